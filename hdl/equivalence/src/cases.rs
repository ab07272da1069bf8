//! Nodes, boxes and rays for the pipelines, with golden's answers: from a seed, or from real traversals.

use fp::Format;
use fp::operands::Operands;
use golden::bvh::box_step;
use golden::dst::{Code, Dst, Step, step};
use golden::traverse::{NoObserver, closest_by_steps};
use golden::{Aabb, Mode, Ray, TraversalRay};

/// The ray's part of a pipeline's inputs, as bit patterns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayWords {
    /// Origin.
    pub origin: [u32; 3],
    /// Reciprocals of the direction for entry planes.
    pub inv_entry: [u32; 3],
    /// Reciprocals of the direction for exit planes.
    pub inv_exit: [u32; 3],
    /// Start of the interval.
    pub t_min: u32,
    /// End of the interval.
    pub t_max: u32,
}

/// The inputs of a dual-split pipeline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NodeCase {
    /// The node's three words.
    pub words: [u32; 3],
    /// The ray.
    pub ray: RayWords,
}

/// The inputs of a ray-box pipeline: planes min x, y, z, max x, y, z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoxCase {
    /// The planes.
    pub planes: [u32; 6],
    /// The ray.
    pub ray: RayWords,
}

/// A slot's offset and interval, as bit patterns.
pub type Slot = (u32, u32, u32);

/// The part of a step's outcome that means something: code, near slot, far slot.
pub type Outcome = (u8, Option<Slot>, Option<Slot>);

impl NodeCase {
    /// Golden's outcome for these inputs.
    #[must_use]
    pub fn golden(&self) -> Outcome {
        let ray = self.ray.traversal_ray();
        let Step { code, near, far } =
            step(self.words, &ray, f32::from_bits(self.ray.t_min), f32::from_bits(self.ray.t_max));
        let slot = |child: golden::dst::Child| (child.offset, child.t_min.to_bits(), child.t_max.to_bits());
        (code as u8, (code != Code::Miss).then(|| slot(near)), (code == Code::Two).then(|| slot(far)))
    }
}

impl BoxCase {
    /// The test of a box with the whole of a prepared ray.
    #[must_use]
    pub fn new(bounds: &Aabb, ray: &TraversalRay) -> Self {
        let corner = |i: usize| if i < 3 { bounds.min[i] } else { bounds.max[i - 3] };
        let planes = std::array::from_fn(|i| corner(i).to_bits());
        Self { planes, ray: RayWords::new(ray, ray.t_min, ray.t_max) }
    }

    /// Hit, and entry distance if so.
    #[must_use]
    pub fn golden(&self) -> (bool, Option<u32>) {
        let plane = |i: usize| f32::from_bits(self.planes[i]);
        let bounds = Aabb { min: [plane(0), plane(1), plane(2)], max: [plane(3), plane(4), plane(5)] };
        let (t_min, t_max) = (f32::from_bits(self.ray.t_min), f32::from_bits(self.ray.t_max));
        let step = box_step(&bounds, &self.ray.traversal_ray(), t_min, t_max);
        (step.hit, step.hit.then(|| step.t_entry.to_bits()))
    }
}

impl RayWords {
    /// The words of a prepared ray with the part `t_min..=t_max` of it.
    #[must_use]
    pub fn new(ray: &TraversalRay, t_min: f32, t_max: f32) -> Self {
        let bits = |words: [f32; 3]| words.map(f32::to_bits);
        Self {
            origin: bits(ray.origin),
            inv_entry: bits(ray.inv_entry),
            inv_exit: bits(ray.inv_exit),
            t_min: t_min.to_bits(),
            t_max: t_max.to_bits(),
        }
    }

    fn traversal_ray(&self) -> TraversalRay {
        let mut ray = TraversalRay::new(&Ray::new([0.0; 3], [1.0; 3]), Mode::Fast).expect("a valid ray");
        ray.origin = self.origin.map(f32::from_bits);
        ray.inv_entry = self.inv_entry.map(f32::from_bits);
        ray.inv_exit = self.inv_exit.map(f32::from_bits);
        ray
    }
}

