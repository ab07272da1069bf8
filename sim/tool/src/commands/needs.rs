//! `dualsplit needs`: the least hardware that a scene needs at an error budget.

use crate::artifacts::Artifacts;
use crate::cli::{Global, NeedsArgs};
use crate::console::{Report, fixed, progress, table};
use crate::input::{self, Built, display};
use anyhow::bail;
use fp::Format;
use golden::TraversalRay;
use golden::dst::Dst;
use golden::precision::Precision;
use golden::structure::{Structure, StructureKind};
use golden::traverse::Trace;
use machine::description::MachineDescription;
use pipelines::catalogue::StandardFormat;
use render::RenderOptions;
use serde::Serialize;
use std::ops::RangeInclusive;
use studies::charts::precision::{PrecisionPoint, Sweep, SweepError};
use studies::needs::carves::CarveLevels;
use studies::needs::knee;
use studies::needs::memory::{DRAM_BYTES_PER_CYCLE, Traffic, multiprocessors_until_bound};
use studies::needs::reuse::{LINE_BYTES, LineStream, ReuseDistances};
use view::plot::{Axis, Chart, Point, Series, Style};

/// Cache sizes that are tried, as powers of two of bytes.
const CACHE_LOG2_BYTES: RangeInclusive<u32> = 8..=22;
/// The machine's caches have banks: none is smaller than this.
const LEAST_CACHE_BYTES: u64 = 1 << 10;
/// What a description may hold.
const MOST_TMS: u32 = 1 << 12;
/// Significands that are tried.
const SIGNIFICAND_BITS: RangeInclusive<u32> = 4..=24;
/// A format that visits more than so many times the nodes of binary32 is not traced to the end, and none below it is tried:
/// the knee lies far behind, and with too few bits every ray visits the whole tree.
const MOST_VISITS: f64 = 16.0;
/// Exponents that are tried.
const EXPONENT_BITS: RangeInclusive<u32> = 3..=8;

#[derive(Serialize)]
struct Document {
    scene: String,
    triangles: usize,
    test: &'static str,
    rays: u64,
    max_image_error: f64,
    max_false_miss: u64,
    max_extra_visits: f64,
    /// The sweeps end before the first format that visits more than this many times the nodes of binary32.
    most_visits: f64,
    /// Those formats.
    beyond_most_visits: Vec<String>,
    variant: &'static str,
    significand_bits: u32,
    exponent_bits: u32,
    /// The narrowest format of `dualsplit export` that has as many bits of both.
    export_format: Option<&'static str>,
    stack_entries: u32,
    address_bits: u32,
    carve_levels: usize,
    cache_bytes: u64,
    /// Absent where nothing misses the cache.
    tms: Option<u32>,
    tms_method: &'static str,
    significand_sweep: Vec<PrecisionPoint>,
    exponent_sweep: Vec<PrecisionPoint>,
    carve_visits: [u64; golden::dst::MAX_CARVES],
    miss_curve: Vec<CachePoint>,
    artifacts: Vec<String>,
}

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

#[derive(Serialize)]
struct CachePoint {
    bytes: u64,
    miss_ratio: f64,
}

