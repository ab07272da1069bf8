//! `dualsplit chart precision`: visits, errors, area, energy and time in every format.

use crate::cli::{DEFAULT_MACHINE, Drawn, Global, PrecisionArgs};
use crate::console::{Bars, Report, fixed, table};
use anyhow::ensure;
use std::path::Path;
use studies::charts::precision_study::{self, Options, PrecisionChart};

pub fn run(args: &PrecisionArgs, global: &Global) -> anyhow::Result<Report> {
    let machine_given =
        args.machine.machine != Path::new(DEFAULT_MACHINE) || !args.machine.settings.is_empty();
    ensure!(
        args.simulate || !machine_given,
        "--machine and --set need the simulation, which --simulate false leaves out"
    );
    let machine = || (args.machine.machine.clone(), args.machine.settings.clone());
    let options = Options {
        scene: args.scene.source(Drawn::Samples, global)?,
        structure: args.structure,
        test: args.test,
        quality: args.quality.quality,
        size: args.size,
        most_visits: args.most_visits,
        machine: args.simulate.then(machine),
        out: args.out.clone(),
        force: global.force,
    };
    let chart = precision_study::run(&options, &Bars::new(global.quiet))?;
    Ok(Report::new(&chart, text(&chart), chart.artifacts.clone()).in_folder(chart.folder.clone()))
}

fn text(d: &PrecisionChart) -> String {
    let mut text = format!(
        "{}: {} triangles, {}, {} {}x{}, {} rays; binary32 robust visits {} nodes per ray\n\n",
        d.scene,
        d.triangles,
        d.structure,
        d.test,
        d.width,
        d.height,
        d.rays,
        fixed(d.reference_node_visits as f64 / d.rays.max(1) as f64, 2)
    );
    let header = [
        "format",
        "variant",
        "bits",
        "node visits/ray",
        "triangles/ray",
        "false misses",
        "false hits",
        "wrong nearest",
        "other distance",
        "RMSE",
        "differing pixels",
        "frame ms",
        "area um2",
        "pJ/ray",
        "front",
    ];
    text += &table(
        header,
        d.points.iter().map(|p| {
            [
                p.format.clone(),
                p.variant.to_owned(),
                (p.exponent_bits + p.significand_bits).to_string(),
                fixed(p.node_visits_per_ray, 2),
                fixed(p.triangle_tests_per_ray, 2),
                p.false_misses.to_string(),
                p.false_hits.to_string(),
                p.wrong_nearest.to_string(),
                p.other_distance.to_string(),
                format!("{:.3e}", p.rmse),
                p.differing_pixels.to_string(),
                p.frame_ms.map(|ms| fixed(ms, 4)).unwrap_or_default(),
                p.area_um2.map(|area| fixed(area, 0)).unwrap_or_default(),
                p.energy_pj_per_ray.map(|energy| fixed(energy, 1)).unwrap_or_default(),
                if p.pareto { "*" } else { "" }.to_owned(),
            ]
        }),
    );
    text += "\nFront: no other has at most as many bits, visits, false misses and RMSE, and less of one.\n";
    if !d.left_out.is_empty() {
        text += &format!(
            "Left out, as they visit more than {} times the nodes of binary32: {}.\n",
            d.most_visits,
            d.left_out.join(", ")
        );
    }
    if let Some(source) = &d.cost_source {
        text += &format!("Area, and energy of a ray's node steps, of the dual-split pipeline: {source}.\n");
    }
    text
}
