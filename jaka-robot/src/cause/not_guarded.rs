//! Why a motion does not run under a limit of force.

use std::time::Duration;

use super::remedy::Remedy;

jaka_proto::worded! {
    /// Why a motion does not run under a limit of force: it could not be stopped within the overtravel, or that is not
    /// known.
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
            /// How long the reaction is taken to last.
            reaction: Duration,
            /// With which deceleration the tool is taken to brake, in mm/s².
            braking_mm_s2: f64,
        } =>
            "at {speed_mm_s} mm/s the tool goes on for more than {overtravel_mm} mm after a contact; permitted are {permitted_mm_s:.2} mm/s, with up to \
             {period:.1?} between packets, {reaction:.1?} of reaction and braking with {braking_mm_s2} mm/s²",
        /// A trajectory is too fast somewhere.
        TooFastAlong {
            /// The last way-point before the contact after which the tool would go on the furthest, counted from 1.
            after: usize,
            /// When that contact would be, in seconds of the trajectory.
            time_s: f64,
            /// The greatest speed of the tool from there on until it rests, in mm/s.
            speed_mm_s: f64,
            /// About the speed that is permitted there, in mm/s.
            permitted_mm_s: f64,
            /// How far the tool would go on, in mm.
            way_mm: f64,
            /// The overtravel that is allowed, in mm.
            overtravel_mm: f64,
            /// The longest time between two of the last packets.
            period: Duration,
            /// How long the reaction is taken to last.
            reaction: Duration,
            /// The even deceleration that the braking along the trajectory comes to, in mm/s².
            braking_mm_s2: f64,
        } =>
            "after way-point {after}, at {time_s:.3} s, with up to {speed_mm_s:.2} mm/s the tool goes on for {way_mm:.2} mm after a contact, \
             and {overtravel_mm} mm are allowed; permitted are {permitted_mm_s:.2} mm/s there, with up to {period:.1?} between packets, \
             {reaction:.1?} of reaction and braking with {braking_mm_s2:.0} mm/s² along it",
        /// A trajectory leaves the joints no acceleration somewhere to brake along it within 0.5 s, and leads the tool
        /// on further than the overtravel.
        CannotBrake {
            /// The last way-point before, counted from 1.
            after: usize,
            /// When the contact would be, in seconds of the trajectory.
            time_s: f64,
        } =>
            "after way-point {after}, at {time_s:.3} s, it leaves the joints no acceleration to brake along it within 0.5 s of a \
             contact",
        /// The speed of the tool centre point does not follow from the motion: only that of a line or an arc does.
        SpeedUnknown =>
            "the speed of the tool does not follow from it",
        /// The motion does not say its acceleration, and the limit says nothing of the braking.
        BrakingUnknown => "it does not say with which acceleration, from which the braking follows",
        /// The arm moves, or motions wait that were started before: what the sensor reads at the start does not count
        /// then.
        Moving => "the arm is not at rest, or another motion is waiting",
        /// Too few packets have come in time to know their period.
        PeriodUnknown => "too few status packets have come to know their period",
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
