//! `cargo xtask kernels`: compiles the machine's programs.

use crate::workspace::root;
use anyhow::{Context, ensure};
use lexopt::prelude::*;
use std::fs;
use std::process::Command;

/// The folder of sources and listings.
const FOLDER: &str = "sim/machine/kernels";
/// Options of the compiler: MIPS32 with all 32 single-precision registers, no fused multiply-add, no `errno`.
const OPTIONS: &str = include_str!("../../../sim/machine/kernels/clang.options");
/// Listings with their sources and what is defined for each.
const LISTINGS: &str = include_str!("../../../sim/machine/kernels/listings.txt");

// What is kept of the compiler's output has one definition, and this crate does not link the machine.
#[path = "../../../sim/machine/src/kernels/tidy.rs"]
mod tidy;

/// Reads what follows the command's name: whether listings are only compared.
pub fn parse(mut arguments: lexopt::Parser) -> anyhow::Result<bool> {
    let mut check = false;
    while let Some(argument) = arguments.next()? {
        match argument {
            Long("check") => check = true,
            other => return Err(other.unexpected().into()),
        }
    }
    Ok(check)
}

/// Compiles all programs, and writes their listings or compares them with those that are there; whether none differs.
pub fn run(check: bool) -> anyhow::Result<bool> {
    let mut good = true;
    for line in LISTINGS.lines().filter(|line| !line.starts_with('#')) {
        let [name, source, defined @ ..] = &line.split_whitespace().collect::<Vec<_>>()[..] else { continue };
        let file = root().join(FOLDER).join(format!("{name}.s"));
        let listing = compile(source, defined)?;
        if !check {
            fs::write(&file, listing).with_context(|| format!("{}: cannot write", file.display()))?;
        } else if fs::read_to_string(&file).with_context(|| format!("{}: cannot read", file.display()))?
            != listing
        {
            println!("{FOLDER}/{name}.s is not what {source} gives: run `cargo xtask kernels`");
            good = false;
        }
    }
    Ok(good)
}

fn compile(source: &str, defined: &[&str]) -> anyhow::Result<String> {
    let clang = std::env::var_os("CLANG").unwrap_or_else(|| "clang-14".into());
    let output = Command::new(&clang)
        .current_dir(root().join(FOLDER))
        .args(OPTIONS.split_whitespace())
        .args(defined.iter().map(|name| format!("-D{name}")))
        .args(["-o", "-", source])
        .output()
        .with_context(|| format!("{} does not start: install Debian's package clang-14", clang.display()))?;
    ensure!(output.status.success(), "{source}: {}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8(output.stdout).context("the compiler's output is no text")?;
    Ok(text.lines().filter_map(tidy::statement).collect())
}
