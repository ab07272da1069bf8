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

/// Exit code 2 and one line on stderr, if anybody still reads it.
fn fail(error: &anyhow::Error) -> ExitCode {
    use std::io::Write;
    let _ = writeln!(std::io::stderr(), "error: {error:#}");
    ExitCode::from(2)
}
