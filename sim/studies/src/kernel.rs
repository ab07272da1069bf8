//! Programs of the user's own for the machine: read or compiled, and what they are made from.

use crate::fidelity::FidelityError;
use crate::input::display;
use anyhow::{Context, anyhow, bail, ensure};
use base::output::{Unfinished, WriteError, write_file};
use machine::core::SimulationError;
use machine::frame::{FrameError, Kernel};
use machine::kernels::{FILES, OPTIONS, statement};
use sha2::{Digest, Sha256};
use std::collections::HashMap;
use std::ffi::OsStr;
use std::fs::{self, File};
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

/// Largest file that is read as a listing, and largest output of the compiler.
const MOST_BYTES: u64 = 4 << 20;

/// The example among the files of [`dump`].
pub const EXAMPLE: &str = "examples/no-t-min.c";

/// Seconds that the compiler may take; it takes less than one.
const MOST_SECONDS: u64 = 60;

/// A program with the file that it comes from.
#[derive(Clone, Debug)]
pub struct Program {
    /// The file as the user names it.
    pub file: String,
    /// The program.
    pub kernel: Kernel,
    /// SHA-256 of the listing: of the file `.s`, or of what a file `.c` is compiled to, without comments and directives as
    /// `cargo xtask kernels` writes it.
    pub sha256: String,
    /// Where in the source each line of a compiled listing comes from; empty for a listing that was read.
    origins: Vec<String>,
}

impl Program {
    /// Reads the listing `path` (`.s`), or compiles the program `path` (`.c`) with these `defines`.
    ///
    /// # Errors
    /// The file has another extension, cannot be read or compiled, or there is no compiler.
    pub fn load(path: &Path, defines: &[&str], may_differ: bool) -> anyhow::Result<Self> {
        let file = display(path);
        let is_file = fs::metadata(path).with_context(|| format!("{file}: cannot read"))?.is_file();
        ensure!(is_file, "{file}: this is no file; name a listing (.s) or a program in C (.c)");
        let (name, listing, origins) = match path.extension().and_then(|extension| extension.to_str()) {
            Some("s" | "S") => (file.clone(), read(path).with_context(|| file.clone())?, vec![]),
            Some("c") => {
                let (listing, origins) = compile(path, defines)?;
                (format!("the listing of {file}"), listing, origins)
            }
            _ => bail!("{file}: a kernel is a listing (.s) or a program in C (.c); rename the file"),
        };
        let sha256 = Sha256::digest(&listing).iter().map(|byte| format!("{byte:02x}")).collect();
        Ok(Self { file, kernel: Kernel { name, listing, may_differ }, sha256, origins })
    }

    /// `error` with the instruction that it is about, and where that is in the source of a program in C.
    #[must_use]
    pub fn explained(&self, error: FidelityError) -> anyhow::Error {
        let Some(line) = line_of(&error).and_then(|line| line.checked_sub(1)) else { return error.into() };
        match (self.kernel.listing.lines().nth(line), self.origins.get(line)) {
            (Some(text), Some(origin)) => anyhow!("{error} (`{}`, {origin})", text.trim()),
            (Some(text), None) => anyhow!("{error} (`{}`)", text.trim().replace('\t', " ")),
            (None, _) => error.into(),
        }
    }
}

/// The line of a program that `error` is about.
fn line_of(error: &FidelityError) -> Option<usize> {
    match error {
        FidelityError::Frame(FrameError::Listing(error)) => Some(error.line),
        FidelityError::Fault(fault)
        | FidelityError::Simulation(SimulationError::Fault(fault))
        | FidelityError::Frame(FrameError::Simulation(SimulationError::Fault(fault))) => {
            Some(fault.line as usize)
        }
        _ => None,
    }
}

/// The text of a file of at most [`MOST_BYTES`].
fn read(path: &Path) -> anyhow::Result<String> {
    let mut bytes = vec![];
    base::input::open(path)?.take(MOST_BYTES + 1).read_to_end(&mut bytes)?;
    ensure!(bytes.len() as u64 <= MOST_BYTES, "a listing has at most {MOST_BYTES} bytes");
    let text = String::from_utf8(bytes);
    text.map_err(|error| {
        let before = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let line = before.iter().filter(|byte| **byte == b'\n').count() + 1;
        anyhow!("line {line}: this is not UTF-8, so it is no listing")
    })
}

