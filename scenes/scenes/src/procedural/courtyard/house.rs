//! The house around the court: arcades, windows, balconies and roofs.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::{DAffine3, DVec2, DVec3};

use super::{BAY, FLOORS, GALLERY, IVY, STONE, for_each_side};
use crate::procedural::builder::{Grid, MeshBuilder, moved, sin_cos, tilted, turned};
use crate::procedural::plants::ivy;
use crate::procedural::random::{fractal_noise, lerp};
use crate::procedural::shapes::{arch, block, block_on, lathe, moulding, torus, tube};

pub(super) fn building(b: &mut MeshBuilder, seed: u64) {
    let window = b.part(shuttered_window);
    let railing = b.part(balcony);
    let pillar = b.part(|b| pillar(b, 2.9));
    for_each_side(b, |b, side, bays| {
        let half = f64::from(bays) * BAY * 0.5;
        let centers = (0..bays).map(|i| (f64::from(i) + 0.5) * BAY - half);
        for (bay, x) in centers.enumerate() {
            b.at(moved(x, 0.0, 0.0), |b| {
                arch(b, BAY, FLOORS[1], 0.5, BAY - 0.9, 2.9, 72);
                b.instance(&pillar, moved(-BAY * 0.5, 0.0, 0.0));
                upper_wall(b, seed, (side * 16 + bay) as u64);
                b.instance(&window, moved(0.0, FLOORS[1] + 0.25, 0.28));
                if (bay + side) % 2 == 0 {
                    b.instance(&railing, moved(0.0, FLOORS[1] - 0.05, 0.25));
                }
            });
        }
        gallery(b, seed, side, half);
        let p = DVec2::new;
        let string_course =
            [p(0.0, -0.3), p(0.1, -0.28), p(0.1, -0.1), p(0.22, -0.02), p(0.22, 0.06), p(0.0, 0.1)];
        for height in [FLOORS[1], FLOORS[2]] {
            b.at(moved(0.0, height, 0.0), |b| {
                moulding(b, &[p(half, 0.25), p(-half, 0.25)], false, &flipped(&string_course), 60);
            });
        }
        if side % 2 == 1 || side == 0 {
            b.at(moved(0.0, FLOORS[1], 0.27), |b| {
                ivy(b, seed, IVY + 10 * side as u64, DVec2::new(2.0 * half, 3.8), 11_000);
            });
        }
    });
}

/// The profile for the other side of the way.
fn flipped(profile: &[DVec2]) -> Vec<DVec2> {
    profile.iter().map(|p| DVec2::new(-p.x, p.y)).collect()
}

fn pillar(b: &mut MeshBuilder, height: f64) {
    let p = DVec2::new;
    block_on(b, DVec3::ZERO, DVec3::new(0.9, 0.5, 0.7), [8, 4, 8]);
    let shaft = [
        p(0.36, 0.5),
        p(0.38, 0.56),
        p(0.3, 0.66),
        p(0.31, 1.2),
        p(0.29, 2.2),
        p(0.27, height - 0.4),
        p(0.34, height - 0.3),
        p(0.42, height - 0.2),
    ];
    lathe(b, &shaft, true, 48, 44);
    block_on(b, DVec3::new(0.0, height - 0.2, 0.0), DVec3::new(0.9, 0.2, 0.62), [8, 3, 8]);
}

/// The rough plaster of one bay of the upper floor.
fn upper_wall(b: &mut MeshBuilder, seed: u64, item: u64) {
    let columns = b.segments(90, 1);
    let rows = b.segments(100, 1);
    b.grid(Grid::open(columns, rows), |u, v| {
        let (x, y) = (lerp(-BAY * 0.5, BAY * 0.5, u), lerp(FLOORS[1], FLOORS[2], v));
        // No relief at the edges, so that bays join.
        let edge = (16.0 * u * (1.0 - u) * v * (1.0 - v)).min(1.0);
        let rough = fractal_noise(seed ^ STONE, DVec3::new(x + 40.0 * item as f64, y, 0.0) * 2.3, 5);
        DVec3::new(x, y, 0.25 + 0.05 * edge * rough)
    });
}

