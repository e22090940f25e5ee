//! The keys that messages have beside their fields.

/// The key under which messages name their command.
pub const COMMAND_NAME: &str = "cmdName";
pub(crate) const ERROR_CODE: &str = "errorCode";
pub(crate) const ERROR_MESSAGE: &str = "errorMsg";

/// The three keys that every reply has.
pub const ENVELOPE: &[&str] = &[COMMAND_NAME, ERROR_CODE, ERROR_MESSAGE];
