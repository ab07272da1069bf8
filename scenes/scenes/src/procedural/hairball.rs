//! A ball of tangled hairs: thin tubes that wind around a core in all directions.
//!
//! Stands for the hairball of Samuli Laine and Tero Karras (2.88 M triangles): long thin triangles in no
//! particular direction, boxes that overlap everywhere, and no occlusion to speak of.

use std::f64::consts::TAU;

use glam::DVec3;

use super::builder::{MeshBuilder, sin_cos};
use super::random::{Random, lerp};
use super::shapes::tube;
use crate::mesh::{Camera, PointLight};

const HAIRS: u32 = 5000;
const SPANS: u32 = 72;
const SIDES: u32 = 4;
/// At coarse levels hairs are fewer, and thicker, but never fewer than this.
const FEWEST_HAIRS: u32 = 60;
const HAIR: u64 = 1;

/// The ball, of radius 5 around the origin.
pub(super) fn generate(b: &mut MeshBuilder, seed: u64) {
    b.repeat(HAIRS, FEWEST_HAIRS, |b, hair, hairs| {
        let thickness = 0.007 * (f64::from(HAIRS) / f64::from(hairs)).sqrt();
        let spans = b.segments(SPANS, 8);
        let sides = b.segments(SIDES, 3);
        let path =
            if b.is_counting() { vec![DVec3::ZERO; spans as usize + 1] } else { wind(seed, hair, spans) };
        tube(b, &path, sides, false, |t| thickness * (1.15 - t));
    });
}

/// A walk on a sphere that slowly drifts outward while its direction turns.
fn wind(seed: u64, hair: u32, spans: u32) -> Vec<DVec3> {
    let mut random = Random::new(seed, HAIR, hair.into());
    let root = random.direction();
    let sideways = root.cross(random.direction()).normalize_or(root.any_orthonormal_vector());
    let (start, end) = (random.range(0.6, 3.2), random.range(3.4, 5.0));
    let turn = random.range(1.5, 7.0);
    let (curl, curl_phase) = (random.range(4.0, 16.0), random.range(0.0, TAU));
    let (wave, wave_phase) = (random.range(1.0, 4.0), random.range(0.0, TAU));
    let amplitude = random.range(0.02, 0.25);
    let axis = root.cross(sideways);
    (0..=spans)
        .map(|i| {
            let t = f64::from(i) / f64::from(spans);
            let (sin, cos) = sin_cos(t * turn);
            let (wave_sin, _) = sin_cos(t * wave + wave_phase);
            let (curl_sin, curl_cos) = sin_cos(t * curl + curl_phase);
            let direction = (root * cos + sideways * sin + axis * (0.6 * wave_sin * t)).normalize();
            let radius = lerp(start, end, t * (2.0 - t)) - amplitude * (1.0 + curl_cos) * 0.5;
            direction * radius + axis * (curl_sin * amplitude * t)
        })
        .collect()
}

pub(super) fn view() -> (Camera, PointLight) {
    let camera =
        Camera { eye: [4.0, 3.2, 12.0], target: [0.0, 0.0, 0.0], up: [0.0, 1.0, 0.0], fov_y_degrees: 45.0 };
    (camera, PointLight { position: [6.0, 10.0, 11.0], intensity: [600.0; 3] })
}
