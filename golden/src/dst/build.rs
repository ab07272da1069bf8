//! Building a partition for a dual-split tree from scratch, by the cost of its own nodes.
//!
//! A hierarchy of boxes pays the same for every inner node. A dual-split tree pays for a split and for the carves
//! that cut each half down to its child, fewer where the children fill their halves. So a candidate is judged by
//!
//! ```text
//! cost = area(P)                                 the split, visited by all rays that meet the parent P
//!      + least cost of the carves of both sides  (see `convert`, over all three axes)
//!      + area(A) n(A) + area(B) n(B)             the triangles, as in the surface area heuristic
//! ```
//!
//! over the binned candidates of all three axes that the last line alone ranks best. The result is a binary hierarchy,
//! which [`Dst::convert`](super::Dst::convert) turns into the tree that was planned, and from which the other
//! structures can be converted as well.

use super::convert::Plan;
use crate::Aabb;
use crate::build::{BinaryTree, BuildError, Content, MAX_DEPTH, MAX_LEAF_SIZE, Node, Tree, check_mesh};
use scenes::Mesh;

/// Bins on each axis.
const BINS: usize = 16;
/// Candidates, cheapest by the surface area heuristic first, whose carves are planned.
const PLANNED: usize = 8;
/// From this many triangles on, both children are built in parallel.
const PARALLEL: usize = 4096;

/// Builds the hierarchy of a dual-split tree over `mesh`, with at most `max_leaf_size` triangles in a leaf.
///
/// The result does not depend on the number of threads. Time is O(n log n), depth at most [`MAX_DEPTH`].
///
/// # Errors
/// As [`build`](crate::build::build).
pub fn build_for_dst(mesh: &Mesh, max_leaf_size: u32) -> Result<BinaryTree, BuildError> {
    if !(1..=MAX_LEAF_SIZE).contains(&max_leaf_size) {
        return Err(BuildError::LeafSize(max_leaf_size));
    }
    check_mesh(mesh)?;
    let item = |index: usize| {
        let aabb = Aabb::of_points(&mesh.corners(index));
        Item { aabb, centre: aabb.centre(), index: index as u32 }
    };
    let mut items: Vec<Item> = (0..mesh.triangles.len()).map(item).collect();
    let nodes = subtree(&mut items, 0, MAX_DEPTH, max_leaf_size as usize);
    Ok(Tree { nodes, primitives: items.iter().map(|item| item.index).collect() })
}

#[derive(Clone, Copy)]
struct Item {
    aabb: Aabb,
    centre: [f32; 3],
    index: u32,
}

fn bounds(items: &[Item]) -> Aabb {
    items.iter().fold(Aabb::EMPTY, |aabb, item| aabb.union(item.aabb))
}

/// The nodes over `items`, which start at `first` among all primitives and end up in the order of the leaves.
fn subtree(items: &mut [Item], first: usize, levels: u32, max_leaf_size: usize) -> Vec<Node> {
    let aabb = bounds(items);
    let Some(middle) = divide(items, &aabb, levels, max_leaf_size) else {
        items.sort_unstable_by_key(|item| item.index);
        let content = Content::Leaf { first_primitive: first as u32, primitive_count: items.len() as u32 };
        return vec![Node { aabb, content }];
    };
    let parallel = items.len() >= PARALLEL;
    let (left, right) = items.split_at_mut(middle);
    let mut build_left = || subtree(left, first, levels - 1, max_leaf_size);
    let mut build_right = || subtree(right, first + middle, levels - 1, max_leaf_size);
    let children =
        if parallel { rayon::join(build_left, build_right) } else { (build_left(), build_right()) };
    join(aabb, children.0, children.1)
}

/// A root over two subtrees: their roots side by side, then all that is below the first, then below the second.
fn join(aabb: Aabb, left: Vec<Node>, right: Vec<Node>) -> Vec<Node> {
    let moved = |node: &Node, by: usize| match node.content {
        Content::Inner { first_child, child_count } => {
            Node { content: Content::Inner { first_child: first_child + by as u32, child_count }, ..*node }
        }
        Content::Leaf { .. } => *node,
    };
    let mut nodes = Vec::with_capacity(1 + left.len() + right.len());
    nodes.push(Node { aabb, content: Content::Inner { first_child: 1, child_count: 2 } });
    // Below the left root every node moves by the two roots before it, below the right one by all of the left too.
    let (by_left, by_right) = (2, 1 + left.len());
    nodes.push(moved(&left[0], by_left));
    nodes.push(moved(&right[0], by_right));
    nodes.extend(left[1..].iter().map(|node| moved(node, by_left)));
    nodes.extend(right[1..].iter().map(|node| moved(node, by_right)));
    nodes
}

