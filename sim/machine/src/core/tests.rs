//! Programs so small that their cycles can be counted by hand.

use super::*;
use crate::description::MachineDescription;
use crate::program::Program;
use walk::Walk;

mod slow;
mod slow_and_fast;
pub(crate) mod walk;

/// A program that gets an item, goes through `body` and gets the next.
pub(crate) fn listing(body: &str) -> String {
    format!(
        "main:\n ATOMIC_INC $2, 0\n beqz $2, $end\n nop\n$body:\n{body}\n\
         ATOMIC_INC $2, 0\n bnez $2, $body\n nop\n$end:\n jr $ra\n nop\n"
    )
}

pub(crate) fn machine(settings: &[&str]) -> MachineDescription {
    let settings: Vec<String> = settings.iter().map(|s| (*s).to_owned()).collect();
    MachineDescription::load("simtrax-reference", &settings).unwrap()
}

fn run_at(settings: &[&str], items: u32, body: &str, address: fn(u32) -> u32) -> Counts {
    let machine = machine(settings);
    let program = Program::new("test", &listing(body), &machine, 8).unwrap();
    let work = Walk { program: &program, items, decide: |item, _| (false, address(item)) };
    simulate(&machine, &program, &work, |_| {}).unwrap()
}

/// Cycles of `body` beyond those of no body, for one thread.
fn cycles(settings: &[&str], body: &str) -> u32 {
    let settings = [&["tm.threads=1"], settings].concat();
    let none = run_at(&settings, 1, "", |_| 0).cycles;
    run_at(&settings, 1, body, |_| 64).cycles - none
}

pub(crate) fn repeat(line: &str, times: usize) -> String {
    vec![line; times].join("\n")
}

#[test]
fn items_that_take_too_much_memory_are_refused() {
    // Each of 128 multiprocessors may hold 2^22 words of runs; an item goes round a loop more often.
    let settings = ["chip.l2_partitions=8", "chip.tms_per_partition=16", "tm.threads=1"];
    let machine = machine(&settings);
    let program = Program::new("test", &listing("$loop:\nbnez $3, $loop\nnop"), &machine, 8).unwrap();
    let simulated = |rounds: u64| {
        let work = Walk { program: &program, items: 1, decide: |_, decision| (decision < rounds, 0) };
        simulate(&machine, &program, &work, |_| {})
    };
    assert!(matches!(simulated(5 << 20), Err(SimulationError::TooMuch)));
    assert!(simulated(1 << 10).is_ok());
}

