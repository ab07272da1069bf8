//! Our static timing against OpenSTA's, on the same netlists, without wires: every path that ends in a register.

use estimate::Implementation;
use gates::liberty::{Library, file_text, load};
use gates::timing::{analyse, reference_slew_ns};
use gates::words::Structures;
use pipelines::catalogue::Top;
use std::collections::BTreeMap;
use std::path::Path;

const LIBRARIES: [&str; 2] = ["sg13g2_stdcell_typ_1p20V_25C.lib.gz", "sky130_fd_sc_hd__tt_025C_1v80.lib.gz"];
/// Most by which the longest path may differ.
const LONGEST: f64 = 0.05;
/// Most by which any path to a register may differ, as a fraction of the longest one.
const ANY: f64 = 0.1;
/// The clock of the check, in nanoseconds: a path's length is this less its slack.
const PERIOD_NS: f64 = 1000.0;

/// Lengths in nanoseconds of the paths that end in each register, by OpenSTA.
fn by_opensta(folder: &Path, liberty: &Path, implementation: &Implementation) -> BTreeMap<usize, f64> {
    let text = file_text(liberty).unwrap();
    // A default wire load would add to every net what we leave out.
    let lines = text.lines().filter(|line| !line.contains("default_wire_load"));
    std::fs::write(folder.join("cells.lib"), lines.collect::<Vec<_>>().join("\n")).unwrap();
    let library = implementation.library;
    std::fs::write(folder.join("top.v"), implementation.mapped.verilog(library, "top")).unwrap();
    let slew = reference_slew_ns(library);
    let script = format!(
        "read_liberty cells.lib\nset_cmd_units -time ns -capacitance fF\nread_verilog top.v\nlink_design top\n\
         create_clock -name clk -period {PERIOD_NS} [get_ports clk]\nset_clock_transition {slew} [get_clocks clk]\n\
         set ins {{}}\nforeach port [all_inputs] {{ if {{[get_property $port full_name] ne \"clk\"}} {{ lappend ins $port }} }}\n\
         set_input_delay 0 -clock clk $ins\nset_input_transition {slew} $ins\n\
         report_checks -path_delay max -format end -digits 5 -group_count 100000 -endpoint_count 1\nexit\n"
    );
    std::fs::write(folder.join("top.tcl"), script).unwrap();
    let report = testing::tools::run(folder, "sta", &["-exit", "-no_splash", "top.tcl"]).unwrap();
    // Lines such as `r12/D (sg13g2_dfrbpq_1)  999.8  1.7  998.1 (MET)`: needed, there, slack.
    let line = |line: &str| {
        let words: Vec<&str> = line.split_whitespace().collect();
        let register = words.first()?.strip_prefix('r')?.split_once('/')?.0.parse().ok()?;
        Some((register, PERIOD_NS - words.get(4)?.parse::<f64>().ok()?))
    };
    let lengths: BTreeMap<usize, f64> = report.lines().filter_map(line).collect();
    assert!(!lengths.is_empty(), "{report}");
    lengths
}

/// By how much our longest path is longer than OpenSTA's, and by how much any path to a register differs at most, both as
/// fractions of the longest path.
fn difference(ours: &BTreeMap<usize, f64>, theirs: &BTreeMap<usize, f64>) -> (f64, f64) {
    assert_eq!(ours.len(), theirs.len());
    let longest = |lengths: &BTreeMap<usize, f64>| lengths.values().copied().fold(0.0, f64::max);
    let all = theirs.iter().map(|(register, theirs)| (ours[register] - theirs).abs());
    (longest(ours) / longest(theirs) - 1.0, all.fold(0.0, f64::max) / longest(theirs))
}

fn ours(implementation: &Implementation, library: &Library) -> BTreeMap<usize, f64> {
    let timing = analyse(&implementation.mapped, library);
    let registers = implementation.mapped.registers.iter().enumerate();
    registers.map(|(i, r)| (i, timing.latest(r.data) + library.flip_flop.setup_ns)).collect()
}

#[test]
fn paths_are_as_long_as_by_opensta() {
    if !testing::long("the timing of both pipelines by OpenSTA") || !testing::tools::available("sta") {
        return;
    }
    let Some(folder) = testing::data("liberty") else { return };
    for name in LIBRARIES {
        let path = folder.join(name);
        // OpenSTA would have to be told how clock gates are placed.
        let library = Library { clock_gate: None, ..load(std::slice::from_ref(&path)).unwrap() };
        for top in [Top::DualSplit, Top::RayBox] {
            let mut implementation = Implementation::new(top, &library, Structures::default()).unwrap();
            let work = tempfile::tempdir().unwrap();
            let theirs = by_opensta(work.path(), &path, &implementation);
            let (longest, any) = difference(&ours(&implementation, &library), &theirs);
            println!("{} {top}: {:+.2} %, any path {:.2} %", library.name, 100.0 * longest, 100.0 * any);
            assert!(longest.abs() <= LONGEST && any <= ANY, "{} {top}: {longest} {any}", library.name);
            // Cells of other sizes than in the netlist that OpenSTA read are noticed.
            let inverts = |cell: usize| {
                library.cells[cell].function == library.cells[library.inverter()].function
                    && library.cells[cell].inputs.len() == 1
            };
            let largest = (0..library.cells.len())
                .filter(|&cell| inverts(cell))
                .max_by(|&a, &b| library.cells[a].area_um2.total_cmp(&library.cells[b].area_um2));
            for gate in implementation.mapped.gates.iter_mut().filter(|gate| inverts(gate.cell)) {
                gate.cell = largest.unwrap();
            }
            let (longest, any) = difference(&ours(&implementation, &library), &theirs);
            println!("largest inverters: {:+.2} %, any path {:.2} %", 100.0 * longest, 100.0 * any);
            assert!(longest.abs() > LONGEST || any > ANY, "{longest} {any}");
        }
    }
}
