//! Frames: the golden renderer's pixels as work for the machine.
//!
//! Each item of the shared counter is a pixel. Its rays are traced through the golden structure by the golden steps; what
//! happens on the way is recorded as events of the structure's program. The picture is the golden picture bit for bit,
//! whatever the timing.

mod checker;
mod layout;
mod names;
mod recorder;
mod recording;
mod structure;
mod triangle;
mod walk;

pub use checker::Checker;
pub use layout::Layout;
pub use recording::Totals;
pub use structure::{FrameMachine, MachineStructure};

use super::core::{Counts, SimulationError, Tape, Work, simulate};
use super::description::DescriptionError;
use super::program::{ListingError, Program};
use golden::precision::NarrowDst;
use golden::structure::Structure;
use names::Names;
use recorder::{Recorder, Traced};
use render::{Pixel, PixelRenderer, RenderError, RenderOptions};
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

/// The pixels of a frame as work for a machine.
pub struct FrameWork<'a> {
    /// The structure's program.
    pub program: Program,
    renderer: PixelRenderer<'a>,
    traced: Traced<'a>,
    width: u32,
    height: u32,
    names: Names,
    layout: Layout,
    checker: Option<&'a dyn Checker>,
    done: Mutex<Done>,
}

#[derive(Default)]
struct Done {
    pixels: Vec<Option<Pixel>>,
    totals: Totals,
}

impl<'a> FrameWork<'a> {
    /// A frame of `scene` through `structure`, one sample per pixel. Every pipeline operation of an item that is timed is
    /// also given to `checker`, if there is one.
    ///
    /// # Errors
    /// See [`FrameError`].
    ///
    /// # Panics
    /// If `structure` is not of the machine's kind.
    pub fn new(
        machine: &FrameMachine,
        scene: &'a Scene,
        structure: &'a Structure,
        options: &RenderOptions,
        checker: Option<&'a dyn Checker>,
    ) -> Result<Self, FrameError> {
        assert_eq!(
            structure.kind(),
            machine.structure.kind(),
            "the structure that the machine is set up for"
        );
        Self::traced(machine, scene, structure, Traced::Wide(structure), options, checker)
    }

    fn traced(
        machine: &FrameMachine,
        scene: &'a Scene,
        structure: &Structure,
        traced: Traced<'a>,
        options: &RenderOptions,
        checker: Option<&'a dyn Checker>,
    ) -> Result<Self, FrameError> {
        let pixels = options.width * options.height;
        let program = machine.program()?;
        Ok(Self {
            renderer: PixelRenderer::new(scene, options)?,
            traced,
            width: options.width,
            height: options.height,
            names: Names::new(&program),
            layout: Layout::new(structure, pixels, &machine.description)?,
            program,
            checker,
            done: Mutex::new(Done { pixels: vec![None; pixels as usize], totals: Totals::default() }),
        })
    }

    /// Where everything lies in memory.
    #[must_use]
    pub fn layout(&self) -> &Layout {
        &self.layout
    }

    /// The pixels recorded so far, row by row from the top, and their totals.
    ///
    /// # Panics
    /// If recording one has panicked.
    #[must_use]
    pub fn finish(self) -> (Vec<Option<Pixel>>, Totals) {
        let done = self.done.into_inner().expect("no panic while it was held");
        (done.pixels, done.totals)
    }
}

impl Work for FrameWork<'_> {
    fn items(&self) -> u32 {
        self.width * self.height
    }

    fn record(&self, item: u32, tape: &mut Tape<'_>) {
        let recorder = Recorder::new(
            self.traced,
            &self.names,
            &self.layout,
            self.checker.filter(|_| tape.is_timed()),
            tape,
        );
        recorder.pixel(self.layout.pixels_at + item * Layout::PIXEL_WORDS);
        let pixel = self.renderer.pixel(&recorder, [item % self.width, item / self.width]);
        let totals = recorder.finish();
        let mut done = self.done.lock().expect("no panic while it was held");
        done.pixels[item as usize] = Some(pixel);
        done.totals.merge(&totals);
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
    traced_frame(machine, scene, structure, Traced::Wide(structure), options, pixels_done)
}

/// [`frame`] through a dual-split tree in a narrower format, each of whose nodes takes the memory of one of `structure`, from
/// which it was converted. The mode of `options` has to be that of the format's variant.
///
/// # Errors
/// See [`FrameError`].
///
/// # Panics
/// If the machine is set up for another structure, or `structure` was not built over the scene's mesh.
pub fn narrow_frame(
    machine: &FrameMachine,
    scene: &Scene,
    structure: &Structure,
    narrow: &NarrowDst,
    options: &RenderOptions,
    pixels_done: impl FnMut(u32),
) -> Result<Frame, FrameError> {
    assert_eq!(
        machine.structure,
        MachineStructure::Dst,
        "narrow formats are those of the dual-split pipeline"
    );
    traced_frame(machine, scene, structure, Traced::Narrow(narrow), options, pixels_done)
}

fn traced_frame(
    machine: &FrameMachine,
    scene: &Scene,
    structure: &Structure,
    traced: Traced<'_>,
    options: &RenderOptions,
    pixels_done: impl FnMut(u32),
) -> Result<Frame, FrameError> {
    let work = FrameWork::traced(machine, scene, structure, traced, options, None)?;
    let counts = simulate(&machine.description, &work.program, &work, pixels_done)?;
    let program = work.program.clone();
    let (pixels, Totals { rays, exact_tests, triangle_tests, .. }) = work.finish();
    let pixels = pixels.into_iter().map(|pixel| pixel.expect("every item was taken")).collect();
    Ok(Frame { counts, program, rays, pixels, exact_tests, triangle_tests })
}
