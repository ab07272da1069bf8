//! What was read was asked, and what was asked was read: nothing is lost between ports, caches and channels, nothing comes twice.

use crate::driver::{Driver, LINE_WORDS, cache, description};
use base::split_mix;
use memory::description::{Bytes, Description};
use memory::{Access, Answer, Client};
use std::collections::HashMap;

/// What clients of several ports have asked of a memory and not got yet.
#[derive(Default)]
struct Open {
    /// The line that each client waits for.
    waits: HashMap<Client, u32>,
    /// The line that each client asked for whose request is kept.
    kept: HashMap<Client, u32>,
    loads: u64,
    stores: u64,
    later: u64,
}

impl Open {
    fn answered(&mut self, client: Client, access: Access, line: u32, answer: Answer) {
        match (answer, access) {
            (Answer::Refused, _) => return,
            (Answer::Kept, _) => {
                assert_eq!(self.kept.insert(client, line), None, "{client:?} is kept twice");
                return;
            }
            (Answer::Later, Access::Store) => panic!("a store waits for no line"),
            (Answer::Later, Access::Load) => {
                assert_eq!(self.waits.insert(client, line), None, "numbers are used once");
                self.later += 1;
            }
            (Answer::At(_), _) => {}
        }
        match access {
            Access::Load => self.loads += 1,
            Access::Store => self.stores += 1,
        }
    }

    /// Hears what the memory has told the driver.
    fn hear(&mut self, driver: &mut Driver) {
        for told in std::mem::take(&mut driver.told) {
            assert!(told.arrival >= told.at, "{told:?} is told after the line has arrived");
            assert!(self.waits.remove(&told.client).is_some(), "{told:?}: nobody waits");
        }
        for (request, answer) in std::mem::take(&mut driver.woken) {
            let line = self.kept.remove(&request.client).expect("only what is kept is given back");
            assert_eq!(request.address / LINE_WORDS, line);
            self.answered(request.client, request.access, line, answer);
        }
    }
}

fn small(seed: u64) -> Description {
    let mut description = description();
    (description.partitions, description.ports_per_partition) = (2, 2);
    description.l1 = cache(1 << 10, 8, 1);
    description.l2 = cache(4 << 10, 8, 3);
    description.l1.enabled = seed % 4 != 3;
    description.l2.associativity = 1 << (seed % 3);
    description.l2.size = Bytes(4 << 10);
    description.l1.miss_registers = [0, 0, 6][seed as usize % 3];
    description.l2.miss_registers = [0, 8][seed as usize % 2];
    description.network.latency_cycles = [0, 0, 0, 5, 30][seed as usize % 5];
    description.dram.channels = 2;
    description.dram.read_queue = [80, 2, 1][seed as usize % 3];
    (description.dram.write_queue, description.dram.write_drain_high) = (8, 4);
    description.dram.write_drain_low = 1;
    description
}

#[test]
fn what_was_read_was_asked() {
    let mut kept = 0;
    for seed in 0..12 {
        let mut driver = Driver::new(&small(seed));
        let (mut open, mut state) = (Open::default(), seed);
        for number in 0..6000 {
            let random = split_mix::next(&mut state);
            let client = Client { port: (random % 4) as u16, number };
            let access = if random >> 8 & 7 == 0 { Access::Store } else { Access::Load };
            let address = (random >> 16) as u32 % 4000;
            let answer = driver.ask(client, access, address);
            kept += u32::from(answer == Answer::Kept);
            open.answered(client, access, address / LINE_WORDS, answer);
            if random >> 48 & 1 == 0 {
                driver.step();
                open.hear(&mut driver);
            }
        }
        // Until everything has been read and written.
        for _ in 0..20_000 {
            driver.step();
            open.hear(&mut driver);
        }
        assert!(
            open.waits.is_empty() && open.kept.is_empty() && !driver.memory.keeps(),
            "{seed}: all is served"
        );
        let (l1, l2) = (driver.memory.l1_counts(), driver.memory.l2_counts());
        let dram = driver.memory.dram_counts(driver.now);
        assert_eq!((l1.loads, l1.stores), (open.loads, open.stores), "{seed}: each once");
        assert_eq!(l1.hits + l1.joined + l2.loads, l1.loads, "{seed}: a load is found, joins, or goes on");
        assert_eq!(l2.hits + dram.reads + dram.merged_reads, l2.loads, "{seed}: as behind the first level");
        assert_eq!(l2.stores, open.stores, "{seed}: stores go around the caches");
        assert_eq!(dram.writes + dram.merged_writes, open.stores, "{seed}: and to the DRAM");
        assert!(open.later > 100 && l1.joined > 10 && l2.hits > 10, "{seed}: all of it happens");
    }
    assert!(kept > 100, "requests are kept: {kept}");
}
