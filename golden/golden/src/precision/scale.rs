//! The power of two that brings a scene into a format's range.

use crate::Aabb;
use fp::Format;

/// Scene units times `2^exponent` are the format's units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    exponent: i32,
    factor: f64,
    inverse: f64,
}

impl Scale {
    /// Half of the format's binades above 1 for coordinates, the other half for the reciprocals that they are multiplied by;
    /// but no larger than leaves the least subnormal at 2^-149 scene units.
    #[must_use]
    pub fn of_scene(bounds: &Aabb, format: Format) -> Self {
        let largest = bounds.min.iter().chain(&bounds.max).fold(0.0f32, |m, x| m.max(x.abs()));
        let room = (format.bias() + 1) / 2;
        let wanted = if largest > 0.0 { room - binades(largest) } else { 0 };
        let least = 1 - format.bias() - format.fraction_bits() as i32;
        Self::new(wanted.min(least + 149))
    }

    /// Scaling by `2^exponent`.
    ///
    /// # Panics
    /// If the exponent is beyond ±512, where doubles would not hold every scaled binary32 number.
    #[must_use]
    pub fn new(exponent: i32) -> Self {
        assert!(exponent.abs() <= 512, "scene scale 2^{exponent}");
        let power = |e: i32| f64::from_bits(((1023 + i64::from(e)) as u64) << 52);
        Self { exponent, factor: power(exponent), inverse: power(-exponent) }
    }

    /// The power of two.
    #[must_use]
    pub fn exponent(self) -> i32 {
        self.exponent
    }

    /// `x` scene units in the format's, exactly.
    #[inline(always)]
    #[must_use]
    pub fn scaled(self, x: f32) -> f64 {
        f64::from(x) * self.factor
    }

    /// `x` of the format's units in scene units, exactly.
    #[inline(always)]
    #[must_use]
    pub fn unscaled(self, x: f32) -> f64 {
        f64::from(x) * self.inverse
    }
}

/// The least `e` with `x < 2^e`, for positive finite `x`.
fn binades(x: f32) -> i32 {
    (f64::from(x).to_bits() >> 52) as i32 - 1022
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_fit_their_format() {
        for largest in [1e-40f32, 1e-20, 0.1, 1.0, 31.5, 1e9, scenes::MAX_COORDINATE] {
            let bounds = Aabb { min: [-largest / 3.0; 3], max: [largest; 3] };
            for format in [Format::BINARY32, Format::TF32, Format::BINARY16, Format::E5M2, Format::E4M3] {
                let scale = Scale::of_scene(&bounds, format);
                assert!(scale.scaled(largest) < f64::from(1u32 << 31) * f64::from(1u32 << 31) * 4.0);
                let max = fp::Arithmetic::new(format).to_f32(format.max_finite());
                assert!(scale.scaled(largest) <= f64::from(max), "{largest} in {format}");
                assert_eq!(scale.unscaled(scale.scaled(largest) as f32), f64::from(largest));
                let least = fp::Arithmetic::new(format).to_f32(1);
                assert!(scale.unscaled(least) >= f64::from(f32::from_bits(1)));
            }
        }
        let bounds = Aabb { min: [0.0; 3], max: [1.0, 2.0, 100.0] };
        assert_eq!(Scale::of_scene(&bounds, Format::BINARY32).exponent(), 0);
        assert_eq!(Scale::of_scene(&bounds, Format::BINARY16).exponent(), 8 - 7);
    }
}
