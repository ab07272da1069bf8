//! Names as the kernel's syntax tree spells them: `regs[i+1]$d$next` becomes `regs$2$d`.

use std::collections::BTreeMap;

use super::error::ErrorKind;

/// Values of the loop variables in scope.
pub type LoopVariables = BTreeMap<String, u64>;

/// The plain name of a signal: the index evaluated, the trailing `$next` dropped.
///
/// # Errors
/// [`ErrorKind::NotUnderstood`] for more than one index, which rust-hdl's own export gets wrong too, and for
/// index arithmetic beyond `+ - * / %` and parentheses; [`ErrorKind::Unresolved`] for an unknown variable.
pub fn resolve(raw: &str, loops: &LoopVariables) -> Result<String, ErrorKind> {
    let name = raw.trim_end_matches("$next");
    let Some((base, rest)) = name.split_once('[') else { return Ok(name.to_owned()) };
    let malformed = || ErrorKind::NotUnderstood(format!("the index of `{raw}`"));
    let (index, tail) = rest.split_once(']').ok_or_else(malformed)?;
    if tail.contains('[') {
        return Err(ErrorKind::NotUnderstood(format!("`{raw}` has two indices; copy one level into locals")));
    }
    let mut parser = Parser { text: index, loops };
    let value = parser.sum()?;
    if !parser.text.is_empty() {
        return Err(malformed());
    }
    Ok(format!("{base}${value}{tail}"))
}

struct Parser<'a> {
    text: &'a str,
    loops: &'a LoopVariables,
}

impl Parser<'_> {
    fn peek(&mut self) -> Option<char> {
        self.text = self.text.trim_start();
        self.text.chars().next()
    }

    fn sum(&mut self) -> Result<u64, ErrorKind> {
        let mut value = self.product()?;
        while let Some(op @ ('+' | '-')) = self.peek() {
            self.text = &self.text[1..];
            let right = self.product()?;
            let result = if op == '+' { value.checked_add(right) } else { value.checked_sub(right) };
            value = result.ok_or_else(|| self.error())?;
        }
        Ok(value)
    }

    fn product(&mut self) -> Result<u64, ErrorKind> {
        let mut value = self.atom()?;
        while let Some(op @ ('*' | '/' | '%')) = self.peek() {
            self.text = &self.text[1..];
            let right = self.atom()?;
            let result = match op {
                '*' => value.checked_mul(right),
                '/' => value.checked_div(right),
                _ => value.checked_rem(right),
            };
            value = result.ok_or_else(|| self.error())?;
        }
        Ok(value)
    }

    fn atom(&mut self) -> Result<u64, ErrorKind> {
        if self.peek() == Some('(') {
            self.text = &self.text[1..];
            let value = self.sum()?;
            if self.peek() != Some(')') {
                return Err(self.error());
            }
            self.text = &self.text[1..];
            return Ok(value);
        }
        let end = self.text.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(self.text.len());
        let (word, rest) = self.text.split_at(end);
        self.text = rest;
        match word.chars().next() {
            Some(first) if first.is_ascii_digit() => {
                let digits = word.trim_end_matches("usize").trim_end_matches('_');
                digits.parse().map_err(|_| self.error())
            }
            Some(_) => self.loops.get(word).copied().ok_or_else(|| ErrorKind::Unresolved(word.to_owned())),
            None => Err(self.error()),
        }
    }

    fn error(&self) -> ErrorKind {
        ErrorKind::NotUnderstood(format!("index arithmetic at `{}`", self.text))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn loops() -> LoopVariables {
        BTreeMap::from([("i".to_owned(), 3), ("k".to_owned(), 2)])
    }

    #[test]
    fn indices_are_evaluated() {
        let cases = [
            ("a$next", "a"),
            ("regs[i]$d$next", "regs$3$d"),
            ("a[i+1]", "a$4"),
            ("a[(i+1)*k-1]", "a$7"),
            ("a[i/k%k]", "a$1"),
            ("a[0]$q", "a$0$q"),
            ("a[2usize]", "a$2"),
        ];
        for (raw, expected) in cases {
            assert_eq!(resolve(raw, &loops()).as_deref(), Ok(expected), "{raw}");
        }
    }

    #[test]
    fn bad_indices_are_errors() {
        assert_eq!(resolve("a[N]", &loops()), Err(ErrorKind::Unresolved("N".into())));
        for raw in ["a[i][k]", "a[i", "a[i-4]", "a[i/0]", "a[(i]", "a[]", "a[i 3]"] {
            assert!(matches!(resolve(raw, &loops()), Err(ErrorKind::NotUnderstood(_))), "{raw}");
        }
    }
}
