//! Events that are put into the error code.
//!
//! Codes and what they are about are those of the vendor's table of controller events; the messages are our own.

use jaka_proto::messages::program::ProgramState;

use super::World;
use crate::state::NO_ERROR;

const ENABLED: Event = Event { code: "0x10f0004", message: "the robot is enabled" };
const DISABLED: Event = Event { code: "0x10f0005", message: "the robot is disabled" };
const SERVO_ON: Event = Event { code: "0x10f0015", message: "servo mode is on" };
const SERVO_OFF: Event = Event { code: "0x10f0016", message: "servo mode is off" };
const PROGRAM_STARTS: Event = Event { code: "0x10f001b", message: "a program starts" };

/// Something that a controller reports and that is not an error.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Event {
    code: &'static str,
    message: &'static str,
}

/// What was so when events were last reported.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Reported {
    enabled: bool,
    servo_mode: bool,
    program: bool,
}

impl World {
    /// Puts what has happened into the error code, if that is a habit and the code is not that of an error.
    pub(super) fn report_events(&mut self) {
        let now = Reported {
            enabled: self.state.enabled,
            servo_mode: self.state.servo_mode,
            program: self.state.program_state != ProgramState::Idle,
        };
        let before = std::mem::replace(&mut self.seen, now);
        let happened = [
            (before.servo_mode, now.servo_mode, SERVO_ON, Some(SERVO_OFF)),
            (before.enabled, now.enabled, ENABLED, Some(DISABLED)),
            (before.program, now.program, PROGRAM_STARTS, None),
        ];
        for (before, now, begins, ends) in happened {
            let event = if now { Some(begins) } else { ends };
            if let Some(event) = event.filter(|_| before != now && self.habits.events && !self.has_error()) {
                event.code.clone_into(&mut self.state.error_code);
                event.message.clone_into(&mut self.state.error_message);
            }
        }
    }

    /// True where the error code has something else than information.
    fn has_error(&self) -> bool {
        let events = [ENABLED, DISABLED, SERVO_ON, SERVO_OFF, PROGRAM_STARTS].map(|event| event.code);
        self.state.error_code != NO_ERROR && !events.contains(&&*self.state.error_code)
    }
}
