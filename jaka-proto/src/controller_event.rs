//! The controller's events, by the code in `errcode`.

use std::fmt;
use std::num::NonZeroU32;

use crate::messages::power::GetRobotStateReply;
use crate::messages::status::RobotStatus;
use crate::messages::{EVENT_EXPLANATIONS, EVENT_RANGES, Severity};
use crate::wire::{Decode as _, Reader, Value};

/// An event of the controller, identified by its code in `errcode`: an error, a warning or information.
///
/// A code that is not zero does not by itself mean that something is wrong: `0x10f0005` says that the robot is
/// disabled. It may also be of an event that is over. The severity is looked up in a table made from the vendor's. The
/// set of codes is open: one that the table does not have has [`Severity::Unknown`].
///
/// ```
/// use jaka_proto::{ControllerEvent, Severity};
///
/// let event = ControllerEvent::from_text("0x10f0005")?.expect("the code is not zero");
/// assert_eq!(event.severity(), Severity::Information);
/// assert_eq!(event.to_string(), "0x10f0005 (information: the robot is disabled)");
/// assert_eq!(ControllerEvent::from_text("0x0")?, None);
/// # Ok::<(), jaka_proto::UnreadableEvent>(())
/// ```
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ControllerEvent(NonZeroU32);

/// Severity, meaning, cause and remedy of an event.
pub(crate) type Explanation = (Severity, Option<&'static str>, Option<EventNote>, Option<EventNote>);

crate::worded! {
    /// Cause or remedy of an event: phrases on one line, without full stop.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    pub enum EventNote {
        /// Statement of the vendor's table for the code.
        OfCode(text: &'static str) => "{text}",
        /// General statement for the event's family, such as brakes, since the table states nothing for the code.
        OfFamily(text: &'static str) => "{text} (general: the vendor's table states nothing for this code)",
    }
}

impl EventNote {
    /// The text alone.
    pub const fn text(self) -> &'static str {
        match self {
            Self::OfCode(text) | Self::OfFamily(text) => text,
        }
    }
}

impl ControllerEvent {
    /// The event of this code; `None` for zero, which says that there is no event.
    pub const fn new(code: u32) -> Option<Self> {
        match NonZeroU32::new(code) {
            Some(code) => Some(Self(code)),
            None => None,
        }
    }

    /// Reads the text of a status packet's `error_code`: a hexadecimal number in any case, with or without `0x`.
    ///
    /// `None` for zero and for an empty text, which say that there is no event.
    ///
    /// # Errors
    /// The text is not such a number, or one of more than 32 bits. Whether there is an event is then not known.
    pub fn from_text(text: &str) -> Result<Option<Self>, UnreadableEvent> {
        let number = text.trim();
        let digits = number.strip_prefix("0x").or_else(|| number.strip_prefix("0X"));
        if number.is_empty() {
            return Ok(None);
        }
        let digits = digits.unwrap_or(number);
        // Rust's own reading would take a sign too.
        let is_number = digits.bytes().all(|digit| digit.is_ascii_hexdigit());
        let code = u32::from_str_radix(digits, 16).ok().filter(|_| is_number);
        code.map(Self::new).ok_or_else(|| UnreadableEvent::new(text))
    }

    /// The code, without the form in which the controller wrote it.
    pub const fn code(self) -> u32 {
        self.0.get()
    }

    /// Severity of the event; [`Severity::Unknown`] for a code that the table does not have.
    pub fn severity(self) -> Severity {
        self.explanation().map_or(Severity::Unknown, |(severity, ..)| *severity)
    }

