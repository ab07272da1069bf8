//! `cargo xtask docs`: are the tables and figures of README.md and docs/ what their commands make?
//!
//! A comment in front of each table and each figure says where it is from ([`markdown::Mark`]); CONTRIBUTING.md explains the forms.

mod markdown;
mod recipes;
mod rules;
mod select;
mod workplace;

use crate::behaviour::hashes::digest;
use crate::workspace::{must_succeed, root, scratch, target};
use anyhow::{Context, ensure};
use lexopt::prelude::*;
use markdown::{Mark, Part, Small};
use rules::Fault;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::Instant;
use workplace::Workplace;

/// Files at once. Most commands keep one processor busy.
const WORKERS: usize = 2;

/// What the command line asks for.
#[derive(Debug)]
pub struct Options {
    check: bool,
    tool: Option<PathBuf>,
    only: Vec<String>,
}

impl Options {
    /// Reads what follows the command's name.
    pub fn parse(mut arguments: lexopt::Parser) -> anyhow::Result<Self> {
        let mut options = Self { check: false, tool: None, only: vec![] };
        while let Some(argument) = arguments.next()? {
            match argument {
                Long("check") => options.check = true,
                Long("tool") => options.tool = Some(arguments.value()?.into()),
                Long("only") => options.only.push(arguments.value()?.string()?),
                other => return Err(other.unexpected().into()),
            }
        }
        Ok(options)
    }
}

/// A Markdown file.
struct File {
    /// Its path from the root, with `/`.
    name: String,
    text: String,
    parts: Vec<Part>,
}

/// Lines `from` to `to` of a file, without the latter, in the place of which others belong.
#[derive(Debug, PartialEq, Eq)]
struct Edit {
    from: usize,
    to: usize,
    lines: Vec<String>,
    /// What is to be said about it.
    why: String,
}

/// Checks or makes the files; whether nothing differed and nothing failed.
pub fn run(options: &Options) -> anyhow::Result<bool> {
    let all = names()?;
    let absent = options.only.iter().find(|name| !all.contains(name));
    ensure!(
        absent.is_none(),
        "--only {}: the files are {}",
        absent.unwrap_or(&String::new()),
        all.join(", ")
    );
    let chosen = all.into_iter().filter(|name| options.only.is_empty() || options.only.contains(name));
    let files = chosen.map(|name| File::read(&name)).collect::<anyhow::Result<Vec<File>>>()?;
    let mut good = true;
    for file in &files {
        for (line, fault) in file.faults() {
            println!("{}:{}: {fault}", file.name, line + 1);
            good = false;
        }
    }
    let start = Instant::now();
    let scratch = scratch("docs-run")?;
    let programs = programs(options.tool.as_deref(), scratch.path())?;
    let queue = Mutex::new(files.iter());
    let done = Mutex::new(vec![]);
    let work = || {
        while let Some(file) = { queue.lock().expect("no worker panics").next() } {
            let edits = edits(file, &programs, scratch.path());
            done.lock().expect("no worker panics").push((file, edits));
        }
    };
    std::thread::scope(|scope| (0..WORKERS).for_each(|_| _ = scope.spawn(work)));
    let mut done = done.into_inner().expect("no worker panics");
    done.sort_by_key(|(file, _)| &file.name);
    for (file, (edits, failures)) in done {
        for (line, failure) in failures {
            println!("{}:{}: {failure}", file.name, line + 1);
            good = false;
        }
        for edit in &edits {
            println!("{}:{}: {}", file.name, edit.from + 1, edit.why);
        }
        if options.check {
            good &= edits.is_empty();
        } else if !edits.is_empty() {
            let path = root().join(&file.name);
            fs::write(&path, edited(&file.text, &edits)).with_context(|| path.display().to_string())?;
        }
    }
    eprintln!("{:8.2} s  all {} files", start.elapsed().as_secs_f64(), files.len());
    if !good {
        println!("`cargo xtask docs` makes what can be made anew");
    }
    Ok(good)
}

