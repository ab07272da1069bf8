//! What was found when a scene was loaded.

use crate::formats::report::FileReport;
use crate::mesh::{Bounds, Mesh};

/// What was found when a scene was loaded.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadReport {
    /// What the file holds besides triangles.
    pub file: FileReport,
    /// What its triangles are.
    pub mesh: MeshReport,
}

impl LoadReport {
    /// A line for each thing that a user may want to know of; none for a clean file.
    #[must_use]
    pub fn notes(&self) -> Vec<String> {
        let mut notes = self.file.notes();
        let MeshReport { degenerate, duplicates, .. } = self.mesh;
        for (count, what) in
            [(degenerate, "triangles have no area"), (duplicates, "triangles repeat earlier ones")]
        {
            if count > 0 {
                notes.push(format!("{count} {what}"));
            }
        }
        notes
    }
}

/// What a mesh consists of.
///
/// Triangles of zero area and repeated ones stay in the mesh, although they add nothing to a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MeshReport {
    /// All triangles.
    pub triangles: usize,
    /// All vertices.
    pub vertices: usize,
    /// Triangles of zero area: points and segments, decided exactly.
    pub degenerate: usize,
    /// Triangles that have the same three corners as an earlier one, in any order.
    pub duplicates: usize,
    /// The box around all triangles, if there is one.
    pub bounds: Option<Bounds>,
}

impl MeshReport {
    /// Counts in O(n log n) time.
    ///
    /// # Panics
    /// If an index of a triangle is out of range.
    #[must_use]
    pub fn new(mesh: &Mesh) -> Self {
        Self {
            triangles: mesh.triangles.len(),
            vertices: mesh.positions.len(),
            degenerate: (0..mesh.triangles.len()).filter(|&i| is_degenerate(mesh.corners(i))).count(),
            duplicates: count_duplicates(mesh),
            bounds: mesh.bounds(),
        }
    }
}

/// Whether the corners lie on one line: so do their projections along each axis, and only then.
///
/// The predicate is Shewchuk's, exact in `f64` for coordinates within [`crate::MAX_COORDINATE`].
fn is_degenerate(corners: [[f32; 3]; 3]) -> bool {
    let projected_area = |first: usize, second: usize| {
        let [a, b, c] = corners.map(|p| robust::Coord { x: f64::from(p[first]), y: f64::from(p[second]) });
        robust::orient2d(a, b, c)
    };
    projected_area(0, 1) == 0.0 && projected_area(1, 2) == 0.0 && projected_area(2, 0) == 0.0
}

fn count_duplicates(mesh: &Mesh) -> usize {
    let vertices = first_equal_vertices(mesh);
    let mut keys: Vec<[u32; 3]> = mesh.triangles.iter().map(|t| t.map(|i| vertices[i as usize])).collect();
    keys.iter_mut().for_each(|key| key.sort_unstable());
    keys.sort_unstable();
    keys.windows(2).filter(|pair| pair[0] == pair[1]).count()
}

/// For each vertex, one vertex in its place that is the same for all vertices at equal positions.
fn first_equal_vertices(mesh: &Mesh) -> Vec<u32> {
    // Adding +0 turns -0 into +0, so that equal positions have equal bits.
    let position_bits = |p: [f32; 3]| p.map(|x| (x + 0.0).to_bits());
    let mut order: Vec<([u32; 3], u32)> =
        mesh.positions.iter().zip(0..).map(|(&p, vertex)| (position_bits(p), vertex)).collect();
    order.sort_unstable();
    let mut representatives = vec![0; order.len()];
    for equal in order.chunk_by(|a, b| a.0 == b.0) {
        for &(_, vertex) in equal {
            representatives[vertex as usize] = equal[0].1;
        }
    }
    representatives
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_points_segments_and_slivers() {
        let positions = vec![
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [3.0, 0.0, 0.0],
            [1.0, f32::from_bits(1), 0.0],
            [-0.0, 0.0, -0.0],
        ];
        let triangles = vec![
            [0, 1, 2],
            [0, 0, 0], // a point
            [0, 5, 0], // a point whose corners differ in the sign of zero
            [0, 1, 3], // a segment
            [0, 4, 1], // a sliver: its area is 2^-150, not zero
            [2, 5, 1], // the first once more
            [1, 2, 0], // and again
        ];
        let report = MeshReport::new(&Mesh { positions, triangles });
        let bounds = Some(Bounds { min: [0.0; 3], max: [3.0, 1.0, 0.0] });
        assert_eq!(report, MeshReport { triangles: 7, vertices: 6, degenerate: 3, duplicates: 3, bounds });
    }

    #[test]
    fn exact_at_the_ends_of_the_range() {
        let big = crate::MAX_COORDINATE;
        let line = |x: f32| [x, x, -x];
        let positions = vec![line(-big), line(big), line(1.0), [big, big, -big.next_down()], line(1e-45)];
        let triangles = vec![[0, 1, 2], [0, 3, 2], [0, 1, 4]];
        let report = MeshReport::new(&Mesh { positions, triangles });
        assert_eq!((report.degenerate, report.duplicates), (2, 0));
    }
}
