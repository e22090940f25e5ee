//! Collision detection, protective stop and emergency stop.

use jaka_proto::Request;

use super::{Draft, Outcome, reply};
use crate::world::World;

pub(super) fn answer(request: &Request, world: &mut World, out: &mut Draft<'_>) -> Outcome {
    let state = &mut world.state;
    match request {
        Request::ProtectiveStopStatus(command) => {
            reply(command, out, |reply| reply.protective_stop = state.protective_stop)
        }
        // The levels of newer firmware.
        Request::EmergencyStopStatus(command) => {
            reply(command, out, |reply| reply.emergency_stop = state.emergency_stop)
        }
        Request::SetClsnSensitivity(command) if !(0..=7).contains(&command.level) => Outcome::Refused,
        Request::SetClsnSensitivity(command) => {
            state.collision_level = command.level;
            Outcome::Accepted
        }
        Request::GetClsnSensitivity(command) => reply(command, out, |reply| reply.level = state.collision_level),
        Request::ClearError(_) => {
            state.protective_stop = false;
            state.clear_error();
            Outcome::Accepted
        }
        _ => Outcome::Unhandled,
    }
}
