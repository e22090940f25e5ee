//! Causes of a broken connection.

use std::error::Error as StdError;
use std::io;

use jaka_proto::exchange::OutOfSync;
use jaka_proto::framing::FrameError;
use jaka_proto::wire::DecodeError;

jaka_proto::worded! {
    /// Cause of a broken connection.
    #[derive(Debug)]
    #[non_exhaustive]
    pub enum Disconnect {
        /// The controller closed the connection.
        Closed {
            /// Number of bytes of an unfinished message that had come.
            partial: usize,
        } => (closed(*partial)),
        /// The system reported an error while sending.
        Write(error: io::Error) => "sending failed",
        /// The system reported an error while receiving.
        Read(error: io::Error) => "receiving failed",
        /// Bytes came that are not a message, or a message longer than the limit.
        Frame(error: FrameError) => (not_a_frame(error)),
        /// A message came that is not a JSON object by its quotes and brackets.
        NotJson(error: DecodeError) => "a message is not JSON: {error}",
        /// The requests to which the next replies belong are uncertain.
        OutOfSync(out_of_sync: OutOfSync) => "{out_of_sync}",
        /// This side reset the connection, because set-points of a servo session and the command that ends servo mode
        /// had no reply. The system discards what it had queued.
        Reset {
            /// Number of set-points without a reply.
            unanswered: u64,
        } =>
            "this program reset the connection, because {unanswered} set-points and the command that ends servo mode had no \
             reply; unsent set-points were discarded, sent ones may still move the arm",
        /// A panic in this program, for example in a logger or a decoder, interrupted the reading of messages.
        Panicked => "a panic in this program interrupted the reading of messages",
        /// The client was dropped, and its connection with it: stop handles can no longer stop the robot.
        ClientDropped => "the client was dropped, which closed its connection",
        /// This is the status port, or a server that sends status packets; port 10001 takes commands.
        StatusPort => "received a status packet instead of a reply: this is the status port; commands go to port 10001",
        /// This is the command port, or a server that answers like it; port 10000 sends the status.
        CommandPort =>
            "received a reply to a command instead of a status packet: this is the command port; status packets come from port 10000",
        /// A command that ends the session was carried out.
        Ended {
            /// `cmdName` of the command.
            by: String,
        } => "`{by}` ended the session",
    }
}

fn closed(partial: usize) -> String {
    let within =
        if partial > 0 { format!(" in the middle of a message, after {partial} bytes of it") } else { String::new() };
    format!("the controller closed the connection{within}")
}

fn not_a_frame(error: &FrameError) -> String {
    if is_text_line(error) {
        return format!("this firmware sends its status as text lines, a form of very old versions: {error}");
    }
    error.to_string()
}

impl Disconnect {
    /// Hint at a possible reason for the end of a command connection, for the text of an error; empty unless the
    /// controller has ended it.
    pub(crate) fn seat_hint(&self) -> &'static str {
        if self.is_by_controller() {
            "; the controller may have shut down, or another client, such as the vendor's app, may have taken the command port"
        } else {
            ""
        }
    }

    /// True if the controller has ended the connection, in order or not.
    pub(crate) fn is_by_controller(&self) -> bool {
        use io::ErrorKind::{BrokenPipe, ConnectionAborted, ConnectionReset};
        match self {
            Self::Closed { .. } => true,
            Self::Read(error) | Self::Write(error) => {
                matches!(error.kind(), ConnectionReset | ConnectionAborted | BrokenPipe)
            }
            _ => false,
        }
    }
}

/// Firmware before the JSON protocol sent lines such as `joint_actual_position:(…)`.
pub fn is_text_line(error: &FrameError) -> bool {
    matches!(error, FrameError::Garbage { excerpt } if excerpt.bytes().starts_with(b"joint_actual_position"))
}

impl StdError for Disconnect {
    fn source(&self) -> Option<&(dyn StdError + 'static)> {
        match self {
            Self::Write(source) | Self::Read(source) => Some(source),
            _ => None,
        }
    }
}
