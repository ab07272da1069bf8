//! Trees for the tests of the builder's parts.

use std::ops::Range;

use proptest::prelude::*;
use scenes::Mesh;

use super::bounds::Bounds;
use super::work::{Link, Place, WorkTree};

fn mesh(corners: &[[[i8; 3]; 3]]) -> Mesh {
    Mesh {
        positions: corners.iter().flatten().map(|p| p.map(f32::from)).collect(),
        triangles: (0..corners.len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect(),
    }
}

/// Small triangles on a grid, many of them overlapping, and where [`random_tree`] shall split.
pub(super) fn triangles(count: Range<usize>) -> impl Strategy<Value = (Mesh, Vec<f64>)> {
    let triangle = (prop::array::uniform3(-3_i8..3), prop::array::uniform3(prop::array::uniform3(0_i8..5)))
        .prop_map(|(origin, corners)| corners.map(|p| [0, 1, 2].map(|i| origin[i] + p[i])));
    (prop::collection::vec(triangle, count), prop::collection::vec(0.0..1.0, 16))
        .prop_map(|(corners, splits)| (mesh(&corners), splits))
}

/// `count` unit triangles in a row.
pub(super) fn grid(count: i8) -> Mesh {
    let corners: Vec<_> = (0..count).map(|i| [[i, 0, 0], [i + 1, 0, 0], [i, 1, 1]]).collect();
    mesh(&corners)
}

/// A tree over `mesh` in the order of its triangles, one in each leaf, each node split at the next of
/// `splits`, a share of its triangles.
pub(super) fn random_tree(mesh: &Mesh, splits: &[f64]) -> WorkTree {
    let boxes: Vec<_> = (0..mesh.triangles.len()).map(|i| Bounds::of_triangle(mesh.corners(i))).collect();
    let mut tree = WorkTree::with_single_leaves((0..boxes.len() as u32).collect());
    let (link, bounds) = fill(&boxes, Place::root(&mut tree, u32::MAX), &mut splits.iter().cycle());
    tree.set_link(WorkTree::ROOT, link);
    tree.set_bounds(WorkTree::ROOT, bounds);
    tree
}

fn fill<'a>(boxes: &[Bounds], place: Place, splits: &mut impl Iterator<Item = &'a f64>) -> (Link, Bounds) {
    if let [bounds] = *boxes {
        return (Link::leaf(place.first_leaf), bounds);
    }
    let share = splits.next().expect("an endless iterator");
    let left_count = ((boxes.len() as f64 * share) as usize).clamp(1, boxes.len() - 1);
    let link = place.link();
    let (pair, [left, right]) = place.split(left_count);
    let left = fill(&boxes[..left_count], left, splits);
    let right = fill(&boxes[left_count..], right, splits);
    (link, pair.fill(left, right))
}
