//! Sample points, a function of seed, pixel, sample and bounce alone.

use base::split_mix::hash;

/// Number of dimensions of a sample point.
pub const SAMPLE_DIMENSIONS: u32 = sobol_burley::NUM_DIMENSIONS;

/// A component of a sample point in [0, 1): the value of the Owen-scrambled Sobol sequence of pixel `pixel`, counted row by row, at
/// `sample_index` and `dimension`, with which a picture of seed `seed` is rendered.
///
/// Dimensions 0 and 1 are the place in the pixel, of all samples but the first; 2 + 2 `b` and 3 + 2 `b` the direction of bounce `b`,
/// counted from 0.
///
/// # Panics
/// If `dimension` is [`SAMPLE_DIMENSIONS`] or greater.
#[must_use]
pub fn sample(seed: u64, pixel: u64, sample_index: u32, dimension: u32) -> f32 {
    PixelSamples::new(seed, pixel).value(sample_index, dimension)
}

/// The Owen-scrambled Sobol sequence of one pixel.
#[derive(Clone, Copy, Debug)]
pub(super) struct PixelSamples {
    seed: u32,
}

const PIXEL_DIMENSION: u32 = 0;
const FIRST_BOUNCE_DIMENSION: u32 = 2;

impl PixelSamples {
    pub fn new(seed: u64, pixel: u64) -> Self {
        Self { seed: (hash(hash(seed).wrapping_add(pixel)) >> 32) as u32 }
    }

    /// Where sample `sample` is in its pixel, from the upper left corner; the first is in the centre.
    pub fn place(self, sample: u32) -> [f32; 2] {
        if sample == 0 { [0.5; 2] } else { self.point(sample, PIXEL_DIMENSION) }
    }

    /// The point in the unit square from which the direction of bounce `bounce`, counted from 0, is made.
    pub fn bounce(self, sample: u32, bounce: usize) -> [f32; 2] {
        self.point(sample, FIRST_BOUNCE_DIMENSION + 2 * bounce as u32)
    }

    fn point(self, sample: u32, dimension: u32) -> [f32; 2] {
        [0, 1].map(|i| self.value(sample, dimension + i))
    }

    fn value(self, sample: u32, dimension: u32) -> f32 {
        sobol_burley::sample(sample, dimension, self.seed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_seeds_and_dimensions_differ() {
        let first = |seed, pixel, bounce| PixelSamples::new(seed, pixel).bounce(1, bounce);
        let all = [first(0, 0, 0), first(1, 0, 0), first(0, 1, 0), first(0, 0, 1)];
        for (i, a) in all.iter().enumerate() {
            assert!(!all[..i].contains(a), "{all:?}");
        }
        assert_eq!(PixelSamples::new(3, 5).place(0), [0.5; 2]);
        assert_ne!(PixelSamples::new(3, 5).place(1), PixelSamples::new(3, 6).place(1));
        assert_eq!(PixelSamples::new(3, 5).place(7), [sample(3, 5, 7, 0), sample(3, 5, 7, 1)]);
        let dimensions: Vec<f32> = (0..12).map(|dimension| sample(3, 5, 7, dimension)).collect();
        for (i, value) in dimensions.iter().enumerate() {
            assert!(!dimensions[..i].contains(value), "{dimensions:?}");
        }
        assert_eq!(PixelSamples::new(3, 5).bounce(7, 4), [sample(3, 5, 7, 10), sample(3, 5, 7, 11)]);
    }
}
