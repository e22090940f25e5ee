//! Servo mode. Cartesian set-points are left to the spec's example.

use jaka_proto::Request;
use jaka_proto::messages::servo::IsInServomoveReply;
use jaka_proto::wire::Writer;

use super::{Outcome, accept, is_on, reply};
use crate::{State, motion};

pub(super) fn answer(request: &Request, state: &mut State, out: &mut Writer) -> Outcome {
    match request {
        Request::IsInServomove(command) => reply(command, IsInServomoveReply { in_servo_mode: state.servo_mode }, out),
        Request::ServoMove(command) => {
            state.servo_mode = is_on(command.servo_mode);
            accept(command, out)
        }
        Request::ServoJ(command) => {
            motion::move_joints(state, command.mode, command.joint_position);
            accept(command, out)
        }
        Request::SetServoMoveFilter(command) => {
            state.servo_filter = *command;
            accept(command, out)
        }
        _ => Outcome::Unhandled,
    }
}
