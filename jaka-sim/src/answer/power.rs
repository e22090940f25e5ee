//! Power, enabling and the controller's state.

use jaka_proto::Request;

use super::{Draft, Outcome, reply};
use crate::world::{Change, World};

pub(super) fn answer(request: &Request, world: &mut World, out: &mut Draft<'_>) -> Outcome {
    match request {
        Request::PowerOn(command) => {
            if !world.state.powered {
                world.later(world.delays.power_on, Change::PoweredOn);
            }
            reply(command, out, |reply| reply.powered_on = Some(true))
        }
        Request::EnableRobot(command) => {
            if !world.state.enabled {
                world.later(world.delays.enable, Change::Enabled);
            }
            reply(command, out, |reply| reply.enabled = Some(true))
        }
        Request::PowerOff(_) | Request::Shutdown(_) => {
            world.cancel_changes(|_| true);
            world.state.powered = false;
            Outcome::Accepted
        }
        // Events 0x0F003A and 0x0F0027.
        Request::DisableRobot(_) if world.is_moving() || world.runner.is_some() => Outcome::Refused,
        Request::DisableRobot(_) => {
            world.cancel_changes(|change| change != Change::PoweredOn);
            world.state.enabled = false;
            Outcome::Accepted
        }
        Request::GetRobotState(command) => reply(command, out, |reply| {
            let (state, event) = (&world.state, world.writing.event(&world.state));
            (reply.powered_on, reply.enabled) = (state.powered, state.enabled);
            reply.error_message = event.is_some().then(|| state.error_message.clone());
            reply.error_code = event;
        }),
        Request::GetVersion(command) => reply(command, out, |reply| reply.version.clone_from(&world.state.version)),
        _ => Outcome::Unhandled,
    }
}
