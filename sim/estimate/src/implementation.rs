//! A pipeline as cells of a library: mapped, sized, measured.

use std::collections::BTreeMap;

use netlist::{Design, Flat, ScopeId, flatten};
use pipelines::catalogue::{StandardFormat, Top};
use rayon::prelude::*;
use serde::Serialize;

use super::{Breakdown, EstimateError, Recipe, stages};
use costs::Unit;
use gates::aig::{Aig, Lit, Node, Origin};
use gates::blast::{Blasted, Options, blast, unit_scopes};
use gates::energy::{self, Energy, activity};
use gates::glitch;
use gates::liberty::Library;
use gates::map::{Mapped, map};
use gates::simulate::LANES_PER_WORD;
use gates::timing::{Timing, buffer, size};
use gates::words::Structures;

/// Cycles until a pipeline is filled.
const FILL_CYCLES: usize = 10;
/// Places in a stream that are simulated with glitches.
const GLITCH_WINDOWS: usize = 16;
/// Cycles whose changes are counted at each place.
const GLITCH_CYCLES: usize = 32;

/// A pipeline in a library.
#[derive(Debug)]
pub struct Implementation<'l> {
    /// The pipeline.
    pub top: Top,
    /// The pipeline's modules.
    pub design: Design,
    /// The pipeline's netlist of words.
    pub flat: Flat,
    /// The gates that were mapped, with those of each unit kept apart.
    pub graph: Aig,
    /// The bits of each input in the graph.
    pub inputs: Vec<Vec<Lit>>,
    /// The cells that the gates are mapped to, buffered and sized.
    pub mapped: Mapped,
    /// The timing of the cells.
    pub timing: Timing,
    /// The library of the cells.
    pub library: &'l Library,
    /// How the cells were found.
    pub recipe: Recipe,
    /// The stage at whose end each latch of the graph is.
    pub(super) latch_stages: Vec<u32>,
    units: Vec<Option<(ScopeId, Unit)>>,
}

/// Energy of an operation in a stream without idle cycles, in femtojoules.
#[derive(Clone, Debug, Serialize)]
pub struct EnergyReport {
    /// Every net changes at most once a cycle.
    pub zero_delay: Breakdown,
    /// With glitches, on a sample; see [`glitch`].
    pub with_glitches: Breakdown,
    /// Operations that `zero_delay` is the mean of.
    pub operations: u64,
    /// Operations that `with_glitches` is the mean of.
    pub glitch_operations: u64,
    /// Standard error of the total with glitches, as a fraction of that total. It follows from the scatter between places in
    /// the stream.
    pub glitch_error: Option<f64>,
}

/// All instances of one kind of module in the hierarchy, without the modules inside them.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct ModuleRow {
    /// The kind.
    pub module: String,
    /// Number of instances.
    pub instances: usize,
    /// Combinational cells.
    pub cells: usize,
    /// Their area.
    pub area_um2: f64,
    /// Flip-flops.
    pub registers: usize,
    /// Their area.
    pub register_area_um2: f64,
    /// Arrival time of the last output of these cells after the clock edge or the inputs.
    pub latest_ns: f64,
    /// The most cells on a path from a register or an input.
    pub levels: u32,
}

/// A unit or a pipeline as gates, before it is mapped.
#[derive(Clone, Debug)]
pub(super) struct Source {
    top: Top,
    design: Design,
    flat: Flat,
    pub graph: Aig,
    inputs: Vec<Vec<Lit>>,
    latch_stages: Vec<u32>,
    units: Vec<Option<(ScopeId, Unit)>>,
}

impl Source {
    pub fn new(
        top: Top,
        format: StandardFormat,
        library: &Library,
        structures: Structures,
    ) -> Result<Self, EstimateError> {
        let design = top.design(format)?;
        let flat = flatten(&design)?;
        let structures = structures.fitted(library);
        let options = Options { structures, keep_units: true, ..Options::default() };
        let Blasted { aig: mut graph, inputs, .. } = blast(&design, &flat, options);
        let latch_stages = stages::of_latches(&graph);
        if library.clock_gate.is_none() {
            graph.multiplex_enables();
        }
        let units = unit_scopes(&design, &flat)
            .into_iter()
            .map(|unit| unit.and_then(|(scope, kind)| Some((scope, Unit::of_module(kind)?))))
            .collect();
        Ok(Self { top, design, flat, graph, inputs, latch_stages, units })
    }

    /// The same pipeline with another graph of equal function and ports.
    pub fn with_graph(&self, graph: Aig) -> Self {
        let moved = |lit: &Lit| match self.graph.nodes()[lit.node()] {
            Node::Input(input) => graph.inputs()[input as usize].lit,
            _ => *lit,
        };
        let inputs = self.inputs.iter().map(|word| word.iter().map(moved).collect()).collect();
        Self { inputs, graph, ..self.clone() }
    }

