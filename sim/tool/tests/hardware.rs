//! The commands about the hardware as a user runs them: estimate, check, export and wave.

mod support;

use pipelines::catalogue::Top;
use std::path::Path;
use std::process::{Command, Output};
use studies::drive::DRAIN_CYCLES;
use support::{Workplace, has_keys};

fn estimate(arguments: &[&str], folder: &Path) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_dualsplit"));
    command.arg("estimate").args(arguments).current_dir(folder).output().unwrap()
}

#[test]
fn the_report_has_all_forms_and_their_numbers_agree() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["--detail", "0.002", "--quality", "fast", "--out", "report", "--json"];
    let output = estimate(&arguments, folder.path());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let written = std::fs::read(folder.path().join("report/estimate.json")).unwrap();
    // What was printed begins with what all documents have in common.
    let mut document = json.clone();
    let common = ["version", "command", "artifacts"];
    assert!(common.iter().all(|key| document.as_object_mut().unwrap().remove(*key).is_some()));
    assert_eq!(document, serde_json::from_slice::<serde_json::Value>(&written).unwrap());
    for name in ["estimate.txt", "estimate.csv", "estimate.html"] {
        assert!(folder.path().join("report").join(name).is_file(), "{name}");
    }
    let number = |value: &serde_json::Value| value.as_f64().unwrap();
    for (name, units) in [("dual_split", [1, 2, 2, 3, 4]), ("ray_box", [0, 6, 6, 12, 2])] {
        let pipelines = json["pipelines"].as_array().unwrap();
        let pipeline = pipelines.iter().find(|pipeline| pipeline["name"] == name).unwrap();
        for (unit, count) in ["int_add", "fp_add", "fp_mul", "fp_min_max", "fp_cmp"].into_iter().zip(units) {
            assert_eq!(pipeline["units"][unit], count, "{name} {unit}");
        }
        assert_eq!(pipeline["latency_cycles"], 8);
        // Without a clock, the numbers hold for the critical path, which is that of one of the stages.
        let clock = &pipeline["clock"];
        assert_eq!(clock["period_ns"], pipeline["critical_path_ns"]);
        let paths = clock["stages"].as_array().unwrap().iter().map(|stage| number(&stage["path_ns"]));
        assert_eq!(paths.fold(0.0, f64::max), number(&clock["period_ns"]));
        assert!(
            (number(&clock["period_fo4"]) * number(&json["library"]["fo4_ps"]) / 1e3
                - number(&clock["period_ns"]))
            .abs()
                < 1e-9
        );
        let estimates = pipeline["estimates"].as_array().unwrap();
        let methods: Vec<&str> = estimates.iter().map(|row| row["method"].as_str().unwrap()).collect();
        assert_eq!(methods, ["published", "netlist", "scaled"]);
        for row in estimates {
            assert!(
                number(&row["glue_area_um2"]) > 0.0
                    && number(&row["area_um2"]) > number(&row["glue_area_um2"])
            );
            assert!(
                number(&row["glue_energy_pj"]) > 0.0
                    && number(&row["energy_pj"]) > number(&row["glue_energy_pj"])
            );
            assert!(!row["source"].as_str().unwrap().is_empty());
        }
        // The parts are those of the netlist's row.
        let area = &pipeline["area"];
        let units: f64 = area["units"].as_object().unwrap().values().map(number).sum();
        assert!((units + number(&area["glue"]) - number(&estimates[1]["area_um2"])).abs() < 1e-6 * units);
    }
}

