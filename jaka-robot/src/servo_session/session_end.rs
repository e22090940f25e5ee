//! Ends of sessions, for the calls after them.

use crate::End;
use crate::{Cause, Error, ErrorKind, Remedy};

/// Cause of the end of a session, a stream or a trajectory, its text and its remedy.
#[derive(Debug, Clone)]
pub(crate) struct SessionEnd {
    cause: Cause,
    because: String,
    remedy: Remedy,
}

impl SessionEnd {
    /// End that needs no remedy.
    pub(crate) fn new(cause: Cause, because: impl Into<String>) -> Self {
        Self { cause, because: because.into(), remedy: Remedy::None }
    }

    /// End by an error.
    pub(crate) fn of(error: &Error) -> Self {
        Self { cause: error.cause(), because: error.kind().to_string(), remedy: error.remedy() }
    }

    /// End of a trajectory.
    pub(crate) fn of_trajectory(end: &End) -> Self {
        Self { cause: end.cause(), because: end.to_string(), remedy: end.remedy() }
    }

    /// Error of a call after the end.
    pub(crate) fn into_error(self) -> Error {
        let Self { cause, because, remedy } = self;
        ErrorKind::SessionEnded { cause, because, remedy }.into()
    }
}
