//! Other ways to build the glue, and what they cost.

use serde::Serialize;

use pipelines::catalogue::Top;

use super::{EstimateError, Implementation, NodeType, Workload};
use gates::aig::{Aig, Lit};
use gates::liberty::Library;
use gates::map::map;
use gates::words::{self, Selection, Structures};

/// A way to build a part, in gate equivalents of the library: areas of two-input NAND gates.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Alternative {
    /// The question.
    pub question: &'static str,
    /// The answer.
    pub answer: String,
    /// Whether the pipeline is built this way.
    pub built: bool,
    /// Its cost.
    pub gate_equivalents: f64,
    /// Its change of the energy of an operation in femtojoules, where that was measured.
    pub energy_fj: Option<f64>,
}

/// Bits that select an axis.
type Axis = [Lit; 2];

/// A word for each axis.
type Reciprocals = [Vec<Lit>; 3];

/// The alternatives for the dual-split pipeline.
///
/// # Errors
/// As for [`Implementation::new`].
pub fn alternatives(
    built: &Implementation,
    library: &Library,
    workload: &Workload,
) -> Result<Vec<Alternative>, EstimateError> {
    let mut list = Vec::new();
    let mut add = |question, answer: &str, is_built, gate_equivalents, energy_fj| {
        list.push(Alternative {
            question,
            answer: answer.to_owned(),
            built: is_built,
            gate_equivalents,
            energy_fj,
        });
    };
    let unit = library.gate_equivalent_um2();

    let question = "choice among three words (all glue)";
    let chained = Implementation::new(
        built.top,
        library,
        Structures { selection: Selection::Chain, ..Structures::default() },
    )?;
    for (implementation, answer, is_built) in [
        (built, "one condition each, AND-OR, choices within choices too", true),
        (&chained, "2:1 multiplexers in a row, as written", false),
    ] {
        let energy = implementation.energy(&workload.streams(implementation)?).zero_delay.glue;
        add(question, answer, is_built, implementation.area().glue / unit, Some(energy));
    }
    if built.top == Top::DualSplit {
        let lean = Implementation::new(Top::DualSplitLean, library, Structures::default())?;
        let energy = lean.energy(&workload.streams(&lean)?).zero_delay.glue;
        add(
            question,
            "AND-OR, without the role comparators (lean)",
            true,
            lean.area().glue / unit,
            Some(energy),
        );
    }

    let question = "reciprocal of a plane (one of two planes)";
    for (answer, is_built, way) in [
        (
            "axis of the entry's; then the exit's axes and the role in one AND-OR of four",
            true,
            axis_with_role as fn(&mut Aig) -> Vec<Lit>,
        ),
        ("axis of both reciprocals, then role by the chosen sign", false, axis_then_role),
        ("role of each axis, then axis", false, role_then_axis),
        (
            "six conditions, AND-OR (lacks the entry's, which the role comparators take)",
            false,
            six_conditions,
        ),
    ] {
        add(question, answer, is_built, gates(way, library)?, None);
    }

    let question = "header code to axes and sides";
    for (answer, is_built, way) in [
        (
            "dual carves 0, 1, 3 and single 2 in two bits (26-bit offsets)",
            true,
            shared_code as fn(&mut Aig) -> Vec<Lit>,
        ),
        ("dual carves 0, 1, 2 and single 3 in two bits (26-bit offsets)", false, dense_code),
        ("an axis for each plane and its side, plain (22-bit offsets)", false, plain_code),
    ] {
        add(question, answer, is_built, gates(way, library)?, None);
    }

    let question = "stall of all registers";
    let registers = built.mapped.registers.len() as f64;
    if let Some(gate) = &library.clock_gate {
        let count: usize = built.mapped.clock_gating.iter().map(|gating| gating.gates).sum();
        add(question, "clock gates", true, count as f64 * gate.area_um2 / unit, None);
    }
    let multiplexer = gates(
        |aig| {
            let [s, a, b] = ["s", "a", "b"].map(|name| aig.add_input(name));
            vec![aig.mux(s, a, b)]
        },
        library,
    )?;
    add(
        question,
        "a multiplexer before every register",
        library.clock_gate.is_none(),
        registers * multiplexer,
        None,
    );

    let question = "operands of bare leaves";
    let whole = built.energy(&workload.streams(built)?).zero_delay.logic();
    add(question, "as they come", true, 0.0, Some(0.0));
    // If the operands are held, the units do not change for a leaf. At best that saves all of a leaf's energy in the
    // units.
    let nodes = workload.nodes.iter().map(|case| NodeType::of(case.words[0]));
    let leaves = nodes.filter(|&node| node == NodeType::Leaf).count() as f64 / workload.nodes.len() as f64;
    let held = 4.0 * 32.0 * gates(and_gate, library)?;
    add(question, "held by a gate at each bit (energy: at most)", false, held, Some(-leaves * whole));
    Ok(list)
}

/// Gate equivalents of a circuit, mapped alone.
fn gates(build: impl Fn(&mut Aig) -> Vec<Lit>, library: &Library) -> Result<f64, EstimateError> {
    let mut aig = Aig::default();
    let outputs = build(&mut aig);
    outputs.into_iter().enumerate().for_each(|(i, lit)| aig.add_output(format!("o{i}"), lit));
    let mapped = map(&aig, library)?;
    let area: f64 = mapped.gates.iter().map(|gate| library.cells[gate.cell].area_um2).sum();
    Ok(area / library.gate_equivalent_um2())
}

fn word(aig: &mut Aig, name: &str, width: usize) -> Vec<Lit> {
    (0..width).map(|bit| aig.add_input(format!("{name}{bit}"))).collect()
}

