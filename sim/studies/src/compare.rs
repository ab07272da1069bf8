//! The differences between two pictures.

use crate::input::{check_outputs, display};
use anyhow::{Context, ensure};
use base::output::write_file;
use serde::Serialize;
use std::path::PathBuf;
use view::picture::difference::Difference;
use view::picture::{self, Format, exr, heatmap, png};

/// The two pictures, and the file for their difference.
#[derive(Clone, Debug)]
pub struct Options {
    /// A `.png` or `.exr` file.
    pub a: PathBuf,
    /// Another file of the same format and size.
    pub b: PathBuf,
    /// The file that the difference is written to: `.png` as a heat map, `.exr` in numbers.
    pub out: Option<PathBuf>,
    /// Replaces `out` if it exists.
    pub force: bool,
}

/// How two pictures differ. Infinite numbers become `null`.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct Comparison {
    pub a: String,
    pub b: String,
    pub width: u32,
    pub height: u32,
    pub rmse: f64,
    pub psnr_db: f64,
    pub peak: f64,
    pub max_abs: f64,
    pub differing_pixels: u64,
    /// Whether no pixel differs.
    #[serde(skip)]
    pub equal: bool,
}

/// Compares two pictures of one format and size.
///
/// # Errors
/// A picture cannot be read, they are of different formats or sizes, or the difference cannot be written.
pub fn run(args: &Options) -> anyhow::Result<Comparison> {
    if let Some(out) = &args.out {
        Format::of(out)?;
    }
    check_outputs(&[("--out", args.out.as_deref())], args.force)?;
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
        write_file(out, args.force, |file| file.write_all(&bytes))?;
    }
    Ok(Comparison {
        a: display(&args.a),
        b: display(&args.b),
        width: a.width,
        height: a.height,
        rmse: difference.rmse,
        psnr_db: difference.psnr_db,
        peak: difference.peak,
        max_abs: difference.max_abs,
        differing_pixels: difference.differing_pixels,
        equal: difference.is_empty(),
    })
}

/// The largest difference of any channel as a heat map.
fn map(difference: &Difference) -> picture::Picture<u8> {
    let pixels = &difference.per_pixel;
    let values = pixels.pixels.iter().map(|rgb| f64::from(rgb.iter().fold(0.0, |a: f32, b| a.max(*b))));
    let label = format!("difference, max {:.4}", difference.max_abs);
    let finite = values.clone().filter(|x| x.is_finite()).fold(0.0, f64::max);
    heatmap::draw(pixels.width, pixels.height, values, finite, &label)
}
