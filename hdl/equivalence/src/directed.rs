//! Cycles aimed at what random ones meet late: ties, the borders of the subnormal and finite ranges, every header of a node,
//! boxes that are touched.

use super::cases::{BoxCase, NodeCase, RayWords};
use super::ports::Ports;
use super::stimulus::{DRAIN_CYCLES, special};
use fp::{Arithmetic, Format, Rounding};
use golden::dst::header::{HEADER, OFFSET};
use netlist::{Flat, mask};
use pipelines::catalogue::{StandardFormat, Top};

/// Codes of `rounding_i`, the reserved ones included.
const ROUNDING_CODES: u32 = 8;

/// The directed cycles of `top` in `format`, in `netlist`'s order of ports: an operation in each, without stalls.
#[must_use]
pub fn directed(top: Top, format: StandardFormat, netlist: &Flat) -> Vec<Vec<u128>> {
    let cycles = Cycles { netlist, ports: Ports::new(netlist), format: format.format() };
    match top {
        Top::IntAdd => cycles.int_add(),
        Top::FpAdd => cycles.arithmetic(&sums(cycles.format)),
        Top::FpMul => cycles.arithmetic(&products(cycles.format)),
        Top::FpMinMax | Top::FpCmp => cycles.ordered(),
        Top::DualSplit | Top::DualSplitLean => cycles.nodes(),
        Top::RayBox | Top::RayBoxLean | Top::RayBoxX2 | Top::RayBoxX4 | Top::RayBoxX8 => cycles.boxes(),
        Top::SharedUnits => cycles.shared_units(),
    }
}

/// Pairs whose sum or difference is a tie, next to one, at a border, or exact zero.
fn sums(format: Format) -> Vec<[u32; 2]> {
    let one = (format.bias() as u32) << format.fraction_bits();
    // Half a unit in the last place of a power of two whose exponent code is large enough.
    let half_unit = |power: u32| power - (format.significand_bits() << format.fraction_bits());
    let largest_power = format.infinity() - (1 << format.fraction_bits());
    let (half, least, max) = (half_unit(one), format.min_normal(), format.max_finite());
    vec![
        [one, half],
        [one + 1, half],
        [one + 2, half],
        [one, half - 1],
        [one, half + 1],
        [one + 1, half - 1],
        [one, 1],
        [one, one],
        [one + 1, one],
        [least - 1, 1],
        [least, 1],
        [least + 1, least],
        [least - 1, least - 1],
        [max, half_unit(largest_power)],
        [max, half_unit(largest_power) - 1],
        [max, 1],
        [max, max],
    ]
}

/// Pairs whose product is a tie, next to one, or at a border.
fn products(format: Format) -> Vec<[u32; 2]> {
    let unit = 1 << format.fraction_bits();
    let one = (format.bias() as u32) * unit;
    let (half, three_halves, two) = (one - unit, one + unit / 2, one + unit);
    let (least, max) = (format.min_normal(), format.max_finite());
    vec![
        [one + 1, three_halves],
        [one + 3, three_halves],
        [one + 5, three_halves],
        [one + 1, one + 1],
        [two - 1, two - 1],
        [two - 1, one + 1],
        [1, half],
        [3, half],
        [least, half],
        [least + 1, half],
        [least + 3, half],
        [2 * least - 1, half],
        [least + unit - 1, half],
        [least - 1, one + 1],
        [least - 1, two],
        [1, 1],
        [least, least],
        [max, one + 1],
        [max, two],
        [max, one],
    ]
}

struct Cycles<'n> {
    netlist: &'n Flat,
    ports: Ports<'n>,
    format: Format,
}

