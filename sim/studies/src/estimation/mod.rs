//! A report of area, energy and speed of the pipelines, beside the published figures.

mod beside_paper;
mod clock;
mod curve;
mod mapper;
mod numbers;
mod report;
mod synthesis;
mod timing_report;

use crate::artifacts::Artifacts;
use crate::input::SceneSource;
use crate::progress::{Part, Progress};
use anyhow::{Context, ensure};
use estimate::{
    Breakdown, EnergyReport, EstimateError, Implementation, Method, ModuleRow, NodeType, PaperFigures,
    Scaling, Workload, cost,
};
use gates::liberty::{embedded, load};
use gates::timing::{fo4, fo4_ns};
use golden::build::Quality;
use netlist::inventory;
use pipelines::catalogue::Top;
use rayon::prelude::*;
use serde::Serialize;
use std::collections::BTreeMap;
use std::path::PathBuf;

pub use beside_paper::{Bar, BesideRow};
pub use clock::{Clock, ClockRow};
pub use curve::CurveRow;
pub use mapper::{Mapper, OwnRow};
pub use synthesis::SynthesisRow;

/// The libraries to map to, the scenes to measure on, and the folder of the report.
#[derive(Clone, Debug)]
pub struct Options {
    /// Liberty files of cell libraries; if there are none, the embedded library is used.
    pub liberty: Vec<PathBuf>,
    /// The clock to map for; if there is none, cells are mapped for area and then sized for speed.
    pub clock: Option<Clock>,
    /// Who maps for that clock.
    pub mapper: Mapper,
    /// Also maps both pipelines for several clocks, and writes area and energy against the clock into the folder `out`.
    pub curve: bool,
    /// Also synthesises the exported Verilog with yosys and ABC.
    pub synthesis: bool,
    /// The scenes on whose rays energy is measured. All tables but that of the scenes show the first.
    pub scenes: Vec<SceneSource>,
    /// How the trees are built.
    pub quality: Quality,
    /// A folder for the report as text, CSV, JSON and HTML.
    pub out: Option<PathBuf>,
    /// Writes into the folder even if it holds files that the tool did not make.
    pub force: bool,
}

/// Area, energy and speed of the pipelines, beside the published figures.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct Estimates {
    pub scene: String,
    pub library: LibraryRow,
    /// The sources of the numbers below, by their keys.
    pub provenance: BTreeMap<&'static str, String>,
    pub pipelines: Vec<PipelineRow>,
    /// The pipelines without redundant comparators.
    pub lean_pipelines: Vec<PipelineRow>,
    pub ratios: Vec<RatioRow>,
    /// The paper's figures and ours at 65 nm, part by part; none for a library that cannot be scaled.
    pub beside_paper: Vec<BesideRow>,
    pub scenes: Vec<SceneRow>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub synthesis: Vec<SynthesisRow>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub curve: Vec<CurveRow>,
}

/// The standard cells.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct LibraryRow {
    pub name: String,
    pub source: String,
    pub node_nm: Option<u32>,
    pub voltage_v: f64,
    pub gate_equivalent_um2: f64,
    /// Delay of an inverter that drives four of its kind.
    pub fo4_ps: f64,
    /// That inverter.
    pub fo4_inverter: String,
    /// Factors to 65 nm, where there are any.
    pub scaling: Option<Scaling>,
}

/// How many units of each kind a pipeline has.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct Units {
    pub int_add: u32,
    pub fp_add: u32,
    pub fp_mul: u32,
    pub fp_min_max: u32,
    pub fp_cmp: u32,
}

/// The cost of a pipeline by one method.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct EstimateRow {
    pub method: &'static str,
    pub area_um2: f64,
    pub energy_pj: f64,
    pub glue_area_um2: f64,
    pub glue_energy_pj: f64,
    pub source: String,
}

/// The energy of an operation on one type of node.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct TypeRow {
    pub node_type: NodeType,
    /// Share of the scene's operations.
    pub share: f64,
    pub energy: Breakdown,
    pub energy_with_glitches: Breakdown,
}

/// Area, energy and speed of a pipeline.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct PipelineRow {
    pub name: &'static str,
    pub units: Units,
    pub latency_cycles: Option<u32>,
    pub published: PaperFigures,
    pub estimates: Vec<EstimateRow>,
    /// Area in the library in square micrometres.
    pub area: Breakdown,
    /// Energy of one operation of the scene in the library in femtojoules.
    pub energy: Breakdown,
    /// The same energy with glitches.
    pub energy_with_glitches: Breakdown,
    pub operations: u64,
    pub glitch_operations: u64,
    /// Standard error of the energy with glitches, as a fraction of it; absent where one sample was all.
    pub glitch_error: Option<f64>,
    pub cells: usize,
    pub registers: usize,
    pub leakage_uw: f64,
    pub critical_path_ns: f64,
    pub clock_mhz: f64,
    pub clock: ClockRow,
    /// The same by our own mapper, where ABC was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub own: Option<OwnRow>,
    pub modules: Vec<ModuleRow>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub node_types: Vec<TypeRow>,
}