fn and_gate(aig: &mut Aig) -> Vec<Lit> {
    let (a, b) = (aig.add_input("a"), aig.add_input("b"));
    vec![aig.and(a, b)]
}

/// Conditions for axis 0, axis 1 and the rest.
fn of_axis(aig: &mut Aig, axis: Axis) -> [Lit; 3] {
    let x = aig.and(!axis[0], !axis[1]);
    let y = aig.and(axis[0], !axis[1]);
    [x, y, axis[1]]
}

/// Conditions of the axes, the plane's side, and the reciprocals for entry and exit.
fn reciprocals(aig: &mut Aig) -> ([Lit; 3], Lit, Reciprocals, Reciprocals) {
    let axis = [aig.add_input("axis0"), aig.add_input("axis1")];
    let side = aig.add_input("side");
    let entry = [0, 1, 2].map(|i| word(aig, &format!("entry{i}_"), 32));
    let exit = [0, 1, 2].map(|i| word(aig, &format!("exit{i}_"), 32));
    (of_axis(aig, axis), side, entry, exit)
}

fn chosen(aig: &mut Aig, conditions: &[Lit], words: &[&[Lit]]) -> Vec<Lit> {
    (0..words[0].len())
        .map(|bit| {
            let terms: Vec<Lit> = conditions
                .iter()
                .zip(words)
                .map(|(&condition, word)| aig.and(condition, word[bit]))
                .collect();
            words::any(aig, &terms)
        })
        .collect()
}

fn axis_then_role(aig: &mut Aig) -> Vec<Lit> {
    let (axis, side, entry, exit) = reciprocals(aig);
    let entry = chosen(aig, &axis, &[&entry[0], &entry[1], &entry[2]]);
    let exit = chosen(aig, &axis, &[&exit[0], &exit[1], &exit[2]]);
    let is_exit = !aig.xor(entry[31], side);
    words::mux(aig, is_exit, &exit, &entry)
}

fn axis_with_role(aig: &mut Aig) -> Vec<Lit> {
    let (axis, side, entry, exit) = reciprocals(aig);
    let entry = chosen(aig, &axis, &[&entry[0], &entry[1], &entry[2]]);
    let is_exit = !aig.xor(entry[31], side);
    let [x, y, z] = axis.map(|axis| aig.and(axis, is_exit));
    chosen(aig, &[x, y, z, !is_exit], &[&exit[0], &exit[1], &exit[2], &entry])
}

fn role_then_axis(aig: &mut Aig) -> Vec<Lit> {
    let (axis, side, entry, exit) = reciprocals(aig);
    let role = [0, 1, 2].map(|i: usize| {
        let is_exit = !aig.xor(entry[i][31], side);
        words::mux(aig, is_exit, &exit[i], &entry[i])
    });
    chosen(aig, &axis, &[&role[0], &role[1], &role[2]])
}

fn six_conditions(aig: &mut Aig) -> Vec<Lit> {
    let (axis, side, entry, exit) = reciprocals(aig);
    let mut conditions = Vec::new();
    for (i, &condition) in axis.iter().enumerate() {
        let is_exit = !aig.xor(entry[i][31], side);
        conditions.push(aig.and(condition, !is_exit));
        conditions.push(aig.and(condition, is_exit));
    }
    let words: Vec<&[Lit]> =
        entry.iter().zip(&exit).flat_map(|(a, b)| [a.as_slice(), b.as_slice()]).collect();
    chosen(aig, &conditions, &words)
}

/// Conditions of both planes' axes, and their sides, from bits 31 and 30:27 of a header.
fn decoded(
    aig: &mut Aig,
    dual: Lit,
    kind: [Lit; 2],
    size: [Lit; 2],
    carve: Lit,
    axes: [Axis; 2],
) -> Vec<Lit> {
    let single: Axis = [0, 1].map(|i| aig.mux(carve, size[i], kind[i]));
    let mut outputs = Vec::new();
    for (axis, (side, plain)) in axes.into_iter().zip([(size[1], Lit::FALSE), (size[0], Lit::TRUE)]) {
        let axis: Axis = [0, 1].map(|i| aig.mux(dual, axis[i], single[i]));
        outputs.extend(of_axis(aig, axis));
        outputs.push(aig.mux(dual, side, plain));
    }
    outputs
}

fn header(aig: &mut Aig) -> (Lit, [Lit; 2], [Lit; 2]) {
    let carve = aig.add_input("carve");
    let kind = [aig.add_input("kind0"), aig.add_input("kind1")];
    (carve, kind, [aig.add_input("size0"), aig.add_input("size1")])
}

fn shared_code(aig: &mut Aig) -> Vec<Lit> {
    let (carve, kind, size) = header(aig);
    let single = aig.and(kind[1], !kind[0]);
    let dual = aig.and(carve, !single);
    let axes = [[kind[1], Lit::FALSE], [!kind[0], kind[0]]];
    decoded(aig, dual, kind, size, carve, axes)
}

fn dense_code(aig: &mut Aig) -> Vec<Lit> {
    let (carve, kind, size) = header(aig);
    let single = aig.and(kind[1], kind[0]);
    let dual = aig.and(carve, !single);
    let second = aig.or(kind[0], kind[1]);
    let axes = [[kind[1], Lit::FALSE], [!second, second]];
    decoded(aig, dual, kind, size, carve, axes)
}

fn plain_code(aig: &mut Aig) -> Vec<Lit> {
    let mut outputs = Vec::new();
    for plane in 0..2 {
        let axis = [0, 1].map(|bit| aig.add_input(format!("axis{plane}{bit}")));
        outputs.extend(of_axis(aig, axis));
        outputs.push(aig.add_input(format!("side{plane}")));
    }
    outputs
}
