//! `dualsplit chart fidelity`: charts of the host's time against the error of the simulation.

use crate::cli::{Drawn, FidelityArgs, Global};
use crate::console::{Bars, Report, fixed, table};
use studies::charts::fidelity_study::{self, FidelityChart, Options};
use studies::fidelity::Level;

pub fn run(args: &FidelityArgs, global: &Global) -> anyhow::Result<Report> {
    let options = Options {
        scene: args.scene.source(Drawn::Samples, global)?,
        structure: args.structure,
        test: args.test,
        quality: args.quality.quality,
        size: args.size,
        repeats: args.repeats,
        rtl: args.rtl,
        machine: args.machine.machine.clone(),
        settings: args.machine.settings.clone(),
        out: args.out.clone(),
        force: global.force,
    };
    let chart = fidelity_study::run(&options, &Bars::new(global.quiet))?;
    Ok(Report::new(&chart, text(&chart), chart.artifacts.clone()).in_folder(chart.folder.clone()))
}

fn text(d: &FidelityChart) -> String {
    let mut text = format!(
        "{}: {} triangles, {}, {}, {}x{} in {} batches on {} with {} threads\n\n",
        d.scene, d.triangles, d.structure, d.test, d.width, d.height, d.batches, d.machine, d.threads
    );
    let header = [
        "level",
        "warming",
        "batches",
        "draws",
        "pixels timed %",
        "host s",
        "frame ms",
        "error %",
        "not corrected",
        "spread",
        "interval",
        "energy mJ",
        "error %",
        "not corrected",
        "spread",
        "interval",
    ];
    text += &table(
        header,
        d.points.iter().map(|p| {
            [
                p.level.to_owned(),
                p.warming.to_owned(),
                p.batches.to_string(),
                p.draws.to_string(),
                fixed(100.0 * p.pixels_timed_share, 1),
                fixed(p.seconds, 3),
                fixed(p.frame_ms, 4),
                fixed(p.time_error_pct, 2),
                fixed(p.plain_time_error_pct, 2),
                p.time_spread_pct.map(|x| fixed(x, 2)).unwrap_or_default(),
                fixed(p.time_interval_pct, 2),
                fixed(p.energy_mj, 4),
                fixed(p.energy_error_pct, 2),
                fixed(p.plain_energy_error_pct, 2),
                p.energy_spread_pct.map(|x| fixed(x, 2)).unwrap_or_default(),
                fixed(p.energy_interval_pct, 2),
            ]
        }),
    );
    text += &format!(
        "\nErrors against the last row; the interval is half of the 95 % interval; not corrected: if everything timed, cold\n\
         start and end included, simply stood for the rest. {} is a lower bound.\n",
        Level::Analytic
    );
    text
}
