//! Deviations of a client from the recording.

use jaka_proto::recording::Port;

jaka_proto::worded! {
    /// Deviation of a client from the recording, for which the recording has no answer.
    #[derive(Debug, Clone, PartialEq, Eq)]
    #[non_exhaustive]
    pub enum Deviation {
        /// Another request came than the recorded one. The connection was closed.
        OtherRequest {
            /// The recorded request.
            expected: String,
            /// The request that came.
            received: String,
        } => "expected the recorded request `{expected}`, but received `{received}`",
        /// A request came where the recorded client sent nothing more. The connection was closed.
        FurtherRequest {
            /// The request that came.
            received: String,
        } => "received `{received}`, but no further request was recorded",
        /// The client ended its connection before it sent what the recorded one sent.
        MissingRequest {
            /// The recorded request.
            expected: String,
        } => "expected the recorded request `{expected}`, but the client disconnected",
        /// A request came to which no reply is left. It was refused.
        NoReplyLeft {
            /// The request that came.
            received: String,
        } => "the recording has no unused reply to `{received}`",
        /// The recording lacks entries, since its file could not be written as fast. The connection was closed there.
        Gap {
            /// Number of missing entries.
            count: u64,
        } => "{count} entries are missing in the recording at this point",
        /// A connection was made that the recording does not have. It was closed.
        Connection {
            /// The port.
            port: Port,
            /// Number of connections to the port in the recording.
            recorded: usize,
        } => "a connection to the {port} port, of which the recording has {recorded}",
    }
}
