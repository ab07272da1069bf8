//! Columns, the values of a node in all lanes, and what the instructions do with them.

use super::LANES;
use super::instruction::{Instruction, Operation, Place, Size};
use netlist::BinaryOp;
use num_traits::{AsPrimitive, PrimInt, Unsigned, WrappingAdd, WrappingMul, WrappingSub};

/// The columns of each size. An instruction's result comes after its operands of the same size.
#[derive(Clone, Debug, Default)]
pub struct Columns {
    small: Vec<[u32; LANES]>,
    medium: Vec<[u64; LANES]>,
    large: Vec<[u128; LANES]>,
}

/// Unsigned integers that a column holds.
trait Value:
    PrimInt + Unsigned + WrappingAdd + WrappingSub + WrappingMul + AsPrimitive<u32> + AsPrimitive<u128> + 'static
where
    u128: AsPrimitive<Self>,
    u32: AsPrimitive<Self>,
{
    const BITS: u32;
}

impl Value for u32 {
    const BITS: u32 = 32;
}
impl Value for u64 {
    const BITS: u32 = 64;
}
impl Value for u128 {
    const BITS: u32 = 128;
}

impl Columns {
    /// A new column of zeros.
    pub fn add(&mut self, size: Size) -> Place {
        let at = match size {
            Size::Small => push(&mut self.small, [0; LANES]),
            Size::Medium => push(&mut self.medium, [0; LANES]),
            Size::Large => push(&mut self.large, [0; LANES]),
        };
        Place { size, at }
    }

    pub fn get(&self, place: Place, lane: usize) -> u128 {
        match place.size {
            Size::Small => self.small[place.at][lane].into(),
            Size::Medium => self.medium[place.at][lane].into(),
            Size::Large => self.large[place.at][lane],
        }
    }

    /// Writes a value that fits.
    pub fn set(&mut self, place: Place, lane: usize, value: u128) {
        match place.size {
            Size::Small => self.small[place.at][lane] = value as u32,
            Size::Medium => self.medium[place.at][lane] = value as u64,
            Size::Large => self.large[place.at][lane] = value,
        }
    }

    /// Writes a column of at most 32 bits.
    pub fn drive(&mut self, place: Place, values: &[u32; LANES]) {
        assert_eq!(place.size, Size::Small, "an input wider than 32 bits");
        self.small[place.at] = *values;
    }

    /// Reads the low 32 bits of a column.
    pub fn read(&self, place: Place, values: &mut [u32; LANES]) {
        match place.size {
            Size::Small => *values = self.small[place.at],
            Size::Medium => *values = self.medium[place.at].map(|value| value as u32),
            Size::Large => *values = self.large[place.at].map(|value| value as u32),
        }
    }

    pub fn copy(&mut self, to: Place, from: Place) {
        match to.size {
            Size::Small => self.small[to.at] = self.small[from.at],
            Size::Medium => self.medium[to.at] = self.medium[from.at],
            Size::Large => self.large[to.at] = self.large[from.at],
        }
    }

    /// `to = enable ? when_enabled : otherwise`, always enabled without `enable`.
    pub fn choose(&mut self, to: Place, enable: Option<Place>, when_enabled: Place, otherwise: Place) {
        let Some(enable) = enable else { return self.copy(to, when_enabled) };
        let select = self.small[enable.at];
        match to.size {
            Size::Small => {
                self.small[to.at] =
                    selected(&select, &self.small[when_enabled.at], &self.small[otherwise.at]);
            }
            Size::Medium => {
                self.medium[to.at] =
                    selected(&select, &self.medium[when_enabled.at], &self.medium[otherwise.at]);
            }
            Size::Large => {
                self.large[to.at] =
                    selected(&select, &self.large[when_enabled.at], &self.large[otherwise.at]);
            }
        }
    }

