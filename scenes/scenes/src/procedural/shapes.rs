//! Shapes that several scenes are made of, in metres, y up.

use std::f64::consts::{PI, TAU};

use glam::{DVec2, DVec3};

use super::builder::{Grid, MeshBuilder, sin_cos};
use super::random::lerp;

/// An axis-parallel block from `min` to `max`, its faces divided into `cells` (at full detail) along x, y, z.
pub(super) fn block(b: &mut MeshBuilder, min: DVec3, max: DVec3, cells: [u32; 3]) {
    let [nx, ny, nz] = cells.map(|n| b.segments(n, 1));
    let at = |x: f64, y: f64, z: f64| min + (max - min) * DVec3::new(x, y, z);
    b.grid(Grid::open(nx, ny), |u, v| at(u, v, 1.0));
    b.grid(Grid::open(nx, ny), |u, v| at(1.0 - u, v, 0.0));
    b.grid(Grid::open(nz, ny), |u, v| at(1.0, v, 1.0 - u));
    b.grid(Grid::open(nz, ny), |u, v| at(0.0, v, u));
    b.grid(Grid::open(nx, nz), |u, v| at(u, 1.0, 1.0 - v));
    b.grid(Grid::open(nx, nz), |u, v| at(u, 0.0, v));
}

/// [`block`] by its centre in x and z, its lowest y and its size.
pub(super) fn block_on(b: &mut MeshBuilder, base: DVec3, size: DVec3, cells: [u32; 3]) {
    let half = DVec3::new(size.x * 0.5, 0.0, size.z * 0.5);
    block(b, base - half, base + half + DVec3::new(0.0, size.y, 0.0), cells);
}

/// A surface of revolution around the y axis through the points (radius, y) of `profile`, from bottom to top
/// seen from outside. A radius of 0 at either end closes it. The profile is a Catmull-Rom curve if `smooth`.
pub(super) fn lathe(b: &mut MeshBuilder, profile: &[DVec2], smooth: bool, around: u32, along: u32) {
    let columns = b.segments(around, 4);
    let spans = profile.len() as u32 - 1;
    let rows = if smooth { b.segments(along, 2) } else { spans };
    let grid = Grid {
        first_pole: profile[0].x == 0.0,
        last_pole: profile[profile.len() - 1].x == 0.0,
        ..Grid::closed(columns, rows)
    };
    b.grid(grid, |u, v| {
        let p = if smooth { on_curve(profile, v) } else { on_polyline(profile, v) };
        let (sin, cos) = sin_cos(u * TAU);
        DVec3::new(p.x * sin, p.y, p.x * cos)
    });
}

fn on_polyline(points: &[DVec2], t: f64) -> DVec2 {
    let position = t * (points.len() - 1) as f64;
    let index = (position as usize).min(points.len() - 2);
    points[index].lerp(points[index + 1], position - index as f64)
}

fn on_curve(points: &[DVec2], t: f64) -> DVec2 {
    let extended: Vec<DVec3> = points.iter().map(|p| p.extend(0.0)).collect();
    let p = catmull_rom(&extended, t);
    // The curve may overshoot the axis, where triangles would lose their area.
    DVec2::new(p.x.max(1e-3), p.y)
}

/// The Catmull-Rom spline through `points`, uniform, at `t` from 0 to 1.
pub(super) fn catmull_rom(points: &[DVec3], t: f64) -> DVec3 {
    let last = points.len() - 1;
    let position = t * last as f64;
    let index = (position as usize).min(last - 1);
    let t = position - index as f64;
    let [p1, p2] = [points[index], points[index + 1]];
    let p0 = if index > 0 { points[index - 1] } else { p1 + p1 - p2 };
    let p3 = if index + 2 <= last { points[index + 2] } else { p2 + p2 - p1 };
    let square = t * t;
    ((p1 * 2.0)
        + (p2 - p0) * t
        + (p0 * 2.0 - p1 * 5.0 + p2 * 4.0 - p3) * square
        + (p1 * 3.0 - p0 - p2 * 3.0 + p3) * (square * t))
        * 0.5
}

