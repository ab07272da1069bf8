//! The DRAM: channels with queues, banks with row buffers, scheduled first-ready first-come first-served.
//!
//! Times in here are DRAM clocks. The order in which completed reads are handed out depends on nothing but the order in
//! which requests came in.

mod channel;

use crate::DramCounts;
use crate::description::Dram as Description;
use channel::{Channel, Offer};
use std::collections::VecDeque;

/// Who waits for a line: a partition's second-level cache, on behalf of a port.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Requester {
    /// The port.
    pub port: u16,
}

/// A line that has arrived.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Arrival {
    /// Cycle of the machine from which on the line can be used.
    pub cycle: u32,
    /// The line.
    pub line: u32,
    /// Whom it is for.
    pub requester: Requester,
}

/// What becomes of a read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Read {
    /// The queue is full.
    Refused,
    /// It will be served.
    Queued,
    /// The line is on its way and arrives in this cycle.
    Arrives(u32),
}

/// All channels.
#[derive(Clone, Debug)]
pub struct Dram {
    description: Description,
    channels: Vec<Channel>,
    /// For each channel, the clock at which it may have something to do.
    next: Vec<u64>,
    next_of_all: u64,
    /// All commands before this clock have been executed.
    time: u64,
    /// Lines whose time of arrival is known, in its order.
    arrivals: VecDeque<Arrival>,
    /// How many of these have been announced.
    announced: usize,
    /// Reads that joined one of these.
    joined: u64,
}

impl Dram {
    /// An idle memory.
    #[must_use]
    pub fn new(description: &Description) -> Self {
        let channels: Vec<Channel> = (0..description.channels).map(|_| Channel::new(description)).collect();
        let next: Vec<u64> = channels.iter().map(|channel| channel.next).collect();
        let next_of_all = next.iter().copied().min().unwrap_or(u64::MAX);
        Self {
            description: *description,
            channels,
            next,
            next_of_all,
            time: 0,
            arrivals: VecDeque::new(),
            announced: 0,
            joined: 0,
        }
    }

    /// The channel of a line.
    #[must_use]
    pub fn channel(&self, line: u32) -> usize {
        self.description.place(line).0
    }

    /// Reads that `channel` can still take.
    #[must_use]
    pub fn room(&self, channel: usize) -> usize {
        self.channels[channel].room()
    }

    /// Asks for `line` in cycle `now`.
    pub fn read(&mut self, now: u32, line: u32, requester: Requester) -> Read {
        if let Some(on_its_way) = self.arrivals.iter().find(|arrival| arrival.line == line) {
            self.joined += 1;
            return Read::Arrives(on_its_way.cycle);
        }
        let (channel, bank, row) = self.description.place(line);
        let clock = self.clock(now);
        match self.channels[channel].read(clock, line, bank, row, requester) {
            Offer::Refused => Read::Refused,
            Offer::Queued => {
                self.reschedule(channel);
                Read::Queued
            }
            Offer::Ready => {
                // A waiting write has the data: as fast as an open row.
                let done = clock + u64::from(self.description.timing.burst);
                Read::Arrives(done.div_ceil(u64::from(self.description.clocks_per_cycle)) as u32)
            }
        }
    }

    /// Writes `line` in cycle `now`; false if the queue is full.
    pub fn write(&mut self, now: u32, line: u32) -> bool {
        let (channel, bank, row) = self.description.place(line);
        let clock = self.clock(now);
        let accepted = self.channels[channel].write(clock, line, bank, row);
        if accepted {
            self.reschedule(channel);
        }
        accepted
    }

    /// The clock at which a request of `cycle` comes: not before what has been executed already.
    fn clock(&self, cycle: u32) -> u64 {
        (u64::from(cycle) * u64::from(self.description.clocks_per_cycle)).max(self.time)
    }

    fn reschedule(&mut self, channel: usize) {
        self.next[channel] = self.channels[channel].next;
        self.next_of_all = self.next_of_all.min(self.next[channel]);
    }

    /// Executes all commands before cycle `end`.
    #[inline]
    pub fn advance(&mut self, end: u32) {
        let end = u64::from(end) * u64::from(self.description.clocks_per_cycle);
        self.time = self.time.max(end);
        while self.next_of_all < end {
            self.execute();
        }
    }

    /// Executes what is due at the earliest clock.
    fn execute(&mut self) {
        let clock = self.next_of_all;
        for (channel, next) in self.channels.iter_mut().zip(&mut self.next) {
            if *next != clock {
                continue;
            }
            if let Some((done, line, requesters)) = channel.command(clock) {
                let cycle = done.div_ceil(u64::from(self.description.clocks_per_cycle)) as u32;
                for requester in requesters {
                    self.arrivals.push_back(Arrival { cycle, line, requester });
                }
            }
            *next = channel.next;
        }
        self.next_of_all = self.next.iter().copied().min().unwrap_or(u64::MAX);
    }

    /// Calls `arrives` for each line whose time of arrival has become known since the last call, and forgets those that
    /// arrive before cycle `start`.
    pub fn announce(&mut self, start: u32, mut arrives: impl FnMut(Arrival)) {
        while self.arrivals.front().is_some_and(|arrival| arrival.cycle < start) {
            self.arrivals.pop_front();
            self.announced -= 1;
        }
        self.arrivals.iter().skip(self.announced).for_each(|arrival| arrives(*arrival));
        self.announced = self.arrivals.len();
    }

    /// Whether lines have got a time of arrival that has not been announced.
    #[must_use]
    pub fn has_news(&self) -> bool {
        self.announced < self.arrivals.len()
    }

    /// The first cycle in which a command may be due.
    #[must_use]
    pub fn next_command(&self) -> u32 {
        let cycle = self.next_of_all / u64::from(self.description.clocks_per_cycle);
        u32::try_from(cycle).unwrap_or(u32::MAX)
    }

    /// Cycles that a read takes at least, in whole cycles.
    #[must_use]
    pub fn least_latency(description: &Description) -> u32 {
        (description.timing.read_latency + description.timing.burst) / description.clocks_per_cycle
    }

    /// Everything that happened up to cycle `now`.
    pub fn counts(&mut self, now: u32) -> DramCounts {
        let clock = self.clock(now);
        let mut sum = DramCounts { merged_reads: self.joined, ..DramCounts::default() };
        self.channels.iter_mut().for_each(|channel| sum.merge(&channel.counts_at(clock)));
        sum
    }
}

#[cfg(test)]
mod tests;
