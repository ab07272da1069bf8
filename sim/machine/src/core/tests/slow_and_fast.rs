//! The core against the slow model, on random programs, work and machines.

use super::walk::Walk;
use super::{machine, slow};
use crate::core::simulate;
use crate::program::Program;
use base::split_mix;

/// Random choices.
struct Choices(u64);

impl Choices {
    fn below(&mut self, end: u64) -> u64 {
        split_mix::next(&mut self.0) % end
    }

    fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len() as u64) as usize]
    }

    /// An instruction of any kind on few registers, so that many depend on each other.
    fn instruction(&mut self) -> String {
        let mut f = || format!("$f{}", self.below(6));
        let floats: Vec<String> = (0..10).map(|_| f()).collect();
        let mut r = || format!("${}", 3 + self.below(5));
        let [a, b, c] = [r(), r(), r()];
        let [x, y, z] = [&floats[0], &floats[1], &floats[2]];
        let word = self.below(80);
        match self.below(16) {
            0 => format!("mul.s {x}, {y}, {z}"),
            1 => format!("div.s {x}, {y}, {z}"),
            2 => format!("addu {a}, {b}, {c}"),
            3 => "nop".to_owned(),
            4 => format!("FPMIN {x}, {y}, {z}"),
            5 => format!("c.olt.s {x}, {y}\nmovt {a}, {b}, $fcc0"),
            6 => format!("STORE {a}, {b}, {word}"),
            7 => format!("STORE {x}, {b}, {}", word % 4),
            8 => {
                let ray = floats[..9].join(", ");
                let (outputs, planes) = (floats[..4].join(", "), floats[4..6].join(", "));
                format!("DSTSTEP {a}, {b}, {c}, {outputs}, {a}, {planes}, {ray}")
            }
            9 => format!("BOXTEST {a}, {x}, {}, {}", floats.join(", "), floats[..6].join(", ")),
            10..=11 => {
                let words: Vec<String> = (0..4).map(|i| format!("LOAD $f{i}, $8, {}", word + i)).collect();
                words.join("\n")
            }
            12 => format!("LOAD {a}, $9, {}", word % 4),
            _ => format!("LOAD {x}, $8, {word}"),
        }
    }

    fn block(&mut self, most: u64) -> String {
        let lines: Vec<String> = (0..self.below(most) + 1).map(|_| self.instruction()).collect();
        lines.join("\n")
    }

    /// A program whose threads go through a body, perhaps skip a part of it, and go round a loop.
    fn listing(&mut self) -> String {
        let [a, b, c, d] = [(); 4].map(|()| self.block(8));
        format!(
            "main:\n ATOMIC_INC $2, 0\n beqz $2, $end\n nop\n$body:\n{a}\n\
             beqz $3, $loop\n nop\n{b}\n$loop:\n{c}\n bnez $4, $loop\n nop\n{d}\n\
             ATOMIC_INC $2, 0\n bnez $2, $body\n nop\n$end:\n jr $ra\n nop\n"
        )
    }

    /// A small machine in which much is scarce.
    fn settings(&mut self) -> Vec<String> {
        let ways = self.one_of(&[1, 1, 2, 4]);
        let mut settings = vec![
            format!("chip.l2_partitions={}", self.one_of(&[1, 1, 2])),
            format!("chip.tms_per_partition={}", self.one_of(&[1, 2, 3])),
            format!("tm.threads={}", self.one_of(&[1, 2, 3, 8, 32])),
            format!("tm.load_words={}", self.one_of(&["1", "1", "2", "4", "\"line\""])),
            format!("icache.caches={}", self.one_of(&[1, 2])),
            format!("icache.banks={}", self.one_of(&[1, 4, 16])),
            format!("icache.fetches_per_bank={}", self.one_of(&[1, 2])),
            format!("l1.enabled={}", self.one_of(&[true, true, true, false])),
            format!("l1.size={}", self.one_of(&[512, 1024, 4096])),
            format!("l1.associativity={ways}"),
            format!("l1.banks={}", self.one_of(&[1, 2, 8])),
            format!("l1.ports={}", self.one_of(&[1, 1, 2, 4])),
            format!("l1.bank_by={}", self.one_of(&["word", "word", "line"])),
            format!("l1.latency_cycles={}", self.one_of(&[1, 1, 3])),
            format!("l1.miss_registers={}", self.one_of(&[0, 0, 1, 3])),
            format!("network.latency_cycles={}", self.one_of(&[0, 0, 1, 9])),
            format!("l2.miss_registers={}", self.one_of(&[0, 0, 1, 4])),
            format!("l2.enabled={}", self.one_of(&[true, true, true, false])),
            format!("l2.size={}", self.one_of(&[1024, 4096, 65536])),
            format!("l2.associativity={}", self.one_of(&[1, 2, 8])),
            format!("l2.banks={}", self.one_of(&[1, 4, 16])),
            format!("l2.ports={}", self.one_of(&[1, 1, 2])),
            format!("l2.bank_by={}", self.one_of(&["word", "word", "line"])),
            format!("l2.latency_cycles={}", self.one_of(&[1, 3, 7])),
            format!("dram.channels={}", self.one_of(&[1, 4])),
            format!("dram.read_queue={}", self.one_of(&[1, 4, 80])),
            format!("dram.write_queue={}", self.one_of(&[2, 80])),
            "dram.write_drain_high=2".to_owned(),
            "dram.write_drain_low=1".to_owned(),
        ];
        for unit in ["fp_mul", "fp_inv", "int_add", "branch"] {
            settings.push(format!("units.{unit}.count={}", self.one_of(&[1, 2, 16])));
            settings.push(format!("units.{unit}.latency_cycles={}", self.one_of(&[1, 2, 17])));
        }
        if self.below(4) == 0 {
            // Quanta shorter than a host's word has bits for.
            settings.push("dram.timing.read_latency=3".to_owned());
            settings.push("dram.timing.burst=2".to_owned());
        }
        settings
    }
}

