//! A description with what its keys mean.

use super::MachineDescription;
use toml::{Table, Value};

/// What is to be known of a key.
#[derive(Clone, Copy, Debug)]
struct Key {
    /// Its path; `*` stands for any name, and `l1` for `l2` too.
    path: &'static str,
    meaning: &'static str,
    unit: &'static str,
    range: &'static str,
}

const fn key(path: &'static str, meaning: &'static str, unit: &'static str, range: &'static str) -> Key {
    Key { path, meaning, unit, range }
}

/// All keys. The ranges are those of `check.rs`, here and in `memory`; a test holds them to it.
#[rustfmt::skip]
const KEYS: &[Key] = &[
    key("name", "in results", "text", "any"),
    key("clock_ghz", "clock of all but the DRAM", "GHz", "0.001 to 100"),
    key("chip.l2_partitions", "partitions of the chip, each an L2 with its multiprocessors", "partitions", "1 to 4096"),
    key("chip.tms_per_partition", "thread multiprocessors (TMs) of a partition", "multiprocessors", "1 to 4096 on the chip"),
    key("layout.alignment", "the children of a node lie in as few blocks of so many bytes as they can", "bytes", "0 for packed nodes, or a power of two from 4 to 256"),
    key("tm.threads", "thread processors of a multiprocessor: in order, one instruction a cycle each", "threads", "1 to 64"),
    key("tm.load_words", "adjacent words that one load brings to registers", "words", "1, 2, 4 or \"line\""),
    key("icache.caches", "instruction caches of a multiprocessor; a thread uses the one of its number modulo theirs", "caches", "1 to 64"),
    key("icache.size", "capacity of each, for area and energy: they hold the whole program", "bytes", "4KiB, the only size with published costs"),
    key("icache.banks", "banks of each; an instruction is in the one of its address modulo theirs", "banks", "a power of two from 1 to 64"),
    key("icache.fetches_per_bank", "fetches that a bank serves", "a cycle", "1 to 255"),
    key("units.*.count", "units that the threads of a multiprocessor share; each takes one operation a cycle", "units", "1 to 255"),
    key("units.*.latency_cycles", "until a result can be used", "cycles", "1 to 200"),
    key("l1.enabled", "whether lines stay in the cache; loads of a line under way are joined all the same", "yes or no", "true or false"),
    key("l1.size", "capacity", "bytes", "a power of two from the line to 64MiB; costs are known from 1KiB to 16MiB"),
    key("l1.line", "length of a line", "bytes", "a power of two from 16 to 256, equal in L1 and L2"),
    key("l1.banks", "banks", "banks", "a power of two from 1 to 64"),
    key("l1.ports", "accesses that a bank takes", "a cycle", "1 to 4"),
    key("l1.bank_by", "what selects a bank: the address in words, or the number of the line", "word", "\"word\" or \"line\""),
    key("l1.associativity", "lines of a set, of which the least recently used is replaced", "lines", "a power of two from 1 to the lines of the cache"),
    key("l1.latency_cycles", "until a hit can be used", "cycles", "1 to 200"),
    key("l1.miss_registers", "lines that may be on their way at a time", "lines", "0 to 65536, where 0 is any number"),
    key("l1.area_mm2", "in the place of the published or modelled area", "mm2", "0 to 1000000"),
    key("l1.energy_nj", "of an access, in the place of the published or modelled energy", "nJ", "0 to 1000000"),
    key("network.latency_cycles", "from an L1 to the L2 of its partition, and as much back", "cycles", "0 to 200"),
    key("dram.clocks_per_cycle", "DRAM clocks in a cycle of the machine", "DRAM clocks", "1 to 16"),
    key("dram.channels", "channels, each with one rank", "channels", "a power of two from 1 to 256"),
    key("dram.banks", "banks of a rank", "banks", "a power of two from 1 to 64"),
    key("dram.rows", "rows of a bank", "rows", "a power of two from 1 to 1048576, and at most 16GiB of memory"),
    key("dram.columns", "lines of a row", "lines", "a power of two from 1 to 4096"),
    key("dram.mapping", "fields of a line's number, from the least significant bits", "words", "\"column-channel-bank-row\", \"channel-column-bank-row\" or \"channel-bank-column-row\""),
    key("dram.read_queue", "reads that a channel holds", "reads", "1 to 4096"),
    key("dram.write_queue", "writes that a channel holds", "writes", "1 to 4096"),
    key("dram.write_drain_high", "writes that a channel waits for before it serves them in preference to reads", "writes", "1 to the write queue"),
    key("dram.write_drain_low", "writes at which it turns to reads again", "writes", "0 to below write_drain_high"),
    key("dram.timing.activate_to_column", "tRCD", "DRAM clocks", "1 to 65536"),
    key("dram.timing.precharge", "tRP", "DRAM clocks", "1 to 65536"),
    key("dram.timing.read_latency", "tCAS", "DRAM clocks", "1 to 65536"),
    key("dram.timing.write_latency", "tCWD", "DRAM clocks", "1 to 65536"),
    key("dram.timing.activate_to_activate_same_bank", "tRC", "DRAM clocks", "1 to 65536"),
    key("dram.timing.activate_to_precharge", "tRAS", "DRAM clocks", "1 to 65536"),
    key("dram.timing.activate_to_activate", "tRRD", "DRAM clocks", "1 to 65536"),
    key("dram.timing.four_activates", "tFAW", "DRAM clocks", "1 to 65536"),
    key("dram.timing.write_recovery", "tWR", "DRAM clocks", "1 to 65536"),
    key("dram.timing.write_to_read", "tWTR", "DRAM clocks", "1 to 65536"),
    key("dram.timing.read_to_precharge", "tRTP", "DRAM clocks", "1 to 65536"),
    key("dram.timing.column_to_column", "tCCD", "DRAM clocks", "1 to 65536"),
    key("dram.timing.burst", "that a line takes on the data bus", "DRAM clocks", "1 to 65536"),
    key("dram.timing.refresh", "tRFC", "DRAM clocks", "1 to 65536"),
    key("dram.timing.refresh_interval", "tREFI", "DRAM clocks", "long enough for a refresh and the use of a row, at most 16777216"),
    key("dram.power.chips_per_channel", "chips that serve a channel together", "chips", "1 to 64"),
    key("dram.power.vdd_v", "supply", "V", "0 to 1000000"),
    key("dram.power.idd0_ma", "of a chip that opens and closes rows", "mA", "0 to 1000000"),
    key("dram.power.idd2n_ma", "of a chip with all banks closed", "mA", "0 to 1000000"),
    key("dram.power.idd3n_ma", "of a chip with an open bank", "mA", "0 to 1000000"),
    key("dram.power.idd4r_ma", "of a chip that reads", "mA", "0 to 1000000"),
    key("dram.power.idd4w_ma", "of a chip that writes", "mA", "0 to 1000000"),
    key("dram.power.idd5_ma", "of a chip that refreshes", "mA", "0 to 1000000"),
];

