//! What an export holds beside the Verilog: FuseSoC core, constraint, README.

use crate::support::stimulus;
use netlist::verilog::{Form, GeneratedFile, Namespace, PackageOptions, package, port_names, shared_files};
use netlist::{Design, inventory};
use pipelines::catalogue::{StandardFormat, Top};
use pipelines::measured::{MEASURED, Measured};
use std::path::Path;
use yaml_rust2::{Yaml, YamlLoader};

const FILES: [&str; 7] = [".v", "_tb.v", "_vectors.hex", ".ys", ".sdc", ".md", "_fpga.v"];
/// What pipelines have too.
const STREAM_FILES: [&str; 4] = ["_stream.v", "_axis.v", "_pkg.sv", ".h"];

fn files_of(top: Top, design: &Design) -> Vec<GeneratedFile> {
    let inputs = design.top().inputs.iter().enumerate().map(|(i, port)| stimulus(0, i, port.width)).collect();
    let form = Form { reset: true, ..Form::default() };
    let options = PackageOptions {
        description: "What it does.",
        period_ns: 1.25,
        form,
        is_pipeline: top.is_pipeline(),
        ..PackageOptions::default()
    };
    package(design, &options, &[inputs]).unwrap()
}

fn contents<'f>(files: &'f [GeneratedFile], name: &str) -> &'f str {
    &files.iter().find(|file| file.name == name).unwrap_or_else(|| panic!("no {name}")).contents
}

fn strings(list: &Yaml) -> Vec<String> {
    list.as_vec().unwrap().iter().map(|item| item.as_str().unwrap().to_owned()).collect()
}

/// The names of a fileset: a file is a string, or the one key of its attributes.
fn fileset(set: &Yaml) -> Vec<String> {
    let name = |file: &Yaml| match file.as_hash() {
        Some(attributes) => attributes.keys().next().unwrap().as_str().unwrap().to_owned(),
        None => file.as_str().unwrap().to_owned(),
    };
    set["files"].as_vec().unwrap().iter().map(name).collect()
}

#[test]
fn packages_are_complete() {
    for &top in Top::ALL {
        let files = files_of(top, &top.design(StandardFormat::Binary32).unwrap());
        let names: Vec<&str> = files.iter().map(|file| file.name.as_str()).collect();
        let mut expected = FILES.to_vec();
        expected.extend((top != Top::SharedUnits).then_some("_checker.sv"));
        expected.extend(STREAM_FILES.iter().filter(|_| top.is_pipeline()));
        expected.push(".core");
        assert_eq!(names, expected.iter().map(|suffix| format!("{top}{suffix}")).collect::<Vec<_>>());
        assert!(files.iter().all(|file| !file.contents.is_empty() && file.contents.ends_with('\n')));
    }
}

#[test]
fn fusesoc_cores_name_files_and_tops_that_exist() {
    let shared = shared_files("any", 1.0);
    for &top in Top::ALL {
        let files = files_of(top, &top.design(StandardFormat::Binary32).unwrap());
        let text = contents(&files, &format!("{top}.core"));
        assert!(text.starts_with("CAPI=2:\n"), "the first line is FuseSoC's mark");
        let documents = YamlLoader::load_from_str(text).unwrap_or_else(|error| panic!("{top}: {error}"));
        let core = &documents[0];
        assert_eq!(
            core["name"].as_str(),
            Some(&*format!("dualsplit:rtl:{top}:{}", env!("CARGO_PKG_VERSION")))
        );
        let sets = core["filesets"].as_hash().unwrap();
        for set in sets.values() {
            for file in fileset(set) {
                let written = files.iter().chain(&shared).any(|written| written.name == file);
                assert!(written, "{top}: no {file}");
            }
        }
        let targets = core["targets"].as_hash().unwrap();
        assert_eq!(targets.len(), 6 + usize::from(top.is_pipeline()));
        for (name, target) in targets {
            let used = strings(&target["filesets"]);
            assert!(used.iter().all(|set| sets.contains_key(&Yaml::String(set.clone()))), "{top}: {used:?}");
            let toplevel = target["toplevel"].as_str().unwrap();
            let sources = used.iter().flat_map(|set| fileset(&core["filesets"][set.as_str()]));
            let declares = format!("module {toplevel}");
            let mut verilog = sources.filter(|file| file.ends_with(".v"));
            assert!(verilog.any(|file| contents(&files, &file).contains(&declares)), "{top}: {name:?}");
        }
    }
}

#[test]
fn readmes_have_every_port_and_the_latency() {
    for &top in Top::ALL {
        let design = top.design(StandardFormat::Binary32).unwrap();
        let files = files_of(top, &design);
        let text = contents(&files, &format!("{top}.md"));
        let names = port_names(design.top(), &mut Namespace::default());
        let inputs = names.inputs.iter().zip(&design.top().inputs).map(|(name, port)| (name, "in", port));
        let outputs =
            names.outputs.iter().zip(&design.top().outputs).map(|(name, (port, _))| (name, "out", port));
        for (name, direction, port) in inputs.chain(outputs) {
            let row = format!("| `{name}` | {direction} | {} |", port.width);
            let meaning = text.lines().find_map(|line| line.strip_prefix(&row));
            let meaning = meaning.unwrap_or_else(|| panic!("{top}: no {row} in {text}"));
            assert!(meaning.len() > "  |".len(), "{top}: {row} has no meaning");
        }
        assert!(text.contains("| `clk_i` | in | 1 |") && text.contains("What it does."));
        assert!(text.contains("| `rst_ni` | in | 1 |") && text.contains(&format!("make sim TOP={top}`")));
        assert_eq!(text.contains(&format!("`{top}_axis`")), top.is_pipeline());
        // In the diagram, the first result is as many cycles behind the first operation as the latency.
        if let Some(latency) = inventory(&design).unwrap().latency_cycles {
            let lane =
                |label: &str| text.lines().find(|line| line.starts_with(label)).unwrap().find("X A").unwrap();
            assert_eq!(lane("outputs") - lane("inputs"), 4 * latency as usize, "{top}");
            assert!(text.contains(&format!("Latency {latency} cycle")), "{top}");
        }
        let constraint = contents(&files, &format!("{top}.sdc"));
        assert!(constraint.contains("set period 1.250\n"), "{constraint}");
        assert!(constraint.contains("create_clock -name clk_i -period $period"), "{constraint}");
    }
}

/// The README of a top in binary32 has the numbers of its row in docs/hardware.md; in another format it has none.
#[test]
fn readmes_state_clock_and_area_as_the_documents_do() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/hardware.md");
    let page = std::fs::read_to_string(page).unwrap();
    for measured in MEASURED {
        let Measured { top, sky130_mhz, sky130_um2, fpga_mhz, luts, flip_flops, multipliers } = measured;
        let row = format!(
            "| `{top}` | {sky130_mhz:.0} | {sky130_um2} | {fpga_mhz:.1} | {luts} | {flip_flops} | {multipliers} |"
        );
        assert!(page.contains(&row), "docs/hardware.md has no row {row}");
        let notes = |format| top.package_options(format, Form::default()).notes;
        let text = notes(StandardFormat::Binary32);
        for number in [format!("{sky130_mhz:.0} MHz and {sky130_um2} um2"), format!("{luts} LUT4")] {
            assert!(text.contains(&number), "{text}");
        }
        assert!(!notes(StandardFormat::Binary16).contains("LUT4"));
    }
}
