//! What motion commands do to the arm.
//!
//! There is no physics yet: every motion of the joints has ended when it is answered, and there are no kinematics, so
//! Cartesian motions go nowhere. The arm's motion over time will be built here.

use jaka_proto::messages::motion::{Jog, JogFrame};
use jaka_proto::messages::types::{JointPosition, MoveMode};

use crate::State;

/// Moves all joints to a position, or by an offset.
pub(crate) fn move_joints(state: &mut State, mode: MoveMode, values: JointPosition) {
    match mode {
        MoveMode::Relative => {
            for (joint, offset) in state.joint_position.0.iter_mut().zip(values.0) {
                *joint += offset;
            }
        }
        _ => state.joint_position = values,
    }
}

/// Jogs one joint by a distance or to a position. A continuous jog needs time, and goes nowhere as yet.
pub(crate) fn jog(state: &mut State, jog: &Jog) {
    match *jog {
        Jog::Increment { frame: JogFrame::Joint, axis, distance, .. } => {
            if let Some(joint) = joint(state, axis) {
                *joint += distance;
            }
        }
        Jog::Absolute { frame: JogFrame::Joint, axis, position, .. } => {
            if let Some(joint) = joint(state, axis) {
                *joint = position;
            }
        }
        _ => {}
    }
}

fn joint(state: &mut State, axis: i64) -> Option<&mut f64> {
    state.joint_position.0.get_mut(usize::try_from(axis).ok()?)
}
