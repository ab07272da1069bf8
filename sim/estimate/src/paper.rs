//! The figures of Lin, Vasiou, Yuksel, Kopta, Brunvand, "Hardware-Accelerated Dual-Split Trees", HPG 2020: 65 nm, 1 GHz.

use netlist::{Design, ElaborateError, inventory};
use pipelines::catalogue::Top;
use serde::Serialize;

use super::EstimateError;
use costs::{Unit, UnitCost};

/// A pipeline in the paper.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct PaperFigures {
    /// Area in square micrometres, without registers, clock and wires.
    pub area_um2: f64,
    /// Energy of an operation in picojoules.
    pub energy_pj: f64,
    /// Cycles from operands to result.
    pub latency_cycles: u32,
    /// The part of the area beyond the published costs of the units.
    pub glue_area_um2: f64,
    /// The part of the energy beyond the published costs of the units.
    pub glue_energy_pj: f64,
}

impl PaperFigures {
    /// The figures of the pipeline `top`. A lean pipeline has those of the published one.
    ///
    /// # Errors
    /// [`EstimateError::NoPipeline`] for other tops.
    pub fn of(top: Top) -> Result<Self, EstimateError> {
        let (published, area_um2, energy_pj) = match top {
            Top::DualSplit | Top::DualSplitLean => (Top::DualSplit, 49_800.0, 61.0),
            Top::RayBox | Top::RayBoxLean => (Top::RayBox, 127_800.0, 137.7),
            _ => return Err(EstimateError::NoPipeline(top)),
        };
        let units = units(&published.design(pipelines::catalogue::StandardFormat::Binary32)?)?;
        Ok(Self {
            area_um2,
            energy_pj,
            latency_cycles: 8,
            glue_area_um2: area_um2 - units.area_um2,
            glue_energy_pj: energy_pj - units.energy_pj,
        })
    }
}

/// The published costs of a design's units, summed.
pub(super) fn units(design: &Design) -> Result<UnitCost, ElaborateError> {
    let mut sum = UnitCost { area_um2: 0.0, energy_pj: 0.0, latency_cycles: 0 };
    for (kind, &count) in &inventory(design)?.units {
        if let Some(unit) = Unit::of_module(kind) {
            sum.area_um2 += f64::from(count) * unit.published().area_um2;
            sum.energy_pj += f64::from(count) * unit.published().energy_pj;
        }
    }
    Ok(sum)
}