    /// Runs one instruction.
    #[inline(always)]
    pub fn execute(&mut self, instruction: &Instruction) {
        let Self { small, medium, large } = self;
        let Instruction { operation, from, to, operands: [a, b, c], .. } = *instruction;
        match operation {
            Operation::Select => match to.size {
                Size::Small => {
                    let (before, out) = split(small, to.at);
                    *out = selected(&before[a], &before[b], &before[c]);
                }
                Size::Medium => {
                    let (before, out) = split(medium, to.at);
                    *out = selected(&small[a], &before[b], &before[c]);
                }
                Size::Large => {
                    let (before, out) = split(large, to.at);
                    *out = selected(&small[a], &before[b], &before[c]);
                }
            },
            Operation::Convert => match (from, to.size) {
                (Size::Small, Size::Small) => {
                    let (before, out) = split(small, to.at);
                    convert(instruction, out, &before[a]);
                }
                (Size::Small, Size::Medium) => convert(instruction, &mut medium[to.at], &small[a]),
                (Size::Small, Size::Large) => convert(instruction, &mut large[to.at], &small[a]),
                (Size::Medium, Size::Small) => convert(instruction, &mut small[to.at], &medium[a]),
                (Size::Medium, Size::Medium) => {
                    let (before, out) = split(medium, to.at);
                    convert(instruction, out, &before[a]);
                }
                (Size::Medium, Size::Large) => convert(instruction, &mut large[to.at], &medium[a]),
                (Size::Large, Size::Small) => convert(instruction, &mut small[to.at], &large[a]),
                (Size::Large, Size::Medium) => convert(instruction, &mut medium[to.at], &large[a]),
                (Size::Large, Size::Large) => {
                    let (before, out) = split(large, to.at);
                    convert(instruction, out, &before[a]);
                }
            },
            Operation::Test(test) => match from {
                Size::Small => {
                    let (before, out) = split(small, to.at);
                    compare(instruction, test, out, &before[a], &before[b]);
                }
                Size::Medium => compare(instruction, test, &mut small[to.at], &medium[a], &medium[b]),
                Size::Large => compare(instruction, test, &mut small[to.at], &large[a], &large[b]),
            },
            Operation::Parity => match from {
                Size::Small => {
                    let (before, out) = split(small, to.at);
                    unary(out, &before[a], |x| x.count_ones() & 1);
                }
                Size::Medium => unary(&mut small[to.at], &medium[a], |x| x.count_ones() & 1),
                Size::Large => unary(&mut small[to.at], &large[a], |x| x.count_ones() & 1),
            },
            Operation::Saturate => match from {
                Size::Small => {
                    let (before, out) = split(small, to.at);
                    *out = before[a];
                }
                Size::Medium => unary(&mut small[to.at], &medium[a], |x| x.min(u32::MAX.into()) as u32),
                Size::Large => unary(&mut small[to.at], &large[a], |x| x.min(u32::MAX.into()) as u32),
            },
            Operation::ShiftLeft | Operation::ShiftRight => match to.size {
                Size::Small => {
                    let (before, out) = split(small, to.at);
                    shift(instruction, out, &before[a], &before[b]);
                }
                Size::Medium => {
                    let (before, out) = split(medium, to.at);
                    shift(instruction, out, &before[a], &small[b]);
                }
                Size::Large => {
                    let (before, out) = split(large, to.at);
                    shift(instruction, out, &before[a], &small[b]);
                }
            },
            Operation::Word(_) | Operation::Join | Operation::SignExtend => match to.size {
                Size::Small => {
                    let (before, out) = split(small, to.at);
                    word(instruction, out, &before[a], &before[b]);
                }
                Size::Medium => {
                    let (before, out) = split(medium, to.at);
                    word(instruction, out, &before[a], &before[b]);
                }
                Size::Large => {
                    let (before, out) = split(large, to.at);
                    word(instruction, out, &before[a], &before[b]);
                }
            },
        }
    }
}

fn push<T>(list: &mut Vec<T>, value: T) -> usize {
    list.push(value);
    list.len() - 1
}

/// The columns before one, and that one.
#[inline(always)]
fn split<T>(columns: &mut [[T; LANES]], at: usize) -> (&[[T; LANES]], &mut [T; LANES]) {
    let (before, rest) = columns.split_at_mut(at);
    (before, &mut rest[0])
}

#[inline(always)]
fn unary<T: Copy>(out: &mut [u32; LANES], a: &[T; LANES], f: impl Fn(T) -> u32) {
    for lane in 0..LANES {
        out[lane] = f(a[lane]);
    }
}

#[inline(always)]
fn binary<T: Copy, R>(out: &mut [R; LANES], a: &[T; LANES], b: &[T; LANES], f: impl Fn(T, T) -> R) {
    for lane in 0..LANES {
        out[lane] = f(a[lane], b[lane]);
    }
}

