//! Payload of the arm.

use jaka_proto::Request;

use super::{Draft, Outcome, reply};
use crate::world::World;

pub(super) fn answer(request: &Request, world: &mut World, out: &mut Draft<'_>) -> Outcome {
    let state = &mut world.state;
    match request {
        Request::SetPayload(command) => {
            (state.payload.mass, state.payload.centroid) = (command.mass, command.centroid);
            Outcome::Accepted
        }
        Request::GetPayload(command) => reply(command, out, |reply| *reply = state.payload),
        _ => Outcome::Unhandled,
    }
}
