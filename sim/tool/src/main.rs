//! The tool `dualsplit`.

mod cli;
mod commands;
mod console;

use clap::Parser;
use std::process::ExitCode;

fn main() -> ExitCode {
    console::end_at_signals();
    base::guard::watch();
    let mut cli = cli::Cli::parse();
    cli.global.words = std::env::args_os().skip(1).collect();
    let command = console::command(cli.global.words.iter().cloned());
    match commands::run(&cli) {
        Ok(report) => match console::print(&report.render(cli.global.json, &command)) {
            Ok(()) if report.difference => ExitCode::from(1),
            Ok(()) => ExitCode::SUCCESS,
            Err(error) => fail(&error),
        },
        Err(error) => fail(&error),
    }
}

/// Writes one line to stderr, and returns exit code 2.
fn fail(error: &anyhow::Error) -> ExitCode {
    console::say(&format!("error: {}", console::message(error)));
    ExitCode::from(2)
}
