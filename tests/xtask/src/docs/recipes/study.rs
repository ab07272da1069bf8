//! The tables of the study at full size, from the files that its runs left in docs/study.

use super::super::workplace::Workplace;
use super::{count, table as markdown};
use crate::behaviour::filter;
use crate::workspace::root;
use anyhow::{Context, bail, ensure};
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;

const FOLDER: &str = "docs/study";
/// The scenes in the order of the catalogue, in which everything shows them.
const SCENES: [&str; 6] = ["atrium", "statue", "courtyard", "powerplant", "vegetation", "hairball"];
const STRUCTURES: [&str; 8] = ["dst", "dst-sw", "bvh2", "bvh4", "bvh8", "bvh2+", "bvh4+", "bvh8+"];

/// A run, by the names of its columns.
struct Run(BTreeMap<String, String>);

impl Run {
    fn text(&self, column: &str) -> anyhow::Result<&str> {
        self.0.get(column).map(String::as_str).with_context(|| format!("no column {column}"))
    }

    fn number(&self, column: &str) -> anyhow::Result<f64> {
        let text = self.text(column)?;
        text.parse().with_context(|| format!("{column}: {text} is no number"))
    }

    fn is(&self, wanted: &[(&str, &str)]) -> bool {
        wanted.iter().all(|(column, text)| self.0.get(*column).is_some_and(|found| found == text))
    }

    /// The number of column `column` with `decimals` decimals.
    fn fixed(&self, column: &str, decimals: usize) -> anyhow::Result<String> {
        Ok(format!("{:.decimals$}", self.number(column)?))
    }

    /// The number of column `column` per ray.
    fn per_ray(&self, column: &str) -> anyhow::Result<f64> {
        Ok(self.number(column)? / self.number("rays")?)
    }
}

/// All runs of the study.
struct Runs(Vec<Run>);

impl Runs {
    fn read() -> anyhow::Result<Self> {
        let [header, lines @ ..] = &records("study.csv")?[..] else { bail!("study.csv: no header") };
        let run = |line: &Vec<String>| Run(header.iter().cloned().zip(line.iter().cloned()).collect());
        Ok(Self(lines.iter().map(run).collect()))
    }

    /// The run with these words in these columns.
    fn find(&self, wanted: &[(&str, &str)]) -> anyhow::Result<&Run> {
        self.0.iter().find(|run| run.is(wanted)).with_context(|| format!("no run has {wanted:?}"))
    }

    fn main(&self, scene: &str, test: &str, structure: &str) -> anyhow::Result<&Run> {
        self.find(&[("series", "main"), ("scene", scene), ("test", test), ("structure", structure)])
    }
}

/// The records of a CSV file, without quotes.
fn records(file: &str) -> anyhow::Result<Vec<Vec<String>>> {
    let path = root().join(FOLDER).join(file);
    let text = fs::read_to_string(&path).with_context(|| path.display().to_string())?;
    let cell = |cell: &str| cell.trim_matches('"').replace("\"\"", "\"");
    Ok(text.lines().map(|line| filter::cells(line).into_iter().map(cell).collect()).collect())
}

/// The table that `what` names.
pub fn table(what: &[&str]) -> anyhow::Result<String> {
    match what {
        ["ratios", test, quantity] => ratios(&Runs::read()?, test, quantity),
        ["components", scene] => components(&Runs::read()?, scene),
        ["multiprocessors"] => multiprocessors(&Runs::read()?),
        ["words", scene] => words(&Runs::read()?, scene),
        ["ray", scenes @ ..] => ray(&Runs::read()?, scenes),
        ["claims"] => claims(),
        _ => bail!(
            "the study's tables are ratios TEST QUANTITY, components SCENE, multiprocessors, words SCENE, ray SCENE... and claims"
        ),
    }
}

/// The time or the energy of all structures in multiples of `dst`.
fn ratios(runs: &Runs, test: &str, quantity: &str) -> anyhow::Result<String> {
    let (column, unit, decimals) = match quantity {
        "time" => ("frame_ms", "dst ms", 3),
        "energy" => ("energy_mj", "dst mJ", 1),
        _ => bail!("the quantities are time and energy"),
    };
    let row = |scene: &&str| {
        let dst = runs.main(scene, test, STRUCTURES[0])?;
        let mut row = vec![(*scene).to_owned()];
        for column in ["triangles", "rays"] {
            row.push(count(dst.text(column)?.parse()?));
        }
        row.push(dst.fixed(column, decimals)?);
        for structure in &STRUCTURES[1..] {
            let ratio = runs.main(scene, test, structure)?.number(column)? / dst.number(column)?;
            row.push(format!("{ratio:.2}"));
        }
        Ok(row)
    };
    let rows = SCENES.iter().map(row).collect::<anyhow::Result<Vec<_>>>()?;
    let header = [&["scene", "triangles", "rays", unit][..], &STRUCTURES[1..]].concat();
    Ok(markdown(&header, rows))
}

/// Energy by component and waits of all structures in `scene`.
fn components(runs: &Runs, scene: &str) -> anyhow::Result<String> {
    const COLUMNS: [(&str, &str, usize); 11] = [
        ("time ms", "frame_ms", 3),
        ("DRAM mJ", "dram_mj", 2),
        ("cache mJ", "cache_mj", 2),
        ("compute mJ", "compute_mj", 2),
        ("issue %", "issue_pct", 0),
        ("data %", "data_pct", 0),
        ("units %", "units_pct", 0),
        ("memory %", "memory_pct", 0),
        ("L1 hit %", "l1_hit_pct", 1),
        ("L2 hit %", "l2_hit_pct", 1),
        ("DRAM GB/s", "dram_gb_s", 0),
    ];
    let row = |structure: &&str| {
        let run = runs.main(scene, "path", structure)?;
        let mut row = vec![(*structure).to_owned(), format!("{:.2}", run.number("node_bytes")? / 1e6)];
        for (_, column, decimals) in COLUMNS {
            row.push(run.fixed(column, decimals)?);
        }
        Ok(row)
    };
    let header = [&["structure", "tree MB"][..], &COLUMNS.map(|(heading, ..)| heading)].concat();
    Ok(markdown(&header, STRUCTURES.iter().map(row).collect::<anyhow::Result<Vec<_>>>()?))
}

