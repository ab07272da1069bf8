//! The document beside an exported top: ports, timing, contents.

use std::fmt::Write;

use super::PackageOptions;
use super::identifier::{CLOCK, Namespace, RESET, port_names};
use super::meaning::meaning;
use crate::{Design, Inventory, SignalType};

/// A Markdown page for the design's top.
#[must_use]
pub fn readme(design: &Design, inventory: &Inventory, options: &PackageOptions) -> String {
    let top = design.top();
    let name = &top.name;
    let mut text = format!("# {name}\n\n");
    if !options.description.is_empty() {
        let _ = writeln!(text, "{}\n", options.description.trim());
    }
    let resets = options.form.resets(design);
    let ports = port_names(top, &mut Namespace::default());
    text.push_str("## Ports\n\n| port | direction | bits | meaning |\n|---|---|---|---|\n");
    if top.clock.is_some() {
        let reset = if resets { "" } else { "; there is no reset" };
        let _ = writeln!(text, "| `{CLOCK}` | in | 1 | clock, rising edge{reset} |");
    }
    if resets {
        let _ = writeln!(
            text,
            "| `{RESET}` | in | 1 | low: no operation is in flight; may fall at any time, rises with the clock |"
        );
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
                "Latency {latency} cycle{}, one operation per cycle. {}\n\n{}",
                if latency == 1 { "" } else { "s" },
                start(resets),
                timing_diagram(latency)
            );
            let enable = top.inputs.iter().any(|port| port.name == "en_i");
            if enable && top.outputs.iter().any(|(port, _)| port.name == "valid_o") {
                text.push_str(
                    "\nWhile `en_i` is low, every register holds and no operand is taken. `valid_o` then stays as it is: a result \
                     that was valid in the cycle before is shown again, and is the same result. A reader counts a result where \
                     both `valid_o` and `en_i` are high.\n",
                );
            }
        }
        None => text.push_str("The latency differs between outputs, or there is feedback.\n"),
    }
    if !options.notes.is_empty() {
        let _ = write!(text, "\n{}\n", options.notes.trim());
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
    if options.is_pipeline && resets {
        let _ = write!(
            text,
            "## Stream\n\n\
             `{name}_stream` has ready and valid on both sides: one result a cycle for a reader that is always ready, no path from a ready \
             to a valid or to the other ready, one place for operands that arrive when the pipeline has just stopped. `{name}_axis` is \
             the same as AXI4-Stream, with the tag as TUSER. `{name}_pkg.sv` and `{name}.h` have the fields of TDATA.\n\n"
        );
    }
    let _ = write!(
        text,
        "## Use\n\n\
         - simulate: `make sim TOP={name}`, which ends with another exit code than 0 if an output differs or an assertion fails\n\
         - lint: `make lint TOP={name}`\n\
         - synthesise: `yosys -s {name}.ys`\n\
         - clock and area: `make timing TOP={name} LIBERTY=FILES DRIVER=INVERTER PERIOD=NS`, by yosys, ABC and OpenSTA\n\
         - FPGA: `make fpga TOP={name}`, on an ECP5-85k by yosys and nextpnr\n\n\
         `{name}_vectors.hex` holds one clock cycle per line: the inputs and then the expected outputs in the order \
         of the table, first port highest, as one hexadecimal number.\n"
    );
    text
}

/// What registers hold at first.
fn start(resets: bool) -> &'static str {
    match resets {
        true => {
            "`rst_ni` clears the valid bits and nothing else: all other registers are unknown until operands have come \
             through, and no output depends on them while it is valid."
        }
        false => "Registers start at their initial value; there is no reset.",
    }
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
