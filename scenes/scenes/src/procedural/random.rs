//! Random numbers that are the same on every machine.

use base::split_mix::{STEP, hash, mix, next};
use glam::DVec3;

/// SplitMix64. Each item of a scene has a generator of its own, so that it looks the same at every detail.
#[derive(Clone, Debug)]
pub(super) struct Random {
    state: u64,
}

impl Random {
    /// The generator of item `item` of kind `kind`, independent of all others with this seed.
    pub(super) fn new(seed: u64, kind: u64, item: u64) -> Self {
        Self { state: mix(mix(hash(seed) ^ kind).wrapping_add(STEP) ^ item) }
    }

    pub(super) fn bits(&mut self) -> u64 {
        next(&mut self.state)
    }

    /// Uniform in [0, 1), a multiple of 2^-53.
    pub(super) fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * f64::EPSILON * 0.5
    }

    /// Uniform in [low, high).
    pub(super) fn range(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Uniform among 0 to `count - 1`, with a bias below 2^-32.
    pub(super) fn below(&mut self, count: u32) -> u32 {
        (((self.bits() >> 32) * u64::from(count)) >> 32) as u32
    }

    /// A point on the unit sphere, uniform by rejection from the ball.
    pub(super) fn direction(&mut self) -> DVec3 {
        loop {
            let p = DVec3::new(self.range(-1.0, 1.0), self.range(-1.0, 1.0), self.range(-1.0, 1.0));
            let length_squared = p.length_squared();
            if (1e-6..=1.0).contains(&length_squared) {
                return p / length_squared.sqrt();
            }
        }
    }
}

/// Smooth noise in about [-1, 1] with features of size 1: hashed lattice values, cubic in between.
pub(super) fn noise(seed: u64, p: DVec3) -> f64 {
    let cell = p.floor();
    let fraction = p - cell;
    let weight = fraction * fraction * (DVec3::splat(3.0) - 2.0 * fraction);
    let [x, y, z] = cell.to_array().map(|c| c as i64 as u64);
    let lattice = |dx: u64, dy: u64, dz: u64| {
        let key = x.wrapping_add(dx).wrapping_mul(0x9E37_79B1)
            ^ y.wrapping_add(dy).wrapping_mul(0x85EB_CA77_0000_0001)
            ^ z.wrapping_add(dz).wrapping_mul(0xC2B2_AE3D_27D4_EB4F);
        (mix(key ^ seed) >> 11) as f64 * f64::EPSILON - 1.0
    };
    let along_x = |dy, dz| lerp(lattice(0, dy, dz), lattice(1, dy, dz), weight.x);
    let along_y = |dz| lerp(along_x(0, dz), along_x(1, dz), weight.y);
    lerp(along_y(0), along_y(1), weight.z)
}

/// `octaves` of [`noise`], each of half the size and strength of the one before.
pub(super) fn fractal_noise(seed: u64, p: DVec3, octaves: u32) -> f64 {
    let mut sum = 0.0;
    let (mut frequency, mut strength) = (1.0, 0.5);
    for octave in 0..octaves {
        sum += strength * noise(seed.wrapping_add(u64::from(octave)), p * frequency);
        frequency *= 2.0;
        strength *= 0.5;
    }
    sum
}

pub(super) fn lerp(a: f64, b: f64, t: f64) -> f64 {
    a + (b - a) * t
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn items_differ_and_repeat() {
        let first = |seed, kind, item| Random::new(seed, kind, item).bits();
        assert_eq!(first(1, 2, 3), first(1, 2, 3));
        let all = [first(1, 2, 3), first(0, 2, 3), first(1, 0, 3), first(1, 2, 0), first(3, 2, 1)];
        for (i, a) in all.iter().enumerate() {
            assert!(!all[..i].contains(a));
        }
    }

    #[test]
    fn ranges() {
        let mut random = Random::new(0, 0, 0);
        let mut sum = 0.0;
        for _ in 0..10_000 {
            let x = random.range(2.0, 4.0);
            assert!((2.0..4.0).contains(&x));
            sum += x;
            assert!(random.below(7) < 7);
            assert!((random.direction().length() - 1.0).abs() < 1e-12);
        }
        assert!((sum / 10_000.0 - 3.0).abs() < 0.02);
    }

    #[test]
    fn noise_is_continuous_and_bounded() {
        for i in 0..1000 {
            let p = DVec3::new(f64::from(i) * 0.37 - 200.0, f64::from(i) * 0.011, 0.5);
            let here = fractal_noise(9, p, 4);
            assert!(here.abs() <= 1.0);
            assert!((here - fractal_noise(9, p + DVec3::splat(1e-9), 4)).abs() < 1e-7);
        }
    }
}
