//! Halves of a connection. One thread at a time takes a half out of the state.

use std::any::Any;
use std::io;
use std::panic::{self, AssertUnwindSafe};
use std::time::Duration;

use jaka_clock::Socket;
use jaka_proto::exchange::{Delivery, Exchange, OutOfSync, Received, RequestId, Waiter};
use jaka_proto::framing::{self, Framer};
use jaka_proto::wire::{DecodeError, Writer};
use jaka_proto::{Envelope, read_envelope};

use super::WIRE;
use super::stops::Stops;
use crate::Disconnect;
use crate::receive::{self, Chunk};
use crate::recorder::Tap;

/// Approximate number of bytes in one write, after which a stop can be sent.
const PIECE: usize = 4096;

/// Longest time for which a write blocks. Afterwards the thread checks its deadline and the connection.
const SLICE: Duration = Duration::from_millis(50);

/// The shortest timeout of a write.
const SHORTEST: Duration = Duration::from_millis(1);

/// The sending half: the thread whose turn it is takes it out of the state.
#[derive(Debug, Default)]
pub(super) struct Outbound {
    pub(super) out: Writer,
    /// End of each request in `out`, and its id in the exchange.
    pub(super) requests: Vec<(usize, RequestId)>,
    pub(super) timeout: WriteTimeout,
}

impl Outbound {
    /// Writes requests, up to a piece of them.
    pub(super) fn compose(&mut self, count: usize, write: &mut dyn FnMut(usize, &mut Writer)) {
        self.out.clear();
        self.requests.clear();
        for index in 0..count {
            write(index, &mut self.out);
            let end = self.out.as_str().len();
            self.requests.push((end, RequestId::default()));
            if end >= PIECE {
                break;
            }
        }
    }

    /// Text of each request.
    pub(super) fn texts(&self) -> impl Iterator<Item = &str> {
        let starts = std::iter::once(0).chain(self.requests.iter().map(|(end, _)| *end));
        starts.zip(&self.requests).map(|(start, (end, _))| &self.out.as_str()[start..*end])
    }
}

/// Current write timeout of the socket, so that it is set only if it must change.
#[derive(Debug, Default)]
pub(super) struct WriteTimeout(Duration);

impl WriteTimeout {
    /// Sets a timeout that is no longer than the time left. A shorter one is kept: a thread that waits to the end
    /// writes a few times more.
    pub(super) fn set(&mut self, stream: &Socket, left: Duration) -> io::Result<()> {
        if !self.0.is_zero() && self.0 <= left.max(SHORTEST) {
            return Ok(());
        }
        self.change(stream, (left / 8 * 7).clamp(SHORTEST, SLICE))
    }

    /// Sets a longer timeout after a write that had to wait, if there is time for it.
    pub(super) fn lengthen(&mut self, stream: &Socket, left: Duration) -> io::Result<()> {
        if self.0 < SLICE && left >= SLICE { self.change(stream, SLICE) } else { Ok(()) }
    }

    fn change(&mut self, stream: &Socket, timeout: Duration) -> io::Result<()> {
        stream.set_write_timeout(Some(timeout))?;
        self.0 = timeout;
        Ok(())
    }
}

/// Payload of a panic.
type Panic = Box<dyn Any + Send>;

/// The receiving half: the reading thread takes it out of the state.
#[derive(Debug)]
pub(super) struct Inbound {
    pub(super) framer: Framer,
    timeout: receive::ReadTimeout,
    /// Panic of a logger, or of the code that reads a reply for its caller. It resumes once the receiving half is back
    /// in the state.
    pub(super) panic: Option<Panic>,
}

impl Inbound {
    pub(super) fn new(max_frame: usize) -> Self {
        Self { framer: Framer::new(max_frame), timeout: receive::ReadTimeout::default(), panic: None }
    }

    pub(super) fn read(&mut self, stream: &Socket, tap: &Tap, left: Duration) -> Result<Chunk, Disconnect> {
        receive::chunk(stream, tap, &mut self.framer, &mut self.timeout, left)
    }

    /// Attributes all messages that have been read, up to the waiter's own reply, and returns their number.
    pub(super) fn attribute(
        &mut self,
        (tap, stops): (&Tap, &Stops),
        exchange: &mut Exchange,
        waiter: &mut Waiter<'_>,
    ) -> Result<usize, Disconnect> {
        let mut count = 0;
        while !waiter.is_done() && self.panic.is_none() {
            let Some(frame) = self.framer.next_frame().map_err(Disconnect::Frame)? else { break };
            tap.received(frame);
            let text = framing::text(frame);
            self.panic = receive_one((exchange, stops), &text, waiter).map_err(|cause| explained(cause, &text))?;
            count += 1;
        }
        Ok(count)
    }

    /// Bytes that belong to no message yet.
    pub(super) fn partial(&self) -> &[u8] {
        self.framer.partial()
    }
}

/// Attributes a reply, even if a logger, or the code that reads the reply for its waiter, panics: the attribution does
/// not depend on them.
fn receive_one(
    (exchange, stops): (&mut Exchange, &Stops),
    text: &str,
    waiter: &mut Waiter<'_>,
) -> Result<Option<Panic>, Disconnect> {
    let read = panic::catch_unwind(AssertUnwindSafe(|| {
        log::trace!(target: WIRE, "<- {text}");
        waiter.read(text)
    }));
    match read {
        Ok(envelope) => deliver((exchange, stops), text, envelope, waiter),
        Err(payload) => {
            deliver((exchange, stops), text, read_envelope(text), &mut Waiter::nobody())?;
            // The waiter is gone.
            if let Some(request) = waiter.request() {
                exchange.discard_pending(request);
            }
            Ok(Some(payload))
        }
    }
}

/// Attributes a reply that was read, and logs one that came late or belongs to none yet.
fn deliver(
    (exchange, stops): (&mut Exchange, &Stops),
    text: &str,
    envelope: Result<Option<Envelope<'_>>, DecodeError>,
    waiter: &mut Waiter<'_>,
) -> Result<Option<Panic>, Disconnect> {
    let envelope = envelope.map_err(Disconnect::NotJson)?;
    let is_accepted = envelope.as_ref().is_none_or(Envelope::is_accepted);
    let received = exchange.receive(text, envelope, waiter).map_err(Disconnect::OutOfSync)?;
    if let Some(received) = &received {
        stops.answered(received.request, is_accepted);
    }
    let line = match received {
        Some(Received { delivery: Delivery::Waiter | Delivery::Pending | Delivery::Counted, .. }) => return Ok(None),
        Some(Received { command, delivery: Delivery::Discarded, .. }) => format!("late reply to `{command}` dropped"),
        None => "a refusal names no command, and may be that of one of several".to_owned(),
    };
    let log = || log::debug!(target: WIRE, "{line}");
    Ok(panic::catch_unwind(AssertUnwindSafe(log)).err())
}

/// Returns `cause`, or [`Disconnect::StatusPort`] if the message shows that this is the status port.
fn explained(cause: Disconnect, text: &str) -> Disconnect {
    if matches!(cause, Disconnect::OutOfSync(OutOfSync::Nameless)) && receive::is_status(text) {
        return Disconnect::StatusPort;
    }
    cause
}
