//! Restructuring for depth: every node becomes a balanced sum of products of a cut, chosen so that the graph is as shallow as
//! it gets, and small where there is time (Mishchenko, Brayton, Jang, Kravets, "Delay Optimization Using SOP Balancing",
//! ICCAD 2011).
//!
//! Cuts do not cross regions, and a node's gates have its origin. The ports and latches stay as they are.

mod products;

use std::collections::HashMap;

use crate::aig::{Aig, Lit, Node};
use crate::map::cuts::{Cut, dominates, join};
use products::{Sum, sum};

/// Most cuts of a node.
const MOST_CUTS: usize = 8;

/// A cut with the better sum of products, of the node or of its complement.
#[derive(Clone)]
struct Candidate {
    cut: Cut,
    sum: Sum,
    complemented: bool,
    level: u32,
    flow: f32,
}

/// The graph, restructured. Its inputs, outputs and latches are those of `aig`, in order.
#[must_use]
pub fn restructure(aig: &Aig) -> Aig {
    let candidates = candidates(aig);
    let chosen = choose(aig, &candidates);
    build(aig, &candidates, &chosen)
}

fn region(aig: &Aig, node: usize) -> u32 {
    aig.origin_of(node).region
}

/// Sums of products of both polarities of a table, each computed once.
#[derive(Default)]
struct Sums(HashMap<(u64, u8), [Sum; 2]>);

impl Sums {
    fn of(&mut self, cut: &Cut) -> &[Sum; 2] {
        let size = cut.size;
        let both = |table: u64| [sum(table, size as usize), sum(!table, size as usize)];
        self.0.entry((cut.table, size)).or_insert_with(|| both(cut.table))
    }
}

/// For each live AND, its cuts: the shallowest first, and in any case that of its operands.
fn candidates(aig: &Aig) -> Vec<Vec<Candidate>> {
    let live = aig.live();
    let mut users = vec![0u32; aig.nodes().len()];
    for node in (0..live.len()).filter(|&node| live[node]) {
        aig.operands(node).iter().flatten().for_each(|lit| users[lit.node()] += 1);
    }
    let mut all: Vec<Vec<Candidate>> = vec![Vec::new(); aig.nodes().len()];
    let (mut levels, mut flows) = (vec![0u32; aig.nodes().len()], vec![0f32; aig.nodes().len()]);
    let mut sums = Sums::default();
    for node in 0..aig.nodes().len() {
        let Some([a, b]) = aig.operands(node).filter(|_| live[node]) else { continue };
        let of = |lit: Lit| -> Vec<Cut> {
            let operand = lit.node();
            let mut cuts = vec![Cut::trivial(operand)];
            if region(aig, operand) == region(aig, node) {
                cuts.extend(all[operand].iter().map(|candidate| candidate.cut));
            }
            cuts
        };
        let mut cuts: Vec<Cut> = Vec::new();
        let (left, right) = (of(a), of(b));
        for x in &left {
            for y in &right {
                let Some(cut) = join(x, y, a.is_complemented(), b.is_complemented()) else { continue };
                if !cuts.iter().any(|known| dominates(known, &cut)) {
                    cuts.retain(|known| !dominates(&cut, known));
                    cuts.push(cut);
                }
            }
        }
        let mut found: Vec<Candidate> = Vec::with_capacity(cuts.len());
        for cut in cuts {
            let arrivals: Vec<u32> = cut.leaves().iter().map(|&leaf| levels[leaf as usize]).collect();
            let below: f32 = cut.leaves().iter().map(|&leaf| flows[leaf as usize]).sum();
            let both = sums.of(&cut);
            let [plain, complement] = [0, 1].map(|side| (both[side].level(&arrivals), both[side].ands()));
            let complemented = complement < plain;
            let (level, ands) = if complemented { complement } else { plain };
            let sum = both[usize::from(complemented)].clone();
            found.push(Candidate { cut, sum, complemented, level, flow: below + ands as f32 });
        }
        found.sort_by(|a, b| a.level.cmp(&b.level).then(a.flow.total_cmp(&b.flow)));
        // The cut of the two operands keeps the node as it is.
        let direct = found.iter().position(|candidate| {
            candidate.cut.leaves().iter().all(|&leaf| [a.node(), b.node()].contains(&(leaf as usize)))
        });
        if let Some(position) = direct.filter(|&position| position >= MOST_CUTS) {
            found.swap(MOST_CUTS - 1, position);
        }
        found.truncate(MOST_CUTS);
        levels[node] = found.iter().map(|candidate| candidate.level).min().unwrap_or(0);
        let flow = found.iter().map(|candidate| candidate.flow).fold(f32::INFINITY, f32::min);
        flows[node] = flow / users[node].max(1) as f32;
        all[node] = found;
    }
    all
}

