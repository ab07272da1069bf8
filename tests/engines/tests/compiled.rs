//! The compiled simulation against the evaluator: random designs, the catalogue, faulty units.

use engines::{compiled_faults, compiled_random, faults, random};
use equivalence::Stimulus;
use lanes::{Compiled, InstructionSet, Program, ProgramPort};
use logic::agreement::{any_inputs, first_difference};
use netlist::Engine;
use netlist::{Flat, Port, flatten, latency_cycles};
use pipelines::catalogue::{StandardFormat, Top};

fn sets() -> impl Iterator<Item = InstructionSet> {
    InstructionSet::ALL.into_iter().filter(|set| set.is_available())
}

fn assert_ports(netlist: &Flat, program: &Program) {
    let names = |ports: &[ProgramPort]| ports.iter().map(|port| port.name).collect::<Vec<_>>();
    let expected = |ports: &mut dyn Iterator<Item = &Port>| ports.map(|p| p.name.clone()).collect::<Vec<_>>();
    assert_eq!(names(program.inputs), expected(&mut netlist.inputs.iter()));
    assert_eq!(names(program.outputs), expected(&mut netlist.outputs.iter().map(|(port, _)| port)));
}

#[test]
fn random_programs_agree_with_the_evaluator() {
    for (seed, program) in &compiled_random::PROGRAMS {
        let netlist = flatten(&random::design(*seed, 64)).unwrap();
        assert_ports(&netlist, program);
        for set in sets() {
            let mut compiled = Compiled::with_instructions(program, set).unwrap();
            let inputs = |cycle, lane| any_inputs(&netlist, *seed, cycle, lane);
            let difference = first_difference(&netlist, &mut compiled, 100, inputs);
            assert_eq!(difference, None, "seed {seed}, {set}");
        }
    }
}

#[test]
fn the_catalogue_agrees_with_the_evaluator() {
    for &(key, ref program) in compiled::programs() {
        let (top, format): (Top, StandardFormat) = key;
        let netlist = flatten(&top.design(format).unwrap()).unwrap();
        assert_ports(&netlist, program);
        let cycles = if netlist.nodes.len() > 6000 { 16 } else { 60 };
        for set in sets() {
            let mut compiled = Compiled::with_instructions(program, set).unwrap();
            let mut streams: Vec<_> =
                (0..compiled.lanes() as u64).map(|lane| Stimulus::new(top, format, &netlist, lane)).collect();
            let inputs = |_, lane: usize| streams[lane].next().unwrap();
            let difference = first_difference(&netlist, &mut compiled, cycles, inputs);
            assert_eq!(difference, None, "{top} {format}, {set}");
        }
    }
}

/// Flushing a pipeline shows at once the outputs that it shows after its latency with inputs held.
#[test]
fn flushing_equals_waiting() {
    for top in [Top::DualSplit, Top::DualSplitLean, Top::RayBox, Top::RayBoxLean] {
        let netlist = flatten(&top.design(StandardFormat::Binary32).unwrap()).unwrap();
        let program = compiled::program(top, StandardFormat::Binary32).unwrap();
        let (mut flushed, mut clocked) = (Compiled::new(program), Compiled::new(program));
        assert!(flushed.has_flush());
        let latency = latency_cycles(&netlist).unwrap();
        let enable = program.input("en_i").unwrap();
        let mut stream = Stimulus::new(top, StandardFormat::Binary32, &netlist, 5);
        for _ in 0..200 {
            for lane in 0..flushed.lanes() {
                let mut inputs = stream.next().unwrap();
                inputs[enable] = 1;
                for (input, value) in inputs.into_iter().enumerate() {
                    flushed.set_input(input, lane, value);
                    clocked.set_input(input, lane, value);
                }
                flushed.flush(lane);
            }
            for _ in 0..latency {
                clocked.clock();
            }
            clocked.settle();
            for output in 0..program.outputs.len() {
                for lane in 0..flushed.lanes() {
                    let (found, expected) = (flushed.output(output, lane), clocked.output(output, lane));
                    assert_eq!(found, expected, "{top}: {}", program.outputs[output].name);
                }
            }
        }
    }
}

#[test]
fn reset_returns_to_power_up_and_keeps_inputs() {
    for (seed, program) in &compiled_random::PROGRAMS {
        let netlist = flatten(&random::design(*seed, 64)).unwrap();
        let mut compiled = Compiled::new(program);
        let show = |compiled: &mut Compiled| {
            compiled.settle();
            (0..program.outputs.len()).map(|output| compiled.output(output, 3)).collect::<Vec<_>>()
        };
        for (input, value) in any_inputs(&netlist, 1, 0, 0).into_iter().enumerate() {
            compiled.set_input(input, 3, value);
        }
        let before = show(&mut compiled);
        (0..5).for_each(|_| compiled.clock());
        compiled.reset();
        assert_eq!(show(&mut compiled), before, "seed {seed}");
    }
}

/// The random programs use every operation on lanes that the build script can write.
#[test]
fn random_programs_use_every_operation() {
    let text = compiled_random::TEXT;
    let bits = ["and", "or", "xor", "not", "select"].map(|name| format!("{name}_b("));
    let numbers = [
        "and",
        "or",
        "xor",
        "add",
        "sub",
        "mul",
        "shl",
        "shr",
        "eq",
        "ne",
        "lt",
        "le",
        "signed_lt",
        "signed_le",
        "select",
        "test",
        "or_bit",
        "parity",
    ];
    let numbers = numbers.iter().flat_map(|name| [format!("{name}_w("), format!("{name}_d(")]);
    let shifts =
        ["shl", "shr", "sar"].iter().flat_map(|n| [format!("{n}_const_w::<"), format!("{n}_const_d::<")]);
    let others = ["widen(", "narrow(", "saturate(", "mul_wide("].map(str::to_owned);
    for operation in bits.into_iter().chain(numbers).chain(shifts).chain(others) {
        assert!(text.contains(&operation), "no random design uses {operation}..)");
    }
}

/// The simulation of a faulty unit shows the fault.
#[test]
fn faulty_units_agree_with_the_evaluator_and_with_nothing_else() {
    for ((position, program), fault) in compiled_faults::PROGRAMS.iter().zip(faults::faults()) {
        let top = fault.0;
        let sound = flatten(&top.design(StandardFormat::Binary32).unwrap()).unwrap();
        let faulty = flatten(&faults::design(fault)).unwrap();
        for set in sets() {
            let mut compiled = Compiled::with_instructions(program, set).unwrap();
            for (netlist, agrees) in [(&faulty, true), (&sound, false)] {
                let mut streams: Vec<_> = (0..compiled.lanes() as u64)
                    .map(|lane| Stimulus::new(top, StandardFormat::Binary32, netlist, lane))
                    .collect();
                let inputs = |_, lane: usize| streams[lane].next().unwrap();
                let difference = first_difference(netlist, &mut compiled, 400, inputs);
                assert_eq!(difference.is_none(), agrees, "fault {position}, {set}: {difference:?}");
            }
        }
    }
}
