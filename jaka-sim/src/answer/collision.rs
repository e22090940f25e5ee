//! Collision detection and protective stop.

use jaka_proto::Request;
use jaka_proto::messages::collision::literal;
use jaka_proto::wire::Writer;

use super::{Outcome, accept, reply};
use crate::world::World;

pub(super) fn answer(request: &Request, world: &mut World, out: &mut Writer) -> Outcome {
    let state = &mut world.state;
    match request {
        Request::ProtectiveStopStatus(command) => {
            reply(command, literal::ProtectiveStopStatusReply { protective_stop: state.protective_stop }, out)
        }
        Request::SetClsnSensitivity(command) => {
            state.collision_level = command.level;
            accept(command, out)
        }
        Request::GetClsnSensitivity(command) => {
            reply(command, literal::GetClsnSensitivityReply { level: state.collision_level }, out)
        }
        Request::ClearError(command) => {
            state.protective_stop = false;
            state.clear_error();
            accept(command, out)
        }
        _ => Outcome::Unhandled,
    }
}
