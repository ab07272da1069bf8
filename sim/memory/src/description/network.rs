//! The network between the ports and the second-level cache of their partition.

use super::check::{MAX_LATENCY, OutOfRange, within};
use serde::{Deserialize, Serialize};

/// What a partition's requests and lines pass through. Where the section is missing, it takes no time.
///
/// A port and its second-level cache count cycles by clocks of their own, of which the second one is late by the latency: a request
/// has the same number at both ends, and its line has twice the latency more. So a port knows in the same cycle that a request was
/// refused, as if the request waited at the other end.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Network {
    /// Cycles that a request takes from a port to the second-level cache, and as many that a line takes back.
    pub latency_cycles: u32,
}

impl Network {
    pub(super) fn check(&self) -> Result<(), OutOfRange> {
        within("network.latency_cycles", self.latency_cycles, 0, MAX_LATENCY)
    }
}