#[test]
fn bad_libraries_end_in_an_error_that_names_them() {
    let folder = tempfile::tempdir().unwrap();
    let cases = [
        ("none.lib", None, "none.lib"),
        ("text.lib", Some("hello"), "line 1: neither `:` nor `(` follows a name"),
        ("open.lib", Some("library (x) {\n cell (y) {\n"), "closing brace"),
        ("unit.lib", Some("library (x) { nom_voltage : 1.0; }"), "time_unit is missing"),
        (
            "empty.lib",
            Some("library (x) { nom_voltage : 1.0; time_unit : \"1ns\"; capacitive_load_unit (1, pf); }"),
            "empty.lib: the library has no rising-edge D flip-flop",
        ),
    ];
    for (name, text, message) in cases {
        if let Some(text) = text {
            std::fs::write(folder.path().join(name), text).unwrap();
        }
        let output = estimate(&["--liberty", name, "--detail", "0.002"], folder.path());
        let error = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{name}: {error}");
        assert!(error.contains(message), "{name}: {error}");
    }
    for (line, message) in [
        ("--synth", "--liberty FILE"),
        ("--clock soon", "1GHz"),
        ("--clock 0GHz", "from 1ps to 1ms"),
        ("--curve", "--out"),
        ("--mapper yosys", "own or abc"),
        ("--mapper abc --liberty empty.lib", "--clock"),
        ("--mapper abc --clock 40fo4", "--liberty FILE"),
        // No program is found.
        ("--mapper abc --clock 40fo4 --liberty empty.lib", "install"),
    ] {
        let mut command = Command::new(env!("CARGO_BIN_EXE_dualsplit"));
        let command = command.arg("estimate").args(line.split(' ')).current_dir(folder.path());
        let output = command.env("PATH", "").output().unwrap();
        let error = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{line}: {error}");
        assert!(error.contains(message), "{line}: {error}");
    }
}

#[test]
fn a_missed_clock_is_exit_code_1() {
    if !testing::long("mapping of four pipelines for a clock") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let missed = estimate(&["--detail", "0.002", "--quality", "fast", "--clock", "50ps"], folder.path());
    assert_eq!(missed.status.code(), Some(1));
    let text = String::from_utf8(missed.stdout).unwrap();
    assert!(text.contains("ray_box misses the clock by ") && text.contains("clock to output"), "{text}");
}

#[test]
fn check() {
    let work = Workplace::new();
    let document = work.json("check --unit fp_add --vectors 500 --seed 7");
    let units = document["units"].as_array().unwrap();
    assert_eq!(units.len(), 1);
    has_keys(&units[0], &["name", "vectors", "mismatches", "vectors_per_second", "classes"]);
    assert_eq!(units[0]["name"], "fp_add");
    assert_eq!(units[0]["mismatches"], 0);
    // The number that was asked for, rounded up to whole cycles of 16 lanes.
    assert!((500..516).contains(&units[0]["vectors"].as_u64().unwrap()), "{units:?}");
    let text = String::from_utf8(work.run("check --unit fp_cmp --vectors 100").stdout).unwrap();
    assert!(text.contains("| fp_cmp") && text.contains("NaN operand"), "{text}");
    work.refused("check --unit fp_div", &["fp_div", "fp_add"]);

    // A fault in the netlist is a difference: exit code 1, and the first mismatch with its seed.
    let line = "check --unit fp_cmp --vectors 2000 --seed 3 --mutate 0";
    let faulty = work.run(&format!("{line} --json"));
    assert_eq!(faulty.status.code(), Some(1));
    let faulty: serde_json::Value = serde_json::from_slice(&faulty.stdout).unwrap();
    assert!(faulty["fault"].as_str().unwrap().starts_with("fp_cmp."), "{faulty}");
    assert!(faulty["units"][0]["mismatches"].as_u64().unwrap() > 0);
    assert!(faulty["units"][0]["first_mismatch"].as_str().unwrap().contains("should be"));
    let text = String::from_utf8(work.run(line).stdout).unwrap();
    assert!(
        text.contains("fault put in: fp_cmp.") && text.contains("first mismatch with --seed 3"),
        "{text}"
    );
    work.refused("check --unit fp_cmp --mutate 100000", &["--mutate 100000", "fp_cmp has"]);
    work.refused("check --mutate 0", &["--unit"]);
}

#[test]
fn exhaustive_check() {
    let work = Workplace::new();
    let document = work.json("check --exhaustive e5m2 mul");
    let unit = &document["units"][0];
    has_keys(unit, &["name", "vectors", "mismatches", "vectors_per_second"]);
    assert_eq!(unit["vectors"], 5 << 16);
    assert_eq!(unit["mismatches"], 0);
    let state = work.path("check-e5m2-mul.json");
    assert!(!state.exists(), "the state is removed when all is done");
    // A run continues at the first block that the interrupted run did not check, and keeps a mismatch that it found.
    let left = r#"{"format":"e5m2","operation":"mul","blocks":1279,"vectors":7,"mismatches":1,"first":"so"}"#;
    std::fs::write(&state, left).unwrap();
    let output = work.run("check --exhaustive e5m2 mul --json");
    assert_eq!(output.status.code(), Some(1));
    let document: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(document["units"][0]["vectors"], 7 + 256);
    assert_eq!(document["units"][0]["first_mismatch"], "so");
    std::fs::write(&state, left.replace("mul", "add")).unwrap();
    work.refused("check --exhaustive e5m2 mul", &["check-e5m2-mul.json", "--state"]);
    work.refused("check --exhaustive binary32 mul", &["2^64", "--vectors"]);
    work.refused("check --exhaustive e5m2 div", &["`div`", "add, sub"]);
}

