//! The adder of any format against exact integers, with one case for each distance between the exponents.
//!
//! There are some hundred distances where there are tens of thousands of pairs of exponents. Within a case one
//! exponent is free, and the other follows from it. A test counts that the cases hold every pair.

use fp::Format;
use netlist::Design;
use pipelines::catalogue::{StandardFormat, Top};
use rayon::prelude::*;

use super::reference::{ADDER, aligned};
use super::theorems::{Theorem, TheoremError, function, word};
use gates::aig::{Aig, Lit, Node};
use gates::prove::{Limits, Proof, copy, prove};
use gates::words;

/// Operands by their exponent fields.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SumCase {
    /// One operand is an infinity or a NaN, the other any word.
    Special {
        /// Whether the first operand is the infinity or NaN.
        first: bool,
    },
    /// Both are finite, and the first exponent exceeds the second by this much. The exponent of a subnormal counts as
    /// the least exponent of normal numbers. Where both exponents are the least, both numbers are normal, or both are
    /// subnormal.
    Distance(i32),
    /// A subnormal and a normal number of the least exponent.
    Least {
        /// The subnormal is the first.
        first: bool,
    },
}

impl SumCase {
    /// All cases of a format.
    #[must_use]
    pub fn all(format: Format) -> Vec<Self> {
        // From the least exponent to the largest of finite numbers.
        let most = (1 << format.exponent_bits()) - 3;
        let both = [true, false];
        let mut cases: Vec<Self> = both.map(|first| Self::Special { first }).into();
        cases.extend(both.map(|first| Self::Least { first }));
        cases.extend((-most..=most).map(Self::Distance));
        cases
    }

    /// The operands of this case, as functions of free ones.
    fn operands(self, aig: &mut Aig, format: Format, a: &[Lit], b: &[Lit]) -> [Vec<Lit>; 2] {
        let fraction_bits = format.fraction_bits() as usize;
        let exponent_bits = format.exponent_bits();
        let exponents = fraction_bits..fraction_bits + exponent_bits as usize;
        let with = |word: &[Lit], field: &[Lit]| {
            let mut word = word.to_vec();
            word[exponents.clone()].copy_from_slice(field);
            word
        };
        let constant = |value: u32| words::constant(value.into(), exponent_bits);
        let largest = (1 << exponent_bits) - 1;
        match self {
            Self::Special { first: true } => [with(a, &constant(largest)), b.to_vec()],
            Self::Special { first: false } => [a.to_vec(), with(b, &constant(largest))],
            Self::Least { first } => {
                [with(a, &constant(u32::from(!first))), with(b, &constant(u32::from(first)))]
            }
            Self::Distance(0) => {
                let field = up_to(aig, &a[exponents.clone()], largest - 1);
                [with(a, &field), with(b, &field)]
            }
            Self::Distance(difference) => {
                let distance = difference.unsigned_abs();
                let (low, high) = if difference > 0 { (b, a) } else { (a, b) };
                let field = up_to(aig, &low[exponents.clone()], largest - 1 - distance);
                let normal = words::any(aig, &field);
                let mut exponent = field.clone();
                exponent[0] = aig.or(exponent[0], !normal);
                let (sum, _) = words::add(aig, ADDER, &exponent, &constant(distance), Lit::FALSE);
                let (low, high) = (with(low, &field), with(high, &sum));
                if difference > 0 { [high, low] } else { [low, high] }
            }
        }
    }

    /// How far apart the exponents are, if both operands are finite.
    fn distance(self) -> Option<i32> {
        match self {
            Self::Special { .. } => None,
            Self::Distance(distance) => Some(distance),
            Self::Least { .. } => Some(0),
        }
    }
}

/// A word that is at most `most`: those beyond become 0.
fn up_to(aig: &mut Aig, word: &[Lit], most: u32) -> Vec<Lit> {
    let beyond = words::less(aig, &words::constant(most.into(), word.len() as u32), word);
    word.iter().map(|&bit| aig.and(bit, !beyond)).collect()
}

/// The adder of a format, to be proved.
#[derive(Clone, Debug)]
pub struct Sums {
    format: Format,
    hardware: Aig,
    /// What there is to prove.
    pub cases: Vec<SumCase>,
}

