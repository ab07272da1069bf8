//! Runs of methods on cases, with counts of their wrong results.

use super::{Instance, Method, Structures};
use base::split_mix;
use golden::build::{BinaryTree, BuildError, BuildOptions, Quality, build};
use golden::structure::{TooLarge, pack_triangles};
use golden::traverse::brute_force;
use golden::triangle::Triangle;
use golden::{Hit, Mode, Ray};
use rayon::prelude::*;
use scenes::Mesh;
use serde::Serialize;
use std::sync::Arc;
use stress::aimed::{Aim, Aimed};
use stress::cases::Case;
use stress::oracle::Oracle;

/// Counts of one method in one case. All integers count rays.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Cell {
    /// The method.
    pub method: String,
    /// The case.
    pub case: String,
    /// Rays traced.
    pub rays: u64,
    /// Rays that exactly hit something and find nothing.
    pub false_misses: u64,
    /// Rays that exactly hit nothing and find something.
    pub false_hits: u64,
    /// Rays that find a triangle which is not at the exactly least distance.
    pub wrong_nearest: u64,
    /// Rays whose result is NaN.
    pub nan: u64,
    /// Rays whose result differs in some bit from that of testing every triangle.
    pub lost: u64,
    /// Rays for which testing every triangle is wrong itself, in any of the first three ways.
    pub triangle_test: u64,
    /// Rays whose visits were counted.
    pub visit_rays: u64,
    /// Rays with more visits than five times the most of eight neighbours, plus four times the depth.
    pub excess_visits: u64,
    /// The least interval of a box that a search found, in units in the last place. If it is below zero, the ray misses the box.
    pub least_slack_ulps: Option<f64>,
}

impl Cell {
    /// A cell without rays.
    #[must_use]
    pub fn new(method: Method, case: &str) -> Self {
        Self { method: method.to_string(), case: case.to_owned(), ..Self::default() }
    }

    /// Adds the counts of `other`.
    pub fn merge(&mut self, other: &Cell) {
        self.rays += other.rays;
        self.false_misses += other.false_misses;
        self.false_hits += other.false_hits;
        self.wrong_nearest += other.wrong_nearest;
        self.nan += other.nan;
        self.lost += other.lost;
        self.triangle_test += other.triangle_test;
        self.visit_rays += other.visit_rays;
        self.excess_visits += other.excess_visits;
        self.least_slack_ulps = match (self.least_slack_ulps, other.least_slack_ulps) {
            (Some(a), Some(b)) => Some(a.min(b)),
            (a, b) => a.or(b),
        };
    }

    /// Number of rays that traversal, not the triangle test, got wrong.
    #[must_use]
    pub fn traversal_failures(&self) -> u64 {
        self.lost + self.nan + self.excess_visits
    }

    /// Counts the result of a ray that exactly hits something. `known` is the result of the method's triangle test for the ray.
    pub(super) fn judge_aimed(&mut self, found: Option<Hit>, known: &Option<Aimed>) {
        self.rays += 1;
        self.false_misses += u64::from(found.is_none());
        self.nan += u64::from(found.is_some_and(|hit| hit.t.is_nan()));
        match known {
            None => self.triangle_test += 1,
            Some(known) if known.is_lost(found) => {
                self.lost += 1;
                self.wrong_nearest += u64::from(found.is_some());
            }
            Some(_) => {}
        }
    }

    fn judge(&mut self, judgement: Judgement) {
        match judgement {
            Judgement::Right => {}
            Judgement::FalseMiss => self.false_misses += 1,
            Judgement::FalseHit => self.false_hits += 1,
            Judgement::WrongNearest => self.wrong_nearest += 1,
        }
    }
}

/// How a result compares with the exact answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Judgement {
    Right,
    FalseMiss,
    FalseHit,
    WrongNearest,
}

/// Judges a result, given the triangles at the exactly least distance.
pub(super) fn judge(found: Option<Hit>, exact: &[u32]) -> Judgement {
    match found {
        None if exact.is_empty() => Judgement::Right,
        None => Judgement::FalseMiss,
        Some(_) if exact.is_empty() => Judgement::FalseHit,
        Some(hit) if exact.contains(&hit.triangle) => Judgement::Right,
        Some(_) => Judgement::WrongNearest,
    }
}

/// A case with its tree and its exact answers.
#[derive(Debug)]
pub struct Bench {
    /// Name of the case.
    pub name: String,
    /// Geometry of the case.
    pub mesh: Mesh,
    /// The hierarchy that all structures are converted from.
    pub tree: BinaryTree,
    /// The triangles in the order of the hierarchy's leaves.
    pub triangles: Arc<[Triangle]>,
    /// The rays traced.
    pub rays: Vec<Ray>,
    /// For each ray, the triangles at the exactly least distance.
    exact: Vec<Vec<u32>>,
    /// For each ray, the hit that testing every triangle finds in fast and in robust mode.
    brute_force: Vec<[Option<Hit>; 2]>,
}

/// Number of rays of a case whose visits are counted and compared with those of their neighbours.
const VISIT_RAYS: usize = 8;

impl Bench {
    /// Prepares at most `rays` rays of `case`, evenly drawn.
    ///
    /// # Errors
    /// [`BuildError`] if there is no tree over the case.
    pub fn new(case: Case, rays: usize) -> Result<Self, BuildError> {
        let tree = build(&case.mesh, &BuildOptions::new(Quality::Fast))?;
        let triangles = pack_triangles(&case.mesh, &tree);
        let count = rays.min(case.rays.len());
        let rays: Vec<Ray> = (0..count).map(|i| case.rays[i * case.rays.len() / count]).collect();
        let oracle = Oracle::new(&case.mesh, &tree);
        let exact = rays.par_iter().map(|ray| oracle.nearest(ray)).collect();
        let both = |ray: &Ray| [Mode::Fast, Mode::Robust].map(|mode| brute_force(&triangles, ray, mode));
        let brute_force = rays.par_iter().map(both).collect();
        Ok(Self { name: case.name.to_owned(), mesh: case.mesh, tree, triangles, rays, exact, brute_force })
    }

