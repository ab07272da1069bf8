//! An analytic bound: from how many multiprocessors on memory, not traversal, limits the frame.
//!
//! Each multiprocessor is given all that its pipelines can do: one node and one triangle a cycle. Each has a cache of its own,
//! and every miss moves a line from DRAM, whose peak rate all share. Latency, queues, banks and shared caches are left out: a
//! machine with fewer multiprocessors than this cannot be bound by bandwidth; one with more may be.

/// What the bound is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Traffic {
    /// Cycles that one ray occupies a multiprocessor's busiest pipeline.
    pub cycles_per_ray: f64,
    /// Bytes that one ray moves from DRAM.
    pub bytes_per_ray: f64,
}

/// Peak of the published configuration: 16 channels of GDDR5, 64 bytes in 4 cycles of a 2 GHz clock each, for a core at 1 GHz
/// (simtrax, `gddr5_8ch.cfg`, which has 16).
pub const DRAM_BYTES_PER_CYCLE: f64 = 16.0 * 64.0 / 4.0 * 2.0;

/// The least number of multiprocessors that asks for all of DRAM's bandwidth; none if a ray moves nothing.
#[must_use]
pub fn multiprocessors_until_bound(traffic: &Traffic) -> Option<u32> {
    let bytes_per_cycle = traffic.bytes_per_ray / traffic.cycles_per_ray;
    let count = (DRAM_BYTES_PER_CYCLE / bytes_per_cycle).ceil();
    (bytes_per_cycle > 0.0 && count.is_finite()).then_some(count as u32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bandwidth_is_shared() {
        let traffic = Traffic { cycles_per_ray: 100.0, bytes_per_ray: 6400.0 };
        assert_eq!(multiprocessors_until_bound(&traffic), Some(8));
        assert_eq!(multiprocessors_until_bound(&Traffic { bytes_per_ray: 0.0, ..traffic }), None);
    }
}
