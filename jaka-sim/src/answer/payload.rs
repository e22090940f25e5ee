//! Payload of the arm.

use jaka_proto::Request;

use super::{Draft, Outcome, reply};
use crate::state::Payload;
use crate::world::World;

pub(super) fn answer(request: &Request, world: &mut World, out: &mut Draft<'_>) -> Outcome {
    let state = &mut world.state;
    match request {
        Request::SetPayload(command) => {
            state.payload = Payload { mass: command.mass, centroid: command.centroid };
            Outcome::Accepted
        }
        Request::GetPayload(command) => {
            let Payload { mass, centroid } = state.payload;
            reply(command, out, |reply| (reply.mass, reply.centroid) = (mass, centroid))
        }
        _ => Outcome::Unhandled,
    }
}
