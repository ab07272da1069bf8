//! All runs of a sweep as one table, and a chart for each key that has several values.

use super::plan::{Plan, Run};
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
    // A file is taken as it is.
    let detail =
        if subject.source.path().is_some() { String::new() } else { subject.source.detail.to_string() };
    vec![
        subject.name.clone(),
        detail,
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

/// What the charts show: the quantity, its unit, and the words of its file and title.
const SHOWN: [(&str, &str, &str, &str); 2] =
    [("frame_ms", "ms", "time", "Frame time"), ("energy_mj.total", "mJ", "energy", "Energy")];

/// The charts as SVG, with the names of their files: of each key with several values, the geometric mean over all other keys.
pub fn charts(plan: &Plan, records: &[Record]) -> Vec<(String, String)> {
    let mut charts = vec![];
    for (key, values) in varied(plan) {
        for (quantity, unit, file, title) in SHOWN {
            let mean = |structure: MachineStructure, value: &String| {
                let of_value = plan
                    .runs
                    .iter()
                    .zip(records)
                    .filter(|(run, _)| run.structure == structure && value_of(plan, run, &key) == *value);
                let logs: Vec<f64> =
                    of_value.filter_map(|(_, record)| record.quantity(quantity)).map(libm::log).collect();
                (!logs.is_empty()).then(|| libm::exp(logs.iter().sum::<f64>() / logs.len() as f64))
            };
            let used =
                MachineStructure::ALL.into_iter().filter(|s| plan.runs.iter().any(|run| run.structure == *s));
            let series = used.map(|structure| {
                (structure.name().to_owned(), values.iter().map(|value| mean(structure, value)).collect())
            });
            let chart = Bars {
                title: format!("{title} by {key}"),
                unit: unit.to_owned(),
                categories: values.clone(),
                series: series.collect(),
                ..Bars::default()
            };
            charts.push((format!("{file}-{}.svg", key.replace('/', "-")), chart.svg()));
        }
    }
    charts
}

/// The keys with several values, in the order of the table, with their values.
fn varied(plan: &Plan) -> Vec<(String, Vec<String>)> {
    let file = &plan.file;
    let texts = |values: &[String]| values.to_vec();
    let keys = [
        ("scene", texts(&file.scenes)),
        ("detail", file.detail.iter().map(ToString::to_string).collect()),
        ("seed", file.seeds.iter().map(ToString::to_string).collect()),
        ("structure", texts(&file.structures)),
        ("test", texts(&file.tests)),
        ("size", file.sizes.iter().map(|[width, height]| format!("{width}x{height}")).collect()),
        ("machine", texts(&file.machines)),
    ];
    let set = file.set.iter().map(|key| (key.name.clone(), key.values.clone()));
    let all = keys.map(|(key, values)| (key.to_owned(), values)).into_iter().chain(set);
    all.filter(|(_, values)| values.len() > 1).collect()
}

/// The value that `run` has of `key`.
fn value_of(plan: &Plan, run: &Run, key: &str) -> String {
    let subject = &plan.subjects[run.subject];
    match key {
        "scene" => subject.name.clone(),
        "detail" => subject.source.detail.to_string(),
        "seed" => subject.source.seed.to_string(),
        "structure" => run.structure.name().to_owned(),
        "test" => run.test.name().to_owned(),
        "size" => format!("{}x{}", run.size[0], run.size[1]),
        "machine" => run.machine_name.clone(),
        _ => {
            let place = plan.file.set.iter().position(|known| known.name == key);
            place.map(|place| run.set[place].clone()).unwrap_or_default()
        }
    }
}
