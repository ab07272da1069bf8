//! One pixel as it is recorded: the events on its tape, the ray that is on its way, and totals.

use super::checker::Checker;
use super::layout::Layout;
use super::names::Names;
use super::triangle::{Side, Tests};
use crate::core::Tape;
use crate::program::{Conditions, EntryId};
use golden::bvh::BoxStep;
use golden::dst::{Child, Step};
use golden::triangle::{Triangle, TriangleHit};
use golden::{Aabb, Hit, TraversalRay};

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

/// What is being recorded.
pub struct State<'a, 'tape, 'words> {
    pub names: &'a Names,
    pub layout: &'a Layout,
    pub tape: &'tape mut Tape<'words>,
    /// The last event of the last ray: how it goes on depends on what the pixel does next.
    pending: Option<(EntryId, Conditions)>,
    /// Whether the netlist executes the pipeline's operations too.
    checker: Option<&'a dyn Checker>,
    pub totals: Totals,
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

impl<'a> Query<'a> {
    pub fn new(ray: &'a TraversalRay, any: bool, triangles: &'a [Triangle]) -> Self {
        Self { ray, any, t_max: ray.t_max, tests: Tests::new(ray), triangles, best: None }
    }

    pub fn hit(&self) -> Option<Hit> {
        self.best.map(|(TriangleHit { t, u, v }, slot)| Hit {
            t: self.ray.given_t(t),
            u,
            v,
            triangle: self.triangles[slot as usize].index(),
        })
    }
}

impl<'a, 'tape, 'words> State<'a, 'tape, 'words> {
    pub fn new(
        names: &'a Names,
        layout: &'a Layout,
        checker: Option<&'a dyn Checker>,
        tape: &'tape mut Tape<'words>,
    ) -> Self {
        Self { names, layout, tape, pending: None, checker, totals: Totals::default() }
    }

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

    /// The last ray's last event is followed by what the pixel does next.
    pub fn go_on(&mut self, how: Conditions) {
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
