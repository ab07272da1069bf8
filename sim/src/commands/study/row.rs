//! One line of the study's tables.

use golden::render::RenderOptions;
use scenes::Scene;
use serde::{Deserialize, Serialize};
use sim::machine::description::MachineDescription;
use sim::machine::frame::Frame;
use sim::machine::results::Results;

/// A simulated frame: what it is of, and what it came to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Row {
    pub preset: String,
    pub scene: String,
    pub triangles: u64,
    pub structure: String,
    pub test: String,
    pub width: u32,
    pub height: u32,
    pub tms: u32,
    /// Whether it belongs to the scaling runs.
    pub scaling: bool,
    pub node_bytes: u64,
    pub rays: u64,
    pub cycles: u64,
    pub frame_ms: f64,
    pub energy_mj: f64,
    pub dram_mj: f64,
    pub cache_mj: f64,
    pub compute_mj: f64,
    pub pipeline_mj: f64,
    pub area_mm2: f64,
    pub instructions: u64,
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
    /// Of everything that the run depends on.
    pub fingerprint: String,
}

/// What a run is of.
pub struct Run<'a> {
    pub preset: &'a str,
    pub scene: &'a Scene,
    pub structure: &'a str,
    pub test: &'a str,
    pub tms: u32,
    pub scaling: bool,
    pub node_bytes: usize,
    pub fingerprint: &'a str,
}

impl Row {
    pub fn new(run: Run<'_>, options: &RenderOptions, frame: &Frame, results: &Results) -> Self {
        let percent = |class: &str| results.thread_cycles[class];
        Self {
            preset: run.preset.to_owned(),
            scene: run.scene.name.clone(),
            triangles: run.scene.mesh.triangles.len() as u64,
            structure: run.structure.to_owned(),
            test: run.test.to_owned(),
            width: options.width,
            height: options.height,
            tms: run.tms,
            scaling: run.scaling,
            node_bytes: run.node_bytes as u64,
            rays: frame.rays,
            cycles: results.cycles.into(),
            frame_ms: results.frame_ms,
            energy_mj: results.energy_mj.total,
            dram_mj: results.energy_groups_mj.dram,
            cache_mj: results.energy_groups_mj.cache,
            compute_mj: results.energy_groups_mj.compute,
            pipeline_mj: results.energy_mj.pipeline,
            area_mm2: results.area_mm2.total,
            instructions: results.instructions.total,
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

/// Identifies everything that a run depends on but its scene, structure and test.
pub fn fingerprint(machine: &MachineDescription, seed: u64, detail: f64, width: u32, height: u32) -> String {
    let version = env!("CARGO_PKG_VERSION");
    let everything = format!("{version} {seed} {detail} {width}x{height}\n{}", machine.to_toml());
    // FNV-1a, 64 bits.
    let hash = everything
        .bytes()
        .fold(0xcbf2_9ce4_8422_2325u64, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3));
    format!("{hash:016x}")
}

/// The rows as CSV with a header.
pub fn csv<'a>(rows: impl Iterator<Item = &'a Row>) -> anyhow::Result<String> {
    let mut writer = csv::Writer::from_writer(vec![]);
    for row in rows {
        writer.serialize(row)?;
    }
    Ok(String::from_utf8(writer.into_inner()?)?)
}
