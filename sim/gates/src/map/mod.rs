//! Mapping of gates to the cells of a library, for area.
//!
//! The mapper enumerates cuts of up to six leaves for every AND, and looks their functions up among the library's
//! cells, with inputs permuted and complemented. Area flow chooses a first cover. The exact area that each choice
//! adds refines it (Mishchenko, Cho, Chatterjee, Brayton, "Combinational and Sequential Mapping with Priority Cuts",
//! ICCAD 2007). The mapper covers both polarities of a node separately; an inverter is one way to get the other. Cuts
//! do not cross regions.

mod cover;
mod cuts;
mod netlist;
mod patterns;

pub use netlist::{ClockGating, Gate, Mapped, Register};
pub use patterns::Patterns;

use super::aig::Aig;
use super::liberty::Library;

/// Why a graph cannot be mapped.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MapError {
    /// No cell covers a node.
    #[error(
        "library {library} has no cell for node {node}: it lacks gates of two inputs; add the file that has them"
    )]
    Uncovered {
        /// The library.
        library: String,
        /// The node.
        node: usize,
    },
    /// A constant is needed that no cell gives.
    #[error("library {library} has no cell that gives a constant {value}; add the file that has it")]
    NoTie {
        /// The library.
        library: String,
        /// The constant.
        value: u8,
    },
}

/// Maps a graph: every output, and data and enable of every latch.
///
/// # Errors
/// [`MapError`] when the library lacks a cell; nothing is left out silently.
pub fn map(aig: &Aig, library: &Library) -> Result<Mapped, MapError> {
    let patterns = Patterns::new(library);
    let cuts = cuts::enumerate(aig, &patterns);
    let cover = cover::Cover::new(aig, library, &patterns, cuts)?;
    netlist::build(aig, library, &cover)
}
