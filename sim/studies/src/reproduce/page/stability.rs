//! The section about the inputs that break ray tracers: a line for each family of methods, with pictures of their failures.

use super::super::stages::Outcome;
use super::rows;
use anyhow::Context;
use serde_json::Value;
use std::fs;
use std::path::Path;
use view::report::{Item, Picture, Section, Table};

/// What is counted of a method: its key, and the heading of its column.
const COUNTS: [(&str, &str); 8] = [
    ("rays", "rays"),
    ("false_misses", "false misses"),
    ("false_hits", "false hits"),
    ("wrong_nearest", "wrong nearest"),
    ("nan", "NaN"),
    ("lost", "lost by traversal"),
    ("triangle_test", "wrong by triangle test"),
    ("excess_visits", "excess visits"),
];
/// The counts that are wrong results: all but the rays and the slow ones.
const WRONG: std::ops::Range<usize> = 1..COUNTS.len() - 1;

/// Methods and the sums of their counts, in the order of the document.
type Sums = Vec<(String, [u64; COUNTS.len()])>;

/// The sums of `cells` by what `name` makes of a method.
fn sums(cells: &[Value], name: impl Fn(&str) -> String) -> Sums {
    let mut all = Sums::new();
    for one in cells {
        let Some(method) = one["method"].as_str().map(&name) else { continue };
        let at = all.iter().position(|(other, _)| *other == method).unwrap_or_else(|| {
            all.push((method, Default::default()));
            all.len() - 1
        });
        for (sum, (key, _)) in all[at].1.iter_mut().zip(COUNTS) {
            *sum += one[key].as_u64().unwrap_or(0);
        }
    }
    all
}

/// A table of `sums`. Columns of zeros become a part of the caption.
fn table(caption: &str, first: &str, sums: &Sums) -> Table {
    let is_zero = |at: &usize| sums.iter().all(|(_, counts)| counts[*at] == 0);
    let (zeros, shown): (Vec<usize>, Vec<usize>) = (0..COUNTS.len()).partition(is_zero);
    let headings = |columns: &[usize]| columns.iter().map(|at| COUNTS[*at].1.to_owned()).collect::<Vec<_>>();
    let row = |(name, counts): &(String, [u64; COUNTS.len()])| {
        [name.clone()].into_iter().chain(shown.iter().map(|at| counts[*at].to_string())).collect()
    };
    let none =
        if zeros.is_empty() { String::new() } else { format!("; none: {}", headings(&zeros).join(", ")) };
    Table {
        caption: format!("{caption}{none}"),
        header: [first.to_owned()].into_iter().chain(headings(&shown)).collect(),
        rows: sums.iter().map(row).collect(),
        ..Table::default()
    }
}

/// The section, with the pictures that `folder` holds.
pub fn section(outcome: &Outcome, folder: &Path) -> anyhow::Result<Section> {
    let cells = rows(&outcome.report["cells"]);
    // A family is an arithmetic: the structures behind it lose the same hits.
    let families =
        sums(cells, |method| method.split_once('/').map_or(method, |(_, arithmetic)| arithmetic).to_owned());
    let (wrong, right): (Sums, Sums) =
        families.into_iter().partition(|(_, counts)| counts[WRONG].iter().any(|count| *count > 0));
    let rays: u64 = cells.iter().filter_map(|cell| cell["rays"].as_u64()).sum();
    let names = |sums: &Sums| sums.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>().join(", ");
    let mut items = vec![];
    if !right.is_empty() {
        let rays: u64 = right.iter().map(|(_, counts)| counts[0]).sum();
        items.push(Item::Text(format!("No result of {rays} rays was wrong: {}.", names(&right))));
    }
    if !wrong.is_empty() {
        let caption = "Arithmetics with wrong results, summed over all structures and inputs";
        items.push(Item::Table(
            table(caption, "arithmetic", &wrong).from("../stress/stress.csv", &outcome.command),
        ));
    }
    let pictures = pictures(&outcome.report["artifacts"], folder)?;
    if !pictures.is_empty() {
        items.push(Item::Text(
            "Rays around a failure, the failing one in the middle; each square is a ray whose direction differs by a fraction of a \
             unit in the last place."
                .into(),
        ));
        items.push(Item::Pictures(pictures));
    }
    let each = table("All methods", "method", &sums(cells, str::to_owned));
    items.push(Item::Folded(
        "Each method by itself".into(),
        vec![Item::Table(each.from("../stress/stress.csv", &outcome.command))],
    ));
    Ok(Section {
        title: "Stability where methods fail".into(),
        text: vec![format!(
            "Every structure and arithmetic, and the netlists, on inputs made to break them: the 33 known cases, rays aimed at \
             corners, edges and faces, and rays that a search walks towards the worst, one unit in the last place at a time. \
             Judged by exact rational arithmetic; {rays} rays in all. Robust and conservative methods must lose none; naive and \
             fast ones show what happens without."
        )],
        items,
    })
}

/// The pictures of failures among `artifacts`.
fn pictures(artifacts: &Value, folder: &Path) -> anyhow::Result<Vec<Picture>> {
    let names = rows(artifacts).iter().filter_map(|path| Path::new(path.as_str()?).file_name()?.to_str());
    let of = |name: &str| {
        let path = folder.join(name);
        let png = fs::read(&path).with_context(|| path.display().to_string())?;
        Ok(Picture { png, caption: name.trim_end_matches(".png").replace('_', " ") })
    };
    names.filter(|name| name.ends_with(".png")).map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;
    use view::report::Page;

    #[test]
    fn families_with_wrong_results_have_a_line_and_the_others_are_folded() {
        let cell = |method: &str, misses: u64| json!({"method": method, "rays": 10, "false_misses": misses});
        let cells =
            json!([cell("dst/fast", 1), cell("bvh2/fast", 2), cell("dst/robust", 0), cell("bvh2/robust", 0)]);
        let report = json!({"cells": cells, "artifacts": []});
        let outcome = Outcome { command: "dualsplit stress".into(), report, difference: false, seconds: 1.0 };
        let section = section(&outcome, Path::new("nowhere")).unwrap();
        assert_eq!(section.items.len(), 3);
        let html = Page { sections: vec![section], ..Page::default() }.html();
        for part in [
            "No result of 20 rays was wrong: robust.",
            ">fast</th><td class=\"number\">20</td><td class=\"number\">3</td>",
        ] {
            assert!(html.contains(part), "{part} in {html}");
        }
        assert!(html.contains("; none: false hits, wrong nearest, NaN,"), "{html}");
        let (shown, folded) = html.split_once("<details>").unwrap();
        assert!(!shown.contains("dst/robust") && folded.contains("dst/robust"), "{html}");
    }
}
