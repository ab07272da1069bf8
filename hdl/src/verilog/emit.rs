//! One module as Verilog-2005 text.
//!
//! Every named value of the source is one `wire` with one expression. Expressions are width-exact: each operand has
//! the width that its operation wants, so the text means the same by Verilog's context rules as by the graph's,
//! and no tool warns. A value without a name is written in place if it is used once and the line stays readable.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::identifier::{CLOCK, Namespace, PortNames, plain, port_names};
use crate::netlist::{BinaryOp, Design, Module, NodeId, Op, Register, UnaryOp, mask};

/// Longest expression written in place, in characters.
const INLINE_LIMIT: usize = 60;

/// The text of a module, from `module` to `endmodule`.
#[must_use]
pub fn module_text(design: &Design, module: &Module) -> String {
    let mut emitter = Emitter::new(design, module);
    emitter.name_everything();
    emitter.logic();
    emitter.finish()
}

/// `[7:0] ` for eight bits, nothing for one.
#[must_use]
pub fn range(width: u32) -> String {
    if width == 1 { String::new() } else { format!("[{}:0] ", width - 1) }
}

/// A sized constant.
#[must_use]
pub fn constant(value: u128, width: u32) -> String {
    match (width, value) {
        (1, _) => format!("1'b{value}"),
        (_, 0..10) => format!("{width}'d{value}"),
        _ => format!("{width}'h{value:x}"),
    }
}

struct Emitter<'d> {
    design: &'d Design,
    module: &'d Module,
    namespace: Namespace,
    ports: PortNames,
    /// Identifiers of nodes that have one.
    names: BTreeMap<NodeId, String>,
    /// Readers of each node: other nodes, registers, instances, outputs.
    uses: Vec<u32>,
    /// Whether bits of the node are selected, which Verilog allows for names only.
    is_selected: Vec<bool>,
    /// Bits of each identifier that something reads, and its width.
    read: BTreeMap<String, (u128, u32)>,
    register_names: Vec<String>,
    instance_names: Vec<String>,
    body: String,
}

impl<'d> Emitter<'d> {
    fn new(design: &'d Design, module: &'d Module) -> Self {
        let mut namespace = Namespace::default();
        let ports = port_names(module, &mut namespace);
        let mut uses = vec![0; module.graph.nodes().len()];
        let operands = module.graph.nodes().iter().flat_map(|node| node.op.operands());
        operands.chain(module.roots()).for_each(|node| uses[node.index()] += 1);
        let mut is_selected = vec![false; uses.len()];
        for node in module.graph.nodes() {
            if let Op::Slice { of, .. } | Op::Extend { of, signed: true } = node.op {
                is_selected[of.index()] = true;
            }
        }
        Self {
            design,
            module,
            namespace,
            ports,
            names: BTreeMap::new(),
            uses,
            is_selected,
            read: BTreeMap::new(),
            register_names: Vec::new(),
            instance_names: Vec::new(),
            body: String::new(),
        }
    }

    /// Gives identifiers to sources and to the source's named values.
    fn name_everything(&mut self) {
        let module = self.module;
        self.register_names =
            module.registers.iter().map(|r| self.namespace.claim(&plain(&r.name))).collect();
        self.instance_names =
            module.instances.iter().map(|i| self.namespace.claim(&plain(&i.name))).collect();
        for (id, node) in module.graph.iter() {
            let name = match node.op {
                Op::Input(input) => self.ports.inputs[input as usize].clone(),
                Op::Register(register) => self.register_names[register as usize].clone(),
                Op::Instance { instance, output } => {
                    let (name, port) = self.instance_output(instance, output);
                    self.namespace.claim(&format!("{name}_{port}"))
                }
                _ => continue,
            };
            self.read.insert(name.clone(), (0, node.width));
            self.names.insert(id, name);
        }
        for (position, port) in module.inputs.iter().enumerate() {
            self.read.entry(self.ports.inputs[position].clone()).or_insert((0, port.width));
        }
        // Where folding made two values of a signal one, the plain name is the better.
        let (last, earlier): (Vec<_>, Vec<_>) = module.names.iter().partition(|local| local.is_last);
        for local in last.into_iter().chain(earlier) {
            if !self.names.contains_key(&local.node) && self.uses[local.node.index()] > 0 {
                let name = self.namespace.claim(&plain(&local.name));
                self.read.insert(name.clone(), (0, module.graph.width(local.node)));
                self.names.insert(local.node, name);
            }
        }
    }

