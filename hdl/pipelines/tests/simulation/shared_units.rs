//! The shared units in each of their modes, and the parallel ray-box forms, in rust-hdl's simulator.

use crate::support::harness::{Pipeline, TAG_BITS, cycles, drive_box, drive_ray, handshake, run};
use crate::support::steps::{BoxCase, Cases, NodeCase, Outcome};
use fp::operands::Operands;
use fp::{Arithmetic, Format, Rounding};
use pipelines::catalogue::Top;
use pipelines::{ray_box_parallel, shared_units};
use units::clocking::Clocked;

type Shared = shared_units!(8, 24, TAG_BITS);

/// The shared units as a pipeline of the given mode.
struct Mode<const MODE: u64>(Shared);

const RAY_BOX: u64 = 1;
const DUAL_SPLIT: u64 = 2;

impl<const MODE: u64> Default for Mode<MODE> {
    fn default() -> Self {
        let mut units = Shared::default();
        units.mode_i.next = MODE.into();
        Self(units)
    }
}

macro_rules! pass_handshake {
    () => {
        fn tick(&mut self) {
            self.0.tick();
        }
        fn handshake(&mut self, enable: bool, valid: bool, tag: u64) {
            self.0.clocking.en_i.next = enable;
            self.0.valid_i.next = valid;
            self.0.tag_i.next = tag.into();
        }
    };
}

impl Pipeline for Mode<DUAL_SPLIT> {
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
        let word = |i: usize| u64::from(case.words[i]).into();
        (self.0.node.header_i.next, self.0.node.plane_0_i.next, self.0.node.plane_1_i.next) =
            (word(0), word(1), word(2));
        drive_ray!(self.0, case.ray);
    }
    pass_handshake!();
    fn output(&self) -> Option<(u64, Outcome)> {
        let unit = &self.0;
        let code = unit.step.code_o.val().to_u8();
        let slot = |offset: u32, t_min: u32, t_max: u32| (offset, t_min, t_max);
        let near = slot(
            unit.step.near_offset_o.val().to_u32(),
            unit.step.near_t_min_o.val().to_u32(),
            unit.step.near_t_max_o.val().to_u32(),
        );
        let far = slot(
            unit.step.far_offset_o.val().to_u32(),
            unit.step.far_t_min_o.val().to_u32(),
            unit.step.far_t_max_o.val().to_u32(),
        );
        assert!(!unit.box_valid_o.val());
        let outcome = (code, (code != 0).then_some(near), (code == 2).then_some(far));
        unit.node_valid_o.val().then(|| (unit.tag_o.val().to_u64(), outcome))
    }
}

impl Pipeline for Mode<RAY_BOX> {
    const TOP: Top = Top::RayBox;
    type Case = BoxCase;
    type Outcome = (bool, Option<u32>);
    fn draw(cases: &mut Cases) -> BoxCase {
        cases.bounds()
    }
    fn golden(case: &BoxCase) -> Self::Outcome {
        case.golden()
    }
    fn drive(&mut self, case: &BoxCase) {
        drive_box!(self.0.bounds, case.planes);
        drive_ray!(self.0, case.ray);
    }
    pass_handshake!();
    fn output(&self) -> Option<(u64, Self::Outcome)> {
        assert!(!self.0.node_valid_o.val());
        let hit = self.0.hit_o.val();
        let entry = hit.then(|| self.0.t_entry_o.val().to_u32());
        self.0.box_valid_o.val().then(|| (self.0.tag_o.val().to_u64(), (hit, entry)))
    }
}

#[test]
fn routed_pipelines_equal_golden() {
    run::<Mode<DUAL_SPLIT>>(cycles::<Mode<DUAL_SPLIT>>(21, true).take(1_500));
    run::<Mode<RAY_BOX>>(cycles::<Mode<RAY_BOX>>(22, true).take(1_500));
}