/// A tube of `sides` sides along `path`, with the radius `radius(t)` at `t` from 0 to 1 by index; caps close
/// it. `path` and `sides` are used as they are, whatever the level.
pub(super) fn tube(b: &mut MeshBuilder, path: &[DVec3], sides: u32, caps: bool, radius: impl Fn(f64) -> f64) {
    let spans = path.len() as u32 - 1;
    let grid = if caps {
        Grid { first_pole: true, last_pole: true, ..Grid::closed(sides, spans + 2) }
    } else {
        Grid::closed(sides, spans)
    };
    if b.is_counting() {
        b.grid(grid, |_, _| DVec3::ZERO);
        return;
    }
    let frames = transported_frames(path);
    let circle: Vec<(f64, f64)> =
        (0..sides).map(|i| sin_cos(f64::from(i) / f64::from(sides) * TAU)).collect();
    b.grid(grid, |u, v| {
        let row = (v * f64::from(grid.rows) + 0.5) as u32;
        let point = if caps { row.saturating_sub(1).min(spans) } else { row };
        let index = point as usize;
        if caps && (row == 0 || row == grid.rows) {
            return path[index];
        }
        let (sin, cos) = circle[(u * f64::from(sides) + 0.5) as usize % sides as usize];
        let (x, y) = frames[index];
        path[index] + (x * cos + y * sin) * radius(f64::from(point) / f64::from(spans))
    });
}

/// Two directions at each point of `path`, at right angles to it and to each other, that turn as little as
/// possible along it; at a bend, in the plane that halves the angle.
fn transported_frames(path: &[DVec3]) -> Vec<(DVec3, DVec3)> {
    let direction = |i: usize| (path[i + 1] - path[i]).normalize_or(DVec3::Y);
    let last = path.len() - 1;
    let first = direction(0);
    let mut x = first.cross(if first.y.abs() < 0.9 { DVec3::Y } else { DVec3::X }).normalize();
    (0..=last)
        .map(|i| {
            let before = direction(i.saturating_sub(1).min(last - 1));
            let after = direction(i.min(last - 1));
            let tangent = (before + after).normalize_or(after);
            x = (x - tangent * tangent.dot(x)).normalize_or(tangent.any_orthonormal_vector());
            (x, tangent.cross(x))
        })
        .collect()
}

/// A straight bar with a rectangular section between two points, without ends: 8 triangles.
pub(super) fn beam(b: &mut MeshBuilder, from: DVec3, to: DVec3, width: f64) {
    tube(b, &[from, to], 4, false, |_| width * std::f64::consts::FRAC_1_SQRT_2);
}

/// A ring of thickness `thickness` around the y axis.
pub(super) fn torus(
    b: &mut MeshBuilder,
    center: DVec3,
    radius: f64,
    thickness: f64,
    around: u32,
    sides: u32,
) {
    let columns = b.segments(around, 5);
    let rows = b.segments(sides, 3);
    b.grid(Grid::closed(columns, rows), |u, v| {
        let (sin_u, cos_u) = sin_cos(u * TAU);
        let (sin_v, cos_v) = sin_cos(v * TAU);
        let r = radius - thickness * cos_v;
        center + DVec3::new(r * sin_u, -thickness * sin_v, r * cos_u)
    });
}

/// A ball of radius 1 times `radius(direction)` around `center`.
pub(super) fn ball(
    b: &mut MeshBuilder,
    center: DVec3,
    around: u32,
    along: u32,
    radius: impl Fn(DVec3) -> f64,
) {
    let columns = b.segments(around, 5);
    let rows = b.segments(along, 3);
    b.grid(Grid::sphere(columns, rows), |u, v| {
        let (sin_u, cos_u) = sin_cos(u * TAU);
        let (sin_v, cos_v) = sin_cos(v * PI);
        let direction = DVec3::new(sin_v * sin_u, -cos_v, sin_v * cos_u);
        center + direction * radius(direction)
    });
}

/// A wall of `width` (along x, centred) from y = 0 to `height`, of `depth` (along z, centred), with a round
/// arch cut out: `opening` wide, its springing line at `spring`. Front, back, soffit and jambs.
pub(super) fn arch(
    b: &mut MeshBuilder,
    width: f64,
    height: f64,
    depth: f64,
    opening: f64,
    spring: f64,
    cells: u32,
) {
    // A multiple of four puts points on the corners of the outer edge.
    let columns = b.segments(cells, 4).next_multiple_of(4);
    let rows = b.segments(cells / 12, 1);
    let through = b.segments(cells / 8, 1);
    let radius = opening * 0.5;
    let curve = |u: f64| {
        let (sin, cos) = sin_cos(PI * u);
        DVec2::new(-radius * cos, spring + radius * sin)
    };
    // The outer edge goes up the left side, along the top and down the right side, with its corners kept.
    let outer = |u: f64| {
        let rise = height - spring;
        let half = width * 0.5;
        if u < 0.25 {
            DVec2::new(-half, spring + rise * u * 4.0)
        } else if u <= 0.75 {
            DVec2::new(lerp(-half, half, (u - 0.25) * 2.0), height)
        } else {
            DVec2::new(half, height - rise * (u - 0.75) * 4.0)
        }
    };
    for side in [1.0, -1.0] {
        let z = side * depth * 0.5;
        b.grid(Grid::open(columns, rows), |u, v| {
            let u = if side > 0.0 { 1.0 - u } else { u };
            curve(u).lerp(outer(u), v).extend(z)
        });
    }
    b.grid(Grid::open(columns, through), |u, v| curve(u).extend(lerp(-depth * 0.5, depth * 0.5, v)));
}

