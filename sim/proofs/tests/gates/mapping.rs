//! Mapping to cells: proved equal to its source, in the embedded library and in those of `DUALSPLIT_DATA`.

use gates::aig::Aig;
use gates::blast::{Blasted, Options, blast};
use gates::energy::activity;
use gates::glitch;
use gates::liberty::{self, Library};
use gates::map::{map, map_fast};
use gates::prove::{Limits, Miter, Verdict};
use gates::restructure::restructure;
use gates::timing::{analyse, buffer, close, size};
use netlist::flatten;
use pipelines::catalogue::{StandardFormat, Top};
use std::collections::BTreeMap;
use std::path::PathBuf;

/// The embedded library, and those beside the repository, if any: files with equal beginnings are of one library.
fn libraries() -> Vec<Library> {
    let mut all = vec![liberty::embedded()];
    let Some(folder) = testing::data("liberty") else { return all };
    let mut groups: BTreeMap<String, Vec<PathBuf>> = BTreeMap::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if name.ends_with(".lib.gz") || name.ends_with(".lib") {
            groups.entry(name[..4].to_owned()).or_default().push(path);
        }
    }
    for mut paths in groups.into_values() {
        paths.sort();
        all.push(liberty::load(&paths).unwrap());
    }
    all
}

fn unit(top: Top) -> Blasted {
    let design = top.design(StandardFormat::Binary32).unwrap();
    let flat = flatten(&design).unwrap();
    blast(&design, &flat, Options { keep_units: true, ..Options::default() })
}

fn area(aig: &Aig, library: &Library) -> f64 {
    map(aig, library).unwrap().gates.iter().map(|gate| library.cells[gate.cell].area_um2).sum()
}

/// Buffers and larger cells included.
#[test]
fn mapped_netlists_are_proved_equal() {
    for library in libraries() {
        let tops = [Top::FpAdd, Top::FpMinMax, Top::FpCmp, Top::FpMul, Top::DualSplit];
        for top in tops.into_iter().take(testing::cases(5, 3) as usize) {
            let mut aig = unit(top).aig;
            if library.clock_gate.is_none() {
                aig.multiplex_enables();
            }
            let mut mapped = map(&aig, &library).unwrap();
            buffer(&mut mapped, &aig, &library);
            let before = analyse(&mapped, &library).critical_path_ns;
            let timing = size(&mut mapped, &library, 0.0);
            println!(
                "{} {top}: {} cells, {before:.3} ns, sized {:.3} ns",
                library.name,
                mapped.gates.len(),
                timing.critical_path_ns
            );
            assert!(timing.critical_path_ns <= before);
            let miter = Miter::new(&aig, &mapped.function(&aig, &library).0).unwrap();
            assert_eq!(miter.prove(Limits::default()).verdict, Verdict::Equal, "{} {top}", library.name);
        }
    }
}

/// Restructured, mapped for delay, buffered, sized and made small again: equal, faster than sizing alone, and smaller with more time.
#[test]
fn netlists_for_a_clock_are_proved_equal_and_meet_it() {
    let library = liberty::embedded();
    let area = |mapped: &gates::map::Mapped| -> f64 {
        mapped.gates.iter().map(|gate| library.cells[gate.cell].area_um2).sum()
    };
    for top in [Top::FpAdd, Top::FpMinMax] {
        let source = unit(top).aig;
        let mut plain = map(&source, &library).unwrap();
        buffer(&mut plain, &source, &library);
        let plain_ns = size(&mut plain, &library, 0.0).critical_path_ns;
        let graph = restructure(&restructure(&source));
        let mapped = map_fast(&graph, &library, 0.0).unwrap();
        let closed = |target_ns: f64| {
            let mut mapped = mapped.clone();
            let timing = close(&mut mapped, &graph, &library, target_ns);
            let miter = Miter::new(&source, &mapped.function(&graph, &library).0).unwrap();
            assert_eq!(miter.prove(Limits::default()).verdict, Verdict::Equal, "{top} {target_ns}");
            (timing.critical_path_ns, area(&mapped))
        };
        let (fastest_ns, fastest_um2) = closed(0.0);
        let (relaxed_ns, relaxed_um2) = closed(1.3 * fastest_ns);
        println!(
            "{top}: {plain_ns:.3} ns, {fastest_ns:.3} ns {fastest_um2:.0} um2, {relaxed_ns:.3} ns {relaxed_um2:.0} um2"
        );
        assert!(fastest_ns < plain_ns && relaxed_ns <= 1.3 * fastest_ns && relaxed_um2 < fastest_um2);
    }
}