/// Orders `items` so that the first ones go left, and returns how many; `None` where they are to be a leaf.
fn divide(items: &mut [Item], aabb: &Aabb, levels: u32, max_leaf_size: usize) -> Option<usize> {
    let count = items.len();
    if count == 1 || levels == 0 {
        return None;
    }
    let may_be_leaf = count <= max_leaf_size;
    // With few levels left, only halving is sure to end in time.
    let halving_levels = usize::BITS - (count - 1).leading_zeros();
    let best = if halving_levels >= levels { None } else { best_candidate(items, aabb) };
    match best {
        Some(best) if !(may_be_leaf && aabb.half_area() * count as f64 <= best.cost) => {
            Some(partition(items, |item| best.bins.bin(best.axis, item.centre) <= best.last_left))
        }
        Some(_) => None,
        None if may_be_leaf => None,
        None => {
            let axis = (0..3).max_by(|i, j| extent(aabb, *i).total_cmp(&extent(aabb, *j))).unwrap_or(0);
            items.sort_unstable_by(|a, b| {
                a.centre[axis].total_cmp(&b.centre[axis]).then(a.index.cmp(&b.index))
            });
            Some(count / 2)
        }
    }
}

fn extent(aabb: &Aabb, axis: usize) -> f32 {
    aabb.max[axis] - aabb.min[axis]
}

/// Moves the items that `goes_left` to the front, both sides keeping their order, and returns how many they are.
fn partition(items: &mut [Item], goes_left: impl Fn(&Item) -> bool) -> usize {
    let (left, right): (Vec<Item>, Vec<Item>) = items.iter().partition(|item| goes_left(item));
    items[..left.len()].copy_from_slice(&left);
    items[left.len()..].copy_from_slice(&right);
    left.len()
}

/// Equal slices of the box of all centres.
#[derive(Clone, Copy)]
struct Bins {
    centres: Aabb,
}

impl Bins {
    fn bin(&self, axis: usize, centre: [f32; 3]) -> usize {
        let (low, high) = (f64::from(self.centres.min[axis]), f64::from(self.centres.max[axis]));
        let share = (f64::from(centre[axis]) - low) / (high - low);
        ((share * BINS as f64) as usize).min(BINS - 1)
    }
}

struct Candidate {
    axis: usize,
    last_left: usize,
    bins: Bins,
    boxes: [Aabb; 2],
    /// Of the triangles alone, then of all.
    cost: f64,
}

fn best_candidate(items: &[Item], aabb: &Aabb) -> Option<Candidate> {
    let centres = items.iter().fold(Aabb::EMPTY, |aabb, item| aabb.grow(item.centre));
    let bins = Bins { centres };
    let mut candidates: Vec<Candidate> = (0..3)
        .filter(|axis| centres.min[*axis] < centres.max[*axis])
        .flat_map(|axis| on_axis(items, axis, bins))
        .collect();
    // The sort is stable: equal candidates stay in the order of axes and bins.
    candidates.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    candidates.truncate(PLANNED);
    for candidate in &mut candidates {
        candidate.cost += aabb.half_area() + Plan::best(aabb, &candidate.boxes).cost();
    }
    candidates.into_iter().reduce(|best, next| if next.cost < best.cost { next } else { best })
}

/// The candidates between the bins of one axis, both sides of which hold something.
fn on_axis(items: &[Item], axis: usize, bins: Bins) -> Vec<Candidate> {
    let mut slices = [(Aabb::EMPTY, 0usize); BINS];
    for item in items {
        let slice = &mut slices[bins.bin(axis, item.centre)];
        *slice = (slice.0.union(item.aabb), slice.1 + 1);
    }
    let mut right = [(Aabb::EMPTY, 0usize); BINS];
    for bin in (0..BINS - 1).rev() {
        let (aabb, count) = slices[bin + 1];
        right[bin] = (right[bin + 1].0.union(aabb), right[bin + 1].1 + count);
    }
    let mut left = (Aabb::EMPTY, 0usize);
    let mut candidates = vec![];
    for last_left in 0..BINS - 1 {
        let (aabb, count) = slices[last_left];
        left = (left.0.union(aabb), left.1 + count);
        let right = right[last_left];
        if left.1 > 0 && right.1 > 0 && count > 0 {
            let cost = left.0.half_area() * left.1 as f64 + right.0.half_area() * right.1 as f64;
            candidates.push(Candidate { axis, last_left, bins, boxes: [left.0, right.0], cost });
        }
    }
    candidates
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::{BuildOptions, Quality, build};
    use crate::dst::Dst;
    use crate::stats::TreeStatistics;
    use crate::structure::{Structure, pack_triangles};

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
                let tree = build_for_dst(&mesh, max_leaf_size).unwrap();
                assert!(tree.max_depth() <= MAX_DEPTH);
                dst(&mesh, &tree);
            }
        }
    }

    #[test]
    fn its_own_cost_beats_a_box_hierarchy_of_the_same_effort() {
        let mesh = scenes::Scene::load("atrium", 0.05, 0).unwrap().mesh;
        let cost = |tree: &BinaryTree| {
            let statistics = TreeStatistics::of(&Structure::Dst(dst(&mesh, tree)));
            statistics.expected_node_visits
        };
        let ours = cost(&build_for_dst(&mesh, 4).unwrap());
        let boxes = cost(&build(&mesh, &BuildOptions { quality: Quality::Fast, max_leaf_size: 4 }).unwrap());
        println!(
            "expected node visits: {ours:.2} from scratch, {boxes:.2} by conversion from a fast hierarchy"
        );
        assert!(ours < boxes);
    }

    #[test]
    fn threads_do_not_matter() {
        let mesh = scenes::Scene::load("vegetation", 0.01, 0).unwrap().mesh;
        let on = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| build_for_dst(&mesh, 4).unwrap())
        };
        assert_eq!(on(1), on(3));
    }
}
