//! The graph of the crates is the one that `tests/layers.txt` allows.

use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Command;

/// The list, relative to the root of the workspace.
const LIST: &str = "tests/layers.txt";
const TOOL: &str = "dualsplit";

/// What each crate uses, by names without the prefix.
type Graph = BTreeMap<String, BTreeSet<String>>;

#[test]
fn crates_use_what_the_list_allows() {
    let text = std::fs::read_to_string(root().join(LIST)).expect(LIST);
    let faults = faults(&stated(&metadata()), &listed(&text));
    assert!(faults.is_empty(), "\n{}\n", faults.join("\n"));
}

#[test]
fn nothing_depends_on_the_tool() {
    let metadata = metadata();
    for (from, dependency) in dependencies(&metadata) {
        assert_ne!(short(name(dependency)), TOOL, "{from} depends on the tool");
    }
}

#[test]
fn planted_edges_are_found() {
    let list = listed("# A rule.\nlow:\nhigh: low\n");
    let with = |edges: &[(&str, &str)]| {
        let mut graph: Graph = [("low", [].into()), ("high", ["low".to_owned()].into())]
            .map(|(name, uses)| (name.to_owned(), uses))
            .into();
        for (from, to) in edges {
            graph.entry((*from).to_owned()).or_default().insert((*to).to_owned());
        }
        graph
    };
    assert_eq!(faults(&with(&[]), &list), [""; 0]);
    assert_eq!(faults(&with(&[("low", "high")]), &list), ["low -> high: not allowed by tests/layers.txt"]);
    assert_eq!(
        faults(&[("low".to_owned(), BTreeSet::new()), ("high".to_owned(), BTreeSet::new())].into(), &list),
        ["high -> low: in tests/layers.txt, but there is no such dependency"]
    );
    let unknown =
        ["other: the crate has no line in tests/layers.txt", "other -> low: not allowed by tests/layers.txt"];
    assert_eq!(faults(&with(&[("other", "low")]), &list), unknown);
}

/// What differs between the graph that the manifests state and the list.
fn faults(stated: &Graph, listed: &Graph) -> Vec<String> {
    let none = BTreeSet::new();
    let names: BTreeSet<&String> = stated.keys().chain(listed.keys()).collect();
    let mut faults = vec![];
    for name in names {
        let (uses, may) = (stated.get(name), listed.get(name));
        if uses.is_none() {
            faults.push(format!("{name}: in {LIST}, but there is no such crate"));
        }
        if may.is_none() {
            faults.push(format!("{name}: the crate has no line in {LIST}"));
        }
        let (uses, may) = (uses.unwrap_or(&none), may.unwrap_or(&none));
        faults.extend(uses.difference(may).map(|to| format!("{name} -> {to}: not allowed by {LIST}")));
        let absent = may.difference(uses);
        faults.extend(absent.map(|to| format!("{name} -> {to}: in {LIST}, but there is no such dependency")));
    }
    faults
}

/// The list's edges.
fn listed(text: &str) -> Graph {
    let lines = text.lines().filter(|line| !line.is_empty() && !line.starts_with('#'));
    let mut graph = Graph::new();
    for line in lines {
        let (name, uses) = line.split_once(':').unwrap_or_else(|| panic!("{LIST}: no colon in `{line}`"));
        let uses = uses.split_whitespace().map(str::to_owned).collect();
        assert!(graph.insert(name.to_owned(), uses).is_none(), "{LIST}: two lines for {name}");
    }
    graph
}

/// The normal and build dependencies between the packages of the workspace.
fn stated(metadata: &Value) -> Graph {
    let packages = metadata["packages"].as_array().expect("packages");
    let mut graph: Graph =
        packages.iter().map(|package| (short(name(package)).to_owned(), BTreeSet::new())).collect();
    for (from, dependency) in dependencies(metadata).filter(|(_, dependency)| dependency["kind"] != "dev") {
        graph.entry(from.to_owned()).or_default().insert(short(name(dependency)).to_owned());
    }
    graph
}

/// All dependencies between the packages, with the name of the package that has them.
fn dependencies(metadata: &Value) -> impl Iterator<Item = (&str, &Value)> {
    let packages = metadata["packages"].as_array().expect("packages");
    let names: BTreeSet<&str> = packages.iter().map(name).collect();
    packages.iter().flat_map(move |package| {
        let all = package["dependencies"].as_array().expect("dependencies");
        let names = names.clone();
        let inside = all.iter().filter(move |dependency| names.contains(name(dependency)));
        inside.map(|dependency| (short(name(package)), dependency))
    })
}

fn name(value: &Value) -> &str {
    value["name"].as_str().expect("a name")
}

fn short(name: &str) -> &str {
    name.strip_prefix("dualsplit-").unwrap_or(name)
}

fn metadata() -> Value {
    let output = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
        .args(["metadata", "--no-deps", "--format-version", "1", "--offline"])
        .current_dir(root())
        .output()
        .expect("cargo metadata");
    assert!(output.status.success(), "cargo metadata: {}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).expect("cargo metadata prints JSON")
}

/// The root of the workspace.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).expect("two folders below the root").to_owned()
}
