//! A client that goes cycle by cycle.

use memory::description::{BankBy, Bytes, Cache, Description, Network};
use memory::{Access, Answer, Client, Memory, Request};

/// A cache with lines of 64 bytes, one line in a set.
pub fn cache(bytes: u64, banks: u32, latency_cycles: u32) -> Cache {
    Cache {
        enabled: true,
        size: Bytes(bytes),
        line: Bytes(64),
        banks,
        ports: 1,
        bank_by: BankBy::Word,
        associativity: 1,
        latency_cycles,
        miss_registers: 0,
        area_mm2: None,
        energy_nj: None,
    }
}

/// Words of a line.
pub const LINE_WORDS: u32 = 16;

/// One port before one partition.
pub fn description() -> Description {
    let description = Description {
        partitions: 1,
        ports_per_partition: 1,
        l1: cache(32 << 10, 8, 1),
        network: Network::default(),
        l2: cache(512 << 10, 16, 3),
        dram: toml::from_str(include_str!("gddr5.toml")).unwrap(),
    };
    description.check().unwrap();
    description
}

/// What a driver was told.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Told {
    /// When it was told.
    pub at: u32,
    pub client: Client,
    /// When the line arrives.
    pub arrival: u32,
}

/// Drives a memory through time. It waits by the number of the request for all that comes later, and serves what the memory gives
/// back.
pub struct Driver {
    pub memory: Memory,
    pub now: u32,
    pub told: Vec<Told>,
    /// Requests that the memory gave back and has answered since, with the answers.
    pub woken: Vec<(Request, Answer)>,
    /// Requests that the memory gave back and then refused.
    again: Vec<Request>,
}

impl Driver {
    /// In cycle 0.
    pub fn new(description: &Description) -> Self {
        description.check().unwrap();
        let mut memory = Memory::new(description);
        memory.begin(0, |_, _| ());
        Self { memory, now: 0, told: vec![], woken: vec![], again: vec![] }
    }

    /// Goes on to the next cycle.
    pub fn step(&mut self) {
        self.now += 1;
        let (now, told) = (self.now, &mut self.told);
        if now % self.memory.quantum() == 0 {
            self.memory.begin(now, |client, arrival| told.push(Told { at: now, client, arrival }));
        }
        let mut woken = std::mem::take(&mut self.again);
        self.memory.wake(now, |_| 0, |request| woken.push(request));
        for request in woken {
            match self.serve(Request { cycle: now, ..request }) {
                Answer::Refused => self.again.push(request),
                Answer::Kept => {}
                answer => self.woken.push((request, answer)),
            }
        }
    }

    /// Goes on to cycle `cycle`.
    pub fn go_to(&mut self, cycle: u32) {
        while self.now < cycle {
            self.step();
        }
    }

    /// A client asks in the current cycle.
    pub fn ask(&mut self, client: Client, access: Access, address: u32) -> Answer {
        self.serve(Request { cycle: self.now, client, access, address })
    }

    fn serve(&mut self, request: Request) -> Answer {
        let answer = self.memory.ask(request);
        if answer == Answer::Later {
            self.memory.port(request.client.port).wait(request.address, request.client.number);
        }
        answer
    }

    /// Port 0 loads `address` in the current cycle, and the driver goes on until the word can be used: after so many cycles.
    pub fn load(&mut self, address: u32) -> u32 {
        let asked = self.now;
        let ready = match self.ask(Client { port: 0, number: 0 }, Access::Load, address) {
            Answer::At(cycle) => cycle,
            Answer::Later => {
                self.told.clear();
                while self.told.is_empty() {
                    assert!(self.now < asked + 10_000, "the line of {address} never comes");
                    self.step();
                }
                self.told[0].arrival
            }
            answer => panic!("nobody else asks: {answer:?}"),
        };
        self.go_to(ready);
        ready - asked
    }

    /// Goes on to the first cycle of a quantum after the current one.
    pub fn next_quantum(&mut self) {
        self.go_to((self.now / self.memory.quantum() + 1) * self.memory.quantum());
    }
}
