//! A folder of results, which a later run may replace.

use crate::input::try_folder;
use anyhow::{Context, bail};
use base::guard;
use base::input::read_own;
use base::output::write_file;
use std::collections::BTreeSet;
use std::fs::{self, File, TryLockError};
use std::path::{Path, PathBuf};

/// The file that lists which files in its folder the tool made. The tool replaces those and no others.
const LIST: &str = ".dualsplit-artifacts";

/// Most bytes of the list.
const MOST_BYTES: u64 = 1 << 24;

/// A folder that is being filled.
pub struct Artifacts {
    folder: PathBuf,
    force: bool,
    /// Files of this and earlier runs, relative to the folder.
    owned: BTreeSet<String>,
    /// Files of this run, in order.
    written: Vec<String>,
    /// The folders that were made for it, the innermost first.
    made: Vec<PathBuf>,
    /// The folder, locked against other runs as long as it is open.
    _lock: Option<File>,
}

impl Artifacts {
    /// Makes `folder`. If it exists, it has to be empty or made by an earlier run, unless `force` is set. A folder that gets no file
    /// is removed again.
    ///
    /// # Errors
    /// The folder holds files of others, or a file of an earlier run that is read, or cannot be made or written into, or another run
    /// is writing into it.
    pub fn create(folder: &Path, force: bool) -> anyhow::Result<Self> {
        let list = folder.join(LIST);
        let mut made = vec![];
        let owned: BTreeSet<String> = match read_own(&list, MOST_BYTES) {
            Ok(text) => text.lines().map(str::to_owned).collect(),
            Err(_) => {
                let occupied = folder.symlink_metadata().is_ok()
                    && fs::read_dir(folder).map_or(true, |mut entries| entries.next().is_some());
                if occupied && !force {
                    bail!(
                        "{}: the folder exists and was not made by this tool; name another with --out, or use --force \
                         to write into it",
                        folder.display()
                    );
                }
                made = folder.ancestors().take_while(|part| !part.exists()).map(Path::to_owned).collect();
                made.retain(|part| !part.as_os_str().is_empty());
                fs::create_dir_all(folder).with_context(|| {
                    format!("{}: cannot make the folder; name another with --out", folder.display())
                })?;
                BTreeSet::new()
            }
        };
        if let Some(name) = owned.iter().find(|name| guard::is_read(&folder.join(name))) {
            bail!(
                "{}: the command reads {name} in this folder, which it would replace; name another with --out",
                folder.display()
            );
        }
        let artifacts =
            Self { folder: folder.to_owned(), force, owned, written: vec![], made, _lock: lock(folder)? };
        try_folder(folder)?;
        Ok(artifacts)
    }

    /// Writes the file `name`, a relative path with `/`. Only with `force` does it replace a file that the tool did not make.
    ///
    /// # Errors
    /// The tool did not make the file, or cannot write it.
    pub fn write(&mut self, name: &str, bytes: &[u8]) -> anyhow::Result<()> {
        let path = self.folder.join(name);
        if let Some(parent) = path.parent() {
            fs::create_dir_all(parent)
                .with_context(|| format!("{}: cannot make the folder", parent.display()))?;
        }
        let replace = self.force || self.owned.contains(name);
        // A file with these bytes may have been brought from another folder.
        let is_same = || {
            path.metadata().is_ok_and(|found| found.len() == bytes.len() as u64)
                && fs::read(&path).is_ok_and(|found| found == bytes)
        };
        let replace = replace || is_same();
        if !replace && path.symlink_metadata().is_ok() {
            bail!(
                "{}: the file was not made by this tool; move it, or use --force to replace it",
                path.display()
            );
        }
        // The file is listed before it is written: if the run is interrupted, the next one may replace what it left.
        if self.owned.insert(name.to_owned()) {
            self.save_list()?;
        }
        write_file(&path, replace, |out| out.write_all(bytes))?;
        self.written.push(name.to_owned());
        Ok(())
    }

    /// Counts the file `name`, which an earlier run made, among the files of this run. Returns false if there is no such file.
    pub fn keep(&mut self, name: &str) -> bool {
        let kept = self.owned.contains(name) && self.folder.join(name).is_file();
        if kept && !self.written.iter().any(|written| written == name) {
            self.written.push(name.to_owned());
        }
        kept
    }

    /// Takes the file `name` from the list of this run's files, so that [`Artifacts::finish`] removes it.
    pub fn drop(&mut self, name: &str) {
        self.written.retain(|written| written != name);
    }

    /// Removes the files of earlier runs that this run did not write or keep, and returns the paths of this run's files in order.
    ///
    /// # Errors
    /// A file cannot be removed, or the list cannot be written.
    pub fn finish(mut self) -> anyhow::Result<Vec<PathBuf>> {
        let current: BTreeSet<String> = self.written.iter().cloned().collect();
        for stale in self.owned.difference(&current) {
            let path = self.folder.join(stale);
            if is_plain(stale) && path.symlink_metadata().is_ok() && !guard::is_read(&path) {
                fs::remove_file(&path).with_context(|| format!("{}: cannot remove", path.display()))?;
            }
        }
        self.owned = current;
        self.save_list()?;
        Ok(self.written.iter().map(|name| self.folder.join(name)).collect())
    }

    fn save_list(&self) -> anyhow::Result<()> {
        let path = self.folder.join(LIST);
        let text: String = self.owned.iter().map(|name| format!("{name}\n")).collect();
        Ok(write_file(&path, true, |out| out.write_all(text.as_bytes()))?)
    }
}

