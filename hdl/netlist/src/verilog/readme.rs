//! The document beside an exported top: ports, timing, contents.

use std::fmt::Write;

use super::identifier::{CLOCK, Namespace, port_names};
use super::meaning::meaning;
use crate::{Design, Inventory, SignalType};

/// A Markdown page for the design's top.
#[must_use]
pub fn readme(design: &Design, inventory: &Inventory, description: &str) -> String {
    let top = design.top();
    let name = &top.name;
    let mut text = format!("# {name}\n\n");
    if !description.is_empty() {
        let _ = writeln!(text, "{}\n", description.trim());
    }
    let ports = port_names(top, &mut Namespace::default());
    text.push_str("## Ports\n\n| port | direction | bits | meaning |\n|---|---|---|---|\n");
    if top.clock.is_some() {
        let _ = writeln!(text, "| `{CLOCK}` | in | 1 | clock, rising edge; there is no reset |");
    }
    for (port, name) in top.inputs.iter().zip(&ports.inputs) {
        let _ = writeln!(text, "| `{name}` | in | {} | {} |", port.width, described(name, &port.signal_type));
    }
    for ((port, _), name) in top.outputs.iter().zip(&ports.outputs) {
        let _ =
            writeln!(text, "| `{name}` | out | {} | {} |", port.width, described(name, &port.signal_type));
    }
    text.push_str("\n## Timing\n\n");
    match inventory.latency_cycles {
        Some(0) => text.push_str("Combinational: outputs follow inputs within the cycle.\n"),
        Some(latency) => {
            let _ = writeln!(
                text,
                "Latency {latency} cycle{}, one operation per cycle. Registers start at their initial value; \
                 there is no reset.\n\n{}",
                if latency == 1 { "" } else { "s" },
                timing_diagram(latency)
            );
        }
        None => text.push_str("The latency differs between outputs, or there is feedback.\n"),
    }
    let _ = write!(
        text,
        "\n## Contents\n\n{} register bits, {} multiplexer bits, {} levels of operations between registers.\n\n",
        inventory.register_bits, inventory.multiplexer_bits, inventory.logic_levels
    );
    if !inventory.units.is_empty() {
        text.push_str("| unit | instances |\n|---|---|\n");
        for (kind, count) in &inventory.units {
            let _ = writeln!(text, "| {kind} | {count} |");
        }
        text.push('\n');
    }
    let _ = write!(
        text,
        "## Use\n\n\
         - simulate: `iverilog -g2005 -o {name}_tb {name}_tb.v {name}.v && vvp {name}_tb`\n\
         - lint: `verilator --lint-only -Wall {name}.v`\n\
         - synthesise: `yosys -s {name}.ys`\n\n\
         `{name}_vectors.hex` holds one clock cycle per line: the inputs and then the expected outputs in the order \
         of the table, first port highest, as one hexadecimal number.\n"
    );
    text
}

/// What a port means, and how its bits are read.
fn described(name: &str, signal_type: &SignalType) -> String {
    match signal_type {
        SignalType::Bits => meaning(name).unwrap_or_default(),
        SignalType::Signed => "two's complement".to_owned(),
        SignalType::Enum(labels) => {
            let short = labels.iter().map(|label| label.rsplit("::").next().unwrap_or(label));
            short.enumerate().map(|(value, label)| format!("{value} {label}")).collect::<Vec<_>>().join(", ")
        }
    }
}

/// Clock, inputs and outputs of a pipeline with two operations back to back.
fn timing_diagram(latency: u32) -> String {
    let cycles = latency as usize + 3;
    let clock: String = (0..cycles).map(|_| "/ \\_").collect();
    let lane = |first: usize| -> String {
        (0..cycles)
            .map(|cycle| match cycle.checked_sub(first) {
                Some(0) => "X A ",
                Some(1) => "X B ",
                Some(2) => "X---",
                _ => "----",
            })
            .collect()
    };
    let numbers: String = (0..cycles).map(|cycle| format!("{cycle:<4}")).collect();
    format!(
        "```text\ncycle    {}\nclk_i    {clock}\ninputs   {}\noutputs  {}\n```",
        numbers.trim_end(),
        lane(0),
        lane(latency as usize)
    )
}
