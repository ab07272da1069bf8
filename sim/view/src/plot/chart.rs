//! Charts of points and lines over two axes.

use super::labels::{Label, places};
use super::legend::Legend;
use super::log_scale::LogScale;
use super::palette::colour;
use super::{FONT, FONT_PX, GRID, INK, TITLE_PX, TOP, WIDTH, number, responsive};
use plotters::coord::ranged1d::{Ranged, ValueFormatter};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// One axis.
#[derive(Clone, Debug, Default)]
pub struct Axis {
    /// The quantity and its unit.
    pub label: String,
    /// Whether the scale is logarithmic. A logarithmic scale leaves out points that are not positive.
    pub log: bool,
}

/// How a series is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Style {
    /// Markers.
    #[default]
    Points,
    /// Markers joined in their order.
    Line,
}

/// One point.
#[derive(Clone, Debug, Default)]
pub struct Point {
    /// Position along the horizontal axis.
    pub x: f64,
    /// Position along the vertical axis.
    pub y: f64,
    /// Ends of the error bar along the vertical axis.
    pub y_range: Option<(f64, f64)>,
    /// Text beside the point.
    pub label: Option<String>,
    /// Whether the point is marked by a ring, as on a Pareto front.
    pub marked: bool,
}

/// Points with a common name and style.
#[derive(Clone, Debug, Default)]
pub struct Series {
    /// Name in the legend.
    pub name: String,
    /// How the points are drawn.
    pub style: Style,
    /// The points, in the order in which they are joined.
    pub points: Vec<Point>,
}

/// A chart of series.
#[derive(Clone, Debug, Default)]
pub struct Chart {
    /// The heading of the chart.
    pub title: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// The series, the first one below the others.
    pub series: Vec<Series>,
}

/// Height in pixels without the legend.
const HEIGHT: u32 = 440;
const MARKER: i32 = 4;

impl Axis {
    /// A linear axis that fits the points.
    #[must_use]
    pub fn linear(label: &str) -> Self {
        Self { label: label.to_owned(), ..Self::default() }
    }

    /// A logarithmic axis that fits the points.
    #[must_use]
    pub fn log(label: &str) -> Self {
        Self { log: true, ..Self::linear(label) }
    }

    fn shows(&self, value: f64) -> bool {
        value.is_finite() && (!self.log || value > 0.0)
    }

    /// The ends of the axis.
    fn extent(&self, values: impl Iterator<Item = f64>) -> (f64, f64) {
        let (low, high) = values
            .filter(|&v| self.shows(v))
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
        match (low <= high, self.log) {
            (false, true) => (1.0, 10.0),
            (false, false) => (0.0, 1.0),
            (true, true) => ((low / 1.5).max(f64::MIN_POSITIVE), (high * 1.5).min(f64::MAX)),
            (true, false) => {
                // If the values come near zero, the scale includes zero, so that lengths can be compared.
                let low = if low >= 0.0 && low < high / 2.0 { 0.0 } else { low };
                let margin = if high > low { 0.06 * (high - low) } else { 0.5 * high.abs().max(1.0) };
                (if low == 0.0 { 0.0 } else { low - margin }, high + margin)
            }
        }
    }
}

impl Chart {
    /// The chart as SVG.
    #[must_use]
    pub fn svg(&self) -> String {
        let points = || self.series.iter().flat_map(|series| &series.points);
        let x = self.x.extent(points().map(|p| p.x));
        let ys = points().flat_map(|p| p.y_range.map_or([p.y; 3], |(low, high)| [low, p.y, high]));
        let y = self.y.extent(ys);
        let legend = Legend::new(self.series.iter().map(|series| series.name.as_str()));
        let height = HEIGHT + legend.height() as u32;
        let mut svg = String::new();
        {
            let root = SVGBackend::with_string(&mut svg, (WIDTH, height)).into_drawing_area();
            let log = |(low, high)| LogScale::new(low, high);
            let drawn = match (self.x.log, self.y.log) {
                (false, false) => self.draw(&root, &legend, x.0..x.1, y.0..y.1),
                (true, false) => self.draw(&root, &legend, log(x), y.0..y.1),
                (false, true) => self.draw(&root, &legend, x.0..x.1, log(y)),
                (true, true) => self.draw(&root, &legend, log(x), log(y)),
            };
            drawn.and_then(|()| root.present()).expect("a string accepts a drawing");
        }
        responsive(&svg, &self.title, WIDTH, height)
    }

