//! The syntax of liberty files: groups, attributes, values.

use super::LibertyError;

/// Most groups around a place. The format needs six, and reading takes a stack in proportion.
const MOST_DEPTH: u32 = 32;

/// A group: `kind (names) { attributes and groups }`.
#[derive(Debug, Default)]
pub struct Group<'t> {
    pub kind: &'t str,
    pub names: Vec<&'t str>,
    /// Simple attributes have one value, complex ones a list.
    pub attributes: Vec<(&'t str, Vec<&'t str>)>,
    pub groups: Vec<Group<'t>>,
    /// Line of its begin.
    pub line: usize,
}

impl<'t> Group<'t> {
    /// The values of an attribute.
    pub fn values(&self, name: &str) -> Option<&[&'t str]> {
        self.attributes.iter().find(|(key, _)| *key == name).map(|(_, values)| values.as_slice())
    }

    /// The only value of an attribute.
    pub fn value(&self, name: &str) -> Option<&'t str> {
        self.values(name).and_then(|values| values.first().copied())
    }

    /// The groups of a kind.
    pub fn of_kind<'g>(&'g self, kind: &'g str) -> impl Iterator<Item = &'g Group<'t>> {
        self.groups.iter().filter(move |group| group.kind == kind)
    }

    /// The first name.
    pub fn name(&self) -> &'t str {
        self.names.first().copied().unwrap_or_default()
    }
}

/// Reads the one group that a file is.
pub fn parse(text: &str) -> Result<Group<'_>, LibertyError> {
    let mut reader = Reader { text, at: 0, line: 1, depth: 0 };
    match reader.item()? {
        Some(Item::Group(group)) => Ok(group),
        _ => Err(reader.error("the file is no `library (...) { ... }`")),
    }
}

enum Item<'t> {
    Group(Group<'t>),
    Attribute(&'t str, Vec<&'t str>),
}

struct Reader<'t> {
    text: &'t str,
    at: usize,
    line: usize,
    /// Groups around this place.
    depth: u32,
}

impl<'t> Reader<'t> {
    fn error(&self, what: &'static str) -> LibertyError {
        LibertyError::Syntax { line: self.line, what: what.to_owned() }
    }

    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    /// Skips spaces, comments and line continuations; line ends only if `over_lines`.
    fn skip(&mut self, over_lines: bool) -> Result<(), LibertyError> {
        while let Some(byte) = self.peek() {
            match byte {
                b'\n' if over_lines => {
                    self.line += 1;
                    self.at += 1;
                }
                b'\\' => {
                    self.at += 1;
                    while matches!(self.peek(), Some(b' ' | b'\t' | b'\r')) {
                        self.at += 1;
                    }
                    if self.peek() == Some(b'\n') {
                        self.line += 1;
                        self.at += 1;
                    }
                }
                b' ' | b'\t' | b'\r' => self.at += 1,
                b'/' if self.text[self.at..].starts_with("/*") => {
                    let Some(length) = self.text[self.at..].find("*/") else {
                        return Err(self.error("a comment does not end"));
                    };
                    self.line += self.text[self.at..self.at + length].matches('\n').count();
                    self.at += length + 2;
                }
                b'/' if self.text[self.at..].starts_with("//") => {
                    while !matches!(self.peek(), None | Some(b'\n')) {
                        self.at += 1;
                    }
                }
                _ => break,
            }
        }
        Ok(())
    }

    /// A string without its quotes, or a word.
    fn word(&mut self) -> Result<&'t str, LibertyError> {
        if self.peek() == Some(b'"') {
            let rest = &self.text[self.at + 1..];
            let length = rest.find('"').ok_or_else(|| self.error("a string does not end"))?;
            self.line += rest[..length].matches('\n').count();
            self.at += length + 2;
            return Ok(&rest[..length]);
        }
        let rest = &self.text[self.at..];
        let is_end = |c: char| c.is_whitespace() || "(){}:;,\"\\".contains(c);
        let length = rest.find(is_end).unwrap_or(rest.len());
        if length == 0 {
            return Err(self.error("a name or a value is missing"));
        }
        self.at += length;
        Ok(&rest[..length])
    }

    /// The next attribute or group; none at a closing brace or the end.
    fn item(&mut self) -> Result<Option<Item<'t>>, LibertyError> {
        loop {
            self.skip(true)?;
            match self.peek() {
                None | Some(b'}') => return Ok(None),
                Some(b';') => self.at += 1,
                Some(_) => break,
            }
        }
        let line = self.line;
        let name = self.word()?;
        self.skip(true)?;
        match self.peek() {
            Some(b':') => {
                self.at += 1;
                self.skip(false)?;
                let start = self.at;
                let mut value = self.word()?;
                self.skip(false)?;
                // An expression without quotes goes on to the end of the statement.
                if !matches!(self.peek(), None | Some(b';' | b'\n' | b'}')) {
                    let rest = &self.text[self.at..];
                    self.at += rest.find([';', '\n', '}']).unwrap_or(rest.len());
                    value = self.text[start..self.at].trim();
                }
                Ok(Some(Item::Attribute(name, vec![value])))
            }
            Some(b'(') => {
                self.at += 1;
                let names = self.list()?;
                self.skip(true)?;
                if self.peek() != Some(b'{') {
                    return Ok(Some(Item::Attribute(name, names)));
                }
                self.at += 1;
                self.depth += 1;
                if self.depth > MOST_DEPTH {
                    return Err(self.error("groups lie more than 32 deep in each other"));
                }
                let mut group = Group { kind: name, names, line, ..Group::default() };
                while let Some(item) = self.item()? {
                    match item {
                        Item::Group(inner) => group.groups.push(inner),
                        Item::Attribute(key, values) => group.attributes.push((key, values)),
                    }
                }
                if self.peek() != Some(b'}') {
                    return Err(self.error("a closing brace is missing"));
                }
                self.at += 1;
                self.depth -= 1;
                Ok(Some(Item::Group(group)))
            }
            _ => Err(self.error("neither `:` nor `(` follows a name")),
        }
    }

    /// Values up to the closing parenthesis.
    fn list(&mut self) -> Result<Vec<&'t str>, LibertyError> {
        let mut values = Vec::new();
        loop {
            self.skip(true)?;
            match self.peek() {
                None => return Err(self.error("a closing parenthesis is missing")),
                Some(b')') => {
                    self.at += 1;
                    return Ok(values);
                }
                Some(b',') => self.at += 1,
                Some(_) => values.push(self.word()?),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn deep_nesting_is_an_error_with_its_line() {
        let nested = |depth: usize| format!("{}{}", "a (b) {\n".repeat(depth), "}\n".repeat(depth));
        assert!(parse(&nested(MOST_DEPTH as usize)).is_ok());
        let error = parse(&nested(20_000)).unwrap_err().to_string();
        assert!(error.starts_with("line 33: groups lie more than 32 deep"), "{error}");
    }
}
