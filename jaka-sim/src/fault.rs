//! What can be wrong with a reply.

mod rename;

/// Something wrong with one reply of the command port.
///
/// [`Controller::inject`](crate::Controller::inject) puts faults into a queue, and each reply takes the next one from
/// it; a controller whose queue is empty replies as it should. The request is carried out in any case. It is the reply
/// that goes wrong.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Fault {
    /// Nothing: this reply is as it should be.
    None,
    /// The reply never comes.
    Drop,
    /// The reply is kept back until [`Controller::release`](crate::Controller::release), or until the next reply goes
    /// out, and goes before that one.
    Hold,
    /// The reply is written in pieces of these sizes, in bytes, and what is left of it as the last.
    ///
    /// Each piece is a segment of its own; the reader's kernel may put them together again.
    Pieces(Vec<usize>),
    /// The reply goes out in one write with the next one, and not before.
    WithNext,
    /// The reply comes twice.
    Twice,
    /// The reply does not say which command it answers.
    Nameless,
    /// The reply names this command as the one it answers.
    Renamed(String),
    /// These bytes come before the reply, in the same write.
    Before(Vec<u8>),
    /// These bytes come after the reply, in the same write.
    After(Vec<u8>),
    /// These bytes come in place of the reply.
    Instead(Vec<u8>),
    /// The connection is closed in place of the reply.
    Close,
    /// The connection is closed after so many bytes of the reply.
    CloseAfter(usize),
    /// The connection is reset in place of the reply, as when the controller has crashed.
    ///
    /// The reset comes from data that nobody reads, so it is certain where the kernel answers that with one, as those
    /// of Linux and Windows do.
    Reset,
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
            _ => bytes.to_vec(),
        }
    }
}
