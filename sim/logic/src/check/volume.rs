//! Operations in volume, with stalls and bubbles, each lane a stream of its own.

use super::Totals;
use super::operations::{Claims, Operation};
use base::split_mix::hash;
use equivalence::{Model, Ports, Stimulus};
use lanes::Compiled;
use netlist::Engine;
use netlist::{Flat, mask};
use pipelines::catalogue::{StandardFormat, Top};
use rayon::prelude::*;

/// Operations that a block compares.
const BLOCK_VECTORS: u64 = 1 << 16;
/// Blocks that are done before their results are added, in order.
const BLOCKS_AT_ONCE: u64 = 64;

/// Compares at least `vectors` operations of the stream of `seed`, which the compiled netlist executes. Calls
/// `progress` with the number of operations done. Returns `None` if `top` in `format` is not compiled or has no
/// specification.
#[must_use]
pub fn volume(
    top: Top,
    format: StandardFormat,
    netlist: &Flat,
    vectors: u64,
    seed: u64,
    progress: impl Fn(u64),
) -> Option<Totals> {
    let program = compiled::program(top, format)?;
    with_engine(top, format, netlist, || Compiled::new(program), vectors, seed, progress)
}

/// [`volume`] with any engine of `netlist`, at power-up.
#[must_use]
pub fn with_engine<E: Engine>(
    top: Top,
    format: StandardFormat,
    netlist: &Flat,
    engine: impl Fn() -> E + Sync,
    vectors: u64,
    seed: u64,
    progress: impl Fn(u64),
) -> Option<Totals> {
    if top != Top::SharedUnits {
        Operation::new(top, format, netlist, seed)?;
    }
    let blocks = vectors.div_ceil(BLOCK_VECTORS);
    let mut totals = Totals::default();
    for first in (0..blocks).step_by(BLOCKS_AT_ONCE as usize) {
        let results: Vec<Totals> = (first..blocks.min(first + BLOCKS_AT_ONCE))
            .into_par_iter()
            .map(|block| {
                let vectors = BLOCK_VECTORS.min(vectors - block * BLOCK_VECTORS);
                let (name, seed) = (format!("block {block}"), hash(hash(seed) ^ block));
                match Operation::new(top, format, netlist, seed) {
                    Some(operation) => Block::new(name, netlist, engine(), operation).run(vectors),
                    None => modelled(&name, top, format, netlist, engine(), vectors, seed),
                }
            })
            .collect();
        results.into_iter().for_each(|result| totals.add(result));
        progress(totals.vectors);
    }
    Some(totals)
}

/// An operation in flight.
#[derive(Clone, Copy, Default)]
struct InFlight {
    valid: bool,
    tag: u128,
    claims: Claims,
    /// Cycle in which it went in.
    cycle: u64,
}

/// The operations in flight in a lane: as many as the latency in cycles, the oldest at `head`.
#[derive(Clone)]
struct Line {
    operations: Box<[InFlight]>,
    head: usize,
}

impl Line {
    fn oldest(&self) -> &InFlight {
        &self.operations[self.head]
    }

    /// Goes on by an enabled cycle: the oldest operation leaves, another enters.
    fn advance(&mut self, next: InFlight) {
        self.operations[self.head] = next;
        self.head = (self.head + 1) % self.operations.len();
    }
}

/// A part of a stream, with registers at power-up.
struct Block<'n, E> {
    name: String,
    netlist: &'n Flat,
    engine: E,
    operation: Operation,
    lines: Vec<Line>,
    /// The operation that goes into each lane in this cycle, and whether the lane is enabled.
    next: Vec<(InFlight, bool)>,
    enable: usize,
    valid: usize,
    tag: usize,
    valid_out: usize,
    tag_out: usize,
    totals: Totals,
}

impl<'n, E: Engine> Block<'n, E> {
    fn new(name: String, netlist: &'n Flat, mut engine: E, operation: Operation) -> Self {
        engine.reset();
        let ports = Ports::new(netlist);
        let empty = vec![InFlight::default(); operation.latency_cycles].into_boxed_slice();
        Self {
            lines: vec![Line { operations: empty, head: 0 }; engine.lanes()],
            next: vec![(InFlight::default(), false); engine.lanes()],
            enable: ports.input("en_i"),
            valid: ports.input("valid_i"),
            tag: ports.input("tag_i"),
            valid_out: ports.output("valid_o"),
            tag_out: ports.output("tag_o"),
            name,
            netlist,
            engine,
            operation,
            totals: Totals::default(),
        }
    }