/// Threads start an operation on every unit in every cycle; exactly the units that no pipeline has answer.
fn threads_get_free_units(mode: u64, first_free: usize) {
    let golden = Arithmetic::new(Format::BINARY32);
    let mut stream = Operands::new(Format::BINARY32, 23);
    let mut units = Shared::default();
    units.clocking.en_i.next = true;
    units.mode_i.next = mode.into();
    let mut previous: Option<[(u32, u32, bool); 8]> = None;
    for cycle in 0..300u64 {
        let drawn: [(u32, u32, bool); 8] = std::array::from_fn(|_| {
            let (a, b) = stream.pair();
            (a, b, stream.bits() & 1 == 1)
        });
        for (i, &(a, b, subtract)) in drawn.iter().enumerate() {
            let word = |bits: u32| u64::from(bits).into();
            (units.add_valid_i[i].next, units.mul_valid_i[i].next) = (true, true);
            (units.add_a_i[i].next, units.mul_a_i[i].next) = (word(a), word(a));
            (units.add_b_i[i].next, units.mul_b_i[i].next) = (word(b), word(b));
            units.add_subtract_i[i].next = subtract;
            units.add_tag_i[i].next = (cycle & 15).into();
            units.mul_tag_i[i].next = ((cycle + 1) & 15).into();
        }
        units.tick();
        let Some(operations) = previous.replace(drawn) else { continue };
        for (i, (a, b, subtract)) in operations.into_iter().enumerate() {
            let valid = (units.add_valid_o[i].val(), units.mul_valid_o[i].val());
            assert_eq!(valid, (i >= first_free, i >= first_free), "unit {i} in mode {mode}");
            if i >= first_free {
                let (sum, product) = (units.add_result_o[i].val(), units.mul_result_o[i].val());
                assert_eq!(sum.to_u32(), golden.fp_add(a, b, subtract, Rounding::NearestEven));
                assert_eq!(product.to_u32(), golden.fp_mul(a, b, Rounding::NearestEven));
                let tags = (units.add_tag_o[i].val().to_u64(), units.mul_tag_o[i].val().to_u64());
                assert_eq!(tags, ((cycle - 1) & 15, cycle & 15));
            }
        }
    }
}

#[test]
fn threads_keep_the_units_that_no_pipeline_has() {
    threads_get_free_units(0, 0);
    threads_get_free_units(RAY_BOX, 6);
    threads_get_free_units(DUAL_SPLIT, 2);
}

macro_rules! parallel {
    ($lanes:literal, $name:ident) => {
        type $name = ray_box_parallel!(8, 24, $lanes, 2, TAG_BITS);

        impl Pipeline for $name {
            const TOP: Top = Top::RayBox;
            type Case = [BoxCase; $lanes];
            type Outcome = [(bool, Option<u32>); $lanes];
            fn draw(cases: &mut Cases) -> Self::Case {
                let ray = cases.bounds().ray;
                std::array::from_fn(|_| BoxCase { ray, ..cases.bounds() })
            }
            fn golden(case: &Self::Case) -> Self::Outcome {
                case.map(|lane| lane.golden())
            }
            fn drive(&mut self, case: &Self::Case) {
                for (i, BoxCase { planes, .. }) in case.iter().enumerate() {
                    drive_box!(self.bounds[i], planes);
                }
                drive_ray!(self, case[0].ray);
            }
            handshake!();
            fn output(&self) -> Option<(u64, Self::Outcome)> {
                let lane = |i: usize| {
                    let hit = self.hit_o[i].val();
                    (hit, hit.then(|| self.t_entry_o[i].val().to_u32()))
                };
                self.valid_o.val().then(|| (self.tag_o.val().to_u64(), std::array::from_fn(lane)))
            }
        }
    };
}

parallel!(2, TwoLanes);
parallel!(4, FourLanes);
parallel!(8, EightLanes);

#[test]
fn every_lane_equals_golden() {
    run::<TwoLanes>(cycles::<TwoLanes>(24, true).take(600));
    run::<FourLanes>(cycles::<FourLanes>(25, true).take(300));
    run::<EightLanes>(cycles::<EightLanes>(26, true).take(150));
}
