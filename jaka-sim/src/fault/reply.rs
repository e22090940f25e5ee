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
    /// Writes nothing.
    Nothing,
    /// Writes the bytes in pieces of these sizes, and the rest as the last piece.
    Write(Vec<u8>, Vec<usize>),
    /// Writes the bytes in one piece, and closes the connection.
    WriteAndClose(Vec<u8>),
    /// Writes the bytes this much later.
    Later(Duration, Vec<u8>),
    /// Holds the bytes back until their release or until the next reply, and writes them before that reply.
    Hold(Vec<u8>),
    /// Writes the bytes together with the next reply.
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
    /// Fault of one reply of the command port.
    ///
    /// [`Controller::inject`](crate::Controller::inject) queues faults, and each reply takes the next one from the
    /// queue; a [`FaultPlan`](crate::FaultPlan) assigns faults to replies from the start. The controller carries out
    /// the request in any case. Only its reply has the fault.
    ///
    /// A fault has a text form, as in the scripts of [`FaultPlan`](crate::FaultPlan): `delay 200ms`, `split 1 5`.
    /// `Display` writes it and `FromStr` reads it.
    ///
    /// The controller closes the connection when it holds back more than 10,000 replies or a megabyte.
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

    /// Returns the delivery of a reply with this fault.
    pub(crate) fn delivery(&self, reply: &str) -> Delivery;

    /// No fault: the reply is correct. `none` in a script.
    None: "none" => Delivery::write(reply);

    /// Omits the reply. `drop` in a script.
    ///
    /// The client waits until its own timeout. The next reply comes as usual.
    Drop: "drop" => Delivery::Nothing;

    /// Delays the reply by this time, in real time; later replies wait for it. `delay 200ms` in a script.
    ///
    /// The client sees a slow controller. The controller carries out its next requests meanwhile. Waiting replies are
    /// lost if the connection ends.
    Delay(time: Duration as time = Duration::from_millis(50)): "delay" => Delivery::Later(*time, reply.into());

    /// Holds the reply back until [`Controller::release`](crate::Controller::release) or until the next reply, and
    /// sends it before that reply. `hold` in a script.
    Hold: "hold" => Delivery::Hold(reply.into());

    /// Writes the reply in pieces of these sizes, in bytes, and the rest as the last piece. `split 1 5` in a script.
    ///
    /// Each piece is a separate segment; the reader's kernel may merge them.
    Pieces(sizes: Vec<usize> as sizes = vec![1, 2, 3]): "split" => Delivery::Write(reply.into(), sizes.clone());

    /// Sends the reply in one write with the next one, and not before. `with-next` in a script.
    WithNext: "with-next" => Delivery::WithNext(reply.into());

    /// Sends the reply twice. `twice` in a script.
    Twice: "twice" => Delivery::write(reply.repeat(2));

    /// Omits the name of the command from the reply. `nameless` in a script.
    Nameless: "nameless" => Delivery::write(rename(reply, None));

    /// Gives the reply the name of this command. `renamed jog` in a script.
    Renamed(name: String as name = GetPayload::INFO.name.to_owned()): "renamed" => {
        Delivery::write(rename(reply, Some(name)))
    };

    /// Sends these bytes before the reply, in the same write. `before "\x00"` in a script.
    Before(bytes: Vec<u8> as bytes = b"{}".to_vec()): "before" => Delivery::write([bytes, reply.as_bytes()].concat());

    /// Sends these bytes after the reply, in the same write. `after "{}"` in a script.
    After(bytes: Vec<u8> as bytes = vec![0]): "after" => Delivery::write([reply.as_bytes(), bytes].concat());

    /// Sends these bytes instead of the reply. `instead "(0, [])"` in a script.
    Instead(bytes: Vec<u8> as bytes = b"nonsense".to_vec()): "instead" => Delivery::write(bytes.as_slice());

    /// Sends random bytes instead of the reply. `garbage 40 7` in a script; a missing seed is 0.
    Garbage {
        /// Number of bytes; at most 256 MiB.
        bytes: usize as count = 500,
        /// Seed of the random bytes. Equal seeds give equal bytes.
        seed: u64 as seed = 7,
    }: "garbage" => Delivery::write(garbage(*bytes, *seed));

    /// Extends the reply to this length, in bytes and at most 256 MiB, with blanks that do not change its JSON value.
    /// `oversized 100000` in a script.
    ///
    /// A longer reply stays unchanged.
    Oversized(size: usize as count = 100_000): "oversized" => Delivery::write(extend(reply, *size));

    /// Keeps the connection open, without this reply or any later one. `half-open` in a script.
    ///
    /// The client sees the same as with a pulled cable at the controller. The controller still reads some 64 KiB from
    /// the client, to notice the end of the connection; after that, the client's writes block. The fault lasts until
    /// the client, another client, [`Controller::disconnect`](crate::Controller::disconnect) or the end of the
    /// controller closes the connection.
    HalfOpen: "half-open" => Delivery::HalfOpen;

    /// Closes the connection instead of replying. `close` in a script.
    Close: "close" => Delivery::Close;

    /// Closes the connection after this many bytes of the reply. `close-after 17` in a script.
    CloseAfter(count: usize as count = 10): "close-after" => {
        Delivery::WriteAndClose(reply.as_bytes()[..reply.len().min(*count)].to_vec())
    };

    /// Resets the connection instead of replying, as after a crash. `reset` in a script.
    Reset: "reset" => Delivery::Reset;

    /// Connects another client to the port, and closes the connection instead of replying. `takeover` in a script.
    ///
    /// The other client stays until a further client replaces it, or, if the port refuses further clients
    /// ([`Takeover::Refuse`](crate::Takeover::Refuse)), until [`Controller::release`](crate::Controller::release).
    Takeover: "takeover" => Delivery::Takeover;
}

fn unknown(word: &str) -> &'static str {
    match word {
        "for" | "random" | "always" | "status" => "this can only begin a line",
        _ => "unknown fault",
    }
}

/// Returns the text with blanks after its first byte, which is a bracket, up to this size.
fn extend(text: &str, size: usize) -> Vec<u8> {
    let blanks = size.min(MOST_BYTES).saturating_sub(text.len());
    let (head, tail) = text.as_bytes().split_at(text.len().min(1));
    [head, &vec![b' '; blanks], tail].concat()
}