impl Key {
    /// What is known of the key `path`.
    fn find(path: &str) -> Option<&'static Self> {
        let same =
            |wanted: &str, found: &str| wanted == "*" || wanted == found || (wanted, found) == ("l1", "l2");
        let is = |key: &&Self| {
            let (wanted, found) = (key.path.split('.'), path.split('.'));
            wanted.clone().count() == found.clone().count()
                && wanted.zip(found).all(|(wanted, found)| same(wanted, found))
        };
        KEYS.iter().find(is)
    }
}

/// `machine` as TOML with a comment above each key, and with the sources that `text`, from which it was read, has behind its values.
pub(super) fn explained(machine: &MachineDescription, text: &str) -> String {
    let read: Table = text.parse().unwrap_or_default();
    let own = Table::try_from(machine).expect("every field has a TOML form");
    let (head, sources) = sources(text);
    let mut out = head;
    if !out.is_empty() {
        out.push('\n');
    }
    for (path, line) in paths(&machine.to_toml()) {
        let Some(path) = path else {
            out += line;
            out.push('\n');
            continue;
        };
        if let Some(key) = Key::find(&path) {
            out += &format!("# {}; {}; {}\n", key.meaning, key.unit, key.range);
        }
        let is_unchanged = value(&read, &path).is_some() && value(&read, &path) == value(&own, &path);
        // An inline table has one source for all of its keys.
        let is_of =
            |of: &str| path.strip_prefix(of).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'));
        let source = sources.iter().find(|(of, _)| is_unchanged && is_of(of));
        out += line;
        out += &source.map_or_else(String::new, |(_, source)| format!(" # {source}"));
        out.push('\n');
    }
    out
}

/// The value at `path`.
fn value<'a>(table: &'a Table, path: &str) -> Option<&'a Value> {
    let mut keys = path.split('.');
    let first = table.get(keys.next()?)?;
    keys.try_fold(first, |value, key| value.get(key))
}

/// The lines of a TOML file, and for each that gives a key a value the key's path.
fn paths(text: &str) -> Vec<(Option<String>, &str)> {
    let mut section = String::new();
    let path = |line: &str| {
        if let Some(name) = line.strip_prefix('[').and_then(|line| line.split_once(']')) {
            section = format!("{}.", name.0);
            return None;
        }
        let (key, _) = line.split_once('=').filter(|_| !line.starts_with('#'))?;
        Some(format!("{section}{}", key.trim()))
    };
    let mut path = path;
    text.lines().map(|line| (path(line.trim()), line)).collect()
}

