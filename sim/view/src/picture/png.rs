//! PNG files: 8 bits, sRGB.

use super::Picture;
use png::{BitDepth, ColorType, Compression, Decoder, Encoder, Filter, Transformations};
use render::Rendering;
use std::io::{BufRead, Seek};

/// The picture as a display shows it, brightened by `exposure_stops` factors of two. Values beyond white become white.
#[must_use]
pub fn develop(rendering: &Rendering, exposure_stops: f32) -> Picture<u8> {
    let gain = libm::exp2f(exposure_stops);
    Picture {
        width: rendering.width,
        height: rendering.height,
        pixels: rendering.pixels.iter().map(|pixel| pixel.rgb.map(|x| encode_srgb(x * gain))).collect(),
    }
}

/// The sRGB code of the linear value `x` (IEC 61966-2-1), 0 to 255; NaN gives 0.
#[must_use]
pub fn encode_srgb(x: f32) -> u8 {
    let x = x.clamp(0.0, 1.0);
    let encoded = if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * libm::powf(x, 1.0 / 2.4) - 0.055 };
    (encoded * 255.0 + 0.5) as u8
}

/// The bytes of a PNG file.
///
/// # Panics
/// If the number of pixels is not `width * height`.
#[must_use]
pub fn encode(picture: &Picture<u8>) -> Vec<u8> {
    let mut bytes = vec![];
    let mut encoder = Encoder::new(&mut bytes, picture.width, picture.height);
    encoder.set_color(ColorType::Rgb);
    encoder.set_compression(Compression::Balanced);
    encoder.set_filter(Filter::Adaptive);
    let mut writer = encoder.write_header().expect("a header is written to memory");
    writer.write_image_data(picture.pixels.as_flattened()).expect("a complete picture is written to memory");
    writer.finish().expect("the end is written to memory");
    bytes
}

/// The colours of a PNG file of any depth as fractions of white, without its transparency.
pub(super) fn decode(source: impl BufRead + Seek) -> Result<Picture<f32>, String> {
    let mut decoder = Decoder::new(source);
    decoder.set_transformations(Transformations::EXPAND);
    let (width, height) = decoder.read_header_info().map_err(|error| error.to_string())?.size();
    super::check_size(width, height)?;
    let mut reader = decoder.read_info().map_err(|error| error.to_string())?;
    let (color, depth) = reader.output_color_type();
    let size = reader.output_buffer_size().ok_or("the picture does not fit into memory")?;
    let mut samples = vec![0; size];
    reader.next_frame(&mut samples).map_err(|error| error.to_string())?;
    let bytes = if depth == BitDepth::Sixteen { 2 } else { 1 };
    let fraction = |pixel: &[u8], channel: usize| match pixel[channel * bytes..][..bytes] {
        [high, low] => f32::from(u16::from_be_bytes([high, low])) / 65535.0,
        [sample] => f32::from(sample) / 255.0,
        _ => unreachable!("one or two bytes"),
    };
    let pixels = samples.chunks_exact(color.samples() * bytes).map(|pixel| match color {
        ColorType::Grayscale | ColorType::GrayscaleAlpha => [fraction(pixel, 0); 3],
        _ => [0, 1, 2].map(|channel| fraction(pixel, channel)),
    });
    Ok(Picture { width, height, pixels: pixels.collect() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Cursor;

    #[test]
    fn srgb_codes() {
        let codes = [(-1.0, 0), (0.0, 0), (f32::NAN, 0), (1.0, 255), (7.0, 255), (f32::INFINITY, 255)];
        for (linear, code) in codes {
            assert_eq!(encode_srgb(linear), code, "{linear}");
        }
        // Middle grey, and the end of the linear part.
        assert_eq!(encode_srgb(0.214_041), 127);
        assert_eq!(encode_srgb(0.003), 10);
        assert!((0..1000).map(|i| encode_srgb(i as f32 / 1000.0)).is_sorted());
    }

    #[test]
    fn pixels_come_back() {
        let pixels = (0..12u8).map(|i| [i, 255 - i, 20 * i]).collect();
        let picture = Picture { width: 4, height: 3, pixels };
        let decoded = decode(Cursor::new(encode(&picture))).unwrap();
        assert_eq!((decoded.width, decoded.height), (4, 3));
        let codes: Vec<_> = decoded.pixels.iter().map(|p| p.map(|x| (x * 255.0 + 0.5) as u8)).collect();
        assert_eq!(codes, picture.pixels);
        assert!(decode(Cursor::new(b"not a PNG")).is_err());
    }

    /// Reads grey and colour, with and without alpha, of 8 and 16 bits.
    #[test]
    fn every_kind_of_pixel_is_read() {
        for color in [ColorType::Grayscale, ColorType::GrayscaleAlpha, ColorType::Rgb, ColorType::Rgba] {
            for (depth, bytes) in [(BitDepth::Eight, 1), (BitDepth::Sixteen, 2)] {
                let samples: Vec<u8> =
                    (0..2 * color.samples()).flat_map(|i| vec![20 * i as u8 + 1; bytes]).collect();
                let mut file = vec![];
                let mut encoder = Encoder::new(&mut file, 2, 1);
                encoder.set_color(color);
                encoder.set_depth(depth);
                encoder.write_header().unwrap().write_image_data(&samples).unwrap();
                let at = |i: usize| (20 * i + 1) as f32 / 255.0;
                let expected = |i: usize| match color {
                    ColorType::Grayscale | ColorType::GrayscaleAlpha => [at(i); 3],
                    _ => [at(i), at(i + 1), at(i + 2)],
                };
                let picture = decode(Cursor::new(&file)).unwrap();
                assert_eq!(picture.pixels, [expected(0), expected(color.samples())], "{color:?} {depth:?}");
            }
        }
    }

    #[test]
    fn a_picture_that_would_fill_memory_is_refused() {
        let mut file = vec![];
        Encoder::new(&mut file, 20_000, 20_000).write_header().unwrap();
        assert!(decode(Cursor::new(&file)).unwrap_err().starts_with("20000 x 20000 pixels"));
    }
}
