//! What the codes on the pipelines' ports mean, in words, for waveforms and listings.

use golden::dst::header::{AXIS, CARVE, LEAF, SINGLE};
use netlist::wave::Decode;

/// The type of the node with this header.
#[must_use]
pub fn node_type(header: u128) -> &'static str {
    let header = header as u32;
    match (CARVE.get(header) == 1, LEAF.get(header) == 1, AXIS.get(header)) {
        (false, true, _) => "bare_leaf",
        (false, false, 0) => "split_x",
        (false, false, 1) => "split_y",
        (false, false, _) => "split_z",
        (true, false, SINGLE) => "single_carve",
        (true, false, _) => "dual_carve",
        (true, true, SINGLE) => "single_carve_leaf",
        (true, true, _) => "dual_carve_leaf",
    }
}

/// The dual-split pipeline's return value.
#[must_use]
pub fn return_value(code: u128) -> &'static str {
    ["miss", "one_child", "two_children", "leaf"][(code & 3) as usize]
}

/// What the shared block's units are routed into.
#[must_use]
pub fn routing(mode: u128) -> &'static str {
    ["threads", "ray_box", "dual_split", "reserved"][(mode & 3) as usize]
}

/// What the values of the signal with this name mean, if they are codes.
#[must_use]
pub fn decoder(name: &str) -> Option<Decode> {
    match name {
        "mode_i" => Some(routing),
        "header_i" | "header_o" => Some(node_type),
        "code_o" => Some(return_value),
        _ => None,
    }
}
