//! Cloth, lamps and urns.

use std::f64::consts::{FRAC_PI_2, TAU};

use glam::{DVec2, DVec3};

use super::{BAY, BAYS, CLOTH, FLOORS, GALLERY, WALL, sides};
use crate::procedural::builder::{Grid, MeshBuilder, moved, sin_cos, turned};
use crate::procedural::random::{Random, fractal_noise};
use crate::procedural::shapes::{block_on, lathe, torus, tube};

/// Long banners that hang from the upper storey into the court.
pub(super) fn banners(b: &mut MeshBuilder, seed: u64) {
    for (number, side) in sides().iter().enumerate().filter(|(_, side)| side.bays == BAYS[0]) {
        side.build(b, FLOORS[1] + 0.75, |b| {
            for (i, x) in side.columns().enumerate().filter(|(i, _)| i % 2 == 1 - number / 2) {
                b.at(moved(x, 0.0, WALL * 0.5 + 0.75), |b| {
                    let item = (number * 100 + i) as u64;
                    cloth(b, seed, item, 1.5, 4.2, [26, 46], 2.5);
                    let ends = [DVec3::new(-0.95, 0.03, 0.0), DVec3::new(0.95, 0.03, 0.0)];
                    tube(b, &ends, 6, true, |_| 0.035);
                    for x in [-0.7, 0.7] {
                        tube(b, &[DVec3::new(x, 0.03, 0.0), DVec3::new(x, 0.15, -0.75)], 5, false, |_| 0.02);
                    }
                });
            }
        });
    }
}

/// Curtains in some arches of the lower arcade, drawn to one side.
pub(super) fn curtains(b: &mut MeshBuilder, seed: u64) {
    for (number, side) in sides().iter().enumerate() {
        side.build(b, 3.3, |b| {
            for (i, x) in side.bay_centers().enumerate().filter(|(i, _)| i % 3 == number % 3) {
                let half = 0.5 * (BAY - 1.0);
                let ends = [DVec3::new(x - half, 0.03, 0.0), DVec3::new(x + half, 0.03, 0.0)];
                tube(b, &ends, 6, true, |_| 0.03);
                let shift = if i % 2 == 0 { -0.45 } else { 0.45 };
                b.at(moved(x + shift, 0.0, 0.0), |b| {
                    cloth(b, seed, (1000 + number * 100 + i) as u64, 1.1, 3.1, [30, 30], 5.0);
                });
            }
        });
    }
}

/// A cloth that hangs from a rod: width and height in metres, falling in folds that widen downward.
fn cloth(b: &mut MeshBuilder, seed: u64, item: u64, width: f64, height: f64, cells: [u32; 2], folds: f64) {
    let mut random = Random::new(seed, CLOTH, item);
    let phase = random.range(0.0, TAU);
    let swing = random.range(-0.12, 0.12);
    let columns = b.segments(cells[0], 3);
    let rows = b.segments(cells[1], 2);
    let key = seed ^ random.bits();
    b.grid(Grid::open(columns, rows), |u, v| {
        let down = 1.0 - v;
        let wander = fractal_noise(key, DVec3::new(u * 4.0, down * 2.0, 0.5), 3);
        let (fold, _) = sin_cos(u * TAU * folds + phase + 1.5 * wander);
        let deep = 0.03 + 0.12 * down;
        let sag = 0.05 * (1.0 - (2.0 * u - 1.0) * (2.0 * u - 1.0)) * down;
        DVec3::new(
            (u - 0.5) * width * (1.0 - 0.12 * down * (1.0 - down)) + 0.05 * wander * down,
            -height * down - sag,
            fold * deep + swing * down * down + 0.15 * wander * down,
        )
    });
}

/// Lamps that hang on chains from the roof and along the galleries.
pub(super) fn lamps(b: &mut MeshBuilder) {
    let hang = |b: &mut MeshBuilder, top: f64, length: f64, size: f64| {
        b.repeat((length / (0.16 * size)) as u32, 2, |b, i, links| {
            let y = top - length * (f64::from(i) + 0.5) / f64::from(links);
            b.at(moved(0.0, y, 0.0) * turned(FRAC_PI_2 * f64::from(i % 2)), |b| {
                let half = length / f64::from(links) * 0.55;
                let way = [
                    DVec3::new(0.0, half, 0.0),
                    DVec3::new(half * 0.5, 0.0, 0.0),
                    DVec3::new(0.0, -half, 0.0),
                    DVec3::new(-half * 0.5, 0.0, 0.0),
                    DVec3::new(0.0, half, 0.0),
                ];
                tube(b, &way, 4, false, |_| 0.012 * size);
            });
        });
        let p = |r: f64, y: f64| DVec2::new(r * size, y * size);
        let bowl = [
            p(0.0, -0.42),
            p(0.05, -0.4),
            p(0.22, -0.28),
            p(0.3, -0.1),
            p(0.26, 0.0),
            p(0.22, -0.1),
            p(0.0, -0.3),
        ];
        b.at(moved(0.0, top - length, 0.0), |b| {
            lathe(b, &bowl, true, 14, 10);
            torus(b, DVec3::new(0.0, -0.05 * size, 0.0), 0.31 * size, 0.03 * size, 14, 4);
        });
    };
    for x in [-1.0, 1.0, 3.0] {
        b.at(moved(x * BAY, 0.0, 0.0), |b| hang(b, FLOORS[2] + 3.4, 4.6, 1.8));
    }
    for side in sides() {
        side.build(b, 0.0, |b| {
            for x in side.bay_centers() {
                b.at(moved(x, 0.0, -GALLERY * 0.5), |b| b.optional(|b| hang(b, FLOORS[1] - 0.32, 1.3, 0.8)));
            }
        });
    }
}

/// Urns on pedestals in the court, between the columns.
pub(super) fn urns(b: &mut MeshBuilder) {
    let p = DVec2::new;
    let urn = [
        p(0.0, 0.0),
        p(0.22, 0.0),
        p(0.2, 0.08),
        p(0.08, 0.16),
        p(0.12, 0.24),
        p(0.3, 0.42),
        p(0.34, 0.6),
        p(0.27, 0.78),
        p(0.2, 0.84),
        p(0.26, 0.94),
        p(0.22, 0.94),
        p(0.15, 0.8),
        p(0.0, 0.5),
    ];
    for side in sides().iter().filter(|side| side.bays == BAYS[0]) {
        side.build(b, 0.0, |b| {
            for x in side.columns().filter(|x| (x / BAY) as i64 % 2 == 0) {
                b.at(moved(x, 0.0, 1.3), |b| {
                    block_on(b, DVec3::ZERO, DVec3::new(0.7, 0.12, 0.7), [1, 1, 1]);
                    block_on(b, DVec3::new(0.0, 0.12, 0.0), DVec3::new(0.56, 0.6, 0.56), [1, 1, 1]);
                    block_on(b, DVec3::new(0.0, 0.72, 0.0), DVec3::new(0.66, 0.08, 0.66), [1, 1, 1]);
                    b.at(moved(0.0, 0.8, 0.0), |b| lathe(b, &urn, true, 20, 22));
                });
            }
        });
    }
}
