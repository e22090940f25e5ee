//! Outcomes of calls.

use jaka_proto::exchange::OutOfSync;
use jaka_proto::framing::FrameError;
use jaka_robot::jaka_sync::ErrorKind as Failure;
use jaka_robot::{Disconnect, Error, ErrorKind};

jaka_proto::worded! {
    /// Outcome of a call.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub(crate) enum Outcome {
        /// Success, with the data that the simulator had.
        Ok => "ok",
        Refused => "refused",
        /// The reply does not fit the spec.
        Unexpected => "unexpected",
        Timeout => "timeout",
        ReplyLost => "reply lost",
        /// The connection is broken for good.
        Broken(cause: Cause) => "**{cause}**",
        /// The motion was accepted; status packets stopped coming, or their connection ended.
        StatusLost => "status lost",
        /// The motion was accepted, and its end is not known at the deadline.
        Deadline => "deadline",
        /// Nothing that moves the arm was sent, since the status is not known.
        StatusUnknown => "status unknown",
        /// Cannot confirm that servo mode was left; the connection still works.
        NotLeft => "not left",
    }
}

jaka_proto::worded! {
    /// Cause of a broken connection.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub(crate) enum Cause {
        /// Its end, or an error of the system.
        End => "end",
        Garbage => "garbage",
        TooLong => "too long",
        NotJson => "not JSON",
        Unsolicited => "unsolicited",
        Nameless => "nameless",
        Ambiguous => "ambiguous",
        /// This side has reset it, since set-points and the end of servo mode were not answered.
        Reset => "reset",
    }
}

impl Outcome {
    /// # Panics
    /// The error is none that a fault may lead to.
    pub(crate) fn of(error: &Error) -> Self {
        match error.kind() {
            ErrorKind::Refused { .. } => Self::Refused,
            ErrorKind::Connection(error) => match error.kind() {
                Failure::Timeout { .. } | Failure::StatusTimeout { .. } | Failure::StateTimeout { .. } => Self::Timeout,
                Failure::ReplyLost { .. } => Self::ReplyLost,
                Failure::UnexpectedReply { .. } | Failure::UnexpectedStatus { .. } => Self::Unexpected,
                Failure::Disconnected { cause, .. } => Self::Broken(Cause::of(cause)),
                other => panic!("no fault may lead to {other:?}"),
            },
            ErrorKind::NotSent { because, .. } => Self::of(because),
            ErrorKind::StatusUnknown { .. } => Self::StatusUnknown,
            ErrorKind::ServoModeNotLeft { leaving, .. } if leaving.is_disconnected() => Self::of(leaving),
            ErrorKind::ServoModeNotLeft { .. } => Self::NotLeft,
            other => panic!("no fault may lead to {other:?}"),
        }
    }

    /// True if a call waits to its deadline.
    pub(crate) fn is_timeout(self) -> bool {
        matches!(self, Self::Timeout | Self::Deadline | Self::NotLeft | Self::Broken(Cause::Ambiguous))
    }
}

impl From<()> for Outcome {
    fn from((): ()) -> Self {
        Self::Ok
    }
}

impl Cause {
    pub(crate) fn of(cause: &Disconnect) -> Self {
        match cause {
            Disconnect::Closed { .. } | Disconnect::Read(_) | Disconnect::Write(_) => Self::End,
            Disconnect::Frame(FrameError::Garbage { .. }) => Self::Garbage,
            Disconnect::Frame(FrameError::TooLong { .. }) => Self::TooLong,
            Disconnect::NotJson(_) => Self::NotJson,
            Disconnect::OutOfSync(OutOfSync::Unsolicited { .. }) => Self::Unsolicited,
            Disconnect::OutOfSync(OutOfSync::Nameless) => Self::Nameless,
            Disconnect::OutOfSync(OutOfSync::Ambiguous { .. }) => Self::Ambiguous,
            Disconnect::Reset { .. } => Self::Reset,
            other => panic!("no fault may lead to {other:?}"),
        }
    }
}
