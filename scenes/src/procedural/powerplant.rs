//! A coal-fired power plant: a steel frame full of boilers, ducts and pipes.
//!
//! Stands for the Powerplant of the University of North Carolina at Chapel Hill (12.7 M triangles): pipes of
//! every length and width run through the whole building, as triangles hundreds of times longer than wide,
//! beside flat floors and walls.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::{DAffine3, DVec2, DVec3};

use super::builder::{Grid, MeshBuilder, Part, facing, moved, scaled, sin_cos, turned};
use super::random::{Random, lerp};
use super::shapes::{beam, block, block_on, lathe, torus, tube};
use crate::mesh::{Camera, PointLight};

/// Half the size of the building in metres, its columns' distance, and the height of its floors.
const HALF: DVec2 = DVec2::new(36.0, 18.0);
const BAY: f64 = 6.0;
const STOREY: f64 = 6.0;
const STOREYS: u32 = 8;
const PIPES: u64 = 51;
const CABLES: u64 = 52;

pub(super) fn generate(b: &mut MeshBuilder, seed: u64) {
    block(b, DVec3::new(-70.0, -0.5, -50.0), DVec3::new(70.0, 0.0, 50.0), [40, 1, 30]);
    frame(b);
    floors(b);
    for (x, turn) in [(-18.0, 0.0), (6.0, PI)] {
        b.at(moved(x, 0.0, 0.0) * turned(turn), boiler);
    }
    stairs(b);
    tanks(b);
    chimney(b);
    turbines(b);
    conveyor(b);
    pipes(b, seed);
    cables(b, seed);
}

fn bays() -> [u32; 2] {
    [(2.0 * HALF.x / BAY) as u32, (2.0 * HALF.y / BAY) as u32]
}

