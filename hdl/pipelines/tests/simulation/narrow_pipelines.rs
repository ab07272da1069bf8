//! The dual-split pipeline in narrower formats against golden's integer arithmetic: exhaustive operands are
//! out of reach, but one source serves all formats, and these tests instantiate it where every width is different.

use crate::support::harness::{TAG_BITS, drive_ray, latency_cycles};
use crate::support::steps::{NodeCase, Outcome, RayWords, Slot};
use fp::operands::Operands;
use fp::{Arithmetic, Format, NanMode, Rounding};
use golden::dst::header::{AXIS, CARVE, LEAF, OFFSET, SINGLE, SIZE, dual_axes};
use pipelines::catalogue::Top;
use pipelines::dual_split;
use std::collections::VecDeque;
use units::clocking::Clocked;

/// `golden::dst::step` with every operation in `arithmetic`.
fn step(arithmetic: &Arithmetic, NodeCase { words, ray }: &NodeCase) -> Outcome {
    let minimum = |a, b| arithmetic.fp_min_max(a, b, false, NanMode::Number);
    let maximum = |a, b| arithmetic.fp_min_max(a, b, true, NanMode::Number);
    let le = |a, b| arithmetic.fp_cmp(a, b).le;
    let [header, planes @ ..] = *words;
    let negative = |axis: usize| arithmetic.format.is_negative(ray.inv_entry[axis]);
    let distance = |i: usize, axis: usize, inv: &[u32; 3]| {
        let difference = arithmetic.fp_add(planes[i], ray.origin[axis], true, Rounding::NearestEven);
        arithmetic.fp_mul(difference, inv[axis], Rounding::NearestEven)
    };
    let axis_index = |code: u32| code.min(2) as usize;
    let (offset, size, leaf) = (OFFSET.get(header), SIZE.get(header), LEAF.get(header) == 1);
    let (t_min, t_max) = (ray.t_min, ray.t_max);
    let one = |code, slot: Slot| (code, Some(slot), None);
    if CARVE.get(header) == 1 {
        let (axes, min_side) = match AXIS.get(header) {
            SINGLE => ([size; 2], [false, true]),
            kind => (dual_axes(kind), [size & 2 != 0, size & 1 != 0]),
        };
        let (mut lower, mut upper) = (t_min, t_max);
        for i in 0..2 {
            let axis = axis_index(axes[i]);
            if negative(axis) == min_side[i] {
                upper = minimum(upper, distance(i, axis, &ray.inv_exit));
            } else {
                lower = maximum(lower, distance(i, axis, &ray.inv_entry));
            }
        }
        match (le(lower, upper), leaf) {
            (false, _) => (0, None, None),
            (true, leaf) => one(if leaf { 3 } else { 1 }, (offset, lower, upper)),
        }
    } else if leaf {
        one(3, (offset, t_min, t_max))
    } else {
        let axis = axis_index(AXIS.get(header));
        let (first, second) = (offset, offset + size);
        let (near, far, near_offset, far_offset) =
            if negative(axis) { (1, 0, second, first) } else { (0, 1, first, second) };
        let upper = minimum(t_max, distance(near, axis, &ray.inv_exit));
        let lower = maximum(t_min, distance(far, axis, &ray.inv_entry));
        let (near_slot, far_slot) = ((near_offset, t_min, upper), (far_offset, lower, t_max));
        match (le(t_min, upper), le(lower, t_max)) {
            (true, true) => (2, Some(near_slot), Some(far_slot)),
            (true, false) => one(1, near_slot),
            (false, true) => one(1, far_slot),
            (false, false) => (0, None, None),
        }
    }
}

fn draw(stream: &mut Operands) -> NodeCase {
    let header = stream.bits() as u32;
    let mut operand = || stream.operand();
    let mut axes = || [operand(), operand(), operand()];
    let (origin, inv_entry, inv_exit, [plane_0, plane_1, t]) = (axes(), axes(), axes(), axes());
    // Most intervals start at zero, so that a good part of all nodes is hit.
    let bits = stream.bits();
    let t_min = if bits & 3 == 0 { stream.operand() } else { 0 };
    NodeCase {
        words: [header, plane_0, plane_1],
        ray: RayWords { origin, inv_entry, inv_exit, t_min, t_max: t },
    }
}

macro_rules! narrow {
    ($test:ident, $exponent_bits:literal, $significand_bits:literal) => {
        #[test]
        fn $test() {
            let arithmetic = Arithmetic::new(Format::new($exponent_bits, $significand_bits).unwrap());
            let mut stream = Operands::new(arithmetic.format, 31);
            let mut pipeline = <dual_split!($exponent_bits, $significand_bits, 2, TAG_BITS)>::default();
            pipeline.clocking.en_i.next = true;
            pipeline.valid_i.next = true;
            let latency = latency_cycles(Top::DualSplit);
            let mut in_flight = VecDeque::new();
            let mut codes = [0; 4];
            for _ in 0..4_000 {
                let case = draw(&mut stream);
                pipeline.node.header_i.next = u64::from(case.words[0]).into();
                pipeline.node.plane_0_i.next = u64::from(case.words[1]).into();
                pipeline.node.plane_1_i.next = u64::from(case.words[2]).into();
                drive_ray!(pipeline, case.ray);
                pipeline.tick();
                in_flight.push_back(case);
                if in_flight.len() < latency {
                    continue;
                }
                let case = in_flight.pop_front().expect("a node is in flight");
                let (code, near, far) = step(&arithmetic, &case);
                assert_eq!(pipeline.step.code_o.val().to_u8(), code, "{case:x?}");
                let near_out = (
                    pipeline.step.near_offset_o.val().to_u32(),
                    pipeline.step.near_t_min_o.val().to_u32(),
                    pipeline.step.near_t_max_o.val().to_u32(),
                );
                let far_out = (
                    pipeline.step.far_offset_o.val().to_u32(),
                    pipeline.step.far_t_min_o.val().to_u32(),
                    pipeline.step.far_t_max_o.val().to_u32(),
                );
                assert!(near.is_none_or(|slot| slot == near_out), "{case:x?}: {near:x?} {near_out:x?}");
                assert!(far.is_none_or(|slot| slot == far_out), "{case:x?}: {far:x?} {far_out:x?}");
                codes[usize::from(code)] += 1;
            }
            assert!(codes.iter().all(|&count| count > 50), "{codes:?}");
        }
    };
}

narrow!(binary16_equals_golden, 5, 11);
narrow!(bfloat16_equals_golden, 8, 8);
narrow!(e5m2_equals_golden, 5, 3);
narrow!(e4m3_equals_golden, 4, 4);
