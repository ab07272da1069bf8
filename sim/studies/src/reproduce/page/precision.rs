//! The sections about speed against accuracy, of the hardware and of the simulator, about stability, and about needs.

use super::super::stages::Outcome;
use super::{Results, cell, rows};
use serde_json::Value;
use view::report::{Item, Section, Table};

/// A section for each of these parts that the job has.
pub fn sections(results: &Results<'_>) -> anyhow::Result<Vec<Section>> {
    let mut sections = vec![];
    if let Some(outcome) = results.outcome("precision") {
        sections.push(precision(results, outcome)?);
    }
    if let Some(outcome) = results.outcome("fidelity") {
        sections.push(fidelity(results, outcome)?);
    }
    sections.extend(results.outcome("stress").map(stability));
    sections.extend(needs(results));
    Ok(sections)
}

fn precision(results: &Results<'_>, outcome: &Outcome) -> anyhow::Result<Section> {
    let figure = |file: &str, caption: &str| {
        results.figure(outcome, "precision", (&format!("{file}.svg"), "precision.csv"), caption)
    };
    let mut items = vec![
        figure("wrong-rays", "Naive rounding loses hits; conservative rounding loses none in any format.")?,
        figure("visits", "What conservative rounding costs: more nodes, the fewer bits the more.")?,
    ];
    if rows(&outcome.report["points"]).iter().any(|point| point["frame_ms"].is_number()) {
        items.push(figure("frame-time", "The dual-split tree on the machine.")?);
    }
    items.push(figure(
        "energy",
        "Speed and accuracy against each other: the fewest bits are not the least energy.",
    )?);
    let shown = ["binary32", "tf32", "bfloat16", "binary16"];
    let points = rows(&outcome.report["points"]).iter();
    let named = points.filter(|point| shown.iter().any(|format| point["format"] == *format));
    let keys = [
        "format",
        "variant",
        "node_visits_per_ray",
        "false_misses",
        "rmse",
        "frame_ms",
        "area_um2",
        "energy_pj_per_ray",
    ];
    let header =
        ["format", "variant", "visits/ray", "false misses", "RMSE", "frame ms", "area um2", "pJ/ray"];
    let table = Table::new(header, named.map(|point| keys.map(|key| cell(&point[key]))));
    items.push(Item::Table(table.from("../precision/precision.csv", &outcome.command)));
    let mut text = vec![format!(
        "Traversal in every format of the floating-point units, everything rounded to nearest (naive) or to bounds \
         (conservative); triangles are tested in binary32 throughout. Sample: {} rays of {}.",
        cell(&outcome.report["rays"]),
        cell(&outcome.report["scene"])
    )];
    let left_out: Vec<String> = rows(&outcome.report["left_out"]).iter().map(cell).collect();
    if !left_out.is_empty() {
        let most = cell(&outcome.report["most_visits"]);
        text.push(format!(
            "Left out, as they visit more than {most} times the nodes of binary32: {}.",
            left_out.join(", ")
        ));
    }
    Ok(Section { title: "Precision of the hardware".into(), text, items })
}

fn fidelity(results: &Results<'_>, outcome: &Outcome) -> anyhow::Result<Section> {
    let figure = |file: &str, caption: &str| {
        results.figure(outcome, "fidelity", (&format!("{file}.svg"), "fidelity.csv"), caption)
    };
    let points = rows(&outcome.report["points"]);
    let header = [
        "level",
        "warming",
        "batches",
        "pixels timed",
        "host s",
        "time error %",
        "+-",
        "energy error %",
        "+-",
    ];
    let number = |point: &Value, key: &str, decimals: usize| {
        format!("{:.decimals$}", point[key].as_f64().unwrap_or(f64::NAN))
    };
    let lines = points.iter().map(|point| {
        let share = 100.0 * point["pixels_timed_share"].as_f64().unwrap_or(f64::NAN);
        [
            cell(&point["level"]),
            cell(&point["warming"]),
            cell(&point["batches"]),
            format!("{share:.0}%"),
            number(point, "seconds", 3),
            number(point, "time_error_pct", 2),
            number(point, "time_interval_pct", 2),
            number(point, "energy_error_pct", 2),
            number(point, "energy_interval_pct", 2),
        ]
    });
    let table = Table::new(header, lines).from("../fidelity/fidelity.csv", &outcome.command);
    Ok(Section {
        title: "Fidelity of the simulator".into(),
        text: vec![
            "A frame is simulated as a bound from its work, as transactions, or with every pipeline operation executed by its \
             netlist, on all pixels or on batches drawn at random. Errors are against the most detailed run of all rays; \
             bars are 95 % intervals. Without warming, cold caches would make a sample's rays dearer than the frame's."
                .into(),
            "dualsplit simulate --fidelity auto takes the cheapest that is within a tolerance.".into(),
        ],
        items: vec![
            figure("time-error", "Host time against error in frame time.")?,
            figure("energy-error", "Host time against error in energy.")?,
            Item::Table(table),
        ],
    })
}

