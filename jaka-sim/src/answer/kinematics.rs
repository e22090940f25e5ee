//! Kinematics and present position. The two computations are left to the spec's examples.

use jaka_proto::Request;
use jaka_proto::messages::kinematics::{GetJointPosReply, GetTcpPosReply};
use jaka_proto::wire::Writer;

use super::{Outcome, reply};
use crate::State;

pub(super) fn answer(request: &Request, state: &mut State, out: &mut Writer) -> Outcome {
    match request {
        Request::GetJointPos(command) => reply(command, GetJointPosReply { joint_position: state.joint_position }, out),
        Request::GetTcpPos(command) => reply(command, GetTcpPosReply { pose: state.tcp_pose }, out),
        Request::GetDhParam(command) => reply(command, state.dh_parameters, out),
        _ => Outcome::Unhandled,
    }
}
