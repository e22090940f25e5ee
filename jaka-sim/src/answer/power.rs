//! Power, enabling and the controller's state.

use jaka_proto::Request;
use jaka_proto::messages::power::{EnableRobotReply, GetRobotStateReply, GetVersionReply, PowerOnReply};
use jaka_proto::wire::Writer;

use super::{Outcome, accept, reply};
use crate::State;

pub(super) fn answer(request: &Request, state: &mut State, out: &mut Writer) -> Outcome {
    match request {
        Request::PowerOn(command) => {
            state.powered = true;
            let mut powered = PowerOnReply::default();
            powered.powered_on = Some(true);
            reply(command, powered, out)
        }
        Request::PowerOff(command) => {
            state.powered = false;
            accept(command, out)
        }
        Request::EnableRobot(command) => {
            state.enabled = true;
            let mut enabled = EnableRobotReply::default();
            enabled.enabled = Some(true);
            reply(command, enabled, out)
        }
        Request::DisableRobot(command) => {
            state.enabled = false;
            accept(command, out)
        }
        Request::Shutdown(command) => {
            state.powered = false;
            accept(command, out)
        }
        Request::GetRobotState(command) => reply(command, robot_state(state), out),
        Request::GetVersion(command) => reply(command, GetVersionReply { version: state.version.clone() }, out),
        _ => Outcome::Unhandled,
    }
}

/// As old firmware answers; newer firmware adds the error.
fn robot_state(state: &State) -> GetRobotStateReply {
    GetRobotStateReply { enabled: state.enabled, powered_on: state.powered, error_code: None, error_message: None }
}
