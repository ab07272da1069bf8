//! What stands beside the boilers: tanks, chimney, turbines, conveyor.

use std::f64::consts::TAU;

use glam::{DVec2, DVec3};

use crate::procedural::builder::{Grid, MeshBuilder, facing, moved, sin_cos};
use crate::procedural::random::lerp;
use crate::procedural::shapes::{beam, block, block_on, lathe, torus, tube};

/// Tanks beside the building with ladders and rings.
pub(super) fn tanks(b: &mut MeshBuilder) {
    let p = DVec2::new;
    for (x, z, radius, height) in
        [(-52.0, 8.0, 7.0, 14.0), (-52.0, -10.0, 6.0, 11.0), (50.0, 12.0, 5.0, 18.0), (54.0, -4.0, 5.0, 18.0)]
    {
        b.at(moved(x, 0.0, z), |b| {
            let shell =
                [p(radius, 0.0), p(radius, height), p(radius * 0.6, height + 1.4), p(0.0, height + 1.9)];
            let columns = b.segments(120, 8);
            let rows = b.segments(24, 2);
            b.grid(Grid::closed(columns, rows), |u, v| {
                let (sin, cos) = sin_cos(u * TAU);
                DVec3::new(radius * sin, height * v, radius * cos)
            });
            lathe(b, &shell[1..], false, 120, 1);
            b.repeat((height / 1.5) as u32, 1, |b, i, count| {
                let y = height * (f64::from(i) + 0.5) / f64::from(count);
                torus(b, DVec3::new(0.0, y, 0.0), radius + 0.03, 0.06, 120, 6);
            });
            b.repeat((height * 3.0) as u32, 4, |b, i, count| {
                let y = height * (f64::from(i) + 0.5) / f64::from(count);
                tube(
                    b,
                    &[DVec3::new(-0.3, y, radius + 0.2), DVec3::new(0.3, y, radius + 0.2)],
                    6,
                    false,
                    |_| 0.02,
                );
            });
            for x in [-0.3, 0.3] {
                tube(
                    b,
                    &[DVec3::new(x, 0.0, radius + 0.2), DVec3::new(x, height + 1.0, radius + 0.2)],
                    6,
                    false,
                    |_| 0.03,
                );
            }
        });
    }
}

pub(super) fn chimney(b: &mut MeshBuilder) {
    b.at(moved(20.0, 0.0, -30.0), |b| {
        let columns = b.segments(160, 8);
        let rows = b.segments(200, 6);
        b.grid(Grid::closed(columns, rows), |u, v| {
            let (sin, cos) = sin_cos(u * TAU);
            let course = v * 60.0;
            let r = lerp(5.0, 2.6, v) + 0.04 * (course - course.floor());
            DVec3::new(r * sin, 95.0 * v, r * cos)
        });
        for y in [30.0, 60.0, 90.0] {
            torus(b, DVec3::new(0.0, y, 0.0), lerp(5.2, 2.8, y / 95.0) + 0.5, 0.08, 90, 8);
        }
    });
    // Flue from the boilers.
    let path = [DVec3::new(6.0, 42.0, -4.0), DVec3::new(12.0, 40.0, -16.0), DVec3::new(20.0, 26.0, -28.0)];
    let sides = b.segments(48, 6);
    tube(b, &path, sides, false, |_| 1.8);
}

/// Turbines in the hall at the end, each a row of casings on a shaft.
pub(super) fn turbines(b: &mut MeshBuilder) {
    let p = DVec2::new;
    for z in [-9.0, 9.0] {
        b.at(facing(DVec3::new(28.0, 3.2, z), DVec3::Y, DVec3::X), |b| {
            let casing = [
                p(0.0, -8.0),
                p(0.6, -8.0),
                p(0.6, -7.2),
                p(1.6, -7.0),
                p(1.9, -5.5),
                p(1.5, -4.4),
                p(0.5, -4.2),
                p(0.5, -3.6),
                p(1.8, -3.4),
                p(2.4, -1.6),
                p(1.8, 0.2),
                p(0.5, 0.4),
                p(0.5, 1.0),
                p(1.5, 1.2),
                p(1.5, 5.4),
                p(0.9, 5.8),
                p(0.0, 6.0),
            ];
            lathe(b, &casing, true, 120, 160);
            b.repeat(40, 4, |b, i, count| {
                let y = lerp(1.4, 5.2, f64::from(i) / f64::from(count));
                torus(b, DVec3::new(0.0, y, 0.0), 1.55, 0.04, 60, 6);
            });
        });
        block_on(b, DVec3::new(28.0, 0.0, z), DVec3::new(16.0, 1.4, 3.6), [10, 1, 3]);
    }
}

/// The covered bridge that brings the coal, a truss that rises from the ground.
pub(super) fn conveyor(b: &mut MeshBuilder) {
    let (from, to) = (DVec3::new(-68.0, 2.0, -20.0), DVec3::new(-30.0, 44.0, -8.0));
    let along = to - from;
    let place = facing(from, along, DVec3::Y);
    b.at(place, |b| {
        let length = along.length();
        for (x, y) in [(-1.5, -1.5), (1.5, -1.5), (1.5, 1.5), (-1.5, 1.5)] {
            beam(b, DVec3::new(x, y, 0.0), DVec3::new(x, y, length), 0.2);
        }
        b.repeat(34, 4, |b, i, count| {
            let step = length / f64::from(count);
            let z = f64::from(i) * step;
            for x in [-1.5, 1.5] {
                beam(b, DVec3::new(x, -1.5, z), DVec3::new(x, 1.5, z + step), 0.12);
                beam(b, DVec3::new(x, -1.5, z), DVec3::new(x, 1.5, z), 0.12);
            }
            for y in [-1.5, 1.5] {
                beam(b, DVec3::new(-1.5, y, z), DVec3::new(1.5, y, z + step), 0.12);
            }
            let sides = b.segments(16, 4);
            tube(b, &[DVec3::new(-0.9, -0.9, z), DVec3::new(0.9, -0.9, z)], sides, true, |_| 0.12);
        });
        block(b, DVec3::new(-0.9, -0.78, 0.0), DVec3::new(0.9, -0.72, length), [2, 1, 60]);
    });
}
