//! The tool `dualsplit`.

mod cli;
mod commands;
mod console;

use clap::Parser;
use std::process::ExitCode;

fn main() -> ExitCode {
    let cli = cli::Cli::parse();
    match commands::run(&cli) {
        Ok(report) => match console::print(&report.render(cli.global.json)) {
            Ok(()) if report.difference => ExitCode::from(1),
            Ok(()) => ExitCode::SUCCESS,
            Err(error) => fail(&error.into()),
        },
        Err(error) => fail(&error),
    }
}

/// Writes one line to stderr, unless that is closed, and returns exit code 2.
fn fail(error: &anyhow::Error) -> ExitCode {
    use std::io::Write;
    let _ = writeln!(std::io::stderr(), "error: {error:#}");
    ExitCode::from(2)
}