#[test]
fn the_core_counts_what_the_slow_model_counts() {
    let mut sums = [0; 10];
    for seed in 0..150 {
        let mut choices = Choices(split_mix::hash(seed));
        let settings = choices.settings();
        let settings: Vec<&str> = settings.iter().map(String::as_str).collect();
        let machine = machine(&settings);
        let listing = choices.listing();
        let program = Program::new("random", &listing, &machine, choices.one_of(&[1, 3, 20])).unwrap();
        let (items, words) = (choices.one_of(&[1, 40, 300]), choices.one_of(&[40, 600, 20_000]));
        let decide = |item: u32, decision: u64| {
            let random = split_mix::hash(seed ^ u64::from(item) << 32 ^ decision);
            (random & 1 == 0, 64 + (random >> 32) as u32 % words)
        };
        let work = Walk { program: &program, items, decide };
        let fast = simulate(&machine, &program, &work, |_| {}).unwrap();
        let slow = slow::simulate(&machine, &program, &work);
        assert_eq!(format!("{fast:#?}"), format!("{slow:#?}"), "seed {seed}, {settings:?}\n{listing}");
        let threads = u64::from(machine.chip.tms() * machine.tm.threads);
        assert_eq!(fast.thread_cycles.total(), threads * u64::from(fast.cycles), "seed {seed}");
        let seen = [
            fast.thread_cycles.units,
            fast.thread_cycles.fetch,
            fast.l1.joined,
            fast.l1.bank_conflicts,
            fast.l2.hits,
            fast.l2.bank_conflicts,
            fast.dram.refused,
            fast.l1.stores,
            fast.l1.register_conflicts,
            fast.l2.register_conflicts,
        ];
        sums.iter_mut().zip(seen).for_each(|(sum, seen)| *sum += seen);
    }
    assert!(sums.iter().all(|sum| *sum > 1000), "everything that is to be compared happens: {sums:?}");
}
