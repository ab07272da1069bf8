//! Collects triangles at a level of detail, or only counts them.
//!
//! All surfaces are made of [`Grid`]s. Their numbers of rows and columns come from
//! [`MeshBuilder::segments`], which scales them with the level of detail, so a dry run with the same calls
//! tells how many triangles a level gives.

use glam::{DAffine3, DMat3, DVec3};

use super::random::Random;
use crate::mesh::Mesh;

/// A sheet of `rows` x `columns` cells, two triangles each.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Grid {
    pub(super) columns: u32,
    pub(super) rows: u32,
    /// The last column of points is the first one again.
    pub(super) closed: bool,
    /// All points of the first row coincide.
    pub(super) first_pole: bool,
    /// All points of the last row coincide.
    pub(super) last_pole: bool,
}

impl Grid {
    pub(super) fn open(columns: u32, rows: u32) -> Self {
        Self { columns, rows, ..Self::default() }
    }

    pub(super) fn closed(columns: u32, rows: u32) -> Self {
        Self { columns, rows, closed: true, ..Self::default() }
    }

    pub(super) fn sphere(columns: u32, rows: u32) -> Self {
        Self { columns, rows, closed: true, first_pole: true, last_pole: true }
    }

    fn triangles(&self) -> u64 {
        let columns = u64::from(self.columns);
        let missing = u64::from(self.first_pole) + u64::from(self.last_pole);
        2 * columns * u64::from(self.rows) - columns * missing
    }
}

/// Something that is built once and placed often.
pub(super) struct Part {
    mesh: Mesh,
    triangles: u64,
}

/// Makes a mesh, or counts its triangles.
pub(super) struct MeshBuilder {
    mesh: Mesh,
    triangles: u64,
    counting: bool,
    level: f64,
    place: DAffine3,
    dither: Random,
}

impl MeshBuilder {
    /// A builder of a mesh whose lengths are divided into `level` times as many segments as at full detail.
    pub(super) fn new(level: f64) -> Self {
        Self {
            mesh: Mesh::default(),
            triangles: 0,
            counting: false,
            level,
            place: DAffine3::IDENTITY,
            dither: Random::new(0, 0, 0),
        }
    }

    /// Like [`MeshBuilder::new`], but without geometry: only [`MeshBuilder::triangles`] has a meaning.
    pub(super) fn counting(level: f64) -> Self {
        Self { counting: true, ..Self::new(level) }
    }

    /// Triangles so far.
    pub(super) fn triangles(&self) -> u64 {
        self.triangles
    }

    /// Whether geometry is left out.
    pub(super) fn is_counting(&self) -> bool {
        self.counting
    }

    /// The number of segments for a length that has `full` segments at full detail. The number is never below `least`
    /// and never falls as the level rises. It is rounded up or down at random, so that sums grow smoothly.
    pub(super) fn segments(&mut self, full: u32, least: u32) -> u32 {
        // At full detail the sum stays below full + 1, as a random number is below 1.
        ((f64::from(full) * self.level + self.dither.unit()) as u32).max(least)
    }

    /// Builds between `least` and `full` items, in proportion to the level. `build` gets the number of the
    /// item and how many there are.
    pub(super) fn repeat(&mut self, full: u32, least: u32, mut build: impl FnMut(&mut Self, u32, u32)) {
        let count = self.segments(full, least);
        let key = self.dither.bits();
        // Each item has random numbers of its own, so that the random numbers of later parts do not depend on the
        // level.
        let outer = self.dither.clone();
        for item in 0..count {
            self.dither = Random::new(key, 0, item.into());
            build(self, item, count);
        }
        self.dither = outer;
    }

    /// Builds something at full detail, and with a chance equal to the level below it.
    pub(super) fn optional(&mut self, mut build: impl FnMut(&mut Self)) {
        self.repeat(1, 0, |b, _, _| build(b));
    }

    /// [`MeshBuilder::optional`] if `small`, and otherwise always.
    pub(super) fn optional_if(&mut self, small: bool, mut build: impl FnMut(&mut Self)) {
        self.repeat(1, u32::from(!small), |b, _, _| build(b));
    }

    /// A part to be placed by [`MeshBuilder::instance`], at the level of this builder.
    pub(super) fn part(&mut self, build: impl FnOnce(&mut Self)) -> Part {
        let mut inner = Self { counting: self.counting, ..Self::new(self.level) };
        inner.dither = Random::new(self.dither.bits(), 0, 0);
        build(&mut inner);
        Part { triangles: inner.triangles, mesh: inner.finish() }
    }

    /// Runs `build` in the coordinates of `place`.
    pub(super) fn at(&mut self, place: DAffine3, build: impl FnOnce(&mut Self)) {
        let outer = self.place;
        self.place = outer * place;
        build(self);
        self.place = outer;
    }

    /// Adds the points `surface(u, v)`, `u` from 0 to 1 over the columns, `v` over the rows. Triangles are
    /// counter-clockwise seen from the side to which the cross product of the directions of u and v points.
    pub(super) fn grid(&mut self, grid: Grid, mut surface: impl FnMut(f64, f64) -> DVec3) {
        self.triangles += grid.triangles();
        if self.counting {
            return;
        }
        let across = if grid.closed { grid.columns } else { grid.columns + 1 };
        let mut below: Vec<u32> = Vec::new();
        for row in 0..=grid.rows {
            let v = f64::from(row) / f64::from(grid.rows);
            let pole = row == 0 && grid.first_pole || row == grid.rows && grid.last_pole;
            let points = if pole { 1 } else { across };
            let first = self.mesh.positions.len() as u32;
            for column in 0..points {
                self.push_position(surface(f64::from(column) / f64::from(grid.columns), v));
            }
            let above: Vec<u32> =
                (0..=grid.columns).map(|c| first + if pole { 0 } else { c % across }).collect();
            for (lower, upper) in below.windows(2).zip(above.windows(2)) {
                if lower[0] != lower[1] {
                    self.mesh.triangles.push([lower[0], lower[1], upper[1]]);
                }
                if upper[0] != upper[1] {
                    self.mesh.triangles.push([lower[0], upper[1], upper[0]]);
                }
            }
            below = above;
        }
    }

