//! Which cell computes which polarity of which node.

use super::MapError;
use super::cuts::Cut;
use super::patterns::{Match, Patterns};
use crate::aig::{Aig, Lit};
use crate::liberty::Library;

/// Passes of exact-area recovery.
const EXACT_PASSES: usize = 4;
/// Areas that differ by less than this fraction are equal but for rounding.
const SAME_AREA: f32 = 1e-5;

/// How one polarity of a node is made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Choice {
    /// The literal exists already: an input or a latch.
    Source,
    /// An inverter behind the other polarity.
    Inverter,
    /// A cell over a cut.
    Cell(Cut, Match),
}

/// A choice for both polarities of each node, and how often each is used.
pub struct Cover<'a> {
    aig: &'a Aig,
    patterns: &'a Patterns,
    cuts: Vec<Vec<Cut>>,
    /// By code of the literal: plain, then complemented.
    pub choices: Vec<Choice>,
    uses: Vec<u32>,
    /// Most cells in a row up to each, by the choices so far.
    levels: Vec<u32>,
}

/// The literals that a match reads.
pub fn operands(cut: &Cut, found: &Match) -> impl Iterator<Item = Lit> {
    let complemented = found.complemented;
    let leaves = *cut;
    (0..cut.size as usize)
        .map(move |leaf| Lit::new(leaves.leaves[leaf] as usize, complemented >> leaf & 1 == 1))
}

impl<'a> Cover<'a> {
    pub fn new(
        aig: &'a Aig,
        library: &Library,
        patterns: &'a Patterns,
        cuts: Vec<Vec<Cut>>,
    ) -> Result<Self, MapError> {
        let count = 2 * aig.nodes().len();
        let choices = vec![Choice::Inverter; count];
        let mut cover = Self { aig, patterns, cuts, choices, uses: vec![0; count], levels: vec![0; count] };
        cover.by_flow(library)?;
        for lit in aig.roots().filter(|lit| lit.node() != 0) {
            cover.take(lit);
        }
        for _ in 0..EXACT_PASSES {
            cover.by_exact_area();
        }
        Ok(cover)
    }

    /// Whether a polarity is used.
    pub fn is_used(&self, lit: Lit) -> bool {
        self.uses[lit.code() as usize] > 0
    }

    /// First choices, by area shared among estimated users.
    fn by_flow(&mut self, library: &Library) -> Result<(), MapError> {
        let live = self.aig.live();
        let mut users = vec![0u32; self.aig.nodes().len()];
        for node in (0..live.len()).filter(|&node| live[node]) {
            self.aig.operands(node).iter().flatten().for_each(|lit| users[lit.node()] += 1);
        }
        let mut flow = vec![0f32; self.choices.len()];
        for node in 1..self.aig.nodes().len() {
            let (plain, complement) = (Lit::new(node, false), Lit::new(node, true));
            if self.aig.operands(node).is_none() {
                self.choices[plain.code() as usize] = Choice::Source;
                flow[complement.code() as usize] = self.patterns.inverter.1 / 2.0;
                continue;
            }
            if !live[node] {
                continue;
            }
            let mut best = [f32::INFINITY; 2];
            for polarity in [plain, complement] {
                for cut in &self.cuts[node] {
                    let table = if polarity.is_complemented() { !cut.table } else { cut.table };
                    for found in self.patterns.of(cut.size as usize, table) {
                        let inputs: f32 = operands(cut, found).map(|lit| flow[lit.code() as usize]).sum();
                        let cost = found.area + inputs;
                        if cost < best[usize::from(polarity.is_complemented())] {
                            best[usize::from(polarity.is_complemented())] = cost;
                            self.choices[polarity.code() as usize] = Choice::Cell(*cut, *found);
                        }
                    }
                }
            }
            let inverter = self.patterns.inverter.1;
            if best[0] > best[1] + inverter {
                best[0] = best[1] + inverter;
                self.choices[plain.code() as usize] = Choice::Inverter;
            } else if best[1] > best[0] + inverter {
                best[1] = best[0] + inverter;
                self.choices[complement.code() as usize] = Choice::Inverter;
            }
            if !best[0].is_finite() {
                return Err(MapError::Uncovered { library: library.name.clone(), node });
            }
            for (polarity, best) in [(plain, best[0]), (complement, best[1])] {
                flow[polarity.code() as usize] = best / users[node].max(1) as f32;
            }
        }
        Ok(())
    }

