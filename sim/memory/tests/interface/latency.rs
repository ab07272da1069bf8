//! Each level answers after the cycles that its description states.

use crate::driver::{Driver, LINE_WORDS, description};
use memory::description::{Description, Mapping};
use memory::{Access, Answer, Client};

const CLIENT: Client = Client { port: 0, number: 0 };

#[test]
fn a_hit_takes_the_latency_of_its_level() {
    for (l1_latency, l2_latency) in [(1, 3), (2, 7), (5, 1)] {
        let mut description = description();
        description.l1.latency_cycles = l1_latency;
        description.l2.latency_cycles = l2_latency;
        let conflict = description.l1.lines() * LINE_WORDS;
        let mut driver = Driver::new(&description);
        driver.load(64);
        driver.next_quantum();
        assert_eq!(driver.load(65), l1_latency, "the first-level cache has the line");
        // Another line takes its place there, and not in the larger cache.
        driver.load(64 + conflict);
        driver.next_quantum();
        assert_eq!(driver.load(65), l1_latency + l2_latency, "the second-level cache has the line");
        assert_eq!((driver.memory.l1_counts().hits, driver.memory.l2_counts().hits), (1, 1));

        // Without a first-level cache, its latency is saved.
        description.l1.enabled = false;
        let mut driver = Driver::new(&description);
        driver.load(64);
        driver.next_quantum();
        assert_eq!(driver.load(65), l2_latency);
    }
}

#[test]
fn a_miss_takes_what_the_row_needs() {
    for (clocks_per_cycle, mapping) in [
        (1, Mapping::ColumnChannelBankRow),
        (2, Mapping::ChannelColumnBankRow),
        (3, Mapping::ChannelBankColumnRow),
    ] {
        let mut description = description();
        description.dram.clocks_per_cycle = clocks_per_cycle;
        description.dram.mapping = mapping;
        let dram = &description.dram;
        let t = dram.timing;
        let cycles = |clocks: u32| clocks.div_ceil(clocks_per_cycle);
        let same_row = match mapping {
            Mapping::ColumnChannelBankRow => 1,
            Mapping::ChannelColumnBankRow => dram.channels,
            Mapping::ChannelBankColumnRow => dram.channels * dram.banks,
        };
        let other_row = dram.channels * dram.banks * dram.columns;
        // In whatever cycle of the quantum it is asked.
        for slot in 0..8 {
            let mut driver = Driver::new(&description);
            driver.go_to(slot);
            let closed = cycles(t.activate_to_column + t.read_latency + t.burst);
            assert_eq!(driver.load(0), closed, "{mapping:?} {slot}: no row is open");
            driver.go_to(1000 + slot);
            let open = cycles(t.read_latency + t.burst);
            assert_eq!(driver.load(same_row * LINE_WORDS), open, "{mapping:?} {slot}: the row is open");
            driver.go_to(2000 + slot);
            let conflict = cycles(t.precharge + t.activate_to_column + t.read_latency + t.burst);
            assert_eq!(
                driver.load(other_row * LINE_WORDS),
                conflict,
                "{mapping:?} {slot}: another row is open"
            );
            assert_eq!(driver.memory.dram_counts(3000).activates, 2);
        }
    }
}

#[test]
fn a_load_that_joins_has_its_words_with_the_line_or_the_latency_of_the_cache_after_it() {
    let description = Description { ports_per_partition: 2, ..description() };
    let mut driver = Driver::new(&description);
    assert_eq!(driver.ask(CLIENT, Access::Load, 64), Answer::Later);
    assert_eq!(driver.ask(Client { number: 1, ..CLIENT }, Access::Load, 65), Answer::Later);
    driver.go_to(24);
    let told = &driver.told;
    assert_eq!(told.iter().map(|told| told.client.number).collect::<Vec<_>>().len(), 2);
    let arrival = told[0].arrival;
    assert!(told.iter().all(|told| told.arrival == arrival) && arrival > 24);
    assert_eq!(driver.ask(CLIENT, Access::Load, 66), Answer::At(arrival + description.l1.latency_cycles));
    // Another port finds the line on its way to the second-level cache.
    let both = description.l1.latency_cycles + description.l2.latency_cycles;
    assert_eq!(driver.ask(Client { port: 1, number: 0 }, Access::Load, 66), Answer::At(arrival + both));
    assert_eq!(driver.memory.dram_counts(25).reads, 1);
}

#[test]
fn the_network_adds_its_latency_there_and_back_to_what_goes_beyond_the_first_level() {
    for network in [0, 1, 9, 40] {
        let mut description = Description { ports_per_partition: 2, ..description() };
        description.network.latency_cycles = network;
        let t = description.dram.timing;
        let read =
            (t.activate_to_column + t.read_latency + t.burst).div_ceil(description.dram.clocks_per_cycle);
        let mut driver = Driver::new(&description);
        assert_eq!(driver.load(64), read + 2 * network, "from the memory");
        driver.next_quantum();
        assert_eq!(driver.load(65), description.l1.latency_cycles, "from the first level");
        let both = description.l1.latency_cycles + description.l2.latency_cycles;
        let other = Client { port: 1, ..CLIENT };
        let now = driver.now;
        assert_eq!(
            driver.ask(other, Access::Load, 65),
            Answer::At(now + both + 2 * network),
            "from the second level"
        );
        driver.go_to(now + 2);
        assert_eq!(driver.ask(CLIENT, Access::Store, 65), Answer::At(now + 3), "nobody waits for a store");
    }
}
