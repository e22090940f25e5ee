//! HTML of a page, with escaped texts of a recording.

use std::fmt::Write as _;
use std::time::Duration;

use itertools::Itertools as _;
use jaka_sync::proto::text::visible;
use jaka_sync::recording::{Entry, Event};

use super::more;
use super::session::{CommandCount, Session};
use crate::recordings::recorded::{excerpt, missing};
use crate::text::utc;

const STYLE: &str = include_str!("page/style.css");

/// Greatest number of rows of a table.
const MOST: usize = 100;
/// Greatest number of shown messages before a problem, and of characters of each.
const BEFORE: usize = 4;
const CHARACTERS: usize = 240;

/// Page under construction.
#[derive(Debug)]
pub(super) struct HtmlPage(String);

impl HtmlPage {
    /// Starts the page of a recording of this name.
    pub(super) fn new(name: &str) -> Self {
        let title = format!("Report of {}", text(name));
        Self(format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width\">\n<title>{title}</title>\n<style>\n{STYLE}</style>\n\
             </head>\n<body>\n<h1>{title}</h1>\n"
        ))
    }

    /// Adds a section with this HTML.
    pub(super) fn section(&mut self, id: &str, title: &str, html: &str) {
        // Writing to a string cannot fail.
        let _ = writeln!(self.0, "<section id=\"{id}\">\n<h2>{title}</h2>\n{html}</section>");
    }

    /// Returns the whole page.
    pub(super) fn end(self) -> String {
        self.0 + "</body>\n</html>\n"
    }
}

/// Returns foreign text in visible characters, with HTML escaped.
fn text(text: &str) -> String {
    escaped(&visible(text))
}

/// Escapes HTML in a text.
pub(super) fn escaped(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    text.replace('"', "&quot;").replace('\'', "&#39;")
}

/// Returns a paragraph of the program's own HTML.
pub(super) fn paragraph(html: &str) -> String {
    format!("<p>{html}</p>\n")
}

/// Returns pictures, side by side if there is space.
pub(super) fn figure(pictures: &[String]) -> String {
    if pictures.is_empty() { String::new() } else { format!("<figure>\n{}</figure>\n", pictures.concat()) }
}

/// Returns facts of the recording, in numbers.
pub(super) fn facts(session: &Session<'_>) -> String {
    let (packets, header) = (&session.packets, &session.recording.header);
    let entries = || session.recording.entries.iter();
    let commands = || session.calls.commands.values();
    let of = |count: fn(&CommandCount) -> usize| commands().map(count).sum::<usize>();
    let mut facts = vec![
        ("recorded by", header.software.clone()),
        ("began", utc::date_and_time(header.started)),
        ("length", format!("{:.3} s", session.end)),
        ("connections", connections(entries())),
        ("requests", of(CommandCount::requests).to_string()),
        ("refused", of(|command| command.refused).to_string()),
        ("without reply", of(|command| command.unanswered).to_string()),
        ("status packets", packets.count.to_string()),
        ("longest time between two", format!("{:.3} s", packets.longest_gap)),
    ];
    let counts = [
        ("not a packet", packets.unreadable as u64),
        ("numbers out of the range of any arm, not drawn", packets.undrawn as u64),
        ("entries missing", entries().map(missing).fold(0, u64::saturating_add)),
    ];
    facts.extend(counts.into_iter().filter(|(_, count)| *count > 0).map(|(name, count)| (name, count.to_string())));
    facts.extend(
        session
            .recording
            .truncated
            .iter()
            .map(|error| ("cut off", format!("the file ends in the middle of a line: {error}"))),
    );
    let rows = facts.into_iter().map(|(name, value)| vec![name.to_owned(), text(&value)]);
    table(&[], rows) + &paragraph("Status packets have no time stamp: times are times of arrival.")
}

fn connections<'r>(entries: impl Iterator<Item = &'r Entry>) -> String {
    let addresses = entries.filter_map(|entry| match &entry.event {
        Event::Connected { address } => Some(address),
        _ => None,
    });
    let addresses: Vec<_> = addresses.sorted().collect();
    let mut different = addresses.iter().dedup();
    let shown = different.by_ref().take(4).join(", ");
    let more = if different.next().is_some() { ", …" } else { "" };
    match addresses.len() {
        0 => "none recorded".to_owned(),
        count => format!("{count}: {shown}{more}"),
    }
}

