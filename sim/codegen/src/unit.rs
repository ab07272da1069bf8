//! From a design's modules to units, each of which becomes a function.
//!
//! A module becomes a unit of its own if its outputs depend on its registers alone (a Moore machine) and it is large
//! enough. Any other instance dissolves in the unit around it. A unit's outputs are known from its registers. A unit
//! therefore reads the outputs of the units inside it, computes their inputs, and then lets them step, in any order.
//!
//! A unit's memory is its inputs, its registers, then the memory of each unit inside it.
//!
//! The logic comes in two versions: one for any clock enable, and one for a cycle in which all lanes are enabled.

use super::idioms::{Idiom, find};
use super::logic::LogicBuilder;
use netlist::{Design, Graph, Module, ModuleId, NodeId, Op};
use std::collections::{BTreeMap, BTreeSet};

/// Operations below which a Moore module is not worth a function of its own.
const MIN_OPERATIONS: usize = 40;

/// The same for a module that is used once, and therefore shares nothing. Beyond this size, the values of a function
/// that held the module would not fit the processor's registers.
const MIN_OPERATIONS_USED_ONCE: usize = 200;

/// Input that enables the clock of every module here.
pub const ENABLE: &str = "en_i";

/// How a value is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// One bit.
    Bit,
    /// 2 to 32 bits.
    Word,
    /// 33 to 64 bits.
    Double,
}

impl Kind {
    /// The kind of values of `width` bits.
    pub fn of(width: u32) -> Self {
        match width {
            1 => Self::Bit,
            2..=32 => Self::Word,
            33..=64 => Self::Double,
            _ => panic!("words of {width} bits are not compiled; the interpreter takes them"),
        }
    }
}

/// A place in a memory of rows and of bits. The kind of a value says which of the two counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    pub row: usize,
    pub bit: usize,
}

impl Place {
    fn plus(self, other: Self) -> Self {
        Self { row: self.row + other.row, bit: self.bit + other.bit }
    }

    /// Reserves room for a value, and moves on behind it.
    pub fn take(&mut self, width: u32) -> Slot {
        let slot = Slot { width, place: *self };
        match Kind::of(width) {
            Kind::Bit => self.bit += 1,
            Kind::Word => self.row += 1,
            Kind::Double => self.row += 2,
        }
        slot
    }
}

/// A value in memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Slot {
    pub width: u32,
    pub place: Place,
}

impl Slot {
    pub fn inside(self, place: Place) -> Self {
        Self { place: self.place.plus(place), ..self }
    }
}

/// A value that a step stores: a register of the unit, or an input of a unit inside.
#[derive(Clone, Debug, PartialEq)]
pub struct Sink {
    pub slot: Slot,
    pub value: NodeId,
}

/// A unit inside another: its position in [`Units::list`], and where its memory begins.
#[derive(Clone, Debug, PartialEq)]
pub struct Child {
    pub unit: usize,
    pub place: Place,
}

/// A value that is no operation of the graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Source {
    /// A value that is read from memory.
    Memory(Slot),
    /// The number of zeros above the leading one of a node of the graph, or `most` if that is less.
    LeadingZeros { of: NodeId, most: u32 },
}

/// The logic of a unit.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Logic {
    /// [`Op::Input`] counts `sources`, and there are no other sources but constants.
    pub graph: Graph,
    pub sources: Vec<Source>,
    pub sinks: Vec<Sink>,
    /// The values of the outputs; for a top only.
    pub outputs: Vec<NodeId>,
}

/// A part of a design that becomes one function, or two.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Unit {
    pub inputs: Vec<Slot>,
    pub logic: Logic,
    /// The logic where the clock enable is set; none for a unit without that input.
    pub enabled: Option<Logic>,
    pub children: Vec<Child>,
    /// Values of the registers at power-up, those of units inside included.
    pub initial: Vec<(Slot, u128)>,
    /// Rows and bits of memory.
    pub size: Place,
}

