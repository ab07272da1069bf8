//! What a reader found in a file besides triangles.

use super::Format;
use super::polygons::PolygonCounts;

/// Most kinds of skipped statements that are told apart.
const MOST_KINDS: usize = 32;
const OTHERS: &str = "other statements";

/// What a file holds besides its triangles.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileReport {
    /// The format that was read.
    pub format: Format,
    /// Kinds of statements or elements that were skipped, in the order of their first.
    pub skipped: Vec<Skipped>,
    /// Polygons of more than three corners that are worth a word.
    pub polygons: PolygonCounts,
    /// Statements with a name that is not UTF-8.
    pub replaced_names: u64,
    /// The first of them with its line, in which U+FFFD stands for what is not UTF-8.
    pub first_replaced_name: Option<(String, u64)>,
}

/// Statements or elements of one kind that were skipped.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Skipped {
    /// Their keyword, or what they are.
    pub what: String,
    /// Why they were skipped.
    pub why: Skip,
    /// How many they are.
    pub count: u64,
    /// The line of the first, or 0 in a format without lines.
    pub first_line: u64,
}

/// Why something in a file was skipped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Skip {
    /// It describes surfaces or groups and has no geometry.
    Attribute,
    /// It is geometry, but no triangle: a point, a line, a face of two corners.
    NoTriangle,
    /// It is geometry that the reader does not know to read.
    Geometry,
    /// The format does not know it.
    Unknown,
}

impl FileReport {
    pub(super) fn new(format: Format) -> Self {
        Self {
            format,
            skipped: Vec::new(),
            polygons: PolygonCounts::default(),
            replaced_names: 0,
            first_replaced_name: None,
        }
    }

    /// Counts something that is skipped.
    pub(super) fn skip(&mut self, what: &str, why: Skip, line: u64) {
        self.skip_many(what, why, 1, line);
    }

    /// Counts `count` things that are skipped.
    pub(super) fn skip_many(&mut self, what: &str, why: Skip, count: u64, line: u64) {
        let position = |what: &str| self.skipped.iter().position(|s| s.what == what && s.why == why);
        // A file of another format has many kinds of unknown statements.
        let rest = self.skipped.len() >= MOST_KINDS;
        match position(what).or_else(|| rest.then(|| position(OTHERS)).flatten()) {
            Some(known) => self.skipped[known].count += count,
            None => {
                let what = if rest { OTHERS } else { what }.to_owned();
                self.skipped.push(Skipped { what, why, count, first_line: line });
            }
        }
    }

    /// Counts a name that is not UTF-8.
    pub(super) fn replaced_name(&mut self, text: &str, line: u64) {
        self.replaced_names += 1;
        self.first_replaced_name.get_or_insert_with(|| (text.to_owned(), line));
    }

    /// Number of statements or elements that were skipped for the reason `why`.
    #[must_use]
    pub fn count(&self, why: Skip) -> u64 {
        self.skipped.iter().filter(|skipped| skipped.why == why).map(|skipped| skipped.count).sum()
    }

    /// A line for each thing that a user may want to know of.
    #[must_use]
    pub fn notes(&self) -> Vec<String> {
        let mut notes = vec![];
        for Skipped { what, why, count, first_line } in &self.skipped {
            let why = match why {
                Skip::Attribute => continue,
                Skip::NoTriangle => "no triangles",
                Skip::Geometry => "geometry of a kind that is not read",
                Skip::Unknown => "not known",
            };
            let first =
                if *first_line == 0 { String::new() } else { format!(", first in line {first_line}") };
            // A keyword is one word, a description has several.
            let what = if what.contains(' ') { what.clone() } else { format!("statements `{what}`") };
            notes.push(format!("skipped {count} {what}: {why}{first}"));
        }
        if let Some((text, line)) = &self.first_replaced_name {
            notes.push(format!("{} names are not UTF-8, first `{text}` in line {line}", self.replaced_names));
        }
        let PolygonCounts { concave, non_planar, self_crossing } = self.polygons;
        for (count, what) in [
            (concave, "polygons are concave; they are divided in their plane"),
            (non_planar, "polygons are not planar; how they are divided is a choice"),
            (self_crossing, "polygons cross themselves; their triangles are a guess"),
        ] {
            if count > 0 {
                notes.push(format!("{count} {what}"));
            }
        }
        notes
    }
}
