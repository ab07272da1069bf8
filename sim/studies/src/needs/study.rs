//! The study of needs: all needs of one scene within an error budget, with a chart of each knee.

use super::carves::CarveLevels;
use super::files;
use super::knee;
use super::memory::{Traffic, multiprocessors_until_bound};
use super::reuse::{LINE_BYTES, LineStream, ReuseDistances};
use crate::artifacts::Artifacts;
use crate::charts::precision::{PrecisionPoint, Sweep, SweepError};
use crate::input::{Built, SceneSource, display};
use crate::progress::{Part, Progress};
use anyhow::bail;
use fp::Format;
use golden::TraversalRay;
use golden::build::Quality;
use golden::dst::Dst;
use golden::precision::{Precision, Variant};
use golden::structure::{Structure, StructureKind};
use golden::traverse::Trace;
use pipelines::catalogue::StandardFormat;
use render::{RenderOptions, Test};
use serde::Serialize;
use std::ops::RangeInclusive;
use std::path::PathBuf;

/// Cache sizes that are tried, as powers of two of bytes.
const CACHE_LOG2_BYTES: RangeInclusive<u32> = 8..=22;
/// Significands that are tried.
const SIGNIFICAND_BITS: RangeInclusive<u32> = 4..=24;
/// A format with more than this many times the node visits of binary32 is not traced to the end, and no narrower one is tried. Its
/// visits lie far beyond the knee, and with too few bits every ray visits the whole tree.
const MOST_VISITS: f64 = 16.0;
/// Exponents that are tried.
const EXPONENT_BITS: RangeInclusive<u32> = 3..=8;

/// The scene, the budget and the folder.
#[derive(Clone, Debug)]
pub struct Options {
    /// The scene, whose seed is also that of the rays.
    pub scene: SceneSource,
    /// The test: primary and shadow rays, or paths.
    pub test: Test,
    /// How traversal in narrow formats rounds.
    pub variant: Variant,
    /// The greatest root mean square error of linear radiance against binary32.
    pub max_image_error: f64,
    /// The greatest number of rays that lose their hit.
    pub max_false_miss: u64,
    /// The greatest number of node visits beyond those of binary32, as a fraction of the latter.
    pub max_extra_visits: f64,
    /// How the tree is built.
    pub quality: Quality,
    /// Width and height of the image in pixels.
    pub size: [u32; 2],
    /// The folder that is written; if absent, `needs-` and the scene's name.
    pub out: Option<PathBuf>,
    /// Writes into the folder even if it holds files that the tool did not make.
    pub force: bool,
}

/// The needs of a scene, and the measurements that they follow from.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct Needs {
    pub scene: String,
    pub triangles: usize,
    pub test: &'static str,
    pub rays: u64,
    pub max_image_error: f64,
    pub max_false_miss: u64,
    pub max_extra_visits: f64,
    /// Each sweep ends before the first format with more than this many times the node visits of binary32.
    pub most_visits: f64,
    /// The formats that ended the sweeps.
    pub beyond_most_visits: Vec<String>,
    pub variant: &'static str,
    pub significand_bits: u32,
    pub exponent_bits: u32,
    /// The narrowest format of `dualsplit export` that has at least as many exponent and significand bits.
    pub export_format: Option<&'static str>,
    pub stack_entries: u32,
    pub address_bits: u32,
    pub carve_levels: usize,
    pub cache_bytes: u64,
    /// The number of multiprocessors; absent if no access misses the cache.
    pub tms: Option<u32>,
    pub tms_method: &'static str,
    pub significand_sweep: Vec<PrecisionPoint>,
    pub exponent_sweep: Vec<PrecisionPoint>,
    pub carve_visits: [u64; golden::dst::MAX_CARVES],
    pub miss_curve: Vec<CachePoint>,
    /// The folder that was written.
    #[serde(skip)]
    pub folder: PathBuf,
    #[serde(skip)]
    pub artifacts: Vec<String>,
}

/// The miss ratio of a cache of some size.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct CachePoint {
    pub bytes: u64,
    pub miss_ratio: f64,
}

/// Finds what the scene needs, and writes it with charts to a folder.
///
/// # Errors
/// The scene cannot be loaded, no format is within the budget, or a file cannot be written.
pub fn run(args: &Options, progress: &dyn Progress) -> anyhow::Result<Needs> {
    let scene = args.scene.load(progress)?;
    let folder = args.out.clone().unwrap_or_else(|| format!("needs-{}", scene.name).into());
    let mut artifacts = Artifacts::create(&folder, args.force)?;
    let built = Built::new(&scene, args.quality, progress)?;
    let [width, height] = args.size;
    let options = RenderOptions { seed: args.scene.seed, ..RenderOptions::new(args.test, width, height) };
    let sweep = Sweep::new(&scene, &built.tree, &built.triangles, StructureKind::Dst, options)?;
    let Structure::Dst(dst) = sweep.structure() else { unreachable!("the kind that was asked for") };

    let precision = |e: u32, s: u32| Ok(Precision::new(Format::new(e, s)?, args.variant));
    let count = SIGNIFICAND_BITS.count() + EXPONENT_BITS.count();
    let part = Part::begin(progress, count as u64, "formats");
    let reference = sweep.reference_counters.node_visits as f64;
    let most_visits = MOST_VISITS.max(2.0 * (1.0 + args.max_extra_visits));
    let mut beyond_most_visits = vec![];
    // The points of `precisions` up to the first format with too many visits.
    let mut points = |precisions: Vec<Precision>| {
        let mut points = vec![];
        for precision in precisions {
            part.next(&precision.to_string());
            part.advance(1);
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
    // The narrowest format of an unbroken row from the widest. One that fits below a failure does so by luck.
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
    drop(part);
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
    let needs = Needs {
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
        folder,
        artifacts: vec![],
    };
    artifacts.write("needs.toml", files::machine(&needs)?.to_toml().as_bytes())?;
    for (name, chart) in files::charts(&needs) {
        artifacts.write(&format!("{name}.svg"), chart.svg().as_bytes())?;
    }
    let artifacts = artifacts.finish()?.iter().map(|path| display(path)).collect();
    Ok(Needs { artifacts, ..needs })
}

/// The lines that binary32 robust traversal reads, one ray after the other, and its visits of carve nodes by place in the chain.
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

/// The narrowest format that modules exist for and that has at least as many exponent and significand bits as `format`.
fn export_format(format: Format) -> Option<StandardFormat> {
    let holds = |f: &StandardFormat| {
        let f = f.format();
        f.exponent_bits() >= format.exponent_bits() && f.significand_bits() >= format.significand_bits()
    };
    StandardFormat::ALL.iter().copied().filter(holds).min_by_key(|f| f.format().width())
}
