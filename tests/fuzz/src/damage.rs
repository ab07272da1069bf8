//! Ways to damage a file.

use proptest::prelude::{Arbitrary, BoxedStrategy, Just, Strategy, any, prop_oneof};
use proptest::sample::Index;

/// Words that mean something to some reader: ends of ranges, numbers that are none, brackets, separators.
const WORDS: [&[u8]; 24] = [
    b"0",
    b"-1",
    b"4294967295",
    b"4294967296",
    b"18446744073709551616",
    b"1e38",
    b"-1e39",
    b"1e-320",
    b"nan",
    b"inf",
    b"1.#IND",
    b"\n",
    b"\r",
    b"\\\n",
    b"#",
    b"\"",
    b"[",
    b"{{{{{{{{",
    b"(",
    b"\xff\xfe",
    b"\x00\x00\x00\x00",
    b"\xff\xff\xff\xff",
    b"\xff\xff\xff\x7f",
    b"\x00\x00\xc0\x7f",
];

/// A damage.
#[derive(Clone, Debug)]
pub enum Damage {
    /// A bit is another one.
    Flip(Index, u8),
    /// A byte is another one.
    Byte(Index, u8),
    /// Bytes are missing.
    Cut(Index, Index),
    /// Bytes are there again, so many times.
    Repeat(Index, Index, u8),
    /// Nothing follows.
    End(Index),
    /// A word is put in.
    Insert(Index, Index),
    /// A word is in the place of as many bytes.
    Over(Index, Index),
    /// A word is in the place of the number that begins there or behind.
    Number(Index, Index),
    /// Part of another file is put in.
    Splice(Index, Index, Index),
}

impl Arbitrary for Damage {
    type Parameters = ();
    type Strategy = BoxedStrategy<Self>;

    fn arbitrary_with((): ()) -> Self::Strategy {
        let place = any::<Index>;
        prop_oneof![
            (place(), 0..8u8).prop_map(|(at, bit)| Self::Flip(at, bit)),
            (place(), any::<u8>()).prop_map(|(at, byte)| Self::Byte(at, byte)),
            (place(), place()).prop_map(|(from, to)| Self::Cut(from, to)),
            (place(), place(), prop_oneof![Just(1u8), 2..40u8])
                .prop_map(|(from, to, times)| Self::Repeat(from, to, times)),
            place().prop_map(Self::End),
            (place(), place()).prop_map(|(at, word)| Self::Insert(at, word)),
            (place(), place()).prop_map(|(at, word)| Self::Over(at, word)),
            (place(), place()).prop_map(|(at, word)| Self::Number(at, word)),
            (place(), place(), place()).prop_map(|(at, from, to)| Self::Splice(at, from, to)),
        ]
        .boxed()
    }
}

/// `seed` with `damages`, some of which take parts of `other`.
#[must_use]
pub fn damaged(seed: &[u8], other: &[u8], damages: &[Damage]) -> Vec<u8> {
    let mut bytes = seed.to_vec();
    for damage in damages {
        if bytes.is_empty() {
            bytes.push(0);
        }
        let place = |index: &Index| index.index(bytes.len());
        let range = |from: &Index, to: &Index, length: usize| {
            let (from, to) = (from.index(length), to.index(length));
            from.min(to)..from.max(to) + 1
        };
        match damage {
            Damage::Flip(at, bit) => {
                let at = place(at);
                bytes[at] ^= 1 << bit;
            }
            Damage::Byte(at, byte) => {
                let at = place(at);
                bytes[at] = *byte;
            }
            Damage::Cut(from, to) => _ = bytes.drain(range(from, to, bytes.len())),
            Damage::Repeat(from, to, times) => {
                let range = range(from, to, bytes.len());
                let part = bytes[range.clone()].repeat((*times).into());
                bytes.splice(range.end..range.end, part);
            }
            Damage::End(at) => bytes.truncate(place(at)),
            Damage::Insert(at, word) => {
                let at = place(at);
                bytes.splice(at..at, word.get(&WORDS).iter().copied());
            }
            Damage::Over(at, word) => {
                let (at, word) = (place(at), word.get(&WORDS));
                let end = bytes.len().min(at + word.len());
                bytes[at..end].copy_from_slice(&word[..end - at]);
            }
            Damage::Number(at, word) => {
                let from = place(at);
                let Some(start) = bytes[from..].iter().position(u8::is_ascii_digit).map(|digit| from + digit)
                else {
                    continue;
                };
                let length = bytes[start..].iter().take_while(|byte| byte.is_ascii_digit()).count();
                bytes.splice(start..start + length, word.get(&WORDS).iter().copied());
            }
            Damage::Splice(at, from, to) if !other.is_empty() => {
                let at = place(at);
                bytes.splice(at..at, other[range(from, to, other.len())].iter().copied());
            }
            Damage::Splice(..) => {}
        }
    }
    bytes
}
