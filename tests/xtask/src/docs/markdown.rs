//! The parts of a Markdown file that can go stale: its tables, figures and commands, and the marks that say where they are from.

use anyhow::{Context, bail, ensure};

/// A part of a file. Lines are counted from 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Part {
    /// A comment that says where the next part is from, or, for [`Mark::MadeBy`], the parts down to [`Part::End`]. It ends above
    /// the line `below`.
    Mark { line: usize, below: usize, mark: Mark },
    /// `<!-- end -->`.
    End { line: usize },
    /// Consecutive lines that begin with a bar.
    Table { line: usize, lines: Vec<String> },
    /// A line that begins with a picture.
    Figure { line: usize },
    /// A fenced block in the language `language`, with the lines between its fences.
    Code { line: usize, language: String, lines: Vec<String> },
    /// A line of text that is not empty.
    Text { line: usize },
}

/// Where a part is from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Mark {
    /// Commands print it.
    MadeBy(Recipe),
    /// A run that takes too long to repeat made it. Each of the small runs of the same command still gives its digest.
    Long { command: String, small: Vec<Small> },
    /// It depends on the host, on programs or on data that not everybody has; this says how it was made.
    Measured(String),
    /// Others published it; this says where.
    Published(String),
    /// Somebody wrote it; it holds no results.
    Written,
    /// The commands of the block run in the folder of the file, and succeed.
    Runs,
    /// The block is put into the file of this name there.
    File(String),
    /// The commands of the block do not run; this says why.
    NotRun(String),
}

/// Commands, and what is taken of the last one's output.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Recipe {
    /// Lines for the shell, or one line `recipe NAME ARGUMENTS`.
    pub commands: Vec<String>,
    /// Selections, which [`super::select`] describes.
    pub selections: Vec<String>,
}

/// A small run in the place of a long one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Small {
    /// Where its line is.
    pub line: usize,
    /// The digest that the file states.
    pub digest: String,
    /// What is run and hashed.
    pub recipe: Recipe,
}

/// What stands for the digest of a small run that has not been made.
pub const NO_DIGEST: &str = "00000000000000000000000000000000";

impl Part {
    /// The line at which it begins.
    pub fn line(&self) -> usize {
        match self {
            Self::Mark { line, .. }
            | Self::End { line }
            | Self::Table { line, .. }
            | Self::Figure { line }
            | Self::Code { line, .. }
            | Self::Text { line } => *line,
        }
    }
}

/// The parts of `text` in order.
pub fn parts(text: &str) -> anyhow::Result<Vec<Part>> {
    let lines: Vec<&str> = text.lines().collect();
    let mut parts = vec![];
    let mut at = 0;
    while at < lines.len() {
        let line = at;
        let below = |end: usize| lines[line + 1..end].iter().map(|line| (*line).to_owned()).collect();
        let head = lines[at].trim_start();
        at += 1;
        if let Some(language) = head.strip_prefix("```") {
            at = line_after(&lines, at, |text| text.trim_start().starts_with("```"))
                .with_context(|| format!("line {}: the block has no end", line + 1))?;
            parts.push(Part::Code { line, language: language.trim().to_owned(), lines: below(at - 1) });
        } else if head.starts_with("<!--") {
            at = line_after(&lines, line, |text| text.contains("-->"))
                .with_context(|| format!("line {}: the comment has no end", line + 1))?;
            let comment = comment(line, &lines[line..at]);
            parts.push(comment.with_context(|| format!("line {}", line + 1))?);
        } else if head.starts_with('|') {
            at =
                (at..lines.len()).find(|&at| !lines[at].trim_start().starts_with('|')).unwrap_or(lines.len());
            let lines = lines[line..at].iter().map(|line| (*line).to_owned()).collect();
            parts.push(Part::Table { line, lines });
        } else if head.starts_with("![") {
            parts.push(Part::Figure { line });
        } else if !head.is_empty() {
            parts.push(Part::Text { line });
        }
    }
    Ok(parts)
}

/// The number of the line after the first one from `from` on that is `wanted`.
fn line_after(lines: &[&str], from: usize, wanted: impl Fn(&str) -> bool) -> Option<usize> {
    (from..lines.len()).find(|&at| wanted(lines[at])).map(|at| at + 1)
}

/// The mark that `lines` hold, of which the first is line `line` of the file.
fn comment(line: usize, lines: &[&str]) -> anyhow::Result<Part> {
    let text = lines.join("\n");
    let inside = text.trim().strip_prefix("<!--").and_then(|text| text.strip_suffix("-->"));
    let inside = inside.context("text behind a comment; give the comment lines of its own")?.trim();
    let (head, body) = inside.split_once('\n').unwrap_or((inside, ""));
    let (kind, rest) = head.split_once(':').map_or((head, ""), |(kind, rest)| (kind, rest.trim()));
    let told = || -> anyhow::Result<String> {
        ensure!(!rest.is_empty(), "the mark `{kind}` says behind a colon where it is from");
        Ok([rest, body].join(" ").split_whitespace().collect::<Vec<_>>().join(" "))
    };
    let mark = match kind.trim() {
        "end" => return Ok(Part::End { line }),
        "written" => Mark::Written,
        "runs" => Mark::Runs,
        "measured" => Mark::Measured(told()?),
        "published" => Mark::Published(told()?),
        "file" => Mark::File(told()?),
        "not-run" => Mark::NotRun(told()?),
        "made-by" => Mark::MadeBy(recipe(body.lines())?),
        "long" => long(line, body)?,
        other => bail!(
            "`{other}` is no mark; they are made-by, end, long, measured, published, written, runs, file and not-run"
        ),
    };
    Ok(Part::Mark { line, below: line + lines.len(), mark })
}

