//! The atrium with a finely tessellated statue: a horned serpent coiled around a rock.
//!
//! Stands for Dragon Sponza, the Sponza atrium with the Stanford dragon (1.15 M triangles): three quarters of
//! the triangles in a small part of the space, each a fraction of a pixel.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::{DVec2, DVec3};

use super::atrium;
use super::builder::{Grid, MeshBuilder, facing, moved, sin_cos, turned};
use super::random::{fractal_noise, lerp};
use super::shapes::{ball, block_on, catmull_rom, lathe, tube};
use crate::mesh::{Camera, PointLight};

const SKIN: u64 = 11;
const ROCK: u64 = 12;

pub(super) fn generate(b: &mut MeshBuilder, seed: u64) {
    atrium::generate(b, seed);
    b.at(moved(-1.5, 0.0, 0.4) * turned(-1.1), |b| {
        pedestal(b);
        b.at(moved(0.0, 0.9, 0.0), |b| {
            rock(b, seed);
            serpent(b, seed);
        });
    });
}

fn pedestal(b: &mut MeshBuilder) {
    block_on(b, DVec3::ZERO, DVec3::new(4.4, 0.2, 4.4), [6, 1, 6]);
    block_on(b, DVec3::new(0.0, 0.2, 0.0), DVec3::new(4.0, 0.15, 4.0), [6, 1, 6]);
    let p = DVec2::new;
    let drum =
        [p(1.9, 0.35), p(1.9, 0.42), p(1.72, 0.5), p(1.72, 0.76), p(1.86, 0.8), p(1.86, 0.9), p(0.0, 0.9)];
    lathe(b, &drum, false, 72, 1);
}

fn rock(b: &mut MeshBuilder, seed: u64) {
    ball(b, DVec3::new(0.0, 0.5, 0.0), 150, 130, |d| {
        let rough = fractal_noise(seed ^ ROCK, d * 2.1, 6);
        let tall = 1.0 + 0.55 * d.y * d.y;
        (0.72 + 0.4 * rough) * tall
    });
}

fn serpent(b: &mut MeshBuilder, seed: u64) {
    let spine = Spine::new();
    body(b, seed, &spine);
    let neck = spine.at(1.0);
    b.at(facing(neck.point, spine.head_direction(), DVec3::Y), |b| head(b, seed));
}

/// The line through the serpent, from the tip of the tail to the head.
struct Spine {
    points: Vec<DVec3>,
}

/// A place on the spine.
struct Section {
    point: DVec3,
    tangent: DVec3,
    /// Direction of the crest on the back.
    back: DVec3,
}

impl Spine {
    const COIL_POINTS: u32 = 34;

    fn new() -> Self {
        let coils = (0..Self::COIL_POINTS).map(|i| {
            let t = f64::from(i) / f64::from(Self::COIL_POINTS - 1);
            let (sin, cos) = sin_cos(-0.6 + t * TAU * 2.55);
            let radius = 1.42 - 0.55 * t * t;
            let rise = 0.1 + 1.75 * t * t * (0.6 + 0.4 * t);
            DVec3::new(radius * sin, rise, radius * cos)
        });
        let neck = [
            DVec3::new(-0.06, 2.16, -0.84),
            DVec3::new(-0.22, 2.45, -0.74),
            DVec3::new(-0.2, 2.8, -0.56),
            DVec3::new(-0.09, 3.18, -0.4),
            DVec3::new(0.0, 3.58, -0.12),
            DVec3::new(0.0, 3.82, 0.35),
            DVec3::new(0.0, 3.8, 0.62),
        ];
        Self { points: coils.chain(neck).collect() }
    }

    fn head_direction(&self) -> DVec3 {
        DVec3::new(0.0, -0.22, 1.0)
    }

    fn at(&self, t: f64) -> Section {
        const STEP: f64 = 1e-4;
        let point = catmull_rom(&self.points, t);
        let ahead = catmull_rom(&self.points, (t + STEP).min(1.0));
        let behind = catmull_rom(&self.points, (t - STEP).max(0.0));
        let tangent = (ahead - behind).normalize();
        // On the coils the back points up and outward, on the neck backward.
        let neck = smooth_step((t - 0.78) / 0.16);
        let outward = DVec3::new(point.x, 0.0, point.z) * 0.5;
        let wanted = (DVec3::Y + outward).lerp(DVec3::new(0.0, 0.25, -1.0), neck);
        let back = (wanted - tangent * tangent.dot(wanted)).normalize();
        Section { point, tangent, back }
    }
}