/// Frame, two shutters with slats, a sill, and a cross of bars.
fn shuttered_window(b: &mut MeshBuilder) {
    let (width, height) = (1.1, 2.3);
    for side in [-1.0, 1.0] {
        block_on(b, DVec3::new(side * 0.61, 0.0, 0.0), DVec3::new(0.12, height, 0.14), [1, 6, 1]);
        b.at(moved(side * 0.67, 0.08, 0.02) * turned(side * -0.45), |b| {
            b.optional(|b| shutter(b, side, height))
        });
    }
    block_on(b, DVec3::new(0.0, height, 0.0), DVec3::new(1.5, 0.16, 0.2), [6, 1, 2]);
    block_on(b, DVec3::new(0.0, -0.1, 0.05), DVec3::new(1.5, 0.1, 0.34), [6, 1, 2]);
    block_on(b, DVec3::new(0.0, 0.0, -0.01), DVec3::new(0.06, height, 0.05), [1, 4, 1]);
    for y in [0.75, 1.5] {
        b.optional(|b| block_on(b, DVec3::new(0.0, y, -0.01), DVec3::new(width, 0.05, 0.05), [4, 1, 1]));
    }
    block_on(b, DVec3::new(0.0, 0.0, -0.03), DVec3::new(width, height, 0.02), [1, 1, 1]);
}

/// A shutter with its hinges at x = 0, opening towards `side`.
fn shutter(b: &mut MeshBuilder, side: f64, height: f64) {
    for (x, w) in [(0.04, 0.08), (0.5, 0.08)] {
        block_on(b, DVec3::new(side * x, 0.0, 0.0), DVec3::new(w, height - 0.1, 0.05), [1, 4, 1]);
    }
    for y in [0.0, height * 0.5 - 0.08, height - 0.2] {
        block_on(b, DVec3::new(side * 0.27, y, 0.0), DVec3::new(0.38, 0.1, 0.05), [3, 1, 1]);
    }
    b.repeat(46, 0, |b, i, count| {
        let y = 0.12 + (height - 0.34) * f64::from(i) / f64::from(count);
        b.at(moved(side * 0.27, y, 0.0) * tilted(-0.7), |b| {
            block_on(b, DVec3::ZERO, DVec3::new(0.38, 0.045, 0.012), [1, 1, 1]);
        });
    });
}

/// A slab on brackets with a wrought-iron railing.
fn balcony(b: &mut MeshBuilder) {
    let (half, depth) = (1.15, 0.75);
    block(b, DVec3::new(-half, 0.0, 0.0), DVec3::new(half, 0.14, depth), [10, 2, 4]);
    for x in [-0.8, 0.8] {
        b.optional(|b| {
            let way: Vec<DVec3> = (0..=8)
                .map(|i| {
                    let (sin, cos) = sin_cos(f64::from(i) / 8.0 * FRAC_PI_2);
                    DVec3::new(x, -0.5 * cos, 0.62 * sin * sin + 0.02)
                })
                .collect();
            tube(b, &way, 10, false, |t| 0.09 - 0.03 * t);
        });
    }
    let corners = [
        DVec3::new(-half + 0.05, 1.05, 0.0),
        DVec3::new(-half + 0.05, 1.05, depth - 0.06),
        DVec3::new(half - 0.05, 1.05, depth - 0.06),
        DVec3::new(half - 0.05, 1.05, 0.0),
    ];
    for height in [0.0, -0.85] {
        let sides = b.segments(10, 4);
        tube(b, &corners.map(|p| p + DVec3::Y * height), sides, false, |_| 0.022);
    }
    b.repeat(20, 3, |b, i, count| {
        let x = ((f64::from(i) + 0.5) / f64::from(count) * 2.0 - 1.0) * (half - 0.05);
        iron_bar(b, DVec3::new(x, 0.14, depth - 0.06));
    });
    for side in [-1.0, 1.0] {
        b.repeat(6, 0, |b, i, count| {
            let z = (f64::from(i) + 0.5) / f64::from(count) * (depth - 0.06);
            iron_bar(b, DVec3::new(side * (half - 0.05), 0.14, z));
        });
    }
}

/// A twisted bar with a ball in the middle.
fn iron_bar(b: &mut MeshBuilder, foot: DVec3) {
    let spans = b.segments(28, 2);
    let columns = b.segments(8, 4);
    b.grid(Grid::closed(columns, spans), |u, v| {
        let (sin, cos) = sin_cos(TAU * (u + 2.5 * v));
        let bulge = (1.0 - ((v - 0.5) * 9.0).abs()).max(0.0);
        let (square, _) = sin_cos(TAU * 4.0 * u);
        let r = 0.009 * (1.0 + 0.15 * square) + 0.02 * (2.0 - bulge) * bulge;
        foot + DVec3::new(r * sin, 0.91 * v, r * cos)
    });
}

