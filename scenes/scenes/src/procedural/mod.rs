//! Six built-in scenes, each with the character of one that ray tracing papers use.
//!
//! A scene is a function of its seed and its level of detail alone. `detail` is the fraction of the full number of
//! triangles; [`build`] finds the level that gives it by counting. The seed moves what is random (hairs, leaves,
//! folds of cloth) and leaves the plan as it is.

mod atrium;
mod builder;
mod courtyard;
mod hairball;
mod plants;
mod powerplant;
mod random;
mod shapes;
mod statue;
mod vegetation;

use thiserror::Error;

use crate::mesh::{Camera, PointLight, Scene};
use builder::MeshBuilder;

/// A built-in scene.
#[derive(Clone, Copy, Debug)]
pub struct CatalogueEntry {
    /// The name by which it is chosen.
    pub name: &'static str,
    /// The scene of the literature whose size and character it shares.
    pub stands_for: &'static str,
    /// Triangles at detail 1 with seed 0; other seeds differ by less than 2 %.
    pub triangles: usize,
    /// What the scene shows, and what is hard about it for a tree.
    pub description: &'static str,
    generate: fn(&mut MeshBuilder, u64),
    view: fn() -> (Camera, PointLight),
}

/// The built-in scenes.
pub const CATALOGUE: &[CatalogueEntry] = &[
    CatalogueEntry {
        name: "atrium",
        stands_for: "Crytek Sponza",
        triangles: 266_056,
        description: "arcaded hall of two storeys, closed, with fluted columns, vaults and cloth",
        generate: atrium::generate,
        view: atrium::view,
    },
    CatalogueEntry {
        name: "statue",
        stands_for: "Dragon Sponza",
        triangles: 1_152_030,
        description: "the atrium with a statue that has three quarters of all triangles",
        generate: statue::generate,
        view: statue::view,
    },
    CatalogueEntry {
        name: "courtyard",
        stands_for: "San Miguel",
        triangles: 10_374_078,
        description: "a furnished courtyard with trees, ivy, a fountain and laid tables",
        generate: courtyard::generate,
        view: courtyard::view,
    },
    CatalogueEntry {
        name: "powerplant",
        stands_for: "Powerplant",
        triangles: 12_777_240,
        description: "a steel frame full of boilers and long thin pipes in all directions",
        generate: powerplant::generate,
        view: powerplant::view,
    },
    CatalogueEntry {
        name: "vegetation",
        stands_for: "Vegetation",
        triangles: 1_854_056,
        description: "a clearing with ferns, grass, bushes and palms: leaves that overlap at every scale",
        generate: vegetation::generate,
        view: vegetation::view,
    },
    CatalogueEntry {
        name: "hairball",
        stands_for: "Hairball",
        triangles: 2_880_000,
        description: "thin curled tubes around a core, thousands of them across each ray",
        generate: hairball::generate,
        view: hairball::view,
    },
];

/// Why a built-in scene cannot be made.
#[derive(Debug, Error, PartialEq)]
pub enum BuildError {
    /// There is no scene of that name.
    #[error("no scene is called `{0}`; the built-in scenes are {names}", names = names())]
    UnknownName(String),
    /// The detail is not in (0, 1].
    #[error("detail {0} is not in (0, 1]; 1 is the full size, 0.01 about a hundredth of the triangles")]
    Detail(f64),
}

/// The names of all built-in scenes, separated by commas.
#[must_use]
pub fn names() -> String {
    CATALOGUE.iter().map(|entry| entry.name).collect::<Vec<_>>().join(", ")
}

/// The entry of the scene `name`, if there is one.
#[must_use]
pub fn find(name: &str) -> Option<&'static CatalogueEntry> {
    CATALOGUE.iter().find(|entry| entry.name == name)
}

/// Makes the scene `name` with about `detail` times its full number of triangles, but not fewer than the few
/// thousand that its coarsest level has. More detail never gives fewer triangles.
///
/// # Errors
/// [`BuildError`] for an unknown name or a detail outside (0, 1].
pub fn build(name: &str, detail: f64, seed: u64) -> Result<Scene, BuildError> {
    let entry = find(name).ok_or_else(|| BuildError::UnknownName(name.to_owned()))?;
    let mut builder = MeshBuilder::new(level_for(entry, detail, seed)?);
    (entry.generate)(&mut builder, seed);
    let (camera, light) = (entry.view)();
    Ok(Scene { name: name.to_owned(), mesh: builder.finish(), camera, light })
}

/// Number of triangles that [`build`] gives, without building.
///
/// # Errors
/// [`BuildError`] for an unknown name or a detail outside (0, 1].
pub fn count_triangles(name: &str, detail: f64, seed: u64) -> Result<u64, BuildError> {
    let entry = find(name).ok_or_else(|| BuildError::UnknownName(name.to_owned()))?;
    Ok(count_at(entry, level_for(entry, detail, seed)?, seed))
}

fn count_at(entry: &CatalogueEntry, level: f64, seed: u64) -> u64 {
    let mut counter = MeshBuilder::counting(level);
    (entry.generate)(&mut counter, seed);
    counter.triangles()
}

/// The highest level, in steps of 2^-16, that stays within `detail` times the full number of triangles.
fn level_for(entry: &CatalogueEntry, detail: f64, seed: u64) -> Result<f64, BuildError> {
    const STEPS: u32 = 1 << 16;
    if !(detail > 0.0 && detail <= 1.0) {
        return Err(BuildError::Detail(detail));
    }
    if detail == 1.0 {
        return Ok(1.0);
    }
    let limit = detail * count_at(entry, 1.0, seed) as f64;
    let level = |step: u32| f64::from(step) / f64::from(STEPS);
    let (mut within, mut beyond) = (0, STEPS);
    while beyond - within > 1 {
        let middle = within.midpoint(beyond);
        if count_at(entry, level(middle), seed) as f64 <= limit {
            within = middle;
        } else {
            beyond = middle;
        }
    }
    Ok(level(within))
}

#[cfg(test)]
mod tests;
