//! A pipeline with ready and valid on both sides, by itself and as AXI4-Stream.
//!
//! A pipeline with a clock enable stops as a whole. [`stream`] enables it while its last stage is empty or read, and puts one
//! place for operands before it: `ready_o` is a register and does not wait for `ready_i`, and no `valid` depends on a `ready`
//! of the same cycle. A reader that is always ready gets one result a cycle. [`axis`] packs the operands into one word and the
//! results into another, by [`Words`].

use std::fmt::Write;

use super::emit::range;
use super::fields::Words;
use super::identifier::{CLOCK, Namespace, RESET, port_names};
use crate::Design;

/// A port that passes through: name and width in bits.
type Wire = (String, u32);

/// Inputs and outputs of a top that belong to an operation, tag included.
pub(super) struct Payload {
    pub operands: Vec<Wire>,
    pub results: Vec<Wire>,
}

impl Payload {
    /// That of a design whose top has `valid_i`, `en_i` and `valid_o`, no second valid, and a reset; such are the pipelines.
    pub fn of(design: &Design) -> Option<Self> {
        let top = design.top();
        let ports = port_names(top, &mut Namespace::default());
        let handshake = ["en_i", "valid_i", "valid_o"];
        let all = || ports.inputs.iter().chain(&ports.outputs);
        let is_complete = handshake.iter().all(|&wanted| all().any(|name| name == wanted));
        let valids = all().filter(|name| name.contains("valid")).count();
        let data = |names: &[String], widths: Vec<u32>| -> Vec<Wire> {
            let wires = names.iter().cloned().zip(widths);
            wires.filter(|(name, _)| !handshake.contains(&name.as_str())).collect()
        };
        (is_complete && valids == 2 && design.has_reset(top)).then(|| Self {
            operands: data(&ports.inputs, top.inputs.iter().map(|port| port.width).collect()),
            results: data(&ports.outputs, top.outputs.iter().map(|(port, _)| port.width).collect()),
        })
    }
}

fn declarations(direction: &str, wires: &[Wire]) -> String {
    wires.iter().map(|(name, width)| format!(",\n    {direction} wire {}{name}", range(*width))).collect()
}

fn connections<'w>(wires: impl Iterator<Item = (&'w str, String)>) -> String {
    wires.map(|(port, value)| format!(",\n        .{port}({value})")).collect()
}

/// The module `<top>_stream`.
pub(super) fn stream(design: &Design, payload: &Payload) -> String {
    let top = &design.top().name;
    let total: u32 = payload.operands.iter().map(|(_, width)| width).sum();
    let names: Vec<&str> = payload.operands.iter().map(|(name, _)| name.as_str()).collect();
    let (high, operands) = (total - 1, names.join(", "));
    let mut low = total;
    let inputs = payload.operands.iter().map(|(name, width)| {
        low -= width;
        let slice = if *width == 1 {
            format!("operands[{low}]")
        } else {
            format!("operands[{}:{low}]", low + width - 1)
        };
        (name.as_str(), slice)
    });
    let inputs = connections(inputs);
    let outputs = connections(payload.results.iter().map(|(name, _)| (name.as_str(), name.clone())));
    format!(
        "// {top}_stream: {top} with ready and valid on both sides; written by dualsplit {version}, do not edit.\n\
         // Verilog-2005. Operands go in where valid_i and ready_o are high, results come out where valid_o and ready_i are high.\n\
         // ready_o is a register: it falls a cycle after the pipeline has stopped, and one place keeps what comes meanwhile.\n\
         // No valid depends on a ready of the same cycle.\n\
         `default_nettype none\n\n\
         module {top}_stream (\n    input  wire {CLOCK},\n    input  wire {RESET},\n    input  wire valid_i,\n    output wire ready_o{declared_in},\n\
         \x20   output wire valid_o,\n    input  wire ready_i{declared_out}\n);\n\n\
         \x20   // The pipeline moves while its last stage is empty or read.\n\
         \x20   wire moves = ready_i | ~valid_o;\n\n\
         \x20   // Operands that came when it had just stopped.\n\
         \x20   reg waiting;\n    reg [{high}:0] waiting_operands;\n\
         \x20   wire [{high}:0] operands = waiting ? waiting_operands : {{{operands}}};\n\
         \x20   assign ready_o = ~waiting;\n\n\
         \x20   always @(posedge {CLOCK} or negedge {RESET}) begin\n        if (!{RESET}) begin\n            waiting <= 1'b0;\n        end else begin\n\
         \x20           waiting <= ~moves & (waiting | valid_i);\n        end\n    end\n\
         \x20   always @(posedge {CLOCK}) begin\n        if (valid_i & ready_o & ~moves) begin\n            waiting_operands <= {{{operands}}};\n        end\n    end\n\n\
         \x20   {top} pipeline (\n        .{CLOCK}({CLOCK}),\n        .{RESET}({RESET}),\n        .en_i(moves),\n        .valid_i(waiting | valid_i){inputs},\n\
         \x20       .valid_o(valid_o){outputs}\n    );\nendmodule\n\n`default_nettype wire\n",
        version = env!("CARGO_PKG_VERSION"),
        declared_in = declarations("input ", &payload.operands),
        declared_out = declarations("output", &payload.results),
    )
}

