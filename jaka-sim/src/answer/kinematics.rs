//! Kinematics and present position.
//!
//! Poses are those of the tool frame in use, seen from the user frame in use, so that the computations and `get_tcp_pos` agree.

use jaka_proto::Request;
use jaka_proto::messages::kinematics::literal;
use jaka_proto::wire::Writer;

use super::{Outcome, reply};
use crate::world::World;

pub(super) fn answer(request: &Request, world: &mut World, out: &mut Writer) -> Outcome {
    let state = &world.state;
    match request {
        Request::GetJointPos(command) => {
            reply(command, literal::GetJointPosReply { joint_position: state.joint_commanded_position }, out)
        }
        Request::GetTcpPos(command) => reply(command, literal::GetTcpPosReply { pose: state.tcp_commanded_pose }, out),
        Request::GetDhParam(command) => reply(command, state.dh_parameters, out),
        Request::KineForward(command) => {
            reply(command, literal::KineForwardReply { pose: world.pose(command.joint_position.0) }, out)
        }
        Request::KineInverse(command) => {
            let flange = world.flange(command.pose);
            match world.model.inverse(&flange, command.reference_joint_position.0) {
                Some(joints) => reply(command, literal::KineInverseReply { joint_position: joints.into() }, out),
                None => Outcome::Refused,
            }
        }
        _ => Outcome::Unhandled,
    }
}
