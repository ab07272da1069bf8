//! Flip-flops and clock gates of a liberty file.

use super::attributes::{Context, arc, capacitance, is_input, is_output, leakage, number};
use super::syntax::Group;
use super::{ClockGate, FlipFlop};

/// Transition time at which a flip-flop's clock energy and setup time are read.
const CLOCK_SLEW_NS: f64 = 0.05;

/// A flip-flop with a data input, a rising-edge clock and an output; set and reset, if any, are tied.
pub(super) fn flip_flop(context: &Context, cell: &Group) -> Option<FlipFlop> {
    let state = cell.of_kind("ff").next()?;
    let clock = state.value("clocked_on")?.trim_matches(['(', ')', ' ']);
    let data = state.value("next_state")?.trim_matches(['(', ')', ' ']);
    let pin = |name: &str| cell.of_kind("pin").find(|pin| pin.name() == name).filter(|pin| is_input(pin));
    // Scan multiplexers and enables make the next state an expression, a falling edge the clock.
    let (clock_pin, data_pin) = (pin(clock)?, pin(data)?);
    let stored = state.names.first()?;
    // A cell that has the complement output only would need an inverter behind it.
    let mut outputs = cell.of_kind("pin").filter(|pin| is_output(pin));
    let output = outputs.find(|pin| pin.value("function").map(str::trim) == Some(stored))?;
    let arc = arc(context, output, clock, |timing| timing.value("timing_type") == Some("rising_edge"))?;
    let setup = (data_pin.of_kind("timing"))
        .filter(|timing| timing.value("timing_type") == Some("setup_rising"))
        .flat_map(|timing| {
            ["rise_constraint", "fall_constraint"].map(|kind| context.constraint(timing, kind))
        })
        .flatten()
        .fold(0.0, f64::max);
    Some(FlipFlop {
        name: cell.name().to_owned(),
        area_um2: number(cell.value("area"))?,
        leakage_nw: leakage(context, cell),
        data: data.to_owned(),
        clock: clock.to_owned(),
        output: output.name().to_owned(),
        data_ff: capacitance(context, data_pin),
        clock_ff: capacitance(context, clock_pin),
        arc,
        clock_energy_fj: clock_energy(context, clock_pin),
        setup_ns: setup,
    })
}

/// A latch that is open while the clock is low, and an AND with the clock.
pub(super) fn clock_gate(context: &Context, cell: &Group) -> Option<ClockGate> {
    let kind = cell.value("clock_gating_integrated_cell")?;
    if !kind.starts_with("latch_posedge") {
        return None;
    }
    let marked = |mark: &str| cell.of_kind("pin").find(|pin| pin.value(mark) == Some("true"));
    let clock = marked("clock_gate_clock_pin")?;
    let enable = marked("clock_gate_enable_pin")?;
    let output = cell.of_kind("pin").find(|pin| is_output(pin))?;
    Some(ClockGate {
        name: cell.name().to_owned(),
        area_um2: number(cell.value("area"))?,
        leakage_nw: leakage(context, cell),
        clock_ff: capacitance(context, clock),
        enable_ff: capacitance(context, enable),
        clock_energy_fj: clock_energy(context, clock),
        max_load_ff: number(output.value("max_capacitance"))
            .map_or(f64::INFINITY, |x| x * context.capacitance_ff),
    })
}

/// Energy of a rising and a falling clock edge: the mean over the conditions that the library lists. Conditions in
/// which data and output differ are left out, because such an edge changes the output and is counted there.
fn clock_energy(context: &Context, clock: &Group) -> f64 {
    let supply = |group: &&Group| {
        !group.value("related_pg_pin").is_some_and(|pin| pin.to_ascii_uppercase().contains("VSS"))
    };
    let groups: Vec<&Group> = clock.of_kind("internal_power").filter(supply).collect();
    let stays = |group: &&&Group| group.value("when").is_none_or(keeps);
    let mut chosen: Vec<&&Group> = groups.iter().filter(stays).collect();
    if chosen.is_empty() {
        chosen = groups.iter().collect();
    }
    let mean = |kind: &str| {
        let tables = chosen.iter().filter_map(|group| context.table(group, kind, context.energy_fj));
        let values: Vec<f64> = tables.map(|table| table.at(CLOCK_SLEW_NS, 0.0)).collect();
        if values.is_empty() { 0.0 } else { values.iter().sum::<f64>() / values.len() as f64 }
    };
    mean("rise_power") + mean("fall_power")
}

/// Whether a condition says that data and output are equal, or does not speak of both.
fn keeps(when: &str) -> bool {
    let mut data = None;
    let mut output = None;
    for term in when.split(['&', '*']) {
        let term = term.trim_matches(['(', ')', ' ']);
        let (name, value) = term.strip_prefix('!').map_or((term, true), |name| (name, false));
        match name.trim() {
            "D" => data = Some(value),
            "Q" => output = Some(value),
            "QN" | "Q_N" if output.is_none() => output = Some(!value),
            _ => (),
        }
    }
    data.zip(output).is_none_or(|(data, output)| data == output)
}
