//! Reads an annotated listing: the compiler's output with entry points, addresses and conditions named behind `#:`.
//!
//! ```text
//! $BB0_5:                         #: node            an entry point, where an event of the traversal begins
//!     LOAD $15, $14, 6            #: node            relative to the address that the event gives as `node`
//!     LOAD $f19, $15, 0           #: children+8      8 words behind `children`
//!     bgez $15, $BB0_12           #: leaf            taken if the event says `leaf`; `!leaf`: if it does not
//! ```

use super::isa::{Decoded, decode};
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

    /// Index of the entry point `name`.
    #[must_use]
    pub fn entry(&self, name: &str) -> Option<usize> {
        self.entries.iter().find(|(_, n)| n.as_str() == name).map(|(at, _)| *at)
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