/// ABC's netlists, read back, equal the graph that ABC was given; a netlist with an exchanged cell does not.
#[test]
fn netlists_of_abc_are_proved_equal() {
    if !testing::tools::provers_available() {
        return;
    }
    let Some(folder) = testing::data("liberty") else { return };
    let liberty = vec![folder.join("sg13g2_stdcell_typ_1p20V_25C.lib.gz")];
    let library = Library { clock_gate: None, ..liberty::load(&liberty).unwrap() };
    let mut aig = unit(Top::FpCmp).aig;
    aig.multiplex_enables();
    let work = tempfile::tempdir().unwrap();
    let differs = |mapped: &gates::map::Mapped| {
        let miter = Miter::new(&aig, &mapped.function(&aig, &library).0).unwrap();
        miter.prove(Limits::default()).verdict != Verdict::Equal
    };
    for script in gates::abc::SCRIPTS {
        let all = gates::abc::map(&aig, &library, &liberty, &script, &[1000.0, 5000.0], work.path()).unwrap();
        assert!(all.len() == 2 && !all.iter().any(differs), "{}", script.name);
        let mut wrong = all.into_iter().next().unwrap();
        let of = |name: &str| library.cells.iter().position(|cell| cell.name == name).unwrap();
        let (nand, nor) = (of("sg13g2_nand2_1"), of("sg13g2_nor2_1"));
        wrong.gates.iter_mut().find(|gate| gate.cell == nand).unwrap().cell = nor;
        assert!(differs(&wrong), "{}", script.name);
    }
}

/// Areas that a mapper must not exceed: 5 % above what it reached when this was written.
#[test]
fn area_does_not_grow() {
    let library = liberty::embedded();
    for (top, gates) in
        [(Top::FpAdd, 2_523.0), (Top::FpMul, 6_230.0), (Top::FpMinMax, 318.0), (Top::FpCmp, 273.0)]
    {
        let found = area(&unit(top).aig, &library) / library.gate_equivalent_um2();
        println!("{top}: {found:.0} gate equivalents");
        assert!(found <= 1.05 * gates, "{top}: {found} gate equivalents");
    }
}

/// A mapped netlist with a cell that was exchanged is not equal.
#[test]
fn an_exchanged_cell_is_found() {
    let library = liberty::embedded();
    let aig = unit(Top::FpCmp).aig;
    let mut mapped = map(&aig, &library).unwrap();
    let cell = |name: &str| library.cells.iter().position(|cell| cell.name == name).unwrap();
    let position = mapped.gates.iter().position(|gate| gate.cell == cell("nand2")).unwrap();
    mapped.gates[position].cell = cell("nor2");
    let miter = Miter::new(&aig, &mapped.function(&aig, &library).0).unwrap();
    assert!(matches!(miter.prove(Limits::default()).verdict, Verdict::Differs { .. }));
}

/// Without glitches every net changes at most once a cycle; with them at least as often in sum, and with equal parity, so
/// that both end in the same values.
#[test]
fn glitches_only_add_changes() {
    let library = liberty::embedded();
    let blasted = unit(Top::FpAdd);
    let aig = &blasted.aig;
    let mut mapped = map(aig, &library).unwrap();
    buffer(&mut mapped, aig, &library);
    let timing = analyse(&mapped, &library);
    let flat = flatten(&Top::FpAdd.design(StandardFormat::Binary32).unwrap()).unwrap();
    let stimulus = equivalence::Stimulus::new(Top::FpAdd, StandardFormat::Binary32, &flat, 3);
    let mut stream: Vec<Vec<u128>> = stimulus.take(60).collect();
    let enable = flat.input("en_i").unwrap();
    stream.iter_mut().for_each(|cycle| cycle[enable] = 1);
    let plain = activity(aig, &blasted.inputs, std::slice::from_ref(&stream), 5);
    let (changes, cycles) = glitch::changes(aig, &mapped, &library, &timing, &blasted.inputs, &stream, 5);
    assert_eq!(cycles, plain.cycles);
    let mut sums = [0, 0];
    for gate in &mapped.gates {
        let net = gate.output as usize;
        let settled = plain.changes[mapped.literals[net].node()];
        assert!(
            changes[net] >= settled && (changes[net] - settled).is_multiple_of(2),
            "net {net}: {} {settled}",
            changes[net]
        );
        sums[0] += settled;
        sums[1] += changes[net];
    }
    println!("changes: {sums:?}");
    assert!(sums[1] > sums[0]);
}
