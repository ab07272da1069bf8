//! Keeps a program that may replace files from replacing what it reads.
//!
//! A tool [`watch`]es its files. From then on, each file that [`input::open`](crate::input::open) opens is known as read, each that
//! a command is going to write is [announced](will_write), and a file that is both is an error, whichever comes first.
//! [`write_file`](crate::output::write_file) replaces no file that was read, announced or not. A program that does not watch may
//! write what it has read, as one that edits a scene.

use std::collections::{BTreeMap, BTreeSet};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use thiserror::Error;

use crate::output::{is_special, target};

/// A file that would be read and written.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Conflict {
    /// What is to be written has been read.
    #[error("this is also read; name another")]
    Read,
    /// What is to be read, or to be written for another option, is written for this option.
    #[error("this is also the file of {0}; name another")]
    Written(String),
}

#[derive(Default)]
struct Files {
    watched: bool,
    read: BTreeSet<PathBuf>,
    /// Files that will be written, and the options that name them.
    announced: BTreeMap<PathBuf, String>,
}

static FILES: Mutex<Files> =
    Mutex::new(Files { watched: false, read: BTreeSet::new(), announced: BTreeMap::new() });

/// The files, if they are watched.
fn files() -> Option<MutexGuard<'static, Files>> {
    // Sets of paths are whole after each of their operations.
    let files = FILES.lock().unwrap_or_else(PoisonError::into_inner);
    files.watched.then_some(files)
}

/// Watches the files of this process from now on.
pub fn watch() {
    FILES.lock().unwrap_or_else(PoisonError::into_inner).watched = true;
}

/// Notes that the file `path` is read.
///
/// # Errors
/// It was announced as written.
pub fn reads(path: &Path) -> io::Result<()> {
    let Some(mut files) = files() else { return Ok(()) };
    let Ok(found) = path.canonicalize() else { return Ok(()) };
    if is_special(path) {
        return Ok(());
    }
    if let Some(option) = files.announced.get(&found) {
        return Err(io::Error::other(Conflict::Written(option.clone())));
    }
    files.read.insert(found);
    Ok(())
}

/// Whether the file `path` was read.
#[must_use]
pub fn is_read(path: &Path) -> bool {
    files().is_some_and(|files| target(path).is_ok_and(|found| files.read.contains(&found)))
}

/// Notes that the file `path` will be written, as `option` says. That holds until it is.
///
/// # Errors
/// It was read, or announced for another option.
pub fn will_write(option: &str, path: &Path) -> Result<(), Conflict> {
    let Some(mut files) = files() else { return Ok(()) };
    let Ok(found) = target(path) else { return Ok(()) };
    if files.read.contains(&found) {
        return Err(Conflict::Read);
    }
    match files.announced.get(&found) {
        Some(other) if other != option => Err(Conflict::Written(other.clone())),
        _ => {
            files.announced.insert(found, option.to_owned());
            Ok(())
        }
    }
}

/// Notes that the file at `found`, links followed, is written: a later part of the program may read it.
pub(crate) fn written(found: &Path) {
    if let Some(mut files) = files() {
        files.announced.remove(found);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{input, output};
    use std::fs;

    /// One test, as all share the files of the process.
    #[test]
    fn what_is_read_is_not_written() {
        let folder = tempfile::tempdir().unwrap();
        let [a, b, c] = ["a", "b", "c"].map(|name| folder.path().join(name));
        let write = |path: &Path| output::write_file(path, true, |out| out.write_all(b"new"));
        fs::write(&a, "old").unwrap();
        input::open(&a).unwrap();
        write(&a).unwrap();

        watch();
        let same = folder.path().join("../").join(folder.path().file_name().unwrap()).join("a");
        will_write("--csv", &a).unwrap();
        assert_eq!(will_write("--csv", &a), Ok(()));
        assert_eq!(will_write("--out", &same), Err(Conflict::Written("--csv".to_owned())));
        let refused = input::open(&same).unwrap_err().to_string();
        assert!(refused.contains("--csv"), "{refused}");
        // Once written, it is a file like any other.
        write(&a).unwrap();
        input::open(&a).unwrap();
        assert!(is_read(&same) && !is_read(&b));
        assert_eq!(will_write("--out", &same), Err(Conflict::Read));
        let refused = write(&same).unwrap_err().to_string();
        assert!(refused.contains("also read"), "{refused}");
        assert_eq!(fs::read(&a).unwrap(), b"new");
        #[cfg(unix)]
        {
            std::os::unix::fs::symlink("a", &c).unwrap();
            assert!(write(&c).is_err() && is_read(&c));
            output::write_file(Path::new("/dev/null"), true, |out| out.write_all(b"x")).unwrap();
        }
        write(&b).unwrap();
    }
}