/// README.md and the files below docs/, by their paths from the root.
fn names() -> anyhow::Result<Vec<String>> {
    let mut names = vec!["README.md".to_owned()];
    let mut open = vec!["docs".to_owned()];
    while let Some(folder) = open.pop() {
        for entry in fs::read_dir(root().join(&folder)).with_context(|| folder.clone())? {
            let entry = entry?;
            let name = format!("{folder}/{}", entry.file_name().to_string_lossy());
            if entry.file_type()?.is_dir() {
                open.push(name);
            } else if name.ends_with(".md") {
                names.push(name);
            }
        }
    }
    names.sort();
    Ok(names)
}

impl File {
    fn read(name: &str) -> anyhow::Result<Self> {
        let text = fs::read_to_string(root().join(name)).with_context(|| name.to_owned())?;
        let parts = markdown::parts(&text).with_context(|| name.to_owned())?;
        Ok(Self { name: name.to_owned(), text, parts })
    }

    fn faults(&self) -> Vec<Fault> {
        rules::faults(&self.parts, self.name.ends_with("GUIDE.md"))
    }
}

/// A folder that holds the program `dualsplit`: the tool at `tool`, or that of the tests, which is built.
fn programs(tool: Option<&Path>, scratch: &Path) -> anyhow::Result<PathBuf> {
    let name = format!("dualsplit{}", std::env::consts::EXE_SUFFIX);
    let tool = match tool {
        Some(tool) => tool.to_owned(),
        None => {
            must_succeed("build --bin dualsplit", |_| {})?;
            target()?.join("debug").join(&name)
        }
    };
    let tool = tool.canonicalize().with_context(|| format!("{}: no such tool", tool.display()))?;
    let programs = scratch.join("bin");
    fs::create_dir_all(&programs)?;
    // A link beside the target folder costs nothing; another file system gets a copy.
    fs::hard_link(&tool, programs.join(&name))
        .or_else(|_| fs::copy(&tool, programs.join(&name)).map(|_| ()))?;
    Ok(programs)
}

/// What is to be changed in `file`, and what failed.
fn edits(file: &File, programs: &Path, scratch: &Path) -> (Vec<Edit>, Vec<Fault>) {
    let (mut edits, mut failures) = (vec![], vec![]);
    let folder = scratch.join(file.name.replace('/', "-"));
    let mut each = || -> anyhow::Result<()> {
        fs::create_dir_all(&folder).with_context(|| folder.display().to_string())?;
        let mut workplace = Workplace::new(&folder, programs)?;
        let lines: Vec<&str> = file.text.lines().collect();
        for (at, part) in file.parts.iter().enumerate() {
            let Part::Mark { line, below, mark } = part else { continue };
            let made = match mark {
                Mark::MadeBy(recipe) => workplace.make(recipe).map(|text| {
                    let end = file.parts[at..].iter().find(|part| matches!(part, Part::End { .. }));
                    let to = end.map_or(*below, Part::line);
                    edits.extend(block(&lines, *below, to, &text));
                }),
                Mark::Long { command, small } => small.iter().try_for_each(|small| {
                    let text = workplace.make(&small.recipe)?;
                    edits.extend(stated(small, command, &digest(text.as_bytes())));
                    Ok(())
                }),
                Mark::Runs => code(file, at).map_or(Ok(()), |lines| {
                    markdown::commands(lines)
                        .iter()
                        .try_for_each(|command| workplace.output(command).map(|_| ()))
                }),
                Mark::File(name) => code(file, at).map_or(Ok(()), |lines| {
                    let path = folder.join(name);
                    fs::write(&path, lines.join("\n") + "\n").with_context(|| path.display().to_string())
                }),
                Mark::Measured(_) | Mark::Published(_) | Mark::Written | Mark::NotRun(_) => Ok(()),
            };
            failures.extend(made.err().map(|error| (*line, format!("{error:#}"))));
        }
        Ok(())
    };
    if let Err(error) = each() {
        failures.push((0, format!("{error:#}")));
    }
    (edits, failures)
}

/// The lines of the block of code behind the mark `at`.
fn code(file: &File, at: usize) -> Option<&[String]> {
    match file.parts.get(at + 1) {
        Some(Part::Code { lines, .. }) => Some(lines),
        _ => None,
    }
}

