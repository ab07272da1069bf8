//! The fixed list of commands.

/// One command of the list.
#[derive(Clone, Debug)]
pub struct Command {
    /// What the file of hashes calls it.
    pub name: String,
    /// Its arguments; `--threads`, and `--json` if that is wanted, are added.
    pub line: String,
    /// Whether it prints JSON.
    pub json: bool,
    /// The commands that write what it reads.
    pub after: &'static [&'static str],
    /// Files that it reads and no command writes: names and contents.
    pub reads: &'static [(&'static str, &'static str)],
    /// Parts of the paths of files that depend on the host or on the program's sources in another form than [`super::filter`] knows.
    pub drops: &'static [&'static str],
    /// The exit code that is right.
    pub code: i32,
}

impl Command {
    fn new(name: impl Into<String>, line: impl Into<String>) -> Self {
        Self { name: name.into(), line: line.into(), json: true, after: &[], reads: &[], drops: &[], code: 0 }
    }

    /// Prints tables.
    fn text(self) -> Self {
        Self { json: false, ..self }
    }

    fn after(self, after: &'static [&'static str]) -> Self {
        Self { after, ..self }
    }

    fn reads(self, reads: &'static [(&'static str, &'static str)]) -> Self {
        Self { reads, ..self }
    }

    fn drops(self, drops: &'static [&'static str]) -> Self {
        Self { drops, ..self }
    }

    fn code(self, code: i32) -> Self {
        Self { code, ..self }
    }
}

/// The structures that software traverses.
const STRUCTURES: [&str; 6] = ["dst", "bvh2", "bvh4", "bvh8", "bvh16", "qbvh8"];
/// The structures that the machine has programs for.
const MACHINE_STRUCTURES: [&str; 8] = ["dst", "dst-sw", "bvh2", "bvh4", "bvh8", "bvh2+", "bvh4+", "bvh8+"];
const MODES: [&str; 2] = ["robust", "fast"];
const TESTS: [&str; 2] = ["raycast", "path"];

/// The scene of most commands, with its options.
const SCENE: &str = "courtyard --detail 0.0005 --quality fast";
/// Another.
const OTHER: &str = "atrium --detail 0.01 --quality medium";
/// The scene of the commands that trace it often.
const SMALLEST: &str = "statue --detail 0.0005 --quality fast";
/// A machine of two multiprocessors with small caches.
const MACHINE: &str =
    "--set chip.l2_partitions=1 --set chip.tms_per_partition=2 --set l1.size=16KiB --set l2.size=128KiB";
