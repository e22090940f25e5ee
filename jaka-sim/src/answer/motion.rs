//! Jog and planned motion. Cartesian motions are left to the spec's examples.

use jaka_proto::Request;
use jaka_proto::wire::Writer;

use super::{Outcome, accept};
use crate::{State, motion};

pub(super) fn answer(request: &Request, state: &mut State, out: &mut Writer) -> Outcome {
    match request {
        Request::Jog(command) => {
            motion::jog(state, command);
            accept(command, out)
        }
        Request::JointMove(command) => {
            motion::move_joints(state, command.mode, command.joint_position);
            accept(command, out)
        }
        _ => Outcome::Unhandled,
    }
}
