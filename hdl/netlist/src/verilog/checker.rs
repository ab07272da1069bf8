//! A module of assertions beside a top: `<top>_checker`.
//!
//! The assertions are immediate, in a clocked block, on history registers of the checker's own. Simulators and yosys read them
//! alike. Two hold for every pipeline: its latency, and that a stall holds its outputs. The caller adds [`Claim`]s about what
//! the outputs mean.

use std::fmt::Write;

use super::emit::range;
use super::identifier::{CLOCK, Namespace, RESET, port_names};
use crate::Design;

/// Something that holds of every valid result.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Claim {
    /// Name, a Verilog identifier.
    pub name: &'static str,
    /// What it says, for the comment.
    pub meaning: &'static str,
    /// A Verilog expression of the top's outputs, and of its inputs when the operation went in: `header_i_then`. `ordered(a, b)` says that
    /// the number `a` is not greater than `b`.
    pub holds: String,
}

/// The checker of a top.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Checker {
    /// Its Verilog.
    pub text: String,
    /// Its inputs besides clock and reset: ports of the top. Its output is called `holds_o`.
    pub ports: Vec<String>,
}

/// The module `<top>_checker`, for a top with `en_i`, `valid_i`, `valid_o` and the same latency, not zero, for all outputs. Its output
/// `holds_o` says whether all assertions hold.
pub(super) fn checker(design: &Design, latency: u32, claims: &[Claim]) -> Option<Checker> {
    let top = design.top();
    let names = port_names(top, &mut Namespace::default());
    let inputs = || names.inputs.iter().zip(top.inputs.iter().map(|port| port.width));
    let outputs = || names.outputs.iter().zip(top.outputs.iter().map(|(port, _)| port.width));
    let has = |wanted: &str| inputs().chain(outputs()).any(|(name, _)| name == wanted);
    if latency == 0 || !["en_i", "valid_i", "valid_o"].iter().all(|name| has(name)) || !design.has_reset(top)
    {
        return None;
    }
    let then = |name: &str| format!("{name}_then");
    let remembered: Vec<_> =
        inputs().filter(|(name, _)| claims.iter().any(|claim| claim.holds.contains(&then(name)))).collect();
    let results: Vec<_> = outputs().filter(|(name, _)| *name != "valid_o").collect();
    let result_bits: u32 = results.iter().map(|(_, width)| width).sum();
    let result_names: Vec<&str> = results.iter().map(|(name, _)| name.as_str()).collect();
    let result_names = result_names.join(", ");
    let name = &top.name;

    let mut text = format!(
        "// {name}_checker: assertions about {name}; written by dualsplit {}, do not edit.\n\
         // SystemVerilog for its immediate assertions, otherwise Verilog-2005. Connect it to the ports of {name}; holds_o is low where\n\
         // an assertion fails.\n`default_nettype none\n\nmodule {name}_checker (\n    input  wire {CLOCK},\n    input  wire {RESET},\n\
         \x20   input  wire en_i,\n    input  wire valid_i",
        env!("CARGO_PKG_VERSION")
    );
    let mut ports = vec!["en_i".to_owned(), "valid_i".to_owned()];
    for (port, width) in remembered.iter().copied().chain(outputs()) {
        let _ = write!(text, ",\n    input  wire {}{port}", range(width));
        ports.push(port.clone());
    }
    text.push_str(",\n    output wire holds_o\n);\n");

    let last = latency - 1;
    let shifted = |register: &str, width: u32, input: &str| match latency {
        1 => input.to_owned(),
        _ => format!("{{{register}[{}:0], {input}}}", width * last - 1),
    };
    let _ = write!(
        text,
        "\n    // The last {latency} cycles in which the pipeline moved, the latest lowest.\n    reg {}valid_history;\n    reg stalled;\n    reg active;\n    \
         reg {}results_before;\n",
        range(latency),
        range(result_bits)
    );
    for (port, width) in &remembered {
        let _ = writeln!(text, "    reg {}{port}_history;", range(width * latency));
    }
    let _ = write!(
        text,
        "    always @(posedge {CLOCK} or negedge {RESET}) begin\n        if (!{RESET}) begin\n            valid_history <= {latency}'d0;\n            \
         stalled <= 1'b0;\n            active <= 1'b0;\n        end else begin\n            active <= 1'b1;\n            stalled <= ~en_i;\n            if (en_i) begin\n                \
         valid_history <= {};\n            end\n        end\n    end\n    always @(posedge {CLOCK}) begin\n        \
         results_before <= {{{result_names}}};\n",
        shifted("valid_history", 1, "valid_i")
    );
    if !remembered.is_empty() {
        text.push_str("        if (en_i) begin\n");
        for (port, width) in &remembered {
            let _ = writeln!(
                text,
                "            {port}_history <= {};",
                shifted(&format!("{port}_history"), *width, port)
            );
        }
        text.push_str("        end\n");
    }
    text.push_str("    end\n");
    for (port, width) in &remembered {
        let (high, low) = (width * latency - 1, width * last);
        let _ = writeln!(text, "    wire {}{} = {port}_history[{high}:{low}];", range(*width), then(port));
    }
    if claims.iter().any(|claim| claim.holds.contains("ordered(")) {
        let widest = results
            .iter()
            .find(|(name, _)| name.contains("_t_") || name.starts_with("t_"))
            .map_or(32, |(_, width)| *width);
        text.push_str(&ordered(widest));
    }
    let oldest = if latency == 1 { "valid_history".to_owned() } else { format!("valid_history[{last}]") };
    let stall = format!("~(stalled & valid_o) | ({{{result_names}}} == results_before)");
    let mut assertions = vec![
        (
            "latency_holds",
            "Results are valid as many cycles after their operands as the latency, counted where en_i is high.",
            format!("valid_o == {oldest}"),
        ),
        ("stall_holds", "A result stays while en_i is low.", stall),
    ];
    assertions.extend(
        claims.iter().map(|claim| (claim.name, claim.meaning, format!("~valid_o | ({})", claim.holds))),
    );
    text.push('\n');
    for (name, meaning, holds) in &assertions {
        let _ = writeln!(text, "    // {meaning}\n    wire {name} = {holds};");
    }
    let all: Vec<&str> = assertions.iter().map(|(name, ..)| *name).collect();
    let _ = writeln!(text, "    assign holds_o = ~active | ({});", all.join(" & "));
    let _ = writeln!(text, "\n    always @(posedge {CLOCK}) begin\n        if (active) begin");
    for name in all {
        let _ = writeln!(text, "            assert ({name});");
    }
    text.push_str("        end\n    end\n");
    if !remembered.is_empty() {
        let then: Vec<String> = remembered.iter().map(|(port, _)| then(port)).collect();
        let _ = write!(
            text,
            "\n    // Bits that nothing reads\n    wire unused = &{{1'b0, {}}};\n",
            then.join(", ")
        );
    }
    text.push_str("endmodule\n\n`default_nettype wire\n");
    Some(Checker { text, ports })
}

/// A function that says whether a number of `width` bits is not greater than another; neither is NaN.
fn ordered(width: u32) -> String {
    let (sign, high) = (width - 1, width - 2);
    format!(
        "\n    // a <= b, for numbers: the words of negative ones are in reverse order, and -0 equals +0.\n    \
         function automatic ordered;\n        input [{sign}:0] a;\n        input [{sign}:0] b;\n        begin\n            \
         if (a[{sign}] != b[{sign}]) ordered = a[{sign}] | ~(|a[{high}:0] | |b[{high}:0]);\n            \
         else ordered = a[{sign}] ? a >= b : a <= b;\n        end\n    endfunction\n"
    )
}
