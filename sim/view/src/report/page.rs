//! The parts of a page, and its HTML.

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
    /// Paragraphs below the heading.
    pub text: Vec<String>,
    /// Tables, charts and pictures below the text, in order.
    pub items: Vec<Item>,
}

/// A table, a chart, or a row of pictures.
#[derive(Clone, Debug)]
pub enum Item {
    /// A table.
    Table(Table),
    /// A chart.
    Figure(Figure),
    /// Pictures side by side.
    Pictures(Vec<Picture>),
}

/// A table. Columns whose cells are all numbers are aligned to the right.
#[derive(Clone, Debug, Default)]
pub struct Table {
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
    /// A table with this header and these rows.
    #[must_use]
    pub fn new<const N: usize>(header: [&str; N], rows: impl IntoIterator<Item = [String; N]>) -> Self {
        Self {
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
        let cells = |tag: &str, cells: &[String]| {
            let cells = cells.iter().enumerate();
            cells.map(|(c, cell)| format!("<{tag}{}>{}</{tag}>", class(c), escape(cell))).collect::<String>()
        };
        let rows: String = self.rows.iter().map(|row| format!("<tr>{}</tr>\n", cells("td", row))).collect();
        format!(
            "<div class=\"scroll\"><table>\n<thead><tr>{}</tr></thead>\n<tbody>\n{rows}</tbody>\n</table></div>\n{}",
            cells("th", &self.header),
            paragraph("p class=\"source\"", &source(&self.csv, &self.command))
        )
    }
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
             <title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n{body}</body>\n</html>\n",
            escape(&self.title),
            include_str!("style.css")
        )
    }
}

impl Item {
    fn html(&self) -> String {
        match self {
            Self::Table(table) => table.html(),
            Self::Figure(figure) => format!(
                "<figure>\n<div class=\"scroll\">{}</div>\n<figcaption>{} {}</figcaption>\n</figure>\n",
                figure.svg.trim(),
                escape(&figure.caption),
                source(&figure.csv, &figure.command)
            ),
            Self::Pictures(pictures) => {
                let pictures: String = pictures.iter().map(Picture::html).collect();
                format!("<div class=\"pictures\">\n{pictures}</div>\n")
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
    texts.iter().map(|text| paragraph("p", &escape(text))).collect()
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

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_holds_everything_and_loads_nothing() {
        let table = Table::new(["unit", "area"], [["fp_add <1>".to_owned(), "3.5".to_owned()]])
            .from("a.csv", "dualsplit a");
        let figure = Figure { svg: "<svg></svg>".into(), caption: "A & B".into(), ..Figure::default() };
        let picture = Picture { png: vec![1, 2, 3], caption: "atrium".into() };
        let page = Page {
            title: "Report".into(),
            summary: vec!["What was built.".into()],
            sections: vec![Section {
                title: "Units, pipelines".into(),
                items: vec![Item::Table(table), Item::Figure(figure), Item::Pictures(vec![picture])],
                ..Section::default()
            }],
        };
        let html = page.html();
        for part in [
            "<a href=\"#units-pipelines\">",
            "<h2 id=\"units-pipelines\">",
            "<td>fp_add &lt;1&gt;</td><td class=\"number\">3.5</td>",
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
