//! The file of a sweep: which lists its runs are the product of.

use anyhow::{Context, bail, ensure};
use base::input::read_text;
use serde::Deserialize;
use std::collections::BTreeSet;
use std::fmt::Display;
use std::path::Path;

/// Most bytes of the file.
const MOST_BYTES: u64 = 1 << 20;

/// A value, or a list of values.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged, expecting = "expected a value or a list of values")]
enum List<T> {
    Many(Vec<T>),
    One(T),
}

/// The file as it is written.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Written {
    scenes: List<String>,
    detail: Option<List<f64>>,
    seeds: Option<List<u64>>,
    structures: List<String>,
    tests: Option<List<String>>,
    sizes: Option<List<String>>,
    quality: Option<String>,
    level: Option<String>,
    pipeline_cost: Option<String>,
    machines: Option<List<String>>,
    #[serde(default)]
    set: toml::Table,
}

/// A key of the machine, and the values that it is given, as `--set` takes them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Key {
    /// The key, with its section.
    pub name: String,
    /// Its values.
    pub values: Vec<String>,
}

/// The lists of a sweep. None is empty, and none has a value twice.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs, reason = "the keys of the file, which docs/tool.md explains")]
pub struct SweepFile {
    pub scenes: Vec<String>,
    /// Of built-in scenes.
    pub detail: Vec<f64>,
    pub seeds: Vec<u64>,
    pub structures: Vec<String>,
    pub tests: Vec<String>,
    pub sizes: Vec<[u32; 2]>,
    pub quality: String,
    pub level: String,
    pub pipeline_cost: String,
    pub machines: Vec<String>,
    pub set: Vec<Key>,
}

impl SweepFile {
    /// Reads the file `path`.
    ///
    /// # Errors
    /// The message names the file and the key or the line.
    pub fn read(path: &Path) -> anyhow::Result<Self> {
        let named = || path.display().to_string();
        let text =
            read_text(path, MOST_BYTES).with_context(|| format!("{}: cannot read the sweep", named()))?;
        Self::parse(&text).with_context(named)
    }

    /// The sweep in `text`.
    ///
    /// # Errors
    /// The message names the key or the line.
    pub fn parse(text: &str) -> anyhow::Result<Self> {
        let written: Written = base::toml_text::parse(text)
            .map_err(|error| anyhow::anyhow!("{}", error.to_string().trim_end()))?;
        let mut set = vec![];
        flatten("", &written.set, &mut set)?;
        let or =
            |words: Option<List<String>>, word: &str| words.unwrap_or_else(|| List::One(word.to_owned()));
        let sizes = values("sizes", or(written.sizes, "64x64"))?
            .iter()
            .map(|text| size(text))
            .collect::<Result<_, _>>()?;
        Ok(Self {
            scenes: values("scenes", written.scenes)?,
            detail: values("detail", written.detail.unwrap_or(List::One(0.1)))?,
            seeds: values("seeds", written.seeds.unwrap_or(List::One(0)))?,
            structures: values("structures", written.structures)?,
            tests: values("tests", or(written.tests, "path"))?,
            sizes,
            quality: written.quality.unwrap_or_else(|| "high".to_owned()),
            level: written.level.unwrap_or_else(|| "transaction".to_owned()),
            pipeline_cost: written.pipeline_cost.unwrap_or_else(|| "published".to_owned()),
            machines: values("machines", or(written.machines, "trax"))?,
            set,
        })
    }
}

/// The values of the list `key`.
fn values<T: Clone + Display>(key: &str, list: List<T>) -> anyhow::Result<Vec<T>> {
    let values = match list {
        List::Many(values) => values,
        List::One(value) => vec![value],
    };
    ensure!(!values.is_empty(), "`{key}` is an empty list, so that there is nothing to run; give a value");
    let mut seen = BTreeSet::new();
    if let Some(twice) = values.iter().find(|value| !seen.insert(value.to_string())) {
        bail!("`{key}` has the value {twice} twice; leave one away");
    }
    Ok(values)
}

fn size(text: &str) -> anyhow::Result<[u32; 2]> {
    let sides =
        text.split_once('x').and_then(|(width, height)| Some([width.parse().ok()?, height.parse().ok()?]));
    sides.with_context(|| format!("`sizes` has {text}; write WIDTHxHEIGHT in pixels, such as 64x64"))
}

/// Adds the lists in `table` to `keys`, whose names begin with `section`.
fn flatten(section: &str, table: &toml::Table, keys: &mut Vec<Key>) -> anyhow::Result<()> {
    for (name, value) in table {
        let name = if section.is_empty() { name.clone() } else { format!("{section}.{name}") };
        let list = match value {
            toml::Value::Table(inner) => {
                flatten(&name, inner, keys)?;
                continue;
            }
            toml::Value::Array(list) => list.clone(),
            single => vec![single.clone()],
        };
        let texts = list.into_iter().map(|value| match value {
            toml::Value::String(text) => Ok(text),
            toml::Value::Integer(_) | toml::Value::Float(_) | toml::Value::Boolean(_) => {
                Ok(value.to_string())
            }
            _ => bail!("`set.{name}` has a value that is neither a word nor a number"),
        });
        let texts = texts.collect::<anyhow::Result<_>>()?;
        keys.push(Key { values: values(&format!("set.{name}"), List::Many(texts))?, name });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_lists_or_single_values() {
        let text = "scenes = [\"atrium\", \"a.obj\"]\nstructures = \"dst\"\nseeds = [0, 7]\nsizes = \"8x4\"\n\
                    [set]\nl1.size = [\"16KiB\", \"32KiB\"]\n\"tm.threads\" = 16\nclock_ghz = [1.5]\n";
        let file = SweepFile::parse(text).unwrap();
        assert_eq!((file.scenes.len(), file.seeds, file.sizes), (2, vec![0, 7], vec![[8, 4]]));
        assert_eq!(
            (file.machines, file.tests, file.detail),
            (vec!["trax".to_owned()], vec!["path".to_owned()], vec![0.1])
        );
        let key = |name: &str, values: &[&str]| Key {
            name: name.to_owned(),
            values: values.iter().map(|value| (*value).to_owned()).collect(),
        };
        let expected =
            [key("clock_ghz", &["1.5"]), key("l1.size", &["16KiB", "32KiB"]), key("tm.threads", &["16"])];
        let mut found = file.set;
        found.sort_by(|a, b| a.name.cmp(&b.name));
        assert_eq!(found, expected);
    }

    #[test]
    fn faults_name_the_key_or_the_line() {
        let good = "scenes = \"atrium\"\nstructures = \"dst\"\n";
        for (more, word) in [
            ("scene = \"atrium\"\n", "scene"),
            ("seeds = []\n", "`seeds`"),
            ("seeds = [3, 3]\n", "3 twice"),
            ("seeds = -1\n", "line 3"),
            ("sizes = [\"64\"]\n", "`sizes`"),
            ("[set]\nl1.size = []\n", "`set.l1.size`"),
            ("[set]\nl1.size = [[1]]\n", "`set.l1.size`"),
            ("detail = \n", "line 3"),
        ] {
            let error = format!("{:#}", SweepFile::parse(&format!("{good}{more}")).unwrap_err());
            assert!(error.contains(word), "{more}: {error}");
        }
        assert!(format!("{:#}", SweepFile::parse("scenes = 3").unwrap_err()).contains("a value or a list"));
        assert!(format!("{:#}", SweepFile::parse("scenes = \"a\"").unwrap_err()).contains("structures"));
    }
}
