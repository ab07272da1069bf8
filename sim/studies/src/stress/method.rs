//! A method: a structure that is traversed with an arithmetic.

use super::Hardware;
use fp::Format;
use golden::build::BinaryTree;
use golden::bvh::box_step;
use golden::dst::Dst;
use golden::precision::{NarrowDst, NarrowRay, NarrowStructure, Precision, Variant};
use golden::structure::{Structure, StructureKind, TooLarge};
use golden::traverse::{Counters, NoObserver, Trace, closest_by_steps};
use golden::triangle::Triangle;
use golden::{Aabb, Hit, Mode, Ray, TraversalRay};
use logic::steps::DualSplitStep;
use netlist::{Flat, flatten};
use pipelines::catalogue::{StandardFormat, Top};
use std::cell::RefCell;
use std::fmt;
use std::str::FromStr;
use std::sync::Arc;

/// How distances to planes are computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Arithmetic {
    /// In binary32, by the kernels that renderings use.
    Native(Mode),
    /// In another format, by golden's traversal for any format.
    Narrow(Precision),
    /// By the netlist of the dual-split pipeline in binary32.
    Netlist(Mode),
    /// By the netlist of the dual-split pipeline in another format, which rounds to nearest.
    NarrowNetlist(StandardFormat),
}

impl Arithmetic {
    /// The mode in which rays are prepared and triangles tested.
    #[must_use]
    pub fn mode(self) -> Mode {
        match self {
            Self::Native(mode) | Self::Netlist(mode) => mode,
            Self::Narrow(precision) => precision.variant.mode(),
            Self::NarrowNetlist(_) => Variant::Naive.mode(),
        }
    }

    /// Whether hits must never be lost.
    #[must_use]
    pub fn is_safe(self) -> bool {
        self.mode() == Mode::Robust
    }

    /// The format of distances.
    #[must_use]
    pub fn format(self) -> Format {
        match self {
            Self::Native(_) | Self::Netlist(_) => Format::BINARY32,
            Self::Narrow(precision) => precision.format,
            Self::NarrowNetlist(format) => format.format(),
        }
    }
}

/// A structure with an arithmetic.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Method {
    /// The structure.
    pub structure: StructureKind,
    /// How distances to planes are computed.
    pub arithmetic: Arithmetic,
}

/// A name that no method has.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "there is no method '{0}': write STRUCTURE/binary32-fast, STRUCTURE/binary32-robust, STRUCTURE/FORMAT-naive or \
     STRUCTURE/FORMAT-conservative with a STRUCTURE of {structures} and a FORMAT such as binary16 or e8m10, or \
     rtl/binary32-robust, rtl/binary32-fast, rtl/FORMAT-naive with a FORMAT of `dualsplit export`",
    structures = StructureKind::names()
)]
pub struct MethodError(String);

/// `dst/binary32-robust`, `bvh4/tf32-naive`, `rtl/binary32-fast`.
impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kind = self.structure;
        match self.arithmetic {
            Arithmetic::Native(mode) => write!(f, "{kind}/binary32-{}", mode.name()),
            Arithmetic::Narrow(precision) => write!(f, "{kind}/{precision}"),
            Arithmetic::Netlist(mode) => write!(f, "rtl/binary32-{}", mode.name()),
            Arithmetic::NarrowNetlist(format) => write!(f, "rtl/{format}-{}", Variant::Naive.name()),
        }
    }
}

impl FromStr for Method {
    type Err = MethodError;

    fn from_str(name: &str) -> Result<Self, MethodError> {
        let parse = || {
            let (structure, rest) = name.split_once('/')?;
            let (format, suffix) = rest.rsplit_once('-')?;
            let mode = [Mode::Fast, Mode::Robust].into_iter().find(|mode| mode.name() == suffix);
            let variant = Variant::ALL.into_iter().find(|variant| variant.name() == suffix);
            let is_binary32 = format == Format::BINARY32.to_string();
            let (structure, arithmetic) = if structure == "rtl" {
                let arithmetic = match (mode, variant) {
                    (Some(mode), _) if is_binary32 => Arithmetic::Netlist(mode),
                    (_, Some(Variant::Naive)) => Arithmetic::NarrowNetlist(format.parse().ok()?),
                    _ => return None,
                };
                (StructureKind::Dst, arithmetic)
            } else {
                let arithmetic = match (mode, variant) {
                    (Some(mode), _) if is_binary32 => Arithmetic::Native(mode),
                    (_, Some(variant)) => Arithmetic::Narrow(Precision::new(format.parse().ok()?, variant)),
                    _ => return None,
                };
                (structure.parse().ok()?, arithmetic)
            };
            Some(Self { structure, arithmetic })
        };
        parse().ok_or_else(|| MethodError(name.to_owned()))
    }
}

