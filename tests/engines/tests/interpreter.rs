//! The interpreter against the evaluator: random designs and the catalogue.

use engines::random;
use equivalence::Stimulus;
use logic::agreement::{any_inputs, first_difference};
use logic::interpreter::{Interpreter, LANES};
use netlist::flatten;
use pipelines::catalogue::{StandardFormat, Top};
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, ..ProptestConfig::default() })]

    /// 64 lanes of 40 cycles for each design.
    #[test]
    fn random_designs_agree_with_the_evaluator(seed: u64, max_width in prop::sample::select(vec![8u32, 32, 64, 128])) {
        let netlist = flatten(&random::design(seed, max_width)).unwrap();
        let mut interpreter = Interpreter::new(&netlist);
        let inputs = |cycle, lane| any_inputs(&netlist, seed, cycle, lane);
        let difference = first_difference(&netlist, &mut interpreter, 40, inputs);
        prop_assert_eq!(difference, None);
    }
}

#[test]
fn the_catalogue_agrees_with_the_evaluator_in_every_format() {
    for &format in StandardFormat::ALL {
        for top in [Top::FpAdd, Top::FpMul, Top::FpMinMax, Top::FpCmp, Top::DualSplit, Top::RayBox] {
            let netlist = flatten(&top.design(format).unwrap()).unwrap();
            let mut interpreter = Interpreter::new(&netlist);
            let mut streams: Vec<_> =
                (0..LANES as u64).map(|lane| Stimulus::new(top, format, &netlist, lane)).collect();
            let inputs = |_, lane: usize| streams[lane].next().unwrap();
            assert_eq!(first_difference(&netlist, &mut interpreter, 12, inputs), None, "{top} {format}");
        }
    }
}
