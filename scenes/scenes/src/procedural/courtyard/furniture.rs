//! Chairs and laid tables, in metres, standing on y = 0 around the y axis.

use std::f64::consts::{FRAC_PI_2, TAU};

use glam::{DVec2, DVec3};

use crate::procedural::builder::{Grid, MeshBuilder, moved, scaled, sin_cos, turned};
use crate::procedural::plants::grass;
use crate::procedural::random::fractal_noise;
use crate::procedural::shapes::{block_on, catmull_rom, lathe, torus, tube};

const CLOTH: u64 = 41;

/// A wooden chair with a woven seat. A person in it looks along z.
pub(super) fn chair(b: &mut MeshBuilder) {
    let half = 0.21;
    let seat = 0.46;
    for (x, z) in [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)] {
        let top = if z < 0.0 { 1.02 } else { seat };
        let lean = if z < 0.0 { -0.1 } else { 0.0 };
        let way = [
            DVec3::new(x * half, 0.0, z * half - lean * 0.3),
            DVec3::new(x * half, seat, z * half),
            DVec3::new(x * half, top.max(seat + 0.01), z * half + lean),
        ];
        let spans = b.segments(60, 2);
        let sides = b.segments(14, 3);
        let path: Vec<DVec3> =
            (0..=spans).map(|i| catmull_rom(&way, f64::from(i) / f64::from(spans))).collect();
        tube(b, &path, sides, false, |t| {
            let (turned, _) = sin_cos(t * TAU * 5.0);
            0.021 * (1.0 + 0.2 * turned)
        });
    }
    for side in [-1.0, 1.0] {
        for height in [0.14, 0.26] {
            b.optional(|b| {
                let sides = b.segments(10, 3);
                let (x, z) = (DVec3::X * half, DVec3::Z * half);
                let along = DVec3::new(side * half, height, 0.0);
                tube(b, &[along - z, along + z], sides, false, |_| 0.013);
                let across = DVec3::new(0.0, height + 0.04, side * half);
                tube(b, &[across - x, across + x], sides, false, |_| 0.013);
            });
        }
        b.optional(|b| {
            let (x, z) =
                (DVec3::new(side * half, seat - 0.04, 0.0), DVec3::new(0.0, seat - 0.04, side * half));
            block_on(b, x, DVec3::new(0.035, 0.045, 2.0 * half), [1, 1, 4]);
            block_on(b, z, DVec3::new(2.0 * half, 0.045, 0.035), [4, 1, 1]);
        });
    }
    weave(b, seat, half);
    ladder_back(b, seat, half);
}

/// Strips of cane that go over and under each other.
fn weave(b: &mut MeshBuilder, height: f64, half: f64) {
    const STRIPS: u32 = 26;
    for direction in 0..2_u32 {
        b.at(moved(0.0, height, 0.0) * turned(FRAC_PI_2 * f64::from(direction)), |b| {
            b.repeat(STRIPS, 2, |b, i, count| {
                let x = ((f64::from(i) + 0.5) / f64::from(count) * 2.0 - 1.0) * half;
                let width = half / f64::from(count) * 0.85;
                let phase = if (i + direction) % 2 == 0 { 0.0 } else { 0.5 };
                let rows = b.segments(72, 1);
                b.grid(Grid::open(1, rows), |u, v| {
                    let (wave, _) = sin_cos((v * f64::from(count) * 0.5 + phase) * TAU);
                    DVec3::new(x + width * (2.0 * u - 1.0), 0.003 * wave, half * (1.0 - 2.0 * v))
                });
            });
        });
    }
}

fn ladder_back(b: &mut MeshBuilder, seat: f64, half: f64) {
    b.repeat(4, 1, |b, i, count| {
        let y = seat + 0.17 + 0.4 * f64::from(i) / f64::from(count);
        let columns = b.segments(40, 2);
        let rows = b.segments(8, 1);
        for side in [1.0, -1.0] {
            b.grid(Grid::open(columns, rows), |u, v| {
                let s = (2.0 * u - 1.0) * side;
                let bow = 0.035 * (1.0 - s * s);
                let rise = 0.035 * (1.0 - s * s);
                DVec3::new(
                    s * half,
                    y + rise + 0.075 * v,
                    -half - 0.035 - (y - seat) * 0.12 - bow + 0.008 * side,
                )
            });
        }
    });
}

