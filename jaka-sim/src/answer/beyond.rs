//! What newer firmware tells, beyond the document.

use jaka_proto::Request;
use jaka_proto::messages::program::ProgramState;

use super::{Draft, Outcome, reply};
use crate::world::World;

pub(super) fn answer(request: &Request, world: &mut World, out: &mut Draft<'_>) -> Outcome {
    let state = &world.state;
    match request {
        Request::GetMotionState(command) => reply(command, out, |reply| {
            (reply.in_position, reply.paused) = (state.in_position, state.program_state == ProgramState::Paused);
        }),
        Request::EmergencyStopStatus(command) => {
            reply(command, out, |reply| reply.emergency_stop = state.emergency_stop)
        }
        Request::GetCurrToolId(command) => reply(command, out, |reply| reply.id = state.tool_frame_id),
        Request::GetCurrUserId(command) => reply(command, out, |reply| reply.id = state.user_frame_id),
        Request::GetActualJointPos(command) => reply(command, out, |reply| reply.joint_position = state.joint_position),
        Request::GetActualTcpPos(command) => reply(command, out, |reply| reply.pose = state.tcp_pose),
        Request::GetDigitalOutput(command) => reply(command, out, |reply| {
            reply.value = state.digital_outputs.get(&(command.kind, command.index)).copied().unwrap_or_default();
        }),
        Request::GetAnalogOutput(command) => reply(command, out, |reply| {
            reply.value = state.analog_outputs.get(&(command.kind, command.index)).copied().unwrap_or_default();
        }),
        _ => Outcome::Unhandled,
    }
}
