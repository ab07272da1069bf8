//! Sweeps: what a file means, shards and merging, and a workflow one of whose workers is killed.

mod support;

use std::process::{Command, Stdio};
use std::time::{Duration, Instant};
use support::{Workplace, has_keys};
use testing::tools::available;

/// Two structures, two seeds and two sizes of a cache, in a small frame on a small machine.
const SWEEP: &str = "\
scenes = [\"scene.obj\"]
structures = [\"dst\", \"bvh2\"]
seeds = [0, 1]
sizes = \"12x10\"
quality = \"fast\"
[set]
l1.size = [\"1KiB\", \"32KiB\"]
chip.l2_partitions = 1
chip.tms_per_partition = 2
";

fn workplace() -> Workplace {
    let work = Workplace::new();
    work.write("s.toml", SWEEP.as_bytes());
    work
}

/// The files of the results of the sweep in `folder`, with their bytes.
fn results(work: &Workplace, folder: &str) -> Vec<(String, Vec<u8>)> {
    let entries = std::fs::read_dir(work.path(folder).join("results")).unwrap();
    let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    // How the results were made names the folder.
    let mut names: Vec<String> = names.filter(|name| name != "rerun.json").collect();
    names.sort();
    names.into_iter().map(|name| (name.clone(), work.read(&format!("{folder}/results/{name}")))).collect()
}

#[test]
fn a_sweep_is_the_product_of_its_lists() {
    let work = workplace();
    let counted = work.json("sweep s.toml --dry-run");
    has_keys(&counted, &["folder", "runs", "distinct", "seconds_left"]);
    assert_eq!(
        (&counted["runs"], &counted["missing"], &counted["simulated"]),
        (&8.into(), &8.into(), &0.into())
    );
    assert!(counted["seconds_left"].as_f64().unwrap() > 0.0 && !work.path("sweep-s").exists());
    let done = work.json("sweep s.toml");
    assert_eq!((&done["simulated"], &done["missing"]), (&8.into(), &0.into()));
    let table = String::from_utf8(work.read("sweep-s/results/sweep.csv")).unwrap();
    let rows: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
    let column =
        |name: &str| rows[0].iter().position(|found| *found == name).unwrap_or_else(|| panic!("no {name}"));
    assert_eq!(rows.len(), 9);
    for (name, values) in [
        ("structure", ["dst", "dst", "bvh2", "bvh2", "dst", "dst", "bvh2", "bvh2"]),
        ("seed", ["0", "0", "0", "0", "1", "1", "1", "1"]),
        ("l1.size", ["1KiB", "32KiB", "1KiB", "32KiB", "1KiB", "32KiB", "1KiB", "32KiB"]),
        ("chip.tms_per_partition", ["2"; 8]),
    ] {
        let found: Vec<&str> = rows[1..].iter().map(|row| row[column(name)]).collect();
        assert_eq!(found, values, "{name}");
    }
    // The same numbers as those of the command for one frame.
    let line = "simulate scene.obj --structure bvh2 --size 12x10 --quality fast --seed 1 --set l1.size=1KiB \
                --set chip.l2_partitions=1 --set chip.tms_per_partition=2";
    let single = work.json(line);
    assert_eq!(rows[7][column("cycles")], single["cycles"].to_string());
    assert_eq!(rows[7][column("energy_mj.total")], single["energy_mj"]["total"].to_string());
    assert!(
        ["time-l1.size.svg", "energy-seed.svg", "time-structure.svg"]
            .iter()
            .all(|name| work.path("sweep-s/results").join(name).exists())
    );
    // Nothing is simulated twice, and a price or a name makes no new run unless it changes a result.
    assert_eq!(work.json("sweep s.toml")["simulated"], 0);
    work.write("s.toml", SWEEP.replace("[0, 1]", "[0, 1, 2]").as_bytes());
    assert_eq!(work.json("sweep s.toml --dry-run")["missing"], 4);
}

#[test]
fn shards_and_merged_folders_give_the_same_bytes() {
    let work = workplace();
    work.json("sweep s.toml --out whole");
    for (shard, folder) in [("1/3", "a"), ("2/3", "a"), ("3/3", "b")] {
        let done = work.json(&format!("sweep s.toml --out {folder} --shard {shard}"));
        assert!((2..=3).contains(&done["simulated"].as_u64().unwrap()), "{done}");
    }
    assert!(!work.path("a/results").exists());
    work.refused("sweep s.toml --out a --merge nowhere", &["--merge nowhere"]);
    let refused = work.run("sweep s.toml --out c --merge a");
    let message = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert!(refused.status.code() == Some(2) && message.contains("2 runs are missing"), "{message}");
    // What an interruption left: half a record is simulated again.
    let first = std::fs::read_dir(work.path("b/runs")).unwrap().next().unwrap().unwrap().path();
    let bytes = std::fs::read(&first).unwrap();
    std::fs::write(&first, &bytes[..bytes.len() / 2]).unwrap();
    assert_eq!(work.json("sweep s.toml --out b --shard 3/3")["simulated"], 1);
    work.json("sweep s.toml --out c --merge a --merge b");
    assert!(results(&work, "c") == results(&work, "whole") && results(&work, "c").len() > 4);
}

#[test]
fn machines_of_a_frame_share_an_execution_at_the_queueing_level() {
    let work = workplace();
    work.write("q.toml", format!("level = \"queueing\"\n{SWEEP}").as_bytes());
    work.json("sweep q.toml --out all");
    for shard in ["1/2", "2/2"] {
        work.json(&format!("sweep q.toml --out parts --shard {shard}"));
    }
    work.json("sweep q.toml --out parts");
    assert!(results(&work, "all") == results(&work, "parts"));
}

#[test]
fn what_is_no_sweep_is_refused() {
    let work = workplace();
    for (from, to, words) in [
        ("structures", "structure", ["bad.toml", "structure"]),
        ("bvh2", "bvh3", ["`structures`", "bvh4"]),
        ("fast", "best", ["`quality`", "medium"]),
        ("l1.size", "l1.sizes", ["--set l1.sizes", "bad.toml"]),
        ("1KiB", "3KiB", ["l1.size = 3KiB", "bad.toml"]),
        ("scene.obj", "nothing.obj", ["nothing.obj", "bad.toml"]),
        ("scene.obj", "-", ["`scenes`", "standard input"]),
        ("[0, 1]", "[]", ["`seeds`", "bad.toml"]),
    ] {
        work.write("bad.toml", SWEEP.replace(from, to).as_bytes());
        work.refused("sweep bad.toml", &words);
        assert!(!work.path("sweep-bad").exists());
    }
    work.refused("sweep none.toml", &["none.toml", "cannot read"]);
    work.refused("sweep s.toml --shard 3/2", &["--shard", "K/N"]);
    work.refused("sweep s.toml --seed 3", &["--seed"]);
    work.refused("sweep s.toml --only abc", &["--only abc", "workflow anew"]);
    work.refused("sweep s.toml --dry-run --shard 1/2", &["--dry-run"]);
}

/// A workflow ends with the same results even if one of its workers is killed.
#[test]
#[cfg(target_os = "linux")]
fn a_workflow_survives_the_loss_of_a_worker() {
    if !available("snakemake") {
        return;
    }
    let work = workplace();
    work.json("sweep s.toml --out plain");
    let written = work.json("sweep s.toml --out flow --workflow snakemake");
    assert_eq!(written["artifacts"], serde_json::json!(["flow/Snakefile"]));
    work.refused("sweep s.toml --out flow --workflow snakemake", &["Snakefile", "--force"]);
    let mut engine = Command::new("snakemake")
        .args(["--snakefile", "flow/Snakefile", "--cores", "2", "--config"])
        .arg(format!("dualsplit={}", env!("CARGO_BIN_EXE_dualsplit")))
        .current_dir(work.path("."))
        .stdout(Stdio::null())
        .stderr(std::fs::File::create(work.path("said")).unwrap())
        .spawn()
        .unwrap();
    let end = Instant::now() + Duration::from_secs(300);
    let mut killed = None;
    while engine.try_wait().unwrap().is_none() {
        assert!(Instant::now() < end, "the workflow does not end");
        if killed.is_none() {
            killed = worker(&work);
            if let Some(id) = killed {
                assert!(Command::new("kill").args(["-KILL", &id.to_string()]).status().unwrap().success());
            }
        }
        std::thread::sleep(Duration::from_millis(2));
    }
    let said = String::from_utf8_lossy(&work.read("said")).into_owned();
    assert!(engine.wait().unwrap().success() && killed.is_some(), "{said}");
    assert!(results(&work, "flow") == results(&work, "plain"), "{said}");
}

/// The process of a run of the workflow in `work`.
#[cfg(target_os = "linux")]
fn worker(work: &Workplace) -> Option<u32> {
    let here = work.path(".").canonicalize().unwrap();
    let processes = std::fs::read_dir("/proc").unwrap().flatten();
    processes.filter_map(|entry| entry.file_name().to_str()?.parse().ok()).find(|id: &u32| {
        let folder = std::path::PathBuf::from(format!("/proc/{id}"));
        let is_tool = std::fs::read_link(folder.join("exe")).is_ok_and(|exe| exe.ends_with("dualsplit"));
        let words = std::fs::read(folder.join("cmdline")).unwrap_or_default();
        let is_run = words.split(|byte| *byte == 0).any(|word| word == b"--only");
        is_tool && is_run && std::fs::read_link(folder.join("cwd")).is_ok_and(|cwd| cwd == here)
    })
}
