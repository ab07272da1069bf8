//! The sections about speed against accuracy, of the hardware and of the simulator, and about needs.

use super::super::stages::Outcome;
use super::{Results, cell, rows, stability};
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
    if let Some(outcome) = results.outcome("stress") {
        sections.push(stability::section(outcome, &results.folder.join("stress"))?);
    }
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
    let caption = "Formats that have names";
    let table = Table::new(caption, header, named.map(|point| keys.map(|key| cell(&point[key]))));
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
    let caption = "Levels and samples against the whole frame";
    let table = Table::new(caption, header, lines).from("../fidelity/fidelity.csv", &outcome.command);
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
    let caption = "The least hardware for each scene";
    let table = Table::new(
        caption,
        header,
        all.iter().map(|(_, outcome)| keys.map(|key| cell(&outcome.report[key]))),
    );
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
