//! Random word graphs: simplification keeps values, and the Verilog computes what the interpreter computes.

use crate::support::stimulus;
use base::split_mix::hash;
use netlist::verilog::{PackageOptions, package};
use netlist::{
    BinaryOp, Design, Graph, Module, Node, NodeId, Op, Port, Register, SignalType, UnaryOp, evaluate,
};
use proptest::prelude::*;
use testing::tools::{available, run};

const WIDTHS: [u32; 14] = [1, 1, 2, 3, 7, 8, 9, 16, 31, 32, 33, 64, 65, 128];
const INPUTS: u32 = 6;
const REGISTERS: u32 = 3;

/// A stream of random numbers.
struct Dice(u64);

impl Dice {
    fn roll(&mut self, sides: usize) -> usize {
        self.0 = hash(self.0);
        (self.0 >> 32) as usize % sides
    }

    fn value(&mut self) -> u128 {
        let (high, low) = (hash(self.0 ^ 1), hash(self.0 ^ 2));
        self.roll(2);
        [0, 1, u128::MAX, u128::from(high) << 64 | u128::from(low)][self.roll(4)]
    }
}

/// The same operations in a plain graph and in one made by the simplifying constructors.
struct Pair {
    plain: Graph,
    simplified: Graph,
    nodes: Vec<(NodeId, NodeId)>,
}

impl Pair {
    fn random(seed: u64, operations: usize) -> Self {
        let mut dice = Dice(seed);
        let mut pair = Self { plain: Graph::default(), simplified: Graph::default(), nodes: Vec::new() };
        for i in 0..INPUTS {
            pair.add(Op::Input(i), input_width(seed, i), |op, _| op);
        }
        for r in 0..REGISTERS {
            pair.add(Op::Register(r), register_width(seed, r), |op, _| op);
        }
        for _ in 0..operations {
            pair.operation(&mut dice);
        }
        pair
    }

    /// Adds a node; its operands are given as positions in `nodes`.
    fn add(&mut self, op: Op, width: u32, bind: impl Fn(Op, &dyn Fn(NodeId) -> NodeId) -> Op) -> usize {
        let plain = bind(op, &|id| self.nodes[id.index()].0);
        let simplified = bind(op, &|id| self.nodes[id.index()].1);
        let ids = (self.plain.intern(Node { op: plain, width }), self.simplified.build(simplified, width));
        self.nodes.push(ids);
        self.nodes.len() - 1
    }

    fn bound(&mut self, op: Op, width: u32) -> usize {
        self.add(op, width, |op, map| op.map_operands(map))
    }

    fn width(&self, position: usize) -> u32 {
        self.plain.width(self.nodes[position].0)
    }

    fn resized(&mut self, position: usize, width: u32, signed: bool) -> usize {
        let (of, from) = (NodeId(position as u32), self.width(position));
        match from.cmp(&width) {
            std::cmp::Ordering::Equal => position,
            std::cmp::Ordering::Less => self.bound(Op::Extend { of, signed }, width),
            std::cmp::Ordering::Greater => self.bound(Op::Slice { of, low: 0 }, width),
        }
    }

    fn operation(&mut self, dice: &mut Dice) {
        let a = dice.roll(self.nodes.len());
        let width = self.width(a);
        let id = |position: usize| NodeId(position as u32);
        match dice.roll(12) {
            0 => {
                let ops = [
                    UnaryOp::Not,
                    UnaryOp::Negate,
                    UnaryOp::ReduceAnd,
                    UnaryOp::ReduceOr,
                    UnaryOp::ReduceXor,
                ];
                let op = ops[dice.roll(5)];
                let result = if matches!(op, UnaryOp::Not | UnaryOp::Negate) { width } else { 1 };
                self.bound(Op::Unary(op, id(a)), result);
            }
            1..=5 => {
                use BinaryOp::*;
                let ops = [And, Or, Xor, Add, Sub, Eq, Ne, Lt, Le, SignedLt, SignedLe];
                let op = ops[dice.roll(ops.len())];
                let b = dice.roll(self.nodes.len());
                let b = self.resized(b, width, dice.roll(2) == 0);
                self.bound(Op::Binary(op, id(a), id(b)), if op.is_comparison() { 1 } else { width });
            }
            6 => {
                let b = dice.roll(self.nodes.len());
                let op = [BinaryOp::Shl, BinaryOp::Shr][dice.roll(2)];
                self.bound(Op::Binary(op, id(a), id(b)), width);
            }
            7 if width <= 64 => {
                let b = dice.roll(self.nodes.len());
                let b = self.resized(b, width, false);
                self.bound(Op::Binary(BinaryOp::Mul, id(a), id(b)), 2 * width);
            }
            8 => {
                let (s, b) = (dice.roll(self.nodes.len()), dice.roll(self.nodes.len()));
                let (select, b) = (self.resized(s, 1, false), self.resized(b, width, false));
                let op = Op::Mux { select: id(select), when_true: id(a), when_false: id(b) };
                self.bound(op, width);
            }
            9 => {
                let low = dice.roll(width as usize) as u32;
                let result = 1 + dice.roll((width - low) as usize) as u32;
                self.bound(Op::Slice { of: id(a), low }, result);
            }
            10 => {
                let b = dice.roll(self.nodes.len());
                if width + self.width(b) <= 128 {
                    self.bound(Op::Concat { high: id(a), low: id(b) }, width + self.width(b));
                }
            }
            _ => {
                let width = WIDTHS[dice.roll(WIDTHS.len())];
                let value = dice.value() & netlist::mask(width);
                self.bound(Op::Constant(value), width);
            }
        }
    }
}

