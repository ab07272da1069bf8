//! The mapped netlist: cells and nets.

use std::collections::BTreeSet;

use super::MapError;
use super::cover::{Choice, Cover, operands};
use crate::aig::{Aig, Lit, Origin};
use crate::liberty::Library;
use crate::liberty::function::MAX_INPUTS;

/// A combinational cell in place. Nets are numbered by the [code](Lit::code) of the literal that they carry; buffers make
/// further ones.
#[derive(Clone, Debug, PartialEq)]
pub struct Gate {
    /// Position in the library.
    pub cell: usize,
    /// Net of each input, in the cell's order.
    pub inputs: Vec<u32>,
    /// Net of the output.
    pub output: u32,
    /// Where it belongs.
    pub origin: Origin,
}

/// A flip-flop in place.
#[derive(Clone, Debug, PartialEq)]
pub struct Register {
    /// The latch of the graph.
    pub latch: usize,
    /// Net of the data input.
    pub data: u32,
    /// Net of the output.
    pub output: u32,
    /// Where it belongs.
    pub origin: Origin,
}

/// Flip-flops behind one enable, whose clock stops together.
#[derive(Clone, Debug, PartialEq)]
pub struct ClockGating {
    /// The net of the enable.
    pub enable: u32,
    /// The enable in the graph that was mapped.
    pub condition: Lit,
    /// Number of flip-flops.
    pub registers: usize,
    /// Number of clock gates.
    pub gates: usize,
}

/// A netlist of cells of a library.
#[derive(Clone, Debug)]
pub struct Mapped {
    /// Cells, operands before users.
    pub gates: Vec<Gate>,
    /// Flip-flops.
    pub registers: Vec<Register>,
    /// Groups of gated flip-flops, if the library has clock gates. Otherwise enables are multiplexers before the
    /// data.
    pub clock_gating: Vec<ClockGating>,
    /// Net of each input of the graph.
    pub inputs: Vec<u32>,
    /// Net of each output of the graph.
    pub outputs: Vec<u32>,
    /// Number of nets.
    pub nets: usize,
    /// For each net, the literal that it carries.
    pub literals: Vec<Lit>,
}

/// Most flip-flops behind one clock gate.
const REGISTERS_PER_GATE: usize = 32;

pub fn build(aig: &Aig, library: &Library, cover: &Cover) -> Result<Mapped, MapError> {
    let nets = 2 * aig.nodes().len();
    let mut mapped = Mapped {
        gates: Vec::new(),
        registers: Vec::new(),
        clock_gating: Vec::new(),
        inputs: aig.inputs().iter().map(|input| input.lit.code()).collect(),
        outputs: aig.outputs.iter().map(|output| output.lit.code()).collect(),
        nets,
        literals: (0..nets as u32).map(Lit::from_code).collect(),
    };
    for value in [Lit::FALSE, Lit::TRUE] {
        if aig.outputs.iter().any(|output| output.lit == value)
            && library.ties[value.code() as usize].is_none()
        {
            return Err(MapError::NoTie { library: library.name.clone(), value: value.code() as u8 });
        }
    }
    for node in 1..aig.nodes().len() {
        let (plain, complement) = (Lit::new(node, false), Lit::new(node, true));
        let choice = |lit: Lit| cover.choices[lit.code() as usize];
        // An inverter comes behind what it inverts.
        let order = if choice(plain) == Choice::Inverter { [complement, plain] } else { [plain, complement] };
        for lit in order.into_iter().filter(|&lit| cover.is_used(lit)) {
            let origin = aig.origin_of(node);
            let (cell, inputs) = match choice(lit) {
                Choice::Source => continue,
                Choice::Inverter => (library.inverter(), vec![(!lit).code()]),
                Choice::Cell(cut, found) => {
                    let mut inputs = [0; MAX_INPUTS];
                    for (leaf, operand) in operands(&cut, &found).enumerate() {
                        inputs[found.input[leaf] as usize] = operand.code();
                    }
                    (found.cell as usize, inputs[..cut.size as usize].to_vec())
                }
            };
            mapped.gates.push(Gate { cell, inputs, output: lit.code(), origin });
        }
    }
    for (latch, found) in aig.latches().iter().enumerate() {
        let (data, output) = (found.data.code(), found.lit.code());
        mapped.registers.push(Register { latch, data, output, origin: found.origin });
    }
    own_inverters(aig, &mut mapped);
    mapped.clock_gating = clock_gating(aig, enables(aig).map(Lit::code));
    Ok(mapped)
}

