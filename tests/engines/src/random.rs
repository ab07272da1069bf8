//! Random designs: every operation at every kind of width, registers with and without enables, instances of modules
//! whose outputs come from registers and of others.
//!
//! The build script also uses this module: it compiles some of the designs for the tests.

use base::split_mix::{hash, next};
use netlist::{
    BinaryOp, Design, Graph, Instance, Module, ModuleId, NodeId, Op, Port, Register, SignalType, UnaryOp,
    mask,
};

/// Widths around the sizes of lanes.
const WIDTHS: [u32; 18] = [1, 1, 1, 2, 3, 7, 8, 16, 24, 31, 32, 32, 33, 48, 63, 64, 65, 128];

/// Operations in a module.
const OPERATIONS: usize = 60;

/// The design of a seed, with words of at most `max_width` bits: modules that are used by later ones, the last the top.
pub fn design(seed: u64, max_width: u32) -> Design {
    let mut modules = Vec::new();
    for position in 0..4 {
        let name = if position == 3 { format!("random_{seed}") } else { format!("part_{position}") };
        let module =
            ModuleMaker::new(hash(seed ^ position << 32), max_width).module(name, &modules, position != 1);
        modules.push(module);
    }
    Design { modules }
}

/// A stream of random choices.
struct Dice(u64);

impl Dice {
    fn bits(&mut self) -> u64 {
        next(&mut self.0)
    }

    fn roll(&mut self, sides: usize) -> usize {
        (self.bits() >> 32) as usize % sides
    }

    fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[self.roll(from.len())]
    }

    fn value(&mut self, width: u32) -> u128 {
        let wide = u128::from(self.bits()) << 64 | u128::from(self.bits());
        let value = [0, 1, u128::MAX, 1 << (width - 1), wide >> self.roll(128), wide][self.roll(6)];
        value & mask(width)
    }
}

struct ModuleMaker {
    dice: Dice,
    max_width: u32,
    graph: Graph,
    nodes: Vec<NodeId>,
}

impl ModuleMaker {
    fn new(seed: u64, max_width: u32) -> Self {
        Self { dice: Dice(seed), max_width, graph: Graph::default(), nodes: Vec::new() }
    }

    fn width(&mut self) -> u32 {
        loop {
            let width = self.dice.pick(&WIDTHS);
            if width <= self.max_width {
                return width;
            }
        }
    }

    /// A node without simplification, so that the engines also compute what the constructors would fold away.
    fn add(&mut self, op: Op, width: u32) -> NodeId {
        let id = self.graph.intern(netlist::Node { op, width });
        self.nodes.push(id);
        id
    }

    fn any(&mut self) -> NodeId {
        let nodes = std::mem::take(&mut self.nodes);
        let id = self.dice.pick(&nodes);
        self.nodes = nodes;
        id
    }

    fn resized(&mut self, id: NodeId, width: u32) -> NodeId {
        let signed = self.dice.roll(2) == 0;
        match self.graph.width(id).cmp(&width) {
            std::cmp::Ordering::Equal => id,
            std::cmp::Ordering::Less => self.add(Op::Extend { of: id, signed }, width),
            std::cmp::Ordering::Greater => self.add(Op::Slice { of: id, low: 0 }, width),
        }
    }

    /// Some node, converted to a width.
    fn of_width(&mut self, width: u32) -> NodeId {
        let id = self.any();
        self.resized(id, width)
    }

