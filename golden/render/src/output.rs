//! What a rendering consists of.

use super::stream::{RayClass, RayStream};
use golden::traverse::Counters;

/// What rays have cost in one pixel: sums over all its rays, and the deepest stack.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Nodes read.
    pub node_visits: u32,
    /// Planes that rays were intersected with, six to a box.
    pub plane_tests: u32,
    /// Boxes tested.
    pub box_tests: u32,
    /// Triangles tested.
    pub triangle_tests: u32,
    /// The largest number of entries that a stack held.
    pub stack_depth: u32,
}

impl Work {
    pub(super) fn add(&mut self, ray: &Counters) {
        let sum =
            |total: &mut u32, x: u64| *total = total.saturating_add(u32::try_from(x).unwrap_or(u32::MAX));
        sum(&mut self.node_visits, ray.node_visits);
        sum(&mut self.plane_tests, ray.plane_tests);
        sum(&mut self.box_tests, ray.box_tests);
        sum(&mut self.triangle_tests, ray.triangle_tests);
        self.stack_depth = self.stack_depth.max(ray.stack_depth);
    }
}

/// One pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pixel {
    /// Mean radiance of all samples, linear RGB.
    pub rgb: [f32; 3],
    /// Distance from the eye along the ray through the pixel's centre, in scene units; infinite where nothing is hit.
    pub depth: f32,
    /// Unit normal of what is seen in the pixel's centre, turned towards the eye; zero where nothing is hit.
    pub normal: [f32; 3],
    /// Index of the triangle in the pixel's centre, [`Pixel::NO_TRIANGLE`] where nothing is hit.
    pub triangle: u32,
    /// The cost of all the pixel's rays.
    pub work: Work,
}

impl Pixel {
    /// [`Pixel::triangle`] where nothing is hit.
    pub const NO_TRIANGLE: u32 = u32::MAX;
}

/// The rays of one class.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ClassTotals {
    /// How many there are.
    pub rays: u64,
    /// How many hit something; for shadow rays, how many are blocked.
    pub hits: u64,
    /// What they have cost.
    pub counters: Counters,
}

impl ClassTotals {
    /// Adds the rays of `other`.
    pub fn merge(&mut self, other: &ClassTotals) {
        self.rays += other.rays;
        self.hits += other.hits;
        self.counters.merge(&other.counters);
    }
}

/// A finished rendering.
#[derive(Clone, Debug, PartialEq)]
pub struct Rendering {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Row by row from the top.
    pub pixels: Vec<Pixel>,
    /// Totals of each class that rendering makes, in the order of [`RayClass::of_wave`].
    pub totals: [ClassTotals; RayClass::WAVES],
    /// All rays, if they were to be kept.
    pub rays: Option<RayStream>,
}

impl Rendering {
    /// Totals of all rays.
    #[must_use]
    pub fn total(&self) -> ClassTotals {
        let mut sum = ClassTotals::default();
        self.totals.iter().for_each(|class| sum.merge(class));
        sum
    }

    /// The classes that have rays, with their totals.
    pub fn classes(&self) -> impl Iterator<Item = (RayClass, &ClassTotals)> {
        let totals = self.totals.iter().enumerate().filter(|(_, totals)| totals.rays > 0);
        totals.map(|(wave, totals)| (RayClass::of_wave(wave), totals))
    }
}
