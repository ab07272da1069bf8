//! What a program executes: the operations of its runs, made of a listing's instructions.

use super::EntryId;
use super::isa::{Place, Register};
use super::listing::{Instruction, Listing};
use super::run::{Kind, MicroOp, Operands, Run, pool_of};
use super::scoreboard::{Accesses, BoardEntry, READY, SINK, Scoreboard, Stretch};
use crate::description::MachineDescription;

/// The instructions from one entry point to the next.
pub struct Route {
    pub from: EntryId,
    pub to: Option<EntryId>,
    /// Indices into the listing.
    pub instructions: Vec<usize>,
}

/// What a program executes.
#[derive(Clone, Debug)]
pub struct Code {
    /// Operations of all runs.
    pub ops: Vec<MicroOp>,
    /// Where the instructions of each run execute.
    pub places: Vec<Vec<Place>>,
    /// Registers of operations that wait for many or write several; the first are those of all others.
    pub operands: Vec<Operands>,
    /// All runs.
    pub runs: Vec<Run>,
}

/// What code is made of.
pub struct Source<'a> {
    pub listing: &'a Listing,
    pub machine: &'a MachineDescription,
    pub pipeline_latency_cycles: u32,
    pub routes: &'a [Route],
    /// Number of entry points.
    pub entries: usize,
    /// Names of addresses.
    pub bases: &'a [String],
}

impl Code {
    /// The code of `source`, with a run for each of its routes.
    pub fn new(source: &Source<'_>) -> Self {
        let stretch = |route: &Route| Stretch {
            from: route.from,
            to: route.to,
            operations: route.instructions.iter().map(|at| source.accesses(*at)).collect(),
        };
        let stretches: Vec<Stretch> = source.routes.iter().map(stretch).collect();
        let board = Scoreboard::new(&stretches, source.entries);
        let mut code =
            Self { ops: vec![], places: vec![], operands: vec![Operands::default()], runs: vec![] };
        for number in 0..source.routes.len() {
            code.add_run(source, number, &board);
        }
        code
    }

    fn add_run(&mut self, source: &Source<'_>, number: usize, board: &Scoreboard) {
        let route = &source.routes[number];
        let first = self.ops.len() as u32;
        let mut bases: Vec<u8> = vec![];
        let known = board.waits[number].iter().zip(&board.notes[number]);
        for (&at, (waits, notes)) in route.instructions.iter().zip(known) {
            let instruction = &source.listing.instructions[at];
            let mut address = (0, 0);
            if let Some((base, offset)) = &instruction.address {
                let base = source.bases.iter().position(|b| b == base).expect("interned") as u8;
                let slot = bases.iter().position(|b| *b == base).unwrap_or_else(|| {
                    bases.push(base);
                    bases.len() - 1
                });
                address = (slot as u8, *offset as u16);
            }
            let bank = (at as u32 & (source.machine.icache.banks - 1)) as u8;
            let op = self.operation(source, instruction, address, waits, *notes, board);
            self.ops.push(MicroOp { bank, ..op });
        }
        let length = self.ops.len() as u32 - first;
        let place = |at: &usize| source.listing.instructions[*at].decoded.place;
        self.places.push(route.instructions.iter().map(place).collect());
        self.runs.push(Run { first, length, bases, next: route.to });
    }

    fn operation(
        &mut self,
        source: &Source<'_>,
        instruction: &Instruction,
        (base, offset): (u8, u16),
        waits: &[Register],
        notes: bool,
        board: &Scoreboard,
    ) -> MicroOp {
        let decoded = &instruction.decoded;
        let kind = match decoded.place {
            Place::Nop => Kind::Nop,
            Place::Load => Kind::Load,
            Place::Store => Kind::Store,
            Place::Counter => Kind::Counter,
            _ => Kind::Plain,
        };
        let entries = |registers: &[Register]| registers.iter().map(|r| board.entry(*r)).collect();
        let (waits, writes): (Vec<BoardEntry>, Vec<BoardEntry>) = (entries(waits), entries(&decoded.writes));
        let write = writes.first().copied().filter(|_| notes).unwrap_or(SINK);
        let reads = match waits[..] {
            [] => [READY; 2],
            [first, second] => [first, second],
            [first, ..] => [first, READY],
        };
        let further = Operands {
            writes: if writes.len() > 1 { writes } else { vec![] },
            reads: if waits.len() > 2 { waits[1..].to_vec() } else { vec![] },
        };
        let operands = self.operands.iter().position(|known| *known == further).unwrap_or_else(|| {
            self.operands.push(further);
            self.operands.len() - 1
        });
        let (pool, latency) = (pool_of(decoded.place), source.latency_cycles(decoded.place) as u8);
        MicroOp { kind, bank: 0, reads, write, pool, latency, base, offset, operands: operands as u16 }
    }
}

impl Source<'_> {
    fn latency_cycles(&self, place: Place) -> u32 {
        match place {
            Place::Unit(unit) => self.machine.units.pool(unit).latency_cycles,
            Place::Load => self.machine.l1.latency_cycles,
            Place::Pipeline => self.pipeline_latency_cycles,
            _ => 1,
        }
    }

    fn accesses(&self, at: usize) -> Accesses {
        let decoded = &self.listing.instructions[at].decoded;
        let latency_cycles = (decoded.place != Place::Load).then(|| self.latency_cycles(decoded.place));
        Accesses { reads: decoded.reads.clone(), writes: decoded.writes.clone(), latency_cycles }
    }
}
