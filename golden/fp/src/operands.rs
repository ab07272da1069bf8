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

    /// In this format the lists of exponents and of fractions are short enough to be written down.
    #[test]
    fn patterns_are_all_pairs_of_a_boundary_exponent_and_a_boundary_fraction() {
        let format = Format::new(5, 11).unwrap();
        let fractions = [0, 1, 2, 3, 0x20, 0x100, 0x1ff, 0x200, 0x201, 0x3fe, 0x3ff];
        let exponents = [0, 1, 2, 5, 7, 14, 15, 16, 22, 25, 29, 30, 31];
        let of_exponent = |exponent: u32| {
            let of_fraction = move |fraction: u32| [0, 1].map(|sign| sign << 15 | exponent << 10 | fraction);
            fractions.into_iter().flat_map(of_fraction)
        };
        let expected: Vec<u32> = exponents.into_iter().flat_map(of_exponent).collect();
        assert_eq!(patterns(format), expected);
    }

    #[test]
    fn a_third_of_the_operands_is_uniform_a_third_patterns_and_a_third_of_moderate_size() {
        const DRAWS: usize = 30_000;
        let patterns: std::collections::BTreeSet<u32> = patterns(Format::BINARY32).into_iter().collect();
        let mut stream = Operands::new(Format::BINARY32, 0);
        let (mut boundary, mut uniform) = (0, 0);
        // Draws by sign and exponent; bits that are ever set, and bits that are ever clear.
        let (mut moderate, mut set, mut clear) = ([[0; 16]; 2], 0, 0);
        for _ in 0..DRAWS {
            let x = stream.operand();
            match (x >> 23 & 0xff).checked_sub(127 - 8) {
                _ if patterns.contains(&x) => boundary += 1,
                Some(exponent @ 0..16) => {
                    moderate[(x >> 31) as usize][exponent as usize] += 1;
                    (set, clear) = (set | x, clear | !x);
                }
                _ => uniform += 1,
            }
        }
        let about = |count: usize, expected: usize| count.abs_diff(expected) < expected / 5;
        assert!(about(boundary, DRAWS / 3), "{boundary}");
        // A sixteenth of the uniform operands has an exponent of moderate size.
        assert!(about(uniform, DRAWS / 3 * 15 / 16), "{uniform}");
        let each = DRAWS / 3 * 17 / 16 / 32;
        assert!(
            moderate.iter().flatten().all(|count| about(*count, each)),
            "{moderate:?} is not {each} each"
        );
        assert_eq!((set & 0x807f_ffff, clear & 0x807f_ffff), (0x807f_ffff, 0x807f_ffff));
    }

    #[test]
    fn a_quarter_of_the_pairs_lies_within_four_places() {
        const DRAWS: usize = 40_000;
        let mut stream = Operands::new(Format::BINARY32, 0);
        let magnitude = |x: u32| i64::from(Format::BINARY32.magnitude(x));
        // Draws by the sign of the first operand, whether the second has the other one, and the distance of magnitudes.
        let mut close = [[[0; 9]; 2]; 2];
        for _ in 0..DRAWS {
            let (a, b) = stream.pair();
            if let Ok(distance @ 0..9) = usize::try_from(magnitude(b) - magnitude(a) + 4) {
                close[(a >> 31) as usize][((a ^ b) >> 31) as usize][distance] += 1;
            }
        }
        let each: usize = DRAWS / 4 / 36;
        let about = |count: usize| count.abs_diff(each) < each / 3;
        assert!(
            close.as_flattened().as_flattened().iter().all(|count| about(*count)),
            "{close:?} is not {each} each"
        );
    }

    /// Reports of mismatches name a seed, which has to give the same operands in every version.
    #[test]
    fn streams_do_not_change() {
        let digest = |format, seed| {
            let mut stream = Operands::new(format, seed);
            (0..4096).fold(0u64, |digest, _| {
                let (a, b) = stream.pair();
                (digest ^ u64::from(a) << 32 ^ u64::from(b)).wrapping_mul(0x0100_0000_01b3)
            })
        };
        assert_eq!(digest(Format::BINARY32, 1), 14_412_828_653_111_393_329);
        assert_eq!(digest(Format::E4M3, 2), 11_185_532_386_416_156_557);
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
