//! Verilog-2005 from the elaborated design, with everything that another engineer needs to use it.
//!
//! [`text`] is one file per top: each module once, children first, names of the source kept, width-exact. Files of different tops
//! can be compiled together, since no two have a module of one name. [`Form`] adds a reset and the source's comments.
//! [`package`] adds testbench, vectors, yosys script, constraint, FuseSoC core and a README. rust-hdl's own export
//! serves as a cross-check: [`cross_check`].

mod checker;
mod comments;
mod constant;
pub mod cross_check;
mod emit;
mod expression;
mod fields;
mod flow;
mod identifier;
mod meaning;
mod readme;
mod scripts;
mod stream;
pub mod testbench;

use std::collections::BTreeSet;
use std::fmt::Write;
use std::io;
use std::path::{Path, PathBuf};

pub use checker::{Checker, Claim};
pub use comments::{Comments, Part};
pub use flow::{MAP, RESTRUCTURE, shared_files};
pub use identifier::{CLOCK, Namespace, PortNames, RESET, plain, port_name, port_names};
pub use readme::readme;
pub use scripts::{constraint, fusesoc_core, yosys};

use crate::{Design, ElaborateError, Module, inventory};

/// What the Verilog has beyond the logic. The default has no reset, initial values instead, and no comments of the source.
#[derive(Clone, Copy, Debug, Default)]
pub struct Form<'a> {
    /// Whether the port [`RESET`] clears the valid bits, asynchronously when it falls. No register has an initial value then;
    /// a design without valid bits stays as it is.
    pub reset: bool,
    /// The source file of each kind of module, whose comments are kept.
    pub sources: &'a [(&'a str, &'a str)],
}

/// Ends of the names of the files that not every package has.
const CHECKER: &str = "_checker.sv";
const STREAM: &str = "_stream.v";
const AXIS: &str = "_axis.v";
const PACKAGE: &str = "_pkg.sv";
const HEADER: &str = ".h";
const FPGA: &str = "_fpga.v";

/// The design as one Verilog-2005 file, in the default form. Deterministic; ASCII.
#[must_use]
pub fn text(design: &Design) -> String {
    Form::default().text(&[design], &design.top().name)
}

impl Form<'_> {
    /// The designs as one Verilog-2005 file called `name`. Deterministic; ASCII.
    #[must_use]
    pub fn text(&self, designs: &[&Design], name: &str) -> String {
        let resets = designs.iter().any(|design| self.resets(design));
        let start = match resets {
            true => "rst_ni, asserted asynchronously, clears the valid bits and nothing else",
            false => "no reset: registers start at their initial value",
        };
        let mut text = format!(
            "// {name}: written by dualsplit {} from the rust-hdl source; do not edit.\n\
             // Verilog-2005. One clock, rising edge; {start}.\n\
             `default_nettype none\n",
            env!("CARGO_PKG_VERSION")
        );
        if designs.iter().map(|design| design.modules.len()).sum::<usize>() > 1 {
            text.push_str(
                "// One file holds the whole hierarchy of its top:\n// verilator lint_off DECLFILENAME\n",
            );
        }
        for design in designs {
            let mut described = BTreeSet::new();
            for module in &design.modules {
                let comments = match self.sources.iter().find(|(kind, _)| *kind == module.kind) {
                    Some((_, source)) => Comments::of(source),
                    None => Comments::default(),
                };
                text.push('\n');
                text.push_str(&header(module));
                if described.insert(&module.kind) && !comments.head.is_empty() {
                    let _ = write!(text, "//\n{}", comments.head);
                }
                text.push_str(&emit::module_text(design, module, self.resets(design), &comments));
            }
        }
        text.push_str("\n`default_nettype wire\n");
        text
    }

    /// Whether the design's top has the port [`RESET`] in this form.
    #[must_use]
    pub fn resets(&self, design: &Design) -> bool {
        self.reset && design.has_reset(design.top())
    }
}

/// What a module is: source, generics, constants, tied inputs.
fn header(module: &Module) -> String {
    let mut text = format!("// {}: {}", module.name, module.kind);
    if !module.generics.is_empty() {
        let _ = write!(text, " {}", module.generics);
    }
    text.push('\n');
    for parameter in &module.parameters {
        let role = if parameter.is_tied_input { "tied input" } else { "constant" };
        let value = constant::constant(parameter.value, parameter.width);
        let _ = writeln!(text, "//   {role} {} = {value}", plain(&parameter.name));
    }
    text
}

/// A file of an export.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GeneratedFile {
    /// File name, without folder.
    pub name: String,
    /// Contents.
    pub contents: String,
}

