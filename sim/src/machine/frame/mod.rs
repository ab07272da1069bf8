//! Frames: the golden renderer's pixels as work for the machine.
//!
//! Each item of the shared counter is a pixel. Its rays are traced through the golden structure by the golden steps; what
//! happens on the way is recorded as events of the structure's program. The picture is the golden picture bit for bit,
//! whatever the timing.

mod layout;
mod names;
mod recorder;
mod structure;
mod triangle;
mod walk;

pub use layout::Layout;
pub use structure::{FrameMachine, MachineStructure};

use super::core::{Counts, SimulationError, Tape, Work, simulate};
use super::description::DescriptionError;
use super::program::{ListingError, Program};
use golden::render::{Pixel, PixelRenderer, RenderError, RenderOptions};
use golden::structure::Structure;
use names::Names;
use recorder::Recorder;
use scenes::Scene;
use std::sync::Mutex;

/// Why a frame cannot be simulated.
#[derive(Debug, thiserror::Error)]
pub enum FrameError {
    /// The machine cannot be built.
    #[error(transparent)]
    Description(#[from] DescriptionError),
    /// The picture cannot be rendered.
    #[error(transparent)]
    Render(#[from] RenderError),
    /// A mistake in a program.
    #[error(transparent)]
    Listing(#[from] ListingError),
    /// The simulation does not end.
    #[error(transparent)]
    Simulation(#[from] SimulationError),
}

/// A simulated frame.
pub struct Frame {
    /// What the machine counted.
    pub counts: Counts,
    /// The program that ran.
    pub program: Program,
    /// Rays traced.
    pub rays: u64,
    /// The picture, row by row from the top.
    pub pixels: Vec<Pixel>,
    /// Triangle tests that single precision did not decide.
    pub exact_tests: u64,
    /// All triangle tests.
    pub triangle_tests: u64,
}

struct FrameWork<'a> {
    renderer: PixelRenderer<'a>,
    structure: &'a Structure,
    width: u32,
    height: u32,
    names: Names,
    layout: Layout,
    done: Mutex<Done>,
}

#[derive(Default)]
struct Done {
    pixels: Vec<Option<Pixel>>,
    rays: u64,
    exact_tests: u64,
    triangle_tests: u64,
}

impl Work for FrameWork<'_> {
    fn items(&self) -> u32 {
        self.width * self.height
    }

    fn record(&self, item: u32, tape: &mut Tape<'_>) {
        let recorder = Recorder::new(self.structure, &self.names, &self.layout, tape);
        recorder.pixel(self.layout.pixels_at + item * Layout::PIXEL_WORDS);
        let pixel = self.renderer.pixel(&recorder, [item % self.width, item / self.width]);
        let totals = recorder.finish();
        let mut done = self.done.lock().expect("no panic while it was held");
        done.pixels[item as usize] = Some(pixel);
        done.rays += totals.rays;
        done.exact_tests += totals.exact_tests;
        done.triangle_tests += totals.triangle_tests;
    }
}

/// Simulates a frame of `scene` through `structure` on `machine`, one sample per pixel.
///
/// `pixels_done` is called with the number of pixels begun since its last call.
///
/// # Errors
/// See [`FrameError`].
///
/// # Panics
/// If `structure` is not of the machine's kind, or was not built over the scene's mesh.
pub fn frame(
    machine: &FrameMachine,
    scene: &Scene,
    structure: &Structure,
    options: &RenderOptions,
    pixels_done: impl FnMut(u32),
) -> Result<Frame, FrameError> {
    assert_eq!(structure.kind(), machine.structure.kind(), "the structure that the machine is set up for");
    let renderer = PixelRenderer::new(scene, options)?;
    let pixels = options.width * options.height;
    let layout = Layout::new(structure, pixels, &machine.description)?;
    let program = machine.program()?;
    let work = FrameWork {
        renderer,
        structure,
        width: options.width,
        height: options.height,
        names: Names::new(&program),
        layout,
        done: Mutex::new(Done { pixels: vec![None; pixels as usize], ..Done::default() }),
    };
    let counts = simulate(&machine.description, &program, &work, pixels_done)?;
    let done = work.done.into_inner().expect("no panic while it was held");
    let Done { pixels, rays, exact_tests, triangle_tests } = done;
    let pixels = pixels.into_iter().map(|pixel| pixel.expect("every item was taken")).collect();
    Ok(Frame { counts, program, rays, pixels, exact_tests, triangle_tests })
}
