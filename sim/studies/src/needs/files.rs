//! The needs as files: a machine, and a chart of each knee.

use super::study::Needs;
use crate::charts::precision::PrecisionPoint;
use machine::description::MachineDescription;
use serde::Serialize;
use view::plot::{Axis, Chart, Point, Series, Style};

/// The smallest cache whose cost is known.
const LEAST_CACHE_BYTES: u64 = 1 << 10;
/// The most multiprocessors that a machine description allows.
const MOST_TMS: u32 = 1 << 12;

/// The needs that are no keys of the machine, and those that its keys follow from.
#[derive(Serialize)]
struct NeedsTable<'a> {
    scene: &'a str,
    variant: &'static str,
    exponent_bits: u32,
    significand_bits: u32,
    #[serde(skip_serializing_if = "Option::is_none")]
    export_format: Option<&'static str>,
    stack_entries: u32,
    address_bits: u32,
    carve_levels: usize,
    cache_bytes: u64,
    #[serde(skip_serializing_if = "Option::is_none")]
    tms: Option<u32>,
}

/// The preset machine with the needed cache and number of multiprocessors, for `dualsplit simulate --machine`. Its section `needs`
/// has all needs.
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
    let needs = toml::Table::try_from(NeedsTable {
        scene: &d.scene,
        variant: d.variant,
        exponent_bits: d.exponent_bits,
        significand_bits: d.significand_bits,
        export_format: d.export_format,
        stack_entries: d.stack_entries,
        address_bits: d.address_bits,
        carve_levels: d.carve_levels,
        cache_bytes: d.cache_bytes,
        tms: d.tms,
    })?;
    Ok(MachineDescription { needs: Some(needs), ..MachineDescription::load("trax", &settings)? })
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
