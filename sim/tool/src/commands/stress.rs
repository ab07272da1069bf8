//! `dualsplit stress`: every method against the exact oracle, on inputs made to break it.

use crate::artifacts::Artifacts;
use crate::cli::{Global, StressArgs};
use crate::console::{Report, fixed, progress, table};
use crate::input::display;
use netlist::Flat;
use rayon::prelude::*;
use scenes::Mesh;
use serde::Serialize;
use std::collections::BTreeSet;
use std::sync::Arc;
use stress::cases;
use stress::shapes::{box_triangles, closed_sphere, grid, moved, soup};
use studies::stress::{Bench, Cell, Instance, Method, Structures, aimed_cells, search, slice};
use view::picture::png;

#[derive(Serialize)]
struct Document {
    rays_per_case: u64,
    aimed_rays: u64,
    cells: Vec<Cell>,
    artifacts: Vec<String>,
}

/// An interpreted netlist takes thousands of times as long as software: it gets this fraction of the rays.
const HARDWARE_SHARE: u64 = 50;
/// Steps of each walk of the search.
const SEARCH_STEPS: u32 = 400;

/// What rays are aimed at: planes in general position, planes that coincide, faces that are planes of boxes, and
/// coordinates far larger than the object.
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

pub fn run(args: &StressArgs, global: &Global) -> anyhow::Result<Report> {
    let methods = methods(args);
    let mut artifacts = Artifacts::create(&args.out, global.force)?;
    let netlists: Vec<Option<Arc<Flat>>> = methods.iter().map(|method| method.netlist()).collect();

    let mut cells = vec![];
    let mut pictured = BTreeSet::new();
    let cases = cases::all();
    let bar = progress(cases.len() as u64, "cases");
    for case in cases {
        bar.set_message(case.name);
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
        bar.inc(1);
    }
    bar.finish_and_clear();

    let targets = targets();
    let share = args.aimed / targets.len() as u64;
    let bar = progress(args.aimed, "aimed rays");
    for (name, mesh) in &targets {
        bar.set_message(*name);
        cells.extend(aimed_cells(&methods, (name, mesh), share, global.seed, |rays| bar.inc(rays))?);
    }
    bar.finish_and_clear();

    let bar = progress(methods.len() as u64, "search");
    for method in methods.iter().filter(|method| !method.is_interpreted()) {
        bar.set_message(method.to_string());
        for (name, mesh) in &targets {
            let name = name.replace("aimed", "searched");
            let (cell, _) = search(*method, (&name, mesh), args.searches, SEARCH_STEPS, global.seed)?;
            cells.push(cell);
        }
        bar.inc(1);
    }
    bar.finish_and_clear();

    let mut csv = csv::Writer::from_writer(vec![]);
    for cell in &cells {
        csv.serialize(cell)?;
    }
    artifacts.write("stress.csv", &csv.into_inner()?)?;
    let broken = methods.iter().zip(sums(&methods, &cells)).any(|(method, sum)| {
        method.arithmetic.is_safe() && (sum.traversal_failures() > 0 || sum.false_hits > 0)
    });
    let text = text(&methods, &cells);
    let document = Document {
        rays_per_case: args.rays,
        aimed_rays: args.aimed,
        cells,
        artifacts: artifacts.finish()?.iter().map(|path| display(path)).collect(),
    };
    let mut report = Report::new(&document, text);
    report.difference = broken;
    Ok(report)
}

/// All methods, or those asked for.
fn methods(args: &StressArgs) -> Vec<Method> {
    if !args.method.is_empty() {
        return args.method.clone();
    }
    Method::software().into_iter().chain(Method::hardware()).collect()
}

/// One structure stands for all: they lose the same.
fn is_pictured(method: Method) -> bool {
    method.structure == golden::structure::StructureKind::Dst && !method.is_hardware()
}

/// The sum of each method's cells, with the worst case in the place of the case.
fn sums(methods: &[Method], cells: &[Cell]) -> Vec<Cell> {
    let sum = |method: &Method| {
        let name = method.to_string();
        let mine: Vec<&Cell> = cells.iter().filter(|cell| cell.method == name).collect();
        let mut sum = Cell::new(*method, &worst_case(&mine).unwrap_or_default());
        mine.iter().for_each(|cell| sum.merge(cell));
        sum
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

fn text(methods: &[Method], cells: &[Cell]) -> String {
    let header = [
        "method",
        "rays",
        "false misses",
        "false hits",
        "wrong nearest",
        "NaN",
        "lost by traversal",
        "wrong by triangle test",
        "excess visits",
        "least slack (ulps)",
        "worst case",
    ];
    let rows = methods.iter().zip(sums(methods, cells)).map(|(method, sum)| {
        [
            method.to_string(),
            sum.rays.to_string(),
            sum.false_misses.to_string(),
            sum.false_hits.to_string(),
            sum.wrong_nearest.to_string(),
            sum.nan.to_string(),
            sum.lost.to_string(),
            sum.triangle_test.to_string(),
            format!("{} of {}", sum.excess_visits, sum.visit_rays),
            sum.least_slack_ulps.map(|slack| fixed(slack, 1)).unwrap_or_default(),
            sum.case,
        ]
    });
    let mut text = table(header, rows);
    text += "\nFalse misses, false hits and wrong nearest are against the exact answer; lost by traversal against testing\n\
             every triangle with the same test, whose own errors are the next column. Each case is in stress.csv.\n";
    text
}
