//! Turns polygons into triangles.
//!
//! A convex polygon becomes the fan from its first corner, and so does any other polygon that this fan covers exactly. Of the
//! rest, ears are cut off in the plane of two axes in which the polygon is largest. Orientations are exact.

use earcut::Earcut;
use robust::{Coord, orient2d};

use super::error::FormatErrorKind;
use crate::mesh::MAX_TRIANGLES;

/// Most corners of a polygon that is not convex. Cutting ears and looking for crossings take quadratic time in the worst case.
pub(super) const MOST_CORNERS: usize = 4096;
/// A polygon is not planar if a corner is farther from its plane than this fraction of its size...
const PLANAR: f64 = 1e-3;
/// ...and than the rounding of the coordinates explains, as a fraction of the largest coordinate.
const ROUNDING: f64 = 4.0 * f32::EPSILON as f64;

/// Polygons of more than three corners that are worth a word.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PolygonCounts {
    /// Some corner points inwards.
    pub concave: u64,
    /// The corners do not lie in a plane.
    pub non_planar: u64,
    /// Two sides cross, so no set of triangles is the polygon.
    pub self_crossing: u64,
}

/// Turns polygons into triangles, and counts those that are worth a word.
pub(super) struct Triangulator {
    pub(super) counts: PolygonCounts,
    ears: Earcut<f64>,
    indices: Vec<u32>,
}

impl Triangulator {
    pub(super) fn new() -> Self {
        Self { counts: PolygonCounts::default(), ears: Earcut::new(), indices: Vec::new() }
    }

    /// Appends the polygon of `corners`, which are three or more indices into `positions`, to `triangles`.
    ///
    /// # Errors
    /// [`FormatErrorKind::LargePolygon`] and [`FormatErrorKind::TooManyTriangles`].
    ///
    /// # Panics
    /// If a corner is no index into `positions`.
    pub(super) fn push(
        &mut self,
        positions: &[[f32; 3]],
        corners: &[u32],
        triangles: &mut Vec<[u32; 3]>,
    ) -> Result<(), FormatErrorKind> {
        if triangles.len() + corners.len().saturating_sub(2) > MAX_TRIANGLES {
            return Err(FormatErrorKind::TooManyTriangles);
        }
        let fan = || corners.windows(2).skip(1).map(|side| [corners[0], side[0], side[1]]);
        let at = |corner: &u32| positions[*corner as usize].map(f64::from);
        let Some(normal) = (corners.len() > 3).then(|| normal(corners.iter().map(at))).flatten() else {
            triangles.extend(fan());
            return Ok(());
        };
        self.counts.non_planar += u64::from(!is_planar(corners.iter().map(at), normal));
        let outline: Vec<Coord<f64>> = corners.iter().map(|corner| project(at(corner), normal)).collect();
        let turns = Turns::of(&outline);
        if turns.is_convex() {
            triangles.extend(fan());
            return Ok(());
        }
        if corners.len() > MOST_CORNERS {
            return Err(FormatErrorKind::LargePolygon(corners.len()));
        }
        let crossing = crosses_itself(&outline);
        self.counts.concave += u64::from(turns.inwards);
        self.counts.self_crossing += u64::from(crossing);
        let fan_covers =
            !crossing && outline.windows(2).skip(1).all(|side| orient2d(outline[0], side[0], side[1]) >= 0.0);
        if !fan_covers {
            self.ears.earcut(outline.iter().map(|p| [p.x, p.y]), &[], &mut self.indices);
            for ear in self.indices.as_chunks::<3>().0 {
                let [a, b, c] = ear.map(|i| i as usize);
                // A polygon that crosses itself has parts that go round the other way.
                let ear =
                    if orient2d(outline[a], outline[b], outline[c]) < 0.0 { [a, c, b] } else { [a, b, c] };
                triangles.push(ear.map(|i| corners[i]));
            }
        }
        if fan_covers || self.indices.is_empty() {
            triangles.extend(fan());
        }
        Ok(())
    }
}

/// The area vector of the polygon, or the largest of its fan's where parts of a polygon that crosses itself cancel each other;
/// `None` if all corners lie on one line.
fn normal(corners: impl Iterator<Item = [f64; 3]>) -> Option<[f64; 3]> {
    let mut corners = corners;
    let first = corners.next()?;
    let mut sides = corners.map(|p| std::array::from_fn(|axis| p[axis] - first[axis]));
    let mut before: [f64; 3] = sides.next()?;
    let (mut sum, mut largest) = ([0.0; 3], [0.0; 3]);
    for side in sides {
        let area = cross(before, side);
        sum = std::array::from_fn(|axis| sum[axis] + area[axis]);
        if magnitude(area) > magnitude(largest) {
            largest = area;
        }
        before = side;
    }
    let normal = if magnitude(sum) > magnitude(largest) * 1e-9 { sum } else { largest };
    (magnitude(normal) > 0.0).then_some(normal)
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The largest magnitude of a component.
fn magnitude(v: [f64; 3]) -> f64 {
    v.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()))
}

