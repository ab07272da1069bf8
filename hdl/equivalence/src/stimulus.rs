//! Streams of inputs from a seed: operations of every class, back to back, with bubbles and stalls.

use super::cases::{Cases, NodeCase};
use super::directed::directed;
use super::ports::{BoxPorts, NodePorts, Ports};
use fp::Format;
use fp::operands::Operands;
use netlist::{Flat, mask};
use pipelines::catalogue::{StandardFormat, Top};

/// Cycles between changes of the shared block's routing.
const MODE_CYCLES: u64 = 64;
/// Enabled cycles without an operation before a change, which empty the pipelines.
pub(crate) const DRAIN_CYCLES: u64 = 8;

/// What an exported testbench runs: the directed cycles of `top`, then `count` cycles of the stream of `seed`, with every value below
/// 2^width.
#[must_use]
pub fn testbench(top: Top, format: StandardFormat, netlist: &Flat, count: u32, seed: u64) -> Vec<Vec<u128>> {
    let mut cycles = directed(top, format, netlist);
    cycles.extend(Stimulus::new(top, format, netlist, seed).take(count as usize));
    for inputs in &mut cycles {
        inputs.iter_mut().zip(&netlist.inputs).for_each(|(value, port)| *value &= mask(port.width));
    }
    cycles
}

/// The endless stream of a seed. Each item gives the values of all inputs in one cycle.
#[derive(Clone, Debug)]
pub struct Stimulus {
    widths: Vec<u32>,
    enable: usize,
    /// The inputs that say that an operation is valid.
    valid: Vec<usize>,
    operands: Vec<[usize; 2]>,
    node: Option<NodePorts>,
    boxes: Vec<BoxPorts>,
    mode: Option<(usize, u128)>,
    /// One value of each class, of either sign.
    special: Vec<u32>,
    stream: Operands,
    cases: Cases,
    /// Nodes to take first, in reverse order.
    nodes: Vec<NodeCase>,
    cycle: u64,
}

impl Stimulus {
    /// The stream of `seed` for `top` in `format`, in `netlist`'s order of ports.
    #[must_use]
    pub fn new(top: Top, format: StandardFormat, netlist: &Flat, seed: u64) -> Self {
        let ports = Ports::new(netlist);
        let named = |part: &str| {
            let inputs = netlist.inputs.iter().enumerate();
            inputs
                .filter(|(_, port)| port.name.contains(part))
                .map(|(position, _)| position)
                .collect::<Vec<_>>()
        };
        let operands = named("a_i").into_iter().zip(named("b_i")).map(|(a, b)| [a, b]);
        let boxes = match top {
            Top::RayBox | Top::RayBoxLean | Top::SharedUnits => vec![ports.bounds(None)],
            Top::RayBoxX2 => (0..2).map(|lane| ports.bounds(Some(lane))).collect(),
            Top::RayBoxX4 => (0..4).map(|lane| ports.bounds(Some(lane))).collect(),
            Top::RayBoxX8 => (0..8).map(|lane| ports.bounds(Some(lane))).collect(),
            _ => Vec::new(),
        };
        let has_node = matches!(top, Top::DualSplit | Top::DualSplitLean | Top::SharedUnits);
        Self {
            widths: netlist.inputs.iter().map(|port| port.width).collect(),
            enable: ports.input("en_i"),
            valid: named("valid_i"),
            operands: if top == Top::IntAdd { Vec::new() } else { operands.collect() },
            node: has_node.then(|| ports.node()),
            boxes,
            mode: netlist.input("mode_i").map(|position| (position, 0)),
            special: special(format.format()),
            stream: Operands::new(format.format(), seed),
            cases: Cases::new(seed ^ 0x5eed),
            nodes: Vec::new(),
            cycle: 0,
        }
    }

    /// The stream with `nodes` as its first nodes, in order.
    #[must_use]
    pub fn with_nodes(mut self, mut nodes: Vec<NodeCase>) -> Self {
        nodes.reverse();
        self.nodes = nodes;
        self
    }

    /// Whether all nodes given have been sent.
    #[must_use]
    pub fn is_past_nodes(&self) -> bool {
        self.nodes.is_empty()
    }
}

/// Zero, the ends of the subnormal and normal ranges, one, infinity and NaN, of either sign.
pub(crate) fn special(format: Format) -> Vec<u32> {
    let one = (format.bias() as u32) << format.fraction_bits();
    let min_normal = format.min_normal();
    let magnitudes = [
        0,
        1,
        min_normal - 1,
        min_normal,
        one,
        format.max_finite(),
        format.infinity(),
        format.canonical_nan(),
    ];
    magnitudes.into_iter().flat_map(|magnitude| [magnitude, magnitude | format.sign_bit()]).collect()
}

impl Iterator for Stimulus {
    type Item = Vec<u128>;

    fn next(&mut self) -> Option<Vec<u128>> {
        // Every input that the code below does not set has random bits.
        let stream = &mut self.stream;
        let mut inputs: Vec<u128> =
            self.widths.iter().map(|&width| u128::from(stream.bits()) & mask(width)).collect();
        let (bits, position) = (stream.bits(), self.cycle % MODE_CYCLES);
        let drains = self.mode.is_some() && position >= MODE_CYCLES - DRAIN_CYCLES;
        let enable = drains || bits & 7 != 0;
        inputs[self.enable] = u128::from(enable);
        for (i, &valid) in self.valid.iter().enumerate() {
            inputs[valid] = u128::from(!drains && bits >> (8 + 3 * i.min(16)) & 7 != 0);
        }
        if let Some((input, mode)) = &mut self.mode {
            if position == 0 {
                *mode = u128::from(bits >> 60 & 3);
            }
            inputs[*input] = *mode;
        }
        for &[a, b] in &self.operands {
            // Random pairs hardly ever combine two classes that have a rule of their own, such as infinity and zero.
            let choice = stream.bits();
            let (x, y) = if choice & 7 == 0 {
                let draw = |shift: u32| self.special[(choice >> shift) as usize % self.special.len()];
                (draw(8), draw(36))
            } else {
                stream.pair()
            };
            (inputs[a], inputs[b]) = (x.into(), y.into());
        }
        for (lane, ports) in self.boxes.iter().enumerate() {
            let case = self.cases.bounds();
            let shared = if lane == 0 { case.ray } else { self.boxes[0].read(&inputs).ray };
            ports.drive(&mut inputs, &super::cases::BoxCase { ray: shared, ..case });
        }
        // The shared block's ray belongs to the pipeline that is routed.
        let boxed = !self.boxes.is_empty() && self.cases.bits() & 1 == 0;
        if let Some(ports) = self.node.filter(|_| !boxed || !self.nodes.is_empty()) {
            let accepted = enable && inputs[self.valid[self.valid.len() - 1]] == 1;
            let case = match self.nodes.last().copied() {
                Some(case) => {
                    if accepted {
                        self.nodes.pop();
                    }
                    case
                }
                None => self.cases.node(),
            };
            ports.drive(&mut inputs, &case);
        }
        self.cycle += 1;
        Some(inputs)
    }
}
