//! Lost network.

use jaka_proto::Request;

use super::{Draft, Outcome};
use crate::state::NetworkException;
use crate::world::World;

pub(super) fn answer(request: &Request, world: &mut World, _out: &mut Draft<'_>) -> Outcome {
    let Request::SetNetworkExceptionHandle(command) = request else { return Outcome::Unhandled };
    world.state.network_exception = NetworkException { delay_ms: command.delay, action: command.action };
    Outcome::Accepted
}
