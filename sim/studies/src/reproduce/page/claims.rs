//! The claims of the paper: beside the results of this job, and beside those at full size, which docs/study keeps.

use super::super::stages::Outcome;
use super::{cell, rows};
use crate::study::comparison::{Claim, of_rows};
use crate::study::row::Row;
use std::collections::BTreeMap;
use view::report::{Item, Section, Table};

/// The runs at full size.
const FULL_SIZE: &str = include_str!("../../../../../docs/study/study.csv");

/// A claim with its name and its four texts.
struct Line {
    name: String,
    claim: String,
    published: String,
    ours: String,
    holds: String,
}

fn full_size() -> Vec<Line> {
    let rows = csv::Reader::from_reader(FULL_SIZE.as_bytes()).into_deserialize();
    let rows: Vec<Row> = rows.map(|row| row.expect("the study wrote the file")).collect();
    let line = |claim: Claim| {
        let Claim { name, claim, published, ours, holds } = claim;
        Line { name, claim, published, ours, holds: holds.to_owned() }
    };
    of_rows(&rows).into_iter().map(line).collect()
}

fn here(study: &Outcome) -> Vec<Line> {
    let text = |value: &serde_json::Value, key: &str| cell(&value[key]);
    let claims = rows(&study.report["comparison"]).iter();
    let line = |claim| Line {
        name: text(claim, "name"),
        claim: text(claim, "claim"),
        published: text(claim, "published"),
        ours: text(claim, "ours"),
        holds: text(claim, "holds"),
    };
    claims.map(line).collect()
}

/// All claims with what this job found, and, unless it is of full size itself, what the study at full size found.
pub fn table(study: &Outcome, is_full_size: bool) -> Table {
    let caption = "What the paper says, and whether it holds";
    let here = here(study);
    let table = if is_full_size {
        let lines = here.into_iter().map(|line| [line.claim, line.published, line.ours, line.holds]);
        Table::new(caption, ["claim", "published", "here", "holds"], lines)
    } else {
        let full: BTreeMap<String, String> =
            full_size().into_iter().map(|line| (line.name, line.holds)).collect();
        let lines = here.into_iter().map(|line| {
            let at_full_size = full.get(&line.name).cloned().unwrap_or_default();
            [line.claim, line.published, line.ours, line.holds, at_full_size]
        });
        Table::new(caption, ["claim", "published", "here", "holds here", "at full size"], lines)
    };
    table.from("../study/comparison.csv", &study.command)
}

/// The section with the claims judged at full size.
pub fn at_full_size() -> Section {
    let lines = full_size().into_iter().map(|line| [line.claim, line.published, line.ours, line.holds]);
    let table = Table::new("The claims at full size", ["claim", "published", "at full size", "holds"], lines);
    Section {
        title: "The study at full size".into(),
        text: vec![
            "All triangles, 256 x 256 pixels, 32 multiprocessors. These are kept results, which this job does not make; \
             docs/study in the repository has all runs, and says why they are what they are."
                .into(),
        ],
        items: vec![Item::Table(table.from("", "dualsplit study --preset paper --quality medium --out study"))],
    }
}

/// The four ratios that matter most, with their ranges over the scenes: here, at full size, and as published.
pub fn ratios(study: Option<&Outcome>) -> Table {
    const SHOWN: [(&str, &str); 4] = [
        ("raycast-time-bvh2", "frame time, ray casting"),
        ("raycast-energy-bvh2", "energy, ray casting"),
        ("path-time-bvh2", "frame time, path tracing"),
        ("path-energy-bvh2", "energy, path tracing"),
    ];
    let (here, full) = (study.map(here).unwrap_or_default(), full_size());
    let of = |lines: &[Line], name: &str, text: fn(&Line) -> &str| {
        lines.iter().find(|line| line.name == name).map_or(String::new(), |line| multiples(text(line)))
    };
    let row = |(name, quantity): (&str, &str)| {
        let found = study.map(|_| of(&here, name, |line| &line.ours));
        let others = [of(&full, name, |line| &line.ours), of(&full, name, |line| &line.published)];
        [quantity.to_owned()].into_iter().chain(found).chain(others).collect()
    };
    let header =
        ["quantity"].into_iter().chain(study.map(|_| "this run")).chain(["at full size", "the paper"]);
    Table {
        caption: "bvh2 in multiples of dst: least and greatest of all scenes".to_owned(),
        header: header.map(str::to_owned).collect(),
        rows: SHOWN.map(row).to_vec(),
        ..Table::default()
    }
}

/// Changes in percent from one structure to another, such as `-2 .. -25 %`, as the latter's multiples of the former.
fn multiples(changes: &str) -> String {
    let numbers = changes.trim_end_matches('%').split("..").map(|text| text.trim().parse::<f64>());
    let ratios: Result<Vec<String>, _> =
        numbers.map(|change| Ok(format!("{:.2}", 1.0 / (1.0 + change? / 100.0)))).collect();
    ratios.map_or_else(|_: std::num::ParseFloatError| changes.to_owned(), |ratios| ratios.join(" to "))
}

/// Where the results at full size differ from the paper, in words.
pub fn differences() -> String {
    let full = full_size();
    let count = |holds: &str| full.iter().filter(|line| line.holds == holds).count();
    let not: Vec<String> = full
        .iter()
        .filter(|line| line.holds == "no" || line.holds == "undecided")
        .map(|line| format!("{}: {} ({})", line.claim, line.ours, line.holds))
        .collect();
    format!(
        "of {} claims of the paper, {} hold at full size, {} hold in part, and {} do not. These are: {}.",
        full.len(),
        count("yes"),
        count("partly"),
        not.len(),
        not.join("; ")
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn changes_become_multiples() {
        assert_eq!(multiples("-2 .. -25 %"), "1.02 to 1.33");
        assert_eq!(multiples("+1.0 .. -50.0 %"), "0.99 to 2.00");
        assert_eq!(multiples("no data"), "no data");
    }

    #[test]
    fn claims_stand_beside_those_at_full_size() {
        let name = &full_size()[0].name;
        let report = json!({"comparison": [{"name": name, "claim": "in other words", "published": "p", "ours": "-50 .. -75 %", "holds": "yes"}]});
        let study = Outcome { command: "dualsplit study".into(), report, difference: false, seconds: 1.0 };
        assert_eq!(table(&study, false).rows[0][3..], ["yes".to_owned(), full_size()[0].holds.clone()]);
        let scaling =
            json!({"comparison": [{"name": "speed-up-by-tms", "claim": "speed-up from 1 to 8 TMs"}]});
        let scaled = Outcome { report: scaling, ..study.clone() };
        assert!(
            !table(&scaled, false).rows[0][4].is_empty(),
            "a claim about another number of multiprocessors"
        );
        assert_eq!(table(&study, true).rows[0].len(), 4);
        let ratios = ratios(Some(&study));
        assert_eq!(ratios.rows[0][1], "2.00 to 4.00");
        assert!(
            ratios.rows.iter().all(|row| row[2..].iter().all(|cell| cell.contains(" to "))),
            "{:?}",
            ratios.rows
        );
        assert_eq!(super::ratios(None).rows[0].len(), 3, "without a study there is no column of this run");
        assert!(differences().contains("claims of the paper"));
    }
}
