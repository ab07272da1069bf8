//! OpenEXR files: linear values, with depth, normal, triangle and the counters as layers.
//!
//! | channels | type | content |
//! |---|---|---|
//! | `R`, `G`, `B` | float | mean radiance |
//! | `depth.Z` | float | distance from the eye in scene units, infinite where nothing is hit |
//! | `normal.X`, `normal.Y`, `normal.Z` | float | unit normal, turned towards the eye; zero where nothing is hit |
//! | `triangle.id` | uint | index of the triangle, 2^32 - 1 where nothing is hit |
//! | `counters.node_visits`, `.plane_tests`, `.box_tests`, `.triangle_tests`, `.stack_depth` | uint | work of all rays of the pixel |

use super::Picture;
use exr::meta::{BlockDescription, MetaData};
use exr::prelude::*;
use render::{Pixel, Rendering};
use std::io::{BufRead, Cursor, Seek};

/// The most bytes of a tile or of a block of lines, before compression. A block that the file holds in part takes as much.
const MOST_BLOCK_BYTES: usize = 1 << 28;

/// The bytes of an EXR file with all channels of `rendering`.
///
/// # Panics
/// If the number of pixels is not `width * height`.
#[must_use]
pub fn encode(rendering: &Rendering) -> Vec<u8> {
    let float = |name: &str, value: fn(&Pixel) -> f32| {
        AnyChannel::new(name, FlatSamples::F32(rendering.pixels.iter().map(value).collect()))
    };
    let uint = |name: &str, value: fn(&Pixel) -> u32| {
        AnyChannel::new(name, FlatSamples::U32(rendering.pixels.iter().map(value).collect()))
    };
    let channels = [
        float("R", |p| p.rgb[0]),
        float("G", |p| p.rgb[1]),
        float("B", |p| p.rgb[2]),
        float("depth.Z", |p| p.depth),
        float("normal.X", |p| p.normal[0]),
        float("normal.Y", |p| p.normal[1]),
        float("normal.Z", |p| p.normal[2]),
        uint("triangle.id", |p| p.triangle),
        uint("counters.node_visits", |p| p.work.node_visits),
        uint("counters.plane_tests", |p| p.work.plane_tests),
        uint("counters.box_tests", |p| p.work.box_tests),
        uint("counters.triangle_tests", |p| p.work.triangle_tests),
        uint("counters.stack_depth", |p| p.work.stack_depth),
    ];
    let layer = Layer::new(
        (rendering.width as usize, rendering.height as usize),
        LayerAttributes::default(),
        Encoding { compression: Compression::ZIP16, ..Encoding::FAST_LOSSLESS },
        AnyChannels::sort(channels.into_iter().collect()),
    );
    write(layer)
}

/// The bytes of an EXR file with the colours of `picture`.
///
/// # Panics
/// If the number of pixels is not `width * height`.
#[must_use]
pub fn encode_colours(picture: &Picture<f32>) -> Vec<u8> {
    let channel = |name: &str, at: usize| {
        AnyChannel::new(name, FlatSamples::F32(picture.pixels.iter().map(|rgb| rgb[at]).collect()))
    };
    write(Layer::new(
        (picture.width as usize, picture.height as usize),
        LayerAttributes::default(),
        Encoding { compression: Compression::ZIP16, ..Encoding::FAST_LOSSLESS },
        AnyChannels::sort([channel("R", 0), channel("G", 1), channel("B", 2)].into_iter().collect()),
    ))
}

fn write(layer: Layer<AnyChannels<FlatSamples>>) -> Vec<u8> {
    let mut bytes = Cursor::new(vec![]);
    let image = Image::from_layer(layer);
    image.write().non_parallel().to_buffered(&mut bytes).expect("a complete picture is written to memory");
    bytes.into_inner()
}

/// The colours of an EXR file.
pub(super) fn decode(mut source: impl BufRead + Seek) -> std::result::Result<Picture<f32>, String> {
    // The sizes come first: the reader makes room for a picture before it looks at its pixels.
    let headers = MetaData::read_from_buffered(&mut source, false).map_err(|e| e.to_string())?.headers;
    for header in &headers {
        let tile = match header.blocks {
            BlockDescription::Tiles(tiles) => Some(tiles.tile_size),
            BlockDescription::ScanLines => None,
        };
        for size in [header.layer_size].into_iter().chain(tile) {
            super::check_size(size.width() as u64, size.height() as u64)?;
        }
        let block_bytes = header.max_block_byte_size();
        if block_bytes > MOST_BLOCK_BYTES {
            return Err(format!("blocks of {block_bytes} bytes; at most {MOST_BLOCK_BYTES} are read"));
        }
    }
    source.rewind().map_err(|e| e.to_string())?;
    let image = read()
        .no_deep_data()
        .largest_resolution_level()
        .rgb_channels(
            |size: Vec2<usize>, _: &_| Picture {
                width: size.width() as u32,
                height: size.height() as u32,
                pixels: vec![[0.0; 3]; size.area()],
            },
            |picture: &mut Picture<f32>, at: Vec2<usize>, (r, g, b): (f32, f32, f32)| {
                picture.set(at.x() as u32, at.y() as u32, [r, g, b]);
            },
        )
        .first_valid_layer()
        .all_attributes()
        .non_parallel()
        .from_buffered(source)
        .map_err(|e| e.to_string())?;
    Ok(image.layer_data.channel_data.pixels)
}

