//! Hashes the sources of all that a result depends on, so that results that are kept can name the program that made them.

use std::fs;
use std::hash::{DefaultHasher, Hasher};
use std::path::{Path, PathBuf};

/// Folders of the workspace, seen from this crate. The tool itself only prints.
const FOLDERS: [&str; 13] = [
    "../../scenes",
    "../../golden",
    "../../hdl",
    "../codegen",
    "../compiled",
    "../costs",
    "../estimate",
    "../gates",
    "../lanes",
    "../logic",
    "../machine",
    "../memory",
    "src",
];

fn main() {
    let mut files = vec![PathBuf::from("../../Cargo.lock")];
    for folder in FOLDERS {
        println!("cargo::rerun-if-changed={folder}");
        collect(Path::new(folder), &mut files);
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

fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            collect(&path, files);
        } else {
            files.push(path);
        }
    }
}
