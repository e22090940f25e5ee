//! Kinematics and current position.
//!
//! Poses are those of the selected tool frame in the selected user frame, so that the computations and `get_tcp_pos` agree.

use jaka_proto::Request;

use super::{Draft, Outcome, reply};
use crate::world::World;

pub(super) fn answer(request: &Request, world: &mut World, out: &mut Draft<'_>) -> Outcome {
    let state = &world.state;
    match request {
        Request::GetJointPos(command) => {
            reply(command, out, |reply| reply.joint_position = state.joint_commanded_position)
        }
        Request::GetTcpPos(command) => reply(command, out, |reply| reply.pose = state.tcp_commanded_pose),
        Request::GetActualJointPos(command) => reply(command, out, |reply| reply.joint_position = state.joint_position),
        Request::GetActualTcpPos(command) => reply(command, out, |reply| reply.pose = state.tcp_pose),
        Request::GetDhParam(command) => reply(command, out, |reply| *reply = state.dh_parameters),
        Request::KineForward(command) => reply(command, out, |reply| reply.pose = world.pose(command.joint_position.0)),
        Request::KineInverse(command) => {
            let flange = world.flange(command.pose);
            match world.model.inverse(flange, command.reference_joint_position) {
                Ok(joints) => reply(command, out, |reply| reply.joint_position = joints),
                Err(_) => Outcome::Refused,
            }
        }
        _ => Outcome::Unhandled,
    }
}