/// The listing of a program in C, and where each of its lines comes from.
fn compile(path: &Path, defines: &[&str]) -> anyhow::Result<(String, Vec<String>)> {
    let folder = tempfile::tempdir().context("a folder for the compiler cannot be made")?;
    let include = folder.path().join("include");
    for (name, content) in FILES {
        let file = include.join(name);
        fs::create_dir_all(file.parent().expect("a file in a folder"))
            .and_then(|()| fs::write(&file, content))
            .with_context(|| format!("{}: cannot write", file.display()))?;
    }
    let _unfinished = Unfinished::new(folder.path());
    let [raw, said, sources] = ["kernel.s", "messages", "sources"].map(|name| folder.path().join(name));
    // A name that begins with a dash would be an option.
    let source = if path.is_absolute() { path.to_owned() } else { Path::new(".").join(path) };
    let clang = std::env::var_os("CLANG").unwrap_or_else(|| "clang-14".into());
    let mut compiler = Command::new(&clang)
        .args(OPTIONS.split_whitespace())
        .args(defines.iter().map(|name| format!("-D{name}")))
        // Positions in the source; instructions are the same with and without.
        .arg("-gline-tables-only")
        // Sources beside the program, edited after --dump-kernels, come before those of this crate.
        .args(own_folders(path).iter().flat_map(|folder| [OsStr::new("-I"), folder.as_os_str()]))
        .arg("-I")
        .arg(&include)
        .args(["-MD", "-MF"])
        .arg(&sources)
        .arg("-o")
        .args([&raw, &source])
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(File::create(&said)?)
        .spawn()
        .with_context(|| {
            format!(
                "{}: {} does not start, which compiles programs in C; install Debian's package clang-14, or name another \
                 clang 14 in the environment variable CLANG",
                path.display(),
                Path::new(&clang).display()
            )
        })?;
    let named =
        || format!("{}: the compiler {} (CLANG names it)", path.display(), Path::new(&clang).display());
    let Some(status) = wait(&mut compiler, MOST_SECONDS)? else {
        bail!("{} did not end within {MOST_SECONDS} s; name a clang 14 in CLANG", named());
    };
    if !status.success() {
        let said = base::input::read_file(&said, MOST_BYTES).unwrap_or_default();
        let said = String::from_utf8_lossy(&said);
        // Files of this crate are named as they are dumped.
        let said = said.replace(&format!("{}/", include.display()), "");
        bail!("{}: the compiler refuses it\n{}", path.display(), said.trim_end());
    }
    ensure!(raw.is_file(), "{} wrote no listing; name a clang 14 in CLANG", named());
    // What the program includes is read as well, and so is not written.
    let rules = base::input::read_own(&sources, MOST_BYTES).unwrap_or_default();
    for source in sources_of(&rules).iter().filter(|source| !source.starts_with(folder.path())) {
        base::guard::reads(source).with_context(|| display(source))?;
    }
    let text = read(&raw).with_context(|| format!("the listing of {}", path.display()))?;
    Ok(tidied(&text))
}

/// The files that the rules of a make file name behind their targets.
fn sources_of(rules: &str) -> Vec<PathBuf> {
    let joined = rules.replace("\\\n", " ");
    let names = joined.lines().filter_map(|line| Some(line.split_once(": ")?.1.replace("\\ ", "\0")));
    let paths = |names: String| {
        let names: Vec<_> = names.split_whitespace().map(|name| name.replace('\0', " ").into()).collect();
        names
    };
    names.flat_map(paths).collect()
}

/// The folders of the program `path` whose sources come first: its own, and the one above where that holds a header of
/// [`kernel::dump`](dump), as for the example.
fn own_folders(path: &Path) -> Vec<PathBuf> {
    let own = path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let above = own.join("..");
    let is_dumped = above.join(FILES[0].0).is_file();
    [own.to_owned()].into_iter().chain(is_dumped.then_some(above)).collect()
}

