//! The embedded library, which needs no file: gate equivalents of each class of cell, with linear delays.
//!
//! Measured from `sg13g2_stdcell_typ_1p20V_25C.lib` (IHP SG13G2, 130 nm, 1.2 V, 25 C, Apache-2.0), smallest drive of each
//! class, transition times those of an inverter that drives four: area over that of the two-input NAND gate, mean input
//! capacitance, delay and transition time as lines through loads of 5 and 25 fF, mean internal energy at 10 fF. The
//! two-input NAND gate, 7.2576 um2 there, is one gate equivalent.

use super::function;
use super::{Arc, Cell, ClockGate, FlipFlop, Library, Sense, Table};

/// Area of a gate equivalent in the library that was measured.
const GATE_EQUIVALENT_UM2: f64 = 7.2576;

/// Inputs, function, then: area in gate equivalents, input capacitance in fF, delay in ps and per fF, transition time in ps
/// and per fF, internal energy in fJ, leakage in nW.
type Row = (&'static str, &'static [&'static str], &'static str, [f64; 8]);

const ROWS: &[Row] = &[
    ("inv", &["A"], "!A", [0.75, 2.87, 27.9, 3.150, 16.8, 3.314, 1.64, 0.063]),
    ("buf", &["A"], "A", [1.0, 2.26, 66.6, 2.706, 12.8, 3.391, 5.69, 0.110]),
    ("buf_4", &["A"], "A", [2.0, 3.70, 87.4, 0.761, 18.7, 0.822, 17.96, 0.337]),
    ("inv_4", &["A"], "!A", [1.5, 11.22, 23.8, 0.838, 14.8, 0.847, 5.11, 0.252]),
    ("nand2", &["A", "B"], "!(A*B)", [1.0, 2.93, 37.7, 3.904, 20.8, 4.509, 2.53, 0.081]),
    ("nand2_2", &["A", "B"], "!(A*B)", [1.5, 5.65, 36.5, 2.043, 20.3, 2.320, 4.73, 0.161]),
    ("nor2", &["A", "B"], "!(A+B)", [1.0, 2.98, 39.6, 4.452, 22.5, 5.320, 2.60, 0.083]),
    ("nor2_2", &["A", "B"], "!(A+B)", [1.5, 5.70, 38.1, 2.441, 21.5, 2.683, 5.03, 0.166]),
    ("nand2b", &["A", "B"], "!(!A*B)", [1.25, 2.63, 56.7, 3.739, 19.4, 4.605, 3.08, 0.129]),
    ("nor2b", &["A", "B"], "!(A+!B)", [1.25, 2.59, 57.9, 4.337, 20.5, 5.374, 2.71, 0.130]),
    ("nand3", &["A", "B", "C"], "!(A*B*C)", [1.25, 2.96, 50.0, 4.726, 28.8, 5.754, 3.65, 0.087]),
    ("nor3", &["A", "B", "C"], "!(A+B+C)", [1.25, 2.98, 55.7, 5.812, 33.9, 7.320, 3.87, 0.095]),
    ("nand4", &["A", "B", "C", "D"], "!(A*B*C*D)", [1.5, 2.98, 61.7, 5.623, 36.9, 7.021, 4.49, 0.092]),
    ("nor4", &["A", "B", "C", "D"], "!(A+B+C+D)", [1.5, 2.95, 71.6, 7.337, 46.2, 9.443, 4.72, 0.100]),
    ("and2", &["A", "B"], "A*B", [1.25, 2.54, 79.1, 2.793, 14.8, 3.347, 6.49, 0.138]),
    ("or2", &["A", "B"], "A+B", [1.25, 2.38, 87.1, 2.900, 16.5, 3.365, 6.41, 0.115]),
    ("and3", &["A", "B", "C"], "A*B*C", [1.75, 2.52, 96.7, 2.959, 17.9, 3.311, 7.38, 0.147]),
    ("or3", &["A", "B", "C"], "A+B+C", [1.75, 2.51, 108.0, 3.131, 19.7, 3.397, 7.62, 0.122]),
    ("and4", &["A", "B", "C", "D"], "A*B*C*D", [2.0, 2.46, 115.0, 3.123, 21.6, 3.318, 8.25, 0.152]),
    ("or4", &["A", "B", "C", "D"], "A+B+C+D", [2.0, 2.48, 131.1, 3.403, 23.6, 3.497, 8.38, 0.124]),
    ("a21oi", &["A1", "A2", "B1"], "!((A1*A2)+B1)", [1.25, 2.98, 51.7, 4.987, 28.5, 6.193, 3.48, 0.114]),
    ("o21ai", &["A1", "A2", "B1"], "!((A1+A2)*B1)", [1.25, 3.31, 53.3, 5.282, 28.9, 6.565, 3.53, 0.127]),
    ("a21o", &["A1", "A2", "B1"], "(A1*A2)+B1", [1.75, 2.72, 98.6, 2.959, 17.9, 3.332, 7.49, 0.158]),
    (
        "a22oi",
        &["A1", "A2", "B1", "B2"],
        "!((A1*A2)+(B1*B2))",
        [1.495, 3.06, 59.0, 5.228, 36.3, 6.571, 4.53, 0.139],
    ),
    (
        "a221oi",
        &["A1", "A2", "B1", "B2", "C1"],
        "!((A1*A2)+(B1*B2)+C1)",
        [2.0, 2.95, 81.6, 6.418, 52.2, 8.260, 5.33, 0.158],
    ),
    ("xor2", &["A", "B"], "A^B", [2.0, 5.44, 58.4, 5.239, 28.7, 6.631, 7.49, 0.185]),
    ("xnor2", &["A", "B"], "!(A^B)", [2.0, 5.36, 57.8, 5.250, 29.7, 6.641, 7.41, 0.195]),
    ("mux2", &["A0", "A1", "S"], "(A0*!S)+(A1*S)", [2.5, 3.57, 103.9, 3.149, 22.4, 3.282, 8.84, 0.246]),
    (
        "mux4",
        &["A0", "A1", "A2", "A3", "S0", "S1"],
        "(A0*!S0*!S1)+(A1*S0*!S1)+(A2*!S0*S1)+(A3*S0*S1)",
        [5.25, 4.07, 151.6, 3.508, 26.0, 3.418, 12.67, 0.465],
    ),
];

/// The embedded library.
///
/// # Panics
/// Never: a test reads every row.
#[must_use]
pub fn embedded() -> Library {
    let cells = ROWS.iter().map(|&(name, inputs, function, numbers)| {
        let [area, capacitance, delay, delay_per_ff, slew, slew_per_ff, energy, leakage] = numbers;
        let function = function::parse(function, inputs).expect("a function of the inputs");
        let arc = Arc {
            delay_ns: [0, 1].map(|_| Table::linear(delay / 1e3, delay_per_ff / 1e3)),
            transition_ns: [0, 1].map(|_| Table::linear(slew / 1e3, slew_per_ff / 1e3)),
            energy_fj: [0, 1].map(|_| Table::constant(energy)),
            sense: Sense::Both,
        };
        Cell {
            name: name.to_owned(),
            area_um2: area * GATE_EQUIVALENT_UM2,
            leakage_nw: leakage,
            inputs: inputs.iter().map(|&input| input.to_owned()).collect(),
            capacitance_ff: vec![capacitance; inputs.len()],
            output: "Y".to_owned(),
            function,
            max_load_ff: f64::INFINITY,
            arcs: vec![arc; inputs.len()],
        }
    });
    Library {
        name: "embedded".to_owned(),
        source: "embedded table of cell classes, measured from IHP sg13g2 typ 1.2 V 25 C (130 nm)".to_owned(),
        node_nm: Some(130),
        voltage_v: 1.2,
        cells: cells.collect(),
        // sg13g2_dfrbpq_1 and sg13g2_lgcp_1.
        flip_flop: FlipFlop {
            name: "dff".to_owned(),
            area_um2: 6.75 * GATE_EQUIVALENT_UM2,
            leakage_nw: 0.5,
            data: "D".to_owned(),
            clock: "CLK".to_owned(),
            output: "Q".to_owned(),
            data_ff: 1.42,
            clock_ff: 2.77,
            arc: Arc {
                delay_ns: [0, 1].map(|_| Table::linear(0.168, 0.003)),
                transition_ns: [0, 1].map(|_| Table::linear(0.025, 0.0033)),
                energy_fj: [0, 1].map(|_| Table::constant(25.0)),
                sense: Sense::Both,
            },
            clock_energy_fj: 26.6,
            setup_ns: 0.1,
        },
        clock_gate: Some(ClockGate {
            name: "clock gate".to_owned(),
            area_um2: 3.75 * GATE_EQUIVALENT_UM2,
            leakage_nw: 0.39,
            clock_ff: 4.7,
            enable_ff: 2.1,
            clock_energy_fj: 20.0,
            max_load_ff: 300.0,
        }),
        ties: [Some(("tielo".to_owned(), 7.2576)), Some(("tiehi".to_owned(), 7.2576))],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_row_reads() {
        let library = embedded();
        assert_eq!(library.gate_equivalent_um2(), GATE_EQUIVALENT_UM2);
        assert_eq!(library.cells[library.inverter()].name, "inv");
        for cell in &library.cells {
            assert!(
                (0..cell.inputs.len()).all(|input| function::depends_on(cell.function, input)),
                "{}",
                cell.name
            );
        }
    }
}
