//! The and-inverter graph: two-input ANDs with complemented edges, structurally hashed.
//!
//! Every user of the graph relies on these invariants:
//! - node 0 is the constant false; a node's operands have smaller numbers than the node;
//! - no AND has a constant operand, or twice the same node, and no two ANDs of a [region](Origin) are alike.

use std::collections::HashMap;
use std::ops::Not;

/// A node or its complement.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Lit(u32);

impl Lit {
    /// The constant 0.
    pub const FALSE: Self = Self(0);
    /// The constant 1.
    pub const TRUE: Self = Self(1);

    /// The literal with AIGER's number: twice the node, plus one if complemented.
    #[must_use]
    pub const fn from_code(code: u32) -> Self {
        Self(code)
    }

    /// AIGER's number.
    #[must_use]
    pub const fn code(self) -> u32 {
        self.0
    }

    /// A node, complemented or not.
    #[must_use]
    pub const fn new(node: usize, complemented: bool) -> Self {
        Self((node as u32) << 1 | complemented as u32)
    }

    /// The node's number.
    #[must_use]
    pub const fn node(self) -> usize {
        (self.0 >> 1) as usize
    }

    /// Whether the node's value is inverted.
    #[must_use]
    pub const fn is_complemented(self) -> bool {
        self.0 & 1 == 1
    }

    /// The literal, inverted if `invert`.
    #[must_use]
    pub const fn complement_if(self, invert: bool) -> Self {
        Self(self.0 ^ invert as u32)
    }

    /// The constant of a truth value.
    #[must_use]
    pub const fn constant(value: bool) -> Self {
        Self(value as u32)
    }
}

impl Not for Lit {
    type Output = Self;

    fn not(self) -> Self {
        Self(self.0 ^ 1)
    }
}

/// What a node is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Node {
    /// The constant false; node 0 and no other.
    False,
    /// An input, by its position.
    Input(u32),
    /// The present value of a latch, by its position.
    Latch(u32),
    /// The conjunction of two literals.
    And(Lit, Lit),
}

/// Where a node comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Origin {
    /// The part of the design; for an elaborated netlist the instance.
    pub scope: u32,
    /// Nodes of different regions are never merged, nor covered by one cell.
    pub region: u32,
}

/// An input.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Input {
    /// Name of the bit.
    pub name: String,
    /// Its node.
    pub lit: Lit,
}

/// A D flip-flop of one bit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Latch {
    /// Name of the bit.
    pub name: String,
    /// The node of its present value.
    pub lit: Lit,
    /// The value taken at a clock edge if enabled.
    pub data: Lit,
    /// Clock enable; [`Lit::TRUE`] for a latch that takes a value at each edge.
    pub enable: Lit,
    /// Value at power-up.
    pub initial: bool,
    /// Where it comes from.
    pub origin: Origin,
}

/// An output.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Output {
    /// Name of the bit.
    pub name: String,
    /// What drives it.
    pub lit: Lit,
}

/// An and-inverter graph; see the module for its invariants.
#[derive(Clone, Debug)]
pub struct Aig {
    nodes: Vec<Node>,
    origins: Vec<Origin>,
    known: HashMap<(Lit, Lit, u32), u32>,
    /// The origin that new nodes get.
    pub origin: Origin,
    inputs: Vec<Input>,
    latches: Vec<Latch>,
    /// Outputs, in order.
    pub outputs: Vec<Output>,
}

impl Default for Aig {
    fn default() -> Self {
        Self {
            nodes: vec![Node::False],
            origins: vec![Origin::default()],
            known: HashMap::new(),
            origin: Origin::default(),
            inputs: Vec::new(),
            latches: Vec::new(),
            outputs: Vec::new(),
        }
    }
}

impl Aig {
    /// All nodes, operands before users.
    #[must_use]
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// Where a node comes from.
    #[must_use]
    pub fn origin_of(&self, node: usize) -> Origin {
        self.origins[node]
    }

    /// Inputs, in order.
    #[must_use]
    pub fn inputs(&self) -> &[Input] {
        &self.inputs
    }

    /// Latches, in order.
    #[must_use]
    pub fn latches(&self) -> &[Latch] {
        &self.latches
    }

    /// Number of AND nodes, dead ones included.
    #[must_use]
    pub fn and_count(&self) -> usize {
        self.nodes.len() - 1 - self.inputs.len() - self.latches.len()
    }

    /// The operands of an AND; none for other nodes.
    #[must_use]
    pub fn operands(&self, node: usize) -> Option<[Lit; 2]> {
        match self.nodes[node] {
            Node::And(a, b) => Some([a, b]),
            _ => None,
        }
    }

    fn push(&mut self, node: Node) -> Lit {
        self.nodes.push(node);
        self.origins.push(self.origin);
        Lit::new(self.nodes.len() - 1, false)
    }

    /// A further input.
    pub fn add_input(&mut self, name: impl Into<String>) -> Lit {
        let lit = self.push(Node::Input(self.inputs.len() as u32));
        self.inputs.push(Input { name: name.into(), lit });
        lit
    }

    /// A further latch, which holds its value until [`Aig::drive_latch`].
    pub fn add_latch(&mut self, name: impl Into<String>, initial: bool) -> Lit {
        let lit = self.push(Node::Latch(self.latches.len() as u32));
        let origin = self.origin;
        self.latches.push(Latch { name: name.into(), lit, data: lit, enable: Lit::TRUE, initial, origin });
        lit
    }

    /// Sets the data and the enable of a latch.
    pub fn drive_latch(&mut self, latch: usize, data: Lit, enable: Lit) {
        let latch = &mut self.latches[latch];
        (latch.data, latch.enable) = (data, enable);
    }

