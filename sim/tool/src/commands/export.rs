//! `dualsplit export`: the hardware as Verilog, with testbenches, constraints and READMEs.

use crate::cli::{ExportArgs, Global};
use crate::console::{Bars, Report};
use serde::Serialize;
use studies::export::{self, Options};
use studies::input::display_all;

#[derive(Serialize)]
struct Document {
    format: &'static str,
}

pub fn run(args: &ExportArgs, global: &Global) -> anyhow::Result<Report> {
    let options = Options {
        out: args.out.clone(),
        format: args.format,
        unit: args.unit,
        vectors: args.vectors,
        tag_bits: args.tag_bits,
        one_file: args.one_file,
        no_reset: args.no_reset,
        period_ns: args.period_ns,
        seed: global.seed(),
        force: global.force,
    };
    let files = display_all(&export::run(&options, &Bars::new(global.quiet))?);
    let text = files.join("\n");
    Ok(Report::new(&Document { format: args.format.name() }, text, files).in_folder(args.out.clone()))
}
