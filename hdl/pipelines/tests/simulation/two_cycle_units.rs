//! `FpAdd` and `FpMul` in rust-hdl's simulator, one operation per cycle, against every oracle that knows the format.

use crate::support::harness::latency_cycles;
use crate::support::oracles::{Kind, Operation, arithmetic, exhaustive, operations};
use fp::operands::Operands;
use fp::{Arithmetic, Format, Rounding};
use pipelines::catalogue::Top;
use std::collections::VecDeque;
use units::clocking::Clocked;
use units::{FpAdd, FpMul};
use units::{fp_add, fp_mul};

const TAG_BITS: usize = 4;

/// What the two units have in common; the tag has four bits.
trait Unit: Clocked {
    const TOP: Top;
    fn handshake(&mut self, enable: bool, valid: bool, tag: u64);
    fn output(&self) -> (bool, u64);
    fn build() -> Self;
    fn arithmetic() -> Arithmetic;
    fn drive(&mut self, operation: Operation);
    fn result(&self) -> u32;
}

macro_rules! unit {
    ($unit:ident, $width:ident, $drive_kind:expr) => {
        impl<
            const E: usize,
            const S: usize,
            const W: usize,
            const X: usize,
            const R: usize,
            const $width: usize,
        > Unit for $unit<E, S, W, X, R, $width, TAG_BITS>
        {
            const TOP: Top = Top::$unit;
            fn handshake(&mut self, enable: bool, valid: bool, tag: u64) {
                self.clocking.en_i.next = enable;
                self.valid_i.next = valid;
                self.tag_i.next = tag.into();
            }
            fn output(&self) -> (bool, u64) {
                (self.valid_o.val(), self.tag_o.val().to_u64())
            }
            fn build() -> Self {
                let mut unit = Self::default();
                unit.clocking.en_i.next = true;
                unit
            }
            fn arithmetic() -> Arithmetic {
                arithmetic::<E, S>()
            }
            fn drive(&mut self, operation: Operation) {
                self.a_i.next = u64::from(operation.a).into();
                self.b_i.next = u64::from(operation.b).into();
                self.rounding_i.next = (operation.rounding as u64).into();
                ($drive_kind)(self, operation.kind);
            }
            fn result(&self) -> u32 {
                self.result_o.val().to_u32()
            }
        }
    };
}

unit!(FpAdd, N, |unit: &mut Self, kind| unit.subtract_i.next = kind == Kind::Subtract);
unit!(FpMul, P, |_: &mut Self, kind| assert_eq!(kind, Kind::Multiply));

/// Streams `operations` through a unit without a gap and compares each result with the oracles.
fn check<U: Unit>(operations: impl IntoIterator<Item = Operation>) -> usize {
    let arithmetic = U::arithmetic();
    let mut unit = U::build();
    let latency = latency_cycles(U::TOP);
    let mut in_flight = VecDeque::new();
    let mut checked = 0;
    for operation in operations {
        unit.drive(operation);
        in_flight.push_back(operation);
        unit.tick();
        if in_flight.len() == latency {
            let operation: Operation = in_flight.pop_front().expect("an operation is in flight");
            let expected = operation.expected(&arithmetic);
            assert_eq!(unit.result(), expected, "{operation:x?}: {:x} {expected:x}", unit.result());
            checked += 1;
        }
    }
    checked
}

fn check_format<A: Unit, M: Unit>(stride: usize, random: usize) {
    let format = A::arithmetic().format;
    check::<A>(operations(&[Kind::Add, Kind::Subtract], format, stride, random, 5));
    check::<M>(operations(&[Kind::Multiply], format, stride, random, 6));
}

#[test]
fn binary32_equals_every_oracle() {
    check_format::<fp_add!(8, 24, TAG_BITS), fp_mul!(8, 24, TAG_BITS)>(7, 30_000);
}

#[test]
fn narrower_formats_equal_golden() {
    check_format::<fp_add!(8, 11, TAG_BITS), fp_mul!(8, 11, TAG_BITS)>(101, 3_000);
    check_format::<fp_add!(8, 8, TAG_BITS), fp_mul!(8, 8, TAG_BITS)>(101, 3_000);
    check_format::<fp_add!(5, 11, TAG_BITS), fp_mul!(5, 11, TAG_BITS)>(101, 3_000);
    check_format::<fp_add!(8, 17, TAG_BITS), fp_mul!(8, 17, TAG_BITS)>(101, 3_000);
    check_format::<fp_add!(3, 8, TAG_BITS), fp_mul!(3, 8, TAG_BITS)>(101, 3_000);
    check_format::<fp_add!(2, 2, TAG_BITS), fp_mul!(2, 2, TAG_BITS)>(7, 1_000);
    check_format::<fp_add!(2, 4, TAG_BITS), fp_mul!(2, 4, TAG_BITS)>(7, 1_000);
}

#[test]
fn e4m3_adder_equals_golden_on_all_pairs() {
    for rounding in [Rounding::NearestEven, Rounding::Down] {
        let all = exhaustive(Kind::Subtract, Format::E4M3, rounding);
        assert_eq!(check::<fp_add!(4, 4, TAG_BITS)>(all), (1 << 16) - 1);
    }
}

#[test]
fn e5m2_multiplier_equals_golden_on_all_pairs() {
    for rounding in [Rounding::NearestEven, Rounding::Up] {
        let all = exhaustive(Kind::Multiply, Format::E5M2, rounding);
        assert_eq!(check::<fp_mul!(5, 3, TAG_BITS)>(all), (1 << 16) - 1);
    }
}

/// Bubbles and stalls in a quarter of all cycles each.
fn check_handshake<U: Unit>(kind: Kind) {
    let arithmetic = U::arithmetic();
    let mut stream = Operands::new(arithmetic.format, 8);
    let mut unit = U::build();
    let mut in_flight = VecDeque::from(vec![None; latency_cycles(U::TOP)]);
    for _ in 0..5_000 {
        let bits = stream.bits();
        let (enable, valid, tag) = (bits & 3 != 0, bits & 12 != 0, bits >> 8 & 15);
        let (a, b) = stream.pair();
        let operation = Operation { kind, a, b, rounding: Rounding::ALL[(bits >> 16) as usize % 5] };
        unit.handshake(enable, valid, tag);
        unit.drive(operation);
        unit.tick();
        if enable {
            in_flight.pop_front();
            in_flight.push_back(valid.then_some((tag, operation)));
        }
        let (valid, tag) = unit.output();
        let seen = valid.then(|| (tag, unit.result()));
        let expected = in_flight[0].map(|(tag, operation)| (tag, operation.expected(&arithmetic)));
        assert_eq!(seen, expected, "{:x?}", in_flight[0]);
    }
}

#[test]
fn valid_and_tag_travel_and_a_stall_holds_them() {
    check_handshake::<fp_add!(8, 24, TAG_BITS)>(Kind::Subtract);
    check_handshake::<fp_mul!(8, 24, TAG_BITS)>(Kind::Multiply);
}

#[test]
fn reserved_rounding_codes_round_toward_zero() {
    let mut unit = <fp_mul!(8, 24, TAG_BITS)>::build();
    for code in 5..8u64 {
        let operation = Operation {
            kind: Kind::Multiply,
            a: 0x3f80_0001,
            b: 0xbf80_0001,
            rounding: Rounding::TowardZero,
        };
        unit.drive(operation);
        unit.rounding_i.next = code.into();
        (0..latency_cycles(Top::FpMul)).for_each(|_| unit.tick());
        assert_eq!(unit.result(), operation.expected(&Arithmetic::new(Format::BINARY32)));
    }
}
