//! One module as Verilog-2005 text.
//!
//! Every named value of the source is one `wire` with one expression. Expressions are width-exact: each operand has
//! the width that its operation wants, so the text means the same by Verilog's context rules as by the graph's,
//! and no tool warns. A value without a name is written in place if it is used once and the line stays readable.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::comments::Comments;
use super::constant::constant;
use super::identifier::{CLOCK, Namespace, PortNames, RESET, plain, port_names};
use crate::{Design, Module, NodeId, Op, mask};

/// Longest expression written in place, in characters.
const INLINE_LIMIT: usize = 60;

/// The text of a module, from `module` to `endmodule`, with the comments of its source. With `reset`, registers have no
/// initial values; those of valid bits are cleared by the port [`RESET`] instead.
#[must_use]
pub fn module_text(design: &Design, module: &Module, reset: bool, comments: &Comments) -> String {
    let mut emitter = Emitter::new(design, module, reset, comments);
    emitter.name_everything();
    emitter.logic();
    emitter.finish()
}

/// `[7:0] ` for eight bits, nothing for one.
#[must_use]
pub fn range(width: u32) -> String {
    if width == 1 { String::new() } else { format!("[{}:0] ", width - 1) }
}

/// Writes the comment about `name` that is not in `shown` yet, if there is one.
fn write_comment(text: &mut String, comments: &Comments, name: &str, shown: &mut Vec<usize>) {
    for line in comments.about(name, shown).into_iter().flat_map(|part| &part.lines) {
        let _ = writeln!(text, "    // {line}");
    }
}

pub(super) struct Emitter<'d> {
    design: &'d Design,
    pub(super) module: &'d Module,
    reset: bool,
    comments: &'d Comments,
    namespace: Namespace,
    ports: PortNames,
    /// Identifiers of nodes that have one.
    pub(super) names: BTreeMap<NodeId, String>,
    /// Readers of each node: other nodes, registers, instances, outputs.
    uses: Vec<u32>,
    /// Whether bits of the node are selected, which Verilog allows for names only.
    is_selected: Vec<bool>,
    /// Whether the node is the whole of an output or a register's next value.
    is_assigned: Vec<bool>,
    /// Bits of each identifier that something reads, and its width.
    pub(super) read: BTreeMap<String, (u128, u32)>,
    register_names: Vec<String>,
    instance_names: Vec<String>,
    body: String,
}

