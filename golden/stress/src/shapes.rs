//! Meshes with known properties, and the random numbers to make more.

use scenes::Mesh;
use std::collections::BTreeMap;

/// A closed octahedron, each triangle split in four `depth` times, its vertices on the unit sphere.
#[must_use]
pub fn closed_sphere(depth: u32) -> Mesh {
    let mut mesh = Mesh {
        positions: vec![
            [1.0, 0.0, 0.0],
            [-1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, -1.0, 0.0],
            [0.0, 0.0, 1.0],
            [0.0, 0.0, -1.0],
        ],
        triangles: vec![
            [0, 2, 4],
            [2, 1, 4],
            [1, 3, 4],
            [3, 0, 4],
            [2, 0, 5],
            [1, 2, 5],
            [3, 1, 5],
            [0, 3, 5],
        ],
    };
    for _ in 0..depth {
        let mut middles = BTreeMap::new();
        let triangles = std::mem::take(&mut mesh.triangles);
        for [a, b, c] in triangles {
            let [ab, bc, ca] = [(a, b), (b, c), (c, a)].map(|(p, q)| {
                *middles.entry((p.min(q), p.max(q))).or_insert_with(|| {
                    let (p, q) = (mesh.positions[p as usize], mesh.positions[q as usize]);
                    let sum: [f64; 3] = std::array::from_fn(|k| f64::from(p[k]) + f64::from(q[k]));
                    let length = (sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]).sqrt();
                    mesh.positions.push(sum.map(|x| (x / length) as f32));
                    mesh.positions.len() as u32 - 1
                })
            });
            mesh.triangles.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
        }
    }
    mesh
}

/// A closed sphere with bumps.
#[must_use]
pub fn blob(depth: u32) -> Mesh {
    let mut mesh = closed_sphere(depth);
    for p in &mut mesh.positions {
        let bump = 1.0 + 0.3 * (p[0] * p[1] * 4.0 + p[2] * p[2] - p[1] * p[2] * 3.0);
        *p = p.map(|x| x * bump);
    }
    mesh
}

/// `n` x `n` squares of two triangles in the plane z = 0, with vertices at whole numbers.
#[must_use]
pub fn grid(n: u32) -> Mesh {
    let positions =
        (0..(n + 1) * (n + 1)).map(|i| [(i % (n + 1)) as f32, (i / (n + 1)) as f32, 0.0]).collect();
    let triangles = (0..n * n)
        .flat_map(|i| {
            let a = i / n * (n + 1) + i % n;
            let (b, c, d) = (a + 1, a + n + 1, a + n + 2);
            [[a, b, d], [a, d, c]]
        })
        .collect();
    Mesh { positions, triangles }
}

/// `mesh`, scaled, then moved.
#[must_use]
pub fn moved(mesh: &Mesh, scale: f32, offset: [f32; 3]) -> Mesh {
    let positions =
        mesh.positions.iter().map(|p| std::array::from_fn(|k| p[k] * scale + offset[k])).collect();
    Mesh { positions, triangles: mesh.triangles.clone() }
}

/// The twelve triangles of a box.
#[must_use]
pub fn box_triangles(low: [f32; 3], high: [f32; 3]) -> Vec<[[f32; 3]; 3]> {
    let corner = |i: usize| std::array::from_fn(|k| if i >> k & 1 == 0 { low[k] } else { high[k] });
    let mut triangles = vec![];
    for axis in 0..3 {
        let (u, v) = (1 << ((axis + 1) % 3), 1 << ((axis + 2) % 3));
        for side in [0, 1 << axis] {
            triangles.push([corner(side), corner(side | u), corner(side | u | v)]);
            triangles.push([corner(side), corner(side | u | v), corner(side | v)]);
        }
    }
    triangles
}

/// A small linear congruential generator: the same numbers everywhere.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// The sequence of `seed`.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// In 0..1.
    pub fn uniform(&mut self) -> f32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 40) as f32 / 16_777_216.0
    }

    /// A number below `n`.
    pub fn below(&mut self, n: usize) -> usize {
        (f64::from(self.uniform()) * n as f64) as usize
    }

    /// A point in the unit sphere.
    pub fn in_sphere(&mut self) -> [f32; 3] {
        loop {
            let p: [f32; 3] = std::array::from_fn(|_| 2.0 * self.uniform() - 1.0);
            if p.iter().map(|x| x * x).sum::<f32>() <= 1.0 {
                return p;
            }
        }
    }
}

/// A triangle soup from corners.
#[must_use]
pub fn soup(triangles: impl IntoIterator<Item = [[f32; 3]; 3]>) -> Mesh {
    let positions: Vec<_> = triangles.into_iter().flatten().collect();
    let triangles = (0..positions.len() as u32 / 3).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    Mesh { positions, triangles }
}
