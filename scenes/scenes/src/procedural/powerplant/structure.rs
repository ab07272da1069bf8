//! Steel frame, floors, railings and stairs.

use std::f64::consts::{FRAC_PI_2, PI};

use glam::{DAffine3, DVec3};

use super::{BAY, HALF, STOREY, STOREYS, bays, grid_point};
use crate::procedural::builder::{MeshBuilder, Part, facing, moved, turned};
use crate::procedural::shapes::{beam, block, block_on, tube};

/// Columns, girders and the diagonal braces of the outer walls.
pub(super) fn frame(b: &mut MeshBuilder) {
    let [nx, nz] = bays();
    let top = f64::from(STOREYS) * STOREY;
    for i in 0..=nx {
        for j in 0..=nz {
            let p = grid_point(i, j);
            let outer = i == 0 || i == nx || j == 0 || j == nz;
            b.optional_if(!outer, |b| girder(b, DVec3::new(p.x, 0.0, p.y), DVec3::new(p.x, top, p.y), 0.5));
        }
    }
    for storey in 1..=STOREYS {
        let y = f64::from(storey) * STOREY - 0.3;
        for i in 0..=nx {
            let (p, q) = (grid_point(i, 0), grid_point(i, nz));
            b.optional_if(i % 4 != 0, |b| girder(b, DVec3::new(p.x, y, p.y), DVec3::new(q.x, y, q.y), 0.45));
        }
        for j in 0..=nz {
            let (p, q) = (grid_point(0, j), grid_point(nx, j));
            b.optional_if(j % 3 != 0, |b| girder(b, DVec3::new(p.x, y, p.y), DVec3::new(q.x, y, q.y), 0.45));
        }
        for i in 0..nx {
            for j in [0, nz] {
                let (p, q) = (grid_point(i, j), grid_point(i + 1, j));
                let (low, high) = (y - STOREY + 0.3, y);
                let (low, high) = if (i + storey) % 2 == 0 { (low, high) } else { (high, low) };
                b.optional(|b| beam(b, DVec3::new(p.x, low, p.y), DVec3::new(q.x, high, q.y), 0.2));
            }
        }
    }
}

/// An I-section between two points: two flanges and a web, 36 triangles.
fn girder(b: &mut MeshBuilder, from: DVec3, to: DVec3, size: f64) {
    let axis = to - from;
    let up = if axis.y.abs() > 0.9 * axis.length() { DVec3::X } else { DVec3::Y };
    b.at(facing(from, axis, up), |b| {
        let length = axis.length();
        let half = size * 0.5;
        for y in [-half, half - size * 0.1] {
            block(b, DVec3::new(-half, y, 0.0), DVec3::new(half, y + size * 0.1, length), [1, 1, 1]);
        }
        let web = size * 0.04;
        block(b, DVec3::new(-web, -half, 0.0), DVec3::new(web, half, length), [1, 1, 1]);
    });
}

/// Gratings with railings along their edges. The boilers take the middle.
pub(super) fn floors(b: &mut MeshBuilder) {
    let [nx, nz] = bays();
    let grating = b.part(|b| {
        b.repeat(104, 3, |b, i, count| {
            let x = (f64::from(i) + 0.5) / f64::from(count) * BAY;
            let half = 0.2 * BAY / f64::from(count);
            block(b, DVec3::new(x - half, -0.05, 0.0), DVec3::new(x + half, 0.0, BAY), [1, 1, 1]);
        });
        b.repeat(10, 0, |b, i, count| {
            let z = (f64::from(i) + 0.5) / f64::from(count) * BAY;
            block(b, DVec3::new(0.0, -0.04, z - 0.01), DVec3::new(BAY, -0.01, z + 0.01), [1, 1, 1]);
        });
    });
    let rail = b.part(|b| railing(b, BAY));
    for storey in 1..STOREYS {
        let y = f64::from(storey) * STOREY;
        for i in 0..nx {
            for j in 0..nz {
                let place = grid_point(i, j);
                if is_open(i, j) || (i * 7 + j * 3 + storey * 5) % 9 == 0 {
                    continue;
                }
                b.at(moved(place.x, y, place.y), |b| b.optional_part(&grating));
                for (edge, (di, dj)) in [(0, -1), (1, 0), (0, 1), (-1, 0)].into_iter().enumerate() {
                    if is_open(i.wrapping_add_signed(di), j.wrapping_add_signed(dj)) {
                        let turn = turned(-FRAC_PI_2 * edge as f64);
                        let center = moved(place.x + BAY * 0.5, y, place.y + BAY * 0.5);
                        let place = center * turn * moved(-BAY * 0.5, 0.0, -BAY * 0.5 + 0.1);
                        b.at(place, |b| b.optional_part(&rail));
                    }
                }
            }
        }
    }
}

