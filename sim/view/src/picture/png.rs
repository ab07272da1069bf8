//! PNG files: 8 bits, sRGB.

use super::Picture;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder, ImageFormat};
use render::Rendering;

/// The picture as a display shows it, brightened by `exposure_stops` factors of two; values beyond white are cut off.
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
    PngEncoder::new_with_quality(&mut bytes, CompressionType::Default, FilterType::Adaptive)
        .write_image(picture.pixels.as_flattened(), picture.width, picture.height, ExtendedColorType::Rgb8)
        .expect("a complete picture is written to memory");
    bytes
}

/// The colours of a PNG file as fractions of white, whatever its depth; transparency is ignored.
pub(super) fn decode(bytes: &[u8]) -> Result<Picture<f32>, String> {
    let image =
        image::load_from_memory_with_format(bytes, ImageFormat::Png).map_err(|e| e.to_string())?.to_rgb32f();
    let pixels = image.as_raw().as_chunks::<3>().0.to_vec();
    Ok(Picture { width: image.width(), height: image.height(), pixels })
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let decoded = decode(&encode(&picture)).unwrap();
        assert_eq!((decoded.width, decoded.height), (4, 3));
        let codes: Vec<_> = decoded.pixels.iter().map(|p| p.map(|x| (x * 255.0 + 0.5) as u8)).collect();
        assert_eq!(codes, picture.pixels);
        assert!(decode(b"not a PNG").is_err());
    }
}
