//! Published unit costs times our unit counts, with our own glue logic beside them.

use super::paper::units;
use super::{Breakdown, EstimateError, Implementation, Scaling};
use costs::PipelineCost;
use pipelines::catalogue::Top;
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// What [`super::compute`] gives for the built-in workload and library, by the pipeline's name. A test makes it again.
const KNOWN: &str = include_str!("../published.json");

/// The known cost of `top`.
pub fn known(top: Top) -> Option<PipelineCost> {
    static COSTS: LazyLock<BTreeMap<String, PipelineCost>> =
        LazyLock::new(|| serde_json::from_str(KNOWN).expect("the test has written it"));
    COSTS.get(top.name()).cloned()
}

/// Area of a two-input NAND gate, one gate equivalent, at 65 nm: between that of Nangate's 45 nm cell (0.798 um2 x 1.5) and
/// of IHP's 130 nm cell (7.2576 um2 x 0.23), both scaled as in [`Scaling`]: 1.20 to 1.67.
const GATE_EQUIVALENT_UM2: f64 = 1.44;

/// Units and glue at 65 nm.
pub fn cost(
    implementation: &Implementation,
    area: &Breakdown,
    energy_fj: &Breakdown,
) -> Result<PipelineCost, EstimateError> {
    let library = implementation.library;
    let scaling = Scaling::of(library).ok_or_else(|| EstimateError::Unscalable(library.name.clone()))?;
    let units = units(&implementation.design)?;
    let gates = area.glue / library.gate_equivalent_um2();
    let glue_area_um2 = gates * GATE_EQUIVALENT_UM2;
    let glue_energy_pj = energy_fj.glue * scaling.energy / 1e3;
    Ok(PipelineCost {
        area_um2: units.area_um2 + glue_area_um2,
        energy_pj: units.energy_pj + glue_energy_pj,
        glue_area_um2,
        glue_energy_pj,
        source: format!(
            "units: {} x our counts; glue: {gates:.0} gate equivalents of our netlist in {}, {}, at {GATE_EQUIVALENT_UM2} um2 \
             (1.20..1.67), its zero-delay energy {}",
            costs::SOURCE,
            library.name,
            implementation.speed(),
            scaling.source()
        ),
    })
}
