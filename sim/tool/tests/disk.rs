//! Disks and folders that refuse: full ones, those that take no file, and those that another run is writing into.
#![cfg(unix)]

mod support;

use std::fs::{self, File};
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};
use support::Workplace;

const TOOL: &str = env!("CARGO_BIN_EXE_dualsplit");

/// Runs the tool, which can make no file of more than 4096 bytes, as on a disk that becomes full. `SIGXFSZ` comes with it.
fn limited(work: &Workplace, line: &str) -> Output {
    // Blocks have 512 bytes.
    let mut shell = Command::new("sh");
    shell.args(["-c", "ulimit -f 8; exec \"$0\" \"$@\"", TOOL]).args(line.split(' '));
    shell.current_dir(work.path(".")).output().unwrap()
}

fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// Asserts that the tool could not write `name`, and says so.
fn could_not_write(output: &Output, name: &str) {
    let said = stderr(output);
    assert_eq!(output.status.code(), Some(2), "{name}: {said}");
    assert!(said.contains(name) && said.contains("cannot write"), "{name}: {said}");
    assert!(!said.contains("panicked") && output.stdout.is_empty(), "{name}: {said}");
}

#[test]
fn a_file_for_which_there_is_no_space_is_not_begun() {
    let work = Workplace::new();
    work.json("render scene.obj --size 32x32 --out big.png --rays big.rays");
    let before = work.files();
    for (line, name) in [
        ("render scene.obj --size 64x64 --out a.exr", "a.exr"),
        ("trace scene.obj --rays big.rays --out a.hits", "a.hits"),
        ("scenes hairball --detail 0.001 --export a.obj", "a.obj"),
        ("scenes hairball --detail 0.001 --export a.stl.gz", "a.stl.gz"),
        ("tree hairball --detail 0.001 --quality fast --save a.tree", "a.tree"),
    ] {
        could_not_write(&limited(&work, line), name);
        assert_eq!(work.files(), before, "{line}");
    }
    // What the file would replace stays.
    let old = work.read("big.rays");
    could_not_write(
        &limited(&work, "render scene.obj --size 32x32 --out b.png --rays big.rays --force"),
        "big.rays",
    );
    assert!(old == work.read("big.rays"));
}

/// A folder of results gets whole files only, and a later run completes it.
#[test]
fn a_folder_for_which_there_is_no_space_holds_whole_files() {
    let work = Workplace::new();
    let line = "chart precision scene.obj --size 4x4 --quality fast --simulate false --out";
    work.json(&format!("{line} whole"));
    could_not_write(&limited(&work, &format!("{line} part")), "part/");
    let names = |folder: &str| -> Vec<String> {
        let entries = fs::read_dir(work.path(folder)).unwrap();
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
    };
    for name in names("part") {
        // The list of the files, and how they were made, name what there is.
        if name != ".dualsplit-artifacts" {
            assert!(work.read(&format!("part/{name}")) == work.read(&format!("whole/{name}")), "{name}");
        }
    }
    assert!(names("part").len() < names("whole").len());
    work.json(&format!("{line} part"));
    assert_eq!(names("part").len(), names("whole").len());
}

#[test]
#[cfg(target_os = "linux")]
fn a_full_device_is_an_error() {
    let work = Workplace::new();
    work.json("render scene.obj --size 8x8 --out a.png --rays a.rays");
    let frame = "simulate scene.obj --size 4x4 --quality fast";
    for line in ["trace scene.obj --rays a.rays --out /dev/full", &format!("{frame} --csv /dev/full")] {
        could_not_write(&work.run(line), "/dev/full");
    }
    let full = || File::options().write(true).open("/dev/full").unwrap();
    let run = |line: &str| {
        let mut run = Command::new(TOOL);
        run.args(line.split(' ')).current_dir(work.path("."));
        run
    };
    could_not_write(&run("tree scene.obj").stdout(full()).output().unwrap(), "standard output");
    // What is said on the way is no result.
    work.write("line.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\nf 1 2 3\n");
    let said = run("tree line.obj").stdout(Stdio::null()).stderr(full()).status().unwrap();
    assert_eq!(said.code(), Some(0));
    assert_eq!(run("tree nothing.obj").stderr(full()).status().unwrap().code(), Some(2));
}

#[test]
fn folders_that_take_no_file_are_noticed_before_the_work() {
    let work = Workplace::new();
    let mut folders = vec!["scene.obj"];
    if cfg!(target_os = "linux") {
        folders.push("/proc");
    }
    // Work that no test would wait for.
    let large = "scene.obj --size 4096x4096 --spp 64";
    for folder in folders {
        work.refused(&format!("render {large} --out {folder}/a.png"), &["--out", folder]);
        work.refused(&format!("needs scene.obj --size 4096x4096 --out {folder}/n"), &[folder, "folder"]);
        work.refused(&format!("study --preset paper --out {folder}/s"), &[folder, "folder"]);
    }
}

/// How a command is run for which permissions hold: as it is, or, for root, without its capabilities.
fn bound_by_permissions(folder: &Path) -> Option<Vec<&'static str>> {
    let probe = folder.join("probe");
    if File::create(&probe).is_err() {
        return Some(vec![]);
    }
    fs::remove_file(&probe).unwrap();
    let words = vec!["setpriv", "--bounding-set=-all", "--inh-caps=-all"];
    let tried = Command::new(words[0]).args(&words[1..]).arg("touch").arg(&probe).output();
    tried.is_ok_and(|output| stderr(&output).contains("ermission denied")).then_some(words)
}

#[test]
fn a_folder_without_permission_is_noticed_before_the_work() {
    let work = Workplace::new();
    let folder = work.path("locked");
    fs::create_dir(&folder).unwrap();
    fs::set_permissions(&folder, fs::Permissions::from_mode(0o555)).unwrap();
    let Some(prefix) = bound_by_permissions(&folder) else {
        println!("skipped: root writes everywhere, and there is no setpriv that takes its capabilities away");
        return;
    };
    for line in [
        "render scene.obj --size 4096x4096 --spp 64 --out locked/a.png",
        "needs scene.obj --size 4096x4096 --out locked",
        "study --preset paper --out locked",
    ] {
        let words: Vec<&str> = prefix.iter().copied().chain([TOOL]).chain(line.split(' ')).collect();
        let output = Command::new(words[0]).args(&words[1..]).current_dir(work.path(".")).output().unwrap();
        could_not_write(&output, "locked");
        assert!(fs::read_dir(&folder).unwrap().next().is_none(), "{line}");
    }
}

#[test]
fn a_second_run_in_a_folder_is_refused() {
    let work = Workplace::new();
    let line = "study --preset quick --quality fast --scene hairball --out s";
    let mut first = Command::new(TOOL)
        .args(line.split(' '))
        .current_dir(work.path("."))
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let end = Instant::now() + Duration::from_secs(120);
    while !work.path("s/settings.json").exists() {
        assert!(Instant::now() < end && first.try_wait().unwrap().is_none(), "the first run does not begin");
        std::thread::sleep(Duration::from_millis(5));
    }
    work.refused(line, &["s: another run is writing", "name another folder"]);
    assert!(first.try_wait().unwrap().is_none(), "the first run goes on");
    let id = first.id().to_string();
    assert!(Command::new("kill").args(["-INT", &id]).status().unwrap().success());
    assert_eq!(first.wait().unwrap().code(), Some(130));
    // The folder is free: the next run comes as far as its settings.
    work.refused(&format!("{line} --seed 5"), &["seed"]);
}
