//! Accesses to global memory and to the local store.

use super::fault::{Fault, Mistake};
use super::local_store::LocalStore;
use super::set_up::POISON;
use super::thread::{Context, Thread};
use crate::program::Operation;

impl Thread {
    /// A word of global memory.
    #[inline(always)]
    pub(super) fn load<S>(
        &self,
        at: usize,
        operation: &Operation,
        context: &mut Context<'_, '_, S>,
    ) -> Result<u32, Box<Fault>> {
        self.load_from(at, self.get(operation.a), operation, 0, context)
    }

    /// Word `word` of what a load from `base` brings.
    #[inline(always)]
    pub(super) fn load_from<S>(
        &self,
        at: usize,
        base: u32,
        operation: &Operation,
        word: u32,
        context: &mut Context<'_, '_, S>,
    ) -> Result<u32, Box<Fault>> {
        if operation.b != 0 && word == 0 {
            context.tape.address(base);
        }
        let address = base.wrapping_add(operation.offset()).wrapping_add(word);
        let loaded = context.around.memory.load(address, self.item);
        loaded.map_err(|denied| self.fault(at, Mistake::Load(address, denied), context))
    }

    /// Stores a word to global memory.
    #[inline(always)]
    pub(super) fn store<S>(
        &mut self,
        at: usize,
        operation: &Operation,
        context: &mut Context<'_, '_, S>,
    ) -> Result<(), Box<Fault>> {
        let (base, value) = (self.get(operation.a), self.get(operation.d));
        if operation.b != 0 {
            context.tape.address(base);
        }
        let address = base.wrapping_add(operation.offset());
        let stored = context.around.memory.store(address, value, self.item);
        stored.map_err(|denied| self.fault(at, Mistake::Store(address, denied), context))?;
        self.stored.push([address, value]);
        Ok(())
    }

    /// A word of the local store.
    #[inline(always)]
    pub(super) fn load_local<S>(
        &mut self,
        at: usize,
        address: u32,
        context: &Context<'_, '_, S>,
    ) -> Result<u32, Box<Fault>> {
        let index = self.local_index(at, address, context)?;
        Ok(match self.local.load(index) {
            Some(value) => value,
            None => self.inherit(at, index, context),
        })
    }

    /// A word that the item has not written: what the thread's set-up has left there.
    #[inline(never)]
    fn inherit<S>(&mut self, at: usize, index: usize, context: &Context<'_, '_, S>) -> u32 {
        let Some(value) = context.set_up.local[index] else {
            self.poisoned_reads.entry(index).or_insert(at);
            return POISON;
        };
        self.inherited[usize::from(context.entry)].insert(index);
        value
    }

    /// Stores a word to the local store.
    #[inline(always)]
    pub(super) fn store_local<S>(
        &mut self,
        at: usize,
        address: u32,
        value: u32,
        context: &Context<'_, '_, S>,
    ) -> Result<(), Box<Fault>> {
        let index = self.local_index(at, address, context)?;
        self.local.store(index, value);
        Ok(())
    }

    #[inline(always)]
    fn local_index<S>(
        &self,
        at: usize,
        address: u32,
        context: &Context<'_, '_, S>,
    ) -> Result<usize, Box<Fault>> {
        LocalStore::index(address)
            .map_err(|misplaced| self.fault(at, Mistake::Local(address, misplaced), context))
    }
}
