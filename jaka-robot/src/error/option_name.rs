//! Names of this crate's options, and the error for a value that one does not take.

use std::fmt;

use crate::{Error, ErrorKind};

/// Name of an option of this crate, and the type that has it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OptionName {
    of: &'static str,
    option: &'static str,
}

impl OptionName {
    pub(crate) const fn new(of: &'static str, option: &'static str) -> Self {
        Self { of, option }
    }

    /// Error for a value that the option does not take.
    pub(crate) fn refuse(self, value: impl fmt::Display, expected: impl Into<String>) -> Error {
        let Self { of, option } = self;
        ErrorKind::InvalidOption { option, of, value: value.to_string(), expected: expected.into() }.into()
    }
}
