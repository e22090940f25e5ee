//! The packets of a connection to the status port.

use std::sync::Arc;
use std::time::{Duration, Instant};

use jaka_clock::Socket;
use jaka_proto::framing::{self, Framer};
use jaka_proto::recording::Port;

use crate::disconnect::is_text_line;
use crate::receive::{self, Chunk};
use crate::recorder::Tap;
use crate::{Config, Disconnect, Error, connection};

/// Packets of a connection to the status port. Skips bytes that belong to no packet.
#[derive(Debug)]
pub(crate) struct Packets {
    pub(crate) stream: Arc<Socket>,
    pub(crate) tap: Tap,
    framer: Framer,
    timeout: receive::ReadTimeout,
    /// Text of the newest packet.
    pub(crate) text: String,
    /// Whether a packet has come. The first message shows whether this is the status port.
    has_come: bool,
    pub(crate) between: Between,
}

/// Counts of the bytes and searches between packets, since they were last taken.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Between {
    /// Bytes that did not belong to a packet, or belonged to an incomplete one.
    pub(crate) bytes: usize,
    /// Number of searches for the beginning of a packet.
    pub(crate) resyncs: u64,
}

/// Time after a silence in which packets may be old ones that the network had held back.
const SETTLING: Duration = Duration::from_millis(100);

/// Recognises the packets that follow a silence.
#[derive(Debug, Default)]
pub(crate) struct Silence {
    /// Arrival of the last packet that could be read.
    last: Option<Instant>,
    /// Arrival of the first packet after the last silence.
    over: Option<Instant>,
}

impl Silence {
    /// Takes the next packet. Returns true if the packet may have been held back in a silence longer than this.
    pub(crate) fn is_followed_by(&mut self, received: Instant, silence: Duration) -> bool {
        let gap = self.last.replace(received).map(|last| received.saturating_duration_since(last));
        if gap.is_some_and(|gap| gap > silence) {
            self.over = Some(received);
        }
        self.over.is_some_and(|over| received.saturating_duration_since(over) < SETTLING)
    }
}

impl Packets {
    pub(crate) fn connect(address: &str, config: &Config) -> Result<Self, Error> {
        let (stream, tap) = connection::connect(address, Port::Status, config)?;
        Ok(Self {
            stream: Arc::new(stream),
            tap,
            framer: Framer::for_status(config.max_frame),
            timeout: receive::ReadTimeout::default(),
            text: String::new(),
            has_come: false,
            between: Between::default(),
        })
    }

    /// Reads once, for at most the time that is left.
    pub(crate) fn read(&mut self, left: Duration) -> Result<Chunk, Disconnect> {
        receive::chunk(&self.stream, &self.tap, &mut self.framer, &mut self.timeout, left)
    }

    /// Keeps the text of the next packet that has arrived in full; false if there is none. A text line of firmware
    /// without JSON packets is an error.
    pub(crate) fn next(&mut self) -> Result<bool, Disconnect> {
        self.tap.stray(self.framer.lost());
        self.between.bytes += self.framer.lost().len();
        loop {
            match self.framer.next_frame() {
                Ok(None) => return Ok(false),
                Ok(Some(frame)) => {
                    self.tap.packet(frame);
                    let text = framing::text(frame);
                    if !self.has_come && receive::is_reply(&text) {
                        return Err(Disconnect::CommandPort);
                    }
                    self.has_come = true;
                    self.text.clear();
                    self.text.push_str(&text);
                    return Ok(true);
                }
                Err(error) if is_text_line(&error) => return Err(Disconnect::Frame(error)),
                Err(error) => {
                    let before = self.tap.copy(self.framer.partial());
                    let dropped = self.framer.resync();
                    self.tap.stray(before.get(..dropped).unwrap_or_default());
                    log::debug!(target: "jaka_sync::wire", "status: {dropped} bytes dropped, {error}");
                    self.between.bytes += dropped;
                    self.between.resyncs += 1;
                }
            }
        }
    }

    /// Records the bytes of an incomplete packet, when no more is read.
    pub(crate) fn record_rest(&self) {
        self.tap.stray(self.framer.partial());
    }
}
