//! Reads an instruction of a listing.

use super::operation::{Opcode, Operation};
use super::registers::{CONDITION, Register, SINK, ZERO, register};
use std::collections::HashMap;

/// What a branch asks of its registers `a` and `b`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "named as in MIPS32")]
pub enum Test {
    Always,
    Equal,
    NotEqual,
    Negative,
    NotNegative,
    Positive,
    NotPositive,
}

/// What decoding needs of the rest of the listing, and adds to.
#[derive(Clone, Debug, Default)]
pub struct Context<'a> {
    /// Constants by their labels.
    pub constants: HashMap<&'a str, u32>,
    /// Lists of registers of operations with many operands.
    pub lists: Vec<Vec<Register>>,
}

/// An instruction, decoded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decoded<'a> {
    /// Goes on with the next instruction.
    Plain(Operation),
    /// Goes to a label if the test holds, after the delay slot.
    Branch(Operation, Test, &'a str),
    /// Ends the program, after the delay slot.
    Return(Operation),
}

/// Decodes `mnemonic` with its `operands`.
///
/// # Errors
/// What is wrong, as a phrase.
pub fn decode<'a>(
    mnemonic: &str,
    operands: &[&'a str],
    context: &mut Context<'_>,
) -> Result<Decoded<'a>, String> {
    if let Some(branch) = branch(mnemonic, operands) {
        return branch;
    }
    let operation = decode_plain(mnemonic, operands, context)?;
    // What is written to register zero is lost.
    let writes_d = operation.accesses(&context.lists).1.is_empty() && operation.d == ZERO;
    let stores = matches!(
        operation.opcode,
        Opcode::Store | Opcode::StoreLocal | Opcode::StoreLocalByte | Opcode::StoreLocalPair
    );
    let d = if writes_d && !stores { SINK } else { operation.d };
    Ok(Decoded::Plain(Operation { d, ..operation }))
}

fn branch<'a>(mnemonic: &str, operands: &[&'a str]) -> Option<Result<Decoded<'a>, String>> {
    let (test, registers) = match mnemonic {
        "j" | "b" => (Test::Always, 0),
        "jr" => (Test::Always, 0),
        "beq" => (Test::Equal, 2),
        "bne" => (Test::NotEqual, 2),
        "beqz" => (Test::Equal, 1),
        "bnez" => (Test::NotEqual, 1),
        "bltz" => (Test::Negative, 1),
        "bgez" => (Test::NotNegative, 1),
        "bgtz" => (Test::Positive, 1),
        "blez" => (Test::NotPositive, 1),
        "bc1t" => (Test::NotEqual, 0),
        "bc1f" => (Test::Equal, 0),
        _ => return None,
    };
    let decoded = || {
        let named = |at: usize| operands.get(at).and_then(|operand| register(operand));
        let need = |at: usize| named(at).ok_or_else(|| format!("operand {} is no register", at + 1));
        if mnemonic == "jr" {
            return match operands {
                ["$ra"] => Ok(Decoded::Return(Operation {
                    opcode: Opcode::Branch,
                    d: SINK,
                    a: need(0)?,
                    b: ZERO,
                    immediate: 0,
                })),
                _ => Err("only `jr $ra` is supported, which ends the program".to_owned()),
            };
        }
        let [mut a, mut b] = [ZERO; 2];
        if mnemonic.starts_with("bc1") {
            a = CONDITION;
            if operands.len() > 1 && named(0) != Some(CONDITION) {
                return Err("only the condition flag $fcc0 is supported".to_owned());
            }
        }
        if registers > 0 {
            a = need(0)?;
        }
        if registers > 1 {
            b = need(1)?;
        }
        let label = operands.last().filter(|label| register(label).is_none()).ok_or("it has no label")?;
        Ok(Decoded::Branch(Operation { opcode: Opcode::Branch, d: SINK, a, b, immediate: 0 }, test, label))
    };
    Some(decoded())
}

