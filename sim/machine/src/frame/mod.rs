//! Frames: pictures as work for the machine.
//!
//! Each item of the shared counter is a pixel. The structure's program or a [`Kernel`] in its place computes it
//! ([`crate::execute`]) from the memory that holds the scene; golden renders the same pixel. A picture that differs in a bit is an
//! error, except of a kernel that may differ.

mod checker;
mod layout;
mod operations;
mod placement;
mod structure;
#[cfg(test)]
mod tests;
mod totals;

pub use checker::Checker;
pub use layout::Layout;
pub use operations::Operations;
pub use placement::node_bytes;
pub use structure::{FrameMachine, Kernel, MachineStructure};
pub use totals::Totals;

use super::core::{Counts, SimulationError, Tape, Work, simulate};
use super::description::{Bytes, DescriptionError, MachineDescription, NodeLayout};
use super::execute::{Difference, Executor, Fault, Mistake, Special};
use super::program::{EntryId, ListingError, Opcode, Program};
use golden::precision::{NarrowDst, Variant};
use golden::structure::{Memory, Structure, StructureFormat};
use render::{Pixel, PixelRenderer, RenderError, RenderOptions};
use scenes::Scene;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::sync::{Arc, Mutex};

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
    pub program: Arc<Program>,
    /// Rays traced.
    pub rays: u64,
    /// The picture, row by row from the top.
    pub pixels: Vec<Pixel>,
    /// Triangle tests that single precision did not decide.
    pub exact_tests: u64,
    /// All triangle tests.
    pub triangle_tests: u64,
    /// Pixels that are not golden's, of a kernel that may differ.
    pub different_pixels: u64,
}

/// What a frame traces through.
#[derive(Clone, Copy)]
enum Traced<'a> {
    /// In binary32.
    Wide(&'a Structure),
    /// A dual-split tree in a narrower format.
    Narrow(&'a NarrowDst),
}

/// The pixels of a frame as work for a machine.
pub struct FrameWork<'a, S = Operations<'a>> {
    /// The structure's program.
    pub program: Arc<Program>,
    executor: Executor<S>,
    /// The operations of items that are timed, if they are others.
    timed: Option<S>,
    /// What golden renders with.
    renderer: PixelRenderer<'a>,
    traced: Traced<'a>,
    /// Whether the picture may differ from golden's.
    may_differ: bool,
    width: u32,
    layout: Layout,
    placed_by: (NodeLayout, Bytes),
    done: Mutex<Done>,
}

/// What of a machine decides where everything lies in its memory.
fn placed_by(machine: &MachineDescription) -> (NodeLayout, Bytes) {
    (machine.layout, machine.l2.line)
}

#[derive(Default)]
struct Done {
    pixels: Vec<Option<Pixel>>,
    totals: Totals,
}

impl<'a> FrameWork<'a> {
    /// A frame of `scene` through `structure`, one sample per pixel. Every pipeline operation of an item that is timed is also given
    /// to `checker`, if there is one.
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
        Self::traced(machine, scene, Traced::Wide(structure), options, checker)
    }

    fn traced(
        machine: &FrameMachine,
        scene: &'a Scene,
        traced: Traced<'a>,
        options: &RenderOptions,
        checker: Option<&'a dyn Checker>,
    ) -> Result<Self, FrameError> {
        let narrow = match traced {
            Traced::Wide(_) => None,
            Traced::Narrow(narrow) => Some(narrow),
        };
        let operations = |checker| Operations {
            seed: options.seed,
            narrow,
            checker,
            checked: AtomicU64::new(0),
            differences: AtomicU64::new(0),
        };
        let program = machine.program()?;
        let mut work = Self::with_operations(machine, program, scene, traced, options, operations(None))?;
        work.timed = checker.map(|checker| operations(Some(checker)));
        Ok(work)
    }

    /// The pixels recorded so far, row by row from the top, and their totals.
    ///
    /// # Errors
    /// If an item has read what another one has left.
    ///
    /// # Panics
    /// If recording one has panicked.
    pub fn finish(mut self) -> Result<(Vec<Option<Pixel>>, Totals), FrameError> {
        self.executor.check().map_err(SimulationError::from)?;
        let Done { pixels, totals } = self.done.into_inner().expect("no panic while it was held");
        let timed = self.timed.as_ref();
        let rtl_operations = timed.map_or(0, |timed| timed.checked.load(Relaxed));
        let rtl_differences = timed.map_or(0, |timed| timed.differences.load(Relaxed));
        Ok((pixels, Totals { rtl_operations, rtl_differences, ..totals }))
    }
}

