//! Markdown as GitHub reads it.

use std::fmt::Write as _;

pub(super) use crate::prose::{code_span as code, prose as escape};

/// A cell's text, which may have links of ours, without what Markdown would take for HTML or for the cell's end. Code
/// spans stay.
fn cell(text: &str) -> String {
    let text: String = text.chars().map(|c| if crate::prose::is_hidden(c) { ' ' } else { c }).collect();
    // What a link has escaped already.
    let text = text.replace("\\<", "<").replace("\\|", "|");
    let parts = text.split('`').enumerate();
    let parts = parts.map(|(i, part)| if i % 2 == 0 { part.replace('<', "&lt;") } else { part.to_owned() });
    parts.collect::<Vec<_>>().join("`").replace('|', "\\|")
}

/// A link to the heading of this document whose text is `heading`.
pub(super) fn link(text: &str, heading: &str) -> String {
    link_into("", text, heading)
}

/// A link to the heading of `file` whose text is `heading`.
pub(super) fn link_into(file: &str, text: &str, heading: &str) -> String {
    format!("[{}]({file}#{})", escape(text), anchor(heading))
}

/// The anchor that GitHub gives to a heading: letters in lower case, digits, `-` and `_`, and `-` for each blank.
fn anchor(heading: &str) -> String {
    let kept = heading.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    kept.flat_map(char::to_lowercase).map(|c| if c == ' ' { '-' } else { c }).collect()
}

/// A table that leaves out the columns in which no row has anything.
pub(super) struct Table<const N: usize> {
    head: [&'static str; N],
    rows: Vec<[String; N]>,
}

impl<const N: usize> Table<N> {
    pub(super) fn new(head: &[&'static str; N]) -> Self {
        Self { head: *head, rows: Vec::new() }
    }

    pub(super) fn row(&mut self, cells: [String; N]) {
        self.rows.push(cells.map(|text| cell(&text)));
    }

    /// Writes the table and an empty line; nothing if it has no rows.
    pub(super) fn render(&self, out: &mut String) {
        if self.rows.is_empty() {
            return;
        }
        let used: Vec<_> = (0..N).filter(|column| self.rows.iter().any(|row| !row[*column].is_empty())).collect();
        let mut line = |cell: &dyn Fn(usize) -> String| {
            let cells: Vec<_> = used.iter().map(|column| cell(*column)).collect();
            let _ = writeln!(out, "| {} |", cells.join(" | "));
        };
        line(&|column| self.head[column].to_owned());
        line(&|_| "---".to_owned());
        for row in &self.rows {
            line(&|column| row[column].clone());
        }
        *out += "\n";
    }
}