/// Leaves out the axis that is closest to `normal`, so that the polygon goes round counter-clockwise.
fn project(p: [f64; 3], normal: [f64; 3]) -> Coord<f64> {
    let largest = magnitude(normal);
    let axis = (0..3).find(|&axis| normal[axis].abs() == largest).unwrap_or(0);
    let (x, y) = (p[(axis + 1) % 3], p[(axis + 2) % 3]);
    if normal[axis] > 0.0 { Coord { x, y } } else { Coord { x: y, y: x } }
}

/// Whether all corners lie in the plane through the first with `normal`, up to [`PLANAR`] and [`ROUNDING`].
fn is_planar(corners: impl Iterator<Item = [f64; 3]> + Clone, normal: [f64; 3]) -> bool {
    // Dividing by the largest component first keeps the squares within range.
    let scaled = normal.map(|x| x / magnitude(normal));
    let length = scaled.iter().map(|x| x * x).sum::<f64>().sqrt();
    let unit = scaled.map(|x| x / length);
    let Some(first) = corners.clone().next() else { return true };
    let (mut size, mut largest, mut below, mut above) = (0.0_f64, 0.0_f64, 0.0_f64, 0.0_f64);
    for p in corners {
        let offset: [f64; 3] = std::array::from_fn(|axis| p[axis] - first[axis]);
        let height: f64 = (0..3).map(|axis| offset[axis] * unit[axis]).sum();
        size = size.max(magnitude(offset));
        largest = largest.max(magnitude(p));
        (below, above) = (below.min(height), above.max(height));
    }
    above - below <= (PLANAR * size).max(ROUNDING * largest)
}

/// How an outline turns.
struct Turns {
    /// Some corner turns clockwise.
    inwards: bool,
    /// How often the sides change between leading up and leading down; twice in one round.
    reversals: usize,
}

impl Turns {
    /// Looks at each corner; corners at the place of the one before do not count.
    fn of(outline: &[Coord<f64>]) -> Self {
        let mut corners: Vec<Coord<f64>> = outline.to_vec();
        corners.dedup_by(|a, b| (a.x, a.y) == (b.x, b.y));
        while corners.len() > 1
            && (corners[0].x, corners[0].y) == (corners[corners.len() - 1].x, corners[corners.len() - 1].y)
        {
            corners.pop();
        }
        let n = corners.len();
        let corner = |i: usize| corners[i % n];
        let up = |i: usize| (corner(i).x, corner(i).y) < (corner(i + 1).x, corner(i + 1).y);
        Self {
            inwards: (0..n).any(|i| orient2d(corner(i), corner(i + 1), corner(i + 2)) < 0.0),
            reversals: (0..n).filter(|&i| up(i) != up(i + 1)).count(),
        }
    }

    /// Whether the outline is convex: it never turns inwards, and goes round once.
    fn is_convex(&self) -> bool {
        !self.inwards && self.reversals <= 2
    }
}

/// Whether two sides cross; sides that only touch do not.
fn crosses_itself(outline: &[Coord<f64>]) -> bool {
    let mut sides: Vec<[Coord<f64>; 2]> = (0..outline.len())
        .map(|i| [outline[i], outline[(i + 1) % outline.len()]])
        .map(|[a, b]| if a.x <= b.x { [a, b] } else { [b, a] })
        .collect();
    sides.sort_unstable_by(|a, b| a[0].x.total_cmp(&b[0].x));
    let apart = |[a, b]: [Coord<f64>; 2], [c, d]: [Coord<f64>; 2]| {
        let (one, other) = (orient2d(a, b, c), orient2d(a, b, d));
        (one < 0.0 && other > 0.0) || (one > 0.0 && other < 0.0)
    };
    sides.iter().enumerate().any(|(i, &side)| {
        let reaches = |other: &&[Coord<f64>; 2]| other[0].x <= side[1].x;
        sides[i + 1..].iter().take_while(reaches).any(|&other| apart(side, other) && apart(other, side))
    })
}

#[cfg(test)]
#[path = "polygons_tests.rs"]
mod tests;
