//! A pipeline mapped for a clock: several graphs and covers, each closed at the clock, of which the smallest that meets it stays.

use std::fmt;
use std::path::{Path, PathBuf};

use pipelines::catalogue::{StandardFormat, Top};
use rayon::prelude::*;

use super::implementation::Source;
use super::{EstimateError, Implementation};
use gates::abc::{self, AbcError, Script};
use gates::aig::Aig;
use gates::liberty::Library;
use gates::map::{Mapped, map, map_fast};
use gates::prove::{Limits, Miter, Verdict};
use gates::restructure::restructure;
use gates::timing::{Timing, analyse, close, fo4_ns, reference_slew_ns};
use gates::words::Structures;

/// How gates become cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Recipe {
    /// By our own mapper.
    Own {
        /// How often the graph is restructured for depth.
        rounds: usize,
        /// How much slower than the fastest cover the smallest may be, as a fraction; none for the smallest of all.
        slower: Option<f64>,
    },
    /// By ABC, with one of [`abc::SCRIPTS`].
    Abc(&'static str),
}

impl fmt::Display for Recipe {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (rounds, slower) = match *self {
            Self::Own { rounds, slower } => (rounds, slower),
            Self::Abc(script) => return write!(f, "ABC's script `{script}`"),
        };
        match rounds {
            0 => write!(f, "gates as they are, ")?,
            rounds => write!(f, "restructured {rounds} times, ")?,
        }
        match slower {
            None => write!(f, "mapped for area"),
            Some(slower) => write!(f, "mapped for delay + {:.0} %", 100.0 * slower),
        }
    }
}

/// Rounds of restructuring and delays above the fastest of our recipes, from small to fast.
const RECIPES: [(usize, Option<f64>); 5] =
    [(0, None), (0, Some(0.0)), (1, Some(0.2)), (2, Some(0.1)), (2, Some(0.0))];
/// What ABC is asked for, as fractions of a clock: it may meet a clock with less area if asked for a shorter one.
const ASKED: [f64; 3] = [0.8, 0.9, 1.0];
/// What ABC is asked for instead of no time at all, in picoseconds.
const LEAST_DELAY_PS: f64 = 1.0;

/// A unit or a pipeline mapped by every recipe, without buffers and sizes.
#[derive(Debug)]
pub struct Mappings<'l> {
    library: &'l Library,
    /// The gates as they are blasted, which every mapping is proved equal to.
    source: Aig,
    rows: Vec<(Recipe, Source, Mapped)>,
}

