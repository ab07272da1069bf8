//! Leaves and the plants that are made of them.
//!
//! Plants grow at the origin, y up. At coarse levels they have fewer and larger leaves, so that the crowns
//! stay as dense as they are.

use std::f64::consts::TAU;

use glam::{DVec2, DVec3};

use super::builder::{Grid, MeshBuilder, Part, facing, scaled, sin_cos, turned};
use super::random::{Random, lerp};
use super::shapes::{catmull_rom, lathe, tube};

/// The form of a leaf, which lies along z with its upper side towards y.
#[derive(Clone, Copy)]
pub(super) struct Leaf {
    /// Metres from stalk to tip.
    pub(super) length: f64,
    /// Largest width in metres.
    pub(super) width: f64,
    /// How far the tip hangs, in lengths.
    pub(super) droop: f64,
    /// How far the edges rise above the middle, in widths.
    pub(super) fold: f64,
    /// Cells across and along at full detail.
    pub(super) cells: [u32; 2],
}

/// One leaf.
pub(super) fn leaf(b: &mut MeshBuilder, form: Leaf) {
    let columns = b.segments(form.cells[0], 1);
    let rows = b.segments(form.cells[1], 2);
    b.grid(Grid { last_pole: true, ..Grid::open(columns, rows) }, |u, v| {
        // Widest at a third of its length.
        let half = form.width * (0.06 + 1.25 * v.sqrt() * (1.0 - v));
        let across = 2.0 * u - 1.0;
        let hang = form.droop * v * v;
        DVec3::new(
            -half * across,
            form.length * (0.35 * v - hang) + form.fold * half * across * across,
            form.length * (v - 0.3 * hang * v),
        )
    });
}

/// Variants of a small leaf.
const BLADES: u32 = 16;

/// How much larger leaves are when only `count` of `full` are left.
fn enlargement(full: u32, count: u32) -> f64 {
    (f64::from(full) / f64::from(count)).sqrt().min(5.0)
}

fn around_axis(random: &mut Random, item: u32) -> f64 {
    // The golden angle spreads leaves evenly.
    f64::from(item) * 2.399_963 + random.range(-0.3, 0.3)
}

fn sampled(way: &[DVec3], spans: u32) -> Vec<DVec3> {
    (0..=spans).map(|i| catmull_rom(way, f64::from(i) / f64::from(spans))).collect()
}

/// A fern: arching fronds with a row of leaflets on either side. `size` is the length of a frond in metres.
pub(super) fn fern(b: &mut MeshBuilder, seed: u64, kind: u64, size: f64) {
    const FRONDS: u32 = 13;
    const LEAFLETS: u32 = 17;
    b.repeat(FRONDS, 4, |b, frond, _| {
        let mut random = Random::new(seed, kind, frond.into());
        let angle = around_axis(&mut random, frond);
        let length = size * random.range(0.75, 1.1);
        let rise = random.range(0.45, 0.8);
        let form = Leaf { length: 0.2 * length, width: 0.05 * length, droop: 0.3, fold: 0.25, cells: [2, 4] };
        let leaflet = b.part(|b| leaf(b, form));
        b.at(turned(angle), |b| {
            let spine =
                |t: f64| DVec3::new(0.0, length * (rise * 1.6 * t - 1.25 * rise * t * t), length * 0.85 * t);
            let spans = b.segments(10, 3);
            let sides = b.segments(5, 3);
            let path: Vec<DVec3> = (0..=spans).map(|i| spine(f64::from(i) / f64::from(spans))).collect();
            tube(b, &path, sides, false, |t| 0.012 * size * (1.05 - t));
            b.repeat(LEAFLETS, 4, |b, i, count| {
                let t = 0.12 + 0.86 * (f64::from(i) + 0.5) / f64::from(count);
                let along = (spine(t + 0.01) - spine(t)).normalize();
                let width = (1.15 - t) * enlargement(LEAFLETS, count).min(2.0);
                for side in [-1.0, 1.0] {
                    let out = DVec3::X * side + along * 0.55;
                    b.instance(&leaflet, facing(spine(t), out, DVec3::Y) * scaled(width));
                }
            });
        });
    });
}