    fn instance_output(&self, instance: u32, output: u32) -> (String, String) {
        let child = self.design.module(self.module.instances[instance as usize].module);
        let ports = port_names(child, &mut Namespace::default());
        (self.instance_names[instance as usize].clone(), ports.outputs[output as usize].clone())
    }

    /// Writes a wire for each node that needs one, operands first.
    fn logic(&mut self) {
        let module = self.module;
        for (id, node) in module.graph.iter() {
            if node.op.is_source() {
                continue;
            }
            if !self.names.contains_key(&id) {
                if !self.needs_wire(id) {
                    continue;
                }
                let name = self.namespace.claim(&format!("n{}", id.index()));
                self.read.insert(name.clone(), (0, node.width));
                self.names.insert(id, name);
            }
            let expression = self.expression(id, true);
            let name = &self.names[&id];
            let _ = writeln!(self.body, "    wire {}{name} = {expression};", range(node.width));
        }
    }

    /// Whether an unnamed node has to have a name: it is read more than once, its bits are selected, or
    /// writing it in place would make too long a line.
    fn needs_wire(&self, id: NodeId) -> bool {
        let is_wiring = matches!(self.module.graph.op(id), Op::Slice { .. });
        (self.uses[id.index()] > 1 && !is_wiring)
            || self.is_selected[id.index()]
            || self.length(id) > INLINE_LIMIT
    }

    /// About how long a node is when written in place.
    fn length(&self, id: NodeId) -> usize {
        if let Some(name) = self.names.get(&id) {
            return name.len();
        }
        self.module.graph.op(id).operands().map(|operand| self.length(operand) + 3).sum::<usize>() + 3
    }

    /// A node where it is used.
    fn operand(&mut self, id: NodeId) -> String {
        match self.names.get(&id) {
            Some(name) => {
                let name = name.clone();
                let width = self.module.graph.width(id);
                self.mark(&name, mask(width));
                name
            }
            None => self.expression(id, false),
        }
    }

    /// A node as the whole right side of an assignment or the whole of a connection.
    fn standalone(&mut self, id: NodeId) -> String {
        if self.names.contains_key(&id) { self.operand(id) } else { self.expression(id, true) }
    }

    fn mark(&mut self, name: &str, bits: u128) {
        if let Some((read, _)) = self.read.get_mut(name) {
            *read |= bits;
        }
    }

    /// The expression of a node from its operands; in parentheses unless it stands alone or needs none.
    fn expression(&mut self, id: NodeId, alone: bool) -> String {
        let graph = &self.module.graph;
        let node = graph.node(id);
        let text = match node.op {
            Op::Constant(value) => return constant(value, node.width),
            Op::Input(_) | Op::Register(_) | Op::Instance { .. } => return self.operand(id),
            Op::Unary(op, a) => {
                let symbol = match op {
                    UnaryOp::Not => "~",
                    UnaryOp::Negate => "-",
                    UnaryOp::ReduceAnd => "&",
                    UnaryOp::ReduceOr => "|",
                    UnaryOp::ReduceXor => "^",
                };
                let text = format!("{symbol}{}", self.operand(a));
                if op == UnaryOp::Not {
                    return text;
                }
                text
            }
            Op::Binary(BinaryOp::Mul, a, b) => {
                let pad = node.width - graph.width(a);
                let mut padded = |operand| match pad {
                    0 => self.operand(operand),
                    _ => format!("{{{}, {}}}", constant(0, pad), self.operand(operand)),
                };
                format!("{} * {}", padded(a), padded(b))
            }
            Op::Binary(op @ (BinaryOp::SignedLt | BinaryOp::SignedLe), a, b) => {
                let symbol = if op == BinaryOp::SignedLt { "<" } else { "<=" };
                format!("$signed({}) {symbol} $signed({})", self.operand(a), self.operand(b))
            }
            Op::Binary(op, a, b) => format!("{} {} {}", self.operand(a), symbol(op), self.operand(b)),
            Op::Mux { select, when_true, when_false } => format!(
                "{} ? {} : {}",
                self.operand(select),
                self.operand(when_true),
                self.operand(when_false)
            ),
            Op::Slice { of, low } => return self.slice(of, low, node.width),
            Op::Concat { .. } => {
                let mut parts = Vec::new();
                self.concatenation(id, true, &mut parts);
                return format!("{{{}}}", parts.join(", "));
            }
            Op::Extend { of, signed: false } => {
                let pad = constant(0, node.width - graph.width(of));
                let mut parts = vec![pad];
                self.concatenation(of, false, &mut parts);
                return format!("{{{}}}", parts.join(", "));
            }
            Op::Extend { of, signed: true } => {
                let (width, pad) = (graph.width(of), node.width - graph.width(of));
                if width == 1 {
                    return format!("{{{}{{{}}}}}", node.width, self.operand(of));
                }
                let sign = self.slice(of, width - 1, 1);
                return format!("{{{{{pad}{{{sign}}}}}, {}}}", self.operand(of));
            }
        };
        if alone { text } else { format!("({text})") }
    }