impl<'l> Mappings<'l> {
    /// Maps a unit or a pipeline in single precision by every recipe.
    ///
    /// # Errors
    /// [`EstimateError`] when the library lacks a cell.
    pub fn new(top: Top, library: &'l Library) -> Result<Self, EstimateError> {
        let mut sources = vec![Source::new(top, StandardFormat::Binary32, library, Structures::default())?];
        for round in 0..2 {
            let shallower = restructure(&sources[round].graph);
            sources.push(sources[round].with_graph(shallower));
        }
        let row = |(rounds, slower): (usize, Option<f64>)| {
            let source = sources[rounds].clone();
            let mapped = match slower {
                None => map(&source.graph, library)?,
                Some(slower) => map_fast(&source.graph, library, slower)?,
            };
            Ok((Recipe::Own { rounds, slower }, source, mapped))
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
        let area = |mapped: &Mapped| area_um2(mapped, library);
        let mut best: Option<((f64, f64), Implementation)> = None;
        for (recipe, source, mapped) in &self.rows {
            // Buffers and sizes make a netlist larger, so that one that is too large already need not be closed.
            if best.as_ref().is_some_and(|(known, _)| known.0 == 0.0 && area(mapped) > known.1) {
                continue;
            }
            let mut mapped = mapped.clone();
            let timing = close(&mut mapped, &source.graph, library, target_ns);
            let found = rank(&timing, area(&mapped), target_ns);
            if best.as_ref().is_none_or(|(known, _)| found < *known) {
                best = Some((found, source.clone().implemented(mapped, timing, library, *recipe)));
            }
        }
        let (_, implementation) = best.expect("there are recipes");
        implementation.proved(&self.source)
    }

    /// The pipeline mapped by ABC for each of some clocks, with the files `liberty` of the library and an empty folder for ABC's files: the
    /// smallest netlist of all scripts that meets the clock, or else the fastest, so that 0 gives the fastest of all. Each is proved
    /// equal to the gates as they were blasted. A cell's unit is the one that [`Mapped::attribute`] finds, as ABC keeps none apart.
    ///
    /// # Errors
    /// [`EstimateError::Abc`] where ABC is not installed or gives no netlist; [`EstimateError::Unproved`] if its netlist is not
    /// proved equal to the gates.
    pub fn by_abc(
        &self,
        clocks_ns: &[f64],
        liberty: &[PathBuf],
        folder: &Path,
    ) -> Result<Vec<Implementation<'l>>, EstimateError> {
        let library = self.library;
        let slew = reference_slew_ns(library);
        let load = 4.0 * library.cells[library.inverter()].capacitance_ff[0];
        let output = library.flip_flop.arc.delay_ns.iter().map(|table| table.at(slew, load));
        let register_ns = output.fold(0.0, f64::max) + library.flip_flop.setup_ns;
        let asked = clocks_ns.iter().flat_map(|clock| ASKED.map(|asked| asked * clock));
        let mut delays: Vec<f64> =
            asked.map(|ns| (1e3 * (ns - register_ns)).max(LEAST_DELAY_PS).round()).collect();
        delays.sort_by(f64::total_cmp);
        delays.dedup();
        let source = &self.rows[0].1;
        let run = |script: &Script| -> Result<Vec<(&'static str, Mapped, Timing)>, AbcError> {
            let folder = folder.join(script.name);
            std::fs::create_dir(&folder).map_err(|source| AbcError::File { path: folder.clone(), source })?;
            let all = abc::map(&source.graph, library, liberty, script, &delays, &folder)?;
            let timed = |mapped: Mapped| {
                let timing = analyse(&mapped, library);
                (script.name, mapped, timing)
            };
            Ok(all.into_iter().map(timed).collect())
        };
        let all = abc::SCRIPTS.par_iter().map(run).collect::<Result<Vec<_>, AbcError>>()?.concat();
        let implement = |&target_ns: &f64| {
            let ranked =
                all.iter().map(|found| (rank(&found.2, area_um2(&found.1, library), target_ns), found));
            let (_, (script, mapped, timing)) =
                ranked.min_by(|a, b| a.0.partial_cmp(&b.0).expect("numbers")).expect("there are scripts");
            let mut mapped = mapped.clone();
            let (function, literals) = mapped.function(&source.graph, library);
            for gating in &mut mapped.clock_gating {
                gating.condition = literals[gating.enable as usize];
            }
            mapped.literals = literals;
            let source = source.with_graph(function);
            source.implemented(mapped, timing.clone(), library, Recipe::Abc(script)).proved(&self.source)
        };
        clocks_ns.par_iter().map(implement).collect()
    }
}

/// What makes a netlist the better one at a clock, the less the better. Not the area counts of a netlist that misses the clock, but
/// its longest path.
fn rank(timing: &Timing, area_um2: f64, target_ns: f64) -> (f64, f64) {
    let ns = timing.critical_path_ns;
    if ns <= target_ns { (0.0, area_um2) } else { (ns, area_um2) }
}

fn area_um2(mapped: &Mapped, library: &Library) -> f64 {
    mapped.gates.iter().map(|gate| library.cells[gate.cell].area_um2).sum()
}

