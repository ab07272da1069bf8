//! The runs of a sweep, each with a key that is a hash of everything that its result depends on.

use super::file::SweepFile;
use crate::input::{SceneSource, quality_name};
use crate::progress::Progress;
use anyhow::{Context, bail, ensure};
use estimate::{Method, embedded_library};
use golden::build::Quality;
use machine::costs::CacheCosts;
use machine::description::MachineDescription;
use machine::frame::{FrameMachine, MachineStructure};
use render::Test;
use scenes::Scene;
use sha2::{Digest, Sha256};
use std::collections::BTreeSet;
use std::path::Path;

/// Most runs of a sweep.
const MOST_RUNS: usize = 100_000;

/// The scene that a run's tree is built over.
#[derive(Clone, Debug)]
pub struct Subject {
    /// The scene as the file names it.
    pub name: String,
    /// Where it comes from.
    pub source: SceneSource,
    /// What stands for its content in keys.
    identity: String,
}

/// A run: a frame on a machine.
#[derive(Clone, Debug)]
pub struct Run {
    /// Number of its subject in [`Plan::subjects`].
    pub subject: usize,
    /// The structure, with its program and its pipeline.
    pub structure: MachineStructure,
    /// Primary and shadow rays, or paths.
    pub test: Test,
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// The machine as the file names it.
    pub machine_name: String,
    /// The value of each key of [`SweepFile::set`].
    pub set: Vec<String>,
    /// The machine, set up for the structure.
    pub machine: FrameMachine,
    /// The hash of everything that the result depends on.
    pub key: String,
}

/// How the runs of a sweep are simulated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// Estimated by caches and queues, all machines of a frame together.
    Queueing,
    /// Simulated.
    Transaction,
}

/// All runs of a sweep, in the order of the file's lists: the last changes first.
#[derive(Debug)]
pub struct Plan {
    /// The lists.
    pub file: SweepFile,
    /// The scenes with their details and seeds.
    pub subjects: Vec<Subject>,
    /// The runs.
    pub runs: Vec<Run>,
    /// How all trees are built.
    pub quality: Quality,
    /// How all runs are simulated.
    pub level: Level,
}

/// The entry of `all` that has the name `name` in the file's list `key`.
fn named<T: Copy>(
    key: &str,
    name: &str,
    all: &[T],
    name_of: impl Fn(T) -> &'static str,
) -> anyhow::Result<T> {
    all.iter().copied().find(|entry| name_of(*entry) == name).with_context(|| {
        let names: Vec<&str> = all.iter().map(|entry| name_of(*entry)).collect();
        format!("`{key}` has {name}; write {}", names.join(", "))
    })
}

impl Plan {
    /// The runs of `file`. Its files of scenes and machines are looked for in `folder`.
    ///
    /// # Errors
    /// A word of the file is not known, a scene or a machine cannot be loaded, or there are too many runs.
    pub fn new(file: SweepFile, folder: &Path, progress: &dyn Progress) -> anyhow::Result<Self> {
        let qualities = [Quality::Fast, Quality::Medium, Quality::High];
        let quality = named("quality", &file.quality, &qualities, quality_name)?;
        let levels = [Level::Queueing, Level::Transaction];
        let level = named("level", &file.level, &levels, |level| match level {
            Level::Queueing => "queueing",
            Level::Transaction => "transaction",
        })?;
        let method = match file.pipeline_cost.as_str() {
            "published" => Method::Published,
            "netlist" => Method::Netlist(embedded_library()),
            "scaled" => Method::Scaled(embedded_library()),
            other => bail!("`pipeline_cost` has {other}; write published, netlist or scaled"),
        };
        let structures = file.structures.iter();
        let structures =
            structures.map(|name| named("structures", name, &MachineStructure::ALL, MachineStructure::name));
        let structures = structures.collect::<anyhow::Result<Vec<_>>>()?;
        let tests = file.tests.iter().map(|name| named("tests", name, &Test::ALL, Test::name));
        let tests = tests.collect::<anyhow::Result<Vec<_>>>()?;
        let subjects = subjects(&file, folder, progress)?;
        let combinations = combinations(&file);
        let machines = file.machines.len() * combinations.len();
        let lengths = [subjects.len(), structures.len(), tests.len(), file.sizes.len(), machines];
        let count = lengths.iter().try_fold(1usize, |product, length| product.checked_mul(*length));
        ensure!(
            count.is_some_and(|count| count <= MOST_RUNS),
            "the product of all lists has more than {MOST_RUNS} runs; shorten a list"
        );
        let pipeline = estimate::by_name(method);
        let mut described = vec![];
        for name in &file.machines {
            for set in &combinations {
                let settings: Vec<String> =
                    file.set.iter().zip(set).map(|(key, value)| format!("{}={value}", key.name)).collect();
                let machine = load_machine(name, folder, &settings)?;
                CacheCosts::new(&machine)?;
                described.push((name, set, machine));
            }
        }
        let mut runs = vec![];
        for (number, subject) in subjects.iter().enumerate() {
            for &structure in &structures {
                for &test in &tests {
                    for &size in &file.sizes {
                        for (name, set, machine) in &described {
                            let machine = FrameMachine::new(machine, structure, &pipeline)?;
                            let frame = (quality, level, test, size);
                            let key = key(subject, frame, &machine);
                            runs.push(Run {
                                subject: number,
                                structure,
                                test,
                                size,
                                machine_name: (*name).clone(),
                                set: (*set).clone(),
                                machine,
                                key,
                            });
                        }
                    }
                }
            }
        }
        Ok(Self { file, subjects, runs, quality, level })
    }

