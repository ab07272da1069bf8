//! Files that appear whole or not at all.

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use thiserror::Error;

use crate::guard;

/// Why a file was not written. The file system is then as it was before.
#[derive(Debug, Error)]
pub enum WriteError {
    /// The file exists and may not be replaced.
    #[error("{}: the file exists; name another, or use --force to replace it", .0.display())]
    Exists(PathBuf),
    /// The program reads the file (see [`guard`]).
    #[error("{}: this is also read; name another", .0.display())]
    Read(PathBuf),
    /// The file system refuses.
    #[error("{}: cannot write ({source}); check the folder, its permissions and free space", path.display())]
    Io {
        /// The file to be written.
        path: PathBuf,
        /// The reason given by the system.
        source: io::Error,
    },
}

/// Bytes that are written at once.
const BUFFER_BYTES: usize = 1 << 16;

/// Writes `path` through a temporary file in the same folder, and renames it when `contents` is done.
///
/// The function replaces an existing file only if `force` is set, even a file that another program creates meanwhile. It follows
/// links. What exists and is no regular file, such as a pipe or a device, holds nothing to replace: the function writes into it.
///
/// # Errors
/// [`WriteError::Exists`] without `force`, [`WriteError::Read`] for a file that a program watches and reads, [`WriteError::Io`] for an
/// error of the system or of `contents`.
pub fn write_file(
    path: &Path,
    force: bool,
    contents: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), WriteError> {
    let failed = |source| WriteError::Io { path: path.to_owned(), source };
    let buffered = |file: &mut File| {
        let mut writer = BufWriter::with_capacity(BUFFER_BYTES, file);
        contents(&mut writer).and_then(|()| writer.flush())
    };
    if is_special(path) {
        return File::options()
            .write(true)
            .open(path)
            .and_then(|mut file| buffered(&mut file))
            .map_err(failed);
    }
    if !force && path.exists() {
        return Err(WriteError::Exists(path.to_owned()));
    }
    if guard::is_read(path) {
        return Err(WriteError::Read(path.to_owned()));
    }
    let target = target(path).map_err(failed)?;
    let folder = target.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut builder = tempfile::Builder::new();
    builder.prefix(".dualsplit-");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    let mut file = builder.tempfile_in(folder).map_err(failed)?;
    let _unfinished = Unfinished::new(file.path());
    buffered(file.as_file_mut()).map_err(failed)?;
    let persisted = if force { file.persist(&target) } else { file.persist_noclobber(&target) };
    match persisted {
        Ok(_) => {
            guard::written(&target);
            Ok(())
        }
        Err(e) if e.error.kind() == io::ErrorKind::AlreadyExists => Err(WriteError::Exists(path.to_owned())),
        Err(e) => Err(failed(e.error)),
    }
}

/// Whether `path` leads to something that is neither a regular file nor a folder, such as a pipe or a device.
#[must_use]
pub fn is_special(path: &Path) -> bool {
    path.metadata().is_ok_and(|metadata| !metadata.is_file() && !metadata.is_dir())
}

/// Where `path` leads, links followed, whether there is a file or not.
///
/// # Errors
/// The folder does not exist, or links lead in a circle.
pub fn target(path: &Path) -> io::Result<PathBuf> {
    const MOST_LINKS: usize = 40;
    let mut path = path.to_owned();
    for _ in 0..MOST_LINKS {
        let Ok(next) = fs::read_link(&path) else {
            let name = path.file_name().ok_or(io::ErrorKind::InvalidInput)?.to_owned();
            let folder = path.parent().filter(|parent| !parent.as_os_str().is_empty());
            return Ok(folder.unwrap_or(Path::new(".")).canonicalize()?.join(name));
        };
        path = path.parent().unwrap_or(Path::new("")).join(next);
    }
    Err(io::Error::other("links lead in a circle"))
}

static UNFINISHED: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

fn unfinished() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    // A set of paths is whole after each of its operations.
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A temporary file or folder, which [`remove_unfinished`] removes as long as this value lives.
pub struct Unfinished(PathBuf);

impl Unfinished {
    /// The temporary file or folder `path`.
    #[must_use]
    pub fn new(path: &Path) -> Self {
        unfinished().insert(path.to_owned());
        Self(path.to_owned())
    }
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        unfinished().remove(&self.0);
    }
}

/// Removes all temporary files and folders, for a program that ends at once, as at a signal. What cannot be removed stays.
pub fn remove_unfinished() {
    for path in &*unfinished() {
        let _ = fs::remove_file(path).or_else(|_| fs::remove_dir_all(path));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refuses_to_overwrite_unless_forced() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        write_file(&path, false, |w| w.write_all(b"first")).unwrap();
        let refused = write_file(&path, false, |w| w.write_all(b"second"));
        assert!(matches!(refused, Err(WriteError::Exists(ref p)) if *p == path));
        assert_eq!(fs::read(&path).unwrap(), b"first");
        write_file(&path, true, |w| w.write_all(b"third")).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"third");
    }

    #[test]
    fn leaves_nothing_behind_on_failure() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        let failed = write_file(&path, false, |w| {
            w.write_all(b"half")?;
            Err(io::Error::other("no more"))
        });
        assert!(failed.unwrap_err().to_string().contains("no more"));
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
        let missing = write_file(&folder.path().join("no/such/a.txt"), true, |_| Ok(()));
        assert!(matches!(missing, Err(WriteError::Io { .. })));
    }

    #[test]
    #[cfg(unix)]
    fn links_are_followed() {
        let folder = tempfile::tempdir().unwrap();
        let [file, link, dangling] = ["file", "link", "dangling"].map(|name| folder.path().join(name));
        std::os::unix::fs::symlink("file", &link).unwrap();
        std::os::unix::fs::symlink("new", &dangling).unwrap();
        fs::write(&file, "old").unwrap();
        assert!(matches!(write_file(&link, false, |_| Ok(())), Err(WriteError::Exists(_))));
        write_file(&link, true, |w| w.write_all(b"new")).unwrap();
        write_file(&dangling, false, |w| w.write_all(b"made")).unwrap();
        assert!(link.is_symlink() && dangling.is_symlink());
        assert_eq!(
            (fs::read(&file).unwrap(), fs::read(folder.path().join("new")).unwrap()),
            (b"new".into(), b"made".into())
        );
        let circle = folder.path().join("circle");
        std::os::unix::fs::symlink("circle", &circle).unwrap();
        assert!(write_file(&circle, true, |_| Ok(())).is_err());
    }

    #[test]
    #[cfg(unix)]
    fn a_device_is_written_into_and_stays() {
        let device = Path::new("/dev/null");
        for force in [false, true] {
            write_file(device, force, |w| w.write_all(b"x")).unwrap();
            assert!(is_special(device));
        }
    }

    #[test]
    fn what_is_unfinished_can_be_removed() {
        let folder = tempfile::tempdir().unwrap();
        write_file(&folder.path().join("a"), false, |w| {
            w.write_all(b"half")?;
            assert_eq!(fs::read_dir(folder.path())?.count(), 1);
            remove_unfinished();
            assert_eq!(fs::read_dir(folder.path())?.count(), 0);
            Ok(())
        })
        .unwrap_err();
    }
}
