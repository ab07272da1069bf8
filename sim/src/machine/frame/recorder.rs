//! Records the rays of one pixel.

use super::layout::Layout;
use super::names::Names;
use super::triangle::{Side, Tests};
use super::walk;
use crate::machine::core::Tape;
use crate::machine::program::{Conditions, EntryId};
use golden::structure::Structure;
use golden::traverse::{Trace, Traversal};
use golden::triangle::{Triangle, TriangleHit};
use golden::{Hit, TraversalRay};
use std::sync::Mutex;

/// Totals of a pixel.
#[derive(Clone, Copy, Debug, Default)]
pub struct Totals {
    pub rays: u64,
    pub exact_tests: u64,
    pub triangle_tests: u64,
}

/// Traces through a golden structure by golden steps, and records what the program does.
pub struct Recorder<'a, 'tape, 'words> {
    structure: &'a Structure,
    state: Mutex<State<'a, 'tape, 'words>>,
}

/// What is being recorded.
pub struct State<'a, 'tape, 'words> {
    pub names: &'a Names,
    pub layout: &'a Layout,
    pub tape: &'tape mut Tape<'words>,
    /// The last event of the last ray: how it goes on depends on what the pixel does next.
    pending: Option<(EntryId, Conditions)>,
    totals: Totals,
}

/// A ray on its way.
pub struct Query<'a> {
    pub ray: &'a TraversalRay,
    pub any: bool,
    pub t_max: f32,
    tests: Tests,
    triangles: &'a [Triangle],
    best: Option<(TriangleHit, u32)>,
}

impl<'a, 'tape, 'words> Recorder<'a, 'tape, 'words> {
    pub fn new(
        structure: &'a Structure,
        names: &'a Names,
        layout: &'a Layout,
        tape: &'tape mut Tape<'words>,
    ) -> Self {
        let state = State { names, layout, tape, pending: None, totals: Totals::default() };
        Self { structure, state: Mutex::new(state) }
    }

    /// The pixel's address.
    pub fn pixel(&self, word: u32) {
        let mut state = self.state.lock().expect("no panic while it was held");
        let base = state.names.pixel;
        state.tape.address(base, word);
    }

    /// Ends the pixel.
    pub fn finish(self) -> Totals {
        let mut state = self.state.into_inner().expect("no panic while it was held");
        let last_bounce = state.names.last_bounce;
        state.go_on(last_bounce);
        state.totals
    }

    fn trace(&self, ray: &TraversalRay, any: bool) -> Option<Hit> {
        let mut state = self.state.lock().expect("no panic while it was held");
        // A shadow ray is cast if the light is above the surface; another ray if not, or after a shadow ray.
        let how = if any { state.names.lit } else { 0 };
        state.go_on(how);
        state.totals.rays += 1;
        match self.structure {
            Structure::Dst(dst) => {
                let mut query = Query::new(ray, any, &dst.triangles);
                walk::dst(dst, &mut query, &mut state);
                query.hit()
            }
            Structure::Bvh2(bvh) => {
                let mut query = Query::new(ray, any, &bvh.triangles);
                walk::bvh2(bvh, &mut query, &mut state);
                query.hit()
            }
            Structure::Bvh4(bvh) => {
                let mut query = Query::new(ray, any, &bvh.triangles);
                walk::wide(bvh, &mut query, &mut state);
                query.hit()
            }
            Structure::Bvh8(bvh) => {
                let mut query = Query::new(ray, any, &bvh.triangles);
                walk::wide(bvh, &mut query, &mut state);
                query.hit()
            }
        }
    }
}

impl Trace for Recorder<'_, '_, '_> {
    fn closest_prepared<O: Traversal>(&self, ray: &TraversalRay, _observer: &mut O) -> Option<Hit> {
        self.trace(ray, false)
    }

    fn occluded_prepared<O: Traversal>(&self, ray: &TraversalRay, _observer: &mut O) -> bool {
        self.trace(ray, true).is_some()
    }
}

impl<'a> Query<'a> {
    fn new(ray: &'a TraversalRay, any: bool, triangles: &'a [Triangle]) -> Self {
        Self { ray, any, t_max: ray.t_max, tests: Tests::new(ray), triangles, best: None }
    }

    fn hit(&self) -> Option<Hit> {
        self.best.map(|(TriangleHit { t, u, v }, slot)| Hit {
            t: self.ray.given_t(t),
            u,
            v,
            triangle: self.triangles[slot as usize].index(),
        })
    }
}

impl State<'_, '_, '_> {
    #[inline(always)]
    pub fn event(&mut self, at: EntryId, conditions: Conditions) {
        self.tape.event(at, conditions);
    }

    /// The ray has ended with this event.
    pub fn end(&mut self, query: &Query<'_>, at: EntryId, conditions: Conditions) {
        let mut conditions = conditions;
        if query.any {
            conditions |= self.names.any;
        }
        match query.best {
            None => conditions |= self.names.nothing,
            Some((_, slot)) => {
                self.tape.address(self.names.hit_address, self.triangle_address(slot));
            }
        }
        self.pending = Some((at, conditions));
    }

    fn go_on(&mut self, how: Conditions) {
        if let Some((at, conditions)) = self.pending.take() {
            self.event(at, conditions | how);
        }
    }

    fn triangle_address(&self, slot: u32) -> u32 {
        self.layout.triangles_at + slot * Triangle::WORDS
    }

    /// Tests the triangles of the leaf that begins in slot `first`; returns whether that ends the ray.
    pub fn leaf(&mut self, query: &mut Query<'_>, first: u32) -> bool {
        let mut slot = first;
        loop {
            let triangle = &query.triangles[slot as usize];
            let address = self.triangle_address(slot);
            self.tape.address(self.names.triangle_address, address);
            for (row, axis) in self.names.rows.into_iter().zip(query.tests.axes) {
                self.tape.address(row, address + 3 * axis as u32);
            }
            self.totals.triangle_tests += 1;
            let names = self.names;
            let mut conditions = if triangle.is_last() { names.last } else { 0 };
            let (side, t) = query.tests.side(query.ray, triangle);
            conditions |= match side {
                Side::Outside => names.outside,
                Side::Positive => names.positive,
                Side::Negative => names.negative,
                Side::Uncertain => {
                    self.totals.exact_tests += 1;
                    names.exact
                }
            };
            if side != Side::Outside {
                match query.tests.intersect(query.ray, triangle, query.t_max) {
                    None => conditions |= if t < query.ray.t_min { names.behind } else { names.farther },
                    Some(hit) => {
                        let index = triangle.index();
                        let lowest = |slot: u32| query.triangles[slot as usize].index();
                        if query.best.is_none_or(|(best, slot)| hit.t < best.t || index < lowest(slot)) {
                            query.t_max = hit.t;
                            query.best = Some((hit, slot));
                        }
                        if query.any {
                            self.end(query, names.triangle, conditions);
                            return true;
                        }
                    }
                }
            }
            self.event(names.triangle, conditions);
            if triangle.is_last() {
                return false;
            }
            slot += 1;
        }
    }
}
