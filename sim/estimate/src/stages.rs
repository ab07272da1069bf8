//! The stages of a pipeline: what lies between two rows of registers, and the longest path of each.

use serde::Serialize;

use super::Implementation;
use gates::aig::{Aig, Node};
use gates::timing::{drivers, fo4_ns, path};

/// Part of a path: gates that follow each other in one unit, or in the glue.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Stretch {
    /// The unit's instance, `glue`, or what registers add: `clock to output`, `setup`.
    pub part: String,
    /// Time that the path spends there.
    pub ns: f64,
}

/// The longest path of a stage.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StageRow {
    /// The first stage lies behind the inputs; the last ends at the outputs.
    pub stage: u32,
    /// Length, from the clock edge through the register's own delay, to the setup time before the next edge.
    pub path_ns: f64,
    /// The same in delays of an inverter that drives four.
    pub path_fo4: f64,
    /// Where the path starts.
    pub from: String,
    /// Where it ends.
    pub to: String,
    /// What it passes.
    pub through: Vec<Stretch>,
}

/// The stage at whose end each latch is, from 1 on. A latch that depends on itself has the stage of what else it depends on.
pub(super) fn of_latches(aig: &Aig) -> Vec<u32> {
    let mut stages = vec![0u32; aig.latches().len()];
    // Each round settles one more stage. Feedback would never settle, and ends with the rounds.
    for _ in 0..=stages.len() {
        let mut levels: Vec<u32> = Vec::with_capacity(aig.nodes().len());
        for node in aig.nodes() {
            levels.push(match *node {
                Node::And(a, b) => levels[a.node()].max(levels[b.node()]),
                Node::Latch(latch) => stages[latch as usize],
                Node::False | Node::Input(_) => 0,
            });
        }
        let next: Vec<u32> = aig.latches().iter().map(|latch| levels[latch.data.node()] + 1).collect();
        if next == stages || next.iter().any(|&stage| stage as usize > stages.len()) {
            break;
        }
        stages = next;
    }
    stages
}

impl Implementation<'_> {
    /// The longest path of each stage, in order.
    #[must_use]
    pub fn stages(&self) -> Vec<StageRow> {
        let (library, aig) = (self.library, &self.graph);
        let last = self.latch_stages.iter().copied().max().unwrap_or(0) + 1;
        let setup_ns = library.flip_flop.setup_ns;
        let registers = self.mapped.registers.iter().map(|register| {
            let name = &aig.latches()[register.latch].name;
            (self.latch_stages[register.latch], register.data, setup_ns, name)
        });
        let outputs = self.mapped.outputs.iter().zip(&aig.outputs);
        let outputs = outputs.map(|(&net, output)| (last, net, 0.0, &output.name));
        let mut ends: Vec<Option<(f64, u32, f64, &String)>> = vec![None; last as usize];
        for (stage, net, setup, name) in registers.chain(outputs) {
            let time = self.timing.latest(net) + setup;
            let end = &mut ends[stage as usize - 1];
            if end.is_none_or(|(latest, ..)| time > latest) {
                *end = Some((time, net, setup, name));
            }
        }
        let driver = drivers(&self.mapped);
        let fo4_ns = fo4_ns(library);
        let row = |(stage, (path_ns, net, setup, to)): (u32, (f64, u32, f64, &String))| {
            let path = path(&self.mapped, library, &self.timing, &driver, net);
            let mut through: Vec<Stretch> = Vec::new();
            let mut add = |part: String, ns: f64| match through.last_mut() {
                Some(last) if last.part == part => last.ns += ns,
                _ => through.push(Stretch { part, ns }),
            };
            if path.start_ns > 0.0 {
                add("clock to output".to_owned(), path.start_ns);
            }
            for step in &path.steps {
                add(self.part(self.mapped.gates[step.gate].origin), step.delay_ns);
            }
            if setup > 0.0 {
                add("setup".to_owned(), setup);
            }
            let from = self.source_name(path.start);
            StageRow { stage, path_ns, path_fo4: path_ns / fo4_ns, from, to: to.clone(), through }
        };
        (1..).zip(ends).filter_map(|(stage, end)| Some((stage, end?))).map(row).collect()
    }

    /// The name of the input or register whose net this is.
    fn source_name(&self, net: u32) -> String {
        let aig = &self.graph;
        match aig.nodes()[self.mapped.literals[net as usize].node()] {
            Node::Input(input) => aig.inputs()[input as usize].name.clone(),
            Node::Latch(latch) => aig.latches()[latch as usize].name.clone(),
            Node::False | Node::And(..) => "constant".to_owned(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use gates::liberty::embedded;
    use gates::words::Structures;
    use pipelines::catalogue::Top;

    #[test]
    fn a_stage_for_each_cycle_and_one_behind_the_last_registers() {
        let library = embedded();
        let implementation = Implementation::new(Top::DualSplit, &library, Structures::default()).unwrap();
        let stages = implementation.stages();
        let numbers: Vec<u32> = stages.iter().map(|row| row.stage).collect();
        let latency = netlist::inventory(&implementation.design).unwrap().latency_cycles.unwrap();
        assert_eq!(numbers, (1..=latency + 1).collect::<Vec<u32>>());
        let longest = stages.iter().map(|row| row.path_ns).fold(0.0, f64::max);
        assert_eq!(longest, implementation.timing.critical_path_ns);
        for row in &stages {
            let sum: f64 = row.through.iter().map(|stretch| stretch.ns).sum();
            assert!((sum - row.path_ns).abs() < 1e-9, "{row:?}");
        }
        // The first stage starts at the inputs, the others at registers.
        assert!(stages[1..].iter().all(|row| row.through[0].part == "clock to output"));
    }
}
