//! What happens at the two ends of a ray: every operation of the renderer, in single precision and in a stated order.
//!
//! A program of another machine that performs these operations gets the same picture bit for bit. All values are binary32. Every
//! operation rounds once, to nearest even, and subnormal numbers are kept; constants are rounded likewise. Nothing is fused.
//! Parentheses say what is computed first; `x + y + z` does not occur. Three operations are not IEEE operations:
//! [`inverse_square_root`], [`sine`] and [`cosine`]. `sqrt` is correctly rounded. `unscale(m)` is [`unscale`], the reciprocal of the
//! power of two at or below `m`. `largest` is the largest absolute value of all components.
//!
//! **Primary ray** ([`primary_direction`]) through `column` and `row`, which are the pixel's integer coordinates, each rounded to
//! binary32, plus the place in the pixel; for each component:
//!
//! ```text
//! d    = (corner + column*right) + row*down
//! unit = inverse_square_root((dx*dx + dy*dy) + dz*dz)
//! d    = d*unit
//! ```
//!
//! **Surface** ([`surface`]) with corners `a`, `b`, `c`, hit at weights `u`, `v` by a ray with direction `d`:
//!
//! ```text
//! e = b - a        f = c - a        s = unscale(largest(e, f))        p = e*s        q = f*s
//! n = (py*qz - pz*qy, pz*qx - px*qz, px*qy - py*qx)
//! squared = (nx*nx + ny*ny) + nz*nz
//! if squared >= 2^-32:  length  = inverse_square_root(squared)
//!                       towards = (nx*dx + ny*dy) + nz*dz
//!                       n       = n*(if the sign bit of towards is set: length, otherwise: -length)
//! otherwise:            n = -d
//! offset = largest(a, b, c) * 2^-17
//! origin = ((a + e*u) + f*v) + n*offset
//! ```
//!
//! **Light** ([`towards_light`], [`TowardsLight::reflected`]) that a surface reflects, where the path carries `throughput`:
//!
//! ```text
//! w = position - origin        m = largest(w)        s = unscale(m)        w = w*s
//! cosine = (nx*wx + ny*wy) + nz*wz
//! if cosine > 0, and nothing is in the way from origin along w up to t = the power of two at or below m:
//!     squared = (wx*wx + wy*wy) + wz*wz
//!     inverse = inverse_square_root(squared)
//!     falloff = (extent*s)*inverse
//!     light   = ((((throughput*(1/pi))*cosine)*inverse)*falloff)*falloff
//!     radiance = radiance + light*intensity                             for each channel
//! ```
//!
//! **Bounce** ([`cosine_direction`]) around `n` from the point `r0`, `r1` of the unit square:
//!
//! ```text
//! angle = r1*(2 pi)        radius = sqrt(r0)        p = radius*cosine(angle)        q = radius*sine(angle)
//! up = sqrt(1 - r0)        sign = copysign(1, nz)
//! a = -1/(sign + nz)       b = (nx*ny)*a
//! dx = ((1 + ((sign*nx)*nx)*a)*p + b*q) + nx*up
//! dy = ((sign*b)*p + (sign + (ny*ny)*a)*q) + ny*up
//! dz = (nz*up - (sign*nx)*p) - ny*q
//! ```
//!
//! **Path**: `radiance = 0`, `throughput = 1`. Where a ray hits nothing, `radiance = radiance + throughput*background` for each
//! channel, and the path ends. Where it hits, in this order: the surface, `throughput = throughput*ALBEDO`, the light, and the next
//! ray if bounces are left. **Pixel**: the sum over its samples, from 0 and in order, divided by their number.
//!
//! # Scale
//! Lengths are multiplied by a power of two, [`unscale`], before they are multiplied with each other. So no product over- or
//! underflows in a scene of any size, and a scene that is scaled by a power of two has the same picture bit for bit, if its light's
//! intensity is scaled by the square. The light's distance is measured in units of [`Light::extent`](crate::Light::extent).

use golden::Ray;
use golden::ray::Hit;
use std::f32::consts::{FRAC_1_PI, TAU};

