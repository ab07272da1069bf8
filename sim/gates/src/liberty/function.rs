//! Boolean functions of cells as truth tables of up to six inputs.

/// Most inputs of a cell.
pub const MAX_INPUTS: usize = 6;

/// Most signs and parentheses around a place: reading takes a stack in proportion.
const MOST_DEPTH: u32 = 64;

/// The truth table of input `i` alone.
#[must_use]
pub const fn variable(i: usize) -> u64 {
    const TABLES: [u64; MAX_INPUTS] = [
        0xaaaa_aaaa_aaaa_aaaa,
        0xcccc_cccc_cccc_cccc,
        0xf0f0_f0f0_f0f0_f0f0,
        0xff00_ff00_ff00_ff00,
        0xffff_0000_ffff_0000,
        0xffff_ffff_0000_0000,
    ];
    TABLES[i]
}

/// Whether a truth table depends on an input.
#[must_use]
pub const fn depends_on(table: u64, input: usize) -> bool {
    let upper = table & variable(input);
    let lower = table & !variable(input);
    upper >> (1 << input) != lower
}

/// The truth table of an expression over `inputs`: `!`, `'`, `&`, `*`, `|`, `+`, `^`, parentheses, constants, and a
/// product where two operands follow each other. `None` if it is no such expression.
#[must_use]
pub fn parse(text: &str, inputs: &[&str]) -> Option<u64> {
    let mut parser = Parser { rest: text.trim(), inputs, depth: 0 };
    let table = parser.sum()?;
    parser.rest.is_empty().then_some(table)
}

struct Parser<'t> {
    rest: &'t str,
    inputs: &'t [&'t str],
    /// Signs and parentheses around this place.
    depth: u32,
}

impl Parser<'_> {
    fn take(&mut self, symbols: &[char]) -> bool {
        self.rest = self.rest.trim_start();
        let found = self.rest.starts_with(symbols);
        if found {
            self.rest = self.rest[1..].trim_start();
        }
        found
    }

    fn sum(&mut self) -> Option<u64> {
        let mut table = self.product()?;
        while self.take(&['|', '+']) {
            table |= self.product()?;
        }
        Some(table)
    }

    fn product(&mut self) -> Option<u64> {
        let mut table = self.difference()?;
        loop {
            let next = self.rest.trim_start().chars().next();
            let goes_on = next.is_some_and(|c| c.is_alphanumeric() || "_!([\"".contains(c));
            if self.take(&['&', '*']) || goes_on {
                table &= self.difference()?;
            } else {
                return Some(table);
            }
        }
    }

    fn difference(&mut self) -> Option<u64> {
        let mut table = self.factor()?;
        while self.take(&['^']) {
            table ^= self.factor()?;
        }
        Some(table)
    }

    fn factor(&mut self) -> Option<u64> {
        self.depth += 1;
        if self.depth > MOST_DEPTH {
            return None;
        }
        let table = self.operand();
        self.depth -= 1;
        table
    }

    fn operand(&mut self) -> Option<u64> {
        let mut table = if self.take(&['!', '~']) {
            return self.factor().map(|table| !table);
        } else if self.take(&['(']) {
            let inner = self.sum()?;
            self.take(&[')']).then_some(inner)?
        } else {
            let is_name = |c: char| c.is_alphanumeric() || "_[]".contains(c);
            let length = self.rest.find(|c| !is_name(c)).unwrap_or(self.rest.len());
            let (name, rest) = self.rest.split_at(length);
            self.rest = rest.trim_start();
            match name {
                "0" => 0,
                "1" => !0,
                _ => {
                    variable(self.inputs.iter().position(|input| *input == name).filter(|&i| i < MAX_INPUTS)?)
                }
            }
        };
        while self.take(&['\'']) {
            table = !table;
        }
        Some(table)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn expressions() {
        let [a, b, c] = [0, 1, 2].map(variable);
        let parse = |text| parse(text, &["A", "B1", "C"]);
        assert_eq!(parse("!(A*B1)"), Some(!(a & b)));
        assert_eq!(parse("(A B1)+C'"), Some((a & b) | !c));
        assert_eq!(parse("A ^ B1 & !C"), Some((a ^ b) & !c));
        assert_eq!(parse("(!A&!B1) | (C)"), Some((!a & !b) | c));
        assert_eq!(parse("1"), Some(!0));
        for bad in ["", "A+", "D", "(A", "A)", "A+*C"] {
            assert_eq!(parse(bad), None, "{bad}");
        }
        for sign in ["!", "("] {
            let deep = format!("{}A", sign.repeat(100_000));
            assert_eq!(super::parse(&deep, &["A"]), None);
        }
        assert!(depends_on(a & b, 0) && depends_on(a & b, 1) && !depends_on(a & b, 2));
    }
}
