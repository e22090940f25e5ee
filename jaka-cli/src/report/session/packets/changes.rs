//! What changed from one status packet to the next.

use std::time::Duration;

use jaka_sync::proto::wire::DecodeError;

use super::super::happenings::{Happening, Kind};
use crate::event;
use crate::failure::chain;
use crate::packed_status::PackedStatus;

/// What changed from one status packet to the next.
#[derive(Debug, Default)]
pub(super) struct Changes {
    pub(super) happenings: Vec<Happening>,
    protective_stop: Option<bool>,
    emergency_stop: Option<bool>,
    powered_on: Option<bool>,
    enabled: Option<bool>,
    error_code: Option<String>,
    /// Fields that were told not to fit.
    unfit: Vec<String>,
    /// Whether the last message could not be read.
    is_unreadable: bool,
}

impl Changes {
    pub(super) fn see(&mut self, time: Duration, packet: &PackedStatus) {
        self.is_unreadable = false;
        let status = &packet.status;
        let happenings = &mut self.happenings;
        let mut change = |last: &mut Option<bool>, now: Option<bool>, [on, off]: [&str; 2], wrong: Option<bool>| {
            let Some(is_on) = now.filter(|now| *last != Some(*now)) else { return };
            let is_first = last.replace(is_on).is_none();
            let is_wrong = wrong == Some(is_on);
            // How it is at the beginning is told only if something is wrong.
            if is_wrong || !is_first {
                let what = if is_on { on } else { off }.to_owned();
                happenings.push(Happening { time, kind: Kind::State, what, is_wrong });
            }
        };
        change(
            &mut self.protective_stop,
            status.protective_stop,
            ["protective stop", "no protective stop any more"],
            Some(true),
        );
        change(
            &mut self.emergency_stop,
            status.emergency_stop,
            ["emergency stop", "no emergency stop any more"],
            Some(true),
        );
        change(&mut self.powered_on, status.powered_on, ["power on", "power off"], None);
        change(&mut self.enabled, status.enabled, ["enabled", "disabled"], None);
        self.see_event(time, status.error_code.as_deref(), status.error_message.as_deref());
        self.see_unfit(time, &packet.unfit);
    }

    fn see_event(&mut self, time: Duration, code: Option<&str>, message: Option<&str>) {
        let Some(code) = code.filter(|code| self.error_code.as_deref() != Some(*code)) else { return };
        self.error_code = Some(code.to_owned());
        let event = event::read(Some(&code.into()));
        let Some(description) = event::describe(&event) else { return };
        let message = message.filter(|message| !message.is_empty()).map(|message| format!(": {message}"));
        let what = format!("{code} ({description}){}", message.unwrap_or_default());
        let severity = event::severity(&event);
        let is_wrong = severity.is_some_and(|severity| !matches!(severity, jaka_sync::Severity::Information));
        self.happenings.push(Happening { time, kind: Kind::ControllerEvent, what, is_wrong });
    }

    fn see_unfit(&mut self, time: Duration, unfit: &[DecodeError]) {
        for error in unfit {
            if !self.unfit.iter().any(|told| told == error.field()) {
                self.unfit.push(error.field().to_owned());
                let what = format!("a status packet does not fit the spec: {error}");
                self.happenings.push(Happening::wrong(time, Kind::Packets, what));
            }
        }
    }

    /// A message that is not a packet: the first of several is told.
    pub(super) fn unreadable(&mut self, time: Duration, error: &DecodeError) {
        if !std::mem::replace(&mut self.is_unreadable, true) {
            let what = format!("a message of the status port is not a packet: {}", chain(error));
            self.happenings.push(Happening::wrong(time, Kind::Packets, what));
        }
    }
}