pub fn run(args: &NeedsArgs, global: &Global) -> anyhow::Result<Report> {
    let scene = input::scene(&args.scene, global)?;
    let folder = args.out.clone().unwrap_or_else(|| format!("needs-{}", scene.name).into());
    let mut artifacts = Artifacts::create(&folder, global.force)?;
    let built = Built::new(&scene, args.quality.quality)?;
    let [width, height] = args.size;
    let options = RenderOptions { seed: global.seed, ..RenderOptions::new(args.test, width, height) };
    let sweep = Sweep::new(&scene, &built.tree, &built.triangles, StructureKind::Dst, options)?;
    let Structure::Dst(dst) = sweep.structure() else { unreachable!("the kind that was asked for") };

    let precision = |e: u32, s: u32| Ok(Precision::new(Format::new(e, s)?, args.variant));
    let count = SIGNIFICAND_BITS.count() + EXPONENT_BITS.count();
    let bar = progress(count as u64, "formats");
    let reference = sweep.reference_counters.node_visits as f64;
    let most_visits = MOST_VISITS.max(2.0 * (1.0 + args.max_extra_visits));
    let mut beyond_most_visits = vec![];
    // Up to the first that visits too many.
    let mut points = |precisions: Vec<Precision>| {
        let mut points = vec![];
        for precision in precisions {
            bar.set_message(precision.to_string());
            bar.inc(1);
            match sweep.point(precision, (most_visits * reference) as u64)? {
                Some(point) => points.push(point),
                None => {
                    beyond_most_visits.push(precision.format.to_string());
                    break;
                }
            }
        }
        Ok::<_, SweepError>(points)
    };
    let significands: Vec<Precision> =
        SIGNIFICAND_BITS.rev().map(|s| precision(8, s)).collect::<anyhow::Result<_>>()?;
    let significand_sweep = points(significands)?;
    let fits = |p: &PrecisionPoint| {
        p.rmse <= args.max_image_error
            && p.false_misses <= args.max_false_miss
            && p.node_visits as f64 <= reference * (1.0 + args.max_extra_visits)
    };
    // The narrowest of an unbroken row from the widest: a lucky one below a failure does not count.
    let Some(significand) = significand_sweep.iter().take_while(|p| fits(p)).last() else {
        bail!(
            "{}: no format up to binary32 stays within the budget in the {} variant; raise --max-image-error, \
             --max-false-miss or --max-extra-visits",
            scene.name,
            args.variant.name()
        );
    };
    let significand_bits = significand.significand_bits;
    let exponents: Vec<Precision> = EXPONENT_BITS
        .rev()
        .filter(|e| Format::new(*e, significand_bits).is_ok())
        .map(|e| precision(e, significand_bits))
        .collect::<anyhow::Result<_>>()?;
    let exponent_sweep = points(exponents)?;
    bar.finish_and_clear();
    let least = exponent_sweep.iter().take_while(|p| fits(p)).last().unwrap_or(significand);
    let format = Format::new(least.exponent_bits, significand_bits)?;

    let (lines, carve_visits) = observe(dst, &sweep);
    let distances = ReuseDistances::of(&lines);
    let miss_curve: Vec<CachePoint> = CACHE_LOG2_BYTES
        .map(|log2| 1u64 << log2)
        .map(|bytes| CachePoint { bytes, miss_ratio: distances.miss_ratio(bytes) })
        .collect();
    let curve: Vec<(f64, f64)> =
        CACHE_LOG2_BYTES.map(f64::from).zip(miss_curve.iter().map(|p| p.miss_ratio)).collect();
    let cache_bytes = miss_curve[knee::of_falling(&curve)].bytes;

    let rays = sweep.rays().max(1) as f64;
    let steps = least.node_visits_per_ray.max(least.triangle_tests_per_ray);
    let missed = distances.misses(cache_bytes / LINE_BYTES) as f64 / rays;
    let traffic = Traffic { cycles_per_ray: steps, bytes_per_ray: missed * LINE_BYTES as f64 };
    let largest = dst.words().len().max(dst.triangles.len()) as u32;
    let document = Document {
        scene: scene.name.clone(),
        triangles: scene.mesh.triangles.len(),
        test: args.test.name(),
        rays: sweep.rays(),
        max_image_error: args.max_image_error,
        max_false_miss: args.max_false_miss,
        max_extra_visits: args.max_extra_visits,
        most_visits,
        beyond_most_visits,
        variant: args.variant.name(),
        significand_bits,
        exponent_bits: format.exponent_bits(),
        export_format: export_format(format).map(StandardFormat::name),
        stack_entries: least.stack_depth,
        address_bits: u32::BITS - (largest - 1).leading_zeros(),
        carve_levels: carve_visits.iter().filter(|visits| **visits > 0).count(),
        cache_bytes,
        tms: multiprocessors_until_bound(&traffic),
        tms_method: "analytic bound: a node and a triangle a cycle per multiprocessor, private caches, peak DRAM rate",
        significand_sweep,
        exponent_sweep,
        carve_visits,
        miss_curve,
        artifacts: vec![],
    };
    artifacts.write("needs.toml", toml_of(&document)?.as_bytes())?;
    artifacts.write("machine.toml", machine(&document)?.to_toml().as_bytes())?;
    for (name, chart) in charts(&document) {
        artifacts.write(&format!("{name}.svg"), chart.svg().as_bytes())?;
    }
    let artifacts = artifacts.finish()?.iter().map(|path| display(path)).collect();
    let document = Document { artifacts, ..document };
    let text = text(&document);
    Ok(Report::new(&document, text))
}

