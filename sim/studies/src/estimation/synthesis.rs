//! Synthesis of the exported Verilog by yosys and ABC, for comparison with our mapping.

use crate::progress::{Part, Progress};
use anyhow::{Context, bail, ensure};
use base::output::Unfinished;
use estimate::Implementation;
use gates::liberty::Library;
use gates::words::Structures;
use netlist::verilog::text;
use serde::Serialize;
use std::path::Path;
use std::process::{Command, Stdio};

/// The result of one flow for one pipeline.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct SynthesisRow {
    pub pipeline: &'static str,
    pub flow: String,
    pub cells: usize,
    pub logic_area_um2: f64,
    pub register_area_um2: f64,
    pub critical_path_ns: Option<f64>,
}

/// The results of our flow and of yosys and ABC, for each pipeline.
pub fn run(
    implementations: &[Implementation],
    liberty: &Path,
    progress: &dyn Progress,
) -> anyhow::Result<Vec<SynthesisRow>> {
    let version = Command::new("yosys")
        .arg("-V")
        .output()
        .context("--synth: yosys; install it, or leave out --synth")?;
    let version =
        String::from_utf8_lossy(&version.stdout).split_whitespace().take(2).collect::<Vec<_>>().join(" ");
    let folder = tempfile::tempdir().context("a temporary folder cannot be made")?;
    let _unfinished = Unfinished::new(folder.path());
    rows(implementations, liberty, (&version, folder.path()), progress)
}

fn rows(
    implementations: &[Implementation],
    liberty: &Path,
    (version, folder): (&str, &Path),
    progress: &dyn Progress,
) -> anyhow::Result<Vec<SynthesisRow>> {
    let library = folder.join("cells.lib");
    std::fs::write(&library, gates::liberty::file_text(liberty)?)?;
    let mut rows = Vec::new();
    for implementation in implementations {
        rows.push(ours(implementation, "ours".to_owned()));
        if implementation.library.clock_gate.is_some() {
            let multiplexed = Library { clock_gate: None, ..implementation.library.clone() };
            let structures = Structures::default();
            let same = Implementation::new(implementation.top, &multiplexed, structures)?;
            rows.push(ours(&same, "ours, a multiplexer for each enable".to_owned()));
        }
        let part = Part::endless(progress, &format!("yosys and ABC on {}", implementation.top));
        let log = yosys(implementation, folder)?;
        drop(part);
        rows.push(parse(implementation, &log, format!("{version}, ABC"))?);
    }
    Ok(rows)
}

fn ours(implementation: &Implementation, flow: String) -> SynthesisRow {
    let area = implementation.area();
    SynthesisRow {
        pipeline: implementation.top.name(),
        flow,
        cells: implementation.mapped.gates.len() + implementation.mapped.registers.len(),
        logic_area_um2: area.logic() + area.clock,
        register_area_um2: area.registers,
        critical_path_ns: Some(implementation.timing.critical_path_ns),
    }
}

/// The log of synthesis. ABC is given a driving cell and a load, so that it sizes cells and reports the delay.
fn yosys(implementation: &Implementation, folder: &Path) -> anyhow::Result<String> {
    let top = implementation.top.name();
    std::fs::write(folder.join(format!("{top}.v")), text(&implementation.design))?;
    let library = implementation.library;
    let inverter = &library.cells[library.inverter()];
    let load_ff = 4.0 * inverter.capacitance_ff[0];
    let constraint = format!("set_driving_cell {}\nset_load {load_ff}\n", inverter.name);
    std::fs::write(folder.join("cells.constr"), constraint)?;
    // The pass that shares resources runs out of memory on floating-point adders. Flip-flops of libraries have no initial
    // value, so the script drops those of our registers, with which the pipeline starts empty.
    let script = format!(
        "read_verilog {top}.v; synth -flatten -noshare -top {top}; setattr -unset init w:*; \
         dfflegalize -cell $_DFF_P_ x; dfflibmap -liberty cells.lib; \
         abc -liberty cells.lib -constr cells.constr -D 1000; opt_clean; \
         tee -o {top}.stat stat -liberty cells.lib"
    );
    let output = Command::new("yosys")
        .args(["-p", &script])
        .current_dir(folder)
        .stdin(Stdio::null())
        .output()
        .context("--synth: yosys")?;
    if !output.status.success() {
        let log = String::from_utf8_lossy(&output.stderr);
        bail!("--synth: yosys fails on {top}: {}", log.lines().last().unwrap_or("no message"));
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

/// The result by the last statistics in a log and by ABC's delay.
fn parse(implementation: &Implementation, log: &str, flow: String) -> anyhow::Result<SynthesisRow> {
    let flip_flop = &implementation.library.flip_flop;
    let statistics = log.rfind("Number of cells:").map(|at| &log[at..]);
    let statistics = statistics.context("--synth: yosys printed no statistics")?;
    let number = |text: &str| text.split_whitespace().find_map(|word| word.parse::<f64>().ok());
    let cells = number(statistics).context("--synth: yosys printed no number of cells")?;
    let area =
        statistics.find("Chip area").and_then(|at| statistics[at..].split(':').nth(1)).and_then(number);
    let area = area.context("--synth: yosys printed no area")?;
    ensure!(!statistics.contains("$_"), "--synth: yosys left cells unmapped; its library lacks some");
    let registers: f64 = (statistics.lines())
        .filter(|line| line.split_whitespace().next() == Some(flip_flop.name.as_str()))
        .filter_map(|line| line.split_whitespace().nth(1)?.parse::<f64>().ok())
        .sum();
    ensure!(registers > 0.0, "--synth: yosys uses other flip-flops than {}", flip_flop.name);
    let register_area_um2 = registers * flip_flop.area_um2;
    let delay = log.rfind("Delay = ").and_then(|at| number(&log[at + 7..]));
    Ok(SynthesisRow {
        pipeline: implementation.top.name(),
        flow,
        cells: cells as usize,
        logic_area_um2: area - register_area_um2,
        register_area_um2,
        critical_path_ns: delay.map(|ps| ps / 1e3),
    })
}
