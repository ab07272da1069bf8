//! `dualsplit export`: the hardware as Verilog, with testbenches, constraints and READMEs.

use crate::cli::{ExportArgs, Global};
use crate::console::{Bars, Report};
use serde::Serialize;
use std::path::PathBuf;
use studies::export::{self, Options};

#[derive(Serialize)]
struct Document {
    files: Vec<PathBuf>,
}

pub fn run(args: &ExportArgs, global: &Global) -> anyhow::Result<Report> {
    let options = Options {
        out: args.out.clone(),
        format: args.format,
        unit: args.unit,
        vectors: args.vectors,
        period_ns: args.period_ns,
        seed: global.seed,
        force: global.force,
    };
    let document = Document { files: export::run(&options, &Bars::default())? };
    let text = document.files.iter().map(|file| format!("{}\n", file.display())).collect();
    Ok(Report::new(&document, text))
}
