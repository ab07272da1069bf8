//! A ray on its way through a structure: what it has hit so far.

use super::Observer;
use crate::ray::{Hit, TraversalRay};
use crate::triangle::{Triangle, TriangleHit, TriangleTest};

/// A closest-hit query, or with `ANY` one that ends at the first hit.
pub struct Query<'a, const ANY: bool> {
    pub ray: &'a TraversalRay,
    test: TriangleTest,
    triangles: &'a [Triangle],
    /// Distance of the best hit, at first the end of the ray.
    pub t_max: f32,
    best: Option<(TriangleHit, u32)>,
}

impl<'a, const ANY: bool> Query<'a, ANY> {
    #[inline(always)]
    pub fn new(ray: &'a TraversalRay, triangles: &'a [Triangle]) -> Self {
        Self { ray, test: TriangleTest::new(ray), triangles, t_max: ray.t_max, best: None }
    }

    /// Tests the triangles of the leaf that begins in slot `first`; returns whether the query is answered.
    #[inline(always)]
    pub fn leaf<O: Observer>(&mut self, first: u32, observer: &mut O) -> bool {
        let mut slot = first as usize;
        loop {
            let triangle = &self.triangles[slot];
            if self.triangle(triangle, slot as u32, observer) && ANY {
                return true;
            }
            if triangle.is_last() {
                return false;
            }
            slot += 1;
        }
    }

    /// Tests the triangle in `slot` and keeps the hit if it is the best so far; returns whether there is one.
    #[inline(always)]
    pub fn triangle<O: Observer>(&mut self, triangle: &Triangle, slot: u32, observer: &mut O) -> bool {
        let found = self.test.intersect(self.ray, triangle, self.t_max);
        observer.triangle(slot, found.as_ref().map(|hit| hit.t));
        let Some(hit) = found else {
            return false;
        };
        let index = triangle.index();
        if self.best.is_none_or(|(best, lowest)| hit.t < best.t || index < lowest) {
            self.t_max = hit.t;
            self.best = Some((hit, index));
            observer.hit(slot, self.t_max);
        }
        true
    }

    /// The best hit, with its distance along the direction that was given.
    #[inline(always)]
    pub fn hit(&self) -> Option<Hit> {
        self.best.map(|(TriangleHit { t, u, v }, triangle)| Hit { t: self.ray.given_t(t), u, v, triangle })
    }
}
