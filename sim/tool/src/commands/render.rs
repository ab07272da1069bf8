//! `dualsplit render`: pictures, heat maps and ray streams.

use super::classes::class_table;
use crate::cli::{Drawn, Global, RenderArgs};
use crate::console::{Bars, Report};
use studies::input::display_all;
use studies::picture::{self, Options, Picture};

pub fn run(args: &RenderArgs, global: &Global) -> anyhow::Result<Report> {
    let options = Options {
        scene: args.scene.source(Drawn::Samples, global)?,
        structure: args.structure.source(),
        test: args.test,
        mode: args.mode.mode,
        view: args.view.view(),
        size: args.view.size,
        samples: args.spp,
        seed: global.seed(),
        exposure: args.exposure,
        heatmap: args.heatmap,
        heatmap_max: args.heatmap_max,
        out: args.out.clone(),
        rays: args.rays.clone(),
        force: global.force,
    };
    let picture = picture::run(&options, &Bars::new(global.quiet))?;
    Ok(Report::new(&picture, text(&picture), display_all([&options.out].into_iter().chain(&options.rays))))
}

fn text(d: &Picture) -> String {
    let mut text = format!(
        "{}: {} triangles, {} test through {}, {} mode, {}x{} with {} sample(s) per pixel\n\
         {} rays in {:.2} s; max {}: {}\n\n",
        d.scene,
        d.triangles,
        d.test,
        d.structure,
        d.mode,
        d.width,
        d.height,
        d.spp,
        d.rays,
        d.seconds,
        d.max_of,
        d.max
    );
    text += &class_table(&d.classes);
    text
}
