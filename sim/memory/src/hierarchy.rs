//! The memory as its clients see it.

use crate::blocked::Blocked;
use crate::description::Description;
use crate::dram::{Dram, Read, Requester};
use crate::l2::L2;
use crate::outstanding::UNKNOWN;
use crate::port::{Near, Port};
use crate::request::{Access, Answer, Client, Request};
use crate::stats::{CacheCounts, DramCounts};

/// First- and second-level caches with the DRAM behind them.
#[derive(Clone, Debug)]
pub struct Memory {
    ports: Vec<Port>,
    l2s: Vec<L2>,
    dram: Dram,
    /// Reads that found their memory channel full.
    blocked: Blocked,
    ports_per_partition: usize,
    l2_latency_cycles: u32,
    /// Cycles from a port to the second-level cache and back.
    network_cycles: u32,
    line_shift: u32,
    quantum: u32,
    /// First cycle of the current quantum.
    start: u32,
}

impl Memory {
    /// An idle memory with empty caches.
    ///
    /// # Panics
    /// If `description` would not pass [`Description::check`].
    #[must_use]
    pub fn new(description: &Description) -> Self {
        let Description { partitions, ports_per_partition, l1, network, l2, dram } = description;
        Self {
            ports: (0..partitions * ports_per_partition).map(|_| Port::new(l1)).collect(),
            l2s: (0..*partitions).map(|_| L2::new(l2)).collect(),
            dram: Dram::new(dram),
            blocked: Blocked::new(dram.channels),
            ports_per_partition: *ports_per_partition as usize,
            l2_latency_cycles: l2.latency_cycles,
            network_cycles: 2 * network.latency_cycles,
            line_shift: l1.line_words().trailing_zeros(),
            quantum: crate::quantum(dram),
            start: 0,
        }
    }

    /// Cycles of a quantum.
    #[must_use]
    pub fn quantum(&self) -> u32 {
        self.quantum
    }

    /// Port `number`.
    ///
    /// # Panics
    /// If there is none of this number.
    #[inline]
    pub fn port(&mut self, number: u16) -> &mut Port {
        &mut self.ports[usize::from(number)]
    }

    /// All ports, partition by partition.
    #[inline]
    pub fn ports(&mut self) -> &mut [Port] {
        &mut self.ports
    }

    /// Begins the quantum at cycle `start`. Calls `arrives` with everyone who waits for a line whose cycle of arrival has become
    /// known, and the cycle, which is `start` or later if no quantum was skipped in which the DRAM had a command due.
    pub fn begin(&mut self, start: u32, mut arrives: impl FnMut(Client, u32)) {
        self.start = start;
        self.dram.advance(start);
        let (ports, l2s, per_partition) = (&mut self.ports, &mut self.l2s, self.ports_per_partition);
        let network_cycles = self.network_cycles;
        self.dram.announce(start, |arrival| {
            let port = arrival.requester.port;
            l2s[usize::from(port) / per_partition].arrives(arrival.line, arrival.cycle);
            let cycle = arrival.cycle + network_cycles;
            ports[usize::from(port)].arrives(arrival.line, cycle, |number| {
                arrives(Client { port, number }, cycle);
            });
        });
        self.l2s.iter_mut().for_each(|l2| l2.begin(start));
        self.ports.iter_mut().for_each(|port| port.begin(start));
    }

    /// Serves a request from the first cache that can, for clients that ask in the order of cycles.
    pub fn ask(&mut self, request: Request) -> Answer {
        let slot = (request.cycle - self.start) as usize;
        let port = &mut self.ports[usize::from(request.client.port)];
        match port.ask(request.access, request.cycle, slot, request.address) {
            Near::At(cycle) => Answer::At(cycle),
            Near::Later => Answer::Later,
            Near::Refused => Answer::Refused,
            Near::Beyond => self.serve(request),
        }
    }

