//! The memory of a many-core machine: caches, queues and DRAM, timed by cycles.
//!
//! Clients ask through ports. A [`Port`] is a first-level cache with the lines on their way to it; the ports of a partition share a
//! second-level cache, and all partitions share the [`dram`]. A [`Request`] says who asks, when, for what. The memory does
//! not know what a client is: it answers with a cycle, and where that is not known yet, it announces it later under the number that
//! the client chose. No data are stored, only their times.
//!
//! | answer | what it means |
//! |---|---|
//! | [`Answer::At`] | the words can be used from this cycle on; of a store, the client goes on then |
//! | [`Answer::Later`] | the line is on its way, and [`Memory::begin`] announces its cycle to whoever waits ([`Port::wait`]) |
//! | [`Answer::Refused`] | a bank or all miss registers are taken, or the queue for writes is full: ask again in the next cycle |
//! | [`Answer::Kept`] | the queue for reads is full: [`Memory::wake`] gives the request back when there is room |
//!
//! # Time
//! Time advances in quanta of [`Memory::quantum`] cycles, which no read of the DRAM undercuts: nothing arrives in the quantum in
//! which it was asked for. [`Memory::begin`] begins a quantum. Within it, a client may ask its port ([`Port::ask`]) for all its
//! cycles at once, before another client has its turn; what the port cannot answer goes to [`Memory::serve`], in the order of
//! cycles. A client that goes cycle by cycle has both in one, [`Memory::ask`].
//!
//! # Size
//! A request takes one bank once and brings words of one line, from its address on. [`Port::within_line`] says how many of the
//! words that a client wants one request brings; it asks for the others anew.
//!
//! ```
//! use memory::description::{BankBy, Bytes, Cache, Description, Network};
//! use memory::{Access, Answer, Client, Memory, Request};
//!
//! # fn dram() -> memory::description::Dram { toml::from_str(include_str!("../tests/interface/gddr5.toml")).unwrap() }
//! let cache = |kib: u64, latency_cycles| Cache {
//!     enabled: true,
//!     size: Bytes(kib << 10),
//!     line: Bytes(64),
//!     banks: 8,
//!     ports: 1,
//!     bank_by: BankBy::Word,
//!     associativity: 1,
//!     latency_cycles,
//!     miss_registers: 0,
//!     area_mm2: None,
//!     energy_nj: None,
//! };
//! let (l1, network, l2) = (cache(32, 1), Network::default(), cache(512, 3));
//! let description = Description { partitions: 1, ports_per_partition: 1, l1, network, l2, dram: dram() };
//! let mut memory = Memory::new(&description);
//! let load = |cycle| Request { cycle, client: Client { port: 0, number: 7 }, access: Access::Load, address: 64 };
//!
//! memory.begin(0, |_, _| ());
//! assert_eq!(memory.ask(load(0)), Answer::Later);
//! memory.port(0).wait(64, 7);
//! let (mut start, mut arrival) = (0, None);
//! while arrival.is_none() {
//!     start += memory.quantum();
//!     memory.begin(start, |client, cycle| arrival = Some((client.number, cycle)));
//! }
//! // A row is opened and a column read, in 60 DRAM clocks of half a cycle.
//! assert_eq!(arrival, Some((7, 30)));
//! memory.begin(32, |_, _| ());
//! assert_eq!(memory.ask(load(32)), Answer::At(33));
//! ```

mod banks;
mod blocked;
pub mod description;
pub mod dram;
mod hierarchy;
mod l2;
mod lines;
mod outstanding;
mod port;
mod quantum;
mod request;
mod stats;
mod tags;

pub use hierarchy::Memory;
pub use port::{Near, Port};
pub use quantum::{LONGEST_QUANTUM, quantum};
pub use request::{Access, Answer, Client, Request};
pub use stats::{CacheCounts, DramCounts};
