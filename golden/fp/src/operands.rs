//! Operands that find faults in floating-point units: boundary patterns and seeded random streams.

use super::format::Format;
use base::split_mix;

/// All values whose exponent lies at or beside a boundary and whose fraction is a boundary pattern, of either sign:
/// zeros, subnormals, powers of two and their neighbours, runs of ones, infinities, quiet and signalling NaNs.
#[must_use]
pub fn patterns(format: Format) -> Vec<u32> {
    let fraction_bits = format.fraction_bits();
    let ones = (1u32 << fraction_bits) - 1;
    let high = 1u32 << (fraction_bits - 1);
    let mut fractions = vec![
        0,
        1,
        2,
        3,
        ones >> 1,
        ones & !1,
        ones,
        high,
        high | 1,
        high >> 1,
        1 << (fraction_bits / 2),
        !high,
    ];
    let (bias, top) = (format.bias() as u32, format.infinity() >> fraction_bits);
    let mut exponents = vec![
        0,
        1,
        2,
        bias / 2,
        bias.saturating_sub(fraction_bits),
        bias - 1,
        bias,
        bias + 1,
        bias + fraction_bits,
        bias + bias / 2,
        top - 2,
        top - 1,
        top,
    ];
    fractions.iter_mut().for_each(|f| *f &= ones);
    exponents.iter_mut().for_each(|e| *e = (*e).min(top));
    [&mut fractions, &mut exponents].into_iter().for_each(|list| {
        list.sort_unstable();
        list.dedup();
    });
    let magnitudes = exponents.iter().flat_map(|e| fractions.iter().map(move |f| e << fraction_bits | f));
    magnitudes.flat_map(|m| [m, m | format.sign_bit()]).collect()
}

/// An endless stream of random operands, equal for equal seeds.
#[derive(Clone, Debug)]
pub struct Operands {
    format: Format,
    patterns: Vec<u32>,
    state: u64,
}

impl Operands {
    /// The stream of `seed`.
    #[must_use]
    pub fn new(format: Format, seed: u64) -> Self {
        Self { format, patterns: patterns(format), state: seed }
    }

    /// 64 uniform bits.
    pub fn bits(&mut self) -> u64 {
        split_mix::next(&mut self.state)
    }

    /// One operand: a uniform bit pattern, a boundary pattern, or a number of moderate size, each in a third of all draws.
    pub fn operand(&mut self) -> u32 {
        let bits = self.bits();
        let (choice, bits) = (bits >> 32, bits as u32);
        match choice % 3 {
            0 => bits & self.format.mask(),
            1 => self.patterns[bits as usize % self.patterns.len()],
            _ => {
                let fraction = bits & (self.format.min_normal() - 1);
                let span = (self.format.bias() as u32).min(16);
                let exponent = self.format.bias() as u32 - span / 2 + (choice >> 2) as u32 % span;
                (exponent << self.format.fraction_bits()) | fraction | bits & self.format.sign_bit()
            }
        }
    }

    /// Two operands; every fourth pair lies close together, so that differences cancel and comparisons are near ties.
    pub fn pair(&mut self) -> (u32, u32) {
        let (a, choice) = (self.operand(), self.bits());
        let b = match choice % 4 {
            0 => {
                let near = a.wrapping_add((choice >> 8) as u32 % 9).wrapping_sub(4) & self.format.mask();
                if choice & 4 == 0 { near } else { near ^ self.format.sign_bit() }
            }
            _ => self.operand(),
        };
        (a, b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns_cover_every_class_of_every_format() {
        for name in ["binary32", "bfloat16", "binary16", "e5m2", "e4m3", "e2m1"] {
            let format: Format = name.parse().unwrap();
            let all = patterns(format);
            let infinity = format.infinity();
            for class in [0, 1, format.min_normal(), format.max_finite(), infinity, format.canonical_nan()] {
                assert!(
                    all.contains(&class) && all.contains(&(class | format.sign_bit())),
                    "{name} {class:x}"
                );
            }
            assert!(all.iter().all(|&x| x <= format.mask()));
        }
    }

    #[test]
    fn a_seed_names_its_stream() {
        let draw = |seed| {
            let mut stream = Operands::new(Format::BINARY32, seed);
            std::array::from_fn::<_, 64, _>(|_| stream.pair())
        };
        assert_eq!(draw(1), draw(1));
        assert_ne!(draw(1), draw(2));
    }
}
