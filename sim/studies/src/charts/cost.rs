//! Area and energy of the dual-split pipeline in each format that modules exist for.
//!
//! The netlist is mapped to the embedded library and scaled to 65 nm, as [`estimate`] does for binary32. The energy is that of
//! the node steps of the scene's rays, with nodes and rays rounded naively to the format. The pipeline is the published one: the
//! second origin of the conservative variant would add one 2:1 multiplexer to each plane.

use crate::stress::narrow_case;
use estimate::{EstimateError, Implementation, Method, Workload, cost};
use fp::{Arithmetic, Format};
use gates::liberty::embedded;
use gates::words::Structures;
use golden::dst::{Dst, step};
use golden::precision::{NarrowDst, Precision, Variant};
use golden::ray::TraversalRay;
use golden::traverse::NoObserver;
use pipelines::catalogue::{StandardFormat, Top};

/// Node steps whose energy is averaged.
const STEPS: usize = 4096;

/// What the pipeline costs in a format.
#[derive(Clone, Debug, PartialEq)]
pub struct FormatCost {
    /// Units and glue, without registers, clock and wires, in square micrometres.
    pub area_um2: f64,
    /// Energy of a node step, of units and glue, in picojoules.
    pub energy_pj: f64,
    /// The source of the numbers.
    pub source: String,
}

/// The cost in `format` for the nodes that `rays` visit, or `None` if no modules of the format exist.
///
/// # Errors
/// [`EstimateError`] where the netlist cannot be mapped, or nothing is visited.
pub fn format_cost(
    format: Format,
    dst: &Dst,
    rays: &[TraversalRay],
) -> Result<Option<FormatCost>, EstimateError> {
    let Some(&standard) = StandardFormat::ALL.iter().find(|standard| standard.format() == format) else {
        return Ok(None);
    };
    let narrow = NarrowDst::new(dst, Precision::new(format, Variant::Naive));
    let arithmetic = Arithmetic::new(format);
    let mut nodes = vec![];
    // A sample of rays that is spread over all waves, until there are enough steps.
    let stride = (rays.len() / 400).max(1);
    for ray in (0..stride).flat_map(|first| rays.iter().skip(first).step_by(stride)) {
        if nodes.len() >= STEPS {
            break;
        }
        narrow.closest_by_steps(ray, &mut NoObserver, |words, ray, t_min, t_max| {
            nodes.push(narrow_case(arithmetic, words, ray, t_min, t_max));
            step(words, ray, t_min, t_max)
        });
    }
    nodes.truncate(STEPS);
    if nodes.is_empty() {
        return Err(EstimateError::Scene("no ray meets a node; move the camera".to_owned()));
    }
    let library = embedded();
    let pipeline = Implementation::in_format(Top::DualSplit, standard, &library, Structures::default())?;
    let workload = Workload { scene: String::new(), nodes, boxes: vec![] };
    let energy = pipeline.energy(&workload.streams(&pipeline)?);
    let cost = cost(&pipeline, &energy.zero_delay, Method::Scaled(&library))?;
    Ok(Some(FormatCost { area_um2: cost.area_um2, energy_pj: cost.energy_pj, source: cost.source }))
}
