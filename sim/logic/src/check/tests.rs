use super::exhaustive::{Exhaustive, Operation};
use super::volume::{volume, with_engine};
use crate::interpreter::Interpreter;
use netlist::{BinaryOp, Change, Flat, Mutation, flatten, mutate};
use pipelines::catalogue::{StandardFormat, Top};
use testing::cases;

fn netlist(top: Top, format: StandardFormat) -> Flat {
    flatten(&top.design(format).unwrap()).unwrap()
}

fn mutant(top: Top, format: StandardFormat, module: &str, value: &str, change: Change) -> Flat {
    let mutation = Mutation { module: module.into(), value: value.into(), change };
    flatten(&mutate(&top.design(format).unwrap(), &mutation).unwrap()).unwrap()
}

/// Ten million operations of each unit and of either pipeline, a million or fewer of the other tops; a hundredth of that in
/// short.
#[test]
fn every_top_in_volume() {
    for &top in Top::ALL {
        let vectors = match top {
            Top::DualSplitLean | Top::RayBoxLean => cases(1_000_000, 10_000),
            Top::RayBoxX2 | Top::RayBoxX4 | Top::RayBoxX8 => cases(100_000, 1_000),
            Top::SharedUnits => cases(10_000, 1_000),
            _ => cases(10_000_000, 100_000),
        };
        let netlist = netlist(top, StandardFormat::Binary32);
        let totals = volume(top, StandardFormat::Binary32, &netlist, vectors, 11, |_| ()).unwrap();
        assert_eq!(totals.first, None, "{top}");
        assert_eq!(totals.mismatches, 0, "{top}");
        assert!(totals.vectors >= vectors, "{top}");
    }
}

#[test]
fn units_in_binary16_in_volume() {
    for top in [Top::FpAdd, Top::FpMul, Top::FpMinMax, Top::FpCmp] {
        let netlist = netlist(top, StandardFormat::Binary16);
        let totals = volume(top, StandardFormat::Binary16, &netlist, 500_000, 12, |_| ()).unwrap();
        assert_eq!(totals.first, None, "{top}");
    }
}

#[test]
fn totals_do_not_depend_on_threads() {
    let netlist = netlist(Top::DualSplit, StandardFormat::Binary32);
    let run = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| volume(Top::DualSplit, StandardFormat::Binary32, &netlist, 300_000, 4, |_| ()))
    };
    assert_eq!(run(1), run(3));
}

/// The check in volume finds faults that random operands seldom meet.
#[test]
fn faults_are_seen_in_volume() {
    use Change::{Constant, Invert, Replace};
    let format = StandardFormat::Binary32;
    let with = |other: &str| Replace(other.into());
    let faults = [
        (Top::FpAdd, "sticky_shift", "sticky", Constant(0)),
        (Top::FpMul, "fp_mul", "left_amount", with("zeros")),
        (Top::FpMinMax, "fp_min_max", "propagate_nan_i", Invert),
        (Top::FpCmp, "fp_cmp", "any_magnitude", Constant(1)),
        (Top::IntAdd, "int_add", "sum", Change::Delay),
        (Top::DualSplit, "dual_split_fold", "latest_entry", with("entry_t")),
        (Top::DualSplit, "delay", "stage$0", Change::IgnoreEnable),
        (Top::RayBox, "fp_cmp", "ordered", Constant(1)),
        (Top::RayBoxX2, "ray_box_select", "inv_low$0", Change::SwapOperands),
        (Top::SharedUnits, "shared_units", "ray_box", Change::Exchange("dual_split".into())),
    ];
    for (top, module, value, change) in faults {
        let broken = mutant(top, format, module, value, change);
        let engine = || Interpreter::new(&broken);
        let totals = with_engine(top, format, &broken, engine, 20_000, 1, |_| ()).unwrap();
        assert!(totals.mismatches > 0 && totals.first.is_some(), "{top}: {module}.{value}");
    }
}

#[test]
fn all_pairs_of_8_bits() {
    for format in [StandardFormat::E5m2, StandardFormat::E4m3] {
        for operation in Operation::ALL {
            let check = Exhaustive::new(format, operation).unwrap();
            let mut progress = check.start();
            check.advance(&mut progress, check.blocks());
            assert_eq!(progress.first, None);
            assert_eq!(progress.mismatches, 0, "{format} {operation}");
            assert_eq!(progress.vectors, u64::from(operation.modes()) << 16, "{format} {operation}");
        }
    }
}

#[test]
fn some_blocks_of_binary16() {
    for operation in Operation::ALL {
        let check = Exhaustive::new(StandardFormat::Binary16, operation).unwrap();
        // One, the largest subnormal, infinity and a NaN, in the last mode.
        for a in [0x3c00, 0x03ff, 0x7c00, 0x7e01] {
            let mut progress = check.start();
            progress.blocks = u64::from(operation.modes() - 1) << 16 | a;
            check.advance(&mut progress, 1);
            assert_eq!((progress.first, progress.mismatches), (None, 0), "{operation} {a:x}");
            assert_eq!(progress.vectors, 1 << 16);
        }
    }
}

/// Work in parts gives the same as work at once.
#[test]
fn all_pairs_in_parts() {
    let check = Exhaustive::new(StandardFormat::E4m3, Operation::Mul).unwrap();
    let (mut whole, mut parts) = (check.start(), check.start());
    check.advance(&mut whole, check.blocks());
    while parts.blocks < check.blocks() {
        check.advance(&mut parts, 100);
    }
    assert_eq!(whole, parts);
}

#[test]
fn a_fault_is_found_among_all_pairs() {
    let format = StandardFormat::E4m3;
    let broken = mutant(Top::FpAdd, format, "fp_add", "swap", Change::Operator(BinaryOp::Ne));
    let check = Exhaustive::new(format, Operation::Add).unwrap().with_netlist(broken.clone());
    let mut progress = check.start();
    check.advance_with(&mut progress, check.blocks(), || Interpreter::new(&broken));
    assert!(progress.mismatches > 0 && progress.first.is_some());
}

#[test]
fn formats_with_too_many_pairs_are_refused() {
    let error = Exhaustive::new(StandardFormat::Tf32, Operation::Add).unwrap_err().to_string();
    assert!(error.starts_with("tf32 has 2^38 pairs") && error.contains("--vectors"), "{error}");
}
