//! Positions of a top's ports by what they carry.

use super::cases::{BoxCase, NodeCase, RayWords};
use netlist::Flat;

/// Positions of the inputs, and of the outputs, of one netlist.
#[derive(Clone, Debug)]
pub struct Ports<'n> {
    netlist: &'n Flat,
}

impl<'n> Ports<'n> {
    /// The ports of `netlist`.
    #[must_use]
    pub fn new(netlist: &'n Flat) -> Self {
        Self { netlist }
    }

    /// Position of the input `name`.
    ///
    /// # Panics
    /// If there is none.
    #[must_use]
    pub fn input(&self, name: &str) -> usize {
        self.netlist.input(name).unwrap_or_else(|| panic!("no input is called `{name}`"))
    }

    /// Position of the output `name`.
    ///
    /// # Panics
    /// If there is none.
    #[must_use]
    pub fn output(&self, name: &str) -> usize {
        self.netlist.output(name).unwrap_or_else(|| panic!("no output is called `{name}`"))
    }

    /// The inputs of the dual-split pipeline's node and ray.
    #[must_use]
    pub fn node(&self) -> NodePorts {
        let words = ["header_i", "plane_0_i", "plane_1_i"].map(|name| self.input(name));
        NodePorts { words, ray: self.ray() }
    }

    /// The inputs of a ray-box pipeline's box and ray; `lane` counts the boxes of a parallel form.
    #[must_use]
    pub fn bounds(&self, lane: Option<usize>) -> BoxPorts {
        let suffix = lane.map(|lane| format!("${lane}")).unwrap_or_default();
        let plane = |i: usize| {
            let (side, axis) = (["min", "max"][i / 3], ["x", "y", "z"][i % 3]);
            self.input(&format!("box_{side}_{axis}_i{suffix}"))
        };
        BoxPorts { planes: std::array::from_fn(plane), ray: self.ray() }
    }

    fn ray(&self) -> RayPorts {
        let axes = |what: &str| ["x", "y", "z"].map(|axis| self.input(&format!("{what}_{axis}_i")));
        RayPorts {
            origin: axes("origin"),
            inv_entry: axes("inv_entry"),
            inv_exit: axes("inv_exit"),
            t_min: self.input("t_min_i"),
            t_max: self.input("t_max_i"),
        }
    }
}

/// Positions of a ray's inputs.
#[derive(Clone, Copy, Debug)]
pub struct RayPorts {
    origin: [usize; 3],
    inv_entry: [usize; 3],
    inv_exit: [usize; 3],
    t_min: usize,
    t_max: usize,
}

/// Positions of a node's and its ray's inputs.
#[derive(Clone, Copy, Debug)]
pub struct NodePorts {
    words: [usize; 3],
    ray: RayPorts,
}

/// Positions of a box's and its ray's inputs.
#[derive(Clone, Copy, Debug)]
pub struct BoxPorts {
    planes: [usize; 6],
    ray: RayPorts,
}

fn get<const N: usize>(inputs: &[u128], positions: [usize; N]) -> [u32; N] {
    positions.map(|position| inputs[position] as u32)
}

fn set<const N: usize>(inputs: &mut [u128], positions: [usize; N], words: [u32; N]) {
    for (position, word) in positions.into_iter().zip(words) {
        inputs[position] = u128::from(word);
    }
}

impl RayPorts {
    fn read(&self, inputs: &[u128]) -> RayWords {
        RayWords {
            origin: get(inputs, self.origin),
            inv_entry: get(inputs, self.inv_entry),
            inv_exit: get(inputs, self.inv_exit),
            t_min: inputs[self.t_min] as u32,
            t_max: inputs[self.t_max] as u32,
        }
    }

    fn drive(&self, inputs: &mut [u128], ray: &RayWords) {
        set(inputs, self.origin, ray.origin);
        set(inputs, self.inv_entry, ray.inv_entry);
        set(inputs, self.inv_exit, ray.inv_exit);
        set(inputs, [self.t_min, self.t_max], [ray.t_min, ray.t_max]);
    }
}

impl NodePorts {
    /// The case in a cycle's inputs.
    #[must_use]
    pub fn read(&self, inputs: &[u128]) -> NodeCase {
        NodeCase { words: get(inputs, self.words), ray: self.ray.read(inputs) }
    }

    /// Puts a case into a cycle's inputs.
    pub fn drive(&self, inputs: &mut [u128], case: &NodeCase) {
        set(inputs, self.words, case.words);
        self.ray.drive(inputs, &case.ray);
    }
}

impl BoxPorts {
    /// The case in a cycle's inputs.
    #[must_use]
    pub fn read(&self, inputs: &[u128]) -> BoxCase {
        BoxCase { planes: get(inputs, self.planes), ray: self.ray.read(inputs) }
    }

    /// Puts a case into a cycle's inputs.
    pub fn drive(&self, inputs: &mut [u128], case: &BoxCase) {
        set(inputs, self.planes, case.planes);
        self.ray.drive(inputs, &case.ray);
    }
}