/// Four runs on it: two structures and two sizes of the L1.
const SWEEP: &str = "\
scenes = \"statue\"
detail = 0.0005
quality = \"fast\"
structures = [\"dst\", \"bvh2\"]
sizes = \"12x12\"
[set]
l1.size = [\"16KiB\", \"32KiB\"]
l2.size = \"128KiB\"
chip.l2_partitions = 1
chip.tms_per_partition = 2
";

/// All commands, in the order in which they run.
pub fn commands() -> Vec<Command> {
    [trees(), pictures(), hardware(), machine(), studies()].concat()
}

/// Scenes and trees; later commands read what these write.
fn trees() -> Vec<Command> {
    vec![
        Command::new("scenes", "scenes").text(),
        Command::new("scenes-json", "scenes"),
        Command::new("scenes-export", "scenes statue --detail 0.001 --export statue.obj"),
        Command::new("scenes-export-xz", "scenes hairball --detail 0.001 --seed 3 --export hairball.obj.xz"),
        Command::new("scenes-export-ply", "scenes hairball --detail 0.001 --seed 3 --export hairball.ply"),
        Command::new("scenes-export-stl", "scenes hairball --detail 0.001 --seed 3 --export hairball.stl.gz"),
        Command::new("tree-fast", "tree courtyard --detail 0.01 --quality fast --scratch"),
        Command::new("tree-medium", format!("tree {OTHER} --save atrium.tree")),
        Command::new("tree-high", "tree statue.obj --save scratch.tree --structure dst_scratch")
            .after(&["scenes-export"]),
    ]
}

/// Pictures, rays and hits, in every structure.
fn pictures() -> Vec<Command> {
    let mut commands = vec![
        Command::new(
            "render-path",
            format!("render {SCENE} --size 48x32 --out path.png --rays path.rays.xz"),
        ),
        Command::new(
            "render-tree",
            "render atrium --detail 0.01 --size 32x32 --spp 2 --exposure 1 --tree atrium.tree --out tree.png",
        )
        .after(&["tree-medium"]),
        Command::new(
            "render-file",
            "render statue.obj --quality fast --eye 3,2,5 --fov 50 --size 32x32 --out statue.png",
        )
        .after(&["scenes-export"]),
        Command::new("render-exr", format!("render {OTHER} --structure bvh4 --size 24x24 --out atrium.exr")),
        Command::new(
            "render-exr-fast",
            format!("render {OTHER} --mode fast --size 24x24 --seed 1 --out fast.exr"),
        ),
    ];
    for structure in STRUCTURES {
        for test in TESTS {
            let name = format!("render-{test}-{structure}");
            let line = format!(
                "render {SCENE} --test {test} --structure {structure} --size 48x32 --out {name}.png \
                 --rays {name}.rays"
            );
            commands.push(Command::new(name, line));
        }
    }
    for quantity in ["node-visits", "plane-tests", "triangle-tests", "stack-depth"] {
        let name = format!("render-heatmap-{quantity}");
        let line = format!("render {SCENE} --size 48x32 --heatmap {quantity} --out {name}.png");
        commands.push(Command::new(name, line));
    }
    for structure in STRUCTURES {
        for mode in MODES {
            let name = format!("trace-{structure}-{mode}");
            let line = format!(
                "trace {SCENE} --rays path.rays.xz --structure {structure} --mode {mode} --out {name}.hits"
            );
            commands.push(Command::new(name, line).after(&["render-path"]));
        }
    }
    let both = &["render-path", "render-raycast-dst"];
    let exr = &["render-exr", "render-exr-fast"];
    let explain = format!("explain {SCENE} --pixel 200,300");
    commands.extend([
        Command::new("compare-same", "compare path.png render-path-bvh8.png")
            .after(&["render-path", "render-path-bvh8"]),
        Command::new("compare-png", "compare path.png render-raycast-dst.png --out png-difference.png")
            .after(both)
            .code(1),
        Command::new("compare-exr", "compare atrium.exr fast.exr --out exr-difference.exr")
            .after(exr)
            .code(1),
        Command::new("compare-exr-text", "compare atrium.exr fast.exr").text().after(exr).code(1),
        Command::new("explain", explain.clone()),
        Command::new("explain-text", explain).text(),
    ]);
    commands
}

/// Verilog, waveforms, checks and costs.
fn hardware() -> Vec<Command> {
    vec![
        Command::new("export-binary32", "export --vectors 200 --out rtl32"),
        Command::new("export-binary16", "export --vectors 200 --format binary16 --out rtl16"),
        Command::new("check", "check --vectors 500"),
        Command::new("check-mutate", "check --unit fp_add --mutate 7 --vectors 500").code(1),
        Command::new("check-exhaustive", "check --exhaustive e5m2 mul"),
        Command::new(
            "wave-dual-split",
            format!("wave --unit dual_split --scene {SCENE} --rays 2 --out dual_split.vcd"),
        ),
        Command::new(
            "wave-ray-box",
            format!("wave --unit ray_box_x4 --scene {SCENE} --rays 2 --out ray_box_x4.vcd"),
        ),
        Command::new(
            "wave-shared",
            format!("wave --unit shared_units --scene {SCENE} --rays 1 --out shared.vcd"),
        ),
        Command::new("estimate", format!("estimate --scene {SCENE} --out estimate")),
    ]
}

/// Frames on the machine, in every structure and at every level.
fn machine() -> Vec<Command> {
    let mut commands = vec![];
    for structure in MACHINE_STRUCTURES {
        for test in TESTS {
            let name = format!("simulate-{structure}-{test}");
            let line = format!(
                "simulate {SCENE} --size 16x16 --structure {structure} --test {test} {MACHINE} \
                 --csv {name}.csv"
            );
            commands.push(Command::new(name, line));
        }
    }
    let simulate = |name: &str, rest: &str| Command::new(name, format!("simulate {OTHER} {MACHINE} {rest}"));
    commands.extend([
        simulate("simulate-queueing", "--size 32x32 --fidelity queueing --set network.latency_cycles=4"),
        simulate("simulate-analytic", "--size 32x32 --fidelity analytic --csv analytic.csv"),
        simulate("simulate-rtl", "--size 16x16 --fidelity rtl --mode fast --csv rtl.csv"),
        simulate("simulate-auto", "--size 64x64 --fidelity auto --tolerance 10% --csv auto.csv"),
        simulate("simulate-sample", "--size 64x64 --structure bvh4 --sample 30% --seed 5 --csv sample.csv"),
        simulate(
            "simulate-wide",
            "--size 16x16 --structure bvh8+ --set tm.load_words=line --pipeline-cost scaled",
        ),
        Command::new("simulate-dump-kernels", "simulate --dump-kernels kernels"),
        simulate("simulate-kernel", "--size 16x16 --kernel kernels/dst.s").after(&["simulate-dump-kernels"]),
        Command::new("simulate-trax", "simulate --machine trax --dump-config").text(),
        Command::new(
            "simulate-simtrax",
            "simulate --machine simtrax-reference --set l1.size=16KiB --dump-config",
        )
        .text(),
    ]);
    commands
}

/// What runs many of the others.
fn studies() -> Vec<Command> {
    let needs = format!("needs {SMALLEST} --size 8x8");
    let precision = format!("chart precision {SMALLEST} --size 12x12 {MACHINE}");
    let fidelity = format!("chart fidelity {SMALLEST} --size 24x24 --repeats 2 {MACHINE}");
    vec![
        Command::new("study", "study --preset small --quality fast --scene atrium --out study"),
        Command::new("needs", format!("{needs} --out needs")),
        Command::new("needs-naive", format!("{needs} --variant naive --max-false-miss 5 --out needs-naive"))
            .text(),
        Command::new(
            "stress",
            "stress --rays 10 --aimed 200 --searches 1 --method dst/binary32-robust \
             --method dst/bfloat16-naive --method bvh8/tf32-conservative --method rtl/binary32-robust \
             --out stress",
        ),
        Command::new("chart-precision", format!("{precision} --out precision")),
        // The names of the records of its runs depend on the program's sources.
        Command::new("sweep", "sweep sweep.toml --out sweep")
            .reads(&[("sweep.toml", SWEEP)])
            .drops(&["sweep/runs/"]),
        Command::new("rerun", "rerun needs").after(&["needs"]),
        // The horizontal axis of its pictures is the host's time.
        Command::new("chart-fidelity", format!("{fidelity} --out fidelity")).drops(&["-error.svg"]),
    ]
}
