//! Requests from their JSON.

use crate::check::{NotSent, Rules};
use crate::command::{Command, CommandInfo, Visit};
use crate::messages::{Request, Role};
use crate::wire::{DecodeError, Reader, Writer};

impl Request {
    /// Reads a request as it goes over the wire.
    ///
    /// # Errors
    /// The text is not a JSON object, names no command or one that the spec does not know, or a field does not fit.
    #[inline]
    pub fn read(json: &str) -> Result<Self, RequestError> {
        let name = name(json).map_err(RequestError::Malformed)?.ok_or(RequestError::Nameless)?;
        let Some(request) = Self::read_named(&name, &mut Reader::new(json)) else {
            return Err(RequestError::Unknown { command: name });
        };
        request.map_err(|source| RequestError::Field { command: name, source })
    }

    /// The name of the command that may be answered by a bare Python tuple, which names no command: for
    /// [`Exchange::new`](crate::exchange::Exchange::new).
    pub fn bare_reply_command() -> Option<&'static str> {
        Self::COMMANDS.iter().find(|info| info.bare_reply.is_some()).map(|info| info.name)
    }

    /// Returns the facts of the spec about the command.
    #[inline]
    pub fn info(&self) -> &'static CommandInfo {
        struct Info;
        impl Visit for Info {
            type Output = &'static CommandInfo;

            fn visit<C: Command>(self, _command: &C) -> Self::Output {
                C::INFO
            }
        }
        self.visit(Info)
    }

    /// Role of the request for the arm.
    #[inline]
    pub fn role(&self) -> Option<Role> {
        struct OfRequest;
        impl Visit for OfRequest {
            type Output = Option<Role>;

            fn visit<C: Command>(self, command: &C) -> Self::Output {
                command.role()
            }
        }
        self.visit(OfRequest)
    }

    /// Writes the request as it goes over the wire.
    #[inline]
    pub fn write(&self, out: &mut Writer) {
        struct Write<'w>(&'w mut Writer);
        impl Visit for Write<'_> {
            type Output = ();

            fn visit<C: Command>(self, command: &C) {
                command.write_request(self.0);
            }
        }
        self.visit(Write(out));
    }

    /// Checks the request against the spec, and against the controller's firmware where the rules say which it is.
    ///
    /// # Errors
    /// As [`Command::check`].
    #[inline]
    pub fn check(&self, rules: impl Into<Rules>) -> Result<(), NotSent> {
        struct Check(Rules);
        impl Visit for Check {
            type Output = Result<(), NotSent>;

            fn visit<C: Command>(self, command: &C) -> Self::Output {
                command.check(self.0)
            }
        }
        self.visit(Check(rules.into()))
    }
}

/// `cmdName`, after a look at the whole text.
fn name(json: &str) -> Result<Option<String>, DecodeError> {
    let mut reader = Reader::new(json);
    let mut name = None;
    reader.begin_object()?;
    while let Some(key) = reader.next_key()? {
        if key == "cmdName" { name = Some(reader.text()?.trim().to_owned()) } else { reader.skip()? }
    }
    reader.end()?;
    Ok(name)
}

crate::worded! {
    /// A request that cannot be read.
    #[derive(Debug, Clone, PartialEq, Eq)]
    #[non_exhaustive]
    pub enum RequestError {
        /// The text is not a JSON object.
        Malformed(source: DecodeError) => "the request is not a JSON object",
        /// The object has no `cmdName`.
        Nameless => "the request has no `cmdName`",
        /// The spec has no such command.
        Unknown {
            /// `cmdName` of the request.
            command: String,
        } => "the spec has no command `{command}`",
        /// A field is missing or does not fit its type.
        Field {
            /// `cmdName` of the request.
            command: String,
            /// Error in the field.
            source: DecodeError,
        } => "the request `{command}` does not fit the spec",
    }
}

impl std::error::Error for RequestError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Malformed(source) | Self::Field { source, .. } => Some(source),
            Self::Nameless | Self::Unknown { .. } => None,
        }
    }
}
