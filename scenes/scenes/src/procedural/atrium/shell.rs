//! What closes the hall: floors, walls, vaults and the roof, with their mouldings.

use std::f64::consts::PI;

use glam::{DVec2, DVec3};

use super::{BAY, COURT, FLOORS, GALLERY, OUTER, STONE, WALL, sides};
use crate::procedural::builder::{Grid, MeshBuilder, moved, sin_cos};
use crate::procedural::random::{fractal_noise, lerp};
use crate::procedural::shapes::{arch, block, block_on, moulding, tube};

/// Floors of worn tiles, walls of dressed stone, with doors below and windows' niches above.
pub(super) fn floors_and_walls(b: &mut MeshBuilder, seed: u64) {
    let columns = b.segments(96, 4);
    let rows = b.segments(56, 3);
    let tile = |t: f64| {
        // Flat in the middle of a tile, lower in the joint.
        let x = (t * 2.0 - 1.0).abs();
        x * x * x * x * x * x * x * x
    };
    b.grid(Grid::open(columns, rows), |u, v| {
        let x = lerp(-OUTER.x, OUTER.x, u);
        let z = lerp(OUTER.y, -OUTER.y, v);
        let (fx, fz) = (x / 0.75, z / 0.75);
        let joint = tile(fx - fx.floor()).max(tile(fz - fz.floor()));
        let worn = fractal_noise(seed ^ STONE, DVec3::new(x * 0.7, z * 0.7, 0.0), 2);
        DVec3::new(x, -0.012 * joint + 0.006 * worn, z)
    });
    for side in sides() {
        let along = if side.distance == COURT.y { OUTER.x } else { OUTER.y };
        side.build(b, 0.0, |b| {
            let columns = b.segments(side.bays * 8, 2);
            let rows = b.segments(34, 2);
            b.grid(Grid::open(columns, rows), |u, v| {
                let x = lerp(-along, along, u);
                let y = lerp(0.0, FLOORS[2] + 0.6, v);
                let course = (y / 0.55).floor();
                let shift = if course as i64 % 2 == 0 { 0.0 } else { 0.5 };
                let (sx, sy) = (x / 1.1 + shift, y / 0.55);
                let joint = tile(sx - sx.floor()).max(tile(sy - sy.floor()));
                let rough = fractal_noise(seed ^ STONE, DVec3::new(x, y, side.angle * 9.0) * 1.7, 3);
                DVec3::new(x, y, -GALLERY + 0.03 + 0.02 * rough - 0.02 * joint)
            });
            for x in side.bay_centers() {
                b.at(moved(x, 0.0, -GALLERY + 0.1), |b| b.optional(doorway));
                b.at(moved(x, FLOORS[1] + 0.9, -GALLERY + 0.1), |b| b.optional(window));
            }
        });
    }
    // The floor of the upper gallery: four strips, mitred by their ends.
    let thickness = 0.3;
    for (half_x, from_z, to_z) in [(OUTER.x, COURT.y, OUTER.y), (OUTER.x, -OUTER.y, -COURT.y)] {
        let y = FLOORS[1];
        block(b, DVec3::new(-half_x, y - thickness, from_z), DVec3::new(half_x, y, to_z), [32, 1, 4]);
    }
    for (from_x, to_x) in [(COURT.x, OUTER.x), (-OUTER.x, -COURT.x)] {
        let y = FLOORS[1];
        block(b, DVec3::new(from_x, y - thickness, -COURT.y), DVec3::new(to_x, y, COURT.y), [4, 1, 14]);
    }
    let ceiling = FLOORS[2] + 0.6;
    for (half_x, from_z, to_z) in [(OUTER.x, COURT.y, OUTER.y), (OUTER.x, -OUTER.y, -COURT.y)] {
        block(b, DVec3::new(-half_x, ceiling - 0.2, from_z), DVec3::new(half_x, ceiling, to_z), [16, 1, 2]);
    }
    for (from_x, to_x) in [(COURT.x, OUTER.x), (-OUTER.x, -COURT.x)] {
        block(b, DVec3::new(from_x, ceiling - 0.2, -COURT.y), DVec3::new(to_x, ceiling, COURT.y), [2, 1, 8]);
    }
}

fn doorway(b: &mut MeshBuilder) {
    arch(b, 2.0, 3.2, 0.24, 1.5, 2.1, 24);
    block_on(b, DVec3::new(-0.87, 0.0, 0.0), DVec3::new(0.26, 2.1, 0.24), [1, 2, 1]);
    block_on(b, DVec3::new(0.87, 0.0, 0.0), DVec3::new(0.26, 2.1, 0.24), [1, 2, 1]);
    b.repeat(6, 0, |b, i, planks| {
        let x = ((f64::from(i) + 0.5) / f64::from(planks) - 0.5) * 1.5;
        block_on(b, DVec3::new(x, 0.0, -0.02), DVec3::new(1.42 / f64::from(planks), 2.1, 0.08), [1, 1, 1]);
    });
}

