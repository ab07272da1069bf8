//! A frame cut into batches of consecutive pixels, and the choice of those that are timed.

use base::split_mix;
use machine::core::Plan;
use std::ops::Range;

/// A frame in batches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Batches {
    /// Pixels of the frame.
    pub items: u32,
    /// Pixels of a batch. The last batch may have up to twice as many, less one.
    pub size: u32,
    /// Number of batches.
    pub count: u32,
    /// Number of batches in the frame's end, which is measured as a whole.
    pub ends: u32,
}

/// The batches drawn from each stratum.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Draw {
    /// For each stratum, the number of its batches, and the indices of those drawn, in order.
    pub strata: Vec<(u32, Vec<u32>)>,
}

impl Draw {
    /// The indices of all batches drawn, in order.
    pub fn indices(&self) -> impl Iterator<Item = u32> + '_ {
        self.strata.iter().flat_map(|(_, drawn)| drawn.iter().copied())
    }
}

impl Batches {
    /// A frame of `items` pixels in batches of `size`.
    #[must_use]
    pub fn new(items: u32, size: u32) -> Self {
        let size = size.max(1);
        Self { items, size, count: (items / size).max(1), ends: 1 }
    }

    /// The pixels of batch `index`.
    #[must_use]
    pub fn items_of(&self, index: u32) -> Range<u32> {
        let end = if index + 1 == self.count { self.items } else { (index + 1) * self.size };
        index * self.size..end
    }

    /// Number of batches that may be drawn: all but the first and those of the end.
    #[must_use]
    pub fn drawable(&self) -> u32 {
        self.count.saturating_sub(1 + self.ends)
    }

    /// The same batches with an end of `ends` batches, or of all but the first if there are fewer.
    #[must_use]
    pub fn with_end(self, ends: u32) -> Self {
        Self { ends: ends.clamp(1, self.count.max(2) - 1), ..self }
    }

    /// Draws two batches from each of `pairs` strata, or draws all batches if these would be no fewer.
    #[must_use]
    pub fn draw(&self, pairs: u32, seed: u64) -> Draw {
        let drawable = self.drawable();
        let pairs = pairs.clamp(1, (drawable / 2).max(1));
        let bounds = |stratum: u32| 1 + (u64::from(drawable) * u64::from(stratum) / u64::from(pairs)) as u32;
        let mut state = split_mix::hash(seed) ^ u64::from(pairs);
        let mut below = |n: u32| (split_mix::next(&mut state) % u64::from(n)) as u32;
        let stratum = |stratum: u32| {
            let (first, end) = (bounds(stratum), bounds(stratum + 1));
            let count = end - first;
            if count <= 2 {
                return (count, (first..end).collect());
            }
            let a = below(count);
            let b = below(count - 1);
            let b = if b >= a { b + 1 } else { b };
            (count, vec![first + a.min(b), first + a.max(b)])
        };
        Draw { strata: (0..pairs).map(stratum).filter(|(count, _)| *count > 0).collect() }
    }

    /// The plan that times the first batch, the end and the batches of `draw`, each after `lead` pixels that are timed too. The
    /// plan has two marks for each measured batch, at its first pixel and after its last.
    #[must_use]
    pub fn plan(&self, draw: &Draw, lead: u32, warming: u32) -> Plan {
        let mut marks = vec![];
        let mut skipped: Vec<Range<u32>> = vec![];
        let mut timed_to = self.items_of(0).end;
        let end = self.items_of(self.count.saturating_sub(self.ends)).start..self.items;
        let measured = std::iter::once(0).chain(draw.indices()).map(|index| self.items_of(index));
        for Range { start, end } in measured.chain([end]) {
            let from = start.saturating_sub(lead).max(timed_to.min(start));
            if from > timed_to {
                skipped.push(timed_to..from);
            }
            timed_to = timed_to.max(end);
            marks.extend([start, end]);
        }
        Plan { skipped, warming, marks }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_batches_of_each_stratum_are_drawn() {
        let batches = Batches::new(1030, 10);
        assert_eq!(batches.count, 103);
        assert_eq!(batches.items_of(102), 1020..1030);
        for seed in 0..20 {
            let draw = batches.draw(7, seed);
            assert_eq!(draw.strata.iter().map(|(count, _)| count).sum::<u32>(), 101);
            let drawn: Vec<u32> = draw.strata.iter().flat_map(|(_, drawn)| drawn.clone()).collect();
            assert_eq!(drawn.len(), 14);
            assert!(drawn.windows(2).all(|pair| pair[0] < pair[1]) && drawn[0] >= 1 && drawn[13] <= 101);
        }
        assert_ne!(batches.draw(7, 0), batches.draw(7, 1));
        // Over many seeds, every batch is drawn.
        let mut seen = [false; 103];
        for seed in 0..400 {
            let draw = batches.draw(7, seed);
            draw.strata.iter().flat_map(|(_, drawn)| drawn).for_each(|&index| seen[index as usize] = true);
        }
        assert_eq!(seen.iter().filter(|seen| **seen).count(), 101);
    }

    #[test]
    fn a_plan_times_what_is_drawn_and_its_lead() {
        let batches = Batches::new(100, 10);
        let draw = Draw { strata: vec![(8, vec![3, 6])] };
        let plan = batches.plan(&draw, 5, 7);
        assert_eq!(plan.skipped, [10..25, 40..55, 70..85]);
        assert_eq!(plan.marks, [0, 10, 30, 40, 60, 70, 90, 100]);
        // Where a lead reaches into timed pixels, no pixel is left out.
        let early = Draw { strata: vec![(8, vec![1, 2])] };
        assert_eq!(batches.plan(&early, 25, 7).skipped, vec![Range { start: 30, end: 65 }]);
        let plan = batches.with_end(3).plan(&draw, 5, 7);
        assert_eq!(plan.skipped, [10..25, 40..55], "the end begins where a measured batch ends");
        assert_eq!(plan.marks, [0, 10, 30, 40, 60, 70, 70, 100]);
        assert_eq!(batches.with_end(3).drawable(), 6);
        let all = batches.draw(4, 0);
        assert_eq!(all.strata.iter().map(|(_, drawn)| drawn.len()).sum::<usize>(), 8);
        assert_eq!(batches.plan(&all, 5, 7).skipped, []);
        for small in [Batches::new(3, 10), Batches::new(20, 10), Batches::new(25, 10)] {
            assert_eq!(small.plan(&small.draw(3, 0), 5, 7).skipped, []);
        }
    }
}
