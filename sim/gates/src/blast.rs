//! From the word graph to gates.

use netlist::module::MULTIPLIER_KINDS;
use netlist::{BinaryOp, Design, Flat, FlatNode, NodeId, Op, ScopeId, UnaryOp};

use super::aig::{Aig, Lit, Origin};
use super::multiply;
use super::words::{self, Adder, Selection, Structures};

/// A kind of module that is left out: its result becomes inputs, and its operands `a_i` and `b_i` become outputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cut {
    /// Kind of the module in the source.
    pub kind: &'static str,
    /// Its result port.
    pub result: &'static str,
}

/// The multiplier arrays, which a proof cannot look into.
pub const ARRAYS: &[Cut] = &[Cut { kind: MULTIPLIER_KINDS[0], result: "product_o" }];
/// The adders and multipliers of a pipeline; the rest is its control.
pub const ARITHMETIC: &[Cut] =
    &[Cut { kind: "fp_add", result: "result_o" }, Cut { kind: "fp_mul", result: "result_o" }];

/// How a design becomes gates.
#[derive(Clone, Copy, Debug, Default)]
pub struct Options {
    /// Structures of arithmetic.
    pub structures: Structures,
    /// Modules that are left out.
    pub cuts: &'static [Cut],
    /// Whether each execution unit is a region of its own, so that its gates can be told from those around it.
    pub keep_units: bool,
}

/// Narrowest words for which a choice gets conditions of its own.
const LEAST_CHOICE_WIDTH: u32 = 8;

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

/// Kinds of module that are execution units.
pub const UNIT_KINDS: &[&str] = &["fp_add", "fp_mul", "fp_min_max", "fp_cmp", "int_add"];

/// The kind of execution unit that each instance of a flattened netlist is or is part of.
#[must_use]
pub fn unit_scopes(design: &Design, flat: &Flat) -> Vec<Option<(ScopeId, &'static str)>> {
    let mut units: Vec<Option<(ScopeId, &'static str)>> = Vec::with_capacity(flat.scopes.len());
    for (id, scope) in flat.scopes.iter().enumerate() {
        let inherited = scope.parent.and_then(|parent| units[parent as usize]);
        let kind = &design.module(scope.module).kind;
        let own = UNIT_KINDS.iter().find(|unit| *unit == kind).map(|unit| (id as ScopeId, *unit));
        units.push(inherited.or(own));
    }
    units
}

/// Turns a flattened netlist into gates.
#[must_use]
pub fn blast(design: &Design, flat: &Flat, options: Options) -> Blasted {
    Blaster::new(design, flat, options).run()
}

/// A result that is made otherwise than by the operations in the graph.
#[derive(Clone, Copy)]
struct Product {
    operands: [NodeId; 2],
    scope: ScopeId,
    result: &'static str,
}

struct Blaster<'n> {
    flat: &'n Flat,
    options: Options,
    /// Region of each instance.
    regions: Vec<u32>,
    /// Multiplexers that are used once only, as a word among which another multiplexer chooses.
    is_inside_choice: Vec<bool>,
    /// For a node that carries the result of a module that is cut or an array: the operands' nodes and the instance.
    products: Vec<Option<Product>>,
    blasted: Blasted,
}

impl<'n> Blaster<'n> {
    fn new(design: &Design, flat: &'n Flat, options: Options) -> Self {
        let units = unit_scopes(design, flat);
        let region = |unit: &Option<(ScopeId, &'static str)>| match unit {
            Some((scope, _)) if options.keep_units => scope + 1,
            _ => 0,
        };
        let mut products = vec![None; flat.nodes.len()];
        for &cut in options.cuts {
            find_products(design, flat, cut, &mut products);
        }
        let blasted = Blasted {
            aig: Aig::default(),
            inputs: Vec::new(),
            outputs: Vec::new(),
            words: vec![Vec::new(); flat.nodes.len()],
            first_latch: Vec::new(),
            cuts: Vec::new(),
        };
        let mut uses = vec![0; flat.nodes.len()];
        let operands = flat.nodes.iter().flat_map(|node| node.op.operands());
        let roots = flat.outputs.iter().map(|(_, node)| *node);
        let states =
            flat.registers.iter().flat_map(|register| std::iter::once(register.data).chain(register.enable));
        operands.chain(roots).chain(states).for_each(|node: NodeId| uses[node.index()] += 1);
        let mut is_inside_choice = vec![false; flat.nodes.len()];
        for node in &flat.nodes {
            let Op::Mux { when_true, when_false, .. } = node.op else { continue };
            if options.structures.selection == Selection::Chain || node.width < LEAST_CHOICE_WIDTH {
                continue;
            }
            for word in [when_true, when_false].map(NodeId::index) {
                is_inside_choice[word] = uses[word] == 1
                    && flat.nodes[word].scope == node.scope
                    && matches!(flat.nodes[word].op, Op::Mux { .. });
            }
        }
        let regions = units.iter().map(region).collect();
        Self { flat, options, regions, is_inside_choice, products, blasted }
    }

