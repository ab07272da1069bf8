//! `dualsplit simulate`: simulations of frames on the many-core machine.

use super::validate;
use crate::cli::{Drawn, Global, SimulateArgs};
use crate::console::{Bars, Report, fixed, number, table};
use machine::description::MachineDescription;
use serde::Serialize;
use studies::fidelity::Interval;
use studies::input::display_all;
use studies::kernel;
use studies::simulate::{self, FidelityRow, KernelRow, Options, Simulation};

/// What `--dump-kernels` prints beside the files.
#[derive(Serialize)]
struct Dumped {
    example: &'static str,
}

pub fn run(args: &SimulateArgs, global: &Global) -> anyhow::Result<Report> {
    if args.scene.is_none() {
        global.without_seed("the command without a scene")?;
    }
    if let Some(folder) = &args.validate {
        return validate::run(folder, &args.row, global);
    }
    if let Some(folder) = &args.dump_kernels {
        let files = display_all(&kernel::dump(folder, global.force)?);
        return Ok(Report::new(&Dumped { example: kernel::EXAMPLE }, files.join("\n"), files));
    }
    let machine = MachineDescription::load(&args.machine.machine, &args.machine.settings)?;
    let scene = match &args.scene {
        Some(scene) => args.load.source(scene, Drawn::Samples, global)?,
        _ => {
            let text = MachineDescription::explained(&args.machine.machine, &args.machine.settings)?;
            return Ok(Report::new(&machine, text, vec![]));
        }
    };
    let options = Options {
        scene,
        structure: args.structure,
        kernel: args.kernel.clone(),
        allow_difference: args.allow_difference,
        test: args.test,
        mode: args.mode.mode,
        quality: args.quality.quality,
        size: args.size,
        machine,
        pipeline_cost: args.cost.pipeline_cost.method(),
        fidelity: args.fidelity,
        sample: args.sample,
        tolerance: args.tolerance,
        csv: args.csv.clone(),
        force: global.force,
    };
    let simulation = simulate::run(&options, &Bars::new(global.quiet))?;
    let mut report = Report::new(&simulation, text(&simulation), display_all(args.csv.as_deref()));
    report.difference = simulation.fidelity.rtl_differences > 0;
    Ok(report)
}

/// The program and its picture, in words.
fn kernel_text(kernel: &KernelRow) -> String {
    let mut text = format!("kernel {}, sha256 of its listing {}\n", kernel.file, kernel.sha256);
    text += &match &kernel.first_difference {
        Some(first) => {
            format!("{} pixels are not golden's; the first: {}\n", kernel.different_pixels, first.text)
        }
        None => "its picture is golden's\n".to_owned(),
    };
    text + "\n"
}

/// The level, the sample and the intervals, as text.
fn fidelity_text(f: &FidelityRow) -> String {
    let percent = |x: f64| fixed(100.0 * x, 2);
    let mut text = String::new();
    if !f.steps.is_empty() {
        let header =
            ["level", "batches", "pixels timed %", "frame ms", "+- %", "energy mJ", "+- %", "verdict"];
        let rows = f.steps.iter().map(|step| {
            [
                step.level.to_owned(),
                format!("{} of {}", step.batches_measured, f.batches),
                fixed(100.0 * step.pixels_timed_share, 1),
                number(step.frame_ms.value),
                percent(step.frame_ms.relative()),
                number(step.energy_mj.value),
                percent(step.energy_mj.relative()),
                step.verdict.clone(),
            ]
        });
        text += &table(header, rows);
        text += "\n";
    }
    let range = |i: &Interval| format!("{} .. {}", number(i.low), number(i.high));
    match (f.level, &f.bound_by) {
        (_, Some(resource)) => text += &format!("analytic: a lower bound by {resource}, not an estimate\n"),
        ("queueing", None) => {
            text += &format!(
                "queueing: an estimate; on machines like the preset it was off by at most a tenth: {} ms, {} mJ\n",
                range(&f.frame_ms),
                range(&f.energy_mj)
            );
        }
        _ if f.pixels_timed_share < 1.0 => {
            text += &format!(
                "{}: {} of {} batches measured, {} % of the pixels timed; 95 % intervals: {} ms, {} mJ\n",
                f.level,
                f.batches_measured,
                f.batches,
                fixed(100.0 * f.pixels_timed_share, 1),
                range(&f.frame_ms),
                range(&f.energy_mj)
            );
        }
        _ => {}
    }
    if f.rtl_operations > 0 {
        text += &format!(
            "rtl: {} pipeline operations executed by the netlist, {} differ from golden\n",
            f.rtl_operations, f.rtl_differences
        );
    }
    if text.is_empty() { text } else { text + "\n" }
}

fn text(d: &Simulation) -> String {
    let mut text = format!(
        "{}, {} triangles, {}, {}, {}x{} on {}: {} rays, {} cycles, {:.3} ms, {:.3} mJ\n\n",
        d.scene,
        d.triangles,
        d.structure,
        d.test,
        d.width,
        d.height,
        d.machine,
        d.rays,
        d.results.cycles,
        d.results.frame_ms,
        d.results.energy_mj.total
    );
    text += &d.kernel.as_ref().map_or_else(String::new, kernel_text);
    text += &fidelity_text(&d.fidelity);
    let rows = d.quantities.iter();
    text += &table(
        ["quantity", "value", "unit", "meaning"],
        rows.map(|q| [q.name.clone(), number(q.value), q.unit.to_owned(), q.meaning.to_owned()]),
    );
    let costs = &d.results.cache_costs;
    for (name, cost) in [("l1", &costs.l1), ("l2", &costs.l2)].into_iter().filter(|(_, c)| c.is_modelled()) {
        text += &format!("\n{name}: area {}; energy {}\n", cost.area_source, cost.energy_source);
    }
    text += &format!(
        "\nsimulated {:.0} rays/s; pipeline energy: {}\n",
        d.simulated_rays_per_second, d.results.pipeline_cost_source
    );
    text
}