/// Instances from a unit's module down to another module.
pub type Path = Vec<u32>;

/// A module that has become a unit: which, and where its registers are.
#[derive(Clone)]
struct Known {
    unit: usize,
    registers: BTreeMap<(Path, u32), Slot>,
}

/// A design, which of its modules are units, and their idioms.
#[derive(Clone, Copy)]
struct Context<'d> {
    design: &'d Design,
    is_unit: &'d [bool],
    idioms: &'d [BTreeMap<NodeId, Idiom>],
}

/// All distinct units of some designs, those inside before those around.
#[derive(Default)]
pub struct Units {
    pub list: Vec<Unit>,
    /// Names of the functions.
    pub names: Vec<String>,
}

impl Units {
    /// Adds the units of `design`; returns the position of its top.
    pub fn add(&mut self, design: &Design) -> usize {
        let idioms: Vec<_> = design.modules.iter().map(|module| find(&module.graph)).collect();
        let context = Context { design, is_unit: &units_of(design), idioms: &idioms };
        self.add_module(&context, design.top_id(), &mut BTreeMap::new()).unit
    }

    fn add_module(
        &mut self,
        context: &Context<'_>,
        module: ModuleId,
        known: &mut BTreeMap<ModuleId, Known>,
    ) -> Known {
        if let Some(found) = known.get(&module) {
            return found.clone();
        }
        let Context { design, is_unit, idioms } = *context;
        let mut builder = Builder::new(design, idioms, module);
        builder.take_registers(is_unit, &mut Path::new(), module);
        for (path, module) in std::mem::take(&mut builder.inner) {
            let inside = self.add_module(context, module, known);
            builder.add_child(path, &inside, &self.list[inside.unit]);
        }
        let registers = builder.registers.clone();
        let unit = builder.finish(&self.list);
        let position = self.list.iter().position(|known| *known == unit).unwrap_or_else(|| {
            self.names.push(format!("{}_{}", design.module(module).kind, self.list.len()));
            self.list.push(unit);
            self.list.len() - 1
        });
        let found = Known { unit: position, registers };
        known.insert(module, found.clone());
        found
    }
}

/// Makes the unit of one module.
pub struct Builder<'d> {
    pub design: &'d Design,
    /// Idioms of each module of the design.
    pub idioms: &'d [BTreeMap<NodeId, Idiom>],
    pub root: ModuleId,
    pub unit: Unit,
    /// Registers of the unit and of the units inside it.
    pub registers: BTreeMap<(Path, u32), Slot>,
    /// Registers of the unit itself, whose next values it computes.
    pub own: Vec<(Path, u32)>,
    /// Instances that are units of their own.
    inner: Vec<(Path, ModuleId)>,
    /// Where the units inside are, in the order of [`Unit::children`].
    pub children: Vec<Path>,
}

impl<'d> Builder<'d> {
    fn new(design: &'d Design, idioms: &'d [BTreeMap<NodeId, Idiom>], root: ModuleId) -> Self {
        let mut unit = Unit::default();
        unit.inputs = design.module(root).inputs.iter().map(|port| unit.size.take(port.width)).collect();
        Self {
            design,
            idioms,
            root,
            unit,
            registers: BTreeMap::new(),
            own: Vec::new(),
            inner: Vec::new(),
            children: Vec::new(),
        }
    }

    /// Gives memory to the registers of a module that dissolves in this unit, and finds the units inside.
    fn take_registers(&mut self, is_unit: &[bool], path: &mut Path, id: ModuleId) {
        let module = self.design.module(id);
        for (position, register) in (0..).zip(&module.registers) {
            let slot = self.unit.size.take(register.width);
            self.registers.insert((path.clone(), position), slot);
            self.own.push((path.clone(), position));
            self.unit.initial.push((slot, register.initial));
        }
        for (position, instance) in (0..).zip(&module.instances) {
            path.push(position);
            if is_unit[instance.module.index()] {
                self.inner.push((path.clone(), instance.module));
            } else {
                self.take_registers(is_unit, path, instance.module);
            }
            path.pop();
        }
    }

