//! Rays, the two modes of traversal, and what a ray carries through the pipelines.
//!
//! # Reciprocals
//! A plane at `p` on axis `k` is met at `t = (p - origin[k]) * inv[k]`: one subtraction, one multiplication, both
//! rounded to nearest even, never fused. A ray carries two reciprocals per axis, and the plane's role selects
//! one: [`TraversalRay::inv_entry`] where the ray enters the half-space, [`TraversalRay::inv_exit`] where it leaves.
//!
//! * [`Mode::Fast`]: both are `1 / d` rounded to nearest.
//! * [`Mode::Robust`]: `inv_exit` is [`EXIT_PADDING_ULPS`] units in the last place further from zero; where `1 / d`
//!   overflows for a non-zero `d`, `inv_entry` is the largest finite number and `inv_exit` infinite.
//!
//! # Why robust mode loses nothing
//! Let `u = 2^-24`, and let a point of a box lie exactly on the ray at `t* >= 0`, so that for all axes `i` and `j`
//! the exact distances satisfy `e_i <= t* <= x_j`. A difference of two floats is rounded by at most a factor
//! `1 + u` (it is exact where it is subnormal) and keeps its sign; `1 / d` is rounded by at most half a unit.
//! Before the last rounding, a positive entry distance is therefore at most `e_i (1 + u)^2`, and a positive exit
//! distance at least `x_j (1 - u) (1 + (k - 1/2) u)` with `k` units of padding, as one unit is at least `u` times the
//! number. `(1 + u)^2 / (1 - u) < 1 + 3.1 u`, so `k = 4` makes every exact entry product at most every exact exit
//! product; the last rounding is monotone, overflow and underflow included, and keeps the order. An entry
//! distance that is not positive cannot exceed `t_min >= 0`, and an exit distance is never below a `t_min <= t*`. A
//! parallel axis (`d = 0`, infinite reciprocals) gives -inf and +inf inside its slab, NaN on either face, which the
//! folds drop, and an empty interval outside: everything or nothing, inclusive on both faces, whatever the sign
//! of the zero. This sharpens Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013, which pads both products.
//!
//! # Range
//! Directions of any finite non-zero length are accepted: they are scaled by a power of two so that the largest
//! component lies in (1/2, 1], which is exact (components below 2^-149 of the largest become zero) and keeps
//! every reciprocal's magnitude at least 1, so that no non-zero distance underflows to zero. `t` is in units of
//! the direction's length, as given. A ray is a defined miss if a component is NaN, its origin or direction is
//! infinite, its direction is zero, or `t_min > t_max`. A negative `t_min` counts as zero.

/// How far [`Mode::Robust`] pads the reciprocal of an exit plane, in units in the last place.
pub const EXIT_PADDING_ULPS: u32 = 4;

/// A ray segment: the points `origin + t * direction` with `t_min <= t <= t_max`, bounds included.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Ray {
    /// Start of the ray.
    pub origin: [f32; 3],
    /// Direction of any finite length but zero.
    pub direction: [f32; 3],
    /// Least distance of a hit, in units of the direction's length; below zero counts as zero.
    pub t_min: f32,
    /// Greatest distance of a hit; may be infinite.
    pub t_max: f32,
}

impl Ray {
    /// The half-line from `origin` along `direction`.
    #[must_use]
    pub fn new(origin: [f32; 3], direction: [f32; 3]) -> Self {
        Self { origin, direction, t_min: 0.0, t_max: f32::INFINITY }
    }
}

/// Where a ray meets a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Distance in units of the ray direction's length.
    pub t: f32,
    /// Barycentric weight of the triangle's second corner.
    pub u: f32,
    /// Barycentric weight of the triangle's third corner.
    pub v: f32,
    /// Index of the triangle in its mesh.
    pub triangle: u32,
}

/// How distances to planes are rounded; the kernels and the RTL are the same in both.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Mode {
    /// Rounding to nearest throughout; may lose hits within rounding of a box's edge.
    Fast,
    /// Conservative rounding; never loses a hit of the triangle test.
    #[default]
    Robust,
}

impl Mode {
    /// The mode's name on the command line and in result files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Mode::Fast => "fast",
            Mode::Robust => "robust",
        }
    }
}

/// What a step of traversal asks of a ray; [`TraversalRay`] answers in binary32, [`crate::precision::NarrowRay`] in
/// other formats.
pub trait PlaneDistances {
    /// Whether the ray runs towards smaller coordinates on `axis`.
    fn is_negative(&self, axis: usize) -> bool;

    /// Distance to the plane at `plane` on `axis` where the ray enters its half-space.
    fn entry(&self, plane: f32, axis: usize) -> f32;

    /// Distance to the plane at `plane` on `axis` where the ray leaves its half-space.
    fn exit(&self, plane: f32, axis: usize) -> f32;
}

