//! The parts of a page, and its HTML.

use crate::plot::escape;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use std::fmt::Write;

/// A report.
#[derive(Clone, Debug, Default)]
pub struct Page {
    /// Heading of the page, and title of its window.
    pub title: String,
    /// Paragraphs below the heading.
    pub summary: Vec<String>,
    /// The sections, in order of reading.
    pub sections: Vec<Section>,
}

/// A part with a heading.
#[derive(Clone, Debug, Default)]
pub struct Section {
    /// The heading. Its anchor is the same text in lower case with hyphens.
    pub title: String,
    /// Paragraphs below the heading. `[words](#anchor)` is a link to another part of the page.
    pub text: Vec<String>,
    /// Tables, charts and pictures below the text, in order.
    pub items: Vec<Item>,
}

/// A table, a chart, a row of pictures, or more of them.
#[derive(Clone, Debug)]
pub enum Item {
    /// A table.
    Table(Table),
    /// A chart.
    Figure(Figure),
    /// Pictures side by side.
    Pictures(Vec<Picture>),
    /// A paragraph, as in [`Section::text`].
    Text(String),
    /// Items that the reader unfolds, below a line that says what they are.
    Folded(String, Vec<Item>),
}

/// A table. Columns whose cells are all numbers are aligned to the right; the first cell of a row names it.
#[derive(Clone, Debug, Default)]
pub struct Table {
    /// What the table shows.
    pub caption: String,
    /// Column headings.
    pub header: Vec<String>,
    /// Cells, as many in each row as headings.
    pub rows: Vec<Vec<String>>,
    /// The path, relative to the page, of the file with the numbers; empty if there is none.
    pub csv: String,
    /// The command that makes the numbers again; empty if there is none.
    pub command: String,
}

/// A chart.
#[derive(Clone, Debug, Default)]
pub struct Figure {
    /// The chart as an SVG element.
    pub svg: String,
    /// The caption.
    pub caption: String,
    /// See [`Table::csv`].
    pub csv: String,
    /// See [`Table::command`].
    pub command: String,
}

/// A picture.
#[derive(Clone, Debug, Default)]
pub struct Picture {
    /// The bytes of a PNG file.
    pub png: Vec<u8>,
    /// The caption.
    pub caption: String,
}

impl Table {
    /// A table with this caption, this header and these rows.
    #[must_use]
    pub fn new<const N: usize>(
        caption: &str,
        header: [&str; N],
        rows: impl IntoIterator<Item = [String; N]>,
    ) -> Self {
        Self {
            caption: caption.to_owned(),
            header: header.map(str::to_owned).to_vec(),
            rows: rows.into_iter().map(|row| row.to_vec()).collect(),
            ..Self::default()
        }
    }

    /// Adds the CSV file and the command of the table's numbers.
    #[must_use]
    pub fn from(mut self, csv: &str, command: &str) -> Self {
        (self.csv, self.command) = (csv.to_owned(), command.to_owned());
        self
    }

    fn html(&self) -> String {
        let number = |column: usize| {
            let is_number =
                |cell: &String| cell.is_empty() || cell.trim_end_matches(['%', 'x']).parse::<f64>().is_ok();
            self.rows.iter().all(|row| row.get(column).is_none_or(is_number))
        };
        let class = |column: usize| if number(column) { " class=\"number\"" } else { "" };
        let cell = |column: usize, text: &String| match column {
            0 => format!("<th scope=\"row\"{}>{}</th>", class(0), escape(text)),
            _ => format!("<td{}>{}</td>", class(column), escape(text)),
        };
        let row = |cells: &Vec<String>| {
            let cells: String = cells.iter().enumerate().map(|(column, text)| cell(column, text)).collect();
            format!("<tr>{cells}</tr>\n")
        };
        let head = self.header.iter().enumerate();
        let head = head.map(|(c, text)| format!("<th scope=\"col\"{}>{}</th>", class(c), escape(text)));
        scrolling(
            &self.caption,
            &format!(
                "<table>\n<caption>{}</caption>\n<thead><tr>{}</tr></thead>\n<tbody>\n{}</tbody>\n</table>",
                escape(&self.caption),
                head.collect::<String>(),
                self.rows.iter().map(row).collect::<String>()
            ),
        ) + &paragraph("p class=\"source\"", &source(&self.csv, &self.command))
    }
}

/// `html` in a box that scrolls sideways where the page is too narrow for it, and then says so. A screen reader calls it `name`.
fn scrolling(name: &str, html: &str) -> String {
    format!(
        "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"{}\">{html}</div>\n\
         <p class=\"hint\" aria-hidden=\"true\">scrolls sideways \u{2194}</p>\n",
        escape(name)
    )
}

