//! `dualsplit compare`: the differences between two pictures.

use crate::cli::{CompareArgs, Global};
use crate::console::Report;
use studies::compare::{self, Options};
use studies::input::display_all;

pub fn run(args: &CompareArgs, global: &Global) -> anyhow::Result<Report> {
    global.without_seed("a comparison")?;
    let options =
        Options { a: args.a.clone(), b: args.b.clone(), out: args.out.clone(), force: global.force };
    let d = compare::run(&options)?;
    let text = format!(
        "RMSE {:.6e}\nPSNR {:.2} dB, peak {}\nlargest difference {:.6e}\ndiffering pixels {} of {}",
        d.rmse,
        d.psnr_db,
        d.peak,
        d.max_abs,
        d.differing_pixels,
        u64::from(d.width) * u64::from(d.height)
    );
    let mut report = Report::new(&d, text, display_all(args.out.as_deref()));
    report.difference = !d.equal;
    Ok(report)
}
