//! The furnished courtyard of an old house, with trees.
//!
//! Stands for San Miguel of Guillermo M. Leal Llaguno (10.5 M triangles): a plain building, chairs and
//! tableware of a thousand small parts, and crowns of leaves that hold half of all triangles.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::{DAffine3, DVec2, DVec3};

use super::builder::{Grid, MeshBuilder, Part, facing, moved, sin_cos, tilted, turned};
use super::furniture::{chair, laid_table};
use super::plants::{broad_leaved, bush, fern, ivy, pot, tree, variants};
use super::random::{Random, fractal_noise, lerp};
use super::shapes::{arch, ball, block, block_on, lathe, moulding, torus, tube};
use crate::mesh::{Camera, PointLight};

/// Half the size of the court in metres.
const COURT: DVec2 = DVec2::new(13.0, 10.0);
const BAY: f64 = 3.25;
const FLOORS: [f64; 3] = [0.0, 4.4, 8.2];
const GALLERY: f64 = 3.5;
const STONE: u64 = 31;
const POTS: u64 = 32;
const TABLES: u64 = 33;
const TREE: u64 = 3400;
const PLANT: u64 = 3500;
const IVY: u64 = 3600;

pub(super) fn generate(b: &mut MeshBuilder, seed: u64) {
    paving(b, seed);
    building(b, seed);
    roofs(b);
    fountain(b);
    trees(b, seed);
    tables(b, seed);
    potted_plants(b, seed);
}

/// Cobbles, each a small dome.
fn paving(b: &mut MeshBuilder, seed: u64) {
    let cells = [b.segments(640, 8), b.segments(480, 8)];
    let reach = COURT + DVec2::splat(GALLERY);
    b.grid(Grid::open(cells[0], cells[1]), |u, v| {
        let (x, z) = (lerp(-reach.x, reach.x, u), lerp(reach.y, -reach.y, v));
        let row = (z / 0.26).floor();
        let shift = if row as i64 % 2 == 0 { 0.0 } else { 0.5 };
        let dome = |t: f64| {
            let s = (t - t.floor()) * 2.0 - 1.0;
            1.0 - s * s * s * s
        };
        let cobble = dome(x / 0.3 + shift) * dome(z / 0.26);
        let uneven = fractal_noise(seed ^ STONE, DVec3::new(x, z, 0.0) * 0.8, 3);
        let in_court = if x.abs() < COURT.x && z.abs() < COURT.y { 1.0 } else { 0.2 };
        DVec3::new(x, in_court * (0.02 * cobble + 0.03 * uneven) - 0.03, z)
    });
}

/// Runs `build` for each side of the court with the number of its bays, in coordinates with x along the
/// wall and z towards the court.
fn for_each_side(b: &mut MeshBuilder, mut build: impl FnMut(&mut MeshBuilder, usize, u32)) {
    for side in 0..4 {
        let (bays, distance) = if side % 2 == 0 { (8, COURT.y) } else { (6, COURT.x) };
        b.at(turned(FRAC_PI_2 * side as f64) * moved(0.0, 0.0, -distance), |b| build(b, side, bays));
    }
}

