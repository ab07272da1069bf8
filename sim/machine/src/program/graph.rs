//! Paths through a program, from one entry point to the next.
//!
//! The timing core executes straight *runs* of instructions. A run begins at an entry point: at the start, behind a use of the
//! counter, or where control jumps back to. It ends at the next one. Branches between two entry points make a tree of nodes, whose
//! leaves are the runs; executing a program goes from node to node. Where a tree would get too large, a place at which its paths
//! meet becomes an entry point too.

use super::code::Route;
use super::decode::Test;
use super::listing::{Control, Listing, ListingError};
use super::operation::Operation;
use super::registers::Register;
use super::{EntryId, RunId};
use std::ops::Range;

/// Most paths from an entry point to the next.
const MOST_PATHS: u64 = 16;
/// Most entry points of a program.
const MOST_ENTRIES: usize = EntryId::MAX as usize;
/// Most instructions of all paths together, a multiple of what the largest program of this crate has.
const MOST_ON_PATHS: u64 = 1 << 16;

/// Index of a node.
pub type NodeId = u32;

/// What follows the instructions of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Edge {
    /// Another node of the same tree.
    Node(NodeId),
    /// The run is over, and goes on at an entry point.
    Entry(RunId, EntryId),
    /// The run is over, and the next item of work is needed.
    Counter(RunId, EntryId),
    /// The run and the program are over.
    End(RunId),
}

/// Straight instructions, then a branch.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Node {
    /// Instructions before the branch.
    pub body: Range<u32>,
    /// The branch, which its delay slot follows.
    pub branch: Option<Branch>,
    /// Where it goes if there is no branch, or it is not taken.
    pub next: Edge,
}

/// A branch of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Branch {
    /// What is asked.
    pub test: Test,
    /// Of which registers.
    pub a: Register,
    /// The second one.
    pub b: Register,
    /// The instruction in its delay slot.
    pub slot: u32,
    /// Where it goes if the test holds.
    pub taken: Edge,
}

/// All paths of a program.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Graph {
    /// All nodes.
    pub nodes: Vec<Node>,
    /// The first node of each entry point.
    pub entries: Vec<NodeId>,
    /// Instructions of each run.
    pub routes: Vec<Route>,
}

/// What builds the graph of `listing`.
struct Builder<'a> {
    program: &'a str,
    listing: &'a Listing,
    /// Instructions at entry points, the start first.
    points: Vec<usize>,
    graph: Graph,
}

impl Graph {
    /// The paths through `listing`; entry 0 is the start.
    ///
    /// # Errors
    /// If there are too many entry points, or paths between them.
    pub fn new(program: &str, listing: &Listing) -> Result<Self, ListingError> {
        let mut builder = Builder { program, listing, points: entry_points(listing), graph: Self::default() };
        builder.limit_paths()?;
        builder.limit_instructions()?;
        for number in 0..builder.points.len() {
            let mut route = vec![];
            let node = builder.node(number as EntryId, builder.points[number], &mut route);
            builder.graph.entries.push(node);
        }
        Ok(builder.graph)
    }
}

/// The start, what follows the counter, and what control jumps back to.
fn entry_points(listing: &Listing) -> Vec<usize> {
    let mut points = vec![listing.start];
    for (at, instruction) in listing.instructions.iter().enumerate() {
        match instruction.control {
            Control::Counter => points.push(at + 1),
            Control::Branch(_, to) if to <= at + 1 => points.push(to),
            _ => {}
        }
    }
    points[1..].sort_unstable();
    let mut seen = vec![];
    points.retain(|at| {
        let new = !seen.contains(at);
        seen.push(*at);
        new
    });
    points
}

/// Where control can go from a place between entry points.
enum Way {
    /// To the instruction with this index.
    To(usize),
    /// Nowhere on this path.
    Out,
}