fn grid_point(i: u32, j: u32) -> DVec2 {
    DVec2::new(f64::from(i) * BAY - HALF.x, f64::from(j) * BAY - HALF.y)
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

/// Columns, girders and the diagonal braces of the outer walls.
fn frame(b: &mut MeshBuilder) {
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

/// Gratings with railings along their edges. The boilers take the middle.
fn floors(b: &mut MeshBuilder) {
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

/// Furnace walls made of parallel tubes, superheater loops above, a drum, and headers around.
fn boiler(b: &mut MeshBuilder) {
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

/// A pipe with round elbows at the inner points of `way`.
fn bent_pipe(b: &mut MeshBuilder, way: &[DVec3], radius: f64, full_sides: u32) {
    let elbow = b.segments(6, 1);
    let sides = b.segments(full_sides, 3);
    let mut path = vec![way[0]];
    for corner in way.windows(3) {
        let (before, after) = (corner[0] - corner[1], corner[2] - corner[1]);
        let reach = (2.5 * radius).min(before.length() * 0.45).min(after.length() * 0.45);
        let from = corner[1] + before.normalize_or_zero() * reach;
        let to = corner[1] + after.normalize_or_zero() * reach;
        path.extend((0..=elbow).map(|k| {
            let t = f64::from(k) / f64::from(elbow);
            from.lerp(corner[1], t).lerp(corner[1].lerp(to, t), t)
        }));
    }
    path.push(way[way.len() - 1]);
    tube(b, &path, sides, false, |_| radius);
}

/// Pipes along the axes through the whole building, thin ones by the thousand and a few wide ones.
fn pipes(b: &mut MeshBuilder, seed: u64) {
    let top = f64::from(STOREYS) * STOREY;
    b.repeat(7700, 40, |b, i, _| {
        let mut random = Random::new(seed, PIPES, i.into());
        let thin = random.unit();
        let radius = lerp(0.018, 0.45, thin * thin * thin * thin * thin);
        let mut p =
            DVec3::new(random.range(-HALF.x, HALF.x), random.range(0.5, top), random.range(-HALF.y, HALF.y));
        // Half of the pipes follow a rack below a floor.
        if random.unit() < 0.5 {
            p.y = (p.y / STOREY).floor() * STOREY + STOREY - 0.9 - random.range(0.0, 0.5);
            p.z = (p.z / BAY + 0.5).floor() * BAY + random.range(0.4, 1.5);
        }
        let mut way = vec![p];
        let mut last_axis = random.below(3);
        for _ in 0..2 + random.below(5) {
            // Never along the same axis twice, so that no pipe turns back into itself.
            let axis = (last_axis + 1 + random.below(2)) % 3;
            let reach = match axis {
                0 => random.range(-22.0, 22.0),
                1 => random.range(-9.0, 9.0),
                _ => random.range(-10.0, 10.0),
            };
            let mut q = p;
            match axis {
                0 => q.x = (p.x + reach).clamp(-HALF.x, HALF.x),
                1 => q.y = (p.y + reach).clamp(0.3, top),
                _ => q.z = (p.z + reach).clamp(-HALF.y, HALF.y),
            }
            if (q - p).length() > 6.0 * radius + 0.1 {
                way.push(q);
                p = q;
                last_axis = axis;
            }
        }
        if way.len() < 2 {
            way.push(p + DVec3::Y * (4.0 * radius + 0.5));
        }
        bent_pipe(b, &way, radius, if radius > 0.15 { 28 } else { 16 });
        if radius > 0.03 {
            flanges(b, &way, radius);
        }
    });
}

/// Rings around a pipe at the ends of its straight runs, and valves on some.
fn flanges(b: &mut MeshBuilder, way: &[DVec3], radius: f64) {
    for (number, leg) in way.windows(2).enumerate() {
        let axis = leg[1] - leg[0];
        for t in [0.2, 0.8] {
            let at = facing(leg[0].lerp(leg[1], t), DVec3::new(axis.y, axis.z, axis.x), axis);
            b.optional(|b| {
                b.at(at * scaled(radius), |b| {
                    let p = DVec2::new;
                    lathe(b, &[p(1.0, -0.4), p(1.6, -0.4), p(1.6, 0.4), p(1.0, 0.4)], false, 14, 1);
                });
            });
        }
        if number % 3 == 1 {
            b.optional(|b| {
                let at = facing(leg[0].lerp(leg[1], 0.5), DVec3::new(axis.y, axis.z, axis.x), axis);
                b.at(at * scaled(radius + 0.02), |b| {
                    let p = DVec2::new;
                    lathe(
                        b,
                        &[p(1.0, -1.6), p(1.8, -0.9), p(2.0, 0.0), p(1.8, 0.9), p(1.0, 1.6)],
                        true,
                        16,
                        8,
                    );
                    tube(b, &[DVec3::ZERO, DVec3::new(0.0, 0.0, 4.0)], 6, false, |_| 0.3);
                    b.at(facing(DVec3::new(0.0, 0.0, 4.0), DVec3::Y, DVec3::Z), |b| {
                        torus(b, DVec3::ZERO, 1.8, 0.2, 20, 6);
                    });
                });
            });
        }
    }
}

/// Cables that sag between the columns, at all angles.
fn cables(b: &mut MeshBuilder, seed: u64) {
    let top = f64::from(STOREYS) * STOREY;
    b.repeat(2600, 10, |b, i, _| {
        let mut random = Random::new(seed, CABLES, i.into());
        let mut end = || {
            DVec3::new(random.range(-HALF.x, HALF.x), random.range(2.0, top), random.range(-HALF.y, HALF.y))
        };
        let from = end();
        let to = from + (end() - from) * 0.3;
        let sag = 0.04 * (to - from).length();
        let spans = b.segments(40, 2);
        let sides = b.segments(6, 3);
        let path: Vec<DVec3> = (0..=spans)
            .map(|k| {
                let t = f64::from(k) / f64::from(spans);
                from.lerp(to, t) - DVec3::Y * (sag * 4.0 * t * (1.0 - t))
            })
            .collect();
        tube(b, &path, sides, false, |_| 0.012);
    });
}

/// Stair towers at both ends of the building.
fn stairs(b: &mut MeshBuilder) {
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

/// Tanks beside the building with ladders and rings.
fn tanks(b: &mut MeshBuilder) {
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

fn chimney(b: &mut MeshBuilder) {
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
fn turbines(b: &mut MeshBuilder) {
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
fn conveyor(b: &mut MeshBuilder) {
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

pub(super) fn view() -> (Camera, PointLight) {
    let camera = Camera {
        eye: [-56.0, 31.0, 52.0],
        target: [-6.0, 23.0, 0.0],
        up: [0.0, 1.0, 0.0],
        fov_y_degrees: 50.0,
    };
    (camera, PointLight { position: [-70.0, 90.0, 90.0], intensity: [36_000.0; 3] })
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
