//! Reads an annotated listing: the compiler's output with entry points, addresses and conditions named behind `#:`.
//!
//! ```text
//! $BB0_5:                         #: node            an entry point, where an event of the traversal begins
//!     LOAD $15, $14, 6            #: node            relative to the address that the event gives as `node`
//!     LOAD $f19, $15, 0           #: children+8      8 words behind `children`
//!     bgez $15, $BB0_12           #: leaf            taken if the event says `leaf`; `!leaf`: if it does not
//! ```

use super::isa::{Decoded, Place, Register, decode};
use std::collections::BTreeMap;

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
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Instruction {
    /// Line in the listing, from 1.
    pub line: usize,
    /// Place, reads and writes.
    pub decoded: Decoded,
    /// Where control goes.
    pub control: Control,
    /// For loads and stores of global memory: what is addressed, and the offset in words.
    pub address: Option<(String, u32)>,
}

/// What follows an instruction, after its delay slot.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Control {
    /// The next instruction.
    Next,
    /// The instruction with this index.
    Jump(usize),
    /// The instruction with this index if the condition has this value.
    Branch(usize, String, bool),
    /// The end of the program.
    End,
}

/// A listing, read.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Listing {
    /// All instructions in the order of addresses.
    pub instructions: Vec<Instruction>,
    /// Entry points: name of each index.
    pub entries: BTreeMap<usize, String>,
}

impl Listing {
    /// Reads `text`.
    ///
    /// # Errors
    /// See [`ListingError`].
    pub fn parse(program: &str, text: &str) -> Result<Self, ListingError> {
        let mut listing = Self::default();
        let mut labels: BTreeMap<&str, usize> = BTreeMap::new();
        let mut targets: Vec<(usize, &str)> = vec![];
        for (index, whole) in text.lines().enumerate() {
            let line = index + 1;
            let fail = |message: String| ListingError { program: program.to_owned(), line, message };
            let (code, note) = match whole.split_once("#:") {
                Some((code, note)) => (code.trim(), Some(note.trim())),
                None => (whole.split('#').next().unwrap_or_default().trim(), None),
            };
            if code.is_empty() {
                continue;
            }
            let at = listing.instructions.len();
            if let Some(label) = code.strip_suffix(':') {
                labels.insert(label, at);
                if let Some(name) = note {
                    listing.entries.insert(at, name.to_owned());
                }
                continue;
            }
            let (mnemonic, operands) = code.split_once(' ').unwrap_or((code, ""));
            let operands: Vec<&str> = operands.split(',').map(str::trim).filter(|o| !o.is_empty()).collect();
            let decoded =
                decode(mnemonic, &operands).ok_or_else(|| fail(format!("cannot decode `{code}`")))?;
            let control = match mnemonic {
                "jr" => Control::End,
                "j" | "b" => {
                    targets.push((at, operands.last().copied().unwrap_or_default()));
                    Control::Jump(0)
                }
                _ if mnemonic.starts_with('b') => {
                    targets.push((at, operands.last().copied().unwrap_or_default()));
                    let note = note.ok_or_else(|| fail(format!("`{code}` has no condition behind `#:`")))?;
                    match note {
                        "always" => Control::Jump(0),
                        "never" => Control::Next,
                        _ => match note.strip_prefix('!') {
                            Some(name) => Control::Branch(0, name.to_owned(), false),
                            None => Control::Branch(0, note.to_owned(), true),
                        },
                    }
                }
                _ => Control::Next,
            };
            let address = match mnemonic {
                "LOAD" | "STORE" => {
                    let address = note.and_then(|note| address(note, operands.last()?));
                    Some(address.ok_or_else(|| fail(format!("`{code}` has no address behind `#:`")))?)
                }
                _ => None,
            };
            listing.instructions.push(Instruction { line, decoded, control, address });
        }
        for (at, label) in targets {
            let line = listing.instructions[at].line;
            let fail = |message: String| ListingError { program: program.to_owned(), line, message };
            let &target = labels.get(label).ok_or_else(|| fail(format!("no label `{label}`")))?;
            if target >= listing.instructions.len() {
                return Err(fail(format!("nothing follows label `{label}`")));
            }
            match &mut listing.instructions[at].control {
                Control::Jump(to) | Control::Branch(to, ..) => *to = target,
                Control::Next | Control::End => {}
            }
        }
        Ok(listing)
    }

