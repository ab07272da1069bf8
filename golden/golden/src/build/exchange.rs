//! Optimisation of a finished tree for a cost that depends on each node's box and its children's: subtrees trade places.
//!
//! At an inner node, a child may trade places with a child of its sibling, and a grandchild with one on the other side
//! (Kensler, "Tree Rotations for Improving Bounding Volume Hierarchies", IEEE RT 2008). That changes this node and the
//! child or children below which something moved, and no other box. The best trade of every node is looked for in
//! parallel, then those that do not touch each other are carried out, greatest gain first; so no trade raises the
//! cost, and the result does not depend on the number of threads.

use super::bounds::Bounds;
use super::work::{Slot, WorkTree};
use rayon::prelude::*;

/// The least gain that is worth a trade, as a share of the cost of the nodes concerned. Rounding is far below.
const LEAST_GAIN: f64 = 1e-6;
/// Nodes that a task looks at.
const TASK: usize = 256;

/// Two slots that trade their contents.
#[derive(Clone, Copy)]
struct Trade {
    gain: f64,
    /// The node above both.
    top: u32,
    slots: [u32; 2],
}

/// Lowers the sum of `cost` over all inner nodes of `tree`, in up to `rounds` rounds. Leaves stay as they are.
///
/// `cost` is a function of a node's box and its children's, no less than the node's half area.
pub(super) fn exchange(tree: &mut WorkTree, rounds: u32, cost: impl Fn(Bounds, [Bounds; 2]) -> f64 + Sync) {
    let slots = 2 * tree.links.len();
    // The first round looks at all nodes, the others where something changed.
    let mut changed = vec![true; slots];
    for _ in 0..rounds {
        let finder = Finder { tree, cost: &cost };
        let tops = (0..slots as u32).into_par_iter().with_min_len(TASK);
        let mut trades: Vec<Trade> =
            tops.filter(|top| changed[*top as usize]).filter_map(|top| finder.best_trade(top)).collect();
        trades.sort_unstable_by(|a, b| b.gain.total_cmp(&a.gain).then(a.top.cmp(&b.top)));
        if trades.is_empty() {
            break;
        }
        changed = carry_out(tree, &trades);
    }
}

/// Carries out the `trades` whose nodes no trade before has touched; returns the slots to look at again.
fn carry_out(tree: &mut WorkTree, trades: &[Trade]) -> Vec<bool> {
    let slots = 2 * tree.links.len();
    let (mut touched, mut changed) = (vec![false; slots], vec![false; slots]);
    for trade in trades {
        changed[trade.top as usize] = true;
        let children = match tree.slot(trade.top) {
            Slot::Inner(pair) if !touched[trade.top as usize] => [2 * pair, 2 * pair + 1],
            _ => continue,
        };
        if children.iter().any(|slot| touched[*slot as usize]) {
            continue;
        }
        swap(tree, trade);
        for slot in [trade.top].into_iter().chain(children).chain(trade.slots) {
            touched[slot as usize] = true;
            changed[slot as usize] = true;
        }
        if trade.top != WorkTree::ROOT {
            changed[tree.parent(trade.top) as usize] = true;
        }
    }
    changed
}

/// Swaps the contents of the trade's slots and updates the boxes between them and its top, whose own box stays.
fn swap(tree: &mut WorkTree, trade: &Trade) {
    let [x, y] = trade.slots;
    let (links, bounds) = ([tree.link(x), tree.link(y)], [tree.bounds(x), tree.bounds(y)]);
    for (slot, link, bounds) in [(x, links[1], bounds[1]), (y, links[0], bounds[0])] {
        tree.set_link(slot, link);
        tree.set_bounds(slot, bounds);
    }
    for slot in trade.slots {
        let parent = tree.parent(slot);
        if parent != trade.top {
            tree.refit(parent);
        }
    }
}

struct Finder<'a, C> {
    tree: &'a WorkTree,
    cost: &'a C,
}