impl<'a, S: Special> FrameWork<'a, S> {
    fn with_operations(
        machine: &FrameMachine,
        program: Program,
        scene: &'a Scene,
        traced: Traced<'a>,
        options: &RenderOptions,
        operations: S,
    ) -> Result<Self, FrameError> {
        let kind = machine.structure.kind();
        let scene_box;
        let memory = match traced {
            Traced::Wide(structure) => {
                assert_eq!(structure.kind(), kind, "the structure that the machine is set up for");
                structure.memory()
            }
            Traced::Narrow(narrow) => {
                // The program tests the box of everything itself, in binary32.
                scene_box = narrow.scene_box();
                Memory { root_box: &scene_box, ..narrow.structure.memory() }
            }
        };
        let placed = placement::place(kind, &memory, machine.description.layout)?;
        let memory = match &placed {
            Some(placed) => Memory { root: placed.root, words: &placed.words, ..memory },
            None => memory,
        };
        let pixels = options.width * options.height;
        let renderer =
            PixelRenderer::new(scene, &RenderOptions { count_work: true, samples: 1, ..*options })?;
        let layout = Layout::new(&memory, pixels, &machine.description)?;
        let program = Arc::new(program);
        let image = layout.memory(&memory, renderer.frame(), options);
        let executor = Executor::new(Arc::clone(&program), image, operations, pixels);
        Ok(Self {
            executor: executor.map_err(SimulationError::from)?,
            timed: None,
            program,
            renderer,
            traced,
            may_differ: machine.kernel.as_ref().is_some_and(|kernel| kernel.may_differ),
            width: options.width,
            layout,
            placed_by: placed_by(&machine.description),
            done: Mutex::new(Done { pixels: vec![None; pixels as usize], totals: Totals::default() }),
        })
    }

    /// Whether the threads of `machine`, whose program is `program`, execute the same as those of this frame's machine.
    #[must_use]
    pub fn records_for(&self, machine: &FrameMachine, program: &Program) -> bool {
        let own = &*self.program;
        placed_by(&machine.description) == self.placed_by
            && (&program.graph, &program.operations, &program.lists)
                == (&own.graph, &own.operations, &own.lists)
    }

    /// Where everything lies in memory.
    #[must_use]
    pub fn layout(&self) -> &Layout {
        &self.layout
    }

    /// Executes item `item` without rendering it by golden.
    ///
    /// # Errors
    /// What the program does wrong.
    pub fn execute(&self, item: u32, entry: EntryId, tape: &mut Tape<'_>) -> Result<(), Box<Fault>> {
        self.executor.record(item, entry, tape).map(|_exact_tests| ())
    }

    /// Golden's pixel, its rays, and whether the program has to compute the same.
    fn golden(&self, pixel: [u32; 2]) -> (Pixel, u64, bool) {
        match self.traced {
            Traced::Wide(structure) => {
                let (pixel, rays) = self.renderer.pixel(structure, pixel);
                (pixel, rays, true)
            }
            Traced::Narrow(narrow) => {
                let (pixel, rays) = self.renderer.pixel(narrow, pixel);
                // Where rounding loses hits, it is a matter of which operations are rounded.
                (pixel, rays, narrow.precision.variant == Variant::Conservative)
            }
        }
    }

    /// What item `item` has written, channel by channel.
    fn written(&self, item: u32) -> [Option<u32>; 3] {
        let first = self.layout.pixels_at + item * Layout::PIXEL_WORDS;
        std::array::from_fn(|channel| self.executor.memory().written(first + channel as u32))
    }

