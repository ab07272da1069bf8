//! SplitMix64: random bits that are the same on every machine.
//!
//! Steele, Lea, Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014.

/// The step of the generator's counter, the odd number nearest to 2^64 over the golden ratio.
pub const STEP: u64 = 0x9e37_79b9_7f4a_7c15;

/// The mixing function: a bijection of 64-bit integers that maps zero to zero.
#[must_use]
pub const fn mix(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// 64 random bits for `key`: the first output of the generator whose counter starts there.
#[must_use]
pub const fn hash(key: u64) -> u64 {
    mix(key.wrapping_add(STEP))
}

/// The generator's next output; `counter` is its state, any number at first.
pub fn next(counter: &mut u64) -> u64 {
    *counter = counter.wrapping_add(STEP);
    mix(*counter)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The outputs for seed 1234567 that the reference implementation in C gives.
    #[test]
    fn outputs_are_those_of_the_reference() {
        let mut counter = 1_234_567;
        let outputs = [(); 3].map(|()| next(&mut counter));
        assert_eq!(
            outputs,
            [6_457_827_717_110_365_317, 3_203_168_211_198_807_973, 9_817_491_932_198_370_423]
        );
        assert_eq!(outputs[0], hash(1_234_567));
    }
}
