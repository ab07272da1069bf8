//! TOML of users, read within limits.

use serde::de::{DeserializeOwned, Error as _};
use toml::de::Error;
use toml_parser::{Source, lexer::TokenKind};

/// The most brackets and braces that open in a text, outside of strings and comments.
///
/// The parser calls itself for each that is open, and its own limit does not count those behind an error. At this number it needs
/// about a megabyte of stack in a debug build.
const MOST_OPENED: usize = 256;

/// The value in `text`.
///
/// # Errors
/// The text is no TOML, has other keys than `T`, or opens more brackets and braces than are read.
pub fn parse<T: DeserializeOwned>(text: &str) -> Result<T, Error> {
    let opens = |kind: TokenKind| matches!(kind, TokenKind::LeftCurlyBracket | TokenKind::LeftSquareBracket);
    let opened = Source::new(text).lex().filter(|token| opens(token.kind())).count();
    if opened > MOST_OPENED {
        return Err(Error::custom(format!(
            "{opened} brackets and braces open; at most {MOST_OPENED} are read"
        )));
    }
    toml::from_str(text)
}

#[cfg(test)]
mod tests {
    use super::*;
    use toml::Table;

    /// Each line closes what was not open, so that the parser's own limit never counts to its end.
    #[test]
    fn tables_that_never_close_are_refused() {
        let line = "a = { b = 1 {}\n";
        let error = parse::<Table>(&line.repeat(20_000)).unwrap_err();
        assert_eq!(error.message(), "40000 brackets and braces open; at most 256 are read");
        // What may be read fits on the stack of a test.
        assert!(parse::<Table>(&line.repeat(MOST_OPENED / 2)).is_err());
    }

    #[test]
    fn brackets_in_strings_and_comments_open_nothing() {
        let text = format!("a = '{}' # {}\n[b]\nc = [1, [2]]", "[".repeat(300), "{".repeat(300));
        let table: Table = parse(&text).unwrap();
        assert_eq!(table["a"].as_str().map(str::len), Some(300));
        assert_eq!(table["b"]["c"].as_array().map(Vec::len), Some(2));
    }
}