fn building(b: &mut MeshBuilder, seed: u64) {
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
        b.at(moved(x, 0.0, back + 0.08), |b| door(b));
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
fn roofs(b: &mut MeshBuilder) {
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

/// A basin with two bowls above it and water that falls from one to the next.
fn fountain(b: &mut MeshBuilder) {
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

fn trees(b: &mut MeshBuilder, seed: u64) {
    let kinds: Vec<Part> = [(9.0, 66_000), (7.5, 55_000)]
        .into_iter()
        .zip(0..)
        .map(|((height, leaves), i)| b.part(|b| tree(b, seed, TREE + 10 * i, height, leaves)))
        .collect();
    let places = [(-7.5, -5.2, 0, 0.0), (5.5, -6.4, 1, 1.0), (8.6, 4.4, 0, 2.2), (-5.0, 6.8, 1, 4.0)];
    for (x, z, kind, angle) in places {
        b.instance(&kinds[kind], moved(x, 0.3, z) * turned(angle));
        b.at(moved(x, 0.0, z), |b| {
            let p = DVec2::new;
            let ring = [
                p(1.1, 0.0),
                p(1.1, 0.35),
                p(1.04, 0.42),
                p(0.86, 0.42),
                p(0.8, 0.35),
                p(0.78, 0.25),
                p(0.0, 0.32),
            ];
            lathe(b, &ring, true, 80, 40);
        });
    }
}

fn tables(b: &mut MeshBuilder, seed: u64) {
    let table = b.part(|b| laid_table(b, seed));
    let chair = b.part(chair);
    let places = [
        (-3.4, 1.8),
        (-8.6, 0.4),
        (-9.6, 4.4),
        (-1.2, 5.6),
        (2.6, 4.6),
        (6.0, 1.2),
        (9.6, -1.0),
        (-3.0, -6.6),
        (1.4, -7.6),
        (9.6, -6.6),
        (-10.6, -8.2),
        (4.4, 8.0),
        (-8.8, 8.0),
        (10.6, 8.2),
    ];
    for ((x, z), number) in places.into_iter().zip(0_u64..) {
        let mut random = Random::new(seed, TABLES, number);
        b.at(moved(x, 0.0, z) * turned(random.range(0.0, TAU)), |b| {
            b.instance(&table, DAffine3::IDENTITY);
            for side in 0..4 {
                let angle = FRAC_PI_2 * f64::from(side) + random.range(-0.25, 0.25);
                let away = random.range(0.72, 0.98);
                b.instance(
                    &chair,
                    turned(angle) * moved(0.0, 0.0, away) * turned(PI + random.range(-0.3, 0.3)),
                );
            }
        });
    }
}

fn potted_plants(b: &mut MeshBuilder, seed: u64) {
    let kinds = [
        b.part(|b| planted(b, |b| bush(b, seed, PLANT, 1.1, 900))),
        b.part(|b| planted(b, |b| fern(b, seed, PLANT + 10, 0.9))),
        b.part(|b| planted(b, |b| broad_leaved(b, seed, PLANT + 20, 0.9))),
        b.part(|b| planted(b, |b| bush(b, seed, PLANT + 30, 0.8, 1400))),
    ];
    for_each_side(b, |b, side, bays| {
        let count = bays * 2;
        b.repeat(count, 2, |b, i, count| {
            let mut random = Random::new(seed, POTS + 10 * side as u64, i.into());
            let x = (f64::from(i) / f64::from(count) - 0.5) * f64::from(bays) * BAY + random.range(-0.2, 0.2);
            let part = &kinds[random.below(4) as usize];
            let place = moved(x, 0.0, random.range(0.75, 1.3)) * turned(random.range(0.0, TAU));
            b.instance(part, place * super::builder::scaled(random.range(0.7, 1.15)));
        });
    });
    let small = variants(b, 2, |b, i| fern(b, seed, PLANT + 40 + u64::from(i), 0.7));
    for i in 0..14 {
        let (sin, cos) = sin_cos(f64::from(i) * TAU / 14.0);
        let place = FOUNTAIN + DVec3::new(2.75 * sin, 0.0, 2.75 * cos);
        b.at(facing(place, DVec3::Z, DVec3::Y), |b| {
            pot(b, 0.45);
            b.instance(&small[i as usize % 2], moved(0.0, 0.4, 0.0) * turned(f64::from(i)));
        });
    }
}

fn planted(b: &mut MeshBuilder, plant: impl FnOnce(&mut MeshBuilder)) {
    pot(b, 0.6);
    ball(b, DVec3::new(0.0, 0.4, 0.0), 30, 16, |d| 0.25 * (1.0 - 0.5 * d.y * d.y));
    b.at(moved(0.0, 0.54, 0.0), plant);
}

const FOUNTAIN: DVec3 = DVec3::new(0.6, 0.0, -1.6);

pub(super) fn view() -> (Camera, PointLight) {
    let camera =
        Camera { eye: [-11.4, 2.5, 7.6], target: [0.0, 2.3, -1.6], up: [0.0, 1.0, 0.0], fov_y_degrees: 60.0 };
    (camera, PointLight { position: [-3.0, 15.0, 6.0], intensity: [600.0; 3] })
}