/// The module `<top>_axis`.
pub(super) fn axis(design: &Design, payload: &Payload, words: &Words<'_>) -> String {
    let top = &design.top().name;
    let tag = |wires: &[Wire], name: &str| {
        wires.iter().find(|(found, _)| found == name).map_or(1, |(_, width)| *width)
    };
    let (tag_in, tag_out) = (tag(&payload.operands, "tag_i"), tag(&payload.results, "tag_o"));
    let inputs = words.operands.iter().map(|field| (field.port.as_str(), field.slice("s_axis_tdata")));
    let inputs = connections(inputs);
    let outputs = connections(words.results.iter().map(|field| (field.port.as_str(), field.port.clone())));
    let mut wires = String::new();
    let mut packed: Vec<String> = Vec::new();
    for field in &words.results {
        let _ = writeln!(wires, "    wire {}{};", range(field.width), field.port);
        packed.push(match words.word_bits - field.width {
            0 => field.port.clone(),
            pad => format!("{{{pad}'d0, {}}}", field.port),
        });
    }
    packed.reverse();
    let mut unread: Vec<String> =
        words.operands.iter().filter_map(|field| field.padding("s_axis_tdata", words.word_bits)).collect();
    unread.insert(0, "1'b0".to_owned());
    let unread = match unread.len() {
        1 => String::new(),
        _ => format!("\n    // Bits that nothing reads\n    wire unused = &{{{}}};\n", unread.join(", ")),
    };
    format!(
        "// {top}_axis: {top} as AXI4-Stream; written by dualsplit {version}, do not edit.\n\
         // Verilog-2005. Each field of {top}_pkg.sv and {top}.h is one word of {bits} bits, the first one lowest. TUSER is the tag.\n\
         `default_nettype none\n\n\
         module {top}_axis (\n    input  wire aclk,\n    input  wire aresetn,\n    input  wire s_axis_tvalid,\n    output wire s_axis_tready,\n\
         \x20   input  wire [{s_high}:0] s_axis_tdata,\n    input  wire {s_tag}s_axis_tuser,\n\
         \x20   output wire m_axis_tvalid,\n    input  wire m_axis_tready,\n    output wire [{m_high}:0] m_axis_tdata,\n    output wire {m_tag}m_axis_tuser\n);\n\n\
         {wires}\n    {top}_stream stream (\n        .{CLOCK}(aclk),\n        .{RESET}(aresetn),\n        .valid_i(s_axis_tvalid),\n        .ready_o(s_axis_tready){inputs},\n\
         \x20       .tag_i(s_axis_tuser),\n        .valid_o(m_axis_tvalid),\n        .ready_i(m_axis_tready){outputs},\n        .tag_o(m_axis_tuser)\n    );\n\
         \x20   assign m_axis_tdata = {{{packed}}};\n{unread}endmodule\n\n`default_nettype wire\n",
        version = env!("CARGO_PKG_VERSION"),
        bits = words.word_bits,
        s_high = words.operands.len() as u32 * words.word_bits - 1,
        m_high = words.results.len() as u32 * words.word_bits - 1,
        s_tag = range(tag_in),
        m_tag = range(tag_out),
        packed = packed.join(", "),
    )
}
