//! The sections about the hardware: its equivalence to the specification, its units and its costs.

use super::super::stages::Outcome;
use super::{cell, rows};
use costs::{SOURCE, Unit};
use estimate::PaperFigures;
use pipelines::catalogue::{StandardFormat, Top};
use serde_json::Value;
use view::report::{Item, Section, Table};

/// The operations that `check` compared, and the number of those that differ.
pub fn compared(check: &Outcome) -> (u64, u64) {
    let units = rows(&check.report["units"]);
    let count = |key: &str| units.iter().filter_map(|unit| unit[key].as_u64()).sum::<u64>();
    (count("vectors"), count("mismatches"))
}

/// The check of the simulated netlists against golden.
pub fn equivalence(check: &Outcome) -> Section {
    let units = rows(&check.report["units"]);
    let (vectors, mismatches) = compared(check);
    let table = Table::new(
        "Simulated netlists against the exact software",
        ["unit", "operations", "mismatches", "operations per second"],
        units.iter().map(|unit| {
            ["name", "vectors", "mismatches", "vectors_per_second"].map(|key| match key {
                "vectors_per_second" => format!("{:.0}", unit[key].as_f64().unwrap_or(0.0)),
                _ => cell(&unit[key]),
            })
        }),
    );
    Section {
        title: "The hardware equals its specification".into(),
        text: vec![format!(
            "{vectors} operations of the simulated netlists, with stalls and bubbles, were compared with the exact software \
             cycle by cycle, bit for bit: {mismatches} differ. Proofs for all inputs: dualsplit check --prove."
        )],
        items: vec![Item::Table(table.from("../stages/check.json", &check.command))],
    }
}

/// Units, latency, area and energy of the pipelines beside the published figures, with costs by netlist if they were estimated.
pub fn pipelines(estimate: Option<&Outcome>) -> anyhow::Result<Section> {
    let mut items = vec![inventory()?];
    let mut text = vec![format!(
        "Counts and latency are read from the elaborated hardware. Area and energy of the units are sums of the {SOURCE}; \
         the published pipelines hold decoding logic besides."
    )];
    if let Some(estimate) = estimate {
        items.push(costs(estimate));
        text.push(
            "Below, the same pipelines by method: published takes the published unit costs and our own decoding logic, \
             netlist our whole netlist in a cell library, scaled the same at 65 nm. Numbers of different methods are not to \
             be mixed."
                .into(),
        );
    }
    Ok(Section { title: "Units and pipelines".into(), text, items })
}

/// Each pipeline by each method, with the source of the numbers.
fn costs(estimate: &Outcome) -> Item {
    let square_mm = |value: &Value| format!("{:.4}", value.as_f64().unwrap_or(f64::NAN) / 1e6);
    let nj = |value: &Value| format!("{:.4}", value.as_f64().unwrap_or(f64::NAN) / 1e3);
    let mut lines = vec![];
    for pipeline in rows(&estimate.report["pipelines"]) {
        let paper = &pipeline["published"];
        lines.push([
            cell(&pipeline["name"]),
            "paper".to_owned(),
            square_mm(&paper["area_um2"]),
            square_mm(&paper["glue_area_um2"]),
            nj(&paper["energy_pj"]),
            nj(&paper["glue_energy_pj"]),
            "Lin et al., HPG 2020".to_owned(),
        ]);
        for by in rows(&pipeline["estimates"]) {
            lines.push([
                cell(&pipeline["name"]),
                cell(&by["method"]),
                square_mm(&by["area_um2"]),
                square_mm(&by["glue_area_um2"]),
                nj(&by["energy_pj"]),
                nj(&by["glue_energy_pj"]),
                cell(&by["source"]),
            ]);
        }
    }
    let header = ["pipeline", "method", "mm2", "of it glue", "nJ", "of it glue", "source"];
    Item::Table(
        Table::new("Cost of the pipelines by method", header, lines)
            .from("../stages/estimate.json", &estimate.command),
    )
}

fn inventory() -> anyhow::Result<Item> {
    let mut rows = vec![];
    for top in [Top::DualSplit, Top::DualSplitLean, Top::RayBox, Top::RayBoxLean] {
        let inventory = netlist::inventory(&top.design(StandardFormat::Binary32)?)?;
        let units =
            || inventory.units.iter().filter_map(|(kind, &n)| Some((Unit::of_module(kind)?, f64::from(n))));
        let sum = |cost: fn(Unit) -> f64| units().map(|(unit, n)| n * cost(unit)).sum::<f64>();
        let count = |kind: &str| inventory.units.get(kind).copied().unwrap_or(0).to_string();
        let paper = PaperFigures::of(top)?;
        let is_lean = matches!(top, Top::DualSplitLean | Top::RayBoxLean);
        let published = |value: f64| if is_lean { String::new() } else { format!("{value:.4}") };
        rows.push([
            top.name().to_owned(),
            count("int_add"),
            count("fp_add"),
            count("fp_mul"),
            count("fp_min_max"),
            count("fp_cmp"),
            inventory.latency_cycles.map(|n| n.to_string()).unwrap_or_default(),
            format!("{:.4}", sum(|unit| unit.published().area_um2) / 1e6),
            format!("{:.4}", sum(|unit| unit.published().energy_pj) / 1e3),
            published(paper.area_um2 / 1e6),
            published(paper.energy_pj / 1e3),
            inventory.register_bits.to_string(),
        ]);
    }
    let header = [
        "pipeline",
        "INTADD",
        "FPADD",
        "FPMUL",
        "FPMIN/MAX",
        "FPCMP",
        "latency (cycles)",
        "units (mm2)",
        "units (nJ)",
        "published (mm2)",
        "published (nJ)",
        "register bits",
    ];
    Ok(Item::Table(Table::new("Units of the pipelines", header, rows).from("", "cargo test --test netlist")))
}
