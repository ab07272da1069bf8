//! What the chip does with the requests of threads: the counter answers them, or the memory.

use super::Chip;
use crate::core::request::{Request, What};
use crate::core::thread::UNKNOWN;
use memory::{Answer, Client};

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
                self.serve_tm(number, now);
            }
        }
        for seat in &mut self.seats {
            seat.tm.shared.asked.clear();
            seat.tm.give_up();
        }
    }

    /// Lets the reads have their turn in cycle `now` for which their channel has room; multiprocessor `first` comes first.
    fn wake(&mut self, now: u32, first: usize) {
        let count = self.seats.len();
        let place = |port: u16| (usize::from(port) + count - first) % count;
        let seats = &mut self.seats;
        self.memory.wake(now, place, |request| {
            let request = Request::given_back(request);
            let tm = &mut seats[usize::from(request.tm)].tm;
            tm.shared.cycles.memory += u64::from(now - request.cycle);
            tm.waiting.push(request);
        });
    }

    /// Serves a multiprocessor in cycle `now`: what it asks in this cycle, then what waits.
    fn serve_tm(&mut self, number: usize, now: u32) {
        let tm = &mut self.seats[number].tm;
        if tm.shared.asked.is_empty() && tm.waiting.is_empty() {
            return;
        }
        let mut tries = std::mem::take(&mut self.tries);
        tries.extend(tm.shared.asked.iter().filter(|request| request.cycle == now));
        tries.append(&mut tm.waiting);
        for request in tries.drain(..) {
            let request = Request { cycle: now, ..request };
            let ready = match self.answer(request) {
                Answer::At(ready) => ready,
                Answer::Later => UNKNOWN,
                Answer::Refused => {
                    let tm = &mut self.seats[number].tm;
                    tm.shared.cycles.memory += 1;
                    tm.waiting.push(request);
                    continue;
                }
                Answer::Kept => continue,
            };
            let port = self.memory.port(request.tm);
            self.seats[number].tm.served(self.program, port, request, ready);
        }
        self.tries = tries;
    }

    /// What the counter or the memory answers to a request in its cycle.
    fn answer(&mut self, request: Request) -> Answer {
        let Request { cycle, tm, thread, what } = request;
        match what {
            What::Item => {
                let item = self.take_item(request);
                self.seats[usize::from(tm)].items[usize::from(thread)] = item;
                Answer::At(cycle + 1)
            }
            What::Words(access, address) => {
                let client = Client { port: tm, number: thread.into() };
                self.memory.serve(memory::Request { cycle, client, access, address })
            }
        }
    }
}
