//! An adversary, which walks a ray one unit in the last place at a time towards the worst case of a method.
//!
//! The ray exactly hits a triangle at every step. The walk shortens the interval that the method computes for the triangle's
//! box: if its length falls below zero, a tree with that box in a leaf of its own loses the hit. A step changes one of the ray's
//! six numbers by a power of two of units in the last place, mostly by one unit. The walk takes each step that does not lengthen
//! the interval, so that it can cross plateaus.

use super::{Cell, Method, Structures};
use golden::build::{BuildOptions, Quality, build};
use golden::structure::{TooLarge, pack_triangles};
use golden::{Aabb, Mode, Ray};
use rayon::prelude::*;
use scenes::Mesh;
use stress::aimed::{Aim, Aimed, nudged};
use stress::shapes::Random;

/// Where a walk ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// The ray with the least interval.
    pub ray: Ray,
    /// The length of its interval in units in the last place of the interval's end.
    pub slack_ulps: f64,
}

/// Walks `starts` rays for `steps` steps each and traces every ray on the way.
///
/// # Errors
/// [`TooLarge`] if the dual-split tree is too large for its format.
///
/// # Panics
/// If there is no tree over the mesh.
pub fn search(
    method: Method,
    (name, mesh): (&str, &Mesh),
    starts: u64,
    steps: u32,
    seed: u64,
) -> Result<(Cell, Option<Found>), TooLarge> {
    // Each leaf has one triangle, so that its box is the triangle's.
    let options = BuildOptions { quality: Quality::Medium, max_leaf_size: 1 };
    let tree = build(mesh, &options).expect("a tree over the mesh");
    let structures = Structures::new(&tree, &pack_triangles(mesh, &tree))?;
    let instance = method.instance(&structures, method.netlist().as_ref());
    let aim = Aim::new(mesh, Mode::Robust, seed);
    let starting: Vec<Aimed> = Aim::new(mesh, Mode::Robust, seed).take(starts as usize).collect();
    let walk = |(i, start): (usize, &Aimed)| {
        let mut cell = Cell::new(method, name);
        let mut random = Random::new(seed ^ (i as u64 + 1) << 20);
        let bounds = Aabb::of_points(&mesh.corners(start.known.triangle as usize));
        let mut best =
            instance.slack(&bounds, &start.ray).map(|slack_ulps| Found { ray: start.ray, slack_ulps });
        for _ in 0..steps {
            let Some(current) = best else { break };
            let ray = neighbour(&current.ray, &mut random);
            let Some(aimed) = aim.confirm(&ray, start.known.triangle) else { continue };
            let Some(slack_ulps) = instance.slack(&bounds, &ray) else { continue };
            if slack_ulps > current.slack_ulps {
                continue;
            }
            best = Some(Found { ray, slack_ulps });
            let known = aimed.in_mode(mesh, method.arithmetic.mode());
            cell.judge_aimed(instance.closest(&ray), &known);
        }
        cell.least_slack_ulps = best.map(|best| best.slack_ulps);
        (cell, best)
    };
    let walks: Vec<_> = starting.par_iter().enumerate().map(walk).collect();
    let mut sum = Cell::new(method, name);
    let mut worst: Option<Found> = None;
    for (cell, best) in walks {
        sum.merge(&cell);
        if best.is_some_and(|best| worst.is_none_or(|worst| best.slack_ulps < worst.slack_ulps)) {
            worst = best;
        }
    }
    Ok((sum, worst))
}

/// `ray` with one of its numbers changed by a power of two of units in the last place.
fn neighbour(ray: &Ray, random: &mut Random) -> Ray {
    let mut ray = *ray;
    let at = random.below(6);
    let ulps = 1i32 << (random.below(24) * random.below(2));
    let component = if at < 3 { &mut ray.origin[at] } else { &mut ray.direction[at - 3] };
    *component = nudged(*component, if random.below(2) == 0 { ulps } else { -ulps });
    ray
}

#[cfg(test)]
mod tests {
    use super::*;
    use stress::shapes::grid;

    #[test]
    fn the_walk_finds_boxes_that_fast_mode_misses_and_none_in_robust_mode() {
        let mesh = grid(4);
        let run = |name: &str| search(name.parse().unwrap(), ("grid", &mesh), 32, 200, 1).unwrap();
        let (fast, worst) = run("dst/binary32-fast");
        assert!(worst.unwrap().slack_ulps < 0.0 && fast.triangle_test > 0, "{fast:?} {worst:?}");
        for safe in ["dst/binary32-robust", "bvh2/bfloat16-conservative"] {
            let (cell, worst) = run(safe);
            assert!(worst.unwrap().slack_ulps >= 0.0 && cell.rays > 100, "{cell:?} {worst:?}");
            assert_eq!(cell.traversal_failures() + cell.false_misses, 0, "{cell:?}");
        }
    }
}