impl Method {
    /// The methods of the stability table: all structures in binary32, and in the named formats naive and conservative.
    #[must_use]
    pub fn software() -> Vec<Self> {
        let formats = [Format::TF32, Format::BFLOAT16, Format::BINARY16, Format::E5M2, Format::E4M3];
        let narrow = formats.into_iter().flat_map(|format| Variant::ALL.map(|v| Precision::new(format, v)));
        let native = [Mode::Fast, Mode::Robust].map(Arithmetic::Native);
        let arithmetics: Vec<_> = native.into_iter().chain(narrow.map(Arithmetic::Narrow)).collect();
        let others = StructureKind::ALL.into_iter().filter(|kind| *kind != StructureKind::Dst);
        std::iter::once(StructureKind::Dst)
            .chain(others)
            .flat_map(|structure| arithmetics.iter().map(move |&arithmetic| Self { structure, arithmetic }))
            .collect()
    }

    /// The methods whose node steps the netlist of the pipeline executes.
    #[must_use]
    pub fn hardware() -> Vec<Self> {
        let native = [Mode::Fast, Mode::Robust].map(Arithmetic::Netlist);
        let narrow = [StandardFormat::Tf32, StandardFormat::Bfloat16, StandardFormat::Binary16];
        let arithmetics = native.into_iter().chain(narrow.map(Arithmetic::NarrowNetlist));
        arithmetics.map(|arithmetic| Self { structure: StructureKind::Dst, arithmetic }).collect()
    }

    /// 0 where rays are prepared and triangles tested in fast mode, 1 in robust mode.
    pub(super) fn mode_index(self) -> usize {
        usize::from(self.arithmetic.mode() == Mode::Robust)
    }

    /// Whether a netlist executes the node steps. Its visits are those of the software.
    #[must_use]
    pub fn is_hardware(self) -> bool {
        matches!(self.arithmetic, Arithmetic::Netlist(_) | Arithmetic::NarrowNetlist(_))
    }

    /// Whether that netlist is interpreted, which is thousands of times slower than software. The netlist in binary32 is compiled.
    #[must_use]
    pub fn is_interpreted(self) -> bool {
        matches!(self.arithmetic, Arithmetic::NarrowNetlist(_))
    }

    /// The netlist that is interpreted for this method's steps, or `None` if none is.
    ///
    /// # Panics
    /// If the pipeline does not elaborate, which the tests of `hdl` rule out.
    #[must_use]
    pub fn netlist(self) -> Option<Arc<Flat>> {
        let Arithmetic::NarrowNetlist(format) = self.arithmetic else { return None };
        let design = Top::DualSplit.design(format).expect("the pipeline elaborates");
        Some(Arc::new(flatten(&design).expect("the pipeline is flattened")))
    }

    /// The method over one tree. `netlist` has to be the result of [`Method::netlist`].
    #[must_use]
    pub fn instance(self, structures: &Structures, netlist: Option<&Arc<Flat>>) -> Instance {
        let wide = structures.get(self.structure);
        let dst = || match &**wide {
            Structure::Dst(dst) => dst,
            _ => unreachable!("netlists step through dual-split trees"),
        };
        let traced = match (self.arithmetic, netlist) {
            (Arithmetic::Native(_), _) => Traced::Native(wide.clone()),
            (Arithmetic::Narrow(precision), _) => Traced::Narrow(NarrowStructure::new(wide, precision)),
            (Arithmetic::Netlist(_), _) => Traced::Netlist(dst().clone()),
            (Arithmetic::NarrowNetlist(format), Some(netlist)) => {
                let precision = Precision::new(format.format(), Variant::Naive);
                Traced::NarrowNetlist(NarrowDst::new(dst(), precision), netlist.clone())
            }
            (Arithmetic::NarrowNetlist(_), None) => unreachable!("interpreted methods have a netlist"),
        };
        Instance { method: self, traced }
    }
}

/// All structures over one hierarchy, in binary32.
#[derive(Debug)]
pub struct Structures(Vec<Arc<Structure>>);

impl Structures {
    /// Converts `tree`, whose triangles are `triangles`.
    ///
    /// # Errors
    /// [`TooLarge`] if the dual-split tree is too large for its format.
    pub fn new(tree: &BinaryTree, triangles: &Arc<[Triangle]>) -> Result<Self, TooLarge> {
        let convert = |kind| Structure::convert(kind, tree, triangles).map(Arc::new);
        StructureKind::ALL.into_iter().map(convert).collect::<Result<_, _>>().map(Self)
    }

