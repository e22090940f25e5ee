//! Lost network.

use jaka_proto::Request;

use super::{Draft, Outcome, accept};
use crate::state::NetworkException;
use crate::world::World;

pub(super) fn answer(request: &Request, world: &mut World, out: &mut Draft<'_>) -> Outcome {
    let state = &mut world.state;
    match request {
        Request::SetNetworkExceptionHandle(command) => {
            state.network_exception = NetworkException { delay_ms: command.delay, action: command.action };
            accept(command, out)
        }
        _ => Outcome::Unhandled,
    }
}
