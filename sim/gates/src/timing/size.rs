//! Larger cells where the longest paths are.

use std::collections::BTreeMap;

use super::{Timing, analyse, edges};
use crate::liberty::Library;
use crate::map::Mapped;

/// Rounds of analysis and resizing.
const ROUNDS: usize = 60;
/// Paths within this fraction of the longest are shortened together.
const NEAR_CRITICAL: f64 = 0.04;
/// Rounds without progress before the end.
const PATIENCE: usize = 6;

/// Replaces cells by larger ones of equal function until no replacement shortens the longest path, or until the path
/// meets `target_ns`. Cells whose load exceeds what the library allows come first. Returns the timing of the result.
pub fn size(mapped: &mut Mapped, library: &Library, target_ns: f64) -> Timing {
    let families = families(library);
    let mut timing = fit_loads(mapped, library, &families);
    let mut best: Vec<usize> = mapped.gates.iter().map(|gate| gate.cell).collect();
    let mut best_ns = timing.critical_path_ns;
    let mut waited = 0;
    for _ in 0..ROUNDS {
        if best_ns <= target_ns || waited > PATIENCE {
            break;
        }
        if !upsize(mapped, library, &timing, &families) {
            break;
        }
        timing = analyse(mapped, library);
        if timing.critical_path_ns < best_ns {
            best_ns = timing.critical_path_ns;
            best = mapped.gates.iter().map(|gate| gate.cell).collect();
            waited = 0;
        } else {
            waited += 1;
        }
    }
    for (gate, cell) in mapped.gates.iter_mut().zip(best) {
        gate.cell = cell;
    }
    analyse(mapped, library)
}

/// Replaces cells whose load exceeds what the library allows by larger ones. Returns the timing of the result.
pub(super) fn fit_loads(
    mapped: &mut Mapped,
    library: &Library,
    families: &BTreeMap<usize, Vec<usize>>,
) -> Timing {
    let mut timing = analyse(mapped, library);
    // A larger cell loads its drivers more, so that one round may make the next necessary.
    for _ in 0..8 {
        let mut changed = false;
        for gate in &mut mapped.gates {
            let load = timing.load_ff[gate.output as usize];
            if load > library.cells[gate.cell].max_load_ff {
                let family = &families[&gate.cell];
                let fits = family.iter().copied().find(|&cell| library.cells[cell].max_load_ff >= load);
                let cell = fits.or(family.last().copied()).unwrap_or(gate.cell);
                changed |= cell != gate.cell;
                gate.cell = cell;
            }
        }
        if !changed {
            break;
        }
        timing = analyse(mapped, library);
    }
    timing
}

/// For each cell, those of equal function, the smallest first.
pub(super) fn families(library: &Library) -> BTreeMap<usize, Vec<usize>> {
    let mut by_function: BTreeMap<(usize, u64), Vec<usize>> = BTreeMap::new();
    for (position, cell) in library.cells.iter().enumerate() {
        by_function.entry((cell.inputs.len(), cell.function)).or_default().push(position);
    }
    let mut families = BTreeMap::new();
    for mut family in by_function.into_values() {
        family.sort_by(|&a, &b| library.cells[a].area_um2.total_cmp(&library.cells[b].area_um2));
        for &cell in &family {
            families.insert(cell, family.clone());
        }
    }
    families
}

/// Replaces every gate near the longest path that a larger cell makes faster. Returns whether there was any.
fn upsize(
    mapped: &mut Mapped,
    library: &Library,
    timing: &Timing,
    families: &BTreeMap<usize, Vec<usize>>,
) -> bool {
    let required = required(mapped, library, timing);
    let margin = NEAR_CRITICAL * timing.critical_path_ns;
    let mut driver: Vec<Option<u32>> = vec![None; mapped.nets];
    for (position, gate) in mapped.gates.iter().enumerate() {
        driver[gate.output as usize] = Some(position as u32);
    }
    let mut changes: Vec<(usize, usize)> = Vec::new();
    for (position, gate) in mapped.gates.iter().enumerate() {
        if required[gate.output as usize] - timing.latest(gate.output) > margin {
            continue;
        }
        // The input that the path comes through.
        let arrives = |pin: usize| timing.latest(gate.inputs[pin]) + timing.delay_ns[position][pin];
        let pin = (0..gate.inputs.len()).max_by(|&a, &b| arrives(a).total_cmp(&arrives(b))).unwrap_or(0);
        let load = timing.load_ff[gate.output as usize];
        let own = delay(library, gate.cell, pin, timing, gate.inputs[pin], load);
        let before = |cell: usize| {
            // What the driver gains or loses by the input's capacitance.
            let extra =
                library.cells[cell].capacitance_ff[pin] - library.cells[gate.cell].capacitance_ff[pin];
            let Some(driver) = driver[gate.inputs[pin] as usize] else {
                let arc = &library.flip_flop.arc;
                return extra
                    * slope(|load| arc.delay_ns[0].at(0.0, load), timing.load_ff[gate.inputs[pin] as usize]);
            };
            let driving = &library.cells[mapped.gates[driver as usize].cell];
            let net = gate.inputs[pin];
            extra
                * slope(
                    |load| driving.arcs[0].delay_ns[0].at(timing.slew_ns[net as usize][0], load),
                    timing.load_ff[net as usize],
                )
        };
        let candidates = families[&gate.cell].iter().copied().filter(|&cell| cell != gate.cell);
        let gain =
            |cell: usize| own - delay(library, cell, pin, timing, gate.inputs[pin], load) - before(cell);
        let best = candidates.map(|cell| (gain(cell), cell)).max_by(|a, b| a.0.total_cmp(&b.0));
        if let Some((gain, cell)) = best.filter(|(gain, _)| *gain > 1e-4 * own) {
            let _ = gain;
            changes.push((position, cell));
        }
    }
    let any = !changes.is_empty();
    for (position, cell) in changes {
        mapped.gates[position].cell = cell;
    }
    any
}

pub(super) fn slope(delay: impl Fn(f64) -> f64, load: f64) -> f64 {
    (delay(load + 1.0) - delay(load)).max(0.0)
}

fn delay(library: &Library, cell: usize, pin: usize, timing: &Timing, net: u32, load: f64) -> f64 {
    let arc = &library.cells[cell].arcs[pin];
    let slew = timing.slew_ns[net as usize];
    edges(arc).map(|(from, to)| arc.delay_ns[to].at(slew[from], load)).fold(0.0, f64::max)
}

/// When each net has to be there at the latest.
fn required(mapped: &Mapped, library: &Library, timing: &Timing) -> Vec<f64> {
    let mut required = vec![f64::INFINITY; mapped.nets];
    let mut limit = |net: u32, time: f64| required[net as usize] = required[net as usize].min(time);
    for register in &mapped.registers {
        limit(register.data, timing.critical_path_ns - library.flip_flop.setup_ns);
    }
    mapped.outputs.iter().for_each(|&net| limit(net, timing.critical_path_ns));
    for (gate, delays) in mapped.gates.iter().zip(&timing.delay_ns).rev() {
        let end = required[gate.output as usize];
        for (&net, delay) in gate.inputs.iter().zip(delays) {
            required[net as usize] = required[net as usize].min(end - delay);
        }
    }
    required
}