/// Whether there is no floor at bay (i, j): outside, and where the boilers stand.
fn is_open(i: u32, j: u32) -> bool {
    let [nx, nz] = bays();
    let boiler = |first: u32| (first..first + 3).contains(&i) && (2..nz - 1).contains(&j);
    i >= nx || j >= nz || boiler(2) || boiler(6)
}

/// Three rails with a post every metre and a half.
fn railing(b: &mut MeshBuilder, length: f64) {
    let sides = b.segments(10, 3);
    for y in [0.35, 0.7, 1.05] {
        tube(b, &[DVec3::new(0.0, y, 0.0), DVec3::new(length, y, 0.0)], sides, false, |_| 0.024);
    }
    block(b, DVec3::new(0.0, 0.0, -0.005), DVec3::new(length, 0.12, 0.005), [1, 1, 1]);
    let posts = b.segments((length / 1.5) as u32, 1);
    // The post at the end belongs to the railing that follows.
    for i in 0..posts {
        let x = length * f64::from(i) / f64::from(posts);
        tube(b, &[DVec3::new(x, 0.0, 0.0), DVec3::new(x, 1.05, 0.0)], sides, false, |_| 0.022);
    }
}

/// Stair towers at both ends of the building.
pub(super) fn stairs(b: &mut MeshBuilder) {
    let flight = b.part(|b| {
        b.repeat(18, 3, |b, i, count| {
            let t = f64::from(i) / f64::from(count);
            let place = DVec3::new(0.0, t * STOREY * 0.5, t * 4.2);
            block_on(b, place, DVec3::new(1.1, 0.05, 0.28), [1, 1, 1]);
        });
        let rise = DVec3::new(0.0, STOREY * 0.5, 4.2);
        let sides = b.segments(10, 3);
        for x in [-0.58, 0.58] {
            beam(b, DVec3::new(x, 0.0, 0.0), DVec3::new(x, 0.0, 0.0) + rise, 0.16);
            for y in [0.5, 1.0] {
                let from = DVec3::new(x, y, 0.0);
                tube(b, &[from, from + rise], sides, false, |_| 0.022);
            }
            b.repeat(7, 1, |b, i, count| {
                let foot = DVec3::new(x, 0.0, 0.0) + rise * (f64::from(i) / f64::from(count));
                tube(b, &[foot, foot + DVec3::Y], sides, false, |_| 0.02);
            });
        }
    });
    for (x, z) in [(-HALF.x - 1.5, -6.0), (HALF.x + 1.5, 3.0), (-HALF.x - 1.5, 9.0)] {
        for storey in 0..STOREYS {
            let y = f64::from(storey) * STOREY;
            b.at(moved(x, y, z), |b| {
                b.optional_part(&flight);
                b.at(moved(1.3, STOREY * 0.5, 4.2) * turned(PI), |b| b.optional_part(&flight));
                block_on(b, DVec3::new(0.65, STOREY * 0.5, 4.9), DVec3::new(2.6, 0.08, 1.2), [1, 1, 1]);
                block_on(b, DVec3::new(0.65, STOREY, -0.7), DVec3::new(2.6, 0.08, 1.2), [1, 1, 1]);
            });
        }
    }
}

/// Instances that may be left out at coarse levels.
trait OptionalPart {
    fn optional_part(&mut self, part: &Part);
}

impl OptionalPart for MeshBuilder {
    fn optional_part(&mut self, part: &Part) {
        self.optional(|b| b.instance(part, DAffine3::IDENTITY));
    }
}
