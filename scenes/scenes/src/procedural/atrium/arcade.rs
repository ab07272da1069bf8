//! The open sides of the court: columns, arches and balustrades.

use std::f64::consts::{PI, TAU};

use glam::{DVec2, DVec3};

use super::{BAY, FLOORS, Side, WALL};
use crate::procedural::builder::{Grid, MeshBuilder, moved, sin_cos};
use crate::procedural::random::lerp;
use crate::procedural::shapes::{arch, block_on, lathe};

/// The columns and arches of one side of one storey.
pub(super) fn build(b: &mut MeshBuilder, storey: usize, side: &Side) {
    let floor = FLOORS[storey];
    let height = FLOORS[storey + 1] - floor;
    let (radius, spring) = if storey == 0 { (0.36, 3.4) } else { (0.27, 2.7) };
    side.build(b, floor, |b| {
        for x in side.columns() {
            b.at(moved(x, 0.0, 0.0), |b| column(b, radius, spring));
        }
        for x in side.bay_centers() {
            b.at(moved(x, 0.0, 0.0), |b| {
                arch(b, BAY, height, WALL, BAY - 2.0 * radius - 0.3, spring, 40);
                b.optional(|b| archivolt(b, (BAY - 2.0 * radius - 0.3) * 0.5, spring));
                if storey == 1 {
                    balustrade(b, BAY - 2.0 * radius - 0.1);
                }
            });
        }
    });
}

/// Plinth, base, fluted shaft, capital and abacus.
fn column(b: &mut MeshBuilder, radius: f64, height: f64) {
    let width = radius * 2.7;
    block_on(b, DVec3::ZERO, DVec3::new(width, 0.22, width), [1, 1, 1]);
    let p = |r: f64, y: f64| DVec2::new(r * radius, y);
    let base =
        [p(1.3, 0.22), p(1.34, 0.3), p(1.18, 0.36), p(1.12, 0.42), p(1.2, 0.48), p(1.02, 0.54), p(1.0, 0.6)];
    b.optional(|b| lathe(b, &base, true, 24, 9));

    let top = height - 0.75;
    let columns = b.segments(54, 5);
    let rows = b.segments(5, 1);
    b.grid(Grid::closed(columns, rows), |u, v| {
        let (flute, _) = sin_cos(u * TAU * 20.0);
        let taper = 1.0 - 0.14 * v * v;
        let r = radius * taper * (1.0 - 0.035 * (1.0 + flute));
        let (sin, cos) = sin_cos(u * TAU);
        DVec3::new(r * sin, lerp(0.6, top, v), r * cos)
    });

    let leaves = b.segments(28, 5);
    let rows = b.segments(7, 1);
    b.grid(Grid::closed(leaves, rows), |u, v| {
        let (leaf, _) = sin_cos(u * TAU * 8.0);
        let bell = 0.86 + 0.5 * v * v * v + 0.08 * (1.0 + leaf) * v * (1.0 - 0.4 * v);
        let (sin, cos) = sin_cos(u * TAU);
        DVec3::new(radius * bell * sin, lerp(top, height - 0.2, v), radius * bell * cos)
    });
    block_on(b, DVec3::new(0.0, height - 0.2, 0.0), DVec3::new(width, 0.2, width * 0.95), [2, 1, 2]);
}

/// The moulded band around an arch, on the side of the court.
fn archivolt(b: &mut MeshBuilder, radius: f64, spring: f64) {
    const PROFILE: [(f64, f64); 7] =
        [(0.0, 0.0), (0.0, 0.06), (0.07, 0.06), (0.09, 0.1), (0.16, 0.1), (0.2, 0.05), (0.2, 0.0)];
    let columns = b.segments(24, 4);
    b.grid(Grid::open(columns, PROFILE.len() as u32 - 1), |u, v| {
        let (outward, forward) = PROFILE[(v * (PROFILE.len() - 1) as f64 + 0.5) as usize];
        let (sin, cos) = sin_cos(PI * u);
        let r = radius + outward;
        DVec3::new(r * cos, spring + r * sin, WALL * 0.5 + forward)
    });
}

fn balustrade(b: &mut MeshBuilder, width: f64) {
    let p = DVec2::new;
    let profile = [p(0.075, 0.12), p(0.06, 0.2), p(0.085, 0.34), p(0.07, 0.45), p(0.04, 0.62), p(0.06, 0.8)];
    block_on(b, DVec3::ZERO, DVec3::new(width, 0.12, 0.26), [1, 1, 1]);
    block_on(b, DVec3::new(0.0, 0.8, 0.0), DVec3::new(width, 0.12, 0.3), [1, 1, 1]);
    b.repeat(9, 0, |b, i, count| {
        let x = ((f64::from(i) + 0.5) / f64::from(count) - 0.5) * width;
        b.at(moved(x, 0.0, 0.0), |b| lathe(b, &profile, true, 8, 8));
    });
}
