//! The instructions: which unit executes each, what it reads and writes.
//!
//! MIPS32 with single-precision floats, one branch delay slot, and the machine's own operations: `LOAD`, `STORE`
//! (global memory, word addresses), `ATOMIC_INC` (a counter that all threads share), `FPMIN`, `FPMAX` and the pipelines'
//! operations. `EXACT` stands for the library routine that decides a triangle test which single precision does not; it is
//! rare, and counts as one instruction. Ordinary loads and stores (`lw`, `swc1`) reach the thread's local store only.

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

/// A register: 0 to 31 integer, 32 to 63 floating point, then the condition flag and the product.
pub type Register = u8;

/// The register that always reads zero.
pub const ZERO: Register = 0;
const FIRST_FLOAT: Register = 32;
const CONDITION: Register = 64;
const PRODUCT: Register = 65;
/// Number of registers.
pub const REGISTERS: usize = 66;

/// Operands of an instruction by role; positions in the listing.
enum Form {
    /// The first is written, the others are read.
    Write,
    /// The first is read and written: it keeps its value where the condition fails.
    Update,
    /// The first so many are written, and of these so many from the fourth on are read too; the others are read.
    Pipeline(usize, usize),
    /// All are read.
    Read,
    /// Both are read, the condition flag is written.
    Compare,
    /// The first is read, the second written.
    Reverse,
}

/// An operation's place and the registers that it reads and writes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Decoded {
    /// Where it executes.
    pub place: Place,
    /// Registers read.
    pub reads: Vec<Register>,
    /// Registers written.
    pub writes: Vec<Register>,
}

/// Decodes `mnemonic` with its `operands`; branches are not decoded here but read registers all the same.
pub fn decode(mnemonic: &str, operands: &[&str]) -> Option<Decoded> {
    use Form::{Compare, Pipeline, Read, Reverse, Update, Write};
    let unit = Place::Unit;
    let (place, form) = match mnemonic {
        "add.s" | "sub.s" | "RAND" | "SIN" | "COS" => (unit(Unit::FpAdd), Write),
        "mul.s" => (unit(Unit::FpMul), Write),
        "div.s" | "sqrt.s" | "FPINVSQRT" => (unit(Unit::FpInv), Write),
        "FPMIN" | "FPMAX" => (unit(Unit::FpMinMax), Write),
        "neg.s" | "abs.s" => (unit(Unit::FpCmp), Write),
        "cvt.s.w" | "cvt.w.s" | "trunc.w.s" => (unit(Unit::Convert), Write),
        "addiu" | "addu" | "subu" | "slt" | "slti" | "sltu" | "sltiu" | "negu" => (unit(Unit::IntAdd), Write),
        "move" | "mov.s" | "mfc1" | "lui" | "ENTRY" | "EXACT" => (Place::Registers, Write),
        "mul" => (unit(Unit::IntMul), Write),
        "sll" | "srl" | "sra" | "sllv" | "srlv" | "and" | "andi" | "or" | "ori" | "xor" | "xori" | "nor"
        | "not" => (unit(Unit::Bitwise), Write),
        "movt" | "movf" | "movn" | "movz" | "movt.s" | "movf.s" | "movn.s" | "movz.s" => {
            (Place::Registers, Update)
        }
        "mtc1" => (Place::Registers, Reverse),
        "lw" | "lwc1" | "ldc1" | "lb" | "lbu" => (Place::LocalStore, Write),
        "sw" | "swc1" | "sdc1" | "sb" => (Place::LocalStore, Read),
        "LOAD" => (Place::Load, Write),
        "STORE" => (Place::Store, Read),
        "ATOMIC_INC" => (Place::Counter, Write),
        "DSTSTEP" => (Place::Pipeline, Pipeline(7, 2)),
        "BOXTEST" => (Place::Pipeline, Pipeline(2, 0)),
        "BOXTEST2" => (Place::Pipeline, Pipeline(3, 0)),
        "BOXTESTS" => (Place::Pipeline, Pipeline(1, 0)),
        "nop" => (Place::Nop, Read),
        "beqz" | "bnez" | "bgez" | "blez" | "bltz" | "bgtz" | "beq" | "bne" | "bc1t" | "bc1f" | "j" | "b"
        | "jr" => (unit(Unit::Branch), Read),
        _ if mnemonic.starts_with("c.") && mnemonic.ends_with(".s") => (unit(Unit::FpCmp), Compare),
        _ => return None,
    };
    let registers: Vec<Option<Register>> = operands.iter().map(|operand| register(operand)).collect();
    let read = |range: &[Option<Register>]| range.iter().flatten().copied().filter(|r| *r != ZERO).collect();
    let (mut reads, mut writes): (Vec<Register>, Vec<Register>) = match form {
        Write => (read(registers.get(1..)?), read(registers.get(..1)?)),
        Update => (read(&registers), read(registers.get(..1)?)),
        Read => (read(&registers), vec![]),
        Compare => (read(&registers), vec![CONDITION]),
        Pipeline(written, updated) => {
            let (outputs, inputs) = registers.split_at_checked(written)?;
            let both = &outputs[3.min(written)..(3 + updated).min(written)];
            (read(&[both, inputs].concat()), read(outputs))
        }
        Reverse => (read(registers.get(..1)?), read(registers.get(1..)?)),
    };
    if matches!(mnemonic, "bc1t" | "bc1f") {
        reads.push(CONDITION);
    }
    if mnemonic == "mul" {
        writes.push(PRODUCT);
    }
    Some(Decoded { place, reads, writes })
}

/// The register that `operand` names, also as the base of an address such as `8($sp)`.
pub fn register(operand: &str) -> Option<Register> {
    let name = match operand.rsplit_once('(') {
        Some((_, base)) => base.strip_suffix(')')?,
        None => operand,
    };
    let name = name.strip_prefix('$')?;
    match name {
        "zero" => Some(ZERO),
        "at" => Some(1),
        "gp" => Some(28),
        "sp" => Some(29),
        "fp" => Some(30),
        "ra" => Some(31),
        _ if name.starts_with("fcc") => Some(CONDITION),
        _ => match name.strip_prefix('f') {
            Some(number) => number.parse().ok().filter(|n| *n < 32).map(|n: u8| n + FIRST_FLOAT),
            None => name.parse().ok().filter(|n| *n < 32),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn operands_by_role() {
        let decoded = |text: &str| {
            let (mnemonic, operands) = text.split_once(' ').unwrap_or((text, ""));
            let operands: Vec<&str> = operands.split(", ").filter(|o| !o.is_empty()).collect();
            decode(mnemonic, &operands).map(|d| (d.reads, d.writes))
        };
        assert_eq!(decoded("sub.s $f1, $f2, $f3"), Some((vec![34, 35], vec![33])));
        assert_eq!(decoded("swc1 $f15, 4($24)"), Some((vec![47, 24], vec![])));
        assert_eq!(decoded("lw $14, 0($12)"), Some((vec![12], vec![14])));
        assert_eq!(decoded("movn.s $f7, $f13, $1"), Some((vec![39, 45, 1], vec![39])));
        assert_eq!(decoded("c.ole.s $f14, $f15"), Some((vec![46, 47], vec![CONDITION])));
        assert_eq!(decoded("bc1t $BB0_5"), Some((vec![CONDITION], vec![])));
        assert_eq!(decoded("mtc1 $zero, $f1"), Some((vec![], vec![33])));
        assert_eq!(decoded("LOAD $f2, $11, 0"), Some((vec![11], vec![34])));
        assert_eq!(decoded("nop"), Some((vec![], vec![])));
        assert_eq!(decoded("frobnicate $1"), None);
    }
}
