//! A coal-fired power plant: a steel frame full of boilers, ducts and pipes.
//!
//! Stands for the Powerplant of the University of North Carolina at Chapel Hill (12.7 M triangles): pipes of
//! every length and width run through the whole building, as triangles hundreds of times longer than wide,
//! beside flat floors and walls.

mod boiler;
mod pipes;
mod structure;
mod yard;

use std::f64::consts::PI;

use glam::{DVec2, DVec3};

use super::builder::{MeshBuilder, moved, turned};
use super::shapes::block;
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
    structure::frame(b);
    structure::floors(b);
    for (x, turn) in [(-18.0, 0.0), (6.0, PI)] {
        b.at(moved(x, 0.0, 0.0) * turned(turn), boiler::build);
    }
    structure::stairs(b);
    yard::tanks(b);
    yard::chimney(b);
    yard::turbines(b);
    yard::conveyor(b);
    pipes::pipes(b, seed);
    pipes::cables(b, seed);
}

fn bays() -> [u32; 2] {
    [(2.0 * HALF.x / BAY) as u32, (2.0 * HALF.y / BAY) as u32]
}

fn grid_point(i: u32, j: u32) -> DVec2 {
    DVec2::new(f64::from(i) * BAY - HALF.x, f64::from(j) * BAY - HALF.y)
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
