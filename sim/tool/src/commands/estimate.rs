//! `dualsplit estimate`: area, energy and speed of the pipelines, beside the published figures.

use crate::cli::{EstimateArgs, Global};
use crate::console::{Bars, Report};
use studies::estimation::{self, Options};

pub fn run(args: &EstimateArgs, global: &Global) -> anyhow::Result<Report> {
    let options = Options {
        liberty: args.liberty.clone(),
        synthesis: args.synth,
        scenes: args.scene.iter().map(|scene| args.load.source(scene, global)).collect(),
        quality: args.quality.quality,
        out: args.out.clone(),
        force: global.force,
    };
    let (estimates, text) = estimation::run(&options, &Bars::default())?;
    Ok(Report::new(&estimates, text))
}
