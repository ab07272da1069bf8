//! What each operation does to a thread.

use super::fault::{Fault, Mistake};
use super::special::Special;
use super::thread::{Context, Thread};
use crate::program::{CONDITION, Opcode, Operation, SINK};

impl Thread {
    /// Executes `operation`, which has index `at`.
    #[inline(always)]
    pub(super) fn execute<S: Special>(
        &mut self,
        at: usize,
        operation: &Operation,
        context: &mut Context<'_, '_, S>,
    ) -> Result<(), Box<Fault>> {
        use Opcode as O;
        let Operation { opcode, d, a, b, immediate } = *operation;
        let special = context.around.special;
        match opcode {
            O::Nop | O::Branch | O::Counter => {}
            O::Add => self.set(d, self.get(a).wrapping_add(self.get(b))),
            O::AddImmediate => self.set(d, self.get(a).wrapping_add(immediate as u32)),
            O::Subtract => self.set(d, self.get(a).wrapping_sub(self.get(b))),
            O::Multiply => self.set(d, self.get(a).wrapping_mul(self.get(b))),
            O::And => self.set(d, self.get(a) & self.get(b)),
            O::AndImmediate => self.set(d, self.get(a) & immediate as u32),
            O::Or => self.set(d, self.get(a) | self.get(b)),
            O::OrImmediate => self.set(d, self.get(a) | immediate as u32),
            O::Xor => self.set(d, self.get(a) ^ self.get(b)),
            O::XorImmediate => self.set(d, self.get(a) ^ immediate as u32),
            O::Nor => self.set(d, !(self.get(a) | self.get(b))),
            O::ShiftLeft => self.set(d, self.get(a) << (immediate & 31)),
            O::ShiftRight => self.set(d, self.get(a) >> (immediate & 31)),
            O::ShiftRightArithmetic => self.set(d, (self.get(a) as i32 >> (immediate & 31)) as u32),
            O::ShiftLeftBy => self.set(d, self.get(a) << (self.get(b) & 31)),
            O::ShiftRightBy => self.set(d, self.get(a) >> (self.get(b) & 31)),
            O::SetLess => self.set(d, u32::from((self.get(a) as i32) < self.get(b) as i32)),
            O::SetLessImmediate => self.set(d, u32::from((self.get(a) as i32) < immediate)),
            O::SetLessUnsigned => self.set(d, u32::from(self.get(a) < self.get(b))),
            O::SetLessUnsignedImmediate => self.set(d, u32::from(self.get(a) < immediate as u32)),
            O::Constant | O::PoolConstant => self.set(d, immediate as u32),
            O::Copy => self.set(d, self.get(a)),
            O::CopyIf => {
                let value = if self.get(b) != 0 { self.get(a) } else { self.get(d) };
                self.set(d, value);
            }
            O::CopyUnless => {
                let value = if self.get(b) == 0 { self.get(a) } else { self.get(d) };
                self.set(d, value);
            }
            O::FloatAdd => self.set_float(d, self.float(a) + self.float(b)),
            O::FloatSubtract => self.set_float(d, self.float(a) - self.float(b)),
            O::FloatMultiply => self.set_float(d, self.float(a) * self.float(b)),
            O::FloatDivide => self.set_float(d, self.float(a) / self.float(b)),
            O::FloatSquareRoot => self.set_float(d, self.float(a).sqrt()),
            O::FloatNegate => self.set(d, self.get(a) ^ 1 << 31),
            O::FloatAbsolute => self.set(d, self.get(a) & !(1 << 31)),
            O::FloatMinimum => self.set_float(d, special.minimum(self.float(a), self.float(b))),
            O::FloatMaximum => self.set_float(d, special.maximum(self.float(a), self.float(b))),
            O::InverseSquareRoot => self.set_float(d, special.inverse_square_root(self.float(a))),
            O::Sine => self.set_float(d, special.sine(self.float(a))),
            O::Cosine => self.set_float(d, special.cosine(self.float(a))),
            O::Random => {
                if self.dimension >= render::SAMPLE_DIMENSIONS {
                    return Err(self.fault(at, Mistake::Random, context));
                }
                self.set_float(d, special.random(self.item, self.dimension));
                self.dimension += 1;
            }
            O::IntegerToFloat => self.set_float(d, self.get(a) as i32 as f32),
            O::FloatToInteger => self.set(d, to_integer(self.float(a).round_ties_even())),
            O::FloatTruncate => self.set(d, to_integer(self.float(a).trunc())),
            O::Equal => self.set(CONDITION, u32::from(self.float(a) == self.float(b))),
            O::Less => self.set(CONDITION, u32::from(self.float(a) < self.float(b))),
            O::LessOrEqual => self.set(CONDITION, u32::from(self.float(a) <= self.float(b))),
            O::Unordered => {
                self.set(CONDITION, u32::from(self.float(a).partial_cmp(&self.float(b)).is_none()));
            }
            O::EqualOrUnordered => {
                let (a, b) = (self.float(a), self.float(b));
                self.set(CONDITION, u32::from(a.partial_cmp(&b).is_none_or(std::cmp::Ordering::is_eq)));
            }
            O::LessOrUnordered => {
                let greater_or_equal = self.float(a) >= self.float(b);
                self.set(CONDITION, u32::from(!greater_or_equal));
            }
            O::LessOrEqualOrUnordered => {
                let greater = self.float(a) > self.float(b);
                self.set(CONDITION, u32::from(!greater));
            }
            O::LoadLocal => {
                let value = self.load_local(at, self.get(a).wrapping_add(immediate as u32), context)?;
                self.set(d, value);
            }
            O::StoreLocal => {
                self.store_local(at, self.get(a).wrapping_add(immediate as u32), self.get(d), context)?;
            }
            // Of a pair, the odd register holds the upper half, which comes first in memory.
            O::LoadLocalPair => {
                let address = self.get(a).wrapping_add(immediate as u32);
                let pair = [0, 4].map(|offset| self.load_local(at, address.wrapping_add(offset), context));
                let [upper, lower] = pair;
                self.set(d + 1, upper?);
                self.set(d, lower?);
            }
            O::StoreLocalPair => {
                let address = self.get(a).wrapping_add(immediate as u32);
                self.store_local(at, address, self.get(d + 1), context)?;
                self.store_local(at, address.wrapping_add(4), self.get(d), context)?;
            }
            O::LoadLocalByte | O::LoadLocalByteUnsigned => {
                let address = self.get(a).wrapping_add(immediate as u32);
                let word = self.load_local(at, address & !3, context)?;
                let byte = word.to_be_bytes()[address as usize & 3];
                let value = if opcode == O::LoadLocalByte { byte as i8 as u32 } else { byte.into() };
                self.set(d, value);
            }
            O::StoreLocalByte => {
                let address = self.get(a).wrapping_add(immediate as u32);
                let mut bytes = self.load_local(at, address & !3, context)?.to_be_bytes();
                bytes[address as usize & 3] = self.get(d) as u8;
                self.store_local(at, address & !3, u32::from_be_bytes(bytes), context)?;
            }
            O::Load => {
                let value = self.load(at, operation, context)?;
                self.set(d, value);
            }
            O::LoadWords => {
                let words = &context.around.program.lists[immediate as usize >> 16];
                let base = self.get(a);
                for (word, register) in (0..).zip(words) {
                    let value = self.load_from(at, base, operation, word, context)?;
                    self.set(if *register == 0 { SINK } else { *register }, value);
                }
            }
            O::LoadLane => {
                let value = self.load(at, operation, context)?;
                let lane = self.lane(at, self.get(d), context)?;
                self.lanes[lane][operation.offset() as usize - 1] = f32::from_bits(value);
            }
            O::Store => self.store(at, operation, context)?,
            O::DualSplitStep => {
                self.dual_split_step(&context.around.program.lists[immediate as usize], special);
            }
            O::BoxTest => self.box_test(&context.around.program.lists[immediate as usize], special),
            O::BoxTestPair => self.box_test_pair(&context.around.program.lists[immediate as usize], special),
            O::BoxTestLanes => self.box_test_lanes(at, immediate as usize, context)?,
            O::LaneEntry => {
                let lane = self.lane(at, self.get(a), context)?;
                self.set_float(d, self.entries[lane]);
            }
            O::ExactTest => self.exact_test(at, immediate as usize, context)?,
        }
        Ok(())
    }
}

/// A float that is an integer as one; what is out of range gives 2^31 - 1, as MIPS32 has it.
#[inline(always)]
fn to_integer(x: f32) -> u32 {
    if (-2_147_483_648.0..2_147_483_648.0).contains(&x) { x as i32 as u32 } else { i32::MAX as u32 }
}
