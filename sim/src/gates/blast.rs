//! From the word graph to gates.

use hdl::catalogue::MULTIPLIER_KINDS;
use hdl::netlist::{BinaryOp, Design, Flat, FlatNode, NodeId, Op, ScopeId, UnaryOp};

use super::aig::{Aig, Lit, Origin};
use super::words::{self, Adder, Structures};
use crate::unit_costs::Unit;

/// What the multiplier arrays of a design become.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Arrays {
    /// One product each, of the whole operands.
    #[default]
    Whole,
    /// The operations as written: four products of half words and their sums.
    AsWritten,
    /// Inputs in the place of their product, and outputs that show their operands.
    Cut,
}

/// How a design becomes gates.
#[derive(Clone, Copy, Debug, Default)]
pub struct Options {
    /// Structures of arithmetic.
    pub structures: Structures,
    /// The multiplier arrays.
    pub arrays: Arrays,
    /// Whether each execution unit is a region of its own, so that its gates can be told from those around it.
    pub keep_units: bool,
}

/// A flattened netlist as gates.
#[derive(Clone, Debug)]
pub struct Blasted {
    /// The gates. Inputs, outputs and latches have the order of the netlist's, bit by bit; inputs and outputs of arrays
    /// that were cut come behind.
    pub aig: Aig,
    /// Bits of each input.
    pub inputs: Vec<Vec<Lit>>,
    /// Bits of each output.
    pub outputs: Vec<Vec<Lit>>,
    /// Bits of each node, for those that the outputs and registers need.
    pub words: Vec<Vec<Lit>>,
    /// The first latch of each register.
    pub first_latch: Vec<usize>,
    /// Path of each array that was cut, in order.
    pub cuts: Vec<String>,
}

/// The execution unit that each instance of a flattened netlist is or is part of.
#[must_use]
pub fn unit_scopes(design: &Design, flat: &Flat) -> Vec<Option<(ScopeId, Unit)>> {
    let mut units: Vec<Option<(ScopeId, Unit)>> = Vec::with_capacity(flat.scopes.len());
    for (id, scope) in flat.scopes.iter().enumerate() {
        let inherited = scope.parent.and_then(|parent| units[parent as usize]);
        let own = Unit::of_module(&design.module(scope.module).kind).map(|unit| (id as ScopeId, unit));
        units.push(inherited.or(own));
    }
    units
}

/// Turns a flattened netlist into gates.
#[must_use]
pub fn blast(design: &Design, flat: &Flat, options: Options) -> Blasted {
    Blaster::new(design, flat, options).run()
}

struct Blaster<'n> {
    flat: &'n Flat,
    options: Options,
    /// Region of each instance.
    regions: Vec<u32>,
    /// For a node that carries the product of a multiplier array: the operands' nodes, and the array.
    products: Vec<Option<([NodeId; 2], ScopeId)>>,
    blasted: Blasted,
}

impl<'n> Blaster<'n> {
    fn new(design: &Design, flat: &'n Flat, options: Options) -> Self {
        let units = unit_scopes(design, flat);
        let region = |unit: &Option<(ScopeId, Unit)>| match unit {
            Some((scope, _)) if options.keep_units => scope + 1,
            _ => 0,
        };
        let products = if options.arrays == Arrays::AsWritten {
            vec![None; flat.nodes.len()]
        } else {
            products(design, flat)
        };
        let blasted = Blasted {
            aig: Aig::default(),
            inputs: Vec::new(),
            outputs: Vec::new(),
            words: vec![Vec::new(); flat.nodes.len()],
            first_latch: Vec::new(),
            cuts: Vec::new(),
        };
        Self { flat, options, regions: units.iter().map(region).collect(), products, blasted }
    }

