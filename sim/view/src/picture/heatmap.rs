//! Heat maps, with a colour bar and the largest value as a number.

use super::{Picture, font};
use colorgrad::Gradient;
use render::{Rendering, Work};
use std::fmt;

/// The quantity that a heat map shows for each pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Nodes read by all rays of the pixel.
    NodeVisits,
    /// Planes tested by all rays of the pixel.
    PlaneTests,
    /// Triangles tested by all rays of the pixel.
    TriangleTests,
    /// The deepest stack of any ray of the pixel.
    StackDepth,
}

impl Quantity {
    /// All quantities.
    pub const ALL: [Self; 4] = [Self::NodeVisits, Self::PlaneTests, Self::TriangleTests, Self::StackDepth];

    /// The quantity's name on the command line and in result files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::NodeVisits => "node-visits",
            Self::PlaneTests => "plane-tests",
            Self::TriangleTests => "triangle-tests",
            Self::StackDepth => "stack-depth",
        }
    }

    /// The quantity in `work`.
    #[must_use]
    pub fn of(self, work: &Work) -> u32 {
        match self {
            Self::NodeVisits => work.node_visits,
            Self::PlaneTests => work.plane_tests,
            Self::TriangleTests => work.triangle_tests,
            Self::StackDepth => work.stack_depth,
        }
    }

    /// The largest value in `rendering`.
    #[must_use]
    pub fn max(self, rendering: &Rendering) -> u32 {
        rendering.pixels.iter().map(|pixel| self.of(&pixel.work)).max().unwrap_or(0)
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// Height of the strip below the map that holds the bar and its labels, in pixels.
pub const STRIP_HEIGHT: u32 = 44;
/// The least width of a map with its strip; narrower maps get a margin on the right.
pub const LEAST_WIDTH: u32 = 240;

const MARGIN: u32 = 8;
const BAR_HEIGHT: u32 = 10;
const BACKGROUND: [u8; 3] = [24; 3];
const TEXT: [u8; 3] = [230; 3];

/// The map of `quantity` per pixel of `rendering`, from 0 to `scale_max` (the largest value if absent).
#[must_use]
pub fn of_rendering(rendering: &Rendering, quantity: Quantity, scale_max: Option<u32>) -> Picture<u8> {
    let largest = quantity.max(rendering);
    let label = format!("{quantity}, max {largest}");
    let values = rendering.pixels.iter().map(|pixel| f64::from(quantity.of(&pixel.work)));
    let scale = f64::from(scale_max.unwrap_or(largest));
    draw(rendering.width, rendering.height, values, scale, &label)
}

/// A map of `values`, row by row from the top, coloured from 0 to `scale_max`, with a bar and `label` below.
#[must_use]
pub fn draw(
    width: u32,
    height: u32,
    values: impl Iterator<Item = f64>,
    scale_max: f64,
    label: &str,
) -> Picture<u8> {
    // The colour map is perceptually uniform. It consists of polynomials, so its colours are the same on every machine.
    let gradient = colorgrad::preset::viridis();
    let colour = |fraction: f64| {
        let [r, g, b, _] = gradient.at(fraction as f32).to_rgba8();
        [r, g, b]
    };
    let mut picture = Picture::filled(width.max(LEAST_WIDTH), height + STRIP_HEIGHT, BACKGROUND);
    for (i, value) in (0..).zip(values) {
        let fraction = if scale_max > 0.0 { (value / scale_max).clamp(0.0, 1.0) } else { 0.0 };
        picture.set(i % width, i / width, colour(fraction));
    }
    let bar_width = picture.width - 2 * MARGIN;
    for x in 0..bar_width {
        let fraction = f64::from(x) / f64::from(bar_width - 1);
        for y in 0..BAR_HEIGHT {
            picture.set(MARGIN + x, height + MARGIN / 2 + y, colour(fraction));
        }
    }
    let numbers = height + MARGIN / 2 + BAR_HEIGHT + 3;
    let number = format_number(scale_max);
    font::draw(&mut picture, MARGIN, numbers, "0", TEXT);
    let half = format_number(scale_max / 2.0);
    let middle = picture.width / 2 - font::width(&half) / 2;
    font::draw(&mut picture, middle, numbers, &half, TEXT);
    let right = picture.width - MARGIN - font::width(&number);
    font::draw(&mut picture, right, numbers, &number, TEXT);
    font::draw(&mut picture, MARGIN, numbers + font::CHARACTER + 5, label, TEXT);
    picture
}

/// A number in at most eight characters.
fn format_number(x: f64) -> String {
    if (x.fract() == 0.0 || x >= 100.0) && x < 1e8 {
        format!("{x:.0}")
    } else if (0.01..100.0).contains(&x) {
        format!("{x:.2}")
    } else {
        format!("{x:.2e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn largest_and_smallest_have_the_colours_of_the_bar_s_ends() {
        let picture = draw(2, 1, [0.0, 8.0].into_iter(), 8.0, "test");
        let bar = (1 + MARGIN / 2) * picture.width + MARGIN;
        let last = bar + picture.width - 2 * MARGIN - 1;
        assert_eq!(picture.pixels[0], picture.pixels[bar as usize]);
        assert_eq!(picture.pixels[1], picture.pixels[last as usize]);
        assert_eq!((picture.width, picture.height), (LEAST_WIDTH, 1 + STRIP_HEIGHT));
        let clipped = draw(2, 1, [0.0, 80.0].into_iter(), 8.0, "test");
        assert_eq!(picture, clipped);
        assert_ne!(picture, draw(2, 1, [0.0, 8.0].into_iter(), 16.0, "test"));
    }

    #[test]
    fn a_map_without_values_is_drawn() {
        let picture = draw(300, 2, std::iter::repeat_n(0.0, 600), 0.0, "nothing");
        assert_eq!(picture.width, 300);
    }

    #[test]
    fn numbers_are_short() {
        for (x, text) in [
            (0.0, "0"),
            (123_456.0, "123456"),
            (2.5, "2.50"),
            (1701.5, "1702"),
            (1e-5, "1.00e-5"),
            (3e9, "3.00e9"),
        ] {
            assert_eq!(format_number(x), text);
        }
    }
}
