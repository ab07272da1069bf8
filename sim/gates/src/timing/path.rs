//! The longest path to a net, gate by gate, and the delay of an inverter that drives four of its kind.

use super::{Timing, edges};
use crate::liberty::{Cell, Library};
use crate::map::Mapped;

/// A gate on a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Position in the netlist's gates.
    pub gate: usize,
    /// Time from the change of the gate's input to that of its output.
    pub delay_ns: f64,
}

/// A path from a register or an input to a net.
#[derive(Clone, Debug, PartialEq)]
pub struct Path {
    /// The net that it starts at.
    pub start: u32,
    /// When that net changes, after the clock edge.
    pub start_ns: f64,
    /// The gates, first to last.
    pub steps: Vec<Step>,
}

/// The path that makes `net` change as late as it does.
#[must_use]
pub fn path(mapped: &Mapped, library: &Library, timing: &Timing, driver: &[Option<u32>], net: u32) -> Path {
    let arrival = |net: u32, edge: usize| timing.arrival_ns[net as usize][edge];
    let mut at = (net, usize::from(arrival(net, 1) > arrival(net, 0)));
    let mut steps = Vec::new();
    while let Some(position) = driver[at.0 as usize] {
        let gate = &mapped.gates[position as usize];
        let load = timing.load_ff[gate.output as usize];
        let mut latest: Option<(f64, f64, u32, usize)> = None;
        for (&input, arc) in gate.inputs.iter().zip(&library.cells[gate.cell].arcs) {
            for (from, _) in edges(arc).filter(|(_, to)| *to == at.1) {
                let delay = arc.delay_ns[at.1].at(timing.slew_ns[input as usize][from], load).max(0.0);
                let time = arrival(input, from) + delay;
                if latest.is_none_or(|(known, ..)| time > known) {
                    latest = Some((time, delay, input, from));
                }
            }
        }
        let Some((_, delay_ns, input, from)) = latest else { break };
        steps.push(Step { gate: position as usize, delay_ns });
        at = (input, from);
    }
    steps.reverse();
    Path { start: at.0, start_ns: arrival(at.0, at.1), steps }
}

/// For each net, the gate that drives it; none for inputs and registers.
#[must_use]
pub fn drivers(mapped: &Mapped) -> Vec<Option<u32>> {
    let mut driver = vec![None; mapped.nets];
    for (position, gate) in mapped.gates.iter().enumerate() {
        driver[gate.output as usize] = Some(position as u32);
    }
    driver
}

/// The delay of an inverter in a chain of such, each of which drives four, and the inverter: the fastest of the library's smallest.
/// Those for clocks may be as small, but are slower.
#[must_use]
pub fn fo4(library: &Library) -> (f64, &Cell) {
    let smallest = &library.cells[library.inverter()];
    let inverters = library.cells.iter().filter(|cell| {
        cell.inputs.len() == 1 && cell.function == smallest.function && cell.area_um2 <= smallest.area_um2
    });
    let all = inverters.map(|inverter| (chain_delay_ns(inverter), inverter));
    all.min_by(|a, b| a.0.total_cmp(&b.0)).expect("the smallest is one")
}

/// [`fo4`] without the inverter.
#[must_use]
pub fn fo4_ns(library: &Library) -> f64 {
    fo4(library).0
}

/// The mean of both edges.
fn chain_delay_ns(inverter: &Cell) -> f64 {
    let (arc, load) = (&inverter.arcs[0], 4.0 * inverter.capacitance_ff[0]);
    // A few places down the chain, the transition times repeat.
    let slews = (0..16).fold([0.0; 2], |[rise, fall], _| {
        [arc.transition_ns[0].at(fall, load), arc.transition_ns[1].at(rise, load)]
    });
    f64::midpoint(arc.delay_ns[0].at(slews[1], load), arc.delay_ns[1].at(slews[0], load))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::aig::Aig;
    use crate::liberty::embedded;
    use crate::map::map;
    use crate::timing::analyse;

    #[test]
    fn an_inverter_with_a_load_of_four() {
        // The embedded inverter: 27.9 ps and 3.15 ps for each fF; four inputs of 2.87 fF.
        let mut library = embedded();
        let expected_ns = (27.9 + 3.15 * 4.0 * 2.87) / 1e3;
        assert!((fo4_ns(&library) - expected_ns).abs() < 1e-12);
        // A slower inverter of the same area, such as libraries have for clocks.
        let mut slower = library.cells[library.inverter()].clone();
        slower.capacitance_ff[0] *= 2.0;
        "slower".clone_into(&mut slower.name);
        library.cells.insert(0, slower);
        assert_eq!(library.inverter(), 0);
        assert!((fo4_ns(&library) - expected_ns).abs() < 1e-12 && fo4(&library).1.name != "slower");
    }

    #[test]
    fn a_path_adds_up_to_the_arrival_at_its_end() {
        let library = embedded();
        let mut aig = Aig::default();
        let inputs: Vec<_> = (0..40).map(|bit| aig.add_input(format!("a{bit}"))).collect();
        let mut parity = aig.add_latch("state", false);
        for bit in inputs {
            parity = aig.xor(parity, bit);
        }
        aig.add_output("y", parity);
        let mapped = map(&aig, &library).unwrap();
        let timing = analyse(&mapped, &library);
        let net = timing.critical_net.unwrap();
        let path = path(&mapped, &library, &timing, &drivers(&mapped), net);
        let sum = path.start_ns + path.steps.iter().map(|step| step.delay_ns).sum::<f64>();
        assert!((sum - timing.critical_path_ns).abs() < 1e-12 && path.steps.len() > 10);
        assert_eq!(mapped.gates[path.steps.last().unwrap().gate].output, net);
    }
}
