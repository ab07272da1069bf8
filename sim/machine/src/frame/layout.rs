//! Where everything lies in the machine's memory, in 32-bit words.

use crate::description::check::out_of_range;
use crate::description::{Bytes, DescriptionError, MachineDescription};
use crate::execute::Memory;
use crate::kernels::parameter;
use golden::ray::{EXIT_PADDING_ULPS, Mode};
use golden::structure;
use golden::triangle::Triangle;
use render::{Frame, RenderOptions};

/// Word addresses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    /// The picture, three words a pixel.
    pub pixels_at: u32,
    /// The structure's nodes.
    pub nodes_at: u32,
    /// The triangles.
    pub triangles_at: u32,
    /// Words of everything.
    pub words: u64,
}

impl Layout {
    /// Words of a pixel.
    pub const PIXEL_WORDS: u32 = 3;

    /// Lays out `structure` with its triangles and a picture of `pixels`, each part from the start of a line, and of a block of nodes.
    ///
    /// # Errors
    /// If the memory is too small.
    pub fn new(
        structure: &structure::Memory<'_>,
        pixels: u32,
        machine: &MachineDescription,
    ) -> Result<Self, DescriptionError> {
        let line = machine.l2.line.max(machine.layout.alignment).0 / 4;
        let align = |words: u64| words.next_multiple_of(line);
        let pixels_at = align(parameter::COUNT as u64);
        let nodes_at = align(pixels_at + u64::from(pixels) * u64::from(Self::PIXEL_WORDS));
        let triangles_at = align(nodes_at + structure.words.len() as u64);
        let words = align(triangles_at + structure.triangles.len() as u64 * u64::from(Triangle::WORDS));
        let bytes = machine.dram.bytes(machine.l2.line.0);
        if words * 4 > bytes {
            let rule =
                format!("scene and picture take {}, and the memory has {}", Bytes(words * 4), Bytes(bytes));
            return Err(out_of_range("dram.rows", machine.dram.rows, rule));
        }
        Ok(Self {
            pixels_at: pixels_at as u32,
            nodes_at: nodes_at as u32,
            triangles_at: triangles_at as u32,
            words,
        })
    }

    /// The memory before a frame.
    #[must_use]
    pub fn memory(
        &self,
        structure: &structure::Memory<'_>,
        frame: &Frame,
        options: &RenderOptions,
    ) -> Memory {
        let mut words = vec![0; self.words as usize];
        let pixels = options.width * options.height;
        for (number, value) in [
            (parameter::RAYS, pixels),
            (parameter::BOUNCES, frame.bounces as u32),
            (parameter::WIDTH, options.width),
            (parameter::OUT, self.pixels_at),
            (parameter::NODES, self.nodes_at),
            (parameter::TRIANGLES, self.triangles_at),
            (parameter::PADDING, if options.mode == Mode::Robust { EXIT_PADDING_ULPS } else { 0 }),
            (parameter::ROOT + 6, structure.root),
        ] {
            words[number] = value;
        }
        let camera = &frame.camera;
        let vectors = [
            (parameter::CAMERA, [camera.eye, camera.corner, camera.right, camera.down].concat()),
            (parameter::LIGHT, [frame.light.position, frame.light.intensity].concat()),
            (parameter::BACKGROUND, frame.background.to_vec()),
            (parameter::ROOT, [structure.root_box.min, structure.root_box.max].concat()),
            (parameter::EXTENT, vec![frame.light.extent]),
            (parameter::INVERSE_WIDTH, vec![1.0 / options.width as f32]),
        ];
        for (first, values) in vectors {
            for (word, value) in words[first..].iter_mut().zip(values) {
                *word = value.to_bits();
            }
        }
        let nodes_at = self.nodes_at as usize;
        words[nodes_at..nodes_at + structure.words.len()].copy_from_slice(structure.words);
        let triangles: &[u32] = bytemuck::cast_slice(structure.triangles);
        let triangles_at = self.triangles_at as usize;
        words[triangles_at..triangles_at + triangles.len()].copy_from_slice(triangles);
        Memory::new(words, self.pixels_at..self.pixels_at + pixels * Self::PIXEL_WORDS)
    }
}
