//! An incremental SAT solver over the nodes of a graph.

use std::collections::BTreeMap;

use batsat::{Callbacks, ClauseKind, Lit as SatLit, Solver, SolverInterface, SolverOpts, Var, lbool};

use crate::aig::{Aig, Lit};

/// The answer to a query.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Answer {
    /// The literals cannot hold together.
    Never,
    /// They hold for these values of sources: inputs and latches, by node. Other sources do not matter.
    Holds(Vec<(usize, bool)>),
    /// The limit was reached before either was known.
    Unknown,
}

/// Stops a search after a number of conflicts.
#[derive(Default)]
struct Limit {
    learnt: u64,
    most: u64,
}

impl Callbacks for Limit {
    fn on_new_clause(&mut self, _: &[SatLit], kind: ClauseKind) {
        self.learnt += u64::from(kind == ClauseKind::Learnt);
    }

    fn stop(&self) -> bool {
        self.learnt >= self.most
    }
}

/// A solver that holds the clauses of the nodes that queries were about.
pub struct NodeSolver {
    solver: Solver<Limit>,
    variables: BTreeMap<usize, Var>,
}

impl Default for NodeSolver {
    fn default() -> Self {
        Self { solver: Solver::new(SolverOpts::default(), Limit::default()), variables: BTreeMap::new() }
    }
}

impl NodeSolver {
    /// Number of nodes that the solver knows.
    #[must_use]
    pub fn len(&self) -> usize {
        self.variables.len()
    }

    /// Conflicts so far.
    #[must_use]
    pub fn conflicts(&self) -> u64 {
        self.solver.cb().learnt
    }

    /// Whether all of `literals` can hold at once; gives up after `most_conflicts`.
    pub fn query(&mut self, aig: &Aig, literals: &[Lit], most_conflicts: u64) -> Answer {
        let assumptions: Vec<SatLit> = literals.iter().map(|&lit| self.literal(aig, lit)).collect();
        let limit = self.solver.cb_mut();
        limit.most = limit.learnt.saturating_add(most_conflicts);
        match self.solver.solve_limited(&assumptions) {
            answer if answer == lbool::FALSE => Answer::Never,
            answer if answer == lbool::TRUE => {
                let is_source = |node: usize| node != 0 && aig.operands(node).is_none();
                let known = self.variables.iter().filter(|(node, _)| is_source(**node));
                Answer::Holds(
                    known.map(|(&node, &var)| (node, self.solver.value_var(var) == lbool::TRUE)).collect(),
                )
            }
            _ => Answer::Unknown,
        }
    }

    /// States that two literals are equal, which must have been proved.
    pub fn state_equal(&mut self, aig: &Aig, a: Lit, b: Lit) {
        let (a, b) = (self.literal(aig, a), self.literal(aig, b));
        self.clause(&[!a, b]);
        self.clause(&[a, !b]);
    }

    fn clause(&mut self, literals: &[SatLit]) {
        self.solver.add_clause_reuse(&mut literals.to_vec());
    }

    fn literal(&mut self, aig: &Aig, lit: Lit) -> SatLit {
        self.add_cone(aig, lit.node());
        self.known(lit)
    }

    fn known(&self, lit: Lit) -> SatLit {
        SatLit::new(self.variables[&lit.node()], !lit.is_complemented())
    }

    /// Adds the clauses of a node and of all that it depends on.
    fn add_cone(&mut self, aig: &Aig, node: usize) {
        let mut stack = vec![node];
        while let Some(&node) = stack.last() {
            if self.variables.contains_key(&node) {
                stack.pop();
                continue;
            }
            let operands = aig.operands(node);
            let waiting: Vec<usize> = (operands.iter().flatten())
                .map(|lit| lit.node())
                .filter(|node| !self.variables.contains_key(node))
                .collect();
            if !waiting.is_empty() {
                stack.extend(waiting);
                continue;
            }
            let variable = self.solver.new_var_default();
            self.variables.insert(node, variable);
            let own = SatLit::new(variable, true);
            if let Some([a, b]) = operands {
                let (a, b) = (self.known(a), self.known(b));
                self.clause(&[!own, a]);
                self.clause(&[!own, b]);
                self.clause(&[own, !a, !b]);
            } else if node == 0 {
                self.clause(&[!own]);
            }
            stack.pop();
        }
    }
}
