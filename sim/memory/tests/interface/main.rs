//! The memory as clients see it: latency, bandwidth, and theorems that hold for every queue and cache.

mod asked;
mod bandwidth;
mod driver;
mod latency;
mod queue;
mod registers;
mod stack;
