//! One line of the study's tables.

use super::jobs::{Preset, SCALING_SCENE, SCALING_TEST, Series, WIDTH_SCENES, WIDTH_TEST};
use machine::description::MachineDescription;
use machine::frame::MachineStructure;
use machine::results::Results;
use render::Test;
use serde::{Deserialize, Serialize};

/// A simulated frame: its scene, structure and machine, and its results.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[allow(missing_docs, reason = "keys of result files, with their units")]
pub struct Row {
    pub preset: String,
    pub scene: String,
    pub triangles: u64,
    pub structure: String,
    pub test: String,
    pub width: u32,
    pub height: u32,
    pub tms: u32,
    pub series: Series,
    /// Words of a load: 1, 2, 4 or line.
    pub load_words: String,
    /// `layout.alignment` of the machine; 0B where nodes are packed.
    #[serde(default)]
    pub alignment: String,
    /// Bytes of the nodes and of the gaps between them.
    pub node_bytes: u64,
    pub rays: u64,
    pub cycles: u64,
    pub frame_ms: f64,
    pub energy_mj: f64,
    pub dram_mj: f64,
    pub cache_mj: f64,
    pub compute_mj: f64,
    /// Caches, instruction caches, registers and local stores.
    pub on_chip_mj: f64,
    /// Units and pipelines.
    pub execution_mj: f64,
    pub l1_mj: f64,
    pub l2_mj: f64,
    pub icache_mj: f64,
    pub registers_mj: f64,
    pub local_store_mj: f64,
    pub units_mj: f64,
    pub pipeline_mj: f64,
    pub area_mm2: f64,
    pub instructions: u64,
    pub loads: u64,
    pub pipeline_operations: u64,
    pub issue_pct: f64,
    pub data_pct: f64,
    pub units_pct: f64,
    pub memory_pct: f64,
    pub fetch_pct: f64,
    pub nop_pct: f64,
    pub halted_pct: f64,
    pub l1_hit_pct: f64,
    pub l2_hit_pct: f64,
    pub dram_gb_s: f64,
    /// A hash of everything that the run's counts depend on except its scene and test.
    pub fingerprint: String,
}

/// What a row says beside the results.
pub(super) struct Run<'a> {
    pub preset: &'a str,
    pub size: &'a Preset,
    pub scene: &'a str,
    pub triangles: u64,
    pub structure: MachineStructure,
    pub test: Test,
    pub machine: &'a MachineDescription,
    pub series: Series,
    pub load_words: &'a str,
    pub node_bytes: u64,
    pub rays: u64,
    pub fingerprint: &'a str,
}

impl Row {
    /// The row of `run`, which has these `results`.
    pub(super) fn new(run: &Run<'_>, results: &Results) -> Self {
        let percent = |class: &str| results.thread_cycles[class];
        Self {
            preset: run.preset.to_owned(),
            scene: run.scene.to_owned(),
            triangles: run.triangles,
            structure: run.structure.name().to_owned(),
            test: run.test.name().to_owned(),
            width: run.size.width,
            height: run.size.height,
            tms: run.machine.chip.tms(),
            series: run.series,
            load_words: run.load_words.to_owned(),
            alignment: run.machine.layout.alignment.to_string(),
            node_bytes: run.node_bytes,
            rays: run.rays,
            cycles: results.cycles.into(),
            frame_ms: results.frame_ms,
            energy_mj: results.energy_mj.total,
            dram_mj: results.energy_groups_mj.dram,
            cache_mj: results.energy_groups_mj.cache,
            compute_mj: results.energy_groups_mj.compute,
            on_chip_mj: results.energy_storage_mj.on_chip,
            execution_mj: results.energy_storage_mj.execution,
            l1_mj: results.energy_mj.l1,
            l2_mj: results.energy_mj.l2,
            icache_mj: results.energy_mj.icache,
            registers_mj: results.energy_mj.registers,
            local_store_mj: results.energy_mj.local_store,
            units_mj: results.energy_mj.units,
            pipeline_mj: results.energy_mj.pipeline,
            area_mm2: results.area_mm2.total,
            instructions: results.instructions.total,
            loads: results.instructions.loads,
            pipeline_operations: results.instructions.pipeline,
            issue_pct: percent("issue"),
            data_pct: percent("data"),
            units_pct: percent("units"),
            memory_pct: percent("memory"),
            fetch_pct: percent("fetch"),
            nop_pct: percent("nop"),
            halted_pct: percent("halted"),
            l1_hit_pct: results.caches.l1_hit_pct,
            l2_hit_pct: results.caches.l2_hit_pct,
            dram_gb_s: results.bandwidth_gb_s.dram,
            fingerprint: run.fingerprint.to_owned(),
        }
    }
}

/// The scenes of `rows`, in the order of the catalogue.
pub(super) fn scenes(rows: &[Row]) -> Vec<&str> {
    let names = scenes::procedural::CATALOGUE.iter().map(|entry| entry.name);
    names.filter(|name| rows.iter().any(|row| row.scene == *name)).collect()
}

/// The rows of a series, with those of the main series that belong to it, in the order of the quantity that it varies.
pub(super) fn of_series(rows: &[Row], series: Series) -> Vec<Row> {
    let belongs = |row: &&Row| {
        row.series == series
            || row.series == Series::Main
                && match series {
                    Series::Main | Series::Layout => true,
                    Series::Scaling => row.scene == SCALING_SCENE && row.test == SCALING_TEST.name(),
                    Series::LoadWidth => {
                        WIDTH_SCENES.contains(&row.scene.as_str()) && row.test == WIDTH_TEST.name()
                    }
                }
    };
    let mut chosen: Vec<Row> = rows.iter().filter(belongs).cloned().collect();
    let place = |row: &Row| scenes::procedural::CATALOGUE.iter().position(|entry| entry.name == row.scene);
    let key = |row: &Row| {
        let varied = (row.tms, row.load_words.clone(), row.alignment.clone());
        (place(row), row.test.clone(), row.structure.clone(), varied)
    };
    chosen.sort_by_key(key);
    chosen
}

/// The rows as CSV with a header.
pub(super) fn csv<'a>(rows: impl Iterator<Item = &'a Row>) -> anyhow::Result<String> {
    let mut writer = csv::Writer::from_writer(vec![]);
    for row in rows {
        writer.serialize(row)?;
    }
    Ok(String::from_utf8(writer.into_inner()?)?)
}