impl Implementation<'_> {
    /// Area of the cells that are no flip-flops and no clock gates.
    #[must_use]
    pub fn logic_um2(&self) -> f64 {
        area_um2(&self.mapped, self.library)
    }

    /// The clock that areas and energies hold for, as a part of their source.
    pub(super) fn speed(&self) -> String {
        let ns = self.timing.critical_path_ns;
        format!("longest path {ns:.3} ns, {:.1} FO4", ns / fo4_ns(self.library))
    }

    /// The same, if its cells are proved to compute what the gates of `source` do, for all inputs and states.
    fn proved(self, source: &Aig) -> Result<Self, EstimateError> {
        let (function, _) = self.mapped.function(&self.graph, self.library);
        let miter = Miter::new(source, &function).expect("mapping keeps ports and latches");
        match miter.prove(Limits::default()).verdict {
            Verdict::Equal => Ok(self),
            verdict => Err(EstimateError::Unproved(self.top, verdict)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use gates::liberty::{embedded, load};

    /// Mappings whose source has an output complemented are those of another circuit.
    fn spoil(mappings: &mut Mappings) {
        let output = &mut mappings.source.outputs[0];
        output.lit = !output.lit;
    }

    #[test]
    fn a_clock_is_met_with_the_least_area_or_missed_by_the_fastest() {
        let library = embedded();
        let mut mappings = Mappings::new(Top::FpCmp, &library).unwrap();
        let fastest = mappings.within(0.0).unwrap();
        let shortest_ns = fastest.timing.critical_path_ns;
        let relaxed = mappings.within(2.0 * shortest_ns).unwrap();
        assert!(relaxed.timing.critical_path_ns <= 2.0 * shortest_ns);
        assert!(relaxed.logic_um2() < 0.9 * fastest.logic_um2());
        let missed = mappings.within(0.5 * shortest_ns).unwrap();
        assert!(missed.timing.critical_path_ns < 1.05 * shortest_ns);
        spoil(&mut mappings);
        assert!(matches!(mappings.within(0.0), Err(EstimateError::Unproved(Top::FpCmp, _))));
    }

    #[test]
    fn abc_meets_a_clock_too() {
        if !testing::tools::provers_available() {
            return;
        }
        let Some(folder) = testing::data("liberty") else { return };
        let liberty = vec![folder.join("sg13g2_stdcell_typ_1p20V_25C.lib.gz")];
        let library = load(&liberty).unwrap();
        let mut mappings = Mappings::new(Top::FpCmp, &library).unwrap();
        let own = mappings.within(0.0).unwrap();
        let clock_ns = 2.0 * own.timing.critical_path_ns;
        let work = tempfile::tempdir().unwrap();
        let found = mappings.by_abc(&[0.0, clock_ns], &liberty, work.path()).unwrap();
        let [fastest, relaxed] = &found[..] else { panic!("one for each clock") };
        assert!(relaxed.timing.critical_path_ns <= clock_ns);
        assert!(fastest.timing.critical_path_ns < relaxed.timing.critical_path_ns);
        assert!(relaxed.logic_um2() < fastest.logic_um2());
        for found in [fastest, relaxed] {
            assert!(matches!(found.recipe, Recipe::Abc(_)));
            assert_eq!(found.stages().len(), own.stages().len());
            assert!(own.area().clock > 0.0 && found.area().clock == own.area().clock);
            assert_eq!(found.area().registers, own.area().registers);
        }
        spoil(&mut mappings);
        let work = tempfile::tempdir().unwrap();
        let spoilt = mappings.by_abc(&[clock_ns], &liberty, work.path());
        assert!(matches!(spoilt, Err(EstimateError::Unproved(Top::FpCmp, _))));
    }

    #[test]
    fn cells_without_origin_are_attributed_to_their_units() {
        let library = embedded();
        let mut pipeline =
            Implementation::new(Top::DualSplit, &library, gates::words::Structures::default()).unwrap();
        let own = pipeline.area();
        pipeline.mapped.gates.iter_mut().for_each(|gate| gate.origin = Default::default());
        assert_eq!(pipeline.area().all_units(), 0.0);
        pipeline.mapped.attribute(&pipeline.graph, &library);
        let found = pipeline.area();
        for (unit, area) in
            own.units.iter().map(|(unit, &area)| (Some(*unit), area)).chain([(None, own.glue)])
        {
            let attributed = unit.map_or(found.glue, |unit| found.units[&unit]);
            assert!((attributed / area - 1.0).abs() < 0.05, "{unit:?}: {attributed} instead of {area}");
        }
    }
}