    pub fn implemented<'l>(
        self,
        mapped: Mapped,
        timing: Timing,
        library: &'l Library,
        recipe: Recipe,
    ) -> Implementation<'l> {
        let Self { top, design, flat, graph, inputs, latch_stages, units } = self;
        Implementation {
            top,
            design,
            flat,
            graph,
            inputs,
            mapped,
            timing,
            library,
            recipe,
            latch_stages,
            units,
        }
    }
}

impl<'l> Implementation<'l> {
    /// Maps a pipeline to a library, and sizes its cells for the shortest critical path.
    ///
    /// # Errors
    /// [`EstimateError`] for tops that are no pipeline, or when the library lacks a cell.
    pub fn new(top: Top, library: &'l Library, structures: Structures) -> Result<Self, EstimateError> {
        Self::in_format(top, StandardFormat::Binary32, library, structures)
    }

    /// Does what [`Implementation::new`] does, in any format that modules exist for.
    ///
    /// # Errors
    /// [`EstimateError`] for tops that are no pipeline, or when the library lacks a cell.
    pub fn in_format(
        top: Top,
        format: StandardFormat,
        library: &'l Library,
        structures: Structures,
    ) -> Result<Self, EstimateError> {
        if !matches!(top, Top::DualSplit | Top::DualSplitLean | Top::RayBox | Top::RayBoxLean) {
            return Err(EstimateError::NoPipeline(top));
        }
        let source = Source::new(top, format, library, structures)?;
        let mut mapped = map(&source.graph, library)?;
        buffer(&mut mapped, &source.graph, library);
        let timing = size(&mut mapped, library, 0.0);
        let recipe = Recipe::Own { rounds: 0, slower: None };
        Ok(source.implemented(mapped, timing, library, recipe))
    }

    /// The unit that a gate of this origin belongs to; `None` for glue.
    fn unit(&self, origin: Origin) -> Option<Unit> {
        self.units[origin.scope as usize].map(|(_, unit)| unit)
    }

    /// The instance of the unit that a gate of this origin belongs to, or `glue`.
    pub(super) fn part(&self, origin: Origin) -> String {
        match self.units[origin.scope as usize] {
            Some((scope, _)) => self.flat.scopes[scope as usize].path.clone(),
            None => "glue".to_owned(),
        }
    }

    fn collect(&self, gates: impl Iterator<Item = f64>) -> Breakdown {
        let mut breakdown = Breakdown::default();
        for (gate, value) in self.mapped.gates.iter().zip(gates) {
            match self.unit(gate.origin) {
                Some(unit) => *breakdown.units.entry(unit).or_default() += value,
                None => breakdown.glue += value,
            }
        }
        breakdown
    }

    /// Area in square micrometres.
    #[must_use]
    pub fn area(&self) -> Breakdown {
        let library = self.library;
        let cells = self.mapped.gates.iter().map(|gate| library.cells[gate.cell].area_um2);
        let mut area = self.collect(cells);
        area.registers = self.mapped.registers.len() as f64 * library.flip_flop.area_um2;
        if let Some(gate) = &library.clock_gate {
            let gates: usize = self.mapped.clock_gating.iter().map(|gating| gating.gates).sum();
            area.clock = gates as f64 * gate.area_um2;
        }
        area
    }

    /// Leakage power in nanowatts.
    #[must_use]
    pub fn leakage_nw(&self) -> f64 {
        let gates: f64 = self.mapped.gates.iter().map(|gate| self.library.cells[gate.cell].leakage_nw).sum();
        gates + self.mapped.registers.len() as f64 * self.library.flip_flop.leakage_nw
    }

    /// Energy of an operation of a stream without glitches, and the number of operations in the mean; see
    /// [`Implementation::energy`].
    #[must_use]
    pub fn zero_delay_energy(&self, stream: &[Vec<u128>]) -> (Breakdown, u64) {
        let length = stream.len() / LANES_PER_WORD;
        let lanes: Vec<Vec<Vec<u128>>> = if length > 2 * FILL_CYCLES {
            stream.chunks_exact(length).take(LANES_PER_WORD).map(<[Vec<u128>]>::to_vec).collect()
        } else {
            vec![stream.to_vec()]
        };
        let (aig, inputs) = (&self.graph, &self.inputs);
        let activity = activity(aig, inputs, &lanes, FILL_CYCLES);
        let cycles = activity.cycles.max(1) as f64;
        let by_node = |net: u32| activity.changes[self.mapped.literals[net as usize].node()] as f64 / cycles;
        let energy = energy::energy(&self.mapped, self.library, &self.timing, by_node);
        (self.spread(&energy), activity.cycles)
    }

