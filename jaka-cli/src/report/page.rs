//! HTML: what is shown of a recording is escaped here.

mod tables;

use std::fmt::Write as _;

use jaka_sync::proto::text::visible;

pub(super) use self::tables::{commands, events, facts, problems};

const STYLE: &str = include_str!("page/style.css");

/// A page as it is written.
#[derive(Debug)]
pub(super) struct Page(String);

impl Page {
    /// The page of a recording of this name.
    pub(super) fn new(name: &str) -> Self {
        let title = format!("Report of {}", text(name));
        Self(format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width\">\n<title>{title}</title>\n<style>\n{STYLE}</style>\n\
             </head>\n<body>\n<h1>{title}</h1>\n"
        ))
    }

    /// Adds a part with this HTML.
    pub(super) fn section(&mut self, id: &str, title: &str, html: &str) {
        // Writing to a string cannot fail.
        let _ = writeln!(self.0, "<section id=\"{id}\">\n<h2>{title}</h2>\n{html}</section>");
    }

    /// The whole page.
    pub(super) fn end(self) -> String {
        self.0 + "</body>\n</html>\n"
    }
}

/// A text of others: in visible characters, none of which is HTML.
fn text(text: &str) -> String {
    escaped(&visible(text))
}

/// A text none of whose characters is HTML.
pub(super) fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '&' => escaped.push_str("&amp;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&#39;"),
            _ => escaped.push(c),
        }
    }
    escaped
}

/// A paragraph of our own text.
pub(super) fn paragraph(html: &str) -> String {
    format!("<p>{html}</p>\n")
}

/// Pictures side by side, if they have room.
pub(super) fn figure(pictures: &[String]) -> String {
    if pictures.is_empty() { String::new() } else { format!("<figure>\n{}</figure>\n", pictures.concat()) }
}
