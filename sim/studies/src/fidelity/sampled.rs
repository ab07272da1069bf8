//! The estimate of a frame at one level, on one sample.

use super::analytic;
use super::batches::{Batches, Draw};
use super::queueing;
use super::ratio::{self, Pair, Stratum};
use super::window::Window;
use super::witness::Netlists;
use super::{FidelityError, Interval, Level};
use golden::structure::Structure;
use machine::core::{Counts, Noted, Plan, simulate_plan};
use machine::frame::{Checker, FrameError, FrameMachine, FrameWork, Totals};
use machine::program::Program;
use machine::results::{Instructions, Results};
use render::RenderOptions;
use scenes::Scene;
use std::time::Instant;

/// The error that warming leaves, as a fraction of the estimate. It is added to both sides of an interval. With a lead of half a
/// fill, the mean error was below it in four of six scenes (`docs/fidelity.md`).
pub const BIAS: f64 = 0.01;

/// A frame that is to be estimated.
#[derive(Clone, Copy)]
pub struct Subject<'a> {
    /// The machine.
    pub machine: &'a FrameMachine,
    /// The scene that the frame shows.
    pub scene: &'a Scene,
    /// The structure over the scene, of the kind that the machine's program traverses.
    pub structure: &'a Structure,
    /// Size of the picture, test, mode and seed.
    pub options: &'a RenderOptions,
}

/// Which part of a frame is timed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Number of strata, from each of which two batches are timed. If absent, all batches are timed.
    pub pairs: Option<u32>,
    /// Seed of the draw of batches.
    pub seed: u64,
    /// Pixels of a batch in fills of the machine. A fill is as many pixels as the machine has threads.
    pub batch_fills: f64,
    /// Pixels before each batch that are timed but not measured, in fills of the machine. Where the longest pixels take several
    /// fills, the lead is that many times longer.
    pub lead_fills: f64,
    /// Whether the lines that pixels left out read are put into the caches.
    pub warms: bool,
}

impl Sample {
    /// The whole frame.
    pub const ALL: Self = Self { pairs: None, seed: 0, batch_fills: 1.0, lead_fills: 0.5, warms: true };

    /// Two batches from each of `pairs` strata.
    #[must_use]
    pub fn of(pairs: u32, seed: u64) -> Self {
        Self { pairs: Some(pairs), seed, ..Self::ALL }
    }

    /// Strata in which `batches` are drawn. A frame without two batches to draw, such as one of fewer pixels than the machine has
    /// threads, is timed as a whole.
    fn pairs_of(&self, batches: &Batches) -> Option<u32> {
        self.pairs.filter(|_| batches.drawable() >= 2)
    }

    /// A sample of the fraction `share` of a frame in `batches`, and of at least two batches. A `share` of 1 is the whole frame.
    #[must_use]
    pub fn share(share: f64, batches: &Batches, seed: u64) -> Self {
        let drawn = share * f64::from(batches.drawable());
        if share >= 1.0 { Self::ALL } else { Self::of((drawn / 2.0).round().max(1.0) as u32, seed) }
    }
}

/// An estimate of a frame's counts, time and energy.
#[derive(Clone, Debug)]
pub struct Estimate {
    /// The level of the simulation.
    pub level: Level,
    /// Number of batches in the frame.
    pub batches: u32,
    /// Number of batches measured.
    pub measured: u32,
    /// The share of the frame's pixels that were timed, measured or not.
    pub timed_share: f64,
    /// The counts of the frame.
    pub counts: Counts,
    /// Time and energy by these counts.
    pub results: Results,
    /// Milliseconds of the frame; at the analytic level, a lower bound.
    pub frame_ms: Interval,
    /// Millijoules of the frame; at the analytic level, a lower bound.
    pub energy_mj: Interval,
    /// Milliseconds and millijoules if all timed pixels, cold start and end included, stood for the rest. The estimate corrects
    /// this value.
    pub plain: [f64; 2],
    /// The resource that sets the bound at the analytic level.
    pub bound_by: Option<String>,
    /// Totals over all pixels recorded. Only an analytic sample leaves pixels unrecorded.
    pub totals: Totals,
    /// Seconds of the host.
    pub seconds: f64,
}

