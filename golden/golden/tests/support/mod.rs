//! Meshes for tests, benchmarks and examples.
#![allow(dead_code, reason = "each user needs a part")]

pub mod strategies;

use scenes::Mesh;
use stress::shapes::soup;

/// The real scenes that `DUALSPLIT_DATA` holds, by number of triangles.
pub const SHARED_SCENES: [&str; 5] = ["bunny", "sibenik", "sanmiguel_leaves", "crytek_sponza", "dragon"];

/// A shared scene, or `None` if `DUALSPLIT_DATA` is unset.
pub fn shared_scene(name: &str) -> Option<Mesh> {
    Some(scenes::obj::load(testing::data(&format!("scenes/{name}.obj.xz"))?).expect("a valid scene"))
}

/// Small triangles at pseudo-random places, half of them stretched along an axis.
pub fn random_soup(triangles: usize, seed: u64) -> Mesh {
    let mut state = seed;
    // Numerical Recipes' 64-bit linear congruential generator; the upper bits are good enough for geometry.
    let mut next = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f32 / (1 << 24) as f32
    };
    soup((0..triangles).map(|i| {
        let origin: [f32; 3] = std::array::from_fn(|_| next());
        let mut size = [0.02; 3];
        if i % 2 == 0 {
            size[i % 3] = next();
        }
        std::array::from_fn(|_| std::array::from_fn(|axis| origin[axis] + size[axis] * next()))
    }))
}
