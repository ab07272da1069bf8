//! Charts as SVG, for files and for the report's page.
//!
//! [`Bars`] compares quantities, with the number beside each bar. [`Chart`] draws points and lines over two axes, with error bars
//! and labels. A structure has one colour in all charts (`palette`), and series differ in their markers too. [`Bars::max`] gives
//! several charts the same scale. The program that shows a file draws its text, so the bytes do not depend on the machine's fonts.

mod bars;
mod chart;
mod labels;
mod legend;
mod log_scale;
mod palette;

pub use bars::Bars;
pub use chart::{Axis, Chart, Point, Series, Style};

use plotters::prelude::RGBColor;

/// Colour of text and axes.
const INK: RGBColor = RGBColor(40, 40, 40);
/// Colour of grid lines.
const GRID: RGBColor = RGBColor(224, 224, 224);
const FONT: &str = "sans-serif";
const FONT_PX: u32 = 15;
const TITLE_PX: u32 = 18;
const WIDTH: u32 = 760;
/// Pixels above the legend, for the title.
const TOP: i32 = 34;

/// Estimated width of `text` in pixels at [`FONT_PX`].
fn text_width(text: &str) -> u32 {
    text.chars().count() as u32 * FONT_PX / 2
}

/// `x` with about four significant digits, for bars and ticks.
#[must_use]
pub fn number(x: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    let magnitude = x.abs().log10().floor() as i32;
    if !(-4..7).contains(&magnitude) {
        return format!("{x:.2e}");
    }
    let text = format!("{x:.*}", (3 - magnitude).max(0) as usize);
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// An SVG that fills the width of the page that shows it, up to its own width, and that a screen reader calls `title`.
fn responsive(svg: &str, title: &str, width: u32, height: u32) -> String {
    let fixed = format!("width=\"{width}\" height=\"{height}\"");
    let fluid = format!("role=\"img\" style=\"width:100%;max-width:{width}px;height:auto\"");
    let svg = svg.replacen(&fixed, &fluid, 1);
    let Some((head, body)) = svg.split_once('>') else { return svg };
    format!("{head}>\n<title>{}</title>{body}", escape(title))
}

/// `text` as HTML and SVG have it.
#[must_use]
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_four_digits() {
        for (x, text) in [
            (0.0, "0"),
            (1.0, "1"),
            (0.12345, "0.1235"),
            (12.3456, "12.35"),
            (98765.4, "98765"),
            (-2.5, "-2.5"),
        ] {
            assert_eq!(number(x), text);
        }
        assert_eq!(number(1.5e9), "1.50e9");
        assert_eq!(number(f64::NAN), "NaN");
    }
}
