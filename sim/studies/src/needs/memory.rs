//! An analytic bound: the number of multiprocessors from which on memory, not traversal, limits the frame.
//!
//! Each multiprocessor works at the peak rate of its pipelines: one node and one triangle a cycle. Each has a cache of its own.
//! Every miss moves a line from DRAM, whose peak rate all multiprocessors share. The bound neglects latency, queues, banks and
//! shared caches. With fewer multiprocessors than the bound, bandwidth cannot limit the machine; with more, it may.

/// The quantities that the bound follows from.
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

/// The least number of multiprocessors that use up the bandwidth of DRAM; `None` if a ray moves no bytes.
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
