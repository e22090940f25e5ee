//! What happens to a connection after a request.

/// What happens to a connection after a request.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum NextStep {
    /// The next request is read.
    Continue,
    Close,
    Reset,
    /// It stays open, and no further request is answered.
    HalfOpen,
    /// Another client takes the port.
    Takeover,
    /// The controller shuts down.
    Shutdown,
}
