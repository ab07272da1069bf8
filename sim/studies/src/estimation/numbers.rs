//! The report as CSV with one row for each number, and the sources of the numbers.

use super::Estimates;
use anyhow::Context;
use estimate::Breakdown;
use gates::liberty::Library;
use std::collections::BTreeMap;

/// The report as CSV, one row for each number.
pub fn csv(document: &Estimates) -> anyhow::Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(["pipeline", "method", "quantity", "part", "value", "unit", "source"])?;
    for pipeline in document.pipelines.iter().chain(&document.lean_pipelines) {
        let mut row = |method: &str, quantity: &str, part: &str, value: f64, unit: &str, source: &str| {
            writer.write_record([pipeline.name, method, quantity, part, &value.to_string(), unit, source])
        };
        let paper = &pipeline.published;
        row("paper", "area", "all", paper.area_um2, "um2", "Lin et al., HPG 2020")?;
        row("paper", "energy", "all", paper.energy_pj, "pJ", "Lin et al., HPG 2020")?;
        for estimate in &pipeline.estimates {
            row(estimate.method, "area", "all", estimate.area_um2, "um2", &estimate.source)?;
            row(estimate.method, "area", "glue", estimate.glue_area_um2, "um2", &estimate.source)?;
            row(estimate.method, "energy", "all", estimate.energy_pj, "pJ", &estimate.source)?;
            row(estimate.method, "energy", "glue", estimate.glue_energy_pj, "pJ", &estimate.source)?;
        }
        let source = &document.library.source;
        for (part, value) in parts(&pipeline.area) {
            row("netlist", "area", &part, value, "um2", source)?;
        }
        for (part, value) in parts(&pipeline.energy) {
            row("netlist", "energy", &part, value, "fJ", source)?;
        }
        for (part, value) in parts(&pipeline.energy_with_glitches) {
            row("netlist", "energy with glitches", &part, value, "fJ", source)?;
        }
    }
    let provenance = &document.provenance;
    for pipeline in document.pipelines.iter().chain(&document.lean_pipelines) {
        let mut row = |quantity: &str, part: &str, value: f64, unit: &str, key: &str| {
            let value = value.to_string();
            writer.write_record([pipeline.name, "netlist", quantity, part, &value, unit, &provenance[key]])
        };
        row("critical path", "all", pipeline.critical_path_ns, "ns", "critical_path_ns")?;
        row("leakage", "all", pipeline.leakage_uw, "uW", "leakage_uw")?;
        for found in &pipeline.node_types {
            let name = found.node_type.name();
            row("energy", name, found.energy.total(), "fJ", "node_types")?;
            row("energy with glitches", name, found.energy_with_glitches.total(), "fJ", "node_types")?;
        }
        for module in &pipeline.modules {
            row("area of module", &module.module, module.area_um2, "um2", "modules")?;
            row("area of module's registers", &module.module, module.register_area_um2, "um2", "modules")?;
        }
    }
    for found in &document.scenes {
        let mut row = |quantity: &str, value: f64| {
            let (value, source) = (value.to_string(), &provenance["scenes"]);
            writer.write_record([found.pipeline, "netlist", quantity, &found.scene, &value, "fJ", source])
        };
        row("energy in scene", found.energy.zero_delay.total())?;
        row("energy with glitches in scene", found.energy.with_glitches.total())?;
    }
    for found in &document.synthesis {
        let (value, source) =
            (found.logic_area_um2.to_string(), format!("{}, {}", provenance["synthesis"], found.flow));
        writer.write_record([found.pipeline, "synthesis", "area", "logic", &value, "um2", &source])?;
    }
    writer.into_inner().context("estimate.csv")
}

/// The sources of the numbers, by the keys of the document.
pub fn provenance(library: &Library) -> BTreeMap<&'static str, String> {
    let netlist =
        format!("our netlist mapped to {} ({} V), without wires", library.source, library.voltage_v);
    let energy = format!("{netlist}; changes of every net in real traversal, times the library's energies");
    BTreeMap::from([
        (
            "published",
            "Lin, Vasiou, Yuksel, Kopta, Brunvand, HPG 2020; latency and units as described there".to_owned(),
        ),
        ("units", "counted in our elaborated hierarchy".to_owned()),
        ("area", netlist.clone()),
        ("energy", format!("{energy}, without delays")),
        ("energy_with_glitches", format!("{energy}, event by event with the cells' delays, on a sample")),
        (
            "critical_path_ns",
            format!("{netlist}; static timing by the library's tables after buffering and sizing"),
        ),
        ("leakage_uw", format!("{netlist}; the library's mean leakage of each cell")),
        ("modules", netlist.clone()),
        ("node_types", format!("{energy}; operations of one type back to back, in the order of the rays")),
        ("scenes", format!("{energy}; operations as the scene's rays meet them")),
        ("ratios", "quotients of the rows above".to_owned()),
        ("synthesis", "the exported Verilog".to_owned()),
    ])
}

/// The parts of a breakdown, by name.
pub fn parts(breakdown: &Breakdown) -> Vec<(String, f64)> {
    let units = breakdown.units.iter().map(|(unit, value)| (format!("{unit:?}"), *value));
    let rest = [
        ("glue", breakdown.glue),
        ("registers", breakdown.registers),
        ("clock", breakdown.clock),
        ("inputs", breakdown.inputs),
    ];
    units.chain(rest.map(|(part, value)| (part.to_owned(), value))).collect()
}
