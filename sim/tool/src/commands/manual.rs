//! `dualsplit manual`: shell completions and man pages.

use crate::cli::{Cli, Global, ManualArgs};
use crate::console::Report;
use clap::CommandFactory;
use clap_complete::Shell;
use serde::Serialize;
use studies::artifacts::Artifacts;
use studies::input::display_all;

#[derive(Serialize)]
struct Document {
    shells: Vec<String>,
}

/// The shells whose completions are written, with the names of their files.
const SHELLS: [(Shell, &str); 4] = [
    (Shell::Bash, "dualsplit.bash"),
    (Shell::Zsh, "_dualsplit"),
    (Shell::Fish, "dualsplit.fish"),
    (Shell::PowerShell, "dualsplit.ps1"),
];

pub fn run(args: &ManualArgs, global: &Global) -> anyhow::Result<Report> {
    global.without_seed("the manual")?;
    let mut command = Cli::command();
    command.build();
    let mut artifacts = Artifacts::create(&args.folder, global.force)?;
    for (shell, name) in SHELLS {
        let mut script = vec![];
        clap_complete::generate(shell, &mut command, "dualsplit", &mut script);
        artifacts.write(&format!("completions/{name}"), &script)?;
    }
    pages(&command, "dualsplit", &mut artifacts)?;
    let files = display_all(&artifacts.finish()?);
    let shells = SHELLS.map(|(shell, _)| shell.to_string()).to_vec();
    Ok(Report::new(&Document { shells }, files.join("\n"), files))
}

/// Writes the pages of `command`, which is called `name`, and of its commands.
fn pages(command: &clap::Command, name: &str, artifacts: &mut Artifacts) -> anyhow::Result<()> {
    let mut page = vec![];
    clap_mangen::Man::new(command.clone()).render(&mut page)?;
    artifacts.write(&format!("man/{name}.1"), &page)?;
    for inner in command.get_subcommands().filter(|inner| !inner.is_hide_set() && inner.get_name() != "help")
    {
        pages(inner, &format!("{name}-{}", inner.get_name()), artifacts)?;
    }
    Ok(())
}