/// What binary32 robust traversal reads, one ray after the other, and the carve nodes that it passes.
fn observe(dst: &Dst, sweep: &Sweep<'_>) -> (Vec<u32>, [u64; golden::dst::MAX_CARVES]) {
    let mut lines = LineStream::new(dst.node_bytes());
    let mut carves = CarveLevels::new(dst);
    sweep.for_each_ray(|ray: &TraversalRay, occlusion| {
        if occlusion {
            dst.occluded_prepared(ray, &mut lines);
            dst.occluded_prepared(ray, &mut carves);
        } else {
            dst.closest_prepared(ray, &mut lines);
            dst.closest_prepared(ray, &mut carves);
        }
    });
    (lines.lines, carves.visits)
}

/// The narrowest format that modules exist for and that has all bits of `format`.
fn export_format(format: Format) -> Option<StandardFormat> {
    let holds = |f: &StandardFormat| {
        let f = f.format();
        f.exponent_bits() >= format.exponent_bits() && f.significand_bits() >= format.significand_bits()
    };
    StandardFormat::ALL.iter().copied().filter(holds).min_by_key(|f| f.format().width())
}

fn toml_of(d: &Document) -> anyhow::Result<String> {
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
    Ok(toml::to_string(&toml)?)
}

/// The preset machine with this cache and number of multiprocessors, for `dualsplit simulate --machine`.
fn machine(d: &Document) -> anyhow::Result<MachineDescription> {
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

fn charts(d: &Document) -> Vec<(&'static str, Chart)> {
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

fn text(d: &Document) -> String {
    let mut text = format!(
        "{}: {} triangles, {}, {} rays; image error at most {}, false misses at most {}, visits at most {} % more than in \
         binary32\n\n",
        d.scene,
        d.triangles,
        d.test,
        d.rays,
        d.max_image_error,
        d.max_false_miss,
        fixed(100.0 * d.max_extra_visits, 1)
    );
    let row = |name: &str, value: String, why: String| [name.to_owned(), value, why];
    let budget = format!("{}, within the budget", d.variant);
    let tms = d.tms.map(|tms| tms.to_string()).unwrap_or_else(|| "any".to_owned());
    let miss = d.miss_curve.iter().find(|p| p.bytes == d.cache_bytes).map_or(0.0, |p| p.miss_ratio);
    let export = d.export_format.unwrap_or("none");
    text += &table(
        ["need", "value", "why"],
        [
            row("significand bits", d.significand_bits.to_string(), budget.clone()),
            row("exponent bits", d.exponent_bits.to_string(), budget),
            row(
                "format to export",
                export.to_owned(),
                "the narrowest with modules and these bits".to_owned(),
            ),
            row("stack entries", d.stack_entries.to_string(), "the most that any ray stacks".to_owned()),
            row("address bits", d.address_bits.to_string(), "words of the tree, or triangles".to_owned()),
            row("carve levels", d.carve_levels.to_string(), "the longest chain that a ray passes".to_owned()),
            row(
                "cache bytes",
                d.cache_bytes.to_string(),
                format!("knee, {} of accesses miss", fixed(miss, 3)),
            ),
            row(
                "multiprocessors",
                tms,
                format!("until {DRAM_BYTES_PER_CYCLE} bytes a cycle are asked for; {}", d.tms_method),
            ),
        ],
    );
    if !d.beyond_most_visits.is_empty() {
        text += &format!(
            "\nNot in the charts, as they visit more than {} times the nodes of binary32: {}, and narrower ones.\n",
            fixed(d.most_visits, 0),
            d.beyond_most_visits.join(", ")
        );
    }
    text += &format!("\n{}\n", d.artifacts.join(", "));
    text
}
