//! An arcaded hall of two storeys, closed all around.
//!
//! Stands for the Sponza atrium of Frank Meinl / Crytek (0.26 M triangles): large plain walls beside finely
//! divided columns, mouldings and cloth, almost everything aligned with the axes.

mod arcade;
mod furnishing;
mod shell;

use std::f64::consts::FRAC_PI_2;

use glam::DVec2;

use super::builder::{MeshBuilder, moved, turned};
use crate::mesh::{Camera, PointLight};

/// Distance of columns.
const BAY: f64 = 3.0;
/// Bays along x and along z.
const BAYS: [u32; 2] = [8, 4];
/// Half the size of the court, to the axes of its columns.
const COURT: DVec2 = DVec2::new(BAY * BAYS[0] as f64 * 0.5, BAY * BAYS[1] as f64 * 0.5);
/// Depth of the galleries around the court.
const GALLERY: f64 = 4.0;
const OUTER: DVec2 = DVec2::new(COURT.x + GALLERY, COURT.y + GALLERY);
/// Height of the floors of both storeys and of the springing of the roof.
const FLOORS: [f64; 3] = [0.0, 5.6, 10.4];
const WALL: f64 = 0.6;
const CLOTH: u64 = 1;
const STONE: u64 = 2;

/// The hall: x along it, the origin in the middle of its floor.
pub(super) fn generate(b: &mut MeshBuilder, seed: u64) {
    shell::floors_and_walls(b, seed);
    for storey in 0..2 {
        for side in sides() {
            arcade::build(b, storey, &side);
        }
        shell::cornice(b, FLOORS[storey + 1]);
    }
    shell::corner_piers(b);
    shell::gallery_vaults(b);
    shell::roof(b);
    furnishing::banners(b, seed);
    furnishing::curtains(b, seed);
    furnishing::lamps(b);
    furnishing::urns(b);
}

/// One side of the court: bays, and where it is put, looking from the court along its local -z.
struct Side {
    bays: u32,
    angle: f64,
    distance: f64,
}

fn sides() -> [Side; 4] {
    std::array::from_fn(|i| Side {
        bays: BAYS[i % 2],
        angle: FRAC_PI_2 * i as f64,
        distance: if i % 2 == 0 { COURT.y } else { COURT.x },
    })
}

impl Side {
    /// Runs `build` in coordinates with x along the side, z towards the court and y = 0 at `height`.
    fn build(&self, b: &mut MeshBuilder, height: f64, build: impl FnOnce(&mut MeshBuilder)) {
        b.at(turned(self.angle) * moved(0.0, height, -self.distance), build);
    }

    /// Positions along the side of the columns between its corners.
    fn columns(&self) -> impl Iterator<Item = f64> {
        let half = f64::from(self.bays) * 0.5;
        (1..self.bays).map(move |i| (f64::from(i) - half) * BAY)
    }

    fn bay_centers(&self) -> impl Iterator<Item = f64> {
        let half = (f64::from(self.bays) - 1.0) * 0.5;
        (0..self.bays).map(move |i| (f64::from(i) - half) * BAY)
    }
}

pub(super) fn view() -> (Camera, PointLight) {
    let camera =
        Camera { eye: [-10.8, 2.6, -1.2], target: [0.0, 4.4, 0.5], up: [0.0, 1.0, 0.0], fov_y_degrees: 65.0 };
    (camera, PointLight { position: [-2.0, 9.6, 1.0], intensity: [130.0; 3] })
}
