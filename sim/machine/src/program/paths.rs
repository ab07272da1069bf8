//! Paths through a listing from one entry point to the next, decided by conditions.

use super::code::Route;
use super::listing::{Control, Listing, ListingError};
use super::{Conditions, EntryId, RunId};

/// Longest path between entry points.
const MAX_RUN: usize = 4096;

/// An entry point.
#[derive(Clone, Debug)]
pub struct Entry {
    pub name: String,
    /// Conditions that the paths from here depend on, one bit each.
    bits: Vec<Conditions>,
    /// The lowest of them and their number, if there is none between them that the paths do not depend on.
    adjacent: Option<(u32, u32)>,
    /// The run for each combination of these conditions.
    runs: Vec<RunId>,
}

impl Entry {
    /// The run under `conditions`.
    #[inline(always)]
    pub fn run(&self, conditions: Conditions) -> RunId {
        let index = match self.adjacent {
            Some((lowest, number)) => (conditions >> lowest & !(Conditions::MAX << number)) as usize,
            None => {
                self.bits.iter().rev().fold(0, |index, bit| index << 1 | usize::from(conditions & bit != 0))
            }
        };
        self.runs[index]
    }
}

/// The paths of a program.
pub struct Paths<'a> {
    program: &'a str,
    listing: &'a Listing,
    /// Names of conditions.
    conditions: &'a [String],
    /// Instructions with an entry point.
    points: Vec<usize>,
}

enum Path {
    /// Depends on a condition that is not decided yet.
    Undecided(Conditions),
    Complete {
        instructions: Vec<usize>,
        next: Option<usize>,
    },
}

impl<'a> Paths<'a> {
    /// Those of the listing of `program`.
    pub fn new(program: &'a str, listing: &'a Listing, conditions: &'a [String]) -> Self {
        Self { program, listing, conditions, points: listing.entries.keys().copied().collect() }
    }

    /// The entry point `name` at instruction `at`, whose routes are added to `routes`.
    pub fn entry(&self, name: &str, at: usize, routes: &mut Vec<Route>) -> Result<Entry, ListingError> {
        let number = |at| self.points.iter().position(|point| *point == at).expect("an entry") as EntryId;
        // Paths that are still to be followed: conditions decided so far, and their values.
        let mut open = vec![(0, 0)];
        let mut complete = vec![];
        let mut mask = 0;
        while let Some((decided, values)) = open.pop() {
            match self.path(at, decided, values)? {
                Path::Undecided(condition) => {
                    open.push((decided | condition, values));
                    open.push((decided | condition, values | condition));
                }
                Path::Complete { instructions, next } => {
                    mask |= decided;
                    complete.push((decided, values, routes.len() as RunId));
                    routes.push(Route { from: number(at), to: next.map(number), instructions });
                }
            }
        }
        let run = |all: Conditions| {
            let found = complete.iter().find(|(decided, values, _)| all & decided == *values);
            found.expect("paths cover all values").2
        };
        let bits: Vec<Conditions> =
            (0..Conditions::BITS).map(|bit| 1 << bit).filter(|bit| mask & bit != 0).collect();
        let conditions = |index: u32| {
            let bits = bits.iter().enumerate();
            bits.map(|(at, bit)| if index >> at & 1 != 0 { *bit } else { 0 }).sum::<Conditions>()
        };
        let runs = (0..1 << bits.len()).map(|index| run(conditions(index))).collect();
        let number = bits.len() as u32;
        let lowest = if mask == 0 { 0 } else { mask.trailing_zeros() };
        let adjacent = (mask >> lowest == !(Conditions::MAX << number)).then_some((lowest, number));
        Ok(Entry { name: name.to_owned(), bits, adjacent, runs })
    }

    /// The path from instruction `at` to the next entry point.
    fn path(&self, at: usize, decided: Conditions, values: Conditions) -> Result<Path, ListingError> {
        let (listing, points) = (self.listing, &self.points);
        let mut instructions = vec![];
        let mut here = at;
        loop {
            let fail = |message: &str| ListingError {
                program: self.program.to_owned(),
                line: listing.instructions.get(here).map_or(0, |i| i.line),
                message: message.to_owned(),
            };
            let instruction =
                listing.instructions.get(here).ok_or_else(|| fail("the program does not end"))?;
            instructions.push(here);
            if instructions.len() > MAX_RUN {
                return Err(fail("a loop without entry point"));
            }
            let next = match &instruction.control {
                Control::Next => {
                    here += 1;
                    if points.contains(&here) {
                        return Ok(Path::Complete { instructions, next: Some(here) });
                    }
                    continue;
                }
                Control::End => None,
                Control::Jump(target) => Some(*target),
                Control::Branch(target, condition, taken_if) => {
                    let bit = 1 << self.conditions.iter().position(|c| c == condition).expect("interned");
                    if decided & bit == 0 {
                        return Ok(Path::Undecided(bit));
                    }
                    Some(if (values & bit != 0) == *taken_if { *target } else { here + 2 })
                }
            };
            // The delay slot.
            if points.contains(&(here + 1)) {
                return Err(fail("an entry point in a delay slot"));
            }
            instructions.push(here + 1);
            match next {
                None => return Ok(Path::Complete { instructions, next: None }),
                Some(target) if points.contains(&target) => {
                    return Ok(Path::Complete { instructions, next: Some(target) });
                }
                Some(target) => here = target,
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::description::MachineDescription;
    use crate::program::Program;

    #[test]
    fn the_run_follows_from_the_conditions_that_the_entry_point_asks_for() {
        // `start` asks for a and b, `second` for a and c. Where a branch is not taken, there is an addition more for its first
        // condition, two for its second.
        let text = "main: #: start\n beqz $2, $one #: a\n nop\n addu $3, $3, $3\n$one:\n beqz $2, $two #: b\n nop\n\
                    addu $3, $3, $3\n addu $3, $3, $3\n$two: #: second\n beqz $2, $three #: a\n nop\n addu $3, $3, $3\n$three:\n\
                    beqz $2, $end #: c\n nop\n addu $3, $3, $3\n addu $3, $3, $3\n$end:\n jr $ra\n nop\n";
        let machine = MachineDescription::load("simtrax-reference", &[]).unwrap();
        let program = Program::new("test", text, &machine, 8).unwrap();
        let [a, b, c] = ["a", "b", "c"].map(|name| program.condition(name));
        for (entry, asked, branches) in [("start", [a, b], 4), ("second", [a, c], 6)] {
            for conditions in 0..8 {
                let additions = [1, 2].iter().zip(asked).filter(|(_, bit)| conditions & bit == 0);
                let additions: usize = additions.map(|(additions, _)| additions).sum();
                let run = program.run(program.entry(entry), conditions);
                assert_eq!(program.ops_of(run).len(), branches + additions, "{entry} {conditions:b}");
            }
        }
    }
}
