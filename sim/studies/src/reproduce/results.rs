//! The results of the main job, as `results.json` has them.

use crate::trees::StructureRow;
use crate::work::ClassRow;
use golden::structure::StructureKind;
use render::{Rendering, Test};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// The results of all scenes.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct Document {
    pub preset: &'static str,
    pub version: &'static str,
    pub mode: &'static str,
    pub seed: u64,
    pub quality: &'static str,
    pub width: u32,
    pub height: u32,
    pub spp: u32,
    pub scenes: Vec<SceneResult>,
}

/// The results of one scene.
#[derive(Debug, Serialize, Deserialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct SceneResult {
    pub scene: String,
    pub stands_for: Cow<'static, str>,
    pub detail: f64,
    pub triangles: usize,
    pub structures: Vec<StructureRow>,
    pub renders: Vec<RenderResult>,
}

/// The work of one test of one scene in one structure.
#[derive(Debug, Serialize, Deserialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct RenderResult {
    pub structure: Cow<'static, str>,
    pub test: Cow<'static, str>,
    pub rays: u64,
    pub hits: u64,
    pub node_visits_per_ray: f64,
    pub plane_tests_per_ray: f64,
    pub triangle_tests_per_ray: f64,
    pub bytes_per_ray: f64,
    pub stack_depth: u32,
    pub classes: Vec<ClassRow>,
}

impl RenderResult {
    /// The work that `rendering` took.
    pub fn new(kind: StructureKind, test: Test, rendering: &Rendering) -> Self {
        let total = rendering.total();
        let per_ray = |x: u64| x as f64 / total.rays.max(1) as f64;
        Self {
            structure: kind.name().into(),
            test: test.name().into(),
            rays: total.rays,
            hits: total.hits,
            node_visits_per_ray: per_ray(total.counters.node_visits),
            plane_tests_per_ray: per_ray(total.counters.plane_tests),
            triangle_tests_per_ray: per_ray(total.counters.triangle_tests),
            bytes_per_ray: per_ray(total.counters.bytes),
            stack_depth: total.counters.stack_depth,
            classes: rendering.classes().map(|(class, totals)| ClassRow::new(class, totals, true)).collect(),
        }
    }
}
