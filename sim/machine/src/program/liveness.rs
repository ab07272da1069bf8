//! Which registers a program reads, from an instruction on, before it writes them.

use super::decode::Test;
use super::listing::{Control, Listing};
use super::registers::Register;

/// Registers, one bit each.
pub type Set = u128;

/// The registers that are read from instruction `at` on before they are written, up to the next use of the counter.
///
/// Behind the counter, what is read is a matter of the next item.
#[must_use]
pub fn read_first(listing: &Listing) -> Vec<Set> {
    let count = listing.instructions.len();
    let set = |registers: &[Register]| registers.iter().fold(0, |set: Set, r| set | 1 << r);
    let accesses: Vec<(Set, Set)> = listing
        .instructions
        .iter()
        .map(|instruction| {
            let (reads, writes) = instruction.operation.accesses(&listing.lists);
            (set(&reads), set(&writes))
        })
        .collect();
    let mut live = vec![0; count + 2];
    loop {
        let before = live.clone();
        for at in (0..count).rev() {
            let through = |live: Set, at: usize| accesses[at].0 | live & !accesses[at].1;
            let behind = match listing.instructions[at].control {
                Control::Next => live[at + 1],
                // What a later item reads is checked where it begins.
                Control::Counter => 0,
                Control::End => through(0, at + 1),
                Control::Branch(Test::Always, to) => through(live[to], at + 1),
                Control::Branch(_, to) => through(live[to] | live[at + 2], at + 1),
            };
            live[at] = through(behind, at);
        }
        if live == before {
            return live;
        }
    }
}
