//! Motions that can be waited for.

use jaka_proto::Command;
use jaka_proto::messages::force::StartTorqSensorPayloadIdentify;
use jaka_proto::messages::motion::{EndMove, JointMove, MoveC, MoveL};
use jaka_proto::messages::types::{JointPosition, MoveMode};

/// A planned motion: one whose reply says that it was accepted, and whose end the status shows.
pub trait Motion: Command<Reply = ()> {
    /// The joints at its end, where the request tells them. A motion that does not end there was stopped.
    fn target(&self) -> Option<JointPosition>;
}

impl Motion for JointMove {
    /// Known for a motion to a position; an offset starts where the motion before it ends.
    fn target(&self) -> Option<JointPosition> {
        (self.mode == MoveMode::Absolute).then_some(self.joint_position)
    }
}

impl Motion for StartTorqSensorPayloadIdentify {
    fn target(&self) -> Option<JointPosition> {
        Some(self.joint_position)
    }
}

/// Not known: in which frame the status gives its pose is not documented.
macro_rules! cartesian {
    ($($type:ident),*) => {$(
        impl Motion for $type {
            fn target(&self) -> Option<JointPosition> {
                None
            }
        }
    )*};
}

cartesian!(EndMove, MoveL, MoveC);
