//! Payload of the arm.

use jaka_proto::Request;
use jaka_proto::messages::payload::literal;
use jaka_proto::wire::Writer;

use super::{Outcome, accept, reply};
use crate::state::Payload;
use crate::world::World;

pub(super) fn answer(request: &Request, world: &mut World, out: &mut Writer) -> Outcome {
    let state = &mut world.state;
    match request {
        Request::SetPayload(command) => {
            state.payload = Payload { mass: command.mass, centroid: command.centroid };
            accept(command, out)
        }
        Request::GetPayload(command) => {
            let Payload { mass, centroid } = state.payload;
            reply(command, literal::GetPayloadReply { centroid, mass }, out)
        }
        _ => Outcome::Unhandled,
    }
}
