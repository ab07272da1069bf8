//! What other tools need beside the Verilog: synthesis script, constraint, FuseSoC core.

use super::identifier::CLOCK;
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

/// A timing constraint for a clock of `period_ns`: a fifth of the period outside the module on either side.
#[must_use]
pub fn constraint(design: &Design, period_ns: f64) -> String {
    let (period, delay) = (decimal(period_ns), decimal(period_ns / 5.0));
    let top = design.top();
    match top.clock {
        Some(_) => format!(
            "create_clock -name {CLOCK} -period {period} [get_ports {CLOCK}]\n\
             set_input_delay -clock {CLOCK} {delay} [remove_from_collection [all_inputs] [get_ports {CLOCK}]]\n\
             set_output_delay -clock {CLOCK} {delay} [all_outputs]\n"
        ),
        None => format!("set_max_delay {period} -from [all_inputs] -to [all_outputs]\n"),
    }
}

/// A FuseSoC description (CAPI2) with a lint and a simulation target.
#[must_use]
pub fn fusesoc_core(design: &Design) -> String {
    let top = &design.top().name;
    let version = env!("CARGO_PKG_VERSION");
    format!(
        "CAPI=2:\n\
         name: ::{top}:{version}\n\
         description: {kind} of dualsplit\n\
         filesets:\n\
         \x20 rtl:\n\
         \x20   files: [{top}.v]\n\
         \x20   file_type: verilogSource\n\
         \x20 tb:\n\
         \x20   files:\n\
         \x20     - {top}_tb.v: {{file_type: verilogSource}}\n\
         \x20     - {top}_vectors.hex: {{file_type: user, copyto: {top}_vectors.hex}}\n\
         \x20 constraint:\n\
         \x20   files: [{top}.sdc]\n\
         \x20   file_type: SDC\n\
         targets:\n\
         \x20 default:\n\
         \x20   filesets: [rtl]\n\
         \x20   toplevel: {top}\n\
         \x20 lint:\n\
         \x20   filesets: [rtl]\n\
         \x20   toplevel: {top}\n\
         \x20   default_tool: verilator\n\
         \x20   tools:\n\
         \x20     verilator: {{mode: lint-only, verilator_options: [-Wall]}}\n\
         \x20 sim:\n\
         \x20   filesets: [rtl, tb]\n\
         \x20   toplevel: {top}_tb\n\
         \x20   default_tool: icarus\n\
         \x20 synth:\n\
         \x20   filesets: [rtl, constraint]\n\
         \x20   toplevel: {top}\n",
        kind = design.top().kind,
    )
}