impl<'d> Emitter<'d> {
    fn new(design: &'d Design, module: &'d Module, reset: bool, comments: &'d Comments) -> Self {
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
        let mut is_assigned = vec![false; uses.len()];
        module.outputs.iter().for_each(|(_, node)| is_assigned[node.index()] = true);
        module.registers.iter().for_each(|register| is_assigned[register.data.index()] = true);
        Self {
            design,
            module,
            reset,
            comments,
            namespace,
            ports,
            names: BTreeMap::new(),
            uses,
            is_selected,
            is_assigned,
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
        // Where folding has merged two values of a signal, the plain name is the better one.
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

    /// Names for nodes that the source does not name, after what reads them: `sum_if` is the condition under which `sum` takes
    /// its first value, `sum_part` another operand.
    fn hints(&self) -> BTreeMap<NodeId, String> {
        let mut hints: BTreeMap<NodeId, String> = BTreeMap::new();
        for (register, name) in self.module.registers.iter().zip(&self.register_names) {
            hints.insert(register.data, format!("{name}_next"));
        }
        for (instance, name) in self.module.instances.iter().zip(&self.instance_names) {
            let child = port_names(self.design.module(instance.module), &mut Namespace::default());
            for (&node, port) in instance.inputs.iter().zip(child.inputs) {
                hints.entry(node).or_insert_with(|| format!("{name}_{port}"));
            }
        }
        for ((_, node), name) in self.module.outputs.iter().zip(&self.ports.outputs) {
            hints.entry(*node).or_insert_with(|| format!("{name}_value"));
        }
        // Readers come after what they read: from the last on, each reader has its name when its operands get theirs.
        for (id, node) in self.module.graph.iter().rev() {
            let Some(reader) = self.names.get(&id).or_else(|| hints.get(&id)).cloned() else { continue };
            let reader =
                ["_if", "_part", "_value"].iter().fold(&*reader, |name, end| name.trim_end_matches(end));
            let select = match node.op {
                Op::Mux { select, .. } => Some(select),
                _ => None,
            };
            for operand in node.op.operands() {
                let role = if select == Some(operand) { "if" } else { "part" };
                hints.entry(operand).or_insert_with(|| format!("{reader}_{role}"));
            }
        }
        hints
    }

    /// Writes a wire for each node that needs one, operands first.
    fn logic(&mut self) {
        let module = self.module;
        let hints = self.hints();
        let mut shown = Vec::new();
        for (id, node) in module.graph.iter() {
            if node.op.is_source() {
                continue;
            }
            if !self.names.contains_key(&id) {
                if !self.needs_wire(id) {
                    continue;
                }
                let name = self.namespace.claim(hints.get(&id).map_or("value", String::as_str));
                self.read.insert(name.clone(), (0, node.width));
                self.names.insert(id, name);
            }
            let expression = self.expression(id, true);
            let name = &self.names[&id];
            write_comment(&mut self.body, self.comments, name, &mut shown);
            let _ = writeln!(self.body, "    wire {}{name} = {expression};", range(node.width));
        }
    }

    /// Whether an unnamed node has to have a name: it is read more than once, its bits are selected, or
    /// writing it in place would make too long a line.
    fn needs_wire(&self, id: NodeId) -> bool {
        let is_wiring = matches!(self.module.graph.op(id), Op::Slice { .. });
        (self.uses[id.index()] > 1 && !is_wiring)
            || self.is_selected[id.index()]
            || (self.length(id) > INLINE_LIMIT && !self.is_assigned[id.index()])
    }

    /// About how long a node is when written in place.
    fn length(&self, id: NodeId) -> usize {
        if let Some(name) = self.names.get(&id) {
            return name.len();
        }
        self.module.graph.op(id).operands().map(|operand| self.length(operand) + 3).sum::<usize>() + 3
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
        if self.reset && self.design.has_reset(module) {
            lines.push(line("input ", 1, RESET));
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
            let _ = match self.reset {
                true => writeln!(text, "    reg {}{name};", range(register.width)),
                false => {
                    let initial = constant(register.initial, register.width);
                    writeln!(text, "    reg {}{name} = {initial};", range(register.width))
                }
            };
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

    /// Clocked assignments, one block for each enable, and one for those of the same enable that reset clears.
    fn registers(&mut self) -> String {
        let module = self.module;
        let mut text = String::new();
        let mut groups: Vec<(_, Vec<usize>)> = Vec::new();
        for (position, register) in module.registers.iter().enumerate() {
            let key = (self.reset && register.has_reset, register.enable);
            match groups.iter_mut().find(|(known, _)| *known == key) {
                Some((_, group)) => group.push(position),
                None => groups.push((key, vec![position])),
            }
        }
        for ((is_reset, enable), group) in groups {
            let edges = if is_reset { format!(" or negedge {RESET}") } else { String::new() };
            let _ = writeln!(text, "    always @(posedge {CLOCK}{edges}) begin");
            let condition = enable.map(|enable| format!("if ({}) ", self.standalone(enable)));
            let condition = condition.unwrap_or_default();
            let mut opening = condition.clone();
            if is_reset {
                let _ = writeln!(text, "        if (!{RESET}) begin");
                for &position in &group {
                    let initial =
                        constant(module.registers[position].initial, module.registers[position].width);
                    let _ = writeln!(text, "            {} <= {initial};", self.register_names[position]);
                }
                opening = format!("end else {condition}");
            }
            let mut indent = "        ";
            if !opening.is_empty() {
                let _ = writeln!(text, "        {opening}begin");
                indent = "            ";
            }
            for position in group {
                let name = self.register_names[position].clone();
                let value = self.standalone(module.registers[position].data);
                let _ = writeln!(text, "{indent}{name} <= {value};");
            }
            if !opening.is_empty() {
                text.push_str("        end\n");
            }
            text.push_str("    end\n");
        }
        text
    }

    fn instances(&mut self) -> String {
        let mut text = String::new();
        let mut shown = Vec::new();
        for (i, instance) in self.module.instances.iter().enumerate() {
            let child = self.design.module(instance.module);
            let ports = port_names(child, &mut Namespace::default());
            let mut connections = Vec::new();
            if child.clock.is_some() {
                connections.push((CLOCK.to_owned(), CLOCK.to_owned()));
            }
            if self.reset && self.design.has_reset(child) {
                connections.push((RESET.to_owned(), RESET.to_owned()));
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
            write_comment(&mut text, self.comments, name, &mut shown);
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
