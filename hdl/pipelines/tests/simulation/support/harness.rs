//! Runs a pipeline cycle by cycle against golden, with bubbles and stalls.

use super::steps::Cases;
use pipelines::catalogue::{StandardFormat, Top};
use std::collections::VecDeque;
use std::fmt::Debug;

pub const TAG_BITS: usize = 5;

/// Latency of a top, which is the same in every format.
pub fn latency_cycles(top: Top) -> usize {
    let netlist = netlist::flatten(&top.design(StandardFormat::Binary32).unwrap()).unwrap();
    netlist::latency_cycles(&netlist).expect("a plain pipeline") as usize
}

/// What the pipelines have in common.
pub trait Pipeline: Default {
    /// The top whose latency it has.
    const TOP: Top;
    type Case: Copy + Debug;
    type Outcome: PartialEq + Debug;
    fn draw(cases: &mut Cases) -> Self::Case;
    fn golden(case: &Self::Case) -> Self::Outcome;
    fn tick(&mut self);
    fn drive(&mut self, case: &Self::Case);
    fn handshake(&mut self, enable: bool, valid: bool, tag: u64);
    /// Tag and outcome, if the output is valid.
    fn output(&self) -> Option<(u64, Self::Outcome)>;
}

/// Drives the ports that describe a ray.
macro_rules! drive_ray {
    ($unit:expr, $ray:expr) => {
        let word = |bits: u32| u64::from(bits).into();
        let $crate::support::steps::RayWords { origin, inv_entry, inv_exit, t_min, t_max } = $ray;
        let to = &mut $unit.ray;
        (to.origin.origin_x_i.next, to.origin.origin_y_i.next, to.origin.origin_z_i.next) =
            (word(origin[0]), word(origin[1]), word(origin[2]));
        let inv = &mut to.reciprocals;
        (inv.inv_entry_x_i.next, inv.inv_entry_y_i.next, inv.inv_entry_z_i.next) =
            (word(inv_entry[0]), word(inv_entry[1]), word(inv_entry[2]));
        (inv.inv_exit_x_i.next, inv.inv_exit_y_i.next, inv.inv_exit_z_i.next) =
            (word(inv_exit[0]), word(inv_exit[1]), word(inv_exit[2]));
        (to.interval.t_min_i.next, to.interval.t_max_i.next) = (word(t_min), word(t_max));
    };
}

/// Drives the ports that describe a box.
macro_rules! drive_box {
    ($bounds:expr, $planes:expr) => {
        let word = |i: usize| u64::from($planes[i]).into();
        let to = &mut $bounds;
        (to.box_min_x_i.next, to.box_min_y_i.next, to.box_min_z_i.next) = (word(0), word(1), word(2));
        (to.box_max_x_i.next, to.box_max_y_i.next, to.box_max_z_i.next) = (word(3), word(4), word(5));
    };
}

/// Enable, valid, tag and clock of a module that has those ports under their usual names.
macro_rules! handshake {
    () => {
        fn handshake(&mut self, enable: bool, valid: bool, tag: u64) {
            self.clocking.en_i.next = enable;
            self.valid_i.next = valid;
            self.tag_i.next = tag.into();
        }
        fn tick(&mut self) {
            Clocked::tick(self);
        }
    };
}

pub(crate) use {drive_box, drive_ray, handshake};

/// One cycle of a pipeline's inputs.
#[derive(Clone, Copy, Debug)]
pub struct Cycle<C> {
    pub enable: bool,
    pub valid: bool,
    pub tag: u64,
    pub case: C,
}

/// Runs the cycles and compares the output after each of them; returns the outcomes that were seen.
pub fn run<P: Pipeline>(cycles: impl IntoIterator<Item = Cycle<P::Case>>) -> Vec<P::Outcome> {
    let mut pipeline = P::default();
    let mut in_flight: VecDeque<Option<(u64, P::Case)>> =
        std::iter::repeat_n(None, latency_cycles(P::TOP)).collect();
    let mut seen = Vec::new();
    for Cycle { enable, valid, tag, case } in cycles {
        pipeline.handshake(enable, valid, tag);
        pipeline.drive(&case);
        pipeline.tick();
        if enable {
            in_flight.pop_front();
            in_flight.push_back(valid.then_some((tag, case)));
        }
        let expected = in_flight[0].map(|(tag, case)| (tag, P::golden(&case)));
        assert_eq!(pipeline.output(), expected, "{:x?}", in_flight[0]);
        if let (true, Some((_, outcome))) = (enable, expected) {
            seen.push(outcome);
        }
    }
    seen
}

/// A seed's cycles: without a gap, or with a bubble or a stall in every fourth cycle each.
pub fn cycles<P: Pipeline>(seed: u64, gaps: bool) -> impl Iterator<Item = Cycle<P::Case>> {
    let mut cases = Cases::new(seed);
    std::iter::repeat_with(move || {
        let bits = cases.bits();
        Cycle {
            enable: !gaps || bits & 3 != 0,
            valid: !gaps || bits & 12 != 0,
            tag: bits >> 8 & ((1 << TAG_BITS) - 1),
            case: P::draw(&mut cases),
        }
    })
}