fn decode_plain(mnemonic: &str, operands: &[&str], context: &mut Context<'_>) -> Result<Operation, String> {
    use Opcode as O;
    let operation = |opcode, d, a, b, immediate| Operation { opcode, d, a, b, immediate };
    let named = |at: usize| operands.get(at).and_then(|operand| register(operand));
    let need = |at: usize| named(at).ok_or_else(|| format!("operand {} is no register", at + 1));
    let count = |expected: usize| match operands.len() == expected {
        true => Ok(()),
        false => Err(format!("{} operands, expected {expected}", operands.len())),
    };
    let number = |at: usize| {
        let text = operands.get(at).copied().unwrap_or_default();
        integer(text).ok_or_else(|| format!("`{text}` is no number"))
    };
    let three = |opcode| count(3).and_then(|()| Ok(operation(opcode, need(0)?, need(1)?, need(2)?, 0)));
    let two = |opcode| count(2).and_then(|()| Ok(operation(opcode, need(0)?, need(1)?, ZERO, 0)));
    // As an assembler reads them: what fits in 16 bits, with a sign or as a pattern.
    let within = |opcode, range: std::ops::Range<i64>| {
        count(3)?;
        let value = number(2)?;
        if !range.contains(&value) {
            return Err(format!("{value} is not in {}..{}", range.start, range.end));
        }
        Ok(operation(opcode, need(0)?, need(1)?, ZERO, value as i32))
    };
    let signed = |opcode| within(opcode, -0x8000..0x8000);
    let pattern = |opcode| within(opcode, 0..0x1_0000);
    let shift = |opcode| within(opcode, 0..32);
    let compare = |opcode| {
        let first = usize::from(named(0) == Some(CONDITION));
        count(first + 2).and_then(|()| Ok(operation(opcode, CONDITION, need(first)?, need(first + 1)?, 0)))
    };
    let global = |opcode| {
        count(3)?;
        let offset = number(2)?;
        if !(0..1 << 16).contains(&offset) {
            return Err(format!("offset {offset} is not in 0..65536 words"));
        }
        Ok(operation(opcode, need(0)?, need(1)?, ZERO, offset as i32))
    };
    match mnemonic {
        "nop" => Ok(operation(O::Nop, SINK, ZERO, ZERO, 0)),
        "addu" => three(O::Add),
        "addiu" => signed(O::AddImmediate),
        "subu" => three(O::Subtract),
        "negu" => two(O::Subtract).map(|op| Operation { a: ZERO, b: op.a, ..op }),
        "mul" => three(O::Multiply),
        "and" => three(O::And),
        "andi" => pattern(O::AndImmediate),
        "or" => three(O::Or),
        "ori" => pattern(O::OrImmediate),
        "xor" => three(O::Xor),
        "xori" => pattern(O::XorImmediate),
        "nor" => three(O::Nor),
        "not" => two(O::Nor),
        "sll" => shift(O::ShiftLeft),
        "srl" => shift(O::ShiftRight),
        "sra" => shift(O::ShiftRightArithmetic),
        "sllv" => three(O::ShiftLeftBy),
        "srlv" => three(O::ShiftRightBy),
        "slt" => three(O::SetLess),
        "slti" => signed(O::SetLessImmediate),
        "sltu" => three(O::SetLessUnsigned),
        "sltiu" => signed(O::SetLessUnsignedImmediate),
        "lui" => {
            count(2)?;
            // The upper half of an address of a constant is not used: the load that follows names the constant.
            let upper = if operands[1].starts_with("%hi(") { 0 } else { number(1)? };
            if !(0..0x1_0000).contains(&upper) {
                return Err(format!("{upper} is not in 0..65536"));
            }
            Ok(operation(O::Constant, need(0)?, ZERO, ZERO, (upper as u32).wrapping_shl(16) as i32))
        }
        "move" | "mov.s" | "mfc1" => two(O::Copy),
        "mtc1" => two(O::Copy).map(|op| Operation { d: op.a, a: op.d, ..op }),
        "movn" | "movn.s" | "movt" | "movt.s" => three(O::CopyIf),
        "movz" | "movz.s" | "movf" | "movf.s" => three(O::CopyUnless),
        "add.s" => three(O::FloatAdd),
        "sub.s" => three(O::FloatSubtract),
        "mul.s" => three(O::FloatMultiply),
        "div.s" => three(O::FloatDivide),
        "sqrt.s" => two(O::FloatSquareRoot),
        "neg.s" => two(O::FloatNegate),
        "abs.s" => two(O::FloatAbsolute),
        "FPMIN" => three(O::FloatMinimum),
        "FPMAX" => three(O::FloatMaximum),
        "FPINVSQRT" => two(O::InverseSquareRoot),
        "SIN" => two(O::Sine),
        "COS" => two(O::Cosine),
        "RAND" => count(1).and_then(|()| Ok(operation(O::Random, need(0)?, ZERO, ZERO, 0))),
        "cvt.s.w" => two(O::IntegerToFloat),
        "cvt.w.s" => two(O::FloatToInteger),
        "trunc.w.s" => two(O::FloatTruncate),
        "c.eq.s" => compare(O::Equal),
        "c.olt.s" | "c.lt.s" => compare(O::Less),
        "c.ole.s" | "c.le.s" => compare(O::LessOrEqual),
        "c.un.s" => compare(O::Unordered),
        "c.ueq.s" => compare(O::EqualOrUnordered),
        "c.ult.s" => compare(O::LessOrUnordered),
        "c.ule.s" => compare(O::LessOrEqualOrUnordered),
        "lw" | "lwc1" => local(O::LoadLocal, operands, context),
        "sw" | "swc1" => local(O::StoreLocal, operands, context),
        "ldc1" => local(O::LoadLocalPair, operands, context),
        "sdc1" => local(O::StoreLocalPair, operands, context),
        "lb" => local(O::LoadLocalByte, operands, context),
        "lbu" => local(O::LoadLocalByteUnsigned, operands, context),
        "sb" => local(O::StoreLocalByte, operands, context),
        "LOAD" => global(O::Load),
        "STORE" => global(O::Store),
        "BOXLOAD" => {
            let load = global(O::LoadLane)?;
            match load.immediate {
                1..=6 => Ok(load),
                other => Err(format!("offset {other}: the words of a box are 1 to 6")),
            }
        }
        "ATOMIC_INC" => count(2).and_then(|()| Ok(operation(O::Counter, need(0)?, ZERO, ZERO, 0))),
        "ENTRY" => two(O::LaneEntry),
        "DSTSTEP" => listed(O::DualSplitStep, 19, operands, context),
        "BOXTEST" => listed(O::BoxTest, 18, operands, context),
        "BOXTEST2" => listed(O::BoxTestPair, 25, operands, context),
        "BOXTESTS" => listed(O::BoxTestLanes, 12, operands, context),
        "EXACT" => listed(O::ExactTest, 11, operands, context),
        "jal" | "jalr" | "bal" => {
            Err("there are no calls; make every function INLINE, and copy by hand what \
                                       the compiler would call memcpy or memset for"
                .to_owned())
        }
        _ => Err("the machine has no such instruction".to_owned()),
    }
}