impl Sums {
    /// The adder of `format`; `spoil` may change its netlist beforehand, to show that a proof can fail.
    ///
    /// # Errors
    /// When the changed netlist is no pipeline.
    pub fn new(format: StandardFormat, spoil: impl FnOnce(&mut Design)) -> Result<Self, TheoremError> {
        let mut design = Top::FpAdd.design(format)?;
        spoil(&mut design);
        let hardware = function(&design, &[])?;
        let format = format.format();
        Ok(Self { format, hardware, cases: SumCase::all(format) })
    }

    /// The theorem of a case.
    ///
    /// # Panics
    /// If the adder lacks one of its ports.
    #[must_use]
    pub fn theorem(&self, case: SumCase) -> Theorem {
        let format = self.format;
        let mut aig = Aig::default();
        let free: Vec<(String, Lit)> = (self.hardware.inputs().iter())
            .map(|input| (input.name.clone(), aig.add_input(input.name.clone())))
            .collect();
        let input =
            |name: &str| word(name, |bit| free.iter().find(|(own, _)| own == bit).map(|(_, lit)| *lit));
        let (subtract, rounding) = (input("subtract_i")[0], input("rounding_i"));
        let [a, b] = case.operands(&mut aig, format, &input("a_i"), &input("b_i"));
        let expected = match case.distance() {
            None => aligned::special(&mut aig, format, &a, &b, subtract),
            Some(distance) => aligned::add(&mut aig, format, (&a, &b), distance, subtract, &rounding),
        };
        let given = |node: Node| {
            let Node::Input(position) = node else { return Lit::FALSE };
            let (name, own) = &free[position as usize];
            let of = |port: &str, word: &[Lit]| {
                let bit = name.strip_prefix(port)?.strip_prefix('[')?.strip_suffix(']')?;
                word.get(bit.parse::<usize>().ok()?).copied()
            };
            of("a_i", &a).or_else(|| of("b_i", &b)).unwrap_or(*own)
        };
        let map = copy(&self.hardware, &mut aig, given);
        let output = |bit: &str| {
            let output = self.hardware.outputs.iter().find(|output| output.name == bit)?;
            Some(map[output.lit.node()].complement_if(output.lit.is_complemented()))
        };
        let claims = [("result_o", expected), ("valid_o", input("valid_i")), ("tag_o", input("tag_i"))];
        let mut theorem = Theorem { aig, pairs: Vec::new(), names: Vec::new(), cases: Vec::new() };
        for (name, expected) in claims {
            let found = word(name, output);
            assert_eq!(found.len(), expected.len(), "the adder's {name} has the reference's width");
            theorem.names.extend((0..found.len()).map(|bit| format!("{name}[{bit}]")));
            theorem.pairs.extend(found.into_iter().zip(expected));
        }
        theorem
    }

    /// Proves all cases on all threads, or finds one that does not hold. Calls `case_done` after each.
    #[must_use]
    pub fn prove(&self, limits: Limits, case_done: impl Fn() + Sync) -> Proof {
        let proofs: Vec<Proof> = (self.cases.par_iter())
            .map(|&case| {
                let theorem = self.theorem(case);
                let proof = prove(&theorem.aig, &theorem.pairs, limits);
                case_done();
                proof
            })
            .collect();
        Proof::of_cases(&proofs)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    /// Every pair of exponent fields is in a case, whose distance is right.
    #[test]
    fn the_cases_hold_every_pair_of_exponents() {
        for format in [Format::BINARY32, Format::BINARY16, Format::E4M3] {
            let bits = format.exponent_bits();
            let field = |word: &[Lit]| {
                let bit = |(i, lit): (usize, &Lit)| {
                    assert!(*lit == Lit::TRUE || *lit == Lit::FALSE);
                    u32::from(*lit == Lit::TRUE) << i
                };
                let low = format.fraction_bits() as usize;
                word[low..low + bits as usize].iter().enumerate().map(bit).sum::<u32>()
            };
            let code = |exponent: u32| {
                words::constant(u128::from(exponent << format.fraction_bits()), format.width())
            };
            let mut pairs = BTreeSet::new();
            for case in SumCase::all(format) {
                for free in 0..1 << bits {
                    let word = code(free);
                    let [a, b] = case.operands(&mut Aig::default(), format, &word, &word);
                    let (a, b) = (field(&a), field(&b));
                    pairs.insert((a, b));
                    if let Some(distance) = case.distance() {
                        assert!(a.max(b) < (1 << bits) - 1);
                        assert_eq!(a.max(1) as i32 - b.max(1) as i32, distance, "{case:?} {a} {b}");
                    }
                }
            }
            assert_eq!(pairs.len(), 1 << (2 * bits), "{format}");
        }
    }
}
