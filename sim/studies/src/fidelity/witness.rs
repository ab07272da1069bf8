//! The pipelines' netlists, compared with golden's steps one operation at a time in the compiled simulation.

use golden::Aabb;
use golden::bvh::BoxStep;
use golden::dst::{Child, Step};
use golden::ray::PlaneRay;
use logic::steps::{DualSplitStep, RayBoxStep};
use machine::frame::Checker;
use std::cell::RefCell;

thread_local! {
    static DUAL_SPLIT: RefCell<DualSplitStep> = RefCell::default();
    static RAY_BOX: RefCell<RayBoxStep> = RefCell::default();
}

/// The netlists of the catalogue in binary32.
pub struct Netlists;

impl Checker for Netlists {
    fn step(&self, words: [u32; 3], ray: &PlaneRay, interval: [f32; 2], golden: &Step) -> bool {
        step(words, ray, interval, golden)
    }

    fn box_test(&self, bounds: &Aabb, ray: &PlaneRay, t_max: f32, golden: &BoxStep) -> bool {
        box_test(bounds, ray, t_max, golden)
    }
}

fn step(words: [u32; 3], ray: &PlaneRay, [t_min, t_max]: [f32; 2], golden: &Step) -> bool {
    let step = DUAL_SPLIT.with_borrow_mut(|pipeline| pipeline.step(words, ray, t_min, t_max));
    bits(&step) == bits(golden)
}

/// The bits of all outputs that a step's return code declares valid.
fn bits(step: &Step) -> (u8, [Option<[u32; 3]>; 2]) {
    use golden::dst::Code;
    let child = |child: &Child| [child.offset, child.t_min.to_bits(), child.t_max.to_bits()];
    match step.code {
        Code::Miss => (0, [None, None]),
        Code::One => (1, [Some(child(&step.near)), None]),
        Code::Two => (2, [Some(child(&step.near)), Some(child(&step.far))]),
        Code::Leaf => (3, [Some(child(&step.near)), None]),
    }
}

fn box_test(bounds: &Aabb, ray: &PlaneRay, t_max: f32, golden: &BoxStep) -> bool {
    let entry = RAY_BOX.with_borrow_mut(|pipeline| pipeline.entry(bounds, ray, 0.0, t_max));
    entry.map(f32::to_bits) == golden.hit.then(|| golden.t_entry.to_bits())
}

#[cfg(test)]
mod tests {
    use super::*;
    use golden::build::{BuildOptions, build};
    use golden::bvh::box_step;
    use golden::dst::{Code, Dst, step as golden_step};
    use golden::structure::pack_triangles;
    use golden::{Mode, TraversalRay};
    use render::CameraRays;

    /// A difference of one unit in the last place of any valid word is noticed.
    #[test]
    fn a_wrong_bit_is_a_difference() {
        let scene = scenes::procedural::build("courtyard", 0.001, 0).unwrap();
        let tree = build(&scene.mesh, &BuildOptions::default()).unwrap();
        let dst = Dst::convert(&tree, pack_triangles(&scene.mesh, &tree)).unwrap();
        let camera = CameraRays::new(&scene.camera, 8, 8).unwrap();
        let mut two = 0;
        for pixel in 0..64 {
            let ray = camera.ray((pixel % 8) as f32 + 0.5, (pixel / 8) as f32 + 0.5);
            let ray = TraversalRay::new(&ray, Mode::Robust).unwrap();
            let here = [ray.t_min, ray.t_max];
            let planes = ray.planes();
            let golden = golden_step(dst.node(0), &ray, ray.t_min, ray.t_max);
            assert!(step(dst.node(0), &planes, here, &golden));
            if golden.code != Code::Miss {
                let mut wrong = golden;
                wrong.near.t_max = f32::from_bits(wrong.near.t_max.to_bits() ^ 1);
                assert!(!step(dst.node(0), &planes, here, &wrong));
            }
            if golden.code == Code::Two {
                two += 1;
                let mut wrong = golden;
                wrong.far.offset ^= 1;
                assert!(!step(dst.node(0), &planes, here, &wrong));
            }
            let test = box_step(&dst.root_box, &ray, ray.t_min, ray.t_max);
            assert!(box_test(&dst.root_box, &planes, ray.t_max, &test));
            assert!(!box_test(&dst.root_box, &planes, ray.t_max, &BoxStep { hit: !test.hit, ..test }));
        }
        assert_eq!(two, 32, "half of the rays visit both children");
    }
}
