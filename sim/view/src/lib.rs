//! Results to look at: pictures, charts and the report's page.
//!
//! | module | what it holds |
//! |---|---|
//! | [`picture`] | pictures as PNG and EXR, heat maps, the difference of two pictures |
//! | [`plot`] | charts as SVG |
//! | [`report`] | the page that holds tables, charts and pictures |
//!
//! ```
//! use view::picture::difference::Difference;
//! use view::picture::{Format, Picture};
//! use view::plot::{Axis, Chart, Point, Series, Style};
//!
//! let white = Picture::filled(4, 4, [1.0_f32; 3]);
//! let mut other = white.clone();
//! other.set(2, 1, [0.5, 1.0, 1.0]);
//! let difference = Difference::new(Format::Png, &white, &other)?;
//! assert_eq!((difference.differing_pixels, difference.max_abs), (1, 0.5));
//!
//! let points = [(1.0, 2.0), (2.0, 4.0)].map(|(x, y)| Point { x, y, ..Point::default() });
//! let series = Series { name: "measured".into(), style: Style::Line, points: points.into() };
//! let chart = Chart {
//!     title: "Time".into(),
//!     x: Axis::linear("triangles"),
//!     y: Axis::linear("ms"),
//!     series: vec![series],
//! };
//! assert!(chart.svg().starts_with("<svg"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod picture;
pub mod plot;
pub mod report;
