//! The memory against its own formulas.

use super::*;
use crate::description::Mapping;
use crate::description::tests::dram as description;

const PORT: Requester = Requester { port: 0 };

/// The cycle in which a single read of `line` at cycle `now` arrives.
fn arrival(dram: &mut Dram, now: u32, line: u32) -> u32 {
    dram.advance(now);
    assert_eq!(dram.read(now, line, PORT), Read::Queued);
    let mut found = None;
    for cycle in now..now + 1000 {
        dram.advance(cycle);
        dram.announce(cycle, |arrival| found = Some(arrival.cycle));
        if let Some(cycle) = found {
            return cycle;
        }
    }
    panic!("the read never arrives");
}

#[test]
fn unloaded_latency_is_its_formula() {
    let description = description();
    let t = description.timing;
    let cycles = |clocks: u32| clocks.div_ceil(description.clocks_per_cycle);
    let mut dram = Dram::new(&description);
    let closed = cycles(t.activate_to_column + t.read_latency + t.burst);
    assert_eq!(arrival(&mut dram, 0, 0), closed);
    // The row is open now; another line of it.
    let open = cycles(t.read_latency + t.burst);
    assert_eq!(arrival(&mut dram, 1000, 1) - 1000, open);
    assert_eq!(open, Dram::least_latency(&description));
    // Another row of the same bank: precharge first.
    let other_row = description.columns * description.channels * description.banks;
    let conflict = cycles(t.precharge + t.activate_to_column + t.read_latency + t.burst);
    assert_eq!(arrival(&mut dram, 2000, other_row) - 2000, conflict);
}

#[test]
fn each_mapping_spreads_lines_in_its_order() {
    // Fields from the least significant bits on, each with two bits: the places of the lines that differ in one field only.
    for (mapping, order) in [
        (Mapping::ColumnChannelBankRow, ["column", "channel", "bank", "row"]),
        (Mapping::ChannelColumnBankRow, ["channel", "column", "bank", "row"]),
        (Mapping::ChannelBankColumnRow, ["channel", "bank", "column", "row"]),
    ] {
        let dram =
            Dram::new(&Description { mapping, channels: 4, columns: 4, banks: 4, rows: 4, ..description() });
        for (at, field) in order.into_iter().enumerate() {
            for value in 0..4 {
                let expected = match field {
                    "channel" => (value as usize, 0, 0),
                    "bank" => (0, value, 0),
                    "row" => (0, 0, value),
                    _ => (0, 0, 0),
                };
                assert_eq!(dram.description.place(value << (2 * at)), expected, "{mapping:?} {field}");
            }
        }
    }
}

#[test]
fn bandwidth_never_exceeds_its_peak() {
    let mut description = description();
    description.channels = 2;
    for stride in [1, 3, 128, 129, 4096, 4097] {
        let mut dram = Dram::new(&description);
        let (mut sent, mut received, cycles) = (0u32, 0u64, 20_000);
        for now in 0..cycles {
            dram.advance(now);
            while sent < 1 << 20 && dram.read(now, sent.wrapping_mul(stride), PORT) == Read::Queued {
                sent += 1;
                if sent % 8 == 0 {
                    break;
                }
            }
            dram.announce(now, |_| received += 1);
        }
        let clocks = f64::from(cycles * description.clocks_per_cycle);
        let peak = clocks / f64::from(description.timing.burst) * f64::from(description.channels);
        assert!(received as f64 <= peak, "stride {stride}: {received} lines, peak {peak}");
        // Adjacent lines come from open rows: all but refresh and row changes is used.
        if stride == 1 {
            assert!(received as f64 > 0.4 * peak, "{received} of {peak}");
        }
    }
}

#[test]
fn reads_of_a_line_share_one_access() {
    let mut dram = Dram::new(&description());
    assert_eq!(dram.read(0, 7, PORT), Read::Queued);
    assert_eq!(dram.read(0, 7, Requester { port: 1 }), Read::Queued);
    let mut arrivals = vec![];
    for cycle in 0..100 {
        dram.advance(cycle);
        dram.announce(cycle, |arrival| arrivals.push(arrival));
        // On its way, but not there yet.
        if !arrivals.is_empty() && cycle < arrivals[0].cycle {
            assert_eq!(dram.read(cycle, 7, PORT), Read::Arrives(arrivals[0].cycle));
        }
    }
    assert_eq!(arrivals.iter().map(|a| a.requester.port).collect::<Vec<_>>(), [0, 1]);
    assert_eq!(arrivals[0].cycle, arrivals[1].cycle);
    assert_eq!(dram.counts(100).reads, 1);
}

#[test]
fn full_queues_refuse_and_refresh_happens() {
    let description = description();
    let mut dram = Dram::new(&description);
    let row = description.columns * description.channels * description.banks;
    for request in 0..description.write_queue {
        assert!(dram.write(0, request * row), "{request}");
    }
    assert!(!dram.write(0, description.write_queue * row));
    assert!(dram.write(0, 0), "a line that waits already is written once");
    let cycles = description.timing.refresh_interval * 4 / description.clocks_per_cycle;
    dram.advance(cycles + 1);
    let counts = dram.counts(cycles);
    assert_eq!(counts.writes, u64::from(description.write_queue));
    assert_eq!(counts.refreshes, 4 * u64::from(description.channels));
    assert_eq!((counts.refused, counts.merged_writes), (1, 1));
}

#[test]
fn a_command_one_clock_early_is_not_issued() {
    let description = description();
    let t = description.timing;
    let mut channel = Channel::new(&description);
    let read = |channel: &mut Channel, clock: u64, line, bank, row| {
        assert!(matches!(channel.read(clock, line, bank, row, PORT), Offer::Queued));
    };
    // Runs to `clock`, without anything being issued before it, and returns what is issued then.
    let only_at = |channel: &mut Channel, from: u64, clock: u64| {
        for early in from..clock {
            assert!(channel.command(early).is_none(), "clock {early}, a command is due at {clock}");
        }
        channel.command(clock).map(|(done, line, _)| (done, line))
    };
    let (column, data) = (u64::from(t.activate_to_column), u64::from(t.read_latency + t.burst));
    // The row is opened at once; its first column can be read that many clocks later.
    read(&mut channel, 0, 1, 0, 7);
    assert_eq!(only_at(&mut channel, 0, column), Some((column + data, 1)));
    // The next column of the row when the bus is free.
    let gap = u64::from(t.column_to_column.max(t.burst));
    read(&mut channel, column, 2, 0, 7);
    assert_eq!(only_at(&mut channel, column + 1, column + gap), Some((column + gap + data, 2)));
    // Another row of the bank: closed when the first was open long enough, opened, read.
    read(&mut channel, column + gap, 3, 0, 8);
    let close = u64::from(t.activate_to_precharge).max(column + gap + u64::from(t.read_to_precharge));
    let open = (close + u64::from(t.precharge)).max(u64::from(t.activate_to_activate_same_bank));
    let ready = open + column;
    assert_eq!(only_at(&mut channel, column + gap + 1, ready), Some((ready + data, 3)));
}