    fn run(mut self, vectors: u64) -> Totals {
        while self.totals.vectors < vectors {
            self.cycle();
        }
        self.totals
    }

    fn cycle(&mut self) {
        let tags = mask(self.netlist.inputs[self.tag].width);
        let lanes = self.engine.lanes();
        let cycle = self.totals.cycles / lanes as u64;
        for lane in 0..lanes {
            // An eighth of all cycles are stalls; an eighth of the others are bubbles.
            let bits = self.operation.bits();
            let (enable, valid, tag) = (bits & 7 != 0, bits >> 3 & 7 != 0, u128::from(bits >> 6) & tags);
            self.engine.set_input(self.enable, lane, enable.into());
            self.engine.set_input(self.valid, lane, valid.into());
            self.engine.set_input(self.tag, lane, tag);
            let claims = self.operation.drive(&mut self.engine, lane);
            self.next[lane] = (InFlight { valid, tag, claims, cycle }, enable);
        }
        self.engine.settle();
        for lane in 0..lanes {
            self.compare(cycle, lane);
            let (next, enabled) = self.next[lane];
            if enabled {
                self.totals.vectors += u64::from(self.lines[lane].oldest().valid);
                self.lines[lane].advance(next);
            }
        }
        self.engine.clock();
        self.totals.cycles += lanes as u64;
    }

    fn compare(&mut self, cycle: u64, lane: usize) {
        let shown = self.lines[lane].oldest();
        let mut wrong = None;
        let mut check = |output: usize, expected: u128| {
            let found = self.engine.output(output, lane);
            if found != expected {
                wrong.get_or_insert((output, expected, found));
            }
        };
        check(self.valid_out, shown.valid.into());
        if shown.valid {
            check(self.tag_out, shown.tag);
            for (claim, &output) in self.operation.outputs.iter().enumerate() {
                if shown.claims.claimed >> claim & 1 == 1 {
                    check(output, shown.claims.values[claim].into());
                }
            }
        }
        if let Some((output, expected, found)) = wrong {
            let went_in = shown.cycle;
            self.totals.mismatches += 1;
            let (block, output) = (&self.name, &self.netlist.outputs[output].0.name);
            self.totals.first.get_or_insert_with(|| {
                format!(
                    "{block}, lane {lane}, cycle {cycle}: {output} is {found:#x}, and should be {expected:#x} for the \
                     operation of cycle {went_in}"
                )
            });
        }
    }
}

/// A block with the claims of [`Model`], which knows every top and is much slower.
fn modelled<E: Engine>(
    block: &str,
    top: Top,
    format: StandardFormat,
    netlist: &Flat,
    mut engine: E,
    vectors: u64,
    seed: u64,
) -> Totals {
    engine.reset();
    let mut lanes: Vec<(Stimulus, Model)> = (0..engine.lanes() as u64)
        .map(|lane| {
            (Stimulus::new(top, format, netlist, hash(seed ^ lane)), Model::new(top, format, netlist))
        })
        .collect();
    let mut totals = Totals::default();
    while totals.vectors < vectors {
        let cycle = totals.cycles / lanes.len() as u64;
        let mut inputs = Vec::with_capacity(lanes.len());
        for (lane, (stimulus, _)) in lanes.iter_mut().enumerate() {
            let values = stimulus.next().expect("streams are endless");
            values.iter().enumerate().for_each(|(input, &value)| engine.set_input(input, lane, value));
            inputs.push(values);
        }
        engine.settle();
        for (lane, (_, model)) in lanes.iter_mut().enumerate() {
            for (claim, _) in model.due() {
                let found = engine.output(claim.output, lane);
                if found != claim.value {
                    totals.mismatches += 1;
                    let output = &netlist.outputs[claim.output].0.name;
                    totals.first.get_or_insert_with(|| {
                        format!(
                            "{block}, lane {lane}, cycle {cycle}: {output} is {found:#x}, and should be {:#x}",
                            claim.value
                        )
                    });
                }
            }
            totals.vectors += u64::from(model.clock(&inputs[lane], |_| ()));
        }
        engine.clock();
        totals.cycles += lanes.len() as u64;
    }
    totals
}
