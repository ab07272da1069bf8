//! Equivalence by sweeping. Where random simulation cannot tell nodes apart, the sweep proves them equal one by one,
//! from the sources on, and merges them, so that later proofs have little left to do (Kuehlmann, Krohm, "Equivalence
//! Checking Using Cuts and Heaps", DAC 1997; Mishchenko et al., "FRAIGs", ERL technical report, 2005).

use std::collections::HashMap;

use super::solver::{Answer, NodeSolver};
use crate::aig::{Aig, Lit, Node};

/// Words of random patterns before the first proof.
const FIRST_WORDS: usize = 16;
/// A solver is replaced when it knows more nodes than this: old clauses slow new queries.
const MOST_NODES: usize = 4000;

/// How hard a proof may try.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Conflicts for each pair of inner nodes.
    pub inner_conflicts: u64,
    /// Conflicts for each pair of outputs.
    pub output_conflicts: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Self { inner_conflicts: 300, output_conflicts: 2_000_000 }
    }
}

/// What a proof found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// All pairs are equal, whatever the sources.
    Equal,
    /// A pair differs.
    Differs {
        /// Position of the pair.
        pair: usize,
        /// Value of each source, inputs and latches, by node; all others are 0.
        sources: Vec<(usize, bool)>,
    },
    /// The limits were reached first, at this pair.
    Unknown {
        /// Position of the pair.
        pair: usize,
    },
}

/// A verdict and what it took.
#[derive(Clone, Debug)]
pub struct Proof {
    /// The answer.
    pub verdict: Verdict,
    /// ANDs that the pairs depend on.
    pub nodes: usize,
    /// Nodes that were proved equal to an earlier one, beyond equal structure.
    pub merged: usize,
    /// Queries to the solver.
    pub queries: u64,
    /// Conflicts in all of them.
    pub conflicts: u64,
}

impl Proof {
    /// The common verdict of several cases, or the first verdict other than equality, with the sums of what the
    /// proofs took.
    #[must_use]
    pub fn of_cases(proofs: &[Self]) -> Self {
        let sum = |number: fn(&Self) -> u64| proofs.iter().map(number).sum();
        let open = proofs.iter().find(|proof| proof.verdict != Verdict::Equal);
        Self {
            verdict: open.map_or(Verdict::Equal, |proof| proof.verdict.clone()),
            nodes: proofs.iter().map(|proof| proof.nodes).sum(),
            merged: proofs.iter().map(|proof| proof.merged).sum(),
            queries: sum(|proof| proof.queries),
            conflicts: sum(|proof| proof.conflicts),
        }
    }
}

/// Proves that the literals of each pair are equal for all values of inputs and latches.
#[must_use]
pub fn prove(aig: &Aig, pairs: &[(Lit, Lit)], limits: Limits) -> Proof {
    Sweep::new(aig, pairs).run(limits)
}

struct Sweep<'a> {
    aig: &'a Aig,
    pairs: &'a [(Lit, Lit)],
    /// Nodes that the pairs depend on.
    cone: Vec<bool>,
    /// Values of each node in all patterns so far, hashed; complemented if the first pattern says 1.
    hashes: Vec<u64>,
    phases: Vec<bool>,
    /// The first node done of each hash.
    classes: HashMap<u64, usize>,
    /// What each node became.
    reduced: Aig,
    map: Vec<Lit>,
    solver: NodeSolver,
    retired_conflicts: u64,
    queries: u64,
    merged: usize,
    random: u64,
    /// The node of the graph of each source of the reduced one.
    sources: HashMap<usize, usize>,
}

impl<'a> Sweep<'a> {
    fn new(aig: &'a Aig, pairs: &'a [(Lit, Lit)]) -> Self {
        let count = aig.nodes().len();
        Self {
            aig,
            pairs,
            cone: aig.cone(pairs.iter().flat_map(|&(a, b)| [a, b])),
            hashes: vec![0; count],
            phases: vec![false; count],
            classes: HashMap::new(),
            reduced: Aig::default(),
            map: vec![Lit::FALSE; count],
            solver: NodeSolver::default(),
            retired_conflicts: 0,
            queries: 0,
            merged: 0,
            random: 0x9e37_79b9_7f4a_7c15,
            sources: HashMap::new(),
        }
    }

    /// xorshift64*, Vigna 2016.
    fn bits(&mut self) -> u64 {
        self.random ^= self.random >> 12;
        self.random ^= self.random << 25;
        self.random ^= self.random >> 27;
        self.random.wrapping_mul(0x2545_f491_4f6c_dd1d)
    }

