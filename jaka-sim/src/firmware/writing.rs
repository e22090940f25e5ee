//! Forms in which a firmware writes what it says.

use jaka_proto::wire::{Value, Writer};
use jaka_proto::{ControllerEvent, Envelope, ErrorCode};
use jaka_spec::{COMMAND_NAME, ERROR_CODE, ERROR_MESSAGE, Spec};

use super::Values;
use crate::State;
use crate::json_text::{Separators, members, respace};

/// A key that nobody knows, as newer firmware may add one.
const UNKNOWN: &str = r#""oddity":[null,{"a":[]}]"#;

/// Forms in which a firmware writes what it says, on both ports.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Writing {
    /// As the document prints it, and as short as may be.
    Document,
    /// As captures have it: numbers that may have a fraction with one, positions with few decimals, the controller's event.
    Capture,
    /// The same, with truth values in replies as in packets.
    AsPackets,
    /// Otherwise, in all ways that were seen.
    Odd,
}

impl Writing {
    /// What stands between the parts.
    pub(crate) fn separators(self) -> Separators {
        if self == Self::Document { Separators::Compact } else { Separators::Spaced }
    }

    /// The controller's event as `get_robot_state` answers it; none where it does not.
    ///
    /// The vendor's SDK 2.1.14 reads no other form than a number.
    pub(crate) fn event(self, state: &State) -> Option<Value> {
        match self {
            Self::Document => None,
            Self::Capture | Self::AsPackets => {
                let event = ControllerEvent::from_text(&state.error_code).ok().flatten();
                Some(event.map_or(0, ControllerEvent::code).into())
            }
            Self::Odd => Some(state.error_code.as_str().into()),
        }
    }

    /// A key that nobody knows and its value, where there is one.
    pub(crate) fn unknown_key(self) -> Option<&'static str> {
        (self == Self::Odd).then_some(UNKNOWN)
    }

    /// Rewrites a reply, which was written as the document does. What is not a JSON object stays as it is.
    pub(crate) fn rewrite(self, spec: &Spec, reply: &mut Writer) {
        if self == Self::Document {
            return;
        }
        if let Some(text) = self.rewritten(spec, reply.as_str()) {
            reply.clear();
            reply.raw(&text);
        }
    }

    fn rewritten(self, spec: &Spec, reply: &str) -> Option<String> {
        let envelope = Envelope::read(reply).ok()?;
        let command = envelope.command.as_deref().and_then(|name| spec.command(name));
        let fields = command.map_or(&[][..], |command| spec.reply_fields(command));
        let values = Values::of_replies(spec, self);
        let is_odd = self == Self::Odd;
        let is_success = envelope.code.as_ref().is_ok_and(|code| code.is_success());
        let mut rewritten = Vec::new();
        for (key, json) in members(reply)? {
            let mut out = Writer::new();
            out.text(&key);
            out.raw(":");
            match &*key {
                ERROR_CODE => match envelope.code.as_ref().ok().and_then(|code| self.code(*code)) {
                    Some(code) => out.json(&code),
                    None => out.raw(json),
                },
                ERROR_MESSAGE if is_odd && is_success => continue,
                COMMAND_NAME if is_odd => out.text(&format!(" {} ", envelope.command.as_deref().unwrap_or_default())),
                key => match fields.iter().find(|field| field.wire == key) {
                    Some(field) => values.field(field, json, &mut out),
                    None => out.raw(json),
                },
            }
            rewritten.push(out.into_string());
        }
        rewritten.extend(self.unknown_key().map(str::to_owned));
        if is_odd {
            rewritten.reverse();
        }
        Some(respace(&format!("{{{}}}", rewritten.join(",")), self.separators()))
    }

    /// An error code that is not written as the document does. Of negative codes no hexadecimal form is known.
    fn code(self, code: ErrorCode) -> Option<Value> {
        match self {
            Self::Document | Self::Capture | Self::AsPackets => None,
            Self::Odd if code.0 > 0 => Some(format!("{:#x}", code.0).into()),
            Self::Odd => Some(code.0.into()),
        }
    }
}
