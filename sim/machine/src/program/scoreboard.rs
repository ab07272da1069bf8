//! Which operands an operation can find not to be ready, which results have to be noted for that, and the entries of their
//! registers on the scoreboard.
//!
//! A thread issues in order, at most one operation a cycle. So a result is ready for whoever comes as many operations
//! later as its unit takes cycles, and for whoever comes behind an operation that has waited for it. Along the runs of a
//! program this leaves few operands that need a look, few results to note and few registers that need an entry. What a load
//! brings may come at any time, and also after its register was written again, until an operation has waited for it.

use super::EntryId;
use super::registers::{REGISTERS, Register, ZERO};

/// Index of a register on the scoreboard.
pub type BoardEntry = u8;
/// The entry of what is always ready.
pub const READY: BoardEntry = 0;
/// Written for results that need no entry.
pub const SINK: BoardEntry = 1;
/// Entries of a scoreboard in memory: one for each value of an index, so that no index needs a check.
pub const BOARD_ENTRIES: usize = 1 << BoardEntry::BITS;

/// The registers of an operation.
#[derive(Clone, Debug)]
pub struct Accesses {
    pub reads: Vec<Register>,
    pub writes: Vec<Register>,
    /// Cycles until what it writes can be used; none for loads.
    pub latency_cycles: Option<u32>,
}

/// The operations from one entry point to the next.
#[derive(Clone, Debug)]
pub struct Stretch {
    pub from: EntryId,
    pub to: Option<EntryId>,
    pub operations: Vec<Accesses>,
}

/// For each register, the greatest number of cycles by which it may be later than the next operation's operands.
type Lateness = [u32; REGISTERS];
/// Of a loaded register.
const UNBOUNDED: u32 = u32::MAX;

/// Which registers of a program are on the scoreboard, and who looks at them.
#[derive(Clone, Debug)]
pub struct Scoreboard {
    /// By stretch and operation, the registers that it can find not to be ready.
    pub waits: Vec<Vec<Vec<Register>>>,
    /// By stretch and operation, whether what it writes has to be noted.
    pub notes: Vec<Vec<bool>>,
    entry_of: [BoardEntry; REGISTERS],
}

impl Scoreboard {
    /// The scoreboard of a program with these stretches between so many entry points.
    pub fn new(stretches: &[Stretch], entries: usize) -> Self {
        // At entry points; grows until it holds for all ways that lead there.
        let mut late: Vec<Lateness> = vec![[0; REGISTERS]; entries];
        loop {
            let before = late.clone();
            for stretch in stretches {
                let mut here = late[usize::from(stretch.from)];
                go_through(stretch, &mut here);
                if let Some(to) = stretch.to {
                    let there = &mut late[usize::from(to)];
                    there.iter_mut().zip(here).for_each(|(there, here)| *there = here.max(*there));
                }
            }
            if late == before {
                break;
            }
        }
        let waits_of = |stretch: &Stretch| go_through(stretch, &mut late[usize::from(stretch.from)].clone());
        let waits: Vec<Vec<Vec<Register>>> = stretches.iter().map(waits_of).collect();
        let notes = notes(stretches, &waits, &late);
        let mut entry_of = [SINK; REGISTERS];
        entry_of[usize::from(ZERO)] = READY;
        let mut next = SINK + 1;
        for &register in waits.iter().flatten().flatten() {
            let entry = &mut entry_of[usize::from(register)];
            if *entry == SINK {
                *entry = next;
                next += 1;
            }
        }
        Self { waits, notes, entry_of }
    }

    /// The entry of `register`, [`SINK`] if nobody ever waits for it.
    pub fn entry(&self, register: Register) -> BoardEntry {
        self.entry_of[usize::from(register)]
    }
}

/// Goes through `stretch` from where registers are so `late`: what each operation can find not to be ready.
fn go_through(stretch: &Stretch, late: &mut Lateness) -> Vec<Vec<Register>> {
    let waits = |operation: &Accesses| {
        let mut waits = operation.reads.clone();
        waits.retain(|register| late[usize::from(*register)] > 0);
        step(late, operation);
        waits
    };
    stretch.operations.iter().map(waits).collect()
}

