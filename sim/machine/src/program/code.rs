//! What a program executes: the operations of its runs, made of a listing's instructions.

use super::EntryId;
use super::listing::{Instruction, Listing};
use super::operation::{Opcode, Place};
use super::registers::{REGISTERS, Register};
use super::run::{Kind, MicroOp, Operands, Run, pool_of};
use super::scoreboard::{Accesses, BoardEntry, READY, SINK, Scoreboard, Stretch};
use crate::description::MachineDescription;

/// The instructions from one entry point to the next.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Route {
    /// Where they begin.
    pub from: EntryId,
    /// The entry point that follows; none at the end of the program.
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
}

/// Which accesses to global memory give a run a new address, by the instructions' indices: the first one since the register
/// that holds it was written, or since control came together. All others are relative to an address that is known.
pub fn new_addresses(listing: &Listing) -> Vec<bool> {
    let leaders = listing.leaders();
    let mut known = [false; REGISTERS];
    let of = |(at, instruction): (usize, &Instruction)| {
        if leaders[at] {
            known = [false; REGISTERS];
        }
        let operation = &instruction.operation;
        let is_new = is_global(instruction) && !std::mem::replace(&mut known[usize::from(operation.a)], true);
        operation.accesses(&listing.lists).1.iter().for_each(|written| known[usize::from(*written)] = false);
        is_new
    };
    listing.instructions.iter().enumerate().map(of).collect()
}

fn is_global(instruction: &Instruction) -> bool {
    matches!(instruction.operation.place(), Place::Load | Place::Store)
}

impl Code {
    /// The code of `source`, with a run for each of its routes.
    ///
    /// # Errors
    /// The index of an instruction before which a run has too many addresses.
    pub fn new(source: &Source<'_>) -> Result<Self, usize> {
        let stretch = |route: &Route| Stretch {
            from: route.from,
            to: route.to,
            operations: route.instructions.iter().map(|at| source.accesses(*at)).collect(),
        };
        let stretches: Vec<Stretch> = source.routes.iter().map(stretch).collect();
        let board = Scoreboard::new(&stretches, source.entries);
        let mut code =
            Self { ops: vec![], places: vec![], operands: vec![Operands::default()], runs: vec![] };
        let is_new = new_addresses(source.listing);
        for number in 0..source.routes.len() {
            code.add_run(source, number, &board, &is_new)?;
        }
        Ok(code)
    }

    fn add_run(
        &mut self,
        source: &Source<'_>,
        number: usize,
        board: &Scoreboard,
        is_new: &[bool],
    ) -> Result<(), usize> {
        let route = &source.routes[number];
        let first = self.ops.len() as u32;
        let mut addresses = 0u8;
        let mut address_of = [0u8; REGISTERS];
        let known = board.waits[number].iter().zip(&board.notes[number]);
        for (&at, (waits, notes)) in route.instructions.iter().zip(known) {
            let instruction = &source.listing.instructions[at];
            let mut address = (0, 0);
            if is_global(instruction) {
                let base = usize::from(instruction.operation.a);
                if is_new[at] {
                    address_of[base] = addresses;
                    addresses = addresses.checked_add(1).ok_or(at)?;
                }
                address = (address_of[base], instruction.operation.offset() as u16);
            }
            let bank = (at as u32 & (source.machine.icache.banks - 1)) as u8;
            let op = self.operation(source, instruction, address, waits, *notes, board);
            self.ops.push(MicroOp { bank, ..op });
        }
        let length = self.ops.len() as u32 - first;
        let place = |at: &usize| source.listing.instructions[*at].operation.place();
        self.places.push(route.instructions.iter().map(place).collect());
        self.runs.push(Run { first, length, addresses, next: route.to });
        Ok(())
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
        let place = instruction.operation.place();
        let kind = match place {
            Place::Nop => Kind::Nop,
            Place::Load => Kind::Load,
            Place::Store => Kind::Store,
            Place::Counter => Kind::Counter,
            _ => Kind::Plain,
        };
        let entries = |registers: &[Register]| registers.iter().map(|r| board.entry(*r)).collect();
        // A word of a wide load that is loaded to register zero is brought all the same.
        let written = match instruction.operation.opcode {
            Opcode::LoadWords => {
                source.listing.lists[instruction.operation.list().expect("its words")].clone()
            }
            _ => instruction.operation.accesses(&source.listing.lists).1,
        };
        let (waits, writes): (Vec<BoardEntry>, Vec<BoardEntry>) = (entries(waits), entries(&written));
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
        let (pool, latency) = (pool_of(place), source.latency_cycles(place) as u8);
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
        let operation = &self.listing.instructions[at].operation;
        let place = operation.place();
        let latency_cycles = (place != Place::Load).then(|| self.latency_cycles(place));
        let (reads, writes) = operation.accesses(&self.listing.lists);
        Accesses { reads, writes, latency_cycles }
    }
}
