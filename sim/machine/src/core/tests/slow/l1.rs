//! The data cache of a multiprocessor, and the lines that are on their way to it.

use super::lines::bank;
use super::{Request, Resource, Slow, State, Tm, UNKNOWN};
use crate::core::Work;
use crate::program::{BoardEntry, Kind};

/// A line on its way to a data cache.
pub struct UnderWay {
    pub arrival: u32,
    /// Threads and registers that wait for the time of arrival to be known.
    pub waiters: Vec<(usize, BoardEntry)>,
}

impl<W: Work> Slow<'_, W> {
    /// The time at which `line` arrives is known.
    pub(super) fn arrives(&mut self, tm: usize, line: u32, arrival: u32) {
        let tm = &mut self.tms[tm];
        let Some(under_way) = tm.under_way.get_mut(&line) else { return };
        under_way.arrival = arrival;
        for (thread, register) in under_way.waiters.drain(..) {
            let thread = &mut tm.threads[thread];
            thread.ready[usize::from(register)] = arrival;
            if thread.state == State::Parked {
                thread.state = State::Runs;
                let until = arrival.max(thread.time);
                self.counts.thread_cycles.data += u64::from(until - thread.time);
                thread.time = until;
            }
        }
        tm.l1.arrivals.push((arrival, line));
    }

    /// Whether the L1's bank is taken, which it counts.
    pub(super) fn l1_refuses(&mut self, request: &Request) -> bool {
        let bank = bank(&self.machine.l1, request.address);
        let (l1, cycle) = (&self.machine.l1, request.cycle);
        let refuses = l1.enabled && self.is_taken(Resource::L1(request.tm, bank), cycle, l1.ports);
        self.tms[request.tm].l1_counts.bank_conflicts += u64::from(refuses);
        refuses
    }

    /// When the word of a load can be used that finds its line in the L1, or on its way there.
    pub(super) fn l1_load(&mut self, request: &Request, rank: usize) -> Option<u32> {
        let &Request { cycle: now, tm: number, kind, address, .. } = request;
        if kind != Kind::Load {
            return None;
        }
        let (line, latency) = (address / self.machine.l1.line_words(), self.l1_latency());
        self.events += 1;
        let tm = &mut self.tms[number];
        let ready = if tm.l1.hit(now, line, (self.turn, rank, self.events)) {
            tm.l1_counts.hits += 1;
            now + latency
        } else {
            let arrival = tm.under_way.get(&line).map(|under_way| under_way.arrival);
            let arrival = arrival.filter(|arrival| *arrival > now)?;
            tm.l1_counts.joined += 1;
            if arrival == UNKNOWN {
                self.wait_for(request, line);
                UNKNOWN
            } else {
                arrival + latency
            }
        };
        self.tms[number].l1_counts.loads += 1;
        self.take(Resource::L1(number, bank(&self.machine.l1, address)), now, 1);
        Some(ready)
    }

    pub(super) fn l1_latency(&self) -> u32 {
        if self.machine.l1.enabled { self.machine.l1.latency_cycles } else { 0 }
    }

    /// The registers of a load wait until it is known when `line` arrives.
    pub(super) fn wait_for(&mut self, request: &Request, line: u32) {
        let Tm { threads, under_way, .. } = &mut self.tms[request.tm];
        let registers = threads[request.thread].targets(self.program, self.machine);
        let under_way = under_way.get_mut(&line).expect("it is under way");
        under_way.waiters.extend(registers.into_iter().map(|register| (request.thread, register)));
    }
}
