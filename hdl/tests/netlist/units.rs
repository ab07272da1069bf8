//! The units and pipelines through every check.

use std::path::Path;

use crate::tools::{available, run};
use crate::verilog::{lint_and_simulate, prove_equivalent, synthesise};
use hdl::catalogue::{MULTIPLIER_KINDS, StandardFormat, Top};
use hdl::netlist::{guard, inventory};

/// Tops that yosys synthesises in seconds.
const SMALL: [Top; 5] = [Top::IntAdd, Top::FpAdd, Top::FpMul, Top::FpMinMax, Top::FpCmp];

#[test]
fn every_kernel_of_every_top_passes_the_guard() {
    for &top in Top::ALL {
        let report = guard(top.module(StandardFormat::Binary32).as_ref());
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
            guard(top.module(format).as_ref()).unwrap_or_else(|error| panic!("{top} {format}: {error}"));
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

#[test]
fn the_units_synthesise() {
    for top in SMALL {
        synthesise(&top.design(StandardFormat::Binary32).unwrap());
    }
}

fn prove(top: Top, format: StandardFormat) {
    let design = top.design(format).unwrap();
    let module = top.module(format);
    prove_equivalent(module.as_ref(), &design, MULTIPLIER_KINDS);
}

#[test]
fn the_units_equal_rust_hdls_export() {
    for top in SMALL {
        prove(top, StandardFormat::Binary32);
    }
}

#[test]
#[ignore = "minutes of yosys; run by name"]
fn the_pipelines_equal_rust_hdls_export() {
    for top in [Top::DualSplit, Top::DualSplitLean, Top::RayBox, Top::RayBoxLean] {
        prove(top, StandardFormat::Binary32);
        println!("{top}: proved");
    }
}

#[test]
#[ignore = "minutes of yosys; run by name"]
fn the_pipelines_synthesise() {
    for top in [Top::DualSplit, Top::RayBox] {
        synthesise(&top.design(StandardFormat::Binary32).unwrap());
    }
}

/// The committed Verilog is what the code generates; `DUALSPLIT_BLESS=1` writes it anew.
#[test]
fn committed_verilog_is_current() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("verilog");
    let bless = std::env::var_os("DUALSPLIT_BLESS").is_some();
    for &top in Top::ALL {
        let design = top.design(StandardFormat::Binary32).unwrap();
        let path = folder.join(format!("{top}.v"));
        let text = hdl::verilog::text(&design);
        assert!(text.is_ascii() && !text.contains('\t'));
        if bless {
            std::fs::create_dir_all(&folder).unwrap();
            std::fs::write(&path, &text).unwrap();
        }
        let committed = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(committed == text, "{} differs; DUALSPLIT_BLESS=1 writes it anew", path.display());
    }
    if available("iverilog") {
        for &top in Top::ALL {
            run(&folder, "iverilog", &["-g2005", "-Wall", "-t", "null", &format!("{top}.v")]).unwrap();
        }
    }
}
