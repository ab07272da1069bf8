//! Buffers for nets that many gates read.

use super::drivers;
use crate::aig::{Aig, Origin};
use crate::liberty::Library;
use crate::liberty::function::variable;
use crate::map::{Gate, Mapped};

/// Most readers of a net, or of a buffer.
const MOST_READERS: usize = 20;

/// A reader of a net.
#[derive(Clone, Copy)]
pub(super) enum Reader {
    Gate(usize, usize),
    Data(usize),
}

/// The readers of each net.
pub(super) fn readers(mapped: &Mapped) -> Vec<Vec<Reader>> {
    let mut readers: Vec<Vec<Reader>> = vec![Vec::new(); mapped.nets];
    for (position, gate) in mapped.gates.iter().enumerate() {
        for (pin, &net) in gate.inputs.iter().enumerate() {
            readers[net as usize].push(Reader::Gate(position, pin));
        }
    }
    for (position, register) in mapped.registers.iter().enumerate() {
        readers[register.data as usize].push(Reader::Data(position));
    }
    readers
}

/// Splits nets with many readers by buffers, in as many ranks as it takes.
pub fn buffer(mapped: &mut Mapped, aig: &Aig, library: &Library) {
    let cell = library.smallest(1, variable(0)).expect("every library read has a buffer");
    let mut places = Places::new(mapped);
    for (net, mut open) in readers(mapped).into_iter().enumerate() {
        let origin = places.origin(mapped, aig, net, &open);
        let mut ranks: Vec<Gate> = Vec::new();
        while open.len() > MOST_READERS {
            let mut next = Vec::new();
            for group in open.chunks(MOST_READERS) {
                // A reader with a number beyond the netlist's gates is a buffer of this net.
                next.push(Reader::Gate(mapped.gates.len() + ranks.len(), 0));
                let rank = split(mapped, &mut ranks, net, group, cell, origin);
                ranks.push(rank);
            }
            open = next;
        }
        places.put(net, ranks);
    }
    places.rebuild(mapped);
}

/// Puts one buffer before each of some groups of readers of a net.
pub(super) fn insert(mapped: &mut Mapped, aig: &Aig, cell: usize, groups: Vec<(usize, Vec<Reader>)>) {
    let mut places = Places::new(mapped);
    for (net, group) in groups {
        let origin = places.origin(mapped, aig, net, &group);
        let rank = split(mapped, &mut [], net, &group, cell, origin);
        places.put(net, vec![rank]);
    }
    places.rebuild(mapped);
}

/// A buffer of `net` that a group of readers reads instead.
fn split(
    mapped: &mut Mapped,
    ranks: &mut [Gate],
    net: usize,
    group: &[Reader],
    cell: usize,
    origin: Origin,
) -> Gate {
    let output = mapped.nets as u32;
    mapped.nets += 1;
    mapped.literals.push(mapped.literals[net]);
    for &reader in group {
        redirect(mapped, ranks, reader, output);
    }
    Gate { cell, inputs: vec![net as u32], output, origin }
}

/// Where new buffers go in the order of gates.
struct Places {
    driver: Vec<Option<u32>>,
    /// Before all gates, for nets that no gate drives.
    first: Vec<Gate>,
    /// Behind each gate.
    behind: Vec<Vec<Gate>>,
}

impl Places {
    fn new(mapped: &Mapped) -> Self {
        Self { driver: drivers(mapped), first: Vec::new(), behind: vec![Vec::new(); mapped.gates.len()] }
    }

    /// The origin of buffers of a net: its gate's, or else that of all readers' region, or else its own.
    fn origin(&self, mapped: &Mapped, aig: &Aig, net: usize, readers: &[Reader]) -> Origin {
        match self.driver[net] {
            Some(gate) => mapped.gates[gate as usize].origin,
            None => shared_origin(mapped, aig, mapped.literals[net].node(), readers),
        }
    }

    /// Puts the buffers of a net behind its driver, the last rank first, as it drives the others.
    fn put(&mut self, net: usize, mut ranks: Vec<Gate>) {
        ranks.reverse();
        match self.driver[net] {
            Some(gate) => self.behind[gate as usize] = ranks,
            None => self.first.extend(ranks),
        }
    }

    fn rebuild(self, mapped: &mut Mapped) {
        let gates = std::mem::replace(&mut mapped.gates, self.first);
        for (gate, buffers) in gates.into_iter().zip(self.behind) {
            mapped.gates.push(gate);
            mapped.gates.extend(buffers);
        }
    }
}

fn redirect(mapped: &mut Mapped, ranks: &mut [Gate], reader: Reader, net: u32) {
    match reader {
        Reader::Gate(position, pin) => match position.checked_sub(mapped.gates.len()) {
            Some(rank) => ranks[rank].inputs[pin] = net,
            None => mapped.gates[position].inputs[pin] = net,
        },
        Reader::Data(position) => mapped.registers[position].data = net,
    }
}

/// Buffers behind an input or a register belong to the region that reads it, if that is one, or else to its own.
fn shared_origin(mapped: &Mapped, aig: &Aig, node: usize, readers: &[Reader]) -> Origin {
    let mut origins = readers.iter().map(|reader| match *reader {
        Reader::Gate(position, _) => mapped.gates[position].origin,
        Reader::Data(position) => mapped.registers[position].origin,
    });
    let own = aig.origin_of(node);
    let first = origins.next().unwrap_or(own);
    if origins.all(|origin| origin.region == first.region) { first } else { own }
}
