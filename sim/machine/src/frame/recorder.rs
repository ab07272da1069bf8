//! Records the rays of one pixel.

use super::checker::Checker;
use super::layout::Layout;
use super::names::Names;
use super::triangle::{Side, Tests};
use super::walk;
use crate::core::Tape;
use crate::program::{Conditions, EntryId};
use golden::bvh::BoxStep;
use golden::dst::{Child, Step};
use golden::precision::NarrowDst;
use golden::structure::Structure;
use golden::traverse::{Observer, Trace};
use golden::triangle::{Triangle, TriangleHit};
use golden::{Aabb, Hit, TraversalRay};
use std::sync::Mutex;

/// Totals of pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Totals {
    /// Rays traced.
    pub rays: u64,
    /// Triangle tests that single precision did not decide.
    pub exact_tests: u64,
    /// All triangle tests.
    pub triangle_tests: u64,
    /// Steps and box tests that the pipeline's netlist executed.
    pub rtl_operations: u64,
    /// Those whose results are not golden's, bit for bit.
    pub rtl_differences: u64,
}

impl Totals {
    /// Adds those of `other`.
    pub fn merge(&mut self, other: &Self) {
        self.rays += other.rays;
        self.exact_tests += other.exact_tests;
        self.triangle_tests += other.triangle_tests;
        self.rtl_operations += other.rtl_operations;
        self.rtl_differences += other.rtl_differences;
    }
}

/// What rays are traced through.
#[derive(Clone, Copy)]
pub enum Traced<'a> {
    /// In binary32.
    Wide(&'a Structure),
    /// A dual-split tree in a narrower format.
    Narrow(&'a NarrowDst),
}

/// Traces through a golden structure by golden steps, and records what the program does.
pub struct Recorder<'a, 'tape, 'words> {
    traced: Traced<'a>,
    state: Mutex<State<'a, 'tape, 'words>>,
}

/// What is being recorded.
pub struct State<'a, 'tape, 'words> {
    pub names: &'a Names,
    pub layout: &'a Layout,
    pub tape: &'tape mut Tape<'words>,
    /// The last event of the last ray: how it goes on depends on what the pixel does next.
    pending: Option<(EntryId, Conditions)>,
    /// Whether the netlist executes the pipeline's operations too.
    checker: Option<&'a dyn Checker>,
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
        traced: Traced<'a>,
        names: &'a Names,
        layout: &'a Layout,
        checker: Option<&'a dyn Checker>,
        tape: &'tape mut Tape<'words>,
    ) -> Self {
        let state = State { names, layout, tape, pending: None, checker, totals: Totals::default() };
        Self { traced, state: Mutex::new(state) }
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
        match self.traced {
            Traced::Narrow(dst) => {
                let mut query = Query::new(ray, any, &dst.structure.triangles);
                walk::narrow_dst(dst, &mut query, &mut state);
                query.hit()
            }
            Traced::Wide(Structure::Dst(dst)) => {
                let mut query = Query::new(ray, any, &dst.triangles);
                walk::dst(dst, &mut query, &mut state);
                query.hit()
            }
            Traced::Wide(Structure::Bvh2(bvh)) => {
                let mut query = Query::new(ray, any, &bvh.triangles);
                walk::bvh2(bvh, &mut query, &mut state);
                query.hit()
            }
            Traced::Wide(Structure::Bvh4(bvh)) => {
                let mut query = Query::new(ray, any, &bvh.triangles);
                walk::wide(bvh, &mut query, &mut state);
                query.hit()
            }
            Traced::Wide(Structure::Bvh8(bvh)) => {
                let mut query = Query::new(ray, any, &bvh.triangles);
                walk::wide(bvh, &mut query, &mut state);
                query.hit()
            }
            Traced::Wide(other) => panic!("the machine has no program for {}", other.kind()),
        }
    }
}

impl Trace for Recorder<'_, '_, '_> {
    fn closest_prepared<O: Observer>(&self, ray: &TraversalRay, _observer: &mut O) -> Option<Hit> {
        self.trace(ray, false)
    }

    fn occluded_prepared<O: Observer>(&self, ray: &TraversalRay, _observer: &mut O) -> bool {
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
    /// Compares a step of the dual-split pipeline with its netlist's.
    #[inline(always)]
    pub fn step(&mut self, words: [u32; 3], ray: &TraversalRay, here: &Child, golden: &Step) {
        if let Some(checker) = self.checker {
            let same = checker.step(words, ray, here, golden);
            self.compared(same);
        }
    }

    /// Compares a box test of the ray-box pipeline with its netlist's.
    #[inline(always)]
    pub fn box_test(&mut self, bounds: &Aabb, ray: &TraversalRay, t_max: f32, golden: &BoxStep) {
        if let Some(checker) = self.checker {
            let same = checker.box_test(bounds, ray, t_max, golden);
            self.compared(same);
        }
    }

    fn compared(&mut self, same: bool) {
        self.totals.rtl_operations += 1;
        self.totals.rtl_differences += u64::from(!same);
    }

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