impl Estimate {
    /// Whether every pixel was timed, so that the estimate is the frame itself.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.level.simulates() && self.timed_share >= 1.0
    }

    /// Whether both intervals reach no farther than `tolerance`, a fraction of the value, to either side.
    #[must_use]
    pub fn is_within(&self, tolerance: f64) -> bool {
        self.level.simulates()
            && self.frame_ms.relative() <= tolerance
            && self.energy_mj.relative() <= tolerance
    }
}

impl<'a> Subject<'a> {
    /// Number of threads of the machine.
    #[must_use]
    pub fn threads(&self) -> u32 {
        let machine = &self.machine.description;
        machine.chip.tms() * machine.tm.threads
    }

    /// The frame in batches of `fills` fills of the machine.
    #[must_use]
    pub fn batches(&self, fills: f64) -> Batches {
        let size = (f64::from(self.threads()) * fills).round() as u32;
        Batches::new(self.options.width * self.options.height, size)
    }

    /// Estimates the frame at `level` on `sample`, or as a whole at the queueing level. `pixels_done` is called with the number of pixels begun since its last call.
    ///
    /// # Errors
    /// [`FidelityError`].
    pub fn estimate(
        &self,
        level: Level,
        sample: &Sample,
        pixels_done: impl FnMut(u32) + Send,
    ) -> Result<Estimate, FidelityError> {
        match level {
            Level::Analytic => self.analytic(sample),
            Level::Queueing => {
                let program = self.machine.program().map_err(FrameError::from)?;
                let mut estimates =
                    queueing::estimates(self, &[(self.machine.clone(), program)], pixels_done)?;
                Ok(estimates.pop().expect("one machine has one estimate"))
            }
            Level::Rtl if self.machine.pipeline.is_none() => {
                Err(FidelityError::NoPipeline(self.machine.structure.name()))
            }
            Level::Transaction | Level::Rtl => self.timed(level, sample, pixels_done),
        }
    }

