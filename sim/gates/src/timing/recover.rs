//! Smaller cells where there is time, and buffers that keep readers which can wait away from nets that cannot.

use super::buffer::{Reader, insert, readers};
use super::{Timing, analyse, drivers, edges};
use crate::aig::Aig;
use crate::liberty::function::variable;
use crate::liberty::{Arc, Library};
use crate::map::Mapped;

/// Passes over the netlist that make cells smaller.
const PASSES: usize = 6;

/// When each net's edges, rising and falling, are needed, if paths may take `limit_ns` from clock edge to clock edge.
pub(super) fn required(mapped: &Mapped, library: &Library, timing: &Timing, limit_ns: f64) -> Vec<[f64; 2]> {
    let mut required = vec![[f64::INFINITY; 2]; mapped.nets];
    let ends = mapped.registers.iter().map(|register| (register.data, library.flip_flop.setup_ns));
    for (net, setup) in ends.chain(mapped.outputs.iter().map(|&net| (net, 0.0))) {
        required[net as usize].iter_mut().for_each(|time| *time = time.min(limit_ns - setup));
    }
    for gate in mapped.gates.iter().rev() {
        let (end, load) = (required[gate.output as usize], timing.load_ff[gate.output as usize]);
        for (&net, arc) in gate.inputs.iter().zip(&library.cells[gate.cell].arcs) {
            for (from, to) in edges(arc) {
                let delay = arc.delay_ns[to].at(timing.slew_ns[net as usize][from], load).max(0.0);
                let time = &mut required[net as usize][from];
                *time = time.min(end[to] - delay);
            }
        }
    }
    required
}

/// Arrival and transition of an output, edge by edge.
pub(super) type Edge = ([f64; 2], [f64; 2]);

pub(super) fn output<'a>(inputs: impl Iterator<Item = (Edge, &'a Arc)>, load: f64) -> Edge {
    let (mut arrival, mut slew) = ([0.0f64; 2], [0.0f64; 2]);
    for ((arrives, slews), arc) in inputs {
        for (from, to) in edges(arc) {
            let delay = arc.delay_ns[to].at(slews[from], load).max(0.0);
            arrival[to] = arrival[to].max(arrives[from] + delay);
            slew[to] = slew[to].max(arc.transition_ns[to].at(slews[from], load));
        }
    }
    (arrival, slew)
}

/// Replaces cells by smaller ones of equal function while the longest path stays within `limit_ns`, or within what it is if
/// that is longer. Returns the timing of the result.
pub(super) fn recover(mapped: &mut Mapped, library: &Library, limit_ns: f64) -> Timing {
    let families = super::size::families(library);
    let mut timing = analyse(mapped, library);
    let limit_ns = limit_ns.max(timing.critical_path_ns);
    for _ in 0..PASSES {
        let before: Vec<usize> = mapped.gates.iter().map(|gate| gate.cell).collect();
        let required = required(mapped, library, &timing, limit_ns);
        let readers = mapped.readers();
        let mut nets: Vec<Edge> =
            timing.arrival_ns.iter().copied().zip(timing.slew_ns.iter().copied()).collect();
        let mut changed = false;
        for position in 0..mapped.gates.len() {
            let gate = &mapped.gates[position];
            let net = gate.output as usize;
            let load = timing.load_ff[net];
            let at_output = |cell: usize| {
                output(gate.inputs.iter().map(|&net| nets[net as usize]).zip(&library.cells[cell].arcs), load)
            };
            // The output's transition time counts in the delays of its readers.
            let in_time = |edge: &Edge| {
                let here = (0..2).all(|to| edge.0[to] <= required[net][to]);
                here && readers[net].iter().all(|&reader| {
                    let reader = &mapped.gates[reader as usize];
                    let (end, load) =
                        (required[reader.output as usize], timing.load_ff[reader.output as usize]);
                    let pins = reader.inputs.iter().zip(&library.cells[reader.cell].arcs);
                    pins.filter(|(input, _)| **input as usize == net).all(|(_, arc)| {
                        let (arrival, _) = output(std::iter::once((*edge, arc)), load);
                        edges(arc).all(|(_, to)| arrival[to] <= end[to])
                    })
                })
            };
            let smaller = families[&gate.cell].iter().copied().take_while(|&cell| cell != gate.cell);
            let fits = |cell: &usize| library.cells[*cell].max_load_ff >= load;
            let found = smaller.filter(fits).find(|&cell| in_time(&at_output(cell)));
            let cell = found.unwrap_or(gate.cell);
            changed |= found.is_some();
            nets[net] = at_output(cell);
            mapped.gates[position].cell = cell;
        }
        if !changed {
            break;
        }
        let after = analyse(mapped, library);
        // Transition times reach further than to the next gate, so that a path may come out longer after all.
        if after.critical_path_ns > limit_ns {
            mapped.gates.iter_mut().zip(before).for_each(|(gate, cell)| gate.cell = cell);
            break;
        }
        timing = after;
    }
    analyse(mapped, library)
}

