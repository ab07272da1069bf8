//! The furnished courtyard of an old house, with trees.
//!
//! Stands for San Miguel of Guillermo M. Leal Llaguno (10.5 M triangles): a plain building, chairs and
//! tableware of a thousand small parts, and crowns of leaves that hold half of all triangles.

mod fountain;
mod furniture;
mod house;

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::{DAffine3, DVec2, DVec3};

use super::builder::{Grid, MeshBuilder, Part, facing, moved, sin_cos, turned};
use super::plants::{broad_leaved, bush, fern, pot, tree, variants};
use super::random::{Random, fractal_noise, lerp};
use super::shapes::{ball, lathe};
use crate::mesh::{Camera, PointLight};
use furniture::{chair, laid_table};

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
    house::building(b, seed);
    house::roofs(b);
    fountain::build(b);
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
