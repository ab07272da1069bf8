//! Products: partial products in columns of equal weight, reduced by full adders, then one addition.

use super::aig::{Aig, Lit};
use super::words::{Multiplier, Structures, add};

/// Bits of equal weight, each with its depth.
type Column = Vec<(u32, Lit)>;

/// `a * b` modulo 2^width.
pub fn product(aig: &mut Aig, structures: Structures, a: &[Lit], b: &[Lit], width: usize) -> Vec<Lit> {
    let significant = |word: &[Lit]| word.iter().rposition(|&bit| bit != Lit::FALSE).map_or(0, |top| top + 1);
    let (a, b) = (&a[..significant(a)], &b[..significant(b)]);
    let (a, b) = if a.len() < b.len() { (b, a) } else { (a, b) };
    let mut columns: Vec<Column> = vec![Vec::new(); width];
    match structures.multiplier {
        Multiplier::Tree => tree(aig, a, b, &mut columns),
        Multiplier::Booth => booth(aig, a, b, &mut columns),
    }
    let [x, y] = compress(aig, columns);
    add(aig, structures.adder, &x, &y, Lit::FALSE).0
}

fn put(columns: &mut [Column], weight: usize, bit: Lit) {
    if bit != Lit::FALSE
        && let Some(column) = columns.get_mut(weight)
    {
        column.push((0, bit));
    }
}

fn tree(aig: &mut Aig, a: &[Lit], b: &[Lit], columns: &mut [Column]) {
    for (i, &a) in a.iter().enumerate() {
        for (j, &b) in b.iter().enumerate() {
            let bit = aig.and(a, b);
            put(columns, i + j, bit);
        }
    }
}

/// Digits -2..=2 of `b`, each from three of its bits. A negative multiple is the complement plus one; the sign is
/// extended by the usual constant: with `e` the inverted sign at weight `w`, `-s 2^w = (e - 1) 2^w`, and the constants of
/// all rows are summed beforehand.
fn booth(aig: &mut Aig, a: &[Lit], b: &[Lit], columns: &mut [Column]) {
    let width = columns.len();
    let bit = |word: &[Lit], i: usize| word.get(i).copied().unwrap_or(Lit::FALSE);
    let mut correction = 0u128;
    for row in 0..=b.len() / 2 {
        let low = if row == 0 { Lit::FALSE } else { bit(b, 2 * row - 1) };
        let (middle, high) = (bit(b, 2 * row), bit(b, 2 * row + 1));
        let one = aig.xor(middle, low);
        let differs = aig.xor(high, middle);
        let two = aig.and(differs, !one);
        // The digit is negative if `high`, except for -0, whose complement plus one is zero again.
        for i in 0..=a.len() {
            let single = aig.and(one, bit(a, i));
            let double = if i == 0 { Lit::FALSE } else { aig.and(two, a[i - 1]) };
            let multiple = aig.or(single, double);
            let signed = aig.xor(multiple, high);
            put(columns, 2 * row + i, signed);
        }
        put(columns, 2 * row, high);
        let sign_weight = 2 * row + a.len() + 1;
        if high != Lit::FALSE && sign_weight < width {
            put(columns, sign_weight, !high);
            correction = correction.wrapping_sub(1 << sign_weight);
        }
    }
    for (weight, column) in columns.iter_mut().enumerate() {
        if correction >> weight & 1 == 1 {
            column.push((0, Lit::TRUE));
        }
    }
}

/// Adds columns up until each has at most two bits, the earliest bits first.
fn compress(aig: &mut Aig, mut columns: Vec<Column>) -> [Vec<Lit>; 2] {
    let width = columns.len();
    for weight in 0..width {
        loop {
            let column = &mut columns[weight];
            // Stable order: by depth, then as they came.
            column.sort_by_key(|&(depth, _)| depth);
            if column.len() <= 2 {
                break;
            }
            let bits: Vec<(u32, Lit)> = column.drain(..3).collect();
            let depth = bits.iter().map(|&(depth, _)| depth).max().unwrap_or(0);
            let (sum, carry) = full_adder(aig, [bits[0].1, bits[1].1, bits[2].1]);
            if sum != Lit::FALSE {
                columns[weight].push((depth + 4, sum));
            }
            if weight + 1 < width && carry != Lit::FALSE {
                columns[weight + 1].push((depth + 3, carry));
            }
        }
    }
    [0, 1].map(|row| columns.iter().map(|c| c.get(row).map_or(Lit::FALSE, |&(_, bit)| bit)).collect())
}

/// Sum and carry of three bits, the latest one last.
fn full_adder(aig: &mut Aig, [a, b, c]: [Lit; 3]) -> (Lit, Lit) {
    let either = aig.xor(a, b);
    let sum = aig.xor(either, c);
    let both = aig.and(a, b);
    let passed = aig.and(either, c);
    (sum, aig.or(both, passed))
}
