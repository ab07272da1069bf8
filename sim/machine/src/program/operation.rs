//! The instructions: what each does to registers and memory, and which unit executes it.
//!
//! MIPS32 with single-precision floats, one branch delay slot, and the machine's own operations:
//!
//! | operation | what it does |
//! |---|---|
//! | `LOAD d, a, n` | word `a + n` of global memory; addresses count words |
//! | `STORE s, a, n` | writes that word |
//! | `ATOMIC_INC d, 0` | the next number of the counter that all threads share |
//! | `FPMIN`, `FPMAX` | [`fp::minimum_number`], [`fp::maximum_number`] |
//! | `FPINVSQRT`, `SIN`, `COS` | [`render::shading`]'s functions |
//! | `RAND d` | golden's sample of the item's pixel in the thread's next dimension |
//! | `DSTSTEP code, near, far, t_min, t_max, far_t_min, far_t_max, word, plane x2, origin x3, inv_entry x3, inv_exit x3` | [`golden::dst::step`]; `t_min` and `t_max` are read as well |
//! | `BOXTEST hit, entry, box x6, origin x3, inv_entry x3, inv_exit x3, t_max` | [`golden::bvh::box_step`] from 0 to `t_max` |
//! | `BOXTEST2 hits, entry x2, box x6, box x6, ...` | two of them; a bit of `hits` each |
//! | `BOXLOAD lane, a, n` | word `a + n` of global memory to component `n - 1` of the box in the lane |
//! | `BOXTESTS hits, lanes, ...` | the boxes in lanes `lanes` down to 1; bit 0 of `hits` is that of lane `lanes` |
//! | `ENTRY d, lane` | the distance at which the box in the lane was entered |
//! | `EXACT hit, t, u, v, a, origin x3, direction x3` | [`golden::triangle::decided_hit`] on the triangle at word `a` |
//!
//! `EXACT` stands for the library routine that decides a triangle test which single precision does not, and counts as
//! one instruction. Ordinary loads and stores (`lw`, `swc1`) reach the thread's local store only. `%gp_rel` loads bring constants
//! of the program.

use super::registers::{CONDITION, LANE_WORDS, Register, SINK, ZERO};
use costs::Unit;

/// Where an operation executes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Place {
    /// A shared unit.
    Unit(Unit),
    /// Registers only: a move needs no unit.
    Registers,
    /// The thread's local store, one access a cycle.
    LocalStore,
    /// A load from global memory.
    Load,
    /// A store to global memory.
    Store,
    /// The counter that all threads share.
    Counter,
    /// The multiprocessor's ray-box or dual-split pipeline.
    Pipeline,
    /// Nothing: an unfilled delay slot.
    Nop,
}

/// What an operation does; `d`, `a`, `b` are the fields of [`Operation`], `n` its immediate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
#[allow(missing_docs, reason = "named as in MIPS32, or after the machine's operation")]
pub enum Opcode {
    Nop,
    Branch,
    Add,
    AddImmediate,
    Subtract,
    Multiply,
    And,
    AndImmediate,
    Or,
    OrImmediate,
    Xor,
    XorImmediate,
    Nor,
    ShiftLeft,
    ShiftRight,
    ShiftRightArithmetic,
    ShiftLeftBy,
    ShiftRightBy,
    SetLess,
    SetLessImmediate,
    SetLessUnsigned,
    SetLessUnsignedImmediate,
    /// `d = n`.
    Constant,
    /// `d = n`, a constant from the program's pool.
    PoolConstant,
    Copy,
    /// `d = a` if `b` is not zero.
    CopyIf,
    /// `d = a` if `b` is zero.
    CopyUnless,
    FloatAdd,
    FloatSubtract,
    FloatMultiply,
    FloatDivide,
    FloatSquareRoot,
    FloatNegate,
    FloatAbsolute,
    FloatMinimum,
    FloatMaximum,
    InverseSquareRoot,
    Sine,
    Cosine,
    Random,
    IntegerToFloat,
    FloatToInteger,
    FloatTruncate,
    Equal,
    Less,
    LessOrEqual,
    Unordered,
    EqualOrUnordered,
    LessOrUnordered,
    LessOrEqualOrUnordered,
    LoadLocal,
    StoreLocal,
    LoadLocalPair,
    StoreLocalPair,
    LoadLocalByte,
    LoadLocalByteUnsigned,
    StoreLocalByte,
    /// From global memory.
    Load,
    /// Several words to the registers of operand list `n >> 16`.
    LoadWords,
    /// To component `n - 1` of the box in lane `d`.
    LoadLane,
    Store,
    Counter,
    /// Registers of operand list `n`.
    DualSplitStep,
    BoxTest,
    BoxTestPair,
    BoxTestLanes,
    LaneEntry,
    ExactTest,
}

/// An instruction as it is executed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Operation {
    /// What it does.
    pub opcode: Opcode,
    /// The register that is written; of a store, the one that is stored.
    pub d: Register,
    /// The first operand; of an access to memory, the register that holds the address.
    pub a: Register,
    /// The second operand.
    pub b: Register,
    /// A constant, an offset (in bytes of the local store, in words of global memory) or the number of a list of registers.
    pub immediate: i32,
}

const _: () = assert!(size_of::<Operation>() == 8);