    /// The parts of a concatenation, nested ones without a name taken apart.
    fn concatenation(&mut self, id: NodeId, is_root: bool, parts: &mut Vec<String>) {
        match self.module.graph.op(id) {
            Op::Concat { high, low } if is_root || !self.names.contains_key(&id) => {
                self.concatenation(high, false, parts);
                self.concatenation(low, false, parts);
            }
            _ => parts.push(self.operand(id)),
        }
    }

    fn slice(&mut self, of: NodeId, low: u32, width: u32) -> String {
        let name = match self.names.get(&of) {
            Some(name) => name.clone(),
            None => unreachable!("a node whose bits are selected has a wire"),
        };
        if self.module.graph.width(of) == width {
            self.mark(&name, mask(width));
            return name;
        }
        self.mark(&name, mask(width) << low);
        if width == 1 { format!("{name}[{low}]") } else { format!("{name}[{}:{low}]", low + width - 1) }
    }

    fn finish(mut self) -> String {
        let registers = self.registers();
        let instances = self.instances();
        let outputs: Vec<String> = (self.module.outputs.iter().enumerate())
            .map(|(position, (_, node))| {
                let name = self.ports.outputs[position].clone();
                let value = self.standalone(*node);
                format!("    assign {name} = {value};\n")
            })
            .collect();
        let mut text = format!("module {} (\n{}\n);\n", self.module.name, self.port_list().join(",\n"));
        let mut section = |title: &str, content: &str| {
            if !content.is_empty() {
                let _ = write!(text, "\n    // {title}\n{content}");
            }
        };
        section("Registers", &self.register_declarations());
        section("Outputs of instances", &self.instance_wires());
        section("Logic", &self.body);
        section("Next state", &registers);
        section("Instances", &instances);
        section("Outputs", &outputs.concat());
        section("Bits that nothing reads", &self.unused());
        text.push_str("endmodule\n");
        text
    }

    fn port_list(&self) -> Vec<String> {
        let module = self.module;
        let widest = (module.inputs.iter().chain(module.outputs.iter().map(|(port, _)| port)))
            .map(|port| range(port.width).len())
            .max()
            .unwrap_or(0);
        let line = |direction: &str, width, name: &str| {
            format!("    {direction} wire {:<widest$}{name}", range(width))
        };
        let mut lines = Vec::new();
        if module.clock.is_some() {
            lines.push(line("input ", 1, CLOCK));
        }
        for (port, name) in module.inputs.iter().zip(&self.ports.inputs) {
            lines.push(line("input ", port.width, name));
        }
        for ((port, _), name) in module.outputs.iter().zip(&self.ports.outputs) {
            lines.push(line("output", port.width, name));
        }
        lines
    }

    fn register_declarations(&self) -> String {
        let mut text = String::new();
        for (register, name) in self.module.registers.iter().zip(&self.register_names) {
            let initial = constant(register.initial, register.width);
            let _ = writeln!(text, "    reg {}{name} = {initial};", range(register.width));
        }
        text
    }