    fn draw<B: DrawingBackend, X, Y>(
        &self,
        root: &DrawingArea<B, plotters::coord::Shift>,
        legend: &Legend,
        x: X,
        y: Y,
    ) -> Result<(), DrawingAreaErrorKind<B::ErrorType>>
    where
        X: plotters::coord::ranged1d::AsRangedCoord<Value = f64>,
        Y: plotters::coord::ranged1d::AsRangedCoord<Value = f64>,
        X::CoordDescType: Ranged<ValueType = f64> + ValueFormatter<f64>,
        Y::CoordDescType: Ranged<ValueType = f64> + ValueFormatter<f64>,
    {
        root.fill(&WHITE)?;
        root.draw(&Text::new(self.title.clone(), (8, 8), (FONT, TITLE_PX).into_font().color(&INK)))?;
        let middle = (FONT, FONT_PX).into_font().color(&INK).pos(Pos::new(HPos::Left, VPos::Center));
        for entry in &legend.entries {
            let (x, y) = (entry.x, TOP + entry.y + 6);
            let outline = marker_outline(entry.series).into_iter().map(|(dx, dy)| (x + 6 + dx, y + dy));
            let name = &self.series[entry.series].name;
            root.draw(&Polygon::new(outline.collect::<Vec<_>>(), colour(name, entry.series).filled()))?;
            root.draw(&Text::new(name.clone(), (x + 17, y), middle.clone()))?;
        }
        let mut chart = ChartBuilder::on(root)
            .margin(10)
            .margin_top(TOP + legend.height() + 4)
            .margin_right(24)
            .x_label_area_size(44)
            .y_label_area_size(68)
            .build_cartesian_2d(x, y)?;
        chart
            .configure_mesh()
            .light_line_style(WHITE)
            .bold_line_style(GRID)
            .axis_style(INK)
            .label_style((FONT, FONT_PX).into_font().color(&INK))
            .x_desc(&self.x.label)
            .y_desc(&self.y.label)
            .x_label_formatter(&|v| number(*v))
            .y_label_formatter(&|v| number(*v))
            .draw()?;
        let (mut labels, mut points) = (vec![], vec![]);
        for (index, series) in self.series.iter().enumerate() {
            let colour = colour(&series.name, index);
            let shown: Vec<&Point> =
                series.points.iter().filter(|p| self.x.shows(p.x) && self.y.shows(p.y)).collect();
            if series.style == Style::Line {
                let line = shown.iter().map(|p| (p.x, p.y));
                chart.draw_series(LineSeries::new(line, colour.stroke_width(2)))?;
            }
            for point in &shown {
                if let Some((low, high)) =
                    point.y_range.filter(|&(low, high)| self.y.shows(low) && self.y.shows(high))
                {
                    let bar = PathElement::new([(point.x, low), (point.x, high)], colour.stroke_width(1));
                    chart.draw_series([bar])?;
                }
            }
            let marker = |p: &&Point| {
                EmptyElement::at((p.x, p.y)) + Polygon::new(marker_outline(index), colour.filled())
            };
            chart.draw_series(shown.iter().map(marker))?;
            let rings = shown.iter().filter(|p| p.marked);
            chart.draw_series(rings.map(|p| Circle::new((p.x, p.y), MARKER + 4, INK.stroke_width(1))))?;
            for point in &shown {
                let at = chart.backend_coord(&(point.x, point.y));
                points.push(at);
                labels.extend(point.label.clone().map(|text| Label { text, at }));
            }
        }
        let (across, down) = chart.plotting_area().get_pixel_range();
        let style = (FONT, FONT_PX - 2).into_font().color(&INK);
        let area = [across.start, down.start, across.end, down.end];
        for (label, place) in labels.iter().zip(places(&labels, &points, area)) {
            if let Some(place) = place {
                root.draw(&Text::new(label.text.clone(), place, style.clone()))?;
            }
        }
        Ok(())
    }
}

/// The shape of a series' markers, in pixels around the point. The shapes repeat: square, diamond, two triangles, bar.
fn marker_outline(index: usize) -> Vec<(i32, i32)> {
    let r = MARKER;
    match index % 5 {
        0 => vec![(-r, -r), (r, -r), (r, r), (-r, r)],
        1 => vec![(0, -r - 2), (r + 2, 0), (0, r + 2), (-r - 2, 0)],
        2 => vec![(0, -r - 1), (r + 1, r), (-r - 1, r)],
        3 => vec![(0, r + 1), (r + 1, -r), (-r - 1, -r)],
        _ => vec![(-r - 2, -2), (r + 2, -2), (r + 2, 2), (-r - 2, 2)],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(values: &[(f64, f64)]) -> Vec<Point> {
        values.iter().map(|&(x, y)| Point { x, y, ..Point::default() }).collect()
    }

    #[test]
    fn draws_all_series_with_labels_rings_and_error_bars() {
        let mut series =
            Series { name: "naive".into(), style: Style::Line, points: points(&[(8.0, 1.0), (24.0, 3.0)]) };
        series.points[0].label = Some("8 bits".into());
        series.points[1].marked = true;
        series.points[1].y_range = Some((2.5, 3.5));
        let second =
            Series { name: "conservative".into(), style: Style::Points, points: points(&[(11.0, 2.0)]) };
        let chart = Chart {
            title: "Precision".into(),
            x: Axis::linear("significand (bits)"),
            y: Axis::log("energy (mJ)"),
            series: vec![series, second],
        };
        let svg = chart.svg();
        for text in [
            "role=\"img\"",
            "<title>Precision</title>",
            "significand (bits)",
            "energy (mJ)",
            "naive",
            "conservative",
            "8 bits",
            "<circle",
        ] {
            assert!(svg.contains(text), "{text} in {svg}");
        }
        assert_eq!(svg, chart.svg());
    }

    #[test]
    fn short_logarithmic_axes_have_ticks() {
        let points = points(&[(0.03, 1.0), (0.05, 2.0)]);
        let series = vec![Series { points, ..Series::default() }];
        let chart = Chart { x: Axis::log("host time (s)"), series, ..Chart::default() };
        for tick in [">\n0.02\n<", ">\n0.05\n<"] {
            assert!(chart.svg().contains(tick), "{}", chart.svg());
        }
    }

    #[test]
    fn points_that_a_scale_cannot_show_are_left_out() {
        let series =
            Series { name: "a".into(), points: points(&[(1.0, 0.0), (2.0, f64::NAN)]), ..Series::default() };
        let ends =
            Series { points: points(&[(1.0, f64::MIN_POSITIVE), (2.0, f64::MAX)]), ..Series::default() };
        let widest = Chart { y: Axis::log("y"), series: vec![ends], ..Chart::default() };
        assert!(widest.svg().contains("</svg>"));
        for log in [false, true] {
            let y = Axis { log, ..Axis::linear("y") };
            let chart =
                Chart { title: "empty".into(), x: Axis::linear("x"), y, series: vec![series.clone()] };
            assert!(chart.svg().contains("empty"));
        }
        assert!(Chart::default().svg().contains("</svg>"));
    }
}
