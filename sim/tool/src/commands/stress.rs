//! `dualsplit stress`: every method, judged by the exact oracle on inputs made to break it.

use crate::cli::{Global, StressArgs};
use crate::console::{Bars, Report, fixed, table};
use studies::stress::study::{self, Options, Stress};

pub fn run(args: &StressArgs, global: &Global) -> anyhow::Result<Report> {
    let options = Options {
        rays: args.rays,
        aimed: args.aimed,
        searches: args.searches,
        methods: args.method.clone(),
        pictures: args.pictures,
        out: args.out.clone(),
        seed: global.seed(),
        force: global.force,
    };
    let stress = study::run(&options, &Bars::new(global.quiet))?;
    let mut report =
        Report::new(&stress, text(&stress), stress.artifacts.clone()).in_folder(args.out.clone());
    report.difference = stress.broken;
    Ok(report)
}

fn text(stress: &Stress) -> String {
    let header = [
        "method",
        "rays",
        "false misses",
        "false hits",
        "wrong nearest",
        "NaN",
        "lost by traversal",
        "wrong by triangle test",
        "excess visits",
        "least slack (ulps)",
        "worst case",
    ];
    let rows = stress.sums.iter().map(|(method, sum)| {
        [
            method.to_string(),
            sum.rays.to_string(),
            sum.false_misses.to_string(),
            sum.false_hits.to_string(),
            sum.wrong_nearest.to_string(),
            sum.nan.to_string(),
            sum.lost.to_string(),
            sum.triangle_test.to_string(),
            format!("{} of {}", sum.excess_visits, sum.visit_rays),
            sum.least_slack_ulps.map(|slack| fixed(slack, 1)).unwrap_or_default(),
            sum.case.clone(),
        ]
    });
    let mut text = table(header, rows);
    text += "\nFalse misses, false hits and wrong nearest are against the exact answer; lost by traversal against testing\n\
             every triangle with the same test, whose own errors are the next column. Each case is in stress.csv.\n";
    text
}