/// For each node in use, the candidate of least area that is shallow enough for its users.
fn choose(aig: &Aig, candidates: &[Vec<Candidate>]) -> Vec<Option<usize>> {
    let level = |node: usize| candidates[node].iter().map(|candidate| candidate.level).min().unwrap_or(0);
    let depth = aig.roots().map(|lit| level(lit.node())).max().unwrap_or(0);
    let mut required: Vec<Option<u32>> = vec![None; aig.nodes().len()];
    aig.roots().for_each(|lit| required[lit.node()] = Some(depth));
    let mut chosen = vec![None; aig.nodes().len()];
    for node in (0..aig.nodes().len()).rev() {
        let Some(limit) = required[node].filter(|_| !candidates[node].is_empty()) else { continue };
        let in_time = (0..candidates[node].len()).filter(|&i| candidates[node][i].level <= limit);
        let best = in_time
            .min_by(|&i, &j| candidates[node][i].flow.total_cmp(&candidates[node][j].flow))
            .unwrap_or(0);
        chosen[node] = Some(best);
        let Candidate { cut, sum, .. } = &candidates[node][best];
        let arrivals: Vec<u32> = cut.leaves().iter().map(|&leaf| level(leaf as usize)).collect();
        for (&leaf, depth) in cut.leaves().iter().zip(sum.depths(&arrivals)) {
            let before = limit.saturating_sub(depth);
            let required = &mut required[leaf as usize];
            *required = Some(required.map_or(before, |known| known.min(before)));
        }
    }
    chosen
}

fn build(aig: &Aig, candidates: &[Vec<Candidate>], chosen: &[Option<usize>]) -> Aig {
    let mut result = Aig::default();
    let mut map: Vec<Lit> = vec![Lit::FALSE; aig.nodes().len()];
    let mut levels: Vec<u32> = vec![0];
    for (node, &kind) in aig.nodes().iter().enumerate() {
        result.origin = aig.origin_of(node);
        map[node] = match kind {
            Node::False => Lit::FALSE,
            Node::Input(input) => result.add_input(aig.inputs()[input as usize].name.clone()),
            Node::Latch(latch) => {
                let latch = &aig.latches()[latch as usize];
                result.add_latch(latch.name.clone(), latch.initial)
            }
            Node::And(..) => {
                let Some(best) = chosen[node] else { continue };
                let Candidate { cut, sum, complemented, .. } = &candidates[node][best];
                let leaves: Vec<Lit> = cut.leaves().iter().map(|&leaf| map[leaf as usize]).collect();
                sum.build(&mut result, &mut levels, &leaves).complement_if(*complemented)
            }
        };
        levels.resize(result.nodes().len(), 0);
    }
    let through = |lit: Lit| map[lit.node()].complement_if(lit.is_complemented());
    for (position, latch) in aig.latches().iter().enumerate() {
        result.drive_latch(position, through(latch.data), through(latch.enable));
    }
    for output in &aig.outputs {
        result.add_output(output.name.clone(), through(output.lit));
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::prove::{Limits, Miter, Verdict};
    use crate::words::{self, Adder};

    fn ripple(width: u32) -> Aig {
        let mut aig = Aig::default();
        let mut word = |name: &str| -> Vec<Lit> {
            (0..width).map(|bit| aig.add_input(format!("{name}{bit}"))).collect()
        };
        let (a, b) = (word("a"), word("b"));
        let (sum, _) = words::add(&mut aig, Adder::Ripple, &a, &b, Lit::FALSE);
        sum.iter().enumerate().for_each(|(bit, &lit)| aig.add_output(format!("y{bit}"), lit));
        aig
    }

    #[test]
    fn a_chain_of_carries_becomes_shallow_and_stays_equal() {
        let aig = ripple(24);
        let mut result = aig.clone();
        for _ in 0..4 {
            let next = restructure(&result);
            assert!(next.depth() <= result.depth());
            result = next;
        }
        println!(
            "depth {} to {}, {} to {} gates",
            aig.depth(),
            result.depth(),
            aig.and_count(),
            result.and_count()
        );
        assert!(2 * result.depth() < aig.depth());
        let miter = Miter::new(&aig, &result).unwrap();
        assert_eq!(miter.prove(Limits::default()).verdict, Verdict::Equal);
    }

    #[test]
    fn regions_keep_their_gates() {
        let mut aig = ripple(8);
        let last = aig.outputs[7].lit;
        aig.origin.region = 1;
        let (x, y) = (aig.add_input("x"), aig.add_input("y"));
        let both = aig.and(x, y);
        let all = aig.and(both, last);
        aig.add_output("z", all);
        let result = restructure(&aig);
        let z = result.outputs[8].lit.node();
        assert_eq!(result.origin_of(z).region, 1);
        let gates = (0..result.nodes().len()).filter(|&node| result.operands(node).is_some());
        assert_eq!(gates.filter(|&node| result.origin_of(node).region == 1).count(), 2);
    }
}
