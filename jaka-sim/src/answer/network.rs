//! Lost network.

use jaka_proto::Request;
use jaka_proto::wire::Writer;

use super::{Outcome, accept};
use crate::state::NetworkException;
use crate::world::World;

pub(super) fn answer(request: &Request, world: &mut World, out: &mut Writer) -> Outcome {
    let state = &mut world.state;
    match request {
        Request::SetNetworkExceptionHandle(command) => {
            state.network_exception = NetworkException { delay_ms: command.delay, action: command.action };
            accept(command, out)
        }
        _ => Outcome::Unhandled,
    }
}
