//! The functions that cells compute, with inputs permuted and complemented.

use std::collections::HashMap;

use crate::liberty::function::{MAX_INPUTS, variable};
use crate::liberty::{Cell, Library};
use crate::timing::reference_slew_ns;

/// Most ways kept to compute one function.
const MOST_MATCHES: usize = 6;

/// The load that delays are estimated at before cells have sizes, in multiples of the input's own capacitance: a cell is made
/// as large as its load demands.
const EFFORT: f64 = 2.0;
/// Power of the number of inputs that multiplies an estimated delay. Cells of many inputs come in few sizes, and their stacks of
/// transistors make them slow under load. ABC's script for speed uses the same.
const WIDE: f64 = 0.9;

/// A cell that computes a function of a cut's leaves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Match {
    /// Position in the library.
    pub cell: u32,
    /// Area of the cell.
    pub area: f32,
    /// For each leaf, the input of the cell that it goes to.
    pub input: [u8; MAX_INPUTS],
    /// Leaves that are taken complemented, a bit each.
    pub complemented: u8,
}

/// All functions that some cell computes.
#[derive(Debug)]
pub struct Patterns {
    matches: HashMap<(u8, u64), Vec<Match>>,
    /// The inverter: position and area.
    pub inverter: (u32, f32),
    /// Estimated delay from each input of each cell of the library, in a unit for comparisons.
    pub delays: Vec<[f32; MAX_INPUTS]>,
    /// Estimated delay from the clock to the output of a flip-flop, and the setup time, in the same unit.
    pub register: (f32, f32),
}

impl Patterns {
    /// The patterns of a library: of cells with equal function the smallest.
    #[must_use]
    pub fn new(library: &Library) -> Self {
        let inverter = library.inverter();
        let mut patterns = Self {
            matches: HashMap::new(),
            inverter: (inverter as u32, library.cells[inverter].area_um2 as f32),
            delays: delays(library),
            register: register(library),
        };
        for (position, cell) in library.cells.iter().enumerate() {
            let inputs = cell.inputs.len();
            if inputs >= 2 && library.smallest(inputs, cell.function) == Some(position) {
                patterns.add(position as u32, cell.area_um2 as f32, inputs, cell.function);
            }
        }
        patterns
    }

    fn add(&mut self, cell: u32, area: f32, inputs: usize, function: u64) {
        for order in permutations(inputs) {
            for complemented in 0..1u8 << inputs {
                // Leaf i feeds cell input order[i].
                let table = arrange(function, inputs, &order, complemented);
                let found = Match { cell, area, input: order, complemented };
                let list = self.matches.entry((inputs as u8, table)).or_default();
                let same = |m: &Match| m.complemented == complemented && m.area <= area;
                if list.iter().any(same) {
                    continue;
                }
                let at = list.partition_point(|m| m.area <= area);
                list.insert(at, found);
                list.truncate(MOST_MATCHES);
            }
        }
    }

    /// Cells that compute a truth table of so many leaves, the smallest first.
    #[must_use]
    pub fn of(&self, leaves: usize, table: u64) -> &[Match] {
        self.matches.get(&(leaves as u8, table)).map_or(&[], Vec::as_slice)
    }
}

/// The slower edge of each arc, at the transition time of a chain of inverters and a load that suits the cell.
fn delays(library: &Library) -> Vec<[f32; MAX_INPUTS]> {
    let slew = reference_slew_ns(library);
    let of = |cell: &Cell| {
        let mut delays = [0.0; MAX_INPUTS];
        for ((delay, arc), capacitance) in delays.iter_mut().zip(&cell.arcs).zip(&cell.capacitance_ff) {
            let load = EFFORT * capacitance;
            let slower = arc.delay_ns.iter().map(|table| table.at(slew, load)).fold(0.0, f64::max);
            *delay = (slower * (cell.inputs.len() as f64).powf(WIDE)) as f32;
        }
        delays
    };
    library.cells.iter().map(of).collect()
}

fn register(library: &Library) -> (f32, f32) {
    let load = 2.0 * EFFORT * library.cells[library.inverter()].capacitance_ff[0];
    let tables = library.flip_flop.arc.delay_ns.iter();
    let delay = tables.map(|table| table.at(reference_slew_ns(library), load)).fold(0.0, f64::max);
    (delay as f32, library.flip_flop.setup_ns as f32)
}

/// The truth table over leaves of a cell's function.
fn arrange(function: u64, inputs: usize, order: &[u8; MAX_INPUTS], complemented: u8) -> u64 {
    let mut table = 0u64;
    for row in 0..1usize << inputs {
        let mut index = 0;
        for (leaf, &input) in order.iter().enumerate().take(inputs) {
            let bit = (row >> leaf & 1) ^ (complemented as usize >> leaf & 1);
            index |= bit << input;
        }
        table |= (function >> index & 1) << row;
    }
    replicate(table, inputs)
}

/// A table of fewer inputs, repeated so that it does not depend on the others.
fn replicate(mut table: u64, inputs: usize) -> u64 {
    for input in inputs..MAX_INPUTS {
        table &= !variable(input);
        table |= table << (1 << input);
    }
    table
}

fn permutations(count: usize) -> Vec<[u8; MAX_INPUTS]> {
    let mut all = Vec::new();
    let mut order: Vec<u8> = Vec::new();
    extend(count, &mut order, &mut all);
    all
}

fn extend(count: usize, order: &mut Vec<u8>, all: &mut Vec<[u8; MAX_INPUTS]>) {
    if order.len() == count {
        let mut full = [0; MAX_INPUTS];
        full[..count].copy_from_slice(order);
        all.push(full);
        return;
    }
    for input in 0..count as u8 {
        if !order.contains(&input) {
            order.push(input);
            extend(count, order, all);
            order.pop();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arranged_tables() {
        let [a, b] = [0, 1].map(variable);
        let mut swapped = [0; MAX_INPUTS];
        swapped[..2].copy_from_slice(&[1, 0]);
        assert_eq!(arrange(a & !b, 2, &swapped, 0), b & !a);
        assert_eq!(arrange(a & !b, 2, &swapped, 0b01), a & b);
        assert_eq!(permutations(4).len(), 24);
    }
}
