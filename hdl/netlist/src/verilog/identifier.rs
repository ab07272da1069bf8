//! Names in the emitted Verilog.
//!
//! Ports end in `_i` or `_o`, the clock is `clk_i`, the reset `rst_ni`; array positions and interface fields are joined by `_` before that.

use std::collections::BTreeSet;

use crate::{Module, is_keyword};

/// The clock port of every clocked module.
pub const CLOCK: &str = "clk_i";
/// The reset port of every module with valid bits, active low.
pub const RESET: &str = "rst_ni";

/// A name without the characters that Verilog would have to escape.
#[must_use]
pub fn plain(name: &str) -> String {
    name.chars().map(|c| if c.is_ascii_alphanumeric() || c == '_' { c } else { '_' }).collect()
}

/// A port's name in Verilog, with the direction's `suffix` once, at its end: `hit_o$3` is `hit_3_o`.
#[must_use]
pub fn port_name(name: &str, suffix: &str) -> String {
    let (stem, position) = name.split_at(name.find('$').unwrap_or(name.len()));
    let stem = stem.strip_suffix(suffix).unwrap_or(stem);
    plain(&format!("{stem}{position}{suffix}"))
}

/// Unique names of one module.
#[derive(Debug, Default)]
pub struct Namespace {
    taken: BTreeSet<String>,
}

impl Namespace {
    /// `wanted`, or `wanted_2`, `wanted_3`, ... if it is taken or reserved.
    pub fn claim(&mut self, wanted: &str) -> String {
        let mut name = wanted.to_owned();
        let mut count = 1;
        while is_keyword(&name) || !self.taken.insert(name.clone()) {
            count += 1;
            name = format!("{wanted}_{count}");
        }
        name
    }
}

/// The port names of a module, by position, without clock and reset.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PortNames {
    /// Names of the inputs.
    pub inputs: Vec<String>,
    /// Names of the outputs.
    pub outputs: Vec<String>,
}

/// The port names of a module; deterministic, so that parents and testbenches agree with the module itself.
pub fn port_names(module: &Module, namespace: &mut Namespace) -> PortNames {
    namespace.claim(CLOCK);
    namespace.claim(RESET);
    PortNames {
        inputs: module.inputs.iter().map(|port| namespace.claim(&port_name(&port.name, "_i"))).collect(),
        outputs: (module.outputs.iter())
            .map(|(port, _)| namespace.claim(&port_name(&port.name, "_o")))
            .collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_unique_and_never_reserved() {
        let mut namespace = Namespace::default();
        assert_eq!(namespace.claim("a"), "a");
        assert_eq!(namespace.claim("a"), "a_2");
        assert_eq!(namespace.claim("a"), "a_3");
        assert_eq!(namespace.claim("wire"), "wire_2");
        assert_eq!(port_name("lo$0", "_i"), "lo_0_i");
        assert_eq!(port_name("hit_o$3", "_o"), "hit_3_o");
        assert_eq!(port_name("hit_o$3", "_i"), "hit_o_3_i");
        assert_eq!(port_name("en_i", "_i"), "en_i");
    }
}
