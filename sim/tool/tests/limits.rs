//! What every command keeps to: options that say something, outputs that are nothing else, memory in proportion, nothing left behind.

mod support;

use support::Workplace;
use testing::tools::available;

/// What a mode or another option makes meaningless is refused, and so is what would check or measure nothing.
#[test]
fn options_without_use_are_refused() {
    let work = Workplace::new();
    work.json("render scene.obj --size 8x8 --out a.png --rays a.rays");
    for (line, words) in [
        ("tree scene.obj --detail 0.5", &["--detail", "file"][..]),
        ("tree statue --format obj", &["--format"]),
        ("scenes --detail 0.5", &["--detail", "--export"]),
        ("check --prove --vectors 5", &["--vectors", "--prove"]),
        ("check --prove --seed 3", &["--seed", "a proof"]),
        ("check --exhaustive binary16 mul --seed 3", &["--seed", "all pairs"]),
        ("compare a.png a.png --seed 3", &["--seed", "a comparison"]),
        ("simulate --validate nowhere --seed 3", &["--seed"]),
        ("simulate --dump-config --seed 0", &["--seed"]),
        ("scenes --seed 3", &["--seed", "list"]),
        ("tree scene.obj --seed 3", &["--seed", "a scene from a file"]),
        ("trace scene.obj --rays a.rays --seed 3", &["--seed", "a scene from a file"]),
        ("render scene.obj --out a.exr --exposure 1", &["--exposure"]),
        ("render scene.obj --out b.png --heatmap plane-tests --exposure 1", &["--exposure"]),
        ("simulate --dump-config --sample 10%", &["--sample", "--dump-config"]),
        ("simulate --dump-config --csv a.csv", &["--csv", "--dump-config"]),
        ("simulate --dump-kernels own --set l1.banks=4", &["--set", "--dump-kernels"]),
        ("simulate --validate nowhere --size 4x4", &["--size", "--validate"]),
        ("chart precision scene.obj --simulate false --set l1.banks=4", &["--set", "--simulate"]),
        ("chart fidelity scene.obj --pipeline-cost netlist", &["--pipeline-cost"]),
        ("chart fidelity scene.obj --repeats 0", &["--repeats"]),
        ("stress --aimed 3", &["--aimed"]),
        ("stress --searches 4000000000", &["--searches"]),
        ("export --out rtl --vectors 4000000000", &["--vectors", "100000"]),
    ] {
        work.refused(line, words);
    }
    work.write("none.rays", &[b"DSTRAYS1".as_slice(), &[0; 8]].concat());
    work.refused("trace scene.obj --rays none.rays", &["none.rays", "no ray"]);
}

#[test]
fn outputs_are_no_inputs_and_no_other_outputs() {
    let work = Workplace::new();
    work.refused("render scene.obj --size 8x8 --out a.png --rays ./a.png", &["--rays", "--out"]);
    work.json("render scene.obj --size 8x8 --out a.png --rays a.rays");
    work.refused("trace scene.obj --rays a.rays --out a.rays --force", &["a.rays", "file of --out"]);
    work.refused("tree scene.obj --save scene.obj --force", &["scene.obj", "file of --save"]);
    work.refused("compare a.png a.png --out a.png --force", &["a.png", "file of --out"]);
    work.refused("wave --unit fp_add --scene scene.obj --out w.fst", &["w.fst", ".vcd"]);
}