impl Estimates {
    /// Whether a pipeline is too slow for the clock that was asked for.
    #[must_use]
    pub fn misses_clock(&self) -> bool {
        self.pipelines.iter().chain(&self.lean_pipelines).any(|pipeline| pipeline.clock.is_missed())
    }
}

impl PipelineRow {
    fn energy_report(&self) -> EnergyReport {
        EnergyReport {
            zero_delay: self.energy.clone(),
            with_glitches: self.energy_with_glitches.clone(),
            operations: self.operations,
            glitch_operations: self.glitch_operations,
            glitch_error: self.glitch_error,
        }
    }
}

/// Energy of an operation in the library, in one of the scenes.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct SceneRow {
    pub scene: String,
    pub pipeline: &'static str,
    /// Shares of the types of node among the operations; none for boxes.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub node_types: Vec<(NodeType, f64)>,
    /// Energy of one operation in femtojoules.
    pub energy: EnergyReport,
}

/// Ray-box over dual-split, by one method.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct RatioRow {
    pub method: String,
    /// Area of the ray-box pipeline over that of the dual-split pipeline.
    pub area: f64,
    pub energy: f64,
}

/// Maps the pipelines and measures them on the scenes' rays. Returns the report as numbers and as text, and the files that it
/// is written to if a folder is given.
///
/// # Errors
/// A scene or a library cannot be loaded, a pipeline cannot be mapped, synthesis fails, or a file cannot be written.
pub fn run(args: &Options, progress: &dyn Progress) -> anyhow::Result<(Estimates, String, Vec<PathBuf>)> {
    ensure!(
        !args.synthesis || args.liberty.len() == 1,
        "--synth needs one --liberty FILE, which yosys and ABC map to as well"
    );
    mapper::check(args)?;
    ensure!(!args.curve || args.out.is_some(), "--curve writes files: name a folder with --out DIR");
    let library = if args.liberty.is_empty() { embedded() } else { load(&args.liberty)? };
    let workloads = (args.scenes.iter())
        .map(|scene| Ok(Workload::new(&scene.load(progress)?, args.quality)?))
        .collect::<anyhow::Result<Vec<Workload>>>()?;
    let mut artifacts =
        args.out.as_deref().map(|folder| Artifacts::create(folder, args.force)).transpose()?;
    let workload = workloads.first().context("--scene names no scene")?;
    let tops = [Top::DualSplit, Top::RayBox, Top::DualSplitLean, Top::RayBoxLean];
    let part = Part::begin(progress, (tops.len() + workloads.len()) as u64 + 1, "mapping and measuring");
    let implementations = (tops.into_par_iter())
        .map(|top| mapper::implementation(args, top, &library))
        .collect::<anyhow::Result<Vec<_>>>()?;
    let (implementations, own): (Vec<Implementation>, Vec<_>) = implementations.into_iter().unzip();
    let mut rows = Vec::new();
    for (implementation, own) in implementations.iter().zip(&own) {
        rows.push(pipeline(implementation, own.as_ref(), workload, args.clock)?);
        part.advance(1);
    }
    let mut scenes = Vec::new();
    for (position, workload) in workloads.iter().enumerate() {
        for (implementation, row) in implementations[..2].iter().zip(&rows) {
            // The energies of the first scene are known already.
            let known = (position == 0).then(|| row.energy_report());
            scenes.push(in_scene(implementation, workload, known)?);
        }
        part.advance(1);
    }
    drop(part);
    let synthesis = if args.synthesis {
        let [liberty] = args.liberty.as_slice() else { unreachable!("one file, as checked") };
        synthesis::run(&implementations[..2], liberty, progress)?
    } else {
        Vec::new()
    };
    let curve = if args.curve { curve::run(args, &library, workload, progress)? } else { Vec::new() };
    let lean_pipelines = rows.split_off(2);
    let estimates = Estimates {
        scene: workload.scene.clone(),
        library: LibraryRow {
            name: library.name.clone(),
            source: library.source.clone(),
            node_nm: library.node_nm,
            voltage_v: library.voltage_v,
            gate_equivalent_um2: library.gate_equivalent_um2(),
            fo4_ps: 1e3 * fo4_ns(&library),
            fo4_inverter: fo4(&library).1.name.clone(),
            scaling: Scaling::of(&library),
        },
        provenance: numbers::provenance(&library),
        ratios: ratios(&rows),
        beside_paper: beside_paper::rows(&rows, Scaling::of(&library).as_ref()),
        scenes,
        pipelines: rows,
        lean_pipelines,
        synthesis,
        curve,
    };
    let sections = report::sections(&estimates);
    let text = report::text(&sections);
    let mut files = vec![];
    if let Some(mut artifacts) = artifacts.take() {
        let json = serde_json::to_vec_pretty(&estimates).context("estimate.json")?;
        artifacts.write("estimate.txt", text.as_bytes())?;
        artifacts.write("estimate.json", &json)?;
        artifacts.write("estimate.csv", &numbers::csv(&estimates)?)?;
        artifacts.write("estimate.html", report::html(&sections).as_bytes())?;
        if args.curve {
            curve::write(&estimates.curve, &mut artifacts)?;
        }
        files = artifacts.finish()?;
    }
    Ok((estimates, text, files))
}

