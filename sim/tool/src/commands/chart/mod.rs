//! `dualsplit chart`: charts of cost against error.

pub mod fidelity;
pub mod precision;

use crate::cli::{ChartArgs, ChartKind, Global};
use crate::console::Report;

pub fn run(args: &ChartArgs, global: &Global) -> anyhow::Result<Report> {
    match &args.chart {
        ChartKind::Precision(args) => precision::run(args, global),
        ChartKind::Fidelity(args) => fidelity::run(args, global),
    }
}
