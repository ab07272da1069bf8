//! Exported files of different tops in one compilation.

use equivalence::testbench as stimulus;
use netlist::verilog::testbench::{Start, testbench, vectors};
use netlist::verilog::{Form, text};
use netlist::{Design, flatten};
use pipelines::catalogue::{StandardFormat, Top};
use std::path::Path;
use testing::tools::{available, in_parallel, run};

const FORM: Form<'static> = Form { reset: true, sources: &[] };

fn design(top: Top) -> Design {
    top.design(StandardFormat::Binary32).unwrap()
}

fn write(folder: &Path, name: &str, contents: &str) {
    std::fs::write(folder.join(name), contents).unwrap();
}

#[test]
fn every_pair_of_files_compiles() {
    if !available("iverilog") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let designs: Vec<Design> = Top::ALL.iter().map(|&top| design(top)).collect();
    for design in &designs {
        let name = &design.top().name;
        write(folder.path(), &format!("{name}.v"), &FORM.text(&[design], name));
    }
    let all = Top::ALL;
    let pairs = all.iter().enumerate().flat_map(|(i, &a)| all[i + 1..].iter().map(move |&b| (a, b)));
    in_parallel(pairs, |(a, b)| {
        drop(compile(folder.path(), &[&format!("{a}.v"), &format!("{b}.v")]).unwrap())
    });

    let together: Vec<&Design> = designs.iter().collect();
    write(folder.path(), "all.v", &FORM.text(&together, "all"));
    compile(folder.path(), &["all.v"]).unwrap();
    // A file beside one that has its modules is refused, so the pairs can fail.
    compile(folder.path(), &["all.v", "int_add.v"]).expect_err("int_add is declared twice");
}

fn compile(folder: &Path, files: &[&str]) -> Result<String, String> {
    run(folder, "iverilog", &[&["-g2005", "-Wall", "-t", "null"], files].concat())
}

/// Testbenches of two tops in one simulation: both pass. `ray_box` has waiting lines that differ from those of `shared_units`.
#[test]
fn two_tops_simulate_side_by_side() {
    if !available("iverilog") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    // Instead of an end, the first testbench waits until the second, which has more vectors, ends the simulation.
    let mut counts = Vec::new();
    for (top, random, ends) in [(Top::RayBox, 100, false), (Top::SharedUnits, 200, true)] {
        let design = design(top);
        let start = Start::of(&design, &FORM).unwrap();
        let cycles = stimulus(top, StandardFormat::Binary32, &flatten(&design).unwrap(), random, 1);
        let bench = testbench(&design, &start, None, cycles.len() as u64);
        let bench = if ends { bench } else { bench.replace("$finish;", "index = -1000000;") };
        counts.push(cycles.len());
        write(folder, &format!("{top}.v"), &FORM.text(&[&design], top.name()));
        write(folder, &format!("{top}_tb.v"), &bench);
        write(folder, &format!("{top}_vectors.hex"), &vectors(&design, &start, cycles).unwrap());
    }
    assert!(counts[0] < counts[1]);
    let files = ["ray_box.v", "ray_box_tb.v", "shared_units.v", "shared_units_tb.v"];
    let tops = ["-g2012", "-s", "ray_box_tb", "-s", "shared_units_tb", "-o", "simulation"];
    run(folder, "iverilog", &[&tops[..], &files].concat()).unwrap();
    let printed = run(folder, "vvp", &["-n", "simulation"]).unwrap();
    for top in ["ray_box", "shared_units"] {
        assert!(printed.contains(&format!("PASS: {top}, ")), "{printed}");
    }
}

/// Names are unique within a file, and no module is called as one in another top's file.
#[test]
fn modules_of_different_tops_have_different_names() {
    let mut seen = std::collections::BTreeSet::new();
    for &format in StandardFormat::ALL {
        for &top in Top::ALL.iter().filter(|top| top.formats().contains(&format)) {
            let design = top.design(format).unwrap();
            for module in &design.modules {
                assert!(seen.insert(module.name.clone()), "{top} {format}: {}", module.name);
            }
            assert_eq!(text(&design).matches("\nmodule ").count(), design.modules.len());
        }
    }
}
