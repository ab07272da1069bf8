//! `dualsplit estimate` as a user runs it.

use std::path::Path;
use std::process::{Command, Output};

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
    assert_eq!(json, serde_json::from_slice::<serde_json::Value>(&written).unwrap());
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
        ("unit.lib", Some("library (x) { nom_voltage : 1.0; }"), "no time_unit"),
        (
            "empty.lib",
            Some("library (x) { nom_voltage : 1.0; time_unit : \"1ns\"; capacitive_load_unit (1, pf); }"),
            "no rising-edge D flip-flop",
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
    let output = estimate(&["--synth"], folder.path());
    assert_eq!(output.status.code(), Some(2));
}
