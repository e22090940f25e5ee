//! Ends of sessions, for the calls after them.

use crate::{Cause, Error, ErrorKind};

/// Cause of the end of a session, a stream or a trajectory, and its text.
#[derive(Debug, Clone)]
pub(crate) struct SessionEnd {
    cause: Cause,
    because: String,
}

impl SessionEnd {
    pub(crate) fn new(cause: Cause, because: impl Into<String>) -> Self {
        Self { cause, because: because.into() }
    }

    /// End by an error.
    pub(crate) fn of(error: &Error) -> Self {
        Self::new(error.cause(), error.to_string())
    }

    /// Error of a call after the end.
    pub(crate) fn into_error(self) -> Error {
        ErrorKind::SessionEnded { cause: self.cause, because: self.because }.into()
    }
}