/// The status of `child`, or none if it did not end within `seconds` and was ended.
fn wait(child: &mut Child, seconds: u64) -> std::io::Result<Option<ExitStatus>> {
    let end = Instant::now() + Duration::from_secs(seconds);
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(Some(status));
        }
        if Instant::now() > end {
            child.kill()?;
            child.wait()?;
            return Ok(None);
        }
        std::thread::sleep(Duration::from_millis(10));
    }
}

/// A compiler's output without comments, directives and debugging data, and where each of its lines comes from.
fn tidied(raw: &str) -> (String, Vec<String>) {
    let (mut listing, mut origins) = (String::new(), vec![]);
    let mut files: HashMap<&str, String> = HashMap::new();
    let mut origin = "no line of the source".to_owned();
    for line in raw.lines() {
        let mut words = line.split('#').next().unwrap_or_default().split_whitespace();
        match words.next() {
            Some(".section") if line.contains(".debug_") => break,
            Some(".file") => {
                // `.file NUMBER "FOLDER" "NAME"`, the folder being optional.
                let quoted: Vec<&str> = line.split('"').skip(1).step_by(2).collect();
                if let (Some(number), Some(name)) =
                    (words.next(), quoted.iter().rfind(|text| !text.is_empty()))
                {
                    let name = Path::new(name).file_name().unwrap_or_default();
                    files.insert(number, name.to_string_lossy().into_owned());
                }
            }
            Some(".loc") => {
                if let (Some(file), Some(line)) =
                    (words.next().and_then(|number| files.get(number)), words.next())
                {
                    origin = format!("{file}, line {line}");
                }
            }
            _ => {
                if let Some(statement) = statement(line) {
                    listing += &statement;
                    origins.push(origin.clone());
                }
            }
        }
    }
    (listing, origins)
}

/// Writes what programs are made from into `folder`: the header that documents the machine, the sources, the example, and the
/// listings of all structures. Returns the files.
///
/// # Errors
/// A file exists, without `force`, or cannot be written. A file that exists is noticed before any is written.
pub fn dump(folder: &Path, force: bool) -> anyhow::Result<Vec<PathBuf>> {
    let files = FILES.map(|(name, content)| (folder.join(name), content));
    if let Some((path, _)) = files.iter().find(|(path, _)| !force && path.symlink_metadata().is_ok()) {
        bail!(WriteError::Exists(path.clone()));
    }
    for (path, content) in &files {
        let parent = path.parent().expect("a file in a folder");
        fs::create_dir_all(parent)
            .with_context(|| format!("{}: cannot make the folder; name another", parent.display()))?;
        write_file(path, force, |out| out.write_all(content.as_bytes()))?;
    }
    Ok(files.into_iter().map(|(path, _)| path).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tidied_listing_keeps_positions_and_drops_debugging_data() {
        let raw = "\t.file\t\"a.c\"\n\t.file\t0 \"/home\" \"a.c\" md5 0x1\n$tmp0:\nmain:\n\t.loc\t0 7 2 # a.c:7\n\
                   \tmove\t$2, $3  # copy\n\t.file\t1 \"./b.h\"\n\t.loc\t1 9 1\n\tjr\t$ra\n\tnop\n\
                   \t.section\t.debug_str\n$info:\n\t.4byte\t1\n";
        let (listing, origins) = tidied(raw);
        assert_eq!(listing, "main:\n    move $2, $3\n    jr $ra\n    nop\n");
        assert_eq!(origins[1..], ["a.c, line 7", "b.h, line 9", "b.h, line 9"]);
    }

    #[test]
    fn the_sources_of_a_program_are_what_its_rules_name() {
        let rules = "kernel.s: ./a.c \\\n  b/my\\ own.h c.h\n";
        assert_eq!(sources_of(rules), ["./a.c", "b/my own.h", "c.h"].map(PathBuf::from));
    }

    #[test]
    #[cfg(unix)]
    fn a_program_that_does_not_end_is_ended() {
        let mut sleeps = Command::new("sleep").arg("600").spawn().unwrap();
        assert!(wait(&mut sleeps, 0).unwrap().is_none());
        let mut ends = Command::new("true").spawn().unwrap();
        assert!(wait(&mut ends, 60).unwrap().unwrap().success());
    }
}
