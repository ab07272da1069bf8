//! Rays as a renderer makes them: a pinhole camera's, and diffuse bounces where they end.
#![allow(dead_code, reason = "each user needs a part")]

use golden::traverse::Trace;
use golden::{Aabb, Mode, Ray};
use scenes::Mesh;

/// Eye, target, up and vertical field of view of the shared scenes.
pub fn camera(name: &str, bounds: &Aabb) -> ([f32; 3], [f32; 3], [f32; 3], f32) {
    match name {
        "crytek_sponza" => ([-1200.0, 250.0, -30.0], [0.0, 280.0, -20.0], [0.0, 1.0, 0.0], 65.0),
        "sibenik" => ([-17.0, -12.5, 0.0], [0.0, -9.0, 0.0], [0.0, 1.0, 0.0], 60.0),
        "sanmiguel_leaves" => ([26.0, -2.42, 1.5], [15.0, -8.5, 7.0], [0.0, 0.0, 1.0], 60.0),
        _ => {
            let centre = bounds.centre();
            let d = sub(bounds.max, bounds.min);
            let diagonal = dot(d, d).sqrt();
            let eye = std::array::from_fn(|k| centre[k] + [0.15, 0.2, 0.9][k] * diagonal);
            (eye, centre, [0.0, 1.0, 0.0], 45.0)
        }
    }
}

/// `size` x `size` rays through the pixels' centres, row by row.
pub fn primary(name: &str, bounds: &Aabb, size: u32) -> Vec<Ray> {
    let (eye, target, up, fov) = camera(name, bounds);
    let forward = normalised(sub(target, eye));
    let right = normalised(cross(forward, up));
    let up = cross(right, forward);
    let scale = (fov.to_radians() / 2.0).tan();
    let pixel = |i: u32| (2.0 * (i as f32 + 0.5) / size as f32 - 1.0) * scale;
    (0..size * size)
        .map(|i| {
            let (x, y) = (pixel(i % size), -pixel(i / size));
            let d = std::array::from_fn(|k| forward[k] + x * right[k] + y * up[k]);
            Ray::new(eye, normalised(d))
        })
        .collect()
}

/// Cosine-weighted bounces from the hits of `rays`, `depth` times over, in wavefront order.
pub fn diffuse(mesh: &Mesh, structure: &impl Trace, rays: &[Ray], depth: usize) -> Vec<Ray> {
    let mut all = vec![];
    let mut wave = rays.to_vec();
    let mut random = Random(1);
    for _ in 0..depth {
        wave = wave
            .iter()
            .filter_map(|ray| {
                let hit = structure.closest(ray, Mode::Robust)?;
                let [a, b, c] = mesh.corners(hit.triangle as usize);
                let normal = normalised(cross(sub(b, a), sub(c, a)));
                let sign = if dot(normal, ray.direction) > 0.0 { -1.0 } else { 1.0 };
                let sphere = random.on_sphere();
                let direction = normalised(std::array::from_fn(|k| sign * normal[k] + sphere[k]));
                let point: [f32; 3] = std::array::from_fn(|k| ray.origin[k] + hit.t * ray.direction[k]);
                let size = point.iter().fold(0.0f32, |m, x| m.max(x.abs()));
                let origin = std::array::from_fn(|k| point[k] + sign * normal[k] * size * 1e-5);
                direction.iter().all(|x| x.is_finite()).then(|| Ray::new(origin, direction))
            })
            .collect();
        all.extend_from_slice(&wave);
    }
    all
}

struct Random(u64);

impl Random {
    fn uniform(&mut self) -> f32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 40) as f32 / 16_777_216.0
    }

    fn on_sphere(&mut self) -> [f32; 3] {
        loop {
            let p: [f32; 3] = std::array::from_fn(|_| 2.0 * self.uniform() - 1.0);
            let length = dot(p, p);
            if length > 1e-4 && length <= 1.0 {
                return normalised(p);
            }
        }
    }
}

fn sub(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    std::array::from_fn(|k| a[k] - b[k])
}

fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn normalised(a: [f32; 3]) -> [f32; 3] {
    let length = dot(a, a).sqrt();
    a.map(|x| x / length)
}
