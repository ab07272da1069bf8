//! The theorems about the hardware, by top and format.

use std::collections::BTreeMap;

use fp::Format;
use golden::dst::header;
use netlist::{Design, ElaborateError, flatten};
use pipelines::catalogue::{CatalogueError, StandardFormat, Top};
use rayon::prelude::*;

use super::reference::pipelines::{Claim, Control};
use super::reference::{exact, order};
use gates::aig::{Aig, Lit, Node};
use gates::blast::{ARITHMETIC, Cut, Options, blast};
use gates::prove::{CombinationalError, Limits, Proof, combinational, copy, prove};
use gates::words::{Adder, Multiplier, Structures};

/// Why a theorem cannot be stated.
#[derive(Debug, thiserror::Error)]
pub enum TheoremError {
    /// There is no such design.
    #[error(transparent)]
    Catalogue(#[from] CatalogueError),
    /// The design has a combinational loop.
    #[error(transparent)]
    Elaborate(#[from] ElaborateError),
    /// The design is no pipeline.
    #[error(transparent)]
    Combinational(#[from] CombinationalError),
    /// There is no reference for a top.
    #[error("no reference for {0}: there are those of the floating-point units and of both pipelines")]
    NoReference(Top),
}

/// The hardware and its reference, side by side.
#[derive(Clone, Debug)]
pub struct Theorem {
    /// Both circuits.
    pub aig: Aig,
    /// What is to be equal.
    pub pairs: Vec<(Lit, Lit)>,
    /// What each pair is, for messages.
    pub names: Vec<String>,
    /// Cases: values of some inputs, such that one case always holds. Each case has a proof of its own. If there are
    /// none, one proof covers all.
    pub cases: Vec<Vec<(String, bool)>>,
}

impl Theorem {
    /// The same for inputs that have these values only, by name.
    #[must_use]
    pub fn case(&self, values: &[(String, bool)]) -> Self {
        let mut aig = Aig::default();
        let free: Vec<Lit> =
            self.aig.inputs().iter().map(|input| aig.add_input(input.name.clone())).collect();
        let map = copy(&self.aig, &mut aig, |node| {
            let Node::Input(input) = node else { return Lit::FALSE };
            let name = &self.aig.inputs()[input as usize].name;
            let fixed = values.iter().find(|(fixed, _)| fixed == name);
            fixed.map_or(free[input as usize], |(_, value)| Lit::constant(*value))
        });
        let through = |lit: Lit| map[lit.node()].complement_if(lit.is_complemented());
        let pairs = self.pairs.iter().map(|&(a, b)| (through(a), through(b))).collect();
        Self { aig, pairs, names: self.names.clone(), cases: Vec::new() }
    }

    /// Proves the theorem case by case on all threads, or finds where it does not hold. Calls `case_done` after each
    /// case.
    #[must_use]
    pub fn prove(&self, limits: Limits, case_done: impl Fn() + Sync) -> Proof {
        if self.cases.is_empty() {
            return prove(&self.aig, &self.pairs, limits);
        }
        let proofs: Vec<Proof> = (self.cases.par_iter())
            .map(|values| {
                let case = self.case(values);
                let proof = prove(&case.aig, &case.pairs, limits);
                case_done();
                proof
            })
            .collect();
        Proof::of_cases(&proofs)
    }

    /// `top` in `format` as a function of its inputs, against its reference; adders and multipliers of a pipeline are
    /// free in both. `spoil` may change the hardware's netlist beforehand, to show that a proof can fail.
    ///
    /// # Errors
    /// [`TheoremError::NoReference`] for tops without one.
    ///
    /// # Panics
    /// If a reference has an output that the hardware lacks, which is a mistake in the reference.
    pub fn of(
        top: Top,
        format: StandardFormat,
        spoil: impl FnOnce(&mut Design),
    ) -> Result<Self, TheoremError> {
        let is_pipeline = matches!(top, Top::DualSplit | Top::DualSplitLean | Top::RayBox | Top::RayBoxLean);
        let mut design = top.design(format)?;
        spoil(&mut design);
        let hardware = function(&design, if is_pipeline { ARITHMETIC } else { &[] })?;
        let mut aig = Aig::default();
        let mut inputs: BTreeMap<String, Lit> = BTreeMap::new();
        for input in hardware.inputs() {
            inputs.insert(input.name.clone(), aig.add_input(input.name.clone()));
        }
        let map = copy(&hardware, &mut aig, |node| match node {
            Node::Input(i) => inputs[&hardware.inputs()[i as usize].name],
            _ => Lit::FALSE,
        });
        let outputs: BTreeMap<&str, Lit> = (hardware.outputs.iter())
            .map(|output| {
                let lit = map[output.lit.node()].complement_if(output.lit.is_complemented());
                (output.name.as_str(), lit)
            })
            .collect();
        let input = |name: &str| word(name, |bit| inputs.get(bit).copied());
        let claims = claims(top, format, &mut aig, &input)?;
        let cases = match top {
            Top::DualSplit | Top::DualSplitLean => header_cases(),
            Top::FpAdd | Top::FpMul => exponent_cases(format.format()),
            _ => Vec::new(),
        };
        let mut theorem = Self { aig, pairs: Vec::new(), names: Vec::new(), cases };
        for Claim { name, when, value } in claims {
            let found = word(&name, |bit| outputs.get(bit).copied());
            assert_eq!(found.len(), value.len(), "{top} has no output {name} of the reference's width");
            for (position, (expected, found)) in value.into_iter().zip(found).enumerate() {
                let expected = theorem.aig.and(when, expected);
                let found = theorem.aig.and(when, found);
                theorem.pairs.push((found, expected));
                theorem.names.push(format!("{name}[{position}]"));
            }
        }
        Ok(theorem)
    }
}

/// A design as a function of its inputs, in enabled cycles.
pub(super) fn function(design: &Design, cuts: &'static [Cut]) -> Result<Aig, TheoremError> {
    let options = Options {
        structures: Structures {
            adder: Adder::Ripple,
            multiplier: Multiplier::Tree,
            ..Structures::default()
        },
        cuts,
        keep_units: false,
    };
    Ok(combinational(&blast(design, &flatten(design)?, options).aig, "en_i")?)
}

/// Every value of the bits of a node's header that are not its offset.
fn header_cases() -> Vec<Vec<(String, bool)>> {
    let code = |value: u32| {
        let bit = |i: usize| (format!("header_i[{}]", header::HEADER.low + i), value >> i & 1 == 1);
        (0..header::HEADER.width).map(bit).collect()
    };
    (0..1 << header::HEADER.width).map(code).collect()
}

/// Every pair of exponent fields.
fn exponent_cases(format: Format) -> Vec<Vec<(String, bool)>> {
    let bits = format.exponent_bits();
    let code = |value: u32| {
        let bit = |i: u32| {
            let operand = if i < bits { "a_i" } else { "b_i" };
            (format!("{operand}[{}]", format.fraction_bits() + i % bits), value >> i & 1 == 1)
        };
        (0..2 * bits).map(bit).collect()
    };
    (0..1 << (2 * bits)).map(code).collect()
}

/// The bits called `name`, or `name[0]`, `name[1]`, ...
pub(super) fn word(name: &str, find: impl Fn(&str) -> Option<Lit>) -> Vec<Lit> {
    match find(name) {
        Some(lit) => vec![lit],
        None => (0..).map_while(|bit| find(&format!("{name}[{bit}]"))).collect(),
    }
}

fn claims(
    top: Top,
    format: StandardFormat,
    aig: &mut Aig,
    input: &dyn Fn(&str) -> Vec<Lit>,
) -> Result<Vec<Claim>, TheoremError> {
    let number = format.format();
    let (a, b) = (input("a_i"), input("b_i"));
    let always = |name: &str, value: Vec<Lit>| Claim { name: name.into(), when: Lit::TRUE, value };
    let mut claims = match top {
        Top::FpAdd => {
            let sum = exact::add(aig, number, &a, &b, input("subtract_i")[0], &input("rounding_i"));
            vec![always("result_o", sum)]
        }
        Top::FpMul => vec![always("result_o", exact::mul(aig, number, &a, &b, &input("rounding_i")))],
        Top::FpMinMax => {
            let (maximum, propagate) = (input("maximum_i")[0], input("propagate_nan_i")[0]);
            vec![always("result_o", order::min_max(aig, number, &a, &b, maximum, propagate))]
        }
        Top::FpCmp => {
            let [lt, le, eq] = order::compare(aig, number, &a, &b);
            vec![always("lt_o", vec![lt]), always("le_o", vec![le]), always("eq_o", vec![eq])]
        }
        Top::DualSplit | Top::DualSplitLean | Top::RayBox | Top::RayBoxLean => {
            let unit = |top: Top| function(&top.design(format)?, &[]);
            let (min_max, compare) = (unit(Top::FpMinMax)?, unit(Top::FpCmp)?);
            let mut control = Control { aig, input, min_max: &min_max, compare: &compare };
            let is_box = matches!(top, Top::RayBox | Top::RayBoxLean);
            return Ok(if is_box { control.ray_box() } else { control.dual_split() });
        }
        _ => return Err(TheoremError::NoReference(top)),
    };
    claims.push(always("valid_o", input("valid_i")));
    claims.push(always("tag_o", input("tag_i")));
    Ok(claims)
}
