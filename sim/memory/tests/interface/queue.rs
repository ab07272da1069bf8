//! Little's law: the mean number of reads in the memory is their rate times their mean latency.

use crate::driver::{Driver, LINE_WORDS, description};
use base::split_mix;
use memory::{Access, Answer, Client};

/// Reads `lines` lines, at most `most` in a cycle and none in some cycles. Returns the cycles that it took, and the sum over these
/// cycles of the number of reads that the memory had taken and not finished, as the client sees it.
fn read(driver: &mut Driver, lines: u32, most: u64, seed: u64) -> (u32, u64) {
    let (mut state, mut sent, mut asked, mut arrived, mut sum) = (seed, 0, 0u64, 0, 0);
    let mut arrivals = vec![];
    while sent < lines || arrived < u64::from(lines) {
        let random = split_mix::next(&mut state);
        let now = if random >> 32 & 1 == 0 { random % (most + 1) } else { 0 };
        for _ in 0..now.min(u64::from(lines - sent)) {
            if driver.memory.keeps() {
                break;
            }
            // Every line once, in an order that opens many rows.
            let line = sent.wrapping_mul(40_503) % (1 << 20);
            match driver.ask(Client { port: 0, number: 0 }, Access::Load, line * LINE_WORDS) {
                Answer::Later => asked += 1,
                Answer::Refused => continue,
                Answer::Kept => {}
                answer => panic!("no line is read twice: {answer:?}"),
            }
            sent += 1;
        }
        sum += asked - arrived;
        driver.step();
        asked += driver.woken.drain(..).filter(|(_, answer)| *answer == Answer::Later).count() as u64;
        arrivals.extend(driver.told.drain(..).map(|told| told.arrival));
        arrivals.retain(|arrival| {
            *arrival > driver.now || {
                arrived += 1;
                false
            }
        });
        assert!(driver.now < 1_000_000, "{arrived} of {asked} reads have arrived");
    }
    (driver.now, sum)
}

#[test]
fn reads_in_the_memory_are_their_rate_times_their_latency() {
    let mut means = vec![];
    for (queue, most) in [(80, 1), (80, 8), (4, 8), (1, 8)] {
        let mut description = description();
        // A clock is a cycle, so that nothing is rounded.
        description.dram.clocks_per_cycle = 1;
        description.dram.channels = 2;
        description.dram.read_queue = queue;
        let mut driver = Driver::new(&description);
        let lines = 3000;
        let (cycles, sum) = read(&mut driver, lines, most, u64::from(queue));
        let counts = driver.memory.dram_counts(cycles);
        assert_eq!(counts.reads, u64::from(lines));
        // Times the cycles, which both sides are divided by: the client's samples, and the latencies that the channels counted.
        assert_eq!(sum, counts.read_latency_clocks, "queue of {queue}, {most} in a cycle");
        let mean = sum as f64 / f64::from(cycles);
        // What the queues hold, and what has been read and is on its way.
        let t = description.dram.timing;
        let on_its_way = (t.read_latency + t.burst).div_ceil(t.burst);
        assert!(mean <= f64::from(2 * (queue + on_its_way)), "{mean} with a queue of {queue}");
        means.push(mean);
    }
    assert!(means[1] > 2.0 * means[3], "a longer queue is used: {means:?}");
}
