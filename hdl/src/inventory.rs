//! What a design consists of, counted in its instantiated hierarchy.

use crate::module::{ModuleName, is_register};
use rust_hdl_core::prelude::*;
use std::collections::BTreeMap;

/// The kinds of module that the published tables count.
pub const UNIT_KINDS: [&str; 5] = ["int_add", "fp_add", "fp_mul", "fp_min_max", "fp_cmp"];

/// Counts of a hierarchy's parts.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Inventory {
    /// Instances by kind of module; the top itself is not counted.
    pub instances: BTreeMap<String, usize>,
    /// Registers, each of any width.
    pub registers: usize,
    /// Bits of all registers.
    pub register_bits: usize,
}

impl Inventory {
    /// Counts the parts of `top`.
    #[must_use]
    pub fn of(top: &dyn Block) -> Self {
        let mut census = Census::default();
        top.accept("top", &mut census);
        census.inventory
    }

    /// Instances of one kind.
    #[must_use]
    pub fn count(&self, kind: &str) -> usize {
        self.instances.get(kind).copied().unwrap_or(0)
    }

    /// Instances of the [`UNIT_KINDS`], in that order.
    #[must_use]
    pub fn units(&self) -> [usize; UNIT_KINDS.len()] {
        UNIT_KINDS.map(|kind| self.count(kind))
    }
}

/// Visits the hierarchy; a scope is open from its start to its end.
#[derive(Default)]
struct Census {
    inventory: Inventory,
    depth: usize,
    in_register: bool,
}

impl Probe for Census {
    fn visit_start_scope(&mut self, _name: &str, node: &dyn Block) {
        self.in_register = is_register(node);
        if self.in_register {
            self.inventory.registers += 1;
        } else if let (Some(module), true) = (ModuleName::of(node), self.depth > 0) {
            *self.inventory.instances.entry(module.kind).or_default() += 1;
        }
        self.depth += 1;
    }

    fn visit_atom(&mut self, _name: &str, signal: &dyn Atom) {
        // The one output of a register is its state.
        if self.in_register && signal.kind() == AtomKind::OutputParameter {
            self.inventory.register_bits += signal.bits();
        }
    }

    fn visit_end_scope(&mut self, _name: &str, _node: &dyn Block) {
        self.depth -= 1;
        self.in_register = false;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formats::binary32::{
        DualSplitPipeline, DualSplitPipelineLean, RayBoxPipeline, RayBoxPipelineLean, RayBoxX2, RayBoxX4,
        RayBoxX8, SharedUnits,
    };
    use crate::units::IntAdd;

    #[test]
    fn a_unit_counts_its_own_registers() {
        let inventory = Inventory::of(&IntAdd::<32, 4>::default());
        assert_eq!(
            inventory,
            Inventory { instances: BTreeMap::new(), registers: 3, register_bits: 32 + 4 + 1 }
        );
    }

    /// INTADD, FPADD, FPMUL, FPMIN/MAX, FPCMP as published (HPG 2020).
    #[test]
    fn pipelines_have_the_published_units() {
        let units = |top: &dyn Block| Inventory::of(top).units();
        assert_eq!(units(&DualSplitPipeline::default()), [1, 2, 2, 3, 4]);
        assert_eq!(units(&RayBoxPipeline::default()), [0, 6, 6, 12, 2]);
    }

    #[test]
    fn parallel_and_shared_forms_have_the_units_of_their_parts() {
        let units = |top: &dyn Block| Inventory::of(top).units();
        assert_eq!(units(&RayBoxX2::default()), [0, 12, 12, 24, 4]);
        assert_eq!(units(&RayBoxX4::default()), [0, 24, 24, 48, 8]);
        assert_eq!(units(&RayBoxX8::default()), [0, 48, 48, 96, 16]);
        assert_eq!(units(&SharedUnits::default()), [1, 8, 8, 12 + 3, 2 + 4]);
    }

    #[test]
    fn lean_pipelines_have_fewer_comparators_and_nothing_else_less() {
        let units = |top: &dyn Block| Inventory::of(top).units();
        assert_eq!(units(&DualSplitPipelineLean::default()), [1, 2, 2, 3, 2]);
        assert_eq!(units(&RayBoxPipelineLean::default()), [0, 6, 6, 12, 1]);
    }
}
