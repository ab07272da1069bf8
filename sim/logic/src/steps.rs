//! Traversal steps by the pipelines' netlists, one at a time: hardware in the loop of a traversal.
//!
//! Each step flushes the pipeline ([`Compiled::flush`]), which gives at once the outputs of eight cycles later.

use golden::Aabb;
use golden::dst::{Child, Code, Step};
use golden::ray::PlaneRay;
use lanes::{Compiled, Program, Slot};
use netlist::Engine;
use pipelines::catalogue::{StandardFormat, Top};

/// The lane in which the steps run.
const LANE: usize = 0;

/// The dual-split pipeline as a step function, for [`closest_by_steps`](golden::traverse::closest_by_steps).
#[derive(Clone, Debug)]
pub struct DualSplitStep {
    pipeline: Pipeline,
    words: [Slot; 3],
    code: usize,
    near: [usize; 3],
    far: [usize; 3],
}

/// The ray-box pipeline as a function.
#[derive(Clone, Debug)]
pub struct RayBoxStep {
    pipeline: Pipeline,
    planes: [Slot; 6],
    hit: usize,
    t_entry: usize,
}

/// A pipeline, with the inputs that both pipelines have.
#[derive(Clone, Debug)]
struct Pipeline {
    compiled: Compiled,
    /// Origin, reciprocals for entry planes and for exit planes.
    vectors: [[Slot; 3]; 3],
    interval: [Slot; 2],
}

impl Pipeline {
    fn new(top: Top) -> Self {
        let program = compiled::program(top, StandardFormat::Binary32).expect("the pipelines are compiled");
        let axes = |what: &str| ["x", "y", "z"].map(|axis| input(program, &format!("{what}_{axis}_i")));
        let vectors = ["origin", "inv_entry", "inv_exit"].map(axes);
        let interval = ["t_min_i", "t_max_i"].map(|name| input(program, name));
        Self { compiled: Compiled::new(program), vectors, interval }
    }

    #[inline]
    fn drive(&mut self, slot: Slot, word: u32) {
        self.compiled.words_mut(slot)[LANE] = word;
    }

    #[inline]
    fn run(&mut self, ray: &PlaneRay, t_min: f32, t_max: f32) {
        for (slots, vector) in self.vectors.into_iter().zip([&ray.origin, &ray.inv_entry, &ray.inv_exit]) {
            for (slot, component) in slots.into_iter().zip(vector) {
                self.drive(slot, component.to_bits());
            }
        }
        for (slot, t) in self.interval.into_iter().zip([t_min, t_max]) {
            self.drive(slot, t.to_bits());
        }
        self.compiled.flush(LANE);
    }

    #[inline]
    fn word(&self, output: usize) -> u32 {
        self.compiled.output(output, LANE) as u32
    }
}

fn input(program: &Program, name: &str) -> Slot {
    program.inputs[program.input(name).unwrap_or_else(|| panic!("no input is called `{name}`"))].slot
}

fn output(program: &Program, name: &str) -> usize {
    program.output(name).unwrap_or_else(|| panic!("no output is called `{name}`"))
}

impl Default for DualSplitStep {
    fn default() -> Self {
        let pipeline = Pipeline::new(Top::DualSplit);
        let program = pipeline.compiled.program();
        let words = ["header_i", "plane_0_i", "plane_1_i"].map(|name| input(program, name));
        let slot = |which: &str| {
            ["offset", "t_min", "t_max"].map(|what| output(program, &format!("{which}_{what}_o")))
        };
        Self { words, code: output(program, "code_o"), near: slot("near"), far: slot("far"), pipeline }
    }
}

impl DualSplitStep {
    /// What the pipeline returns for the node `words` and the part `t_min..=t_max` of `ray`.
    #[must_use]
    pub fn step(&mut self, words: [u32; 3], ray: &PlaneRay, t_min: f32, t_max: f32) -> Step {
        for (slot, word) in self.words.into_iter().zip(words) {
            self.pipeline.drive(slot, word);
        }
        self.pipeline.run(ray, t_min, t_max);
        let child = |[offset, t_min, t_max]: [usize; 3]| Child {
            offset: self.pipeline.word(offset),
            t_min: f32::from_bits(self.pipeline.word(t_min)),
            t_max: f32::from_bits(self.pipeline.word(t_max)),
        };
        let code = [Code::Miss, Code::One, Code::Two, Code::Leaf][self.pipeline.word(self.code) as usize & 3];
        Step { code, near: child(self.near), far: child(self.far) }
    }
}

impl Default for RayBoxStep {
    fn default() -> Self {
        let pipeline = Pipeline::new(Top::RayBox);
        let program = pipeline.compiled.program();
        let plane = |i: usize| {
            let (side, axis) = (["min", "max"][i / 3], ["x", "y", "z"][i % 3]);
            input(program, &format!("box_{side}_{axis}_i"))
        };
        let planes = std::array::from_fn(plane);
        Self { planes, hit: output(program, "hit_o"), t_entry: output(program, "t_entry_o"), pipeline }
    }
}

impl RayBoxStep {
    /// Where the part `t_min..=t_max` of `ray` enters `bounds`, if it does.
    #[must_use]
    pub fn entry(&mut self, bounds: &Aabb, ray: &PlaneRay, t_min: f32, t_max: f32) -> Option<f32> {
        for (slot, plane) in self.planes.into_iter().zip(bounds.min.into_iter().chain(bounds.max)) {
            self.pipeline.drive(slot, plane.to_bits());
        }
        self.pipeline.run(ray, t_min, t_max);
        (self.pipeline.word(self.hit) == 1).then(|| f32::from_bits(self.pipeline.word(self.t_entry)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use golden::build::{BuildOptions, build};
    use golden::bvh::box_step;
    use golden::dst::Dst;
    use golden::structure::pack_triangles;
    use golden::traverse::{NoObserver, Trace, closest_by_steps};
    use golden::{Mode, TraversalRay};
    use render::CameraRays;

    /// If netlists do every step and every box test, the hits of a picture are those of the software, bit for bit.
    #[test]
    fn traversal_by_hardware_steps_finds_the_same_hits() {
        let scene = scenes::procedural::build("courtyard", 0.01, 0).unwrap();
        let tree = build(&scene.mesh, &BuildOptions::default()).unwrap();
        let dst = Dst::convert(&tree, pack_triangles(&scene.mesh, &tree)).unwrap();
        let camera = CameraRays::new(&scene.camera, 32, 32).unwrap();
        let (mut steps, mut boxes) = (DualSplitStep::default(), RayBoxStep::default());
        let mut hits = 0;
        for pixel in 0..32 * 32 {
            let given = camera.ray((pixel % 32) as f32 + 0.5, (pixel / 32) as f32 + 0.5);
            let ray = TraversalRay::new(&given, Mode::Robust).unwrap();
            let found = closest_by_steps(&dst, &ray, &mut NoObserver, |words, ray, t_min, t_max| {
                steps.step(words, &ray.planes(), t_min, t_max)
            });
            assert_eq!(found, dst.closest(&given, Mode::Robust));
            hits += usize::from(found.is_some());
            let root = box_step(&dst.root_box, &ray, ray.t_min, ray.t_max);
            let entry = boxes.entry(&dst.root_box, &ray.planes(), ray.t_min, ray.t_max);
            assert_eq!(entry.map(f32::to_bits), root.hit.then(|| root.t_entry.to_bits()));
        }
        assert!(hits > 100);
    }
}