    /// Energy of an operation of a stream. The stream has the values of all inputs in each cycle, and an operation in
    /// each cycle.
    #[must_use]
    pub fn energy(&self, stream: &[Vec<u128>]) -> EnergyReport {
        let (zero_delay, operations) = self.zero_delay_energy(stream);
        let (aig, inputs) = (&self.graph, &self.inputs);
        let windows: Vec<(Vec<u64>, u64)> = (0..GLITCH_WINDOWS)
            .into_par_iter()
            .map(|window| {
                let start = stream.len() * window / GLITCH_WINDOWS;
                let end = stream.len().min(start + FILL_CYCLES + 1 + GLITCH_CYCLES);
                let sample = &stream[start..end];
                glitch::changes(aig, &self.mapped, self.library, &self.timing, inputs, sample, FILL_CYCLES)
            })
            .collect();
        let glitch_operations: u64 = windows.iter().map(|(_, cycles)| cycles).sum();
        let mut changes = vec![0u64; self.mapped.nets];
        for (counts, _) in &windows {
            changes.iter_mut().zip(counts).for_each(|(sum, count)| *sum += count);
        }
        let with_glitches = self.with_changes(&changes, glitch_operations);
        let totals: Vec<f64> = (windows.iter().filter(|(_, cycles)| *cycles > 0))
            .map(|(counts, cycles)| self.with_changes(counts, *cycles).total())
            .collect();
        EnergyReport {
            zero_delay,
            with_glitches,
            operations,
            glitch_operations,
            glitch_error: relative_standard_error(&totals),
        }
    }

    /// Energy of an operation, from the changes of each net in `operations` operations.
    fn with_changes(&self, changes: &[u64], operations: u64) -> Breakdown {
        let by_net = |net: u32| changes[net as usize] as f64 / operations.max(1) as f64;
        self.spread(&energy::energy(&self.mapped, self.library, &self.timing, by_net))
    }

    fn spread(&self, energy: &Energy) -> Breakdown {
        let mut breakdown = self.collect(energy.gates_fj.iter().copied());
        breakdown.registers = energy.registers_fj.iter().sum();
        breakdown.clock = energy.clock_fj;
        breakdown.inputs = energy.inputs_fj;
        breakdown
    }

    /// Every kind of module, the largest first.
    #[must_use]
    pub fn modules(&self) -> Vec<ModuleRow> {
        let kind = |scope: ScopeId| self.design.module(self.flat.scopes[scope as usize].module).kind.as_str();
        let mut rows: BTreeMap<&str, ModuleRow> = BTreeMap::new();
        for scope in 0..self.flat.scopes.len() as ScopeId {
            rows.entry(kind(scope)).or_default().instances += 1;
        }
        let mut levels = vec![0u32; self.mapped.nets];
        for gate in &self.mapped.gates {
            let below = gate.inputs.iter().map(|&net| levels[net as usize]).max().unwrap_or(0);
            levels[gate.output as usize] = below + 1;
            let row = rows.entry(kind(gate.origin.scope)).or_default();
            row.cells += 1;
            row.area_um2 += self.library.cells[gate.cell].area_um2;
            row.latest_ns = row.latest_ns.max(self.timing.latest(gate.output));
            row.levels = row.levels.max(below + 1);
        }
        for register in &self.mapped.registers {
            let row = rows.entry(kind(register.origin.scope)).or_default();
            row.registers += 1;
            row.register_area_um2 += self.library.flip_flop.area_um2;
        }
        let mut rows: Vec<ModuleRow> =
            rows.into_iter().map(|(kind, row)| ModuleRow { module: kind.to_owned(), ..row }).collect();
        rows.sort_by(|a, b| b.area_um2.total_cmp(&a.area_um2).then_with(|| a.module.cmp(&b.module)));
        rows
    }
}

/// Standard error of the mean of samples, as a fraction of the mean; none for fewer than two samples, which say nothing about it.
fn relative_standard_error(samples: &[f64]) -> Option<f64> {
    let count = samples.len() as f64;
    let mean = samples.iter().sum::<f64>() / count;
    if samples.len() < 2 || mean == 0.0 {
        return None;
    }
    let variance = samples.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / (count - 1.0);
    Some((variance / count).sqrt() / mean)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn standard_errors() {
        assert_eq!(relative_standard_error(&[]), None);
        assert_eq!(relative_standard_error(&[3.0]), None);
        assert_eq!(relative_standard_error(&[2.0, 2.0, 2.0]), Some(0.0));
        // Variance 2, error of the mean 1, mean 2.
        assert_eq!(relative_standard_error(&[1.0, 3.0]), Some(0.5));
    }
}