/// Returns the problems, with the messages before them. Immediate repetitions of a problem share a row.
pub(super) fn problems(session: &Session<'_>) -> String {
    let problems = session.happenings.iter().filter(|happening| happening.is_wrong);
    let counted: Vec<_> = problems.dedup_by_with_count(|one, other| one.what == other.what).collect();
    let rows = counted.into_iter().map(|(times, problem)| {
        let again = if times > 1 { format!(" ({times} times in a row)") } else { String::new() };
        let messages = messages(session.messages_before(problem.time, BEFORE));
        vec![seconds(problem.time), text(&problem.what) + &again, messages]
    });
    let titles = ["time (s)", "what", "last messages of the command port until then"];
    list(&titles, rows, "row").unwrap_or_else(|| paragraph("The recording shows none."))
}

fn messages(entries: &[&Entry]) -> String {
    let mut lines = entries.iter().filter_map(|entry| {
        let arrow = if let Event::Sent(_) = entry.event { "->" } else { "<-" };
        let message = excerpt(entry.event.message()?, CHARACTERS);
        Some(text(&format!("{} {arrow} {message}", seconds(entry.time))))
    });
    let lines = lines.join("\n");
    if lines.is_empty() { "none".to_owned() } else { format!("<pre>{lines}</pre>") }
}

/// Returns all events, in the order of their times.
pub(super) fn events(session: &Session<'_>) -> String {
    let rows = session.happenings.iter().map(|event| vec![seconds(event.time), text(&event.what)]);
    list(&["time (s)", "what"], rows, "row").unwrap_or_else(|| paragraph("None."))
}

/// Returns each command with its reply times.
pub(super) fn commands(session: &Session<'_>) -> String {
    let rows = session.calls.commands.iter().map(|(name, command)| {
        let at = |share: usize| {
            let last = command.replies.len().checked_sub(1)?;
            command.replies.get(last - last * (100 - share) / 100)
        };
        let time = |ms: Option<&f64>| ms.map_or_else(|| "–".to_owned(), |ms| format!("{ms:.3}"));
        let counts = [command.requests(), command.refused, command.unanswered].map(|count| count.to_string());
        let mut row = vec![text(name)];
        row.extend(counts.into_iter().chain([time(at(50)), time(at(99)), time(at(100))]));
        row
    });
    let titles =
        ["command", "requests", "refused", "without reply", "median (ms)", "99th percentile (ms)", "slowest (ms)"];
    list(&titles, rows, "command").unwrap_or_else(|| paragraph("None."))
}

fn seconds(time: Duration) -> String {
    format!("{:.6}", time.as_secs_f64())
}

/// Returns a table of the first of these rows, and the number of the others; `None` without rows.
fn list(titles: &[&str], rows: impl ExactSizeIterator<Item = Vec<String>>, noun: &str) -> Option<String> {
    let all = rows.len();
    let more = more(all, MOST, noun).map(|more| paragraph(&more)).unwrap_or_default();
    (all > 0).then(|| table(titles, rows.take(MOST)) + &more)
}

/// Returns a table of HTML cells.
fn table(titles: &[&str], rows: impl Iterator<Item = Vec<String>>) -> String {
    let is_number = |cell: &str| !titles.is_empty() && (cell.parse::<f64>().is_ok() || cell == "–");
    let class = |cell: &str| if is_number(cell) { " class=\"number\"" } else { "" };
    let cells: Vec<_> = titles.iter().map(|title| format!("<th>{}</th>", escaped(title))).collect();
    let header = if cells.is_empty() { String::new() } else { format!("<tr>{}</tr>\n", cells.concat()) };
    let rows = rows.map(|row| {
        let cells: Vec<_> = row.iter().map(|cell| format!("<td{}>{cell}</td>", class(cell))).collect();
        format!("<tr>{}</tr>\n", cells.concat())
    });
    format!("<table>\n{header}{}</table>\n", rows.collect::<String>())
}