/// Counts of wrong results by method, summed over all cases.
fn stability(outcome: &Outcome) -> Section {
    const KEYS: [&str; 7] =
        ["rays", "false_misses", "false_hits", "wrong_nearest", "nan", "lost", "excess_visits"];
    let cells = rows(&outcome.report["cells"]);
    let mut methods: Vec<(&str, [u64; 7], u64)> = vec![];
    for one in cells {
        let Some(name) = one["method"].as_str() else { continue };
        let at = methods.iter().position(|(other, ..)| *other == name).unwrap_or_else(|| {
            methods.push((name, [0; 7], 0));
            methods.len() - 1
        });
        for (sum, key) in methods[at].1.iter_mut().zip(KEYS) {
            *sum += one[key].as_u64().unwrap_or(0);
        }
        methods[at].2 += one["triangle_test"].as_u64().unwrap_or(0);
    }
    let rays: u64 = methods.iter().map(|(_, sums, _)| sums[0]).sum();
    let header = [
        "method",
        "rays",
        "false misses",
        "false hits",
        "wrong nearest",
        "NaN",
        "lost by traversal",
        "excess visits",
        "wrong by triangle test",
    ];
    let lines = methods.iter().map(|(name, sums, triangle_test)| {
        let mut line: [String; 9] = Default::default();
        line[0] = (*name).to_owned();
        line[1..8].iter_mut().zip(sums).for_each(|(cell, sum)| *cell = sum.to_string());
        line[8] = triangle_test.to_string();
        line
    });
    let table = Table::new(header, lines).from("../stress/stress.csv", &outcome.command);
    Section {
        title: "Stability where methods fail".into(),
        text: vec![format!(
            "Every structure and arithmetic, and the netlists, on inputs made to break them: the 33 known cases, rays aimed at \
             corners, edges and faces, and rays that a search walks towards the worst, one unit in the last place at a time. \
             Judged by exact rational arithmetic; {rays} rays in all. Robust and conservative methods must lose none; naive and \
             fast ones show what happens without."
        )],
        items: vec![Item::Table(table)],
    }
}

fn needs(results: &Results<'_>) -> Option<Section> {
    let all: Vec<&(String, Outcome)> =
        results.outcomes.iter().filter(|(name, _)| name.starts_with("needs-")).collect();
    let (_, first) = all.first()?;
    let keys = [
        "scene",
        "triangles",
        "rays",
        "significand_bits",
        "exponent_bits",
        "stack_entries",
        "address_bits",
        "carve_levels",
        "cache_bytes",
        "tms",
    ];
    let header = [
        "scene",
        "triangles",
        "rays",
        "significand bits",
        "exponent bits",
        "stack entries",
        "address bits",
        "carve levels",
        "cache bytes",
        "TMs until memory-bound",
    ];
    let table = Table::new(header, all.iter().map(|(_, outcome)| keys.map(|key| cell(&outcome.report[key]))));
    Some(Section {
        title: "No more than a scene needs".into(),
        text: vec![
            "The least hardware with which no hit is lost, no pixel differs, and at most 5 % more nodes are visited. Each \
             row is also a machine file, needs.toml, in the folder of its command."
                .into(),
        ],
        items: vec![Item::Table(table.from("", &first.command))],
    })
}
