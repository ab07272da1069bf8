//! What the memory consists of, as the keys of a TOML file: how large everything is, and how long it takes.

mod cache;
pub mod check;
mod dram;
mod network;
mod size;
mod words;

pub use cache::{BankBy, Cache, MAX_BANKS, MAX_PORTS};
pub use dram::{Dram, DramPower, DramTiming, Mapping};
pub use network::Network;
pub use size::Bytes;

use check::OutOfRange;

/// A whole memory.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Description {
    /// Partitions, each a second-level cache with its ports.
    pub partitions: u32,
    /// Ports of a partition, each with a first-level cache.
    pub ports_per_partition: u32,
    /// The first-level caches.
    pub l1: Cache,
    /// Between the first- and the second-level caches.
    pub network: Network,
    /// The second-level caches.
    pub l2: Cache,
    /// The DRAM that all share.
    pub dram: Dram,
}

impl Description {
    /// Whether the caches and the DRAM can be built.
    ///
    /// # Errors
    /// The first key that is out of range.
    pub fn check(&self) -> Result<(), OutOfRange> {
        let Self { l1, network, l2, dram, .. } = self;
        l1.check("l1")?;
        network.check()?;
        l2.check("l2")?;
        if l1.line != l2.line {
            return Err(OutOfRange::new("l2.line", l2.line, format!("equal to l1.line, {}", l1.line)));
        }
        dram.check(l2.line.0)
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// A cache of 32 KiB.
    pub fn cache() -> Cache {
        let text = "enabled = true\nsize = \"32KiB\"\nline = \"64B\"\nbanks = 8\nassociativity = 1\n\
                    latency_cycles = 1";
        toml::from_str(text).unwrap()
    }

    /// The DRAM of the tests at the interface.
    pub fn dram() -> Dram {
        toml::from_str(include_str!("../../tests/interface/gddr5.toml")).unwrap()
    }

    fn description() -> Description {
        Description {
            partitions: 1,
            ports_per_partition: 1,
            l1: cache(),
            network: Network::default(),
            l2: cache(),
            dram: dram(),
        }
    }

    #[test]
    fn what_cannot_be_built_is_named() {
        assert_eq!(description().check(), Ok(()));
        let error = |change: fn(&mut Description)| {
            let mut description = description();
            change(&mut description);
            description.check().unwrap_err().to_string()
        };
        assert_eq!(error(|d| d.l1.banks = 3), "l1.banks = 3: a power of two from 1 to 64");
        assert_eq!(error(|d| d.l2.ports = 5), "l2.ports = 5: from 1 to 4");
        let message = "l2.miss_registers = 65537: from 0 to 65536";
        assert_eq!(error(|d| d.l2.miss_registers = 65_537), message);
        assert_eq!(error(|d| d.network.latency_cycles = 201), "network.latency_cycles = 201: from 0 to 200");
        assert_eq!(error(|d| d.l2.line = Bytes(32)), "l2.line = 32B: equal to l1.line, 64B");
        assert_eq!(error(|d| d.dram.write_drain_high = 90), "dram.write_drain_high = 90: from 1 to 80");
        assert_eq!(error(|d| d.dram.power.vdd_v = -1.0), "dram.power.vdd_v = -1: from 0 to 1000000");
        let refresh = error(|d| (d.dram.timing.refresh, d.dram.timing.refresh_interval) = (28, 56));
        assert!(refresh.starts_with("dram.timing.refresh_interval = 56: from"), "{refresh}");
        let rows = error(|d| d.dram.rows = 1 << 20);
        assert!(rows.starts_with("dram.rows = 1048576: at most 2^34 bytes"), "{rows}");
    }

    #[test]
    fn banks_are_chosen_by_word_unless_the_key_says_otherwise() {
        assert_eq!(cache().bank_by, BankBy::Word);
        let text = toml::to_string(&Cache { bank_by: BankBy::Line, ..cache() }).unwrap();
        assert!(text.contains("bank_by = \"line\""), "{text}");
        assert_eq!(toml::from_str::<Cache>(&text).unwrap().bank_by, BankBy::Line);
        assert!(toml::from_str::<Cache>(&text.replace("\"line\"", "\"row\"")).is_err());
        let number = toml::from_str::<Cache>(&text.replace("\"line\"", "3")).unwrap_err();
        assert!(number.message().contains("expected `word` or `line`"), "{number}");
    }
}
