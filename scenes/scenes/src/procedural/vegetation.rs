//! A clearing overgrown with ferns, grass, bushes and palms.
//!
//! Stands for Vegetation (1.1 to 1.9 M triangles in the literature): leaves that overlap at every scale, so
//! that boxes overlap too and rays pass close by many triangles without hitting them.

use std::f64::consts::TAU;

use glam::{DAffine3, DVec3};

use super::builder::{Grid, MeshBuilder, Part, moved, scaled, sin_cos, turned};
use super::plants::{broad_leaved, bush, fern, grass, palm, variants};
use super::random::{Random, fractal_noise, lerp};
use crate::mesh::{Camera, PointLight};

/// Half the size of the ground in metres.
const GROUND: f64 = 16.0;
const PLACE: u64 = 21;
const TERRAIN: u64 = 22;
const SHAPE: u64 = 2300;

pub(super) fn generate(b: &mut MeshBuilder, seed: u64) {
    ground(b, seed);
    stones(b, seed);
    let ferns = variants(b, 4, |b, i| fern(b, seed, SHAPE + u64::from(i), 1.2));
    let broad = variants(b, 4, |b, i| broad_leaved(b, seed, SHAPE + 100 + u64::from(i), 1.0));
    let tufts = variants(b, 5, |b, i| grass(b, seed, SHAPE + 200 + u64::from(i), 0.7));
    let bushes = variants(b, 3, |b, i| bush(b, seed, SHAPE + 300 + 2 * u64::from(i), 1.5, 310));
    let palms = variants(b, 3, |b, i| palm(b, seed, SHAPE + 400 + 2 * u64::from(i), 4.5));
    plant(b, seed, 0, &ferns, 56, 6, 1.0);
    plant(b, seed, 1, &broad, 140, 8, 0.9);
    plant(b, seed, 2, &tufts, 380, 12, 0.35);
    plant(b, seed, 3, &bushes, 60, 4, 1.4);
    plant(b, seed, 4, &palms, 26, 3, 2.6);
}

/// Metres above 0 at (x, z): low in the middle, where the path is, rising to the sides and the back.
fn height(seed: u64, x: f64, z: f64) -> f64 {
    let hills = 1.5 * fractal_noise(seed ^ TERRAIN, DVec3::new(x * 0.16, z * 0.16, 0.3), 2);
    let rise = (x - path(z)) * (x - path(z)) * 0.012 + (GROUND - z) * 0.03;
    hills * ((x - path(z)).abs() * 0.25).min(1.0) + rise
}

/// The x of the path at z.
fn path(z: f64) -> f64 {
    let (sin, _) = sin_cos(z * 0.22);
    1.6 * sin
}

fn ground(b: &mut MeshBuilder, seed: u64) {
    let columns = b.segments(170, 12);
    let rows = b.segments(170, 12);
    b.grid(Grid::open(columns, rows), |u, v| {
        let (x, z) = (lerp(-GROUND, GROUND, u), lerp(GROUND, -GROUND, v));
        let rough = 0.08 * fractal_noise(seed ^ TERRAIN ^ 1, DVec3::new(x, z, 0.0) * 1.9, 4);
        DVec3::new(x, height(seed, x, z) + rough, z)
    });
}

fn stones(b: &mut MeshBuilder, seed: u64) {
    b.repeat(90, 6, |b, i, _| {
        let mut random = Random::new(seed, PLACE + 100, i.into());
        let z = random.range(-GROUND, GROUND);
        let x = path(z) + random.range(-3.0, 3.0);
        let size = random.range(0.08, 0.4);
        let key = random.bits();
        b.at(moved(x, height(seed, x, z), z) * scaled(size), |b| {
            super::shapes::ball(b, DVec3::ZERO, 22, 14, |d| {
                (1.0 + 0.5 * fractal_noise(key, d * 1.3, 3)) * (1.0 - 0.3 * d.y * d.y)
            });
        });
    });
}

/// Puts up to `full` plants on the ground, `clear` metres away from the middle of the path.
fn plant(b: &mut MeshBuilder, seed: u64, kind: u64, parts: &[Part], full: u32, least: u32, clear: f64) {
    b.repeat(full, least, |b, i, count| {
        let mut random = Random::new(seed, PLACE + kind, i.into());
        let part = &parts[i as usize % parts.len()];
        if b.is_counting() {
            b.instance(part, DAffine3::IDENTITY);
            return;
        }
        // More of them near the path and the eye, where they are seen.
        let depth = random.unit();
        let z = lerp(GROUND - 4.0, -GROUND, depth);
        let reach = lerp(5.0, GROUND - 2.0, depth) * random.unit() + clear;
        let x = path(z) + if random.unit() < 0.5 { -reach } else { reach };
        let grown = (f64::from(full) / f64::from(count)).sqrt().min(1.7) * random.range(0.7, 1.25);
        let place = moved(x, height(seed, x, z) - 0.03, z) * turned(random.range(0.0, TAU)) * scaled(grown);
        b.instance(part, place);
    });
}

pub(super) fn view() -> (Camera, PointLight) {
    let camera =
        Camera { eye: [1.3, 2.1, 14.6], target: [-0.4, 1.5, 2.0], up: [0.0, 1.0, 0.0], fov_y_degrees: 55.0 };
    (camera, PointLight { position: [9.0, 26.0, 14.0], intensity: [1700.0; 3] })
}
