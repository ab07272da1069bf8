//! Energy of a mapped netlist from how often its nets change.

use super::aig::{Aig, Lit};
use super::liberty::{Cell, Library};
use super::map::Mapped;
use super::simulate::{LANES_PER_WORD, Simulator};
use super::timing::Timing;

/// How often nodes change.
#[derive(Clone, Debug)]
pub struct Activity {
    /// Changes of each node.
    pub changes: Vec<u64>,
    /// Cycles in which they were counted.
    pub cycles: u64,
}

/// Runs streams of inputs, one in each lane, and counts changes after the first `skip` cycles, the filling of the
/// pipeline. Each cycle of a stream has the values of all words of `inputs`.
///
/// # Panics
/// When the streams differ in length, or there are more than 64.
#[must_use]
pub fn activity(aig: &Aig, inputs: &[Vec<Lit>], streams: &[Vec<Vec<u128>>], skip: usize) -> Activity {
    assert!(streams.len() <= LANES_PER_WORD, "a stream in each lane");
    let length = streams.first().map_or(0, Vec::len);
    assert!(streams.iter().all(|stream| stream.len() == length), "streams of one length");
    let lanes = if streams.len() == LANES_PER_WORD { !0 } else { (1u64 << streams.len()) - 1 };
    let mut simulator = Simulator::<1>::new(aig);
    let mut before: Vec<u64> = vec![0; aig.nodes().len()];
    let mut changes = vec![0u64; aig.nodes().len()];
    for cycle in 0..length {
        for (port, bits) in inputs.iter().enumerate() {
            simulator.set_word(bits, streams.iter().map(|stream| stream[cycle][port]));
        }
        simulator.settle();
        for ((count, old), new) in changes.iter_mut().zip(&mut before).zip(simulator.values()) {
            if cycle > skip {
                *count += u64::from(((*old ^ new[0]) & lanes).count_ones());
            }
            *old = new[0];
        }
        simulator.clock();
    }
    let cycles = length.saturating_sub(skip + 1) as u64 * streams.len() as u64;
    Activity { changes, cycles }
}

/// Energy of a cycle, by the part that spends it.
#[derive(Clone, Debug, Default)]
pub struct Energy {
    /// Of each gate: its load and its inside.
    pub gates_fj: Vec<f64>,
    /// Of each flip-flop: its output's load and its inside, without the clock's part.
    pub registers_fj: Vec<f64>,
    /// Of the clock: its pins, the flip-flops' insides at edges without change, and clock gates.
    pub clock_fj: f64,
    /// Of the inputs' nets, which a driver outside pays for.
    pub inputs_fj: f64,
}

/// Energy of a cycle from changes of each net, as a mean over cycles.
#[must_use]
pub fn energy(mapped: &Mapped, library: &Library, timing: &Timing, changes: impl Fn(u32) -> f64) -> Energy {
    let swing = 0.5 * library.voltage_v * library.voltage_v;
    let net = |net: u32| changes(net) * swing * timing.load_ff[net as usize];
    let gates_fj = mapped.gates.iter().map(|gate| {
        let cell = &library.cells[gate.cell];
        net(gate.output) + changes(gate.output) * internal(cell, &gate.inputs, timing, gate.output)
    });
    let registers_fj = mapped.registers.iter().map(|register| {
        let arc = &library.flip_flop.arc;
        let load = timing.load_ff[register.output as usize];
        let inside = f64::midpoint(arc.energy_fj[0].at(0.0, load), arc.energy_fj[1].at(0.0, load));
        net(register.output) + changes(register.output) * inside
    });
    let flip_flop = &library.flip_flop;
    // A clock net rises and falls once a cycle: twice half a swing.
    let pin = flip_flop.clock_ff * 2.0 * swing;
    let mut clock_fj = mapped.registers.len() as f64 * (pin + flip_flop.clock_energy_fj);
    if let Some(gate) = &library.clock_gate {
        let gates: usize = mapped.clock_gating.iter().map(|gating| gating.gates).sum();
        clock_fj += gates as f64 * (gate.clock_ff * 2.0 * swing + gate.clock_energy_fj);
    }
    Energy {
        gates_fj: gates_fj.collect(),
        registers_fj: registers_fj.collect(),
        clock_fj,
        inputs_fj: mapped.inputs.iter().map(|&input| net(input)).sum(),
    }
}

/// Energy inside a cell when its output changes: the mean over its inputs and both edges.
fn internal(cell: &Cell, inputs: &[u32], timing: &Timing, output: u32) -> f64 {
    let load = timing.load_ff[output as usize];
    let sum: f64 = cell
        .arcs
        .iter()
        .zip(inputs)
        .map(|(arc, &net)| {
            let slew = timing.slew_ns[net as usize];
            f64::midpoint(arc.energy_fj[0].at(slew[0], load), arc.energy_fj[1].at(slew[1], load))
        })
        .sum();
    sum / cell.arcs.len() as f64
}