/// A rosette of large curved leaves on stalks.
pub(super) fn broad_leaved(b: &mut MeshBuilder, seed: u64, kind: u64, size: f64) {
    const LEAVES: u32 = 11;
    b.repeat(LEAVES, 4, |b, i, count| {
        let mut random = Random::new(seed, kind, i.into());
        let angle = around_axis(&mut random, i);
        let lean = random.range(0.25, 0.75);
        let stalk = size * random.range(0.5, 0.9);
        let form = Leaf {
            length: size * random.range(0.55, 0.8) * enlargement(LEAVES, count).min(1.4),
            width: size * random.range(0.28, 0.4),
            droop: random.range(0.4, 1.0),
            fold: random.range(0.1, 0.35),
            cells: [6, 13],
        };
        b.at(turned(angle), |b| {
            let top = DVec3::new(0.0, stalk, stalk * lean);
            let way = [DVec3::ZERO, DVec3::new(0.0, stalk * 0.6, stalk * lean * 0.3), top];
            let spans = b.segments(7, 2);
            let sides = b.segments(6, 3);
            tube(b, &sampled(&way, spans), sides, false, |t| 0.02 * size * (1.2 - t * 0.6));
            b.at(facing(top, DVec3::new(0.0, 0.15, 1.0), DVec3::Y), |b| leaf(b, form));
        });
    });
}

/// A tuft of narrow blades.
pub(super) fn grass(b: &mut MeshBuilder, seed: u64, kind: u64, size: f64) {
    const BLADES: u32 = 42;
    b.repeat(BLADES, 5, |b, i, count| {
        let mut random = Random::new(seed, kind, i.into());
        let root = DVec3::new(random.range(-0.2, 0.2), 0.0, random.range(-0.2, 0.2)) * size;
        let lean = DVec3::new(random.range(-0.5, 0.5), 1.0, random.range(-0.5, 0.5));
        let form = Leaf {
            length: size * random.range(0.5, 1.1),
            width: 0.022 * size * enlargement(BLADES, count),
            droop: random.range(0.1, 0.5),
            fold: 0.4,
            cells: [2, 6],
        };
        let up = DVec3::new(random.range(-1.0, 1.0), 0.1, random.range(-1.0, 1.0));
        b.at(facing(root, lean, up), |b| leaf(b, form));
    });
}

/// A round bush of many small leaves on thin twigs.
pub(super) fn bush(b: &mut MeshBuilder, seed: u64, kind: u64, size: f64, leaves: u32) {
    let form = Leaf { length: 0.13 * size, width: 0.065 * size, droop: 0.4, fold: 0.3, cells: [2, 4] };
    let blades = variants(b, BLADES, |b, _| leaf(b, form));
    b.repeat(24, 5, |b, i, _| {
        let mut random = Random::new(seed, kind, i.into());
        let end = crown_point(&mut random) * size;
        let way = [DVec3::ZERO, DVec3::new(end.x * 0.3, end.y * 0.6, end.z * 0.3), end];
        let spans = b.segments(8, 2);
        let sides = b.segments(5, 3);
        tube(b, &sampled(&way, spans), sides, false, |t| 0.012 * size * (1.1 - t));
    });
    b.repeat(leaves, 24, |b, i, count| {
        let mut random = Random::new(seed, kind + 1, i.into());
        let place = crown_point(&mut random) * size * random.range(0.7, 1.0);
        let out = place - DVec3::new(0.0, 0.4 * size, 0.0) + random.direction() * (0.5 * size);
        let grown = enlargement(leaves, count) * random.range(0.7, 1.2);
        b.instance(
            &blades[i as usize % blades.len()],
            facing(place, out, DVec3::Y + random.direction() * 0.5) * scaled(grown),
        );
    });
}

