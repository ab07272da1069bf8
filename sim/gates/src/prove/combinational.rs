//! A pipeline without its registers: the outputs as a function of the inputs.

use crate::aig::{Aig, Lit, Node};

/// Why a circuit has no combinational form.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CombinationalError {
    /// A latch depends on itself.
    #[error("latch `{0}` depends on itself: only circuits without feedback have a combinational form")]
    Feedback(String),
    /// A latch has another enable than the rest.
    #[error("latch `{0}` is not held by the enable of the others: the stages would not move together")]
    Enable(String),
}

/// The graph with every latch replaced by its data. That is the function of a pipeline in which all paths have the
/// same number of enabled cycles. All latches must have the enable `enable`, an input's name, which becomes 1.
///
/// # Errors
/// [`CombinationalError`] when there is feedback or another enable.
pub fn combinational(aig: &Aig, enable: &str) -> Result<Aig, CombinationalError> {
    let enable = aig.inputs().iter().find(|input| input.name == enable).map(|input| input.lit);
    if let Some(other) = aig.latches().iter().find(|latch| Some(latch.enable) != enable) {
        return Err(CombinationalError::Enable(other.name.clone()));
    }
    let mut result = Aig::default();
    let mut map: Vec<Option<Lit>> = vec![None; aig.nodes().len()];
    map[0] = Some(Lit::FALSE);
    for input in aig.inputs() {
        let lit = result.add_input(input.name.clone());
        map[input.lit.node()] = Some(if Some(input.lit) == enable { Lit::TRUE } else { lit });
    }
    let mut open = vec![false; aig.nodes().len()];
    for output in &aig.outputs {
        let mut stack = vec![output.lit.node()];
        while let Some(&node) = stack.last() {
            if map[node].is_some() {
                stack.pop();
                continue;
            }
            let needs: Vec<Lit> = match aig.nodes()[node] {
                Node::And(a, b) => vec![a, b],
                Node::Latch(latch) => vec![aig.latches()[latch as usize].data],
                Node::False | Node::Input(_) => vec![],
            };
            let waiting: Vec<usize> =
                needs.iter().map(|lit| lit.node()).filter(|&node| map[node].is_none()).collect();
            if waiting.is_empty() {
                let known =
                    |lit: Lit| map[lit.node()].unwrap_or(Lit::FALSE).complement_if(lit.is_complemented());
                let lit = match needs.as_slice() {
                    [a, b] => result.and(known(*a), known(*b)),
                    [data] => known(*data),
                    _ => Lit::FALSE,
                };
                map[node] = Some(lit);
                open[node] = false;
                stack.pop();
            } else {
                // A node that is open when the walk meets it again waits for itself.
                if std::mem::replace(&mut open[node], true) && waiting.iter().any(|&node| open[node]) {
                    return Err(CombinationalError::Feedback(name_in(aig, &stack)));
                }
                stack.extend(waiting);
            }
        }
        let lit = map[output.lit.node()].unwrap_or(Lit::FALSE).complement_if(output.lit.is_complemented());
        result.add_output(output.name.clone(), lit);
    }
    Ok(result)
}

/// A latch among nodes.
fn name_in(aig: &Aig, nodes: &[usize]) -> String {
    let latch = nodes.iter().rev().find_map(|&node| match aig.nodes()[node] {
        Node::Latch(latch) => Some(aig.latches()[latch as usize].name.clone()),
        _ => None,
    });
    latch.unwrap_or_default()
}
