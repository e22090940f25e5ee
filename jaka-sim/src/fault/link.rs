//! Faults of a link between a port and its clients.

use std::time::Duration;

use super::kinds::kinds;

/// Passage of bytes on a link.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Passage {
    /// All that waits passes now.
    Now,
    /// The first bytes that wait pass after this time.
    After(Duration),
    /// So many bytes pass in a second.
    Paced(u64),
    /// Nothing passes until the fault changes.
    Held,
    /// Nothing passes ever again.
    Lost,
}

kinds! {
    /// Something wrong with a link: what passes between a port and its clients in one direction, and when.
    ///
    /// [`Controller::link`](crate::Controller::link) sets it at once, and [`Happening::Link`](crate::Happening::Link)
    /// at a time. It applies to the connections that are open and to later ones, until another fault is set. Its own
    /// times are real times, also with a stepped clock. A link has no message boundaries: it passes bytes, and the end
    /// of a connection after them.
    ///
    /// The system makes the connection itself, which succeeds on a link on which nothing passes.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    #[non_exhaustive]
    pub enum LinkFault("a fault of a link", |_| "unknown fault of a link");

    /// Passage of the bytes that wait, the first of them for `age`.
    pub(crate) fn passage(&self, age: Duration) -> Passage;

    /// Nothing: what is sent passes at once, and so does all that is held. `none` in a script.
    #[default]
    None: "none" => Passage::Now;

    /// Nothing passes until another fault is set. `hold` in a script.
    ///
    /// To the client: what the controller sends waits, and then arrives as it was sent: old status packets, replies of
    /// long ago. When 16 MiB wait, the controller ends the connection; the client gets these, and then the end.
    ///
    /// To the controller: requests are neither read nor carried out, nor is the end of the connection noticed. The
    /// systems' buffers go on taking what the client sends, some hundred kilobytes, and acknowledge it.
    Hold: "hold" => Passage::Held;

    /// Each byte arrives this much later, in order, in the same portions as without. `delay 800ms` in a script.
    ///
    /// Requests are carried out, and answered, this much later.
    Delay(time: Duration as time = Duration::from_millis(80)): "delay" => match time.saturating_sub(age) {
        Duration::ZERO => Passage::Now,
        left => Passage::After(left),
    };

    /// So many bytes pass in a second, and at least one. `slow 9600` in a script.
    ///
    /// What has been held goes on at this pace, and so does all that follows, until another fault is set.
    Slow(per_second: u64 as rate = 20_000): "slow" => Passage::Paced(*per_second);

    /// Nothing passes ever again, as with a pulled cable: no byte, no end of the connection, no reset. `cut` in a
    /// script.
    ///
    /// A connection that has been cut stays so, and so does one that is made meanwhile. When another fault is set, it
    /// is for the connections that follow.
    Cut: "cut" => Passage::Lost;
}
