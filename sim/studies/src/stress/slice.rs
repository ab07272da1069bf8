//! Pictures of ray space: the rays around a failing one, each judged by the exact answer.

use super::Instance;
use super::bench::{Bench, Judgement, judge};
use golden::Ray;
use rayon::prelude::*;
use stress::oracle::Oracle;
use view::picture::{Picture, font};

/// A picture of the rays around a failing one.
#[derive(Clone, Debug)]
pub struct Slice {
    /// The picture.
    pub picture: Picture<u8>,
    /// The failure of the ray in the middle: `false_miss`, `false_hit` or `wrong_nearest`.
    pub failure: &'static str,
    /// The ray in the middle.
    pub ray: Ray,
}

/// Number of rays to either side of the middle.
const REACH: i32 = 40;
/// Width and height of a ray's square in pixels.
const PIXELS: u32 = 5;
const STRIP: u32 = 76;
const BACKGROUND: [u8; 3] = [255; 3];
const INK: [u8; 3] = [40; 3];

/// Colours of Okabe and Ito, which colour-blind readers can tell apart, with their meanings.
const KEY: [(&str, [u8; 3]); 5] = [
    ("hit, right", [86, 180, 233]),
    ("miss, right", [224, 224, 224]),
    ("false miss", [213, 94, 0]),
    ("wrong nearest", [240, 228, 66]),
    ("false hit", [0, 0, 0]),
];

/// The rays around the first ray of `bench` that the method fails on, or `None` if it fails on none.
///
/// The two lesser components of the direction vary by steps of a fraction of a unit in the last place of the method's format.
#[must_use]
pub fn slice(bench: &Bench, instance: &Instance) -> Option<Slice> {
    let (ray, judgement) = bench.first_failure(instance)?;
    let failure = match judgement {
        Judgement::FalseMiss => "false_miss",
        Judgement::FalseHit => "false_hit",
        Judgement::WrongNearest | Judgement::Right => "wrong_nearest",
    };
    let bits = instance.method.arithmetic.format().significand_bits() as i32;
    // In binary32 a step is one unit in the last place. In narrower formats, a step is a fraction of a unit.
    let exponent = if bits == 24 { -23 } else { -bits - 2 };
    let picture = draw(bench, instance, &ray, exponent);
    Some(Slice { picture, failure, ray })
}

fn draw(bench: &Bench, instance: &Instance, ray: &Ray, exponent: i32) -> Picture<u8> {
    let d = ray.direction.map(f64::from);
    let main = (0..3).fold(0, |m, k| if d[k].abs() > d[m].abs() { k } else { m });
    let (a, b) = ((main + 1) % 3, (main + 2) % 3);
    let step = libm::exp2(libm::floor(libm::log2(d[main].abs())) + f64::from(exponent));
    let oracle = Oracle::new(&bench.mesh, &bench.tree);
    let side = (2 * REACH + 1) as u32;
    let colour = |i: u32| {
        let mut direction = d;
        direction[a] += f64::from((i % side) as i32 - REACH) * step;
        direction[b] += f64::from(REACH - (i / side) as i32) * step;
        let ray = Ray { direction: direction.map(|x| x as f32), ..*ray };
        let (found, exact) = (instance.closest(&ray), oracle.nearest(&ray));
        KEY[match judge(found, &exact) {
            Judgement::Right if found.is_some() => 0,
            Judgement::Right => 1,
            Judgement::FalseMiss => 2,
            Judgement::WrongNearest => 3,
            Judgement::FalseHit => 4,
        }]
        .1
    };
    let colours: Vec<[u8; 3]> = (0..side * side).into_par_iter().map(colour).collect();
    let mut picture = Picture::filled(side * PIXELS, side * PIXELS + STRIP, BACKGROUND);
    for (i, colour) in (0..).zip(&colours) {
        rectangle(&mut picture, [i % side * PIXELS, i / side * PIXELS], [PIXELS; 2], *colour);
    }
    let mut top = side * PIXELS + 6;
    let mut left = 6;
    for (name, colour) in KEY.into_iter().filter(|(_, colour)| colours.contains(colour)) {
        let width = 14 + font::width(name) + 10;
        if left + width > picture.width {
            (left, top) = (6, top + 14);
        }
        rectangle(&mut picture, [left, top], [10, 10], colour);
        font::draw(&mut picture, left + 14, top + 1, name, INK);
        left += width;
    }
    font::draw(&mut picture, 6, top + 18, &instance.method.to_string(), INK);
    font::draw(&mut picture, 6, top + 30, &bench.name, INK);
    let axes = ["x", "y", "z"];
    let caption = format!("direction {} right, {} up, step {step:.1e}", axes[a], axes[b]);
    font::draw(&mut picture, 6, top + 42, &caption, INK);
    picture
}

fn rectangle(picture: &mut Picture<u8>, [x, y]: [u32; 2], [width, height]: [u32; 2], colour: [u8; 3]) {
    for j in 0..height {
        for i in 0..width {
            picture.set(x + i, y + j, colour);
        }
    }
}
