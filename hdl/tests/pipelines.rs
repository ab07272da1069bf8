//! Both pipelines in rust-hdl's simulator against golden: back to back, with bubbles and with stalls.

mod support;

use hdl::clocking::Clocked;
use hdl::pipelines::{DualSplitPipeline, RayBoxPipeline};
use hdl::{dual_split, ray_box};
use std::collections::VecDeque;
use std::fmt::Debug;
use support::steps::{BoxCase, Cases, NodeCase, Outcome, RayWords};

const LATENCY_CYCLES: usize = 8;
const TAG_BITS: usize = 5;

/// What the pipelines have in common.
trait Pipeline: Clocked + Default {
    type Case: Copy + Debug;
    type Outcome: PartialEq + Debug;
    fn draw(cases: &mut Cases) -> Self::Case;
    fn golden(case: &Self::Case) -> Self::Outcome;
    fn drive(&mut self, case: &Self::Case);
    fn handshake(&mut self, enable: bool, valid: bool, tag: u64);
    /// Tag and outcome, if the output is valid.
    fn output(&self) -> Option<(u64, Self::Outcome)>;
}

macro_rules! drive_ray {
    ($unit:expr, $ray:expr) => {
        let word = |bits: u32| u64::from(bits).into();
        let RayWords { origin, inv_entry, inv_exit, t_min, t_max } = $ray;
        ($unit.origin_x_i.next, $unit.origin_y_i.next, $unit.origin_z_i.next) =
            (word(origin[0]), word(origin[1]), word(origin[2]));
        ($unit.inv_entry_x_i.next, $unit.inv_entry_y_i.next, $unit.inv_entry_z_i.next) =
            (word(inv_entry[0]), word(inv_entry[1]), word(inv_entry[2]));
        ($unit.inv_exit_x_i.next, $unit.inv_exit_y_i.next, $unit.inv_exit_z_i.next) =
            (word(inv_exit[0]), word(inv_exit[1]), word(inv_exit[2]));
        ($unit.t_min_i.next, $unit.t_max_i.next) = (word(t_min), word(t_max));
    };
}

macro_rules! handshake {
    () => {
        fn handshake(&mut self, enable: bool, valid: bool, tag: u64) {
            self.en_i.next = enable;
            self.valid_i.next = valid;
            self.tag_i.next = tag.into();
        }
    };
}

impl<const C: usize> Pipeline for DualSplitPipeline<8, 24, 32, 10, 26, 28, 48, C, TAG_BITS> {
    type Case = NodeCase;
    type Outcome = Outcome;
    fn draw(cases: &mut Cases) -> NodeCase {
        cases.node()
    }
    fn golden(case: &NodeCase) -> Outcome {
        case.golden()
    }
    fn drive(&mut self, case: &NodeCase) {
        self.header_i.next = u64::from(case.words[0]).into();
        self.plane_0_i.next = u64::from(case.words[1]).into();
        self.plane_1_i.next = u64::from(case.words[2]).into();
        drive_ray!(self, case.ray);
    }
    handshake!();
    fn output(&self) -> Option<(u64, Outcome)> {
        let code = self.code_o.val().to_u8();
        let near = (
            self.near_offset_o.val().to_u32(),
            self.near_t_min_o.val().to_u32(),
            self.near_t_max_o.val().to_u32(),
        );
        let far = (
            self.far_offset_o.val().to_u32(),
            self.far_t_min_o.val().to_u32(),
            self.far_t_max_o.val().to_u32(),
        );
        let outcome = (code, (code != 0).then_some(near), (code == 2).then_some(far));
        self.valid_o.val().then(|| (self.tag_o.val().to_u64(), outcome))
    }
}

impl<const C: usize> Pipeline for RayBoxPipeline<8, 24, 32, 10, 26, 28, 48, C, TAG_BITS> {
    type Case = BoxCase;
    type Outcome = (bool, Option<u32>);
    fn draw(cases: &mut Cases) -> BoxCase {
        cases.bounds()
    }
    fn golden(case: &BoxCase) -> (bool, Option<u32>) {
        case.golden()
    }
    fn drive(&mut self, case: &BoxCase) {
        let word = |i: usize| u64::from(case.planes[i]).into();
        (self.box_min_x_i.next, self.box_min_y_i.next, self.box_min_z_i.next) = (word(0), word(1), word(2));
        (self.box_max_x_i.next, self.box_max_y_i.next, self.box_max_z_i.next) = (word(3), word(4), word(5));
        drive_ray!(self, case.ray);
    }
    handshake!();
    fn output(&self) -> Option<(u64, (bool, Option<u32>))> {
        let hit = self.hit_o.val();
        let entry = hit.then(|| self.t_entry_o.val().to_u32());
        self.valid_o.val().then(|| (self.tag_o.val().to_u64(), (hit, entry)))
    }
}

/// One cycle of a pipeline's inputs.
#[derive(Clone, Copy, Debug)]
struct Cycle<C> {
    enable: bool,
    valid: bool,
    tag: u64,
    case: C,
}

/// Runs the cycles and compares the output after each of them; returns the outcomes that were seen.
fn run<P: Pipeline>(cycles: impl IntoIterator<Item = Cycle<P::Case>>) -> Vec<P::Outcome> {
    let mut pipeline = P::default();
    let mut in_flight: VecDeque<Option<(u64, P::Case)>> = std::iter::repeat_n(None, LATENCY_CYCLES).collect();
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
fn cycles<P: Pipeline>(seed: u64, gaps: bool) -> impl Iterator<Item = Cycle<P::Case>> {
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

type DualSplit = dual_split!(8, 24, 2, TAG_BITS);
type DualSplitLean = dual_split!(8, 24, 0, TAG_BITS);
type RayBox = ray_box!(8, 24, 2, TAG_BITS);
type RayBoxLean = ray_box!(8, 24, 1, TAG_BITS);

#[test]
fn dual_split_equals_golden_back_to_back() {
    let seen = run::<DualSplit>(cycles::<DualSplit>(11, false).take(12_000));
    for code in 0..4 {
        let count = seen.iter().filter(|(c, ..)| *c == code).count();
        assert!(count > 300, "only {count} outcomes have code {code}");
    }
}

#[test]
fn dual_split_equals_golden_with_bubbles_and_stalls() {
    run::<DualSplit>(cycles::<DualSplit>(12, true).take(4_000));
}

#[test]
fn lean_dual_split_equals_golden() {
    run::<DualSplitLean>(cycles::<DualSplitLean>(13, true).take(6_000));
}

#[test]
fn ray_box_equals_golden_back_to_back() {
    let seen = run::<RayBox>(cycles::<RayBox>(14, false).take(4_000));
    let hits = seen.iter().filter(|(hit, _)| *hit).count();
    assert!(hits > 300 && seen.len() - hits > 300, "{hits} hits in {}", seen.len());
}

#[test]
fn ray_box_equals_golden_with_bubbles_and_stalls() {
    run::<RayBox>(cycles::<RayBox>(15, true).take(2_000));
}

#[test]
fn lean_ray_box_equals_golden() {
    run::<RayBoxLean>(cycles::<RayBoxLean>(16, true).take(2_000));
}
