//! Mapping to cells: proved equal to its source.

use hdl::catalogue::{StandardFormat, Top};
use hdl::netlist::flatten;
use sim::gates::blast::{Options, blast};
use sim::gates::liberty::{self, Library};
use sim::gates::map::map;
use sim::gates::prove::{Limits, Miter, Verdict};
use std::path::PathBuf;

/// The libraries beside the repository, if any.
fn libraries() -> Vec<Library> {
    let Some(folder) = std::env::var_os("DUALSPLIT_DATA").map(|data| PathBuf::from(data).join("liberty"))
    else {
        println!("skipped: DUALSPLIT_DATA is not set");
        return Vec::new();
    };
    let mut groups: std::collections::BTreeMap<String, Vec<PathBuf>> = std::collections::BTreeMap::new();
    for entry in std::fs::read_dir(&folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if name.ends_with(".lib.gz") || name.ends_with(".lib") {
            groups.entry(name[..4].to_owned()).or_default().push(path);
        }
    }
    let mut all: Vec<Library> = vec![liberty::embedded()];
    all.extend(groups.into_values().map(|mut paths| {
        paths.sort();
        liberty::load(&paths).unwrap()
    }));
    all
}

#[test]
fn mapped_units_are_proved_equal() {
    for library in libraries() {
        println!(
            "{}: {} cells, 1 GE = {} um2, FF {:?}",
            library.name,
            library.cells.len(),
            library.gate_equivalent_um2(),
            library.flip_flop.name
        );
        for top in [Top::FpAdd, Top::FpMul, Top::FpMinMax, Top::FpCmp, Top::DualSplit, Top::RayBox] {
            let design = top.design(StandardFormat::Binary32).unwrap();
            let flat = flatten(&design).unwrap();
            let aig = blast(&design, &flat, Options { keep_units: true, ..Options::default() }).aig;
            let start = std::time::Instant::now();
            let mapped = map(&aig, &library).unwrap();
            let took = start.elapsed().as_secs_f64();
            let area: f64 = mapped.gates.iter().map(|gate| library.cells[gate.cell].area_um2).sum();
            let glue: f64 = mapped
                .gates
                .iter()
                .filter(|gate| gate.origin.region == 0)
                .map(|gate| library.cells[gate.cell].area_um2)
                .sum();
            println!(
                "{top}: {} ands, {} cells, {area:.0} um2, glue {glue:.0}, {took:.2} s",
                aig.and_count(),
                mapped.gates.len()
            );
            if top == Top::RayBox {
                continue;
            }
            let miter = Miter::new(&aig, &mapped.function(&aig, &library)).unwrap();
            let start = std::time::Instant::now();
            let proof = miter.prove(Limits::default());
            println!("   {proof:?} {:.2} s", start.elapsed().as_secs_f64());
            assert_eq!(proof.verdict, Verdict::Equal);
        }
    }
}