    /// Uses a polarity once more; the area that this adds.
    fn take(&mut self, lit: Lit) -> f32 {
        let uses = &mut self.uses[lit.code() as usize];
        *uses += 1;
        if *uses > 1 { 0.0 } else { self.take_operands(lit) }
    }

    fn take_operands(&mut self, lit: Lit) -> f32 {
        match self.choices[lit.code() as usize] {
            Choice::Source => 0.0,
            Choice::Inverter => self.patterns.inverter.1 + self.take(!lit),
            Choice::Cell(cut, found) => {
                operands(&cut, &found).fold(found.area, |area, operand| area + self.take(operand))
            }
        }
    }

    /// Uses a polarity once less; the area that this saves.
    fn drop(&mut self, lit: Lit) -> f32 {
        let uses = &mut self.uses[lit.code() as usize];
        *uses -= 1;
        if *uses > 0 { 0.0 } else { self.drop_operands(lit) }
    }

    fn drop_operands(&mut self, lit: Lit) -> f32 {
        match self.choices[lit.code() as usize] {
            Choice::Source => 0.0,
            Choice::Inverter => self.patterns.inverter.1 + self.drop(!lit),
            Choice::Cell(cut, found) => {
                operands(&cut, &found).fold(found.area, |area, operand| area + self.drop(operand))
            }
        }
    }

    /// Most cells in a row up to a polarity that is made so.
    fn level(&self, lit: Lit, choice: &Choice) -> u32 {
        let of = |lit: Lit| self.levels[lit.code() as usize];
        match choice {
            Choice::Source => 0,
            Choice::Inverter => of(!lit) + 1,
            Choice::Cell(cut, found) => operands(cut, found).map(of).max().unwrap_or(0) + 1,
        }
    }

    /// For each polarity in use, the choice that adds least to the whole; of equal ones that with the fewest cells in a row.
    fn by_exact_area(&mut self) {
        for node in 1..self.aig.nodes().len() {
            if self.aig.operands(node).is_none() {
                continue;
            }
            for lit in [Lit::new(node, false), Lit::new(node, true)] {
                if !self.is_used(lit) {
                    continue;
                }
                self.drop_operands(lit);
                let mut best: Option<(f32, u32, Choice)> = None;
                let mut consider = |cover: &mut Self, choice: Choice| {
                    let level = cover.level(lit, &choice);
                    cover.choices[lit.code() as usize] = choice;
                    let area = cover.take_operands(lit);
                    cover.drop_operands(lit);
                    let is_better = |(least, shortest, _): (f32, u32, Choice)| {
                        area < least - SAME_AREA * least
                            || area <= least + SAME_AREA * least && level < shortest
                    };
                    if best.is_none_or(is_better) {
                        best = Some((area, level, choice));
                    }
                };
                // Two inverters behind each other would each be made from the other.
                if self.choices[(!lit).code() as usize] != Choice::Inverter {
                    consider(self, Choice::Inverter);
                }
                for position in 0..self.cuts[node].len() {
                    let cut = self.cuts[node][position];
                    let table = if lit.is_complemented() { !cut.table } else { cut.table };
                    let patterns = self.patterns;
                    for found in patterns.of(cut.size as usize, table) {
                        consider(self, Choice::Cell(cut, *found));
                    }
                }
                if let Some((_, level, choice)) = best {
                    self.choices[lit.code() as usize] = choice;
                    self.levels[lit.code() as usize] = level;
                }
                self.take_operands(lit);
            }
        }
    }
}
