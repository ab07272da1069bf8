//! The inputs that each top is given, and the outputs that it must show.

use super::oracle::Oracle;
use equivalence::Ports;
use equivalence::cases::{Cases, RayWords};
use fp::operands::Operands;
use fp::{Format, NanMode, Rounding};
use golden::bvh::box_step;
use golden::dst::{Child, Code, step};
use golden::{Aabb, Mode, Ray, TraversalRay};
use netlist::Engine;
use netlist::Flat;
use pipelines::catalogue::{StandardFormat, Top};

/// Outputs that an operation may make claims about: those of eight ray-box pipelines.
const MAX_CLAIMS: usize = 16;

/// The values that claimed outputs must show, in the order of [`Operation::outputs`]. The other values mean nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Claims {
    /// A bit for each output that is claimed.
    pub claimed: u16,
    pub values: [u32; MAX_CLAIMS],
}

impl Claims {
    fn add(&mut self, output: usize, value: u32) {
        self.claimed |= 1 << output;
        self.values[output] = value;
    }
}

/// A top with a stream of operations for it.
pub struct Operation {
    /// Positions of the outputs that claims are about.
    pub outputs: Vec<usize>,
    /// Cycles from inputs to outputs.
    pub latency_cycles: usize,
    format: Format,
    kind: Kind,
    operands: Operands,
    cases: Cases,
}

enum Kind {
    IntAdd { operands: [usize; 2] },
    FpAdd { oracle: Oracle, operands: [usize; 2], subtract: usize, rounding: usize },
    FpMul { oracle: Oracle, operands: [usize; 2], rounding: usize },
    FpMinMax { oracle: Oracle, operands: [usize; 2], maximum: usize, propagate: usize },
    FpCmp { oracle: Oracle, operands: [usize; 2] },
    DualSplit { words: [usize; 3], ray: RayPorts, prepared: TraversalRay },
    RayBox { lanes: Vec<[usize; 6]>, ray: RayPorts, prepared: TraversalRay },
}

struct RayPorts {
    vectors: [[usize; 3]; 3],
    interval: [usize; 2],
}

