//! Area and energy of the pipelines, each number with its source.
//!
//! There are three methods: published unit costs times our unit counts, with our own glue logic; our netlist in a library; our
//! netlist scaled to 65 nm. *Units* are the combinational gates of execution units. *Glue* is the logic around them: selection, offset and return
//! value. Registers, clock and input nets have rows of their own, because the published sums hold none of them.
//!
//! [`pipeline_cost`] gives the cost of a pipeline, [`Implementation`] a mapped netlist with its areas, delays and energies, and
//! [`Workload`] the operations that the energy is measured on.
//!
//! ```
//! use estimate::{PaperFigures, Scaling, embedded_library};
//! use pipelines::catalogue::Top;
//!
//! // The glue is what the paper's area holds beyond its units.
//! let paper = PaperFigures::of(Top::DualSplit)?;
//! assert_eq!((paper.area_um2, paper.glue_area_um2.round()), (49_800.0, 5_086.0));
//!
//! // The embedded library has a node of 130 nm: scaled to 65 nm, its areas shrink to 0.23 times.
//! let scaling = Scaling::of(embedded_library()).expect("the node is known");
//! assert_eq!((scaling.node_nm, scaling.area), (130, 0.23));
//! # Ok::<(), estimate::EstimateError>(())
//! ```

mod breakdown;
mod clock;
mod implementation;
mod paper;
mod published;
mod scaling;
mod stages;
mod workload;

pub use breakdown::Breakdown;
pub use clock::{Mappings, Recipe};
pub use implementation::{EnergyReport, Implementation, ModuleRow};
pub use paper::PaperFigures;
pub use scaling::{PAPER_CLOCK_FO4, Scaling, TARGET_NODE_NM, TARGET_VOLTAGE_V};
pub use stages::{StageRow, Stretch};
pub use workload::{NodeType, Workload};

use std::collections::BTreeMap;
use std::sync::{Mutex, OnceLock, PoisonError};

use costs::{Pipeline, PipelineCost, Unit};
use gates::abc::AbcError;
use gates::liberty::{Library, embedded};
use gates::map::MapError;
use gates::prove::Verdict;
use netlist::{ElaborateError, inventory};
use pipelines::catalogue::{CatalogueError, StandardFormat, Top};

