//! Least recent use is a stack: what a cache holds, a larger one holds (Mattson, Gecsei, Slutz, Traiger, "Evaluation techniques for
//! storage hierarchies", IBM Systems Journal 9, 1970). So the misses of all sizes follow from the reuse distances of the accesses.

use crate::driver::{Driver, LINE_WORDS, description};
use base::split_mix;
use memory::CacheCounts;
use memory::description::{Bytes, Cache};

const SIZES: [u32; 8] = [1, 2, 4, 8, 16, 32, 64, 128];

/// A stream of lines in which near ones and ones of late are frequent.
fn lines(seed: u64) -> Vec<u32> {
    let mut state = seed;
    let mut line = 0u32;
    (0..1500)
        .map(|_| {
            let random = split_mix::next(&mut state);
            line = match random % 4 {
                0 => (random >> 8) as u32 % 90,
                1 => line / 2,
                _ => (line + (random >> 8) as u32 % 3) % 90,
            };
            line
        })
        .collect()
}

/// For each size, the accesses whose line is not among the last so many distinct ones.
fn expected(lines: &[u32]) -> Vec<u64> {
    let mut recent: Vec<u32> = vec![];
    let mut misses = vec![0; SIZES.len()];
    for line in lines {
        let distance = recent.iter().position(|other| other == line);
        for (size, misses) in SIZES.iter().zip(&mut misses) {
            *misses += u64::from(distance.is_none_or(|distance| distance >= *size as usize));
        }
        recent.retain(|other| other != line);
        recent.insert(0, *line);
    }
    misses
}

/// What a cache of one set counts, whose accesses follow one another.
fn counts(lines: &[u32], l1: impl Fn(Cache) -> Cache, l2: impl Fn(Cache) -> Cache) -> [CacheCounts; 2] {
    let mut description = description();
    (description.l1, description.l2) = (l1(description.l1), l2(description.l2));
    let mut driver = Driver::new(&description);
    for line in lines {
        driver.load(line * LINE_WORDS);
        driver.next_quantum();
    }
    [driver.memory.l1_counts(), driver.memory.l2_counts()]
}

#[test]
fn a_larger_cache_never_misses_more_and_each_size_misses_what_reuse_says() {
    let one_set = |size: u32| {
        move |cache: Cache| Cache {
            size: Bytes(64 * u64::from(size)),
            associativity: size,
            banks: 1,
            ..cache
        }
    };
    let misses = |counts: &CacheCounts| counts.loads - counts.hits;
    for seed in 0..3 {
        let lines = lines(seed);
        let expected = expected(&lines);
        assert!(expected[..7].is_sorted_by(|small, large| small > large), "each size decides: {expected:?}");
        let l1 = SIZES.map(|size| misses(&counts(&lines, one_set(size), |l2| l2)[0]));
        assert_eq!(l1[..], expected, "first level");
        let off = |l1: Cache| Cache { enabled: false, ..l1 };
        let l2 = SIZES.map(|size| misses(&counts(&lines, off, one_set(size))[1]));
        assert_eq!(l2[..], expected, "second level");
    }
}
