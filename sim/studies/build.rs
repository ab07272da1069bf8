//! Hashes the sources of all that a result depends on, so that results that are kept can name the program that made them.

use std::fs;
use std::hash::{DefaultHasher, Hasher};
use std::path::{Path, PathBuf};

/// Folders of sources, seen from this crate; beside them, all crates in the folder above it.
const FOLDERS: [&str; 4] = ["../../scenes", "../../golden", "../../hdl", "src"];
/// Crates of that folder that only print and draw, and this one, of which `src` counts.
const WITHOUT: [&str; 3] = ["tool", "view", "studies"];

fn main() {
    let mut files = vec![PathBuf::from("../../Cargo.lock")];
    let beside = entries(Path::new("..")).filter(|path| !WITHOUT.iter().any(|name| path.ends_with(name)));
    for folder in FOLDERS.iter().map(PathBuf::from).chain(beside) {
        println!("cargo::rerun-if-changed={}", folder.display());
        collect(&folder, &mut files);
    }
    files.sort();
    // The standard hasher has fixed keys.
    let mut hasher = DefaultHasher::new();
    for file in &files {
        hasher.write(file.as_os_str().as_encoded_bytes());
        hasher.write(&fs::read(file).unwrap_or_default());
    }
    println!("cargo::rerun-if-changed=../../Cargo.lock");
    println!("cargo::rustc-env=DUALSPLIT_SOURCES={:016x}", hasher.finish());
}

/// What lies in `folder`.
fn entries(folder: &Path) -> impl Iterator<Item = PathBuf> {
    fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path())
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    for path in entries(folder) {
        if path.is_dir() {
            collect(&path, files);
        } else {
            files.push(path);
        }
    }
}
