//! Mapping to cells: proved equal to its source, in the embedded library and in those of `DUALSPLIT_DATA`.

use gates::aig::Aig;
use gates::blast::{Blasted, Options, blast};
use gates::energy::activity;
use gates::glitch;
use gates::liberty::{self, Library};
use gates::map::map;
use gates::prove::{Limits, Miter, Verdict};
use gates::timing::{analyse, buffer, size};
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
            let miter = Miter::new(&aig, &mapped.function(&aig, &library)).unwrap();
            assert_eq!(miter.prove(Limits::default()).verdict, Verdict::Equal, "{} {top}", library.name);
        }
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
    let miter = Miter::new(&aig, &mapped.function(&aig, &library)).unwrap();
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
