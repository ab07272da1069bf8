//! The hardware: floating-point units and traversal pipelines as synthesizable-style modules.

pub mod netlist;