#[cfg(test)]
mod tests {
    use super::*;
    use render::Work;

    fn rendering() -> Rendering {
        let pixel = |i: u32| Pixel {
            rgb: [i as f32, 1e-20 * i as f32, 1e20],
            depth: if i == 2 { f32::INFINITY } else { 0.1 * i as f32 },
            normal: [0.6, -0.8, 0.0],
            triangle: if i == 2 { Pixel::NO_TRIANGLE } else { 1000 * i },
            work: Work {
                node_visits: i,
                plane_tests: 2 * i,
                box_tests: 0,
                triangle_tests: 7,
                stack_depth: 3,
            },
        };
        Rendering {
            width: 3,
            height: 2,
            pixels: (0..6).map(pixel).collect(),
            totals: Default::default(),
            rays: None,
        }
    }

    #[test]
    fn colours_come_back_bit_for_bit() {
        let rendering = rendering();
        let decoded = decode(Cursor::new(encode(&rendering))).unwrap();
        let rgb: Vec<_> = rendering.pixels.iter().map(|p| p.rgb).collect();
        assert_eq!(decoded, Picture { width: 3, height: 2, pixels: rgb });
        assert_eq!(decode(Cursor::new(encode_colours(&decoded))).unwrap(), decoded);
        assert!(decode(Cursor::new(b"not an EXR")).is_err());
    }

    #[test]
    fn layers_come_back() {
        let rendering = rendering();
        let bytes = encode(&rendering);
        let image = read()
            .no_deep_data()
            .largest_resolution_level()
            .all_channels()
            .first_valid_layer()
            .all_attributes()
            .from_buffered(Cursor::new(&bytes))
            .unwrap();
        let channels = image.layer_data.channel_data.list;
        let values = |name: &str| {
            let channel = channels.iter().find(|c| c.name.to_string() == name).expect(name);
            channel.sample_data.clone()
        };
        assert_eq!(channels.len(), 13);
        let triangles = rendering.pixels.iter().map(|p| p.triangle).collect();
        assert_eq!(values("triangle.id"), FlatSamples::U32(triangles));
        let depths = rendering.pixels.iter().map(|p| p.depth).collect();
        assert_eq!(values("depth.Z"), FlatSamples::F32(depths));
        let planes = rendering.pixels.iter().map(|p| p.work.plane_tests).collect();
        assert_eq!(values("counters.plane_tests"), FlatSamples::U32(planes));
    }

    /// The data window is the only size in the file: its right lower corner is moved far out.
    #[test]
    fn a_picture_that_would_fill_memory_is_refused() {
        let mut file = encode(&rendering());
        let at = file.windows(17).position(|bytes| bytes == b"dataWindow\0box2i\0").unwrap() + 17 + 4 + 8;
        file[at..at + 8].copy_from_slice(&[19_999i32.to_le_bytes(); 2].concat());
        assert!(decode(Cursor::new(&file)).unwrap_err().starts_with("20000 x 20000 pixels"));
    }

    /// A tile's size is read before its pixels are, and may be larger than the picture.
    #[test]
    fn a_tile_that_would_fill_memory_is_refused() {
        let pixel = |_| (0.0f32, 0.5f32, 1.0f32);
        let mut bytes = Cursor::new(vec![]);
        let image = Image::from_channels((9, 7), SpecificChannels::rgb(pixel));
        image.write().non_parallel().to_buffered(&mut bytes).unwrap();
        let file = bytes.into_inner();
        let at = file.windows(15).position(|bytes| bytes == b"tiles\0tiledesc\0").unwrap() + 15 + 4;
        let with_tile = |size: [i32; 2]| {
            let mut file = file.clone();
            file[at..at + 8].copy_from_slice(&size.map(i32::to_le_bytes).concat());
            decode(Cursor::new(file)).map(|picture| picture.pixels.len())
        };
        assert_eq!(with_tile([64, 64]), Ok(63));
        assert!(with_tile([1 << 24, 64]).unwrap_err().starts_with("16777216 x 64 pixels"));
        assert!(with_tile([8192, 8192]).unwrap_err().starts_with("blocks of 805306368 bytes"));
    }
}
