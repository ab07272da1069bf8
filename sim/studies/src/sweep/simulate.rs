//! Simulating the runs of a sweep: runs of one scene share its trees, and at the queueing level machines share an execution.

use super::plan::{Level, Plan, Run, Subject};
use super::record::Record;
use crate::fidelity::{self, queueing};
use crate::input::Built;
use crate::progress::{Part, Progress};
use anyhow::Context;
use golden::structure::{Structure, StructureKind};
use machine::frame::{FrameMachine, MachineStructure, frame, node_bytes};
use machine::program::Program;
use rayon::prelude::*;
use render::{RenderOptions, Test};
use scenes::Scene;
use std::collections::BTreeMap;
use std::path::Path;
use std::time::Instant;

/// Runs that one execution of a frame can serve: those of one structure, test and size.
type Frames<'a> = BTreeMap<(usize, usize, [u32; 2]), Vec<&'a Run>>;

/// Simulates `runs`, which are of `plan` and differ in their keys, and writes the record of each into `folder` when it is done.
///
/// # Errors
/// A scene cannot be loaded, a run fails, or a record cannot be written. The records of the runs before stay.
pub fn simulate(plan: &Plan, runs: &[&Run], folder: &Path, progress: &dyn Progress) -> anyhow::Result<()> {
    let part = Part::begin(progress, runs.len() as u64, "runs");
    for (number, subject) in plan.subjects.iter().enumerate() {
        let own: Vec<&Run> = runs.iter().copied().filter(|run| run.subject == number).collect();
        if own.is_empty() {
            continue;
        }
        part.next(&subject.name);
        let scene = subject.source.load(progress)?;
        let built = Built::new(&scene, plan.quality, progress)?;
        let structures = StructureKind::ALL
            .into_par_iter()
            .filter(|kind| own.iter().any(|run| run.structure.kind() == *kind))
            .map(|kind| Ok((kind, built.convert(kind)?.0)))
            .collect::<anyhow::Result<Vec<(StructureKind, Structure)>>>()?;
        let of = |structure: MachineStructure| {
            let found = structures.iter().find(|(kind, _)| *kind == structure.kind());
            &found.expect("all that the runs need").1
        };
        let done = |record: Record| -> anyhow::Result<()> {
            record.write(folder)?;
            part.advance(1);
            Ok(())
        };
        match plan.level {
            Level::Transaction => own.par_iter().try_for_each(|run| {
                let record = one(run, subject, &scene, of(run.structure)).with_context(|| plan.words(run))?;
                done(record)
            })?,
            Level::Queueing => {
                let mut frames = Frames::new();
                for run in own {
                    frames.entry((place(run.structure), run.test.bounces(), run.size)).or_default().push(run);
                }
                for runs in frames.values() {
                    let records = together(runs, subject, &scene, of(runs[0].structure));
                    records.with_context(|| plan.words(runs[0]))?.into_iter().try_for_each(done)?;
                }
            }
        }
    }
    Ok(())
}

/// The place of a structure in the list of all.
fn place(structure: MachineStructure) -> usize {
    MachineStructure::ALL.iter().position(|known| *known == structure).expect("the list has all")
}

fn options(test: Test, [width, height]: [u32; 2], subject: &Subject) -> RenderOptions {
    RenderOptions { seed: subject.source.seed, ..RenderOptions::new(test, width, height) }
}

fn one(run: &Run, subject: &Subject, scene: &Scene, structure: &Structure) -> anyhow::Result<Record> {
    let start = Instant::now();
    let machine = &run.machine;
    let bytes = node_bytes(structure, machine.description.layout)?.0;
    let frame = frame(machine, scene, structure, &options(run.test, run.size, subject), |_| {})?;
    let results = machine.results(&frame.program, &frame.counts)?;
    let facts = [scene.mesh.triangles.len() as u64, bytes, frame.rays];
    Ok(Record::new(&run.key, facts, start.elapsed().as_secs_f64(), &results))
}

fn together(
    runs: &[&Run],
    subject: &Subject,
    scene: &Scene,
    structure: &Structure,
) -> anyhow::Result<Vec<Record>> {
    let set_up = runs.iter().map(|run| Ok((run.machine.clone(), run.machine.program()?)));
    let machines = set_up.collect::<anyhow::Result<Vec<(FrameMachine, Program)>>>()?;
    let options = options(runs[0].test, runs[0].size, subject);
    let shared = fidelity::Subject { machine: &machines[0].0, scene, structure, options: &options };
    let estimates = queueing::estimates(&shared, &machines, |_| ())?;
    let records = runs.iter().zip(estimates).map(|(run, estimate)| {
        let bytes = node_bytes(structure, run.machine.description.layout)?.0;
        let facts = [scene.mesh.triangles.len() as u64, bytes, estimate.totals.rays];
        Ok(Record::new(&run.key, facts, estimate.seconds, &estimate.results))
    });
    records.collect()
}
