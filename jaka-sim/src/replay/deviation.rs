//! Deviations of a client from the recording.

use jaka_proto::recording::Port;

jaka_proto::worded! {
    /// Deviation of a client from the recording, for which the recording has no answer.
    #[derive(Debug, Clone, PartialEq, Eq)]
    #[non_exhaustive]
    pub enum Deviation {
        /// The client sent another request than the recorded one. The controller closed the connection.
        OtherRequest {
            /// Recorded request.
            expected: String,
            /// Received request.
            received: String,
        } => "expected the recorded request `{expected}`, but received `{received}`",
        /// The client sent a request after the last recorded one. The controller closed the connection.
        FurtherRequest {
            /// Received request.
            received: String,
        } => "received `{received}`, but no further request was recorded",
        /// The client disconnected before it sent a recorded request.
        MissingRequest {
            /// Recorded request.
            expected: String,
        } => "expected the recorded request `{expected}`, but the client disconnected",
        /// The recording has no reply left for a request. The controller refused it.
        NoReplyLeft {
            /// Received request.
            received: String,
        } => "the recording has no unused reply to `{received}`",
        /// The recording lacks entries, since writing the file was too slow. The controller closed the connection
        /// there.
        Gap {
            /// Number of missing entries.
            count: u64,
        } => "{count} entries are missing in the recording at this point",
        /// The client opened a connection that the recording does not have. The controller closed it.
        Connection {
            /// Port.
            port: Port,
            /// Number of connections to the port in the recording.
            recorded: usize,
        } => "a connection to the {port} port, of which the recording has {recorded}",
    }
}