    /// How what item `item` has written differs from `golden`, if it does.
    ///
    /// # Errors
    /// If it does and may not, or because the item depends on others.
    fn compare(
        &self,
        item: u32,
        entry: EntryId,
        pixel: [u32; 2],
        golden: &Pixel,
    ) -> Result<Option<Difference>, Box<Fault>> {
        let (found, golden) = (self.written(item), golden.rgb.map(f32::to_bits));
        let Some(channel) = (0..3).find(|channel| found[*channel] != Some(golden[*channel])) else {
            return Ok(None);
        };
        if let Some(fault) = self.executor.blame(item, entry) {
            return Err(fault);
        }
        let difference = Difference { pixel, channel, found: found[channel], golden: golden[channel] };
        if self.may_differ {
            return Ok(Some(difference));
        }
        let store = self.program.operations.iter().position(|op| op.opcode == Opcode::Store);
        Err(Box::new(Fault {
            program: self.program.name.clone(),
            line: store.map_or(1, |at| self.program.lines[at]),
            item,
            mistake: Mistake::Picture(difference),
        }))
    }
}

impl<S: Special> Work for FrameWork<'_, S> {
    fn items(&self) -> u32 {
        self.executor.items()
    }

    fn entries(&self) -> Option<(EntryId, EntryId)> {
        self.executor.entries()
    }

    fn start(&self, tape: &mut Tape<'_>) -> Result<(), Box<Fault>> {
        self.executor.start(tape)
    }

    fn record(&self, item: u32, entry: EntryId, tape: &mut Tape<'_>) -> Result<(), Box<Fault>> {
        let exact_tests = match &self.timed {
            Some(timed) if tape.is_timed() => self.executor.record_with(timed, item, entry, tape)?,
            _ => self.executor.record(item, entry, tape)?,
        };
        if item >= self.items() {
            return Ok(());
        }
        let place = [item % self.width, item / self.width];
        let (mut pixel, rays, equal) = self.golden(place);
        let difference = if equal { self.compare(item, entry, place, &pixel)? } else { None };
        if difference.is_some() {
            pixel.rgb = self.written(item).map(|word| f32::from_bits(word.unwrap_or(0)));
        }
        let mut done = self.done.lock().expect("no panic while it was held");
        // An item that was executed ahead from another entry point is recorded again.
        if done.pixels[item as usize].is_some() {
            return Ok(());
        }
        if let Some(difference) = difference {
            done.totals.differs(difference);
        }
        done.totals.rays += rays;
        done.totals.exact_tests += exact_tests;
        done.totals.triangle_tests += u64::from(pixel.work.triangle_tests);
        done.pixels[item as usize] = Some(Pixel { work: render::Work::default(), ..pixel });
        Ok(())
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
    traced_frame(machine, scene, Traced::Wide(structure), options, pixels_done)
}

/// [`frame`] through a dual-split tree in a narrower format. The mode of `options` has to be that of the format's variant.
///
/// # Errors
/// See [`FrameError`].
///
/// # Panics
/// If the machine is set up for another structure, or `narrow` was not built over the scene's mesh.
pub fn narrow_frame(
    machine: &FrameMachine,
    scene: &Scene,
    narrow: &NarrowDst,
    options: &RenderOptions,
    pixels_done: impl FnMut(u32),
) -> Result<Frame, FrameError> {
    assert_eq!(
        machine.structure,
        MachineStructure::Dst,
        "narrow formats are those of the dual-split pipeline"
    );
    traced_frame(machine, scene, Traced::Narrow(narrow), options, pixels_done)
}

fn traced_frame(
    machine: &FrameMachine,
    scene: &Scene,
    traced: Traced<'_>,
    options: &RenderOptions,
    pixels_done: impl FnMut(u32),
) -> Result<Frame, FrameError> {
    let work = FrameWork::traced(machine, scene, traced, options, None)?;
    let counts = simulate(&machine.description, &work.program, &work, pixels_done)?;
    let program = Arc::clone(&work.program);
    let (pixels, totals) = work.finish()?;
    let Totals { rays, exact_tests, triangle_tests, different_pixels, .. } = totals;
    let pixels = pixels.into_iter().map(|pixel| pixel.expect("every item was taken")).collect();
    Ok(Frame { counts, program, rays, pixels, exact_tests, triangle_tests, different_pixels })
}