    /// Joins loads of adjacent words into loads of up to `words` words, as a machine with wider loads would be programmed:
    /// a load moves up to an earlier one if nothing between them uses its registers or can be jumped to.
    pub fn widen_loads(&mut self, words: usize) {
        let count = self.instructions.len();
        let mut targets: Vec<bool> = (0..count).map(|at| self.entries.contains_key(&at)).collect();
        for instruction in &self.instructions {
            if let Control::Jump(to) | Control::Branch(to, ..) = instruction.control {
                targets[to] = true;
            }
        }
        let mut joined = vec![false; count];
        for at in 0..count {
            if joined[at] || self.instructions[at].decoded.place != Place::Load {
                continue;
            }
            let first = &self.instructions[at].decoded;
            let changes_base = first.writes.iter().any(|register| first.reads.contains(register));
            if changes_base || at > 0 && self.instructions[at - 1].control != Control::Next {
                continue;
            }
            // Registers that instructions between have read or written.
            let mut used: Vec<Register> = vec![];
            for next in at + 1..count {
                let wide = self.instructions[at].decoded.writes.len();
                // A delay slot is as far as straight code goes.
                let leaves = |at: usize| self.instructions[at].control != Control::Next;
                if wide >= words || targets[next] || leaves(next) || leaves(next - 1) {
                    break;
                }
                if joined[next] {
                    continue;
                }
                let (load, candidate) = (&self.instructions[at], &self.instructions[next]);
                let base = &load.decoded.reads;
                if candidate.adjoins(load) && !candidate.decoded.writes.iter().any(|r| used.contains(r)) {
                    let written = candidate.decoded.writes.clone();
                    joined[next] = true;
                    self.instructions[at].decoded.writes.extend(written);
                    continue;
                }
                if candidate.decoded.writes.iter().any(|register| base.contains(register)) {
                    break;
                }
                used.extend(candidate.decoded.reads.iter().chain(&candidate.decoded.writes));
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
        let all = std::mem::take(&mut self.instructions);
        self.instructions = all
            .into_iter()
            .zip(gone)
            .filter(|(_, gone)| !**gone)
            .map(|(instruction, _)| instruction)
            .collect();
        for instruction in &mut self.instructions {
            if let Control::Jump(to) | Control::Branch(to, ..) = &mut instruction.control {
                *to = place[*to];
            }
        }
        let entries = std::mem::take(&mut self.entries);
        self.entries = entries.into_iter().map(|(at, name)| (place[at], name)).collect();
    }

    /// Index of the entry point `name`.
    #[must_use]
    pub fn entry(&self, name: &str) -> Option<usize> {
        self.entries.iter().find(|(_, n)| n.as_str() == name).map(|(at, _)| *at)
    }
}

impl Instruction {
    /// Whether this load brings the word behind those that `load` brings.
    fn adjoins(&self, load: &Self) -> bool {
        let (Some((base, offset)), Some((other, next))) = (&load.address, &self.address) else {
            return false;
        };
        self.decoded.place == Place::Load
            && base == other
            && offset + load.decoded.writes.len() as u32 == *next
            && load.decoded.reads == self.decoded.reads
    }
}

/// `base` or `base+offset` of a note, with the instruction's own offset added.
fn address(note: &str, offset: &str) -> Option<(String, u32)> {
    let offset: u32 = offset.parse().ok()?;
    match note.split_once('+') {
        Some((base, more)) => Some((base.to_owned(), offset + more.parse::<u32>().ok()?)),
        None => Some((note.to_owned(), offset)),
    }
}
