//! What of a compiler's output is kept. `cargo xtask kernels` includes this file as well.

/// The line `line` of a compiler's output as listings have it, with its line break; none if it says nothing of the program.
#[must_use]
pub fn statement(line: &str) -> Option<String> {
    let code = line.split('#').next().unwrap_or_default().trim();
    let is_value = [".4byte", ".word"].iter().any(|directive| code.starts_with(directive));
    // Labels that no instruction names.
    let is_mark = ["$func_begin", "$func_end", "$tmp"].iter().any(|prefix| code.starts_with(prefix));
    if code.is_empty() || code.starts_with('.') && !is_value || is_mark {
        return None;
    }
    let indentation = if code.ends_with(':') { "" } else { "    " };
    Some(format!("{indentation}{}\n", code.replace('\t', " ")))
}
