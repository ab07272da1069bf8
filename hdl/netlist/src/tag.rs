//! Tags of any width, from a source with tags of one bit.
//!
//! A tag passes through a pipeline unread. Its width is a generic of the source, which Rust compiles anew for each value. The
//! elaborated instance tree can have it changed instead: what carries a tag is known by its name, and literals take the width of
//! what they are assigned to.

use rust_hdl_core::prelude::Block;

use super::error::{ElaborateError, ErrorKind};
use super::probe::Scope;
use super::{Design, elaborate_scope, lower, probe};

/// Elaborates a module as [`elaborate`](super::elaborate) does, with tags of `bits` bits. A tag is a port called `tag_i`, `tag_o`, or so
/// with another word before it, a register called `tag` or `tag_1`, and whatever a delay line called `tag` holds.
///
/// # Errors
/// As `elaborate`.
pub fn elaborate_with_tag(module: &dyn Block, name: &str, bits: usize) -> Result<Design, ElaborateError> {
    let mut scope = probe::read(module, name)
        .ok_or_else(|| lower::at_module(name, ErrorKind::NotUnderstood("a module without scope".into())))?;
    widen(&mut scope, bits);
    elaborate_scope(&scope, name)
}

fn widen(scope: &mut Scope, bits: usize) {
    for atom in scope.atoms.iter_mut().filter(|atom| is_tag(&atom.name)) {
        atom.width = bits;
    }
    // The value of the generic, as the module tells it.
    if let Some(timing) = &mut scope.timing
        && let Some((rest, width)) = timing.name.rsplit_once("_t")
        && width.parse::<u32>().is_ok()
    {
        timing.name = format!("{rest}_t{bits}");
    }
    for child in &mut scope.children {
        if is_tag(&child.name) { widen_all(child, bits) } else { widen(child, bits) }
    }
}

/// Widens everything in a register or a delay line of tags but its clock and enable.
fn widen_all(scope: &mut Scope, bits: usize) {
    let data = scope.atoms.iter_mut().filter(|atom| !atom.is_clock && !atom.name.ends_with("en_i"));
    data.for_each(|atom| atom.width = bits);
    if let Some(timing) = &mut scope.timing
        && let Some((kind, stages)) = timing.name.split_once(" w1_")
    {
        timing.name = format!("{kind} w{bits}_{stages}");
    }
    scope.children.iter_mut().for_each(|child| widen_all(child, bits));
}

fn is_tag(name: &str) -> bool {
    let stem = name.split('$').find(|part| part.contains("tag")).unwrap_or_default();
    let stem = stem.trim_end_matches(|c: char| c.is_ascii_digit());
    let stem = ["_i", "_o", "_"].iter().find_map(|end| stem.strip_suffix(end)).unwrap_or(stem);
    stem == "tag" || stem.ends_with("_tag")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tags_are_known_by_name() {
        for name in ["tag", "tag_1", "tag_i", "tag_o", "add_tag_i$3", "mul_tag_o$0"] {
            assert!(is_tag(name), "{name}");
        }
        for name in ["stage", "stage$0", "tagged_i", "advantage_o", "valid", "en_i"] {
            assert!(!is_tag(name), "{name}");
        }
    }
}