/// A point on the surface of a slightly flattened unit crown that stands on the ground.
fn crown_point(random: &mut Random) -> DVec3 {
    let d = random.direction();
    DVec3::new(d.x * 0.62, 0.55 + 0.45 * d.y, d.z * 0.62)
}

/// A palm: a ringed trunk with a crown of feathered fronds. `size` is its height in metres.
pub(super) fn palm(b: &mut MeshBuilder, seed: u64, kind: u64, size: f64) {
    let mut random = Random::new(seed, kind, 0);
    let top = DVec3::new(random.range(-0.12, 0.12) * size, size, random.range(-0.12, 0.12) * size);
    let way = [DVec3::ZERO, DVec3::new(top.x * 0.1, size * 0.5, top.z * 0.1), top];
    let spans = b.segments(60, 6);
    let sides = b.segments(14, 5);
    tube(b, &sampled(&way, spans), sides, false, |t| {
        let ring = t * 20.0;
        size * (0.028 - 0.01 * t + 0.006 * (ring - ring.floor()))
    });
    b.at(facing(top, DVec3::Z, DVec3::Y), |b| fern(b, seed, kind + 1, size * 0.55));
}

/// Where the leaves of a tree are.
struct Twig {
    from: DVec3,
    to: DVec3,
}

/// A deciduous tree of `height` metres: a trunk that forks several times, and `leaves` leaves on the twigs.
pub(super) fn tree(b: &mut MeshBuilder, seed: u64, kind: u64, height: f64, leaves: u32) {
    let mut random = Random::new(seed, kind, 0);
    let mut twigs = Vec::new();
    let fork = DVec3::new(random.range(-0.06, 0.06), 0.34, random.range(-0.06, 0.06)) * height;
    branch(b, &mut random, DVec3::ZERO, fork, 0.034 * height, 0.6);
    let limbs: Vec<DVec3> = (0..6)
        .map(|i| {
            let (sin, cos) = sin_cos(f64::from(i) * TAU / 6.0 + random.range(-0.35, 0.35));
            let out = random.range(0.16, 0.27);
            fork + DVec3::new(sin * out, random.range(0.16, 0.32), cos * out) * height
        })
        .collect();
    for limb in limbs {
        branch(b, &mut random, fork, limb, 0.017 * height, 0.55);
        for _ in 0..6 {
            let reach = (limb - fork) * 0.35 + random.direction() * (0.17 * height);
            let bough = limb + reach + DVec3::Y * (0.05 * height);
            branch(b, &mut random, limb, bough, 0.008 * height, 0.5);
            for _ in 0..8 {
                let twig = bough + random.direction() * (0.11 * height) + DVec3::Y * (0.015 * height);
                branch(b, &mut random, bough, twig, 0.003 * height, 0.4);
                twigs.push(Twig { from: bough, to: twig });
            }
        }
    }
    foliage(b, seed, kind + 1, height, leaves, &twigs);
}

fn branch(b: &mut MeshBuilder, random: &mut Random, from: DVec3, to: DVec3, radius: f64, taper: f64) {
    let bend = random.direction() * ((to - from).length() * 0.1);
    let way = [from, from.lerp(to, 0.5) + bend, to];
    b.optional_if(radius < 0.05, |b| {
        let spans = b.segments(9, 2);
        let sides = b.segments(9, 3);
        tube(b, &sampled(&way, spans), sides, false, |t| radius * lerp(1.0, taper, t));
    });
}