/// A number as an assembler writes it.
pub(super) fn integer(text: &str) -> Option<i64> {
    match text.strip_prefix("0x") {
        Some(digits) => i64::from_str_radix(digits, 16).ok(),
        None => text.parse().ok(),
    }
    .filter(|n| (i64::from(i32::MIN)..=i64::from(u32::MAX)).contains(n))
}

/// An access to the local store, such as `lw $3, 8($sp)`, or to a constant, such as `lwc1 $f0, %gp_rel($CPI0_0)($gp)`.
fn local(opcode: Opcode, operands: &[&str], context: &Context<'_>) -> Result<Operation, String> {
    let [value, address] = operands else {
        return Err(format!("{} operands, expected 2", operands.len()));
    };
    let d = register(value).ok_or("operand 1 is no register")?;
    let (offset, base) = address
        .strip_suffix(')')
        .and_then(|rest| rest.rsplit_once('('))
        .ok_or_else(|| format!("`{address}` is no address of the local store"))?;
    let a = register(base).ok_or_else(|| format!("`{base}` is no register"))?;
    let symbol = ["%gp_rel(", "%lo("].iter().find_map(|prefix| offset.strip_prefix(prefix));
    if let Some(symbol) = symbol.and_then(|rest| rest.strip_suffix(')')) {
        let value = context.constants.get(symbol).ok_or_else(|| format!("no constant `{symbol}`"))?;
        return match opcode {
            Opcode::LoadLocal => {
                Ok(Operation { opcode: Opcode::PoolConstant, d, a: ZERO, b: ZERO, immediate: *value as i32 })
            }
            _ => Err("constants are read word by word".to_owned()),
        };
    }
    let offset = if offset.is_empty() { Some(0) } else { integer(offset) };
    let immediate = offset
        .filter(|offset| (-0x8000..0x8000).contains(offset))
        .ok_or_else(|| format!("`{address}` is no address of the local store"))? as i32;
    Ok(Operation { opcode, d, a, b: ZERO, immediate })
}

