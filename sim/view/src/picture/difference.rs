//! The difference of two pictures, in numbers.

use super::{Format, Picture};

/// The difference of two pictures of one size.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// Root mean square difference over all channels. It is infinite if one of two values is finite and the other is not.
    pub rmse: f64,
    /// Peak signal-to-noise ratio in decibels, `20 log10(peak / rmse)`; infinite for equal pictures.
    pub psnr_db: f64,
    /// The peak value: 1 for PNG, the largest finite value of the first picture for EXR.
    pub peak: f64,
    /// The largest difference of any channel.
    pub max_abs: f64,
    /// Number of pixels with any difference.
    pub differing_pixels: u64,
    /// Largest difference of any channel, pixel by pixel.
    pub per_pixel: Picture<f32>,
}

/// The error for two pictures of different sizes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the pictures have {} x {} and {} x {} pixels; render both with the same --size", .0[0], .0[1], .1[0], .1[1])]
pub struct SizeMismatch([u32; 2], [u32; 2]);

impl Difference {
    /// Compares `a` with `b`, both read from files of `format`.
    ///
    /// # Errors
    /// [`SizeMismatch`] if their sizes differ.
    pub fn new(format: Format, a: &Picture<f32>, b: &Picture<f32>) -> Result<Self, SizeMismatch> {
        if (a.width, a.height) != (b.width, b.height) {
            return Err(SizeMismatch([a.width, a.height], [b.width, b.height]));
        }
        let pixels: Vec<[f32; 3]> = a
            .pixels
            .iter()
            .zip(&b.pixels)
            .map(|(a, b)| std::array::from_fn(|i| absolute_difference(a[i], b[i])))
            .collect();
        let values = || pixels.as_flattened().iter().map(|x| f64::from(*x));
        let count = values().count().max(1) as f64;
        let rmse = (values().map(|x| x * x).sum::<f64>() / count).sqrt();
        let peak = match format {
            Format::Png => 1.0,
            Format::Exr => {
                let finite = a.pixels.as_flattened().iter().filter(|x| x.is_finite());
                finite.fold(0.0, |peak, x| f64::max(peak, f64::from(*x)))
            }
        };
        let psnr_db = if rmse == 0.0 { f64::INFINITY } else { 20.0 * libm::log10(peak / rmse) };
        Ok(Self {
            rmse,
            psnr_db,
            peak,
            max_abs: values().fold(0.0, f64::max),
            differing_pixels: pixels.iter().filter(|rgb| **rgb != [0.0; 3]).count() as u64,
            per_pixel: Picture { pixels, ..*a },
        })
    }

    /// Whether no channel of any pixel differs.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.differing_pixels == 0
    }
}

/// The absolute difference of two values. It is zero for two NaNs and for equal infinities, and infinite where it would be NaN.
fn absolute_difference(a: f32, b: f32) -> f32 {
    if a == b || a.is_nan() && b.is_nan() {
        return 0.0;
    }
    let difference = (a - b).abs();
    if difference.is_nan() { f32::INFINITY } else { difference }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(values: [f32; 6]) -> Picture<f32> {
        Picture { width: 2, height: 1, pixels: values.as_chunks().0.to_vec() }
    }

    #[test]
    fn numbers() {
        let a = picture([0.0, 0.5, 1.0, 0.25, 0.25, 0.25]);
        let b = picture([0.0, 0.5, 0.4, 0.25, 0.25, 0.25]);
        let difference = Difference::new(Format::Png, &a, &b).unwrap();
        assert!((difference.rmse - 0.6 / 6f64.sqrt()).abs() < 1e-7);
        assert!((difference.psnr_db - 20.0 * (6f64.sqrt() / 0.6).log10()).abs() < 1e-6);
        assert_eq!(difference.differing_pixels, 1);
        assert_eq!(difference.max_abs, f64::from(1.0f32 - 0.4));
        let same = Difference::new(Format::Exr, &a, &a).unwrap();
        assert!(same.is_empty() && same.psnr_db == f64::INFINITY && same.peak == 1.0);
    }

    #[test]
    fn values_that_are_no_numbers() {
        let a = picture([f32::NAN, f32::INFINITY, 0.0, 1.0, 1.0, 1.0]);
        assert!(Difference::new(Format::Exr, &a, &a).unwrap().is_empty());
        let b = picture([0.0, f32::INFINITY, 0.0, 1.0, 1.0, 1.0]);
        let difference = Difference::new(Format::Exr, &a, &b).unwrap();
        assert_eq!((difference.differing_pixels, difference.rmse), (1, f64::INFINITY));
    }

    #[test]
    fn sizes_must_agree() {
        let a = picture([0.0; 6]);
        let b = Picture { width: 1, height: 2, ..a.clone() };
        let error = Difference::new(Format::Png, &a, &b).unwrap_err();
        assert!(error.to_string().contains("2 x 1 and 1 x 2"));
    }
}