    fn add_child(&mut self, path: Path, inside: &Known, unit: &Unit) {
        let place = self.unit.size;
        for ((below, position), slot) in &inside.registers {
            let whole = path.iter().chain(below).copied().collect();
            self.registers.insert((whole, *position), slot.inside(place));
        }
        self.unit.initial.extend(unit.initial.iter().map(|&(slot, value)| (slot.inside(place), value)));
        self.unit.children.push(Child { unit: inside.unit, place });
        self.children.push(path);
        self.unit.size = place.plus(unit.size);
    }

    fn finish(self, units: &[Unit]) -> Unit {
        let enable = self.design.module(self.root).inputs.iter().position(|port| port.name == ENABLE);
        let logic = LogicBuilder::new(&self, None).finish(units);
        let enabled = enable.map(|input| LogicBuilder::new(&self, Some(input)).finish(units));
        Unit { logic, enabled, ..self.unit }
    }

    pub fn module_id(&self, path: &[u32]) -> ModuleId {
        let step = |id: ModuleId, &position: &u32| self.design.module(id).instances[position as usize].module;
        path.iter().fold(self.root, step)
    }

    pub fn module(&self, path: &[u32]) -> &'d Module {
        self.design.module(self.module_id(path))
    }
}

/// Whether each module is to be a unit.
fn units_of(design: &Design) -> Vec<bool> {
    let mut uses = vec![0; design.modules.len()];
    for instance in design.modules.iter().flat_map(|module| &module.instances) {
        uses[instance.module.index()] += 1;
    }
    let mut dependences: Vec<Vec<BTreeSet<u32>>> = Vec::new();
    let mut is_unit: Vec<bool> = Vec::new();
    // Operations that a module brings into the unit around it.
    let mut operations: Vec<usize> = Vec::new();
    for (module, uses) in design.modules.iter().zip(uses) {
        let mut cones = Cones { module, dependences: &dependences, known: BTreeMap::new() };
        let of_outputs: Vec<_> = module.outputs.iter().map(|(_, node)| cones.inputs(*node)).collect();
        let is_moore = of_outputs.iter().all(BTreeSet::is_empty);
        let inside = module.instances.iter().map(|instance| instance.module.index());
        let dissolved: usize = inside.filter(|&id| !is_unit[id]).map(|id| operations[id]).sum();
        let own = module.graph.nodes().len() + dissolved;
        let least = if uses == 1 { MIN_OPERATIONS_USED_ONCE } else { MIN_OPERATIONS };
        dependences.push(of_outputs);
        operations.push(own);
        is_unit.push(is_moore && own >= least);
    }
    is_unit
}

/// Which inputs of a module its nodes depend on within a cycle.
struct Cones<'d> {
    module: &'d Module,
    /// For each module before this one and each of its outputs.
    dependences: &'d [Vec<BTreeSet<u32>>],
    known: BTreeMap<NodeId, BTreeSet<u32>>,
}

impl Cones<'_> {
    fn inputs(&mut self, node: NodeId) -> BTreeSet<u32> {
        if let Some(known) = self.known.get(&node) {
            return known.clone();
        }
        let found = match self.module.graph.op(node) {
            Op::Input(input) => BTreeSet::from([input]),
            Op::Instance { instance, output } => {
                let instance = &self.module.instances[instance as usize];
                let through = &self.dependences[instance.module.index()][output as usize];
                through.iter().flat_map(|&input| self.inputs(instance.inputs[input as usize])).collect()
            }
            op => op.operands().flat_map(|operand| self.inputs(operand)).collect(),
        };
        self.known.insert(node, found.clone());
        found
    }
}