    /// Meaning of the event, such as `the robot is disabled`; `None` for a code that the table does not have.
    ///
    /// Meanings, causes and remedies are from the vendor's table of February 2024, in our own words. jaka-spec's
    /// `EVENTS.md` has all of them by code.
    pub fn meaning(self) -> Option<&'static str> {
        self.explanation().and_then(|(_, meaning, ..)| *meaning)
    }

    /// Possible causes of the event; `None` for a code that the table does not have, and for reports of actions.
    pub fn cause(self) -> Option<EventNote> {
        self.explanation().and_then(|(_, _, cause, _)| *cause)
    }

    /// Remedies for the event; `None` for a code that the table does not have.
    ///
    /// No remedy acts on the arm before somebody has looked at it. No remedy knows whether a person is beside the arm.
    pub fn remedy(self) -> Option<EventNote> {
        self.explanation().and_then(|(.., remedy)| *remedy)
    }

    /// The table's entry for the range that has the code.
    fn explanation(self) -> Option<&'static Explanation> {
        let code = self.code();
        let at = EVENT_RANGES.partition_point(|(_, last, _)| *last < code);
        let (first, _, found) = EVENT_RANGES.get(at)?;
        EVENT_EXPLANATIONS.get(*found).filter(|_| *first <= code)
    }
}

/// The code, its severity and its meaning, such as `0x10f0005 (information: the robot is disabled)`.
impl fmt::Display for ControllerEvent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:#08x} (", self.code())?;
        match (self.severity(), self.meaning()) {
            (Severity::Unknown, _) => f.write_str("severity unknown")?,
            (severity, Some(meaning)) => write!(f, "{severity}: {meaning}")?,
            (severity, None) => write!(f, "{severity}")?,
        }
        f.write_str(")")
    }
}

impl fmt::Debug for ControllerEvent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "ControllerEvent({:#08x})", self.code())
    }
}

/// A code of an event that is not a number, or not one of an event. Whether there is an event is not known.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct UnreadableEvent {
    /// Text in place of the code, as the controller wrote it.
    pub text: String,
}

impl UnreadableEvent {
    fn new(text: impl Into<String>) -> Self {
        Self { text: text.into() }
    }
}

/// With the text's control characters escaped, and no more of it than 60 characters.
impl fmt::Display for UnreadableEvent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text: String = self.text.chars().take(60).collect();
        write!(f, "the event code {text:?} is not a number such as 0x10f0005")
    }
}

impl std::error::Error for UnreadableEvent {}

impl RobotStatus {
    /// The controller's event, from `error_code`; `None` where the packet says that there is none or does not have the
    /// field.
    ///
    /// # Errors
    /// `error_code` cannot be read, as [`ControllerEvent::from_text`] says. Whether there is an event is then not
    /// known.
    pub fn event(&self) -> Result<Option<ControllerEvent>, UnreadableEvent> {
        self.error_code.as_deref().map_or(Ok(None), ControllerEvent::from_text)
    }
}

impl GetRobotStateReply {
    /// The controller's event, from `error_code`; `None` where the reply says that there is none or does not have the
    /// field.
    ///
    /// One controller writes the code as a number. A text is read as in status packets, except a text of decimal digits
    /// alone, which is ambiguous.
    ///
    /// # Errors
    /// `error_code` cannot be read. Whether there is an event is then not known.
    pub fn event(&self) -> Result<Option<ControllerEvent>, UnreadableEvent> {
        match &self.error_code {
            None => Ok(None),
            Some(Value::String(text)) if is_ambiguous(text) => Err(UnreadableEvent::new(text)),
            Some(Value::String(text)) => ControllerEvent::from_text(text),
            Some(value) => {
                let text = value.to_string();
                let number = value.is_number().then(|| i64::decode(&mut Reader::new(&text)).ok()).flatten();
                let code = number.and_then(|number| u32::try_from(number).ok());
                code.map(ControllerEvent::new).ok_or_else(|| UnreadableEvent::new(text))
            }
        }
    }
}

/// True for decimal digits that are another number if they are taken for hexadecimal ones.
fn is_ambiguous(text: &str) -> bool {
    let digits = text.trim();
    digits.bytes().all(|digit| digit.is_ascii_digit()) && digits.trim_start_matches('0').len() > 1
}
