//! Published unit costs on our counts, with our glue logic counted in gates.

use hdl::netlist::{Design, ElaborateError, flatten, inventory};

use super::PipelineCost;
use crate::gates::blast::{Options, blast};
use crate::unit_costs::{self, Unit};

/// Area of a two-input NAND gate at 65 nm: between that of Nangate's 45 nm cell (0.798 um2 x 1.5) and of IHP's 130 nm
/// cell (7.2576 um2 x 0.23), scaled by Stillmaker and Baas, "Scaling equations for the accurate prediction of CMOS
/// device performance from 180 nm to 7 nm", Integration 58, 2017.
const NAND2_AREA_UM2: f64 = 1.44;

/// Units and glue.
pub fn cost(design: &Design) -> Result<PipelineCost, ElaborateError> {
    let mut area_um2 = 0.0;
    let mut energy_pj = 0.0;
    for (kind, &count) in &inventory(design)?.units {
        if let Some(unit) = Unit::of_module(kind) {
            area_um2 += f64::from(count) * unit.published().area_um2;
            energy_pj += f64::from(count) * unit.published().energy_pj;
        }
    }
    let blasted = blast(design, &flatten(design)?, Options { keep_units: true, ..Options::default() });
    let live = blasted.aig.live();
    let is_glue = |&node: &usize| {
        live[node] && blasted.aig.operands(node).is_some() && blasted.aig.origin_of(node).region == 0
    };
    let gates = (0..live.len()).filter(is_glue).count() as f64;
    // The published table's own energy of simple logic: that of an integer adder for its area.
    let simple = Unit::IntAdd.published();
    let glue_area_um2 = gates * NAND2_AREA_UM2;
    let glue_energy_pj = glue_area_um2 * simple.energy_pj / simple.area_um2;
    Ok(PipelineCost {
        area_um2: area_um2 + glue_area_um2,
        energy_pj: energy_pj + glue_energy_pj,
        glue_area_um2,
        glue_energy_pj,
        source: format!(
            "{}; glue: {gates} two-input gates of our netlist at {NAND2_AREA_UM2} um2, with the published integer adder's \
             energy for its area",
            unit_costs::SOURCE
        ),
    })
}
