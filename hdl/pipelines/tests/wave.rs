//! Waveforms of a pipeline.

use equivalence::Stimulus;
use netlist::Evaluator;
use netlist::flatten;
use netlist::wave::{CYCLE_NS, write};
use pipelines::catalogue::{StandardFormat, Top};
use pipelines::words::{decoder, node_type, return_value};
use std::collections::HashMap;
use vcd::{Command, Parser, ScopeItem, Value};

/// The dump, read back by the reader of `vcd`, shows each input and output of each cycle, and the decoded type.
#[test]
fn the_dump_reads_back() {
    let netlist = flatten(&Top::DualSplit.design(StandardFormat::Binary32).unwrap()).unwrap();
    let stimulus = Stimulus::new(Top::DualSplit, StandardFormat::Binary32, &netlist, 1);
    let cycles: Vec<Vec<u128>> = stimulus.take(40).collect();
    let mut bytes = Vec::new();
    write(&netlist, cycles.iter().cloned(), decoder, &mut bytes).unwrap();

    let mut parser = Parser::new(&bytes[..]);
    let header = parser.parse_header().unwrap();
    let id = |name: &str| header.find_var(&["dual_split", name]).unwrap().code;
    let inside = header.find_var(&["dual_split", "multiply_0", "array_lower", "product_o"]);
    assert_eq!(inside.unwrap().size, 48, "signals of inner instances are there");
    let scopes = header.items.iter().filter(|item| matches!(item, ScopeItem::Scope(_))).count();
    assert_eq!(scopes, 1);

    let mut expected = Evaluator::new(&netlist);
    let (node, code) = (netlist.input("header_i").unwrap(), netlist.output("code_o").unwrap());
    let (mut words, mut text) = (HashMap::new(), HashMap::new());
    let mut time = 0;
    let mut compared = 0;
    for command in parser {
        match command.unwrap() {
            Command::ChangeVector(id, bits) => {
                let value = bits.iter().fold(0u128, |value, bit| value << 1 | u128::from(*bit == Value::V1));
                words.insert(id, value);
            }
            Command::ChangeString(id, value) => {
                text.insert(id, value);
            }
            Command::Timestamp(next) => {
                // Everything at the start of a cycle has been read.
                if time % CYCLE_NS == 0 && next == time + CYCLE_NS / 2 {
                    let cycle = (time / CYCLE_NS) as usize;
                    let outputs = expected.cycle(&cycles[cycle]);
                    assert_eq!(words[&id("header_i")], cycles[cycle][node], "cycle {cycle}");
                    assert_eq!(text[&id("header_i_text")], node_type(cycles[cycle][node]));
                    assert_eq!(words[&id("code_o")], outputs[code], "cycle {cycle}");
                    assert_eq!(text[&id("code_o_text")], return_value(outputs[code]));
                    compared += 1;
                }
                time = next;
            }
            _ => {}
        }
    }
    assert_eq!(compared, cycles.len());
}