/// What [`package`] writes beside the Verilog.
#[derive(Clone, Debug)]
pub struct PackageOptions<'a> {
    /// What the top does, in one line.
    pub description: &'a str,
    /// More about it, in Markdown: sections of the README.
    pub notes: String,
    /// Clock period of the constraint in nanoseconds.
    pub period_ns: f64,
    /// What the Verilog has beyond the logic.
    pub form: Form<'a>,
    /// Whether it gets a stream of packed words.
    pub is_pipeline: bool,
    /// What holds of every valid result.
    pub claims: Vec<Claim>,
    /// What the values of the port `code_o` say, for the packed words; none where there is no such port.
    pub codes: Vec<ResultCode>,
}

/// A value of the port `code_o`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ResultCode {
    /// Its name.
    pub name: &'static str,
    /// The value.
    pub value: u8,
    /// What it says.
    pub meaning: &'static str,
}

impl Default for PackageOptions<'_> {
    /// No description, a clock of 1 ns, the default form.
    fn default() -> Self {
        Self {
            description: "",
            notes: String::new(),
            period_ns: 1.0,
            form: Form::default(),
            is_pipeline: false,
            claims: vec![],
            codes: vec![],
        }
    }
}

/// Everything about one top: `<top>.v`, `<top>_tb.v`, `<top>_vectors.hex`, `<top>.ys`, `<top>.sdc`, `<top>.md` and
/// `<top>.core`; `<top>_fpga.v` if it has a clock. With a reset, a top of one latency also has `<top>_checker.sv`, and a pipeline `<top>_stream.v`, `<top>_axis.v`,
/// `<top>_pkg.sv` and `<top>.h`. `stimulus` gives the values of all inputs for each cycle of the testbench.
///
/// # Errors
/// When the design has a combinational loop.
pub fn package(
    design: &Design,
    options: &PackageOptions,
    stimulus: &[Vec<u128>],
) -> Result<Vec<GeneratedFile>, ElaborateError> {
    let name = &design.top().name;
    let inventory = inventory(design)?;
    let start = testbench::Start::of(design, &options.form)?;
    let file = |suffix: &str, contents| GeneratedFile { name: format!("{name}{suffix}"), contents };
    let checker = match inventory.latency_cycles.filter(|_| options.form.resets(design)) {
        Some(latency) => checker::checker(design, latency, &options.claims),
        None => None,
    };
    let mut files = vec![
        file(".v", options.form.text(&[design], name)),
        file("_tb.v", testbench::testbench(design, &start, checker.as_ref(), stimulus.len() as u64)),
        file("_vectors.hex", testbench::vectors(design, &start, stimulus.iter().cloned())?),
        file(".ys", yosys(design)),
        file(".sdc", constraint(design, &options.form, options.period_ns)),
        file(".md", readme(design, &inventory, options)),
    ];
    if design.top().clock.is_some() {
        files.push(file(FPGA, flow::fpga_wrapper(design, &options.form)));
    }
    files.extend(checker.map(|checker| file(CHECKER, checker.text)));
    let payload = stream::Payload::of(design).filter(|_| options.form.resets(design) && options.is_pipeline);
    if let Some(payload) = payload {
        let words = fields::Words::of(&payload, &options.codes);
        files.extend([
            file(STREAM, stream::stream(design, &payload)),
            file(AXIS, stream::axis(design, &payload, &words)),
            file(PACKAGE, words.package(design)),
            file(HEADER, words.header(design)),
        ]);
    }
    files.push(file(".core", fusesoc_core(design, options.description, &files)));
    Ok(files)
}

/// Writes the files of an export into a folder, which is made if missing. Each file is written under a temporary name
/// and then renamed, so that a reader never sees half of one.
///
/// # Errors
/// When the folder or a file cannot be written; the message names it.
pub fn write_files(folder: &Path, files: &[GeneratedFile]) -> io::Result<Vec<PathBuf>> {
    let named = |path: &Path| {
        let path = path.display().to_string();
        move |error: io::Error| io::Error::new(error.kind(), format!("{path}: {error}"))
    };
    std::fs::create_dir_all(folder).map_err(named(folder))?;
    let mut written = Vec::with_capacity(files.len());
    for file in files {
        let path = folder.join(&file.name);
        let unfinished = folder.join(format!("{}.part", file.name));
        std::fs::write(&unfinished, &file.contents).map_err(named(&unfinished))?;
        std::fs::rename(&unfinished, &path).map_err(named(&path))?;
        written.push(path);
    }
    Ok(written)
}
