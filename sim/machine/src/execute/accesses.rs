//! Accesses to global memory and to the local store.

use super::fault::{Fault, Mistake};
use super::local_store::LocalStore;
use super::set_up::POISON;
use super::thread::{Context, Surroundings, Thread};
use crate::core::Tape;
use crate::program::Operation;

impl Thread {
    #[inline(always)]
    pub(super) fn load<S>(
        &self,
        at: usize,
        operation: &Operation,
        word: u32,
        context: &Context<'_, S>,
        tape: &mut Tape<'_>,
    ) -> Result<u32, Box<Fault>> {
        self.load_from(at, self.get(operation.a), operation, word, context, tape)
    }

    /// Word `word` of what a load from `base` brings.
    #[inline(always)]
    pub(super) fn load_from<S>(
        &self,
        at: usize,
        base: u32,
        operation: &Operation,
        word: u32,
        context: &Context<'_, S>,
        tape: &mut Tape<'_>,
    ) -> Result<u32, Box<Fault>> {
        if operation.b != 0 && word == 0 {
            tape.address(base);
        }
        let address = base.wrapping_add(operation.offset()).wrapping_add(word);
        let Surroundings { program, memory, .. } = context.around;
        memory
            .load(address, self.item)
            .map_err(|denied| Fault::new(program, at, self.item, Mistake::Load(address, denied)))
    }

    #[inline(always)]
    pub(super) fn load_local<S>(
        &mut self,
        at: usize,
        address: u32,
        context: &mut Context<'_, S>,
    ) -> Result<u32, Box<Fault>> {
        let program = context.around.program;
        let index = LocalStore::index(address)
            .map_err(|misplaced| Fault::new(program, at, self.item, Mistake::Local(address, misplaced)))?;
        Ok(match self.local.load(index) {
            Some(value) => value,
            None => self.inherit(at, index, context),
        })
    }

    /// A word that the item has not written: what the thread's set-up has left there.
    #[inline(never)]
    pub(super) fn inherit<S>(&mut self, at: usize, index: usize, context: &Context<'_, S>) -> u32 {
        let Some(value) = context.set_up.local[index] else {
            self.poisoned_reads.entry(index).or_insert(at);
            return POISON;
        };
        self.inherited[usize::from(context.entry)].insert(index);
        value
    }

    #[inline(always)]
    pub(super) fn store_local<S>(
        &mut self,
        at: usize,
        address: u32,
        value: u32,
        context: &Context<'_, S>,
    ) -> Result<(), Box<Fault>> {
        let index = LocalStore::index(address).map_err(|misplaced| {
            Fault::new(context.around.program, at, self.item, Mistake::Local(address, misplaced))
        })?;
        self.local.store(index, value);
        Ok(())
    }

    /// Stores a word to global memory.
    #[inline(always)]
    pub(super) fn store<S>(
        &mut self,
        at: usize,
        operation: &Operation,
        context: &Context<'_, S>,
        tape: &mut Tape<'_>,
    ) -> Result<(), Box<Fault>> {
        let (base, value) = (self.get(operation.a), self.get(operation.d));
        if operation.b != 0 {
            tape.address(base);
        }
        let address = base.wrapping_add(operation.offset());
        let around = context.around;
        around
            .memory
            .store(address, value, self.item)
            .map_err(|denied| Fault::new(around.program, at, self.item, Mistake::Store(address, denied)))?;
        self.stored.push([address, value]);
        Ok(())
    }
}