impl<C: Fn(Bounds, [Bounds; 2]) -> f64> Finder<'_, C> {
    /// The trade below the inner node in slot `top` that lowers the cost most; ties go to the one that is tried first.
    /// Where the areas alone exceed what there is, the cost is not asked for.
    fn best_trade(&self, top: u32) -> Option<Trade> {
        let tree = self.tree;
        let pair = tree.link(top).children()?;
        let children = [2 * pair, 2 * pair + 1];
        let grandchildren = children.map(|slot| match tree.slot(slot) {
            Slot::Inner(pair) => Some([2 * pair, 2 * pair + 1]),
            Slot::Leaf(_) => None,
        });
        if grandchildren == [None, None] {
            return None;
        }
        let whole = tree.bounds(top);
        let cost = &self.cost;
        let below = [0, 1].map(|side| {
            let slots = grandchildren[side]?;
            Some(cost(tree.bounds(children[side]), slots.map(|slot| tree.bounds(slot))))
        });
        let here = cost(whole, children.map(|slot| tree.bounds(slot)));
        let mut best: Option<Trade> = None;
        let mut offer = |before: f64, after: f64, slots: [u32; 2]| {
            let gain = before - after;
            if gain > best.map_or(LEAST_GAIN * before, |best| best.gain) {
                best = Some(Trade { gain, top, slots });
            }
        };
        // A child with a child of its sibling.
        for side in [0, 1] {
            let (Some(slots), Some(below)) = (grandchildren[side], below[side]) else { continue };
            let sibling = children[1 - side];
            for (up, stays) in [(slots[0], slots[1]), (slots[1], slots[0])] {
                let inside = [sibling, stays].map(|slot| tree.bounds(slot));
                let lower = inside[0].union(inside[1]);
                if whole.half_area() + lower.half_area() < here + below {
                    let after = cost(lower, inside) + cost(whole, [tree.bounds(up), lower]);
                    offer(here + below, after, [sibling, up]);
                }
            }
        }
        // Two grandchildren.
        if let ([Some(left), Some(right)], [Some(below_left), Some(below_right)]) = (grandchildren, below) {
            let before = here + below_left + below_right;
            for (other, stays) in [(right[0], right[1]), (right[1], right[0])] {
                let [new_left, new_right] =
                    [[other, left[1]], [left[0], stays]].map(|slots| slots.map(|slot| tree.bounds(slot)));
                let [lower_left, lower_right] = [new_left, new_right].map(|[a, b]| a.union(b));
                if whole.half_area() + lower_left.half_area() + lower_right.half_area() < before {
                    let after = cost(lower_left, new_left)
                        + cost(lower_right, new_right)
                        + cost(whole, [lower_left, lower_right]);
                    offer(before, after, [left[0], other]);
                }
            }
        }
        best
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::testing::{random_tree, triangles};
    use proptest::prelude::*;

    fn sum(tree: &WorkTree, cost: impl Fn(Bounds, [Bounds; 2]) -> f64) -> f64 {
        let below: Vec<u32> = tree.pairs_depth_first();
        below
            .iter()
            .map(|&pair| cost(tree.bounds(tree.parents[pair as usize]), tree.bounds[pair as usize].0))
            .sum()
    }

    /// A cost that depends on the children as well as on the node.
    fn overlap(node: Bounds, [a, b]: [Bounds; 2]) -> f64 {
        let common = Bounds { min: a.min.max(b.min), max: a.max.min(b.max) };
        let extent = (common.max - common.min).max(glam::Vec3A::ZERO);
        node.half_area() + 3.0 * Bounds { min: glam::Vec3A::ZERO, max: extent }.half_area()
    }

    proptest! {
        #[test]
        fn ends_where_no_trade_gains((mesh, splits) in triangles(1..40)) {
            let mut tree = random_tree(&mesh, &splits);
            let before = sum(&tree, overlap);
            exchange(&mut tree, 1000, overlap);
            tree.to_tree().validate(&mesh).expect("a hierarchy");
            let after = sum(&tree, overlap);
            prop_assert!(after <= before * (1.0 + 1e-12));
            // Every trade is tried by carrying it out.
            for top in 0..2 * tree.links.len() as u32 {
                for slots in trades(&tree, top) {
                    let mut traded = tree.clone();
                    swap(&mut traded, &Trade { gain: 0.0, top, slots });
                    traded.to_tree().validate(&mesh).expect("a hierarchy");
                    prop_assert!(sum(&traded, overlap) >= after - 3.0 * LEAST_GAIN * after);
                }
            }
        }
    }

    fn trades(tree: &WorkTree, top: u32) -> Vec<[u32; 2]> {
        let children = |slot: u32| match tree.slot(slot) {
            Slot::Inner(pair) => vec![2 * pair, 2 * pair + 1],
            Slot::Leaf(_) => vec![],
        };
        let [left, right] = children(top)[..] else { return vec![] };
        let (below_left, below_right) = (children(left), children(right));
        let mut all: Vec<_> = below_left.iter().map(|slot| [right, *slot]).collect();
        all.extend(below_right.iter().map(|slot| [left, *slot]));
        all.extend(below_left.iter().flat_map(|a| below_right.iter().map(|b| [*a, *b])));
        all
    }
}
