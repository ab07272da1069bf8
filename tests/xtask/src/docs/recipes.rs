//! Tables that no single command prints.

mod machine;
mod study;

use super::workplace::Workplace;
use anyhow::{Context, bail};
use serde_json::Value;

/// The table that a line `recipe LINE` asks for.
pub fn make(line: &str, workplace: &mut Workplace<'_>) -> anyhow::Result<String> {
    let words: Vec<&str> = line.split_whitespace().collect();
    match &words[..] {
        ["study", what @ ..] => study::table(what),
        ["sensitivity"] => study::ranges(workplace),
        ["machine", what @ ..] => machine::table(what, workplace),
        _ => bail!("recipe {line}: the recipes are study, sensitivity and machine"),
    }
    .with_context(|| format!("recipe {line}"))
}

/// A Markdown table whose first column is text and whose other columns are numbers.
fn table(header: &[&str], rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    let header: Vec<String> = header.iter().map(|cell| (*cell).to_owned()).collect();
    let mut text = line(&header) + "|---|" + &"--:|".repeat(header.len() - 1) + "\n";
    rows.into_iter().for_each(|row| text += &line(&row));
    text
}

/// A count with commas between thousands.
fn count(n: u64) -> String {
    let digits = n.to_string();
    let mut text = String::new();
    for (at, digit) in digits.chars().enumerate() {
        if at > 0 && (digits.len() - at).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// The number at `path` in `document`, with dots between keys.
fn number(document: &Value, path: &str) -> anyhow::Result<f64> {
    let found = path.split('.').try_fold(document, |value, key| value.get(key));
    found.and_then(Value::as_f64).with_context(|| format!("{path}: no such number"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_and_counts_are_as_in_the_documents() {
        assert_eq!(
            table(&["a", "b"], [vec!["x".to_owned(), "1".to_owned()]]),
            "| a | b |\n|---|--:|\n| x | 1 |\n"
        );
        assert_eq!([7, 1000, 12_345_678].map(count), ["7", "1,000", "12,345,678"]);
        let document = serde_json::json!({"a": {"b": 1.5}});
        assert_eq!(number(&document, "a.b").unwrap(), 1.5);
        assert!(number(&document, "a.c").is_err());
    }
}