/// Time and energy of the atrium by number of multiprocessors.
fn multiprocessors(runs: &Runs) -> anyhow::Result<String> {
    let counts = ["1", "2", "4", "8", "16", "32", "64"];
    series(runs, "atrium", "tms", ("load_words", "1"), &counts)
}

/// Time and energy of `scene` by the words of a load.
fn words(runs: &Runs, scene: &str) -> anyhow::Result<String> {
    series(runs, scene, "load_words", ("tms", "32"), &["1", "2", "4", "line"])
}

fn series(
    runs: &Runs,
    scene: &str,
    column: &str,
    other: (&str, &str),
    values: &[&str],
) -> anyhow::Result<String> {
    let row = |structure: &&str| {
        let mut row = vec![(*structure).to_owned()];
        for (quantity, decimals) in [("frame_ms", 3), ("energy_mj", 1)] {
            for value in values {
                let run =
                    [("scene", scene), ("test", "path"), ("structure", structure), (column, value), other];
                row.push(runs.find(&run)?.fixed(quantity, decimals)?);
            }
        }
        Ok(row)
    };
    let headings =
        ["ms", "mJ"].iter().flat_map(|unit| values.iter().map(move |value| format!("{value} {unit}")));
    let header: Vec<String> = [scene.to_owned()].into_iter().chain(headings).collect();
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    Ok(markdown(&header, STRUCTURES.iter().map(row).collect::<anyhow::Result<Vec<_>>>()?))
}

/// What a ray of path tracing costs in `scenes`.
fn ray(runs: &Runs, scenes: &[&str]) -> anyhow::Result<String> {
    const SHOWN: [&str; 4] = ["dst", "bvh2", "bvh4", "dst-sw"];
    /// Threads of a multiprocessor.
    const THREADS: f64 = 32.0;
    type Of = fn(&Run) -> anyhow::Result<f64>;
    fn thread_cycles(run: &Run) -> anyhow::Result<f64> {
        Ok(run.per_ray("cycles")? * run.number("tms")? * THREADS)
    }
    const ROWS: [(&str, Of); 8] = [
        ("instructions", |run| run.per_ray("instructions")),
        ("of these loads of memory", |run| run.per_ray("loads")),
        ("L1 misses", |run| Ok(run.per_ray("loads")? * (1.0 - run.number("l1_hit_pct")? / 100.0))),
        ("operations of the pipeline", |run| run.per_ray("pipeline_operations")),
        ("thread-cycles", thread_cycles),
        ("of these waiting for data", |run| Ok(thread_cycles(run)? * run.number("data_pct")? / 100.0)),
        ("for a cache bank or a full memory queue", |run| {
            Ok(thread_cycles(run)? * run.number("memory_pct")? / 100.0)
        }),
        ("for a unit", |run| Ok(thread_cycles(run)? * run.number("units_pct")? / 100.0)),
    ];
    let columns: Vec<(&str, &str)> =
        scenes.iter().flat_map(|scene| SHOWN.map(|structure| (*scene, structure))).collect();
    let row = |(name, of): &(&str, Of)| {
        let mut row = vec![(*name).to_owned()];
        for (scene, structure) in &columns {
            let value = of(runs.main(scene, "path", structure)?)?;
            row.push(if value == 0.0 && name.contains("pipeline") {
                "-".to_owned()
            } else {
                count(value.round() as u64)
            });
        }
        Ok(row)
    };
    let headings = columns.iter().map(|(scene, structure)| format!("{scene} {structure}"));
    let header: Vec<String> = ["path tracing, one ray".to_owned()].into_iter().chain(headings).collect();
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    Ok(markdown(&header, ROWS.iter().map(row).collect::<anyhow::Result<Vec<_>>>()?))
}

/// The claims of the paper beside the results.
fn claims() -> anyhow::Result<String> {
    let all = records("comparison.csv")?;
    ensure!(all.len() > 1, "comparison.csv: no claims");
    let line = |cells: &Vec<String>| format!("| {} |\n", cells.join(" | "));
    let rows: String = all[1..].iter().map(line).collect();
    Ok(line(&all[0]) + &format!("|{}\n", "---|".repeat(all[0].len())) + &rows)
}

/// The keys that the study of sensitivity varies, with their values. They do not depend on its size.
pub fn ranges(workplace: &mut Workplace<'_>) -> anyhow::Result<String> {
    let document: Value = serde_json::from_str(&workplace.output(SMALL_SENSITIVITY)?)?;
    let rows = document["ranges"].as_array().context("the document has no ranges")?;
    let row = |row: &Value| {
        let values: Vec<&str> = row["values"].as_array()?.iter().filter_map(Value::as_str).collect();
        Some(format!("| `{}` | {} |\n", row["key"].as_str()?, values.join(", ")))
    };
    let rows = rows.iter().map(row).collect::<Option<String>>().context("a range has a key and values")?;
    Ok(format!("| key | values |\n|---|---|\n{rows}"))
}

/// The command of which docs/study/sensitivity.md has the digest too.
const SMALL_SENSITIVITY: &str = "dualsplit study --sensitivity --preset small --scene vegetation --quality fast --machines 8 --out study --json";
