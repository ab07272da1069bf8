//! The sizes of the main job.

use super::stages::Stage;
use golden::build::Quality;
use scenes::procedural::CATALOGUE;

/// A size of the job.
pub struct Preset {
    /// The name on the command line.
    pub name: &'static str,
    /// The approximate number of triangles of a scene, which is never below that of the scene's coarsest level.
    pub triangles: f64,
    /// How all trees are built.
    pub quality: Quality,
    /// Width and height in pixels of the renderings in which work is counted. They have one sample per pixel.
    pub measured_side: u32,
    /// Width and height of the pictures in pixels.
    pub picture_side: u32,
    /// Samples per pixel of the pictures.
    pub picture_samples: u32,
    /// The approximate seconds that trees, work and pictures of a scene take on two cores.
    pub scene_seconds: f64,
    /// The other parts of the job.
    pub stages: fn() -> Vec<Stage>,
}

/// All sizes.
pub const PRESETS: [Preset; 3] = [
    // A test of all parts, which takes seconds.
    Preset {
        name: "smoke",
        triangles: 1.0,
        quality: Quality::Fast,
        measured_side: 24,
        picture_side: 48,
        picture_samples: 1,
        scene_seconds: 0.5,
        stages: smoke,
    },
    // The default, which has to end within five minutes on two cores.
    Preset {
        name: "quick",
        triangles: 60_000.0,
        quality: Quality::High,
        measured_side: 192,
        picture_side: 320,
        picture_samples: 8,
        scene_seconds: 6.0,
        stages: quick,
    },
    // Everything at full size. The job takes hours, most of them for the study.
    Preset {
        name: "paper",
        triangles: f64::INFINITY,
        quality: Quality::High,
        measured_side: 512,
        picture_side: 512,
        picture_samples: 16,
        scene_seconds: 150.0,
        stages: paper,
    },
];

/// A machine of two multiprocessors, which small frames keep busy.
const SMALL: &str = "--set chip.l2_partitions=1 --set chip.tms_per_partition=2";

fn smoke() -> Vec<Stage> {
    let mut stages = vec![
        Stage::new("check", 1.0, "check --unit dual_split --vectors 200"),
        Stage::new(
            "precision",
            1.0,
            "chart precision statue --detail 0.0005 --size 12x12 --quality fast --simulate false --out OUT",
        ),
        Stage::new(
            "fidelity",
            1.0,
            "chart fidelity statue --detail 0.0005 --size 24x24 --repeats 1 --quality fast --rtl false \
             --set chip.l2_partitions=1 --set chip.tms_per_partition=1 --out OUT",
        ),
        Stage::new(
            "stress",
            1.0,
            "stress --rays 2 --aimed 400 --searches 0 --pictures false --method dst/binary32-fast \
             --method dst/binary32-robust --out OUT",
        ),
    ];
    stages.extend(
        needs(0.5, |scene| format!("needs {scene} --detail 0.0005 --size 8x8 --quality fast --out OUT"))
            .take(1),
    );
    stages
}

fn quick() -> Vec<Stage> {
    let mut stages = vec![
        Stage::new("check", 6.0, "check --vectors 20000"),
        Stage::new("estimate", 25.0, "estimate --detail 0.002"),
        Stage::new("study", 60.0, "study --preset small --out OUT"),
        Stage::new("precision", 20.0, "chart precision courtyard --detail 0.005 --size 16x16 --out OUT"),
        Stage::new(
            "fidelity",
            30.0,
            &format!("chart fidelity courtyard --detail 0.01 --size 64x64 --repeats 2 {SMALL} --out OUT"),
        ),
        Stage::new("stress", 25.0, "stress --rays 4 --aimed 800 --searches 1 --out OUT"),
    ];
    stages.extend(needs(2.0, |scene| format!("needs {scene} --detail 0.01 --size 24x24 --out OUT")));
    stages
}

fn paper() -> Vec<Stage> {
    let mut stages = vec![
        Stage::new("check", 60.0, "check --vectors 10000000"),
        Stage::new("estimate", 60.0, "estimate --detail 0.1"),
    ];
    // One part for each scene. All parts write to the same folder, where each finds the runs of the others.
    stages.extend(CATALOGUE.iter().map(|entry| Stage {
        folder: "study".to_owned(),
        ..Stage::new(
            &format!("study-{}", entry.name),
            3600.0,
            &format!("study --preset paper --quality medium --scene {} --out OUT", entry.name),
        )
    }));
    stages.push(Stage::new("precision", 600.0, "chart precision atrium --detail 1 --size 64x64 --out OUT"));
    stages.push(Stage::new(
        "fidelity",
        500.0,
        "chart fidelity atrium --detail 1 --size 128x128 --repeats 10 --set chip.l2_partitions=2 --set \
         chip.tms_per_partition=4 --out OUT",
    ));
    stages.push(Stage::new("stress", 300.0, "stress --rays 200 --aimed 20000 --searches 8 --out OUT"));
    stages.extend(needs(60.0, |scene| {
        format!("needs {scene} --detail 1 --size 64x64 --quality medium --out OUT")
    }));
    stages
}

/// The needs of each built-in scene.
fn needs(seconds: f64, line: fn(&str) -> String) -> impl Iterator<Item = Stage> {
    CATALOGUE
        .iter()
        .map(move |entry| Stage::new(&format!("needs-{}", entry.name), seconds, &line(entry.name)))
}
