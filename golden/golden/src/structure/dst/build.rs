//! Building a partition for a dual-split tree, by the cost of its own nodes.
//!
//! A hierarchy of boxes pays the same for every inner node. A dual-split tree pays for a split and for the carves
//! that cut each half down to its child, fewer where the children fill their halves:
//!
//! ```text
//! cost of an inner node = area(P)                                the split, visited by all rays that meet the box P
//!                       + least cost of the carves of both sides (see `convert`, over all three axes)
//! cost of a leaf        = area x triangles                       as in the surface area heuristic
//! ```
//!
//! The partition of the least SAH cost is where the search starts: it counts the splits and the triangles. Subtrees are
//! exchanged, then leaves merged, as long as that lowers the cost above. The result is a binary hierarchy, which
//! [`Dst::convert`](super::Dst::convert) turns into the tree that was planned, and from which the other structures can
//! be converted as well.

use super::convert::Plan;
use crate::build::{BinaryTree, BuildError, BuildOptions, build_for_cost};
use scenes::Mesh;

/// Builds the hierarchy of a dual-split tree over `mesh`.
///
/// The result does not depend on the number of threads; depth and time are bounded as for [`build`](crate::build::build).
///
/// # Errors
/// As [`build`](crate::build::build).
pub fn build_for_dst(mesh: &Mesh, options: &BuildOptions) -> Result<BinaryTree, BuildError> {
    build_for_cost(mesh, options, |node, children| node.half_area() + Plan::best(node, children).cost())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::{MAX_DEPTH, Quality, build};
    use crate::dst::Dst;
    use crate::stats::TreeStatistics;
    use crate::structure::{Structure, pack_triangles};

    fn options(max_leaf_size: u32) -> BuildOptions {
        BuildOptions { max_leaf_size, ..BuildOptions::new(Quality::High) }
    }

    fn dst(mesh: &Mesh, tree: &BinaryTree) -> Dst {
        tree.validate(mesh).unwrap();
        let dst = Dst::convert(tree, pack_triangles(mesh, tree)).unwrap();
        dst.validate(tree).unwrap();
        dst
    }

    #[test]
    fn every_kind_of_mesh_gives_a_valid_tree() {
        let one = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let soups: [Vec<[[f32; 3]; 3]>; 4] = [
            vec![one],
            vec![one; 5000],
            (0..300).map(|i| one.map(|p| p.map(|x| x * 1.2f32.powi(i)))).collect(),
            (0..2000).map(|i| one.map(|[x, y, z]| [x + i as f32, y, z])).collect(),
        ];
        for soup in soups {
            let positions: Vec<_> = soup.into_iter().flatten().collect();
            let triangles = (0..positions.len() as u32 / 3).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
            let mesh = Mesh { positions, triangles };
            for max_leaf_size in [1, 4] {
                let tree = build_for_dst(&mesh, &options(max_leaf_size)).unwrap();
                assert!(tree.max_depth() <= MAX_DEPTH);
                dst(&mesh, &tree);
            }
        }
    }

    #[test]
    fn its_own_cost_is_below_that_of_the_best_box_hierarchy() {
        for scene in ["atrium", "hairball", "vegetation"] {
            let mesh = scenes::Scene::load(scene, 0.005, 0).unwrap().mesh;
            let cost = |tree: &BinaryTree| TreeStatistics::of(&Structure::Dst(dst(&mesh, tree))).own_cost();
            let ours = cost(&build_for_dst(&mesh, &options(4)).unwrap());
            let converted = cost(&build(&mesh, &options(4)).unwrap());
            println!("{scene}: {ours:.2}, by conversion {converted:.2}");
            assert!(ours < converted, "{scene}: {ours} {converted}");
        }
    }

    #[test]
    fn threads_do_not_matter() {
        let mesh = scenes::Scene::load("vegetation", 0.01, 0).unwrap().mesh;
        let on = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| build_for_dst(&mesh, &options(4)).unwrap())
        };
        assert_eq!(on(1), on(3));
    }
}