impl Page {
    /// The page as one document.
    #[must_use]
    pub fn html(&self) -> String {
        let mut body = format!("<h1>{}</h1>\n{}", escape(&self.title), paragraphs(&self.summary));
        body += "<nav>\n";
        for section in &self.sections {
            let _ = writeln!(body, "<a href=\"#{}\">{}</a>", anchor(&section.title), escape(&section.title));
        }
        body += "</nav>\n";
        for section in &self.sections {
            let _ = writeln!(
                body,
                "<section>\n<h2 id=\"{}\">{}</h2>",
                anchor(&section.title),
                escape(&section.title)
            );
            body += &paragraphs(&section.text);
            body.extend(section.items.iter().map(Item::html));
            body += "</section>\n";
        }
        format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n{body}<script>\n{}</script>\n</body>\n</html>\n",
            escape(&self.title),
            include_str!("style.css"),
            include_str!("scroll.js")
        )
    }
}

impl Item {
    fn html(&self) -> String {
        match self {
            Self::Table(table) => table.html(),
            Self::Figure(figure) => format!(
                "<figure>\n{}<figcaption>{} {}</figcaption>\n</figure>\n",
                scrolling(&figure.caption, figure.svg.trim()),
                escape(&figure.caption),
                source(&figure.csv, &figure.command)
            ),
            Self::Pictures(pictures) => {
                let pictures: String = pictures.iter().map(Picture::html).collect();
                format!("<div class=\"pictures\">\n{pictures}</div>\n")
            }
            Self::Text(text) => paragraph("p", &linked(text)),
            Self::Folded(summary, items) => {
                let items: String = items.iter().map(Self::html).collect();
                format!("<details>\n<summary>{}</summary>\n{items}</details>\n", escape(summary))
            }
        }
    }
}

impl Picture {
    fn html(&self) -> String {
        let caption = escape(&self.caption);
        format!(
            "<figure><img alt=\"{caption}\" src=\"data:image/png;base64,{}\"><figcaption>{caption}</figcaption></figure>\n",
            STANDARD.encode(&self.png)
        )
    }
}

/// The line that names the file and the command of some numbers.
fn source(csv: &str, command: &str) -> String {
    let mut parts = vec![];
    if !csv.is_empty() {
        parts.push(format!("<a href=\"{0}\">{0}</a>", escape(csv)));
    }
    if !command.is_empty() {
        parts.push(format!("<code>{}</code>", escape(command)));
    }
    parts.join(" · ")
}

fn paragraphs(texts: &[String]) -> String {
    texts.iter().map(|text| paragraph("p", &linked(text))).collect()
}

/// `text` as HTML, with its links.
fn linked(text: &str) -> String {
    let mut html = String::new();
    let mut rest = text;
    while let Some((before, words, target, after)) = link(rest) {
        let _ = write!(html, "{}<a href=\"{}\">{}</a>", escape(before), escape(target), escape(words));
        rest = after;
    }
    html + &escape(rest)
}

/// The first link of `text`: what is before it, its words, its target, and what is behind it.
fn link(text: &str) -> Option<(&str, &str, &str, &str)> {
    let middle = text.find("](#")?;
    let start = text[..middle].rfind('[')?;
    let end = middle + text[middle..].find(')')?;
    Some((&text[..start], &text[start + 1..middle], &text[middle + 2..end], &text[end + 1..]))
}

/// A paragraph, or an empty string if there is no text.
fn paragraph(open: &str, html: &str) -> String {
    if html.is_empty() { String::new() } else { format!("<{open}>{html}</p>\n") }
}

fn anchor(title: &str) -> String {
    title
        .to_lowercase()
        .split(|c: char| !c.is_alphanumeric())
        .filter(|part| !part.is_empty())
        .collect::<Vec<_>>()
        .join("-")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_holds_everything_and_loads_nothing() {
        let table = Table::new("Units", ["unit", "area"], [["fp_add <1>".to_owned(), "3.5".to_owned()]])
            .from("a.csv", "dualsplit a");
        let figure = Figure { svg: "<svg></svg>".into(), caption: "A & B".into(), ..Figure::default() };
        let picture = Picture { png: vec![1, 2, 3], caption: "atrium".into() };
        let page = Page {
            title: "Report".into(),
            summary: vec!["What was built.".into()],
            sections: vec![Section {
                title: "Units, pipelines".into(),
                text: vec!["See [the units](#units-pipelines), [1] <2>.".into()],
                items: vec![
                    Item::Table(table),
                    Item::Folded("More".into(), vec![Item::Figure(figure), Item::Pictures(vec![picture])]),
                ],
            }],
        };
        let html = page.html();
        for part in [
            "<a href=\"#units-pipelines\">",
            "<h2 id=\"units-pipelines\">",
            "<caption>Units</caption>",
            "<th scope=\"col\">unit</th><th scope=\"col\" class=\"number\">area</th>",
            "<th scope=\"row\">fp_add &lt;1&gt;</th><td class=\"number\">3.5</td>",
            "See <a href=\"#units-pipelines\">the units</a>, [1] &lt;2&gt;.",
            "<details>\n<summary>More</summary>",
            "aria-label=\"A &amp; B\"",
            "scrolls sideways",
            "<a href=\"a.csv\">",
            "<code>dualsplit a</code>",
            "A &amp; B",
            "data:image/png;base64,AQID",
        ] {
            assert!(html.contains(part), "{part} in {html}");
        }
        assert!(!html.contains("http"), "nothing is loaded from elsewhere");
    }
}
