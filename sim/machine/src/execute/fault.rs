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
    /// A lane that does not exist, and how many there are.
    Lane(u32, u32),
    /// It asks for the exact triangle test of numbers that are not finite.
    NotFinite,
    /// So many instructions have been executed without asking for a new item.
    NoProgress(u64),
    /// It asks for another item after it has got the number of all items.
    AsksOn,
    /// It ends without asking for an item.
    NoItems,
    /// It ends although there are more items.
    EndsEarly,
    /// It asks for items in more places than its first item and those behind it.
    AsksElsewhere,
    /// The picture is not golden's.
    Picture(Difference),
}

/// A pixel that is not golden's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Difference {
    /// Column and row.
    pub pixel: [u32; 2],
    /// The first channel that differs: red, green or blue.
    pub channel: usize,
    /// Bits of what the program has written; none if it has written nothing.
    pub found: Option<u32>,
    /// Bits of what golden has computed.
    pub golden: u32,
}

impl Difference {
    /// Name of the channel.
    #[must_use]
    pub fn channel_name(&self) -> &'static str {
        ["red", "green", "blue"][self.channel]
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { pixel: [x, y], found, golden, .. } = *self;
        let value = |bits| format!("{:?} (bits {bits:08x})", f32::from_bits(bits));
        let found = found.map_or_else(|| "not written".to_owned(), value);
        let channel = self.channel_name();
        write!(f, "pixel {x},{y} is not golden's: {channel} is {found}, golden has {}", value(golden))
    }
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
            Self::Lane(lane, lanes) => write!(f, "there is no lane {lane}; lanes are 1 to {lanes}"),
            Self::NotFinite => f.write_str("EXACT needs finite numbers: origin, direction and the triangle's corners"),
            Self::NoProgress(count) => write!(
                f,
                "{count} instructions without asking for a new item: the loop does not end, or the frame is too large"
            ),
            Self::AsksOn => f.write_str("it asks for another item, although there are no more"),
            Self::NoItems => f.write_str("it ends without asking for an item"),
            Self::EndsEarly => f.write_str("it ends although there are more items"),
            Self::AsksElsewhere => f.write_str(
                "it asks for an item here and in two other places; the first item may be asked for in one, all others in another",
            ),
            Self::Picture(difference) => difference.fmt(f),
        }
    }
}
