//! Charts of horizontal bars in groups, side by side or stacked.

use super::legend::Legend;
use super::palette::colour;
use super::{FONT, FONT_PX, GRID, INK, TITLE_PX, TOP, WIDTH, number, responsive, text_width};
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
    /// What stands beside the bars: for each series, a text for each category; of a stacked chart, the texts of the last series. Where
    /// there is none, the number stands there.
    pub texts: Vec<Vec<String>>,
    /// Whether a line goes through all categories at 1, to which ratios are compared.
    pub unit_line: bool,
}

const BAR: i32 = 16;
const GAP: i32 = 12;
/// Height of a line of a category's name.
const LINE: i32 = 18;
/// The most characters in a line of a category's name.
const LINE_CHARACTERS: usize = 34;

impl Bars {
    /// These quantities divided by `reference`, which has one for each category and is called `name`. The quantities themselves, or
    /// their sums if they are stacked, stand in brackets behind the ratios.
    #[must_use]
    pub fn in_multiples_of(self, name: &str, reference: &[Option<f64>]) -> Self {
        let ratio = |value: Option<f64>, c: usize| Some(value? / reference.get(c).copied().flatten()?);
        let text = |value: Option<f64>, c: usize| {
            let of = |value: f64, ratio: f64| format!("{ratio:.2} ({})", number(value));
            value.zip(ratio(value, c)).map(|(value, ratio)| of(value, ratio)).unwrap_or_default()
        };
        let shown = |s: usize, c: usize| match self.stacked {
            true => self
                .series
                .iter()
                .filter_map(|(_, values)| values.get(c).copied().flatten())
                .reduce(|a, b| a + b),
            false => self.series[s].1.get(c).copied().flatten(),
        };
        let categories = 0..self.categories.len();
        let texts = |s: usize| categories.clone().map(|c| text(shown(s, c), c)).collect();
        let texts = (0..self.series.len()).map(texts).collect();
        let divided = |(name, values): &(String, Vec<Option<f64>>)| {
            let ratios = values.iter().enumerate().map(|(c, value)| ratio(*value, c));
            (name.clone(), ratios.collect())
        };
        Self {
            unit: format!("in multiples of {name}; {} in brackets", self.unit),
            series: self.series.iter().map(divided).collect(),
            texts,
            unit_line: true,
            ..self
        }
    }

    /// The chart as SVG.
    #[must_use]
    pub fn svg(&self) -> String {
        let legend = Legend::new(self.series.iter().map(|(name, _)| name.as_str()));
        let lines = self.categories.iter().map(|name| wrapped(name).len()).max().unwrap_or(1) as i32;
        let group = if self.stacked { BAR } else { BAR * self.series.len().max(1) as i32 }
            .max(LINE * lines - GAP / 2);
        let top = TOP + legend.height() + 6;
        let height = (top + (group + GAP) * self.categories.len() as i32 + 12) as u32;
        let mut svg = String::new();
        {
            let root = SVGBackend::with_string(&mut svg, (WIDTH, height)).into_drawing_area();
            // A backend that writes to a string does not fail.
            self.draw(&root, &legend, top, group).expect("a string accepts a drawing");
            root.present().expect("a string accepts a drawing");
        }
        responsive(&svg, &self.heading(), WIDTH, height)
    }

    /// The title with the unit.
    fn heading(&self) -> String {
        if self.unit.is_empty() { self.title.clone() } else { format!("{} ({})", self.title, self.unit) }
    }

