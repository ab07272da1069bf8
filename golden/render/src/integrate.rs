//! The integrator: paths, row by row in parallel.

use super::camera::CameraRays;
use super::output::{ClassTotals, Pixel, Rendering, Work};
use super::sampling::{PixelSamples, cosine_direction};
use super::stream::{RayClass, RayStream, Wave};
use super::surface::Surface;
use super::{ALBEDO, RenderOptions};
use glam::DVec3;
use golden::Ray;
use golden::ray::{Hit, TraversalRay};
use golden::traverse::{Counters, NoObserver, Trace};
use rayon::prelude::*;
use scenes::Scene;
use std::f64::consts::FRAC_1_PI;

/// Renders with valid options.
pub(super) fn render<S: Trace>(
    structure: &S,
    scene: &Scene,
    camera: &CameraRays,
    options: &RenderOptions,
    rows_done: impl Fn(u64) + Sync,
) -> Rendering {
    // The rows are collected in order, and joined in order below, so the result does not depend on the number of
    // threads.
    let rows: Vec<Row> = (0..options.height)
        .into_par_iter()
        .map(|y| {
            let mut row = Row::new(options);
            let mut tracer = Tracer { structure, scene, options, row: &mut row, work: Work::default() };
            (0..options.width).for_each(|x| tracer.pixel(camera, x, y));
            rows_done(1);
            row
        })
        .collect();
    let mut totals = [ClassTotals::default(); RayClass::WAVES];
    for row in &rows {
        totals.iter_mut().zip(&row.totals).for_each(|(sum, class)| sum.merge(class));
    }
    let rays = options.keep_rays.then(|| join_waves(&rows, &totals));
    let pixels = rows.into_iter().flat_map(|row| row.pixels).collect();
    Rendering { width: options.width, height: options.height, pixels, totals, rays }
}

/// Renders one pixel with valid options.
pub(super) fn pixel<S: Trace>(
    structure: &S,
    scene: &Scene,
    camera: &CameraRays,
    options: &RenderOptions,
    [x, y]: [u32; 2],
) -> Pixel {
    let mut row = Row::new(options);
    Tracer { structure, scene, options, row: &mut row, work: Work::default() }.pixel(camera, x, y);
    row.pixels.pop().expect("one pixel")
}

fn join_waves(rows: &[Row], totals: &[ClassTotals; RayClass::WAVES]) -> RayStream {
    let mut stream = RayStream::default();
    stream.rays.reserve_exact(totals.iter().map(|class| class.rays as usize).sum());
    for wave in 0..RayClass::WAVES {
        let first = stream.rays.len();
        rows.iter().for_each(|row| stream.rays.extend_from_slice(&row.rays[wave]));
        let rays = (stream.rays.len() - first) as u32;
        if rays > 0 {
            stream.waves.push(Wave { class: RayClass::of_wave(wave), rays });
        }
    }
    stream
}

/// The results of one row.
struct Row {
    pixels: Vec<Pixel>,
    totals: [ClassTotals; RayClass::WAVES],
    rays: [Vec<Ray>; RayClass::WAVES],
}

impl Row {
    fn new(options: &RenderOptions) -> Self {
        Self {
            pixels: Vec::with_capacity(options.width as usize),
            totals: Default::default(),
            rays: Default::default(),
        }
    }
}

struct Tracer<'a, S> {
    structure: &'a S,
    scene: &'a Scene,
    options: &'a RenderOptions,
    row: &'a mut Row,
    /// The work of the current pixel.
    work: Work,
}

