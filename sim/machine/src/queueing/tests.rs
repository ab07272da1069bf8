//! Programs whose waits are known, and the timing core beside the estimate.

use super::population::{Bursts, train_wait};
use super::*;
use crate::core::simulate;
use crate::core::tests::walk::Walk;
use crate::core::tests::{listing, machine, repeat};

/// What the core counts, and what is estimated.
fn both(settings: &[&str], items: u32, body: &str, address: fn(u32) -> u32) -> [Counts; 2] {
    let machine = machine(settings);
    let program = Program::new("test", &listing(body), &machine, 8).unwrap();
    let work = Walk { program: &program, items, decide: |item, _| (false, address(item)) };
    let counts = simulate(&machine, &program, &work, |_| {}).unwrap();
    let estimate = estimate(&[(&machine, &program)], &work, |_| {}).unwrap().pop().unwrap();
    assert_eq!(estimate.runs, counts.runs, "every run is executed as often");
    [counts, estimate]
}

fn cycles(settings: &[&str], items: u32, body: &str, address: fn(u32) -> u32) -> [u32; 2] {
    both(settings, items, body, address).map(|counts| counts.cycles)
}

#[test]
fn a_thread_alone_takes_its_cycles_exactly() {
    let used = "LOAD $3, $4, 0\naddu $5, $3, $3";
    for body in [
        String::new(),
        repeat("add.s $f1, $f2, $f3", 40),
        repeat("add.s $f1, $f1, $f3", 40),
        "div.s $f1, $f2, $f3\nadd.s $f4, $f1, $f1".to_owned(),
        used.to_owned(),
        format!("{used}\nLOAD $3, $4, 1\naddu $5, $3, $3"),
        // A line that replaces another in the first-level cache only.
        format!("{used}\nLOAD $6, $4, 8192\naddu $5, $6, $6\nLOAD $3, $4, 1\naddu $5, $3, $3"),
        // What is loaded is used in the next run.
        format!("addu $5, $6, $6\n{used}\nLOAD $6, $4, 8192"),
        "STORE $3, $4, 0".to_owned(),
    ] {
        let [core, estimated] = cycles(&["tm.threads=1"], 3, &body, |_| 64);
        assert_eq!(estimated, core, "{body}");
    }
}

/// Asserts that what is estimated is off by at most `percent`.
fn assert_close([core, estimated]: [u32; 2], percent: f64, what: &str) {
    let error = 100.0 * (f64::from(estimated) / f64::from(core) - 1.0);
    assert!(error.abs() <= percent, "{what}: {estimated} for {core} cycles, {error:+.1} %");
}

#[test]
fn threads_that_share_units_wait_for_each_other() {
    let body = repeat("mul.s $f1, $f1, $f3\naddu $5, $6, $6\naddu $7, $6, $6", 40);
    for count in [1, 2, 4, 8, 16] {
        let setting = format!("units.fp_mul.count={count}");
        let settings = ["tm.threads=32", &setting];
        assert_close(cycles(&settings, 8000, &body, |_| 64), 8.0, &setting);
    }
}

#[test]
fn reads_share_the_buses_and_rows_of_the_memory() {
    // Each item reads lines of its own, adjacent or in rows of their own.
    let body = repeat("LOAD $3, $4, 0\naddu $5, $3, $3", 1);
    let addresses: [fn(u32) -> u32; 2] = [|item| 16 * item, |item| item.wrapping_mul(0x9E37_79B9) >> 4];
    for (address, what) in addresses.into_iter().zip(["adjacent", "scattered"]) {
        for channels in ["dram.channels=1", "dram.channels=4"] {
            let settings = ["tm.threads=32", "l1.banks=64", "l2.banks=64", channels];
            assert_close(cycles(&settings, 4000, &body, address), 15.0, &format!("{what}, {channels}"));
        }
    }
}

#[test]
fn few_items_are_spread_over_all_multiprocessors() {
    // Each partition reads the line for itself, as none has got it when the others ask.
    let settings = ["chip.l2_partitions=4", "chip.tms_per_partition=2", "tm.threads=8", "dram.channels=1"];
    let [core, estimate] = both(&settings, 8, "LOAD $3, $4, 0\naddu $5, $3, $3", |_| 64);
    assert_eq!((core.l2.loads, core.l2.hits), (8, 0));
    assert_eq!((estimate.l2.loads, estimate.l2.hits), (8, 0));
    assert_eq!((estimate.dram.reads, estimate.dram.merged_reads), (1, 7));
}

#[test]
fn machines_that_share_an_execution_count_as_each_alone() {
    let body = repeat("LOAD $3, $4, 0\nadd.s $f1, $f1, $f3\naddu $5, $3, $3", 8);
    let machines = ["tm.threads=4", "tm.threads=32", "l1.size=16KiB"].map(|setting| machine(&[setting]));
    let program = Program::new("test", &listing(&body), &machines[0], 8).unwrap();
    let work = Walk { program: &program, items: 2500, decide: |item, _| (false, 48 * item) };
    let all: Vec<_> = machines.iter().map(|machine| (machine, &program)).collect();
    let together = estimate(&all, &work, |_| {}).unwrap();
    for (alone, together) in all.into_iter().zip(together) {
        let alone = estimate(&[alone], &work, |_| {}).unwrap().pop().unwrap();
        assert_eq!(format!("{alone:?}"), format!("{together:?}"));
    }
}

#[test]
fn items_that_take_too_much_memory_are_refused() {
    let machine = machine(&[]);
    let program = Program::new("test", &listing("$loop:\nbnez $3, $loop\nnop"), &machine, 8).unwrap();
    let executed = |rounds: u64| {
        let work = Walk { program: &program, items: 8, decide: |_, decision| (decision < rounds, 0) };
        let mut items = Items::new(&work, &program, 0..0, 0..u32::MAX).unwrap();
        items.most_words = 1000;
        items.execute(8).map(|()| items.end())
    };
    assert_eq!(executed(200), Err(SimulationError::TooMuch));
    assert_eq!(executed(100), Ok(8));
}

#[test]
fn requests_wait_as_in_a_closed_queue() {
    // As many slots as threads.
    assert_eq!(Bursts::new(8, 8).wait(8, 0.7, 0.9), 0.0);
    // All ask all the time: each is served once in so many cycles as there are threads for a slot.
    for (threads, slots) in [(2, 1), (32, 2), (12, 4)] {
        let wait = Bursts::new(threads, slots).wait(threads, 1.0, 1.0);
        let expected = f64::from(threads) / f64::from(slots) - 1.0;
        assert!((wait - expected).abs() < 0.02 * expected, "{threads} threads, {slots} slots: {wait}");
    }
    // Two threads that ask in every second cycle at random. With a the share of cycles after which one waits, the next cycle leaves
    // one waiting if the other asks: a = (1 - a) / 4 + a / 2, so a = 1 / 3, and 3 / 4 (1 - a) + a = 5 / 6 are served in a cycle.
    let wait = Bursts::new(2, 1).wait(2, 0.5, 0.5);
    assert!((wait - 0.4).abs() < 0.01, "{wait}");
}

#[test]
fn a_train_waits_for_a_free_track() {
    assert_eq!(train_wait(1, 1, 0.9), 0.0);
    // One other train is on the track with this chance, in each cycle.
    assert!((train_wait(2, 1, 0.25) - 1.0 / 3.0).abs() < 1e-12);
    assert!((train_wait(3, 2, 0.5) - 1.0 / 3.0).abs() < 1e-12);
}
