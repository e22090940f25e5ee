//! Faults of a link between a port and its clients.

use std::time::Duration;

use super::kinds::kinds;

/// Passage of bytes on a link.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Passage {
    /// All waiting bytes pass now.
    Now,
    /// The first waiting bytes pass after this time.
    After(Duration),
    /// This many bytes pass in a second.
    Paced(u64),
    /// Nothing passes until the fault changes.
    Held,
    /// Nothing passes ever again.
    Lost,
}

kinds! {
    /// Fault of a link between a port and its clients: the bytes that pass in one direction, and their times.
    ///
    /// [`Controller::link`](crate::Controller::link) sets it at once, and [`Happening::Link`](crate::Happening::Link)
    /// at a time. It applies to open and later connections, until another fault is set. Its own times are real times,
    /// also with a stepped clock. A link has no message boundaries: it passes bytes, and after them the end of the
    /// connection.
    ///
    /// The operating system opens the connection itself, also on a link on which nothing passes.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    #[non_exhaustive]
    pub enum LinkFault("a fault of a link", |_| "unknown fault of a link");

    /// Returns the passage of the waiting bytes, with `age` as the waiting time of the first.
    pub(crate) fn passage(&self, age: Duration) -> Passage;

    /// No fault: bytes pass at once, and so do all held bytes. `none` in a script.
    #[default]
    None: "none" => Passage::Now;

    /// Blocks all bytes until another fault is set. `hold` in a script.
    ///
    /// To the client: all bytes of the controller wait, and then arrive as sent, with old status packets and old
    /// replies. When 16 MiB wait, the controller ends the connection; the client gets the 16 MiB, and then the end.
    ///
    /// To the controller: the controller neither reads nor carries out requests, nor notices the end of the connection.
    /// The operating systems' buffers still take some hundred kilobytes from the client, and acknowledge them.
    Hold: "hold" => Passage::Held;

    /// Delays each byte by this time, in order, in the same portions as without. `delay 800ms` in a script.
    ///
    /// The controller carries out and answers requests this much later.
    Delay(time: Duration as time = Duration::from_millis(80)): "delay" => match time.saturating_sub(age) {
        Duration::ZERO => Passage::Now,
        left => Passage::After(left),
    };

    /// Limits the rate to this many bytes a second, and at least one. `slow 9600` in a script.
    ///
    /// Held and later bytes pass at this rate, until another fault is set.
    Slow(per_second: u64 as rate = 20_000): "slow" => Passage::Paced(*per_second);

    /// Blocks all bytes for good, as a pulled cable does: no byte, no end of the connection, no reset. `cut` in a
    /// script.
    ///
    /// A cut connection stays cut, and so does one opened meanwhile. A later fault applies to later connections.
    Cut: "cut" => Passage::Lost;
}