/// Every node that golden's search for the closest hits of `rays` visits, in order.
#[must_use]
pub fn visited_nodes<'r>(dst: &Dst, rays: impl IntoIterator<Item = &'r TraversalRay>) -> Vec<NodeCase> {
    let mut nodes = Vec::new();
    for ray in rays {
        closest_by_steps(dst, ray, &mut NoObserver, |words, ray, t_min, t_max| {
            nodes.push(NodeCase { words, ray: RayWords::new(ray, t_min, t_max) });
            step(words, ray, t_min, t_max)
        });
    }
    nodes
}

/// Endless cases, equal for equal seeds: half from plausible geometry, half with any bits at any place.
#[derive(Clone, Debug)]
pub struct Cases {
    stream: Operands,
}

impl Cases {
    /// The cases of `seed`.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self { stream: Operands::new(Format::BINARY32, seed) }
    }

    /// 64 uniform bits.
    pub fn bits(&mut self) -> u64 {
        self.stream.bits()
    }

    fn below(&mut self, limit: u64) -> u64 {
        (self.bits() >> 16) % limit
    }

    /// A coordinate on a coarse grid, so that planes meet each other and the origin often.
    fn coordinate(&mut self) -> f32 {
        self.below(33) as f32 * 0.25 - 4.0
    }

    fn ray(&mut self) -> RayWords {
        let mode = if self.below(2) == 0 { Mode::Fast } else { Mode::Robust };
        loop {
            let origin = [(); 3].map(|()| self.coordinate());
            let direction = [(); 3].map(|()| match self.below(6) {
                0 => 0.0,
                1 => -0.0,
                2 => f32::from_bits(self.below(1 << 20) as u32),
                _ => self.coordinate(),
            });
            let Some(ray) = TraversalRay::new(&Ray::new(origin, direction), mode) else { continue };
            let t_min = if self.below(2) == 0 { 0.0 } else { self.coordinate() };
            let t_max = if self.below(2) == 0 { f32::INFINITY } else { self.coordinate() + 2.0 };
            let mut words = RayWords {
                origin: ray.origin.map(f32::to_bits),
                inv_entry: ray.inv_entry.map(f32::to_bits),
                inv_exit: ray.inv_exit.map(f32::to_bits),
                t_min: t_min.to_bits(),
                t_max: t_max.to_bits(),
            };
            // In every other ray, any operand at all in a few places.
            if self.below(2) == 0 {
                for _ in 0..=self.below(3) {
                    let operand = self.stream.operand();
                    let axis = self.below(3) as usize;
                    match self.below(5) {
                        0 => words.origin[axis] = operand,
                        1 => words.inv_entry[axis] = operand,
                        2 => words.inv_exit[axis] = operand,
                        3 => words.t_min = operand,
                        _ => words.t_max = operand,
                    }
                }
            }
            return words;
        }
    }

    fn plane(&mut self) -> u32 {
        if self.below(6) == 0 { self.stream.operand() } else { self.coordinate().to_bits() }
    }

    /// Ends the interval exactly at the distance of `plane`, in every fourth case.
    fn meet(&mut self, ray: &mut RayWords, plane: u32) {
        let axis = self.below(3) as usize;
        let exact = ray.traversal_ray();
        let t = exact.entry(f32::from_bits(plane), axis);
        match self.below(8) {
            0 => ray.t_min = fp::canonical(t).to_bits(),
            1 => ray.t_max = fp::canonical(t).to_bits(),
            _ => (),
        }
    }

    /// A node of any type, reserved codes included.
    pub fn node(&mut self) -> NodeCase {
        let mut ray = self.ray();
        let words = [self.bits() as u32, self.plane(), self.plane()];
        self.meet(&mut ray, words[1]);
        NodeCase { words, ray }
    }

    /// A box; one in eight may have crossed planes.
    pub fn bounds(&mut self) -> BoxCase {
        let mut ray = self.ray();
        let mut planes = [(); 6].map(|()| self.plane());
        // Most boxes are in order.
        if self.below(8) != 0 {
            for axis in 0..3 {
                let [a, b] = [planes[axis], planes[axis + 3]].map(f32::from_bits);
                if a > b {
                    planes.swap(axis, axis + 3);
                }
            }
        }
        self.meet(&mut ray, planes[0]);
        BoxCase { planes, ray }
    }
}
