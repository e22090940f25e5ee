//! Power, enabling and the controller's state.

use jaka_proto::Request;
use jaka_proto::messages::power::literal;
use jaka_proto::wire::Writer;

use super::{Outcome, accept, reply};
use crate::State;
use crate::world::{Change, World};

pub(super) fn answer(request: &Request, world: &mut World, out: &mut Writer) -> Outcome {
    match request {
        Request::PowerOn(command) => {
            if !world.state.powered {
                world.later(world.delays.power_on, Change::PoweredOn);
            }
            reply(command, literal::PowerOnReply { powered_on: Some(true) }, out)
        }
        Request::EnableRobot(command) => {
            if !world.state.enabled {
                world.later(world.delays.enable, Change::Enabled);
            }
            reply(command, literal::EnableRobotReply { enabled: Some(true) }, out)
        }
        Request::PowerOff(command) => {
            switch_off(world);
            accept(command, out)
        }
        Request::Shutdown(command) => {
            switch_off(world);
            accept(command, out)
        }
        Request::DisableRobot(command) => {
            world.cancel_changes(|change| change != Change::PoweredOn);
            world.state.enabled = false;
            accept(command, out)
        }
        Request::GetRobotState(command) => reply(command, robot_state(&world.state), out),
        Request::GetVersion(command) => {
            reply(command, literal::GetVersionReply { version: world.state.version.clone() }, out)
        }
        _ => Outcome::Unhandled,
    }
}

fn switch_off(world: &mut World) {
    world.cancel_changes(|_| true);
    world.state.powered = false;
}

/// As the document has it; firmware that answers the event too does so by its style.
fn robot_state(state: &State) -> literal::GetRobotStateReply {
    literal::GetRobotStateReply {
        enabled: state.enabled,
        powered_on: state.powered,
        error_code: None,
        error_message: None,
    }
}
