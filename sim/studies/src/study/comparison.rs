//! Our results beside the published ones.
//!
//! The published results are those of D. Lin, E. Vasiou, C. Yuksel, D. Kopta, E. Brunvand, "Hardware-Accelerated Dual-Split
//! Trees", HPG 2020, as presented there.

use super::correlation::{Correlation, Direction};
use super::jobs::Series;
use super::row::{Row, of_series, scenes};
use serde::Serialize;

/// A claim of the paper, with our result.
#[derive(Clone, Debug, Serialize)]
pub struct Claim {
    /// Its name, which does not depend on the study's size.
    pub name: String,
    /// The claim in words.
    pub claim: String,
    /// The paper's result.
    pub published: String,
    /// The study's result.
    pub ours: String,
    /// `yes`, `partly` where some scenes agree, `no`, `undecided` where chance explains the result as well, or `-` without data.
    pub holds: &'static str,
}

/// Least and greatest change in percent over all scenes.
struct Range {
    least: f64,
    most: f64,
}

/// A quantity of a row.
type Of = fn(&Row) -> f64;

struct Table<'a> {
    rows: &'a [Row],
}

impl Table<'_> {
    fn scenes(&self) -> Vec<&str> {
        scenes(self.rows)
    }

    fn value(&self, scene: &str, test: &str, structure: &str, of: fn(&Row) -> f64) -> Option<f64> {
        let found = self.rows.iter().find(|r| r.scene == scene && r.test == test && r.structure == structure);
        found.map(of)
    }

    /// Change of the quantity `of` from `base` to `structure` in percent, for each scene.
    fn changes(&self, test: &str, structure: &str, base: &str, of: fn(&Row) -> f64) -> Vec<f64> {
        let change = |scene: &str| {
            let base = self.value(scene, test, base, of)?;
            Some(100.0 * (self.value(scene, test, structure, of)? / base - 1.0))
        };
        self.scenes().into_iter().filter_map(change).collect()
    }

    /// The number of scenes in which `structure` has the least `of` among the structures `among`, and the number of all scenes.
    fn least(&self, test: &str, structure: &str, among: &[&str], of: fn(&Row) -> f64) -> (usize, usize) {
        let scenes = self.scenes();
        let is_least = |scene: &&str| {
            let own = self.value(scene, test, structure, of)?;
            let others = among.iter().filter(|other| **other != structure);
            // A scene counts only if all of these structures were simulated.
            let values: Option<Vec<f64>> = others.map(|other| self.value(scene, test, other, of)).collect();
            Some(values?.iter().all(|value| own <= *value))
        };
        let known: Vec<bool> = scenes.iter().filter_map(is_least).collect();
        (known.iter().filter(|least| **least).count(), known.len())
    }
}

const STRUCTURES: [&str; 8] = ["dst", "dst-sw", "bvh2", "bvh4", "bvh8", "bvh2+", "bvh4+", "bvh8+"];

fn time(row: &Row) -> f64 {
    row.frame_ms
}

fn energy(row: &Row) -> f64 {
    row.energy_mj
}

fn percent(changes: &[f64]) -> String {
    if changes.is_empty() {
        return "no data".to_owned();
    }
    let least = changes.iter().copied().fold(f64::INFINITY, f64::min);
    let most = changes.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    format!("{most:+.1} .. {least:+.1} %")
}

/// Whether the changes lie in the published range.
fn within(changes: &[f64], published: &Range) -> &'static str {
    let inside = changes.iter().filter(|c| **c >= published.least && **c <= published.most).count();
    judge(inside, changes.len())
}

fn judge(good: usize, all: usize) -> &'static str {
    match (good, all) {
        (_, 0) => "-",
        _ if good == all => "yes",
        (0, _) => "no",
        _ => "partly",
    }
}