impl Cycles<'_> {
    /// Inputs of an operation with the given values; all other inputs are zero, and the tag alternates.
    fn cycle(&self, position: usize, values: &[(&str, u128)]) -> Vec<u128> {
        let mut inputs = vec![0; self.netlist.inputs.len()];
        let mut set = |name: &str, value: u128| {
            if let Some(input) = self.netlist.input(name) {
                inputs[input] = value & mask(self.netlist.inputs[input].width);
            }
        };
        set("en_i", 1);
        set("valid_i", 1);
        set("tag_i", position as u128);
        values.iter().for_each(|(name, value)| set(name, *value));
        inputs
    }

    fn int_add(&self) -> Vec<Vec<u128>> {
        let bits: Vec<u128> = (0..32).map(|bit| 1 << bit).chain([0, u128::from(u32::MAX)]).collect();
        let pairs =
            bits.iter().flat_map(|&a| [(a, a), (a, 1), (u128::from(u32::MAX), a), (a - a % 2, 0x5555_5555)]);
        pairs.enumerate().map(|(i, (a, b))| self.cycle(i, &[("a_i", a), ("b_i", b)])).collect()
    }

    /// All pairs of special values, and the given ones in every rounding direction and sign.
    fn arithmetic(&self, pairs: &[[u32; 2]]) -> Vec<Vec<u128>> {
        let special = special(self.format);
        let all = special.iter().flat_map(|&a| special.iter().map(move |&b| [a, b])).enumerate();
        let all = all.map(|(i, pair)| (pair, i as u32 / 3, i as u32 % ROUNDING_CODES));
        let aimed = (0..ROUNDING_CODES).flat_map(|rounding| {
            let signs = (0..4).flat_map(move |signs| pairs.iter().map(move |&pair| (pair, signs)));
            signs.map(move |([a, b], signs)| {
                let sign = |word: u32, bit: u32| {
                    if signs >> bit & 1 == 1 { word | self.format.sign_bit() } else { word }
                };
                ([sign(a, 0), sign(b, 1)], 0, rounding)
            })
        });
        (all.chain(aimed).enumerate())
            .map(|(i, ([a, b], subtract, rounding))| {
                let values = [("a_i", a), ("b_i", b), ("subtract_i", subtract), ("rounding_i", rounding)];
                self.cycle(i, &values.map(|(name, value)| (name, u128::from(value))))
            })
            .collect()
    }

    /// Special values and their neighbours, with both choices of minimum or maximum and both treatments of NaN.
    fn ordered(&self) -> Vec<Vec<u128>> {
        let mut words = special(self.format);
        let one = (self.format.bias() as u32) << self.format.fraction_bits();
        words.extend([one + 1, (one + 1) | self.format.sign_bit(), self.format.infinity() + 1]);
        let pairs: Vec<[u32; 2]> = words.iter().flat_map(|&a| words.iter().map(move |&b| [a, b])).collect();
        let choices = (0..4).flat_map(|choice: u128| pairs.iter().map(move |&pair| (pair, choice)));
        (choices.enumerate())
            .map(|(i, ([a, b], choice))| {
                let (maximum, propagate) = (choice & 1, choice >> 1);
                let values = [
                    ("a_i", u128::from(a)),
                    ("b_i", u128::from(b)),
                    ("maximum_i", maximum),
                    ("propagate_nan_i", propagate),
                ];
                self.cycle(i, &values)
            })
            .collect()
    }

    fn word(&self, x: f32) -> u32 {
        Arithmetic::new(self.format).from_f32(x, Rounding::NearestEven)
    }

    /// A ray from the origin; its reciprocals are powers of two.
    fn ray(&self, direction: [f32; 3], t_min: f32, t_max: f32) -> RayWords {
        let inverse = direction.map(|d| self.word(1.0 / d));
        let [t_min, t_max] = [t_min, t_max].map(|t| self.word(t));
        RayWords { origin: [0; 3], inv_entry: inverse, inv_exit: inverse, t_min, t_max }
    }

    /// Every value of the header's upper bits, with planes before, inside, at the ends of and behind the interval, met upwards and
    /// downwards.
    fn nodes(&self) -> Vec<Vec<u128>> {
        let offsets = [OFFSET.mask(), 0x155_5555, 0x2aa_aaaa, 1];
        let planes = [[4.0, 2.0], [2.0, 4.0], [8.0, 1.0], [0.5, 64.0], [64.0, 0.5], [f32::NAN, 4.0]];
        let rays = [([1.0, 1.0, 2.0], 8.0), ([-1.0, -1.0, -2.0], 8.0), ([1.0, -2.0, 0.0], 1.0)];
        let ports = self.ports.node();
        let mut cycles = Vec::new();
        for code in 0..=HEADER.mask() {
            for (direction, t_max) in rays {
                for [plane_0, plane_1] in planes {
                    let header = code << HEADER.low | offsets[cycles.len() % offsets.len()];
                    // Downwards, the planes are met at the same distances with their signs changed.
                    let plane = |plane: f32| self.word(plane * direction[0]);
                    let words = [header, plane(plane_0), plane(plane_1)];
                    let mut inputs = self.cycle(cycles.len(), &[("mode_i", 2)]);
                    ports.drive(&mut inputs, &NodeCase { words, ray: self.ray(direction, 1.0, t_max) });
                    cycles.push(inputs);
                }
            }
        }
        cycles
    }

    /// Boxes before every octant, hit in the middle, at a corner, at an end of the interval and not at all; rays along an axis inside,
    /// outside and on a face.
    fn boxes(&self) -> Vec<Vec<u128>> {
        let mut cases = Vec::new();
        for octant in 0..8 {
            let sign = |axis: usize| if octant >> axis & 1 == 1 { -1.0f32 } else { 1.0 };
            let corners: [[[f32; 2]; 3]; 5] = [
                [[1.0, 4.0]; 3],
                [[1.0, 2.0], [2.0, 4.0], [1.0, 4.0]],
                [[1.0, 2.0], [3.0, 4.0], [1.0, 4.0]],
                [[8.0, 16.0]; 3],
                [[0.5, 1.0]; 3],
            ];
            for corner in corners {
                let bounds: [[f32; 2]; 3] = std::array::from_fn(|axis| match sign(axis) {
                    s if s < 0.0 => [-corner[axis][1], -corner[axis][0]],
                    _ => corner[axis],
                });
                cases.push((bounds, [sign(0), sign(1), sign(2)], [1.0, 8.0]));
            }
        }
        for (along, zero) in [(0, 0.0), (1, -0.0), (2, 0.0)] {
            for sides in [[-1.0, 1.0], [1.0, 2.0], [0.0, 1.0], [-1.0, 0.0], [f32::NAN, 1.0]] {
                let bounds = std::array::from_fn(|axis| if axis == along { [1.0, 2.0] } else { sides });
                let direction = std::array::from_fn(|axis| if axis == along { 1.0 } else { zero });
                cases.push((bounds, direction, [0.0, 8.0]));
            }
        }
        let lanes =
            (0..8).filter(|lane| self.netlist.input(&format!("box_min_x_i${lane}")).is_some()).count();
        (0..cases.len())
            .map(|i| {
                let mut inputs = self.cycle(i, &[("mode_i", 1)]);
                let (_, direction, [t_min, t_max]) = cases[i];
                let ray = self.ray(direction, t_min, t_max);
                for lane in 0..lanes.max(1) {
                    let (bounds, ..) = cases[(i + 7 * lane) % cases.len()];
                    let planes = std::array::from_fn(|plane| self.word(bounds[plane % 3][plane / 3]));
                    let ports = self.ports.bounds((lanes > 0).then_some(lane));
                    ports.drive(&mut inputs, &BoxCase { planes, ray });
                }
                inputs
            })
            .collect()
    }

    /// The threads' units one after the other, then each pipeline; empty cycles before the routing changes.
    fn shared_units(&self) -> Vec<Vec<u128>> {
        let mut cycles = Vec::new();
        for (unit, pairs) in [("add", sums(self.format)), ("mul", products(self.format))] {
            for (i, [a, b]) in pairs.into_iter().enumerate() {
                let lane = i % 8;
                let named = [("valid", 1), ("a", a), ("b", b), ("tag", 1)];
                let named = named.map(|(name, value)| (format!("{unit}_{name}_i${lane}"), u128::from(value)));
                let mut values: Vec<(&str, u128)> =
                    named.iter().map(|(name, value)| (&**name, *value)).collect();
                values.push(("valid_i", 0));
                cycles.push(self.cycle(i, &values));
            }
        }
        let drain = |mode: u128| {
            (0..DRAIN_CYCLES).map(move |i| self.cycle(i as usize, &[("valid_i", 0), ("mode_i", mode)]))
        };
        let parts =
            [cycles, drain(0).collect(), self.boxes(), drain(1).collect(), self.nodes(), drain(2).collect()];
        parts.concat()
    }
}
