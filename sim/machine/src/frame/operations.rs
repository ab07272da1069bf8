//! The machine's own operations as a frame's program meets them.

use super::checker::Checker;
use crate::execute::Special;
use golden::Aabb;
use golden::bvh::{BoxStep, box_step};
use golden::dst::{Step, step};
use golden::precision::NarrowDst;
use golden::ray::PlaneRay;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// Golden's functions, with the samples of a frame's pixels and the frame's pipeline.
pub struct Operations<'a> {
    /// Selects the sample sequences.
    pub seed: u64,
    /// The dual-split tree in a narrower format, whose pipeline steps through it.
    pub narrow: Option<&'a NarrowDst>,
    /// Another implementation of the pipelines.
    pub checker: Option<&'a dyn Checker>,
    /// Operations that it was asked about.
    pub checked: AtomicU64,
    /// Those whose results are not golden's, bit for bit.
    pub differences: AtomicU64,
}

impl Operations<'_> {
    fn compared(&self, same: bool) {
        self.checked.fetch_add(1, Relaxed);
        self.differences.fetch_add(u64::from(!same), Relaxed);
    }
}

impl Special for Operations<'_> {
    fn random(&self, item: u32, dimension: u32) -> f32 {
        render::sample(self.seed, u64::from(item), 0, dimension)
    }

    #[inline(always)]
    fn step(&self, words: [u32; 3], ray: &PlaneRay, interval: [f32; 2]) -> Step {
        if let Some(narrow) = self.narrow {
            return narrow.step(words, ray, interval);
        }
        let [t_min, t_max] = interval;
        let golden = step(words, ray, t_min, t_max);
        if let Some(checker) = self.checker {
            self.compared(checker.step(words, ray, interval, &golden));
        }
        golden
    }

    #[inline(always)]
    fn box_test(&self, bounds: &Aabb, ray: &PlaneRay, t_max: f32) -> BoxStep {
        let golden = box_step(bounds, ray, 0.0, t_max);
        if let Some(checker) = self.checker {
            self.compared(checker.box_test(bounds, ray, t_max, &golden));
        }
        golden
    }
}
