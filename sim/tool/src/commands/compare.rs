//! `dualsplit compare`: how two pictures differ.

use crate::cli::{CompareArgs, Global};
use crate::console::Report;
use crate::input::{check_writable, display};
use anyhow::{Context, ensure};
use base::output::write_file;
use serde::Serialize;
use view::picture::difference::Difference;
use view::picture::{self, Format, exr, heatmap, png};

/// Infinite numbers are `null`.
#[derive(Serialize)]
struct Document {
    a: String,
    b: String,
    width: u32,
    height: u32,
    rmse: f64,
    psnr_db: f64,
    peak: f64,
    max_abs: f64,
    differing_pixels: u64,
    out: Option<String>,
}

pub fn run(args: &CompareArgs, global: &Global) -> anyhow::Result<Report> {
    if let Some(out) = &args.out {
        Format::of(out)?;
        check_writable("--out", out, global.force)?;
    }
    let (format, a) = picture::read(&args.a)?;
    let (other_format, b) = picture::read(&args.b)?;
    let names = || format!("{} and {}", args.a.display(), args.b.display());
    ensure!(
        format == other_format,
        "{}: one is a .png in sRGB, the other a linear .exr; render both to the same format",
        names()
    );
    let difference = Difference::new(format, &a, &b).with_context(names)?;
    if let Some(out) = &args.out {
        let bytes = match Format::of(out)? {
            Format::Exr => exr::encode_colours(&difference.per_pixel),
            Format::Png => png::encode(&map(&difference)),
        };
        write_file(out, global.force, |file| file.write_all(&bytes))?;
    }
    let document = Document {
        a: display(&args.a),
        b: display(&args.b),
        width: a.width,
        height: a.height,
        rmse: difference.rmse,
        psnr_db: difference.psnr_db,
        peak: difference.peak,
        max_abs: difference.max_abs,
        differing_pixels: difference.differing_pixels,
        out: args.out.as_deref().map(display),
    };
    let text = format!(
        "RMSE {:.6e}\nPSNR {:.2} dB, peak {}\nlargest difference {:.6e}\ndiffering pixels {} of {}",
        difference.rmse,
        difference.psnr_db,
        difference.peak,
        difference.max_abs,
        difference.differing_pixels,
        a.pixels.len()
    );
    let mut report = Report::new(&document, text);
    report.difference = !difference.is_empty();
    Ok(report)
}

/// The largest difference of any channel as a heat map.
fn map(difference: &Difference) -> picture::Picture<u8> {
    let pixels = &difference.per_pixel;
    let values = pixels.pixels.iter().map(|rgb| f64::from(rgb.iter().fold(0.0, |a: f32, b| a.max(*b))));
    let label = format!("difference, max {:.4}", difference.max_abs);
    let finite = values.clone().filter(|x| x.is_finite()).fold(0.0, f64::max);
    heatmap::draw(pixels.width, pixels.height, values, finite, &label)
}