/// A profile of points (outward, y) drawn along the polygon `corners` at y = 0, whose outward side is to the
/// right of the way. Mitred at the corners; `closed` joins the ends.
pub(super) fn moulding(b: &mut MeshBuilder, corners: &[DVec2], closed: bool, profile: &[DVec2], cells: u32) {
    let count = corners.len();
    let legs = if closed { count } else { count - 1 };
    let right = |i: usize| {
        let along = corners[(i + 1) % count] - corners[i % count];
        DVec2::new(along.y, -along.x).normalize()
    };
    let offset = |i: usize| {
        let (before, after) = if closed {
            (right((i + count - 1) % count), right(i % count))
        } else {
            (right(i.saturating_sub(1).min(legs - 1)), right(i.min(legs - 1)))
        };
        (before + after) / (1.0 + before.dot(after))
    };
    for leg in 0..legs {
        let n = b.segments(cells, 1);
        let (from, to) = (corners[leg], corners[(leg + 1) % count]);
        let (from_offset, to_offset) = (offset(leg), offset(leg + 1));
        b.grid(Grid::open(n, profile.len() as u32 - 1), |u, v| {
            let p = on_polyline(profile, v);
            let flat = (from + from_offset * p.x).lerp(to + to_offset * p.x, u);
            DVec3::new(flat.x, p.y, flat.y)
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Mesh;

    fn built(build: impl FnOnce(&mut MeshBuilder)) -> Mesh {
        let mut builder = MeshBuilder::new(1.0);
        build(&mut builder);
        builder.finish()
    }

    /// Six times the enclosed volume, by the divergence theorem: positive if faces point outward.
    fn volume(mesh: &Mesh) -> f64 {
        let corner = |p: [f32; 3]| DVec3::from(p.map(f64::from));
        let terms = (0..mesh.triangles.len()).map(|i| {
            let [a, b, c] = mesh.corners(i).map(corner);
            a.dot(b.cross(c)) / 6.0
        });
        terms.sum()
    }

    #[test]
    fn closed_shapes_point_outward_and_hold_their_volume() {
        let block = built(|b| block(b, DVec3::ZERO, DVec3::new(1.0, 2.0, 3.0), [2, 3, 4]));
        assert!((volume(&block) - 6.0).abs() < 1e-6);
        let ball = built(|b| ball(b, DVec3::ONE, 64, 64, |_| 1.0));
        assert!((volume(&ball) / (4.0 / 3.0 * PI) - 1.0).abs() < 0.01);
        let path: Vec<DVec3> = (0..20).map(|i| DVec3::new(f64::from(i), 0.1, 0.2)).collect();
        let tube = built(|b| tube(b, &path, 64, true, |_| 0.5));
        assert!((volume(&tube) / (19.0 * PI * 0.25) - 1.0).abs() < 0.01);
        let ring = built(|b| torus(b, DVec3::ZERO, 2.0, 0.5, 64, 64));
        assert!((volume(&ring) / (TAU * 2.0 * PI * 0.25) - 1.0).abs() < 0.01);
        let cone = [DVec2::new(0.0, 0.0), DVec2::new(1.0, 0.0), DVec2::new(0.0, 3.0)];
        let cone = built(|b| lathe(b, &cone, false, 64, 1));
        assert!((volume(&cone) / PI - 1.0).abs() < 0.01);
    }

    #[test]
    fn tubes_keep_their_width_around_bends() {
        let path = [DVec3::ZERO, DVec3::X * 5.0, DVec3::new(5.0, 5.0, 0.0), DVec3::new(5.0, 5.0, -5.0)];
        let mesh = built(|b| tube(b, &path, 8, false, |_| 0.1));
        for p in &mesh.positions {
            let p = DVec3::from(p.map(f64::from));
            let nearest = path.iter().map(|q| (p - *q).length()).fold(f64::INFINITY, f64::min);
            assert!((nearest - 0.1).abs() < 1e-6);
        }
    }

    #[test]
    fn splines_pass_through_their_points() {
        let points = [DVec3::ZERO, DVec3::X, DVec3::new(2.0, 3.0, 1.0), DVec3::Y];
        for (i, p) in points.iter().enumerate() {
            assert!((catmull_rom(&points, i as f64 / 3.0) - *p).length() < 1e-12);
        }
    }
}