    /// The keys of all runs, each once, in order.
    #[must_use]
    pub fn keys(&self) -> Vec<&str> {
        let mut seen = BTreeSet::new();
        self.runs.iter().map(|run| run.key.as_str()).filter(|key| seen.insert(*key)).collect()
    }

    /// A run in words, for messages.
    #[must_use]
    pub fn words(&self, run: &Run) -> String {
        let Run { structure, test, size: [width, height], machine_name, .. } = run;
        let subject = &self.subjects[run.subject];
        let set = self.file.set.iter().zip(&run.set).map(|(key, value)| format!(", {}={value}", key.name));
        let (name, seed) = (&subject.name, subject.source.seed);
        format!(
            "{name}, seed {seed}, {structure}, {test}, {width}x{height}, {machine_name}{}",
            set.collect::<String>()
        )
    }
}

/// The scenes of `file` with their details and seeds.
fn subjects(file: &SweepFile, folder: &Path, progress: &dyn Progress) -> anyhow::Result<Vec<Subject>> {
    let mut subjects = vec![];
    for name in &file.scenes {
        let built_in = scenes::procedural::find(name).is_some();
        ensure!(
            name != scenes::formats::STDIN,
            "`scenes` has -; standard input can be read once only, so name a file"
        );
        let details = if built_in { &file.detail[..] } else { &[1.0] };
        let path = if built_in { name.into() } else { folder.join(name).into_os_string() };
        let content = if built_in {
            String::new()
        } else {
            let source = SceneSource { name: path.clone(), format: None, detail: 1.0, seed: 0 };
            digest(&source.load(progress)?)
        };
        for &detail in details {
            for &seed in &file.seeds {
                let identity = if built_in { format!("{name} {detail}") } else { content.clone() };
                let source = SceneSource { name: path.clone(), format: None, detail, seed };
                subjects.push(Subject { name: name.clone(), source, identity: format!("{identity} {seed}") });
            }
        }
    }
    Ok(subjects)
}

/// Every choice of a value for each key.
fn combinations(file: &SweepFile) -> Vec<Vec<String>> {
    let mut all = vec![vec![]];
    for key in &file.set {
        // Far more than are ever run are refused by the caller.
        if all.len() > MOST_RUNS {
            break;
        }
        let extended =
            |chosen: &Vec<String>, value: &String| [&chosen[..], std::slice::from_ref(value)].concat();
        all = all
            .iter()
            .flat_map(|chosen| key.values.iter().map(move |value| extended(chosen, value)))
            .collect();
    }
    all
}

/// The machine `name`, a preset or a file in `folder`.
fn load_machine(name: &str, folder: &Path, settings: &[String]) -> anyhow::Result<MachineDescription> {
    let is_preset = machine::description::PRESETS.iter().any(|(preset, _)| *preset == name);
    let path = if is_preset { name.into() } else { folder.join(name) };
    Ok(MachineDescription::load(path, settings)?)
}

/// A hash of what a scene holds.
fn digest(scene: &Scene) -> String {
    let mut hash = Sha256::new();
    for corner in &scene.mesh.positions {
        corner.iter().for_each(|x| hash.update(x.to_bits().to_le_bytes()));
    }
    for triangle in &scene.mesh.triangles {
        triangle.iter().for_each(|index| hash.update(index.to_le_bytes()));
    }
    hash.update(format!("{:?} {:?}", scene.camera, scene.light));
    hex(&hash.finalize())
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The hash of everything that the result of a run depends on.
fn key(
    subject: &Subject,
    (quality, level, test, [width, height]): (Quality, Level, Test, [u32; 2]),
    machine: &FrameMachine,
) -> String {
    // What a machine is called changes no result.
    let described = MachineDescription { name: String::new(), needs: None, ..machine.description.clone() };
    let everything = format!(
        "{} {} {quality:?} {level:?} {test} {width}x{height} {}\n{}\n{:?}\n{}",
        env!("DUALSPLIT_SOURCES"),
        subject.identity,
        machine.structure,
        described.to_toml(),
        machine.pipeline,
        machine.structure.listing(described.layout)
    );
    hex(&Sha256::digest(everything)[..16])
}
