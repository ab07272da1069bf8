//! Buffers for nets that many gates read.

use crate::aig::{Aig, Origin};
use crate::liberty::Library;
use crate::liberty::function::variable;
use crate::map::{Gate, Mapped};

/// Most readers of a net, or of a buffer.
const MOST_READERS: usize = 20;

/// A reader of a net.
#[derive(Clone, Copy)]
enum Reader {
    Gate(usize, usize),
    Data(usize),
}

/// Splits nets with many readers by buffers, in as many ranks as it takes.
pub fn buffer(mapped: &mut Mapped, aig: &Aig, library: &Library) {
    let cell = library.smallest(1, variable(0)).expect("every library read has a buffer");
    let mut readers: Vec<Vec<Reader>> = vec![Vec::new(); mapped.nets];
    for (position, gate) in mapped.gates.iter().enumerate() {
        for (pin, &net) in gate.inputs.iter().enumerate() {
            readers[net as usize].push(Reader::Gate(position, pin));
        }
    }
    for (position, register) in mapped.registers.iter().enumerate() {
        readers[register.data as usize].push(Reader::Data(position));
    }
    // The buffers that come before all gates, for nets that no gate drives, and those behind each gate.
    let mut first: Vec<Gate> = Vec::new();
    let mut behind: Vec<Vec<Gate>> = vec![Vec::new(); mapped.gates.len()];
    let mut driver = vec![None; mapped.nets];
    for (position, gate) in mapped.gates.iter().enumerate() {
        driver[gate.output as usize] = Some(position);
    }
    for net in 0..readers.len() {
        let lit = mapped.literals[net];
        let origin = driver[net].map_or_else(
            || shared_origin(mapped, aig, lit.node(), &readers[net]),
            |g: usize| mapped.gates[g].origin,
        );
        let mut ranks: Vec<Gate> = Vec::new();
        let mut open = std::mem::take(&mut readers[net]);
        while open.len() > MOST_READERS {
            let mut next = Vec::new();
            for group in open.chunks(MOST_READERS) {
                let output = mapped.nets as u32;
                mapped.nets += 1;
                mapped.literals.push(lit);
                for &reader in group {
                    redirect(mapped, &mut ranks, reader, output);
                }
                // A reader with a number beyond the netlist's gates is a buffer of this net.
                next.push(Reader::Gate(mapped.gates.len() + ranks.len(), 0));
                ranks.push(Gate { cell, inputs: vec![net as u32], output, origin });
            }
            open = next;
        }
        // The last rank drives the first.
        ranks.reverse();
        match driver[net] {
            Some(position) => behind[position] = ranks,
            None => first.extend(ranks),
        }
    }
    let gates = std::mem::take(&mut mapped.gates);
    mapped.gates = first;
    for (gate, buffers) in gates.into_iter().zip(behind) {
        mapped.gates.push(gate);
        mapped.gates.extend(buffers);
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
