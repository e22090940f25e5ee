//! Commands that the controller refused.

use std::fmt;

use crate::error_code::ErrorCode;
use crate::text::Visible;

/// A command that the controller refused, in the controller's words. Nothing came of the command.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Refusal {
    /// `cmdName` of the command.
    pub command: String,
    /// The controller's code.
    pub code: ErrorCode,
    /// The controller's message.
    pub message: String,
}

impl Refusal {
    /// A refusal of `command`.
    pub fn new(command: impl Into<String>, code: ErrorCode, message: impl Into<String>) -> Self {
        Self { command: command.into(), code, message: message.into() }
    }
}

/// In one line, whatever the controller says: see [`text`](crate::text).
impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { command, code, message } = self;
        write!(f, "the controller refused `{}` with code {code}", Visible(command))?;
        if message.is_empty() { Ok(()) } else { write!(f, ": {}", Visible(message)) }
    }
}

impl std::error::Error for Refusal {}
