//! Gates against the evaluator of `netlist`, cycle by cycle, with bubbles and stalls, every output and register bit.

use equivalence::Stimulus;
use gates::aiger::{self, Form};
use gates::blast::{Options, blast};
use gates::simulate::Simulator;
use gates::words::{Adder, Multiplier, Selection, Structures};
use netlist::{Evaluator, flatten};
use pipelines::catalogue::{StandardFormat, Top};

const LANES: usize = 64;

/// Runs a stream in each lane and its evaluator side by side.
fn compare(top: Top, format: StandardFormat, options: Options, cycles: usize) {
    let design = top.design(format).unwrap();
    let flat = flatten(&design).unwrap();
    let blasted = blast(&design, &flat, options);
    let mut gates = Simulator::<1>::new(&blasted.aig);
    // Checking every lane against an evaluator of its own costs 64 evaluations a cycle: the first lanes do.
    let checked = 4;
    let mut words: Vec<Evaluator> = (0..checked).map(|_| Evaluator::new(&flat)).collect();
    let mut streams: Vec<Stimulus> =
        (0..LANES).map(|lane| Stimulus::new(top, format, &flat, lane as u64)).collect();
    for cycle in 0..cycles {
        let inputs: Vec<Vec<u128>> = streams.iter_mut().map(|stream| stream.next().unwrap()).collect();
        for (port, bits) in blasted.inputs.iter().enumerate() {
            gates.set_word(bits, inputs.iter().map(|lane| lane[port]));
        }
        gates.settle();
        for (lane, evaluator) in words.iter_mut().enumerate() {
            let outputs = evaluator.cycle(&inputs[lane]);
            for (position, bits) in blasted.outputs.iter().enumerate() {
                let found = gates.word(bits, lane);
                let name = &flat.outputs[position].0.name;
                assert_eq!(found, outputs[position], "{top} {format} {options:?} cycle {cycle} {name}");
            }
        }
        gates.clock();
        for (lane, evaluator) in words.iter().enumerate() {
            for register in &flat.registers {
                let found = gates.word(&blasted.words[register.output.index()], lane);
                assert_eq!(found, evaluator.value(register.output), "{top} {cycle} {}", register.name);
            }
        }
    }
}

#[test]
fn every_top_in_binary32() {
    for &top in Top::ALL {
        compare(top, StandardFormat::Binary32, Options::default(), 40);
    }
}

#[test]
fn units_in_every_format() {
    for &format in StandardFormat::ALL {
        for top in [Top::FpAdd, Top::FpMul, Top::FpMinMax, Top::FpCmp] {
            compare(top, format, Options::default(), 100);
        }
    }
}

#[test]
fn every_structure() {
    for adder in [Adder::Ripple, Adder::BrentKung, Adder::Sklansky] {
        for multiplier in [Multiplier::Tree, Multiplier::Booth] {
            let structures = Structures { adder, multiplier, selection: Selection::Chain };
            let options = Options { structures, keep_units: true, cuts: &[] };
            for top in [Top::FpAdd, Top::FpMul, Top::DualSplit] {
                compare(top, StandardFormat::Binary32, options, 60);
            }
        }
    }
}

/// All products of two 11-bit significands, in 64 lanes.
#[test]
fn products_of_eleven_bits_are_complete() {
    use gates::aig::Aig;
    use gates::multiply::product;
    for multiplier in [Multiplier::Tree, Multiplier::Booth] {
        let mut aig = Aig::default();
        let structures = Structures { multiplier, ..Structures::default() };
        let a: Vec<_> = (0..11).map(|i| aig.add_input(format!("a{i}"))).collect();
        let b: Vec<_> = (0..11).map(|i| aig.add_input(format!("b{i}"))).collect();
        let product = product(&mut aig, structures, &a, &b, 22);
        let mut gates = Simulator::<1>::new(&aig);
        for x in 0..1u128 << 11 {
            for y in (0..1u128 << 11).step_by(LANES) {
                gates.set_word(&a, [x; LANES]);
                gates.set_word(&b, (0..LANES as u128).map(|lane| y + lane));
                gates.settle();
                for lane in 0..LANES {
                    assert_eq!(gates.word(&product, lane), x * (y + lane as u128));
                }
            }
        }
    }
}

#[test]
fn aiger_files_read_back() {
    let design = Top::FpAdd.design(StandardFormat::E4m3).unwrap();
    let flat = flatten(&design).unwrap();
    let aig = blast(&design, &flat, Options::default()).aig;
    for form in [Form::Ascii, Form::Binary] {
        let mut file = Vec::new();
        aiger::write(&aig, form, &mut file).unwrap();
        let read = aiger::read(&file).unwrap();
        assert_eq!(read.inputs().len(), aig.inputs().len());
        let names = |aig: &gates::aig::Aig| -> Vec<String> {
            aig.latches().iter().map(|latch| latch.name.clone()).collect()
        };
        assert_eq!(names(&read), names(&aig));
        let mut again = Vec::new();
        aiger::write(&read, form, &mut again).unwrap();
        assert_eq!(file, again);
        let (mut x, mut y) = (Simulator::<1>::new(&aig), Simulator::<1>::new(&read));
        for step in 0..200u64 {
            for input in 0..aig.inputs().len() {
                let value = step.wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(input as u32 * 7 + 3);
                x.set_input(input, [value]);
                y.set_input(input, [value]);
            }
            x.settle();
            y.settle();
            for (a, b) in aig.outputs.iter().zip(&read.outputs) {
                assert_eq!(x.value(a.lit), y.value(b.lit), "{}", a.name);
            }
            x.clock();
            y.clock();
        }
        for length in 0..file.len().min(400) {
            assert!(aiger::read(&file[..length]).is_err(), "the first {length} bytes");
        }
    }
}
