//! Trees of `obvhs` over our meshes.
#![allow(dead_code, reason = "each user needs a part")]

use obvhs::BvhBuildParams;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2;
use obvhs::triangle::Triangle;
use scenes::Mesh;

/// The triangles of `mesh` as `obvhs` takes them.
pub fn triangles(mesh: &Mesh) -> Vec<Triangle> {
    (0..mesh.triangles.len())
        .map(|i| {
            let [v0, v1, v2] = mesh.corners(i).map(Into::into);
            Triangle { v0, v1, v2 }
        })
        .collect()
}

/// `preset` without triangle pre-splits and with leaves of at most `max_leaf_size` triangles.
pub fn params(preset: BvhBuildParams, max_leaf_size: u32) -> BvhBuildParams {
    BvhBuildParams { pre_split: false, max_prims_per_leaf: max_leaf_size, ..preset }
}

/// The `very_slow` preset as it is, and with the weights of `Tree::sah_cost` for its leaf collapse, which by
/// default takes a traversal step for three times as dear as a triangle test.
pub fn very_slow_params(max_leaf_size: u32) -> [BvhBuildParams; 2] {
    let preset = params(BvhBuildParams::very_slow_build(), max_leaf_size);
    [preset, BvhBuildParams { collapse_traversal_cost: 1.0, ..preset }]
}

/// The lesser cost of the two.
pub fn very_slow_sah_cost(mesh: &Mesh, max_leaf_size: u32) -> f64 {
    let triangles = triangles(mesh);
    very_slow_params(max_leaf_size)
        .map(|params| sah_cost(&build_bvh2(&triangles, params, &mut Default::default())))
        .into_iter()
        .fold(f64::INFINITY, f64::min)
}

/// The formula of `Tree::sah_cost`.
pub fn sah_cost(bvh: &Bvh2) -> f64 {
    let half_area = |node: usize| {
        let aabb = bvh.nodes[node].aabb();
        let e = aabb.max.as_dvec3() - aabb.min.as_dvec3();
        e.x * e.y + e.y * e.z + e.z * e.x
    };
    let weight = |node: usize| match &bvh.nodes[node] {
        node if node.is_leaf() => f64::from(node.prim_count),
        _ => 1.0,
    };
    (0..bvh.nodes.len()).map(|node| weight(node) * half_area(node)).sum::<f64>() / half_area(0)
}
