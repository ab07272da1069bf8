//! The analytic bound: the work of the rays over the machine's peak rates.

use super::batches::Batches;
use costs::Unit;
use machine::core::{Counts, DramCounts, Tape, ThreadCycles, Work, accesses};
use machine::description::MachineDescription;
use machine::execute::Fault;
use machine::frame::FrameWork;
use machine::program::{Kind, Program};
use machine::results::Instructions;
use rayon::prelude::*;

/// The work that some pixels ask of the machine.
#[derive(Clone, Debug, Default)]
pub struct Asked {
    /// How many times each run is executed.
    pub runs: Vec<u64>,
    /// Instructions of the longest pixel.
    pub longest: u64,
    /// One bit for each line: whether the line is read.
    lines: Vec<u64>,
    /// Number of words stored.
    pub stores: u64,
}

impl Asked {
    fn merge(mut self, other: &Self) -> Self {
        let add = |a: &mut Vec<u64>, b: &[u64], join: fn(u64, u64) -> u64| {
            a.resize(a.len().max(b.len()), 0);
            a.iter_mut().zip(b).for_each(|(a, b)| *a = join(*a, *b));
        };
        add(&mut self.runs, &other.runs, |a, b| a + b);
        add(&mut self.lines, &other.lines, |a, b| a | b);
        self.longest = self.longest.max(other.longest);
        self.stores += other.stores;
        self
    }

    /// Number of distinct lines read.
    #[must_use]
    pub fn distinct_lines(&self) -> u64 {
        self.lines.iter().map(|word| u64::from(word.count_ones())).sum()
    }
}

/// Records the batches `indices`, each on its own, on all of the host's threads.
///
/// # Errors
/// What the program does wrong.
pub fn record(
    work: &FrameWork<'_>,
    batches: &Batches,
    indices: &[u32],
    line_words: u32,
) -> Result<Vec<Asked>, Box<Fault>> {
    let program = &*work.program;
    let (_, later) = work.entries().expect("a frame has items");
    let lengths: Vec<u64> = program.code.runs.iter().map(|run| u64::from(run.length)).collect();
    let batch = |&index: &u32| {
        let mut asked = Asked {
            runs: vec![0; program.code.runs.len()],
            lines: vec![0; work.layout().words.div_ceil(u64::from(line_words) * 64) as usize],
            ..Asked::default()
        };
        let mut words = vec![];
        let mut before = 0;
        for pixel in batches.items_of(index) {
            words.clear();
            work.record(pixel, later, &mut Tape::new(&mut words, &mut asked.runs).not_timed())?;
            let total: u64 = asked.runs.iter().zip(&lengths).map(|(times, length)| times * length).sum();
            asked.longest = asked.longest.max(total - before);
            before = total;
            accesses(program, &words, |kind, word| match kind {
                Kind::Load => {
                    let line = word / line_words;
                    asked.lines[line as usize / 64] |= 1 << (line % 64);
                }
                _ => asked.stores += 1,
            });
        }
        Ok(asked)
    };
    indices.par_iter().map(batch).collect()
}

/// The sum of `batches`.
#[must_use]
pub fn sum(batches: &[Asked]) -> Asked {
    batches.iter().fold(Asked::default(), Asked::merge)
}

/// How often a thread executes each run beside its pixels, if these were all recorded as later ones.
#[derive(Clone, Debug)]
pub struct Ends {
    /// A thread starts, and finds in the end that there are no more pixels.
    always: Vec<u64>,
    /// A thread takes its first pixel from another place: by how much the runs differ, of pixel 0.
    first: Vec<i64>,
}

impl Ends {
    /// Those of a thread of `work`.
    ///
    /// # Errors
    /// What the program does wrong.
    pub fn new(work: &FrameWork<'_>) -> Result<Self, Box<Fault>> {
        let (first, later) = work.entries().expect("a frame has items");
        let count = |record: &dyn Fn(&mut Tape<'_>) -> Result<(), Box<Fault>>| {
            let mut counts = vec![0; work.program.code.runs.len()];
            record(&mut Tape::new(&mut vec![], &mut counts).not_timed()).map(|()| counts)
        };
        let always = count(&|tape| {
            work.start(tape)?;
            work.execute(work.items(), later, tape)
        })?;
        let as_first = count(&|tape| work.execute(0, first, tape))?;
        let as_later = count(&|tape| work.execute(0, later, tape))?;
        let first = as_first.iter().zip(as_later).map(|(first, later)| *first as i64 - later as i64);
        Ok(Self { always, first: first.collect() })
    }

