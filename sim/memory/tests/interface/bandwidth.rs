//! The bandwidth that the description states is reached at each level, and never exceeded.

use crate::driver::{Driver, LINE_WORDS, description};
use memory::description::{BankBy, Mapping};
use memory::{Access, Answer, Client};

/// Asks twice as many loads in each cycle as the banks of a cache can serve; every load brings a word that `address` gives by its
/// number. Returns how many loads were served in each cycle.
fn served(driver: &mut Driver, banks: u32, cycles: u32, address: impl Fn(u32) -> u32) -> Vec<u32> {
    let mut next = 0;
    let each = |driver: &mut Driver, next: &mut u32| {
        let mut served = 0;
        for _ in 0..2 * banks {
            let answer = driver.ask(Client { port: 0, number: 0 }, Access::Load, address(*next));
            assert!(matches!(answer, Answer::At(_) | Answer::Refused), "{answer:?}");
            served += u32::from(answer != Answer::Refused);
            *next += 1;
        }
        driver.step();
        served
    };
    (0..cycles).map(|_| each(driver, &mut next)).collect()
}

#[test]
fn a_first_level_cache_serves_a_word_of_each_bank_a_cycle() {
    for banks in [1, 4, 8, 32] {
        let mut description = description();
        description.l1.banks = banks;
        let words = description.l1.lines() * LINE_WORDS;
        for (bank_by, stride) in [(BankBy::Word, 1), (BankBy::Line, LINE_WORDS)] {
            description.l1.bank_by = bank_by;
            let mut driver = Driver::new(&description);
            (0..description.l1.lines()).for_each(|line| driver.memory.warm(0, line * LINE_WORDS));
            let each = served(&mut driver, banks, 100, |number| number * stride % words);
            assert_eq!(each, vec![banks; 100], "{banks} banks by {bank_by:?}");
            assert_eq!(driver.memory.l1_counts().bank_conflicts, 100 * u64::from(banks));
        }
        // Two accesses of each bank.
        let mut two = description;
        (two.l1.bank_by, two.l1.ports) = (BankBy::Word, 2);
        let mut driver = Driver::new(&two);
        (0..two.l1.lines()).for_each(|line| driver.memory.warm(0, line * LINE_WORDS));
        assert_eq!(served(&mut driver, banks, 100, |number| number % words), vec![2 * banks; 100]);
        // One bank, however many there are.
        description.l1.bank_by = BankBy::Line;
        let mut driver = Driver::new(&description);
        driver.memory.warm(0, 0);
        assert_eq!(served(&mut driver, banks, 100, |number| number % LINE_WORDS), [1; 100]);
    }
}

#[test]
fn a_second_level_cache_serves_a_line_by_each_bank_a_cycle() {
    for (banks, bank_by) in [(1, BankBy::Word), (4, BankBy::Word), (16, BankBy::Word), (16, BankBy::Line)] {
        let mut description = description();
        description.l1.enabled = false;
        (description.l2.banks, description.l2.bank_by) = (banks, bank_by);
        let mut driver = Driver::new(&description);
        (0..description.l2.lines()).for_each(|line| driver.memory.warm(0, line * LINE_WORDS));
        // Every load is for a line of its own, so that none joins another.
        let each = served(&mut driver, banks, 100, |number| number * LINE_WORDS + number % banks);
        assert_eq!(each, vec![banks; 100], "{banks} banks by {bank_by:?}");
        let counts = driver.memory.l2_counts();
        assert_eq!((counts.loads, counts.hits), (100 * u64::from(banks), 100 * u64::from(banks)));
    }
}

#[test]
fn a_channel_sends_a_line_each_burst_and_none_sooner() {
    let mut description = description();
    description.dram.channels = 2;
    // A refresh takes one clock in 71.
    for (mapping, stride, least) in [
        (Mapping::ChannelColumnBankRow, 1, 0.97),
        (Mapping::ChannelBankColumnRow, 1, 0.97),
        // All lines are in one of the two channels.
        (Mapping::ChannelColumnBankRow, 2, 0.485),
        // One row of a bank after another.
        (Mapping::ChannelColumnBankRow, 2 * 128 * 16, 0.0),
        (Mapping::ColumnChannelBankRow, 129, 0.0),
    ] {
        description.dram.mapping = mapping;
        let dram = &description.dram;
        let cycles = 20_000;
        let mut driver = Driver::new(&description);
        let mut sent = 0u32;
        while driver.now < cycles {
            for _ in 0..2 {
                let line = sent.wrapping_mul(stride) % (1 << 22);
                if driver.memory.keeps() {
                    break;
                }
                let answer = driver.ask(Client { port: 0, number: 0 }, Access::Load, line * LINE_WORDS);
                sent += u32::from(answer != Answer::Refused);
            }
            driver.step();
        }
        let mut arrivals: Vec<u32> = driver.told.iter().map(|told| told.arrival).collect();
        arrivals.sort_unstable();
        // Of any lines in sequence, as many bursts lie between the first and the last one as there are others on the channels. An
        // arrival is rounded up to a cycle.
        for apart in [1, 2, 10, 100, 1000] {
            for (first, last) in arrivals.iter().zip(arrivals.iter().skip(apart)) {
                let clocks = (last - first + 1) * dram.clocks_per_cycle - 1;
                let bursts = apart as u32 / dram.channels;
                assert!(
                    bursts * dram.timing.burst <= clocks,
                    "{mapping:?} {stride}: {apart} lines {first} {last}"
                );
            }
        }
        let peak = f64::from(cycles * dram.clocks_per_cycle * dram.channels) / f64::from(dram.timing.burst);
        let share = arrivals.len() as f64 / peak;
        assert!(share <= 1.0 && share >= least, "{mapping:?}, stride {stride}: {share} of the peak");
    }
}
