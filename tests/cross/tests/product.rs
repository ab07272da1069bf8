//! The multiplier arrays multiply: a proof for all operands, by the algebra of their word graphs.
//!
//! A solver does not finish arrays of 24 bits, but an array is a sum of partial products. The proof follows every
//! word in it as a polynomial in the operands' bits with integer coefficients. As long as no sum exceeds its width
//! and no slice cuts through a carry, which the proof checks, the polynomial has the value of the word. The polynomials of the
//! two arrays, the upper one by `2^H` with `H` half of the bits, must add up to the sum of `2^(i+j) a_i b_j`.

use netlist::{BinaryOp, Change, Design, Graph, Module, Mutation, Op, mask, mutate};
use pipelines::catalogue::{StandardFormat, Top};
use std::collections::BTreeMap;

/// The bits, by operand and position, that are multiplied.
type Monomial = Vec<(u32, u32)>;
/// Coefficients by monomial; none is zero.
type Polynomial = BTreeMap<Monomial, u128>;

/// The value with all bits of the operands set: no coefficient is negative.
fn largest(p: &Polynomial) -> u128 {
    p.values().sum()
}

fn scaled(p: &Polynomial, bits: u32) -> Polynomial {
    p.iter().map(|(bit, coefficient)| (bit.clone(), coefficient << bits)).collect()
}

fn sum(a: &Polynomial, b: &Polynomial) -> Polynomial {
    let mut sum = a.clone();
    for (bits, coefficient) in b {
        *sum.entry(bits.clone()).or_default() += coefficient;
    }
    sum
}

fn product(a: &Polynomial, b: &Polynomial) -> Polynomial {
    let mut product = Polynomial::new();
    for (x, p) in a {
        for (y, q) in b {
            *product.entry([&x[..], y].concat()).or_default() += p * q;
        }
    }
    product
}

/// Bits `low..low + width` of a word: all of it, or bits that no carry reaches, as each is a monomial of its own.
fn slice(p: &Polynomial, low: u32, width: u32) -> Result<Polynomial, String> {
    if low == 0 && largest(p) <= mask(width) {
        return Ok(p.clone());
    }
    let mut powers: Vec<u128> = p.values().copied().collect();
    powers.sort_unstable();
    if powers.iter().any(|x| !x.is_power_of_two()) || powers.windows(2).any(|pair| pair[0] == pair[1]) {
        return Err(format!("bits {low}.. of a sum are taken, which carries may reach"));
    }
    let taken = p.iter().filter(|(_, x)| (low..low + width).contains(&x.trailing_zeros()));
    Ok(taken.map(|(bits, x)| (bits.clone(), x >> low)).collect())
}

/// The polynomials of all nodes.
fn polynomials(graph: &Graph) -> Result<Vec<Polynomial>, String> {
    let mut found: Vec<Polynomial> = Vec::new();
    for node in graph.nodes() {
        let of = |id: netlist::NodeId| &found[id.index()];
        let polynomial = match node.op {
            Op::Input(i) => (0..node.width).map(|bit| (vec![(i, bit)], 1 << bit)).collect(),
            Op::Constant(0) => Polynomial::new(),
            Op::Constant(value) => Polynomial::from([(Vec::new(), value)]),
            Op::Extend { of: a, signed: false } => of(a).clone(),
            Op::Slice { of: a, low } => slice(of(a), low, node.width)?,
            Op::Concat { high, low } => sum(&scaled(of(high), graph.width(low)), of(low)),
            Op::Binary(BinaryOp::Add, a, b) => sum(of(a), of(b)),
            Op::Binary(BinaryOp::Mul, a, b) => product(of(a), of(b)),
            other => return Err(format!("{other:?} is no part of a sum of products")),
        };
        if largest(&polynomial) > mask(node.width) {
            return Err(format!("{:?} exceeds {} bits", node.op, node.width));
        }
        found.push(polynomial);
    }
    Ok(found)
}

/// Whether the outputs of the design's two arrays are the product of their two inputs.
fn multiply(design: &Design) -> Result<(), String> {
    let arrays: Vec<&Module> =
        design.modules.iter().filter(|module| module.kind == "significand_product").collect();
    let [lower, upper] = arrays[..] else { return Err(format!("{} arrays", arrays.len())) };
    let [a, b] = [0, 1].map(|input| lower.inputs[input].width);
    let mut whole = Polynomial::new();
    for (array, scale) in [(lower, 0), (upper, b.div_ceil(2))] {
        assert_eq!((array.inputs.len(), array.outputs.len()), (2, 1));
        assert!(array.registers.is_empty() && array.instances.is_empty());
        let product = &polynomials(&array.graph)?[array.outputs[0].1.index()];
        whole = sum(&whole, &scaled(product, scale));
    }
    let bits = (0..a).flat_map(|i| (0..b).map(move |j| (vec![(0, i), (1, j)], 1 << (i + j))));
    let expected: Polynomial = bits.collect();
    if whole == expected { Ok(()) } else { Err("another polynomial".to_owned()) }
}

#[test]
fn the_arrays_multiply_in_every_format() {
    for &format in StandardFormat::ALL {
        let design = Top::FpMul.design(format).unwrap();
        multiply(&design).unwrap_or_else(|error| panic!("{format}: {error}"));
    }
}

#[test]
fn the_proof_finds_faults() {
    let design = Top::FpMul.design(StandardFormat::Binary32).unwrap();
    let faults = [
        ("product_o", Change::Increment),
        ("product_o", Change::StuckBit { bit: 30, value: false }),
        ("a_i", Change::StuckBit { bit: 7, value: false }),
        ("b_i", Change::StuckBit { bit: 11, value: false }),
        ("b_i", Change::StuckBit { bit: 12, value: true }),
    ];
    for (value, change) in faults {
        let mutation = Mutation { module: "significand_product".into(), value: value.into(), change };
        let mutant = mutate(&design, &mutation).unwrap();
        assert!(multiply(&mutant).is_err(), "{mutation}");
    }
}
