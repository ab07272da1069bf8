//! Where the workspace is, its Cargo, and folders that are removed again.

use anyhow::{Context, ensure};
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use tempfile::TempDir;

/// Set where the long tests are wanted.
pub const LONG_TESTS: &str = "DUALSPLIT_LONG";
/// Set where a missing tool is a failure.
pub const NO_TOOL_MISSING: &str = "CI";

/// The root of the workspace.
pub fn root() -> &'static Path {
    // Of `tests/xtask`.
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).expect("the crate is two folders below the root")
}

/// The target folder that this program was built into.
pub fn target() -> anyhow::Result<PathBuf> {
    // Of `target/debug/xtask`.
    let program = std::env::current_exe().context("where this program is")?;
    let folder = program.ancestors().nth(2).context("this program is not in a target folder")?;
    Ok(folder.to_owned())
}

/// Cargo in the root of the workspace, with the words of `line` as arguments. What it prints goes to stderr.
pub fn cargo(line: &str) -> Command {
    let program = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(program);
    command.args(line.split_whitespace()).current_dir(root()).stdin(Stdio::null()).stdout(io::stderr());
    command
}

/// Whether `command` succeeds.
pub fn succeeds(mut command: Command) -> anyhow::Result<bool> {
    let status = command.status().with_context(|| format!("{:?} does not start", command.get_program()))?;
    Ok(status.success())
}

/// Runs `cargo` with the words of `line`, as `change` makes it.
///
/// An error if it fails.
pub fn must_succeed(line: &str, change: impl FnOnce(&mut Command)) -> anyhow::Result<()> {
    let mut command = cargo(line);
    change(&mut command);
    ensure!(succeeds(command)?, "cargo {line}: failed");
    Ok(())
}

/// An empty folder below the target folder, of a name that begins with `name`. It goes when this is dropped.
pub fn scratch(name: &str) -> anyhow::Result<TempDir> {
    let target = target()?;
    tempfile::Builder::new()
        .prefix(&format!("{name}-"))
        .tempdir_in(&target)
        .with_context(|| format!("{}: cannot make a folder in it", target.display()))
}