/// All claims.
pub fn compare(rows: &[Row], scaling: &[Row]) -> Vec<Claim> {
    let table = Table { rows };
    let mut claims = vec![];
    let mut range = |test: &str, base: &str, what: &str, of: fn(&Row) -> f64, published: Range| {
        let changes = table.changes(test, "dst", base, of);
        claims.push(Claim {
            name: format!("{test}-{what}-{base}"),
            claim: format!("{test}: {what}, dst against {base}"),
            published: format!("{:+.0} .. {:+.0} %", published.most, published.least),
            ours: percent(&changes),
            holds: within(&changes, &published),
        });
    };
    range("raycast", "bvh2", "time", time, Range { least: -25.0, most: -2.0 });
    range("raycast", "bvh2", "energy", energy, Range { least: -41.0, most: -23.0 });
    range("raycast", "dst-sw", "time", time, Range { least: -34.0, most: -20.0 });
    range("raycast", "dst-sw", "energy", energy, Range { least: -28.0, most: -17.0 });
    range("path", "bvh2", "time", time, Range { least: -31.0, most: -21.0 });
    range("path", "bvh2", "energy", energy, Range { least: -38.0, most: -26.0 });
    range("path", "dst-sw", "time", time, Range { least: -34.0, most: 0.0 });
    range("path", "dst-sw", "energy", energy, Range { least: -24.0, most: 0.0 });
    let mut count = |name: &str, claim: &str, published: &str, (good, all): (usize, usize)| {
        claims.push(Claim {
            name: name.to_owned(),
            claim: claim.to_owned(),
            published: published.to_owned(),
            ours: format!("{good} of {all} scenes"),
            holds: judge(good, all),
        });
    };
    count(
        "path-fastest",
        "path: dst is fastest",
        "everywhere",
        table.least("path", "dst", &STRUCTURES, time),
    );
    count(
        "raycast-lowest-energy",
        "raycast: dst has the lowest energy",
        "everywhere",
        table.least("raycast", "dst", &STRUCTURES, energy),
    );
    count(
        "path-lowest-energy",
        "path: dst has the lowest energy",
        "everywhere",
        table.least("path", "dst", &STRUCTURES, energy),
    );
    let single = ["dst", "dst-sw", "bvh2", "bvh4", "bvh8"];
    count(
        "raycast-fastest-single",
        "raycast: dst is fastest among single pipelines",
        "everywhere",
        table.least("raycast", "dst", &single, time),
    );
    let beaten = table.changes("raycast", "dst", "bvh2+", time);
    claims.push(Claim {
        name: "raycast-bvh2+-faster".to_owned(),
        claim: "raycast: bvh2+ is sometimes faster than dst".to_owned(),
        published: "sometimes".to_owned(),
        ours: format!("in {} of {} scenes", beaten.iter().filter(|c| **c > 0.0).count(), beaten.len()),
        holds: if beaten.is_empty() {
            "-"
        } else if beaten.iter().any(|c| *c > 0.0) {
            "yes"
        } else {
            "no"
        },
    });
    for grouping in &GROUPINGS {
        claims.extend(less_in_caches(&table, grouping));
        claims.extend(cuts_everything(&table, grouping));
    }
    claims.extend(growth(&table));
    claims.extend(catching_up(&table));
    claims.extend(scaling_claim(scaling));
    claims
}