#[inline(always)]
fn selected<T: Copy>(select: &[u32; LANES], when_true: &[T; LANES], when_false: &[T; LANES]) -> [T; LANES] {
    let mut out = *when_false;
    for lane in 0..LANES {
        out[lane] = if select[lane] != 0 { when_true[lane] } else { when_false[lane] };
    }
    out
}

/// `(a >> shift) & mask` in another size.
#[inline(always)]
fn convert<A, R>(instruction: &Instruction, out: &mut [R; LANES], a: &[A; LANES])
where
    A: Value + AsPrimitive<R>,
    R: Value,
    u128: AsPrimitive<A> + AsPrimitive<R>,
    u32: AsPrimitive<A> + AsPrimitive<R>,
{
    let keep: R = instruction.mask.as_();
    for lane in 0..LANES {
        let moved: R = a[lane].unsigned_shr(instruction.shift).as_();
        out[lane] = moved & keep;
    }
}

#[inline(always)]
fn compare<T: Value>(
    instruction: &Instruction,
    test: BinaryOp,
    out: &mut [u32; LANES],
    a: &[T; LANES],
    b: &[T; LANES],
) where
    u128: AsPrimitive<T>,
    u32: AsPrimitive<T>,
{
    // Signed numbers order like unsigned ones when they are moved to the top of the word and their sign is flipped.
    let (up, sign) = (instruction.shift as usize, T::one() << (T::BITS as usize - 1));
    let key = |x: T| (x << up) ^ sign;
    match test {
        BinaryOp::Eq => binary(out, a, b, |a, b| u32::from(a == b)),
        BinaryOp::Ne => binary(out, a, b, |a, b| u32::from(a != b)),
        BinaryOp::Lt => binary(out, a, b, |a, b| u32::from(a < b)),
        BinaryOp::Le => binary(out, a, b, |a, b| u32::from(a <= b)),
        BinaryOp::SignedLt => binary(out, a, b, |a, b| u32::from(key(a) < key(b))),
        _ => binary(out, a, b, |a, b| u32::from(key(a) <= key(b))),
    }
}

#[inline(always)]
fn shift<T: Value>(instruction: &Instruction, out: &mut [T; LANES], a: &[T; LANES], amount: &[u32; LANES])
where
    u128: AsPrimitive<T>,
    u32: AsPrimitive<T>,
{
    let keep: T = instruction.mask.as_();
    let left = instruction.operation == Operation::ShiftLeft;
    for lane in 0..LANES {
        // The amount is reduced to the word, so that the shift is defined. An amount beyond the word gives zero.
        let (by, inside) = ((amount[lane] & (T::BITS - 1)) as usize, amount[lane] < T::BITS);
        let moved = if left { a[lane] << by } else { a[lane] >> by };
        out[lane] = if inside { moved & keep } else { T::zero() };
    }
}

#[inline(always)]
fn word<T: Value>(instruction: &Instruction, out: &mut [T; LANES], a: &[T; LANES], b: &[T; LANES])
where
    u128: AsPrimitive<T>,
    u32: AsPrimitive<T>,
{
    let keep: T = instruction.mask.as_();
    let up = instruction.shift as usize;
    match instruction.operation {
        Operation::Word(BinaryOp::And) => binary(out, a, b, |a, b| a & b),
        Operation::Word(BinaryOp::Or) => binary(out, a, b, |a, b| a | b),
        Operation::Word(BinaryOp::Xor) => binary(out, a, b, |a, b| a ^ b),
        Operation::Word(BinaryOp::Add) => binary(out, a, b, |a, b| a.wrapping_add(&b) & keep),
        Operation::Word(BinaryOp::Sub) => binary(out, a, b, |a, b| a.wrapping_sub(&b) & keep),
        Operation::Word(_) => binary(out, a, b, |a, b| a.wrapping_mul(&b) & keep),
        Operation::Join => binary(out, a, b, |a, b| a << up | b),
        _ => {
            // Flipping the sign bit and subtracting it extends the sign.
            let sign = T::one() << up;
            binary(out, a, b, |a, _| (a ^ sign).wrapping_sub(&sign) & keep);
        }
    }
}
