//! Files that appear whole or not at all.

use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use thiserror::Error;

/// Why a file was not written. The file system is then as it was before.
#[derive(Debug, Error)]
pub enum WriteError {
    /// The file exists and may not be replaced.
    #[error("{}: the file exists; name another, or use --force to replace it", .0.display())]
    Exists(PathBuf),
    /// The file system refuses.
    #[error("{}: cannot write ({source}); check the folder, its permissions and free space", path.display())]
    Io {
        /// The file to be written.
        path: PathBuf,
        /// The reason given by the system.
        source: io::Error,
    },
}

/// Writes `path` through a temporary file in the same folder, and renames it when `contents` is done.
///
/// The function replaces an existing file only if `force` is set, even a file that another program creates meanwhile.
///
/// # Errors
/// [`WriteError::Exists`] without `force`, [`WriteError::Io`] for an error of the system or of `contents`.
pub fn write_file(
    path: &Path,
    force: bool,
    contents: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), WriteError> {
    if !force && path.symlink_metadata().is_ok() {
        return Err(WriteError::Exists(path.to_owned()));
    }
    let failed = |source| WriteError::Io { path: path.to_owned(), source };
    let folder = path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut builder = tempfile::Builder::new();
    builder.prefix(".dualsplit-");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    let mut file = builder.tempfile_in(folder).map_err(failed)?;
    let mut writer = BufWriter::with_capacity(1 << 16, file.as_file_mut());
    contents(&mut writer).and_then(|()| writer.flush()).map_err(failed)?;
    drop(writer);
    let persisted = if force { file.persist(path) } else { file.persist_noclobber(path) };
    match persisted {
        Ok(_) => Ok(()),
        Err(e) if e.error.kind() == io::ErrorKind::AlreadyExists => Err(WriteError::Exists(path.to_owned())),
        Err(e) => Err(failed(e.error)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

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
}