    fn run(mut self) -> Blasted {
        let flat = self.flat;
        for port in &flat.inputs {
            let bits =
                (0..port.width).map(|bit| self.blasted.aig.add_input(bit_name(&port.name, bit, port.width)));
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
                let bit_lit =
                    aig.add_latch(bit_name(&name, bit, register.width), register.initial >> bit & 1 == 1);
                self.blasted.words[register.output.index()].push(bit_lit);
            }
        }
        let needed = self.needed();
        let mut cuts = Vec::new();
        for (position, node) in flat.nodes.iter().enumerate() {
            if !needed[position] {
                continue;
            }
            self.blasted.aig.origin = self.origin_of(node.scope);
            let word = match (self.products[position], node.op) {
                (Some(product), _) => self.product(node.width, product, &mut cuts),
                (None, Op::Register(_)) => continue,
                // Part of a longer choice, which is made where the choice ends.
                (None, Op::Mux { .. }) if self.is_inside_choice[position] => continue,
                (None, Op::Mux { .. }) => self.choice(position),
                (None, _) => self.node(node),
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
                self.blasted.aig.add_output(bit_name(&port.name, bit, port.width), lit);
            }
            self.blasted.outputs.push(word);
        }
        // If the result is a register, its operands come later than it.
        for product in cuts {
            let path = self.flat.scopes[product.scope as usize].path.clone();
            for (name, operand) in [("a_i", product.operands[0]), ("b_i", product.operands[1])] {
                let word = self.blasted.words[operand.index()].clone();
                for (bit, &lit) in (0..).zip(&word) {
                    let name = bit_name(&format!("{path}.{name}"), bit, word.len() as u32);
                    self.blasted.aig.add_output(name, lit);
                }
            }
            self.blasted.cuts.push(path);
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
                Some(product) => product.operands.iter().for_each(|node| needed[node.index()] = true),
                None => {
                    self.flat.nodes[position].op.operands().for_each(|node| needed[node.index()] = true);
                }
            }
        }
        needed
    }

    fn product(&mut self, width: u32, product: Product, cuts: &mut Vec<Product>) -> Vec<Lit> {
        let aig = &mut self.blasted.aig;
        cuts.push(product);
        let path = &self.flat.scopes[product.scope as usize].path;
        (0..width)
            .map(|bit| aig.add_input(bit_name(&format!("{path}.{}", product.result), bit, width)))
            .collect()
    }

    /// A multiplexer with those that serve it alone.
    fn choice(&mut self, position: usize) -> Vec<Lit> {
        let Op::Mux { select, when_true, when_false } = self.flat.nodes[position].op else {
            unreachable!("a choice")
        };
        if ![when_true, when_false].iter().any(|word| self.is_inside_choice[word.index()]) {
            let Blasted { aig, words, .. } = &mut self.blasted;
            let word = |id: NodeId| words[id.index()].as_slice();
            return words::mux(aig, word(select)[0], word(when_true), word(when_false));
        }
        let mut choices = Vec::new();
        self.gather(position, Lit::TRUE, &mut choices);
        let Blasted { aig, words, .. } = &mut self.blasted;
        let choices: Vec<(Lit, &[Lit])> =
            choices.iter().map(|&(condition, word)| (condition, words[word.index()].as_slice())).collect();
        let group = if self.options.structures.selection == Selection::AndOrThrees { 3 } else { 2 };
        words::select_one(aig, &choices, group)
    }

    /// The words that a multiplexer chooses among if `reached`, each with its condition, of which one holds.
    fn gather(&mut self, position: usize, reached: Lit, choices: &mut Vec<(Lit, NodeId)>) {
        let Op::Mux { select, when_true, when_false } = self.flat.nodes[position].op else {
            unreachable!("a choice")
        };
        let select = self.blasted.words[select.index()][0];
        for (select, word) in [(select, when_true), (!select, when_false)] {
            let condition = self.blasted.aig.and(reached, select);
            if self.is_inside_choice[word.index()] {
                self.gather(word.index(), condition, choices);
            } else {
                choices.push((condition, word));
            }
        }
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
            Op::Mux { .. } => unreachable!("choices are made whole"),
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
        BinaryOp::Mul => multiply::product(aig, structures, a, b, width),
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

/// Notes the results of a kind of module, by node.
fn find_products(design: &Design, flat: &Flat, cut: Cut, products: &mut [Option<Product>]) {
    for (scope, instance) in (0..).zip(&flat.scopes) {
        if design.module(instance.module).kind != cut.kind {
            continue;
        }
        let port = |wanted: &str| {
            let mut names = flat.names.iter();
            names.find(|name| name.scope == scope && name.name == wanted).map(|name| name.node)
        };
        // A module with an operand or result that is constant is left as written.
        if let (Some(a), Some(b), Some(result)) = (port("a_i"), port("b_i"), port(cut.result)) {
            products[result.index()] = Some(Product { operands: [a, b], scope, result: cut.result });
        }
    }
}

/// Name of one bit of a word of `width` bits.
#[must_use]
pub fn bit_name(word: &str, bit: u32, width: u32) -> String {
    if width == 1 { word.to_owned() } else { format!("{word}[{bit}]") }
}