/// The lines of a recipe: those that begin with a command's name, and then selections.
fn recipe<'a>(lines: impl Iterator<Item = &'a str>) -> anyhow::Result<Recipe> {
    let is_command =
        |line: &String| ["dualsplit ", "cargo ", "recipe "].iter().any(|name| line.starts_with(name));
    let (commands, selections): (Vec<String>, Vec<String>) = joined(lines).into_iter().partition(is_command);
    ensure!(!commands.is_empty(), "a recipe has a line that begins with dualsplit, cargo or recipe");
    Ok(Recipe { commands, selections })
}

/// The lines, each with those below it that are indented more than the first.
fn joined<'a>(lines: impl Iterator<Item = &'a str>) -> Vec<String> {
    let mut joined: Vec<String> = vec![];
    for line in lines.filter(|line| !line.trim().is_empty()) {
        match joined.last_mut() {
            Some(last) if line.starts_with(' ') => *last = format!("{last} {}", line.trim()),
            _ => joined.push(line.trim().to_owned()),
        }
    }
    joined
}

/// A long run: its command, and `small DIGEST` above the recipe of each small run.
fn long(line: usize, body: &str) -> anyhow::Result<Mark> {
    let lines: Vec<&str> = body.lines().collect();
    let is_small = |at: &usize| lines[*at].starts_with("small ");
    let starts: Vec<usize> = (0..lines.len()).filter(is_small).collect();
    let first = *starts.first().context("a long run has a line `small DIGEST` above a small run")?;
    let command = joined(lines[..first].iter().copied()).join("\n");
    ensure!(!command.is_empty(), "a long run begins with its command");
    let ends = starts.iter().skip(1).copied().chain([lines.len()]);
    let small = |(start, end): (&usize, usize)| {
        let digest = lines[*start].trim_start_matches("small ").trim();
        let is_digest =
            digest.len() == NO_DIGEST.len() && digest.bytes().all(|byte| byte.is_ascii_hexdigit());
        ensure!(is_digest, "{digest}: a digest is {} hexadecimal digits", NO_DIGEST.len());
        // The line of the comment's head precedes the body.
        let recipe = recipe(lines[start + 1..end].iter().copied())?;
        Ok(Small { line: line + 1 + start, digest: digest.to_owned(), recipe })
    };
    Ok(Mark::Long { command, small: starts.iter().zip(ends).map(small).collect::<anyhow::Result<_>>()? })
}

/// The commands of a block, of which a backslash joins lines.
pub fn commands(lines: &[String]) -> Vec<String> {
    let text = lines.join("\n").replace("\\\n", " ");
    let words = |line: &str| line.split_whitespace().collect::<Vec<_>>().join(" ");
    text.lines().map(words).filter(|line| !line.is_empty() && !line.starts_with('#')).collect()
}

/// The cells of a line of a table.
pub fn cells(line: &str) -> Vec<&str> {
    let line = line.trim();
    let inside = line.strip_prefix('|').unwrap_or(line);
    inside.strip_suffix('|').unwrap_or(inside).split('|').map(str::trim).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_found_with_their_lines() {
        let text = "# A\n\n<!-- written -->\n| a |\n|---|\n| b |\n\n```sh\n| no table |\n```\n![x](y.png)\n";
        let found = parts(text).unwrap();
        let table = ["| a |", "|---|", "| b |"].map(str::to_owned).to_vec();
        assert_eq!(
            found,
            [
                Part::Text { line: 0 },
                Part::Mark { line: 2, below: 3, mark: Mark::Written },
                Part::Table { line: 3, lines: table },
                Part::Code { line: 7, language: "sh".into(), lines: vec!["| no table |".into()] },
                Part::Figure { line: 10 },
            ]
        );
    }

    #[test]
    fn marks_hold_commands_and_selections() {
        let text = "<!-- made-by\ndualsplit tree a\n  --scratch\ntable 1\nwithout b ms\n-->\n<!-- end -->\n";
        let Part::Mark { mark: Mark::MadeBy(recipe), .. } = &parts(text).unwrap()[0] else { panic!() };
        assert_eq!(recipe.commands, ["dualsplit tree a --scratch"]);
        assert_eq!(recipe.selections, ["table 1", "without b ms"]);

        let text = "x\n<!-- long\ndualsplit stress --rays 9\nsmall 0123456789abcdef0123456789abcdef\ndualsplit stress --rays 1 --json\n-->\n";
        let Part::Mark { mark: Mark::Long { command, small }, .. } = &parts(text).unwrap()[1] else {
            panic!()
        };
        assert_eq!(command, "dualsplit stress --rays 9");
        assert_eq!((small[0].line, small[0].digest.as_str()), (3, "0123456789abcdef0123456789abcdef"));
        assert_eq!(small[0].recipe.commands, ["dualsplit stress --rays 1 --json"]);
    }

    #[test]
    fn commands_go_on_behind_a_backslash() {
        let lines = ["dualsplit tree a \\", "  --scratch", "", "# then", "ls"].map(str::to_owned);
        assert_eq!(commands(&lines), ["dualsplit tree a --scratch", "ls"]);
    }

    #[test]
    fn what_is_no_mark_is_refused() {
        for (text, word) in [
            ("<!-- by me -->", "no mark"),
            ("<!-- measured -->", "colon"),
            ("<!-- made-by\ntable 1\n-->", "dualsplit"),
            ("<!-- long\ndualsplit a\n-->", "small"),
            ("<!-- long\ndualsplit a\nsmall 12\ndualsplit b\n-->", "hexadecimal"),
            ("<!-- written", "no end"),
            ("<!-- written --> text", "lines of its own"),
            ("```sh\na", "no end"),
        ] {
            let error = format!("{:#}", parts(text).unwrap_err());
            assert!(error.contains(word), "{text}: {error}");
        }
    }
}
