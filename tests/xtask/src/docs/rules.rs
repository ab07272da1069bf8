//! What is demanded of every file: each table and each figure says where it is from.

use super::markdown::{Mark, Part, cells};

/// A line of a file, counted from 0, and what is wrong there.
pub type Fault = (usize, String);

/// The faults of a file with these `parts`. In a guide, each block of commands has a mark as well.
pub fn faults(parts: &[Part], is_guide: bool) -> Vec<Fault> {
    let mut faults = vec![];
    // The line of the block that is open, and the mark in front of the part.
    let (mut open, mut before): (Option<usize>, Option<(usize, &Mark)>) = (None, None);
    for part in parts {
        let line = part.line();
        let mark = before.take();
        let mut fault = |line: usize, text: &str| faults.push((line, text.to_owned()));
        match part {
            Part::Mark { mark: Mark::MadeBy(_), .. } => {
                if open.replace(line).is_some() {
                    fault(line, "a block begins in another; the first has no `<!-- end -->`");
                }
            }
            Part::Mark { mark, .. } => before = Some((line, mark)),
            Part::End { .. } => {
                if open.take().is_none() {
                    fault(line, "no block is open here");
                }
            }
            Part::Table { lines, .. } => match mark {
                _ if open.is_some() => {}
                Some((_, Mark::Written)) => {
                    if let Some(heading) = numbers(lines) {
                        fault(line, &format!("a written table has no results, and `{heading}` are numbers"));
                    }
                }
                Some((_, Mark::Long { .. } | Mark::Measured(_) | Mark::Published(_))) => {}
                _ => fault(line, "the table has no mark"),
            },
            Part::Figure { .. } => {
                if open.is_none() && !matches!(mark, Some((_, Mark::Long { .. } | Mark::Measured(_)))) {
                    fault(line, "the figure has no mark");
                }
            }
            Part::Code { language, .. } => {
                let is_marked = matches!(
                    mark,
                    Some((_, Mark::Runs | Mark::File(_) | Mark::NotRun(_) | Mark::Measured(_)))
                );
                if is_guide && language == "sh" && !is_marked && open.is_none() {
                    fault(line, "the commands have no mark");
                }
            }
            Part::Text { .. } => {}
        }
        if let Some((at, mark)) = mark {
            let fits = match mark {
                Mark::Runs | Mark::File(_) | Mark::NotRun(_) => matches!(part, Part::Code { .. }),
                Mark::Measured(_) => {
                    !matches!(part, Part::Text { .. } | Part::Mark { .. } | Part::End { .. })
                }
                _ => matches!(part, Part::Table { .. } | Part::Figure { .. }),
            };
            if !fits {
                fault(at, "the mark has nothing below it that it could be about");
            }
        }
    }
    faults.extend(before.map(|(at, _)| (at, "the mark is the last part of the file".to_owned())));
    faults.extend(open.map(|at| (at, "the block has no `<!-- end -->`".to_owned())));
    faults
}

/// The heading of a column of which all cells are numbers with more digits than a count of a few.
fn numbers(lines: &[String]) -> Option<String> {
    let is_number = |cell: &str| {
        let digits = cell.trim_end_matches(['%', 'x']).trim().replace(',', "");
        digits.parse::<f64>().is_ok() && digits.len() > 1
    };
    let rows: Vec<Vec<&str>> = lines.iter().skip(2).map(|line| cells(line)).collect();
    let header = cells(lines.first()?);
    let column = (0..header.len()).find(|&at| {
        !rows.is_empty() && rows.iter().all(|row| row.get(at).is_some_and(|cell| is_number(cell)))
    });
    column.map(|at| header[at].to_owned())
}

#[cfg(test)]
mod tests {
    use super::super::markdown::parts;
    use super::*;

    fn found(text: &str) -> Vec<Fault> {
        faults(&parts(text).unwrap(), true)
    }

    #[test]
    fn marked_parts_have_no_fault() {
        let text = "<!-- written -->\n| a |\n|---|\n| b |\n\n<!-- measured: on a host -->\n![x](y)\n\n\
                    <!-- made-by\ndualsplit a\n-->\n| a |\n|---|\n| 12 |\n<!-- end -->\n\n<!-- runs -->\n```sh\nx\n```\n";
        assert_eq!(found(text), []);
    }

    #[test]
    fn each_fault_is_told_with_its_line() {
        for (text, line, word) in [
            ("| a |\n|---|\n", 0, "no mark"),
            ("x\n![x](y)\n", 1, "figure"),
            ("<!-- written -->\n![x](y)\n", 1, "figure"),
            ("<!-- written -->\n| a |\n|---|\n| 1,200 |\n", 1, "`a` are numbers"),
            ("<!-- written -->\ntext\n", 0, "nothing below"),
            ("<!-- written -->\n", 0, "last part"),
            ("<!-- made-by\ndualsplit a\n-->\n| a |\n", 0, "no `<!-- end -->`"),
            ("<!-- end -->\n", 0, "no block"),
            ("```sh\nx\n```\n", 0, "commands"),
        ] {
            let found = found(text);
            assert_eq!(found.len(), 1, "{text}: {found:?}");
            assert!(found[0].0 == line && found[0].1.contains(word), "{text}: {found:?}");
        }
        assert_eq!(faults(&parts("```sh\nx\n```\n").unwrap(), false), []);
    }
}
