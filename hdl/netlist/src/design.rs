//! The elaborated design: modules with their graphs, the hierarchy kept.

use super::graph::{Graph, NodeId};

/// How the bits of a signal are meant; the graph itself is untyped but for widths.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum SignalType {
    /// Plain bits, unsigned.
    Bits,
    /// Two's complement.
    Signed,
    /// An enumeration: label `Type::Name` of each value from 0.
    Enum(Vec<String>),
}

/// A port of a module.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Port {
    /// Name in the source, array positions `$`-joined; the field of an interface whose name ends in `_i` or `_o` has its own.
    pub name: String,
    /// Width in bits.
    pub width: u32,
    /// How the bits are meant.
    pub signal_type: SignalType,
}

/// A D flip-flop of one word: on the clock's rising edge, `q <= d` if enabled.
///
/// A simulation starts every register at [`initial`](Self::initial), which is where power-up and reset leave it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Register {
    /// Name of the instance in the source.
    pub name: String,
    /// Width in bits.
    pub width: u32,
    /// How the bits are meant.
    pub signal_type: SignalType,
    /// Value at power-up, and in reset if it has one.
    pub initial: u128,
    /// Whether the hardware's reset clears it. The others have unknown values until their first data arrive.
    pub has_reset: bool,
    /// The next value.
    pub data: NodeId,
    /// One-bit clock enable; always enabled when absent.
    pub enable: Option<NodeId>,
}

/// Index of a module in [`Design::modules`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ModuleId(pub u32);

impl ModuleId {
    /// The position in [`Design::modules`].
    #[must_use]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// A use of a module. Its outputs are read by [`Op::Instance`](super::Op::Instance).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Instance {
    /// Name of the field in the source, array positions `$`-joined.
    pub name: String,
    /// The module.
    pub module: ModuleId,
    /// The value of each input of the module, in its order.
    pub inputs: Vec<NodeId>,
}

/// A value that a module was specialised for: a `Constant` field, or an input tied by every parent.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Parameter {
    /// Name of the field in the source.
    pub name: String,
    /// Width in bits.
    pub width: u32,
    /// The value.
    pub value: u128,
    /// Whether it is an input that the parent ties, and no `Constant` field.
    pub is_tied_input: bool,
}

/// A local signal: a name for a node, for Verilog, waves and messages.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LocalName {
    /// Name in the source, unique in the module; the n-th of several values is `name_n`, the last plain.
    pub name: String,
    /// The node that carries the value.
    pub node: NodeId,
    /// Whether it is the last value of the signal.
    pub is_last: bool,
    /// How the bits are meant.
    pub signal_type: SignalType,
}

/// A module, once, however often it is instantiated.
///
/// Every node of the graph is reachable from an output, a register or an instance input, so counts are of
/// live logic only.
#[derive(Clone, Debug, PartialEq)]
pub struct Module {
    /// Name, unique in the design and usable in Verilog.
    pub name: String,
    /// What the module is in the source, shared by all its specialisations: the unit of an inventory.
    pub kind: String,
    /// Values of the generics as the source names them, such as `e8m23`; empty if it has none.
    pub generics: String,
    /// The values it was specialised for, in order of declaration.
    pub parameters: Vec<Parameter>,
    /// Name of the clock input, if anything beneath is clocked.
    pub clock: Option<String>,
    /// Inputs without the clock, in order of declaration; the index of [`Op::Input`](super::Op::Input).
    pub inputs: Vec<Port>,
    /// Outputs in order of declaration, with the node that drives each.
    pub outputs: Vec<(Port, NodeId)>,
    /// The combinational logic.
    pub graph: Graph,
    /// Registers; the index of [`Op::Register`](super::Op::Register).
    pub registers: Vec<Register>,
    /// Instances; the index of [`Op::Instance`](super::Op::Instance).
    pub instances: Vec<Instance>,
    /// Named values in the order in which the source assigns them; registers, ports and instances have
    /// their own names.
    pub names: Vec<LocalName>,
}

impl Module {
    /// The nodes that something other than a node reads: outputs, register and instance inputs, in order.
    pub fn roots(&self) -> impl Iterator<Item = NodeId> {
        let outputs = self.outputs.iter().map(|(_, node)| *node);
        let registers = self.registers.iter().flat_map(|r| std::iter::once(r.data).chain(r.enable));
        let instances = self.instances.iter().flat_map(|i| i.inputs.iter().copied());
        outputs.chain(registers).chain(instances)
    }
}

/// An elaborated design. Modules come before their users; the last one is the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Design {
    /// The modules, children first.
    pub modules: Vec<Module>,
}

impl Design {
    /// The module that the others serve.
    ///
    /// # Panics
    /// When there is no module; `elaborate` always gives at least one.
    #[must_use]
    pub fn top(&self) -> &Module {
        self.modules.last().expect("a design has a top module")
    }

    /// The id of the top module.
    #[must_use]
    pub fn top_id(&self) -> ModuleId {
        ModuleId(self.modules.len() as u32 - 1)
    }

    /// The module with this id.
    #[must_use]
    pub fn module(&self, id: ModuleId) -> &Module {
        &self.modules[id.index()]
    }

    /// Whether the module or anything beneath it has a register that reset clears.
    #[must_use]
    pub fn has_reset(&self, module: &Module) -> bool {
        let beneath = || module.instances.iter().any(|instance| self.has_reset(self.module(instance.module)));
        module.registers.iter().any(|register| register.has_reset) || beneath()
    }

    /// The module with this name.
    #[must_use]
    pub fn find(&self, name: &str) -> Option<&Module> {
        self.modules.iter().find(|module| module.name == name)
    }
}
