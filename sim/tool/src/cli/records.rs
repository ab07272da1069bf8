//! Arguments of the commands that make earlier results again and write the manual.

use clap::Args;
use std::path::PathBuf;

#[derive(Args, Debug)]
pub struct RerunArgs {
    /// The folder of results, or its rerun.json.
    pub folder: PathBuf,
}

#[derive(Args, Debug)]
pub struct ManualArgs {
    /// The folder to write.
    pub folder: PathBuf,
}