/// How the energy is grouped: memory, what counts as caches, and the rest.
type Grouping = [(&'static str, Of); 3];

/// The paper's grouping, and the talk's, in which registers and local stores are on-chip storage like the caches.
const GROUPINGS: [Grouping; 2] = [
    [("DRAM", |row| row.dram_mj), ("cache", |row| row.cache_mj), ("compute", |row| row.compute_mj)],
    [
        ("DRAM", |row| row.dram_mj),
        ("on-chip storage", |row| row.on_chip_mj),
        ("execution", |row| row.execution_mj),
    ],
];

/// The claim that the pipeline saves energy of the caches in the hairball.
fn less_in_caches(table: &Table<'_>, [_, (name, of), _]: &Grouping) -> Option<Claim> {
    let value = |structure: &str| table.value("hairball", "path", structure, *of);
    let change = 100.0 * (value("dst")? / value("dst-sw")? - 1.0);
    Some(Claim {
        name: format!("hairball-less-{}", name.replace(' ', "-")),
        claim: format!("hairball, path: {name} energy, dst against dst-sw"),
        published: "much lower".to_owned(),
        ours: format!("{change:+.1} %"),
        holds: if change < -20.0 { "yes" } else { "no" },
    })
}

/// The claim that both dual-split variants spend less on memory, caches and computation than every BVH in the hairball.
fn cuts_everything(table: &Table<'_>, parts: &Grouping) -> Option<Claim> {
    let (mut less, mut all, mut ours) = (0, 0, vec![]);
    for (name, of) in parts {
        let value = |structure: &str| table.value("hairball", "path", structure, *of);
        let best = STRUCTURES[2..].iter().filter_map(|bvh| value(bvh)).reduce(f64::min)?;
        for dst in ["dst", "dst-sw"] {
            let change = 100.0 * (value(dst)? / best - 1.0);
            less += usize::from(change < 0.0);
            all += 1;
            ours.push(format!("{dst} {name} {change:+.1} %"));
        }
    }
    Some(Claim {
        name: format!("hairball-all-with-{}", parts[1].0.replace(' ', "-")),
        claim: format!(
            "hairball, path: dst and dst-sw below the best BVH in {}, {} and {}",
            parts[0].0, parts[1].0, parts[2].0
        ),
        published: "all three".to_owned(),
        ours: ours.join(", "),
        holds: judge(less, all),
    })
}

/// The claim that the gain over BVH2 grows with the scene, by the rank correlation of triangles and speed-up in path tracing.
fn growth(table: &Table<'_>) -> Option<Claim> {
    let mut gains = vec![];
    for scene in table.scenes() {
        let triangles = table.rows.iter().find(|row| row.scene == scene)?.triangles;
        let gain = table.value(scene, "path", "bvh2", time)? / table.value(scene, "path", "dst", time)?;
        gains.push((triangles as f64, gain));
    }
    let found = Correlation::of(&gains)?;
    Some(Claim {
        name: "path-gain-grows".to_owned(),
        claim: "path: the gain over bvh2 grows with the scene (Kendall's tau of triangles and gain)"
            .to_owned(),
        published: "grows".to_owned(),
        ours: format!("{found} over {} scenes", gains.len()),
        holds: found.holds(Direction::Rises),
    })
}

/// The claim that software decoding costs less time where memory dominates, by the rank correlation of memory's share of the
/// energy and the hardware's gain in time.
fn catching_up(table: &Table<'_>) -> Option<Claim> {
    let mut gains = vec![];
    for scene in table.scenes() {
        for test in ["raycast", "path"] {
            let share = table.value(scene, test, "dst", |row| row.dram_mj / row.energy_mj)?;
            gains.push((
                share,
                table.value(scene, test, "dst-sw", time)? / table.value(scene, test, "dst", time)?,
            ));
        }
    }
    let found = Correlation::of(&gains)?;
    Some(Claim {
        name: "dst-sw-catches-up".to_owned(),
        claim: "dst-sw catches up with dst where memory dominates (Kendall's tau of memory's share and gain)"
            .to_owned(),
        published: "catches up".to_owned(),
        ours: format!("{found} over {} frames", gains.len()),
        holds: found.holds(Direction::Falls),
    })
}

/// The claim about the speed-up from the fewest to the most multiprocessors.
fn scaling_claim(scaling: &[Row]) -> Option<Claim> {
    let tms = || scaling.iter().map(|row| row.tms);
    let (few, many) = (tms().min()?, tms().max()?);
    let cycles = |structure: &str, tms: u32| {
        let found = scaling.iter().find(|row| row.structure == structure && row.tms == tms)?;
        Some(found.cycles as f64)
    };
    let speed_up = |structure: &str| Some(cycles(structure, few)? / cycles(structure, many)?);
    let [dst, bvh2, bvh4, bvh8] = ["dst", "bvh2", "bvh4", "bvh8"].map(speed_up);
    let (dst, bvh2, bvh4, bvh8) = (dst?, bvh2?, bvh4?, bvh8?);
    Some(Claim {
        name: "speed-up-by-tms".to_owned(),
        claim: format!("speed-up from {few} to {many} TMs: dst, bvh2, bvh4, bvh8"),
        published: "dst above bvh2 and bvh4, about like bvh8".to_owned(),
        ours: format!("{dst:.2}, {bvh2:.2}, {bvh4:.2}, {bvh8:.2}"),
        holds: judge(usize::from(dst >= bvh2) + usize::from(dst >= bvh4), 2),
    })
}

/// The claims in the runs of a study of any size.
pub fn of_rows(rows: &[Row]) -> Vec<Claim> {
    compare(&of_series(rows, Series::Main), &of_series(rows, Series::Scaling))
}

/// The claims as CSV with a header, without their names.
pub(super) fn csv(claims: &[Claim]) -> anyhow::Result<String> {
    let mut writer = csv::Writer::from_writer(vec![]);
    writer.write_record(["claim", "published", "ours", "holds"])?;
    for Claim { name: _, claim, published, ours, holds } in claims {
        writer.write_record([claim, published, ours, *holds])?;
    }
    Ok(String::from_utf8(writer.into_inner()?)?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;
    use std::path::Path;

    #[test]
    fn the_claims_in_docs_are_those_of_the_runs_in_docs() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/study");
        let mut reader = ::csv::Reader::from_path(folder.join("study.csv")).unwrap();
        let rows: Vec<Row> = reader.deserialize().collect::<Result<_, _>>().unwrap();
        let claims = of_rows(&rows);
        let (file, expected) = (folder.join("comparison.csv"), csv(&claims).unwrap());
        if std::env::var_os("DUALSPLIT_BLESS").is_some() {
            fs::write(&file, &expected).unwrap();
        }
        assert_eq!(fs::read_to_string(&file).unwrap(), expected, "DUALSPLIT_BLESS=1 writes the file anew");
        let names: std::collections::BTreeSet<&String> = claims.iter().map(|claim| &claim.name).collect();
        assert_eq!(names.len(), claims.len(), "each claim has a name of its own");
    }
}
