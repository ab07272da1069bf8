//! Tests of every command: its JSON keys, its files, and the input that it refuses.

mod support;

use golden::structure::StructureKind;
use support::{Workplace, has_keys};

const COUNTERS: [&str; 4] = ["node_visits", "plane_tests", "box_tests", "triangle_tests"];

#[test]
fn scenes() {
    let work = Workplace::new();
    let all = work.json("scenes");
    let scenes = all["scenes"].as_array().unwrap();
    assert_eq!(scenes.len(), scenes::procedural::CATALOGUE.len());
    scenes.iter().for_each(|scene| has_keys(scene, &["name", "triangles", "stands_for"]));

    let exported = work.json("scenes hairball --export hair.obj.xz --detail 0.001");
    let triangles = exported["exported"]["triangles"].as_u64().unwrap();
    let tree = work.json("tree hair.obj.xz --quality fast");
    assert_eq!(tree["triangles"].as_u64(), Some(triangles));

    work.refused("scenes hairball", &["--export"]);
    work.refused("scenes --export a.obj", &["NAME"]);
    work.refused("scenes teapot --export a.obj", &["teapot", "hairball"]);
    work.refused("scenes hairball --export hair.obj.xz --detail 0.001", &["hair.obj.xz", "--force"]);
    work.refused("scenes hairball --export b.obj --detail 0", &["detail", "0"]);
    work.refused("scenes hairball --export nowhere/b.obj", &["nowhere"]);
}