/// A ray as traversal and the pipelines see it: scaled, with its reciprocals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TraversalRay {
    /// Start of the ray.
    pub origin: [f32; 3],
    /// The direction, scaled by a power of two so that its largest component lies in (1/2, 1].
    pub direction: [f32; 3],
    /// Reciprocals for planes where the ray enters; their sign bits say which side of a box is entered first.
    pub inv_entry: [f32; 3],
    /// Reciprocals for planes where the ray leaves.
    pub inv_exit: [f32; 3],
    /// Least distance in units of the scaled direction, at least +0.
    pub t_min: f32,
    /// Greatest distance in units of the scaled direction.
    pub t_max: f32,
    /// Distances along the given direction are those along the scaled one times `2^t_exponent`.
    t_exponent: i32,
}

impl TraversalRay {
    /// Prepares `ray`, or returns `None` where it is a defined miss (see the module's range).
    #[inline]
    #[must_use]
    pub fn new(ray: &Ray, mode: Mode) -> Option<Self> {
        let largest = ray.direction.iter().fold(0.0f32, |m, d| m.max(d.abs()));
        let finite = ray.origin.iter().chain(&ray.direction).all(|x| x.is_finite());
        // Written so that a NaN bound fails too.
        let ordered = ray.t_min <= ray.t_max && ray.t_max >= 0.0;
        if !(finite && largest > 0.0 && ordered) {
            return None;
        }
        let t_exponent = if largest > 0.5 && largest <= 1.0 { 0 } else { scale_exponent(largest) };
        let (direction, t_min, t_max) = if t_exponent == 0 {
            (ray.direction, ray.t_min, ray.t_max)
        } else {
            // t along the scaled direction = t along the given one / 2^t_exponent.
            (
                ray.direction.map(|d| scale(d, t_exponent)),
                scale(ray.t_min, -t_exponent),
                scale(ray.t_max, -t_exponent),
            )
        };
        let inv_entry: [f32; 3] = direction.map(|d| entry_reciprocal(d, mode));
        let inv_exit = std::array::from_fn(|k| exit_reciprocal(direction[k], inv_entry[k], mode));
        // `max` may return either zero; adding +0 leaves only the positive one.
        Some(Self {
            origin: ray.origin,
            direction,
            inv_entry,
            inv_exit,
            t_min: t_min.max(0.0) + 0.0,
            t_max,
            t_exponent,
        })
    }

    /// Whether the ray runs towards smaller coordinates on `axis`: the sign bit of the reciprocal.
    #[inline(always)]
    #[must_use]
    pub fn is_negative(&self, axis: usize) -> bool {
        self.inv_entry[axis].is_sign_negative()
    }

    /// Distance to the plane at `plane` on `axis` where the ray enters its half-space.
    #[inline(always)]
    #[must_use]
    pub fn entry(&self, plane: f32, axis: usize) -> f32 {
        (plane - self.origin[axis]) * self.inv_entry[axis]
    }

    /// Distance to the plane at `plane` on `axis` where the ray leaves its half-space.
    #[inline(always)]
    #[must_use]
    pub fn exit(&self, plane: f32, axis: usize) -> f32 {
        (plane - self.origin[axis]) * self.inv_exit[axis]
    }

    /// A distance along the scaled direction as one along the direction that was given.
    #[inline(always)]
    #[must_use]
    pub fn given_t(&self, t: f32) -> f32 {
        if self.t_exponent == 0 { t } else { scale(t, self.t_exponent) }
    }
}

impl PlaneDistances for TraversalRay {
    #[inline(always)]
    fn is_negative(&self, axis: usize) -> bool {
        self.is_negative(axis)
    }

    #[inline(always)]
    fn entry(&self, plane: f32, axis: usize) -> f32 {
        self.entry(plane, axis)
    }

    #[inline(always)]
    fn exit(&self, plane: f32, axis: usize) -> f32 {
        self.exit(plane, axis)
    }
}

/// What a ray's steps need of it: what the pipelines get.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaneRay {
    /// Start of the ray.
    pub origin: [f32; 3],
    /// Reciprocals for planes where the ray enters; their sign bits say which side of a box is entered first.
    pub inv_entry: [f32; 3],
    /// Reciprocals for planes where the ray leaves.
    pub inv_exit: [f32; 3],
}

impl TraversalRay {
    /// What its steps need.
    #[must_use]
    pub fn planes(&self) -> PlaneRay {
        PlaneRay { origin: self.origin, inv_entry: self.inv_entry, inv_exit: self.inv_exit }
    }
}

impl PlaneDistances for PlaneRay {
    #[inline(always)]
    fn is_negative(&self, axis: usize) -> bool {
        self.inv_entry[axis].is_sign_negative()
    }

