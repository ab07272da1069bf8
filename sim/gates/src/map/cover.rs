//! Which cell computes which polarity of which node.

use super::MapError;
use super::cuts::Cut;
use super::patterns::{Match, Patterns};
use crate::aig::{Aig, Lit, Node};
use crate::liberty::Library;

/// Passes of exact-area recovery.
const EXACT_PASSES: usize = 4;
/// Areas that differ by less than this fraction are equal but for rounding.
const SAME_AREA: f32 = 1e-5;
/// Times in nanoseconds that differ by less are equal but for rounding.
const SAME_TIME: f32 = 1e-6;

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
    /// Estimated time at which each changes last, by the choices so far; zeros without a limit.
    arrival: Vec<f32>,
    /// When each is needed by its users; infinite without a limit.
    required: Vec<f32>,
}

/// What the first choices are made for.
#[derive(Clone, Copy, PartialEq)]
enum Flow {
    Area,
    Delay,
    /// The least area that arrives when it is needed.
    AreaWithin,
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
        slower: Option<f32>,
    ) -> Result<Self, MapError> {
        let count = 2 * aig.nodes().len();
        let mut cover = Self {
            aig,
            patterns,
            cuts,
            choices: vec![Choice::Inverter; count],
            uses: vec![0; count],
            levels: vec![0; count],
            arrival: vec![0.0; count],
            required: vec![f32::INFINITY; count],
        };
        let mut limit = None;
        match slower {
            None => cover.by_flow(library, Flow::Area)?,
            Some(slower) => {
                cover.by_flow(library, Flow::Delay)?;
                cover.count_uses();
                let found = (1.0 + slower) * cover.latest();
                cover.require(found);
                cover.by_flow(library, Flow::AreaWithin)?;
                limit = Some(found);
            }
        }
        cover.count_uses();
        for _ in 0..EXACT_PASSES {
            if let Some(limit) = limit {
                cover.require(limit);
            }
            cover.by_exact_area(limit.is_some());
        }
        Ok(cover)
    }

    /// Whether a polarity is used.
    pub fn is_used(&self, lit: Lit) -> bool {
        self.uses[lit.code() as usize] > 0
    }

    fn count_uses(&mut self) {
        self.uses.fill(0);
        let aig = self.aig;
        for lit in aig.roots().filter(|lit| lit.node() != 0) {
            self.take(lit);
        }
    }

    /// First choices, by area shared among estimated users, or by delay.
    fn by_flow(&mut self, library: &Library, goal: Flow) -> Result<(), MapError> {
        let live = self.aig.live();
        let mut users = vec![0u32; self.aig.nodes().len()];
        for node in (0..live.len()).filter(|&node| live[node]) {
            self.aig.operands(node).iter().flatten().for_each(|lit| users[lit.node()] += 1);
        }
        let mut flow = vec![0f32; self.choices.len()];
        let inverter = self.patterns.inverter.1;
        for node in 1..self.aig.nodes().len() {
            let (plain, complement) = (Lit::new(node, false), Lit::new(node, true));
            if self.aig.operands(node).is_none() {
                self.choices[plain.code() as usize] = Choice::Source;
                flow[complement.code() as usize] = inverter / 2.0;
                if goal != Flow::Area {
                    self.set_arrivals(node);
                }
                continue;
            }
            if !live[node] {
                continue;
            }
            // Time, as far as it counts, and flow.
            let mut best = [(f32::INFINITY, f32::INFINITY); 2];
            for polarity in [plain, complement] {
                let code = polarity.code() as usize;
                let required = self.required[code];
                let best = &mut best[usize::from(polarity.is_complemented())];
                for cut in &self.cuts[node] {
                    let table = if polarity.is_complemented() { !cut.table } else { cut.table };
                    for found in self.patterns.of(cut.size as usize, table) {
                        let inputs: f32 = operands(cut, found).map(|lit| flow[lit.code() as usize]).sum();
                        let choice = Choice::Cell(*cut, *found);
                        let cost = (self.late(&choice, polarity, goal, required), found.area + inputs);
                        if is_less(cost, *best) {
                            *best = cost;
                            self.choices[code] = choice;
                        }
                    }
                }
            }
            self.invert_where_better(node, goal, &mut best);
            if !best[0].1.is_finite() {
                return Err(MapError::Uncovered { library: library.name.clone(), node });
            }
            for (polarity, best) in [(plain, best[0]), (complement, best[1])] {
                flow[polarity.code() as usize] = best.1 / users[node].max(1) as f32;
            }
            if goal != Flow::Area {
                self.set_arrivals(node);
            }
        }
        Ok(())
    }

    /// Makes one polarity from the other if that costs less than its own cell.
    fn invert_where_better(&mut self, node: usize, goal: Flow, best: &mut [(f32, f32); 2]) {
        if goal != Flow::Area {
            for side in [0, 1] {
                let code = Lit::new(node, side == 1).code() as usize;
                // A polarity without a cell arrives behind the other.
                self.arrival[code] = if best[side].1.is_finite() {
                    self.arrival(&self.choices[code], code)
                } else {
                    f32::INFINITY
                };
            }
        }
        for side in [0, 1] {
            let lit = Lit::new(node, side == 1);
            let required = self.required[lit.code() as usize];
            let cost = (
                self.late(&Choice::Inverter, lit, goal, required),
                best[1 - side].1 + self.patterns.inverter.1,
            );
            if is_less(cost, best[side]) {
                best[side] = cost;
                self.choices[lit.code() as usize] = Choice::Inverter;
                return;
            }
        }
    }

    /// The time of a choice that counts against it: all of it, what exceeds the limit, or none.
    fn late(&self, choice: &Choice, lit: Lit, goal: Flow, required: f32) -> f32 {
        match goal {
            Flow::Area => 0.0,
            Flow::Delay => self.arrival(choice, lit.code() as usize),
            Flow::AreaWithin => (self.arrival(choice, lit.code() as usize) - required - SAME_TIME).max(0.0),
        }
    }

    /// When a literal, by its code, changes last if it is made so.
    fn arrival(&self, choice: &Choice, code: usize) -> f32 {
        let (inverter, delays) = (self.patterns.inverter.0, &self.patterns.delays);
        match choice {
            Choice::Source => match self.aig.nodes()[code / 2] {
                Node::Latch(_) => self.patterns.register.0,
                _ => 0.0,
            },
            Choice::Inverter => self.arrival[code ^ 1] + delays[inverter as usize][0],
            Choice::Cell(cut, found) => operands(cut, found)
                .zip(found.input)
                .map(|(lit, input)| {
                    self.arrival[lit.code() as usize] + delays[found.cell as usize][input as usize]
                })
                .fold(0.0, f32::max),
        }
    }

    /// Arrival times of both polarities of a node, by their choices.
    fn set_arrivals(&mut self, node: usize) {
        let (plain, complement) = (2 * node, 2 * node + 1);
        let is_behind = self.choices[plain] == Choice::Inverter;
        let order = if is_behind { [complement, plain] } else { [plain, complement] };
        for code in order {
            self.arrival[code] = self.arrival(&self.choices[code], code);
        }
    }

    /// What outputs and latches read, with the time by which it has to be there before the next clock edge.
    fn ends(&self) -> impl Iterator<Item = (Lit, f32)> {
        let setup = self.patterns.register.1;
        let outputs = self.aig.outputs.iter().map(|output| (output.lit, 0.0));
        let latches = self.aig.latches().iter().flat_map(|latch| [latch.data, latch.enable]);
        outputs.chain(latches.map(move |lit| (lit, setup)))
    }

    /// The estimated length of the longest path, by the choices so far.
    fn latest(&self) -> f32 {
        self.ends().map(|(lit, setup)| self.arrival[lit.code() as usize] + setup).fold(0.0, f32::max)
    }

    /// When each literal in use is needed, if paths may be as long as the limit, or as the longest is.
    fn require(&mut self, limit: f32) {
        let limit = limit.max(self.latest());
        self.required.fill(f32::INFINITY);
        let ends: Vec<(Lit, f32)> = self.ends().collect();
        for (lit, setup) in ends {
            let required = &mut self.required[lit.code() as usize];
            *required = required.min(limit - setup);
        }
        let (inverter, delays) = (self.patterns.inverter.0, &self.patterns.delays);
        for node in (1..self.aig.nodes().len()).rev() {
            let (plain, complement) = (Lit::new(node, false), Lit::new(node, true));
            let is_behind = self.choices[plain.code() as usize] == Choice::Inverter;
            let order = if is_behind { [plain, complement] } else { [complement, plain] };
            for lit in order.into_iter().filter(|&lit| self.uses[lit.code() as usize] > 0) {
                let end = self.required[lit.code() as usize];
                match self.choices[lit.code() as usize] {
                    Choice::Source => (),
                    Choice::Inverter => {
                        let required = &mut self.required[(!lit).code() as usize];
                        *required = required.min(end - delays[inverter as usize][0]);
                    }
                    Choice::Cell(cut, found) => {
                        for (operand, input) in operands(&cut, &found).zip(found.input) {
                            let required = &mut self.required[operand.code() as usize];
                            *required = required.min(end - delays[found.cell as usize][input as usize]);
                        }
                    }
                }
            }
        }
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

    /// For each polarity in use, the choice in time that adds least to the whole; of equal ones that with the fewest cells in
    /// a row.
    fn by_exact_area(&mut self, timed: bool) {
        for node in 1..self.aig.nodes().len() {
            if timed {
                self.set_arrivals(node);
            }
            if self.aig.operands(node).is_none() {
                continue;
            }
            for lit in [Lit::new(node, false), Lit::new(node, true)] {
                if !self.is_used(lit) {
                    continue;
                }
                let code = lit.code() as usize;
                self.drop_operands(lit);
                let present = self.choices[code];
                let mut best: Option<(f32, u32, Choice)> = None;
                let mut consider = |cover: &mut Self, choice: Choice| {
                    // The present choice stays where others shifted times so that it is late.
                    let limit = cover.required[code] + SAME_TIME;
                    if timed && choice != present && cover.arrival(&choice, code) > limit {
                        return;
                    }
                    let level = cover.level(lit, &choice);
                    cover.choices[code] = choice;
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
                if self.choices[code ^ 1] != Choice::Inverter {
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
                    self.choices[code] = choice;
                    self.levels[code] = level;
                }
                self.take_operands(lit);
            }
            if timed {
                self.set_arrivals(node);
            }
        }
    }
}

/// Whether a time and an area are better than others: sooner, or equally soon and smaller.
fn is_less(cost: (f32, f32), than: (f32, f32)) -> bool {
    cost.0 < than.0 - SAME_TIME || cost.0 <= than.0 + SAME_TIME && cost.1 < than.1
}
