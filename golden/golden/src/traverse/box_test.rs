//! The ray-box test of the kernels: two boxes, or one, in four lanes.

use crate::Aabb;
use crate::ray::TraversalRay;
use crate::simd::F32x4;

/// A ray, prepared for boxes.
pub(crate) struct BoxTest {
    origin: F32x4,
    inv_entry: F32x4,
    inv_exit: F32x4,
    /// All ones in the lanes whose axis is entered at its max plane.
    negative: F32x4,
    t_min: F32x4,
}

impl BoxTest {
    #[inline(always)]
    pub fn new(ray: &TraversalRay) -> Self {
        let four = |[x, y, z]: [f32; 3]| F32x4::new([x, y, z, z]);
        let mask = |axis: usize| f32::from_bits(if ray.is_negative(axis) { u32::MAX } else { 0 });
        Self {
            origin: four(ray.origin),
            inv_entry: four(ray.inv_entry),
            inv_exit: four(ray.inv_exit),
            negative: four([mask(0), mask(1), mask(2)]),
            t_min: F32x4::splat(ray.t_min),
        }
    }

    /// Distances to the planes of entry and of exit, one axis to a lane.
    #[inline(always)]
    fn planes(&self, aabb: &Aabb) -> (F32x4, F32x4) {
        let words: &[f32; 6] = bytemuck::cast_ref(aabb);
        let min = F32x4::load(words[..4].try_into().expect("four words"));
        // The last four words, rotated so that the maxima come first.
        let max = F32x4::load(words[2..].try_into().expect("four words")).yzwx();
        let (entry, exit) = min.exchange(max, self.negative);
        (entry.sub(self.origin).mul(self.inv_entry), exit.sub(self.origin).mul(self.inv_exit))
    }

    /// Which of two boxes are hit (bit 0, bit 1), and where they are entered.
    #[inline(always)]
    pub fn pair(&self, a: &Aabb, b: &Aabb, t_max: f32) -> (u32, [f32; 2]) {
        let (entry_a, exit_a) = self.planes(a);
        let (entry_b, exit_b) = self.planes(b);
        // Lanes: x of a, x of b, y of a, y of b; then z of a, z of b. NaN is dropped by standing first.
        let t_max = F32x4::splat(t_max);
        let (low, high) = (entry_a.interleave_low(entry_b), entry_a.interleave_high(entry_b));
        let t_entry = high.max(low.max(self.t_min)).max(low.max(self.t_min).zwxy());
        let (low, high) = (exit_a.interleave_low(exit_b), exit_a.interleave_high(exit_b));
        let t_exit = high.min(low.min(t_max)).min(low.min(t_max).zwxy());
        let [ta, tb, ..] = t_entry.to_array();
        (t_entry.le(t_exit) & 3, [ta, tb])
    }

    /// The part of the ray up to `t_max` that lies in `aabb`, if there is any.
    #[inline(always)]
    pub fn interval(&self, aabb: &Aabb, t_max: f32) -> Option<[f32; 2]> {
        let (entry, exit) = self.planes(aabb);
        let t_entry = entry.max(self.t_min);
        let t_entry = t_entry.max(t_entry.yzx()).max(t_entry.zxy());
        let t_exit = exit.min(F32x4::splat(t_max));
        let t_exit = t_exit.min(t_exit.yzx()).min(t_exit.zxy());
        (t_entry.le(t_exit) & 1 == 1).then(|| [t_entry.x(), t_exit.x()])
    }
}