    /// Renames an input; `None` if there is no such.
    pub fn rename_input(&mut self, input: usize, name: &str) -> Option<()> {
        self.inputs.get_mut(input).map(|input| name.clone_into(&mut input.name))
    }

    /// Renames a latch; `None` if there is no such.
    pub fn rename_latch(&mut self, latch: usize, name: &str) -> Option<()> {
        self.latches.get_mut(latch).map(|latch| name.clone_into(&mut latch.name))
    }

    /// A further output.
    pub fn add_output(&mut self, name: impl Into<String>, lit: Lit) {
        self.outputs.push(Output { name: name.into(), lit });
    }

    /// `a & b`, folded where an operand is constant or both are of one node.
    pub fn and(&mut self, a: Lit, b: Lit) -> Lit {
        let (a, b) = if a <= b { (a, b) } else { (b, a) };
        if a == Lit::FALSE || a == !b {
            return Lit::FALSE;
        }
        if a == Lit::TRUE || a == b {
            return b;
        }
        if let Some(known) = self.known.get(&(a, b, self.origin.region)) {
            return Lit::new(*known as usize, false);
        }
        let lit = self.push(Node::And(a, b));
        self.known.insert((a, b, self.origin.region), lit.node() as u32);
        lit
    }

    /// `a | b`.
    pub fn or(&mut self, a: Lit, b: Lit) -> Lit {
        !self.and(!a, !b)
    }

    /// `a ^ b`, with complements moved to the output.
    pub fn xor(&mut self, a: Lit, b: Lit) -> Lit {
        let invert = a.is_complemented() ^ b.is_complemented();
        let (a, b) = (a.complement_if(a.is_complemented()), b.complement_if(b.is_complemented()));
        let both = self.and(a, b);
        let neither = self.and(!a, !b);
        self.and(!both, !neither).complement_if(invert)
    }

    /// `select ? when_true : when_false`.
    pub fn mux(&mut self, select: Lit, when_true: Lit, when_false: Lit) -> Lit {
        if when_true == when_false {
            return when_true;
        }
        if when_true == !when_false {
            return self.xor(select, when_false);
        }
        let taken = self.and(select, when_true);
        let other = self.and(!select, when_false);
        self.or(taken, other)
    }

    /// What latch `latch` holds after the next clock edge, the enable included.
    pub fn next_state(&mut self, latch: usize) -> Lit {
        let Latch { lit, data, enable, origin, .. } = self.latches[latch];
        self.origin = origin;
        self.mux(enable, data, lit)
    }

    /// Puts a multiplexer before every latch with an enable, and then enables the latch always: for libraries without
    /// clock gates.
    pub fn multiplex_enables(&mut self) {
        for latch in 0..self.latches.len() {
            let next = self.next_state(latch);
            self.drive_latch(latch, next, Lit::TRUE);
        }
    }

    /// The literals that something outside the ANDs reads: outputs, then data and enable of each latch.
    pub fn roots(&self) -> impl Iterator<Item = Lit> {
        let outputs = self.outputs.iter().map(|output| output.lit);
        outputs.chain(self.latches.iter().flat_map(|latch| [latch.data, latch.enable]))
    }

    /// Which nodes the [roots](Aig::roots) depend on, within a cycle.
    #[must_use]
    pub fn live(&self) -> Vec<bool> {
        self.cone(self.roots())
    }

    /// Which nodes some literals depend on, within a cycle.
    #[must_use]
    pub fn cone(&self, roots: impl IntoIterator<Item = Lit>) -> Vec<bool> {
        let mut live = vec![false; self.nodes.len()];
        roots.into_iter().for_each(|lit| live[lit.node()] = true);
        for node in (0..self.nodes.len()).rev() {
            if let (true, Node::And(a, b)) = (live[node], self.nodes[node]) {
                live[a.node()] = true;
                live[b.node()] = true;
            }
        }
        live
    }

    /// Longest chain of ANDs between sources and [roots](Aig::roots).
    #[must_use]
    pub fn depth(&self) -> u32 {
        let mut levels: Vec<u32> = Vec::with_capacity(self.nodes.len());
        for node in &self.nodes {
            levels.push(match *node {
                Node::And(a, b) => 1 + levels[a.node()].max(levels[b.node()]),
                _ => 0,
            });
        }
        self.roots().map(|lit| levels[lit.node()]).max().unwrap_or(0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constants_fold_and_equal_gates_are_one() {
        let mut aig = Aig::default();
        let (a, b) = (aig.add_input("a"), aig.add_input("b"));
        assert_eq!(aig.and(a, Lit::FALSE), Lit::FALSE);
        assert_eq!(aig.and(Lit::TRUE, a), a);
        assert_eq!(aig.and(a, a), a);
        assert_eq!(aig.and(a, !a), Lit::FALSE);
        assert_eq!(aig.and(a, b), aig.and(b, a));
        assert_eq!(aig.xor(a, b), !aig.xor(!a, b));
        assert_eq!(aig.mux(a, b, b), b);
        assert_eq!(aig.xor(a, a), Lit::FALSE);
        assert_eq!(aig.and_count(), 3);
        aig.origin.region = 1;
        assert_ne!(aig.and(a, b), Lit::new(3, false), "regions keep their own gates");
    }

    #[test]
    fn dead_nodes_are_not_live() {
        let mut aig = Aig::default();
        let (a, b) = (aig.add_input("a"), aig.add_input("b"));
        let used = aig.and(a, b);
        let dead = aig.and(a, !b);
        aig.add_output("y", !used);
        let live = aig.live();
        assert!(live[used.node()] && !live[dead.node()]);
        assert_eq!(aig.depth(), 1);
    }
}
