//! Cuts: sets of at most six nodes that determine another, with its function of them.

use super::patterns::Patterns;
use crate::aig::{Aig, Lit};
use crate::liberty::function::{MAX_INPUTS, variable};

/// Most cuts of a node.
const MOST_CUTS: usize = 32;

/// A cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cut {
    /// Nodes, in ascending order; the first `size` count.
    pub leaves: [u32; MAX_INPUTS],
    /// Number of leaves.
    pub size: u8,
    /// The node's value as a function of them.
    pub table: u64,
}

impl Cut {
    pub fn trivial(node: usize) -> Self {
        let mut leaves = [0; MAX_INPUTS];
        leaves[0] = node as u32;
        Self { leaves, size: 1, table: variable(0) }
    }

    /// The leaves.
    pub fn leaves(&self) -> &[u32] {
        &self.leaves[..self.size as usize]
    }
}

/// The cuts of every AND that is needed; none for other nodes.
pub fn enumerate(aig: &Aig, patterns: &Patterns) -> Vec<Vec<Cut>> {
    let live = aig.live();
    // Weight of a node: an estimate of the area that it costs, shared among its users.
    let mut users = vec![0u32; aig.nodes().len()];
    for node in (0..live.len()).filter(|&node| live[node]) {
        aig.operands(node).iter().flatten().for_each(|lit| users[lit.node()] += 1);
    }
    let mut weight = vec![0f32; aig.nodes().len()];
    let mut all: Vec<Vec<Cut>> = vec![Vec::new(); aig.nodes().len()];
    for node in 0..aig.nodes().len() {
        let Some([a, b]) = aig.operands(node).filter(|_| live[node]) else { continue };
        let region = aig.origin_of(node).region;
        let of = |lit: Lit| -> Vec<Cut> {
            let operand = lit.node();
            let mut cuts = vec![Cut::trivial(operand)];
            if aig.origin_of(operand).region == region {
                cuts.extend_from_slice(&all[operand]);
            }
            cuts
        };
        let mut cuts: Vec<(f32, bool, Cut)> = Vec::new();
        let (left, right) = (of(a), of(b));
        for x in &left {
            for y in &right {
                let Some(cut) = join(x, y, a.is_complemented(), b.is_complemented()) else { continue };
                if cuts.iter().any(|(_, _, known)| dominates(known, &cut)) {
                    continue;
                }
                cuts.retain(|(_, _, known)| !dominates(&cut, known));
                let flow: f32 = cut.leaves().iter().map(|&leaf| weight[leaf as usize]).sum();
                let size = cut.size as usize;
                let area = [cut.table, !cut.table]
                    .iter()
                    .filter_map(|&table| patterns.of(size, table).first())
                    .map(|found| found.area)
                    .reduce(f32::min);
                // A cut that no cell computes may still become part of one that a cell does.
                let cost = flow + area.unwrap_or(cut.size as f32 * patterns.inverter.1);
                cuts.push((cost, area.is_some(), cut));
            }
        }
        cuts.sort_by(|a, b| {
            b.1.cmp(&a.1).then(a.0.total_cmp(&b.0)).then_with(|| a.2.leaves().cmp(b.2.leaves()))
        });
        // The cut of the two operands stays in any case, because a cell of two inputs covers it.
        let direct = cuts.iter().position(|(_, _, cut)| {
            cut.leaves().iter().all(|&leaf| leaf as usize == a.node() || leaf as usize == b.node())
        });
        if let Some(position) = direct.filter(|&position| position >= MOST_CUTS) {
            cuts.swap(MOST_CUTS - 1, position);
        }
        // Most of the cuts kept are matched ones. Some others stay as parts of larger cuts.
        let matched = cuts.iter().filter(|cut| cut.1).count().min(MOST_CUTS - 2);
        let mut kept: Vec<(f32, bool, Cut)> = cuts[..matched].to_vec();
        kept.extend(cuts.iter().filter(|cut| !cut.1).take(MOST_CUTS - matched));
        if let Some((cost, _, _)) = kept.first() {
            weight[node] = cost / users[node].max(1) as f32;
        }
        all[node] = kept.into_iter().map(|(_, _, cut)| cut).collect();
    }
    all
}

/// Whether every leaf of one cut is one of the other.
pub fn dominates(cut: &Cut, other: &Cut) -> bool {
    cut.size <= other.size && cut.leaves().iter().all(|leaf| other.leaves().contains(leaf))
}

pub fn join(x: &Cut, y: &Cut, invert_x: bool, invert_y: bool) -> Option<Cut> {
    let mut leaves = [0u32; MAX_INPUTS];
    let (mut i, mut j, mut size) = (0, 0, 0);
    let (left, right) = (x.leaves(), y.leaves());
    while i < left.len() || j < right.len() {
        if size == MAX_INPUTS {
            return None;
        }
        let next = match (left.get(i), right.get(j)) {
            (Some(&a), Some(&b)) => a.min(b),
            (Some(&a), None) => a,
            (None, Some(&b)) => b,
            (None, None) => break,
        };
        i += usize::from(left.get(i) == Some(&next));
        j += usize::from(right.get(j) == Some(&next));
        leaves[size] = next;
        size += 1;
    }
    let mut cut = Cut { leaves, size: size as u8, table: 0 };
    let expand = |part: &Cut, invert: bool| {
        let table = stretch(part, &cut.leaves[..size]);
        if invert { !table } else { table }
    };
    cut.table = expand(x, invert_x) & expand(y, invert_y);
    Some(cut)
}

/// The table of a cut over more leaves.
fn stretch(part: &Cut, leaves: &[u32]) -> u64 {
    let mut table = part.table;
    // The loop starts with the last variable, so that each variable moves to a free place.
    for (position, leaf) in part.leaves().iter().enumerate().rev() {
        let target = leaves.iter().position(|other| other == leaf).unwrap_or(position);
        for place in position..target {
            table = swap_adjacent(table, place);
        }
    }
    table
}

/// The table with variables `i` and `i + 1` exchanged.
fn swap_adjacent(table: u64, i: usize) -> u64 {
    let (low, high) = (variable(i), variable(i + 1));
    let up = table & low & !high;
    let down = table & !low & high;
    let stay = table & !(low ^ high);
    let distance = 1 << i;
    stay | up << distance | down >> distance
}
