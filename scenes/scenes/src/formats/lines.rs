//! Lines that end in a line feed, a carriage return, or both.

use std::io::{self, BufRead};

use base::input::Limit;

/// Most bytes of a line. A longer one is no text, and might not end.
const MOST_BYTES: usize = 64 << 20;

/// Reads `source` line by line.
pub(super) struct Lines<R> {
    source: R,
    /// Number of the line that was read last, from 1.
    pub(super) number: u64,
    /// The last line ended in a carriage return, so a line feed that follows belongs to it.
    after_return: bool,
}

impl<R: BufRead> Lines<R> {
    pub(super) fn new(source: R) -> Self {
        Self { source, number: 0, after_return: false }
    }

    /// Appends the next line to `line`, without its end, and says whether it had one; `None` after the last line.
    ///
    /// # Errors
    /// Those of the source, and [`Limit::Line`].
    pub(super) fn next(&mut self, line: &mut Vec<u8>) -> io::Result<Option<bool>> {
        let mut any = false;
        loop {
            let mut available = self.source.fill_buf()?;
            if self.after_return {
                self.after_return = false;
                if available.first() == Some(&b'\n') {
                    self.source.consume(1);
                    available = self.source.fill_buf()?;
                }
            }
            if available.is_empty() {
                self.number += u64::from(any);
                return Ok(any.then_some(false));
            }
            any = true;
            if line.len() > MOST_BYTES {
                return Err(io::Error::other(Limit::Line));
            }
            let Some(end) = available.iter().position(|byte| matches!(byte, b'\n' | b'\r')) else {
                line.extend_from_slice(available);
                let bytes = available.len();
                self.source.consume(bytes);
                continue;
            };
            line.extend_from_slice(&available[..end]);
            self.after_return = available[end] == b'\r';
            self.source.consume(end + 1);
            self.number += 1;
            return Ok(Some(true));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formats;
    use std::io::BufReader;
    use std::path::Path;

    #[test]
    fn a_line_without_an_end_is_an_error() {
        let endless = BufReader::new(io::repeat(b'v'));
        let error = formats::read(endless, Path::new("a.obj"), None, None).unwrap_err().to_string();
        assert!(error.starts_with("a.obj:1: the line holds more than 64 MiB"), "{error}");
    }

    #[test]
    fn every_end_of_a_line_in_every_buffer() {
        let text = b"a\r\nb\rc\n\r\n\n\rd";
        for capacity in 1..14 {
            let mut lines = Lines::new(BufReader::with_capacity(capacity, &text[..]));
            let mut found = vec![];
            let mut line = vec![];
            while let Some(ended) = lines.next(&mut line).unwrap() {
                found.push((String::from_utf8(std::mem::take(&mut line)).unwrap(), ended));
            }
            let expected =
                [("a", true), ("b", true), ("c", true), ("", true), ("", true), ("", true), ("d", false)];
            assert_eq!(
                found,
                expected.map(|(line, ended)| (line.to_owned(), ended)),
                "buffers of {capacity}"
            );
            assert_eq!(lines.number, 7);
        }
    }
}
