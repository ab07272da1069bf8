//! What a pipeline takes of a multiprocessor's units.

use super::description::check::out_of_range;
use super::description::{DescriptionError, MachineDescription};
use costs::Pipeline;

/// Adds the units that `pipeline` has beyond those of `single` to `machine`.
pub fn add_units_beyond(pipeline: &Pipeline, single: &Pipeline, machine: &mut MachineDescription) {
    for (&unit, &count) in &pipeline.units {
        machine.units.pool_mut(unit).count += count - single.units.get(&unit).copied().unwrap_or(0);
    }
}

/// Takes the pipeline's units out of those of `machine`.
///
/// # Errors
/// If a multiprocessor has not enough of them, or none would be left for the rest of the program.
pub fn take_units(pipeline: &Pipeline, machine: &mut MachineDescription) -> Result<(), DescriptionError> {
    let mut left = machine.units;
    for (&unit, &count) in &pipeline.units {
        let pool = left.pool_mut(unit);
        if pool.count <= count {
            let key = format!("units.{}.count", unit.name());
            let rule = format!("the pipeline {} takes {count}, and one has to be left", pipeline.name);
            return Err(out_of_range(key, pool.count, rule));
        }
        pool.count -= count;
    }
    machine.units = left;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use costs::{PipelineCost, Unit};

    fn pipeline(name: &str, units: [(Unit, u32); 3]) -> Pipeline {
        let cost = PipelineCost {
            area_um2: 0.0,
            energy_pj: 0.0,
            glue_area_um2: 0.0,
            glue_energy_pj: 0.0,
            source: String::new(),
        };
        Pipeline { name: name.into(), units: units.into(), latency_cycles: 8, cost }
    }

    #[test]
    fn units_are_taken_from_the_machine() {
        let ray_box = pipeline("ray_box", [(Unit::FpAdd, 6), (Unit::FpMul, 6), (Unit::FpMinMax, 12)]);
        let mut machine = MachineDescription::load("trax", &[]).unwrap();
        take_units(&ray_box, &mut machine).unwrap();
        let left = |unit| machine.units.pool(unit).count;
        assert_eq!((left(Unit::FpAdd), left(Unit::FpMul), left(Unit::FpMinMax)), (2, 2, 4));
        let mut small = MachineDescription::load("trax", &["units.fp_mul.count=6".to_owned()]).unwrap();
        let error = take_units(&ray_box, &mut small).unwrap_err().to_string();
        assert!(error.contains("units.fp_mul.count = 6") && error.contains("ray_box"), "{error}");
        let dual_split = pipeline("dual_split", [(Unit::FpAdd, 2), (Unit::FpMul, 2), (Unit::FpMinMax, 3)]);
        let mut small = MachineDescription::load("trax", &["units.fp_mul.count=6".to_owned()]).unwrap();
        take_units(&dual_split, &mut small).unwrap();
        assert_eq!(small.units.fp_mul.count, 4);
    }
}
