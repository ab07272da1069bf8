//! The study of stability: every method, judged by the exact oracle on inputs made to break it.

use super::{Bench, Cell, Instance, Method, Structures, aimed_cells, search, slice};
use crate::artifacts::Artifacts;
use crate::input::display;
use crate::progress::{Part, Progress};
use netlist::Flat;
use rayon::prelude::*;
use scenes::Mesh;
use serde::Serialize;
use std::collections::BTreeSet;
use std::path::PathBuf;
use std::sync::Arc;
use stress::cases;
use stress::shapes::{box_triangles, closed_sphere, grid, moved, soup};
use view::picture::png;

/// The methods, the number of rays, and the folder of the results.
#[derive(Clone, Debug)]
pub struct Options {
    /// The most rays of each known case.
    pub rays: u64,
    /// Number of rays that are aimed at corners, edges and faces of four meshes, at least 4.
    pub aimed: u64,
    /// Number of rays per method and mesh that a search walks towards the worst case; none if 0.
    pub searches: u64,
    /// The methods; all if the list is empty.
    pub methods: Vec<Method>,
    /// Draws the rays around a failure of each kind.
    pub pictures: bool,
    /// The folder that is written.
    pub out: PathBuf,
    /// Seed of the rays.
    pub seed: u64,
    /// Writes into the folder even if it holds files that the tool did not make.
    pub force: bool,
}

/// The counts of every method in every case.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct Stress {
    pub rays_per_case: u64,
    pub aimed_rays: u64,
    pub cells: Vec<Cell>,
    #[serde(skip)]
    pub artifacts: Vec<String>,
    /// The sum of each method's cells. It names the worst case in place of the case.
    #[serde(skip)]
    pub sums: Vec<(Method, Cell)>,
    /// Whether a method that must lose no hit lost one.
    #[serde(skip)]
    pub broken: bool,
}

/// Divisor of the number of rays for interpreted netlists, which take thousands of times as long as software.
const HARDWARE_SHARE: u64 = 50;
/// Steps of each walk of the search.
const SEARCH_STEPS: u32 = 400;

/// The meshes that rays are aimed at. They have planes in general position, planes that coincide, faces in planes of boxes,
/// and coordinates far larger than the object.
fn targets() -> [(&'static str, Mesh); 4] {
    let boxes = (0..27).flat_map(|i| {
        let low = [i % 3, i / 3 % 3, i / 9].map(|c| 1.5 * c as f32);
        box_triangles(low, low.map(|x| x + 1.0))
    });
    [
        ("aimed: sphere", closed_sphere(3)),
        ("aimed: grid", grid(12)),
        ("aimed: boxes", soup(boxes)),
        ("aimed: far sphere", moved(&closed_sphere(3), 1.0, [1e4, -3e3, 7.0])),
    ]
}

/// Runs all methods, and writes the cells and pictures of failures to a folder.
///
/// # Errors
/// A case cannot be built, or a file cannot be written.
pub fn run(args: &Options, progress: &dyn Progress) -> anyhow::Result<Stress> {
    let all = || Method::software().into_iter().chain(Method::hardware()).collect();
    let methods = if args.methods.is_empty() { all() } else { args.methods.clone() };
    let mut artifacts = Artifacts::create(&args.out, args.force)?;
    let netlists: Vec<Option<Arc<Flat>>> = methods.iter().map(|method| method.netlist()).collect();

    let mut cells = vec![];
    let mut pictured = BTreeSet::new();
    let cases = cases::all();
    let part = Part::begin(progress, cases.len() as u64, "cases");
    for case in cases {
        part.next(case.name);
        let bench = Bench::new(case, usize::try_from(args.rays)?)?;
        let structures = Structures::new(&bench.tree, &bench.triangles)?;
        let instances: Vec<Instance> = methods
            .iter()
            .zip(&netlists)
            .map(|(method, netlist)| method.instance(&structures, netlist.as_ref()))
            .collect();
        let run = |instance: &Instance| {
            let interpreted = instance.method.is_interpreted();
            let limit = if interpreted { (args.rays / HARDWARE_SHARE).max(1) } else { args.rays };
            bench.run(instance, limit as usize)
        };
        let results: Vec<Cell> = instances.par_iter().map(run).collect();
        for (instance, cell) in instances.iter().zip(&results) {
            let failed = cell.false_misses + cell.false_hits + cell.wrong_nearest > 0;
            let wanted = args.pictures && failed && is_pictured(instance.method);
            if let Some(slice) = wanted.then(|| slice(&bench, instance)).flatten() {
                let name = format!("{}-{}.png", instance.method.to_string().replace('/', "-"), slice.failure);
                if pictured.insert(name.clone()) {
                    artifacts.write(&name, &png::encode(&slice.picture))?;
                }
            }
        }
        cells.extend(results);
        part.advance(1);
    }
    drop(part);

    let targets = targets();
    let share = args.aimed / targets.len() as u64;
    let part = Part::begin(progress, args.aimed, "aimed rays");
    for (name, mesh) in &targets {
        part.next(name);
        cells.extend(aimed_cells(&methods, (name, mesh), share, args.seed, |rays| part.advance(rays))?);
    }
    drop(part);

    let part = Part::begin(progress, methods.len() as u64, "search");
    let searched = |method: &&Method| args.searches > 0 && !method.is_interpreted();
    for method in methods.iter().filter(searched) {
        part.next(&method.to_string());
        for (name, mesh) in &targets {
            let name = name.replace("aimed", "searched");
            let (cell, _) = search(*method, (&name, mesh), args.searches, SEARCH_STEPS, args.seed)?;
            cells.push(cell);
        }
        part.advance(1);
    }
    drop(part);

    let mut csv = csv::Writer::from_writer(vec![]);
    for cell in &cells {
        csv.serialize(cell)?;
    }
    artifacts.write("stress.csv", &csv.into_inner()?)?;
    let sums = sums(&methods, &cells);
    let broken = sums.iter().any(|(method, sum)| {
        method.arithmetic.is_safe() && (sum.traversal_failures() > 0 || sum.false_hits > 0)
    });
    Ok(Stress {
        rays_per_case: args.rays,
        aimed_rays: args.aimed,
        cells,
        artifacts: artifacts.finish()?.iter().map(|path| display(path)).collect(),
        sums,
        broken,
    })
}

/// Whether failures of the method are drawn. One structure stands for all, because all structures lose the same hits.
fn is_pictured(method: Method) -> bool {
    method.structure == golden::structure::StructureKind::Dst && !method.is_hardware()
}

/// The sum of each method's cells. It names the worst case in place of the case.
fn sums(methods: &[Method], cells: &[Cell]) -> Vec<(Method, Cell)> {
    let sum = |method: &Method| {
        let name = method.to_string();
        let mine: Vec<&Cell> = cells.iter().filter(|cell| cell.method == name).collect();
        let mut sum = Cell::new(*method, &worst_case(&mine).unwrap_or_default());
        mine.iter().for_each(|cell| sum.merge(cell));
        (*method, sum)
    };
    methods.iter().map(sum).collect()
}

/// The case with the largest fraction of wrong results.
fn worst_case(cells: &[&Cell]) -> Option<String> {
    let wrong = |cell: &Cell| cell.false_misses + cell.false_hits + cell.wrong_nearest;
    let fraction = |cell: &Cell| wrong(cell) as f64 / cell.rays.max(1) as f64;
    let worst =
        cells.iter().filter(|cell| wrong(cell) > 0).max_by(|a, b| fraction(a).total_cmp(&fraction(b)))?;
    Some(format!("{} ({:.1} %)", worst.case, 100.0 * fraction(worst)))
}