/// A row that cannot be opened between two refreshes is never read. The check of descriptions refuses such a DRAM.
#[test]
fn a_machine_in_which_nothing_moves_stops_with_its_state() {
    let mut machine = machine(&["tm.threads=1"]);
    let timing = &mut machine.dram.timing;
    (timing.refresh, timing.refresh_interval) = (1, timing.activate_to_column);
    let program = Program::new("test", &listing("LOAD $3, $4, 0\naddu $5, $3, $3"), &machine, 8).unwrap();
    let work = Walk { program: &program, items: 1, decide: |_, _| (false, 64) };
    match simulate(&machine, &program, &work, |_| {}) {
        Err(SimulationError::Stuck { waiting, reads, refreshes, .. }) => {
            assert_eq!((waiting, reads), (machine.chip.tms(), 0));
            assert!(refreshes > 1000);
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn results_are_used_when_they_are_ready_and_not_a_cycle_before() {
    // Independent: one a cycle. Dependent: one each latency; the last result is not waited for.
    assert_eq!(cycles(&[], &repeat("add.s $f1, $f2, $f3", 40)), 40);
    for latency in [1, 2, 5, 17] {
        let setting = format!("units.fp_add.latency_cycles={latency}");
        assert_eq!(cycles(&[&setting], &repeat("add.s $f1, $f1, $f3", 40)), 39 * latency + 1);
    }
    let division = "div.s $f1, $f2, $f3\nadd.s $f4, $f1, $f1";
    assert_eq!(cycles(&[], division), 17);
    // A condition is ready one cycle later, for the branch behind it too.
    assert_eq!(cycles(&[], "c.olt.s $f1, $f2\nmovt $3, $4, $fcc0"), 2);
    // The pipeline's results come after its latency.
    let step = |operands: &str| format!("DSTSTEP {operands}{}", ", $f7".repeat(9));
    let first = step("$2, $3, $4, $f1, $f2, $f3, $f4, $5, $f5, $f6");
    assert_eq!(cycles(&[], &format!("{first}\naddu $6, $3, $3")), 9);
    assert_eq!(cycles(&[], &format!("{first}\naddu $6, $7, $7")), 2);
    // Of several operands that are late, the last one decides.
    let late = "div.s $f1, $f7, $f7\ndiv.s $f2, $f7, $f7\ndiv.s $f3, $f7, $f7";
    for (user, from) in [
        ("add.s $f4, $f1, $f2".to_owned(), 17),
        ("add.s $f4, $f2, $f1".to_owned(), 17),
        ("add.s $f4, $f3, $f1".to_owned(), 18),
        (step("$2, $3, $4, $f1, $f2, $f7, $f7, $5, $f7, $f7"), 17),
        (step("$2, $3, $4, $f7, $f7, $f2, $f1, $5, $f3, $f7"), 18),
    ] {
        assert_eq!(cycles(&[], &format!("{late}\n{user}")), from + 1, "{user}");
    }
}

#[test]
fn loads_take_the_latency_of_where_the_line_is() {
    let t = machine(&[]).dram.timing;
    let memory = (t.activate_to_column + t.read_latency + t.burst) / machine(&[]).dram.clocks_per_cycle;
    let used = "LOAD $3, $4, 0\naddu $5, $3, $3";
    assert_eq!(cycles(&[], used), memory + 1);
    // The second word of the line is there after the first.
    let again = format!("{used}\nLOAD $3, $4, 1\naddu $5, $3, $3");
    assert_eq!(cycles(&[], &again), memory + 3);
    for latency in [1, 3] {
        let setting = format!("l1.latency_cycles={latency}");
        assert_eq!(cycles(&[&setting], &again), memory + 2 + latency);
    }
    // Replaced in the first-level cache by a line of the same set, but still in the second.
    let conflict = "LOAD $6, $4, 8192\naddu $5, $6, $6\nLOAD $3, $4, 1\naddu $5, $3, $3";
    let both = format!("{used}\n{conflict}");
    let counts = run_at(&["tm.threads=1"], 1, &both, |_| 64);
    assert_eq!((counts.l1.hits, counts.l2.hits, counts.l2.loads), (0, 1, 3));
    let (l1, l2) = (machine(&[]).l1.latency_cycles, machine(&[]).l2.latency_cycles);
    let two_lines = cycles(&[], &format!("{used}\nLOAD $6, $4, 8192\naddu $5, $6, $6"));
    assert_eq!(cycles(&[], &both) - two_lines, l1 + l2 + 1);
    // Two ways hold both.
    let counts = run_at(&["tm.threads=1", "l1.associativity=2"], 1, &both, |_| 64);
    assert_eq!((counts.l1.hits, counts.l2.loads), (1, 2));
    // Without a first-level cache its latency is saved, not only its hits.
    assert_eq!(cycles(&["l1.enabled=false"], &again), memory + 2 + l2);
}

#[test]
fn reads_that_find_their_channel_full_wait_and_are_all_served() {
    // Every thread reads a line of its own, all in one row of one channel: whatever the queue holds, the data bus decides.
    let settings = |queue: &'static str| ["tm.threads=32", "l1.banks=64", "l2.banks=64", queue];
    let body = "LOAD $3, $4, 0\naddu $5, $3, $3";
    let run = |queue| run_at(&settings(queue), 32, body, |item| 17 * item);
    let (free, full) = (run("dram.read_queue=80"), run("dram.read_queue=2"));
    assert_eq!((free.dram.refused, free.dram.reads), (0, 32));
    assert_eq!(full.dram.reads, 32);
    assert!(full.dram.refused >= 30, "{}", full.dram.refused);
    // Two reads in the queue keep the bus as busy as all of them, but for the cycles until room is seen.
    assert!(full.cycles >= free.cycles && full.cycles <= free.cycles + 32, "{} {}", full.cycles, free.cycles);
    assert!(full.thread_cycles.memory > free.thread_cycles.memory);
    let threads = 32 * u64::from(full.cycles);
    assert_eq!(full.thread_cycles.total(), threads);
}

#[test]
fn a_line_that_is_read_while_everybody_waits_is_not_missed() {
    // Line 4 is in the second-level cache only, its row is open. Line 5 is read from that row, and while line 4 is served
    // the memory gives the command. Then the only thread waits for line 5, and nothing else is due before the refresh.
    let set_up = "LOAD $3, $4, 0\naddu $5, $3, $3\nLOAD $6, $4, 8192\naddu $5, $6, $6\n";
    let both = format!("{set_up}LOAD $7, $4, 16\nLOAD $8, $4, 1\naddu $5, $7, $8");
    let m = machine(&[]);
    let read = (m.dram.timing.read_latency + m.dram.timing.burst) / m.dram.clocks_per_cycle;
    for nops in 0..8 {
        let nops = "nop\n".repeat(nops);
        let from = cycles(&[], &format!("{nops}{set_up}"));
        assert_eq!(cycles(&[], &format!("{nops}{both}")) - from, read + 1, "{nops}");
    }
}

#[test]
fn a_load_that_can_join_a_line_under_way_does_not_wait_for_the_bank_of_the_second_level_cache() {
    let loads = repeat("LOAD $3, $4, 0\nLOAD $5, $4, 512", 2);
    for threads in [8, 16] {
        let settings = ["chip.tms_per_partition=4", &format!("tm.threads={threads}"), "l2.banks=1"];
        let counts = run_at(&settings, 16 * threads, &loads, |item| 1024 + item % 2);
        assert_eq!(counts.l2.loads, 8, "two lines for each of four multiprocessors");
        // Each of these waits for the other three multiprocessors at most; all others find the line under way.
        assert!(counts.l2.bank_conflicts <= 8 * 3, "{counts:?}");
    }
}

#[test]
fn banks_units_and_fetches_serve_as_many_a_cycle_as_there_are() {
    let slower = |settings: &[&str], body: &str, address: fn(u32) -> u32| {
        let settings = [&["tm.threads=4", "icache.fetches_per_bank=4"], settings].concat();
        run_at(&settings, 4, body, address).thread_cycles
    };
    let adds = repeat("add.s $f1, $f2, $f3", 200);
    let free = slower(&["units.fp_add.count=4"], &adds, |_| 0);
    // The counter answers one thread a cycle: at the start, threads wait 1, 2 and 3 cycles for it.
    assert_eq!(free.units, 6);
    // One unit for four threads: each operation waits for three others, but for the ends.
    let taken = slower(&["units.fp_add.count=1"], &adds, |_| 0);
    assert!((1800..=2400).contains(&taken.units), "{taken:?}");
    assert_eq!(taken.issue, free.issue);
    // All threads load the same word: one a cycle. Different banks: no conflict.
    let loads = repeat("LOAD $3, $4, 0", 200);
    let same = slower(&[], &loads, |_| 64);
    let apart = slower(&[], &loads, |item| 64 + item);
    assert!((1800..=2700).contains(&same.memory), "{same:?}");
    assert!(apart.memory < 20, "{apart:?}");
    // One bank with one fetch for four threads.
    let one = ["icache.caches=1", "icache.banks=1", "icache.fetches_per_bank=1"];
    let fetched = slower(&one, &repeat("addu $3, $4, $4", 200), |_| 0);
    assert!((1800..=2500).contains(&fetched.fetch), "{fetched:?}");
}

#[test]
fn every_thread_cycle_is_in_one_class_and_stores_merge_or_count() {
    for settings in [vec![], vec!["chip.tms_per_partition=3"], vec!["l1.enabled=false"]] {
        let body = "LOAD $3, $4, 0\nmul.s $f1, $f1, $f1\nSTORE $3, $4, 7\naddu $3, $3, $3";
        let counts = run_at(&settings, 999, body, |item| 64 + 37 * item);
        let tms = machine(&settings).chip.tms();
        let all = u64::from(counts.cycles) * u64::from(32 * tms);
        assert_eq!(counts.thread_cycles.total(), all);
        assert_eq!((counts.l1.loads, counts.l1.stores), (999, 999));
        // Some may still wait in the queues when the last thread ends.
        let written = counts.dram.writes + counts.dram.merged_writes;
        assert!((900..=999).contains(&written), "{written}");
    }
}

#[test]
fn every_cycle_that_waits_for_memory_is_a_refusal_that_one_cache_counts() {
    // Of loads of one word and stores, with room in the memory's queues.
    let body = "LOAD $3, $4, 0\naddu $5, $3, $3\nLOAD $6, $4, 40\nSTORE $3, $4, 1";
    let queues = ["chip.tms_per_partition=4", "dram.read_queue=4096", "dram.write_queue=4096"];
    for banks in
        [["l2.banks=1", "l1.banks=8"], ["l2.banks=2", "l1.banks=2"], ["l2.banks=1", "l1.enabled=false"]]
    {
        let counts = run_at(&[&banks[..], &queues].concat(), 4000, body, |item| 64 + 37 * (item % 512));
        assert_eq!(counts.dram.refused, 0, "{banks:?}");
        assert!(counts.l2.bank_conflicts > 100, "{banks:?} {}", counts.l2.bank_conflicts);
        let refusals = counts.l1.bank_conflicts + counts.l2.bank_conflicts;
        assert_eq!(counts.thread_cycles.memory, refusals, "{banks:?}");
    }
}

#[test]
fn wide_loads_bring_adjacent_words_and_take_a_second_access_across_lines() {
    let four = "LOAD $3, $9, 0\nLOAD $4, $9, 1\nLOAD $5, $9, 2\nLOAD $6, $9, 3";
    let used = format!("{four}\naddu $7, $3, $6");
    let run = |words: &str, address: fn(u32) -> u32| {
        let words = format!("tm.load_words={words}");
        run_at(&["tm.threads=1", &words], 1, &used, address)
    };
    let instructions = |counts: &Counts| counts.thread_cycles.issue;
    let narrow = run("1", |_| 64);
    assert_eq!(narrow.l1.loads, 4);
    for (words, loads) in [("2", 2), ("4", 1), ("line", 1)] {
        let wide = run(words, |_| 64);
        assert_eq!(wide.l1.loads, loads, "{words}");
        assert_eq!(instructions(&narrow) - instructions(&wide), 4 - loads, "{words}");
        // While the line is on its way, the number of loads does not matter; once it is there, each takes a cycle.
        assert_eq!(narrow.cycles, wide.cycles, "{words}");
        let again = format!("{used}\n{used}");
        let twice = |words: &str| {
            run_at(&["tm.threads=1", &format!("tm.load_words={words}")], 1, &again, |_| 64).cycles
        };
        assert_eq!(twice("1") - twice(words), 4 - loads as u32, "{words}");
    }
    // Words 62 to 65: two in each line.
    let crossing = run("4", |_| 62);
    assert_eq!((crossing.l1.loads, crossing.dram.reads), (2, 2));
    assert_eq!(instructions(&crossing), instructions(&run("4", |_| 64)));
    // What is used between two loads keeps them apart, as does a register that is written.
    let apart = "LOAD $3, $9, 0\naddu $4, $4, $4\nLOAD $4, $9, 1";
    let counts = run_at(&["tm.threads=1", "tm.load_words=4"], 1, apart, |_| 64);
    assert_eq!(counts.l1.loads, 2);
}