    #[inline(always)]
    fn entry(&self, plane: f32, axis: usize) -> f32 {
        (plane - self.origin[axis]) * self.inv_entry[axis]
    }

    #[inline(always)]
    fn exit(&self, plane: f32, axis: usize) -> f32 {
        (plane - self.origin[axis]) * self.inv_exit[axis]
    }
}

#[inline(always)]
fn entry_reciprocal(d: f32, mode: Mode) -> f32 {
    let inv = 1.0 / d;
    if mode == Mode::Robust && inv.is_infinite() && d != 0.0 { f32::MAX.copysign(d) } else { inv }
}

#[inline(always)]
fn exit_reciprocal(d: f32, inv: f32, mode: Mode) -> f32 {
    match mode {
        Mode::Fast => inv,
        // A step in the bit pattern is a step away from zero; it stops at infinity.
        Mode::Robust if inv.is_finite() => {
            let padded = f32::from_bits(inv.to_bits() + EXIT_PADDING_ULPS);
            if padded.is_finite() { padded } else { f32::INFINITY.copysign(d) }
        }
        Mode::Robust => inv,
    }
}

/// The exponent `e` for which `x * 2^e` lies in (1/2, 1], `x` positive and finite.
fn scale_exponent(x: f32) -> i32 {
    let bits = if x.is_normal() { x.to_bits() } else { (x * 2f32.powi(64)).to_bits() };
    let shift = if x.is_normal() { 0 } else { 64 };
    let exact_power = bits & 0x007f_ffff == 0;
    let floor_log2 = (bits >> 23) as i32 - 127 - shift;
    if exact_power { -floor_log2 } else { -floor_log2 - 1 }
}

/// `x * 2^e`, rounded once, without overflow on the way.
fn scale(x: f32, e: i32) -> f32 {
    // Every such product fits a double exactly: |e| <= 150.
    (f64::from(x) * f64::from_bits(((1023 + i64::from(e)) as u64) << 52)) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scaling_brings_the_largest_component_into_range() {
        for length in [1e-45f32, 1e-38, 1e-20, 0.3, 0.5, 0.75, 1.0, 1.5, 2.0, 1e20, 3e38] {
            let ray = TraversalRay::new(&Ray::new([0.0; 3], [0.0, -length, 0.0]), Mode::Fast).unwrap();
            let d = -ray.direction[1];
            assert!(d > 0.5 && d <= 1.0, "{length} became {d}");
            let back = ray.given_t(3.0 * (1.0 / d));
            let exact = (3.0 / f64::from(length)) as f32;
            assert!((back - exact).abs() <= exact * 3e-7 || back == exact, "{length}: {back} {exact}");
        }
    }

    #[test]
    fn invalid_rays_are_defined_misses() {
        let good = Ray::new([0.0; 3], [1.0, 0.0, 0.0]);
        assert!(TraversalRay::new(&good, Mode::Robust).is_some());
        for bad in [
            Ray { direction: [0.0; 3], ..good },
            Ray { direction: [f32::NAN, 1.0, 0.0], ..good },
            Ray { direction: [f32::INFINITY, 1.0, 0.0], ..good },
            Ray { origin: [f32::NAN, 0.0, 0.0], ..good },
            Ray { origin: [0.0, f32::INFINITY, 0.0], ..good },
            Ray { t_min: 2.0, t_max: 1.0, ..good },
            Ray { t_min: f32::NAN, ..good },
            Ray { t_max: f32::NAN, ..good },
            Ray { t_min: -2.0, t_max: -1.0, ..good },
        ] {
            assert!(TraversalRay::new(&bad, Mode::Robust).is_none(), "{bad:?}");
        }
    }

    #[test]
    fn t_min_is_never_negative_zero() {
        for t_min in [-0.0, -1.0, 0.0] {
            let ray = Ray { t_min, ..Ray::new([0.0; 3], [1.0, 0.0, 0.0]) };
            assert_eq!(TraversalRay::new(&ray, Mode::Robust).unwrap().t_min.to_bits(), 0);
        }
    }

    #[test]
    fn robust_exits_are_padded_and_entries_are_finite_for_tiny_components() {
        let ray =
            TraversalRay::new(&Ray::new([0.0; 3], [1e-40, -0.0, 1.0]), Mode::Robust).expect("a valid ray");
        assert_eq!(ray.inv_entry[0], f32::MAX);
        assert_eq!(ray.inv_exit[0], f32::INFINITY);
        assert_eq!(ray.inv_entry[1], f32::NEG_INFINITY);
        assert_eq!(ray.inv_exit[1], f32::NEG_INFINITY);
        assert_eq!(ray.inv_exit[2].to_bits() - ray.inv_entry[2].to_bits(), EXIT_PADDING_ULPS);
    }
}
