//! Packages of Python: simulation drivers and linters.

use std::process::Command;

/// Whether `python3` has the module `module`. If it has not, prints a message, or panics where `CI` is set.
///
/// # Panics
/// Where `CI` is set and the module is missing.
#[must_use]
pub fn has_module(module: &str) -> bool {
    let imported = Command::new("python3").args(["-c", &format!("import {module}")]).output();
    let found = imported.is_ok_and(|output| output.status.success());
    assert!(found || std::env::var_os("CI").is_none(), "python3 has no module {module}, and CI is set");
    if !found {
        println!("skipped: python3 has no module {module}");
    }
    found
}
