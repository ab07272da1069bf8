//! An arcaded hall of two storeys, closed all around.
//!
//! Stands for the Sponza atrium of Frank Meinl / Crytek (0.26 M triangles): large plain walls beside finely
//! divided columns, mouldings and cloth, almost everything aligned with the axes.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::{DVec2, DVec3};

use super::builder::{Grid, MeshBuilder, moved, sin_cos, turned};
use super::random::{Random, fractal_noise, lerp};
use super::shapes::{arch, block, block_on, lathe, moulding, torus, tube};
use crate::mesh::{Camera, PointLight};

/// Distance of columns.
const BAY: f64 = 3.0;
/// Bays along x and along z.
const BAYS: [u32; 2] = [8, 4];
/// Half the size of the court, to the axes of its columns.
const COURT: DVec2 = DVec2::new(BAY * BAYS[0] as f64 * 0.5, BAY * BAYS[1] as f64 * 0.5);
/// Depth of the galleries around the court.
const GALLERY: f64 = 4.0;
const OUTER: DVec2 = DVec2::new(COURT.x + GALLERY, COURT.y + GALLERY);
/// Height of the floors of both storeys and of the springing of the roof.
const FLOORS: [f64; 3] = [0.0, 5.6, 10.4];
const WALL: f64 = 0.6;
const CLOTH: u64 = 1;
const STONE: u64 = 2;

/// The hall: x along it, the origin in the middle of its floor.
pub(super) fn generate(b: &mut MeshBuilder, seed: u64) {
    floors_and_walls(b, seed);
    for storey in 0..2 {
        for side in sides() {
            arcade(b, storey, &side);
        }
        cornice(b, FLOORS[storey + 1]);
    }
    corner_piers(b);
    gallery_vaults(b);
    roof(b);
    banners(b, seed);
    curtains(b, seed);
    lamps(b);
    urns(b);
}

/// One side of the court: bays, and where it is put, looking from the court along its local -z.
struct Side {
    bays: u32,
    angle: f64,
    distance: f64,
}

fn sides() -> [Side; 4] {
    std::array::from_fn(|i| Side {
        bays: BAYS[i % 2],
        angle: FRAC_PI_2 * i as f64,
        distance: if i % 2 == 0 { COURT.y } else { COURT.x },
    })
}

impl Side {
    /// Runs `build` in coordinates with x along the side, z towards the court and y = 0 at `height`.
    fn build(&self, b: &mut MeshBuilder, height: f64, build: impl FnOnce(&mut MeshBuilder)) {
        b.at(turned(self.angle) * moved(0.0, height, -self.distance), build);
    }

    /// Positions along the side of the columns between its corners.
    fn columns(&self) -> impl Iterator<Item = f64> {
        let half = f64::from(self.bays) * 0.5;
        (1..self.bays).map(move |i| (f64::from(i) - half) * BAY)
    }

    fn bay_centers(&self) -> impl Iterator<Item = f64> {
        let half = (f64::from(self.bays) - 1.0) * 0.5;
        (0..self.bays).map(move |i| (f64::from(i) - half) * BAY)
    }
}

fn arcade(b: &mut MeshBuilder, storey: usize, side: &Side) {
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

/// Square piers in the corners of the court.
fn corner_piers(b: &mut MeshBuilder) {
    for (x, z) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
        let base = DVec3::new(x * COURT.x, 0.0, z * COURT.y);
        block_on(b, base, DVec3::new(1.0, FLOORS[2], 1.0), [2, 8, 2]);
        block_on(b, base, DVec3::new(1.25, 0.5, 1.25), [1, 1, 1]);
    }
}

/// A moulding around the court below `height`.
fn cornice(b: &mut MeshBuilder, height: f64) {
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

/// Floors of worn tiles, walls of dressed stone, with doors below and windows' niches above.
fn floors_and_walls(b: &mut MeshBuilder, seed: u64) {
    // The court's floor lies a step below the galleries'.
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

/// Groin vaults under the upper floor, one for each bay of the galleries.
fn gallery_vaults(b: &mut MeshBuilder) {
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
fn roof(b: &mut MeshBuilder) {
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

/// Long banners that hang from the upper storey into the court.
fn banners(b: &mut MeshBuilder, seed: u64) {
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
fn curtains(b: &mut MeshBuilder, seed: u64) {
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

/// Lamps that hang on chains from the roof and along the galleries.
fn lamps(b: &mut MeshBuilder) {
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
fn urns(b: &mut MeshBuilder) {
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

pub(super) fn view() -> (Camera, PointLight) {
    let camera =
        Camera { eye: [-10.8, 2.6, -1.2], target: [0.0, 4.4, 0.5], up: [0.0, 1.0, 0.0], fov_y_degrees: 65.0 };
    (camera, PointLight { position: [-2.0, 9.6, 1.0], intensity: [130.0; 3] })
}