    fn get(&self, kind: StructureKind) -> &Arc<Structure> {
        self.0.iter().find(|structure| structure.kind() == kind).expect("a structure of each kind")
    }
}

thread_local! {
    /// The compiled pipeline in binary32.
    static STEP: RefCell<DualSplitStep> = RefCell::default();
}

/// A method over one tree.
#[derive(Debug)]
pub struct Instance {
    /// The method.
    pub method: Method,
    traced: Traced,
}

#[derive(Debug)]
enum Traced {
    Native(Arc<Structure>),
    Narrow(NarrowStructure),
    Netlist(Dst),
    NarrowNetlist(NarrowDst, Arc<Flat>),
}

impl Instance {
    /// The nearest hit of `ray`.
    #[must_use]
    pub fn closest(&self, ray: &Ray) -> Option<Hit> {
        let prepared = TraversalRay::new(ray, self.method.arithmetic.mode())?;
        match &self.traced {
            Traced::Native(structure) => structure.closest_prepared(&prepared, &mut NoObserver),
            Traced::Narrow(structure) => structure.closest_prepared(&prepared, &mut NoObserver),
            Traced::Netlist(dst) => STEP.with_borrow_mut(|hardware| {
                closest_by_steps(dst, &prepared, &mut NoObserver, |words, ray, low, high| {
                    hardware.step(words, &ray.planes(), low, high)
                })
            }),
            Traced::NarrowNetlist(dst, netlist) => {
                let mut hardware = Hardware::new(netlist);
                let arithmetic = fp::Arithmetic::new(dst.precision.format);
                dst.closest_by_steps(&prepared, &mut NoObserver, |words, ray, low, high| {
                    hardware.narrow_step(arithmetic, words, ray, low, high)
                })
            }
        }
    }

    /// Number of nodes that the search for the nearest hit of `ray` visits. It is zero for netlists, whose visits are those of the
    /// software.
    #[must_use]
    pub fn visits(&self, ray: &Ray) -> u64 {
        let mut counters = Counters::default();
        let Some(prepared) = TraversalRay::new(ray, self.method.arithmetic.mode()) else { return 0 };
        let _: Option<Hit> = match &self.traced {
            Traced::Native(structure) => structure.closest_prepared(&prepared, &mut counters),
            Traced::Narrow(structure) => structure.closest_prepared(&prepared, &mut counters),
            Traced::Netlist(_) | Traced::NarrowNetlist(..) => None,
        };
        counters.node_visits
    }

    /// The length of the interval that the method computes for a box of the scene, in units in the last place of its end.
    ///
    /// The length is below zero if the ray misses the box. It is `None` if the ray is not valid or the interval has no end.
    #[must_use]
    pub fn slack(&self, bounds: &Aabb, ray: &Ray) -> Option<f64> {
        let prepared = TraversalRay::new(ray, self.method.arithmetic.mode())?;
        let (entry, exit) = match &self.traced {
            Traced::Native(_) | Traced::Netlist(_) => {
                let test = box_step(bounds, &prepared, prepared.t_min, prepared.t_max);
                (test.t_entry, test.t_exit)
            }
            Traced::Narrow(structure) => {
                let (bounds, ray): (Aabb, NarrowRay) = structure.narrow(bounds, &prepared);
                let test = box_step(&bounds, &ray, ray.t_min, ray.t_max);
                (test.t_entry, test.t_exit)
            }
            Traced::NarrowNetlist(dst, _) => {
                let (bounds, ray) = (dst.aabb(bounds), dst.ray(&prepared));
                let test = box_step(&bounds, &ray, ray.t_min, ray.t_max);
                (test.t_entry, test.t_exit)
            }
        };
        let (entry, exit) = (f64::from(entry), f64::from(exit));
        let size = entry.abs().max(exit.abs());
        let ulp = size * libm::exp2(-f64::from(self.method.arithmetic.format().fraction_bits()));
        (size.is_finite() && ulp > 0.0).then(|| (exit - entry) / ulp)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_method_parses_from_its_name() {
        let all = Method::software().into_iter().chain(Method::hardware());
        let mut names = std::collections::BTreeSet::new();
        for method in all {
            assert_eq!(method.to_string().parse(), Ok(method));
            assert!(names.insert(method.to_string()));
        }
        assert_eq!(names.len(), StructureKind::ALL.len() * (2 + 10) + 5);
        for bad in
            ["dst", "dst/binary32", "dst/fast", "rtl/tf32-conservative", "kd/binary32-fast", "dst/e9m3-naive"]
        {
            assert!(bad.parse::<Method>().unwrap_err().to_string().contains(bad));
        }
    }
}