fn input_width(seed: u64, input: u32) -> u32 {
    WIDTHS[Dice(seed ^ u64::from(input) << 8).roll(WIDTHS.len())]
}

fn register_width(seed: u64, register: u32) -> u32 {
    WIDTHS[Dice(seed ^ u64::from(register) << 16 ^ 7).roll(WIDTHS.len())]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, ..ProptestConfig::default() })]

    #[test]
    fn simplification_keeps_every_value(seed: u64, operations in 1usize..60) {
        let pair = Pair::random(seed, operations);
        for vector in 0..16 {
            let value = |op: Op, width| match op {
                Op::Input(i) => stimulus(vector ^ seed, i as usize, width),
                Op::Register(r) => stimulus(vector ^ seed, 100 + r as usize, width),
                _ => 0,
            };
            let plain = evaluate(&pair.plain, value);
            let simplified = evaluate(&pair.simplified, value);
            for &(p, s) in &pair.nodes {
                prop_assert_eq!(plain[p.index()], simplified[s.index()], "{:?}", pair.plain.node(p));
            }
        }
    }
}

/// A design of one module: the nodes of a random graph as outputs, registers fed from it.
fn random_design(seed: u64) -> Design {
    let pair = Pair::random(seed, 60);
    let mut dice = Dice(!seed);
    let mut graph = pair.simplified;
    let port = |name: String, width| Port { name, width, signal_type: SignalType::Bits };
    let pick = |dice: &mut Dice| pair.nodes[dice.roll(pair.nodes.len())].1;
    let outputs = (pair.nodes.iter().rev().take(25).enumerate())
        .map(|(i, &(_, node))| (port(format!("z{i}"), graph.width(node)), node))
        .collect();
    let registers = (0..REGISTERS)
        .map(|r| {
            let width = register_width(seed, r);
            let (data, enable) = (pick(&mut dice), pick(&mut dice));
            let enable = graph.resize(enable, 1, false);
            Register {
                name: format!("r{r}"),
                width,
                signal_type: SignalType::Bits,
                has_reset: false,
                initial: dice.value() & netlist::mask(width),
                data: graph.resize(data, width, false),
                enable: (dice.roll(2) == 0).then_some(enable),
            }
        })
        .collect();
    let module = Module {
        name: "random".into(),
        kind: "random".into(),
        generics: String::new(),
        parameters: Vec::new(),
        clock: Some("clk".into()),
        inputs: (0..INPUTS).map(|i| port(format!("x{i}"), input_width(seed, i))).collect(),
        outputs,
        graph,
        registers,
        instances: Vec::new(),
        names: Vec::new(),
    };
    Design { modules: vec![module] }
}

#[test]
fn verilog_of_random_designs_simulates_like_the_interpreter() {
    if !available("iverilog") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    for seed in 0..40 {
        let design = random_design(seed);
        let inputs = &design.top().inputs;
        let stimulus: Vec<Vec<u128>> = (0..200)
            .map(|cycle| inputs.iter().enumerate().map(|(i, p)| stimulus(cycle, i, p.width)).collect())
            .collect();
        let options = PackageOptions::default();
        for file in package(&design, &options, &stimulus).unwrap() {
            std::fs::write(folder.path().join(file.name), file.contents).unwrap();
        }
        run(folder.path(), "iverilog", &["-g2012", "-o", "simulation", "random_tb.v", "random.v"])
            .unwrap_or_else(|error| panic!("seed {seed}: {error}\n{}", netlist::verilog::text(&design)));
        let printed = run(folder.path(), "vvp", &["-n", "simulation"]).unwrap();
        assert!(printed.contains("PASS: random, 200 vectors"), "seed {seed}: {printed}");
        if seed < 10 && available("verilator") {
            let lint = run(folder.path(), "verilator", &["--lint-only", "-Wall", "random.v"]);
            assert_eq!(lint.as_deref(), Ok(""), "seed {seed}");
        }
    }
}
