//! The state in which items begin.

use super::local_store::{LOCAL_STORE_BYTES, LOCAL_STORE_WORDS};
use super::thread::Thread;
use crate::program::{Register, STACK_POINTER};
use std::collections::BTreeSet;

/// What an item finds where nothing or another item has written. A program that uses it computes something else than one that finds
/// what it expects: it is a NaN, and no address.
pub const POISON: u32 = 0x7fe5_e5e5;

/// The state of a thread that has come to an entry point.
#[derive(Clone, Debug, PartialEq)]
pub struct SetUp {
    /// Registers by their numbers.
    pub registers: [u32; 256],
    /// Words of the local store; none where nothing has been written, or other items write something else.
    pub local: Vec<Option<u32>>,
    /// The register that gets an item's number.
    pub item: Register,
    /// Registers that items leave otherwise; they hold [`POISON`].
    pub poisoned: BTreeSet<Register>,
}

impl SetUp {
    /// The state at the start of a program.
    #[must_use]
    pub fn start() -> Self {
        let mut registers = [0; 256];
        registers[usize::from(STACK_POINTER)] = LOCAL_STORE_BYTES;
        Self {
            registers,
            local: vec![None; LOCAL_STORE_WORDS],
            item: STACK_POINTER,
            poisoned: BTreeSet::new(),
        }
    }

    /// The state that `thread` has come to from this one, where it asks for an item to be put into the register `item`.
    #[must_use]
    pub fn after(&self, thread: &Thread, item: Register) -> Self {
        let mut local = self.local.clone();
        thread.local.touched().for_each(|(at, value)| local[at] = Some(value));
        Self { registers: thread.registers, local, item, poisoned: BTreeSet::new() }
    }

    /// Puts `thread` into this state.
    pub fn restore(&self, thread: &mut Thread) {
        thread.registers = self.registers;
        for register in &self.poisoned {
            thread.registers[usize::from(*register)] = POISON;
        }
    }

    /// Of the registers `read`, those that `thread` has left otherwise.
    pub fn other_registers<'a>(
        &self,
        thread: &'a Thread,
        read: &'a [Register],
    ) -> impl Iterator<Item = Register> + use<'a, '_> {
        let differs = |register: &Register| {
            let index = usize::from(*register);
            *register != self.item
                && thread.registers[index] != self.registers[index]
                && !self.poisoned.contains(register)
        };
        read.iter().copied().filter(differs)
    }

    /// Words of the local store that `thread` has left otherwise.
    pub fn other_words<'a>(&self, thread: &'a Thread) -> impl Iterator<Item = usize> + use<'a, '_> {
        let differs = |(at, value): &(usize, u32)| self.local[*at].is_some_and(|before| before != *value);
        thread.local.touched().filter(differs).map(|(at, _)| at)
    }
}
