//! A recording as text.

use jaka_sync::proto::text::visible_json_line;
use jaka_sync::recording::{Entry, Event, Message, Recording};

use super::filter::Filter;
use super::summary::Summary;
use crate::failure::Failure;
use crate::output;
use crate::utc;

/// How many characters of a message are shown.
const SHOWN: usize = 160;

/// Prints the entries, a line each, and a summary.
pub(super) fn print(recording: &Recording, filter: &Filter) -> Result<(), Failure> {
    let header = &recording.header;
    output::line(&format!("recorded by {}, from {}", header.software, utc::date_and_time(header.started)))?;
    for entry in recording.entries.iter().filter(|entry| filter.shows(entry)) {
        output::line(&line(entry))?;
    }
    output::lines(&format!("\n{}", Summary::new(recording, filter)))
}

fn line(entry: &Entry) -> String {
    let Entry { time, port, connection, event, .. } = entry;
    format!("{:12.6}  {:<7} {connection:>2}  {}", time.as_secs_f64(), port.word(), describe(event))
}

fn describe(event: &Event) -> String {
    match event {
        Event::Connected { address } => format!("connected to {address}"),
        Event::Sent(message) => format!("-> {}", shortened(message)),
        Event::Received(message) => format!("<- {}", shortened(message)),
        Event::Closed { by, why } => format!("closed by {}: {why}", by.word()),
        Event::Error { text } => format!("error: {text}"),
        Event::Dropped { count } => format!("{count} entries are missing here"),
        _ => event.word().to_owned(),
    }
}

/// A message in one line.
fn shortened(message: &Message) -> String {
    let text = message.to_string();
    let text = visible_json_line(&text);
    match text.char_indices().nth(SHOWN) {
        Some((end, _)) => format!("{}… ({} bytes)", &text[..end], message.bytes().len()),
        None => text.into_owned(),
    }
}
