//! Work that goes through a program by decisions instead of values: any way through it can be timed.

use crate::core::{Tape, Work};
use crate::execute::Fault;
use crate::program::{Branch, Edge, EntryId, Operation, Place, Program, START, Test};

/// The register that a program asks about its item; zero where there is none.
const ITEM: u8 = 2;

/// Items of a program. `decide` gives, by the item and by the number of decisions that have been made for it, whether a branch is
/// taken, and the address in a register.
pub struct Walk<'a, D> {
    pub program: &'a Program,
    pub items: u32,
    pub decide: D,
}

impl<D: Fn(u32, u64) -> (bool, u32)> Walk<'_, D> {
    fn walk(&self, item: u32, entry: EntryId, tape: &mut Tape<'_>) {
        let graph = &self.program.graph;
        let mut decisions = 0;
        let mut decide = || {
            decisions += 1;
            (self.decide)(item, decisions)
        };
        let mut node = graph.entries[usize::from(entry)];
        tape.begin();
        loop {
            let here = &graph.nodes[node as usize];
            let slot = here.branch.map(|branch| branch.slot);
            for at in here.body.clone().chain(slot) {
                let operation: &Operation = &self.program.operations[at as usize];
                if matches!(operation.place(), Place::Load | Place::Store) && operation.b == 1 {
                    tape.address(decide().1);
                }
            }
            let is_taken = |branch: &Branch, decided: bool| match branch.test {
                Test::Always => true,
                test if branch.a == ITEM => (item >= self.items) == (test == Test::Equal),
                _ => decided,
            };
            let taken = here.branch.filter(|branch| is_taken(branch, decide().0));
            match taken.map_or(here.next, |branch| branch.taken) {
                Edge::Node(next) => node = next,
                Edge::Entry(run, entry) => {
                    tape.end(run);
                    node = graph.entries[usize::from(entry)];
                    tape.begin();
                }
                Edge::Counter(run, _) | Edge::End(run) => return tape.end(run),
            }
        }
    }
}

impl<D: Fn(u32, u64) -> (bool, u32) + Sync> Work for Walk<'_, D> {
    fn items(&self) -> u32 {
        self.items
    }

    fn entries(&self) -> Option<(EntryId, EntryId)> {
        // These programs use the counter twice, first at their beginning.
        let edges =
            self.program.graph.nodes.iter().flat_map(|node| {
                [Some(node.next), node.branch.map(|branch| branch.taken)].into_iter().flatten()
            });
        let behind = edges.filter_map(|edge| match edge {
            Edge::Counter(_, entry) => Some(entry),
            _ => None,
        });
        behind.clone().min().zip(behind.max())
    }

    fn start(&self, tape: &mut Tape<'_>) -> Result<(), Box<Fault>> {
        self.walk(0, START, tape);
        Ok(())
    }

    fn record(&self, item: u32, entry: EntryId, tape: &mut Tape<'_>) -> Result<(), Box<Fault>> {
        self.walk(item, entry, tape);
        Ok(())
    }
}