impl Operation {
    /// Where it executes.
    #[must_use]
    pub fn place(&self) -> Place {
        use Opcode as O;
        match self.opcode {
            O::Nop => Place::Nop,
            O::Branch => Place::Unit(Unit::Branch),
            O::Add
            | O::AddImmediate
            | O::Subtract
            | O::SetLess
            | O::SetLessImmediate
            | O::SetLessUnsigned
            | O::SetLessUnsignedImmediate => Place::Unit(Unit::IntAdd),
            O::Multiply => Place::Unit(Unit::IntMul),
            O::And
            | O::AndImmediate
            | O::Or
            | O::OrImmediate
            | O::Xor
            | O::XorImmediate
            | O::Nor
            | O::ShiftLeft
            | O::ShiftRight
            | O::ShiftRightArithmetic
            | O::ShiftLeftBy
            | O::ShiftRightBy => Place::Unit(Unit::Bitwise),
            O::Constant | O::Copy | O::CopyIf | O::CopyUnless | O::LaneEntry | O::ExactTest => {
                Place::Registers
            }
            O::FloatAdd | O::FloatSubtract | O::Sine | O::Cosine | O::Random => Place::Unit(Unit::FpAdd),
            O::FloatMultiply => Place::Unit(Unit::FpMul),
            O::FloatDivide | O::FloatSquareRoot | O::InverseSquareRoot => Place::Unit(Unit::FpInv),
            O::FloatMinimum | O::FloatMaximum => Place::Unit(Unit::FpMinMax),
            O::FloatNegate
            | O::FloatAbsolute
            | O::Equal
            | O::Less
            | O::LessOrEqual
            | O::Unordered
            | O::EqualOrUnordered
            | O::LessOrUnordered
            | O::LessOrEqualOrUnordered => Place::Unit(Unit::FpCmp),
            O::IntegerToFloat | O::FloatToInteger | O::FloatTruncate => Place::Unit(Unit::Convert),
            O::PoolConstant
            | O::LoadLocal
            | O::StoreLocal
            | O::LoadLocalPair
            | O::StoreLocalPair
            | O::LoadLocalByte
            | O::LoadLocalByteUnsigned
            | O::StoreLocalByte => Place::LocalStore,
            O::Load | O::LoadWords | O::LoadLane => Place::Load,
            O::Store => Place::Store,
            O::Counter => Place::Counter,
            O::DualSplitStep | O::BoxTest | O::BoxTestPair | O::BoxTestLanes => Place::Pipeline,
        }
    }

    /// The list of registers that it has beyond its fields.
    #[must_use]
    pub fn list(&self) -> Option<usize> {
        match self.opcode {
            Opcode::LoadWords => Some(self.immediate as usize >> 16),
            Opcode::DualSplitStep
            | Opcode::BoxTest
            | Opcode::BoxTestPair
            | Opcode::BoxTestLanes
            | Opcode::ExactTest => Some(self.immediate as usize),
            _ => None,
        }
    }

    /// Words behind the address of its base, of an access to global memory.
    #[must_use]
    pub fn offset(&self) -> u32 {
        self.immediate as u32 & 0xffff
    }

    /// Registers that it reads and writes, without [`ZERO`]; `lists` are the program's lists of registers.
    #[must_use]
    pub fn accesses(&self, lists: &[Vec<Register>]) -> (Vec<Register>, Vec<Register>) {
        use Opcode as O;
        let Self { opcode, d, a, b, .. } = *self;
        let list = self.list().map_or(&[][..], |list| &lists[list]);
        let (reads, writes) = match opcode {
            O::Nop => (vec![], vec![]),
            O::Branch => (vec![a, b], vec![]),
            O::CopyIf | O::CopyUnless => (vec![d, a, b], vec![d]),
            O::Equal
            | O::Less
            | O::LessOrEqual
            | O::Unordered
            | O::EqualOrUnordered
            | O::LessOrUnordered
            | O::LessOrEqualOrUnordered => (vec![a, b], vec![CONDITION]),
            O::StoreLocal | O::StoreLocalByte | O::Store => (vec![d, a], vec![]),
            O::StoreLocalPair => (vec![d, d + 1, a], vec![]),
            O::LoadLocalPair => (vec![a], vec![d, d + 1]),
            O::LoadWords => (vec![a], list.to_vec()),
            O::LoadLane => (vec![d, a], vec![LANE_WORDS + self.offset().saturating_sub(1) as u8]),
            O::DualSplitStep => (list[3..].to_vec(), list[..7].to_vec()),
            O::BoxTest => (list[2..].to_vec(), list[..2].to_vec()),
            O::BoxTestPair => (list[3..].to_vec(), list[..3].to_vec()),
            O::BoxTestLanes => {
                let lanes = (0..6).map(|word| LANE_WORDS + word);
                (lanes.chain(list[1..].iter().copied()).collect(), list[..1].to_vec())
            }
            O::ExactTest => (list[4..].to_vec(), list[..4].to_vec()),
            _ => (vec![a, b], vec![d]),
        };
        let known =
            |registers: Vec<Register>| registers.into_iter().filter(|r| *r != ZERO && *r != SINK).collect();
        // The outputs of a step that it does not read are written only.
        let reads = match opcode {
            O::DualSplitStep => [&reads[..2], &reads[4..]].concat(),
            _ => reads,
        };
        (known(reads), known(writes))
    }
}
