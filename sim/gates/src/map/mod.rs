//! Mapping of gates to the cells of a library, for area, or for area within a delay.
//!
//! The mapper enumerates cuts of up to six leaves for every AND, and looks their functions up among the library's
//! cells, with inputs permuted and complemented. Area flow chooses a first cover. The exact area that each choice
//! adds refines it (Mishchenko, Cho, Chatterjee, Brayton, "Combinational and Sequential Mapping with Priority Cuts",
//! ICCAD 2007). The mapper covers both polarities of a node separately; an inverter is one way to get the other. Cuts
//! do not cross regions.
//!
//! Within a delay, the fastest cover comes first. Every later choice has to arrive when its users need it. Before cells have
//! sizes and loads, a cell's delay is estimated by the load that suits it (see [`Patterns`]).

mod attribute;
mod cover;
pub(crate) mod cuts;
pub(crate) mod netlist;
mod patterns;
mod verilog;

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
    map_to(aig, library, None)
}

/// Maps a graph for delay: the smallest cover found whose estimated longest path is at most `slower`, a fraction, above that of
/// the fastest cover.
///
/// # Errors
/// As [`map`].
pub fn map_fast(aig: &Aig, library: &Library, slower: f64) -> Result<Mapped, MapError> {
    map_to(aig, library, Some(slower as f32))
}

fn map_to(aig: &Aig, library: &Library, slower: Option<f32>) -> Result<Mapped, MapError> {
    let patterns = Patterns::new(library);
    let cuts = cuts::enumerate(aig, &patterns);
    let cover = cover::Cover::new(aig, library, &patterns, cuts, slower)?;
    netlist::build(aig, library, &cover)
}
