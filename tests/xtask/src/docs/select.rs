//! What is taken of a command's output.
//!
//! | selection | what it leaves |
//! |---|---|
//! | `table N` | the Nth table, counted from 1 |
//! | `lines A-B` | these lines, counted from 1 |
//! | `only A, B` | of a table, the columns with these headings |
//! | `without A, B` | of a table, the other columns |
//! | `rows A, B` | of a table, the rows that begin with one of these cells |
//!
//! Columns keep the spaces that align them.

use super::markdown::cells;
use anyhow::{Context, bail, ensure};

/// What `selections` leave of `output`, one after another. Ends in a line break.
pub fn select(output: &str, selections: &[String]) -> anyhow::Result<String> {
    let mut lines: Vec<String> = output.lines().map(|line| line.trim_end().to_owned()).collect();
    for selection in selections {
        lines = one(&lines, selection).with_context(|| format!("selection `{selection}`"))?;
    }
    Ok(lines.join("\n") + "\n")
}

fn one(lines: &[String], selection: &str) -> anyhow::Result<Vec<String>> {
    let (word, rest) = selection.split_once(' ').unwrap_or((selection, ""));
    let names: Vec<&str> = rest.split(',').map(str::trim).collect();
    match word {
        "table" => {
            let number: usize = rest.parse().context("write `table` and a number")?;
            table(lines, number).with_context(|| format!("the output has no table {number}"))
        }
        "lines" => {
            let (first, last) = rest.split_once('-').context("write `lines` and A-B")?;
            let (first, last): (usize, usize) = (first.parse()?, last.parse()?);
            ensure!(
                (1..=last).contains(&first) && last <= lines.len(),
                "the output has {} lines",
                lines.len()
            );
            Ok(lines[first - 1..last].to_vec())
        }
        "only" => columns(lines, &names, true),
        "without" => columns(lines, &names, false),
        "rows" => {
            let absent = names.iter().find(|name| !lines.iter().any(|line| cells(line)[0] == **name));
            ensure!(absent.is_none(), "no row begins with `{}`", absent.unwrap_or(&""));
            let kept =
                lines.iter().enumerate().filter(|(at, line)| *at < 2 || names.contains(&cells(line)[0]));
            Ok(kept.map(|(_, line)| line.clone()).collect())
        }
        _ => bail!("the selections are table, lines, only, without and rows"),
    }
}

/// The table `number`, counted from 1.
fn table(lines: &[String], number: usize) -> Option<Vec<String>> {
    let is_row = |line: &&String| line.starts_with('|');
    let mut rest = lines;
    for left in (0..number).rev() {
        let start = rest.iter().position(|line| line.starts_with('|'))?;
        let found: Vec<String> = rest[start..].iter().take_while(is_row).cloned().collect();
        if left == 0 {
            return Some(found);
        }
        rest = &rest[start + found.len()..];
    }
    None
}

/// The columns of a table whose headings are among `names`, or are not.
fn columns(lines: &[String], names: &[&str], wanted: bool) -> anyhow::Result<Vec<String>> {
    let head = lines.first().context("there is no table")?;
    let header = cells(head);
    for name in names {
        ensure!(header.contains(name), "no column is called `{name}`; they are {}", header.join(", "));
    }
    let row = |line: &String| {
        let inside = line.trim_start_matches('|');
        let cells = inside.strip_suffix('|').unwrap_or(inside).split('|').zip(&header);
        let kept: Vec<&str> =
            cells.filter(|(_, heading)| names.contains(heading) == wanted).map(|(cell, _)| cell).collect();
        format!("|{}|", kept.join("|"))
    };
    Ok(lines.iter().map(row).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    const OUTPUT: &str =
        "Trees\n\n| a | b ms |\n|---|------|\n| x |  1.5 |\n\n| c |\n|---|\n| y |\n| z |\nend\n";

    fn selected(selections: &[&str]) -> String {
        let selections: Vec<String> = selections.iter().map(|selection| (*selection).to_owned()).collect();
        select(OUTPUT, &selections).unwrap_or_else(|error| format!("{error:#}"))
    }

    #[test]
    fn tables_lines_columns_and_rows_are_taken() {
        assert_eq!(selected(&[]), OUTPUT);
        assert_eq!(selected(&["table 1", "without b ms"]), "| a |\n|---|\n| x |\n");
        assert_eq!(selected(&["table 1", "only b ms"]), "| b ms |\n|------|\n|  1.5 |\n");
        assert_eq!(selected(&["table 2", "rows z"]), "| c |\n|---|\n| z |\n");
        assert_eq!(selected(&["lines 1-1"]), "Trees\n");
    }

    #[test]
    fn what_is_not_there_is_an_error() {
        for (selections, word) in [
            (&["table 3"][..], "no table 3"),
            (&["table 1", "without c"], "no column"),
            (&["table 2", "rows q"], "no row"),
            (&["lines 3-99"], "lines"),
            (&["sorted"], "the selections are"),
        ] {
            assert!(selected(selections).contains(word), "{selections:?}: {}", selected(selections));
        }
    }
}