/// Every file that a command reads stays as it is, whatever names it.
#[test]
fn no_input_is_overwritten() {
    let work = Workplace::new();
    let machine =
        work.run("simulate --dump-config --set chip.tms_per_partition=1 --set chip.l2_partitions=1");
    work.write("my.toml", &machine.stdout);
    work.write("scene.view.toml", b"fov = 40\n");
    let corners = [[0f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let bytes: Vec<u8> = corners.as_flattened().iter().flat_map(|x| x.to_le_bytes()).collect();
    work.write("corners.bin", &bytes);
    let gltf = r#"{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36, "uri": "corners.bin"}]}"#;
    work.write("a.gltf", gltf.as_bytes());
    work.json("tree a.gltf");
    let frame = "--size 4x4 --quality fast --force";
    let kept = |name: &str, line: &str| {
        let before = work.read(name);
        work.refused(line, &[name, "name another"]);
        assert!(before == work.read(name), "{line}");
    };
    kept("my.toml", &format!("simulate scene.obj --machine my.toml {frame} --csv my.toml"));
    kept("scene.view.toml", &format!("simulate scene.obj {frame} --csv scene.view.toml"));
    kept("scene.view.toml", &format!("render scene.obj {frame} --out a.png --rays ./scene.view.toml"));
    kept("corners.bin", "tree a.gltf --save corners.bin --force");
    kept("a.gltf", "tree a.gltf --save a.gltf --force");
    if available("clang-14") {
        work.json("simulate --dump-kernels .");
        let kernel = format!("simulate scene.obj {frame} --kernel examples/no-t-min.c --machine my.toml");
        kept("traversal.h", &format!("{kernel} --csv traversal.h"));
    }
    // A folder of results: what a later run would replace or remove is not read from it.
    work.json("chart fidelity scene.obj --size 8x8 --quality fast --machine my.toml --repeats 1 --rtl false --out f");
    std::fs::copy(work.path("my.toml"), work.path("f/fidelity.csv")).unwrap();
    let line = "chart fidelity scene.obj --size 8x8 --quality fast --machine f/fidelity.csv --repeats 1 --rtl false --out f";
    let before = work.read("f/fidelity.csv");
    work.refused(line, &["f: ", "reads fidelity.csv", "name another"]);
    assert!(before == work.read("f/fidelity.csv"));
}

/// What is written into standard output would lie in, or be replaced by, what is printed.
#[test]
#[cfg(unix)]
fn standard_output_is_no_file() {
    let work = Workplace::new();
    let line = "simulate scene.obj --size 4x4 --quality fast --json --csv /dev/stdout";
    work.refused(line, &["--csv /dev/stdout", "name a file"]);
    let file = std::fs::File::create(work.path("out.json")).unwrap();
    let mut run = std::process::Command::new(env!("CARGO_BIN_EXE_dualsplit"));
    run.args(line.split(' ')).arg("--force").current_dir(work.path(".")).stdout(file);
    assert_eq!(run.output().unwrap().status.code(), Some(2));
    assert!(work.read("out.json").is_empty());
}

/// A pipe stays a pipe: its reader gets the hits that a file would hold.
#[test]
#[cfg(unix)]
fn a_pipe_is_written_into() {
    let work = Workplace::new();
    work.json("render scene.obj --size 8x8 --out a.png --rays a.rays");
    work.json("trace scene.obj --rays a.rays --out a.hits");
    let pipe = work.path("p");
    assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let reader = std::thread::spawn({
        let pipe = pipe.clone();
        move || std::fs::read(pipe).unwrap()
    });
    work.json("trace scene.obj --rays a.rays --out p");
    assert_eq!(reader.join().unwrap(), work.read("a.hits"));
    assert!(!pipe.metadata().unwrap().is_file());
}

/// Files that ask for a deep stack or for much memory end in an error.
#[test]
fn small_files_cannot_ask_for_much() {
    let work = Workplace::new();
    work.write("nest.lib", format!("library (x) {{\n{}", "a (b) {\n".repeat(20_000)).as_bytes());
    work.refused("estimate --liberty nest.lib", &["nest.lib", "line 33", "deep"]);
    work.write("nest.toml", format!("a = {}", "[".repeat(100_000)).as_bytes());
    work.refused("simulate --machine nest.toml --dump-config", &["nest.toml"]);
    if cfg!(unix) {
        work.refused("simulate --machine /dev/zero --dump-config", &["/dev/zero", "more than"]);
        work.refused("trace scene.obj --rays scene.obj --tree /dev/zero", &["scene.obj"]);
        work.refused("estimate --liberty /dev/zero --quality fast", &["/dev/zero", "more than"]);
    }
}

/// A signal ends a run without leaving its temporary file.
#[test]
#[cfg(unix)]
fn an_interrupted_run_leaves_no_temporary_file() {
    let work = Workplace::new();
    work.json("render scene.obj --size 64x64 --out a.png --rays a.rays");
    let before = work.files();
    // Writing the rays of 64 x 64 pixels and 256 samples into a compressed file takes longer than a signal.
    let mut run = std::process::Command::new(env!("CARGO_BIN_EXE_dualsplit"))
        .args("render scene.obj --size 64x64 --spp 256 --out b.png --rays b.rays.xz".split(' '))
        .current_dir(work.path("."))
        .spawn()
        .unwrap();
    let is_temporary = |name: &String| name.starts_with(".dualsplit-");
    let end = std::time::Instant::now() + std::time::Duration::from_secs(120);
    while !work.path("b.png").exists() || !work.files().iter().any(is_temporary) {
        assert!(
            std::time::Instant::now() < end && run.try_wait().unwrap().is_none(),
            "the run was not met in its writing"
        );
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    let id = run.id().to_string();
    assert!(std::process::Command::new("kill").args(["-INT", &id]).status().unwrap().success());
    assert_eq!(run.wait().unwrap().code(), Some(130));
    let left: Vec<String> = work.files().into_iter().filter(|name| !before.contains(name)).collect();
    assert_eq!(left, ["b.png"]);
}
