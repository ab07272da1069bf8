//! What the chip does for its multiprocessors: the counter, second-level caches and memory.

use super::Chip;
use crate::machine::core::dram::{Read, Requester};
use crate::machine::core::l1::Access;
use crate::machine::core::outstanding::UNKNOWN;
use crate::machine::core::tm::Request;
use crate::machine::core::work::Work;
use crate::machine::program::Kind;

/// What becomes of a request.
enum Outcome {
    Served,
    /// A cache bank is taken, or the queue for writes full; it tries again in the next cycle.
    Refused,
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
            seat.tm
                .outbox
                .drain(..)
                .for_each(|request| requests[(request.cycle - start) as usize].push(request));
        }
        let wakes = wakes && !self.blocked.is_empty();
        // What was refused in the slot before.
        let mut refused = std::mem::take(&mut self.refused);
        for (slot, now) in requests[..self.length as usize].iter_mut().enumerate() {
            if now.is_empty() && refused.is_empty() && !wakes {
                continue;
            }
            merge(now, &refused, place);
            refused.clear();
            if wakes {
                let cycle = start + slot as u32;
                self.dram.advance(cycle);
                let seats = &mut self.seats;
                self.blocked.wake(&self.dram, place, |mut request| {
                    seats[usize::from(request.tm)].tm.cycles.memory += u64::from(cycle - request.cycle);
                    request.cycle = cycle;
                    now.push(request);
                });
                now.sort_by_key(place);
            }
            for mut request in now.drain(..) {
                match self.serve_one(&mut request, slot) {
                    Outcome::Served => continue,
                    Outcome::Full(line) => {
                        self.blocked.add(self.dram.channel(line), line, request);
                        continue;
                    }
                    Outcome::Refused => {}
                }
                let tm = &mut self.seats[usize::from(request.tm)].tm;
                // Nothing else can happen to its thread before it tries again.
                if slot + 1 < self.length as usize {
                    tm.cycles.memory += 1;
                    request.cycle += 1;
                    refused.push(request);
                } else {
                    tm.refused(request);
                }
            }
        }
        (self.requests, self.refused) = (requests, refused);
    }

    /// Serves a request of this slot, if it can.
    fn serve_one(&mut self, request: &mut Request, slot: usize) -> Outcome {
        let (number, program, now) = (usize::from(request.tm), self.program, request.cycle);
        if request.kind == Kind::Counter {
            let item = self.take_item(*request);
            let seat = &mut self.seats[number];
            seat.items[usize::from(request.thread)] = item;
            seat.tm.served(program, *request, now + 1);
            return Outcome::Served;
        }
        let seat = &mut self.seats[number];
        let tm = &mut seat.tm;
        let l2 = &mut self.l2s[seat.partition];
        if tm.l1.refuses(slot, request.address) {
            return Outcome::Refused;
        }
        // A line that the L1 did not have is there or under way only after the L1 has asked for another.
        if request.kind == Kind::Load
            && request.missed != tm.l1.lines_asked
            && let Access::Served(ready) = tm.load_now(program, *request, slot)
        {
            tm.served(program, *request, ready);
            return Outcome::Served;
        }
        request.missed = tm.l1.lines_asked;
        if !l2.is_free(slot, request.address) {
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
            tm.l1.stored(slot, request.address);
            tm.served(program, *request, now + 1);
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
        tm.taken(program, *request, slot, arrival);
        tm.served(program, *request, arrival);
        Outcome::Served
    }
}

/// Merges `later` into `requests`, both in order of place, behind those of the same place.
fn merge(requests: &mut Vec<Request>, later: &[Request], place: impl Fn(&Request) -> u32) {
    let (mut these, mut those) = (requests.len(), later.len());
    requests.extend_from_slice(later);
    if these == 0 {
        return;
    }
    while those > 0 {
        let last = later[those - 1];
        if these > 0 && place(&requests[these - 1]) > place(&last) {
            these -= 1;
            requests[these + those] = requests[these];
        } else {
            those -= 1;
            requests[these + those] = last;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn requests_of_one_place_stay_in_order_when_they_are_merged() {
        let request = |&(tm, thread): &(u16, u8)| Request {
            cycle: 0,
            tm,
            thread,
            kind: Kind::Load,
            address: 0,
            missed: 0,
        };
        let merged = |these: &[(u16, u8)], those: &[(u16, u8)]| {
            let mut requests: Vec<Request> = these.iter().map(request).collect();
            let later: Vec<Request> = those.iter().map(request).collect();
            merge(&mut requests, &later, |request| request.tm.into());
            requests.iter().map(|request| (request.tm, request.thread)).collect::<Vec<_>>()
        };
        assert_eq!(
            merged(&[(1, 0), (3, 1)], &[(0, 2), (1, 3), (2, 4), (3, 5), (4, 6)]),
            [(0, 2), (1, 0), (1, 3), (2, 4), (3, 1), (3, 5), (4, 6)]
        );
        assert_eq!(merged(&[], &[(1, 0), (1, 1)]), [(1, 0), (1, 1)]);
        assert_eq!(merged(&[(2, 0)], &[]), [(2, 0)]);
    }
}
