//! Static timing of a mapped netlist from a library's delay tables. Buffers and larger cells make the netlist faster.
//!
//! Wires have no capacitance and no delay; the clock arrives everywhere at once, with the transition time of an inverter
//! that drives four of its kind, as do the inputs.

mod buffer;
mod hasten;
mod path;
mod recover;
mod size;

pub use buffer::buffer;
pub use hasten::close;
pub use path::{Path, Step, drivers, fo4, fo4_ns, path};
use recover::{isolate, recover};
pub use size::size;

use super::liberty::{Arc, Library, Sense};
use super::map::Mapped;

/// Times and loads of every net.
#[derive(Clone, Debug)]
pub struct Timing {
    /// When each net has risen, and fallen, at the latest, after the clock edge.
    pub arrival_ns: Vec<[f64; 2]>,
    /// Transition times.
    pub slew_ns: Vec<[f64; 2]>,
    /// Capacitance of the inputs that each net drives.
    pub load_ff: Vec<f64>,
    /// Delay from each input of each gate to its output, the slower edge.
    pub delay_ns: Vec<Vec<f64>>,
    /// The longest path from clock or input to data or output, set-up included.
    pub critical_path_ns: f64,
    /// The net at which it ends.
    pub critical_net: Option<u32>,
}

impl Timing {
    /// The highest clock frequency in megahertz.
    #[must_use]
    pub fn clock_mhz(&self) -> f64 {
        1e3 / self.critical_path_ns
    }

    /// The later edge of a net.
    #[must_use]
    pub fn latest(&self, net: u32) -> f64 {
        self.arrival_ns[net as usize][0].max(self.arrival_ns[net as usize][1])
    }
}

/// The transition time behind an inverter that drives four of its kind.
#[must_use]
pub fn reference_slew_ns(library: &Library) -> f64 {
    let inverter = &library.cells[library.inverter()];
    let load = 4.0 * inverter.capacitance_ff[0];
    // The input of that inverter has the same transition time; a few rounds come close to it.
    (0..8).fold(0.0, |slew, _| inverter.arcs[0].transition_ns[0].at(slew, load))
}

/// The capacitance that each net drives: inputs of gates, data of flip-flops, enables of clock gates.
#[must_use]
pub fn loads(mapped: &Mapped, library: &Library) -> Vec<f64> {
    let mut load = vec![0.0; mapped.nets];
    for gate in &mapped.gates {
        for (net, capacitance) in gate.inputs.iter().zip(&library.cells[gate.cell].capacitance_ff) {
            load[*net as usize] += capacitance;
        }
    }
    for register in &mapped.registers {
        load[register.data as usize] += library.flip_flop.data_ff;
    }
    if let Some(gate) = &library.clock_gate {
        for gating in &mapped.clock_gating {
            load[gating.enable as usize] += gate.enable_ff * gating.gates as f64;
        }
    }
    load
}

/// Arrival times in all nets.
#[must_use]
pub fn analyse(mapped: &Mapped, library: &Library) -> Timing {
    let slew = reference_slew_ns(library);
    let mut timing = Timing {
        arrival_ns: vec![[0.0; 2]; mapped.nets],
        slew_ns: vec![[slew; 2]; mapped.nets],
        load_ff: loads(mapped, library),
        delay_ns: Vec::with_capacity(mapped.gates.len()),
        critical_path_ns: 0.0,
        critical_net: None,
    };
    for register in &mapped.registers {
        let (net, arc) = (register.output as usize, &library.flip_flop.arc);
        for edge in 0..2 {
            timing.arrival_ns[net][edge] = arc.delay_ns[edge].at(slew, timing.load_ff[net]);
            timing.slew_ns[net][edge] = arc.transition_ns[edge].at(slew, timing.load_ff[net]);
        }
    }
    for gate in &mapped.gates {
        let output = gate.output as usize;
        let load = timing.load_ff[output];
        let (mut arrival, mut transition) = ([0.0f64; 2], [0.0f64; 2]);
        let mut delays = Vec::with_capacity(gate.inputs.len());
        for (&net, arc) in gate.inputs.iter().zip(&library.cells[gate.cell].arcs) {
            let mut slowest = 0.0f64;
            for (from, to) in edges(arc) {
                let input_slew = timing.slew_ns[net as usize][from];
                let delay = arc.delay_ns[to].at(input_slew, load).max(0.0);
                arrival[to] = arrival[to].max(timing.arrival_ns[net as usize][from] + delay);
                transition[to] = transition[to].max(arc.transition_ns[to].at(input_slew, load));
                slowest = slowest.max(delay);
            }
            delays.push(slowest);
        }
        (timing.arrival_ns[output], timing.slew_ns[output]) = (arrival, transition);
        timing.delay_ns.push(delays);
    }
    let data = mapped.registers.iter().map(|register| (register.data, library.flip_flop.setup_ns));
    let ends = data.chain(mapped.outputs.iter().map(|&net| (net, 0.0)));
    for (net, setup) in ends {
        let end = timing.latest(net) + setup;
        if end > timing.critical_path_ns {
            (timing.critical_path_ns, timing.critical_net) = (end, Some(net));
        }
    }
    timing
}

/// Pairs of an input's edge and the output's: 0 rises, 1 falls.
pub(super) fn edges(arc: &Arc) -> impl Iterator<Item = (usize, usize)> {
    let sense = arc.sense;
    [(0, 0), (1, 1), (0, 1), (1, 0)].into_iter().filter(move |(from, to)| match sense {
        Sense::Positive => from == to,
        Sense::Negative => from != to,
        Sense::Both => true,
    })
}