fn pipeline(
    implementation: &Implementation,
    own: Option<&Implementation>,
    workload: &Workload,
    clock: Option<Clock>,
) -> anyhow::Result<PipelineRow> {
    let top = implementation.top;
    let counts = inventory(&implementation.design)?;
    let count = |kind: &str| counts.units.get(kind).copied().unwrap_or(0);
    let stream = workload.streams(implementation)?;
    let energy = implementation.energy(&stream);
    let mut estimates = Vec::new();
    let methods = [
        ("published", Method::Published),
        ("netlist", Method::Netlist(implementation.library)),
        ("scaled", Method::Scaled(implementation.library)),
    ];
    for (name, method) in methods {
        match cost(implementation, &energy.zero_delay, method) {
            Ok(cost) => estimates.push(EstimateRow {
                method: name,
                area_um2: cost.area_um2,
                energy_pj: cost.energy_pj,
                glue_area_um2: cost.glue_area_um2,
                glue_energy_pj: cost.glue_energy_pj,
                source: cost.source,
            }),
            // A technology without published coefficients has no such row; the report says so.
            Err(EstimateError::Unscalable(_)) => (),
            Err(error) => return Err(error.into()),
        }
    }
    let is_box = matches!(top, Top::RayBox | Top::RayBoxLean);
    let mut node_types = Vec::new();
    for node_type in NodeType::ALL.into_iter().filter(|_| !is_box) {
        let stream = workload.nodes_of(implementation, |other| other == node_type);
        let energy = implementation.energy(&stream);
        if energy.operations > 0 {
            node_types.push(TypeRow {
                node_type,
                share: stream.len() as f64 / workload.nodes.len() as f64,
                energy: energy.zero_delay,
                energy_with_glitches: energy.with_glitches,
            });
        }
    }
    Ok(PipelineRow {
        name: top.name(),
        units: Units {
            int_add: count("int_add"),
            fp_add: count("fp_add"),
            fp_mul: count("fp_mul"),
            fp_min_max: count("fp_min_max"),
            fp_cmp: count("fp_cmp"),
        },
        latency_cycles: counts.latency_cycles,
        published: PaperFigures::of(top)?,
        estimates,
        area: implementation.area(),
        energy: energy.zero_delay,
        energy_with_glitches: energy.with_glitches,
        operations: energy.operations,
        glitch_operations: energy.glitch_operations,
        glitch_error: energy.glitch_error,
        cells: implementation.mapped.gates.len(),
        registers: implementation.mapped.registers.len(),
        leakage_uw: implementation.leakage_nw() / 1e3,
        critical_path_ns: implementation.timing.critical_path_ns,
        clock_mhz: implementation.timing.clock_mhz(),
        clock: ClockRow::of(implementation, clock),
        own: own.map(|own| OwnRow::new(own, workload)).transpose()?,
        modules: implementation.modules(),
        node_types,
    })
}

fn in_scene(
    implementation: &Implementation,
    workload: &Workload,
    known: Option<EnergyReport>,
) -> anyhow::Result<SceneRow> {
    let is_box = matches!(implementation.top, Top::RayBox | Top::RayBoxLean);
    let share = |node_type: NodeType| {
        let count = workload.nodes.iter().filter(|case| NodeType::of(case.words[0]) == node_type).count();
        (node_type, count as f64 / workload.nodes.len() as f64)
    };
    let energy = match known {
        Some(energy) => energy,
        None => implementation.energy(&workload.streams(implementation)?),
    };
    Ok(SceneRow {
        scene: workload.scene.clone(),
        pipeline: implementation.top.name(),
        node_types: NodeType::ALL.into_iter().filter(|_| !is_box).map(share).collect(),
        energy,
    })
}

/// How many times larger the ray-box pipeline is than the dual-split pipeline, by each method.
fn ratios(rows: &[PipelineRow]) -> Vec<RatioRow> {
    let [dual_split, ray_box] = rows else { return Vec::new() };
    let mut ratios = vec![RatioRow {
        method: "paper".to_owned(),
        area: ray_box.published.area_um2 / dual_split.published.area_um2,
        energy: ray_box.published.energy_pj / dual_split.published.energy_pj,
    }];
    for (small, large) in dual_split.estimates.iter().zip(&ray_box.estimates) {
        ratios.push(RatioRow {
            method: small.method.to_owned(),
            area: large.area_um2 / small.area_um2,
            energy: large.energy_pj / small.energy_pj,
        });
    }
    ratios.push(RatioRow {
        method: "netlist with registers and clock".to_owned(),
        area: ray_box.area.total() / dual_split.area.total(),
        energy: ray_box.energy.total() / dual_split.energy.total(),
    });
    ratios.push(RatioRow {
        method: "netlist with registers, clock and glitches".to_owned(),
        area: ray_box.area.total() / dual_split.area.total(),
        energy: ray_box.energy_with_glitches.total() / dual_split.energy_with_glitches.total(),
    });
    ratios
}
