//! Collapse of the binary tree into a wide one.

use super::tree::{BinaryTree, Content, Node, Tree};

/// The hierarchy with up to `WIDTH` children that [`collapse_wide`] makes.
pub type WideTree<const WIDTH: usize> = Tree<WIDTH>;

/// Least costs of the parts of a wide tree below one inner node of the binary tree, in units of area: entry
/// `i - 1` if it may become up to `i` siblings.
type Costs<const WIDTH: usize> = [f64; WIDTH];

/// Collapses `tree` into nodes of up to `WIDTH` children with the least [`Tree::sah_cost`] that removing
/// inner nodes reaches. Leaves and their boxes stay as they are. Ties go to fewer nodes.
///
/// Dynamic programming after Ylitie, Karras and Laine 2017, "Efficient Incoherent Ray Traversal on GPUs
/// Through Compressed Wide BVHs", section 3.1: the cost C(n, i) of representing the subtree of node n by at
/// most i siblings is the least over distributions of the i between its two children; as one sibling, n is
/// itself a wide node.
#[must_use]
pub fn collapse_wide<const WIDTH: usize>(tree: &BinaryTree) -> WideTree<WIDTH> {
    const { assert!(WIDTH >= 2, "an inner node has at least two children") };
    let collapse = Collapse::<WIDTH>::new(tree);
    let mut nodes = vec![tree.nodes[0]];
    // (node of the binary tree, its index in the wide tree)
    let mut stack = vec![(0_usize, 0_usize)];
    let mut children = Vec::with_capacity(WIDTH);
    while let Some((binary, wide)) = stack.pop() {
        if matches!(tree.nodes[binary].content, Content::Leaf { .. }) {
            continue;
        }
        children.clear();
        collapse.distribute(binary, WIDTH, &mut children);
        let first_child = nodes.len();
        nodes[wide].content =
            Content::Inner { first_child: first_child as u32, child_count: children.len() as u32 };
        nodes.extend(children.iter().map(|&child| tree.nodes[child]));
        stack.extend(children.iter().copied().zip(first_child..nodes.len()).rev());
    }
    Tree { nodes, primitives: tree.primitives.clone() }
}

struct Collapse<'a, const WIDTH: usize> {
    tree: &'a BinaryTree,
    costs: Vec<Costs<WIDTH>>,
}

impl<'a, const WIDTH: usize> Collapse<'a, WIDTH> {
    fn new(tree: &'a BinaryTree) -> Self {
        let mut collapse = Self { tree, costs: vec![[0.0; WIDTH]; tree.nodes.len()] };
        for (index, node) in tree.nodes.iter().enumerate().rev() {
            collapse.costs[index] = collapse.costs_of(node, index);
        }
        collapse
    }

    fn costs_of(&self, node: &Node, index: usize) -> Costs<WIDTH> {
        let area = self.tree.area_weight(node);
        if let Content::Leaf { primitive_count, .. } = node.content {
            return [area * f64::from(primitive_count); WIDTH];
        }
        let mut costs = [area + self.best_split(index, WIDTH).0; WIDTH];
        for siblings in 2..=WIDTH {
            costs[siblings - 1] = costs[siblings - 2].min(self.best_split(index, siblings).0);
        }
        costs
    }

    /// The least cost of the children of inner node `index` as at most `siblings` siblings, at least one for
    /// each child, and how many are the first child's.
    fn best_split(&self, index: usize, siblings: usize) -> (f64, usize) {
        let children = self.tree.children(&self.tree.nodes[index]);
        let [left, right] = [children.start, children.start + 1];
        let cost = |of_left: usize| self.costs[left][of_left - 1] + self.costs[right][siblings - of_left - 1];
        (2..siblings).fold((cost(1), 1), |best, of_left| {
            let cost = cost(of_left);
            if cost < best.0 { (cost, of_left) } else { best }
        })
    }

    /// Appends the best at most `siblings` (2 or more) siblings that represent the children of inner node
    /// `index`.
    fn distribute(&self, index: usize, siblings: usize, children: &mut Vec<usize>) {
        let of_left = self.best_split(index, siblings).1;
        let [left, right] = [0, 1].map(|side| self.tree.children(&self.tree.nodes[index]).start + side);
        self.represent(left, of_left, children);
        self.represent(right, siblings - of_left, children);
    }

    /// Appends the best at most `siblings` siblings that represent node `index`.
    fn represent(&self, index: usize, siblings: usize, children: &mut Vec<usize>) {
        let leaf = matches!(self.tree.nodes[index].content, Content::Leaf { .. });
        // The most siblings for which opening the node up is no worse than fewer.
        let opened =
            (2..=siblings).rev().find(|&i| !leaf && self.best_split(index, i).0 <= self.costs[index][i - 2]);
        match opened {
            Some(siblings) => self.distribute(index, siblings, children),
            None => children.push(index),
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::build::{BuildOptions, Quality, build};

    /// The least cost over all wide trees, by trying every set of inner nodes to remove.
    fn brute_force(tree: &BinaryTree, index: usize, width: usize) -> f64 {
        let node = &tree.nodes[index];
        let area = tree.area_weight(node);
        if let Content::Leaf { primitive_count, .. } = node.content {
            return area * f64::from(primitive_count);
        }
        let mut best = f64::INFINITY;
        let mut fronts = vec![tree.children(node).collect::<Vec<_>>()];
        while let Some(front) = fronts.pop() {
            best = best.min(front.iter().map(|&child| brute_force(tree, child, width)).sum());
            for (i, &child) in front.iter().enumerate() {
                let below = tree.children(&tree.nodes[child]);
                if !below.is_empty() && front.len() < width {
                    let mut opened = front.clone();
                    opened.splice(i..=i, below);
                    fronts.push(opened);
                }
            }
        }
        area + best
    }

    fn check<const WIDTH: usize>(mesh: &scenes::Mesh, tree: &BinaryTree) {
        let wide = collapse_wide::<WIDTH>(tree);
        wide.validate(mesh).expect("a hierarchy");
        let leaves = |nodes: &[Node]| -> Vec<Node> {
            nodes.iter().filter(|n| matches!(n.content, Content::Leaf { .. })).copied().collect()
        };
        let order = |node: &Node| match node.content {
            Content::Leaf { first_primitive, .. } => first_primitive,
            Content::Inner { .. } => unreachable!(),
        };
        let (mut ours, mut theirs) = (leaves(&wide.nodes), leaves(&tree.nodes));
        ours.sort_by_key(order);
        theirs.sort_by_key(order);
        assert_eq!(ours, theirs);
        let least = brute_force(tree, 0, WIDTH) / tree.area_weight(&tree.nodes[0]);
        assert!((wide.sah_cost() - least).abs() <= 1e-12 * least, "{} {least}", wide.sah_cost());
    }

    proptest! {
        #[test]
        fn cost_is_the_least_of_all_collapses(
            corners in prop::collection::vec(prop::array::uniform3(prop::array::uniform3(0_u8..20)), 1..12)
        ) {
            let positions = corners.iter().flatten().map(|p| p.map(f32::from)).collect();
            let triangles = (0..corners.len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
            let mesh = scenes::Mesh { positions, triangles };
            let options = BuildOptions { max_leaf_size: 1, ..BuildOptions::new(Quality::Fast) };
            let tree = build(&mesh, &options).expect("a tree");
            check::<3>(&mesh, &tree);
            check::<4>(&mesh, &tree);
            check::<8>(&mesh, &tree);
            check::<16>(&mesh, &tree);
            prop_assert_eq!(&collapse_wide::<2>(&tree), &tree);
        }
    }
}
