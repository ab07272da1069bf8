//! Changes with glitches: an event-driven simulation with the cells' delays.
//!
//! Every gate has one delay for each input, that of its slower edge; a pulse shorter than the delay is swallowed
//! (inertial delay). Flip-flops change at the clock edge, after their own delay; inputs at the edge.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::aig::{Aig, Lit};
use super::liberty::Library;
use super::map::Mapped;
use super::simulate::Simulator;
use super::timing::Timing;

/// Time in femtoseconds, so that equal times are equal.
type Femtoseconds = u64;

/// Changes of each net in one stream of inputs, after the first `skip` cycles; and the cycles counted.
#[must_use]
pub fn changes(
    aig: &Aig,
    mapped: &Mapped,
    library: &Library,
    timing: &Timing,
    inputs: &[Vec<Lit>],
    stream: &[Vec<u128>],
    skip: usize,
) -> (Vec<u64>, u64) {
    let mut simulation = Events::new(mapped, library, timing);
    // The values at the beginning of each cycle come from the graph. After every change has gone through, graph and
    // gates agree.
    let mut settled = Simulator::<1>::new(aig);
    let mut counts = vec![0u64; mapped.nets];
    for (cycle, words) in stream.iter().enumerate() {
        for (port, bits) in inputs.iter().enumerate() {
            settled.set_word(bits, [words[port]]);
        }
        settled.settle();
        let value = |net: u32| settled.value(mapped.literals[net as usize])[0] & 1 == 1;
        if cycle == 0 {
            simulation.set_all(value);
        } else {
            let sources = mapped.inputs.iter().map(|&net| (net, 0));
            let delay = |net: u32| femtoseconds(timing.latest(net));
            let registers = mapped.registers.iter().map(|register| (register.output, delay(register.output)));
            for (net, time) in sources.chain(registers) {
                if simulation.values[net as usize] != value(net) {
                    simulation.schedule_source(net, time, value(net));
                }
            }
            simulation.run(|net| {
                if cycle > skip {
                    counts[net as usize] += 1;
                }
            });
        }
        settled.clock();
    }
    (counts, stream.len().saturating_sub(skip + 1) as u64)
}

fn femtoseconds(ns: f64) -> Femtoseconds {
    (ns.max(0.0) * 1e6) as Femtoseconds
}

struct Events<'m> {
    mapped: &'m Mapped,
    functions: Vec<u64>,
    delays: Vec<Vec<Femtoseconds>>,
    readers: Vec<Vec<u32>>,
    values: Vec<bool>,
    /// Value that each net will have, and the number of the event that brings it.
    planned: Vec<(bool, u64)>,
    queue: BinaryHeap<Reverse<(Femtoseconds, u64, u32)>>,
    number: u64,
}

impl<'m> Events<'m> {
    fn new(mapped: &'m Mapped, library: &Library, timing: &Timing) -> Self {
        Self {
            mapped,
            functions: mapped.gates.iter().map(|gate| library.cells[gate.cell].function).collect(),
            delays: timing
                .delay_ns
                .iter()
                .map(|pins| pins.iter().map(|&ns| femtoseconds(ns)).collect())
                .collect(),
            readers: mapped.readers(),
            values: vec![false; mapped.nets],
            planned: vec![(false, 0); mapped.nets],
            queue: BinaryHeap::new(),
            number: 0,
        }
    }

    fn set_all(&mut self, value: impl Fn(u32) -> bool) {
        for net in 0..self.values.len() {
            self.values[net] = value(net as u32);
            self.planned[net] = (self.values[net], 0);
        }
    }

    fn schedule_source(&mut self, net: u32, time: Femtoseconds, value: bool) {
        self.number += 1;
        self.planned[net as usize] = (value, self.number);
        self.queue.push(Reverse((time, self.number, net)));
    }

    fn run(&mut self, mut changed: impl FnMut(u32)) {
        while let Some(Reverse((time, number, net))) = self.queue.pop() {
            let (value, last) = self.planned[net as usize];
            // A later event has replaced this one.
            if number != last || self.values[net as usize] == value {
                continue;
            }
            self.values[net as usize] = value;
            changed(net);
            for position in 0..self.readers[net as usize].len() {
                let reader = self.readers[net as usize][position] as usize;
                self.evaluate(reader, net, time);
            }
        }
    }

    fn evaluate(&mut self, reader: usize, from: u32, time: Femtoseconds) {
        let gate = &self.mapped.gates[reader];
        let mut row = 0;
        let mut delay = 0;
        for (pin, &net) in gate.inputs.iter().enumerate() {
            row |= usize::from(self.values[net as usize]) << pin;
            if net == from {
                delay = delay.max(self.delays[reader][pin]);
            }
        }
        let value = self.functions[reader] >> row & 1 == 1;
        let output = gate.output as usize;
        if self.planned[output].0 == value {
            return;
        }
        self.number += 1;
        // If the output returns to its present value before the pulse comes out, there is no pulse.
        self.planned[output] = (value, self.number);
        if self.values[output] != value {
            self.queue.push(Reverse((time + delay.max(1), self.number, output as u32)));
        }
    }
}
