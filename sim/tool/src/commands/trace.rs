//! `dualsplit trace`: the closest hits of a saved stream of rays.

use super::classes::class_table;
use crate::cli::{Drawn, Global, TraceArgs};
use crate::console::{Bars, Report};
use studies::input::display_all;
use studies::trace::{self, Options, Traced};

pub fn run(args: &TraceArgs, global: &Global) -> anyhow::Result<Report> {
    let options = Options {
        scene: args.scene.source(Drawn::Scenes, global)?,
        structure: args.structure.source(),
        rays: args.rays.clone(),
        mode: args.mode.mode,
        out: args.out.clone(),
        force: global.force,
    };
    let traced = trace::run(&options, &Bars::new(global.quiet))?;
    Ok(Report::new(&traced, text(&traced), display_all(options.out.as_deref())))
}

fn text(d: &Traced) -> String {
    let mut text = format!(
        "{}: {} rays, {} hits, {} mode, {}, {} thread(s), {:.3} s, {:.3} million rays/s\n\n",
        d.scene,
        d.rays,
        d.hits,
        d.mode,
        d.structure,
        d.threads,
        d.seconds,
        d.rays_per_second / 1e6
    );
    text += &class_table(&d.classes);
    text
}