/// How far a ray that leaves a surface starts from it, in units of 2^-24 of the triangle's largest coordinate.
///
/// Let `L` be the largest coordinate, and a unit 2^-24 `L`, the greatest rounding error of a number up to `L`. An edge is at most
/// `2 L`, so it is off by 2 units, and its product with a weight by 4 units times that weight; as the two weights sum to at most 1,
/// both products add 4 units. The three sums have results of at most about `L` and add a unit each. The origin is thus off by 7 units
/// in each component, and by at most 13 along any direction.
///
/// The normal is within 0.16 of the exact one wherever it is computed, so that the offset takes the origin
/// 126 units away from the triangle's plane, and at least 113 units are left. The triangle test decides the sign of a distance
/// exactly. So a ray that rises from the plane misses the triangle. The margin is for the neighbours: triangles that are in one plane but
/// for the rounding of their corners, by one unit in each component.
///
/// The directions of [`cosine_direction`] have a cosine of at least 2^-12 with the computed normal. They rise from the plane if
/// the normal's angle is less than that off: if the sine of the angle between the edges is above 2^-10, hence if `squared` is at least
/// 2^-12. A ray that leaves a thinner triangle at a smaller angle than the normal's error can hit it again.
///
/// Waechter and Binder, "A Fast and Robust Method for Avoiding Self-Intersection", Ray Tracing Gems, 2019, step by 256
/// units of each coordinate of the point, and by a fixed distance near the origin. The triangle's largest coordinate, taken
/// instead, makes the offset scale with the scene and covers large triangles near the origin.
pub const OFFSET_ULPS: u32 = 128;

/// The square of the cross product of a triangle's edges, scaled so that their largest component lies in [1, 2), from which on its
/// direction is a normal.
///
/// With `u` = 2^-24, `|p|` and `|q|` the lengths of the edges and `sin` the sine of the angle between them: an edge is off by
/// `u` times its length, which makes `2 u |p| |q|` in the product. The six products of components, rounded, add `1.16 u |p| |q|`, and the
/// differences `u |n|`. The normal's direction is therefore off by `(3.2 / sin + 1) u`. As `|p|` and `|q|` are below `2 sqrt(3)`, a
/// `squared` of 2^-32 means a sine above 2^-16 / 12, so the error is below 0.16.
const LEAST_SQUARED_NORMAL: f32 = 1.0 / 4_294_967_296.0;

type V3 = [f32; 3];

/// `1 / sqrt(x)`: root and quotient in binary64, then rounded to binary32.
#[inline]
#[must_use]
pub fn inverse_square_root(x: f32) -> f32 {
    (1.0 / f64::from(x).sqrt()) as f32
}

/// The sine of `x` radians, from `libm`, so that it is the same on every machine.
#[inline]
#[must_use]
pub fn sine(x: f32) -> f32 {
    libm::sinf(x)
}

/// The cosine of `x` radians, from `libm`, so that it is the same on every machine.
#[inline]
#[must_use]
pub fn cosine(x: f32) -> f32 {
    libm::cosf(x)
}

/// The bits of a number's exponent.
const EXPONENT: u32 = 0x7f80_0000;

/// The power of two at or below `m`, which is not negative; 0 where `m` is subnormal.
#[inline]
#[must_use]
pub fn power_of_two(m: f32) -> f32 {
    f32::from_bits(m.to_bits() & EXPONENT)
}

/// The reciprocal of the power of two at or below `m`, which is finite and not negative: 2^127 where `m` is subnormal, 0 from
/// 2^127 on.
#[inline]
#[must_use]
pub fn unscale(m: f32) -> f32 {
    f32::from_bits(0x7f00_0000 - (m.to_bits() & EXPONENT))
}

fn largest<'a>(components: impl IntoIterator<Item = &'a f32>) -> f32 {
    components.into_iter().fold(0.0, |largest, x| x.abs().max(largest))
}

#[inline]
fn dot(a: V3, b: V3) -> f32 {
    (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]
}

#[inline]
fn difference(a: V3, b: V3) -> V3 {
    std::array::from_fn(|k| a[k] - b[k])
}

/// The direction of the ray through the point `column` pixels to the right of and `row` pixels below the upper left corner of the
/// image; `corner` is the direction through that corner, `right` and `down` are the steps from pixel to pixel.
///
/// Its length is 1 up to rounding.
#[must_use]
pub fn primary_direction(corner: V3, right: V3, down: V3, [column, row]: [f32; 2]) -> V3 {
    let d: V3 = std::array::from_fn(|k| (corner[k] + column * right[k]) + row * down[k]);
    let unit = inverse_square_root(dot(d, d));
    d.map(|d| d * unit)
}

