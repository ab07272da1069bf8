//! Standard-cell libraries: from liberty files, plain or gzip-compressed, or the embedded one.
//!
//! The reader keeps what mapping, timing and energy need: combinational cells of one output and up to six inputs, the
//! smallest rising-edge D flip-flop, the smallest latch-based clock gate, tables of delay, transition time and
//! internal energy. Units are nanoseconds, femtofarads, femtojoules, square micrometres and nanowatts, whatever the
//! units of the file.

mod attributes;
mod embedded;
pub mod function;
mod read;
mod sequential;
mod sound;
mod syntax;
mod table;

use base::input::{at_most, open, unpacked};
use std::io::BufReader;
use std::path::{Path, PathBuf};

pub use embedded::embedded;
pub use read::read;
pub use table::Table;

/// Why a file is no usable library.
#[derive(Debug, thiserror::Error)]
pub enum LibertyError {
    /// The file cannot be read.
    #[error("{path}: {source}; name a liberty file, .lib or .lib.gz", path = .path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
    /// It is not liberty.
    #[error("line {line}: {what}; give a liberty file with NLDM tables")]
    Syntax {
        /// The line.
        line: usize,
        /// What is wrong.
        what: String,
    },
    /// Something is wrong inside a file.
    #[error("{path}: {error}", path = .path.display())]
    In {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        error: Box<LibertyError>,
    },
    /// A cell that every netlist needs is missing.
    #[error(
        "{files}: the library has no {what}; add the file that has it (--liberty may be given several times)"
    )]
    Missing {
        /// The cell.
        what: &'static str,
        /// The files that were read.
        files: String,
    },
    /// Files of one library differ in what they should share.
    #[error("{0} differs between the files: give files of one library and corner")]
    Mixed(&'static str),
}

/// A combinational cell.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// Name in the library.
    pub name: String,
    /// Area.
    pub area_um2: f64,
    /// Leakage power.
    pub leakage_nw: f64,
    /// Names of the inputs, in alphabetical order: the variables of the function.
    pub inputs: Vec<String>,
    /// Capacitance of each input.
    pub capacitance_ff: Vec<f64>,
    /// Name of the output.
    pub output: String,
    /// Truth table of the output.
    pub function: u64,
    /// Largest load; infinite if the library does not say.
    pub max_load_ff: f64,
    /// For each input, the delay and energy of a change of the output.
    pub arcs: Vec<Arc>,
}

/// From a change of an input, or of the clock, to one of the output.
#[derive(Clone, Debug, PartialEq)]
pub struct Arc {
    /// Delay until the output rises, and falls.
    pub delay_ns: [Table; 2],
    /// Transition time of the rising, and of the falling output.
    pub transition_ns: [Table; 2],
    /// Energy inside the cell when the output rises, and falls, without that of the load.
    pub energy_fj: [Table; 2],
    /// Which input change makes the output rise.
    pub sense: Sense,
}

/// Which edge of an input makes which edge of the output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sense {
    /// The output rises with the input.
    Positive,
    /// The output rises when the input falls.
    Negative,
    /// Either may happen.
    Both,
}

/// A D flip-flop that takes its value at the rising clock edge.
#[derive(Clone, Debug, PartialEq)]
pub struct FlipFlop {
    /// Name in the library.
    pub name: String,
    /// Area.
    pub area_um2: f64,
    /// Leakage power.
    pub leakage_nw: f64,
    /// Name of the data input.
    pub data: String,
    /// Name of the clock input.
    pub clock: String,
    /// Name of the output.
    pub output: String,
    /// Capacitance of the data input.
    pub data_ff: f64,
    /// Capacitance of the clock input.
    pub clock_ff: f64,
    /// From clock to output; its energies are those of an output change.
    pub arc: Arc,
    /// Energy of a clock cycle in which the output stays, inside the cell.
    pub clock_energy_fj: f64,
    /// Time by which the data has to come before the clock edge.
    pub setup_ns: f64,
}

/// A cell that stops a clock: a latch and a gate.
#[derive(Clone, Debug, PartialEq)]
pub struct ClockGate {
    /// Name in the library.
    pub name: String,
    /// Area.
    pub area_um2: f64,
    /// Leakage power.
    pub leakage_nw: f64,
    /// Capacitance of the clock input.
    pub clock_ff: f64,
    /// Capacitance of the enable input.
    pub enable_ff: f64,
    /// Energy of a clock cycle, inside the cell, with the clock passed.
    pub clock_energy_fj: f64,
    /// Largest load.
    pub max_load_ff: f64,
}

/// Cells of one technology and corner.
#[derive(Clone, Debug, PartialEq)]
pub struct Library {
    /// Name in the file.
    pub name: String,
    /// Where its numbers come from.
    pub source: String,
    /// Feature size in nanometres, where known.
    pub node_nm: Option<u32>,
    /// Supply voltage.
    pub voltage_v: f64,
    /// Combinational cells that netlists may use.
    pub cells: Vec<Cell>,
    /// The flip-flop.
    pub flip_flop: FlipFlop,
    /// The clock gate, if there is one.
    pub clock_gate: Option<ClockGate>,
    /// The cell that gives a constant 0, and 1: name and area.
    pub ties: [Option<(String, f64)>; 2],
}

impl Library {
    /// The smallest cell with a function, its inputs in order.
    #[must_use]
    pub fn smallest(&self, inputs: usize, function: u64) -> Option<usize> {
        let with_function =
            |&i: &usize| self.cells[i].inputs.len() == inputs && self.cells[i].function == function;
        let cells = (0..self.cells.len()).filter(with_function);
        cells.min_by(|&a, &b| self.cells[a].area_um2.total_cmp(&self.cells[b].area_um2))
    }

    /// The smallest inverter.
    ///
    /// # Panics
    /// Never: reading a library without inverter is an error.
    #[must_use]
    pub fn inverter(&self) -> usize {
        self.smallest(1, !function::variable(0)).expect("every library read has an inverter")
    }

    /// The smallest two-input NAND gate: one gate equivalent.
    ///
    /// # Panics
    /// Never: reading a library without one is an error.
    #[must_use]
    pub fn nand2(&self) -> usize {
        self.smallest(2, !(function::variable(0) & function::variable(1)))
            .expect("every library read has a NAND")
    }

    /// The area of a two-input NAND gate.
    #[must_use]
    pub fn gate_equivalent_um2(&self) -> f64 {
        self.cells[self.nand2()].area_um2
    }
}

/// Reads the files of a library, each plain or gzip-compressed.
///
/// # Errors
/// [`LibertyError`] when a file is no liberty, or the files together lack inverter, NAND gate or flip-flop.
pub fn load(paths: &[PathBuf]) -> Result<Library, LibertyError> {
    let texts: Result<Vec<String>, LibertyError> = paths.iter().map(|path| file_text(path)).collect();
    let named: Vec<(&Path, String)> = paths.iter().map(PathBuf::as_path).zip(texts?).collect();
    read(&named)
}

/// Most bytes of a liberty file, unpacked. Open libraries have up to 40 MiB.
const MOST_BYTES: u64 = 1 << 30;

/// The text of a file, plain or compressed.
///
/// # Errors
/// [`LibertyError::File`] when it cannot be read.
pub fn file_text(path: &Path) -> Result<String, LibertyError> {
    let read = || at_most(unpacked(BufReader::new(open(path)?))?, MOST_BYTES);
    let bytes = read().map_err(|source| LibertyError::File { path: path.to_owned(), source })?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
