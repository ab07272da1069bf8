//! The file of a run: its result at the prices of its machine.

use anyhow::Context;
use base::input::read_own;
use base::output::write_file;
use machine::results::Results;
use serde::{Deserialize, Serialize};
use std::fs;
use std::path::{Path, PathBuf};

/// Most bytes of a record.
const MOST_BYTES: u64 = 1 << 20;

/// The folder of the records in that of a sweep.
const RUNS: &str = "runs";

/// A finished run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Record {
    /// The key of the run.
    pub key: String,
    /// Triangles of the scene.
    pub triangles: u64,
    /// Bytes of the structure's nodes, gaps included.
    pub node_bytes: u64,
    /// Seconds of the host, for estimates of the time left.
    pub seconds: f64,
    /// The quantities of `dualsplit simulate`, in its order.
    pub quantities: Vec<(String, f64)>,
}

impl Record {
    /// The record of a run with these results, in which `rays` rays were traced.
    pub fn new(key: &str, [triangles, node_bytes, rays]: [u64; 3], seconds: f64, results: &Results) -> Self {
        let quantities = results.quantities(rays).into_iter().map(|q| (q.name, q.value)).collect();
        Self { key: key.to_owned(), triangles, node_bytes, seconds, quantities }
    }

    /// The quantity `name`.
    pub fn quantity(&self, name: &str) -> Option<f64> {
        self.quantities.iter().find(|(known, _)| known == name).map(|(_, value)| *value)
    }

    /// The file of the run `key` in the folder of a sweep.
    pub fn path(folder: &Path, key: &str) -> PathBuf {
        folder.join(RUNS).join(format!("{key}.json"))
    }

    /// The record of the run `key` in the folder of a sweep. A file that is none, such as one that was cut, counts as missing.
    pub fn read(folder: &Path, key: &str) -> Option<Self> {
        let text = read_own(&Self::path(folder, key), MOST_BYTES).ok()?;
        serde_json::from_str::<Self>(&text).ok().filter(|record| record.key == key)
    }

    /// Writes the record into the folder of a sweep, whole or not at all. Another process may be writing the same record.
    ///
    /// # Errors
    /// The folder cannot be made, or the file not be written.
    pub fn write(&self, folder: &Path) -> anyhow::Result<()> {
        let path = Self::path(folder, &self.key);
        let runs = folder.join(RUNS);
        fs::create_dir_all(&runs).with_context(|| {
            format!("{}: cannot make the folder; name another with --out", runs.display())
        })?;
        let mut text = serde_json::to_vec_pretty(self)?;
        text.push(b'\n');
        Ok(write_file(&path, true, |out| out.write_all(&text))?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_record_counts_as_missing() {
        let folder = tempfile::tempdir().unwrap();
        let quantities = vec![("b".to_owned(), 0.1 + 0.2), ("a".to_owned(), 1e-300)];
        let record = Record { key: "k".to_owned(), triangles: 3, node_bytes: 4, seconds: 0.5, quantities };
        assert_eq!(Record::read(folder.path(), "k"), None);
        record.write(folder.path()).unwrap();
        assert_eq!(Record::read(folder.path(), "k"), Some(record.clone()));
        assert_eq!((record.quantity("a"), record.quantity("c")), (Some(1e-300), None));
        let path = Record::path(folder.path(), "k");
        let text = fs::read_to_string(&path).unwrap();
        fs::write(Record::path(folder.path(), "other"), &text).unwrap();
        assert_eq!(Record::read(folder.path(), "other"), None, "of another run");
        fs::write(&path, &text[..text.len() / 2]).unwrap();
        assert_eq!(Record::read(folder.path(), "k"), None);
    }
}
