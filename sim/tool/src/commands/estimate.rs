//! `dualsplit estimate`: area, energy and speed of the pipelines, beside the published figures.

use crate::cli::{Drawn, EstimateArgs, Global};
use crate::console::{Bars, Report};
use studies::estimation::{self, Options};
use studies::input::display_all;

pub fn run(args: &EstimateArgs, global: &Global) -> anyhow::Result<Report> {
    let options = Options {
        liberty: args.liberty.clone(),
        clock: args.clock,
        mapper: args.mapper,
        curve: args.curve,
        synthesis: args.synth,
        scenes: args.load.sources(&args.scene, Drawn::Scenes, global)?,
        quality: args.quality.quality,
        out: args.out.clone(),
        force: global.force,
    };
    let (estimates, text, files) = estimation::run(&options, &Bars::new(global.quiet))?;
    let mut report = Report::new(&estimates, text, display_all(&files)).in_folder(args.out.clone());
    report.difference = estimates.misses_clock();
    Ok(report)
}
