//! The ray-box and dual-split pipelines as the hardware has them: units and latency of the elaborated RTL.

use super::description::check::{out_of_range, unit_key};
use super::description::{DescriptionError, MachineDescription};
use crate::estimate::{Method, PipelineCost, pipeline_cost};
use crate::unit_costs::Unit;
use hdl::catalogue::{StandardFormat, Top};
use hdl::netlist::inventory;
use std::collections::BTreeMap;

/// A pipeline of a multiprocessor: one operation a cycle, shared by its threads, configured for the whole run.
#[derive(Clone, Debug, PartialEq)]
pub struct Pipeline {
    /// The module.
    pub top: Top,
    /// Units that it consists of.
    pub units: BTreeMap<Unit, u32>,
    /// Cycles from operands to results.
    pub latency_cycles: u32,
    /// Area and energy of an operation.
    pub cost: PipelineCost,
}

impl Pipeline {
    /// The pipeline `top` in single precision, its cost found by `method`.
    ///
    /// # Panics
    /// If `top` cannot be elaborated or has paths of different latency, which the hardware's own tests rule out.
    #[must_use]
    pub fn new(top: Top, method: Method) -> Self {
        let design = top.design(StandardFormat::Binary32).expect("the catalogue's modules elaborate");
        let inventory = inventory(&design).expect("the pipelines have no combinational loop");
        let mut units = BTreeMap::new();
        for (kind, &count) in &inventory.units {
            if let Some(unit) = Unit::of_module(kind) {
                *units.entry(unit).or_default() += count;
            }
        }
        Self {
            top,
            units,
            latency_cycles: inventory.latency_cycles.expect("a pipeline has one latency"),
            cost: pipeline_cost(top, method).expect("the catalogue's modules elaborate"),
        }
    }

    /// Adds the units that this pipeline has beyond those of `single` to `machine`.
    pub fn add_units_beyond(&self, single: &Self, machine: &mut MachineDescription) {
        for (&unit, &count) in &self.units {
            machine.units.pool_mut(unit).count += count - single.units.get(&unit).copied().unwrap_or(0);
        }
    }

    /// Takes the pipeline's units out of those of `machine`.
    ///
    /// # Errors
    /// If a multiprocessor has not enough of them, or none would be left for the rest of the program.
    pub fn take_units(&self, machine: &mut MachineDescription) -> Result<(), DescriptionError> {
        let mut left = machine.units;
        for (&unit, &count) in &self.units {
            let pool = left.pool_mut(unit);
            if pool.count <= count {
                let key = format!("units.{}.count", unit_key(unit));
                let rule = format!("the pipeline {} takes {count}, and one has to be left", self.top);
                return Err(out_of_range(key, pool.count, rule));
            }
            pool.count -= count;
        }
        machine.units = left;
        Ok(())
    }

    /// Area of its units in square micrometres, as published.
    #[must_use]
    pub fn unit_area_um2(&self) -> f64 {
        self.units.iter().map(|(unit, count)| f64::from(*count) * unit.published().area_um2).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_taken_from_the_machine() {
        let mut machine = MachineDescription::load("trax", &[]).unwrap();
        Pipeline::new(Top::RayBox, Method::Published).take_units(&mut machine).unwrap();
        let left = |unit| machine.units.pool(unit).count;
        assert_eq!((left(Unit::FpAdd), left(Unit::FpMul), left(Unit::FpMinMax)), (2, 2, 4));
        let mut small = MachineDescription::load("trax", &["units.fp_mul.count=6".to_owned()]).unwrap();
        let error =
            Pipeline::new(Top::RayBox, Method::Published).take_units(&mut small).unwrap_err().to_string();
        assert!(error.contains("units.fp_mul.count = 6") && error.contains("ray_box"), "{error}");
        let dual_split = Pipeline::new(Top::DualSplit, Method::Published);
        let mut small = MachineDescription::load("trax", &["units.fp_mul.count=6".to_owned()]).unwrap();
        dual_split.take_units(&mut small).unwrap();
        assert_eq!(small.units.fp_mul.count, 4);
        assert_eq!(dual_split.latency_cycles, 8);
    }
}
