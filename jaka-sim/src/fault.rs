//! What can be wrong with a reply.

mod display;
mod each;
mod link;
mod plan;
mod rename;
mod script;
mod split_mix;
mod status;
mod token_reader;
mod tokens;

use std::time::Duration;

pub use self::link::{LinkEvent, LinkFault};
pub use self::plan::FaultPlan;
pub use self::script::ScriptError;
pub(crate) use self::split_mix::SplitMix64;
pub use self::status::StatusFault;
pub(crate) use self::token_reader::read_time;

/// The most bytes that a fault makes up: 256 MiB.
const MOST_BYTES: usize = 256 << 20;

/// Something wrong with one reply of the command port.
///
/// [`Controller::inject`](crate::Controller::inject) puts faults into a queue, and each reply takes the next one from
/// it; a [`FaultPlan`] says which replies have faults from the start. The request is carried out in any case. It is the
/// reply that goes wrong.
///
/// A fault has a text form, as in the scripts of [`FaultPlan`]: `delay 200ms`, `split 1 5`. It is what `Display` writes
/// and `FromStr` reads.
///
/// Where replies are kept back without end, the connection is closed, once they are 10,000 or a megabyte.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Fault {
    /// Nothing: this reply is as it should be. `none` in a script.
    None,
    /// The reply never comes. `drop` in a script.
    ///
    /// The client waits until its own timeout. The next reply comes as usual.
    Drop,
    /// The reply comes so much later, in real time, and later replies wait behind it. `delay 200ms` in a script.
    ///
    /// The client sees a slow controller. Meanwhile its next requests are carried out, and a connection that ends takes
    /// what still waits with it.
    Delay(Duration),
    /// The reply is kept back until [`Controller::release`](crate::Controller::release), or until the next reply goes
    /// out, and goes before that one. `hold` in a script.
    Hold,
    /// The reply is written in pieces of these sizes, in bytes, and what is left of it as the last. `split 1 5` in a
    /// script.
    ///
    /// Each piece is a segment of its own; the reader's kernel may put them together again.
    Pieces(Vec<usize>),
    /// The reply goes out in one write with the next one, and not before. `with-next` in a script.
    WithNext,
    /// The reply comes twice. `twice` in a script.
    Twice,
    /// The reply does not say which command it answers. `nameless` in a script.
    Nameless,
    /// The reply names this command as the one it answers. `renamed jog` in a script.
    Renamed(String),
    /// These bytes come before the reply, in the same write. `before "\x00"` in a script.
    Before(Vec<u8>),
    /// These bytes come after the reply, in the same write. `after "{}"` in a script.
    After(Vec<u8>),
    /// These bytes come in place of the reply. `instead "(0, [])"` in a script.
    Instead(Vec<u8>),
    /// Random bytes come in place of the reply. `garbage 40 7` in a script; without the seed it is 0.
    Garbage {
        /// How many; at most 256 MiB.
        bytes: usize,
        /// The same seed gives the same bytes.
        seed: u64,
    },
    /// The reply is blown up to this length, in bytes and at most 256 MiB, with blanks that leave it the same JSON.
    /// `oversized 100000` in a script.
    ///
    /// A reply that is longer already stays as it is.
    Oversized(usize),
    /// The connection stays open in place of the reply, but from now on nothing is answered. `half-open` in a script.
    ///
    /// The client sees what it would see of a controller whose cable is pulled. Some 64 KiB of what it sends are still
    /// taken, so that its end of the connection is noticed; then its writes fill up. It lasts until the client, a
    /// newcomer, [`Controller::disconnect`](crate::Controller::disconnect) or the end of the controller closes the
    /// connection.
    HalfOpen,
    /// The connection is closed in place of the reply. `close` in a script.
    Close,
    /// The connection is closed after so many bytes of the reply. `close-after 17` in a script.
    CloseAfter(usize),
    /// The connection is reset in place of the reply, as when the controller has crashed. `reset` in a script.
    Reset,
    /// Another client takes the port: the connection is closed in place of the reply. `takeover` in a script.
    ///
    /// The other client stays until a newcomer takes the port from it, or, where newcomers are refused
    /// ([`Takeover::Refuse`](crate::Takeover::Refuse)), until [`Controller::release`](crate::Controller::release).
    Takeover,
}

impl Fault {
    /// What goes out in place of the reply, where the fault is in the bytes and not in their way.
    pub(crate) fn garble(&self, reply: &str) -> Vec<u8> {
        let bytes = reply.as_bytes();
        match self {
            Self::Twice => bytes.repeat(2),
            Self::Nameless => rename::rename(reply, None).into_bytes(),
            Self::Renamed(name) => rename::rename(reply, Some(name)).into_bytes(),
            Self::Before(more) => [more, bytes].concat(),
            Self::After(more) => [bytes, more].concat(),
            Self::Instead(other) => other.clone(),
            Self::Garbage { bytes, seed } => garbage(*bytes, *seed),
            Self::Oversized(size) => blow_up(bytes, *size),
            _ => bytes.to_vec(),
        }
    }
}

/// Random bytes, the same for the same seed.
pub(crate) fn garbage(bytes: usize, seed: u64) -> Vec<u8> {
    SplitMix64::new(seed).bytes(bytes.min(MOST_BYTES))
}

/// The text with blanks behind its first byte, which is a bracket, up to this size.
fn blow_up(text: &[u8], size: usize) -> Vec<u8> {
    let blanks = size.min(MOST_BYTES).saturating_sub(text.len());
    let (head, tail) = text.split_at(text.len().min(1));
    [head, &vec![b' '; blanks], tail].concat()
}
