//! What a program does wrong.

use super::local_store::{LOCAL_STORE_BYTES, Misplaced};
use super::memory::Denied;
use crate::program::{Program, Register, register_name};
use render::SAMPLE_DIMENSIONS;
use std::fmt;

/// A mistake that shows when a program is executed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{program}, line {line}, in item {item}: {mistake}")]
pub struct Fault {
    /// The program.
    pub program: String,
    /// Line of the instruction, from 1.
    pub line: u32,
    /// The item of work, from 0.
    pub item: u32,
    /// What is wrong.
    pub mistake: Mistake,
}

/// What is wrong.
#[derive(Clone, Debug, PartialEq)]
pub enum Mistake {
    /// A load from global memory fails.
    Load(u32, Denied),
    /// A store to global memory fails.
    Store(u32, Denied),
    /// An access to the local store fails.
    Local(u32, Misplaced),
    /// It reads a byte address of the local store that an earlier item has changed.
    LocalLeft(u32),
    /// It reads a register that an earlier item has changed.
    RegisterLeft(Register),
    /// It asks for more random numbers than an item has.
    Random,
    /// A lane that does not exist, or more than there are.
    Lane(u32),
    /// So many instructions have been executed without asking for a new item.
    NoProgress(u64),
    /// It asks for another item after it has got the number of all items.
    AsksOn,
    /// The picture is not golden's: channel, bits of the program's value (none if it has written none), bits of golden's.
    Picture {
        /// Column and row.
        pixel: [u32; 2],
        /// Red, green or blue.
        channel: usize,
        /// What the program has written.
        found: Option<f32>,
        /// What golden has computed.
        golden: f32,
    },
}

impl Fault {
    /// A mistake of the operation with index `at`.
    pub(super) fn new(program: &Program, at: usize, item: u32, mistake: Mistake) -> Box<Self> {
        Box::new(Self { program: program.name.clone(), line: program.lines[at], item, mistake })
    }
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Load(address, Denied::Outside) => {
                write!(f, "it loads word {address}, which is outside memory")
            }
            Self::Load(address, Denied::NotWritten) => {
                write!(f, "it loads word {address} of the picture, which it has not written")
            }
            Self::Load(address, _) => write!(f, "it loads word {address}, which another item has written"),
            Self::Store(address, Denied::Outside) => {
                write!(f, "it stores to word {address}, which is outside memory")
            }
            Self::Store(address, Denied::ReadOnly) => {
                write!(f, "it stores to word {address}; only the picture can be written")
            }
            Self::Store(address, _) => {
                write!(f, "it stores to word {address}, which another item has written")
            }
            Self::Local(address, Misplaced::Outside) => write!(
                f,
                "byte {} is outside the {LOCAL_STORE_BYTES} bytes of the local store: the stack is too large, or an index is out \
                 of range",
                *address as i32
            ),
            Self::Local(address, Misplaced::Unaligned) => {
                write!(f, "byte {address} of the local store is not the address of a word")
            }
            Self::LocalLeft(address) => write!(
                f,
                "it reads byte {address} of the local store as an earlier item has left it; items have to be independent"
            ),
            Self::RegisterLeft(register) => write!(
                f,
                "it reads {} as an earlier item has left it; items have to be independent",
                register_name(*register)
            ),
            Self::Random => {
                write!(f, "it asks for more than the {} random numbers of an item", SAMPLE_DIMENSIONS - 2)
            }
            Self::Lane(lane) => write!(f, "there is no lane {lane}; lanes are 1 to 8"),
            Self::NoProgress(count) => write!(
                f,
                "{count} instructions without asking for a new item: the loop does not end, or the frame is too large"
            ),
            Self::AsksOn => f.write_str("it asks for another item, although there are no more"),
            Self::Picture { pixel: [x, y], channel, found, golden } => {
                let channel = ["red", "green", "blue"][*channel];
                write!(f, "pixel {x},{y} is not golden's: {channel} is ")?;
                match found {
                    Some(found) => write!(f, "{found:?} (bits {:08x})", found.to_bits())?,
                    None => f.write_str("not written")?,
                }
                write!(f, ", golden has {golden:?} (bits {:08x})", golden.to_bits())
            }
        }
    }
}