/// Why there is no estimate.
#[derive(Debug, thiserror::Error)]
pub enum EstimateError {
    /// There is no such design.
    #[error(transparent)]
    Catalogue(#[from] CatalogueError),
    /// The design has a combinational loop.
    #[error(transparent)]
    Elaborate(#[from] ElaborateError),
    /// The library lacks a cell.
    #[error(transparent)]
    Map(#[from] MapError),
    /// The scene cannot be loaded or built.
    #[error("{0}")]
    Scene(String),
    /// The published scaling equations have no coefficients for the library's node.
    #[error(
        "library {0} has a node without scaling coefficients: use one of 45, 130 or 180 nm, or leave scaling out"
    )]
    Unscalable(String),
    /// ABC gives no netlist.
    #[error(transparent)]
    Abc(#[from] AbcError),
    /// A mapped netlist could not be proved equal to its source.
    #[error("the cells of {0} are not proved equal to its gates: {1:?}; report this as a fault")]
    Unproved(Top, Verdict),
    /// Not a pipeline.
    #[error("{0} has no estimate: name dual_split, dual_split_lean, ray_box or ray_box_lean")]
    NoPipeline(Top),
}

/// How a cost is found.
#[derive(Clone, Copy, Debug)]
pub enum Method<'l> {
    /// Published unit costs times our unit counts, and our own glue, mapped to the embedded library and scaled to 65 nm.
    Published,
    /// Our netlist in a library: units and glue, without registers and clock.
    Netlist(&'l Library),
    /// The same scaled to 65 nm by published equations.
    Scaled(&'l Library),
}

/// What a pipeline costs, for operations of the built-in workload; see [`Workload::built_in`].
///
/// # Errors
/// [`EstimateError`] for tops that are no pipeline, and for libraries that lack a cell or a scaling.
pub fn pipeline_cost(top: Top, method: Method) -> Result<PipelineCost, EstimateError> {
    if let Top::RayBoxX2 | Top::RayBoxX4 | Top::RayBoxX8 = top {
        return parallel_cost(top, method);
    }
    // Without a choice of library, the costs of a top are always the same: mapping and simulating it takes seconds.
    if let (Method::Published, Some(cost)) = (method, published::known(top)) {
        return Ok(cost);
    }
    compute(top, method)
}

/// [`pipeline_cost`] by mapping and measuring the netlist, for pipelines that are not parallel forms.
///
/// # Errors
/// As [`pipeline_cost`].
pub fn compute(top: Top, method: Method) -> Result<PipelineCost, EstimateError> {
    let workload = built_in()?;
    let library = match method {
        Method::Published => embedded_library(),
        Method::Netlist(library) | Method::Scaled(library) => library,
    };
    let implementation = Implementation::new(top, library, gates::words::Structures::default())?;
    let (energy, _) = implementation.zero_delay_energy(&workload.streams(&implementation)?);
    cost(&implementation, &energy, method)
}

/// The pipeline `top` in single precision as data: units and latency of the elaborated hardware, its cost by `method`.
///
/// # Errors
/// The errors of [`pipeline_cost`].
pub fn pipeline(top: Top, method: Method) -> Result<Pipeline, EstimateError> {
    let inventory = inventory(&top.design(StandardFormat::Binary32)?)?;
    let mut units = BTreeMap::new();
    for (kind, &count) in &inventory.units {
        if let Some(unit) = Unit::of_module(kind) {
            *units.entry(unit).or_default() += count;
        }
    }
    let latency_cycles = inventory.latency_cycles.ok_or(EstimateError::NoPipeline(top))?;
    Ok(Pipeline { name: top.name().to_owned(), units, latency_cycles, cost: pipeline_cost(top, method)? })
}

/// A function that returns the [`pipeline`] whose module has a given name, as a machine asks for it. The function elaborates each
/// pipeline once, which takes a while, however many machines ask.
///
/// # Panics
/// The function panics if no pipeline has the name, or its hardware does not elaborate, which the hardware's own tests rule
/// out.
pub fn by_name(method: Method<'_>) -> impl Fn(&str) -> Pipeline + Sync {
    let elaborated = Mutex::new(BTreeMap::new());
    let elaborate = move |name: &str| {
        let top = name.parse().unwrap_or_else(|error| panic!("{error}"));
        pipeline(top, method).unwrap_or_else(|error| panic!("{error}"))
    };
    move |name| {
        // An entry is whole or absent, also after a panic.
        let mut known = elaborated.lock().unwrap_or_else(PoisonError::into_inner);
        known.entry(name.to_owned()).or_insert_with(|| elaborate(name)).clone()
    }
}

/// The cost of a parallel form: the cost of one ray-box pipeline times the number of such pipelines in the form.
///
/// The number of adders in the form, over that of one pipeline, gives the number of pipelines.
fn parallel_cost(top: Top, method: Method) -> Result<PipelineCost, EstimateError> {
    let adders = |top: Top| -> Result<f64, EstimateError> {
        Ok(inventory(&top.design(StandardFormat::Binary32)?)?.units["fp_add"].into())
    };
    let copies = adders(top)? / adders(Top::RayBox)?;
    let one = pipeline_cost(Top::RayBox, method)?;
    Ok(PipelineCost {
        area_um2: copies * one.area_um2,
        energy_pj: copies * one.energy_pj,
        glue_area_um2: copies * one.glue_area_um2,
        glue_energy_pj: copies * one.glue_energy_pj,
        source: format!("{copies} times one ray-box pipeline: {}", one.source),
    })
}

/// [`pipeline_cost`] of a pipeline that is already mapped and measured. The library of `method` has to be the implementation's.
///
/// # Errors
/// [`EstimateError::Unscalable`] where the library cannot be scaled.
pub fn cost(
    implementation: &Implementation,
    energy_fj: &Breakdown,
    method: Method,
) -> Result<PipelineCost, EstimateError> {
    let area = implementation.area();
    let library = implementation.library;
    match method {
        Method::Published => published::cost(implementation, &area, energy_fj),
        Method::Netlist(_) => Ok(PipelineCost {
            area_um2: area.logic(),
            energy_pj: energy_fj.logic() / 1e3,
            glue_area_um2: area.glue,
            glue_energy_pj: energy_fj.glue / 1e3,
            source: format!(
                "our netlist mapped to {} ({} V), {}, without wires; zero-delay energy",
                library.source,
                library.voltage_v,
                implementation.speed()
            ),
        }),
        Method::Scaled(_) => {
            let scaling =
                Scaling::of(library).ok_or_else(|| EstimateError::Unscalable(library.name.clone()))?;
            Ok(PipelineCost {
                area_um2: area.logic() * scaling.area,
                energy_pj: energy_fj.logic() * scaling.energy / 1e3,
                glue_area_um2: area.glue * scaling.area,
                glue_energy_pj: energy_fj.glue * scaling.energy / 1e3,
                source: format!(
                    "our netlist mapped to {}, {}, {}",
                    library.source,
                    implementation.speed(),
                    scaling.source()
                ),
            })
        }
    }
}

/// The library that is part of the program. It is read once.
pub fn embedded_library() -> &'static Library {
    static LIBRARY: OnceLock<Library> = OnceLock::new();
    LIBRARY.get_or_init(embedded)
}

fn built_in() -> Result<&'static Workload, EstimateError> {
    static WORKLOAD: OnceLock<Result<Workload, String>> = OnceLock::new();
    let workload = WORKLOAD.get_or_init(|| Workload::built_in().map_err(|error| error.to_string()));
    workload.as_ref().map_err(|error| EstimateError::Scene(error.clone()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Published area in mm2 and energy in nJ of a pipeline's units.
    fn sum(top: Top) -> (f64, f64) {
        let units = pipeline(top, Method::Published).unwrap().units;
        units.iter().fold((0.0, 0.0), |(area, energy), (unit, &count)| {
            let (cost, count) = (unit.published(), f64::from(count));
            (area + count * cost.area_um2 / 1e6, energy + count * cost.energy_pj / 1e3)
        })
    }

    #[test]
    fn sums_are_those_of_the_paper() {
        let (area, energy) = sum(Top::RayBox);
        assert_eq!((format!("{area:.4}"), format!("{energy:.4}")), ("0.1271".into(), "0.1371".into()));
        let (area, energy) = sum(Top::DualSplit);
        assert_eq!((format!("{area:.4}"), format!("{energy:.4}")), ("0.0447".into(), "0.0475".into()));
    }

    #[test]
    fn glue_is_at_most_half_of_the_papers() {
        for top in [Top::DualSplit, Top::DualSplitLean] {
            let cost = pipeline_cost(top, Method::Published).unwrap();
            let paper = PaperFigures::of(top).unwrap();
            assert_eq!(format!("{:.0} {:.1}", paper.glue_area_um2, paper.glue_energy_pj), "5086 13.5");
            assert!(cost.glue_area_um2 <= 0.5 * paper.glue_area_um2, "{top}: {cost:?}");
            assert!(cost.glue_energy_pj <= 0.5 * paper.glue_energy_pj, "{top}: {cost:?}");
            assert!(cost.glue_area_um2 > 500.0 && cost.glue_energy_pj > 0.05, "{top}: {cost:?}");
        }
        let one = pipeline_cost(Top::RayBox, Method::Published).unwrap();
        assert_eq!(pipeline_cost(Top::RayBoxX4, Method::Published).unwrap().area_um2, 4.0 * one.area_um2);
        assert!(matches!(
            pipeline_cost(Top::FpAdd, Method::Published),
            Err(EstimateError::NoPipeline(Top::FpAdd))
        ));
    }
}
