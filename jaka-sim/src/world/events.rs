//! Events that are put into the error code.

use std::time::Duration;

use jaka_proto::messages::program::ProgramState;
use jaka_proto::{ControllerEvent, Severity};

use super::World;
use crate::State;

/// Codes of the vendor's table of controller events.
const ENABLED: u32 = 0x10f_0004;
const DISABLED: u32 = 0x10f_0005;
const PROTECTIVE_STOP: u32 = 0x10f_000b;
const SERVO_ON: u32 = 0x10f_0015;
const SERVO_OFF: u32 = 0x10f_0016;
const PROGRAM_STARTS: u32 = 0x10f_001b;

/// Time for which information stays in the error code: a capture has one entry of a log for 257 ms.
const INFORMATION: Duration = Duration::from_millis(256);

/// What was so when events were last reported.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[expect(clippy::struct_excessive_bools, reason = "each is a fact of its own")]
pub(super) struct Reported {
    enabled: bool,
    servo_mode: bool,
    program: bool,
    protective_stop: bool,
}

impl World {
    /// Puts what has happened into the error code, if that is a habit and the code is not that of an error.
    pub(super) fn report_events(&mut self) {
        let now = Reported {
            enabled: self.state.enabled,
            servo_mode: self.state.servo_mode,
            program: self.state.program_state != ProgramState::Idle,
            protective_stop: self.state.protective_stop,
        };
        let before = std::mem::replace(&mut self.seen, now);
        let happened = [
            (before.servo_mode, now.servo_mode, SERVO_ON, Some(SERVO_OFF)),
            (before.enabled, now.enabled, ENABLED, Some(DISABLED)),
            (before.program, now.program, PROGRAM_STARTS, None),
            (before.protective_stop, now.protective_stop, PROTECTIVE_STOP, None),
        ];
        for (before, now, begins, ends) in happened {
            let event = if now { Some(begins) } else { ends };
            if let Some(event) = event.filter(|_| before != now && self.habits.events && !has_error(&self.state)) {
                self.state.report(event);
                self.event_ends = Some(self.now + INFORMATION);
            }
        }
    }

    /// Takes information out of the error code when its time is over.
    pub(super) fn end_information(&mut self) {
        if self.event_ends.take_if(|ends| *ends <= self.now).is_some() && !has_error(&self.state) {
            self.state.clear_error();
        }
    }
}

/// True where the error code has something else than information.
fn has_error(state: &State) -> bool {
    let event = ControllerEvent::from_text(&state.error_code);
    event.map_or(true, |event| event.is_some_and(|event| event.severity() != Severity::Information))
}
