//! The DRAM as calendars: of each channel's data bus, and of the rows that it opens.

use super::calendar::Calendar;
use crate::description::Dram as Description;
use memory::DramCounts;
use std::collections::VecDeque;

/// A row of a bank, while it is open.
#[derive(Clone, Copy, Debug)]
struct Open {
    row: u32,
    /// Clock from which on it can be read.
    from: u64,
    /// Clock at which it is closed.
    until: u64,
    /// Clock from which on it may be closed.
    closable: u64,
    /// Clock from which on the next row may be opened in its place.
    next: u64,
}

/// A bank.
#[derive(Clone, Debug, Default)]
struct Bank {
    /// Number of refreshes before.
    refreshes: u64,
    /// Rows that a request may find, in the order in which they are open.
    rows: VecDeque<Open>,
}

/// Rows that a bank keeps; the last one is open until another follows.
const MOST_ROWS: usize = 16;

#[derive(Clone, Debug)]
struct Channel {
    /// Slots in which a line passes on the bus.
    bus: Calendar,
    /// Slots in which a row is opened.
    opens: Calendar,
    banks: Vec<Bank>,
    /// Lines to be written, in order, each with the clock at which it came.
    writes: VecDeque<(u64, u32)>,
    /// Lines that are read, each with the cycle in which it arrives.
    under_way: Vec<(u32, u32)>,
    /// The clock from which on no line is on the bus.
    idle_from: u64,
}

/// The memory of the chip. Times are DRAM clocks.
#[derive(Clone, Debug)]
pub struct Dram {
    description: Description,
    channels: Vec<Channel>,
    /// Clocks of a slot of the bus.
    line_clocks: u64,
    /// Clocks between two rows of a channel that are opened one after another.
    open_clocks: u64,
    /// What happened.
    pub counts: DramCounts,
}

impl Dram {
    /// An idle memory.
    pub fn new(description: &Description) -> Self {
        let channel = Channel {
            bus: Calendar::default(),
            opens: Calendar::default(),
            banks: vec![Bank::default(); description.banks as usize],
            writes: VecDeque::new(),
            under_way: vec![],
            idle_from: 0,
        };
        let timing = &description.timing;
        Self {
            description: *description,
            channels: vec![channel; description.channels as usize],
            line_clocks: timing.burst.max(timing.column_to_column).into(),
            open_clocks: timing.activate_to_activate.max(timing.four_activates.div_ceil(4)).into(),
            counts: DramCounts::default(),
        }
    }

    /// No request comes before cycle `start` any more.
    pub fn advance(&mut self, start: u32) {
        let clock = u64::from(start) * u64::from(self.description.clocks_per_cycle);
        for channel in &mut self.channels {
            channel.bus.advance(clock / self.line_clocks);
            channel.opens.advance(clock / self.open_clocks);
        }
    }

    /// The cycle in which `line` arrives that is asked for in cycle `now`.
    pub fn read(&mut self, now: u32, line: u32) -> u32 {
        let clock = u64::from(now) * u64::from(self.description.clocks_per_cycle);
        let channel = self.description.place(line).0;
        // Another partition may have asked for the line.
        let under_way = &mut self.channels[channel].under_way;
        under_way.retain(|(_, arrives)| *arrives > now);
        if let Some((_, arrives)) = under_way.iter().find(|(other, _)| *other == line) {
            self.counts.merged_reads += 1;
            return *arrives;
        }
        self.write_when_idle(channel, clock);
        let column = self.column(clock, line);
        let timing = &self.description.timing;
        let done = column + u64::from(timing.read_latency + timing.burst);
        self.counts.reads += 1;
        self.counts.read_latency_clocks += done - clock;
        let arrives = done.div_ceil(self.description.clocks_per_cycle.into()) as u32;
        self.channels[channel].under_way.push((line, arrives));
        arrives
    }

