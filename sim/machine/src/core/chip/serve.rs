//! What the chip does for its multiprocessors: the counter, second-level caches and memory.

use super::Chip;
use crate::core::dram::{Read, Requester};
use crate::core::l1::Access;
use crate::core::outstanding::UNKNOWN;
use crate::core::tm::Request;
use crate::core::work::Work;
use crate::program::Kind;

/// What becomes of a request.
enum Outcome {
    Served,
    /// A cache bank is taken, or the queue for writes full; it tries again in the next cycle. Its L1 has asked for so many lines
    /// by now.
    Refused(u32),
    /// The queue of the memory channel of this line is full.
    Full(u32),
}

impl<W: Work> Chip<'_, W> {
    /// Serves what multiprocessors ask in the order of time; if `wakes`, also reads for whose channel there is room again.
    pub(super) fn serve(&mut self, start: u32, wakes: bool) {
        let mut requests = std::mem::take(&mut self.requests);
        // In one cycle, multiprocessors come in ring order from another one each time.
        let (count, first) = (self.seats.len() as u32, start / self.length % self.seats.len() as u32);
        let place = |request: &Request| {
            let tm = u32::from(request.tm);
            if tm < first { tm + count - first } else { tm - first }
        };
        let (before, from) = self.seats.split_at_mut(first as usize);
        for seat in from.iter_mut().chain(before) {
            for request in &seat.tm.outbox {
                requests[(request.cycle - start) as usize].push(*request);
            }
            seat.tm.outbox.clear();
        }
        let wakes = wakes && !self.blocked.is_empty();
        let mut waiting = std::mem::take(&mut self.waiting);
        for (slot, new) in requests[..self.length as usize].iter_mut().enumerate() {
            if new.is_empty() && waiting.is_empty() && !wakes {
                continue;
            }
            let now = start + slot as u32;
            put_before(&mut waiting, new, place);
            new.clear();
            if wakes {
                self.dram.advance(now);
                let seats = &mut self.seats;
                self.blocked.wake(&self.dram, place, |request| {
                    seats[usize::from(request.tm)].tm.cycles.memory += u64::from(now - request.cycle);
                    waiting.push(request);
                });
                waiting.sort_by_key(place);
            }
            let mut kept = 0;
            for at in 0..waiting.len() {
                let mut request = Request { cycle: now, ..waiting[at] };
                if !self.refuses(&request, slot) {
                    match self.serve_one(request, slot) {
                        Outcome::Served => continue,
                        Outcome::Refused(lines_asked) => request.missed = lines_asked,
                        Outcome::Full(line) => {
                            self.blocked.add(self.dram.channel(line), line, request);
                            continue;
                        }
                    }
                }
                self.seats[usize::from(request.tm)].tm.cycles.memory += 1;
                waiting[kept] = request;
                kept += 1;
            }
            waiting.truncate(kept);
        }
        // Nothing else could happen to their threads before.
        for request in waiting.drain(..) {
            self.seats[usize::from(request.tm)].tm.refused(request);
        }
        (self.requests, self.waiting) = (requests, waiting);
    }

    /// Whether a cache bank that `request` needs in this slot is taken: what becomes of most of them while many wait.
    #[inline(always)]
    fn refuses(&mut self, request: &Request, slot: usize) -> bool {
        if request.kind == Kind::Counter {
            return false;
        }
        let seat = &mut self.seats[usize::from(request.tm)];
        let (l1, l2) = (&mut seat.tm.l1, &mut self.l2s[seat.partition]);
        // A line that the L1 did not have is there or under way only after the L1 has asked for another.
        l1.refuses(slot, request.address)
            || request.missed == l1.lines_asked && l2.refuses(slot, request.address)
    }

    /// Serves a request of this slot that its banks do not refuse, if it can. Apart from the loop over those that they refuse,
    /// which are far more.
    #[inline(never)]
    fn serve_one(&mut self, request: Request, slot: usize) -> Outcome {
        let (number, program, now) = (usize::from(request.tm), self.program, request.cycle);
        if request.kind == Kind::Counter {
            let item = self.take_item(request);
            let seat = &mut self.seats[number];
            seat.items[usize::from(request.thread)] = item;
            seat.tm.served(program, request, now + 1);
            return Outcome::Served;
        }
        let seat = &mut self.seats[number];
        let tm = &mut seat.tm;
        let l2 = &mut self.l2s[seat.partition];
        if request.missed != tm.l1.lines_asked {
            if request.kind == Kind::Load
                && let Access::Served(ready) = tm.load_now(program, request, slot)
            {
                tm.served(program, request, ready);
                return Outcome::Served;
            }
            if l2.refuses(slot, request.address) {
                return Outcome::Refused(tm.l1.lines_asked);
            }
        }
        let line = request.address >> self.line_shift;
        self.dram.advance(now);
        if request.kind == Kind::Store {
            if !self.dram.write(now, line) {
                return Outcome::Refused(tm.l1.lines_asked);
            }
            l2.take(slot, request.address);
            l2.counts.stores += 1;
            tm.l1.stored(slot, request.address);
            tm.served(program, request, now + 1);
            return Outcome::Served;
        }
        let hit = l2.hit(now, line);
        let from_l2 = self.machine.l2.latency_cycles + tm.l1.latency_cycles;
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
        tm.taken(program, request, slot, arrival);
        tm.served(program, request, arrival);
        Outcome::Served
    }
}

/// Puts `new` among `waiting`, both in order of place, before those of the same place.
fn put_before(waiting: &mut Vec<Request>, new: &[Request], place: impl Fn(&Request) -> u32) {
    let (mut old, mut rest) = (waiting.len(), new.len());
    waiting.extend_from_slice(new);
    if old == 0 {
        return;
    }
    while rest > 0 {
        let last = new[rest - 1];
        if old > 0 && place(&waiting[old - 1]) >= place(&last) {
            old -= 1;
            waiting[old + rest] = waiting[old];
        } else {
            rest -= 1;
            waiting[old + rest] = last;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_one_place_the_newest_request_comes_first() {
        let request = |&(tm, thread): &(u16, u8)| Request {
            cycle: 0,
            tm,
            thread,
            kind: Kind::Load,
            address: 0,
            missed: 0,
        };
        let put = |new: &[(u16, u8)], waiting: &[(u16, u8)]| {
            let new: Vec<Request> = new.iter().map(request).collect();
            let mut waiting: Vec<Request> = waiting.iter().map(request).collect();
            put_before(&mut waiting, &new, |request| request.tm.into());
            waiting.iter().map(|request| (request.tm, request.thread)).collect::<Vec<_>>()
        };
        assert_eq!(
            put(&[(1, 0), (3, 1)], &[(0, 2), (1, 3), (2, 4), (3, 5), (4, 6)]),
            [(0, 2), (1, 0), (1, 3), (2, 4), (3, 1), (3, 5), (4, 6)]
        );
        assert_eq!(put(&[], &[(1, 0), (1, 1)]), [(1, 0), (1, 1)]);
        assert_eq!(put(&[(2, 0)], &[]), [(2, 0)]);
    }
}
