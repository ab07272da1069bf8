//! What every command keeps to: options that say something, outputs that are nothing else, memory in proportion, nothing left behind.

mod support;

use support::Workplace;

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
    work.refused("trace scene.obj --rays a.rays --out a.rays --force", &["--out a.rays", "also read"]);
    work.refused("tree scene.obj --save scene.obj --force", &["--save", "also read"]);
    work.refused("compare a.png a.png --out a.png --force", &["--out", "also read"]);
    work.refused("wave --unit fp_add --scene scene.obj --out w.fst", &["w.fst", ".vcd"]);
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