#[test]
fn tree() {
    let work = Workplace::new();
    let document = work.json("tree scene.obj --scratch");
    has_keys(&document, &["version", "command", "artifacts", "scene", "triangles", "structures"]);
    assert_eq!(document["command"], "tree scene.obj --scratch");
    assert_eq!(document["triangles"], 6);
    let structures = document["structures"].as_array().unwrap();
    let names: Vec<_> = structures.iter().map(|s| s["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["bvh2", "bvh4", "bvh8", "bvh16", "qbvh2", "qbvh4", "qbvh8", "dst", "dst_scratch"]);
    let without = work.json("tree scene.obj");
    assert_eq!(without["structures"].as_array().unwrap().len(), names.len() - 1, "the slow one is asked for");
    for s in structures {
        has_keys(
            s,
            &[
                "nodes",
                "leaves",
                "bytes",
                "bytes_per_triangle",
                "sah_cost",
                "max_depth",
                "build_ms",
                "convert_ms",
                "carve_nodes_per_split",
            ],
        );
    }
    let text = String::from_utf8(work.run("tree scene.obj").stdout).unwrap();
    for words in ["| bvh8", "Leaves by depth", "Children by number of carve nodes"] {
        assert!(text.contains(words), "{text}");
    }
}

#[test]
fn saved_trees() {
    let work = Workplace::new();
    let size = "--size 40x30";
    work.json(&format!("render scene.obj {size} --out built.png --rays a.rays"));
    work.json("trace scene.obj --rays a.rays --out built.hits");
    for structure in ["bvh2", "bvh4", "bvh8", "bvh16", "qbvh2", "qbvh4", "qbvh8", "dst", "dst_scratch"] {
        let document = work.json(&format!("tree scene.obj --save {structure}.tree --structure {structure}"));
        assert_eq!(document["artifacts"], serde_json::json!([format!("{structure}.tree")]));
        let trace = work
            .json(&format!("trace scene.obj --rays a.rays --tree {structure}.tree --out {structure}.hits"));
        assert_eq!(trace["structure"], structure.trim_end_matches("_scratch"));
        assert_eq!(work.read(&format!("{structure}.hits")), work.read("built.hits"));
        work.json(&format!("render scene.obj {size} --tree {structure}.tree --out {structure}.png"));
        assert_eq!(work.read(&format!("{structure}.png")), work.read("built.png"));
    }
    assert_ne!(work.read("bvh2.tree"), work.read("dst.tree"));
    work.refused("tree scene.obj --save dst.tree", &["dst.tree", "--force"]);
    work.json("tree scene.obj --save dst.tree --force");
    work.refused("tree scene.obj --structure bvh2", &["--save"]);
    work.refused("tree scene.obj --save nowhere/a.tree", &["nowhere"]);

    let trace = |tree: &str| format!("trace scene.obj --rays a.rays --tree {tree}");
    work.refused(&format!("{} --structure bvh2", trace("dst.tree")), &["--structure", "--tree"]);
    work.refused(&format!("{} --quality fast", trace("dst.tree")), &["--quality", "--tree"]);
    work.refused(&trace("missing.tree"), &["missing.tree"]);
    work.refused(&trace("scene.obj"), &["scene.obj", "not a dual-split tree file"]);
    let mut bytes = work.read("dst.tree");
    work.write("short.tree", &bytes[..bytes.len() - 1]);
    work.refused(&trace("short.tree"), &["short.tree", "bytes", "save the tree again"]);
    let middle = bytes.len() / 2;
    bytes[middle] ^= 4;
    work.write("damaged.tree", &bytes);
    work.refused(&trace("damaged.tree"), &["damaged.tree", "checksum"]);

    let scene = String::from_utf8(work.read("scene.obj")).unwrap();
    work.write("moved.obj", scene.replace("v 0 1.5 0", "v 0 1.25 0").as_bytes());
    work.write("smaller.obj", scene.replace("f 1 2 5\n", "").as_bytes());
    for (other, words) in [("moved.obj", "triangle"), ("smaller.obj", "6 triangles, the scene has 5")] {
        let line = format!("--tree dst.tree --out a.png {size}");
        work.refused(&format!("render {other} {line}"), &["dst.tree", words, "save one of this scene"]);
    }
}

#[test]
fn render_trace_and_compare() {
    let work = Workplace::new();
    let size = "--size 40x30 --spp 2";
    for structure in ["bvh2", "bvh4", "bvh8", "bvh16", "qbvh8", "dst"] {
        for test in ["raycast", "path"] {
            let line = format!("render scene.obj --structure {structure} --test {test} {size}");
            let document = work.json(&format!("{line} --out {structure}-{test}.exr"));
            has_keys(&document, &["rays", "seconds", "max", "mode", "classes"]);
            assert!(document["max"].as_f64().unwrap() > 0.0);
            assert!(document["maxima"]["node_visits"].as_u64().unwrap() > 0);
            work.json(&format!("{line} --out {structure}-{test}.png --mode fast"));
        }
    }
    // The counters differ, the colours do not.
    let equal = work.json("compare bvh2-path.exr dst-path.exr");
    assert_eq!((&equal["differing_pixels"], &equal["rmse"]), (&0.into(), &0.0.into()));
    assert_ne!(work.read("bvh2-path.exr"), work.read("dst-path.exr"));
    for other in ["bvh4", "bvh8", "bvh16", "qbvh8", "dst"] {
        assert_eq!(work.read("bvh2-path.png"), work.read(&format!("{other}-path.png")));
        assert_eq!(work.read("bvh2-raycast.png"), work.read(&format!("{other}-raycast.png")));
    }

    let different = work.run("compare dst-path.png dst-raycast.png --out difference.png --json");
    assert_eq!(different.status.code(), Some(1));
    let different: serde_json::Value = serde_json::from_slice(&different.stdout).unwrap();
    assert_eq!(different["differing_pixels"], 123);
    has_keys(&different, &["rmse", "psnr_db", "max_abs"]);
    assert!(work.path("difference.png").exists());

    let render = work.json(&format!("render scene.obj --test path {size} --out a.png --rays a.rays.xz"));
    assert_eq!(work.read("a.png"), work.read("dst-path.png"));
    for structure in ["bvh2", "dst"] {
        let line = format!("trace scene.obj --rays a.rays.xz --structure {structure} --mode robust");
        let trace = work.json(&format!("{line} --out {structure}.hits"));
        has_keys(&trace, &["rays", "hits", "rays_per_second", "mode"]);
        has_keys(&trace, &COUNTERS);
        assert_eq!(trace["rays"], render["rays"]);
        assert_eq!(trace["classes"].as_array().unwrap().len(), render["classes"].as_array().unwrap().len());
    }
    assert_eq!(work.read("bvh2.hits"), work.read("dst.hits"));
}

#[test]
fn threads_and_seed() {
    let work = Workplace::new();
    let picture = |name: &str, options: &str| {
        work.json(&format!("render scene.obj --size 33x21 --out {name} {options}"));
        work.read(name)
    };
    let one = picture("one.exr", "--threads 1");
    assert_eq!(one, picture("three.exr", "--threads 3"));
    assert_ne!(one, picture("seed.exr", "--seed 1"));
}

#[test]
fn heat_maps() {
    let work = Workplace::new();
    let mut maps = vec![];
    for quantity in ["node-visits", "plane-tests", "triangle-tests", "stack-depth"] {
        let line = format!("render scene.obj --size 64x48 --heatmap {quantity} --out {quantity}.png");
        let document = work.json(&line);
        assert_eq!(document["max_of"], quantity);
        assert_eq!(document["max"].as_f64(), document["maxima"][quantity.replace('-', "_")].as_f64());
        maps.push(work.read(&format!("{quantity}.png")));
    }
    assert!(maps.windows(2).all(|pair| pair[0] != pair[1]));
    work.refused("render scene.obj --heatmap speed --out a.png", &["speed", "node-visits"]);
    work.refused("render scene.obj --heatmap stack-depth --out a.exr", &["--out a.exr", "--heatmap"]);
    work.refused("render scene.obj --heatmap-max 5 --out a.png", &["--heatmap"]);
}

#[test]
fn views() {
    let work = Workplace::new();
    let view = "--eye -3,2.5,-3 --target 0,0.5,0 --up 0,1,0 --fov 35 --light -2,5,1";
    work.json(&format!("render scene.obj --size 32x32 {view} --out a.png"));
    work.json("render scene.obj --size 32x32 --out b.png");
    assert_ne!(work.read("a.png"), work.read("b.png"));
    let refused = |options: &str, words: &[&str]| {
        work.refused(&format!("render scene.obj --out c.png {options}"), words);
    };
    refused("--eye 1,2", &["--eye", "1,2", "comma"]);
    refused("--eye 0,0,0 --target 0,0,0", &["eye", "target"]);
    refused("--up 0,0,0", &["up"]);
    refused("--fov 180", &["fov"]);
    refused("--light 0,0,0 --target 0,0,0", &["--light"]);
    refused("--size 0x10", &["size", "0x10"]);
    refused("--size 10", &["--size"]);
    refused("--spp 0", &["spp"]);
    refused("--threads 0", &["--threads"]);
}

#[test]
fn explain() {
    let work = Workplace::new();
    let line = "explain scene.obj --pixel 16,16 --size 32x32";
    let document = work.json(line);
    has_keys(&document, &["scene", "mode", "pixel", "ray", "hit", "structures"]);
    assert!(document["hit"]["t"].as_f64().unwrap() > 0.0);
    let structures = document["structures"].as_array().unwrap();
    let names = |s: &[serde_json::Value]| -> Vec<String> {
        s.iter().map(|s| s["name"].as_str().unwrap().to_owned()).collect()
    };
    assert_eq!(names(structures), ["dst", "bvh2"]);
    let other = work.json(&format!("{line} --structure bvh16 --structure bvh4"));
    assert_eq!(other["hit"], document["hit"]);
    let others = other["structures"].as_array().unwrap();
    assert_eq!(names(others), ["bvh16", "bvh4"]);
    for s in structures.iter().chain(others) {
        has_keys(s, &COUNTERS);
        let visited = |step: &&serde_json::Value| step["step"] == "node" || step["step"] == "box";
        let visits = s["steps"].as_array().unwrap().iter().filter(visited).count();
        assert_eq!(visits as u64, s["node_visits"].as_u64().unwrap());
    }
    let text = String::from_utf8(work.run(line).stdout).unwrap();
    assert!(text.contains("root box") && text.contains("best"), "{text}");
    work.refused("explain scene.obj --pixel 32,0 --size 32x32", &["--pixel 32,0", "32x32"]);
    work.refused("explain scene.obj", &["--pixel"]);
}

#[test]
fn files_are_kept_without_force() {
    let work = Workplace::new();
    work.json("render scene.obj --size 8x8 --out a.png --rays a.rays");
    let before = work.read("a.png");
    work.refused("render scene.obj --size 9x9 --out a.png", &["a.png", "--force"]);
    work.refused("render scene.obj --size 9x9 --out new.png --rays a.rays", &["a.rays", "--force"]);
    work.refused("trace scene.obj --rays a.rays --out a.rays", &["a.rays", "--force"]);
    work.refused("compare a.png a.png --out a.png", &["a.png", "--force"]);
    assert_eq!(work.read("a.png"), before);
    work.json("render scene.obj --size 9x9 --out a.png --force");
    assert_ne!(work.read("a.png"), before);
}

#[test]
fn frames_with_fewer_pixels_than_threads_work_at_every_level() {
    let work = Workplace::new();
    for level in ["analytic --sample 10%", "transaction --sample 10%", "auto"] {
        for size in ["1x1", "24x24"] {
            let frame =
                format!("simulate scene.obj --quality fast --size {size} --test raycast --fidelity {level}");
            let document = work.json(&frame);
            assert!(document["frame_ms"].as_f64().unwrap() > 0.0, "{frame}");
        }
    }
}

#[test]
fn bad_input_is_named() {
    let work = Workplace::new();
    work.write("empty.obj", b"");
    work.write("nan.obj", b"v 0 0 0\nv 1 0 nan\nv 0 1 0\nf 1 2 3\n");
    work.write("short.rays", b"DSTRAYS1\x02\0\0\0\x01\0\0\0 too short");
    work.write("no.png", b"no");
    work.refused("tree nothing", &["nothing", "built-in"]);
    work.refused("tree nothing.obj", &["nothing.obj"]);
    work.refused("tree empty.obj", &["empty.obj"]);
    work.refused("tree nan.obj", &["nan.obj:2"]);
    work.refused("tree hairball --detail 2", &["detail 2"]);
    work.refused("tree scene.obj --quality best", &["best", "medium"]);
    work.refused("render scene.obj --out a.jpg", &["a.jpg", ".png"]);
    work.refused("render scene.obj --out nowhere/a.png", &["nowhere"]);
    work.refused("render scene.obj --structure octree --out a.png", &["octree", "dst"]);
    work.refused("render scene.obj --mode careful --out a.png", &["careful", "robust"]);
    work.refused("trace scene.obj --rays short.rays", &["short.rays", "offset", "ray 0 of 2"]);
    work.refused("trace scene.obj --rays scene.obj", &["scene.obj", "DSTRAYS1"]);
    work.refused("trace scene.obj --rays none.rays", &["none.rays"]);
    work.refused("check --vectors 0", &["--vectors", "0"]);
    work.refused("check --unit fp_add --vectors 0 --mutate 1", &["--vectors", "0"]);
    work.refused("compare no.png no.png", &["no.png"]);
    work.refused("compare scene.obj no.png", &["scene.obj", ".exr"]);
    work.refused("frobnicate", &["frobnicate"]);
}

#[test]
fn pictures_that_cannot_be_compared() {
    let work = Workplace::new();
    work.json("render scene.obj --size 8x8 --out a.png");
    work.json("render scene.obj --size 8x8 --out a.exr");
    work.json("render scene.obj --size 8x9 --out b.png");
    work.refused("compare a.png a.exr", &["a.png", "a.exr"]);
    work.refused("compare a.png b.png", &["a.png", "b.png", "8 x 8"]);
}

#[test]
fn reproduce() {
    let work = Workplace::new();
    let artifacts = |line: &str| -> Vec<String> {
        let document = work.json(line);
        let paths = document["artifacts"].as_array().unwrap();
        paths.iter().map(|path| path.as_str().unwrap().to_owned()).collect()
    };
    let paths = artifacts("reproduce --preset smoke --threads 2");
    // For each scene and test, there are a heat map of each structure and one picture.
    let pictures = scenes::procedural::CATALOGUE.len() * 2 * (StructureKind::ALL.len() + 1);
    assert_eq!(
        paths.iter().filter(|path| path.contains("images/") || path.contains("heatmaps/")).count(),
        pictures
    );
    for file in ["trees.csv", "report/index.html", "precision/visits.svg", "stages/stress.json"] {
        assert!(paths.contains(&format!("out/{file}")), "{file} in {paths:?}");
    }
    assert!(!work.path("out/stages/unfinished.json").exists());
    let results: serde_json::Value = serde_json::from_slice(&work.read("out/results.json")).unwrap();
    has_keys(&results, &["mode", "seed", "scenes"]);
    let csv = String::from_utf8(work.read("out/work.csv")).unwrap();
    assert!(csv.starts_with("scene,test,structure,mode,class,rays,hits,node_visits,plane_tests"), "{csv}");
    let page = String::from_utf8(work.read("out/report/index.html")).unwrap();
    for part in [
        "In a minute",
        "Where it differs",
        "Units and pipelines",
        "Fidelity of the simulator",
        "Stability where methods fail",
        "<code>dualsplit check --unit dual_split --vectors 200</code>",
        "dst/binary32-robust",
    ] {
        assert!(page.contains(part), "{part}");
    }
    // Every part that the page names is there, every chart has a name, and every table has a caption and names its columns.
    for anchor in page.split("href=\"#").skip(1).filter_map(|rest| rest.split('"').next()) {
        assert!(page.contains(&format!("id=\"{anchor}\"")), "{anchor}");
    }
    let count = |part: &str| page.matches(part).count();
    assert_eq!(count("<svg"), count("role=\"img\""));
    assert_eq!(
        (count("<table>"), count("<table>")),
        (count("<caption>"), count("<thead><tr><th scope=\"col\""))
    );
    // Every file that the page names is there.
    for link in page.split("href=\"../").skip(1).filter_map(|rest| rest.split('"').next()) {
        assert!(work.path(&format!("out/{link}")).is_file(), "{link}");
    }

    // A run on one thread replaces every file by an equal one, except for those that hold times.
    let before: Vec<_> = paths.iter().map(|path| work.read(path)).collect();
    work.write("out/mine.txt", b"mine");
    assert_eq!(artifacts("reproduce --preset smoke --threads 1"), paths);
    let timed = ["results.json", "index.html", "/stages/", "/fidelity/"];
    for (path, before) in paths.iter().zip(before) {
        if !timed.iter().any(|part| path.contains(part)) {
            assert!(work.read(path) == before, "{path}");
        }
    }
    assert_eq!(work.read("out/mine.txt"), b"mine");

    std::fs::create_dir(work.path("photos")).unwrap();
    work.write("photos/cat.png", b"cat");
    work.refused("reproduce --preset smoke --out photos", &["photos", "--force"]);
    work.refused("reproduce --preset huge", &["huge", "quick"]);
}

#[test]
fn an_interrupted_job_goes_on_where_it_was() {
    use std::process::{Command, Stdio};
    use std::time::{Duration, Instant};
    let work = Workplace::new();
    let mut child = Command::new(env!("CARGO_BIN_EXE_dualsplit"))
        .args(["reproduce", "--preset", "smoke"])
        .current_dir(work.path(""))
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let finished = work.path("out/stages/check.json");
    let start = Instant::now();
    while !finished.exists() {
        assert!(start.elapsed() < Duration::from_secs(300), "the job makes no progress");
        std::thread::sleep(Duration::from_millis(5));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(!work.path("out/report/index.html").exists());
    let made = |name: &str| std::fs::metadata(work.path(name)).unwrap().modified().unwrap();
    let parts = ["out/stages/check.json", "out/stages/scene-atrium.json", "out/images/atrium-path.png"];
    let before = parts.map(made);

    let output = work.run("reproduce --preset smoke");
    let progress = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(0), "{progress}");
    assert!(progress.contains("check: taken from the interrupted run"), "{progress}");
    assert!(progress.contains("stress: ") && progress.contains("left, at the pace so far"), "{progress}");
    assert_eq!(parts.map(made), before, "finished parts are not repeated");
    assert!(work.path("out/report/index.html").exists());

    // After a complete job, the same command begins anew.
    let progress = String::from_utf8(work.run("reproduce --preset smoke").stderr).unwrap();
    assert!(!progress.contains("interrupted"), "{progress}");
    assert_ne!(parts.map(made), before);
}

#[cfg(unix)]
#[test]
fn a_closed_pipe_is_no_panic() {
    use std::process::{Command, Stdio};
    let work = Workplace::new();
    let mut child = Command::new(env!("CARGO_BIN_EXE_dualsplit"))
        .args(["tree", "scene.obj"])
        .current_dir(work.path(""))
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(0));
    assert!(output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
}

/// A folder of results is made again by what it says of itself, wherever it lies.
#[test]
fn results_are_made_again() {
    let work = Workplace::new();
    std::fs::create_dir(work.path("a")).unwrap();
    std::fs::copy(work.path("scene.obj"), work.path("a/scene.obj")).unwrap();
    let line = "chart precision scene.obj --size 4x4 --quality fast --simulate false --seed 3 --out p";
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_dualsplit"))
        .args(line.split(' ').chain(["--json", "--threads", "1"]))
        .current_dir(work.path("a"))
        .output()
        .unwrap();
    let first: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let made: serde_json::Value = serde_json::from_slice(&work.read("a/p/rerun.json")).unwrap();
    let words: Vec<&str> = line.split(' ').collect();
    assert_eq!((&made["arguments"], &made["folder"]), (&serde_json::json!(words), &"p".into()));
    std::fs::rename(work.path("a"), work.path("b")).unwrap();
    let table = work.read("b/p/precision.csv");
    work.write("b/p/precision.csv", b"");
    assert_eq!(work.json("rerun b/p"), first);
    assert!(work.read("b/p/precision.csv") == table && work.path("b/p/rerun.json").exists());
    std::fs::rename(work.path("b/p"), work.path("b/q")).unwrap();
    work.refused("rerun b/q", &["written as p", "run `dualsplit chart precision"]);
    work.refused("rerun b", &["rerun.json", "name their folder"]);
    work.refused("rerun b/q --seed 4", &["--seed"]);
    work.write(
        "b/q/rerun.json",
        b"{\"version\": \"9\", \"commit\": \"\", \"folder\": \"q\", \"arguments\": [\"sing\"]}",
    );
    work.refused("rerun b/q", &["rerun.json", "does not take `dualsplit sing`"]);
}

#[test]
fn man_pages_and_completions_are_written() {
    let work = Workplace::new();
    let written = work.json("manual m");
    let files = written["artifacts"].as_array().unwrap();
    assert!(files.len() > 20 && files.iter().all(|file| work.path(file.as_str().unwrap()).exists()));
    let page = String::from_utf8(work.read("m/man/dualsplit-chart-precision.1")).unwrap();
    assert!(page.contains("most\\-visits") && page.contains("dualsplit chart precision"), "{page}");
    let script = String::from_utf8(work.read("m/completions/dualsplit.bash")).unwrap();
    assert!(script.contains("--most-visits") && script.contains("rerun"));
    assert!(!work.path("m/man/dualsplit-manual.1").exists(), "hidden");
}

#[test]
fn a_quiet_command_says_nothing_but_its_result() {
    let work = Workplace::new();
    work.write("dart.obj", b"v 0 0 0\nv 2 -1 0\nv 0.5 0 0\nv 2 1 0\nl 1 2\nf 2 3 4 1\n");
    let said = |line: &str| work.run(line).stderr;
    assert!(!said("tree dart.obj").is_empty() && said("tree dart.obj --quiet").is_empty());
    assert_eq!(work.json("tree dart.obj -q")["command"], "tree dart.obj");
    assert!(said("tree none.obj -q").starts_with(b"error: "));
    let version = String::from_utf8(work.run("--version").stdout).unwrap();
    assert!(version.starts_with(&format!("dualsplit {}", env!("CARGO_PKG_VERSION"))), "{version}");
}
