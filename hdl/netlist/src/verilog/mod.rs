//! Verilog-2005 from the elaborated design, with everything that another engineer needs to use it.
//!
//! [`text`] is one file per top: each module once, children first, names of the source kept, width-exact.
//! [`package`] adds testbench, vectors, yosys script, constraint, FuseSoC core and a README. rust-hdl's own export
//! serves as a cross-check: [`cross_check`].

mod constant;
pub mod cross_check;
mod emit;
mod expression;
mod identifier;
mod meaning;
mod readme;
mod scripts;
pub mod testbench;

use std::fmt::Write;
use std::io;
use std::path::{Path, PathBuf};

pub use identifier::{Namespace, PortNames, plain, port_name, port_names};
pub use readme::readme;
pub use scripts::{constraint, fusesoc_core, yosys};

use crate::{Design, ElaborateError, Module, inventory};

/// The design as one Verilog-2005 file. Deterministic; ASCII.
#[must_use]
pub fn text(design: &Design) -> String {
    let top = design.top();
    let mut text = format!(
        "// {}: written by dualsplit {} from the rust-hdl source; do not edit.\n\
         // Verilog-2005. One clock, rising edge, no reset: registers start at their initial value.\n\
         `default_nettype none\n",
        top.name,
        env!("CARGO_PKG_VERSION")
    );
    if design.modules.len() > 1 {
        text.push_str(
            "// One file holds the whole hierarchy of its top:\n// verilator lint_off DECLFILENAME\n",
        );
    }
    for module in &design.modules {
        text.push('\n');
        text.push_str(&header(module));
        text.push_str(&emit::module_text(design, module));
    }
    text.push_str("\n`default_nettype wire\n");
    text
}

/// What a module is: source, generics, constants, tied inputs.
fn header(module: &Module) -> String {
    let mut text = format!("// {}", module.kind);
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
#[derive(Clone, Copy, Debug)]
pub struct PackageOptions<'a> {
    /// What the top does, in Markdown: the first paragraphs of the README.
    pub description: &'a str,
    /// Clock period of the constraint in nanoseconds.
    pub period_ns: f64,
}

/// Everything about one top: `<top>.v`, `<top>_tb.v`, `<top>_vectors.hex`, `<top>.ys`, `<top>.sdc`, `<top>.core` and
/// `<top>.md`. `stimulus` gives the values of all inputs for each cycle of the testbench.
///
/// # Errors
/// When the design has a combinational loop.
pub fn package(
    design: &Design,
    options: &PackageOptions,
    stimulus: &[Vec<u128>],
) -> Result<Vec<GeneratedFile>, ElaborateError> {
    let name = &design.top().name;
    let file = |suffix: &str, contents| GeneratedFile { name: format!("{name}{suffix}"), contents };
    Ok(vec![
        file(".v", text(design)),
        file("_tb.v", testbench::testbench(design, stimulus.len() as u64)),
        file("_vectors.hex", testbench::vectors(design, stimulus.iter().cloned())?),
        file(".ys", yosys(design)),
        file(".sdc", constraint(design, options.period_ns)),
        file(".core", fusesoc_core(design)),
        file(".md", readme(design, &inventory(design)?, options.description)),
    ])
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
