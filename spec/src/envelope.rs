//! The keys that messages have in addition to their fields.

/// The key under which messages name their command.
pub const COMMAND_NAME: &str = "cmdName";
/// The key of the code with which a reply says whether its command was accepted.
pub const ERROR_CODE: &str = "errorCode";
/// The key of the message that explains a refusal.
pub const ERROR_MESSAGE: &str = "errorMsg";

/// The three keys that every reply has.
pub const ENVELOPE: &[&str] = &[COMMAND_NAME, ERROR_CODE, ERROR_MESSAGE];
