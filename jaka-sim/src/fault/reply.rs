//! Faults of a reply.

use std::time::Duration;

use jaka_proto::Command;
use jaka_proto::messages::payload::GetPayload;

use super::kinds::kinds;
use super::rename::rename;
use super::{MOST_BYTES, garbage};

/// Delivery of a reply to the client.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Delivery {
    /// Nothing is written.
    Nothing,
    /// The bytes are written in pieces of these sizes, and the rest as the last piece.
    Write(Vec<u8>, Vec<usize>),
    /// The bytes are written in one piece, and the connection is closed.
    WriteAndClose(Vec<u8>),
    /// The bytes are written this much later.
    Later(Duration, Vec<u8>),
    /// The bytes are held back until they are released or the next reply is written, and go before that one.
    Hold(Vec<u8>),
    /// The bytes are written together with the next reply.
    WithNext(Vec<u8>),
    HalfOpen,
    Close,
    Reset,
    Takeover,
}

impl Delivery {
    fn write(bytes: impl Into<Vec<u8>>) -> Self {
        Self::Write(bytes.into(), Vec::new())
    }
}

kinds! {
    /// Something wrong with one reply of the command port.
    ///
    /// [`Controller::inject`](crate::Controller::inject) queues faults, and each reply takes the next one from the
    /// queue; a [`FaultPlan`](crate::FaultPlan) says from the start which replies have faults. The request is carried
    /// out in any case. It is the reply that goes wrong.
    ///
    /// A fault has a text form, as in the scripts of [`FaultPlan`](crate::FaultPlan): `delay 200ms`, `split 1 5`.
    /// `Display` writes it and `FromStr` reads it.
    ///
    /// When more than 10,000 replies or a megabyte are kept back, the connection is closed.
    ///
    /// ```
    /// use jaka_sim::{Controller, Fault};
    ///
    /// for fault in Fault::one_of_each() {
    ///     let controller = Controller::start()?;
    ///     controller.inject(fault);
    ///     // Here a program must end, and must not believe wrong data.
    /// }
    /// # Ok::<(), std::io::Error>(())
    /// ```
    #[derive(Debug, Clone, PartialEq, Eq)]
    #[non_exhaustive]
    pub enum Fault("a fault", unknown);

    /// Delivery of a reply with this fault.
    pub(crate) fn delivery(&self, reply: &str) -> Delivery;

    /// Nothing: this reply is as it should be. `none` in a script.
    None: "none" => Delivery::write(reply);

    /// The reply never comes. `drop` in a script.
    ///
    /// The client waits until its own timeout. The next reply comes as usual.
    Drop: "drop" => Delivery::Nothing;

    /// The reply comes this much later, in real time, and later replies wait until it has. `delay 200ms` in a script.
    ///
    /// The client sees a slow controller. Meanwhile its next requests are carried out. If the connection ends, what
    /// still waits is lost with it.
    Delay(time: Duration as time = Duration::from_millis(50)): "delay" => Delivery::Later(*time, reply.into());

    /// The reply is kept back until [`Controller::release`](crate::Controller::release), or until the next reply is
    /// written, and goes before that one. `hold` in a script.
    Hold: "hold" => Delivery::Hold(reply.into());

    /// The reply is written in pieces of these sizes, in bytes, and the rest of it as the last piece. `split 1 5` in a
    /// script.
    ///
    /// Each piece is a segment of its own; the reader's kernel may put them together again.
    Pieces(sizes: Vec<usize> as sizes = vec![1, 2, 3]): "split" => Delivery::Write(reply.into(), sizes.clone());

    /// The reply goes out in one write with the next one, and not before. `with-next` in a script.
    WithNext: "with-next" => Delivery::WithNext(reply.into());

    /// The reply comes twice. `twice` in a script.
    Twice: "twice" => Delivery::write(reply.repeat(2));

    /// The reply does not say which command it answers. `nameless` in a script.
    Nameless: "nameless" => Delivery::write(rename(reply, None));

    /// The reply names this command as the one it answers. `renamed jog` in a script.
    Renamed(name: String as name = GetPayload::INFO.name.to_owned()): "renamed" => {
        Delivery::write(rename(reply, Some(name)))
    };

    /// These bytes come before the reply, in the same write. `before "\x00"` in a script.
    Before(bytes: Vec<u8> as bytes = b"{}".to_vec()): "before" => Delivery::write([bytes, reply.as_bytes()].concat());

    /// These bytes come after the reply, in the same write. `after "{}"` in a script.
    After(bytes: Vec<u8> as bytes = vec![0]): "after" => Delivery::write([reply.as_bytes(), bytes].concat());

    /// These bytes come in place of the reply. `instead "(0, [])"` in a script.
    Instead(bytes: Vec<u8> as bytes = b"nonsense".to_vec()): "instead" => Delivery::write(bytes.as_slice());

    /// Random bytes come in place of the reply. `garbage 40 7` in a script; without the seed it is 0.
    Garbage {
        /// Number of bytes; at most 256 MiB.
        bytes: usize as count = 500,
        /// Seed of the random bytes. Equal seeds give equal bytes.
        seed: u64 as seed = 7,
    }: "garbage" => Delivery::write(garbage(*bytes, *seed));

    /// The reply is extended to this length, in bytes and at most 256 MiB, with blanks that leave it the same JSON.
    /// `oversized 100000` in a script.
    ///
    /// A reply that is longer already stays as it is.
    Oversized(size: usize as count = 100_000): "oversized" => Delivery::write(extend(reply, *size));

    /// The connection stays open in place of the reply, but from now on nothing is answered. `half-open` in a script.
    ///
    /// The client sees what it would see of a controller whose cable is pulled. Some 64 KiB of what it sends are still
    /// read, so that its end of the connection is noticed; then its writes fill up. It lasts until the client, another
    /// client, [`Controller::disconnect`](crate::Controller::disconnect) or the end of the controller closes the
    /// connection.
    HalfOpen: "half-open" => Delivery::HalfOpen;

    /// The connection is closed in place of the reply. `close` in a script.
    Close: "close" => Delivery::Close;

    /// The connection is closed after this many bytes of the reply. `close-after 17` in a script.
    CloseAfter(count: usize as count = 10): "close-after" => {
        Delivery::WriteAndClose(reply.as_bytes()[..reply.len().min(*count)].to_vec())
    };

    /// The connection is reset in place of the reply, as when the controller has crashed. `reset` in a script.
    Reset: "reset" => Delivery::Reset;

    /// Another client takes the port: the connection is closed in place of the reply. `takeover` in a script.
    ///
    /// The other client stays until a further client takes the port from it, or, if further clients are refused
    /// ([`Takeover::Refuse`](crate::Takeover::Refuse)), until [`Controller::release`](crate::Controller::release).
    Takeover: "takeover" => Delivery::Takeover;
}

fn unknown(word: &str) -> &'static str {
    match word {
        "for" | "random" | "always" | "status" => "this can only begin a line",
        _ => "unknown fault",
    }
}

/// The text with blanks after its first byte, which is a bracket, up to this size.
fn extend(text: &str, size: usize) -> Vec<u8> {
    let blanks = size.min(MOST_BYTES).saturating_sub(text.len());
    let (head, tail) = text.as_bytes().split_at(text.len().min(1));
    [head, &vec![b' '; blanks], tail].concat()
}
