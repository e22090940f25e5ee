//! Script of one connection of a recording.

use std::sync::Arc;
use std::time::Duration;

use jaka_proto::Envelope;
use jaka_proto::recording::{Ending, Entry, Event, Message, Port, Recording};

/// Events on one connection of a recording, in order.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(crate) struct Script {
    /// Start of the connection in the recording.
    pub(crate) start: Duration,
    pub(crate) steps: Vec<ScriptStep>,
    /// Last message that is a JSON object, which is the final status.
    pub(crate) last: Option<Message>,
}

/// Step of a script; times count from the start of the connection.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum ScriptStep {
    /// The client sends a request.
    Expect { request: String, at: Duration },
    /// The controller sends bytes.
    Send { bytes: Vec<u8>, at: Duration },
    /// The controller ends the connection.
    End { by: Ending, at: Duration },
    /// This many entries are missing.
    Gap { count: u64 },
}

/// Returns the scripts of the connections to a port.
pub(super) fn scripts(recording: &Recording, port: Port) -> Vec<Arc<Script>> {
    let mut numbers = Vec::new();
    for entry in recording.entries.iter().filter(|entry| entry.port == port) {
        // A connection with only an error was never opened; events of motions belong to the program.
        if !matches!(entry.event, Event::Error { .. } | Event::Motion { .. }) && !numbers.contains(&entry.connection) {
            numbers.push(entry.connection);
        }
    }
    let entries =
        |number| recording.entries.iter().filter(move |entry| (entry.port, entry.connection) == (port, number));
    numbers.into_iter().map(|number| Arc::new(script(entries(number)))).collect()
}

fn script<'e>(entries: impl Iterator<Item = &'e Entry>) -> Script {
    let mut entries = entries.peekable();
    let start = entries.peek().map_or(Duration::ZERO, |entry| entry.time);
    let mut script = Script { start, ..Script::default() };
    entries.for_each(|entry| script.add(&entry.event, entry.time.saturating_sub(start)));
    script
}

impl Script {
    /// Returns an iterator over the times of the requests.
    pub(crate) fn requests(&self) -> impl Iterator<Item = Duration> {
        self.steps.iter().filter_map(|step| match step {
            ScriptStep::Expect { at, .. } => Some(*at),
            _ => None,
        })
    }

    fn add(&mut self, event: &Event, at: Duration) {
        match event {
            Event::Sent(request) => self.steps.push(ScriptStep::Expect { request: request.to_string(), at }),
            Event::Received(message) => {
                self.send(message.bytes(), at);
                if message.text().is_some_and(|text| Envelope::read(text).is_ok()) {
                    self.last = Some(message.clone());
                }
            }
            Event::Closed { by: by @ (Ending::Controller | Ending::Failure), .. } => {
                self.steps.push(ScriptStep::End { by: *by, at });
            }
            Event::Dropped { count } => self.steps.push(ScriptStep::Gap { count: *count }),
            _ => {}
        }
    }

    /// Adds bytes to send. Merges bytes with the same recorded time into one piece.
    fn send(&mut self, more: &[u8], time: Duration) {
        match self.steps.last_mut() {
            Some(ScriptStep::Send { bytes, at }) if *at == time => bytes.extend_from_slice(more),
            _ => self.steps.push(ScriptStep::Send { bytes: more.to_vec(), at: time }),
        }
    }
}

#[cfg(test)]
mod tests {
    use jaka_proto::recording::Header;

    use super::*;

    #[test]
    fn each_connection_has_its_steps() {
        let at = |millis, port, connection, event| Entry::new(Duration::from_millis(millis), port, connection, event);
        let message = |text: &str| Message::new(text);
        let connected = || Event::Connected { address: String::new() };
        let entries = vec![
            at(5, Port::Command, 1, Event::Error { text: "no connection could be made".to_owned() }),
            at(10, Port::Command, 2, connected()),
            at(11, Port::Status, 3, connected()),
            at(12, Port::Status, 3, Event::Received(message("{}"))),
            at(13, Port::Command, 2, Event::Sent(message("a"))),
            at(15, Port::Command, 2, Event::Received(message("b"))),
            at(15, Port::Command, 2, Event::Received(message("c"))),
            at(16, Port::Command, 2, Event::Received(message("d"))),
            at(17, Port::Command, 2, Event::Closed { by: Ending::Client, why: String::new() }),
            at(20, Port::Status, 3, Event::Received(message("garbage"))),
            at(21, Port::Status, 3, Event::Closed { by: Ending::Controller, why: String::new() }),
        ];
        let recording = Recording::new(Header::new(Duration::ZERO, ""), entries);
        let millis = Duration::from_millis;
        let send = |text: &str, at| ScriptStep::Send { bytes: text.into(), at: millis(at) };
        let commands = scripts(&recording, Port::Command);
        assert_eq!(commands.len(), 1);
        let expect = ScriptStep::Expect { request: "a".to_owned(), at: millis(3) };
        assert_eq!(commands[0].steps, [expect, send("bc", 5), send("d", 6)]);
        let readers = scripts(&recording, Port::Status);
        assert_eq!(readers.len(), 1);
        let end = ScriptStep::End { by: Ending::Controller, at: millis(10) };
        assert_eq!(readers[0].steps, [send("{}", 1), send("garbage", 9), end]);
        assert_eq!(readers[0].last, Some(message("{}")));
    }
}
