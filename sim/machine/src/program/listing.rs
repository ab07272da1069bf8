//! Reads a listing: an assembler file as the compiler writes it.
//!
//! Of the directives, `.4byte` and `.word` give the value of a constant behind its label. Those that compilers write beside them are
//! skipped, as are comments from `#` to the end of the line; others are errors. The program begins at `main`, and has at most [`MOST_INSTRUCTIONS`].

use super::decode::{Context, Decoded, Test, decode, integer};
use super::operation::{Opcode, Operation};
use super::registers::Register;
use std::collections::HashMap;

/// Most instructions of a listing, several times those of the longest that comes with this crate.
pub const MOST_INSTRUCTIONS: usize = 1 << 13;

/// Why a listing cannot be used.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{program}, line {line}: {message}")]
pub struct ListingError {
    /// The program.
    pub program: String,
    /// Line from 1.
    pub line: usize,
    /// What is wrong.
    pub message: String,
}

/// An instruction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Instruction {
    /// Line in the listing, from 1.
    pub line: u32,
    /// What it does.
    pub operation: Operation,
    /// Where control goes.
    pub control: Control,
}

/// What follows an instruction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Control {
    /// The next instruction.
    Next,
    /// After the delay slot, the instruction with this index if the test of the operation's registers holds.
    Branch(Test, usize),
    /// The next instruction, in the next item of work.
    Counter,
    /// After the delay slot, the end of the program.
    End,
}

/// A listing, read.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Listing {
    /// All instructions in the order of addresses.
    pub instructions: Vec<Instruction>,
    /// Lists of registers of operations with many operands.
    pub lists: Vec<Vec<Register>>,
    /// Index of the first instruction that is executed.
    pub start: usize,
}

impl Listing {
    /// Reads `text`.
    ///
    /// # Errors
    /// See [`ListingError`].
    pub fn parse(program: &str, text: &str) -> Result<Self, ListingError> {
        let fail = |line: usize, message: String| ListingError { program: program.to_owned(), line, message };
        let lines: Vec<(usize, &str)> = text
            .lines()
            .enumerate()
            .map(|(index, line)| (index + 1, line.split('#').next().unwrap_or_default().trim()))
            .filter(|(_, code)| !code.is_empty())
            .collect();
        let mut context = Context { constants: constants(&lines), lists: vec![] };
        let mut listing = Self::default();
        let mut labels: HashMap<&str, usize> = HashMap::new();
        let mut targets: Vec<(usize, &str)> = vec![];
        for &(line, code) in &lines {
            let at = listing.instructions.len();
            if let Some(label) = code.strip_suffix(':') {
                if labels.insert(label, at).is_some() {
                    return Err(fail(line, format!("label `{label}` is there twice")));
                }
                continue;
            }
            if code.starts_with('.') {
                let name = code.split_whitespace().next().unwrap_or_default();
                if !is_directive(name) {
                    let message = format!(
                        "unknown directive `{name}`; leave it away, or write {CONSTANTS:?} for a constant"
                    );
                    return Err(fail(line, message));
                }
                continue;
            }
            if at == MOST_INSTRUCTIONS {
                return Err(fail(line, format!("more than {MOST_INSTRUCTIONS} instructions")));
            }
            let (mnemonic, operands) = code.split_once(char::is_whitespace).unwrap_or((code, ""));
            let operands: Vec<&str> = operands.split(',').map(str::trim).filter(|o| !o.is_empty()).collect();
            let decoded = decode(mnemonic, &operands, &mut context).map_err(|message| {
                fail(line, format!("cannot decode `{}`: {message}", code.replace('\t', " ")))
            })?;
            let (operation, control) = match decoded {
                Decoded::Plain(operation) if operation.opcode == Opcode::Counter => {
                    (operation, Control::Counter)
                }
                Decoded::Plain(operation) => (operation, Control::Next),
                Decoded::Branch(operation, test, label) => {
                    targets.push((at, label));
                    (operation, Control::Branch(test, 0))
                }
                Decoded::Return(operation) => (operation, Control::End),
            };
            listing.instructions.push(Instruction { line: line as u32, operation, control });
        }
        for (at, label) in targets {
            let line = listing.instructions[at].line as usize;
            let &to = labels.get(label).ok_or_else(|| fail(line, format!("no label `{label}`")))?;
            if to >= listing.instructions.len() {
                return Err(fail(line, format!("nothing follows label `{label}`")));
            }
            if let Control::Branch(_, target) = &mut listing.instructions[at].control {
                *target = to;
            }
        }
        let count = listing.instructions.len();
        listing.start = labels.get("main").copied().unwrap_or(0);
        if listing.start >= count {
            return Err(fail(1, "there are no instructions behind `main:`".to_owned()));
        }
        let leaders = listing.leaders();
        for (at, instruction) in listing.instructions.iter().enumerate() {
            let line = instruction.line as usize;
            let next = listing.instructions.get(at + 1);
            match instruction.control {
                // The last delay slot is no place to come to by a jump.
                Control::Next | Control::Counter
                    if next.is_none() && (!listing.is_slot(at) || leaders[at]) =>
                {
                    return Err(fail(line, "the program goes on behind its last instruction".to_owned()));
                }
                Control::Branch(..) | Control::End
                    if next.is_none_or(|next| next.control != Control::Next) =>
                {
                    let message =
                        "the delay slot has to hold an instruction that is no branch and no ATOMIC_INC";
                    return Err(fail(line, message.to_owned()));
                }
                Control::Branch(test, _) if test != Test::Always && at + 2 == count => {
                    return Err(fail(line, "the program goes on behind its last instruction".to_owned()));
                }
                _ => {}
            }
        }
        listing.lists = context.lists;
        Ok(listing)
    }

