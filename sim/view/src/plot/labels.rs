//! Where the texts beside points go, so that none lies over another.

use super::text_width;

/// A text beside a point, in pixels.
pub struct Label {
    /// The text.
    pub text: String,
    /// The point.
    pub at: (i32, i32),
}

/// Left, top, right and bottom.
type Box = [i32; 4];

const HEIGHT: i32 = 15;
/// Distance between a point and the nearest place of its text.
const GAP: i32 = 7;
/// Rings of places around a point.
const RINGS: i32 = 12;

/// For each label, the left top corner of its text. A text lies within `area` and clear of all `points` and of all other texts; one
/// for which there is no such place near its point is left out.
pub fn places(labels: &[Label], points: &[(i32, i32)], area: Box) -> Vec<Option<(i32, i32)>> {
    let mut taken: Vec<Box> = points.iter().map(|&(x, y)| [x - 4, y - 4, x + 4, y + 4]).collect();
    let mut place = |label: &Label| {
        let width = text_width(&label.text) as i32;
        let (x, y) = label.at;
        let around = (0..RINGS).flat_map(|ring| {
            let far = GAP + 8 * ring;
            let (left, middle, right) = (x - far - width, x - width / 2, x + far);
            let (above, beside, below) = (y - far - HEIGHT, y - HEIGHT / 2, y + far);
            [
                (right, above),
                (right, below),
                (left, above),
                (left, below),
                (right, beside),
                (left, beside),
                (middle, above),
                (middle, below),
            ]
        });
        let is_free = |&(left, top): &(i32, i32)| {
            let own = [left, top, left + width, top + HEIGHT];
            inside(own, area) && !taken.iter().any(|other| overlap(own, *other))
        };
        let found = around.into_iter().find(is_free)?;
        taken.push([found.0, found.1, found.0 + width, found.1 + HEIGHT]);
        Some(found)
    };
    labels.iter().map(&mut place).collect()
}

fn overlap(a: Box, b: Box) -> bool {
    a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]
}

fn inside(a: Box, b: Box) -> bool {
    a[0] >= b[0] && a[1] >= b[1] && a[2] <= b[2] && a[3] <= b[3]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_keep_clear_of_each_other_of_points_and_of_the_edge() {
        let points: Vec<(i32, i32)> = (0..12).map(|n| (100 + 3 * n, 100 + 2 * n)).collect();
        let labels: Vec<Label> = points.iter().map(|&at| Label { text: "binary16".into(), at }).collect();
        let area = [60, 20, 400, 300];
        let found = places(&labels, &points, area);
        let boxes: Vec<Box> = found
            .iter()
            .flatten()
            .map(|&(x, y)| [x, y, x + text_width("binary16") as i32, y + HEIGHT])
            .collect();
        assert_eq!(boxes.len(), labels.len(), "there is room for all");
        for (i, a) in boxes.iter().enumerate() {
            assert!(inside(*a, area), "{a:?}");
            assert!(!boxes[..i].iter().any(|b| overlap(*a, *b)), "{a:?} in {boxes:?}");
            assert!(
                !points.iter().any(|&(x, y)| overlap(*a, [x, y, x + 1, y + 1])),
                "{a:?} lies over a point"
            );
        }
        assert_eq!(places(&labels[..1], &[], [0, 0, 10, 10]), [None], "there is no room");
    }
}
