//! A boiler: furnace walls, superheater and drum.

use std::f64::consts::{FRAC_PI_2, PI};

use glam::{DVec2, DVec3};

use super::pipes::bent_pipe;
use crate::procedural::builder::{MeshBuilder, facing, moved, sin_cos, turned};
use crate::procedural::shapes::{block_on, lathe, tube};

/// Furnace walls made of parallel tubes, superheater loops above, a drum, and headers around.
pub(super) fn build(b: &mut MeshBuilder) {
    let half = DVec2::new(7.0, 5.2);
    let (bottom, top) = (4.0, 40.0);
    for side in 0..4 {
        let (width, distance) = if side % 2 == 0 { (half.x, half.y) } else { (half.y, half.x) };
        b.at(turned(FRAC_PI_2 * f64::from(side)) * moved(0.0, 0.0, distance), |b| {
            b.repeat((width * 2.0 / 0.09) as u32, 12, |b, i, count| {
                let x = ((f64::from(i) + 0.5) / f64::from(count) * 2.0 - 1.0) * width;
                let sides = b.segments(12, 3);
                let radius = 0.45 * width / f64::from(count) * 2.0;
                let way = [
                    DVec3::new(x * 0.2, bottom - 2.5, -distance * 0.8),
                    DVec3::new(x, bottom + 4.0, 0.0),
                    DVec3::new(x, 18.0, 0.0),
                    DVec3::new(x, 30.0, 0.0),
                    DVec3::new(x, top, 0.0),
                ];
                tube(b, &way, sides, false, |_| radius);
            });
            for y in [12.0, 20.0, 28.0, 36.0] {
                block_on(b, DVec3::new(0.0, y, 0.25), DVec3::new(width * 2.0 + 0.8, 0.5, 0.3), [4, 1, 1]);
                b.repeat(20, 0, |b, i, count| {
                    let x = ((f64::from(i) + 0.5) / f64::from(count) * 2.0 - 1.0) * width;
                    block_on(b, DVec3::new(x, y - 0.15, 0.3), DVec3::new(0.06, 0.8, 0.36), [1, 1, 1]);
                });
            }
        });
    }
    superheater(b, half, top);
    let drum = [
        DVec2::new(0.0, -8.4),
        DVec2::new(0.7, -8.2),
        DVec2::new(1.0, -7.6),
        DVec2::new(1.0, 7.6),
        DVec2::new(0.7, 8.2),
        DVec2::new(0.0, 8.4),
    ];
    let lying = facing(DVec3::new(0.0, top + 4.0, -3.0), DVec3::Y, DVec3::X);
    b.at(lying, |b| lathe(b, &drum, true, 64, 40));
    for y in [bottom, top] {
        for side in [-1.0, 1.0] {
            let sides = b.segments(24, 5);
            let z = side * (half.y + 0.3);
            tube(b, &[DVec3::new(-half.x, y, z), DVec3::new(half.x, y, z)], sides, true, |_| 0.3);
        }
    }
    // Risers from the headers to the drum.
    b.repeat(36, 3, |b, i, count| {
        let x = ((f64::from(i) + 0.5) / f64::from(count) * 2.0 - 1.0) * half.x;
        let side = if i % 2 == 0 { -1.0 } else { 1.0 };
        let way = [
            DVec3::new(x, top, side * (half.y + 0.3)),
            DVec3::new(x, top + 2.5 + 0.3 * side, side * (half.y + 0.3)),
            DVec3::new(x, top + 2.5 + 0.3 * side, -3.0),
            DVec3::new(x, top + 4.0, -3.0),
        ];
        bent_pipe(b, &way, 0.11, 12);
    });
}

/// Hanging loops of thin tubes, in rows.
fn superheater(b: &mut MeshBuilder, half: DVec2, top: f64) {
    b.repeat(64, 3, |b, row, rows| {
        let x = ((f64::from(row) + 0.5) / f64::from(rows) * 2.0 - 1.0) * (half.x - 0.4);
        b.repeat(9, 1, |b, i, loops| {
            let pitch = 2.0 * (half.y - 0.6) / f64::from(loops);
            let z = (f64::from(i) + 0.5) * pitch - (half.y - 0.6);
            let turn = pitch * 0.4;
            let low = top - 7.0;
            let bend = b.segments(10, 2);
            let sides = b.segments(10, 3);
            let mut way = vec![DVec3::new(x, top + 1.5, z - turn)];
            way.extend((0..=bend).map(|k| {
                let (sin, cos) = sin_cos(PI * f64::from(k) / f64::from(bend));
                DVec3::new(x, low - turn * sin, z - turn * cos)
            }));
            way.push(DVec3::new(x, top + 1.5, z + turn));
            tube(b, &way, sides, false, |_| 0.035);
        });
    });
}