impl<S: Trace> Tracer<'_, S> {
    fn pixel(&mut self, camera: &CameraRays, x: u32, y: u32) {
        let index = u64::from(y) * u64::from(self.options.width) + u64::from(x);
        let samples = PixelSamples::new(self.options.seed, index);
        self.work = Work::default();
        let mut sum = DVec3::ZERO;
        let mut seen = None;
        for sample in 0..self.options.samples {
            let [dx, dy] = samples.place(sample);
            let ray = camera.ray(f64::from(x) + dx, f64::from(y) + dy);
            let (radiance, first) = self.path(ray, samples, sample);
            sum += radiance;
            if sample == 0 {
                seen = first;
            }
        }
        let rgb = (sum / f64::from(self.options.samples)).to_array().map(|c| c as f32);
        let pixel = Pixel {
            rgb,
            depth: f32::INFINITY,
            normal: [0.0; 3],
            triangle: Pixel::NO_TRIANGLE,
            work: self.work,
        };
        self.row.pixels.push(match seen {
            None => pixel,
            Some((hit, surface)) => Pixel {
                depth: hit.t,
                normal: surface.normal.to_array().map(|c| c as f32),
                triangle: hit.triangle,
                ..pixel
            },
        });
    }

    /// The radiance along `ray`, and what it hits first.
    fn path(&mut self, mut ray: Ray, samples: PixelSamples, sample: u32) -> (DVec3, Option<(Hit, Surface)>) {
        let bounces = self.options.test.bounces();
        let mut radiance = DVec3::ZERO;
        // All surfaces reflect all colours alike.
        let mut throughput = 1.0;
        let mut first = None;
        for vertex in 0..=bounces {
            let Some(hit) = self.closest(2 * vertex, &ray) else {
                radiance += throughput * colour(self.options.background);
                break;
            };
            let corners = self.scene.mesh.corners(hit.triangle as usize);
            let surface = Surface::new(corners, &hit, ray.direction);
            if vertex == 0 {
                first = Some((hit, surface));
            }
            throughput *= ALBEDO;
            radiance += throughput * FRAC_1_PI * self.irradiance(2 * vertex + 1, &surface);
            if vertex < bounces {
                let direction = cosine_direction(surface.normal, samples.bounce(sample, vertex));
                ray = Ray::new(surface.origin, direction.to_array().map(|c| c as f32));
            }
        }
        (radiance, first)
    }

    /// The light that reaches `surface` from the point light.
    fn irradiance(&mut self, wave: usize, surface: &Surface) -> DVec3 {
        let light = &self.scene.light;
        let origin = surface.origin;
        let direction: [f32; 3] = std::array::from_fn(|axis| light.position[axis] - origin[axis]);
        let towards = colour(direction);
        let cosine_times_distance = surface.normal.dot(towards);
        if cosine_times_distance <= 0.0 {
            return DVec3::ZERO;
        }
        // The direction reaches from the surface to the light at t = 1.
        let ray = Ray { origin, direction, t_min: 0.0, t_max: 1.0 };
        if self.occluded(wave, &ray) {
            return DVec3::ZERO;
        }
        let squared = towards.length_squared();
        colour(light.intensity) * (cosine_times_distance / squared.sqrt() / squared)
    }

    fn closest(&mut self, wave: usize, ray: &Ray) -> Option<Hit> {
        let mut counters = Counters::default();
        let (structure, count) = (self.structure, self.options.count_work);
        let hit = TraversalRay::new(ray, self.options.mode).and_then(|ray| match count {
            true => structure.closest_prepared(&ray, &mut counters),
            false => structure.closest_prepared(&ray, &mut NoObserver),
        });
        self.record(wave, ray, hit.is_some(), counters);
        hit
    }

    fn occluded(&mut self, wave: usize, ray: &Ray) -> bool {
        let mut counters = Counters::default();
        let (structure, count) = (self.structure, self.options.count_work);
        let hit = TraversalRay::new(ray, self.options.mode).is_some_and(|ray| match count {
            true => structure.occluded_prepared(&ray, &mut counters),
            false => structure.occluded_prepared(&ray, &mut NoObserver),
        });
        self.record(wave, ray, hit, counters);
        hit
    }

    fn record(&mut self, wave: usize, ray: &Ray, hit: bool, counters: Counters) {
        self.work.add(&counters);
        self.row.totals[wave].merge(&ClassTotals { rays: 1, hits: u64::from(hit), counters });
        if self.options.keep_rays {
            self.row.rays[wave].push(*ray);
        }
    }
}

/// Three components in double precision.
fn colour(rgb: [f32; 3]) -> DVec3 {
    DVec3::from_array(rgb.map(f64::from))
}