    fn operation(&mut self) {
        use BinaryOp::{Add, And, Eq, Le, Lt, Mul, Ne, Or, Shl, Shr, SignedLe, SignedLt, Sub, Xor};
        let a = self.any();
        let width = self.graph.width(a);
        match self.dice.roll(13) {
            0 => {
                use UnaryOp::{Negate, Not, ReduceAnd, ReduceOr, ReduceXor};
                let op = self.dice.pick(&[Not, Negate, ReduceAnd, ReduceOr, ReduceXor, ReduceXor]);
                self.add(Op::Unary(op, a), if matches!(op, Not | Negate) { width } else { 1 });
            }
            1..=5 => {
                let op =
                    self.dice.pick(&[And, Or, Xor, Add, Sub, Add, Sub, Eq, Ne, Lt, Le, SignedLt, SignedLe]);
                let b = self.of_width(width);
                self.add(Op::Binary(op, a, b), if op.is_comparison() { 1 } else { width });
            }
            6 => {
                let (op, b) = (self.dice.pick(&[Shl, Shr]), self.any());
                self.add(Op::Binary(op, a, b), width);
            }
            // A shift that mostly stays inside the word.
            7 => {
                let amount = self.of_width(6.min(self.max_width));
                let op = self.dice.pick(&[Shl, Shr]);
                self.add(Op::Binary(op, a, amount), width);
            }
            8 => {
                let b = self.of_width(width);
                let result = (width + self.dice.roll(width as usize + 1) as u32).min(self.max_width);
                self.add(Op::Binary(Mul, a, b), result);
            }
            9 => {
                let (select, when_false) = (self.of_width(1), self.of_width(width));
                self.add(Op::Mux { select, when_true: a, when_false }, width);
            }
            10 => {
                let low = self.dice.roll(width as usize) as u32;
                let result = 1 + self.dice.roll((width - low) as usize) as u32;
                self.add(Op::Slice { of: a, low }, result);
            }
            11 => {
                let low = if self.dice.roll(2) == 0 { self.of_width(1) } else { self.any() };
                let result = width + self.graph.width(low);
                if result <= self.max_width {
                    self.add(Op::Concat { high: a, low }, result);
                }
            }
            _ => {
                let width = self.width();
                let value = self.dice.value(width);
                self.add(Op::Constant(value), width);
            }
        }
    }

    /// A module that may use earlier ones. A Moore machine's outputs come from its registers.
    fn module(mut self, name: String, earlier: &[Module], is_moore: bool) -> Module {
        let port = |name: String, width| Port { name, width, signal_type: SignalType::Bits };
        let inputs: Vec<Port> =
            (0..5).map(|i| port(format!("x{i}"), if i == 0 { 1 } else { self.width() })).collect();
        for (i, port) in (0..).zip(&inputs) {
            self.add(Op::Input(i), port.width);
        }
        let widths: Vec<u32> = (0..5).map(|_| self.width()).collect();
        let registers: Vec<NodeId> =
            (0..).zip(&widths).map(|(r, &width)| self.add(Op::Register(r), width)).collect();
        let mut instances = Vec::new();
        for operation in 0..OPERATIONS {
            self.operation();
            if operation % 20 == 10 && !earlier.is_empty() {
                let module = self.dice.roll(earlier.len());
                let used = &earlier[module];
                let inputs = used.inputs.iter().map(|port| self.of_width(port.width)).collect();
                let instance = instances.len() as u32;
                instances.push(Instance {
                    name: format!("i{instance}"),
                    module: ModuleId(module as u32),
                    inputs,
                });
                for (output, (port, _)) in (0..).zip(&used.outputs) {
                    self.add(Op::Instance { instance, output }, port.width);
                }
            }
        }
        let outputs = (0..10)
            .map(|i| {
                let node = if is_moore { registers[i % registers.len()] } else { self.any() };
                (port(format!("z{i}"), self.graph.width(node)), node)
            })
            .collect();
        let registers = (0..)
            .zip(&widths)
            .map(|(r, &width): (u32, _)| Register {
                name: format!("r{r}"),
                width,
                signal_type: SignalType::Bits,
                initial: self.dice.value(width),
                data: self.of_width(width),
                enable: (self.dice.roll(2) == 0).then(|| self.of_width(1)),
                has_reset: false,
            })
            .collect();
        Module {
            kind: if instances.is_empty() { "random".into() } else { "random_tree".into() },
            name,
            generics: String::new(),
            parameters: Vec::new(),
            clock: Some("clk".into()),
            inputs,
            outputs,
            graph: self.graph,
            registers,
            instances,
            names: Vec::new(),
        }
    }
}