    /// Runs a method on the case's rays, or on the first `limit` of them.
    #[must_use]
    pub fn run(&self, instance: &Instance, limit: usize) -> Cell {
        let method = instance.method;
        let mut cell = Cell::new(method, &self.name);
        let at = method.mode_index();
        for (i, ray) in self.rays.iter().enumerate().take(limit) {
            let found = instance.closest(ray);
            let (exact, every) = (&self.exact[i], self.brute_force[i][at]);
            cell.rays += 1;
            cell.judge(judge(found, exact));
            cell.nan +=
                u64::from(found.is_some_and(|hit| hit.t.is_nan() || hit.u.is_nan() || hit.v.is_nan()));
            cell.lost += u64::from(bits(found) != bits(every));
            cell.triangle_test += u64::from(judge(every, exact) != Judgement::Right);
        }
        if !method.is_hardware() {
            let every = (self.rays.len() / VISIT_RAYS).max(1);
            for ray in self.rays.iter().step_by(every).take(VISIT_RAYS) {
                cell.visit_rays += 1;
                cell.excess_visits += u64::from(self.is_slow(instance, ray));
            }
        }
        cell
    }

    /// The first ray for which `instance` gives a wrong result, with the judgement of that result.
    pub(super) fn first_failure(&self, instance: &Instance) -> Option<(Ray, Judgement)> {
        self.rays.iter().zip(&self.exact).find_map(|(ray, exact)| {
            let judgement = judge(instance.closest(ray), exact);
            (judgement != Judgement::Right).then_some((*ray, judgement))
        })
    }

    fn is_slow(&self, instance: &Instance, ray: &Ray) -> bool {
        let neighbours = turned(ray).map(|ray| instance.visits(&ray));
        let most = neighbours.into_iter().max().unwrap_or(0);
        instance.visits(ray) > 5 * most + 4 * u64::from(self.tree.max_depth())
    }
}

fn bits(hit: Option<Hit>) -> Option<(u32, u32, u32, u32)> {
    hit.map(|hit| (hit.t.to_bits(), hit.u.to_bits(), hit.v.to_bits(), hit.triangle))
}

/// `ray`, turned by a millionth in eight directions.
fn turned(ray: &Ray) -> [Ray; 8] {
    let d = ray.direction.map(f64::from);
    let length = d.iter().map(|x| x * x).sum::<f64>().sqrt();
    let main = (0..3).fold(0, |m, k| if d[k].abs() > d[m].abs() { k } else { m });
    let (a, b) = ((main + 1) % 3, (main + 2) % 3);
    [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)].map(|(x, y)| {
        let mut turned = d;
        turned[a] += f64::from(x) * 1e-6 * length;
        turned[b] += f64::from(y) * 1e-6 * length;
        Ray { direction: turned.map(|x| x as f32), ..*ray }
    })
}

/// Number of rays that one seed generates. Larger numbers of rays are split into such chunks, which run in parallel.
const CHUNK: u64 = 1 << 14;

/// An interpreted netlist takes thousands of times as long as software: this many rays of a chunk are enough for it.
const NETLIST_CHUNK: u64 = CHUNK / 1000;

/// Runs every method on the same `rays` rays, aimed at the triangles of `mesh` so that the answer is known by construction.
/// Interpreted netlists run on a thousandth of the rays.
///
/// # Errors
/// [`TooLarge`] if the dual-split tree is too large for its format.
///
/// # Panics
/// If there is no tree over the mesh.
pub fn aimed_cells(
    methods: &[Method],
    (name, mesh): (&str, &Mesh),
    rays: u64,
    seed: u64,
    done: impl Fn(u64) + Sync,
) -> Result<Vec<Cell>, TooLarge> {
    let tree = build(mesh, &BuildOptions::new(Quality::Medium)).expect("a tree over the mesh");
    let structures = Structures::new(&tree, &pack_triangles(mesh, &tree))?;
    let instances: Vec<Instance> =
        methods.iter().map(|method| method.instance(&structures, method.netlist().as_ref())).collect();
    let new_cells = || methods.iter().map(|method| Cell::new(*method, name)).collect::<Vec<_>>();
    let chunk = |index: u64| {
        let count = CHUNK.min(rays - index * CHUNK);
        let mut cells = new_cells();
        for (i, aimed) in (0..count).zip(Aim::new(mesh, Mode::Robust, mixed(seed, index))) {
            let known = [aimed.in_mode(mesh, Mode::Fast), Some(aimed)];
            for (cell, instance) in cells.iter_mut().zip(&instances) {
                if i < NETLIST_CHUNK || !instance.method.is_interpreted() {
                    cell.judge_aimed(instance.closest(&aimed.ray), &known[instance.method.mode_index()]);
                }
            }
        }
        done(count);
        cells
    };
    let merged = |mut sums: Vec<Cell>, cells: Vec<Cell>| {
        sums.iter_mut().zip(&cells).for_each(|(sum, cell)| sum.merge(cell));
        sums
    };
    // Sums of integers do not depend on the order.
    Ok((0..rays.div_ceil(CHUNK)).into_par_iter().map(chunk).reduce(new_cells, merged))
}

/// A seed for part `index`.
fn mixed(seed: u64, index: u64) -> u64 {
    split_mix::mix(seed.wrapping_add(index.wrapping_add(1).wrapping_mul(split_mix::STEP)))
}
