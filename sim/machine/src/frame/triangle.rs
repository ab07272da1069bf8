//! Which way a triangle test takes through its program: golden's error bound, evaluated again.

use golden::TraversalRay;
use golden::triangle::{Triangle, TriangleTest};

/// A ray's triangle tests.
pub struct Tests {
    test: TriangleTest,
    /// The axis of the direction's largest component last.
    pub axes: [usize; 3],
    shear: [f32; 2],
    scale: f32,
}

/// What single precision says about a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Certainly missed.
    Outside,
    /// Certainly met, seen from one side.
    Positive,
    /// Certainly met, seen from the other side.
    Negative,
    /// Too close to an edge to tell.
    Uncertain,
}

const UNIT_ROUNDOFF: f32 = 1.0 / 16_777_216.0;

impl Tests {
    pub fn new(ray: &TraversalRay) -> Self {
        let d = ray.direction;
        let [x, y, z] = d.map(f32::abs);
        let largest = if x > y && x > z {
            0
        } else if y > z {
            1
        } else {
            2
        };
        let axes = [(largest + 1) % 3, (largest + 2) % 3, largest];
        let scale = 1.0 / d[largest];
        Self { test: TriangleTest::new(ray), axes, shear: [d[axes[0]] * scale, d[axes[1]] * scale], scale }
    }

    /// The golden test.
    pub fn intersect(
        &self,
        ray: &TraversalRay,
        triangle: &Triangle,
        t_max: f32,
    ) -> Option<golden::triangle::TriangleHit> {
        self.test.intersect(ray, triangle, t_max)
    }

    /// The side, and the distance if it is certain.
    pub fn side(&self, ray: &TraversalRay, triangle: &Triangle) -> (Side, f32) {
        let corners = triangle.corners();
        let row = |axis: usize| corners.map(|corner| corner[axis] - ray.origin[axis]);
        let [ax, ay, az] = self.axes.map(row);
        let largest = |row: [f32; 3]| row.iter().fold(0f32, |m, x| m.max(x.abs()));
        let m = largest(ax).max(largest(ay)).max(largest(az));
        let x: [f32; 3] = std::array::from_fn(|i| ax[i] - az[i] * self.shear[0]);
        let y: [f32; 3] = std::array::from_fn(|i| ay[i] - az[i] * self.shear[1]);
        let e = largest(x).max(largest(y));
        let edges = [x[2] * y[1] - y[2] * x[1], x[0] * y[2] - y[0] * x[2], x[1] * y[0] - y[1] * x[0]];
        let bound = 40.0 * UNIT_ROUNDOFF * m * (e + 4.0 * UNIT_ROUNDOFF * m);
        let least = edges[0].min(edges[1]).min(edges[2]);
        let most = edges[0].max(edges[1]).max(edges[2]);
        let side = if most > bound && least < -bound {
            Side::Outside
        } else if least > bound {
            Side::Positive
        } else if most < -bound {
            Side::Negative
        } else {
            Side::Uncertain
        };
        let depth = edges[0] * az[0] + edges[1] * az[1] + edges[2] * az[2];
        (side, depth * self.scale / (edges[0] + edges[1] + edges[2]))
    }
}
