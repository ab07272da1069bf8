//! `cargo xtask quick`: formats, lints, and runs the tests that need neither external tools nor volume.

use crate::workspace::{LONG_TESTS, NO_TOOL_MISSING, cargo, succeeds};
use std::process::Stdio;
use std::time::Instant;

/// Runs the steps until one fails; whether none did.
pub fn run() -> anyhow::Result<bool> {
    // No tests in documentation: each of them is linked on its own.
    let test = if has_nextest() { "nextest run --workspace --tests" } else { "test --workspace --tests" };
    let steps = ["fmt --all", "clippy --workspace --all-targets -- -D warnings", test];
    let start = Instant::now();
    for line in steps {
        if !step(line)? {
            eprintln!("quick: cargo {line} failed");
            return Ok(false);
        }
    }
    eprintln!("quick: {:.1} s", start.elapsed().as_secs_f64());
    Ok(true)
}

fn step(line: &str) -> anyhow::Result<bool> {
    eprintln!("quick: cargo {line}");
    let start = Instant::now();
    let mut command = cargo(line);
    command.env_remove(LONG_TESTS).env_remove(NO_TOOL_MISSING);
    let good = succeeds(command)?;
    eprintln!("quick: cargo {line}: {:.1} s", start.elapsed().as_secs_f64());
    Ok(good)
}

fn has_nextest() -> bool {
    let mut command = cargo("nextest --version");
    command.stdout(Stdio::null()).stderr(Stdio::null());
    succeeds(command).unwrap_or(false)
}