    pub(super) fn work(&self, rtl: bool) -> Result<FrameWork<'a>, FidelityError> {
        let checker = rtl.then_some(&Netlists as &dyn Checker);
        Ok(FrameWork::new(self.machine, self.scene, self.structure, self.options, checker)?)
    }

    fn results(&self, program: &Program, counts: &Counts) -> Result<Results, FidelityError> {
        Ok(self.machine.results(program, counts)?)
    }

    /// The analytic bound, with an interval by the spread of work between batches.
    fn analytic(&self, sample: &Sample) -> Result<Estimate, FidelityError> {
        let start = Instant::now();
        let work = self.work(false)?;
        let machine = &self.machine.description;
        let batches = self.batches(sample.batch_fills);
        let indices: Vec<u32> = match sample.pairs_of(&batches) {
            None => (0..batches.count).collect(),
            Some(pairs) => batches.draw(pairs, sample.seed).indices().collect(),
        };
        let asked = analytic::record(&work, &batches, &indices, machine.l2.line_words())?;
        let ends = analytic::Ends::new(&work)?;
        let pixels: u32 = indices.iter().map(|index| batches.items_of(*index).len() as u32).sum();
        let scale = f64::from(batches.items) / f64::from(pixels);
        let bound = analytic::bound(
            machine,
            &work.program,
            &ends,
            &analytic::sum(&asked),
            (batches.items.into(), scale),
        );
        let results = self.results(&work.program, &bound.counts)?;
        let whole = indices.len() == batches.count as usize;
        let (mut frame_ms, mut energy_mj) =
            (Interval::exact(results.frame_ms), Interval::exact(results.energy_mj.total));
        if !whole {
            // The spread of instructions stands for that of time and energy. Apart from background energy, both are
            // proportional to instructions.
            let instructions = |asked: &analytic::Asked| {
                let counts = Counts { runs: asked.runs.clone(), ..Counts::default() };
                Instructions::new(&work.program, &counts).total as f64
            };
            let pairs = asked.iter().zip(&indices).map(|(asked, index)| Pair {
                y: instructions(asked),
                x: batches.items_of(*index).len() as f64,
            });
            let sum = ratio::estimate(&[(batches.count, pairs.collect())], f64::from(batches.items));
            let half = ratio::student(sum.freedom) * sum.error / sum.value;
            frame_ms = Interval::around(frame_ms.value, half * frame_ms.value);
            energy_mj = Interval::around(energy_mj.value, half * energy_mj.value);
        }
        let (_, totals) = work.finish()?;
        Ok(Estimate {
            level: Level::Analytic,
            batches: batches.count,
            measured: indices.len() as u32,
            timed_share: 0.0,
            counts: bound.counts,
            results,
            frame_ms,
            energy_mj,
            plain: [frame_ms.value, energy_mj.value],
            bound_by: Some(bound.resource),
            totals,
            seconds: start.elapsed().as_secs_f64(),
        })
    }

    /// The parts of the frame that are timed.
    pub(super) fn plan(&self, sample: &Sample) -> Result<(Batches, Draw, Plan), FidelityError> {
        let batches = self.batches(sample.batch_fills);
        let Some(pairs) = sample.pairs_of(&batches) else {
            let draw = Draw { strata: vec![(batches.drawable(), (1..=batches.drawable()).collect())] };
            let plan = batches.plan(&draw, 0, 0);
            return Ok((batches, draw, plan));
        };
        let line_words = self.machine.description.l2.line_words();
        let lifetimes = Lifetimes::new(&self.work(false)?, &batches, line_words)?;
        let batches = batches.with_end(lifetimes.end_batches);
        let draw = batches.draw(pairs, sample.seed);
        // The mix of pixels in flight determines what the caches hold. With long pixels, the mix takes longer to settle.
        let fills = sample.lead_fills.max((sample.lead_fills * lifetimes.longest_fills).min(MOST_LEAD_FILLS));
        let lead = (f64::from(self.threads()) * fills).round() as u32;
        let plan = batches.plan(&draw, lead, if sample.warms { u32::MAX } else { 0 });
        Ok((batches, draw, plan))
    }

    fn timed(
        &self,
        level: Level,
        sample: &Sample,
        pixels_done: impl FnMut(u32) + Send,
    ) -> Result<Estimate, FidelityError> {
        let start = Instant::now();
        let work = self.work(level == Level::Rtl)?;
        let machine = &self.machine.description;
        let (batches, draw, plan) = self.plan(sample)?;
        let skipped: u32 = plan.skipped.iter().map(|range| range.len() as u32).sum();
        let (counts, noted) = simulate_plan(machine, &work.program, &work, &plan, pixels_done)?;
        let estimated = if skipped == 0 {
            let results = self.results(&work.program, &counts)?;
            let (frame_ms, energy) = (results.frame_ms, results.energy_mj.total);
            (counts.clone(), results, Interval::exact(frame_ms), Interval::exact(energy))
        } else {
            self.expanded(&work.program, &draw, &counts, &noted)?
        };
        let plain = self.plain(&work.program, &counts)?;
        let (_, totals) = work.finish()?;
        let (counts, results, frame_ms, energy_mj) = estimated;
        Ok(Estimate {
            level,
            batches: batches.count,
            // A frame of one batch is measured as its first and as its end.
            measured: (plan.marks.len() as u32 / 2).min(batches.count),
            timed_share: 1.0 - f64::from(skipped) / f64::from(batches.items),
            counts,
            results,
            frame_ms,
            energy_mj,
            plain,
            bound_by: None,
            totals,
            seconds: start.elapsed().as_secs_f64(),
        })
    }

    /// Time and energy of the frame, if both were proportional to the instructions that were timed.
    fn plain(&self, program: &Program, counts: &Counts) -> Result<[f64; 2], FidelityError> {
        let timed = Window::new(&Noted::of(counts));
        let scale = Instructions::new(program, counts).total as f64 / timed.instructions();
        let expanded =
            Counts { runs: counts.runs.clone(), ..Window(timed.0.map(|field| field * scale)).counts() };
        let results = self.results(program, &expanded)?;
        Ok([results.frame_ms, results.energy_mj.total])
    }

    /// The frame's counts, extrapolated from those of a sample. The first batch and the end are taken as measured.
    fn expanded(
        &self,
        program: &Program,
        draw: &Draw,
        counts: &Counts,
        noted: &[Noted],
    ) -> Result<(Counts, Results, Interval, Interval), FidelityError> {
        let windows: Vec<Window> =
            noted.chunks_exact(2).map(|ends| Window::between(&ends[0], &ends[1])).collect();
        let [first, drawn @ .., _] = &windows[..] else {
            unreachable!("a plan measures the first batch and the end");
        };
        let at_last = Window::between(&Noted::default(), &noted[noted.len() - 2]);
        let end = Window::between(&Noted::default(), &Noted::of(counts));
        let last = end.minus(&at_last);
        let known = Instructions::new(program, counts).total as f64;
        let middle = known - first.instructions() - last.instructions();

        // The sampled batches of each stratum, with the number of batches that they stand for.
        let mut left = drawn.iter();
        let strata: Vec<(u32, Vec<&Window>)> = draw
            .strata
            .iter()
            .map(|(count, drawn)| (*count, left.by_ref().take(drawn.len()).collect()))
            .collect();
        let weighted = |of: &dyn Fn(&Window) -> f64| -> f64 {
            let mean =
                |windows: &[&Window]| windows.iter().map(|w| of(w)).sum::<f64>() / windows.len() as f64;
            strata.iter().map(|(count, windows)| f64::from(*count) * mean(windows)).sum()
        };
        let scale = middle / weighted(&Window::instructions);
        let sum = Window(std::array::from_fn(|i| {
            first.0[i] + last.0[i] + scale * weighted(&|window: &Window| window.0[i])
        }));
        let mut estimated = sum.counts();
        estimated.runs.clone_from(&counts.runs);
        // All loads were recorded, and the first-level cache takes each once: their number needs no estimate.
        let instructions = Instructions::new(program, counts);
        estimated.l1.loads = instructions.loads;
        let results = self.results(program, &estimated)?;

        let energy = |window: &Window| -> Result<f64, FidelityError> {
            let counts = Counts { runs: vec![0; program.code.runs.len()], ..window.counts() };
            let energy = self.results(program, &counts)?.energy_mj;
            Ok(energy.dram + energy.l2)
        };
        let ms = 1e3 / (self.machine.description.clock_ghz * 1e9);
        let half = |of: &dyn Fn(&Window) -> Result<f64, FidelityError>| -> Result<f64, FidelityError> {
            let mut pairs: Vec<Stratum> = vec![];
            for (count, windows) in &strata {
                let pair = |window: &&Window| Ok(Pair { y: of(window)?, x: window.instructions() });
                pairs.push((*count, windows.iter().map(pair).collect::<Result<_, FidelityError>>()?));
            }
            let sum = ratio::estimate(&pairs, middle);
            Ok(ratio::student(sum.freedom) * sum.error + BIAS * sum.value)
        };
        let time = half(&|window| Ok(window.cycles() * ms))?;
        let energy = half(&energy)?;
        let (frame_ms, energy_mj) = (results.frame_ms, results.energy_mj.total);
        Ok((estimated, results, Interval::around(frame_ms, time), Interval::around(energy_mj, energy)))
    }
}