impl Builder<'_> {
    /// Turns places at which paths meet into entry points, until no entry point has too many paths.
    fn limit_paths(&mut self) -> Result<(), ListingError> {
        loop {
            if self.points.len() > MOST_ENTRIES {
                let message = format!("more than {MOST_ENTRIES} loops and joining branches");
                return Err(self.error(self.points[MOST_ENTRIES], message));
            }
            let onward = self.onward();
            let worst = self.points.iter().copied().max_by_key(|at| onward[*at]);
            let Some(worst) = worst.filter(|at| onward[*at] > MOST_PATHS) else {
                return Ok(());
            };
            let inward = self.inward(worst);
            let gain = |at: &usize| {
                let (to, from) = (inward[*at], onward[*at]);
                (to.saturating_mul(from)).saturating_sub(to.saturating_add(from))
            };
            let joins = (0..inward.len()).filter(|at| inward[*at] > 1 && !self.points.contains(at));
            match joins.max_by_key(gain) {
                Some(at) if gain(&at) > 0 => self.points.push(at),
                _ => return Ok(()),
            }
        }
    }

    fn error(&self, at: usize, message: String) -> ListingError {
        let line = self.listing.instructions[at].line as usize;
        ListingError { program: self.program.to_owned(), line, message }
    }

    /// Whether all paths can be kept.
    fn limit_instructions(&self) -> Result<(), ListingError> {
        let onward = self.onward();
        // By instruction, those of all paths from it on.
        let mut lengths = vec![0u64; onward.len()];
        for at in (0..onward.len()).rev() {
            let behind = self.ways(at).map(|way| match way {
                Way::To(to) if to > at => lengths.get(to).copied().unwrap_or(0),
                _ => 0,
            });
            // A branch takes its delay slot along.
            let is_branch =
                matches!(self.listing.instructions[at].control, Control::Branch(..) | Control::End);
            let own = onward[at].saturating_mul(if is_branch { 2 } else { 1 });
            lengths[at] =
                behind[0].saturating_add(if self.forks(at) { behind[1] } else { 0 }).saturating_add(own);
        }
        let mut sum = 0u64;
        for &at in &self.points {
            sum = sum.saturating_add(lengths[at]);
            if sum > MOST_ON_PATHS {
                let message = format!(
                    "more than {MOST_ON_PATHS} instructions on all paths between loops and joining branches"
                );
                return Err(self.error(at, message));
            }
        }
        Ok(())
    }

    /// Where control goes from instruction `at`.
    fn ways(&self, at: usize) -> [Way; 2] {
        let way = |to: usize| if self.points.contains(&to) { Way::Out } else { Way::To(to) };
        match self.listing.instructions[at].control {
            Control::Next => [way(at + 1), Way::Out],
            Control::Counter | Control::End => [Way::Out, Way::Out],
            Control::Branch(Test::Always, to) => [way(to), Way::Out],
            Control::Branch(_, to) => [way(to), way(at + 2)],
        }
    }

    /// Whether the instruction can go two ways.
    fn forks(&self, at: usize) -> bool {
        matches!(self.listing.instructions[at].control, Control::Branch(test, _) if test != Test::Always)
    }

    /// Paths from each instruction to the next entry points. Between entry points, control only goes to higher addresses.
    fn onward(&self) -> Vec<u64> {
        let count = self.listing.instructions.len();
        let mut paths = vec![1u64; count];
        for at in (0..count).rev() {
            let [a, b] = self.ways(at).map(|way| match way {
                Way::To(to) if to > at => paths.get(to).copied().unwrap_or(1),
                _ => 1,
            });
            paths[at] = if self.forks(at) { a.saturating_add(b) } else { a };
        }
        paths
    }

    /// Paths to each instruction from the entry point at instruction `from`.
    fn inward(&self, from: usize) -> Vec<u64> {
        let mut paths = vec![0u64; self.listing.instructions.len()];
        paths[from] = 1;
        for at in from..paths.len() {
            let ways = self.ways(at);
            let used = if self.forks(at) { 2 } else { 1 };
            for way in ways.into_iter().take(used) {
                if let Way::To(to) = way
                    && to > at
                    && to < paths.len()
                {
                    paths[to] = paths[to].saturating_add(paths[at]);
                }
            }
        }
        paths
    }

    /// The node at instruction `at` of the tree of `entry`, `route` leading to it.
    fn node(&mut self, entry: EntryId, at: usize, route: &mut Vec<usize>) -> NodeId {
        let id = self.graph.nodes.len();
        self.graph.nodes.push(Node { body: 0..0, branch: None, next: Edge::End(0) });
        let length = route.len();
        let mut here = at;
        while self.listing.instructions[here].control == Control::Next {
            route.push(here);
            here += 1;
            if self.points.contains(&here) {
                break;
            }
        }
        let body = at as u32..here as u32;
        let instruction = self.listing.instructions[here];
        let over = self.points.contains(&here) && here > at;
        let Operation { a, b, .. } = instruction.operation;
        let branch = |test, taken| Branch { test, a, b, slot: here as u32 + 1, taken };
        let (branch, next) = match instruction.control {
            _ if over => (None, self.edge(entry, here, route)),
            Control::Next => unreachable!("straight instructions end at a branch or an entry point"),
            Control::Counter => {
                route.push(here);
                let to = self.number(here + 1);
                (None, Edge::Counter(self.run(entry, Some(to), route), to))
            }
            Control::End => {
                route.extend([here, here + 1]);
                let end = Edge::End(self.run(entry, None, route));
                (Some(branch(Test::Always, end)), end)
            }
            Control::Branch(test, to) => {
                route.extend([here, here + 1]);
                let taken = self.edge(entry, to, route);
                let next = if test == Test::Always { taken } else { self.edge(entry, here + 2, route) };
                (Some(branch(test, taken)), next)
            }
        };
        route.truncate(length);
        self.graph.nodes[id] = Node { body, branch, next };
        id as NodeId
    }

    /// What leads to instruction `to` in the tree of `entry` by `route`.
    fn edge(&mut self, entry: EntryId, to: usize, route: &mut Vec<usize>) -> Edge {
        if self.points.contains(&to) {
            let number = self.number(to);
            return Edge::Entry(self.run(entry, Some(number), route), number);
        }
        Edge::Node(self.node(entry, to, route))
    }

    fn number(&self, at: usize) -> EntryId {
        self.points.iter().position(|point| *point == at).expect("an entry point") as EntryId
    }

    fn run(&mut self, from: EntryId, to: Option<EntryId>, route: &[usize]) -> RunId {
        self.graph.routes.push(Route { from, to, instructions: route.to_vec() });
        self.graph.routes.len() as RunId - 1
    }
}
