//! Changes from one status packet to the next.

use std::collections::{BTreeMap, BTreeSet};
use std::time::Duration;

use jaka_sync::proto::wire::DecodeError;
use serde_json::Value;

use super::super::happenings::{Happening, HappeningKind};
use crate::failure::chain;
use crate::packets::event;
use crate::packets::fields::plain;
use crate::packets::flags::{Flags, Tone};
use crate::packets::packed_status::PackedStatus;

/// Changes from one status packet to the next.
#[derive(Debug, Default)]
pub(super) struct Changes {
    pub(super) happenings: Vec<Happening>,
    flags: Flags,
    error_code: Option<String>,
    /// Values of fields not drawn.
    values: BTreeMap<String, Value>,
    /// Fields reported not to fit.
    unfit: BTreeSet<String>,
    /// Whether the last message was unreadable.
    is_unreadable: bool,
}

impl Changes {
    pub(super) fn see(&mut self, time: Duration, packet: &PackedStatus) {
        self.is_unreadable = false;
        let status = &packet.status;
        self.happenings.extend(self.flags.see(status).into_iter().map(|(tone, what)| Happening {
            time,
            kind: HappeningKind::State,
            what: what.to_owned(),
            is_wrong: tone == Tone::Bad,
        }));
        self.see_event(time, status.error_code.as_deref(), status.error_message.as_deref());
        self.see_unfit(time, &packet.unfit);
    }

    fn see_event(&mut self, time: Duration, code: Option<&str>, message: Option<&str>) {
        let Some(code) = code.filter(|code| self.error_code.as_deref() != Some(*code)) else { return };
        self.error_code = Some(code.to_owned());
        let event = event::read(Some(&code.into()));
        let Some(description) = event::describe(&event) else { return };
        let message = message.filter(|message| !message.is_empty()).map(|message| format!(": {message}"));
        let severity = event::severity(&event);
        let is_wrong = severity.is_some_and(|severity| !matches!(severity, jaka_sync::Severity::Information));
        let remedy = event::remedy(&event)
            .filter(|remedy| is_wrong && !remedy.of_family)
            .map(|remedy| format!("; remedy: {remedy}"));
        let what = format!("{code} ({description}){}{}", message.unwrap_or_default(), remedy.unwrap_or_default());
        self.happenings.push(Happening { time, kind: HappeningKind::ControllerEvent, what, is_wrong });
    }

    /// Takes the value of a field that is not drawn, and reports its changes.
    pub(super) fn see_value(&mut self, time: Duration, name: &str, value: &Value) {
        if self.values.get(name) != Some(value) {
            self.values.insert(name.to_owned(), value.clone());
            self.happenings.push(Happening::usual(time, HappeningKind::State, format!("{name} {}", plain(value))));
        }
    }

    fn see_unfit(&mut self, time: Duration, unfit: &[DecodeError]) {
        for error in unfit.iter().filter(|error| self.unfit.insert(error.field().to_owned())) {
            let what = format!("a status packet does not fit the spec: {error}");
            self.happenings.push(Happening::wrong(time, HappeningKind::Packets, what));
        }
    }

    /// Takes a message that is not a packet, and reports the first of several.
    pub(super) fn unreadable(&mut self, time: Duration, error: &DecodeError) {
        if !std::mem::replace(&mut self.is_unreadable, true) {
            let what = format!("a message of the status port is not a packet: {}", chain(error));
            self.happenings.push(Happening::wrong(time, HappeningKind::Packets, what));
        }
    }
}
