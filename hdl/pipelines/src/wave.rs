//! Waveforms: a netlist's simulation as a value change dump that GTKWave and Surfer open.
//!
//! Scopes are the instances, signals their ports, registers and locals under the names of the source. One clock cycle lasts
//! [`CYCLE_NS`]: inputs change at its start, registers in its middle, with the rising edge. Signals that carry a code get a
//! second one beside them, `<name>_text`, whose values are words: the type of the node in a header, the dual-split
//! pipeline's return value, and the routing of the shared units.

use std::io::{self, Write};

use golden::dst::header::{AXIS, CARVE, LEAF, SINGLE};
use netlist::{Evaluator, Flat, NodeId};
use vcd::{IdCode, TimescaleUnit, Value, VarType, Writer};

/// Length of a clock cycle in the dump.
pub const CYCLE_NS: u64 = 10;

/// What the words of a signal mean.
type Decode = fn(u128) -> &'static str;

/// The type of the node with this header.
#[must_use]
pub fn node_type(header: u128) -> &'static str {
    let header = header as u32;
    match (CARVE.get(header) == 1, LEAF.get(header) == 1, AXIS.get(header)) {
        (false, true, _) => "bare_leaf",
        (false, false, 0) => "split_x",
        (false, false, 1) => "split_y",
        (false, false, _) => "split_z",
        (true, false, SINGLE) => "single_carve",
        (true, false, _) => "dual_carve",
        (true, true, SINGLE) => "single_carve_leaf",
        (true, true, _) => "dual_carve_leaf",
    }
}

/// The dual-split pipeline's return value.
#[must_use]
pub fn return_value(code: u128) -> &'static str {
    ["miss", "one_child", "two_children", "leaf"][(code & 3) as usize]
}

/// What the shared block's units are routed into.
#[must_use]
pub fn routing(mode: u128) -> &'static str {
    ["threads", "ray_box", "dual_split", "reserved"][(mode & 3) as usize]
}

fn decoder(name: &str) -> Option<Decode> {
    match name {
        "mode_i" => Some(routing),
        "header_i" | "header_o" => Some(node_type),
        "code_o" => Some(return_value),
        _ => None,
    }
}

struct Signal {
    node: NodeId,
    width: u32,
    id: IdCode,
    text: Option<(IdCode, Decode)>,
    last: Option<u128>,
}

/// Simulates `netlist` for the given cycles, each the values of all inputs, and writes what every named signal does.
///
/// # Errors
/// When `out` cannot be written.
pub fn write(
    netlist: &Flat,
    cycles: impl IntoIterator<Item = Vec<u128>>,
    out: &mut dyn Write,
) -> io::Result<()> {
    let mut writer = Writer::new(&mut *out);
    writer.timescale(1, TimescaleUnit::NS)?;
    let (clock, mut signals) = declare(netlist, &mut writer)?;
    let mut simulation = Evaluator::new(netlist);
    let mut time = 0;
    for inputs in cycles {
        for (position, value) in inputs.into_iter().enumerate() {
            simulation.set_input(position, value);
        }
        for (level, offset) in [(Value::V0, 0), (Value::V1, CYCLE_NS / 2)] {
            if level == Value::V1 {
                simulation.clock();
            }
            simulation.settle();
            writer.timestamp(time + offset)?;
            writer.change_scalar(clock, level)?;
            change(&mut writer, &simulation, &mut signals)?;
        }
        time += CYCLE_NS;
    }
    writer.timestamp(time)?;
    out.flush()
}

