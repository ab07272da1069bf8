//! What a run does when nobody is in its way: the cycles that it takes alone, the units that it uses, and its accesses.

use crate::program::{BOARD_ENTRIES, BoardEntry, Kind, MicroOp, POOLS, Program, RunId};

/// A load or store of a run.
#[derive(Clone, Copy, Debug)]
pub struct Access {
    /// Which of the run's addresses it is relative to.
    pub base: u8,
    /// Whether it is a store.
    pub stores: bool,
    /// Words behind that address.
    pub offset: u16,
    /// Number of words.
    pub words: u8,
    /// Cycles from the run's start to its issue.
    pub issue: u16,
    /// Cycles from the run's start to the first operation that reads what it brings, or [`LATER`].
    pub used: u16,
    /// Registers that it brings.
    pub registers: Registers,
}

/// A value is read in a later run.
pub const LATER: u16 = u16::MAX;

/// A set of registers, by their entries on the scoreboard.
pub type Registers = u128;

/// The set of one. A machine has fewer registers that anybody waits for than a set has places.
fn only(entry: BoardEntry) -> Registers {
    1 << (entry % 128)
}

/// What a run does.
#[derive(Clone, Debug, Default)]
pub struct RunProfile {
    /// Number of addresses that it has on a tape.
    pub addresses: u32,
    /// Instructions.
    pub length: u32,
    /// Those that are nops.
    pub nops: u32,
    /// Uses of each pool.
    pub uses: [u32; POOLS],
    /// Trains of fetches: operations that are fetched one after another, a cycle and a bank each.
    pub fetch_trains: u32,
    /// Loads and stores in order.
    pub accesses: Vec<Access>,
    /// Registers that it waits for, each with the cycles from the run's start to the first operation that does.
    pub reads: Vec<(Registers, u16)>,
}

/// All runs of a program.
#[derive(Clone, Debug)]
pub struct Profile {
    /// By number.
    pub runs: Vec<RunProfile>,
    /// Cycles that a run takes alone, by the run before it; [`UNKNOWN`] until they are asked for.
    cycles: Vec<u32>,
}

const UNKNOWN: u32 = u32::MAX;

/// Issues operations one after another as soon as their operands are ready.
struct Issue {
    ready: [u32; BOARD_ENTRIES],
    now: u32,
}

impl Issue {
    /// Issues `op`, which takes `cycles` until its result can be used; returns the cycle.
    fn issue(&mut self, program: &Program, op: &MicroOp) -> u32 {
        let operands = program.operands_of(op);
        let reads = op.reads.iter().chain(&operands.reads);
        let at = reads.map(|entry| self.ready[usize::from(*entry)]).fold(self.now, u32::max);
        for entry in written(program, op) {
            self.ready[usize::from(*entry)] = at + u32::from(op.latency);
        }
        // Nobody waits for what is always ready.
        self.ready[0] = 0;
        self.now = at + 1;
        at
    }
}

fn written<'a>(program: &'a Program, op: &'a MicroOp) -> &'a [BoardEntry] {
    match &program.operands_of(op).writes[..] {
        [] => std::slice::from_ref(&op.write),
        several => several,
    }
}

impl Profile {
    /// The runs of `program`.
    pub fn new(program: &Program) -> Self {
        let count = program.code.runs.len();
        let runs = (0..count as RunId).map(|run| RunProfile::new(program, run)).collect();
        Self { runs, cycles: vec![UNKNOWN; (count + 1) * count] }
    }

    /// Cycles that `run` takes alone if it follows `before`; at the start, nothing does.
    #[inline]
    pub fn cycles(&mut self, program: &Program, before: Option<RunId>, run: RunId) -> u32 {
        let count = self.runs.len();
        let at = before.map_or(count, |before| before as usize) * count + run as usize;
        if self.cycles[at] == UNKNOWN {
            let mut issue = Issue { ready: [0; BOARD_ENTRIES], now: 0 };
            let ops = before.map_or(&[][..], |before| program.ops_of(before));
            ops.iter().for_each(|op| _ = issue.issue(program, op));
            let start = issue.now;
            program.ops_of(run).iter().for_each(|op| _ = issue.issue(program, op));
            self.cycles[at] = issue.now - start;
        }
        self.cycles[at]
    }
}

impl RunProfile {
    fn new(program: &Program, run: RunId) -> Self {
        let Some(found) = program.code.runs.get(run as usize) else {
            return Self::default();
        };
        let mut profile = Self { addresses: found.addresses.into(), length: found.length, ..Self::default() };
        let mut issue = Issue { ready: [0; BOARD_ENTRIES], now: 0 };
        let mut seen: Registers = 0;
        let mut fetched: Option<(u32, u8)> = None;
        for op in program.ops_of(run) {
            // An operation is fetched in the cycle behind the one before, and then waits for its operands.
            let follows =
                fetched.is_some_and(|(at, bank)| at == issue.now && op.bank == bank.wrapping_add(1));
            profile.fetch_trains += u32::from(!follows);
            let now = issue.issue(program, op);
            fetched = Some((now + 1, op.bank));
            let now = now.min(u32::from(LATER) - 1) as u16;
            profile.nops += u32::from(op.kind == Kind::Nop);
            profile.uses[usize::from(op.pool)] += 1;
            for entry in op.reads.iter().chain(&program.operands_of(op).reads).filter(|entry| **entry != 0) {
                let register = only(*entry);
                let brings = |access: &&mut Access| access.used == LATER && access.registers & register != 0;
                profile.accesses.iter_mut().filter(brings).for_each(|access| access.used = now);
                if seen & register == 0 {
                    profile.reads.push((register, now));
                    seen |= register;
                }
            }
            if matches!(op.kind, Kind::Load | Kind::Store) {
                let written = written(program, op);
                profile.accesses.push(Access {
                    base: op.base,
                    stores: op.kind == Kind::Store,
                    offset: op.offset,
                    words: written.len().max(1) as u8,
                    issue: now,
                    used: LATER,
                    registers: written.iter().fold(0, |all, entry| all | only(*entry)),
                });
            }
        }
        profile
    }
}
