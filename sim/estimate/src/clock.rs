//! A pipeline mapped for a clock: several graphs and covers, each closed at the clock, of which the smallest that meets it stays.

use std::fmt;
use std::path::{Path, PathBuf};

use pipelines::catalogue::{StandardFormat, Top};
use rayon::prelude::*;

use super::implementation::Source;
use super::{EstimateError, Implementation};
use gates::abc::{self, Script};
use gates::aig::Aig;
use gates::liberty::Library;
use gates::map::{Mapped, map, map_fast};
use gates::prove::{Limits, Miter, Verdict};
use gates::restructure::restructure;
use gates::timing::{Timing, analyse, close, reference_slew_ns};
use gates::words::Structures;

/// How gates become cells.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Recipe {
    /// How often the graph is restructured for depth.
    pub rounds: usize,
    /// How much slower than the fastest cover the smallest may be, as a fraction; none for the smallest of all.
    pub slower: Option<f64>,
}

impl fmt::Display for Recipe {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.rounds {
            0 => write!(f, "gates as they are, ")?,
            rounds => write!(f, "restructured {rounds} times, ")?,
        }
        match self.slower {
            None => write!(f, "mapped for area"),
            Some(slower) => write!(f, "mapped for delay + {:.0} %", 100.0 * slower),
        }
    }
}

/// From small to fast.
const RECIPES: [Recipe; 5] = [
    Recipe { rounds: 0, slower: None },
    Recipe { rounds: 0, slower: Some(0.0) },
    Recipe { rounds: 1, slower: Some(0.2) },
    Recipe { rounds: 2, slower: Some(0.1) },
    Recipe { rounds: 2, slower: Some(0.0) },
];

/// A pipeline mapped by every recipe, without buffers and sizes.
#[derive(Debug)]
pub struct Mappings<'l> {
    library: &'l Library,
    /// The gates as they are blasted, which every mapping is proved equal to.
    source: Aig,
    rows: Vec<(Recipe, Source, Mapped)>,
}

impl<'l> Mappings<'l> {
    /// Maps a pipeline in single precision by every recipe.
    ///
    /// # Errors
    /// [`EstimateError`] for tops that are no pipeline, or when the library lacks a cell.
    pub fn new(top: Top, library: &'l Library) -> Result<Self, EstimateError> {
        let mut sources = vec![Source::new(top, StandardFormat::Binary32, library, Structures::default())?];
        for round in 0..2 {
            let shallower = restructure(&sources[round].graph);
            sources.push(sources[round].with_graph(shallower));
        }
        let row = |recipe: Recipe| {
            let source = sources[recipe.rounds].clone();
            let mapped = match recipe.slower {
                None => map(&source.graph, library)?,
                Some(slower) => map_fast(&source.graph, library, slower)?,
            };
            Ok((recipe, source, mapped))
        };
        let rows = RECIPES.into_par_iter().map(row).collect::<Result<Vec<_>, EstimateError>>()?;
        Ok(Self { library, source: sources[0].graph.clone(), rows })
    }

    /// The smallest netlist whose longest path is within `target_ns`; the fastest where there is none, so that 0 gives the
    /// fastest of all. It is proved equal to the gates as they were blasted.
    ///
    /// # Errors
    /// [`EstimateError::Unproved`] if the proof fails, which is a fault of the mapper.
    pub fn within(&self, target_ns: f64) -> Result<Implementation<'l>, EstimateError> {
        let library = self.library;
        let area = |mapped: &Mapped| -> f64 {
            mapped.gates.iter().map(|gate| library.cells[gate.cell].area_um2).sum()
        };
        // Not the area counts of a netlist that misses the clock, but its longest path.
        let rank = |timing: &Timing, area: f64| {
            let ns = timing.critical_path_ns;
            if ns <= target_ns { (0.0, area) } else { (ns, area) }
        };
        let mut best: Option<((f64, f64), Implementation)> = None;
        for (recipe, source, mapped) in &self.rows {
            // Buffers and sizes make a netlist larger, so that one that is too large already need not be closed.
            if best.as_ref().is_some_and(|(known, _)| known.0 == 0.0 && area(mapped) > known.1) {
                continue;
            }
            let mut mapped = mapped.clone();
            let timing = close(&mut mapped, &source.graph, library, target_ns);
            let found = rank(&timing, area(&mapped));
            if best.as_ref().is_none_or(|(known, _)| found < *known) {
                best = Some((found, source.clone().implemented(mapped, timing, library, *recipe)));
            }
        }
        let (_, implementation) = best.expect("there are recipes");
        match implementation.compare(&self.source) {
            Verdict::Equal => Ok(implementation),
            verdict => Err(EstimateError::Unproved(implementation.top, verdict)),
        }
    }
}

impl<'l> Mappings<'l> {
    /// The pipeline mapped by ABC for each of some clocks, with the files `liberty` of the library and a folder for ABC's files. The
    /// library has to be one without clock gates. All cells are glue, for ABC keeps no units apart.
    ///
    /// # Errors
    /// [`EstimateError::Abc`] where ABC is not installed or gives no netlist; [`EstimateError::Unproved`] if its netlist is not
    /// proved equal to the gates.
    pub fn by_abc(
        &self,
        script: &Script,
        clocks_ns: &[f64],
        liberty: &[PathBuf],
        folder: &Path,
    ) -> Result<Vec<Implementation<'l>>, EstimateError> {
        let library = self.library;
        let slew = reference_slew_ns(library);
        let load = 4.0 * library.cells[library.inverter()].capacitance_ff[0];
        let output = library.flip_flop.arc.delay_ns.iter().map(|table| table.at(slew, load));
        let register_ns = output.fold(0.0, f64::max) + library.flip_flop.setup_ns;
        let delays: Vec<f64> = clocks_ns.iter().map(|ns| 1e3 * (ns - register_ns).max(1e-3)).collect();
        let source = &self.rows[0].1;
        let all = abc::map(&self.source, library, liberty, script, &delays, folder)?;
        let implement = |mut mapped: Mapped| {
            let (function, literals) = mapped.function(&self.source, library);
            mapped.literals = literals;
            let timing = analyse(&mapped, library);
            let source = source.with_graph(function);
            let implementation = source.implemented(mapped, timing, library, Recipe::default());
            match implementation.compare(&self.source) {
                Verdict::Equal => Ok(implementation),
                verdict => Err(EstimateError::Unproved(implementation.top, verdict)),
            }
        };
        all.into_par_iter().map(implement).collect()
    }
}

impl Implementation<'_> {
    /// Area of the cells that are no flip-flops and no clock gates.
    #[must_use]
    pub fn logic_um2(&self) -> f64 {
        self.mapped.gates.iter().map(|gate| self.library.cells[gate.cell].area_um2).sum()
    }

    /// Whether the cells compute what a graph with the same ports and latches does, for all inputs and states.
    #[must_use]
    pub fn compare(&self, source: &Aig) -> Verdict {
        let (function, _) = self.mapped.function(&self.graph, self.library);
        let miter = Miter::new(source, &function).expect("mapping keeps ports and latches");
        miter.prove(Limits::default()).verdict
    }
}
