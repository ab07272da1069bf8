//! Pictures: PNG in sRGB to look at, EXR with linear values to compute with.

pub mod difference;
pub mod exr;
pub mod font;
pub mod heatmap;
pub mod png;

use render::{MAX_PIXELS, Rendering};
use std::io::BufReader;
use std::path::{Path, PathBuf};

/// The formats that pictures are read from and written to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// 8 bits per channel, sRGB.
    Png,
    /// 32-bit floats, linear.
    Exr,
}

impl Format {
    /// The format that the extension of `path` names.
    ///
    /// # Errors
    /// [`PictureError`] for other extensions.
    pub fn of(path: &Path) -> Result<Self, PictureError> {
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        match ending.to_ascii_lowercase().as_str() {
            "png" => Ok(Self::Png),
            "exr" => Ok(Self::Exr),
            _ => Err(PictureError { path: path.to_owned(), kind: PictureErrorKind::Ending }),
        }
    }
}

/// Why a picture cannot be used. The message names the file, the cause and the remedy.
#[derive(Debug, thiserror::Error)]
#[error("{}: {kind}", path.display())]
pub struct PictureError {
    /// The file, as the caller named it.
    pub path: PathBuf,
    /// The reason.
    pub kind: PictureErrorKind,
}

/// The reasons for which a picture cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum PictureErrorKind {
    /// The extension names no format.
    #[error("pictures are .png or .exr files; give the name one of these endings")]
    Ending,
    /// The file cannot be read.
    #[error("cannot read the file ({0}); check its name and permissions")]
    Read(std::io::Error),
    /// The content is not a picture of the format that the extension names.
    #[error("not a picture of the format that its ending names ({0}); write it again")]
    Damaged(String),
}

/// A picture in memory: `width * height` pixels of linear or display RGB, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture<T> {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// The pixels.
    pub pixels: Vec<[T; 3]>,
}

impl<T: Copy> Picture<T> {
    /// A picture of one colour.
    #[must_use]
    pub fn filled(width: u32, height: u32, colour: [T; 3]) -> Self {
        Self { width, height, pixels: vec![colour; width as usize * height as usize] }
    }

    /// Sets the pixel at (`x`, `y`). Does nothing outside the picture.
    pub fn set(&mut self, x: u32, y: u32, colour: [T; 3]) {
        if x < self.width && y < self.height {
            self.pixels[y as usize * self.width as usize + x as usize] = colour;
        }
    }
}

/// Reads the colours of a `.png` file (as fractions of white, in sRGB) or of an `.exr` file (linear).
///
/// # Errors
/// [`PictureError`] names the file and the remedy.
pub fn read(path: &Path) -> Result<(Format, Picture<f32>), PictureError> {
    let format = Format::of(path)?;
    let error = |kind| PictureError { path: path.to_owned(), kind };
    let source = BufReader::new(base::input::open(path).map_err(|e| error(PictureErrorKind::Read(e)))?);
    let picture = match format {
        Format::Png => png::decode(source),
        Format::Exr => exr::decode(source),
    };
    Ok((format, picture.map_err(|reason| error(PictureErrorKind::Damaged(reason)))?))
}

/// Whether a picture of this size is read.
///
/// # Errors
/// It has too many pixels.
fn check_size(width: impl Into<u64>, height: impl Into<u64>) -> Result<(), String> {
    let (width, height) = (width.into(), height.into());
    if width.saturating_mul(height) > MAX_PIXELS.into() {
        return Err(format!(
            "{width} x {height} pixels; pictures of at most {MAX_PIXELS} pixels are compared"
        ));
    }
    Ok(())
}

/// The largest finite radiance of any channel of `rendering`.
#[must_use]
pub fn max_radiance(rendering: &Rendering) -> f32 {
    let channels = rendering.pixels.iter().flat_map(|pixel| pixel.rgb);
    channels.filter(|x| x.is_finite()).fold(0.0, f32::max)
}