/// An operation with a list of `count` registers.
fn listed(
    opcode: Opcode,
    count: usize,
    operands: &[&str],
    context: &mut Context<'_>,
) -> Result<Operation, String> {
    if operands.len() != count {
        return Err(format!("{} operands, expected {count}", operands.len()));
    }
    let registers =
        operands.iter().map(|operand| register(operand).ok_or_else(|| format!("`{operand}` is no register")));
    context.lists.push(registers.collect::<Result<_, _>>()?);
    Ok(Operation { opcode, d: SINK, a: ZERO, b: ZERO, immediate: context.lists.len() as i32 - 1 })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn accesses(text: &str) -> Option<(Vec<Register>, Vec<Register>)> {
        let (mnemonic, operands) = text.split_once(' ').unwrap_or((text, ""));
        let operands: Vec<&str> = operands.split(", ").filter(|o| !o.is_empty()).collect();
        let mut context = Context::default();
        let operation = match decode(mnemonic, &operands, &mut context).ok()? {
            Decoded::Plain(operation) | Decoded::Branch(operation, ..) | Decoded::Return(operation) => {
                operation
            }
        };
        Some(operation.accesses(&context.lists))
    }

    #[test]
    fn operands_by_role() {
        assert_eq!(accesses("sub.s $f1, $f2, $f3"), Some((vec![34, 35], vec![33])));
        assert_eq!(accesses("swc1 $f15, 4($24)"), Some((vec![47, 24], vec![])));
        assert_eq!(accesses("lw $14, 0($12)"), Some((vec![12], vec![14])));
        assert_eq!(accesses("movn.s $f7, $f13, $1"), Some((vec![39, 45, 1], vec![39])));
        assert_eq!(accesses("c.ole.s $f14, $f15"), Some((vec![46, 47], vec![CONDITION])));
        assert_eq!(accesses("bc1t $BB0_5"), Some((vec![CONDITION], vec![])));
        assert_eq!(accesses("mtc1 $zero, $f1"), Some((vec![], vec![33])));
        assert_eq!(accesses("LOAD $f2, $11, 0"), Some((vec![11], vec![34])));
        assert_eq!(accesses("STORE $f2, $11, 0"), Some((vec![34, 11], vec![])));
        assert_eq!(accesses("addu $zero, $3, $4"), Some((vec![3, 4], vec![])));
        assert_eq!(accesses("nop"), Some((vec![], vec![])));
        assert_eq!(accesses("frobnicate $1"), None);
        assert_eq!(accesses("addu $1, $2"), None);
        for bad in [
            "sll $1, $2, 32",
            "srl $1, $2, -1",
            "addiu $1, $2, 32768",
            "andi $1, $2, -1",
            "ori $1, $2, 65536",
            "lui $1, 65536",
            "lw $1, 40000($2)",
        ] {
            assert_eq!(accesses(bad), None, "{bad}");
        }
        for good in ["sll $1, $2, 31", "addiu $1, $2, -32768", "andi $1, $2, 65535", "lui $1, 65535"] {
            assert!(accesses(good).is_some(), "{good}");
        }
        let floats: Vec<String> = (1..=13).map(|f| format!("$f{f}")).collect();
        let step =
            format!("DSTSTEP $1, $2, $3, {}, $4, {}", floats[..4].join(", "), floats[2..13].join(", "));
        let (reads, writes) = accesses(&step).unwrap();
        assert_eq!(writes, [1, 2, 3, 33, 34, 35, 36]);
        assert_eq!(reads[..4], [33, 34, 4, 35]);
    }
}
