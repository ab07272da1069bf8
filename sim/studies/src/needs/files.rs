//! The needs as files: the machine and the pipeline, and a chart of each knee.

use super::reuse::LINE_BYTES;
use super::study::Needs;
use crate::charts::precision::PrecisionPoint;
use machine::description::MachineDescription;
use serde::Serialize;
use view::plot::{Axis, Chart, Point, Series, Style};

/// The smallest cache of the machine, which has banks.
const LEAST_CACHE_BYTES: u64 = 1 << 10;
/// The most multiprocessors that a machine description allows.
const MOST_TMS: u32 = 1 << 12;

/// The machine and the pipeline as a file.
#[derive(Serialize)]
struct Toml<'a> {
    scene: &'a str,
    pipeline: PipelineToml,
    tree: TreeToml,
    cache: CacheToml,
    chip: ChipToml,
}

#[derive(Serialize)]
struct PipelineToml {
    variant: &'static str,
    exponent_bits: u32,
    significand_bits: u32,
    stack_entries: u32,
    #[serde(skip_serializing_if = "Option::is_none")]
    export_format: Option<&'static str>,
}

#[derive(Serialize)]
struct TreeToml {
    address_bits: u32,
    carve_levels: usize,
}

#[derive(Serialize)]
struct CacheToml {
    bytes: u64,
    line_bytes: u64,
}

#[derive(Serialize)]
struct ChipToml {
    #[serde(skip_serializing_if = "Option::is_none")]
    tms: Option<u32>,
}

/// The needs as TOML.
pub fn toml(d: &Needs) -> anyhow::Result<String> {
    let toml = Toml {
        scene: &d.scene,
        pipeline: PipelineToml {
            variant: d.variant,
            exponent_bits: d.exponent_bits,
            significand_bits: d.significand_bits,
            stack_entries: d.stack_entries,
            export_format: d.export_format,
        },
        tree: TreeToml { address_bits: d.address_bits, carve_levels: d.carve_levels },
        cache: CacheToml { bytes: d.cache_bytes, line_bytes: LINE_BYTES },
        chip: ChipToml { tms: d.tms },
    };
    Ok(::toml::to_string(&toml)?)
}

/// The preset machine with the needed cache and number of multiprocessors, for `dualsplit simulate --machine`.
pub fn machine(d: &Needs) -> anyhow::Result<MachineDescription> {
    let preset = MachineDescription::load("trax", &[])?;
    let partitions = preset.chip.l2_partitions;
    let mut settings = vec![
        format!("name=\"{}-needs\"", d.scene),
        format!("l1.size={}", d.cache_bytes.max(LEAST_CACHE_BYTES)),
    ];
    let most = MOST_TMS / partitions;
    settings
        .extend(d.tms.map(|tms| format!("chip.tms_per_partition={}", tms.div_ceil(partitions).min(most))));
    Ok(MachineDescription::load("trax", &settings)?)
}

/// The charts with their file names, which lack the extension.
pub fn charts(d: &Needs) -> Vec<(&'static str, Chart)> {
    let line = |name: &str, points: Vec<(f64, f64, bool)>| Series {
        name: name.to_owned(),
        style: Style::Line,
        points: points.into_iter().map(|(x, y, marked)| Point { x, y, marked, ..Point::default() }).collect(),
    };
    let visits = |sweep: &[PrecisionPoint], x: fn(&PrecisionPoint) -> u32, chosen: u32| {
        let points = sweep.iter().map(|p| (f64::from(x(p)), p.node_visits_per_ray, x(p) == chosen)).collect();
        vec![line(d.variant, points)]
    };
    let chart = |title: &str, x: Axis, y: Axis, series| Chart {
        title: format!("{}: {title}", d.scene),
        x,
        y,
        series,
    };
    let per_ray = || Axis::linear("node visits per ray");
    let significand = visits(&d.significand_sweep, |p| p.significand_bits, d.significand_bits);
    let exponent = visits(&d.exponent_sweep, |p| p.exponent_bits, d.exponent_bits);
    let cache =
        d.miss_curve.iter().map(|p| (p.bytes as f64, p.miss_ratio, p.bytes == d.cache_bytes)).collect();
    let all = d.carve_visits.iter().sum::<u64>().max(1) as f64;
    let levels = (1..).zip(&d.carve_visits);
    let levels =
        levels.map(|(level, v)| (f64::from(level), *v as f64 / all, level as usize == d.carve_levels));
    vec![
        (
            "significand",
            chart("visits by significand", Axis::linear("significand (bits)"), per_ray(), significand),
        ),
        ("exponent", chart("visits by exponent", Axis::linear("exponent (bits)"), per_ray(), exponent)),
        (
            "cache",
            chart(
                "misses of a fully associative cache",
                Axis::log("cache (bytes)"),
                Axis::linear("miss ratio"),
                vec![line("LRU", cache)],
            ),
        ),
        (
            "carves",
            chart(
                "visits of carve nodes by place in their chain",
                Axis::linear("place in the chain"),
                Axis::linear("fraction of visits"),
                vec![line("carves", levels.collect())],
            ),
        ),
    ]
}