impl Operation {
    /// The stream of `seed` for `top` in `format`, for `netlist`'s order of ports; none for tops that are not compared here.
    pub fn new(top: Top, format: StandardFormat, netlist: &Flat, seed: u64) -> Option<Self> {
        let ports = Ports::new(netlist);
        let (input, output) = (|name: &str| ports.input(name), |name: &str| ports.output(name));
        let outputs = |names: &[&str]| names.iter().map(|name| output(name)).collect::<Vec<_>>();
        let operands = || ["a_i", "b_i"].map(input);
        let oracle = || Oracle::new(format.format());
        let prepared = TraversalRay::new(&Ray::new([0.0; 3], [1.0; 3]), Mode::Fast)?;
        let ray = || {
            let axes = |what: &str| ["x", "y", "z"].map(|axis| input(&format!("{what}_{axis}_i")));
            let vectors = ["origin", "inv_entry", "inv_exit"].map(axes);
            RayPorts { vectors, interval: ["t_min_i", "t_max_i"].map(input) }
        };
        let (kind, outputs, latency_cycles) = match top {
            Top::IntAdd => (Kind::IntAdd { operands: operands() }, outputs(&["sum_o"]), 1),
            Top::FpAdd => {
                let (subtract, rounding) = (input("subtract_i"), input("rounding_i"));
                let kind = Kind::FpAdd { oracle: oracle(), operands: operands(), subtract, rounding };
                (kind, outputs(&["result_o"]), 2)
            }
            Top::FpMul => {
                let rounding = input("rounding_i");
                (Kind::FpMul { oracle: oracle(), operands: operands(), rounding }, outputs(&["result_o"]), 2)
            }
            Top::FpMinMax => {
                let (maximum, propagate) = (input("maximum_i"), input("propagate_nan_i"));
                let kind = Kind::FpMinMax { oracle: oracle(), operands: operands(), maximum, propagate };
                (kind, outputs(&["result_o"]), 1)
            }
            Top::FpCmp => (
                Kind::FpCmp { oracle: oracle(), operands: operands() },
                outputs(&["lt_o", "le_o", "eq_o"]),
                1,
            ),
            // Golden traverses in binary32.
            _ if format != StandardFormat::Binary32 => return None,
            Top::DualSplit | Top::DualSplitLean => {
                let words = ["header_i", "plane_0_i", "plane_1_i"].map(input);
                let names = [
                    "code_o",
                    "near_offset_o",
                    "near_t_min_o",
                    "near_t_max_o",
                    "far_offset_o",
                    "far_t_min_o",
                    "far_t_max_o",
                ];
                (Kind::DualSplit { words, ray: ray(), prepared }, outputs(&names), 8)
            }
            Top::SharedUnits => return None,
            Top::RayBox | Top::RayBoxLean | Top::RayBoxX2 | Top::RayBoxX4 | Top::RayBoxX8 => {
                let suffixes: Vec<String> = match top {
                    Top::RayBoxX2 => (0..2).map(|lane| format!("${lane}")).collect(),
                    Top::RayBoxX4 => (0..4).map(|lane| format!("${lane}")).collect(),
                    Top::RayBoxX8 => (0..8).map(|lane| format!("${lane}")).collect(),
                    _ => vec![String::new()],
                };
                let planes = |suffix: &String| {
                    std::array::from_fn(|i| {
                        let (side, axis) = (["min", "max"][i / 3], ["x", "y", "z"][i % 3]);
                        input(&format!("box_{side}_{axis}_i{suffix}"))
                    })
                };
                let lanes = suffixes.iter().map(planes).collect();
                let shown = |suffix: &String| {
                    [output(&format!("hit_o{suffix}")), output(&format!("t_entry_o{suffix}"))]
                };
                let outputs = suffixes.iter().flat_map(shown).collect();
                (Kind::RayBox { lanes, ray: ray(), prepared }, outputs, 8)
            }
        };
        let operands = Operands::new(format.format(), seed);
        Some(Self {
            format: format.format(),
            outputs,
            latency_cycles,
            kind,
            operands,
            cases: Cases::new(seed ^ 0x5eed),
        })
    }

    /// 64 uniform bits.
    pub fn bits(&mut self) -> u64 {
        self.operands.bits()
    }