/// The most batches in which the frame's end is searched.
const MOST_END_BATCHES: u32 = 16;
/// The longest lead before a batch, in fills of the machine.
const MOST_LEAD_FILLS: f64 = 4.0;

/// How long pixels are in flight.
struct Lifetimes {
    /// Fills of the machine that the longest pixel of a batch takes, mean over batches.
    longest_fills: f64,
    /// Batches of the frame's end, which begins with the first pixel that may still be in flight when the counter runs out. A few
    /// long pixels of the end decide when the frame ends, and no other pixels can stand for them.
    end_batches: u32,
}

impl Lifetimes {
    /// Those of the frame's last batches. A pixel with so many times the mean's instructions takes the time of as many fills, if
    /// threads are equally fast.
    fn new(work: &FrameWork<'_>, batches: &Batches, line_words: u32) -> Result<Self, FidelityError> {
        let looked_at: Vec<u32> = (0..batches.count).rev().take(MOST_END_BATCHES as usize).collect();
        let asked = analytic::record(work, batches, &looked_at, line_words)?;
        let instructions = |runs: &[u64]| {
            let counts = Counts { runs: runs.to_vec(), ..Counts::default() };
            Instructions::new(&work.program, &counts).total as f64
        };
        let all: f64 = asked.iter().map(|asked| instructions(&asked.runs)).sum();
        let pixels: usize = looked_at.iter().map(|index| batches.items_of(*index).len()).sum();
        let fills = |asked: &analytic::Asked| asked.longest as f64 * pixels as f64 / all;
        let outlives = |(ahead, asked): &(usize, &analytic::Asked)| fills(asked) >= *ahead as f64;
        let ends = asked.iter().enumerate().filter(outlives).map(|(ahead, _)| ahead as u32 + 1);
        Ok(Self {
            longest_fills: asked.iter().map(fills).sum::<f64>() / asked.len() as f64,
            end_batches: ends.max().unwrap_or(1),
        })
    }
}
