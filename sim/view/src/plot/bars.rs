//! Charts of horizontal bars in groups, side by side or stacked.

use super::legend::Legend;
use super::{FONT, FONT_PX, GRID, INK, TITLE_PX, TOP, WIDTH, colour, number, responsive, text_width};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Quantities of several series in several categories.
#[derive(Clone, Debug, Default)]
pub struct Bars {
    /// The heading of the chart.
    pub title: String,
    /// The quantity and its unit.
    pub unit: String,
    /// Names of the categories, each of which has a group of bars.
    pub categories: Vec<String>,
    /// For each series, its name, and its value in each category, which may be absent.
    pub series: Vec<(String, Vec<Option<f64>>)>,
    /// Whether the series of a category add up in one bar.
    pub stacked: bool,
    /// End of the scale, to compare several charts; the largest value if absent.
    pub max: Option<f64>,
}

const BAR: i32 = 16;
const GAP: i32 = 12;
const RIGHT: i32 = 84;

impl Bars {
    /// The chart as SVG.
    #[must_use]
    pub fn svg(&self) -> String {
        let legend = Legend::new(self.series.iter().map(|(name, _)| name.as_str()));
        let group = if self.stacked { BAR } else { BAR * self.series.len().max(1) as i32 };
        let top = TOP + legend.height() + 6;
        let height = (top + (group + GAP) * self.categories.len() as i32 + 12) as u32;
        let mut svg = String::new();
        {
            let root = SVGBackend::with_string(&mut svg, (WIDTH, height)).into_drawing_area();
            // A backend that writes to a string does not fail.
            self.draw(&root, &legend, top, group).expect("a string accepts a drawing");
            root.present().expect("a string accepts a drawing");
        }
        responsive(&svg, WIDTH, height)
    }

    fn scale_max(&self) -> f64 {
        let value =
            |series: &(String, Vec<Option<f64>>), c: usize| series.1.get(c).copied().flatten().unwrap_or(0.0);
        let largest = (0..self.categories.len())
            .map(|c| {
                let values = self.series.iter().map(|series| value(series, c));
                if self.stacked { values.sum() } else { values.fold(0.0, f64::max) }
            })
            .fold(0.0, f64::max);
        let max = self.max.unwrap_or(largest);
        if max > 0.0 { max } else { 1.0 }
    }

    fn draw<B: DrawingBackend>(
        &self,
        root: &DrawingArea<B, plotters::coord::Shift>,
        legend: &Legend,
        top: i32,
        group: i32,
    ) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
        root.fill(&WHITE)?;
        let text = |px: u32| (FONT, px).into_font().color(&INK);
        let left_middle = text(FONT_PX).pos(Pos::new(HPos::Left, VPos::Center));
        let right_middle = text(FONT_PX).pos(Pos::new(HPos::Right, VPos::Center));
        let title =
            if self.unit.is_empty() { self.title.clone() } else { format!("{} ({})", self.title, self.unit) };
        root.draw(&Text::new(title, (8, 8), text(TITLE_PX)))?;
        for entry in &legend.entries {
            let (x, y) = (entry.x, TOP + entry.y);
            root.draw(&Rectangle::new([(x, y), (x + 12, y + 12)], colour(entry.series).filled()))?;
            let name = self.series[entry.series].0.clone();
            root.draw(&Text::new(name, (x + 17, y + 6), left_middle.clone()))?;
        }
        let left = 16 + self.categories.iter().map(|name| text_width(name)).max().unwrap_or(0) as i32;
        let per_unit = f64::from(WIDTH as i32 - RIGHT - left) / self.scale_max();
        for (c, category) in self.categories.iter().enumerate() {
            let y = top + (group + GAP) * c as i32;
            root.draw(&PathElement::new([(left, y - GAP / 2), (WIDTH as i32, y - GAP / 2)], GRID))?;
            root.draw(&Text::new(category.clone(), (left - 8, y + group / 2), right_middle.clone()))?;
            let mut base = 0.0;
            for (s, (_, values)) in self.series.iter().enumerate() {
                let Some(value) = values.get(c).copied().flatten() else { continue };
                let y = if self.stacked { y } else { y + BAR * s as i32 };
                let x = |v: f64| left + (v * per_unit).round().clamp(0.0, f64::from(WIDTH)) as i32;
                let (from, to) = if self.stacked { (base, base + value) } else { (0.0, value) };
                root.draw(&Rectangle::new(
                    [(x(from), y + 1), (x(to).max(x(from) + 1), y + BAR - 1)],
                    colour(s).filled(),
                ))?;
                if !self.stacked {
                    root.draw(&Text::new(number(value), (x(to) + 5, y + BAR / 2), left_middle.clone()))?;
                }
                base = to;
            }
            if self.stacked {
                let end = left + (base * per_unit).round() as i32;
                root.draw(&Text::new(number(base), (end + 5, y + BAR / 2), left_middle.clone()))?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn example(stacked: bool) -> Bars {
        Bars {
            title: "Frame time".into(),
            unit: "ms".into(),
            categories: vec!["atrium".into(), "hairball".into()],
            series: vec![("dst".into(), vec![Some(1.5), Some(4.0)]), ("bvh2".into(), vec![Some(2.5), None])],
            stacked,
            max: None,
        }
    }

    #[test]
    fn every_number_stands_beside_its_bar() {
        let svg = example(false).svg();
        for text in ["Frame time (ms)", "atrium", "hairball", "dst", "bvh2", "1.5", "4", "2.5"] {
            assert!(svg.contains(text), "{text} in {svg}");
        }
        let sums = example(true).svg();
        assert!(sums.contains("\n4\n") && !sums.contains("\n2.5\n"), "{sums}");
    }

    #[test]
    fn a_common_scale_makes_equal_bars_equal() {
        let mut small = example(false);
        small.series.truncate(1);
        small.series[0].1 = vec![Some(1.5), None];
        small.max = Some(4.0);
        let width = |svg: &str| {
            let bar =
                svg.split("<rect").find(|rect| rect.contains("#0072B2") && rect.contains("height=\"14\""));
            bar.and_then(|rect| rect.split("width=\"").nth(1)?.split('"').next()?.parse::<u32>().ok())
        };
        assert_eq!(width(&small.svg()), width(&example(false).svg()));
        assert!(width(&small.svg()).is_some());
    }
}
