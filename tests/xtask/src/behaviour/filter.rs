//! Takes what depends on the host out of JSON and CSV.
//!
//! Everything else keeps its bytes: the order of keys, the digits of numbers and the layout count.

/// The keys of JSON documents and the columns of CSV files that hold the host's times, its threads, or the program's sources.
pub const HOST_NAMES: [&str; 9] = [
    "build_ms",
    "commit",
    "convert_ms",
    "fingerprint",
    "rays_per_second",
    "seconds",
    "simulated_rays_per_second",
    "threads",
    "vectors_per_second",
];

/// What stands for a value that was taken out.
const BLANK: &str = "_";

/// What of an artifact `name` does not depend on the host.
pub fn filtered(name: &str, bytes: Vec<u8>) -> Vec<u8> {
    let filter = match name.rsplit_once('.') {
        Some((_, "json")) => json,
        Some((_, "csv")) => csv,
        _ => return bytes,
    };
    match String::from_utf8(bytes) {
        Ok(text) => filter(&text).into_bytes(),
        Err(error) => error.into_bytes(),
    }
}

/// `text` with a blank for each number or word whose key is a host's name.
pub fn json(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(start) = rest.find('"') {
        let Some(length) = string_length(&rest[start + 1..]) else { break };
        let end = start + 1 + length;
        let key = &rest[start + 1..end];
        out.push_str(&rest[..=end]);
        rest = &rest[end + 1..];
        let value = rest.trim_start().strip_prefix(':').map(str::trim_start);
        if let Some(value) = value
            && HOST_NAMES.contains(&key)
        {
            let number = value
                .find(|c: char| !c.is_ascii_alphanumeric() && !"+-.\"".contains(c))
                .unwrap_or(value.len());
            if number > 0 {
                out.push_str(&rest[..rest.len() - value.len()]);
                out.push_str(BLANK);
                rest = &value[number..];
            }
        }
    }
    out + rest
}

/// Bytes before the quote that ends a JSON string.
fn string_length(text: &str) -> Option<usize> {
    let mut escaped = false;
    text.bytes().position(|byte| {
        let ends = byte == b'"' && !escaped;
        escaped = byte == b'\\' && !escaped;
        ends
    })
}

/// `text` with a blank for each cell below a host's name.
pub fn csv(text: &str) -> String {
    let mut lines = records(text).into_iter();
    let Some(header) = lines.next() else { return String::new() };
    let is_host: Vec<bool> =
        cells(header).iter().map(|cell| HOST_NAMES.contains(&cell.trim_end().trim_matches('"'))).collect();
    let mut out = header.to_owned();
    for line in lines {
        let cell = |(i, cell)| match is_host.get(i) {
            Some(true) => BLANK,
            _ => cell,
        };
        let content = line.trim_end_matches(['\r', '\n']);
        out += &cells(content).into_iter().enumerate().map(cell).collect::<Vec<_>>().join(",");
        out += &line[content.len()..];
    }
    out
}

/// The records with their line ends.
fn records(text: &str) -> Vec<&str> {
    split(text, '\n', true)
}

/// The cells of a record with their quotes.
pub fn cells(record: &str) -> Vec<&str> {
    split(record, ',', false)
}

/// The parts of `text` between the separators that are outside of quotes.
///
/// Each has the separator that ends it, if `inclusive`.
fn split(text: &str, separator: char, inclusive: bool) -> Vec<&str> {
    let mut quoted = false;
    let outside = |c: char| {
        quoted ^= c == '"';
        c == separator && !quoted
    };
    if inclusive { text.split_inclusive(outside).collect() } else { text.split(outside).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn json_loses_the_hosts_numbers_and_nothing_else() {
        let text =
            "{\n  \"a\": 1.50,\n  \"seconds\": 1.5e-3,\n  \"list\": [{\"build_ms\":12}, {\"b\":2}]\n}\n";
        let without = "{\n  \"a\": 1.50,\n  \"seconds\": _,\n  \"list\": [{\"build_ms\":_}, {\"b\":2}]\n}\n";
        assert_eq!(json(text), without);
        let others = r#"{"seconds of": 1, "x": "seconds", "y": "a \"seconds\": 3", "seconds": {"z": 1}}"#;
        assert_eq!(json(others), others);
        assert_eq!(json(r#"{"fingerprint": "0a1b", "b": "c"}"#), r#"{"fingerprint": _, "b": "c"}"#);
        assert_eq!(json(r#"["\\", {"threads": 4}]"#), r#"["\\", {"threads": _}]"#);
    }

    #[test]
    fn csv_loses_the_hosts_columns_and_nothing_else() {
        let text = "level,seconds,note\nrtl,0.5,\"a, \"\"b\"\"\nc\"\nall,12,\n";
        assert_eq!(csv(text), "level,seconds,note\nrtl,_,\"a, \"\"b\"\"\nc\"\nall,_,\n");
        let other = "name,value\nseconds,3\n";
        assert_eq!(csv(other), other);
        assert_eq!(csv(""), "");
    }

    #[test]
    fn only_json_and_csv_are_read() {
        let bytes = b"\"seconds\": 3".to_vec();
        assert_eq!(filtered("a.json", bytes.clone()), b"\"seconds\": _");
        assert_eq!(filtered("a.txt", bytes.clone()), bytes);
        assert_eq!(filtered("a.csv", vec![0xff, 0xfe]), [0xff, 0xfe]);
    }
}
