//! Two circuits over common inputs and states.

use std::collections::BTreeMap;

use super::sweep::{Limits, Proof, prove};
use crate::aig::{Aig, Lit, Node};

/// Why two circuits cannot be compared.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MiterError {
    /// One circuit has a port or state that the other has not.
    #[error("{what} `{name}` is in one circuit only: compare circuits with equal ports and registers")]
    Unmatched {
        /// Input, output or latch.
        what: &'static str,
        /// Its name.
        name: String,
    },
    /// A latch starts at different values.
    #[error("latch `{0}` starts at different values: compare circuits with equal initial states")]
    Initial(String),
}

/// Two circuits side by side in one graph, with the pairs that are to be equal: outputs and next states by name.
#[derive(Clone, Debug, Default)]
pub struct Miter {
    /// Both circuits; equal structure is shared. Latches of the circuits are inputs.
    pub aig: Aig,
    /// What is to be equal.
    pub pairs: Vec<(Lit, Lit)>,
    /// The name of each pair.
    pub names: Vec<String>,
}

impl Miter {
    /// Pairs everything that has the same name.
    ///
    /// # Errors
    /// [`MiterError`] when a name is in one of the circuits only, or latches differ in their initial value.
    pub fn new(left: &Aig, right: &Aig) -> Result<Self, MiterError> {
        let mut miter = Self::default();
        let mut sources: BTreeMap<&str, Lit> = BTreeMap::new();
        let names = |aig: &Aig| -> BTreeMap<String, ()> {
            aig.inputs().iter().map(|input| (input.name.clone(), ())).collect()
        };
        same("input", names(left).into_keys(), names(right).into_keys())?;
        let initial = |aig: &Aig| -> BTreeMap<String, bool> {
            aig.latches().iter().map(|latch| (latch.name.clone(), latch.initial)).collect()
        };
        let (left_initial, right_initial) = (initial(left), initial(right));
        same("latch", left_initial.keys().cloned(), right_initial.keys().cloned())?;
        if let Some((name, _)) = left_initial.iter().find(|(name, value)| right_initial[*name] != **value) {
            return Err(MiterError::Initial(name.clone()));
        }
        let outputs = |aig: &Aig| -> Vec<String> {
            let mut names: Vec<String> = aig.outputs.iter().map(|output| output.name.clone()).collect();
            names.sort();
            names
        };
        same("output", outputs(left).into_iter(), outputs(right).into_iter())?;
        for input in left.inputs() {
            sources.insert(&input.name, miter.aig.add_input(input.name.clone()));
        }
        let mut states: BTreeMap<&str, Lit> = BTreeMap::new();
        for latch in left.latches() {
            states.insert(&latch.name, miter.aig.add_input(latch.name.clone()));
        }
        let roots = [left, right].map(|side| miter.import(side, &sources, &states));
        for (name, lit) in &roots[0] {
            miter.pairs.push((*lit, roots[1][name]));
            miter.names.push(name.clone());
        }
        Ok(miter)
    }

    /// Copies a circuit, and returns its outputs and next states by name.
    fn import(
        &mut self,
        side: &Aig,
        inputs: &BTreeMap<&str, Lit>,
        states: &BTreeMap<&str, Lit>,
    ) -> BTreeMap<String, Lit> {
        let mut side = side.clone();
        let next: Vec<Lit> = (0..side.latches().len()).map(|latch| side.next_state(latch)).collect();
        let source = |node: &Node| match node {
            Node::Input(i) => inputs[side.inputs()[*i as usize].name.as_str()],
            Node::Latch(l) => states[side.latches()[*l as usize].name.as_str()],
            _ => Lit::FALSE,
        };
        let map = copy(&side, &mut self.aig, |node| source(&node));
        let through = |lit: Lit| map[lit.node()].complement_if(lit.is_complemented());
        let outputs =
            side.outputs.iter().map(|output| (format!("output {}", output.name), through(output.lit)));
        let latches = side.latches().iter().zip(&next);
        let states = latches.map(|(latch, &next)| (format!("next {}", latch.name), through(next)));
        outputs.chain(states).collect()
    }

    /// Proves that all pairs are equal.
    #[must_use]
    pub fn prove(&self, limits: Limits) -> Proof {
        prove(&self.aig, &self.pairs, limits)
    }
}

/// Copies the logic of one graph into another, in one region. `source` gives the literal of each source. Returns the
/// literal of each node.
pub fn copy(from: &Aig, to: &mut Aig, source: impl Fn(Node) -> Lit) -> Vec<Lit> {
    let mut map: Vec<Lit> = Vec::with_capacity(from.nodes().len());
    for &node in from.nodes() {
        let lit = match node {
            Node::False => Lit::FALSE,
            Node::And(a, b) => {
                let [a, b] = [a, b].map(|lit: Lit| map[lit.node()].complement_if(lit.is_complemented()));
                to.and(a, b)
            }
            source_node => source(source_node),
        };
        map.push(lit);
    }
    map
}

fn same(
    what: &'static str,
    left: impl Iterator<Item = String>,
    right: impl Iterator<Item = String>,
) -> Result<(), MiterError> {
    let (left, right): (Vec<String>, Vec<String>) = (left.collect(), right.collect());
    let alone = |these: &[String], those: &[String]| {
        these.iter().find(|name| those.binary_search(name).is_err()).cloned()
    };
    match alone(&left, &right).or_else(|| alone(&right, &left)) {
        Some(name) => Err(MiterError::Unmatched { what, name }),
        None => Ok(()),
    }
}
