//! Commands that the controller refused.

use std::fmt;

use crate::text::Visible;
use crate::wire::{Decode, DecodeError, Encode, Reader, Writer};

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

/// A code in a reply's `errorCode`. The set is open: firmware sends codes that no document lists.
///
/// Codes named by sources are associated constants. Success is numeric zero in any form: `"0"`, `0`, `"0x0"`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ErrorCode(pub i64);

impl Refusal {
    /// A refusal of `command`.
    pub fn new(command: impl Into<String>, code: ErrorCode, message: impl Into<String>) -> Self {
        Self { command: command.into(), code, message: message.into() }
    }
}

/// In one line, for any text of the controller: see [`text`](crate::text).
impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { command, code, message } = self;
        write!(f, "the controller refused `{}` with code {code}", Visible(command))?;
        if message.is_empty() { Ok(()) } else { write!(f, ": {}", Visible(message)) }
    }
}

impl std::error::Error for Refusal {}

impl ErrorCode {
    /// True for success.
    pub fn is_success(self) -> bool {
        self.0 == 0
    }
}

impl fmt::Display for ErrorCode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

/// As a string of decimal digits, the form of the document.
impl Encode for ErrorCode {
    fn encode(&self, out: &mut Writer) {
        out.raw("\"");
        out.int(self.0);
        out.raw("\"");
    }
}

/// Any number, or a string that holds one, also in hexadecimal.
impl Decode for ErrorCode {
    fn decode(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        if reader.eat("\"0\"") {
            return Ok(Self(0));
        }
        if let Some(code) = reader.text_with(hexadecimal_or_decimal) {
            return Ok(Self(code));
        }
        i64::decode(reader).map(Self)
    }
}

fn hexadecimal_or_decimal(text: &str) -> Option<i64> {
    let text = text.trim();
    match text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")) {
        // Digits alone: `from_str_radix` takes a sign, too.
        Some(digits) if digits.bytes().all(|byte| byte.is_ascii_hexdigit()) => i64::from_str_radix(digits, 16).ok(),
        Some(_) => None,
        None => text.parse().ok(),
    }
}

crate::__serde_impls!(ErrorCode);
