//! Turns a flattened netlist into instructions on columns.

use super::columns::Columns;
use super::instruction::{Instruction, Operation, Place, Size};
use super::{Interpreter, Register};
use netlist::{BinaryOp, Flat, NodeId, Op, UnaryOp, mask};

/// The interpreter of a netlist, registers not yet at power-up.
pub fn compile(netlist: &Flat) -> Interpreter {
    let mut compiler = Compiler {
        netlist,
        code: Vec::new(),
        columns: Columns::default(),
        nodes: vec![None; netlist.nodes.len()],
    };
    let mut order: Vec<usize> = (0..netlist.nodes.len()).collect();
    let group = |position: &usize| {
        let node = &netlist.nodes[*position];
        (node.level, operation_group(node.op), Size::of(node.width), *position)
    };
    order.sort_by_key(group);
    for position in order {
        let place = compiler.node(position);
        compiler.nodes[position] = Some(place);
    }
    compiler.finish()
}

/// Nodes of the same group run one after the other.
fn operation_group(op: Op) -> (u8, Option<BinaryOp>) {
    match op {
        Op::Binary(op, ..) => (0, Some(op)),
        Op::Mux { .. } => (1, None),
        Op::Slice { .. } => (2, None),
        Op::Concat { .. } => (3, None),
        Op::Extend { .. } => (4, None),
        Op::Unary(..) => (5, None),
        _ => (6, None),
    }
}

struct Compiler<'n> {
    netlist: &'n Flat,
    code: Vec<Instruction>,
    columns: Columns,
    nodes: Vec<Option<Place>>,
}

impl Compiler<'_> {
    fn finish(mut self) -> Interpreter {
        let nodes: Vec<Place> =
            self.nodes.iter().map(|place| place.expect("every node has a column")).collect();
        // An input that nothing reads has no node, but can be driven.
        let mut inputs: Vec<Option<Place>> = vec![None; self.netlist.inputs.len()];
        for (node, &place) in self.netlist.nodes.iter().zip(&nodes) {
            if let Op::Input(input) = node.op {
                inputs[input as usize] = Some(place);
            }
        }
        let inputs = inputs.into_iter().zip(&self.netlist.inputs).map(|(place, port)| {
            (place.unwrap_or_else(|| self.columns.add(Size::of(port.width))), port.width)
        });
        let inputs = inputs.collect();
        let registers = self.netlist.registers.iter().map(|register| Register {
            present: nodes[register.output.index()],
            data: nodes[register.data.index()],
            enable: register.enable.map(|enable| nodes[enable.index()]),
            next: self.columns.add(Size::of(register.width)),
            initial: register.initial,
        });
        let registers = registers.collect();
        let outputs = self.netlist.outputs.iter().map(|(_, node)| nodes[node.index()]).collect();
        Interpreter { code: self.code, columns: self.columns, inputs, outputs, registers, nodes }
    }

    fn width(&self, id: NodeId) -> u32 {
        self.netlist.nodes[id.index()].width
    }

    fn place(&self, id: NodeId) -> Place {
        self.nodes[id.index()].expect("operands are on lower levels")
    }

    fn emit(
        &mut self,
        operation: Operation,
        size: Size,
        operands: [Place; 3],
        shift: u32,
        mask: u128,
    ) -> Place {
        let to = self.columns.add(size);
        let from = operands[0].size;
        let operands = operands.map(|operand| operand.at);
        self.code.push(Instruction { operation, from, to, operands, shift, mask });
        to
    }

    /// The value, converted to a size that holds it.
    fn in_size(&mut self, place: Place, size: Size) -> Place {
        if place.size == size { place } else { self.emit(Operation::Convert, size, [place; 3], 0, u128::MAX) }
    }

    fn constant(&mut self, size: Size, value: u128) -> Place {
        let place = self.columns.add(size);
        (0..super::LANES).for_each(|lane| self.columns.set(place, lane, value));
        place
    }

    /// The column of a node, with the instructions that fill it.
    fn node(&mut self, position: usize) -> Place {
        let node = self.netlist.nodes[position];
        let (size, all) = (Size::of(node.width), mask(node.width));
        match node.op {
            Op::Constant(value) => self.constant(size, value),
            Op::Input(_) | Op::Register(_) => self.columns.add(size),
            Op::Instance { .. } => unreachable!("a flattened netlist has no instances"),
            Op::Unary(op, a) => self.unary(op, a, node.width),
            Op::Binary(op, a, b) => self.binary(op, a, b, node.width),
            Op::Mux { select, when_true, when_false } => {
                let operands = [select, when_true, when_false].map(|id| self.place(id));
                self.emit(Operation::Select, size, operands, 0, 0)
            }
            Op::Slice { of, low } => self.emit(Operation::Convert, size, [self.place(of); 3], low, all),
            Op::Concat { high, low } => {
                let shift = self.width(low);
                let (high, low) = (self.place(high), self.place(low));
                let (high, low) = (self.in_size(high, size), self.in_size(low, size));
                self.emit(Operation::Join, size, [high, low, low], shift, 0)
            }
            Op::Extend { of, signed } => {
                let place = self.place(of);
                let wide = self.in_size(place, size);
                if signed {
                    self.emit(Operation::SignExtend, size, [wide; 3], self.width(of) - 1, all)
                } else {
                    wide
                }
            }
        }
    }

    fn unary(&mut self, op: UnaryOp, a: NodeId, width: u32) -> Place {
        let (place, all) = (self.place(a), mask(self.width(a)));
        match op {
            UnaryOp::Not => {
                let ones = self.constant(place.size, all);
                self.emit(Operation::Word(BinaryOp::Xor), place.size, [place, ones, ones], 0, all)
            }
            UnaryOp::Negate => {
                let zero = self.constant(place.size, 0);
                self.emit(Operation::Word(BinaryOp::Sub), place.size, [zero, place, place], 0, mask(width))
            }
            UnaryOp::ReduceAnd | UnaryOp::ReduceOr => {
                let (test, against) =
                    if op == UnaryOp::ReduceAnd { (BinaryOp::Eq, all) } else { (BinaryOp::Ne, 0) };
                let against = self.constant(place.size, against);
                self.emit(Operation::Test(test), Size::Small, [place, against, against], 0, 0)
            }
            UnaryOp::ReduceXor => self.emit(Operation::Parity, Size::Small, [place; 3], 0, 0),
        }
    }

    fn binary(&mut self, op: BinaryOp, a: NodeId, b: NodeId, width: u32) -> Place {
        let (size, all) = (Size::of(width), mask(width));
        let (place_a, place_b) = (self.place(a), self.place(b));
        match op {
            BinaryOp::Shl | BinaryOp::Shr => {
                let amount = match place_b.size {
                    Size::Small => place_b,
                    _ => self.emit(Operation::Saturate, Size::Small, [place_b; 3], 0, 0),
                };
                let shift = if op == BinaryOp::Shl { Operation::ShiftLeft } else { Operation::ShiftRight };
                self.emit(shift, size, [place_a, amount, amount], 0, all)
            }
            _ if op.is_comparison() => {
                let bits = match place_a.size {
                    Size::Small => 32,
                    Size::Medium => 64,
                    Size::Large => 128,
                };
                let up = bits - self.width(a);
                self.emit(Operation::Test(op), Size::Small, [place_a, place_b, place_b], up, 0)
            }
            _ => {
                // A product may need a larger size than its factors.
                let (x, y) = (self.in_size(place_a, size), self.in_size(place_b, size));
                self.emit(Operation::Word(op), size, [x, y, y], 0, all)
            }
        }
    }
}
