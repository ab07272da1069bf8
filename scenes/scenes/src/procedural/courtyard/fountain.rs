//! A basin with two bowls above it and water that falls from one to the next.

use std::f64::consts::TAU;

use glam::{DVec2, DVec3};

use super::FOUNTAIN;
use crate::procedural::builder::{Grid, MeshBuilder, moved, sin_cos};
use crate::procedural::random::lerp;
use crate::procedural::shapes::{lathe, tube};

/// The fountain, in the court.
pub(super) fn build(b: &mut MeshBuilder) {
    let p = DVec2::new;
    b.at(moved(FOUNTAIN.x, 0.0, FOUNTAIN.z), |b| {
        let rim = [
            p(2.3, 0.0),
            p(2.3, 0.1),
            p(2.1, 0.16),
            p(2.05, 0.5),
            p(2.2, 0.58),
            p(2.22, 0.7),
            p(2.1, 0.74),
            p(1.9, 0.72),
            p(1.86, 0.6),
            p(1.84, 0.1),
            p(0.0, 0.05),
        ];
        lathe(b, &rim, true, 160, 90);
        water(b, 1.87, 0.55, 150);
        let stem = [
            p(0.5, 0.05),
            p(0.5, 0.3),
            p(0.3, 0.5),
            p(0.22, 0.9),
            p(0.3, 1.2),
            p(0.18, 1.4),
            p(0.3, 1.55),
            p(0.9, 1.72),
            p(1.05, 1.85),
            p(1.0, 1.9),
            p(0.85, 1.8),
            p(0.2, 1.72),
            p(0.14, 1.9),
            p(0.2, 2.2),
            p(0.12, 2.4),
            p(0.45, 2.55),
            p(0.52, 2.64),
            p(0.46, 2.64),
            p(0.1, 2.56),
            p(0.08, 2.8),
            p(0.14, 2.95),
            p(0.0, 3.15),
        ];
        lathe(b, &stem, true, 110, 220);
        b.at(moved(0.0, 1.3, 0.0), |b| water(b, 0.9, 0.52, 60));
        for (count, from, to, top, bottom) in [(28, 1.03, 1.5, 1.86, 0.55), (16, 0.5, 0.78, 2.64, 1.84)] {
            b.repeat(count, 4, |b, i, count| {
                let (sin, cos) = sin_cos(f64::from(i) / f64::from(count) * TAU);
                let spans = b.segments(30, 4);
                let sides = b.segments(8, 3);
                let path: Vec<DVec3> = (0..=spans)
                    .map(|k| {
                        let t = f64::from(k) / f64::from(spans);
                        let r = lerp(from, to, t);
                        DVec3::new(r * sin, lerp(top, bottom, t * t) + 0.12 * t * (1.0 - t), r * cos)
                    })
                    .collect();
                tube(b, &path, sides, false, |t| 0.018 * (1.2 - 0.7 * t));
            });
        }
    });
}

fn water(b: &mut MeshBuilder, radius: f64, height: f64, cells: u32) {
    let columns = b.segments(cells, 8);
    let rows = b.segments(cells / 2, 2);
    b.grid(Grid { last_pole: true, ..Grid::closed(columns, rows) }, |u, v| {
        let r = radius * (1.0 - v);
        let (sin, cos) = sin_cos(u * TAU);
        let (wave, _) = sin_cos(r * 38.0);
        let (cross, _) = sin_cos(u * TAU * 16.0);
        DVec3::new(r * sin, height + 0.008 * wave + 0.005 * cross * (1.0 - v) * v, r * cos)
    });
}
