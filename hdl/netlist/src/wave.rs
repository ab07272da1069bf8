//! Waveforms: a netlist's simulation as a value change dump that GTKWave and Surfer open.
//!
//! Scopes are the instances, signals their ports, registers and locals under the names of the source. One clock cycle
//! lasts [`CYCLE_NS`]: inputs change at its start, registers in its middle, with the rising edge. If the caller has a
//! [`Decode`] for a signal that carries a code, a second signal beside it, `<name>_text`, has words as values.

use std::io::{self, Write};

use crate::{Evaluator, Flat, NodeId};
use vcd::{IdCode, TimescaleUnit, Value, VarType, Writer};

/// Length of a clock cycle in the dump.
pub const CYCLE_NS: u64 = 10;

/// What the values of a signal mean, in a word.
pub type Decode = fn(u128) -> &'static str;

struct Signal {
    node: NodeId,
    width: u32,
    id: IdCode,
    text: Option<(IdCode, Decode)>,
    last: Option<u128>,
}

/// Simulates `netlist` for the given cycles, each the values of all inputs, and writes what every named signal does.
/// `decoder` knows by the name of a signal what its values mean.
///
/// # Errors
/// When `out` cannot be written.
pub fn write(
    netlist: &Flat,
    cycles: impl IntoIterator<Item = Vec<u128>>,
    decoder: impl Fn(&str) -> Option<Decode>,
    out: &mut dyn Write,
) -> io::Result<()> {
    let mut writer = Writer::new(&mut *out);
    writer.timescale(1, TimescaleUnit::NS)?;
    let (clock, mut signals) = declare(netlist, decoder, &mut writer)?;
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
fn declare<W: Write>(
    netlist: &Flat,
    decoder: impl Fn(&str) -> Option<Decode>,
    writer: &mut Writer<W>,
) -> io::Result<(IdCode, Vec<Signal>)> {
    let mut signals = Vec::new();
    let mut clock = IdCode::from(0u32);
    // Scopes are in depth-first order, so that those still open are the ancestors.
    let mut open: Vec<u32> = Vec::new();
    for (position, scope) in netlist.scopes.iter().enumerate() {
        while open.last().copied() != scope.parent && open.pop().is_some() {
            writer.upscope()?;
        }
        writer.add_module(&crate::verilog::plain(&scope.name))?;
        open.push(position as u32);
        if scope.parent.is_none() {
            clock = writer.add_wire(1, "clk_i")?;
        }
        for named in netlist.names.iter().filter(|named| named.scope as usize == position) {
            let width = netlist.nodes[named.node.index()].width;
            let name = crate::verilog::plain(&named.name);
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
