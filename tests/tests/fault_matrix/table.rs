//! The matrix as a table.

use std::fmt::Write;

use crate::cell::Kind;
use crate::model::Expected;
use crate::outcome::Outcome;
use crate::troubles::Trouble;

const BEGIN: &str =
    "<!-- The fault matrix begins. Written by `UPDATE_EXPECT=1 cargo test -p jaka-tests --test fault_matrix`. -->";
const END: &str = "<!-- The fault matrix ends. -->";

/// Page with this table.
pub(crate) const DOCUMENT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fault_matrix/table.md");

/// The cells of a row.
type Row = [Expected; Kind::ALL.len()];

/// A table in Markdown. Faults of links with which all goes the same way stand in one row.
pub(crate) fn table(troubles: &[Trouble], rows: &[Row]) -> String {
    let mut table = "|".to_owned();
    for name in [""].into_iter().chain(Kind::ALL.map(name)) {
        push(&mut table, name);
    }
    table.push_str("\n|");
    table.push_str(&"---|".repeat(Kind::ALL.len() + 1));
    for (names, cells) in groups(troubles, rows) {
        table.push_str("\n|");
        push(&mut table, &names.join("<br>"));
        for cell in cells {
            push(&mut table, &text(*cell));
        }
    }
    table + "\n"
}

fn groups<'r>(troubles: &[Trouble], rows: &'r [Row]) -> Vec<(Vec<String>, &'r Row)> {
    let mut groups: Vec<(bool, Vec<String>, &Row)> = Vec::new();
    for (trouble, row) in troubles.iter().zip(rows) {
        let (name, is_link) = (format!("`{trouble}`"), matches!(trouble, Trouble::Link(_)));
        match groups.iter_mut().find(|(is_group, _, other)| is_link && *is_group && *other == row) {
            Some((_, names, _)) => names.push(name),
            None => groups.push((is_link, vec![name], row)),
        }
    }
    groups.into_iter().map(|(_, names, row)| (names, row)).collect()
}

fn push(table: &mut String, cell: &str) {
    // Writing to a string cannot fail.
    let _ = write!(table, " {} |", cell.replace('|', "\\|"));
}

fn name(kind: Kind) -> &'static str {
    match kind {
        Kind::Query => "query",
        Kind::Setting => "setting",
        Kind::Raw => "raw call",
        Kind::Text => "`call_text`",
        Kind::Recorded => "recorded",
        Kind::Stop => "stop",
        Kind::StopBeside => "query + stop",
        Kind::Motion => "motion",
        Kind::EndOfMotion => "end of motion",
        Kind::Entering => "entering servo mode",
        Kind::SetPoints => "set-points",
        Kind::StatusStream => "status stream",
        Kind::Monitor => "monitor",
    }
}

/// Outcome of the call, and unusual outcomes of the next calls.
fn text(cell: Expected) -> String {
    let (first, stop) = (Some(cell.first.to_string()), cell.stop.map(|stop| format!(" + {stop}")));
    let next = (cell.other != usual(cell.stop.unwrap_or(cell.first))).then(|| format!(", next {}", cell.other));
    let again = cell.same.filter(|same| *same != cell.other).map(|same| format!(", again {same}"));
    [first, stop, next, again].into_iter().flatten().collect()
}

/// Usual outcome of the next call: an equal outcome on a broken connection, and success otherwise.
fn usual(outcome: Outcome) -> Outcome {
    if matches!(outcome, Outcome::Broken(_)) { outcome } else { Outcome::Ok }
}

/// Page with this table in its place.
pub(crate) fn in_document(table: &str) -> String {
    let document = std::fs::read_to_string(DOCUMENT).expect("the document is there");
    let (before, rest) = document.split_once(BEGIN).expect("the document has a place for the matrix");
    let (_, after) = rest.split_once(END).expect("the place for the matrix ends");
    format!("{before}{BEGIN}\n\n{table}\n{END}{after}")
}
