//! A report as one self-contained HTML page. Charts and pictures are part of the page, which loads no other file.
//!
//! A [`Page`] is a list of [`Section`]s, each with text, tables, charts and pictures. Below each table and chart, the page names
//! the file with its numbers and the command that makes it again.

mod page;

pub use page::{Figure, Item, Page, Picture, Section, Table};