    /// Adds 64 patterns to every hash; `pattern` gives some sources' values in all of them but for a few flips.
    fn simulate(&mut self, pattern: &[(usize, bool)], is_first: bool) {
        let mut values = vec![0u64; self.aig.nodes().len()];
        let pattern: HashMap<usize, bool> = pattern.iter().copied().collect();
        for (node, found) in self.aig.nodes().iter().enumerate() {
            values[node] = match *found {
                Node::False => 0,
                Node::And(a, b) => {
                    let value = |lit: Lit| values[lit.node()] ^ if lit.is_complemented() { !0 } else { 0 };
                    value(a) & value(b)
                }
                // One flip in 16 around a pattern; the first lane is the pattern itself.
                Node::Input(_) | Node::Latch(_) if !pattern.is_empty() => {
                    let flips = self.bits() & self.bits() & self.bits() & self.bits() & !1;
                    let value = pattern.get(&node).copied().unwrap_or(false);
                    flips ^ if value { !0 } else { 0 }
                }
                Node::Input(_) | Node::Latch(_) => self.bits(),
            };
            if is_first {
                self.phases[node] = values[node] & 1 == 1;
            }
            let value = values[node] ^ if self.phases[node] { !0 } else { 0 };
            // The finaliser of SplitMix64, Steele et al. 2014: a collision costs a query, never a wrong answer.
            let mut mixed = self.hashes[node].rotate_left(5) ^ value;
            mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            self.hashes[node] = mixed ^ (mixed >> 31);
        }
    }

    /// The classes of the nodes below `end`, after hashes have changed.
    fn reclassify(&mut self, end: usize) {
        self.classes.clear();
        for node in 0..end {
            if self.cone[node] || node == 0 {
                self.classes.entry(self.hashes[node]).or_insert(node);
            }
        }
    }

    fn query(&mut self, literals: &[Lit], most_conflicts: u64) -> Answer {
        if self.solver.len() > MOST_NODES {
            self.retired_conflicts += self.solver.conflicts();
            self.solver = NodeSolver::default();
        }
        self.queries += 1;
        self.solver.query(&self.reduced, literals, most_conflicts)
    }

    /// Values by node of the reduced graph, as values by node of the graph.
    fn translate(&self, values: &[(usize, bool)]) -> Vec<(usize, bool)> {
        values.iter().filter_map(|&(node, value)| Some((*self.sources.get(&node)?, value))).collect()
    }

    fn run(mut self, limits: Limits) -> Proof {
        for word in 0..FIRST_WORDS {
            self.simulate(&[], word == 0);
        }
        self.classes.insert(self.hashes[0], 0);
        for node in 1..self.aig.nodes().len() {
            if !self.cone[node] {
                continue;
            }
            match self.aig.nodes()[node] {
                Node::And(a, b) => {
                    let [a, b] = [a, b].map(|lit| self.mapped(lit));
                    let own = self.reduced.and(a, b);
                    self.map[node] = own;
                    self.merge(node, limits.inner_conflicts);
                }
                _ => {
                    let source = self.reduced.add_input(String::new());
                    self.sources.insert(source.node(), node);
                    self.map[node] = source;
                    self.classes.entry(self.hashes[node]).or_insert(node);
                }
            }
        }
        let verdict = self.outputs(limits.output_conflicts);
        Proof {
            verdict,
            nodes: (0..self.cone.len()).filter(|&n| self.cone[n] && self.aig.operands(n).is_some()).count(),
            merged: self.merged,
            queries: self.queries,
            conflicts: self.retired_conflicts + self.solver.conflicts(),
        }
    }

    fn mapped(&self, lit: Lit) -> Lit {
        self.map[lit.node()].complement_if(lit.is_complemented())
    }

    /// Merges a node with an earlier one that it equals, if there is one and the proof is easy.
    fn merge(&mut self, node: usize, most_conflicts: u64) {
        loop {
            let Some(&known) = self.classes.get(&self.hashes[node]) else {
                self.classes.insert(self.hashes[node], node);
                return;
            };
            let own = self.map[node];
            let other = self.map[known].complement_if(self.phases[known] ^ self.phases[node]);
            if own == other {
                return;
            }
            match self.differ(own, other, most_conflicts) {
                Answer::Never => {
                    self.solver.state_equal(&self.reduced, own, other);
                    self.map[node] = other;
                    self.merged += 1;
                    return;
                }
                Answer::Holds(values) => {
                    let pattern = self.translate(&values);
                    self.simulate(&pattern, false);
                    self.reclassify(node);
                }
                Answer::Unknown => return,
            }
        }
    }

    /// Whether two literals can differ.
    fn differ(&mut self, a: Lit, b: Lit, most_conflicts: u64) -> Answer {
        if a == !b {
            return Answer::Holds(Vec::new());
        }
        match self.query(&[a, !b], most_conflicts) {
            Answer::Never => self.query(&[!a, b], most_conflicts),
            answer => answer,
        }
    }

    fn outputs(&mut self, most_conflicts: u64) -> Verdict {
        for (pair, &(a, b)) in self.pairs.iter().enumerate() {
            let (a, b) = (self.mapped(a), self.mapped(b));
            if a == b {
                continue;
            }
            match self.differ(a, b, most_conflicts) {
                Answer::Never => self.solver.state_equal(&self.reduced, a, b),
                Answer::Holds(values) => {
                    return Verdict::Differs { pair, sources: self.translate(&values) };
                }
                Answer::Unknown => return Verdict::Unknown { pair },
            }
        }
        Verdict::Equal
    }
}