#[test]
fn export() {
    let work = Workplace::new();
    let document = work.json("export --out rtl --unit fp_mul --format binary16 --vectors 50");
    let files = document["artifacts"].as_array().unwrap();
    assert_eq!(files.len(), 14, "{files:?}");
    let verilog = String::from_utf8(work.read("rtl/fp_mul_binary16.v")).unwrap();
    assert!(verilog.contains("module fp_mul_binary16"), "{verilog}");
    assert_eq!(
        work.read("rtl/fp_mul_binary16_vectors.hex").iter().filter(|&&byte| byte == b'\n').count(),
        946,
        "the directed cycles and 50 random ones"
    );
    let first = work.read("rtl/fp_mul_binary16_vectors.hex");
    work.json("export --out rtl --unit fp_mul --format binary16 --vectors 50");
    assert_eq!(work.read("rtl/fp_mul_binary16_vectors.hex"), first, "the same every time");
    work.refused(
        "export --out none --unit shared_units --format binary16",
        &["shared_units", "binary16", "binary32"],
    );
    assert!(!work.path("none").exists(), "a refused export leaves no folder");
    work.json("export --out all --vectors 1 --format e4m3 --one-file --tag-bits 7 --no-reset");
    let verilog = String::from_utf8(work.read("all/dualsplit_e4m3.v")).unwrap();
    for part in ["module fp_add_e4m3 (", "module dual_split_e4m3 (", "input  wire [6:0] tag_i"] {
        assert!(verilog.contains(part), "{part}");
    }
    assert!(!verilog.contains("rst_ni"), "no reset was asked for");
    work.refused("export --out tags --tag-bits 65", &["--tag-bits", "64"]);
    std::fs::create_dir(work.path("mine")).unwrap();
    work.write("mine/note", b"mine");
    work.refused("export --out mine --unit fp_mul", &["mine", "--force"]);
    work.refused("export --out x --format binary64", &["binary64", "binary32"]);
}

#[test]
fn wave() {
    let work = Workplace::new();
    for unit in Top::ALL {
        let out = format!("{unit}.vcd");
        let document = work.json(&format!("wave --unit {unit} --scene scene.obj --rays 2 --out {out}"));
        has_keys(&document, &["unit", "rays", "operations", "cycles"]);
        // The two rays visit six nodes and test six boxes, four of which are pairs of siblings.
        let operations = match unit {
            Top::FpAdd | Top::FpMul => 2 * 6,
            Top::FpMinMax => 3 * 6,
            Top::FpCmp => 4 * 6,
            Top::RayBoxX2 | Top::RayBoxX4 | Top::RayBoxX8 => 4,
            Top::SharedUnits => 6 + 6 + 12usize.div_ceil(8),
            _ => 6,
        };
        let drains = if *unit == Top::SharedUnits { 3 } else { 1 };
        assert_eq!(document["operations"], operations, "{unit}");
        assert_eq!(document["cycles"], operations + drains * DRAIN_CYCLES, "{unit}");
        let dump = String::from_utf8(work.read(&out)).unwrap();
        for words in ["$timescale 1 ns", &format!("$scope module {unit}"), "clk_i", "$enddefinitions"] {
            assert!(dump.contains(words), "{words}");
        }
        let has_node = [Top::DualSplit, Top::DualSplitLean, Top::SharedUnits].contains(unit);
        assert_eq!(dump.contains("header_i_text"), has_node);
        assert_eq!(has_node, dump.contains("sleaf "), "{unit}: a ray reaches a leaf");
        assert_eq!(*unit == Top::SharedUnits, dump.contains("sthreads "));
    }
    work.refused(
        "wave --unit dual_split --scene scene.obj --out dual_split.vcd",
        &["dual_split.vcd", "--force"],
    );
    work.refused("wave --unit fp_div --scene scene.obj --out x.vcd", &["fp_div", "dual_split"]);
}
