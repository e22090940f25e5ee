//! User-defined system variables.

use jaka_proto::Request;

use super::{Draft, Outcome, reply};
use crate::world::World;

pub(super) fn answer(request: &Request, world: &mut World, out: &mut Draft<'_>) -> Outcome {
    let state = &mut world.state;
    match request {
        Request::QueryUserDefinedVariable(command) => {
            reply(command, out, |reply| reply.variables.clone_from(&state.variables))
        }
        Request::ModifyUserDefinedVariable(command) => {
            let Some(variable) = state.variables.iter_mut().find(|variable| variable.id == command.id) else {
                return Outcome::Refused;
            };
            variable.alias.clone_from(&command.alias);
            variable.value = command.value;
            Outcome::Accepted
        }
        _ => Outcome::Unhandled,
    }
}
