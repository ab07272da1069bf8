//! Sweeps over one scene, charted as cost against error.

pub mod cost;
pub mod fidelity;
pub mod fidelity_study;
pub mod pareto;
pub mod precision;
pub mod precision_study;

use serde::Serialize;

/// Points as CSV with a header.
fn csv(points: &[impl Serialize]) -> anyhow::Result<Vec<u8>> {
    let mut csv = ::csv::Writer::from_writer(vec![]);
    for point in points {
        csv.serialize(point)?;
    }
    Ok(csv.into_inner()?)
}