fn smooth_step(t: f64) -> f64 {
    let t = t.clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

fn body_radius(t: f64) -> f64 {
    let tail = (1.0 - (1.0 - t / 0.55).max(0.0) * (1.0 - t / 0.55).max(0.0)) * 0.36;
    lerp(tail.max(0.015), 0.2, smooth_step((t - 0.55) / 0.4))
}

/// A tube with scales, plates on the belly and spikes along the back.
fn body(b: &mut MeshBuilder, seed: u64, spine: &Spine) {
    const RINGS: f64 = 150.0;
    const SCALES_AROUND: f64 = 30.0;
    const SPIKES: f64 = 62.0;
    let columns = b.segments(390, 6);
    let rows = b.segments(920, 24);
    let mut current = (f64::NAN, spine.at(0.0));
    b.grid(Grid { first_pole: true, ..Grid::closed(columns, rows) }, |u, v| {
        if v != current.0 {
            current = (v, spine.at(v));
        }
        let section = &current.1;
        if v == 0.0 {
            return section.point - section.tangent * 0.05;
        }
        // From -1 to 1 around the body, 0 at the back.
        let around = if u > 0.5 { 2.0 * u - 2.0 } else { 2.0 * u };
        let radius = body_radius(v);
        let ring = v * RINGS;
        let fall = ring - ring.floor();
        let belly = smooth_step((around.abs() - 0.66) * 12.0);
        let slot = u * SCALES_AROUND + if (ring as u64).is_multiple_of(2) { 0.0 } else { 0.5 };
        let across = (slot - slot.floor()) * 2.0 - 1.0;
        let scale = 0.13 * (1.0 - fall) * (1.0 - across * across);
        let plate = 0.1 * (1.0 - fall) * fall * 4.0;
        let muscle =
            0.1 * fractal_noise(seed ^ SKIN, section.point * 2.5 + section.back * (1.0 - around.abs()), 3);
        let spike_place = v * SPIKES;
        let along_spike = (spike_place - spike_place.floor()) * 2.0 - 1.0;
        let narrow = (1.0 - around.abs() * 14.0).max(0.0);
        let lean = (1.0 - along_spike.abs()).max(0.0);
        let spike = 0.85 * narrow * lean * lean * (1.0 - 0.4 * v);
        let r = radius * (0.92 + lerp(scale, plate, belly) + muscle + spike);
        let (sin, cos) = sin_cos(u * TAU);
        let side = section.tangent.cross(section.back);
        section.point + (section.back * cos + side * sin) * r
    });
}

/// The head looks along z; its origin is the end of the neck.
fn head(b: &mut MeshBuilder, seed: u64) {
    let skin = move |p: DVec3| fractal_noise(seed ^ SKIN, p * 9.0, 4);
    // Skull and upper jaw.
    ball(b, DVec3::new(0.0, 0.06, 0.18), 190, 150, |d| {
        let forward = d.z.max(0.0);
        let length = 0.27 + 0.36 * forward * forward * forward;
        let flat = 1.0 - 0.28 * d.y * d.y - 0.2 * forward * d.x * d.x;
        let brow_place = DVec3::new(d.x.abs() - 0.45, d.y - 0.55, d.z - 0.55).length();
        let brow = 0.09 * smooth_step(1.0 - brow_place * 3.2);
        let nostril_place = DVec3::new(d.x.abs() - 0.1, d.y - 0.2, d.z - 0.97).length();
        let nostril = 0.07 * smooth_step(1.0 - nostril_place * 8.0);
        let lip = 0.05 * smooth_step(1.0 - (d.y + 0.25).abs() * 9.0) * forward;
        (length + brow - nostril + lip) * flat * (1.0 + 0.05 * skin(d))
    });
    // Lower jaw, open.
    b.at(facing(DVec3::new(0.0, -0.08, 0.14), DVec3::new(0.0, -0.42, 1.0), DVec3::Y), |b| {
        ball(b, DVec3::ZERO, 110, 90, |d| {
            let forward = d.z.max(0.0);
            let hollow = 0.12 * smooth_step(d.y * 2.0) * forward;
            (0.17 + 0.34 * forward * forward * forward - hollow)
                * (1.0 - 0.5 * d.y * d.y)
                * (1.0 + 0.05 * skin(d))
        });
        teeth(b, 0.045, 1.0);
    });
    b.at(moved(0.0, -0.06, 0.2), |b| teeth(b, 0.02, -1.0));
    for side in [-1.0, 1.0] {
        ball(b, DVec3::new(side * 0.2, 0.18, 0.4), 28, 20, |_| 0.06);
        horn(b, side);
        whiskers(b, side);
        ear(b, side);
    }
}

fn teeth(b: &mut MeshBuilder, height: f64, direction: f64) {
    b.repeat(22, 4, |b, i, count| {
        let t = (f64::from(i) + 0.5) / f64::from(count) * 2.0 - 1.0;
        let (sin, cos) = sin_cos(t * 1.35);
        let root = DVec3::new(0.14 * sin, height, 0.1 + 0.3 * cos);
        let length = 0.06 + 0.05 * t.abs() * (1.0 - t.abs()) * 4.0;
        let sides = b.segments(10, 4);
        let tip = root + DVec3::new(0.0, direction * length, -0.01);
        let path: Vec<DVec3> = (0..=4).map(|k| root.lerp(tip, f64::from(k) * 0.25)).collect();
        tube(b, &path, sides, false, |t| 0.018 * (1.02 - t * t));
    });
}

fn horn(b: &mut MeshBuilder, side: f64) {
    let way = [
        DVec3::new(side * 0.12, 0.22, 0.06),
        DVec3::new(side * 0.2, 0.42, -0.08),
        DVec3::new(side * 0.32, 0.56, -0.34),
        DVec3::new(side * 0.38, 0.58, -0.66),
        DVec3::new(side * 0.34, 0.68, -0.92),
    ];
    let spans = b.segments(160, 5);
    let sides = b.segments(36, 4);
    let path: Vec<DVec3> = (0..=spans).map(|i| catmull_rom(&way, f64::from(i) / f64::from(spans))).collect();
    tube(b, &path, sides, false, |t| {
        let (ring, _) = sin_cos(t * TAU * 22.0);
        0.068 * (1.02 - t) * (1.0 + 0.07 * ring)
    });
}

fn whiskers(b: &mut MeshBuilder, side: f64) {
    b.repeat(5, 1, |b, i, _| {
        let spread = f64::from(i) * 0.22;
        let way = [
            DVec3::new(side * 0.1, 0.02 - 0.02 * spread, 0.66 - 0.2 * spread),
            DVec3::new(side * (0.34 + 0.1 * spread), 0.05 - 0.3 * spread, 0.7 - 0.3 * spread),
            DVec3::new(side * (0.5 + 0.2 * spread), -0.25 - 0.3 * spread, 0.5 - 0.5 * spread),
            DVec3::new(side * (0.6 + 0.1 * spread), -0.3 - 0.5 * spread, 0.2 - 0.5 * spread),
        ];
        let spans = b.segments(60, 6);
        let sides = b.segments(8, 3);
        let path: Vec<DVec3> =
            (0..=spans).map(|i| catmull_rom(&way, f64::from(i) / f64::from(spans))).collect();
        tube(b, &path, sides, false, |t| 0.012 * (1.05 - t));
    });
}

/// A ribbed fin behind the jaw.
fn ear(b: &mut MeshBuilder, side: f64) {
    let columns = b.segments(90, 5);
    let rows = b.segments(40, 2);
    b.grid(Grid::open(columns, rows), |u, v| {
        let (sin, cos) = sin_cos(lerp(-0.5, 1.3, u) + FRAC_PI_2);
        let (rib, _) = sin_cos(u * PI * 12.0);
        let reach = 0.08 + v * (0.34 + 0.07 * rib.abs());
        DVec3::new(side * (0.14 + 0.32 * v + 0.02 * rib * v), 0.08 + reach * cos * -0.7, -reach * sin)
    });
}

pub(super) fn view() -> (Camera, PointLight) {
    let camera =
        Camera { eye: [-9.2, 2.5, -1.6], target: [-1.0, 2.9, 0.3], up: [0.0, 1.0, 0.0], fov_y_degrees: 60.0 };
    (camera, PointLight { position: [-5.0, 8.6, -2.4], intensity: [120.0; 3] })
}
