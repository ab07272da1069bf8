//! The version that the tool prints: that of its package, with the commit of the sources where they are a git repository.

use std::path::{Path, PathBuf};
use std::process::Command;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let git = |words: &[&str]| {
        let output = Command::new("git").arg("-C").arg(&root).args(words).output().ok()?;
        let text = String::from_utf8(output.stdout).ok().filter(|_| output.status.success())?;
        Some(text.trim().to_owned())
    };
    // Sources that were unpacked inside another repository are not of its commit.
    let is_own = git(&["rev-parse", "--show-toplevel"])
        .and_then(|top| Some(Path::new(&top).canonicalize().ok()? == root.canonicalize().ok()?));
    let commit =
        git(&["rev-parse", "--short=12", "HEAD"]).filter(|_| is_own == Some(true)).unwrap_or_default();
    println!("cargo::rustc-env=DUALSPLIT_COMMIT={commit}");
    let of_commit = if commit.is_empty() { String::new() } else { format!(" ({commit})") };
    println!("cargo::rustc-env=DUALSPLIT_VERSION={}{of_commit}", env!("CARGO_PKG_VERSION"));
    if commit.is_empty() {
        return;
    }
    // Each commit and each checkout adds a line to the first; the second serves where git keeps no log.
    for name in ["logs/HEAD", "HEAD"] {
        let path = git(&["rev-parse", "--git-path", name]).map(|path| root.join(PathBuf::from(path)));
        if let Some(path) = path.filter(|path| path.exists()) {
            println!("cargo::rerun-if-changed={}", path.display());
        }
    }
}
