//! Inputs and outputs.

use jaka_proto::Request;

use super::{Draft, Outcome, is_on, reply};
use crate::State;
use crate::world::World;

/// Outputs with this index and above are refused, so that clients cannot make the state grow without limit.
const MAX_OUTPUTS: i64 = 1024;

pub(super) fn answer(request: &Request, world: &mut World, out: &mut Draft<'_>) -> Outcome {
    let state = &mut world.state;
    match request {
        Request::SetDigitalOutput(command) if command.index < MAX_OUTPUTS => {
            state.digital_outputs.insert((command.kind, command.index), is_on(command.value));
        }
        Request::SetAnalogOutput(command) if command.index < MAX_OUTPUTS => {
            state.analog_outputs.insert((command.kind, command.index), command.value);
        }
        Request::SetDigitalOutput(_) | Request::SetAnalogOutput(_) => return Outcome::Refused,
        _ => return query(request, state, out),
    }
    Outcome::Accepted
}

fn query(request: &Request, state: &State, out: &mut Draft<'_>) -> Outcome {
    match request {
        Request::GetDigitalInputStatus(command) => {
            reply(command, out, |reply| reply.digital_inputs.clone_from(&state.digital_inputs))
        }
        Request::GetFuncdiStatus(command) => {
            reply(command, out, |reply| reply.function_inputs.clone_from(&state.function_inputs))
        }
        Request::GetExtioStatus(command) => reply(command, out, |reply| reply.extio_status.clone_from(&state.extio)),
        Request::GetDigitalOutput(command) => reply(command, out, |reply| {
            reply.value = state.digital_outputs.get(&(command.kind, command.index)).copied().unwrap_or_default();
        }),
        Request::GetAnalogOutput(command) => reply(command, out, |reply| {
            reply.value = state.analog_outputs.get(&(command.kind, command.index)).copied().unwrap_or_default();
        }),
        _ => Outcome::Unhandled,
    }
}
