//! What a pipeline takes of a multiprocessor's units.

use super::description::check::out_of_range;
use super::description::{DescriptionError, MachineDescription};
use costs::Pipeline;

/// Takes the units of `pipeline` out of those of `machine`. Of a parallel pipeline, it takes those of the `single` one in its place:
/// the others are added to the machine with it.
///
/// # Errors
/// If a multiprocessor has not enough of them, or none would be left for the rest of the program.
pub fn take_units(
    pipeline: &Pipeline,
    single: Option<&Pipeline>,
    machine: &mut MachineDescription,
) -> Result<(), DescriptionError> {
    let mut left = machine.units;
    for (&unit, &count) in &pipeline.units {
        let taken = single.map_or(count, |single| single.units.get(&unit).copied().unwrap_or(0));
        let pool = left.pool_mut(unit);
        if pool.count <= taken {
            let key = format!("units.{}.count", unit.name());
            let rule = format!("the pipeline {} takes {taken}, and one has to be left", pipeline.name);
            return Err(out_of_range(key, pool.count, rule));
        }
        pool.count -= taken;
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
        take_units(&ray_box, None, &mut machine).unwrap();
        let left = |unit| machine.units.pool(unit).count;
        assert_eq!((left(Unit::FpAdd), left(Unit::FpMul), left(Unit::FpMinMax)), (2, 2, 4));
        let mut small = MachineDescription::load("trax", &["units.fp_mul.count=6".to_owned()]).unwrap();
        let error = take_units(&ray_box, None, &mut small).unwrap_err().to_string();
        assert!(error.contains("units.fp_mul.count = 6") && error.contains("ray_box"), "{error}");
        let dual_split = pipeline("dual_split", [(Unit::FpAdd, 2), (Unit::FpMul, 2), (Unit::FpMinMax, 3)]);
        let mut small = MachineDescription::load("trax", &["units.fp_mul.count=6".to_owned()]).unwrap();
        take_units(&dual_split, None, &mut small).unwrap();
        assert_eq!(small.units.fp_mul.count, 4);
        // Of eight boxes at once: those of one come from the machine, and the error names what the machine was given.
        let parallel = pipeline("ray_box_x8", [(Unit::FpAdd, 48), (Unit::FpMul, 48), (Unit::FpMinMax, 96)]);
        let mut machine = MachineDescription::load("trax", &[]).unwrap();
        take_units(&parallel, Some(&ray_box), &mut machine).unwrap();
        assert_eq!((machine.units.fp_add.count, machine.units.fp_min_max.count), (2, 4));
        let mut small = MachineDescription::load("trax", &["units.fp_add.count=4".to_owned()]).unwrap();
        let error = take_units(&parallel, Some(&ray_box), &mut small).unwrap_err().to_string();
        assert!(error.contains("units.fp_add.count = 4") && error.contains("takes 6"), "{error}");
    }
}