    fn instance_wires(&self) -> String {
        let mut text = String::new();
        for (id, node) in self.module.graph.iter() {
            if let Op::Instance { .. } = node.op {
                let _ = writeln!(text, "    wire {}{};", range(node.width), self.names[&id]);
            }
        }
        text
    }

    /// Clocked assignments, one block for each enable.
    fn registers(&mut self) -> String {
        let module = self.module;
        let mut text = String::new();
        let mut groups: Vec<(Option<NodeId>, Vec<(usize, &Register)>)> = Vec::new();
        for (position, register) in module.registers.iter().enumerate() {
            match groups.iter_mut().find(|(enable, _)| *enable == register.enable) {
                Some((_, group)) => group.push((position, register)),
                None => groups.push((register.enable, vec![(position, register)])),
            }
        }
        for (enable, group) in groups {
            let _ = writeln!(text, "    always @(posedge {CLOCK}) begin");
            let mut indent = "        ";
            if let Some(enable) = enable {
                let condition = self.standalone(enable);
                let _ = writeln!(text, "        if ({condition}) begin");
                indent = "            ";
            }
            for (position, register) in group {
                let name = self.register_names[position].clone();
                let value = self.standalone(register.data);
                let _ = writeln!(text, "{indent}{name} <= {value};");
            }
            if enable.is_some() {
                text.push_str("        end\n");
            }
            text.push_str("    end\n");
        }
        text
    }

    fn instances(&mut self) -> String {
        let mut text = String::new();
        for (i, instance) in self.module.instances.iter().enumerate() {
            let child = self.design.module(instance.module);
            let ports = port_names(child, &mut Namespace::default());
            let mut connections = Vec::new();
            if child.clock.is_some() {
                connections.push((CLOCK.to_owned(), CLOCK.to_owned()));
            }
            for (name, &node) in ports.inputs.iter().zip(&instance.inputs) {
                let value = self.standalone(node);
                connections.push((name.clone(), value));
            }
            for (o, name) in ports.outputs.iter().enumerate() {
                let op = Op::Instance { instance: i as u32, output: o as u32 };
                let wire = self.module.graph.iter().find(|(_, node)| node.op == op);
                let value = wire.map(|(id, _)| self.names[&id].clone()).unwrap_or_default();
                connections.push((name.clone(), value));
            }
            let widest = connections.iter().map(|(port, _)| port.len()).max().unwrap_or(0);
            let lines: Vec<String> = connections
                .iter()
                .map(|(port, value)| format!("        .{port:<widest$} ({value})"))
                .collect();
            let name = &self.instance_names[i];
            let _ = writeln!(text, "    {} {name} (\n{}\n    );", child.name, lines.join(",\n"));
        }
        text
    }

    /// A reduction of every bit that nothing reads: what lint tools take as unread on purpose.
    fn unused(&mut self) -> String {
        let mut parts = Vec::new();
        for (name, &(read, width)) in &self.read {
            let mut missing = !read & mask(width);
            if missing == mask(width) {
                parts.push(name.clone());
                continue;
            }
            while missing != 0 {
                let low = missing.trailing_zeros();
                let length = (!(missing >> low)).trailing_zeros();
                parts.push(match length {
                    1 => format!("{name}[{low}]"),
                    _ => format!("{name}[{}:{low}]", low + length - 1),
                });
                missing &= !(mask(length) << low);
            }
        }
        if parts.is_empty() {
            return String::new();
        }
        let name = self.namespace.claim("unused");
        format!("    wire {name} = &{{1'b0, {}}};\n", parts.join(", "))
    }
}

fn symbol(op: BinaryOp) -> &'static str {
    match op {
        BinaryOp::And => "&",
        BinaryOp::Or => "|",
        BinaryOp::Xor => "^",
        BinaryOp::Add => "+",
        BinaryOp::Sub => "-",
        BinaryOp::Mul => "*",
        BinaryOp::Eq => "==",
        BinaryOp::Ne => "!=",
        BinaryOp::Lt | BinaryOp::SignedLt => "<",
        BinaryOp::Le | BinaryOp::SignedLe => "<=",
        BinaryOp::Shl => "<<",
        BinaryOp::Shr => ">>",
    }
}