/// Puts a buffer before those readers of a late net that need it later than a buffer takes, where that relieves the net's
/// driver. A net is late if its slack is less than `margin_ns` above the least. Returns whether there was any such.
pub(super) fn isolate(mapped: &mut Mapped, aig: &Aig, library: &Library, margin_ns: f64) -> bool {
    let timing = analyse(mapped, library);
    let required = required(mapped, library, &timing, timing.critical_path_ns);
    let buffer = library.smallest(1, variable(0)).expect("every library read has a buffer");
    let cell = &library.cells[buffer];
    let driver = drivers(mapped);
    let all = readers(mapped);
    let slack = |net: usize| {
        (0..2).map(|edge| required[net][edge] - timing.arrival_ns[net][edge]).fold(f64::INFINITY, f64::min)
    };
    let mut groups = Vec::new();
    for (net, readers) in all.iter().enumerate() {
        if readers.len() < 2 || slack(net) > margin_ns {
            continue;
        }
        let needs = |reader: &Reader| match *reader {
            Reader::Gate(position, pin) => {
                let gate = &mapped.gates[position];
                let arc = &library.cells[gate.cell].arcs[pin];
                let (end, load) = (required[gate.output as usize], timing.load_ff[gate.output as usize]);
                let times = edges(arc).map(|(from, to)| {
                    let delay = arc.delay_ns[to].at(timing.slew_ns[net][from], load);
                    end[to] - delay - timing.arrival_ns[net][from]
                });
                (times.fold(f64::INFINITY, f64::min), library.cells[gate.cell].capacitance_ff[pin])
            }
            Reader::Data(_) => {
                let end = timing.critical_path_ns - library.flip_flop.setup_ns;
                (end - timing.latest(net as u32), library.flip_flop.data_ff)
            }
        };
        let load: f64 = readers.iter().map(|reader| needs(reader).1).sum();
        let delay = 1.5
            * cell.arcs[0].delay_ns.iter().map(|t| t.at(timing.slew_ns[net][0], load)).fold(0.0, f64::max);
        let waits: Vec<Reader> =
            readers.iter().copied().filter(|reader| needs(reader).0 > margin_ns + delay).collect();
        let moved: f64 = waits.iter().map(|reader| needs(reader).1).sum();
        let own = driver[net].map_or(library.flip_flop.clock_ff, |gate| {
            library.cells[mapped.gates[gate as usize].cell].capacitance_ff[0]
        });
        if waits.len() < readers.len()
            && moved - cell.capacitance_ff[0] > 0.5 * own.max(cell.capacitance_ff[0])
        {
            groups.push((net, waits));
        }
    }
    let any = !groups.is_empty();
    insert(mapped, aig, buffer, groups);
    any
}
