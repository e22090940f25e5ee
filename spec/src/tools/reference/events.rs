//! The controller's events: a table of those with a meaning, and a count of the others.

use std::fmt::Write as _;

use super::markdown::{Table, code};
use crate::words::{event_codes, list};
use crate::{Event, Severity};

/// The line of the index.
pub(super) fn index(out: &mut String, events: &[Event]) {
    if !events.is_empty() {
        let _ = writeln!(out, "- Events: {}", counts(&events.iter()));
    }
}

/// The table, by code, and a sentence on the other codes.
pub(super) fn render(out: &mut String, events: &[Event]) {
    let (known, others): (Vec<_>, Vec<_>) = events.iter().partition(|event| event.meaning.is_some());
    let mut known: Vec<_> = known.iter().filter_map(|event| Some((*event, event.meaning.as_ref()?))).collect();
    known.sort_by_key(|(event, _)| event.codes().min());
    let mut table = Table::new(&["code", "severity", "meaning"]);
    for (event, meaning) in known {
        let codes: Vec<_> = event.codes.iter().map(|codes| code(&event_codes(codes))).collect();
        table.row([codes.join(", "), event.severity.word().to_owned(), meaning.clone()]);
    }
    table.render(out);
    if !others.is_empty() {
        let _ = writeln!(out, "Known by their severity alone: {}.\n", counts(&others.into_iter()));
    }
}

/// `3 errors, 1 warning and 2 of information`.
fn counts<'e>(events: &(impl Iterator<Item = &'e Event> + Clone)) -> String {
    let names = [
        (Severity::Error, "error", "errors"),
        (Severity::Warning, "warning", "warnings"),
        (Severity::Information, "of information", "of information"),
    ];
    let counts = names.into_iter().filter_map(|(severity, one, many)| {
        let of_it = events.clone().filter(|event| event.severity == severity);
        match of_it.map(|event| event.codes().count()).sum() {
            0 => None,
            1 => Some(format!("1 {one}")),
            count => Some(format!("{count} {many}")),
        }
    });
    list(&counts.collect::<Vec<_>>(), "and")
}
