//! What the chip does with requests: the counter, the second-level caches and the memory.

use super::l1::UnderWay;
use super::lines::bank;
use super::{Request, Resource, Slow, State, UNKNOWN};
use crate::core::Work;
use crate::program::Kind;
use memory::dram::{Read, Requester};

enum Outcome {
    Served(u32),
    /// It tries again in the next cycle.
    Refused,
    /// It tries again when the memory channel of this line has room.
    Full(u32),
}

impl<W: Work> Slow<'_, W> {
    /// The chip serves what was asked, cycle by cycle; in each cycle multiprocessors have their turn in ring order from another
    /// one each quantum, and of one multiprocessor the newest request comes first.
    pub(super) fn serve(&mut self, start: u32, length: u32, wakes: bool) {
        let count = self.tms.len();
        let first = (start / length) as usize % count;
        let place = |request: &Request| (request.tm + count - first) % count;
        let asked: Vec<Request> = self.tms.iter_mut().flat_map(|tm| std::mem::take(&mut tm.asks)).collect();
        let wakes = wakes && !self.blocked.is_empty();
        let mut waiting: Vec<Request> = vec![];
        for now in start..start + length {
            let mut tries: Vec<Request> = asked.iter().copied().filter(|ask| ask.cycle == now).collect();
            tries.append(&mut waiting);
            if wakes {
                self.dram.advance(now);
                self.wake(now, &mut tries, place);
            }
            tries.sort_by_key(place);
            for request in tries {
                let request = Request { cycle: now, ..request };
                match self.try_to_serve(request) {
                    Outcome::Served(ready) => {
                        let thread = &mut self.tms[request.tm].threads[request.thread];
                        thread.state = State::Runs;
                        self.retire(request.tm, request.thread, now, ready);
                        let new_work = request.kind == Kind::Counter;
                        self.tms[request.tm].answered.push((request.thread, new_work));
                    }
                    Outcome::Refused => {
                        self.counts.thread_cycles.memory += 1;
                        waiting.push(request);
                    }
                    Outcome::Full(line) => self.blocked.push((line, request)),
                }
            }
        }
        for request in waiting {
            let thread = &mut self.tms[request.tm].threads[request.thread];
            (thread.state, thread.time) = (State::Runs, start + length);
        }
    }

    /// As many reads as a memory channel has room for try again, and behind each those of the same line.
    fn wake(&mut self, now: u32, tries: &mut Vec<Request>, place: impl Fn(&Request) -> usize) {
        for channel in 0..self.machine.dram.channels as usize {
            for _ in 0..self.dram.room(channel) {
                let of_channel = self.blocked.iter().filter(|(line, _)| self.dram.channel(*line) == channel);
                let Some(&(first, _)) = of_channel.min_by_key(|(_, request)| place(request)) else { break };
                let (woken, rest): (Vec<_>, Vec<_>) =
                    self.blocked.drain(..).partition(|(line, _)| *line == first);
                self.blocked = rest;
                for (_, request) in woken {
                    self.counts.thread_cycles.memory += u64::from(now - request.cycle);
                    tries.push(request);
                }
            }
        }
    }

    fn try_to_serve(&mut self, request: Request) -> Outcome {
        let Request { cycle: now, tm: number, thread, kind, address } = request;
        if kind == Kind::Counter {
            self.tms[number].threads[thread].item = self.next_item;
            self.next_item = self.work.items().min(self.next_item + 1);
            return Outcome::Served(now + 1);
        }
        if self.l1_refuses(&request) {
            return Outcome::Refused;
        }
        if let Some(ready) = self.l1_load(&request, 0) {
            return Outcome::Served(ready);
        }
        let line = address / self.machine.l1.line_words();
        if kind == Kind::Load && self.l1_is_full(number, now) {
            return Outcome::Refused;
        }
        let partition = self.tms[number].partition;
        let l2_bank = Resource::L2(partition, bank(&self.machine.l2, address));
        if self.is_taken(l2_bank, now, self.machine.l2.ports) {
            self.counts.l2.bank_conflicts += 1;
            return Outcome::Refused;
        }
        self.dram.advance(now);
        if kind == Kind::Store {
            if !self.dram.write(now, line) {
                return Outcome::Refused;
            }
            self.counts.l2.stores += 1;
            self.tms[number].l1_counts.stores += 1;
            self.take(l2_bank, now, 1);
            self.take(Resource::L1(number, bank(&self.machine.l1, address)), now, 1);
            return Outcome::Served(now + 1);
        }
        self.events += 1;
        let latency =
            self.machine.l2.latency_cycles + self.l1_latency() + 2 * self.machine.network.latency_cycles;
        let arrival = if self.l2s[partition].hit(now, line, (self.turn, 0, self.events)) {
            self.counts.l2.hits += 1;
            now + latency
        } else {
            if self.l2_is_full(partition, line, now) {
                return Outcome::Refused;
            }
            match self.dram.read(now, line, Requester { port: number as u16 }) {
                Read::Refused => return Outcome::Full(line),
                Read::Queued => {
                    // A line that is known to arrive later keeps its time until it is announced again.
                    let known = self.asked_by_l2[partition].entry(line).or_insert(UNKNOWN);
                    if *known <= now {
                        *known = UNKNOWN;
                    }
                    UNKNOWN
                }
                Read::Arrives(cycle) => {
                    self.l2_arrives(partition, line, cycle);
                    cycle + latency
                }
            }
        };
        self.counts.l2.loads += 1;
        self.tms[number].l1_counts.loads += 1;
        self.take(l2_bank, now, 1);
        self.take(Resource::L1(number, bank(&self.machine.l1, address)), now, 1);
        self.tms[number].under_way.insert(line, UnderWay { arrival, waiters: vec![] });
        if arrival == UNKNOWN {
            self.wait_for(&request, line);
        } else {
            self.tms[number].l1.arrivals.push((arrival, line));
        }
        Outcome::Served(arrival)
    }

    /// `line` arrives at a partition's cache in cycle `cycle`.
    pub(super) fn l2_arrives(&mut self, partition: usize, line: u32, cycle: u32) {
        self.l2s[partition].arrivals.push((cycle, line));
        self.asked_by_l2[partition].insert(line, cycle);
    }

    /// Whether no line more may be on its way to a multiprocessor's cache, which it counts.
    fn l1_is_full(&mut self, tm: usize, now: u32) -> bool {
        let under_way = self.tms[tm].under_way.values().filter(|line| line.arrival > now).count();
        let registers = self.machine.l1.miss_registers as usize;
        let is_full = registers > 0 && under_way >= registers;
        self.tms[tm].l1_counts.register_conflicts += u64::from(is_full);
        is_full
    }

    /// Whether `line` may not be on its way to a partition's cache as well, which it counts.
    fn l2_is_full(&mut self, partition: usize, line: u32, now: u32) -> bool {
        let under_way = self.asked_by_l2[partition].iter().filter(|(_, arrival)| **arrival > now);
        let registers = self.machine.l2.miss_registers as usize;
        let is_full = registers > 0
            && under_way.clone().count() >= registers
            && !under_way.clone().any(|(asked, _)| *asked == line);
        self.counts.l2.register_conflicts += u64::from(is_full);
        is_full
    }
}