    /// Words of `line` are written in cycle `now`.
    pub fn write(&mut self, now: u32, line: u32) {
        let clock = u64::from(now) * u64::from(self.description.clocks_per_cycle);
        let channel = self.description.place(line).0;
        self.write_when_idle(channel, clock);
        let writes = &mut self.channels[channel].writes;
        if writes.iter().any(|(_, waiting)| *waiting == line) {
            self.counts.merged_writes += 1;
            return;
        }
        writes.push_back((clock, line));
        if writes.len() >= self.description.write_drain_high as usize {
            while self.channels[channel].writes.len() > self.description.write_drain_low as usize {
                self.write_first(channel, clock);
            }
        }
    }

    /// Writes what waits for `channel`, as far as its bus was idle before `clock` for as long as a row takes to open.
    fn write_when_idle(&mut self, channel: usize, clock: u64) {
        loop {
            let Channel { writes, idle_from, banks, .. } = &self.channels[channel];
            let Some((came, line)) = writes.front() else {
                return;
            };
            let (_, bank, row) = self.description.place(*line);
            let is_open = banks[bank as usize].rows.back().is_some_and(|open| open.row == row);
            let opening = if is_open { 0 } else { self.description.timing.activate_to_column };
            let from = (*came).max(*idle_from);
            if from + u64::from(opening) >= clock {
                return;
            }
            self.write_first(channel, from);
        }
    }

    /// Writes the first line that waits for `channel`.
    fn write_first(&mut self, channel: usize, clock: u64) {
        if let Some((_, line)) = self.channels[channel].writes.pop_front() {
            self.column(clock, line);
            self.counts.writes += 1;
        }
    }

    /// The clock at which `line` passes on its channel's bus, if it is asked for at `clock`.
    fn column(&mut self, clock: u64, line: u32) -> u64 {
        let timing = &self.description.timing;
        let (channel, bank, row) = self.description.place(line);
        let Channel { bus, opens, banks, idle_from, .. } = &mut self.channels[channel];
        let Bank { refreshes, rows } = &mut banks[bank as usize];
        let (now, interval) =
            (clock / u64::from(timing.refresh_interval), u64::from(timing.refresh_interval));
        let clock = if now > 0 { clock.max(now * interval + u64::from(timing.refresh)) } else { clock };
        if now > *refreshes {
            *refreshes = now;
            rows.clear();
        }
        let mut on_bus = |from: u64| {
            let column = from.max(bus.take(from / self.line_clocks) * self.line_clocks);
            *idle_from = (*idle_from).max(column + self.line_clocks);
            column
        };
        // Requests for a row that is open, or waits to be, are served with it.
        if let Some(open) = rows.iter_mut().find(|open| open.row == row && clock < open.until) {
            let column = on_bus(clock.max(open.from));
            open.closable = open.closable.max(column + u64::from(timing.read_to_precharge));
            return column;
        }
        let from = match rows.back_mut() {
            None => clock,
            Some(last) => {
                last.until = clock.max(last.closable);
                (last.until + u64::from(timing.precharge)).max(last.next)
            }
        };
        let opened = from.max(opens.take(from / self.open_clocks) * self.open_clocks);
        let column = on_bus(opened + u64::from(timing.activate_to_column));
        let closable = opened + u64::from(timing.activate_to_precharge);
        if rows.len() == MOST_ROWS {
            rows.pop_front();
        }
        rows.push_back(Open {
            row,
            from: opened + u64::from(timing.activate_to_column),
            until: u64::MAX,
            closable: closable.max(column + u64::from(timing.read_to_precharge)),
            next: opened + u64::from(timing.activate_to_activate_same_bank),
        });
        self.counts.activates += 1;
        column
    }

    /// What happened up to cycle `end`, in which everything is written that waits. Rows are open all the time, but for the refreshes.
    pub fn counts_at(&mut self, end: u32) -> DramCounts {
        for channel in 0..self.channels.len() {
            self.write_when_idle(channel, u64::MAX);
        }
        let description = &self.description;
        let clocks = u64::from(end) * u64::from(description.clocks_per_cycle);
        let refreshes = clocks / u64::from(description.timing.refresh_interval);
        let active = clocks.saturating_sub(refreshes * u64::from(description.timing.refresh));
        let channels = u64::from(description.channels);
        DramCounts { refreshes: refreshes * channels, active_clocks: active * channels, ..self.counts }
    }
}
