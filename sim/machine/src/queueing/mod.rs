//! A level between bound and transactions: caches by their tags, everything else by what waiting takes on the average.
//!
//! Threads execute the same runs with the same addresses as in the timing core, but a run is one step. It takes
//! * the cycles that it takes alone behind the run before it (`profile`),
//! * the mean wait for its fetches and units, by the balance of a closed queue whose customers are the threads of a
//!   multiprocessor (`population`, `contention`),
//! * the time until lines arrive that are not in the first-level cache (`caches`, `behind`): banks of caches, data buses and rows
//!   of the DRAM are promised slot by slot (`calendar`, `dram`).
//!
//! Threads have their turn one after another in windows of some cycles, so that the caches see their lines mixed as on the machine.
//! The waits follow from how often each run was executed lately, by all multiprocessors together.
//!
//! Several machines share one execution (`items`): an item is executed once and forgotten when all have taken it.

mod behind;
mod caches;
mod calendar;
mod contention;
mod dram;
mod items;
mod model;
mod population;
mod profile;
#[cfg(test)]
mod tests;
mod thread;

use crate::core::{Counts, SimulationError, Work};
use crate::description::MachineDescription;
use crate::program::Program;
use items::Items;
use model::Model;
use rayon::prelude::*;

/// Items that are executed at a time.
const CHUNK: u32 = 1024;

/// Estimates what each of `machines` counts when it executes `work`. Their programs have the same runs.
///
/// `items_done` is called with the number of items executed since its last call.
///
/// # Errors
/// See [`SimulationError`].
pub fn estimate<W: Work>(
    machines: &[(&MachineDescription, &Program)],
    work: &W,
    mut items_done: impl FnMut(u32),
) -> Result<Vec<Counts>, SimulationError> {
    let Some((_, program)) = machines.first() else {
        return Ok(vec![]);
    };
    let threads = machines.iter().map(|(machine, _)| machine.chip.tms() * machine.tm.threads);
    let (most, fewest) = (threads.clone().max().unwrap_or(0), threads.min().unwrap_or(0));
    let mut items = Items::new(work, program, 0..most, fewest..u32::MAX)?;
    let mut models: Vec<(Model<'_>, bool)> =
        machines.iter().map(|(machine, program)| (Model::new(machine, program, &items), false)).collect();
    while models.iter().any(|(_, done)| !done) {
        let done = items.end();
        items.execute(CHUNK)?;
        items_done(items.end() - done);
        models.par_iter_mut().filter(|(_, done)| !done).try_for_each(|(model, done)| {
            *done = model.advance(&items)?;
            Ok::<(), SimulationError>(())
        })?;
        items.forget(models.iter().map(|(model, _)| model.next_item).min().unwrap_or(0));
    }
    Ok(models.into_iter().map(|(model, _)| model.counts()).collect())
}
