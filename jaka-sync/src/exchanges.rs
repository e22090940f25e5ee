//! The last messages of a connection, for errors to show.

use std::fmt;

use jaka_proto::recording::{Entry, Event, Message};
use jaka_proto::text::visible;

/// How many characters of a message are shown.
const SHOWN: usize = 300;

/// Writes messages, a line each; nothing if there are none.
pub fn show(entries: &[Entry], f: &mut fmt::Formatter<'_>) -> fmt::Result {
    if !entries.is_empty() {
        f.write_str("\nthe last messages of the connection, by seconds since the recording began:")?;
    }
    entries.iter().try_for_each(|entry| {
        let (arrow, message) = match &entry.event {
            Event::Sent(message) => ("->", message),
            Event::Received(message) => ("<-", message),
            _ => return Ok(()),
        };
        write!(f, "\n{:12.6} {arrow} ", entry.time.as_secs_f64())?;
        show_message(message, f)
    })
}

fn show_message(message: &Message, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let text = message.to_string();
    let text = visible(&text);
    match text.char_indices().nth(SHOWN) {
        Some((end, _)) => write!(f, "{}… ({} bytes)", &text[..end], message.bytes().len()),
        None => f.write_str(&text),
    }
}
