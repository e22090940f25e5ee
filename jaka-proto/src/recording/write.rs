//! How a recording is written, line by line.

use std::fmt;
use std::time::Duration;

use super::{Ending, Entry, Event, FORMAT, Header, Message, MotionStep, Port, Recording};
use crate::wire::Writer;

impl Recording {
    /// Writes all lines.
    pub fn write(&self, out: &mut Writer) {
        self.header.write(out);
        self.entries.iter().for_each(|entry| entry.write(out));
    }
}

impl Header {
    /// Writes the line, with its line feed.
    pub fn write(&self, out: &mut Writer) {
        out.raw("{\"jaka_recording\":");
        out.int(FORMAT.into());
        out.raw(",\"started\":");
        seconds(self.started, out);
        out.raw(",\"software\":");
        out.text(&self.software);
        out.raw("}\n");
    }
}

impl Entry {
    /// Writes the line, with its line feed.
    pub fn write(&self, out: &mut Writer) {
        out.raw("{\"time\":");
        seconds(self.time, out);
        out.raw(",\"port\":");
        out.text(self.port.word());
        out.raw(",\"connection\":");
        out.int(self.connection.into());
        out.raw(",\"event\":");
        out.text(self.event.word());
        self.event.write_fields(out);
        out.raw("}\n");
    }
}

impl Port {
    /// Both ports.
    pub const ALL: [Self; 2] = [Self::Command, Self::Status];

    /// Its name in a recording: `command` or `status`.
    pub fn word(self) -> &'static str {
        match self {
            Self::Command => "command",
            Self::Status => "status",
        }
    }
}

/// Its [`word`](Port::word).
impl fmt::Display for Port {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())
    }
}

impl Ending {
    pub(super) const ALL: [Self; 3] = [Self::Client, Self::Controller, Self::Failure];

    /// Its name in a recording: `client`, `controller` or `failure`.
    pub fn word(self) -> &'static str {
        match self {
            Self::Client => "client",
            Self::Controller => "controller",
            Self::Failure => "failure",
        }
    }
}

impl MotionStep {
    pub(super) const ALL: [Self; 4] = [Self::Late, Self::Gap, Self::Done, Self::Failed];

    /// Its name in a recording, such as `late`.
    pub fn word(self) -> &'static str {
        match self {
            Self::Late => "late",
            Self::Gap => "gap",
            Self::Done => "done",
            Self::Failed => "failed",
        }
    }
}

impl Event {
    /// Its name in a recording, such as `sent`.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Connected { .. } => "connected",
            Self::Sent(_) => "sent",
            Self::Received(_) => "received",
            Self::Closed { .. } => "closed",
            Self::Error { .. } => "error",
            Self::Motion { .. } => "motion",
            Self::Dropped { .. } => "dropped",
        }
    }

    fn write_fields(&self, out: &mut Writer) {
        match self {
            Self::Connected { address } => field("address", address, out),
            Self::Sent(message) | Self::Received(message) => write_message(message, out),
            Self::Closed { by, why } => {
                field("by", by.word(), out);
                field("why", why, out);
            }
            Self::Error { text } => field("text", text, out),
            Self::Motion { step, text } => {
                field("step", step.word(), out);
                field("text", text, out);
            }
            Self::Dropped { count } => {
                out.raw(",\"count\":");
                out.raw(&count.to_string());
            }
        }
    }
}

fn write_message(message: &Message, out: &mut Writer) {
    if let Some(text) = message.text() {
        return field("text", text, out);
    }
    out.raw(",\"hex\":\"");
    message.bytes().iter().for_each(|byte| out.raw(&format!("{byte:02x}")));
    out.raw("\"");
}

fn field(key: &str, value: &str, out: &mut Writer) {
    out.comma();
    out.text(key);
    out.raw(":");
    out.text(value);
}

fn seconds(time: Duration, out: &mut Writer) {
    out.raw(&format!("{}.{:06}", time.as_secs(), time.subsec_micros()));
}
