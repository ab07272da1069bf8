//! The legend: the names of series, above the chart.

use super::{WIDTH, text_width};

const LINE: i32 = 20;
const LEFT: i32 = 8;
/// Width in pixels of an entry without its text.
const MARK_AND_GAP: i32 = 34;

/// The place of each series' name. A single series has no entry.
pub struct Legend {
    pub entries: Vec<Entry>,
}

/// The mark of a series, 12 pixels square, with its name to the right.
pub struct Entry {
    pub series: usize,
    pub x: i32,
    pub y: i32,
}

impl Legend {
    /// Places the names from left to right, in as many lines as they need.
    pub fn new<'a>(names: impl ExactSizeIterator<Item = &'a str>) -> Self {
        let (mut x, mut y) = (LEFT, 0);
        let mut entries = vec![];
        if names.len() < 2 {
            return Self { entries };
        }
        for (series, name) in names.enumerate() {
            let width = text_width(name) as i32 + MARK_AND_GAP;
            if x + width > WIDTH as i32 && x > LEFT {
                (x, y) = (LEFT, y + LINE);
            }
            entries.push(Entry { series, x, y });
            x += width;
        }
        Self { entries }
    }

    /// Height of all lines in pixels.
    pub fn height(&self) -> i32 {
        self.entries.last().map_or(0, |entry| entry.y + LINE)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_go_on_in_the_next_line() {
        let name = "a name of thirty-six characters here".to_owned();
        let names = vec![name; 5];
        let legend = Legend::new(names.iter().map(String::as_str));
        let places: Vec<(i32, i32)> = legend.entries.iter().map(|entry| (entry.x, entry.y)).collect();
        let second = LEFT + 36 * 15 / 2 + MARK_AND_GAP;
        assert_eq!(places, [(LEFT, 0), (second, 0), (LEFT, LINE), (second, LINE), (LEFT, 2 * LINE)]);
        assert_eq!(legend.height(), 3 * LINE);
        assert_eq!(Legend::new(["alone"].into_iter()).height(), 0);
    }
}
