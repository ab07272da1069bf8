//! The level-1 vectors of Berkeley TestFloat for binary32, where `DUALSPLIT_DATA` has them.
//!
//! A line reads `a b  a+b flags  a-b flags  a*b flags  a<b flags  a<=b flags  a==b flags` in hexadecimal.

use fp::{Arithmetic, Format, Rounding};
use pipelines::formats::binary32::{FpAdd, FpCmp, FpMul};
use std::io::{BufRead, BufReader};
use units::clocking::Clocked;

/// Operands and the six results of one line.
type Line = [u32; 8];

/// The vectors, or `None` with a note if there are none.
fn lines() -> Option<Vec<Line>> {
    let path = testing::data("testfloat/f32_level1.txt.gz")?;
    let file = std::fs::File::open(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let text = BufReader::new(flate2::read::GzDecoder::new(file));
    let parse = |line: std::io::Result<String>| {
        let line = line.unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let words: Vec<u32> = line
            .split_whitespace()
            .map(|word| u32::from_str_radix(word, 16).expect("a hexadecimal word"))
            .collect();
        [words[0], words[1], words[2], words[4], words[6], words[8], words[10], words[12]]
    };
    Some(text.lines().map(parse).collect())
}

#[test]
fn golden_equals_testfloat() {
    let Some(lines) = lines() else { return };
    assert_eq!(lines.len(), 46_464);
    let golden = Arithmetic::new(Format::BINARY32);
    for [a, b, sum, difference, product, lt, le, eq] in lines {
        let rounding = Rounding::NearestEven;
        assert_eq!(golden.fp_add(a, b, false, rounding), sum, "{a:08x} + {b:08x}");
        assert_eq!(golden.fp_add(a, b, true, rounding), difference, "{a:08x} - {b:08x}");
        assert_eq!(golden.fp_mul(a, b, rounding), product, "{a:08x} * {b:08x}");
        let comparison = golden.fp_cmp(a, b);
        let seen = [comparison.lt, comparison.le, comparison.eq].map(u32::from);
        assert_eq!(seen, [lt, le, eq], "{a:08x} ? {b:08x}");
    }
}

#[test]
fn units_equal_testfloat() {
    let Some(lines) = lines() else { return };
    let (mut add, mut subtract, mut mul, mut cmp) =
        (FpAdd::default(), FpAdd::default(), FpMul::default(), FpCmp::default());
    (add.clocking.en_i.next, subtract.clocking.en_i.next, mul.clocking.en_i.next, cmp.clocking.en_i.next) =
        (true, true, true, true);
    subtract.subtract_i.next = true;
    let mut previous = None;
    for line in lines {
        let [a, b, .., lt, le, eq] = line;
        let word = |bits: u32| u64::from(bits).into();
        (add.a_i.next, subtract.a_i.next, mul.a_i.next, cmp.a_i.next) = (word(a), word(a), word(a), word(a));
        (add.b_i.next, subtract.b_i.next, mul.b_i.next, cmp.b_i.next) = (word(b), word(b), word(b), word(b));
        add.tick();
        subtract.tick();
        mul.tick();
        cmp.tick();
        let seen = [cmp.lt_o.val(), cmp.le_o.val(), cmp.eq_o.val()].map(u32::from);
        assert_eq!(seen, [lt, le, eq], "{a:08x} ? {b:08x}");
        // The other units take one cycle more.
        if let Some([a, b, sum, difference, product, ..]) = previous.replace(line) {
            let seen = [&add.result_o, &subtract.result_o, &mul.result_o].map(|port| port.val().to_u32());
            assert_eq!(seen, [sum, difference, product], "{a:08x} {b:08x}");
        }
    }
}