    /// Adds a copy of `part`.
    pub(super) fn instance(&mut self, part: &Part, place: DAffine3) {
        self.triangles += part.triangles;
        if self.counting {
            return;
        }
        let first = self.mesh.positions.len() as u32;
        self.at(place, |b| {
            part.mesh.positions.iter().for_each(|p| b.push_position(DVec3::from(p.map(f64::from))))
        });
        self.mesh.triangles.extend(part.mesh.triangles.iter().map(|t| t.map(|i| first + i)));
    }

    fn push_position(&mut self, p: DVec3) {
        self.mesh.positions.push(self.place.transform_point3(p).to_array().map(|x| x as f32));
    }

    /// The mesh, its vertices numbered as triangles first name them.
    pub(super) fn finish(self) -> Mesh {
        const UNUSED: u32 = u32::MAX;
        let mut numbers = vec![UNUSED; self.mesh.positions.len()];
        let mut positions = Vec::with_capacity(self.mesh.positions.len());
        let mut triangles = self.mesh.triangles;
        for index in triangles.iter_mut().flatten() {
            let number = &mut numbers[*index as usize];
            if *number == UNUSED {
                *number = positions.len() as u32;
                positions.push(self.mesh.positions[*index as usize]);
            }
            *index = *number;
        }
        Mesh { positions, triangles }
    }
}

/// Sine and cosine that are the same on every machine.
pub(super) fn sin_cos(radians: f64) -> (f64, f64) {
    libm::sincos(radians)
}

/// A shift.
pub(super) fn moved(x: f64, y: f64, z: f64) -> DAffine3 {
    DAffine3::from_translation(DVec3::new(x, y, z))
}

/// A turn around the y axis, from z towards x.
pub(super) fn turned(radians: f64) -> DAffine3 {
    let (sin, cos) = sin_cos(radians);
    DAffine3::from_mat3(DMat3::from_cols(DVec3::new(cos, 0.0, -sin), DVec3::Y, DVec3::new(sin, 0.0, cos)))
}

/// A turn around the x axis, from y towards z.
pub(super) fn tilted(radians: f64) -> DAffine3 {
    let (sin, cos) = sin_cos(radians);
    DAffine3::from_mat3(DMat3::from_cols(DVec3::X, DVec3::new(0.0, cos, sin), DVec3::new(0.0, -sin, cos)))
}

/// At `origin`, with z along `forward` and y as close to `up` as that allows.
pub(super) fn facing(origin: DVec3, forward: DVec3, up: DVec3) -> DAffine3 {
    let z = forward.normalize_or(DVec3::Z);
    let x = up.cross(z).normalize_or(z.any_orthonormal_vector());
    DAffine3::from_mat3_translation(DMat3::from_cols(x, z.cross(x), z), origin)
}

/// The same scale along all axes.
pub(super) fn scaled(factor: f64) -> DAffine3 {
    DAffine3::from_scale(DVec3::splat(factor))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_those_of_the_mesh() {
        for grid in [Grid::open(3, 5), Grid::closed(7, 2), Grid::sphere(6, 4), Grid::sphere(3, 2)] {
            let mut counter = MeshBuilder::counting(1.0);
            let mut builder = MeshBuilder::new(1.0);
            let surface = |u: f64, v: f64| {
                let (sin, cos) = sin_cos(u * std::f64::consts::TAU);
                let radius = v * (1.0 - v);
                DVec3::new(cos * radius, sin * radius, v)
            };
            counter.grid(grid, surface);
            builder.grid(grid, surface);
            assert_eq!(builder.triangles(), counter.triangles());
            assert_eq!(builder.finish().triangles.len() as u64, counter.triangles());
        }
    }

    #[test]
    fn segments_grow_with_the_level() {
        let at = |level: f64| {
            let mut builder = MeshBuilder::counting(level);
            (0..1000).map(|i| builder.segments(i % 40, 2)).collect::<Vec<_>>()
        };
        let levels = [0.0, 0.01, 0.3, 0.31, 0.5, 0.99, 1.0].map(at);
        for pair in levels.windows(2) {
            assert!(pair[0].iter().zip(&pair[1]).all(|(low, high)| low <= high));
        }
        assert!(levels[6].iter().zip(0..1000).all(|(&n, i)| n == (i % 40).max(2)));
        let half: u32 = levels[4].iter().sum();
        assert!((half as f64 / 9800.0 - 1.0).abs() < 0.05, "{half}");
    }

    #[test]
    fn vertices_are_numbered_by_first_use() {
        let mut builder = MeshBuilder::new(1.0);
        builder.grid(Grid::open(4, 4), |u, v| DVec3::new(u, v, 0.0));
        let mesh = builder.finish();
        let mut next = 0;
        for &index in mesh.triangles.iter().flatten() {
            assert!(index <= next);
            next = next.max(index + 1);
        }
        assert_eq!(next as usize, mesh.positions.len());
    }
}
