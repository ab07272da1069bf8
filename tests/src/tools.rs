//! Finds and runs the Verilog tools.

use std::path::Path;
use std::process::Command;

/// Whether a tool can be run. Without it a test says so and passes; with `CI` set it fails instead.
///
/// # Panics
/// Where `CI` is set and the tool is missing.
#[must_use]
pub fn available(tool: &str) -> bool {
    let found = Command::new(tool).arg("-V").output().is_ok();
    assert!(found || std::env::var_os("CI").is_none(), "{tool} is missing, and CI is set");
    if !found {
        println!("skipped: {tool} is not installed");
    }
    found
}

/// Runs a command in a folder; returns what it printed, on both streams.
///
/// # Errors
/// The same text when it fails.
///
/// # Panics
/// If it cannot be started.
pub fn run(folder: &Path, command: &str, arguments: &[&str]) -> Result<String, String> {
    let output = Command::new(command).args(arguments).current_dir(folder).output().unwrap();
    let text =
        String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr);
    if output.status.success() { Ok(text) } else { Err(text) }
}