/// The change of the block between the lines `from` and `to`, if it is not `text`. The fences of a block of code stay.
fn block(lines: &[&str], from: usize, to: usize, text: &str) -> Option<Edit> {
    let is_fence = |at: usize| at < to && lines[at].starts_with("```");
    let (from, to) = if is_fence(from) && is_fence(to - 1) { (from + 1, to - 1) } else { (from, to) };
    let made: Vec<&str> = text.lines().collect();
    let found = &lines[from..to];
    if found == made {
        return None;
    }
    let at = (0..).find(|&at| found.get(at) != made.get(at)).expect("they differ");
    let shown =
        |line: Option<&&str>| line.map_or("nothing".to_owned(), |line| format!("`{}`", line.trim_end()));
    let why = format!("was {}\n    and is made as {}", shown(found.get(at)), shown(made.get(at)));
    Some(Edit { from, to, lines: made.into_iter().map(str::to_owned).collect(), why })
}

/// The change of a digest, if it is not `found`.
fn stated(small: &Small, command: &str, found: &str) -> Option<Edit> {
    (small.digest != found).then(|| Edit {
        from: small.line,
        to: small.line + 1,
        lines: vec![format!("small {found}")],
        why: format!(
            "a small run gives another result than it did (digest {found}), so what is below may be stale: see whether `{command}` \
             still makes it"
        ),
    })
}

/// `text` with the edits made.
fn edited(text: &str, edits: &[Edit]) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    for edit in edits.iter().rev() {
        lines.splice(edit.from..edit.to, edit.lines.iter().cloned());
    }
    lines.join("\n") + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_table_and_figure_says_where_it_is_from() {
        let mut faults = vec![];
        for name in names().unwrap() {
            let file = File::read(&name).unwrap();
            faults.extend(
                file.faults().into_iter().map(|(line, fault)| format!("{name}:{}: {fault}", line + 1)),
            );
        }
        assert!(faults.is_empty(), "\n{}\n", faults.join("\n"));
    }

    fn file(text: &str) -> File {
        File { name: "a.md".to_owned(), text: text.to_owned(), parts: markdown::parts(text).unwrap() }
    }

    /// A program that prints a table, and fails if it is called `fail`.
    fn check(text: &str) -> (String, Vec<Fault>) {
        let scratch = scratch("docs-test").unwrap();
        let programs = scratch.path().join("bin");
        fs::create_dir_all(&programs).unwrap();
        let program = programs.join("dualsplit");
        fs::write(
            &program,
            "#!/bin/sh -e\ntest \"$1\" != fail\necho \"$@\" >>log\nprintf '| a |\\n|---|\\n| 1 |\\n'\n",
        )
        .unwrap();
        #[cfg(unix)]
        fs::set_permissions(&program, std::os::unix::fs::PermissionsExt::from_mode(0o755)).unwrap();
        let file = file(text);
        let (edits, failures) = edits(&file, &programs, scratch.path());
        (edited(text, &edits), failures)
    }

    #[cfg(unix)]
    #[test]
    fn stale_blocks_and_digests_are_made_anew() {
        let sha = digest(b"| a |\n|---|\n| 1 |\n");
        let with = |cell: &str, digest: &str| {
            format!(
                "# A\n<!-- made-by\ndualsplit tree\n-->\n| a |\n|---|\n| {cell} |\n<!-- end -->\n\n<!-- made-by\ndualsplit tree\n\
                 lines 3-3\n-->\n```\n| {cell} |\n```\n<!-- end -->\n\n<!-- long\ndualsplit tree --big\nsmall {digest}\ndualsplit tree\n\
                 -->\n| x |\n|---|\n"
            )
        };
        let good = with("1", &sha);
        assert_eq!(check(&good), (good.clone(), vec![]));
        assert_eq!(check(&with("2", markdown::NO_DIGEST)), (good, vec![]));
    }

    #[cfg(unix)]
    #[test]
    fn commands_that_fail_are_told_and_others_go_on() {
        let text = "<!-- runs -->\n```sh\ndualsplit fail\n```\n<!-- file: a.txt -->\n```\na\n```\n<!-- runs -->\n```sh\n\
                    dualsplit tree\ngrep tree log && grep a a.txt\n```\n";
        let (_, failures) = check(text);
        assert_eq!(failures.len(), 1, "{failures:?}");
        assert_eq!(failures[0].0, 0);
    }
}
