//! What the specification says of every top, as claims that fall due after the latency.

use std::collections::VecDeque;
use std::sync::Arc;

use super::cases::{BoxCase, NodeCase};
use super::classes;
use super::ports::{BoxPorts, NodePorts, Ports};
use fp::{Arithmetic, NanMode, Rounding};
use netlist::Flat;
use pipelines::catalogue::{StandardFormat, Top};

/// Cycles from a pipeline's inputs to its outputs.
const PIPELINE_LATENCY_CYCLES: usize = 8;
/// The shared block's routing codes.
const RAY_BOX_MODE: u128 = 1;
const DUAL_SPLIT_MODE: u128 = 2;
/// Adders, and multipliers, of the shared block.
const SHARED_UNITS: usize = 8;

/// An output's value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Claim {
    /// Position of the output.
    pub output: usize,
    /// Its value.
    pub value: u128,
}

/// The specification of a top, with the operations that are in flight.
#[derive(Clone, Debug)]
pub struct Model {
    enable: usize,
    functions: Vec<(Function, Line)>,
}

/// The claims in flight, the oldest first: as many as the latency in cycles.
type Line = VecDeque<(Vec<Claim>, Option<Arc<[u128]>>)>;

/// Whether a part exists with a routing.
type HasMode = fn(u128) -> bool;

/// A part of a top with a latency and a `valid` of its own.
#[derive(Clone, Debug)]
struct Function {
    valid: usize,
    valid_out: usize,
    tag: [usize; 2],
    /// Position of the routing, and the values of it with which this part exists.
    mode: Option<(usize, HasMode)>,
    operation: Operation,
}

#[derive(Clone, Debug)]
enum Operation {
    IntAdd {
        operands: [usize; 2],
        sum: usize,
    },
    FpAdd {
        arithmetic: Arithmetic,
        operands: [usize; 2],
        subtract: usize,
        rounding: Option<usize>,
        result: usize,
    },
    FpMul {
        arithmetic: Arithmetic,
        operands: [usize; 2],
        rounding: Option<usize>,
        result: usize,
    },
    FpMinMax {
        arithmetic: Arithmetic,
        operands: [usize; 2],
        maximum: usize,
        propagate: usize,
        result: usize,
    },
    FpCmp {
        arithmetic: Arithmetic,
        operands: [usize; 2],
        lt_le_eq: [usize; 3],
    },
    DualSplit {
        node: NodePorts,
        code: usize,
        near: [usize; 3],
        far: [usize; 3],
    },
    RayBox {
        lanes: Vec<(BoxPorts, [usize; 2])>,
    },
}

impl Model {
    /// The specification of `top` in `format`, for `netlist`'s order of ports, with nothing in flight.
    ///
    /// # Panics
    /// If `netlist` lacks a port of `top`, or if a pipeline is in another format than binary32, the only one that
    /// golden traverses in.
    #[must_use]
    pub fn new(top: Top, format: StandardFormat, netlist: &Flat) -> Self {
        let ports = Ports::new(netlist);
        let functions = match top {
            Top::SharedUnits => shared_units(&ports, format),
            _ => vec![(Function::of(top, format, &ports), latency_cycles(top))],
        };
        let functions = functions.into_iter().map(|(function, latency)| {
            let empty = vec![Claim { output: function.valid_out, value: 0 }];
            (function, std::iter::repeat_n((empty, None), latency).collect())
        });
        Self { enable: ports.input("en_i"), functions: functions.collect() }
    }

    /// The claims about the outputs now, each with the inputs of its operation.
    pub fn due(&self) -> impl Iterator<Item = (Claim, Option<&[u128]>)> {
        self.functions.iter().flat_map(|(_, line)| {
            let (claims, inputs) = &line[0];
            claims.iter().map(move |claim| (*claim, inputs.as_deref()))
        })
    }

