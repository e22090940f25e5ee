//! Reasons why status packets do not show a fact, and why a motion is not guarded or not checked.

use std::error::Error as StdError;
use std::time::Duration;

use jaka_proto::messages::types::JointPosition;
use jaka_proto::wire::DecodeError;

use super::remedy::Remedy;
use crate::Snapshot;
#[cfg(feature = "serde")]
use crate::form;

jaka_proto::worded! {
    /// Reason why status packets do not show a requested fact.
    #[derive(Debug, Clone, PartialEq)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize), serde(tag = "kind", rename_all = "snake_case"))]
    #[non_exhaustive]
    pub enum NotShown {
        /// The packet does not have the field.
        Absent {
            /// Its name in [`RobotStatus`](crate::status::RobotStatus).
            field: String,
        } => "status packets of this controller do not have `{field}`",
        /// The packet has the field in a form that does not fit.
        Unfit {
            /// Error with the field and the reason.
            #[cfg_attr(feature = "serde", serde(serialize_with = "form::text"))]
            source: DecodeError,
        } => "the newest status packet cannot be read: {source}",
        /// The list does not have so many elements.
        TooShort {
            /// The list's name in [`RobotStatus`](crate::status::RobotStatus).
            field: String,
            /// Number of its elements.
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

jaka_proto::worded! {
    /// Reason why a motion does not run under a limit of force: it could not be stopped within the overtravel, or that
    /// is not known.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub enum NotGuarded {
        /// The motion is too fast.
        TooFast {
            /// The speed of the motion, in mm/s.
            speed_mm_s: f64,
            /// The speed that is permitted, in mm/s.
            permitted_mm_s: f64,
            /// The overtravel that is allowed, in mm.
            overtravel_mm: f64,
            /// The longest time between two of the last packets.
            period: Duration,
            /// Assumed duration of the reaction.
            reaction: Duration,
            /// Assumed deceleration of the tool while it brakes, in mm/s².
            braking_mm_s2: f64,
        } =>
            "at {speed_mm_s} mm/s the tool moves more than {overtravel_mm} mm after a contact; permitted are {permitted_mm_s:.2} mm/s, with up to \
             {period:.1?} between packets, {reaction:.1?} of reaction and braking with {braking_mm_s2} mm/s²",
        /// A trajectory is too fast somewhere.
        TooFastAlong {
            /// The last way-point before the contact with the longest path afterwards, counted from 1.
            after: usize,
            /// Time of that contact, in seconds of the trajectory.
            time_s: f64,
            /// The greatest speed of the tool from there on until it rests, in mm/s.
            speed_mm_s: f64,
            /// About the speed that is permitted there, in mm/s.
            permitted_mm_s: f64,
            /// Distance that the tool would travel after that contact, in mm.
            way_mm: f64,
            /// The overtravel that is allowed, in mm.
            overtravel_mm: f64,
            /// The longest time between two of the last packets.
            period: Duration,
            /// Assumed duration of the reaction.
            reaction: Duration,
            /// The even deceleration that the braking along the trajectory comes to, in mm/s².
            braking_mm_s2: f64,
        } =>
            "after way-point {after}, at {time_s:.3} s, with up to {speed_mm_s:.2} mm/s the tool moves {way_mm:.2} mm after a contact, \
             and {overtravel_mm} mm are allowed; permitted are {permitted_mm_s:.2} mm/s there, with up to {period:.1?} between packets, \
             {reaction:.1?} of reaction and braking with {braking_mm_s2:.0} mm/s² along it",
        /// A trajectory leaves the joints no acceleration somewhere to brake along it within 0.5 s, and moves the tool
        /// further than the overtravel.
        CannotBrake {
            /// The last way-point before it, counted from 1.
            after: usize,
            /// Time of the contact, in seconds of the trajectory.
            time_s: f64,
        } =>
            "after way-point {after}, at {time_s:.3} s, the trajectory leaves the joints no acceleration to brake along it within 0.5 s of a \
             contact",
        /// The motion does not determine the speed of the tool centre point: only a line or an arc does.
        SpeedUnknown =>
            "the request does not determine the speed of the tool",
        /// The motion does not say its acceleration, and the limit says nothing of the braking.
        BrakingUnknown => "the request has no acceleration, which determines the braking distance",
        /// The arm moves, or motions wait that were started before: the sensor's values at the start do not count then.
        Moving => "the arm is not at rest, or another motion is waiting",
        /// Too few packets have come in time to know their period.
        PeriodUnknown => "the period of status packets is not known yet",
    }
}

impl NotGuarded {
    /// Remedy.
    pub fn remedy(&self) -> Remedy {
        match self {
            Self::TooFast { .. } | Self::TooFastAlong { .. } | Self::CannotBrake { .. } => Remedy::MoveMoreSlowly,
            Self::SpeedUnknown => Remedy::MoveOnLine,
            Self::BrakingUnknown => Remedy::GiveAcceleration,
            Self::Moving => Remedy::WaitForMotions,
            Self::PeriodUnknown => jaka_sync::Remedy::WaitForPackets.into(),
        }
    }
}

impl std::error::Error for NotGuarded {}

jaka_proto::worded! {
    /// Reason why a motion or a set-point could not be checked against the limits.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    #[non_exhaustive]
    pub enum Unchecked {
        /// The start is not known: the arm moves, or the motion follows one with an unknown end. Wait for the end of
        /// all motions.
        Start => "the start of the motion is not known",
        /// The request does not determine the end of the motion, such as an arc by offsets or a relative motion with a
        /// rotation. Give an absolute target.
        Target => "the request does not determine the end of the motion",
        /// The request does not determine its path: name the `path` in the `[command.motion]` of a pack, or send it
        /// without limits.
        Path => "the request does not determine the path of the arm",
        /// The controller's pose of the arm does not fit its joint positions, for the frames that its `kine_forward`
        /// shows: a frame was changed at this moment, or the arm moved.
        Frames => "the arm's pose does not fit its joint positions: a frame is changing, or the arm moves",
        /// A motion before it has not been waited for, and a frame was changed since. Wait for its end.
        FramesInQueue => "a frame was changed after a motion that has not ended",
        /// The robot has no limits, by which streams and trajectories know the arm: see
        /// [`RobotConfig::limits`](crate::RobotConfig::limits).
        NoLimits =>
            "the robot has no limits, and streams and trajectories need them",
    }
}

impl Unchecked {
    /// Remedy.
    pub fn remedy(self) -> Remedy {
        match self {
            Self::Start | Self::FramesInQueue => Remedy::WaitForMotions,
            Self::Target => Remedy::GiveAbsoluteTarget,
            Self::Path => Remedy::None,
            Self::Frames => jaka_sync::Remedy::TryAgain.into(),
            Self::NoLimits => Remedy::GiveLimits,
        }
    }
}
