//! The integrator: paths, row by row in parallel.

use super::frame::Frame;
use super::output::{ClassTotals, Pixel, Rendering, Work};
use super::sampling::PixelSamples;
use super::shading::{Surface, cosine_direction, surface, towards_light};
use super::stream::{RayClass, RayStream, Wave};
use super::{ALBEDO, RenderOptions};
use golden::Ray;
use golden::ray::{Hit, TraversalRay};
use golden::traverse::{Counters, NoObserver, Trace};
use rayon::prelude::*;
use scenes::Mesh;

/// Renders with valid options.
pub(super) fn render<S: Trace>(
    structure: &S,
    mesh: &Mesh,
    frame: &Frame,
    options: &RenderOptions,
    rows_done: impl Fn(u64) + Sync,
) -> Rendering {
    // The rows are collected in order, and joined in order below, so the result does not depend on the number of
    // threads.
    let rows: Vec<Row> = (0..options.height)
        .into_par_iter()
        .map(|y| {
            let mut row = Row::new(options);
            let mut tracer = Tracer { structure, mesh, frame, options, row: &mut row, work: Work::default() };
            (0..options.width).for_each(|x| tracer.pixel(x, y));
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

/// Renders one pixel with valid options; also the number of its rays.
pub(super) fn pixel<S: Trace>(
    structure: &S,
    mesh: &Mesh,
    frame: &Frame,
    options: &RenderOptions,
    [x, y]: [u32; 2],
) -> (Pixel, u64) {
    let mut row = Row::new(options);
    Tracer { structure, mesh, frame, options, row: &mut row, work: Work::default() }.pixel(x, y);
    (row.pixels.pop().expect("one pixel"), row.totals.iter().map(|class| class.rays).sum())
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
    mesh: &'a Mesh,
    frame: &'a Frame,
    options: &'a RenderOptions,
    row: &'a mut Row,
    /// The work of the current pixel.
    work: Work,
}

impl<S: Trace> Tracer<'_, S> {
    fn pixel(&mut self, x: u32, y: u32) {
        let index = u64::from(y) * u64::from(self.options.width) + u64::from(x);
        let samples = PixelSamples::new(self.options.seed, index);
        self.work = Work::default();
        let mut sum = [0.0; 3];
        let mut seen = None;
        for sample in 0..self.options.samples {
            let [dx, dy] = samples.place(sample);
            let ray = self.frame.camera.ray(x as f32 + dx, y as f32 + dy);
            let (radiance, first) = self.path(ray, samples, sample);
            add(&mut sum, radiance);
            if sample == 0 {
                seen = first;
            }
        }
        let rgb = sum.map(|channel| channel / self.options.samples as f32);
        let pixel = Pixel {
            rgb,
            depth: f32::INFINITY,
            normal: [0.0; 3],
            triangle: Pixel::NO_TRIANGLE,
            work: self.work,
        };
        self.row.pixels.push(match seen {
            None => pixel,
            Some((hit, surface)) => {
                Pixel { depth: hit.t, normal: surface.normal, triangle: hit.triangle, ..pixel }
            }
        });
    }

    /// The radiance along `ray`, and what it hits first.
    fn path(
        &mut self,
        mut ray: Ray,
        samples: PixelSamples,
        sample: u32,
    ) -> ([f32; 3], Option<(Hit, Surface)>) {
        let bounces = self.frame.bounces;
        let mut radiance = [0.0; 3];
        // All surfaces reflect all colours alike.
        let mut throughput = 1f32;
        let mut first = None;
        for vertex in 0..=bounces {
            let Some(hit) = self.closest(2 * vertex, &ray) else {
                add(&mut radiance, self.frame.background.map(|channel| throughput * channel));
                break;
            };
            let corners = self.mesh.corners(hit.triangle as usize);
            let surface = surface(&corners, &hit, ray.direction);
            if vertex == 0 {
                first = Some((hit, surface));
            }
            throughput *= ALBEDO;
            if let Some(light) = self.light(2 * vertex + 1, &surface, throughput) {
                add(&mut radiance, self.frame.light.intensity.map(|channel| light * channel));
            }
            if vertex < bounces {
                let direction = cosine_direction(surface.normal, samples.bounce(sample, vertex));
                ray = Ray::new(surface.origin, direction);
            }
        }
        (radiance, first)
    }

    /// The light that `surface` reflects, per unit of the light's intensity, if any reaches it.
    fn light(&mut self, wave: usize, surface: &Surface, throughput: f32) -> Option<f32> {
        let light = &self.frame.light;
        let towards = towards_light(surface, light.position)?;
        let reflected = towards.reflected(throughput, light.extent);
        (!self.occluded(wave, &towards.shadow)).then_some(reflected)
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

fn add(sum: &mut [f32; 3], channels: [f32; 3]) {
    sum.iter_mut().zip(channels).for_each(|(sum, channel)| *sum += channel);
}