    /// Drives the next operation in one lane, and returns the claims about its outputs.
    pub fn drive(&mut self, engine: &mut impl Engine, lane: usize) -> Claims {
        let mut claims = Claims::default();
        let Self { format, kind, operands: stream, cases, .. } = self;
        let bits = stream.bits();
        match kind {
            Kind::IntAdd { operands } => {
                let pair = (bits as u32, stream.bits() as u32);
                put_pair(engine, lane, *operands, pair);
                claims.add(0, pair.0.wrapping_add(pair.1));
            }
            Kind::FpAdd { oracle, operands, subtract, rounding } => {
                let (a, b) = pair(*format, stream, bits);
                put_pair(engine, lane, *operands, (a, b));
                let (minus, code) = (bits >> 60 & 1 == 1, bits >> 61);
                put(engine, lane, *subtract, minus.into());
                put(engine, lane, *rounding, code as u32);
                claims.add(0, oracle.add(a, b, minus, direction(code)));
            }
            Kind::FpMul { oracle, operands, rounding } => {
                let (a, b) = pair(*format, stream, bits);
                put_pair(engine, lane, *operands, (a, b));
                let code = bits >> 61;
                put(engine, lane, *rounding, code as u32);
                claims.add(0, oracle.mul(a, b, direction(code)));
            }
            Kind::FpMinMax { oracle, operands, maximum, propagate } => {
                let (a, b) = pair(*format, stream, bits);
                put_pair(engine, lane, *operands, (a, b));
                let (greater, propagates) = (bits >> 60 & 1 == 1, bits >> 61 & 1 == 1);
                put(engine, lane, *maximum, greater.into());
                put(engine, lane, *propagate, propagates.into());
                let mode = if propagates { NanMode::Propagate } else { NanMode::Number };
                claims.add(0, oracle.min_max(a, b, greater, mode));
            }
            Kind::FpCmp { oracle, operands } => {
                let (a, b) = pair(*format, stream, bits);
                put_pair(engine, lane, *operands, (a, b));
                let expected = oracle.compare(a, b);
                [expected.lt, expected.le, expected.eq]
                    .into_iter()
                    .enumerate()
                    .for_each(|(output, value)| claims.add(output, value.into()));
            }
            Kind::DualSplit { words, ray, prepared } => {
                let case = cases.node();
                words.iter().zip(case.words).for_each(|(input, word)| put(engine, lane, *input, word));
                let [t_min, t_max] = ray.put(engine, lane, &case.ray, prepared);
                let outcome = step(case.words, prepared, t_min, t_max);
                claims.add(0, outcome.code as u32);
                let mut slot = |first: usize, child: Child| {
                    claims.add(first, child.offset);
                    claims.add(first + 1, child.t_min.to_bits());
                    claims.add(first + 2, child.t_max.to_bits());
                };
                if outcome.code != Code::Miss {
                    slot(1, outcome.near);
                }
                if outcome.code == Code::Two {
                    slot(4, outcome.far);
                }
            }
            Kind::RayBox { lanes, ray, prepared } => {
                let mut case = cases.bounds();
                let [t_min, t_max] = ray.put(engine, lane, &case.ray, prepared);
                for (position, inputs) in lanes.iter().enumerate() {
                    if position > 0 {
                        case = cases.bounds();
                    }
                    inputs
                        .iter()
                        .zip(case.planes)
                        .for_each(|(input, plane)| put(engine, lane, *input, plane));
                    let plane = |i: usize| f32::from_bits(case.planes[i]);
                    let (min, max) = ([plane(0), plane(1), plane(2)], [plane(3), plane(4), plane(5)]);
                    let outcome = box_step(&Aabb { min, max }, prepared, t_min, t_max);
                    claims.add(2 * position, outcome.hit.into());
                    if outcome.hit {
                        claims.add(2 * position + 1, outcome.t_entry.to_bits());
                    }
                }
            }
        }
        claims
    }
}

impl RayPorts {
    /// Drives a ray and prepares it for golden; returns its interval.
    fn put(
        &self,
        engine: &mut impl Engine,
        lane: usize,
        words: &RayWords,
        prepared: &mut TraversalRay,
    ) -> [f32; 2] {
        let vectors = [words.origin, words.inv_entry, words.inv_exit];
        for (inputs, vector) in self.vectors.iter().zip(vectors) {
            inputs.iter().zip(vector).for_each(|(input, word)| put(engine, lane, *input, word));
        }
        [prepared.origin, prepared.inv_entry, prepared.inv_exit] =
            vectors.map(|vector| vector.map(f32::from_bits));
        let interval = [words.t_min, words.t_max];
        self.interval.iter().zip(interval).for_each(|(input, word)| put(engine, lane, *input, word));
        interval.map(f32::from_bits)
    }
}

/// Two operands. In an eighth of all pairs both are special values; random pairs hardly ever are.
fn pair(format: Format, stream: &mut Operands, bits: u64) -> (u32, u32) {
    if bits & 7 != 0 {
        return stream.pair();
    }
    let one = (format.bias() as u32) << format.fraction_bits();
    let (least, infinity) = (format.min_normal(), format.infinity());
    let special = [0, 1, least - 1, least, one, format.max_finite(), infinity, format.canonical_nan()];
    let value = |bits: u64| special[bits as usize & 7] | if bits & 8 == 0 { 0 } else { format.sign_bit() };
    (value(bits >> 3), value(bits >> 7))
}

/// The direction of a rounding code; reserved ones round towards zero.
fn direction(code: u64) -> Rounding {
    Rounding::ALL.get(code as usize).copied().unwrap_or(Rounding::TowardZero)
}

fn put_pair(engine: &mut impl Engine, lane: usize, inputs: [usize; 2], (a, b): (u32, u32)) {
    put(engine, lane, inputs[0], a);
    put(engine, lane, inputs[1], b);
}

fn put(engine: &mut impl Engine, lane: usize, input: usize, value: u32) {
    engine.set_input(input, lane, value.into());
}
