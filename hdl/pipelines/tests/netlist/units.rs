//! The units and pipelines through every check.

use std::path::Path;

use crate::verilog::{lint_and_simulate, prove_equivalent, synthesise};
use netlist::module::MULTIPLIER_KINDS;
use netlist::verilog::Form;
use netlist::{flatten, guard, inventory};
use pipelines::catalogue::{StandardFormat, Top, sources};
use testing::long;
use testing::tools::{available, in_parallel, run};

/// What is proved equal to rust-hdl's export, the largest first: every unit and both pipelines.
const PROVED: [Top; 9] = [
    Top::RayBox,
    Top::RayBoxLean,
    Top::DualSplit,
    Top::DualSplitLean,
    Top::FpMul,
    Top::FpAdd,
    Top::FpMinMax,
    Top::FpCmp,
    Top::IntAdd,
];

#[test]
fn every_kernel_of_every_top_passes_the_guard() {
    for &top in Top::ALL {
        let report = guard(top.module(StandardFormat::Binary32).unwrap().as_ref());
        let report = report.unwrap_or_else(|error| panic!("{top}: {error}"));
        assert!(report.kernels > 0 && report.values_identical + report.values_simulated > 0);
        println!("{top}: {report:?}");
    }
}

#[test]
fn every_format_elaborates_and_passes_the_guard() {
    for &format in StandardFormat::ALL {
        for top in [Top::FpAdd, Top::FpMul, Top::FpMinMax, Top::FpCmp, Top::DualSplit, Top::RayBox] {
            let design = top.design(format).unwrap_or_else(|error| panic!("{top} {format}: {error}"));
            assert!(design.top().clock.is_some());
            guard(top.module(format).unwrap().as_ref())
                .unwrap_or_else(|error| panic!("{top} {format}: {error}"));
        }
    }
}

#[test]
fn latencies_and_unit_counts_are_the_published_ones() {
    // INTADD, FPADD, FPMUL, FPMIN/MAX, FPCMP: Lin et al., HPG 2020, section 5.
    let published = [(Top::DualSplit, [1, 2, 2, 3, 4]), (Top::RayBox, [0, 6, 6, 12, 2])];
    for (top, expected) in published {
        let found = inventory(&top.design(StandardFormat::Binary32).unwrap()).unwrap();
        let counts = ["int_add", "fp_add", "fp_mul", "fp_min_max", "fp_cmp"]
            .map(|kind| found.units.get(kind).copied().unwrap_or(0));
        println!("{top}: {} register bits, {} multiplexer bits", found.register_bits, found.multiplexer_bits);
        assert_eq!(counts, expected, "{top}");
        assert_eq!(found.latency_cycles, Some(8), "{top}: {:?}", found.output_latency_cycles);
    }
    let latencies = [(Top::IntAdd, 1), (Top::FpAdd, 2), (Top::FpMul, 2), (Top::FpMinMax, 1), (Top::FpCmp, 1)];
    for (top, cycles) in latencies {
        let found = inventory(&top.design(StandardFormat::Binary32).unwrap()).unwrap();
        assert_eq!(found.latency_cycles, Some(cycles), "{top}: {:?}", found.output_latency_cycles);
    }
}

#[test]
fn every_top_is_lint_clean_and_simulates() {
    for &top in Top::ALL {
        lint_and_simulate(&top.design(StandardFormat::Binary32).unwrap(), 200);
    }
}

/// The tops that are synthesised and proved in short: the units.
fn is_quick(top: Top, what: &str) -> bool {
    let is_unit = matches!(top, Top::IntAdd | Top::FpAdd | Top::FpMul | Top::FpMinMax | Top::FpCmp);
    is_unit || long(&format!("{what} of {top}"))
}

/// yosys maps every top to gates and flip-flops: no latch, and no more flip-flops than the netlist has bits of registers. It
/// may merge flip-flops of equal data. docs/hardware.md has the numbers of cells.
#[test]
fn every_top_synthesises() {
    in_parallel(Top::ALL.iter().rev().filter(|top| is_quick(**top, "synthesis")), |&top| {
        let design = top.design(StandardFormat::Binary32).unwrap();
        let Some(statistics) = synthesise(&design) else { return };
        let (_, sum) = statistics.rsplit_once("Number of cells:").expect("the sum comes last");
        let mut lines = sum.lines().map(|line| line.split_whitespace().collect::<Vec<_>>());
        println!("{top}: {} cells", lines.next().unwrap()[0]);
        let mut flip_flops = 0;
        for line in lines.filter(|line| line.len() == 2 && line[0].starts_with('$')) {
            assert!(line[0].starts_with("$_") && !line[0].contains("LATCH"), "{top}: {}", line[0]);
            if line[0].contains("DFF") {
                flip_flops += line[1].parse::<u32>().unwrap();
            }
        }
        let registers: u32 = flatten(&design).unwrap().registers.iter().map(|register| register.width).sum();
        assert!(
            0 < flip_flops && flip_flops <= registers,
            "{top}: {flip_flops} of {registers}\n{statistics}"
        );
        if matches!(top, Top::IntAdd | Top::FpMinMax | Top::FpCmp) {
            assert_eq!(flip_flops, registers, "{top}");
        }
    });
}

#[test]
fn units_and_pipelines_equal_rust_hdls_export() {
    in_parallel(PROVED.into_iter().filter(|top| is_quick(*top, "the proof")), |top| {
        let format = StandardFormat::Binary32;
        prove_equivalent(
            top.module(format).unwrap().as_ref(),
            &top.design(format).unwrap(),
            MULTIPLIER_KINDS,
        );
        println!("{top}: proved");
    });
}

/// The lean and parallel forms, of whose Verilog a digest is committed: their modules are those of the pipelines.
const DIGESTED: [Top; 5] = [Top::DualSplitLean, Top::RayBoxLean, Top::RayBoxX2, Top::RayBoxX4, Top::RayBoxX8];

/// The committed Verilog, and the digests beside it, are what the code generates.
#[test]
fn committed_verilog_is_current() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../verilog");
    let bless = std::env::var_os("DUALSPLIT_BLESS").is_some();
    let current = |name: &str, text: &str| {
        let path = folder.join(name);
        if bless {
            std::fs::write(&path, text).unwrap();
        }
        let committed = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(
            committed == text,
            "{name} differs from what the code generates; `DUALSPLIT_BLESS=1 cargo test -p dualsplit-pipelines --test netlist \
             committed_verilog` writes the Verilog and the digests anew"
        );
    };
    let scratch = tempfile::tempdir().unwrap();
    let mut digests = String::new();
    let sources = sources();
    let form = Form { reset: true, sources: &sources };
    for &top in Top::ALL {
        let text = form.text(&[&top.design(StandardFormat::Binary32).unwrap()], top.name());
        assert!(text.is_ascii() && !text.contains('\t'));
        let name = format!("{top}.v");
        if DIGESTED.contains(&top) {
            digests.push_str(&format!("{name} crc32 {:08x}\n", crc32fast::hash(text.as_bytes())));
        } else {
            current(&name, &text);
        }
        if available("iverilog") {
            std::fs::write(scratch.path().join(&name), &text).unwrap();
            run(scratch.path(), "iverilog", &["-g2005", "-Wall", "-t", "null", &name]).unwrap();
        }
    }
    current("digests.txt", &digests);
}
