//! All runs of a sweep as one table, and a chart for each key that has several values.

use super::plan::{Plan, Run, Subject};
use super::record::Record;
use machine::frame::MachineStructure;
use std::collections::BTreeSet;
use view::plot::Bars;

/// The table: a line for each run, with the values of all keys and then all quantities.
pub fn csv(plan: &Plan, records: &[Record]) -> anyhow::Result<Vec<u8>> {
    let mut names: Vec<&str> = vec![];
    let mut seen = BTreeSet::new();
    for (name, _) in records.iter().flat_map(|record| &record.quantities) {
        if seen.insert(name) {
            names.push(name);
        }
    }
    let mut writer = csv::Writer::from_writer(vec![]);
    let fixed = [
        "scene",
        "detail",
        "seed",
        "triangles",
        "structure",
        "node_bytes",
        "test",
        "width",
        "height",
        "quality",
        "level",
        "machine",
    ];
    let set = plan.file.set.iter().map(|key| key.name.as_str());
    writer.write_record(fixed.into_iter().chain(set).chain(["key"]).chain(names.iter().copied()))?;
    for (run, record) in plan.runs.iter().zip(records) {
        let mut line = keys(plan, run, record);
        line.extend(run.set.iter().cloned());
        line.push(run.key.clone());
        line.extend(
            names.iter().map(|name| record.quantity(name).map(|x| x.to_string()).unwrap_or_default()),
        );
        writer.write_record(&line)?;
    }
    Ok(writer.into_inner()?)
}

fn keys(plan: &Plan, run: &Run, record: &Record) -> Vec<String> {
    let subject = &plan.subjects[run.subject];
    let [width, height] = run.size;
    vec![
        subject.name.clone(),
        detail(subject),
        subject.source.seed.to_string(),
        record.triangles.to_string(),
        run.structure.name().to_owned(),
        record.node_bytes.to_string(),
        run.test.name().to_owned(),
        width.to_string(),
        height.to_string(),
        plan.file.quality.clone(),
        plan.file.level.clone(),
        run.machine_name.clone(),
    ]
}

/// The detail of a built-in scene; nothing for a file, which is taken as it is.
fn detail(subject: &Subject) -> String {
    if subject.source.path().is_some() { String::new() } else { subject.source.detail.to_string() }
}

/// What the charts show: the quantity, its unit, and the words of its file and title.
const SHOWN: [(&str, &str, &str, &str); 2] =
    [("frame_ms", "ms", "time", "Frame time"), ("energy_mj.total", "mJ", "energy", "Energy")];

/// The charts as SVG, with the names of their files: of each key with several values, the geometric mean over all other keys.
pub fn charts(plan: &Plan, records: &[Record]) -> Vec<(String, String)> {
    let lines: Vec<Vec<(&str, String)>> = plan.runs.iter().map(|run| varied(plan, run)).collect();
    let used: Vec<MachineStructure> = MachineStructure::ALL
        .into_iter()
        .filter(|s| plan.runs.iter().any(|run| run.structure == *s))
        .collect();
    let mut charts = vec![];
    for (place, (key, _)) in lines.first().into_iter().flatten().enumerate() {
        let mut seen = BTreeSet::new();
        let values = lines.iter().map(|line| &line[place].1);
        let values: Vec<&String> = values.filter(|value| !value.is_empty() && seen.insert(*value)).collect();
        if values.len() < 2 {
            continue;
        }
        for (quantity, unit, file, title) in SHOWN {
            let mean = |structure: MachineStructure, value: &String| {
                let runs = plan.runs.iter().zip(records).zip(&lines);
                let of_value =
                    runs.filter(|((run, _), line)| run.structure == structure && line[place].1 == *value);
                let quantities = of_value.filter_map(|((_, record), _)| record.quantity(quantity));
                let logs: Vec<f64> = quantities.map(libm::log).collect();
                (!logs.is_empty()).then(|| libm::exp(logs.iter().sum::<f64>() / logs.len() as f64))
            };
            let series = used.iter().map(|structure| {
                let means = values.iter().map(|value| mean(*structure, value));
                (structure.name().to_owned(), means.collect())
            });
            let chart = Bars {
                title: format!("{title} by {key}"),
                unit: unit.to_owned(),
                categories: values.iter().map(|value| (*value).clone()).collect(),
                series: series.collect(),
                ..Bars::default()
            };
            charts.push((format!("{file}-{}.svg", key.replace('/', "-")), chart.svg()));
        }
    }
    charts
}

/// The keys of the file in the order of the table, with the values that `run` has of them.
fn varied<'a>(plan: &'a Plan, run: &Run) -> Vec<(&'a str, String)> {
    let subject = &plan.subjects[run.subject];
    let [width, height] = run.size;
    let mut all = vec![
        ("scene", subject.name.clone()),
        ("detail", detail(subject)),
        ("seed", subject.source.seed.to_string()),
        ("structure", run.structure.name().to_owned()),
        ("test", run.test.name().to_owned()),
        ("size", format!("{width}x{height}")),
        ("machine", run.machine_name.clone()),
    ];
    all.extend(plan.file.set.iter().zip(&run.set).map(|(key, value)| (key.name.as_str(), value.clone())));
    all
}