    /// Adds those of `threads` threads to the `runs` of `pixels`.
    fn add(&self, threads: u64, pixels: u64, runs: &mut [u64]) {
        let busy = threads.min(pixels) as i64;
        for ((run, always), first) in runs.iter_mut().zip(&self.always).zip(&self.first) {
            // Another first pixel than pixel 0 may have taken another path.
            *run = (*run + always * threads).saturating_add_signed(first * busy);
        }
    }
}

/// A lower bound of the time, with the resource that sets it.
#[derive(Clone, Debug)]
pub struct Bound {
    /// The counts of a frame that takes this time.
    pub counts: Counts,
    /// The resource that sets the bound.
    pub resource: String,
}

/// The least time that `machine` needs for `scale` times the work `asked`, which is a frame of `pixels`.
#[must_use]
pub fn bound(
    machine: &MachineDescription,
    program: &Program,
    ends: &Ends,
    asked: &Asked,
    (pixels, scale): (u64, f64),
) -> Bound {
    let threads = u64::from(machine.chip.tms() * machine.tm.threads);
    let mut runs: Vec<u64> = asked.runs.iter().map(|times| (*times as f64 * scale).round() as u64).collect();
    ends.add(threads, pixels, &mut runs);
    let mut counts = Counts { runs, ..Counts::default() };
    let instructions = Instructions::new(program, &counts);
    let tms = f64::from(machine.chip.tms());
    // A line comes from memory at least once. The lines that a sample reads are a subset of those that the frame reads.
    let lines = asked.distinct_lines();
    let icache = &machine.icache;
    let fetches = f64::from(icache.caches) * f64::from(icache.banks) * f64::from(icache.fetches_per_bank);
    let timing = &machine.dram.timing;
    let mut bounds = vec![
        ("issue".to_owned(), instructions.total as f64 / threads as f64),
        ("fetch".to_owned(), instructions.total as f64 / (tms * fetches)),
        ("pipeline".to_owned(), instructions.pipeline as f64 / tms),
        ("longest pixel".to_owned(), asked.longest as f64),
        (
            "memory".to_owned(),
            lines as f64 * f64::from(timing.burst.max(timing.column_to_column))
                / f64::from(machine.dram.channels * machine.dram.clocks_per_cycle),
        ),
    ];
    if machine.l1.enabled {
        let accesses = (instructions.loads + instructions.stores) as f64;
        bounds.push(("l1".to_owned(), accesses / (tms * f64::from(machine.l1.banks))));
    }
    for unit in Unit::ALL {
        let times = instructions.units.get(&unit).copied().unwrap_or(0) as f64;
        let name = unit.name().to_owned();
        bounds.push((name, times / (tms * f64::from(machine.units.pool(unit).count))));
    }
    let (resource, cycles) =
        bounds.into_iter().fold((String::new(), 0.0), |a, b| if b.1 > a.1 { b } else { a });
    counts.cycles = cycles.ceil() as u32;
    let all = u64::from(counts.cycles) * threads;
    let issue = instructions.total - instructions.nops;
    counts.thread_cycles = ThreadCycles { issue, nop: instructions.nops, ..ThreadCycles::default() };
    counts.thread_cycles.data = all.saturating_sub(instructions.total);
    counts.l1.loads = instructions.loads;
    counts.l1.hits = instructions.loads.saturating_sub(lines);
    counts.l1.stores = instructions.stores;
    counts.l2.loads = lines;
    counts.l2.stores = instructions.stores;
    let clocks = u64::from(counts.cycles) * u64::from(machine.dram.clocks_per_cycle);
    counts.dram = DramCounts {
        reads: lines,
        active_clocks: clocks * u64::from(machine.dram.channels),
        ..DramCounts::default()
    };
    Bound { counts, resource }
}
