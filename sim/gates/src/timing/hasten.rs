//! Sizing for a clock: cells of other sizes where paths are too long, as many at a time as help.

use super::recover::{Edge, output, required};
use super::size::{families, fit_loads, slope};
use super::{Timing, analyse, buffer, drivers, isolate, recover};
use crate::aig::Aig;
use crate::liberty::Library;
use crate::map::Mapped;

/// Most rounds of analysis and resizing.
const ROUNDS: usize = 400;
/// Rounds in which the longest path has to become shorter by the fraction `PROGRESS`.
const LAP: usize = 30;
const PROGRESS: f64 = 0.003;
/// Paths within this fraction of the longest are shortened together.
const NEAR_CRITICAL: f64 = 0.04;
/// Single changes that may fail one after another before the end.
const PATIENCE: usize = 12;
/// How much a longer transition time adds to the delay of what reads it: the usual slope of delay tables.
const SLEW_TO_DELAY: f64 = 0.2;
/// Rounds of buffering, sizing and making small again.
const CLOSING_ROUNDS: usize = 5;

/// Buffers and sizes a mapped netlist for a clock period: shortens the longest path until it is within `target_ns` or gets no
/// shorter, and then makes cells smaller where there is time. Returns the timing of the result.
pub fn close(mapped: &mut Mapped, aig: &Aig, library: &Library, target_ns: f64) -> Timing {
    buffer(mapped, aig, library);
    let mut timing = hasten(mapped, library, target_ns);
    for _ in 0..CLOSING_ROUNDS {
        if timing.critical_path_ns <= target_ns {
            break;
        }
        let before = timing.critical_path_ns;
        // Smaller cells beside the longest path are smaller loads on it.
        recover(mapped, library, target_ns);
        timing = hasten(mapped, library, target_ns);
        let mut next = mapped.clone();
        if isolate(&mut next, aig, library, NEAR_CRITICAL * timing.critical_path_ns) {
            let after = hasten(&mut next, library, target_ns);
            if after.critical_path_ns < timing.critical_path_ns {
                (*mapped, timing) = (next, after);
            }
        }
        if timing.critical_path_ns > 0.998 * before {
            break;
        }
    }
    recover(mapped, library, target_ns)
}

/// Replaces cells by others of equal function until the longest path is within `target_ns`, or gets no shorter.
fn hasten(mapped: &mut Mapped, library: &Library, target_ns: f64) -> Timing {
    let families = families(library);
    let mut timing = fit_loads(mapped, library, &families);
    let mut best: Option<(f64, Vec<usize>)> = None;
    // The share of the changes found that the next round makes, and gates whose change did not help.
    let (mut share, mut failures) = (1.0f64, 0);
    let mut useless = vec![false; mapped.gates.len()];
    let mut lap_ns = f64::INFINITY;
    for round in 0..ROUNDS {
        if round % LAP == 0 {
            if timing.critical_path_ns > (1.0 - PROGRESS) * lap_ns {
                break;
            }
            lap_ns = timing.critical_path_ns;
        }
        if best.as_ref().is_none_or(|(ns, _)| timing.critical_path_ns < *ns) {
            best = Some((timing.critical_path_ns, mapped.gates.iter().map(|gate| gate.cell).collect()));
        }
        if timing.critical_path_ns <= target_ns || failures > PATIENCE {
            break;
        }
        let threshold_ns = target_ns.max((1.0 - NEAR_CRITICAL) * timing.critical_path_ns);
        let mut moves = moves(mapped, library, &timing, &families, threshold_ns);
        moves.retain(|found| !useless[found.gate]);
        if moves.is_empty() {
            break;
        }
        moves.sort_by(|a, b| b.gain_ns.total_cmp(&a.gain_ns).then(a.gate.cmp(&b.gate)));
        moves.truncate(((share * moves.len() as f64) as usize).max(1));
        let before: Vec<(usize, usize)> =
            moves.iter().map(|found| (found.gate, mapped.gates[found.gate].cell)).collect();
        moves.iter().for_each(|found| mapped.gates[found.gate].cell = found.cell);
        let after = analyse(mapped, library);
        if excess(mapped, library, &after, threshold_ns) < excess(mapped, library, &timing, threshold_ns) {
            (timing, failures) = (after, 0);
            share = (1.5 * share).min(1.0);
            continue;
        }
        before.iter().for_each(|&(gate, cell)| mapped.gates[gate].cell = cell);
        share /= 3.0;
        if let [(gate, _)] = before[..] {
            useless[gate] = true;
            failures += 1;
        }
    }
    if let Some((_, cells)) = best {
        mapped.gates.iter_mut().zip(cells).for_each(|(gate, cell)| gate.cell = cell);
    }
    analyse(mapped, library)
}

