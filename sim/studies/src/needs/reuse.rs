//! The misses of caches of all sizes, from the reuse distances of one stream of addresses.
//!
//! A fully associative cache of `n` lines with LRU replacement hits an access exactly if fewer than `n` other lines were used
//! since the last use of the same line (Mattson, Gecsei, Slutz, Traiger, "Evaluation
//! techniques for storage hierarchies", IBM Systems Journal 9(2), 1970). Distances are counted in a Fenwick tree over time.

use golden::traverse::{Node, Observer};
use golden::triangle::Triangle;

/// Bytes of a line, as in the published machine.
pub const LINE_BYTES: u64 = 64;

/// Collects the lines that a traversal reads. Nodes begin at address 0, and triangles follow them.
#[derive(Clone, Debug, Default)]
pub struct LineStream {
    /// Numbers of the lines, in the order of access.
    pub lines: Vec<u32>,
    triangles_at: u64,
}

impl LineStream {
    /// An empty stream for a structure with `node_bytes` bytes of nodes.
    #[must_use]
    pub fn new(node_bytes: usize) -> Self {
        Self { lines: vec![], triangles_at: (node_bytes as u64).next_multiple_of(LINE_BYTES) }
    }

    fn read(&mut self, address: u64, bytes: u64) {
        let lines = address / LINE_BYTES..=(address + bytes - 1) / LINE_BYTES;
        self.lines.extend(lines.map(|line| u32::try_from(line).expect("structures are below 256 GiB")));
    }
}

impl Observer for LineStream {
    fn node(&mut self, node: &Node) {
        self.read(node.address, node.bytes.into());
    }

    fn triangle(&mut self, slot: u32, _t: Option<f32>) {
        let bytes = u64::from(Triangle::WORDS) * 4;
        self.read(self.triangles_at + u64::from(slot) * bytes, bytes);
    }
}

/// The number of accesses with each reuse distance.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ReuseDistances {
    /// Accesses by the number of other lines used since the line's last use.
    counts: Vec<u64>,
    /// Number of accesses to a line that was not used before.
    pub first_uses: u64,
    /// Number of all accesses.
    pub accesses: u64,
}

impl ReuseDistances {
    /// The distances of a stream of line numbers.
    #[must_use]
    pub fn of(lines: &[u32]) -> Self {
        let distinct = lines.iter().max().map_or(0, |last| *last as usize + 1);
        // Time of each line's last use, counted from 1; 0 before the first use.
        let mut last_use = vec![0usize; distinct];
        let mut uses = Fenwick::new(lines.len());
        let mut distances = Self { accesses: lines.len() as u64, ..Self::default() };
        for (now, &line) in (1..).zip(lines) {
            let last = std::mem::replace(&mut last_use[line as usize], now);
            if last == 0 {
                distances.first_uses += 1;
            } else {
                let distance = (uses.sum(now - 1) - uses.sum(last)) as usize;
                if distances.counts.len() <= distance {
                    distances.counts.resize(distance + 1, 0);
                }
                distances.counts[distance] += 1;
                uses.add(last, -1);
            }
            uses.add(now, 1);
        }
        distances
    }

    /// Misses of a cache of `lines` lines.
    #[must_use]
    pub fn misses(&self, lines: u64) -> u64 {
        let kept = usize::try_from(lines).unwrap_or(usize::MAX).min(self.counts.len());
        self.first_uses + self.counts[kept..].iter().sum::<u64>()
    }

    /// The fraction of accesses that miss a cache of `bytes` bytes.
    #[must_use]
    pub fn miss_ratio(&self, bytes: u64) -> f64 {
        self.misses(bytes / LINE_BYTES) as f64 / self.accesses.max(1) as f64
    }
}

/// Prefix sums of small integers (Fenwick, "A new data structure for cumulative frequency tables", 1994).
struct Fenwick(Vec<i32>);

impl Fenwick {
    fn new(len: usize) -> Self {
        Self(vec![0; len + 1])
    }

    fn add(&mut self, at: usize, value: i32) {
        let mut i = at;
        while i < self.0.len() {
            self.0[i] += value;
            i += i & i.wrapping_neg();
        }
    }

    /// The sum of positions 1 to `to`.
    fn sum(&self, to: usize) -> i32 {
        let (mut i, mut sum) = (to, 0);
        while i > 0 {
            sum += self.0[i];
            i &= i - 1;
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::VecDeque;

    /// Misses of a cache that is simulated access by access.
    fn simulated_misses(lines: &[u32], capacity: usize) -> u64 {
        let mut cache = VecDeque::new();
        let mut misses = 0;
        for line in lines {
            match cache.iter().position(|kept| kept == line) {
                Some(at) => drop(cache.remove(at)),
                None => misses += 1,
            }
            cache.push_front(*line);
            cache.truncate(capacity);
        }
        misses
    }

    #[test]
    fn misses_are_those_of_simulated_caches() {
        let mut random = stress::shapes::Random::new(4);
        let lines: Vec<u32> =
            (0..3000).map(|i| (random.below(60) * random.below(4) + i / 500) as u32).collect();
        let distances = ReuseDistances::of(&lines);
        for capacity in [1, 2, 3, 7, 16, 50, 100, 1000] {
            assert_eq!(distances.misses(capacity as u64), simulated_misses(&lines, capacity), "{capacity}");
        }
        assert_eq!(distances.misses(0), 3000);
        assert_eq!(ReuseDistances::of(&[]).miss_ratio(64), 0.0);
    }

    #[test]
    fn records_that_straddle_lines_touch_both() {
        let mut stream = LineStream::new(100);
        stream.read(60, 12);
        stream.read(0, 4);
        stream.triangle(1, None);
        assert_eq!(stream.lines, [0, 1, 0, 2, 3]);
    }
}