/// The enables that stop the clock of some latch, in the order of their codes.
pub(crate) fn enables(aig: &Aig) -> impl Iterator<Item = Lit> {
    let all: BTreeSet<Lit> = aig.latches().iter().map(|latch| latch.enable).collect();
    all.into_iter().filter(|&enable| enable != Lit::TRUE)
}

/// Clock gates for each of the [`enables`], which are on the nets `nets`.
pub(crate) fn clock_gating(aig: &Aig, nets: impl Iterator<Item = u32>) -> Vec<ClockGating> {
    let gating = |(condition, enable)| {
        let registers = aig.latches().iter().filter(|latch| latch.enable == condition).count();
        ClockGating { enable, condition, registers, gates: registers.div_ceil(REGISTERS_PER_GATE) }
    };
    enables(aig).zip(nets).map(gating).collect()
}

/// An inverter behind an input or a register belongs to the region that reads it, if that is one.
fn own_inverters(aig: &Aig, mapped: &mut Mapped) {
    let readers = mapped.readers();
    for position in 0..mapped.gates.len() {
        let Gate { output, .. } = mapped.gates[position];
        if aig.operands(Lit::from_code(output).node()).is_some() {
            continue;
        }
        let mut origins = readers[output as usize].iter().map(|&reader| mapped.gates[reader as usize].origin);
        if let Some(first) = origins.next()
            && origins.all(|origin| origin.region == first.region)
        {
            mapped.gates[position].origin = first;
        }
    }
}

impl Mapped {
    /// The graph of the cells' functions, with the ports and latches of the graph that was mapped, and the literal of each net
    /// in it; that of a net without driver is false.
    ///
    /// # Panics
    /// If a net that something reads has no driver.
    #[must_use]
    pub fn function(&self, source: &Aig, library: &Library) -> (Aig, Vec<Lit>) {
        let mut aig = Aig::default();
        let mut nets: Vec<Option<Lit>> = vec![None; self.nets];
        nets[Lit::FALSE.code() as usize] = Some(Lit::FALSE);
        nets[Lit::TRUE.code() as usize] = Some(Lit::TRUE);
        for (input, net) in source.inputs().iter().zip(&self.inputs) {
            nets[*net as usize] = Some(aig.add_input(input.name.clone()));
        }
        for register in &self.registers {
            let latch = &source.latches()[register.latch];
            aig.origin = register.origin;
            nets[register.output as usize] = Some(aig.add_latch(latch.name.clone(), latch.initial));
        }
        let value = |nets: &[Option<Lit>], net: u32| {
            nets[net as usize].expect("cells are in order, and every net has a driver")
        };
        for gate in &self.gates {
            let inputs: Vec<Lit> = gate.inputs.iter().map(|&net| value(&nets, net)).collect();
            aig.origin = gate.origin;
            let lit = expand(&mut aig, library.cells[gate.cell].function, &inputs);
            nets[gate.output as usize] = Some(lit);
        }
        for register in &self.registers {
            // With a clock gate, the enable is its input; the flip-flop takes its data at each edge that passes.
            let condition = source.latches()[register.latch].enable;
            let gating = self.clock_gating.iter().find(|gating| gating.condition == condition);
            let enable = gating.map_or(Lit::TRUE, |gating| value(&nets, gating.enable));
            aig.drive_latch(register.latch, value(&nets, register.data), enable);
        }
        for (output, net) in source.outputs.iter().zip(&self.outputs) {
            aig.add_output(output.name.clone(), value(&nets, *net));
        }
        (aig, nets.into_iter().map(|lit| lit.unwrap_or(Lit::FALSE)).collect())
    }

    /// For each net, the gates that read it.
    #[must_use]
    pub fn readers(&self) -> Vec<Vec<u32>> {
        let mut readers = vec![Vec::new(); self.nets];
        for (position, gate) in self.gates.iter().enumerate() {
            gate.inputs.iter().for_each(|&net| readers[net as usize].push(position as u32));
        }
        readers
    }
}

/// Gates of a truth table over literals, by Shannon's expansion.
fn expand(aig: &mut Aig, table: u64, inputs: &[Lit]) -> Lit {
    let Some((&last, rest)) = inputs.split_last() else { return Lit::constant(table & 1 == 1) };
    let half = 1 << rest.len();
    let mask = if half == 64 { !0 } else { (1u64 << half) - 1 };
    let (low, high) = (table & mask, table >> half & mask);
    let when_false = expand(aig, low, rest);
    let when_true = expand(aig, high, rest);
    aig.mux(last, when_true, when_false)
}
