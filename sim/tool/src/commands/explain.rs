//! `dualsplit explain`: the traversal of one pixel's primary ray, step by step.

use crate::cli::{Drawn, ExplainArgs, Global};
use crate::console::{Bars, Report};
use std::fmt::Write;
use studies::explain::{self, Explanation, Options};
use studies::walk::Step;

pub fn run(args: &ExplainArgs, global: &Global) -> anyhow::Result<Report> {
    let options = Options {
        scene: args.scene.source(Drawn::Scenes, global)?,
        view: args.view.view(),
        size: args.view.size,
        pixel: args.pixel,
        mode: args.mode.mode,
        quality: args.quality.quality,
        structures: args.structure.clone(),
    };
    let explanation = explain::run(&options, &Bars::new(global.quiet))?;
    Ok(Report::new(&explanation, text(&explanation), vec![]))
}

fn text(d: &Explanation) -> String {
    let mut text = format!(
        "{}: {} triangles, pixel {},{} of {}x{}, {} mode\norigin {:?}, direction {:?}\n",
        d.scene,
        d.triangles,
        d.pixel[0],
        d.pixel[1],
        d.size[0],
        d.size[1],
        d.mode,
        d.ray.origin,
        d.ray.direction
    );
    match &d.hit {
        Some(hit) => {
            _ = writeln!(
                text,
                "hit: triangle {} at t = {}, u = {}, v = {}",
                hit.triangle, hit.t, hit.u, hit.v
            )
        }
        None => text += "no hit\n",
    }
    for section in &d.structures {
        let c = section.counters;
        let _ = writeln!(
            text,
            "\n{}: {} node visits, {} plane tests, {} triangle tests, stack depth {}",
            section.name, c.node_visits, c.plane_tests, c.triangle_tests, c.stack_depth
        );
        for (number, step) in section.steps.iter().enumerate() {
            let _ = writeln!(text, "{:>5}  {}", number + 1, line(step));
        }
    }
    text
}

fn line(step: &Step) -> String {
    let outcome = |hit: &bool| if *hit { "hit" } else { "miss" };
    match step {
        Step::Root { hit, t_entry, t_exit } => format!("root box   [{t_entry}, {t_exit}] {}", outcome(hit)),
        Step::Node { offset, header, planes, t_min, t_max, outcome } => {
            format!("node @{offset} [{t_min}, {t_max}] {header}, planes {planes:?} -> {outcome}")
        }
        Step::Box { node, leaf, hit, t_entry, t_exit } => {
            let kind = if *leaf { "leaf" } else { "inner" };
            format!("box {node} ({kind}) [{t_entry}, {t_exit}] {}", outcome(hit))
        }
        Step::Push { offset, t_min, depth } => format!("  push @{offset} from {t_min}, depth {depth}"),
        Step::Pop { offset, discarded } => {
            format!("  pop @{offset}{}", if *discarded { ", discarded: beyond the hit" } else { "" })
        }
        Step::Triangle { slot, triangle, t, best } => match t {
            Some(t) => {
                format!("  triangle {triangle} (slot {slot}) hit at {t}{}", if *best { ", best" } else { "" })
            }
            None => format!("  triangle {triangle} (slot {slot}) missed"),
        },
    }
}
