//! Where everything lies in the machine's memory, in 32-bit words.

use crate::description::check::out_of_range;
use crate::description::{DescriptionError, MachineDescription};
use golden::structure::Structure;
use golden::triangle::Triangle;

/// Word addresses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    /// The picture, three words a pixel.
    pub pixels_at: u32,
    /// The structure as golden stores it.
    pub nodes_at: u32,
    /// The triangles.
    pub triangles_at: u32,
    /// Words of everything.
    pub words: u64,
}

/// The parameter block: image, camera, light, root.
const PARAMETER_WORDS: u64 = 64;

impl Layout {
    /// Words of a pixel.
    pub const PIXEL_WORDS: u32 = 3;

    /// Lays out `structure` with its triangles and a picture of `pixels`, each part from the start of a line.
    ///
    /// # Errors
    /// If the memory is too small.
    pub fn new(
        structure: &Structure,
        pixels: u32,
        machine: &MachineDescription,
    ) -> Result<Self, DescriptionError> {
        let triangles = structure.triangles().len();
        let line = u64::from(machine.l2.line_words());
        let align = |words: u64| words.next_multiple_of(line);
        let pixels_at = PARAMETER_WORDS;
        let nodes_at = align(pixels_at + u64::from(pixels) * u64::from(Self::PIXEL_WORDS));
        let triangles_at = align(nodes_at + structure.node_bytes() as u64 / 4);
        let words = align(triangles_at + triangles as u64 * u64::from(Triangle::WORDS));
        let bytes = machine.dram.bytes(machine.l2.line.0);
        if words * 4 > bytes {
            let rule =
                format!("{} bytes of scene and picture do not fit in {bytes} bytes of memory", words * 4);
            return Err(out_of_range("dram.rows", machine.dram.rows, rule));
        }
        Ok(Self {
            pixels_at: pixels_at as u32,
            nodes_at: nodes_at as u32,
            triangles_at: triangles_at as u32,
            words,
        })
    }
}