    fn run(mut self) -> Blasted {
        let flat = self.flat;
        for port in &flat.inputs {
            let bits = (0..port.width).map(|bit| self.blasted.aig.add_input(bit_name(&port.name, bit)));
            let bits = bits.collect();
            self.blasted.inputs.push(bits);
        }
        for register in &flat.registers {
            self.blasted.aig.origin = self.origin_of(register.scope);
            let aig = &mut self.blasted.aig;
            self.blasted.first_latch.push(aig.latches().len());
            let path = &flat.scopes[register.scope as usize].path;
            let name =
                if path.is_empty() { register.name.clone() } else { format!("{path}.{}", register.name) };
            for bit in 0..register.width {
                let bit_lit = aig.add_latch(bit_name(&name, bit), register.initial >> bit & 1 == 1);
                self.blasted.words[register.output.index()].push(bit_lit);
            }
        }
        let needed = self.needed();
        let mut cut_operands = Vec::new();
        for (position, node) in flat.nodes.iter().enumerate() {
            if !needed[position] || matches!(node.op, Op::Register(_)) {
                continue;
            }
            self.blasted.aig.origin = self.origin_of(node.scope);
            let word = match self.products[position] {
                Some((operands, scope)) => {
                    let words = operands.map(|operand| self.blasted.words[operand.index()].clone());
                    self.product(node.width, words, scope, &mut cut_operands)
                }
                None => self.node(node),
            };
            self.blasted.words[position] = word;
        }
        let mut drives = Vec::new();
        for (register, &first) in flat.registers.iter().zip(&self.blasted.first_latch) {
            let enable = register.enable.map_or(Lit::TRUE, |enable| self.blasted.words[enable.index()][0]);
            let data = &self.blasted.words[register.data.index()];
            drives.extend(data.iter().enumerate().map(|(bit, &data)| (first + bit, data, enable)));
        }
        for (latch, data, enable) in drives {
            self.blasted.aig.drive_latch(latch, data, enable);
        }
        for (port, node) in &flat.outputs {
            let word = self.blasted.words[node.index()].clone();
            for (bit, &lit) in (0..).zip(&word) {
                self.blasted.aig.add_output(bit_name(&port.name, bit), lit);
            }
            self.blasted.outputs.push(word);
        }
        for (name, lit) in cut_operands {
            self.blasted.aig.add_output(name, lit);
        }
        self.blasted
    }

    fn origin_of(&self, scope: ScopeId) -> Origin {
        Origin { scope, region: self.regions[scope as usize] }
    }

    /// Nodes that outputs and registers need, with arrays taken as one operation.
    fn needed(&self) -> Vec<bool> {
        let mut needed = vec![false; self.flat.nodes.len()];
        self.flat.outputs.iter().for_each(|(_, node)| needed[node.index()] = true);
        for register in &self.flat.registers {
            needed[register.data.index()] = true;
            register.enable.iter().for_each(|enable| needed[enable.index()] = true);
        }
        for position in (0..self.flat.nodes.len()).rev() {
            if !needed[position] {
                continue;
            }
            match self.products[position] {
                Some((operands, _)) => operands.iter().for_each(|node| needed[node.index()] = true),
                None => {
                    self.flat.nodes[position].op.operands().for_each(|node| needed[node.index()] = true);
                }
            }
        }
        needed
    }

    fn product(
        &mut self,
        width: u32,
        [a, b]: [Vec<Lit>; 2],
        scope: ScopeId,
        cut_operands: &mut Vec<(String, Lit)>,
    ) -> Vec<Lit> {
        let aig = &mut self.blasted.aig;
        if self.options.arrays == Arrays::Whole {
            return words::multiply(aig, self.options.structures, &a, &b, width as usize);
        }
        let path = &self.flat.scopes[scope as usize].path;
        self.blasted.cuts.push(path.clone());
        for (name, word) in [("a_i", a), ("b_i", b)] {
            let bits = (0..).zip(word);
            cut_operands.extend(bits.map(|(bit, lit)| (bit_name(&format!("{path}.{name}"), bit), lit)));
        }
        (0..width).map(|bit| aig.add_input(bit_name(&format!("{path}.product_o"), bit))).collect()
    }

