//! `FpMinMax`, `FpCmp` and `IntAdd` in rust-hdl's simulator against golden, the native type and SoftFloat.

use fp::operands::{Operands, patterns};
use fp::{Arithmetic, Format, NanMode};
use units::clocking::Clocked;
use units::{IntAdd, fp_cmp, fp_min_max};

/// Every pattern with every pattern, then `random` pairs.
fn pairs(format: Format, random: usize) -> Vec<(u32, u32)> {
    let all = patterns(format);
    let mut stream = Operands::new(format, 2);
    let crossed = all.iter().flat_map(|&a| all.iter().map(move |&b| (a, b)));
    crossed.chain(std::iter::repeat_with(|| stream.pair()).take(random)).collect()
}

fn check_min_max<const E: usize, const S: usize, const W: usize>(random: usize) {
    let mut unit = <fp_min_max!()>::default();
    let golden = Arithmetic::new(Format::new(E as u32, S as u32).unwrap());
    unit.clocking.en_i.next = true;
    for (a, b) in pairs(golden.format, random) {
        for (maximum, nan_mode) in
            [false, true].into_iter().flat_map(|m| [NanMode::Number, NanMode::Propagate].map(|n| (m, n)))
        {
            unit.a_i.next = u64::from(a).into();
            unit.b_i.next = u64::from(b).into();
            unit.maximum_i.next = maximum;
            unit.propagate_nan_i.next = nan_mode == NanMode::Propagate;
            unit.tick();
            let result = unit.result_o.val().to_u32();
            assert_eq!(
                result,
                golden.fp_min_max(a, b, maximum, nan_mode),
                "{a:x} {b:x} {maximum} {nan_mode:?}"
            );
        }
    }
}

fn check_cmp<const E: usize, const S: usize, const W: usize>(random: usize) {
    let mut unit = <fp_cmp!()>::default();
    let golden = Arithmetic::new(Format::new(E as u32, S as u32).unwrap());
    unit.clocking.en_i.next = true;
    for (a, b) in pairs(golden.format, random) {
        unit.a_i.next = u64::from(a).into();
        unit.b_i.next = u64::from(b).into();
        unit.tick();
        let expected = golden.fp_cmp(a, b);
        let result = (unit.lt_o.val(), unit.le_o.val(), unit.eq_o.val());
        assert_eq!(result, (expected.lt, expected.le, expected.eq), "{a:x} {b:x}");
        if W == 32 {
            let (x, y) = (f32::from_bits(a), f32::from_bits(b));
            assert_eq!(result, (x < y, x <= y, x == y));
            // SAFETY: SoftFloat's comparisons take plain words; their only state is the thread's exception flags.
            let soft = unsafe {
                use softfloat_sys::{f32_eq, f32_le, f32_lt, float32_t};
                let (x, y) = (float32_t { v: a }, float32_t { v: b });
                (f32_lt(x, y), f32_le(x, y), f32_eq(x, y))
            };
            assert_eq!(result, soft);
        }
    }
}

#[test]
fn min_max_equals_golden() {
    check_min_max::<8, 24, 32>(10_000);
    check_min_max::<5, 11, 16>(2_000);
    check_min_max::<8, 8, 16>(2_000);
    check_min_max::<4, 4, 8>(2_000);
}

#[test]
fn cmp_equals_golden_native_and_softfloat() {
    check_cmp::<8, 24, 32>(20_000);
    check_cmp::<5, 11, 16>(2_000);
    check_cmp::<5, 3, 8>(2_000);
}

#[test]
fn int_add_wraps() {
    let mut unit = IntAdd::<32, 1>::default();
    let mut stream = Operands::new(Format::BINARY32, 3);
    unit.clocking.en_i.next = true;
    for _ in 0..10_000 {
        let (a, b) = (stream.bits() as u32, stream.bits() as u32);
        unit.a_i.next = u64::from(a).into();
        unit.b_i.next = u64::from(b).into();
        unit.tick();
        assert_eq!(unit.sum_o.val().to_u32(), a.wrapping_add(b));
    }
}

#[test]
fn valid_and_tag_travel_and_a_stall_holds_them() {
    let mut unit = IntAdd::<8, 4>::default();
    let mut stream = Operands::new(Format::BINARY32, 4);
    let mut expected = (false, 0, 0);
    for _ in 0..5_000 {
        let bits = stream.bits();
        let (en, valid) = (bits & 1 == 1, bits & 2 == 2);
        let (tag, a, b) = (bits >> 8 & 15, bits >> 16 & 255, bits >> 24 & 255);
        unit.clocking.en_i.next = en;
        unit.valid_i.next = valid;
        unit.tag_i.next = tag.into();
        unit.a_i.next = a.into();
        unit.b_i.next = b.into();
        unit.tick();
        if en {
            expected = (valid, tag, (a + b) & 255);
        }
        assert_eq!((unit.valid_o.val(), unit.tag_o.val().to_u64(), unit.sum_o.val().to_u64()), expected);
    }
}