    /// What stands beside the bar of `value`.
    fn text(&self, series: usize, category: usize, value: f64) -> String {
        let own = self.texts.get(series).and_then(|texts| texts.get(category));
        own.cloned().unwrap_or_else(|| number(value))
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
        root.draw(&Text::new(self.heading(), (8, 8), text(TITLE_PX)))?;
        for entry in &legend.entries {
            let (x, y) = (entry.x, TOP + entry.y);
            let name = self.series[entry.series].0.clone();
            root.draw(&Rectangle::new([(x, y), (x + 12, y + 12)], colour(&name, entry.series).filled()))?;
            root.draw(&Text::new(name, (x + 17, y + 6), left_middle.clone()))?;
        }
        let names: Vec<Vec<String>> = self.categories.iter().map(|name| wrapped(name)).collect();
        let widest = |texts: &mut dyn Iterator<Item = u32>| texts.max().unwrap_or(0) as i32;
        let left = 16 + widest(&mut names.iter().flatten().map(|line| text_width(line)));
        let texts = self.texts.iter().flatten().map(|text| text_width(text)).chain([text_width("0.00000")]);
        let right = 16 + widest(&mut texts.into_iter());
        let per_unit = f64::from(WIDTH as i32 - right - left) / self.scale_max();
        let unit = left + per_unit.round() as i32;
        let has_line = self.unit_line && self.scale_max() >= 1.0;
        if has_line {
            let bottom = top + (group + GAP) * self.categories.len() as i32 - GAP / 2;
            root.draw(&PathElement::new([(unit, top - GAP / 2), (unit, bottom)], INK))?;
        }
        // A text that would lie over the line at 1 stands behind it.
        let beside = |end: i32, text: &str| {
            let start = end + 5;
            let is_over = has_line && start <= unit && unit <= start + text_width(text) as i32;
            if is_over { unit + 5 } else { start }
        };
        for (c, lines) in names.iter().enumerate() {
            let y = top + (group + GAP) * c as i32;
            root.draw(&PathElement::new([(left, y - GAP / 2), (WIDTH as i32, y - GAP / 2)], GRID))?;
            let first = y + group / 2 - LINE * (lines.len() as i32 - 1) / 2;
            for (n, line) in lines.iter().enumerate() {
                let at = (left - 8, first + LINE * n as i32);
                root.draw(&Text::new(line.clone(), at, right_middle.clone()))?;
            }
            let bars = if self.stacked { BAR } else { BAR * self.series.len().max(1) as i32 };
            let y = y + (group - bars) / 2;
            let mut base = 0.0;
            for (s, (name, values)) in self.series.iter().enumerate() {
                let Some(value) = values.get(c).copied().flatten() else { continue };
                let y = if self.stacked { y } else { y + BAR * s as i32 };
                let x = |v: f64| left + (v * per_unit).round().clamp(0.0, f64::from(WIDTH)) as i32;
                let (from, to) = if self.stacked { (base, base + value) } else { (0.0, value) };
                root.draw(&Rectangle::new(
                    [(x(from), y + 1), (x(to).max(x(from) + 1), y + BAR - 1)],
                    colour(name, s).filled(),
                ))?;
                if !self.stacked {
                    let text = self.text(s, c, value);
                    let at = (beside(x(to), &text), y + BAR / 2);
                    root.draw(&Text::new(text, at, left_middle.clone()))?;
                }
                base = to;
            }
            if self.stacked {
                let end = left + (base * per_unit).round() as i32;
                let text = self.text(self.series.len().saturating_sub(1), c, base);
                let at = (beside(end, &text), y + BAR / 2);
                root.draw(&Text::new(text, at, left_middle.clone()))?;
            }
        }
        Ok(())
    }
}

/// `name` in lines of at most [`LINE_CHARACTERS`] characters, if its words are no longer.
fn wrapped(name: &str) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in name.split_whitespace() {
        let line = lines.last_mut().expect("there is a line");
        if line.is_empty() {
            line.push_str(word);
        } else if line.chars().count() + 1 + word.chars().count() <= LINE_CHARACTERS {
            *line += " ";
            *line += word;
        } else {
            lines.push(word.to_owned());
        }
    }
    lines
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
            ..Bars::default()
        }
    }

    #[test]
    fn ratios_have_a_line_at_one_and_absolute_values_beside_them() {
        let ratios = example(false).in_multiples_of("dst", &[Some(1.5), None]);
        assert_eq!(ratios.series[1].1, [Some(2.5 / 1.5), None]);
        let svg = ratios.svg();
        for text in ["Frame time (in multiples of dst; ms in brackets)", "\n1.00 (1.5)\n", "\n1.67 (2.5)\n"] {
            assert!(svg.contains(text), "{text} in {svg}");
        }
        let plain = Bars { unit_line: false, ..ratios };
        let lines = |svg: &str| svg.matches("<line").count() + svg.matches("<polyline").count();
        assert_eq!(lines(&svg), lines(&plain.svg()) + 1);
        let sums = example(true).in_multiples_of("dst", &[Some(2.0), Some(2.0)]);
        assert!(sums.svg().contains("\n2.00 (4)\n"), "{}", sums.svg());
    }

    #[test]
    fn charts_say_what_they_are_and_long_names_go_on_in_the_next_line() {
        let svg = example(false).svg();
        assert!(svg.contains("role=\"img\"") && svg.contains("<title>Frame time (ms)</title>"), "{svg}");
        let name = "raycast: dst is fastest among single pipelines";
        assert_eq!(wrapped(name), ["raycast: dst is fastest among", "single pipelines"]);
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
