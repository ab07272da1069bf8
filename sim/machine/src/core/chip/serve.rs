//! What the chip does for its multiprocessors: the counter, second-level caches and memory.

use super::Chip;
use crate::core::dram::{Read, Requester};
use crate::core::outstanding::UNKNOWN;
use crate::core::request::Request;
use crate::program::Kind;

/// What becomes of a request.
enum Outcome {
    /// What it asked for can be used from this cycle on.
    Served(u32),
    /// A cache bank is taken, or the queue for writes full: it tries again in the next cycle.
    Refused,
    /// The queue of the memory channel of this line is full: it tries again when there is room.
    Full(u32),
}

impl Chip<'_> {
    /// Serves what multiprocessors have asked, cycle by cycle of the quantum that begins at `start`; if `wakes`, also reads for
    /// whose channel there is room again.
    pub(super) fn serve(&mut self, start: u32, wakes: bool) {
        // In each cycle, multiprocessors have their turn in ring order, from another one each quantum.
        let count = self.seats.len();
        let first = (start / self.length) as usize % count;
        for now in start..start + self.length {
            if wakes {
                self.wake(now, first);
            }
            for number in (first..count).chain(0..first) {
                self.serve_tm(number, now, (now - start) as usize);
            }
        }
        for seat in &mut self.seats {
            seat.tm.shared.asked.clear();
            seat.tm.give_up();
        }
    }

    /// Lets the reads wait for their turn in cycle `now` for which their channel has room; multiprocessor `first` comes first.
    fn wake(&mut self, now: u32, first: usize) {
        self.dram.advance(now);
        let count = self.seats.len();
        let seats = &mut self.seats;
        let place = |request: &Request| (usize::from(request.tm) + count - first) % count;
        self.blocked.wake(&self.dram, place, |request| {
            let tm = &mut seats[usize::from(request.tm)].tm;
            tm.shared.cycles.memory += u64::from(now - request.cycle);
            tm.waiting.push(request);
        });
    }

    /// Serves a multiprocessor in cycle `now`, which is `slot` of the quantum: what it asks in this cycle, then what waits.
    fn serve_tm(&mut self, number: usize, now: u32, slot: usize) {
        let tm = &mut self.seats[number].tm;
        if tm.shared.asked.is_empty() && tm.waiting.is_empty() {
            return;
        }
        let mut tries = std::mem::take(&mut self.tries);
        tries.extend(tm.shared.asked.iter().filter(|request| request.cycle == now));
        tries.append(&mut tm.waiting);
        for request in tries.drain(..) {
            let request = Request { cycle: now, ..request };
            let outcome = self.serve_one(request, slot);
            let tm = &mut self.seats[number].tm;
            match outcome {
                Outcome::Served(ready) => tm.served(self.program, request, ready),
                Outcome::Refused => {
                    tm.shared.cycles.memory += 1;
                    tm.waiting.push(request);
                }
                Outcome::Full(line) => self.blocked.add(self.dram.channel(line), line, request),
            }
        }
        self.tries = tries;
    }

    /// Serves a request in its cycle, which is `slot` of the quantum, if it can.
    fn serve_one(&mut self, request: Request, slot: usize) -> Outcome {
        let (number, now) = (usize::from(request.tm), request.cycle);
        if request.kind == Kind::Counter {
            self.seats[number].items[usize::from(request.thread)] = self.take_item(request);
            return Outcome::Served(now + 1);
        }
        let seat = &mut self.seats[number];
        let (l1, l2) = (&mut seat.tm.shared.l1, &mut self.l2s[seat.partition]);

        // Earlier requests may have taken the L1's bank, or asked for the same line.
        if l1.refuses(slot, request.address) {
            return Outcome::Refused;
        }
        if request.kind == Kind::Load
            && let Some(ready) = l1.find(now, slot, request.address)
        {
            return Outcome::Served(ready);
        }

        if l2.refuses(slot, request.address) {
            return Outcome::Refused;
        }
        let line = request.address >> self.line_shift;
        self.dram.advance(now);
        if request.kind == Kind::Store {
            if !self.dram.write(now, line) {
                return Outcome::Refused;
            }
            l2.take(slot, request.address);
            l2.counts.stores += 1;
            l1.stored(slot, request.address);
            return Outcome::Served(now + 1);
        }
        let hit = l2.hit(now, line);
        let from_l2 = self.machine.l2.latency_cycles + l1.latency_cycles;
        let arrival = if hit {
            now + from_l2
        } else {
            match self.dram.read(now, line, Requester { tm: number as u16 }) {
                Read::Refused => return Outcome::Full(line),
                Read::Queued => UNKNOWN,
                Read::Arrives(cycle) => {
                    l2.arrives(line, cycle);
                    cycle + from_l2
                }
            }
        };
        l2.take(slot, request.address);
        l2.counts.loads += 1;
        l2.counts.hits += u64::from(hit);
        l1.taken(now, slot, request.address, arrival);
        Outcome::Served(arrival)
    }
}