/// Back wall with doors, ceiling and floor beams of the arcade behind one side.
fn gallery(b: &mut MeshBuilder, seed: u64, side: usize, half: f64) {
    let cells = [b.segments(200, 2), b.segments(40, 1)];
    let back = -GALLERY;
    let along = half + GALLERY;
    b.grid(Grid::open(cells[0], cells[1]), |u, v| {
        let (x, y) = (lerp(-along, along, u), FLOORS[1] * v);
        let rough = fractal_noise(seed ^ STONE, DVec3::new(x, y, 7.0 * side as f64) * 1.3, 4);
        DVec3::new(x, y, back + 0.05 * rough)
    });
    block(b, DVec3::new(-along, FLOORS[1] - 0.1, back), DVec3::new(half, FLOORS[1], -0.25), [20, 1, 4]);
    b.repeat(26, 3, |b, i, count| {
        let x = lerp(-half, half, (f64::from(i) + 0.5) / f64::from(count));
        block_on(
            b,
            DVec3::new(x, FLOORS[1] - 0.35, back * 0.5),
            DVec3::new(0.18, 0.25, GALLERY - 0.4),
            [2, 2, 20],
        );
    });
    b.repeat((half / 2.0) as u32, 1, |b, i, count| {
        let x = lerp(-half, half, (f64::from(i) + 0.5) / f64::from(count));
        b.at(moved(x, 0.0, back + 0.08), door);
    });
}

fn door(b: &mut MeshBuilder) {
    for side in [-1.0, 1.0] {
        block_on(b, DVec3::new(side * 0.72, 0.0, 0.0), DVec3::new(0.18, 2.5, 0.16), [2, 8, 2]);
        b.repeat(4, 1, |b, i, count| {
            let height = 2.4 / f64::from(count);
            let y = height * f64::from(i);
            block_on(b, DVec3::new(side * 0.32, y, -0.02), DVec3::new(0.6, height - 0.02, 0.06), [4, 4, 1]);
            block_on(
                b,
                DVec3::new(side * 0.32, y + 0.08, 0.02),
                DVec3::new(0.4, height - 0.2, 0.05),
                [4, 4, 1],
            );
        });
        torus(b, DVec3::new(side * 0.08, 1.1, 0.06), 0.05, 0.01, 24, 10);
    }
    block_on(b, DVec3::new(0.0, 2.5, 0.0), DVec3::new(1.8, 0.2, 0.22), [6, 2, 2]);
}

/// Roofs of clay tiles that slope towards the court.
pub(super) fn roofs(b: &mut MeshBuilder) {
    let tile = b.part(|b| {
        let columns = b.segments(14, 2);
        let rows = b.segments(7, 1);
        b.grid(Grid::open(columns, rows), |u, v| {
            let (sin, cos) = sin_cos(PI * u);
            let r = lerp(0.105, 0.085, v);
            DVec3::new(r * cos, r * sin * 0.9, -0.48 * v)
        });
    });
    const SLOPE: f64 = 0.38;
    for_each_side(b, |b, _, bays| {
        let half = f64::from(bays) * BAY * 0.5;
        b.at(moved(0.0, FLOORS[2] + 0.05, 0.65) * tilted(SLOPE), |b| {
            b.grid(Grid::open(1, 1), |u, v| DVec3::new(lerp(-half - 4.0, half + 4.0, u), -0.02, -4.6 * v));
            let columns = b.segments((half * 2.0 / 0.22) as u32, 8);
            let rows = b.segments(11, 2);
            for row in 0..rows {
                let z = -4.5 * f64::from(row) / f64::from(rows);
                // Mitred where two roofs meet.
                let reach = half - 0.65 - z * 0.9;
                for column in 0..columns {
                    let x = ((f64::from(column) + 0.5) / f64::from(columns) * 2.0 - 1.0) * reach;
                    let grown =
                        DVec3::new(half * 2.0 / 0.22 / f64::from(columns), 1.0, 11.0 / f64::from(rows));
                    b.instance(&tile, moved(x, 0.0, z) * DAffine3::from_scale(grown));
                }
            }
        });
    });
}
