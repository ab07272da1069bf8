//! What fewer bits cost and save: visits, lost hits and image error of a scene in every format.
//!
//! The reference is binary32 in robust mode. Each format traces the reference's rays again, so that visits and lost hits of all
//! formats refer to the same rays. The image error is that of a picture rendered with the format's own rays.

use super::pareto;
use fp::{Format, FormatError};
use golden::Ray;
use golden::build::BinaryTree;
use golden::precision::{NarrowDst, NarrowStructure, Precision, Variant};
use golden::ray::TraversalRay;
use golden::structure::{Structure, StructureKind, TooLarge};
use golden::traverse::{Counters, Trace};
use golden::triangle::Triangle;
use machine::frame::{FrameError, FrameMachine, narrow_frame};
use rayon::prelude::*;
use render::{RayClass, RenderError, RenderOptions, Rendering, render};
use scenes::Scene;
use serde::Serialize;
use std::sync::Arc;
use view::picture::Picture;
use view::picture::difference::Difference;

/// A scene's reference, which formats are compared with.
pub struct Sweep<'a> {
    scene: &'a Scene,
    structure: Structure,
    options: RenderOptions,
    reference: Rendering,
    /// The reference's rays by class, each with what it finds.
    rays: Vec<(Ray, Answer)>,
    /// The work of all these rays in binary32 robust mode.
    pub reference_counters: Counters,
}

/// The result of a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Answer {
    /// The nearest triangle and the bits of its distance.
    Nearest(Option<(u32, u32)>),
    /// Whether anything is in the way.
    Occluded(bool),
}

impl Answer {
    fn is_hit(self) -> bool {
        matches!(self, Self::Nearest(Some(_)) | Self::Occluded(true))
    }
}