    /// Applies a rising clock edge with these inputs, and calls `class` with the name of each class that they are in.
    /// Returns whether an operation went in.
    pub fn clock(&mut self, inputs: &[u128], mut class: impl FnMut(&'static str)) -> bool {
        if inputs[self.enable] == 0 {
            class("stall");
            return false;
        }
        let mut any = false;
        let origin: Arc<[u128]> = inputs.into();
        for (function, line) in &mut self.functions {
            let exists = function.mode.is_none_or(|(position, has)| has(inputs[position]));
            let valid = exists && inputs[function.valid] == 1;
            let mut claims = vec![Claim { output: function.valid_out, value: u128::from(valid) }];
            if valid {
                claims.push(Claim { output: function.tag[1], value: inputs[function.tag[0]] });
                function.operation.claim(inputs, &mut claims, &mut class);
            }
            any |= valid;
            line.pop_front();
            line.push_back((claims, Some(Arc::clone(&origin))));
        }
        if !any {
            class("bubble");
        }
        any
    }
}

/// Cycles from inputs to outputs.
fn latency_cycles(top: Top) -> usize {
    match top {
        Top::IntAdd | Top::FpMinMax | Top::FpCmp => 1,
        Top::FpAdd | Top::FpMul => 2,
        _ => PIPELINE_LATENCY_CYCLES,
    }
}

impl Function {
    fn of(top: Top, format: StandardFormat, ports: &Ports) -> Self {
        let arithmetic = Arithmetic::new(format.format());
        let (input, output) = (|name: &str| ports.input(name), |name: &str| ports.output(name));
        let operands = || [input("a_i"), input("b_i")];
        let operation = match top {
            Top::IntAdd => Operation::IntAdd { operands: operands(), sum: output("sum_o") },
            Top::FpAdd => Operation::FpAdd {
                arithmetic,
                operands: operands(),
                subtract: input("subtract_i"),
                rounding: Some(input("rounding_i")),
                result: output("result_o"),
            },
            Top::FpMul => Operation::FpMul {
                arithmetic,
                operands: operands(),
                rounding: Some(input("rounding_i")),
                result: output("result_o"),
            },
            Top::FpMinMax => Operation::FpMinMax {
                arithmetic,
                operands: operands(),
                maximum: input("maximum_i"),
                propagate: input("propagate_nan_i"),
                result: output("result_o"),
            },
            Top::FpCmp => Operation::FpCmp {
                arithmetic,
                operands: operands(),
                lt_le_eq: ["lt_o", "le_o", "eq_o"].map(output),
            },
            _ => {
                assert_eq!(format, StandardFormat::Binary32, "golden traverses in binary32");
                pipeline(top, ports)
            }
        };
        Self {
            valid: input("valid_i"),
            valid_out: output("valid_o"),
            tag: [input("tag_i"), output("tag_o")],
            mode: None,
            operation,
        }
    }
}

fn pipeline(top: Top, ports: &Ports) -> Operation {
    let lane = |lane: Option<usize>| {
        let suffix = lane.map(|lane| format!("${lane}")).unwrap_or_default();
        let outputs = ["hit_o", "t_entry_o"].map(|name| ports.output(&format!("{name}{suffix}")));
        (ports.bounds(lane), outputs)
    };
    let lanes = |count: usize| (0..count).map(|i| lane(Some(i))).collect();
    match top {
        Top::RayBoxX2 => Operation::RayBox { lanes: lanes(2) },
        Top::RayBoxX4 => Operation::RayBox { lanes: lanes(4) },
        Top::RayBoxX8 => Operation::RayBox { lanes: lanes(8) },
        Top::RayBox | Top::RayBoxLean => Operation::RayBox { lanes: vec![lane(None)] },
        _ => {
            let slot = |which: &str| {
                ["offset", "t_min", "t_max"].map(|what| ports.output(&format!("{which}_{what}_o")))
            };
            let (near, far) = (slot("near"), slot("far"));
            Operation::DualSplit { node: ports.node(), code: ports.output("code_o"), near, far }
        }
    }
}

/// The threads' units and the two pipelines of the shared block, with their latencies in cycles.
fn shared_units(ports: &Ports, format: StandardFormat) -> Vec<(Function, usize)> {
    assert_eq!(format, StandardFormat::Binary32, "golden traverses in binary32");
    let arithmetic = Arithmetic::new(format.format());
    let mode = ports.input("mode_i");
    let mut functions = Vec::new();
    for (top, valid_out, has) in [
        (Top::DualSplit, "node_valid_o", (|mode| mode == DUAL_SPLIT_MODE) as HasMode),
        (Top::RayBox, "box_valid_o", |mode| mode == RAY_BOX_MODE),
    ] {
        let function = Function {
            valid: ports.input("valid_i"),
            valid_out: ports.output(valid_out),
            tag: [ports.input("tag_i"), ports.output("tag_o")],
            mode: Some((mode, has)),
            operation: pipeline(top, ports),
        };
        functions.push((function, PIPELINE_LATENCY_CYCLES));
    }
    for i in 0..SHARED_UNITS {
        let has: HasMode = match i {
            0 | 1 => |mode| mode != RAY_BOX_MODE && mode != DUAL_SPLIT_MODE,
            2..6 => |mode| mode != RAY_BOX_MODE,
            _ => |_| true,
        };
        for unit in ["add", "mul"] {
            let input = |name: &str| ports.input(&format!("{unit}_{name}_i${i}"));
            let output = |name: &str| ports.output(&format!("{unit}_{name}_o${i}"));
            let (operands, result) = ([input("a"), input("b")], output("result"));
            let (operation, top) = match unit {
                "add" => {
                    let subtract = input("subtract");
                    (Operation::FpAdd { arithmetic, operands, subtract, rounding: None, result }, Top::FpAdd)
                }
                _ => (Operation::FpMul { arithmetic, operands, rounding: None, result }, Top::FpMul),
            };
            let function = Function {
                valid: input("valid"),
                valid_out: output("valid"),
                tag: [input("tag"), output("tag")],
                mode: Some((mode, has)),
                operation,
            };
            functions.push((function, latency_cycles(top)));
        }
    }
    functions
}

/// The direction of a code; the reserved ones round toward zero.
fn rounding(inputs: &[u128], position: Option<usize>) -> Rounding {
    let code = position.map_or(0, |position| inputs[position]);
    Rounding::ALL.into_iter().find(|each| *each as u128 == code).unwrap_or(Rounding::TowardZero)
}

impl Operation {
    fn claim(&self, inputs: &[u128], claims: &mut Vec<Claim>, mut class: impl FnMut(&'static str)) {
        let pair = |positions: &[usize; 2]| positions.map(|position| inputs[position] as u32);
        let mut add = |output: usize, value: u32| claims.push(Claim { output, value: u128::from(value) });
        match self {
            Self::IntAdd { operands, sum } => {
                let [a, b] = pair(operands);
                let (value, carry) = a.overflowing_add(b);
                class(if carry { "carry out" } else { "no carry out" });
                add(*sum, value);
            }
            Self::FpAdd { arithmetic, operands, subtract, rounding: direction, result } => {
                let [a, b] = pair(operands);
                let value = arithmetic.fp_add(a, b, inputs[*subtract] == 1, rounding(inputs, *direction));
                classes::operands(arithmetic.format, [a, b], &mut class);
                class(classes::result(arithmetic.format, value));
                add(*result, value);
            }
            Self::FpMul { arithmetic, operands, rounding: direction, result } => {
                let [a, b] = pair(operands);
                let value = arithmetic.fp_mul(a, b, rounding(inputs, *direction));
                classes::operands(arithmetic.format, [a, b], &mut class);
                class(classes::result(arithmetic.format, value));
                add(*result, value);
            }
            Self::FpMinMax { arithmetic, operands, maximum, propagate, result } => {
                let [a, b] = pair(operands);
                let nan_mode = if inputs[*propagate] == 1 { NanMode::Propagate } else { NanMode::Number };
                classes::operands(arithmetic.format, [a, b], &mut class);
                add(*result, arithmetic.fp_min_max(a, b, inputs[*maximum] == 1, nan_mode));
            }
            Self::FpCmp { arithmetic, operands, lt_le_eq } => {
                let [a, b] = pair(operands);
                let expected = arithmetic.fp_cmp(a, b);
                classes::operands(arithmetic.format, [a, b], &mut class);
                for (output, value) in lt_le_eq.iter().zip([expected.lt, expected.le, expected.eq]) {
                    add(*output, u32::from(value));
                }
            }
            Self::DualSplit { node, code, near, far } => {
                let case: NodeCase = node.read(inputs);
                let (value, near_slot, far_slot) = case.golden();
                classes::node(&case, value, &mut class);
                add(*code, u32::from(value));
                for (outputs, slot) in [(near, near_slot), (far, far_slot)] {
                    if let Some((offset, t_min, t_max)) = slot {
                        outputs
                            .iter()
                            .zip([offset, t_min, t_max])
                            .for_each(|(output, value)| add(*output, value));
                    }
                }
            }
            Self::RayBox { lanes } => {
                for (ports, [hit_out, entry_out]) in lanes {
                    let case: BoxCase = ports.read(inputs);
                    let (hit, entry) = case.golden();
                    classes::bounds(&case, hit, &mut class);
                    add(*hit_out, u32::from(hit));
                    if let Some(entry) = entry {
                        add(*entry_out, entry);
                    }
                }
            }
        }
    }
}
