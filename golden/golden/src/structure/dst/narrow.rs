//! The dual-split tree in a narrow format.

use super::header::{Header, LEAF_WORDS, NODE_WORDS};
use super::steps::traverse;
use super::{Dst, Step};
use crate::bvh::box_step;
use crate::precision::{NarrowDst, NarrowRay, Planes};
use crate::ray::{Hit, TraversalRay};
use crate::traverse::Observer;
use crate::traverse::query::Query;
use std::sync::Arc;

/// `dst` with its planes rounded; the same nodes at the same offsets.
pub(super) fn rounded(dst: &Dst, planes: &Planes) -> Dst {
    let mut words = dst.words().to_vec();
    let mut at = 0;
    while at < words.len() {
        let is_min = match Header::decode(words[at]) {
            Some(Header::Leaf { .. }) => {
                at += LEAF_WORDS as usize;
                continue;
            }
            Some(Header::CarveDual { is_min, .. }) => is_min,
            Some(Header::Split { .. } | Header::CarveSingle { .. }) | None => [false, true],
        };
        for (word, is_min) in words[at + 1..].iter_mut().zip(is_min) {
            *word = planes.plane(f32::from_bits(*word), is_min).to_bits();
        }
        at += NODE_WORDS as usize;
    }
    Dst::new(planes.aabb(&dst.root_box), words, Arc::clone(&dst.triangles))
}

impl NarrowDst {
    /// The nearest hit with every node step executed by `step`: [`crate::dst::step()`], or hardware.
    pub fn closest_by_steps<O: Observer>(
        &self,
        ray: &TraversalRay,
        observer: &mut O,
        step: impl FnMut([u32; 3], &NarrowRay, f32, f32) -> Step,
    ) -> Option<Hit> {
        let mut query = Query::<false>::new(ray, &self.structure.triangles);
        self.by_steps(&mut query, observer, step);
        query.hit()
    }

    pub(super) fn by_steps<const ANY: bool, O: Observer>(
        &self,
        query: &mut Query<'_, ANY>,
        observer: &mut O,
        mut step: impl FnMut([u32; 3], &NarrowRay, f32, f32) -> Step,
    ) -> bool {
        let ray = self.ray(query.ray);
        let root = box_step(&self.structure.root_box, &ray, ray.t_min, ray.t_max);
        let step = |words, low, high| step(words, &ray, low, high);
        traverse(&self.structure, root, query, observer, step, |t| ray.limit(t))
    }
}