/// Why there is no sweep.
#[derive(Debug, thiserror::Error)]
pub enum SweepError {
    /// The picture cannot be rendered.
    #[error(transparent)]
    Render(#[from] RenderError),
    /// The dual-split tree is too large for its format.
    #[error(transparent)]
    TooLarge(#[from] TooLarge),
    /// A format is outside the supported range.
    #[error(transparent)]
    Format(#[from] FormatError),
}

/// One format in one variant.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PrecisionPoint {
    /// Name of the format.
    pub format: String,
    /// `naive` or `conservative`.
    pub variant: &'static str,
    /// Exponent bits.
    pub exponent_bits: u32,
    /// Significand bits with the hidden one.
    pub significand_bits: u32,
    /// Rays traced: all rays of the reference.
    pub rays: u64,
    /// Node visits of all rays.
    pub node_visits: u64,
    /// Node visits per ray.
    pub node_visits_per_ray: f64,
    /// Triangles tested per ray.
    pub triangle_tests_per_ray: f64,
    /// The largest number of stack entries.
    pub stack_depth: u32,
    /// Rays that hit something in the reference and nothing in this format.
    pub false_misses: u64,
    /// Rays that hit something in this format and nothing in the reference.
    pub false_hits: u64,
    /// Rays that hit another triangle than in the reference.
    pub wrong_nearest: u64,
    /// Rays that hit the triangle of the reference at a distance that differs in some bit.
    pub other_distance: u64,
    /// Root mean square difference in linear radiance from the reference's picture.
    pub rmse: f64,
    /// Pixels with any difference.
    pub differing_pixels: u64,
    /// Area of the dual-split pipeline in square micrometres, where modules of the format exist; see [`super::cost`].
    pub area_um2: Option<f64>,
    /// Energy that the pipeline spends on the node visits of a ray, in picojoules.
    pub energy_pj_per_ray: Option<f64>,
    /// Simulated time of the frame in milliseconds, where a machine is given; see [`Sweep::frame_ms`].
    pub frame_ms: Option<f64>,
    /// Whether no other point has at most as many bits, visits, false misses and error, and less of one.
    pub pareto: bool,
}

/// The formats of a chart: every significand from 24 bits down to 8 with 8 exponent bits, and those that have names.
#[must_use]
pub fn formats() -> Vec<Format> {
    let wide = (8..=24).rev().filter_map(|bits| Format::new(8, bits).ok());
    wide.chain([Format::BINARY16, Format::E5M2, Format::E4M3]).collect()
}

impl<'a> Sweep<'a> {
    /// Renders the reference.
    ///
    /// # Errors
    /// See [`SweepError`].
    pub fn new(
        scene: &'a Scene,
        tree: &BinaryTree,
        triangles: &Arc<[Triangle]>,
        kind: StructureKind,
        options: RenderOptions,
    ) -> Result<Self, SweepError> {
        let structure = Structure::convert(kind, tree, triangles)?;
        let options = RenderOptions { mode: Variant::Conservative.mode(), ..options };
        let kept = RenderOptions { keep_rays: true, ..options };
        let mut reference = render(&structure, scene, &kept, |_| {})?;
        let stream = reference.rays.take().expect("rays are kept");
        let mut rays = vec![];
        for (class, wave) in stream.by_wave() {
            let occlusion = matches!(class, RayClass::Shadow { .. });
            rays.extend(wave.iter().map(|ray| (*ray, occlusion)));
        }
        let mode = options.mode;
        let traced: Vec<_> = rays
            .par_iter()
            .map(|(ray, occlusion)| {
                let (answer, counters) = trace(&structure, ray, *occlusion, mode);
                ((*ray, answer), counters)
            })
            .collect();
        let mut reference_counters = Counters::default();
        traced.iter().for_each(|(_, counters)| reference_counters.merge(counters));
        let rays = traced.into_iter().map(|(ray, _)| ray).collect();
        Ok(Self { scene, structure, options, reference, rays, reference_counters })
    }

    /// Number of rays that every format traces.
    #[must_use]
    pub fn rays(&self) -> u64 {
        self.rays.len() as u64
    }

    /// Milliseconds of the frame on `machine`, or `None` for other structures than dual-split trees.
    ///
    /// `machine` runs the program of the dual-split pipeline. The pipeline's latency does not depend on the format, and nodes keep
    /// their 12 bytes.
    ///
    /// # Errors
    /// [`FrameError`] if the machine cannot run it.
    pub fn frame_ms(&self, machine: &FrameMachine, precision: Precision) -> Result<Option<f64>, FrameError> {
        let Structure::Dst(dst) = &self.structure else { return Ok(None) };
        let narrow = NarrowDst::new(dst, precision);
        let options = RenderOptions { mode: precision.variant.mode(), ..self.options };
        let frame = narrow_frame(machine, self.scene, &narrow, &options, |_| {})?;
        Ok(Some(f64::from(frame.counts.cycles) / machine.description.clock_ghz / 1e6))
    }

    /// The rays that ask for the nearest hit, prepared in `mode`.
    #[must_use]
    pub fn closest_rays(&self, mode: golden::Mode) -> Vec<TraversalRay> {
        let closest = self.rays.iter().filter(|(_, answer)| matches!(answer, Answer::Nearest(_)));
        closest.filter_map(|(ray, _)| TraversalRay::new(ray, mode)).collect()
    }

    /// Calls `visit` with every ray in the reference's order, and whether the ray asks for occlusion only.
    pub fn for_each_ray(&self, mut visit: impl FnMut(&TraversalRay, bool)) {
        for (ray, answer) in &self.rays {
            if let Some(prepared) = TraversalRay::new(ray, self.options.mode) {
                visit(&prepared, matches!(answer, Answer::Occluded(_)));
            }
        }
    }

    /// The structure in the reference's binary32.
    #[must_use]
    pub fn structure(&self) -> &Structure {
        &self.structure
    }

    /// Traces and renders in `precision`, or returns `None` if the rays visit more than `most_visits` nodes.
    ///
    /// The limit bounds the time: with too few bits no node is culled, and every ray of a conservative traversal visits the whole
    /// tree.
    ///
    /// # Errors
    /// See [`SweepError`].
    pub fn point(
        &self,
        precision: Precision,
        most_visits: u64,
    ) -> Result<Option<PrecisionPoint>, SweepError> {
        let structure = &NarrowStructure::new(&self.structure, precision);
        let mode = precision.variant.mode();
        let traced = |(ray, expected): &(Ray, Answer)| {
            let (found, counters) = trace(structure, ray, matches!(expected, Answer::Occluded(_)), mode);
            let wrong = match (*expected, found) {
                (expected, found) if expected.is_hit() != found.is_hit() => {
                    [u64::from(expected.is_hit()), u64::from(found.is_hit()), 0, 0]
                }
                (Answer::Nearest(Some((a, t))), Answer::Nearest(Some((b, u)))) if (a, t) != (b, u) => {
                    [0, 0, u64::from(a != b), u64::from(a == b)]
                }
                _ => [0; 4],
            };
            (counters, wrong)
        };
        // Sums and maxima of integers do not depend on the order.
        let add = |mut a: (Counters, [u64; 4]), b: (Counters, [u64; 4])| {
            a.0.merge(&b.0);
            (a.0, std::array::from_fn(|i| a.1[i] + b.1[i]))
        };
        let mut sums = Default::default();
        let mut traced_rays = 0;
        while traced_rays < self.rays.len() {
            // Each turn traces as many rays as all turns before it, so that the time beyond the limit stays near that of the
            // limit.
            let next = self.rays.len().min((2 * traced_rays).max(1));
            let some = &self.rays[traced_rays..next];
            sums = add(sums, some.par_iter().map(traced).reduce(Default::default, add));
            if sums.0.node_visits > most_visits {
                return Ok(None);
            }
            traced_rays = next;
        }
        let (counters, wrong) = sums;
        let rendering = render(structure, self.scene, &RenderOptions { mode, ..self.options }, |_| {})?;
        let difference =
            Difference::new(view::picture::Format::Exr, &colours(&self.reference), &colours(&rendering))
                .expect("both have the size of the options");
        let per_ray = |x: u64| x as f64 / self.rays().max(1) as f64;
        let [false_misses, false_hits, wrong_nearest, other_distance] = wrong;
        Ok(Some(PrecisionPoint {
            format: precision.format.to_string(),
            variant: precision.variant.name(),
            exponent_bits: precision.format.exponent_bits(),
            significand_bits: precision.format.significand_bits(),
            rays: self.rays(),
            node_visits: counters.node_visits,
            node_visits_per_ray: per_ray(counters.node_visits),
            triangle_tests_per_ray: per_ray(counters.triangle_tests),
            stack_depth: counters.stack_depth,
            false_misses,
            false_hits,
            wrong_nearest,
            other_distance,
            rmse: difference.rmse,
            differing_pixels: difference.differing_pixels,
            area_um2: None,
            energy_pj_per_ray: None,
            frame_ms: None,
            pareto: false,
        }))
    }
}

fn trace(structure: &impl Trace, ray: &Ray, occlusion: bool, mode: golden::Mode) -> (Answer, Counters) {
    let mut counters = Counters::default();
    let prepared = TraversalRay::new(ray, mode);
    let answer = if occlusion {
        Answer::Occluded(prepared.is_some_and(|ray| structure.occluded_prepared(&ray, &mut counters)))
    } else {
        let hit = prepared.and_then(|ray| structure.closest_prepared(&ray, &mut counters));
        Answer::Nearest(hit.map(|hit| (hit.triangle, hit.t.to_bits())))
    };
    (answer, counters)
}

fn colours(rendering: &Rendering) -> Picture<f32> {
    let pixels = rendering.pixels.iter().map(|pixel| pixel.rgb).collect();
    Picture { width: rendering.width, height: rendering.height, pixels }
}

/// Marks the points on the Pareto front of bits, visits, false misses and image error.
pub fn mark_front(points: &mut [PrecisionPoint]) {
    let costs: Vec<[f64; 4]> = points
        .iter()
        .map(|p| {
            let bits = p.exponent_bits + p.significand_bits;
            [f64::from(bits), p.node_visits as f64, p.false_misses as f64, p.rmse]
        })
        .collect();
    for (point, marked) in points.iter_mut().zip(pareto::front(&costs)) {
        point.pareto = marked;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use golden::build::{BuildOptions, Quality, build};
    use golden::structure::pack_triangles;
    use render::Test;

    #[test]
    fn a_format_is_given_up_at_the_first_visit_too_many() {
        let scene = Scene::load("statue", 0.0005, 0).unwrap();
        let tree = build(&scene.mesh, &BuildOptions::new(Quality::Fast)).unwrap();
        let triangles = pack_triangles(&scene.mesh, &tree);
        let options = RenderOptions::new(Test::Raycast, 8, 8);
        let sweep = Sweep::new(&scene, &tree, &triangles, StructureKind::Dst, options).unwrap();
        let precision = Precision::new(Format::new(8, 6).unwrap(), Variant::Conservative);
        let point = sweep.point(precision, u64::MAX).unwrap().unwrap();
        assert!(point.node_visits > sweep.reference_counters.node_visits);
        assert_eq!(sweep.point(precision, point.node_visits).unwrap(), Some(point.clone()));
        assert_eq!(sweep.point(precision, point.node_visits - 1).unwrap(), None);
        // A low limit is exceeded before all rays are traced.
        assert_eq!(sweep.point(precision, 1).unwrap(), None);
    }
}
