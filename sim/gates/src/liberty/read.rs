//! From liberty's groups to cells.

use std::path::Path;

use super::attributes::{Context, arc, capacitance, is_input, is_output, leakage, number};
use super::function::{self, MAX_INPUTS, depends_on};
use super::syntax::{Group, parse};
use super::{Arc, Cell, LibertyError, Library};
use super::{sequential, sound};

/// Reads the texts of files that make up one library.
///
/// # Errors
/// As for [`super::load`].
pub fn read(files: &[(&Path, String)]) -> Result<Library, LibertyError> {
    let mut name = String::new();
    let mut voltage_v: Option<f64> = None;
    let mut cells: Vec<Cell> = Vec::new();
    let (mut flip_flops, mut gates) = (Vec::new(), Vec::new());
    let mut ties: [Option<(String, f64)>; 2] = [None, None];
    for (path, text) in files {
        let in_file = |error| LibertyError::In { path: path.to_path_buf(), error: Box::new(error) };
        let group = parse(text).map_err(in_file)?;
        sound::check(&group).map_err(in_file)?;
        let volts = number(group.value("nom_voltage"));
        if voltage_v.is_some() && voltage_v != volts {
            return Err(LibertyError::Mixed("nom_voltage"));
        }
        voltage_v = volts;
        if name.is_empty() {
            group.name().clone_into(&mut name);
        }
        let context = Context::new(&group).map_err(in_file)?;
        for cell in group.of_kind("cell") {
            // Most libraries close clock gates to synthesis, and leave them to the clock tree.
            if let Some(found) = sequential::clock_gate(&context, cell) {
                gates.push(found);
            }
            if cell.value("dont_use") == Some("true") {
                continue;
            }
            if let Some((value, tie)) = tie(cell) {
                let better = ties[value].as_ref().is_none_or(|(_, area)| tie.1 < *area);
                if better {
                    ties[value] = Some(tie);
                }
            } else if let Some(found) = combinational(&context, cell) {
                cells.push(found);
            } else if let Some(found) = sequential::flip_flop(&context, cell) {
                flip_flops.push(found);
            }
        }
    }
    cells.sort_by(|a, b| a.name.cmp(&b.name));
    flip_flops.sort_by(|a, b| a.area_um2.total_cmp(&b.area_um2).then_with(|| a.name.cmp(&b.name)));
    gates.sort_by(|a, b| a.area_um2.total_cmp(&b.area_um2).then_with(|| a.name.cmp(&b.name)));
    let missing = |what: &'static str| {
        let paths: Vec<String> = files.iter().map(|(path, _)| path.display().to_string()).collect();
        LibertyError::Missing { what, files: paths.join(", ") }
    };
    let flip_flop = flip_flops.into_iter().next().ok_or_else(|| missing("rising-edge D flip-flop"))?;
    let source =
        files.first().map(|(path, _)| path.file_name().unwrap_or_default().to_string_lossy().into_owned());
    let node_nm = known_node(&name);
    let library = Library {
        source: source.unwrap_or_default(),
        node_nm,
        voltage_v: voltage_v.unwrap_or(0.0),
        cells,
        flip_flop,
        clock_gate: gates.into_iter().next(),
        ties,
        name,
    };
    let (a, b) = (function::variable(0), function::variable(1));
    for (what, inputs, table) in [("inverter", 1, !a), ("two-input NAND gate", 2, !(a & b)), ("buffer", 1, a)]
    {
        if library.smallest(inputs, table).is_none() {
            return Err(missing(what));
        }
    }
    Ok(library)
}

/// Feature size of the libraries that are known by name.
fn known_node(name: &str) -> Option<u32> {
    let known =
        [("sky130", 130), ("sg13g2", 130), ("nangate", 45), ("freepdk45", 45), ("asap7", 7), ("osu018", 180)];
    let name = name.to_ascii_lowercase();
    known.into_iter().find(|(part, _)| name.contains(part)).map(|(_, node)| node)
}

/// A cell without inputs that gives a constant: the constant, name and area.
fn tie(cell: &Group) -> Option<(usize, (String, f64))> {
    let pins: Vec<&Group> = cell.of_kind("pin").collect();
    let [pin] = pins.as_slice() else { return None };
    let value = match pin.value("function")?.trim() {
        "0" => 0,
        "1" => 1,
        _ => return None,
    };
    Some((value, (cell.name().to_owned(), number(cell.value("area"))?)))
}

/// A cell with one output that is a function of up to six inputs, with complete tables.
fn combinational(context: &Context, cell: &Group) -> Option<Cell> {
    let is_state = |group: &Group| sound::STATES.contains(&group.kind);
    if cell.groups.iter().any(is_state) || cell.value("clock_gating_integrated_cell").is_some() {
        return None;
    }
    let mut inputs: Vec<&Group> = cell.of_kind("pin").filter(|pin| is_input(pin)).collect();
    inputs.sort_by_key(|pin| pin.name());
    let outputs: Vec<&Group> = cell.of_kind("pin").filter(|pin| is_output(pin)).collect();
    let [output] = outputs.as_slice() else { return None };
    if output.value("three_state").is_some() || inputs.is_empty() || inputs.len() > MAX_INPUTS {
        return None;
    }
    let names: Vec<&str> = inputs.iter().map(|pin| pin.name()).collect();
    let function = function::parse(output.value("function")?, &names)?;
    if (0..names.len()).any(|input| !depends_on(function, input)) {
        return None;
    }
    let arcs: Option<Vec<Arc>> =
        names.iter().map(|name| arc(context, output, name, is_combinational)).collect();
    Some(Cell {
        name: cell.name().to_owned(),
        area_um2: number(cell.value("area"))?,
        leakage_nw: leakage(context, cell),
        capacitance_ff: inputs.iter().map(|pin| capacitance(context, pin)).collect(),
        inputs: names.into_iter().map(str::to_owned).collect(),
        output: output.name().to_owned(),
        function,
        max_load_ff: number(output.value("max_capacitance"))
            .map_or(f64::INFINITY, |x| x * context.capacitance_ff),
        arcs: arcs?,
    })
}

fn is_combinational(timing: &Group) -> bool {
    matches!(timing.value("timing_type"), None | Some("combinational"))
}
