//! Tables of a page.

use std::time::Duration;

use jaka_sync::proto::text::visible_json_line;

use super::super::more;
use super::super::session::{CommandCount, Happening, Messages, Session};
use super::{escaped, paragraph, text};

/// How many rows a table has at most.
const MOST: usize = 100;
/// How many messages are shown before what went wrong, and how many characters of each.
const BEFORE: usize = 4;
const CHARACTERS: usize = 240;

/// What was recorded, in numbers.
pub(in crate::report) fn facts(session: &Session<'_>) -> String {
    let packets = &session.packets;
    let commands = || session.calls.commands.values();
    let of = |count: fn(&CommandCount) -> usize| commands().map(count).sum::<usize>();
    let mut facts = vec![
        ("recorded by", session.software.to_owned()),
        ("began", session.started.clone()),
        ("length", format!("{:.3} s", session.end)),
        ("connections", connections(&session.connections)),
        ("requests", of(CommandCount::requests).to_string()),
        ("refused", of(|command| command.refused).to_string()),
        ("without reply", of(|command| command.unanswered).to_string()),
        ("status packets", packets.count.to_string()),
        ("longest time between two", format!("{:.3} s", packets.longest_gap)),
    ];
    let counts = [
        ("not a packet", packets.unreadable as u64),
        ("numbers beyond any arm's, not drawn", packets.undrawn as u64),
        ("entries missing", session.dropped),
    ];
    facts.extend(counts.into_iter().filter(|(_, count)| *count > 0).map(|(name, count)| (name, count.to_string())));
    facts.extend(
        session.truncated.iter().map(|error| ("cut off", format!("the file ends in the middle of a line: {error}"))),
    );
    let rows = facts.into_iter().map(|(name, value)| vec![name.to_owned(), text(&value)]);
    table(&[], rows) + &paragraph("Status packets have no time stamp: times are those at which they arrived.")
}

fn connections(addresses: &[&str]) -> String {
    let mut different: Vec<_> = addresses.to_vec();
    different.sort_unstable();
    different.dedup();
    let more = if different.len() > 4 { ", …" } else { "" };
    different.truncate(4);
    match addresses.len() {
        0 => "none recorded".to_owned(),
        count => format!("{count}: {}{more}", different.join(", ")),
    }
}

/// What went wrong, with the messages before it. What happened again immediately is one row.
pub(in crate::report) fn problems(session: &Session<'_>) -> String {
    let mut rows: Vec<(&Happening, usize)> = Vec::new();
    for problem in session.problems() {
        match rows.last_mut() {
            Some((before, times)) if before.what == problem.what => *times += 1,
            _ => rows.push((problem, 1)),
        }
    }
    if rows.is_empty() {
        return paragraph("Nothing that the recording shows.");
    }
    let all = rows.len();
    let rows = rows.into_iter().take(MOST).map(|(problem, times)| {
        let again = if times > 1 { format!(" ({times} times in a row)") } else { String::new() };
        vec![seconds(problem.time), text(&problem.what) + &again, messages(&session.messages, problem.time)]
    });
    let table = table(&["time (s)", "what", "the last messages of the command port up to then"], rows);
    table + &more(all, MOST, "row").map(|more| paragraph(&more)).unwrap_or_default()
}

fn messages(messages: &Messages<'_>, time: Duration) -> String {
    let before = messages.before(time, BEFORE).iter().map(|message| {
        let shown = message.message.to_string();
        let shown = visible_json_line(&shown);
        let shown = match shown.char_indices().nth(CHARACTERS) {
            Some((end, _)) => format!("{}… ({} bytes)", &shown[..end], message.message.bytes().len()),
            None => shown.into_owned(),
        };
        text(&format!("{:.6} {} {shown}", message.time.as_secs_f64(), message.arrow))
    });
    let lines: Vec<_> = before.collect();
    if lines.is_empty() { "none".to_owned() } else { format!("<pre>{}</pre>", lines.join("\n")) }
}

/// What happened, in the order of the times.
pub(in crate::report) fn events(session: &Session<'_>) -> String {
    let all = session.happenings.len();
    if all == 0 {
        return paragraph("None.");
    }
    let rows = session.happenings.iter().take(MOST);
    let table = table(&["time (s)", "what"], rows.map(|event| vec![seconds(event.time), text(&event.what)]));
    table + &more(all, MOST, "row").map(|more| paragraph(&more)).unwrap_or_default()
}

/// Each command with the times of its replies.
pub(in crate::report) fn commands(session: &Session<'_>) -> String {
    let commands = &session.calls.commands;
    if commands.is_empty() {
        return paragraph("None.");
    }
    let rows = commands.iter().take(MOST).map(|(name, command)| {
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
    table(&titles, rows) + &more(commands.len(), MOST, "command").map(|more| paragraph(&more)).unwrap_or_default()
}

fn seconds(time: Duration) -> String {
    format!("{:.6}", time.as_secs_f64())
}

/// A table of HTML cells.
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
