//! An area or an energy, divided among the parts of a pipeline.

use std::collections::BTreeMap;

use serde::Serialize;

use costs::Unit;

/// Area in square micrometres, or energy of an operation in femtojoules.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Breakdown {
    /// Combinational gates of the execution units, by unit.
    pub units: BTreeMap<Unit, f64>,
    /// Combinational gates between them.
    pub glue: f64,
    /// Flip-flops. Their energy is that of the changes of their outputs.
    pub registers: f64,
    /// Clock gates. Their energy is that of a clock cycle without a change.
    pub clock: f64,
    /// Nets of the inputs, which a driver outside the pipeline charges. They have no area.
    pub inputs: f64,
}

impl Breakdown {
    /// All units.
    #[must_use]
    pub fn all_units(&self) -> f64 {
        self.units.values().sum()
    }

    /// Units and glue: the parts that the published sums cover.
    #[must_use]
    pub fn logic(&self) -> f64 {
        self.all_units() + self.glue
    }

    /// The sum of all parts.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.logic() + self.registers + self.clock + self.inputs
    }

    /// All parts times a factor.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        Self {
            units: self.units.iter().map(|(&unit, value)| (unit, value * factor)).collect(),
            glue: self.glue * factor,
            registers: self.registers * factor,
            clock: self.clock * factor,
            inputs: self.inputs * factor,
        }
    }
}
