//! Exported Verilog as gates: read by yosys, an elaborator that shares nothing with ours, and written as AIGER.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::{Command, Stdio};

use netlist::verilog::{plain, port_name, text};
use netlist::{Design, ElaborateError, flatten};

use super::miter::{Miter, MiterError};
use crate::aig::Aig;
use crate::aiger::{self, AigerError};
use crate::blast::{ARRAYS, Options, blast};
use crate::words::{Adder, Multiplier, Structures};

/// Why exported Verilog cannot be compared.
#[derive(Debug, thiserror::Error)]
pub enum VerilogError {
    /// The design does not elaborate.
    #[error(transparent)]
    Elaborate(#[from] ElaborateError),
    /// The tool cannot be run.
    #[error("yosys: {0}; install yosys 0.23 or later, or leave out what needs it")]
    Missing(std::io::Error),
    /// A file cannot be written or read.
    #[error("{path}: {source}", path = .path.display())]
    File {
        /// The file.
        path: std::path::PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
    /// The tool does not accept the Verilog.
    #[error("yosys refuses the exported Verilog of {top}: {message}")]
    Refused {
        /// The design.
        top: String,
        /// The end of its log.
        message: String,
    },
    /// The tool's file is no AIGER.
    #[error(transparent)]
    Aiger(#[from] AigerError),
    /// Ports or registers do not correspond.
    #[error(transparent)]
    Miter(#[from] MiterError),
}

/// The exported Verilog of a design beside our own gates, paired by the names of ports and registers. Both sides
/// leave multiplier arrays out: the miter compares their operands, and their products are free. Files go into
/// `folder`.
///
/// # Errors
/// [`VerilogError`] when yosys is missing or refuses, or names do not correspond.
pub fn exported(design: &Design, folder: &Path) -> Result<Miter, VerilogError> {
    compared(design, &text(design), folder)
}

/// [`exported`] with another source in the place of the design's own Verilog.
///
/// # Errors
/// Likewise.
pub fn compared(design: &Design, source: &str, folder: &Path) -> Result<Miter, VerilogError> {
    let flat = flatten(design)?;
    let options = Options {
        structures: Structures {
            adder: Adder::BrentKung,
            multiplier: Multiplier::Tree,
            ..Structures::default()
        },
        cuts: ARRAYS,
        keep_units: false,
    };
    let mut own = blast(design, &flat, options).aig;
    rename(&mut own, verilog_name);
    if let Some(clock) = &design.top().clock {
        // An input that no gate reads.
        own.add_input(plain(clock));
    }
    let known: BTreeSet<String> = own.latches().iter().map(|latch| latch.name.clone()).collect();
    let mut read = synthesise(design, source, folder)?;
    // yosys lists all names of a net; one of them is the register's.
    rename(&mut read, |names, _| {
        let mut aliases = names.split(' ');
        let first = aliases.clone().next().unwrap_or_default();
        aliases.find(|alias| known.contains(*alias)).unwrap_or(first).to_owned()
    });
    Ok(Miter::new(&own, &read)?)
}

/// One of our names as the Verilog has it, with the brackets of a bit and the dots of the hierarchy kept. Ports of
/// the top, which have no path, end in `suffix`.
fn verilog_name(name: &str, suffix: &str) -> String {
    let (word, bit) = match name.strip_suffix(']').and_then(|name| name.rsplit_once('[')) {
        Some((word, bit)) => (word, format!("[{bit}]")),
        None => (name, String::new()),
    };
    let word = if suffix.is_empty() || word.contains('.') {
        word.split('.').map(plain).collect::<Vec<_>>().join(".")
    } else {
        port_name(word, suffix)
    };
    format!("{word}{bit}")
}

/// Renames everything: `name` gets the old name, and the suffix of ports of its kind.
fn rename(aig: &mut Aig, name: impl Fn(&str, &str) -> String) {
    for position in 0..aig.inputs().len() {
        let new = name(&aig.inputs()[position].name, "_i");
        aig.rename_input(position, &new);
    }
    for position in 0..aig.latches().len() {
        let new = name(&aig.latches()[position].name, "");
        aig.rename_latch(position, &new);
    }
    for output in &mut aig.outputs {
        output.name = name(&output.name, "_o");
    }
}

fn synthesise(design: &Design, source: &str, folder: &Path) -> Result<Aig, VerilogError> {
    let top = &design.top().name;
    let (verilog, gates) = (format!("{top}.v"), format!("{top}.aig"));
    let path = folder.join(&verilog);
    std::fs::write(&path, source).map_err(|source| VerilogError::File { path, source })?;
    let arrays: Vec<&str> = (design.modules.iter())
        .filter(|module| ARRAYS.iter().any(|cut| cut.kind == module.kind))
        .map(|module| module.name.as_str())
        .collect();
    let mut script = format!("read_verilog {verilog}; hierarchy -top {top}; proc; ");
    for array in &arrays {
        script += &format!("setattr -mod -set blackbox 1 {array}; ");
    }
    script += &format!("flatten; hierarchy -top {top}; ");
    for array in &arrays {
        script += &format!("expose -evert {top}/t:{array}; ");
    }
    script +=
        &format!("techmap; dfflegalize -cell $_DFF_P_ 01; aigmap; opt_clean; write_aiger -symbols {gates}");
    let output = Command::new("yosys")
        .args(["-q", "-p", &script])
        .current_dir(folder)
        .stdin(Stdio::null())
        .output()
        .map_err(VerilogError::Missing)?;
    if !output.status.success() {
        let log = String::from_utf8_lossy(&output.stderr).into_owned();
        let message = log.lines().rev().find(|line| !line.is_empty()).unwrap_or("no message").to_owned();
        return Err(VerilogError::Refused { top: top.clone(), message });
    }
    let path = folder.join(gates);
    let bytes = std::fs::read(&path).map_err(|source| VerilogError::File { path, source })?;
    Ok(aiger::read(&bytes)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_of_the_export() {
        assert_eq!(verilog_name("a_i[3]", "_i"), "a_i[3]");
        assert_eq!(verilog_name("box_min_x_i$1[3]", "_i"), "box_min_x_1_i[3]");
        assert_eq!(verilog_name("hit_o$0", "_o"), "hit_0_o");
        assert_eq!(verilog_name("lane$0.mul$1.product_o[47]", "_i"), "lane_0.mul_1.product_o[47]");
        assert_eq!(verilog_name("valid_1", ""), "valid_1");
    }
}
