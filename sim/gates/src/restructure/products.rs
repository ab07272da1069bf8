//! Irredundant sums of products of truth tables, and the trees that they become.

use crate::aig::{Aig, Lit};
use crate::liberty::function::{MAX_INPUTS, variable};

/// A product: the variables that it has plain, and complemented.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Product {
    plain: u8,
    complemented: u8,
}

/// A sum of products of a cut's leaves.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sum {
    products: Vec<Product>,
}

/// An irredundant sum of products of a table of so many variables (Minato, "Fast Generation of Irredundant Sum-of-Products
/// Forms from Binary Decision Diagrams", 1992).
pub fn sum(table: u64, variables: usize) -> Sum {
    let mut products = Vec::new();
    irredundant(table, table, variables, Product { plain: 0, complemented: 0 }, &mut products);
    Sum { products }
}

/// Adds products that cover `must` and nothing outside `may`, each times `common`. Returns what they cover.
fn irredundant(must: u64, may: u64, variables: usize, common: Product, products: &mut Vec<Product>) -> u64 {
    if must == 0 {
        return 0;
    }
    if may == !0 {
        products.push(common);
        return !0;
    }
    let top = variables - 1;
    let (mask, shift) = (variable(top), 1u32 << top);
    let low = |table: u64| (table & !mask) | (table & !mask) << shift;
    let high = |table: u64| (table & mask) | (table & mask) >> shift;
    if low(must) == high(must) && low(may) == high(may) {
        return irredundant(must, may, top, common, products);
    }
    let bit = 1 << top;
    let with_low = Product { complemented: common.complemented | bit, ..common };
    let with_high = Product { plain: common.plain | bit, ..common };
    let from_low = irredundant(low(must) & !high(may), low(may), top, with_low, products);
    let from_high = irredundant(high(must) & !low(may), high(may), top, with_high, products);
    let rest = (low(must) & !from_low) | (high(must) & !from_high);
    let from_both = irredundant(rest, low(may) & high(may), top, common, products);
    (from_low & !mask) | (from_high & mask) | from_both
}

/// Joins the earliest two of some items until one is left: the shallowest tree.
fn join_earliest<T>(
    mut items: Vec<(u32, T)>,
    mut join: impl FnMut((u32, T), (u32, T)) -> (u32, T),
) -> Option<(u32, T)> {
    while items.len() > 1 {
        // Stable, so that equal times keep their order.
        items.sort_by_key(|(time, _)| std::cmp::Reverse(*time));
        if let (Some(first), Some(second)) = (items.pop(), items.pop()) {
            items.push(join(first, second));
        }
    }
    items.pop()
}

impl Product {
    fn variables(self) -> impl Iterator<Item = (usize, bool)> {
        (0..MAX_INPUTS).filter_map(move |i| match (self.plain >> i & 1, self.complemented >> i & 1) {
            (1, _) => Some((i, false)),
            (_, 1) => Some((i, true)),
            _ => None,
        })
    }
}

impl Sum {
    /// Number of two-input gates.
    pub fn ands(&self) -> usize {
        let literals: u32 =
            self.products.iter().map(|p| (p.plain | p.complemented).count_ones().saturating_sub(1)).sum();
        literals as usize + self.products.len().saturating_sub(1)
    }

    /// Level of the root of the tree, for leaves at these levels.
    pub fn level(&self, arrivals: &[u32]) -> u32 {
        let product = |product: &Product| {
            let items = product.variables().map(|(leaf, _)| (arrivals[leaf], ())).collect();
            join_earliest(items, |a, b| (a.0.max(b.0) + 1, ())).map_or(0, |(level, ())| level)
        };
        let items = self.products.iter().map(|p| (product(p), ())).collect();
        join_earliest(items, |a, b| (a.0.max(b.0) + 1, ())).map_or(0, |(level, ())| level)
    }

    /// For each leaf, the longest way from it to the root of the tree that [`Sum::level`] is of.
    pub fn depths(&self, arrivals: &[u32]) -> Vec<u32> {
        type Depths = [Option<u32>; MAX_INPUTS];
        let join = |a: (u32, Depths), b: (u32, Depths)| {
            let mut both: Depths = [None; MAX_INPUTS];
            for (depth, (a, b)) in both.iter_mut().zip(a.1.into_iter().zip(b.1)) {
                *depth = a.max(b).map(|depth| depth + 1);
            }
            (a.0.max(b.0) + 1, both)
        };
        let leaf = |leaf: usize| {
            let mut depths: Depths = [None; MAX_INPUTS];
            depths[leaf] = Some(0);
            (arrivals[leaf], depths)
        };
        let products = self
            .products
            .iter()
            .filter_map(|product| join_earliest(product.variables().map(|(i, _)| leaf(i)).collect(), join));
        let root = join_earliest(products.collect(), join).map_or([None; MAX_INPUTS], |(_, depths)| depths);
        (0..arrivals.len()).map(|leaf| root[leaf].unwrap_or(0)).collect()
    }

    /// Adds the tree to a graph, whose nodes have the levels `levels`.
    pub fn build(&self, aig: &mut Aig, levels: &mut Vec<u32>, leaves: &[Lit]) -> Lit {
        let mut and = |a: Lit, b: Lit| {
            let lit = aig.and(a, b);
            levels.resize(aig.nodes().len().max(levels.len()), 0);
            if let Some([a, b]) = aig.operands(lit.node()) {
                levels[lit.node()] = levels[a.node()].max(levels[b.node()]) + 1;
            }
            (levels[lit.node()], lit)
        };
        let mut terms = Vec::new();
        for product in &self.products {
            let factors: Vec<Lit> = product
                .variables()
                .map(|(leaf, complemented)| leaves[leaf].complement_if(complemented))
                .collect();
            let items = factors.into_iter().map(|lit| (and(lit, lit).0, lit)).collect();
            let (level, lit) = join_earliest(items, |a, b| and(a.1, b.1)).unwrap_or((0, Lit::TRUE));
            terms.push((level, !lit));
        }
        let none = join_earliest(terms, |a, b| and(a.1, b.1)).map_or(Lit::TRUE, |(_, lit)| lit);
        !none
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_are_their_tables() {
        for seed in 0..200u64 {
            let table = base::split_mix::hash(seed);
            let covered = sum(table, 6).products.iter().fold(0u64, |covered, product| {
                let factors = product.variables().map(|(i, c)| if c { !variable(i) } else { variable(i) });
                covered | factors.fold(!0, |all, factor| all & factor)
            });
            assert_eq!(covered, table);
        }
        assert_eq!((sum(0, 6).products.len(), sum(!0, 6).ands()), (0, 0));
    }

    #[test]
    fn late_leaves_are_near_the_root() {
        let [a, b, c, d] = [0, 1, 2, 3].map(variable);
        let all = sum(a & b & c & d, 4);
        assert_eq!((all.ands(), all.level(&[0, 0, 0, 0]), all.level(&[0, 0, 0, 5])), (3, 2, 6));
        assert_eq!(all.depths(&[0, 0, 0, 5]), [2, 3, 3, 1]);
        let parity = sum(a ^ b, 2);
        assert_eq!((parity.ands(), parity.level(&[0, 3])), (3, 5));
    }
}