/// A point on a triangle, seen from a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// The unit normal of the triangle, on the side from which the ray came.
    pub normal: V3,
    /// Start of the rays that leave the point on that side.
    pub origin: V3,
}

/// The surface where a ray with `direction`, of length 1 up to rounding, made `hit` on the triangle with `corners`.
///
/// The surface faces the ray where single precision does not resolve the normal: of a triangle that is too thin, or with an edge that
/// is subnormal or reaches 2^127.
#[must_use]
pub fn surface(corners: &[V3; 3], hit: &Hit, direction: V3) -> Surface {
    let [a, b, c] = *corners;
    let (e, f) = (difference(b, a), difference(c, a));
    let s = unscale(largest(e.iter().chain(&f)));
    let ([px, py, pz], [qx, qy, qz]) = (e.map(|x| x * s), f.map(|x| x * s));
    let n = [py * qz - pz * qy, pz * qx - px * qz, px * qy - py * qx];
    let squared = dot(n, n);
    let normal = if squared >= LEAST_SQUARED_NORMAL {
        let length = inverse_square_root(squared);
        let length = if dot(n, direction).is_sign_negative() { length } else { -length };
        n.map(|n| n * length)
    } else {
        direction.map(|d| -d)
    };
    let offset = largest(corners.as_flattened()) * (OFFSET_ULPS as f32 / 16_777_216.0);
    let origin = std::array::from_fn(|k| ((a[k] + e[k] * hit.u) + f[k] * hit.v) + normal[k] * offset);
    Surface { normal, origin }
}

/// The way from a surface to a light above it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TowardsLight {
    /// The ray that hits something exactly if the light does not reach the surface.
    pub shadow: Ray,
    /// The cosine of the angle between the normal and the direction of `shadow`, times the direction's length.
    cosine: f32,
    /// The light's distance is the length of the direction over `scale`.
    scale: f32,
}

/// The way from `surface` to the light at `position`; `None` where the light is not above the surface, or is 2^127 away.
#[must_use]
pub fn towards_light(surface: &Surface, position: V3) -> Option<TowardsLight> {
    let w = difference(position, surface.origin);
    let m = largest(&w);
    let scale = unscale(m);
    let direction = w.map(|w| w * scale);
    let cosine = dot(surface.normal, direction);
    let shadow = Ray { origin: surface.origin, direction, t_min: 0.0, t_max: power_of_two(m) };
    (cosine > 0.0).then_some(TowardsLight { shadow, cosine, scale })
}

impl TowardsLight {
    /// What the surface adds to the radiance of a path, per unit of [`Light::intensity`](crate::Light::intensity).
    ///
    /// `throughput` is the path's up to and with the surface's albedo, `extent` that of the light.
    #[must_use]
    pub fn reflected(&self, throughput: f32, extent: f32) -> f32 {
        let inverse = inverse_square_root(dot(self.shadow.direction, self.shadow.direction));
        let falloff = (extent * self.scale) * inverse;
        ((((throughput * FRAC_1_PI) * self.cosine) * inverse) * falloff) * falloff
    }
}

/// The direction at the point `r0`, `r1` of the cosine-weighted distribution around the unit vector `n`, of length 1 up to rounding.
///
/// Malley's method: a uniform point of the disk, projected upwards, in the basis of Duff et al., "Building an Orthonormal Basis,
/// Revisited", JCGT 6(1), 2017. The cosine is positive as `r0` is below 1.
#[must_use]
pub fn cosine_direction([nx, ny, nz]: V3, [r0, r1]: [f32; 2]) -> V3 {
    let angle = r1 * TAU;
    let radius = r0.sqrt();
    let (p, q) = (radius * cosine(angle), radius * sine(angle));
    let up = (1.0 - r0).sqrt();
    let sign = 1f32.copysign(nz);
    let a = -1.0 / (sign + nz);
    let b = (nx * ny) * a;
    [
        ((1.0 + ((sign * nx) * nx) * a) * p + b * q) + nx * up,
        ((sign * b) * p + (sign + (ny * ny) * a) * q) + ny * up,
        (nz * up - (sign * nx) * p) - ny * q,
    ]
}

#[cfg(test)]
#[path = "shading_tests.rs"]
mod tests;
