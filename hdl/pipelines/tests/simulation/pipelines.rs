//! Both pipelines in rust-hdl's simulator against golden: back to back, with bubbles and with stalls.

use crate::support::harness::{Cycle, Pipeline, TAG_BITS, cycles, drive_box, drive_ray, handshake, run};
use crate::support::steps::{BoxCase, Cases, NodeCase, Outcome, RayWords};
use fp::Format;
use fp::operands::patterns;
use pipelines::catalogue::Top;
use pipelines::{dual_split, ray_box};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed};
use std::fmt::Debug;
use units::clocking::Clocked;

impl<const C: usize> Pipeline for dual_split!(8, 24, C, TAG_BITS) {
    const TOP: Top = Top::DualSplit;
    type Case = NodeCase;
    type Outcome = Outcome;
    fn draw(cases: &mut Cases) -> NodeCase {
        cases.node()
    }
    fn golden(case: &NodeCase) -> Outcome {
        case.golden()
    }
    fn drive(&mut self, case: &NodeCase) {
        self.node.header_i.next = u64::from(case.words[0]).into();
        self.node.plane_0_i.next = u64::from(case.words[1]).into();
        self.node.plane_1_i.next = u64::from(case.words[2]).into();
        drive_ray!(self, case.ray);
    }
    handshake!();
    fn output(&self) -> Option<(u64, Outcome)> {
        let code = self.step.code_o.val().to_u8();
        let near = (
            self.step.near_offset_o.val().to_u32(),
            self.step.near_t_min_o.val().to_u32(),
            self.step.near_t_max_o.val().to_u32(),
        );
        let far = (
            self.step.far_offset_o.val().to_u32(),
            self.step.far_t_min_o.val().to_u32(),
            self.step.far_t_max_o.val().to_u32(),
        );
        let outcome = (code, (code != 0).then_some(near), (code == 2).then_some(far));
        self.valid_o.val().then(|| (self.tag_o.val().to_u64(), outcome))
    }
}

impl<const C: usize> Pipeline for ray_box!(8, 24, C, TAG_BITS) {
    const TOP: Top = Top::RayBox;
    type Case = BoxCase;
    type Outcome = (bool, Option<u32>);
    fn draw(cases: &mut Cases) -> BoxCase {
        cases.bounds()
    }
    fn golden(case: &BoxCase) -> (bool, Option<u32>) {
        case.golden()
    }
    fn drive(&mut self, case: &BoxCase) {
        drive_box!(self.bounds, case.planes);
        drive_ray!(self, case.ray);
    }
    handshake!();
    fn output(&self) -> Option<(u64, (bool, Option<u32>))> {
        let hit = self.hit_o.val();
        let entry = hit.then(|| self.t_entry_o.val().to_u32());
        self.valid_o.val().then(|| (self.tag_o.val().to_u64(), (hit, entry)))
    }
}

/// Words that shrink towards zero and towards few set bits.
fn word() -> impl Strategy<Value = u32> {
    let special = patterns(Format::BINARY32);
    prop_oneof![
        any::<u32>(),
        proptest::sample::select(special),
        (-8i32..9).prop_map(|x| (x as f32).to_bits())
    ]
}

fn ray() -> impl Strategy<Value = RayWords> {
    let axes = || [word(), word(), word()];
    (axes(), axes(), axes(), word(), word()).prop_map(|(origin, inv_entry, inv_exit, t_min, t_max)| {
        RayWords { origin, inv_entry, inv_exit, t_min, t_max }
    })
}

fn gaps<C: Debug>(case: impl Strategy<Value = C>) -> impl Strategy<Value = Vec<Cycle<C>>> {
    let cycle = (any::<bool>(), any::<bool>(), 0..1u64 << TAG_BITS, case)
        .prop_map(|(enable, valid, tag, case)| Cycle { enable, valid, tag, case });
    proptest::collection::vec(cycle, 1..40)
}

fn config() -> Config {
    Config { cases: 60, rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..Config::default() }
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn dual_split_equals_golden_on_shrinkable_cycles(
        cycles in gaps((any::<[u32; 1]>(), word(), word(), ray()).prop_map(|([header], plane_0, plane_1, ray)| {
            NodeCase { words: [header, plane_0, plane_1], ray }
        }))
    ) {
        run::<DualSplit>(cycles);
    }

    #[test]
    fn ray_box_equals_golden_on_shrinkable_cycles(
        cycles in gaps((proptest::array::uniform6(word()), ray()).prop_map(|(planes, ray)| BoxCase { planes, ray }))
    ) {
        run::<RayBox>(cycles);
    }
}

pub type DualSplit = dual_split!(8, 24, 2, TAG_BITS);
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
