//! What status packets do not show.

use std::error::Error as StdError;

use jaka_proto::messages::types::JointPosition;
use jaka_proto::wire::DecodeError;

use super::remedy::Remedy;
use crate::Snapshot;

jaka_proto::worded! {
    /// Why status packets do not show what is asked of them.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub enum NotShown {
        /// The packet does not have the field.
        Absent {
            /// Its name in [`RobotStatus`](crate::status::RobotStatus).
            field: String,
        } => "status packets of this controller do not have `{field}`",
        /// The packet has the field in a form that does not fit.
        Unfit {
            /// Which field, and why.
            source: DecodeError,
        } => "the newest status packet cannot be read: {source}",
        /// The list does not have so many elements.
        TooShort {
            /// The list's name in [`RobotStatus`](crate::status::RobotStatus).
            field: String,
            /// How many it has.
            count: usize,
        } => "`{field}` of the status packet has {count} elements",
        /// The force sensor does not report that it works: switch it on.
        SensorOff => "the sensor does not report that it works",
        /// The force sensor reports an error.
        SensorError {
            /// Its code, as the controller writes it.
            code: String,
        } => "the sensor reports error {code}",
    }
}

impl NotShown {
    /// Remedy.
    pub fn remedy(&self) -> Remedy {
        match self {
            Self::SensorOff => Remedy::SwitchSensorOn,
            Self::Absent { .. } | Self::Unfit { .. } | Self::TooShort { .. } | Self::SensorError { .. } => Remedy::None,
        }
    }
}

impl StdError for NotShown {}

/// The joints of a packet.
pub(crate) fn shown_joints(packet: &Snapshot) -> Result<JointPosition, NotShown> {
    Field { packet, name: "joint_actual_position" }.shown(packet.status.joint_actual_position)
}

/// A field of a packet.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Field<'p> {
    pub(crate) packet: &'p Snapshot,
    pub(crate) name: &'static str,
}

impl Field<'_> {
    /// Its value, or why there is none.
    pub(crate) fn shown<T>(self, value: Option<T>) -> Result<T, NotShown> {
        value.ok_or_else(|| {
            let unfit = self.packet.unfit.iter().find(|error| error.is_in(self.name));
            match unfit {
                Some(source) => NotShown::Unfit { source: source.clone() },
                None => NotShown::Absent { field: self.name.to_owned() },
            }
        })
    }
}