/// Declares all scopes and signals, the clock in the top scope.
fn declare<W: Write>(netlist: &Flat, writer: &mut Writer<W>) -> io::Result<(IdCode, Vec<Signal>)> {
    let mut signals = Vec::new();
    let mut clock = IdCode::from(0u32);
    // Scopes are in depth-first order, so that those still open are the ancestors.
    let mut open: Vec<u32> = Vec::new();
    for (position, scope) in netlist.scopes.iter().enumerate() {
        while open.last().copied() != scope.parent && open.pop().is_some() {
            writer.upscope()?;
        }
        writer.add_module(&netlist::verilog::plain(&scope.name))?;
        open.push(position as u32);
        if scope.parent.is_none() {
            clock = writer.add_wire(1, "clk_i")?;
        }
        for named in netlist.names.iter().filter(|named| named.scope as usize == position) {
            let width = netlist.nodes[named.node.index()].width;
            let name = netlist::verilog::plain(&named.name);
            let id = writer.add_wire(width, &name)?;
            let text = match decoder(&named.name) {
                Some(decode) => {
                    Some((writer.add_var(VarType::String, 1, &format!("{name}_text"), None)?, decode))
                }
                None => None,
            };
            signals.push(Signal { node: named.node, width, id, text, last: None });
        }
    }
    for _ in open {
        writer.upscope()?;
    }
    writer.enddefinitions()?;
    Ok((clock, signals))
}

/// Writes the signals that have changed.
fn change<W: Write>(
    writer: &mut Writer<W>,
    simulation: &Evaluator<'_>,
    signals: &mut [Signal],
) -> io::Result<()> {
    for signal in signals {
        let value = simulation.value(signal.node);
        if signal.last.replace(value) == Some(value) {
            continue;
        }
        let bits: Vec<Value> =
            (0..signal.width).rev().map(|bit| Value::from(value >> bit & 1 == 1)).collect();
        writer.change_vector(signal.id, &bits)?;
        if let Some((id, decode)) = signal.text {
            writer.change_string(id, decode(value))?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::{StandardFormat, Top};
    use crate::equivalence::Stimulus;
    use netlist::flatten;
    use std::collections::HashMap;
    use vcd::{Command, Parser, ScopeItem};

    /// The dump, read back by the reader of `vcd`, shows each input and output of each cycle, and the decoded type.
    #[test]
    fn the_dump_reads_back() {
        let netlist = flatten(&Top::DualSplit.design(StandardFormat::Binary32).unwrap()).unwrap();
        let stimulus = Stimulus::new(Top::DualSplit, StandardFormat::Binary32, &netlist, 1);
        let cycles: Vec<Vec<u128>> = stimulus.take(40).collect();
        let mut bytes = Vec::new();
        write(&netlist, cycles.iter().cloned(), &mut bytes).unwrap();

        let mut parser = Parser::new(&bytes[..]);
        let header = parser.parse_header().unwrap();
        let id = |name: &str| header.find_var(&["dual_split", name]).unwrap().code;
        let inside = header.find_var(&["dual_split", "multiply_0", "array", "product_o"]);
        assert_eq!(inside.unwrap().size, 48, "signals of inner instances are there");
        let scopes = header.items.iter().filter(|item| matches!(item, ScopeItem::Scope(_))).count();
        assert_eq!(scopes, 1);

        let mut expected = Evaluator::new(&netlist);
        let (node, code) = (netlist.input("header_i").unwrap(), netlist.output("code_o").unwrap());
        let (mut words, mut text) = (HashMap::new(), HashMap::new());
        let mut time = 0;
        let mut compared = 0;
        for command in parser {
            match command.unwrap() {
                Command::ChangeVector(id, bits) => {
                    let value =
                        bits.iter().fold(0u128, |value, bit| value << 1 | u128::from(*bit == Value::V1));
                    words.insert(id, value);
                }
                Command::ChangeString(id, value) => {
                    text.insert(id, value);
                }
                Command::Timestamp(next) => {
                    // Everything at the start of a cycle has been read.
                    if time % CYCLE_NS == 0 && next == time + CYCLE_NS / 2 {
                        let cycle = (time / CYCLE_NS) as usize;
                        let outputs = expected.cycle(&cycles[cycle]);
                        assert_eq!(words[&id("header_i")], cycles[cycle][node], "cycle {cycle}");
                        assert_eq!(text[&id("header_i_text")], node_type(cycles[cycle][node]));
                        assert_eq!(words[&id("code_o")], outputs[code], "cycle {cycle}");
                        assert_eq!(text[&id("code_o_text")], return_value(outputs[code]));
                        compared += 1;
                    }
                    time = next;
                }
                _ => {}
            }
        }
        assert_eq!(compared, cycles.len());
    }
}
