//! Reports of a connection to its recorder.

use std::collections::VecDeque;
use std::error::Error as StdError;
use std::sync::{Arc, Mutex};
use std::time::Duration;

use jaka_clock::{Clock, Socket, lock};
use jaka_proto::recording::{Ending, Entry, Event, Message, MotionStep, Port};

use super::{Recorder, Track};
use crate::{Disconnect, Error};

/// Number of messages that an error keeps.
const KEPT: usize = 8;

/// Address of a connection, for errors, and its reports to its recorder, if it has one.
#[derive(Debug, Clone, Default)]
pub(crate) struct Tap {
    address: Arc<str>,
    connection: Option<Arc<Connection>>,
}

/// A connection that is recorded.
#[derive(Debug)]
struct Connection {
    track: Track,
    state: Mutex<TapState>,
}

#[derive(Debug, Default)]
struct TapState {
    is_open: bool,
    /// Arrival of the bytes that were read last.
    arrived: Duration,
    last: VecDeque<Arc<Entry>>,
}

impl Tap {
    /// Reports of a connection to this address; none without a recorder.
    pub(crate) fn new(
        address: &str,
        port: Port,
        recorder: Option<&Recorder>,
        status_interval: Duration,
        clock: &Clock,
    ) -> Self {
        let connection = recorder.map(|recorder| {
            let track = recorder.track_by(clock, port, status_interval);
            Arc::new(Connection { track, state: Mutex::default() })
        });
        Self { address: address.into(), connection }
    }

    /// Address of the connection, with the port.
    pub(crate) fn address(&self) -> String {
        self.address.as_ref().to_owned()
    }

    /// Records that the connection is made.
    pub(crate) fn connected(&self, stream: &Socket) {
        let Some(connection) = &self.connection else { return };
        lock(&connection.state).is_open = true;
        let address = stream.system().peer_addr().map(|address| address.to_string()).unwrap_or_default();
        connection.track.record(Event::Connected { address });
    }

    /// Records a request that is sent.
    pub(crate) fn sent(&self, text: &str) {
        if let Some(connection) = &self.connection {
            connection.message(connection.track.now(), Event::Sent(Message::new(text)));
        }
    }

    /// Notes the arrival of bytes, which may contain messages.
    pub(crate) fn arrived(&self) {
        if let Some(connection) = &self.connection {
            lock(&connection.state).arrived = connection.track.now();
        }
    }

    /// Records a message from the bytes that came.
    pub(crate) fn received(&self, message: &[u8]) {
        if let Some(connection) = &self.connection {
            let time = lock(&connection.state).arrived;
            connection.message(time, Event::Received(Message::new(message)));
        }
    }

    /// Records a status packet from the bytes that came.
    pub(crate) fn packet(&self, packet: &[u8]) {
        let Some(connection) = &self.connection else { return };
        let time = lock(&connection.state).arrived;
        let entry = connection.track.entry(time, Event::Received(Message::new(packet)));
        connection.keep(&entry);
        connection.track.push_packet(&entry);
    }

    /// Records bytes that do not form a message, or come after the last message that will be read.
    pub(crate) fn stray(&self, bytes: &[u8]) {
        if !bytes.is_empty() {
            self.received(bytes);
        }
    }

    /// Copy of bytes that may have to be recorded later; empty if nothing is recorded.
    pub(crate) fn copy(&self, bytes: &[u8]) -> Vec<u8> {
        if self.connection.is_some() { bytes.to_vec() } else { Vec::new() }
    }

    /// Records that the connection is broken for good.
    pub(crate) fn broken(&self, cause: &Disconnect) {
        let by = match cause {
            Disconnect::Closed { .. } => Ending::Controller,
            Disconnect::Read(_) | Disconnect::Write(_) => Ending::Failure,
            _ => Ending::Client,
        };
        self.closed(by, || with_source(cause));
    }

    /// Records that this side ends the connection.
    pub(crate) fn left(&self) {
        self.closed(Ending::Client, || "the program has closed it".to_owned());
    }

    /// Records the end of the connection. Only the first end counts.
    fn closed(&self, by: Ending, why: impl FnOnce() -> String) {
        let Some(connection) = &self.connection else { return };
        if std::mem::take(&mut lock(&connection.state).is_open) {
            connection.track.record(Event::Closed { by, why: why() });
        }
    }

    /// Records an event of a motion.
    pub(crate) fn motion(&self, step: MotionStep, text: impl FnOnce() -> String) {
        if let Some(connection) = &self.connection {
            connection.track.record(Event::Motion { step, text: text() });
        }
    }

    /// Adds the last messages to an error, and records it if no other entry shows it.
    pub(crate) fn attach(&self, error: Error) -> Error {
        let exchanges = self.note(&error, error.is_refused() || error.is_disconnected());
        error.with_exchanges(exchanges)
    }

    /// Records an error that no other entry shows, and returns the last messages; none without a recorder.
    pub(crate) fn note(&self, error: &(dyn StdError + 'static), is_shown: bool) -> Box<[Entry]> {
        let Some(connection) = &self.connection else { return Box::default() };
        if !is_shown {
            connection.track.record(Event::Error { text: with_source(error) });
        }
        connection.exchanges()
    }
}

impl Connection {
    fn message(&self, time: Duration, event: Event) {
        let entry = self.track.entry(time, event);
        self.keep(&entry);
        self.track.push(&entry);
    }

    /// Keeps a message for errors.
    fn keep(&self, entry: &Arc<Entry>) {
        let mut state = lock(&self.state);
        if state.last.len() == KEPT {
            state.last.pop_front();
        }
        state.last.push_back(Arc::clone(entry));
    }

    fn exchanges(&self) -> Box<[Entry]> {
        lock(&self.state).last.iter().map(|entry| Entry::clone(entry)).collect()
    }
}

/// Text of an error and of its source.
fn with_source(error: &dyn StdError) -> String {
    error.source().map_or_else(|| error.to_string(), |source| format!("{error}: {source}"))
}