/// `operation` is issued, at the earliest in the cycle that `late` counts from; the next one follows a cycle later.
fn step(late: &mut Lateness, operation: &Accesses) {
    for &register in &operation.reads {
        late[usize::from(register)] = 0;
    }
    for cycles in late.iter_mut().filter(|cycles| **cycles != UNBOUNDED) {
        *cycles = cycles.saturating_sub(1);
    }
    for &register in operation.writes.iter().filter(|register| **register != ZERO) {
        let cycles = &mut late[usize::from(register)];
        *cycles = match operation.latency_cycles {
            None => UNBOUNDED,
            Some(_) if *cycles == UNBOUNDED => UNBOUNDED,
            Some(latency) => latency - 1,
        };
    }
}

/// For each register, operations from the next one on before one that looks at it.
type Distance = [u32; REGISTERS];

/// Goes back through `stretch` from where operations that look are so `far`; calls `at` with each operation's number and what is
/// true behind it.
fn go_back(
    stretch: &Stretch,
    waits: &[Vec<Register>],
    far: &mut Distance,
    mut at: impl FnMut(usize, &Distance),
) {
    for number in (0..stretch.operations.len()).rev() {
        at(number, far);
        far.iter_mut().for_each(|far| *far = far.saturating_add(1));
        waits[number].iter().for_each(|register| far[usize::from(*register)] = 0);
    }
}

