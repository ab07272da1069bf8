//! Area and energy of the pipelines, each number with where it comes from.

mod published;

use hdl::catalogue::{StandardFormat, Top};
use hdl::netlist::ElaborateError;
use serde::Serialize;

/// How a cost is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Method {
    /// The published costs of execution units on our counts, and our own glue logic, at 65 nm. Needs no cell library.
    Published,
}

/// What a pipeline costs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PipelineCost {
    /// Units and glue, without registers, clock and wires, in square micrometres.
    pub area_um2: f64,
    /// Energy of one operation, of units and glue, in picojoules.
    pub energy_pj: f64,
    /// The part of the area that is glue: selection, offset and return logic between the units.
    pub glue_area_um2: f64,
    /// The part of the energy that is glue.
    pub glue_energy_pj: f64,
    /// Where the numbers come from.
    pub source: String,
}

/// What a top costs, one of the pipelines or an execution unit.
///
/// # Errors
/// When the top does not elaborate, which none of the catalogue does.
pub fn pipeline_cost(top: Top, method: Method) -> Result<PipelineCost, ElaborateError> {
    let design = top.design(StandardFormat::Binary32)?;
    match method {
        Method::Published => published::cost(&design),
    }
}
