//! One channel: its queues, the state of its banks, and what it does next.

use super::Requester;
use crate::DramCounts;
use crate::description::{Dram as Description, DramTiming};

/// What becomes of a read.
pub enum Offer {
    /// The queue is full.
    Refused,
    /// It will be served, or joined one that will be.
    Queued,
    /// A waiting write holds the line.
    Ready,
}

#[derive(Clone, Debug)]
struct Request {
    line: u32,
    bank: u32,
    row: u32,
    arrival: u64,
    requesters: Vec<Requester>,
}

const CLOSED: u32 = u32::MAX;

#[derive(Clone, Copy, Debug)]
struct Bank {
    open_row: u32,
    next_activate: u64,
    next_precharge: u64,
    next_column: u64,
}

/// A channel with one rank.
#[derive(Clone, Debug)]
pub struct Channel {
    timing: DramTiming,
    read_limit: usize,
    write_limit: usize,
    drain_high: usize,
    drain_low: usize,
    reads: Vec<Request>,
    writes: Vec<Request>,
    /// Whether writes are served in preference to reads.
    draining: bool,
    banks: Vec<Bank>,
    next_read: u64,
    next_write: u64,
    next_activate: u64,
    /// The last four activates.
    activates: [u64; 4],
    next_refresh: u64,
    open_banks: u32,
    active_since: u64,
    counts: DramCounts,
    /// Clock at which there may be something to do.
    pub next: u64,
}

/// Long ago, without underflow.
const NEVER: u64 = 0;

impl Channel {
    pub fn new(description: &Description) -> Self {
        let timing = description.timing;
        let bank = Bank { open_row: CLOSED, next_activate: NEVER, next_precharge: NEVER, next_column: NEVER };
        Self {
            timing,
            read_limit: description.read_queue as usize,
            write_limit: description.write_queue as usize,
            drain_high: description.write_drain_high as usize,
            drain_low: description.write_drain_low as usize,
            reads: vec![],
            writes: vec![],
            draining: false,
            banks: vec![bank; description.banks as usize],
            next_read: NEVER,
            next_write: NEVER,
            next_activate: NEVER,
            activates: [NEVER; 4],
            next_refresh: u64::from(timing.refresh_interval),
            open_banks: 0,
            active_since: 0,
            counts: DramCounts::default(),
            next: u64::from(timing.refresh_interval),
        }
    }

    /// Reads that the queue can still take.
    pub fn room(&self) -> usize {
        self.read_limit - self.reads.len()
    }

    pub fn read(&mut self, clock: u64, line: u32, bank: u32, row: u32, requester: Requester) -> Offer {
        if let Some(request) = self.reads.iter_mut().find(|request| request.line == line) {
            request.requesters.push(requester);
            self.counts.merged_reads += 1;
            return Offer::Queued;
        }
        if self.writes.iter().any(|request| request.line == line) {
            self.counts.merged_reads += 1;
            return Offer::Ready;
        }
        if self.reads.len() >= self.read_limit {
            self.counts.refused += 1;
            return Offer::Refused;
        }
        self.reads.push(Request { line, bank, row, arrival: clock, requesters: vec![requester] });
        self.next = self.next.min(clock);
        Offer::Queued
    }

    pub fn write(&mut self, clock: u64, line: u32, bank: u32, row: u32) -> bool {
        if self.writes.iter().any(|request| request.line == line) {
            self.counts.merged_writes += 1;
            return true;
        }
        if self.writes.len() >= self.write_limit {
            self.counts.refused += 1;
            return false;
        }
        self.writes.push(Request { line, bank, row, arrival: clock, requesters: vec![] });
        self.next = self.next.min(clock);
        true
    }

    /// Issues at most one command at `clock` and sets `next`. Returns the line of a read that was issued, when its
    /// data are there, and who waits for them.
    pub fn command(&mut self, clock: u64) -> Option<(u64, u32, Vec<Requester>)> {
        if clock >= self.next_refresh {
            self.refresh();
            self.next = clock + 1;
            return None;
        }
        if self.writes.len() >= self.drain_high {
            self.draining = true;
        } else if self.writes.len() <= self.drain_low {
            self.draining = false;
        }
        // The earliest clock at which any candidate's next command is allowed.
        let mut soonest = self.next_refresh;
        let no_read = self.reads.iter().all(|request| request.arrival > clock);
        let writing = self.draining || no_read;
        if writing {
            // A read that arrives later is looked at when it arrives.
            soonest = self
                .reads
                .iter()
                .map(|request| request.arrival)
                .fold(soonest, |a, b| if b > clock { a.min(b) } else { a });
        }
        let queue = if writing { &self.writes } else { &self.reads };
        let mut chosen = None;
        let bus = if writing { self.next_write } else { self.next_read };
        for (at, request) in queue.iter().enumerate() {
            let bank = &self.banks[request.bank as usize];
            if bank.open_row == request.row {
                let allowed = bank.next_column.max(bus).max(request.arrival);
                if allowed <= clock {
                    chosen = Some(at);
                    break;
                }
                soonest = soonest.min(allowed);
            }
        }
        if let Some(at) = chosen {
            self.next = clock + 1;
            return if writing {
                self.issue_write(clock, at);
                None
            } else {
                Some(self.issue_read(clock, at))
            };
        }
        let activate_allowed = self.next_activate.max(self.after_four_activates());
        for request in queue {
            let number = request.bank as usize;
            let bank = &self.banks[number];
            if bank.open_row == request.row {
                continue;
            }
            let closed = bank.open_row == CLOSED;
            let allowed = if closed { bank.next_activate.max(activate_allowed) } else { bank.next_precharge };
            let allowed = allowed.max(request.arrival);
            if allowed <= clock {
                let row = request.row;
                if closed {
                    self.activate(clock, number, row);
                } else {
                    self.precharge(clock, number);
                }
                self.next = clock + 1;
                return None;
            }
            soonest = soonest.min(allowed);
        }
        self.next = soonest;
        None
    }

