//! `dualsplit wave`: the waveform of a unit that processes a scene's rays.

use crate::cli::{Drawn, Global, WaveArgs};
use crate::console::{Bars, Report};
use studies::wave::{self, Options};

pub fn run(args: &WaveArgs, global: &Global) -> anyhow::Result<Report> {
    let options = Options {
        unit: args.unit,
        scene: args.load.source(&args.scene, Drawn::Scenes, global)?,
        rays: args.rays,
        mode: args.mode.mode,
        quality: args.quality.quality,
        out: args.out.clone(),
        force: global.force,
    };
    let wave = wave::run(&options, &Bars::new(global.quiet))?;
    let text = format!(
        "{}: {} operations of {} rays in {} cycles",
        wave.path, wave.operations, wave.rays, wave.cycles
    );
    Ok(Report::new(&wave, text, vec![wave.path.clone()]))
}