/// A round table with a cloth, laid for four.
pub(super) fn laid_table(b: &mut MeshBuilder, seed: u64) {
    let top = 0.75;
    let p = DVec2::new;
    let foot = [
        p(0.34, 0.0),
        p(0.32, 0.04),
        p(0.1, 0.1),
        p(0.05, 0.2),
        p(0.07, 0.4),
        p(0.05, 0.6),
        p(0.12, 0.7),
        p(0.3, 0.74),
    ];
    lathe(b, &foot, true, 32, 40);
    tablecloth(b, seed, 0.6, top);
    for side in 0..4 {
        b.at(turned(FRAC_PI_2 * f64::from(side)) * moved(0.0, top + 0.006, 0.4), cover);
    }
    b.at(moved(0.0, top, 0.0), |b| {
        let vase = [
            p(0.0, 0.0),
            p(0.04, 0.0),
            p(0.06, 0.05),
            p(0.05, 0.12),
            p(0.025, 0.17),
            p(0.04, 0.21),
            p(0.03, 0.2),
            p(0.0, 0.1),
        ];
        lathe(b, &vase, true, 30, 32);
        b.at(moved(0.0, 0.17, 0.0), |b| grass(b, seed, CLOTH + 1, 0.3));
        b.at(moved(0.16, 0.0, 0.1), bottle);
    });
}

fn tablecloth(b: &mut MeshBuilder, seed: u64, radius: f64, top: f64) {
    let columns = b.segments(150, 8);
    let rows = b.segments(60, 3);
    b.grid(Grid { last_pole: true, ..Grid::closed(columns, rows) }, |u, v| {
        // From the hem up to the edge of the table, then to its middle.
        let (sin, cos) = sin_cos(u * TAU);
        let hang = (1.0 - v * 2.0).max(0.0);
        let inward = (v * 2.0 - 1.0).max(0.0);
        let corner = sin * sin * cos * cos * 4.0;
        let (fold, _) =
            sin_cos(u * TAU * 14.0 + 2.0 * fractal_noise(seed ^ CLOTH, DVec3::new(sin, cos, 0.0) * 2.0, 2));
        let r = radius * (1.0 - inward) + hang * (0.04 + 0.035 * fold);
        DVec3::new(r * sin, top - hang * (0.2 + 0.14 * corner) + 0.004, r * cos)
    });
}

/// Plates, a glass, knife and fork; the guest sits towards z.
fn cover(b: &mut MeshBuilder) {
    let p = DVec2::new;
    let plate = [
        p(0.0, 0.004),
        p(0.06, 0.0),
        p(0.08, 0.004),
        p(0.125, 0.02),
        p(0.127, 0.023),
        p(0.08, 0.01),
        p(0.0, 0.009),
    ];
    lathe(b, &plate, true, 56, 20);
    b.optional(|b| b.at(moved(0.0, 0.012, 0.0) * scaled(0.7), |b| lathe(b, &plate, true, 56, 20)));
    let glass = [
        p(0.0, 0.0),
        p(0.034, 0.0),
        p(0.03, 0.004),
        p(0.006, 0.01),
        p(0.005, 0.07),
        p(0.012, 0.08),
        p(0.034, 0.1),
        p(0.038, 0.14),
        p(0.032, 0.18),
        p(0.03, 0.18),
        p(0.036, 0.14),
        p(0.03, 0.1),
        p(0.0, 0.088),
    ];
    b.at(moved(0.13, 0.0, -0.1), |b| lathe(b, &glass, true, 32, 40));
    b.optional(|b| {
        let knife =
            [DVec3::new(0.16, 0.004, 0.1), DVec3::new(0.16, 0.006, 0.0), DVec3::new(0.165, 0.004, -0.11)];
        piece(b, &knife, 0.006);
        let fork =
            [DVec3::new(-0.16, 0.004, 0.1), DVec3::new(-0.16, 0.004, 0.0), DVec3::new(-0.16, 0.01, -0.06)];
        piece(b, &fork, 0.005);
        for tine in 0..4 {
            let x = -0.16 + 0.006 * (f64::from(tine) - 1.5);
            piece(
                b,
                &[DVec3::new(x, 0.01, -0.06), DVec3::new(x, 0.008, -0.08), DVec3::new(x, 0.012, -0.11)],
                0.0015,
            );
        }
    });
    b.optional(|b| {
        torus(b, DVec3::new(-0.22, 0.02, 0.0), 0.025, 0.004, 28, 10);
        block_on(b, DVec3::new(-0.22, 0.0, 0.02), DVec3::new(0.06, 0.012, 0.12), [4, 1, 6]);
    });
}

fn piece(b: &mut MeshBuilder, way: &[DVec3], thickness: f64) {
    let spans = b.segments(24, 2);
    let sides = b.segments(8, 3);
    let path: Vec<DVec3> = (0..=spans).map(|i| catmull_rom(way, f64::from(i) / f64::from(spans))).collect();
    tube(b, &path, sides, true, |t| thickness * (1.2 - t * 0.6));
}

fn bottle(b: &mut MeshBuilder) {
    let p = DVec2::new;
    let profile = [
        p(0.0, 0.01),
        p(0.035, 0.0),
        p(0.037, 0.02),
        p(0.037, 0.18),
        p(0.03, 0.21),
        p(0.014, 0.24),
        p(0.013, 0.3),
        p(0.016, 0.3),
        p(0.014, 0.32),
        p(0.0, 0.32),
    ];
    lathe(b, &profile, true, 32, 44);
}