/// The comment at the top of a file, and the comments behind its values with their keys' paths.
fn sources(text: &str) -> (String, Vec<(String, String)>) {
    let head: String =
        text.lines().take_while(|line| line.starts_with('#')).map(|line| format!("{line}\n")).collect();
    let source = |(path, line): (Option<String>, &str)| {
        let path = path?;
        let mut quoted = false;
        let at = line.char_indices().find(|(_, c)| {
            quoted ^= *c == '"';
            *c == '#' && !quoted
        });
        Some((path, line[at?.0 + 1..].trim().to_owned()))
    };
    (head, paths(text).into_iter().filter_map(source).collect())
}

#[cfg(test)]
mod tests {
    use super::super::PRESETS;
    use super::*;

    fn load(settings: &[String]) -> Result<MachineDescription, String> {
        MachineDescription::load("trax", settings).map_err(|error| error.to_string())
    }

    /// The keys of the preset and those that it leaves out.
    fn all() -> Vec<String> {
        let settings = ["l1.ports=2", "l2.ports=2", "l1.area_mm2=1.0", "l2.energy_nj=1.0"].map(str::to_owned);
        let text = load(&settings).unwrap().to_toml();
        paths(&text).into_iter().filter_map(|(path, _)| path).collect()
    }

    #[test]
    fn every_key_is_explained_and_nothing_else() {
        let all = all();
        for path in &all {
            assert!(Key::find(path).is_some(), "{path} has no line in KEYS");
        }
        for key in KEYS {
            let is_there = all.iter().any(|path| Key::find(path).is_some_and(|found| found.path == key.path));
            assert!(is_there || key.path == "l1.energy_nj", "{}: there is no such key", key.path);
        }
    }

    #[test]
    fn an_explained_machine_is_the_machine_and_is_explained_alike() {
        for (name, preset) in PRESETS {
            let machine = MachineDescription::load(name, &[]).unwrap();
            let text = explained(&machine, preset);
            assert_eq!(super::super::settings::parse(name, &text, &[]).unwrap(), machine);
            assert_eq!(explained(&machine, &text), text);
        }
    }

    #[test]
    fn every_value_of_the_preset_says_where_it_is_from_and_a_changed_one_does_not() {
        let text = MachineDescription::explained("trax", &["l1.size=64KiB".to_owned()]).unwrap();
        let lines = paths(&text).into_iter().filter(|(path, line)| path.is_some() && !line.contains(" # "));
        assert_eq!(lines.map(|(_, line)| line).collect::<Vec<_>>(), ["size = \"64KiB\""]);
        assert!(text.contains("count = 8 # published: 8 adders; latency: sample\n"), "{text}");
        assert!(text.contains("# tRCD; DRAM clocks; 1 to 65536\nactivate_to_column = 28 # sample"), "{text}");
    }

    /// The ends of a range of integers, and whether it has powers of two only.
    fn ends(range: &str) -> Option<(i64, i64, bool)> {
        let (numbers, powers) = match range.strip_prefix("a power of two from ") {
            Some(rest) => (rest, true),
            None => (range, false),
        };
        let (low, high) = numbers.split(',').next()?.split_once(" to ")?;
        Some((low.parse().ok()?, high.parse().ok()?, powers))
    }

    #[test]
    fn ranges_are_what_is_accepted() {
        let mut tested = 0;
        for path in all() {
            let key = Key::find(&path).unwrap();
            let Some((low, high, powers)) = ends(key.range) else { continue };
            let refused = |value: i64| {
                let point = if ["mm2", "nJ", "V", "mA"].contains(&key.unit) { ".0" } else { "" };
                let error = load(&[format!("{path}={value}{point}")]).err()?;
                error.contains(&format!("{path} = ")).then_some(error)
            };
            let sizes = key.unit == "bytes";
            for value in [low, high] {
                // Another key may not fit, or all keys together: then the message has another rule.
                let error =
                    refused(value).filter(|error| error.contains("from ") && !error.contains("equal"));
                assert!(error.is_none(), "{path}={value}: {error:?}");
            }
            for value in [if powers { low / 2 } else { low - 1 }, if powers { 2 * high } else { high + 1 }] {
                assert!(sizes || value < 0 || refused(value).is_some(), "{path}={value} is accepted");
            }
            tested += 1;
        }
        assert!(tested > 50, "only {tested} keys have ranges of numbers");
    }
}