    /// Whether the instruction with index `at` is the delay slot of one before.
    fn is_slot(&self, at: usize) -> bool {
        let before = at.checked_sub(1).map(|before| self.instructions[before].control);
        matches!(before, Some(Control::Branch(..) | Control::End))
    }

    /// Which instructions control can come to from elsewhere than the instruction before, by their indices.
    #[must_use]
    pub fn leaders(&self) -> Vec<bool> {
        let mut leaders = vec![false; self.instructions.len() + 1];
        leaders[self.start] = true;
        for (at, instruction) in self.instructions.iter().enumerate() {
            match instruction.control {
                Control::Next => {}
                Control::Counter => leaders[at + 1] = true,
                Control::End => leaders[(at + 2).min(self.instructions.len())] = true,
                Control::Branch(_, to) => {
                    leaders[to] = true;
                    leaders[(at + 2).min(self.instructions.len())] = true;
                }
            }
        }
        leaders
    }

    /// Joins loads of adjacent words into loads of up to `words` words, as a machine with wider loads would be programmed:
    /// a load moves up to an earlier one if nothing between them uses its registers, stores, or can be jumped to.
    pub fn widen_loads(&mut self, words: usize) {
        let count = self.instructions.len();
        let leaders = self.leaders();
        let leaves = |at: usize, all: &[Instruction]| all[at].control != Control::Next;
        let mut joined = vec![false; count];
        for at in 0..count {
            let first = self.instructions[at].operation;
            let is_slot = self.is_slot(at);
            if joined[at] || first.opcode != Opcode::Load || first.d == first.a || is_slot {
                continue;
            }
            let mut loaded = vec![first.d];
            // Registers that instructions between have read or written.
            let mut used: Vec<Register> = vec![];
            for next in at + 1..count {
                // A delay slot is as far as straight code goes.
                let all = &self.instructions;
                if loaded.len() >= words || leaders[next] || leaves(next, all) || leaves(next - 1, all) {
                    break;
                }
                if joined[next] {
                    continue;
                }
                let operation = all[next].operation;
                let adjoins = operation.opcode == Opcode::Load
                    && operation.a == first.a
                    && operation.offset() == first.offset() + loaded.len() as u32;
                if adjoins && !used.contains(&operation.d) {
                    joined[next] = true;
                    loaded.push(operation.d);
                    if operation.d == first.a {
                        break;
                    }
                    continue;
                }
                let (reads, writes) = operation.accesses(&self.lists);
                if writes.contains(&first.a) || operation.opcode == Opcode::Store {
                    break;
                }
                used.extend(reads.iter().chain(&writes));
            }
            if loaded.len() > 1 {
                let immediate = (self.lists.len() as i32) << 16 | first.offset() as i32;
                self.lists.push(loaded);
                self.instructions[at].operation = Operation { opcode: Opcode::LoadWords, immediate, ..first };
            }
        }
        self.remove(&joined);
    }

    /// Removes the instructions marked in `gone`; what was aimed at one is aimed at the next.
    fn remove(&mut self, gone: &[bool]) {
        let mut place = Vec::with_capacity(gone.len() + 1);
        let mut kept = 0;
        for gone in gone {
            place.push(kept);
            kept += usize::from(!gone);
        }
        place.push(kept);
        let mut number = 0;
        self.instructions.retain(|_| {
            number += 1;
            !gone[number - 1]
        });
        for instruction in &mut self.instructions {
            if let Control::Branch(_, to) = &mut instruction.control {
                *to = place[*to];
            }
        }
        self.start = place[self.start];
    }
}

/// Directives that give the value of a constant.
const CONSTANTS: [&str; 2] = [".4byte", ".word"];

/// Directives that compilers write and that say nothing about what is executed.
const SKIPPED: [&str; 26] = [
    ".abicalls",
    ".addrsig",
    ".align",
    ".asciz",
    ".byte",
    ".data",
    ".end",
    ".ent",
    ".file",
    ".fmask",
    ".frame",
    ".globl",
    ".ident",
    ".loc",
    ".mask",
    ".module",
    ".nan",
    ".option",
    ".p2align",
    ".previous",
    ".rdata",
    ".section",
    ".set",
    ".size",
    ".text",
    ".type",
];

fn is_directive(name: &str) -> bool {
    CONSTANTS.contains(&name) || SKIPPED.contains(&name) || name.starts_with(".cfi_")
}

/// The constants of a program: the words behind labels.
fn constants<'a>(lines: &[(usize, &'a str)]) -> HashMap<&'a str, u32> {
    let mut constants = HashMap::new();
    for pair in lines.windows(2) {
        let [(_, label), (_, value)] = pair else { continue };
        let value = CONSTANTS.iter().find_map(|directive| value.strip_prefix(directive));
        if let (Some(label), Some(value)) = (label.strip_suffix(':'), value.map(str::trim).and_then(integer))
        {
            constants.insert(label, value as u32);
        }
    }
    constants
}