/// By stretch and operation, whether the scoreboard has to know of what it writes.
///
/// It need not know if no operation looks before the result is ready, and what the scoreboard says of the register without it is
/// not later either. Then all operations that look find the register ready, as they would otherwise.
fn notes(stretches: &[Stretch], waits: &[Vec<Vec<Register>>], late: &[Lateness]) -> Vec<Vec<bool>> {
    // At entry points; shrinks until it holds for all ways that lead on.
    let mut far: Vec<Distance> = vec![[u32::MAX; REGISTERS]; late.len()];
    let behind = |stretch: &Stretch, far: &[Distance]| {
        stretch.to.map_or([u32::MAX; REGISTERS], |to| far[usize::from(to)])
    };
    loop {
        let before = far.clone();
        for (stretch, waits) in stretches.iter().zip(waits) {
            let mut here = behind(stretch, &far);
            go_back(stretch, waits, &mut here, |_, _| ());
            let there = &mut far[usize::from(stretch.from)];
            there.iter_mut().zip(here).for_each(|(there, here)| *there = here.min(*there));
        }
        if far == before {
            break;
        }
    }
    let of = |(stretch, waits): (&Stretch, &Vec<Vec<Register>>)| {
        let mut notes = vec![false; stretch.operations.len()];
        go_back(stretch, waits, &mut behind(stretch, &far), |number, far| {
            let Accesses { writes, latency_cycles, .. } = &stretch.operations[number];
            let early = |register: &Register| {
                latency_cycles.is_none_or(|latency| far[usize::from(*register)].saturating_add(1) < latency)
            };
            notes[number] = writes.iter().any(early);
        });
        let mut late = late[usize::from(stretch.from)];
        for (operation, notes) in stretch.operations.iter().zip(&mut notes) {
            operation.reads.iter().for_each(|register| late[usize::from(*register)] = 0);
            *notes |= operation.writes.iter().any(|register| late[usize::from(*register)] > 1);
            step(&mut late, operation);
        }
        notes
    };
    stretches.iter().zip(waits).map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn accesses(reads: &[Register], write: Register, latency_cycles: Option<u32>) -> Accesses {
        Accesses { reads: reads.to_vec(), writes: vec![write], latency_cycles }
    }

    /// What operations wait for; the first stretch comes first, and both lead to the second.
    fn waits(stretches: [Vec<Accesses>; 2]) -> [Vec<Vec<Register>>; 2] {
        let [first, second] = stretches;
        let stretches =
            [(0, first), (1, second)].map(|(from, operations)| Stretch { from, to: Some(1), operations });
        let board = Scoreboard::new(&stretches, 2);
        [0, 1].map(|stretch| board.waits[stretch].clone())
    }

    fn three() -> Accesses {
        accesses(&[], 5, Some(3))
    }

    fn use_it() -> Accesses {
        accesses(&[5, 6], 7, Some(1))
    }

    fn other() -> Accesses {
        accesses(&[6], 8, Some(1))
    }

    #[test]
    fn results_are_waited_for_until_their_latency_has_passed() {
        let [first, second] = waits([vec![three(), other(), use_it(), use_it()], vec![three()]]);
        // The second use need not look.
        assert_eq!((first, second), (vec![vec![], vec![], vec![5], vec![]], vec![vec![]]));
        // Nor one that comes a cycle later.
        let [first, _] = waits([vec![three(), other(), other(), use_it()], vec![]]);
        assert_eq!(first, vec![vec![0; 0]; 4]);
    }

    #[test]
    fn what_comes_late_is_late_behind_an_entry_point_too_on_whatever_way() {
        let two = || accesses(&[], 5, Some(2));
        let [_, second] = waits([vec![two()], vec![use_it()]]);
        assert_eq!(second, [[5]]);
        // From its own end, the register is ready, unless it was written last.
        let [_, second] = waits([vec![], vec![use_it(), accesses(&[], 5, Some(1))]]);
        assert_eq!(second, vec![vec![0; 0]; 2]);
        let [_, second] = waits([vec![], vec![use_it(), two()]]);
        assert_eq!(second, [vec![5], vec![]]);
    }

    #[test]
    fn loads_are_waited_for_even_if_their_register_was_written_again() {
        let load = accesses(&[], 5, None);
        let write = accesses(&[], 5, Some(1));
        let [first, second] = waits([vec![load, write, other()], vec![use_it(), use_it()]]);
        assert_eq!((first.concat(), second), (vec![], vec![vec![5], vec![]]));
    }

    /// Whether what operations write is noted; stretches as above.
    fn notes_of(stretches: [Vec<Accesses>; 2]) -> [Vec<bool>; 2] {
        let [first, second] = stretches;
        let stretches =
            [(0, first), (1, second)].map(|(from, operations)| Stretch { from, to: Some(1), operations });
        let board = Scoreboard::new(&stretches, 2);
        [0, 1].map(|stretch| board.notes[stretch].clone())
    }

    #[test]
    fn results_are_noted_if_somebody_looks_before_they_are_ready() {
        let [first, _] = notes_of([vec![three(), other(), use_it(), use_it()], vec![]]);
        assert_eq!(first, [true, false, false, false]);
        let [first, _] = notes_of([vec![three(), other(), other(), use_it()], vec![]]);
        assert_eq!(first, [false; 4]);
        // Also where the one who looks comes behind an entry point, on whatever way.
        let [first, second] = notes_of([vec![three()], vec![other(), use_it()]]);
        assert_eq!((first, second), (vec![true], vec![false, false]));
        let [_, second] = notes_of([vec![], vec![use_it(), other(), three()]]);
        assert_eq!(second, [false, false, true]);
    }

    #[test]
    fn results_are_noted_if_the_scoreboard_would_go_on_saying_something_later() {
        let load = || accesses(&[], 5, None);
        let write = || accesses(&[], 5, Some(1));
        // The second write comes while the load may be under way, like the first.
        let [first, _] = notes_of([vec![load(), write(), write(), use_it(), write(), use_it()], vec![]]);
        assert_eq!(first, [true, true, true, false, false, false]);
        // A short one behind a long one, as long as that would not be ready for the next operation anyway.
        let long = || accesses(&[], 5, Some(4));
        let looks = || vec![use_it(), accesses(&[], 5, Some(2))];
        let [first, _] = notes_of([vec![long(), other(), write()], looks()]);
        assert_eq!(first, [true, false, true]);
        let [first, _] = notes_of([vec![long(), other(), other(), write()], looks()]);
        assert_eq!(first, [false; 4]);
    }

    #[test]
    fn only_registers_that_are_waited_for_have_an_entry() {
        let operations =
            vec![accesses(&[], 9, None), accesses(&[9, ZERO], 7, Some(1)), accesses(&[7], 8, Some(1))];
        let board = Scoreboard::new(&[Stretch { from: 0, to: None, operations }], 1);
        assert_eq!([ZERO, 7, 8, 9].map(|register| board.entry(register)), [READY, SINK, SINK, SINK + 1]);
        assert_eq!(board.waits[0][1], [9]);
    }
}
