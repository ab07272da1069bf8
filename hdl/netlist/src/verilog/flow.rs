//! The route from Verilog to numbers with public tools: a Makefile for all tops of a folder, its scripts for ABC, liberty files and
//! OpenSTA, and for each top a wrapper that fits an FPGA's pins.

use std::fmt::Write;

use super::identifier::{CLOCK, Namespace, RESET, port_names};
use super::{Form, GeneratedFile};
use crate::Design;

/// Names of the files that the packages of a folder share.
pub(super) const MAKEFILE: &str = "Makefile";
pub(super) const RESTRUCTURING: &str = "restructure.abc";
pub(super) const LIBRARY: &str = "library.awk";
pub(super) const TIMING: &str = "timing.tcl";

/// ABC's commands that restructure logic for delay, in three rounds.
pub const RESTRUCTURE: &str = "strash; ifraig; scorr; dc2; dch -f; if -g -K 6; strash; dch -f; if -g -K 6; strash; dch -f; \
                               if -g -K 6; strash; dch -f";
/// ABC's commands that map what [`RESTRUCTURE`] leaves to cells within `{D}` picoseconds between registers, buffer and size them.
pub const MAP: &str = "map -B 0.9 -D {D}; topo; buffer -c; topo; upsize -D {D}; dnsize -D {D}";

/// The files that the packages in one folder share: `Makefile`, `restructure.abc`, `library.awk` and `timing.tcl`. The Makefile's
/// default top is `top`, its default clock period `period_ns`.
#[must_use]
pub fn shared_files(top: &str, period_ns: f64) -> Vec<GeneratedFile> {
    let makefile =
        include_str!("makefile.mk").replace("%TOP%", top).replace("%PERIOD%", &period_ns.to_string());
    let restructure = format!("{RESTRUCTURE}; {MAP}\n").replace("; ", "\n");
    let files = [
        (MAKEFILE, makefile),
        (RESTRUCTURING, restructure),
        (LIBRARY, include_str!("library.awk").into()),
        (TIMING, include_str!("timing.tcl").into()),
    ];
    files.map(|(name, contents)| GeneratedFile { name: name.into(), contents }).into()
}

/// The module `<top>_fpga`: operands are shifted in and results out, a bit a cycle, so that four or five pins suffice and every path of the
/// top lies between registers.
pub(super) fn fpga_wrapper(design: &Design, form: &Form) -> String {
    let top = design.top();
    let ports = port_names(top, &mut Namespace::default());
    let name = &top.name;
    let inputs: u32 = top.inputs.iter().map(|port| port.width).sum();
    let outputs: u32 = top.outputs.iter().map(|(port, _)| port.width).sum();
    let mut connections = vec![format!(".{CLOCK}({CLOCK})")];
    let mut reset = String::new();
    if form.resets(design) {
        connections.push(format!(".{RESET}({RESET})"));
        reset = format!("    input  wire {RESET},\n");
    }
    let widths = top.inputs.iter().chain(top.outputs.iter().map(|(port, _)| port)).map(|port| port.width);
    let words = ports
        .inputs
        .iter()
        .map(|_| ("operands", inputs))
        .chain(ports.outputs.iter().map(|_| ("results", outputs)));
    let mut low = [0, 0];
    for ((port, width), (word, _)) in ports.inputs.iter().chain(&ports.outputs).zip(widths).zip(words) {
        let low = &mut low[usize::from(word == "results")];
        let slice =
            if width == 1 { format!("{word}[{low}]") } else { format!("{word}[{}:{low}]", *low + width - 1) };
        connections.push(format!(".{port}({slice})"));
        *low += width;
    }
    let (last_in, last_out) = (inputs - 1, outputs - 1);
    let mut text = format!(
        "// {name}_fpga: {name} between shift registers; written by dualsplit {}, do not edit.\n\
         // Verilog-2005. The wrapper itself has {} flip-flops and, on an FPGA, {outputs} LUTs; what is left of a report is {name}.\n\
         `default_nettype none\n\nmodule {name}_fpga (\n    input  wire {CLOCK},\n{reset}    input  wire serial_i,\n    input  wire take_i,\n    \
         output wire serial_o\n);\n\n",
        env!("CARGO_PKG_VERSION"),
        inputs + outputs
    );
    let _ = write!(
        text,
        "    reg [{last_in}:0] operands;\n    reg [{last_out}:0] taken;\n    wire [{last_out}:0] results;\n    \
         always @(posedge {CLOCK}) begin\n        operands <= {{operands[{}:0], serial_i}};\n        \
         taken <= take_i ? results : {{taken[{}:0], 1'b0}};\n    end\n    assign serial_o = taken[{last_out}];\n\n    \
         {name} dut (\n        {}\n    );\nendmodule\n\n`default_nettype wire\n",
        last_in - 1,
        last_out - 1,
        connections.join(",\n        ")
    );
    text
}
