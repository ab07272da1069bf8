//! Pipes with flanges and valves, and cables.

use glam::{DVec2, DVec3};

use super::{BAY, CABLES, HALF, PIPES, STOREY, STOREYS};
use crate::procedural::builder::{MeshBuilder, facing, scaled};
use crate::procedural::random::{Random, lerp};
use crate::procedural::shapes::{lathe, torus, tube};

/// Pipes along the axes through the whole building, thin ones by the thousand and a few wide ones.
pub(super) fn pipes(b: &mut MeshBuilder, seed: u64) {
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

/// A pipe with round elbows at the inner points of `way`.
pub(super) fn bent_pipe(b: &mut MeshBuilder, way: &[DVec3], radius: f64, full_sides: u32) {
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

/// Cables that sag between the columns, at all angles.
pub(super) fn cables(b: &mut MeshBuilder, seed: u64) {
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
