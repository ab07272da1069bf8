//! Fuzz targets: every reader of files, fed with damaged files.
//!
//! A [`Target`] reads bytes. Its seeds are good files and files of known faults; [`fuzz`] damages them in all ways of [`damage`],
//! by strategies of `proptest`, which also finds the smallest damage that still fails. A target fails where it panics, takes more
//! than [`Target::most_bytes`] of memory, or takes longer than [`MOST_SECONDS`]. That it returns an error is no failure.
//!
//! The variable `DUALSPLIT_FUZZ_SECONDS` says how long each target is fuzzed. A fault that is found becomes a test of the reader.
//!
//! ```
//! let ply = fuzz::targets::ALL.iter().find(|target| target.name == "ply").expect("a format");
//! (ply.read)(b"ply\nformat ascii 1.0\n"); // an error, and no panic
//! ```

pub mod damage;
pub mod targets;

use damage::{Damage, damaged};
use peak_alloc::PeakAlloc;
use proptest::collection::vec;
use proptest::prelude::any;
use proptest::sample::Index;
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestError, TestRng, TestRunner};
use std::io::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Mutex, Once, PoisonError};
use std::time::{Duration, Instant};

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// A reader of files.
#[derive(Clone, Copy)]
pub struct Target {
    /// The name of what it reads.
    pub name: &'static str,
    /// Files that it reads, or nearly does.
    pub seeds: fn() -> Vec<Vec<u8>>,
    /// Reads a file.
    pub read: fn(&[u8]),
    /// The most memory that reading a file of at most [`MOST_INPUT`] bytes may take, in bytes.
    pub most_bytes: usize,
}

/// The longest file that is tried.
pub const MOST_INPUT: usize = 1 << 16;

/// The longest time for a file. Debug builds and busy hosts are slow; a reader that hangs takes longer.
pub const MOST_SECONDS: u64 = 20;

/// After so many seconds the process ends: a reader that does not return is found by nothing else.
const HANGING_SECONDS: u64 = 3 * MOST_SECONDS;

/// Cases between two looks at the clock.
const BATCH: u32 = 64;

/// Damages to a file.
const MOST_DAMAGES: usize = 6;

/// How long each target is fuzzed: as the variable `DUALSPLIT_FUZZ_SECONDS` says, or a second.
///
/// # Panics
/// If the variable is no number.
#[must_use]
pub fn duration() -> Duration {
    let text = std::env::var("DUALSPLIT_FUZZ_SECONDS").unwrap_or_else(|_| "1".to_owned());
    Duration::from_secs_f64(text.parse().expect("DUALSPLIT_FUZZ_SECONDS is a number of seconds"))
}

/// Feeds `target` with its seeds and then with damaged ones for about `duration`. Returns the number of files.
///
/// # Errors
/// What went wrong, with the smallest file for which it does.
///
/// # Panics
/// If the target has no seed.
pub fn fuzz(target: &Target, duration: Duration) -> Result<u64, String> {
    // Memory is counted for the whole process.
    static ALONE: Mutex<()> = Mutex::new(());
    let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
    watch();
    let seeds = (target.seeds)();
    let explained = |what: &str, bytes: &[u8]| {
        format!("{}: {what}; the file: b\"{}\"", target.name, bytes.escape_ascii())
    };
    for seed in &seeds {
        check(target, seed).map_err(|what| explained(&what, seed))?;
    }
    let end = Instant::now() + duration;
    let strategy = (any::<Index>(), any::<Index>(), vec(any::<Damage>(), 0..MOST_DAMAGES));
    let mut files = seeds.len() as u64;
    for batch in 0u64.. {
        let mut start = [0; 32];
        start[..8].copy_from_slice(&batch.to_le_bytes());
        let config =
            Config { cases: BATCH, failure_persistence: None, max_shrink_iters: 2000, ..Config::default() };
        let mut runner = TestRunner::new_with_rng(config, TestRng::from_seed(RngAlgorithm::ChaCha, &start));
        let of = |index: &Index| seeds[index.index(seeds.len())].as_slice();
        let bytes_of = |(seed, other, damages): &(Index, Index, Vec<Damage>)| {
            let mut bytes = damaged(of(seed), of(other), damages);
            bytes.truncate(MOST_INPUT);
            bytes
        };
        let tried =
            runner.run(&strategy, |case| check(target, &bytes_of(&case)).map_err(TestCaseError::fail));
        match tried {
            Ok(()) => files += u64::from(BATCH),
            Err(TestError::Fail(what, case)) => return Err(explained(what.message(), &bytes_of(&case))),
            Err(TestError::Abort(what)) => return Err(what.message().to_owned()),
        }
        if Instant::now() >= end {
            break;
        }
    }
    Ok(files)
}

/// The file that is being read, since when.
static READING: Mutex<Option<(Instant, Vec<u8>)>> = Mutex::new(None);

/// Tells which file is being read, or that none is.
fn reading(bytes: Option<&[u8]>) {
    let bytes = bytes.map(|bytes| (Instant::now(), bytes.to_vec()));
    *READING.lock().unwrap_or_else(PoisonError::into_inner) = bytes;
}

/// Starts the thread that ends the process where a reader hangs, with the file on stderr.
fn watch() {
    static STARTED: Once = Once::new();
    let watching = || {
        loop {
            std::thread::sleep(Duration::from_secs(1));
            if let Some((since, bytes)) = &*READING.lock().unwrap_or_else(PoisonError::into_inner)
                && since.elapsed().as_secs() >= HANGING_SECONDS
            {
                // Not by `eprintln`: a test that does not end keeps that to itself.
                let file = bytes.escape_ascii();
                _ = writeln!(std::io::stderr(), "reading it does not end; the file: b\"{file}\"");
                std::process::abort();
            }
        }
    };
    STARTED.call_once(|| _ = std::thread::spawn(watching));
}

/// Reads one file.
fn check(target: &Target, bytes: &[u8]) -> Result<(), String> {
    reading(Some(bytes));
    let (before, start) = (MEMORY.current_usage(), Instant::now());
    MEMORY.reset_peak_usage();
    let read = catch_unwind(AssertUnwindSafe(|| (target.read)(bytes)));
    reading(None);
    let (taken, seconds) = (MEMORY.peak_usage().saturating_sub(before), start.elapsed().as_secs());
    match read {
        Err(_) => Err("reading it panics".to_owned()),
        Ok(()) if taken > target.most_bytes => Err(format!("reading it takes {taken} bytes")),
        Ok(()) if seconds >= MOST_SECONDS => Err(format!("reading it takes {seconds} s")),
        Ok(()) => Ok(()),
    }
}
