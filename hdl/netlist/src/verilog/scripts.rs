//! What other tools need beside the Verilog: synthesis script, constraint, FuseSoC core.

use std::fmt::Write;

use super::flow::{LIBRARY, MAKEFILE, RESTRUCTURING, TIMING};
use super::identifier::{CLOCK, Namespace, RESET, port_names};
use super::{AXIS, CHECKER, FPGA, Form, GeneratedFile, HEADER, PACKAGE, STREAM};
use crate::Design;

/// A yosys script that reads, checks and synthesises the design, printing statistics before and after.
///
/// `-noshare` leaves out a pass that runs out of memory on floating-point adders in yosys 0.23. The hierarchy is kept, so
/// that each module is mapped once; the statistics end with the sum over the hierarchy.
#[must_use]
pub fn yosys(design: &Design) -> String {
    let top = &design.top().name;
    format!(
        "# Run as: yosys -s {top}.ys\n\
         read_verilog {top}.v\n\
         hierarchy -check -top {top}\n\
         check -assert\n\
         tee -o {top}_hierarchy.txt stat\n\
         synth -noshare -top {top}\n\
         check -assert\n\
         tee -o {top}_cells.txt stat\n"
    )
}

/// `x` with three decimals, or with as many as it takes.
fn decimal(x: f64) -> String {
    let short = format!("{x:.3}");
    if short.parse() == Ok(x) { short } else { x.to_string() }
}

/// A timing constraint for a clock of `period_ns`: a fifth of the period outside the module on either side, a fiftieth of
/// uncertainty. Where the environment has `PERIOD` in nanoseconds, that is the period.
#[must_use]
pub fn constraint(design: &Design, form: &Form, period_ns: f64) -> String {
    let period = decimal(period_ns);
    let top = design.top();
    let names = port_names(top, &mut Namespace::default()).inputs;
    let ports = names.iter().zip(&top.inputs).map(|(name, port)| match port.width {
        1 => name.clone(),
        _ => format!("{name}[*]"),
    });
    let ports: Vec<String> = ports.collect();
    let reset = match form.resets(design) {
        true => format!("set_false_path -from [get_ports {RESET}]\n"),
        false => String::new(),
    };
    match top.clock {
        Some(_) => format!(
            "set period {period}\n\
             if {{[info exists ::env(PERIOD)]}} {{ set period $::env(PERIOD) }}\n\
             create_clock -name {CLOCK} -period $period [get_ports {CLOCK}]\n\
             set_clock_uncertainty [expr $period / 50.0] [get_clocks {CLOCK}]\n\
             set_input_delay -clock {CLOCK} [expr $period / 5.0] [get_ports {{{}}}]\n\
             set_output_delay -clock {CLOCK} [expr $period / 5.0] [all_outputs]\n{reset}",
            ports.join(" ")
        ),
        None => format!("set_max_delay {period} -from [all_inputs] -to [all_outputs]\n"),
    }
}

/// What the Makefile makes and FuseSoC has targets for.
const FLOW_TARGETS: [&str; 2] = ["timing", "fpga"];

/// A FuseSoC description (CAPI2), called by vendor, library, top and version, of a package with these other files: a lint and a
/// simulation target, a lint target of the stream if there is one, and `timing` and `fpga` if the top has a clock. These two let Icarus
/// elaborate the top, as FuseSoC wants a tool, and call the Makefile of [`super::shared_files`] with the environment's variables.
#[must_use]
pub fn fusesoc_core(design: &Design, description: &str, others: &[GeneratedFile]) -> String {
    let top = &design.top().name;
    let version = env!("CARGO_PKG_VERSION");
    let has = |suffix: &str| others.iter().any(|file| file.name == format!("{top}{suffix}"));
    let checker = match has(CHECKER) {
        true => format!("\x20     - {top}{CHECKER}: {{file_type: systemVerilogSource}}\n"),
        false => String::new(),
    };
    let lint = |toplevel: &str| {
        format!(
            "\x20   toplevel: {toplevel}\n\
             \x20   default_tool: verilator\n\
             \x20   tools:\n\
             \x20     verilator: {{mode: lint-only, verilator_options: [-Wall]}}\n"
        )
    };
    let mut text = format!(
        "CAPI=2:\n\
         name: dualsplit:rtl:{top}:{version}\n\
         description: \"{description}\"\n\
         filesets:\n\
         \x20 rtl:\n\
         \x20   files: [{top}.v]\n\
         \x20   file_type: verilogSource\n\
         \x20 tb:\n\
         \x20   files:\n\
         \x20     - {top}_tb.v: {{file_type: systemVerilogSource}}\n\
         {checker}\
         \x20     - {top}_vectors.hex: {{file_type: user, copyto: {top}_vectors.hex}}\n\
         \x20 constraint:\n\
         \x20   files: [{top}.sdc]\n\
         \x20   file_type: SDC\n",
        description = description.trim(),
    );
    if has(STREAM) {
        let _ = write!(
            text,
            "\x20 stream:\n\
             \x20   files:\n\
             \x20     - {top}{STREAM}: {{file_type: verilogSource}}\n\
             \x20     - {top}{AXIS}: {{file_type: verilogSource}}\n\
             \x20 words:\n\
             \x20   files:\n\
             \x20     - {top}{PACKAGE}: {{file_type: systemVerilogSource}}\n\
             \x20     - {top}{HEADER}: {{file_type: cSource, is_include_file: true}}\n"
        );
    }
    if has(FPGA) {
        // FuseSoC writes a Makefile of its own.
        let own = [".v", FPGA, ".sdc"].map(|end| format!("{top}{end}"));
        let shared = [RESTRUCTURING, LIBRARY, TIMING].map(str::to_owned);
        let copied = own.iter().chain(&shared).map(|name| (name.as_str(), name.as_str()));
        text.push_str("\x20 flow:\n\x20   file_type: user\n\x20   files:\n");
        for (name, copy) in copied.chain([(MAKEFILE, "flow.mk")]) {
            let _ = writeln!(text, "\x20     - {name}: {{copyto: {copy}}}");
        }
        text.push_str("scripts:\n");
        for name in FLOW_TARGETS {
            let _ = writeln!(text, "\x20 {name}: {{cmd: [make, -f, flow.mk, {name}, TOP={top}]}}");
        }
    }
    let _ = write!(
        text,
        "targets:\n\
         \x20 default:\n\
         \x20   filesets: [rtl]\n\
         \x20   toplevel: {top}\n\
         \x20 lint:\n\
         \x20   filesets: [rtl]\n\
         {}\
         \x20 sim:\n\
         \x20   filesets: [rtl, tb]\n\
         \x20   toplevel: {top}_tb\n\
         \x20   default_tool: icarus\n\
         \x20   tools:\n\
         \x20     icarus: {{iverilog_options: [-g2012]}}\n\
         \x20 synth:\n\
         \x20   filesets: [rtl, constraint]\n\
         \x20   toplevel: {top}\n",
        lint(top)
    );
    for name in FLOW_TARGETS.iter().filter(|_| has(FPGA)) {
        let _ = write!(
            text,
            "\x20 {name}:\n\
             \x20   filesets: [rtl, flow]\n\
             \x20   toplevel: {top}\n\
             \x20   default_tool: icarus\n\
             \x20   hooks: {{post_build: [{name}]}}\n"
        );
    }
    if has(STREAM) {
        let _ = write!(
            text,
            "\x20 stream:\n\
             \x20   filesets: [rtl, stream, words]\n\
             {}",
            lint(&format!("{top}_axis"))
        );
    }
    text
}