    /// The clock from which on the last four activates allow another.
    fn after_four_activates(&self) -> u64 {
        if self.counts.activates < 4 { 0 } else { self.activates[0] + u64::from(self.timing.four_activates) }
    }

    fn activate(&mut self, clock: u64, number: usize, row: u32) {
        let t = &self.timing;
        let bank = &mut self.banks[number];
        bank.open_row = row;
        bank.next_column = clock + u64::from(t.activate_to_column);
        bank.next_precharge = clock + u64::from(t.activate_to_precharge);
        bank.next_activate = clock + u64::from(t.activate_to_activate_same_bank);
        self.next_activate = clock + u64::from(t.activate_to_activate);
        self.activates.rotate_left(1);
        self.activates[3] = clock;
        self.counts.activates += 1;
        if self.open_banks == 0 {
            self.active_since = clock;
        }
        self.open_banks += 1;
    }

    fn precharge(&mut self, clock: u64, number: usize) {
        let bank = &mut self.banks[number];
        bank.open_row = CLOSED;
        bank.next_activate = bank.next_activate.max(clock + u64::from(self.timing.precharge));
        self.open_banks -= 1;
        if self.open_banks == 0 {
            self.counts.active_clocks += clock - self.active_since;
        }
    }

    fn issue_read(&mut self, clock: u64, at: usize) -> (u64, u32, Vec<Requester>) {
        let t = self.timing;
        let request = self.reads.remove(at);
        let bank = &mut self.banks[request.bank as usize];
        bank.next_precharge = bank.next_precharge.max(clock + u64::from(t.read_to_precharge));
        let gap = u64::from(t.column_to_column.max(t.burst));
        self.next_read = self.next_read.max(clock + gap);
        // The bus turns around: the write's data must not start before the read's have passed.
        let turn = u64::from(t.read_latency + t.burst + 2).saturating_sub(u64::from(t.write_latency));
        self.next_write = self.next_write.max(clock + turn.max(gap));
        let done = clock + u64::from(t.read_latency + t.burst);
        self.counts.reads += 1;
        self.counts.read_latency_clocks += done - request.arrival;
        (done, request.line, request.requesters)
    }

    fn issue_write(&mut self, clock: u64, at: usize) {
        let t = self.timing;
        let request = self.writes.remove(at);
        let bank = &mut self.banks[request.bank as usize];
        let end_of_data = clock + u64::from(t.write_latency + t.burst);
        bank.next_precharge = bank.next_precharge.max(end_of_data + u64::from(t.write_recovery));
        self.next_write = self.next_write.max(clock + u64::from(t.column_to_column.max(t.burst)));
        self.next_read = self.next_read.max(end_of_data + u64::from(t.write_to_read));
        self.counts.writes += 1;
    }

    /// Closes all rows and keeps the rank busy.
    fn refresh(&mut self) {
        let t = self.timing;
        let due = self.next_refresh;
        let open = self.banks.iter().filter(|bank| bank.open_row != CLOSED);
        let closed = open.map(|bank| bank.next_precharge.max(due) + u64::from(t.precharge)).max();
        let start = closed.unwrap_or(due);
        if self.open_banks > 0 {
            self.counts.active_clocks += start - self.active_since;
            self.open_banks = 0;
        }
        for bank in &mut self.banks {
            bank.open_row = CLOSED;
            bank.next_activate = bank.next_activate.max(start + u64::from(t.refresh));
        }
        self.next_refresh += u64::from(t.refresh_interval);
        self.counts.refreshes += 1;
    }

    /// What happened up to `clock`.
    pub fn counts_at(&mut self, clock: u64) -> DramCounts {
        let mut counts = self.counts;
        if self.open_banks > 0 {
            counts.active_clocks += clock.saturating_sub(self.active_since);
        }
        counts
    }
}