fn foliage(b: &mut MeshBuilder, seed: u64, kind: u64, height: f64, leaves: u32, twigs: &[Twig]) {
    let form = Leaf { length: 0.014 * height, width: 0.008 * height, droop: 0.35, fold: 0.3, cells: [2, 4] };
    let blades = variants(b, BLADES, |b, _| leaf(b, form));
    b.repeat(leaves, 60, |b, i, count| {
        if b.is_counting() {
            b.instance(&blades[i as usize % blades.len()], glam::DAffine3::IDENTITY);
            return;
        }
        let mut random = Random::new(seed, kind, i.into());
        let twig = &twigs[random.below(twigs.len() as u32) as usize];
        let place = twig.from.lerp(twig.to, random.range(0.2, 1.15)) + random.direction() * (0.022 * height);
        let out = random.direction() + (twig.to - twig.from).normalize() - DVec3::Y * 0.2;
        let grown = enlargement(leaves, count) * random.range(0.75, 1.25);
        b.instance(
            &blades[i as usize % blades.len()],
            facing(place, out, DVec3::Y + random.direction() * 0.6) * scaled(grown),
        );
    });
}

/// A terracotta pot of `size` metres height, full of earth.
pub(super) fn pot(b: &mut MeshBuilder, size: f64) {
    let p = |r: f64, y: f64| DVec2::new(r * size, y * size);
    let profile = [
        p(0.0, 0.0),
        p(0.32, 0.0),
        p(0.36, 0.1),
        p(0.48, 0.7),
        p(0.5, 0.82),
        p(0.56, 0.84),
        p(0.57, 1.0),
        p(0.5, 1.0),
        p(0.48, 0.9),
        p(0.0, 0.92),
    ];
    lathe(b, &profile, true, 40, 36);
}

/// Ivy on a wall in the plane z = 0, from y = 0 up to `size.y`, `size.x` wide and centred.
pub(super) fn ivy(b: &mut MeshBuilder, seed: u64, kind: u64, size: DVec2, leaves: u32) {
    let form = Leaf { length: 0.12, width: 0.11, droop: 0.5, fold: 0.2, cells: [4, 4] };
    let blades = variants(b, BLADES, |b, _| leaf(b, form));
    const STEMS: u32 = 40;
    let stem = |i: u32| {
        let mut random = Random::new(seed, kind, i.into());
        let x = random.range(-0.5, 0.5) * size.x;
        let reach = size.y * random.range(0.3, 1.0);
        [0.0, 0.33, 0.66, 1.0].map(|t| {
            DVec3::new(x + random.range(-0.6, 0.6) * t * 1.5, reach * t, 0.02 + 0.04 * random.unit())
        })
    };
    b.repeat(STEMS, 6, |b, i, _| {
        let spans = b.segments(24, 3);
        let sides = b.segments(5, 3);
        tube(b, &sampled(&stem(i), spans), sides, false, |t| 0.02 * (1.1 - t));
    });
    let stems: Vec<[DVec3; 4]> = (0..STEMS).map(stem).collect();
    b.repeat(leaves, 30, |b, i, count| {
        if b.is_counting() {
            b.instance(&blades[i as usize % blades.len()], glam::DAffine3::IDENTITY);
            return;
        }
        let mut random = Random::new(seed, kind + 1, i.into());
        let way = &stems[random.below(STEMS) as usize];
        let spread =
            DVec3::new(random.range(-0.35, 0.35), random.range(-0.35, 0.35), random.range(0.02, 0.12));
        let place = catmull_rom(way, random.unit()) + spread;
        let hang = DVec3::new(random.range(-0.8, 0.8), -0.6, random.range(0.3, 0.9));
        let grown = enlargement(leaves, count) * random.range(0.6, 1.2);
        b.instance(
            &blades[i as usize % blades.len()],
            facing(place, hang, DVec3::Z + random.direction() * 0.4) * scaled(grown),
        );
    });
}

/// Several parts of a kind. Below full detail the parts differ in their numbers of triangles, so that the number in a
/// whole crown grows smoothly with the level.
pub(super) fn variants(
    b: &mut MeshBuilder,
    count: u32,
    mut build: impl FnMut(&mut MeshBuilder, u32),
) -> Vec<Part> {
    (0..count).map(|i| b.part(|b| build(b, i))).collect()
}
