//! A report as one self-contained HTML page. Drawings and pictures are part of the page, and it loads nothing.
//!
//! A [`Page`] is a list of [`Section`]s, each with text, tables, drawings and pictures. Beside every table and drawing
//! stand the file with its numbers and the command that makes it again.

mod page;

pub use page::{Figure, Item, Page, Picture, Section, Table};