/// By how much the paths to all registers and outputs exceed a time, in sum.
fn excess(mapped: &Mapped, library: &Library, timing: &Timing, limit_ns: f64) -> f64 {
    let data = mapped.registers.iter().map(|register| (register.data, library.flip_flop.setup_ns));
    let ends = data.chain(mapped.outputs.iter().map(|&net| (net, 0.0)));
    ends.map(|(net, setup)| (timing.latest(net) + setup - limit_ns).max(0.0)).sum()
}

/// A cell in another's place, and the time that this gains at its output.
struct Move {
    gate: usize,
    cell: usize,
    gain_ns: f64,
}

/// The best change of each gate that is later than its readers need it for `limit_ns`.
fn moves(
    mapped: &Mapped,
    library: &Library,
    timing: &Timing,
    families: &std::collections::BTreeMap<usize, Vec<usize>>,
    limit_ns: f64,
) -> Vec<Move> {
    let required = required(mapped, library, timing, limit_ns);
    let driver = drivers(mapped);
    // Delay that a femtofarad more adds to what drives a net.
    let per_ff = |net: u32| {
        let load = timing.load_ff[net as usize];
        let (arc, slew) = match driver[net as usize] {
            Some(gate) => {
                let gate = &mapped.gates[gate as usize];
                (&library.cells[gate.cell].arcs[0], timing.slew_ns[gate.inputs[0] as usize][0])
            }
            None => (&library.flip_flop.arc, 0.0),
        };
        slope(|load| arc.delay_ns[0].at(slew, load), load)
    };
    let mut moves = Vec::new();
    for (position, gate) in mapped.gates.iter().enumerate() {
        let net = gate.output as usize;
        let late = |edge: &Edge| {
            (0..2)
                .map(|to| edge.0[to] + SLEW_TO_DELAY * edge.1[to] - required[net][to])
                .fold(f64::MIN, f64::max)
        };
        let is_late = (0..2).any(|to| timing.arrival_ns[net][to] > required[net][to]);
        if !is_late || families[&gate.cell].len() < 2 {
            continue;
        }
        let own = &library.cells[gate.cell];
        let slopes: Vec<f64> = gate.inputs.iter().map(|&net| per_ff(net)).collect();
        let at_output = |cell: usize| {
            let new = &library.cells[cell];
            let inputs = gate.inputs.iter().enumerate().map(|(pin, &net)| {
                let added = slopes[pin] * (new.capacitance_ff[pin] - own.capacitance_ff[pin]);
                let arrival = timing.arrival_ns[net as usize].map(|time| time + added);
                ((arrival, timing.slew_ns[net as usize]), &new.arcs[pin])
            });
            output(inputs, timing.load_ff[net])
        };
        let present = late(&at_output(gate.cell));
        let others = families[&gate.cell].iter().copied().filter(|&cell| cell != gate.cell);
        let fits = |cell: &usize| library.cells[*cell].max_load_ff >= timing.load_ff[net];
        let gains = others.filter(fits).map(|cell| (present - late(&at_output(cell)), cell));
        if let Some((gain_ns, cell)) = gains.max_by(|a, b| a.0.total_cmp(&b.0))
            && gain_ns > 1e-5
        {
            moves.push(Move { gate: position, cell, gain_ns });
        }
    }
    moves
}