    fn node(&mut self, node: &FlatNode) -> Vec<Lit> {
        let Blasted { aig, words, inputs, .. } = &mut self.blasted;
        let word = |id: NodeId| words[id.index()].as_slice();
        let structures = self.options.structures;
        let width = node.width as usize;
        match node.op {
            Op::Constant(value) => words::constant(value, node.width),
            Op::Input(input) => inputs[input as usize].clone(),
            Op::Register(_) | Op::Instance { .. } => {
                unreachable!("registers have words, a flat netlist no instances")
            }
            Op::Unary(op, a) => {
                let a = word(a);
                match op {
                    UnaryOp::Not => words::not(a),
                    UnaryOp::Negate => {
                        words::subtract(aig, structures.adder, &words::constant(0, node.width), a)
                    }
                    UnaryOp::ReduceAnd => vec![words::all(aig, a)],
                    UnaryOp::ReduceOr => vec![words::any(aig, a)],
                    UnaryOp::ReduceXor => vec![words::reduce(aig, a, Lit::FALSE, Aig::xor)],
                }
            }
            Op::Binary(op, a, b) => binary(aig, structures, op, word(a), word(b), width),
            Op::Mux { select, when_true, when_false } => {
                words::mux(aig, word(select)[0], word(when_true), word(when_false))
            }
            Op::Slice { of, low } => word(of)[low as usize..low as usize + width].to_vec(),
            Op::Concat { high, low } => [word(low), word(high)].concat(),
            Op::Extend { of, signed } => {
                let of = word(of);
                let fill = if signed { of[of.len() - 1] } else { Lit::FALSE };
                of.iter().copied().chain(std::iter::repeat(fill)).take(width).collect()
            }
        }
    }
}

fn binary(
    aig: &mut Aig,
    structures: Structures,
    op: BinaryOp,
    a: &[Lit],
    b: &[Lit],
    width: usize,
) -> Vec<Lit> {
    let Structures { adder, .. } = structures;
    match op {
        BinaryOp::And => words::zip(aig, a, b, Aig::and),
        BinaryOp::Or => words::zip(aig, a, b, Aig::or),
        BinaryOp::Xor => words::zip(aig, a, b, Aig::xor),
        BinaryOp::Add => sum(aig, adder, a, b),
        BinaryOp::Sub => words::subtract(aig, adder, a, b),
        BinaryOp::Mul => words::multiply(aig, structures, a, b, width),
        BinaryOp::Eq => vec![words::equal(aig, a, b)],
        BinaryOp::Ne => vec![!words::equal(aig, a, b)],
        BinaryOp::Lt => vec![words::less(aig, a, b)],
        BinaryOp::Le => vec![!words::less(aig, b, a)],
        BinaryOp::SignedLt => vec![words::less(aig, &words::bias(a), &words::bias(b))],
        BinaryOp::SignedLe => vec![!words::less(aig, &words::bias(b), &words::bias(a))],
        BinaryOp::Shl => words::shift(aig, a, b, true),
        BinaryOp::Shr => words::shift(aig, a, b, false),
    }
}

/// A sum; an operand of one bit or less becomes the carry in.
fn sum(aig: &mut Aig, adder: Adder, a: &[Lit], b: &[Lit]) -> Vec<Lit> {
    let is_carry = |word: &[Lit]| word[1..].iter().all(|&bit| bit == Lit::FALSE);
    let zero = vec![Lit::FALSE; a.len()];
    match (is_carry(a), is_carry(b)) {
        (_, true) => words::add(aig, adder, a, &zero, b[0]).0,
        (true, false) => words::add(aig, adder, b, &zero, a[0]).0,
        _ => words::add(aig, adder, a, b, Lit::FALSE).0,
    }
}

/// The multiplier arrays' products, by node.
fn products(design: &Design, flat: &Flat) -> Vec<Option<([NodeId; 2], ScopeId)>> {
    let mut products = vec![None; flat.nodes.len()];
    for (scope, instance) in (0..).zip(&flat.scopes) {
        let module = design.module(instance.module);
        if !MULTIPLIER_KINDS.contains(&module.kind.as_str()) {
            continue;
        }
        let port = |wanted: &str| {
            let mut names = flat.names.iter();
            names.find(|name| name.scope == scope && name.name == wanted).map(|name| name.node)
        };
        // An array with an operand or product that is constant is left as written.
        if let (Some(a), Some(b), Some(product)) = (port("a_i"), port("b_i"), port("product_o")) {
            products[product.index()] = Some(([a, b], scope));
        }
    }
    products
}

/// Name of one bit of a word.
#[must_use]
pub fn bit_name(word: &str, bit: u32) -> String {
    format!("{word}[{bit}]")
}