    /// Serves a request that its port has not answered, in its cycle of the current quantum. Requests come in the order of cycles.
    #[inline]
    pub fn serve(&mut self, request: Request) -> Answer {
        let Request { cycle: now, client: Client { port: number, .. }, access, address } = request;
        let slot = (now - self.start) as usize;
        let port = &mut self.ports[usize::from(number)];
        let l2 = &mut self.l2s[usize::from(number) / self.ports_per_partition];

        // Earlier requests may have taken the port's bank, or asked for the same line.
        let bank = port.bank(address);
        if port.refuses(slot, bank) {
            return Answer::Refused;
        }
        if access == Access::Load
            && let Some(ready) = port.find(now, slot, bank, address)
        {
            return Answer::of(ready);
        }

        if access == Access::Load && port.is_full(now, address) {
            return Answer::Refused;
        }
        if l2.refuses(slot, address) {
            return Answer::Refused;
        }
        let line = address >> self.line_shift;
        self.dram.advance(now);
        if access == Access::Store {
            if !self.dram.write(now, line) {
                return Answer::Refused;
            }
            l2.take(slot, address);
            l2.counts.stores += 1;
            port.stored(slot, bank);
            return Answer::At(now + 1);
        }
        let hit = l2.hit(now, line);
        let from_l2 = self.l2_latency_cycles + port.latency_cycles() + self.network_cycles;
        let arrival = if hit {
            now + from_l2
        } else {
            if l2.is_full(now, line) {
                return Answer::Refused;
            }
            match self.dram.read(now, line, Requester { port: number }) {
                Read::Refused => {
                    self.blocked.add(self.dram.channel(line), line, request);
                    return Answer::Kept;
                }
                Read::Queued => {
                    l2.asked(now, line);
                    UNKNOWN
                }
                Read::Arrives(cycle) => {
                    l2.asked(now, line);
                    l2.arrives(line, cycle);
                    cycle + from_l2
                }
            }
        };
        l2.take(slot, address);
        l2.counts.loads += 1;
        l2.counts.hits += u64::from(hit);
        port.taken(now, slot, bank, address, arrival);
        Answer::of(arrival)
    }

    /// Whether requests are kept until their memory channel has room.
    #[must_use]
    pub fn keeps(&self) -> bool {
        !self.blocked.is_empty()
    }

    /// Gives requests back whose memory channel has room in cycle `now`, to be served in this cycle: those of the ports of least
    /// `place` first, and with each those for the same line.
    pub fn wake(&mut self, now: u32, place: impl Fn(u16) -> usize, wake: impl FnMut(Request)) {
        self.dram.advance(now);
        self.blocked.wake(&self.dram, place, wake);
    }

    /// Whether the next quantum begins with an announcement or with room for a kept request, as far as it is known.
    #[must_use]
    pub fn has_news(&self) -> bool {
        self.dram.has_news() || self.blocked.could_go_on(&self.dram)
    }

    /// The first cycle in which the DRAM may have something to do. Without requests nothing happens before.
    #[must_use]
    pub fn next_command(&self) -> u32 {
        self.dram.next_command()
    }

    /// Puts the line of word `address` into the caches that port `number` loads from, in no time.
    pub fn warm(&mut self, number: u16, address: u32) {
        let line = address >> self.line_shift;
        if !self.ports[usize::from(number)].warm(line) {
            self.l2s[usize::from(number) / self.ports_per_partition].warm(line);
        }
    }

    /// What all first-level caches counted.
    #[must_use]
    pub fn l1_counts(&self) -> CacheCounts {
        CacheCounts::sum(self.ports.iter().map(|port| &port.counts))
    }

    /// What all second-level caches counted.
    #[must_use]
    pub fn l2_counts(&self) -> CacheCounts {
        CacheCounts::sum(self.l2s.iter().map(|l2| &l2.counts))
    }

    /// What the DRAM counted up to cycle `now`.
    pub fn dram_counts(&mut self, now: u32) -> DramCounts {
        self.dram.counts(now)
    }
}
