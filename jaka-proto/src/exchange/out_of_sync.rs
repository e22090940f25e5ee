//! Why replies can no longer be attributed.

crate::worded! {
    /// Why the replies of a connection can no longer be attributed to its requests.
    #[derive(Debug, Clone, PartialEq, Eq)]
    #[non_exhaustive]
    pub enum OutOfSync {
        /// A reply came to a command that was not sent, or that was answered already.
        Unsolicited {
            /// `cmdName` of the reply.
            command: String,
        } => "a reply to `{command}` came, but no such request is outstanding",
        /// A reply came to a request before any of it was sent.
        BeforeSent => "a reply came to a request before any of it was sent",
        /// A reply names no command, and is not the refusal of the only request that is outstanding.
        Nameless => "a reply came that names no command",
        /// A request was not answered in time, after a reply of its name was taken for that to an older request: it may
        /// have been its own.
        Ambiguous {
            /// `cmdName` of both.
            command: String,
        } => "one of two replies to `{command}` is lost, and it is not known which",
    }
}

impl std::error::Error for OutOfSync {}