/// Adds the file `name` to `folder`, which a run has filled, and returns its path.
///
/// # Errors
/// Those of [`Artifacts`].
pub fn add(folder: &Path, name: &str, bytes: &[u8]) -> anyhow::Result<PathBuf> {
    let mut artifacts = Artifacts::create(folder, false)?;
    artifacts.written = artifacts.owned.iter().filter(|owned| *owned != name).cloned().collect();
    artifacts.write(name, bytes)?;
    artifacts.finish()?;
    Ok(folder.join(name))
}

impl Drop for Artifacts {
    fn drop(&mut self) {
        if self.owned.is_empty() {
            // What is not empty stays.
            self.made.iter().all(|folder| fs::remove_dir(folder).is_ok());
        }
    }
}

/// Locks `folder`. Where the system locks no folders, two runs at a time are not noticed.
///
/// # Errors
/// Another run holds the lock.
fn lock(folder: &Path) -> anyhow::Result<Option<File>> {
    let Ok(file) = File::open(folder) else { return Ok(None) };
    match file.try_lock() {
        Ok(()) => Ok(Some(file)),
        Err(TryLockError::WouldBlock) => {
            bail!(
                "{}: another run is writing into this folder; wait for its end, or name another folder with --out",
                folder.display()
            )
        }
        Err(TryLockError::Error(_)) => Ok(None),
    }
}

/// Whether a listed name stays inside the folder. Users can edit the list, so its names are not trusted.
fn is_plain(name: &str) -> bool {
    Path::new(name).components().all(|part| matches!(part, std::path::Component::Normal(_)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn run(folder: &Path, names: &[&str], force: bool) -> anyhow::Result<Vec<PathBuf>> {
        let mut artifacts = Artifacts::create(folder, force)?;
        for name in names {
            artifacts.write(name, name.as_bytes())?;
        }
        artifacts.finish()
    }

    #[test]
    fn a_run_replaces_the_files_of_earlier_ones_and_no_others() {
        let parent = tempfile::tempdir().unwrap();
        let folder = parent.path().join("out");
        let paths = run(&folder, &["b", "sub/a", "old"], false).unwrap();
        assert_eq!(paths, ["b", "sub/a", "old"].map(|name| folder.join(name)));
        fs::write(folder.join("mine"), "my own").unwrap();
        run(&folder, &["b", "sub/a"], false).unwrap();
        assert!(!folder.join("old").exists(), "made by the tool, and no longer part of the result");
        assert_eq!(fs::read(folder.join("mine")).unwrap(), b"my own");
        let error = run(&folder, &["b", "mine"], false).unwrap_err().to_string();
        assert!(error.contains("mine") && error.contains("--force"), "{error}");
        assert_eq!(fs::read(folder.join("mine")).unwrap(), b"my own");
        run(&folder, &["mine"], true).unwrap();
    }

    #[test]
    fn a_file_is_added_to_those_of_a_run() {
        let parent = tempfile::tempdir().unwrap();
        let folder = parent.path().join("out");
        run(&folder, &["a", "b"], false).unwrap();
        for content in ["1", "2"] {
            assert_eq!(add(&folder, "c", content.as_bytes()).unwrap(), folder.join("c"));
        }
        assert!(["a", "b", "c"].iter().all(|name| folder.join(name).exists()));
        run(&folder, &["a"], false).unwrap();
        assert!(!folder.join("c").exists(), "a file of the tool like the others");
    }

    #[test]
    fn a_run_that_writes_nothing_leaves_no_folder() {
        let parent = tempfile::tempdir().unwrap();
        let folder = parent.path().join("a/b");
        drop(Artifacts::create(&folder, false).unwrap());
        assert_eq!(fs::read_dir(parent.path()).unwrap().count(), 0);
        fs::create_dir(parent.path().join("a")).unwrap();
        drop(Artifacts::create(&folder, false).unwrap());
        assert!(parent.path().join("a").exists() && !folder.exists());
        let mut artifacts = Artifacts::create(&folder, false).unwrap();
        artifacts.write("c", b"").unwrap();
        drop(artifacts);
        assert!(folder.join("c").exists());
    }

    #[test]
    #[cfg(unix)]
    fn two_runs_in_one_folder_are_refused() {
        let parent = tempfile::tempdir().unwrap();
        let folder = parent.path().join("out");
        let first = Artifacts::create(&folder, false).unwrap();
        let error = Artifacts::create(&folder, true).err().expect("a lock").to_string();
        assert!(error.contains("another run is writing"), "{error}");
        first.finish().unwrap();
        run(&folder, &["a"], false).unwrap();
    }

    #[test]
    fn folders_of_others_are_left_alone() {
        let parent = tempfile::tempdir().unwrap();
        let folder = parent.path().join("photos");
        fs::create_dir(&folder).unwrap();
        run(&folder, &[], false).unwrap();
        fs::remove_file(folder.join(LIST)).unwrap();
        fs::write(folder.join("cat.png"), "cat").unwrap();
        let error = run(&folder, &["a"], false).unwrap_err().to_string();
        assert!(error.contains("--force"), "{error}");
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
        let file = folder.join("cat.png");
        assert!(run(&file, &["a"], false).is_err());
    }

    #[test]
    fn an_edited_list_removes_nothing_outside() {
        let parent = tempfile::tempdir().unwrap();
        let folder = parent.path().join("out");
        run(&folder, &["a"], false).unwrap();
        let outside = parent.path().join("precious");
        fs::write(&outside, "x").unwrap();
        fs::write(folder.join(LIST), format!("a\n../precious\n{}\n", outside.display())).unwrap();
        run(&folder, &["a"], false).unwrap();
        assert!(outside.exists());
    }
}