fn window(b: &mut MeshBuilder) {
    arch(b, 1.5, 2.4, 0.2, 1.0, 1.5, 20);
    block_on(b, DVec3::new(-0.62, 0.0, 0.0), DVec3::new(0.26, 1.5, 0.2), [1, 1, 1]);
    block_on(b, DVec3::new(0.62, 0.0, 0.0), DVec3::new(0.26, 1.5, 0.2), [1, 1, 1]);
    block_on(b, DVec3::new(0.0, -0.12, 0.04), DVec3::new(1.7, 0.12, 0.3), [1, 1, 1]);
    b.repeat(5, 0, |b, i, bars| {
        let x = (f64::from(i) + 0.5) / f64::from(bars) - 0.5;
        tube(b, &[DVec3::new(x, 0.0, 0.02), DVec3::new(x, 1.9, 0.02)], 6, false, |_| 0.018);
    });
}

/// Square piers in the corners of the court.
pub(super) fn corner_piers(b: &mut MeshBuilder) {
    for (x, z) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
        let base = DVec3::new(x * COURT.x, 0.0, z * COURT.y);
        block_on(b, base, DVec3::new(1.0, FLOORS[2], 1.0), [2, 8, 2]);
        block_on(b, base, DVec3::new(1.25, 0.5, 1.25), [1, 1, 1]);
    }
}

/// A moulding around the court below `height`.
pub(super) fn cornice(b: &mut MeshBuilder, height: f64) {
    let p = DVec2::new;
    let profile = [
        p(0.0, -0.5),
        p(0.08, -0.48),
        p(0.08, -0.4),
        p(0.14, -0.36),
        p(0.14, -0.3),
        p(0.3, -0.16),
        p(0.42, -0.12),
        p(0.42, -0.02),
        p(0.36, 0.0),
        p(0.0, 0.0),
    ];
    let (x, z) = (COURT.x - WALL * 0.5, COURT.y - WALL * 0.5);
    let corners = [p(-x, -z), p(-x, z), p(x, z), p(x, -z)];
    b.at(moved(0.0, height, 0.0), |b| {
        moulding(b, &corners, true, &profile, 16);
        for side in sides() {
            side.build(b, 0.0, |b| {
                b.repeat(side.bays * 9, 0, |b, i, teeth| {
                    let length = f64::from(side.bays) * BAY - 2.0;
                    let x = ((f64::from(i) + 0.5) / f64::from(teeth) - 0.5) * length;
                    block_on(
                        b,
                        DVec3::new(x, -0.3, WALL * 0.5 + 0.17),
                        DVec3::new(0.16, 0.14, 0.14),
                        [1, 1, 1],
                    );
                });
            });
        }
    });
}

/// Groin vaults under the upper floor, one for each bay of the galleries.
pub(super) fn gallery_vaults(b: &mut MeshBuilder) {
    for side in sides() {
        side.build(b, 0.0, |b| {
            for x in side.bay_centers() {
                let columns = b.segments(12, 2);
                let rows = b.segments(12, 2);
                b.grid(Grid::open(columns, rows), |u, v| {
                    let curve = |t: f64| {
                        let s = 2.0 * t - 1.0;
                        (1.0 - s * s).max(0.0).sqrt()
                    };
                    let height = curve(u).max(curve(v));
                    DVec3::new(
                        x + (u - 0.5) * BAY,
                        lerp(3.9, FLOORS[1] - 0.32, height),
                        lerp(-GALLERY, -WALL * 0.5, v),
                    )
                });
                block(
                    b,
                    DVec3::new(x - BAY * 0.5 - 0.12, FLOORS[1] - 0.7, -GALLERY),
                    DVec3::new(x - BAY * 0.5 + 0.12, FLOORS[1] - 0.3, -WALL * 0.5),
                    [1, 1, 2],
                );
            }
        });
    }
}

/// A coffered barrel vault over the court, with its two end walls.
pub(super) fn roof(b: &mut MeshBuilder) {
    let rise = 3.4;
    let spring = FLOORS[2];
    let half = COURT.y + WALL * 0.5;
    let columns = b.segments(104, 4);
    let rows = b.segments(48, 5);
    b.grid(Grid::open(columns, rows), |u, v| {
        let (sin, cos) = sin_cos(PI * v);
        let coffer = |t: f64, n: f64| {
            let f = t * n;
            let d = (f - f.floor() - 0.5).abs() * 2.0;
            ((0.8 - d) * 8.0).clamp(0.0, 1.0)
        };
        let deep = 0.22 * coffer(u, 16.0) * coffer(v, 9.0);
        let x = lerp(-COURT.x - WALL * 0.5, COURT.x + WALL * 0.5, u);
        DVec3::new(x, spring + (rise + deep) * sin, (half + deep) * cos)
    });
    for side in [-1.0, 1.0] {
        let columns = b.segments(28, 5);
        let rows = b.segments(8, 1);
        b.grid(Grid::open(columns, rows), |u, v| {
            let (sin, cos) = sin_cos(PI * if side < 0.0 { u } else { 1.0 - u });
            DVec3::new(
                side * COURT.x,
                spring - 0.5 * (1.0 - v) + (rise + 0.25) * sin * v,
                -(half + 0.25) * cos,
            )
        });
    }
}
