//! The comments of a module's source, for its Verilog.
//!
//! The head of a source file describes the algorithm, and comments in the kernel say what its parts do. The syntax tree that
//! elaboration reads has neither, so both are taken from the text: the lines `//!`, and each block of `//` in `fn update`
//! with the names that the statements up to the next block assign.

/// What the source of one module says.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Comments {
    /// The head, as lines of a Verilog comment.
    pub head: String,
    /// Each comment of the kernel, with the signals, registers and instances that it is about.
    pub parts: Vec<Part>,
}

/// A comment of a kernel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// The lines, without marks.
    pub lines: Vec<String>,
    /// Fields of the module that the statements below it assign, without array positions.
    pub names: Vec<String>,
}

impl Comments {
    /// The comments of a source file that defines one module.
    #[must_use]
    pub fn of(source: &str) -> Self {
        let plain = |line: &str| line.replace("[`", "`").replace("`]", "`").replace("super::", "");
        let head = source.lines().map_while(|line| line.strip_prefix("//!"));
        let head = head.map(|line| format!("//{}\n", plain(line))).collect();
        let kernel = source.split_once("fn update(&mut self) {").map_or("", |(_, kernel)| kernel);
        let kernel = kernel.split_once("\n    }").map_or(kernel, |(kernel, _)| kernel);
        let mut parts: Vec<Part> = Vec::new();
        let mut in_comment = false;
        for line in kernel.lines().map(str::trim) {
            if let Some(comment) = line.strip_prefix("// ") {
                if !in_comment {
                    parts.push(Part { lines: Vec::new(), names: Vec::new() });
                }
                parts.last_mut().into_iter().for_each(|part| part.lines.push(plain(comment)));
            } else if let Some(part) = parts.last_mut() {
                part.names.extend(assigned(line).map(str::to_owned));
            }
            in_comment = line.starts_with("// ");
        }
        Self { head, parts }
    }

    /// The comment about the Verilog name `name`, if `shown` does not have it yet.
    pub(super) fn about(&self, name: &str, shown: &mut Vec<usize>) -> Option<&Part> {
        let is_meant = |field: &String| match name.strip_prefix(field.as_str()) {
            // `normal_2` is the second value of `normal`, `add_0` an element of `add`.
            Some(rest) => {
                rest.is_empty() || rest.strip_prefix('_').is_some_and(|rest| rest.parse::<u32>().is_ok())
            }
            None => false,
        };
        let (position, part) =
            self.parts.iter().enumerate().find(|(_, part)| part.names.iter().any(is_meant))?;
        if shown.contains(&position) {
            return None;
        }
        shown.push(position);
        Some(part)
    }
}

/// The field that a line of a kernel assigns: `sum` in `self.sum.next = ...`, `add` in
/// `ClockEnable::link(&mut self.clocking, &mut self.add[i].clocking)`.
fn assigned(line: &str) -> Option<&str> {
    let target = match line.split_once(".next = ") {
        Some((target, _)) => target.rsplit_once("self.").map(|(_, target)| target),
        None if line.contains("::link(") => line.rsplit_once("&mut self.").map(|(_, target)| target),
        None => None,
    }?;
    Some(target.split(['.', '[', ')']).next().unwrap_or(target))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_belong_to_what_follows() {
        let comments = Comments::of(
            "//! Adds.\n//!\n//! See [`super::Other`].\n\nuse x;\n\nimpl Logic for A {\n    fn update(&mut self) {\n\
             \x20       self.early.next = 1;\n        // Cycle 1:\n        // shift.\n\
             \x20       self.value.next = self.other.val();\n\
             \x20       ClockEnable::link(&mut self.clocking, &mut self.add[i].clocking);\n\
             \x20       // Cycle 2.\n        self.sum.d.next = 3;\n    }\n    // Not in the kernel.\n}\n",
        );
        assert_eq!(comments.head, "// Adds.\n//\n// See `Other`.\n");
        let part = |lines: &[&str], names: &[&str]| Part {
            lines: lines.iter().map(|&line| line.to_owned()).collect(),
            names: names.iter().map(|&name| name.to_owned()).collect(),
        };
        let expected = [part(&["Cycle 1:", "shift."], &["value", "add"]), part(&["Cycle 2."], &["sum"])];
        assert_eq!(comments.parts, expected);

        let mut shown = Vec::new();
        assert_eq!(comments.about("early", &mut shown), None);
        assert_eq!(comments.about("values", &mut shown), None);
        assert_eq!(comments.about("value_2", &mut shown), Some(&expected[0]));
        assert_eq!(comments.about("add_0", &mut shown), None, "each comment once");
        assert_eq!(comments.about("sum", &mut shown), Some(&expected[1]));
    }
}
