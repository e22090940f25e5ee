//! Paths from one point of a trajectory to the next, and the requested speeds.

use std::ops::RangeInclusive;

use super::TrajectoryError;
use super::curve_path::CurvePath;
use super::line::Line;
use crate::checker::Checker;
use crate::limits::RATES;

/// Path between two points: straight in joint space, on a line of the tool, or a curve.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Leg {
    /// Number of the way-point at its start, from 1.
    pub(super) after: usize,
    /// Length in degrees, of all joints together; for a line of the tool in mm, with [`TURN_MM`] for each radian.
    pub(super) length: f64,
    /// Joints at its start.
    pub(super) start: [f64; 6],
    pub(super) path: LegPath,
    pub(super) speeds: LegSpeeds,
    /// Tolerances within which the corner at its end may be rounded.
    pub(super) corner: Tolerances,
}

/// Highest speeds on a leg.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct LegSpeeds {
    /// Speed of the tool centre point, in mm/s.
    pub(super) tcp_speed: f64,
    /// Speeds of the joints, in deg/s.
    pub(super) joint_speeds: [f64; 6],
}

/// Path of a leg, for each unit of its length.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum LegPath {
    Joints([f64; 6]),
    Tool(Line),
    Curve(CurvePath),
}

/// Requested speeds and jerks.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct SpeedSettings {
    pub(super) speeds: LegSpeeds,
    /// Jerks in deg/s³.
    pub(super) jerks: Option<[f64; 6]>,
    /// Share of each joint's acceleration that bends leave for changes of the rate.
    pub(super) reserve: f64,
}

/// Speeds, accelerations and jerks with which a trajectory is planned.
#[derive(Debug, Clone, Copy)]
pub(super) struct Budget {
    /// Speeds in deg/s and mm/s.
    pub(super) speeds: LegSpeeds,
    /// Accelerations in deg/s²; `jerks` are in deg/s³.
    pub(super) accelerations: [f64; 6],
    pub(super) jerks: [f64; 6],
    /// Requested speed of the tool centre point, in mm/s; infinite without a request.
    pub(super) tcp_asked: f64,
    /// Acceleration of the tool centre point along its path, in mm/s²; infinite without a limit.
    pub(super) tcp_acceleration: f64,
    /// Share of the accelerations for curves at a constant speed.
    pub(super) curving: f64,
}

impl Budget {
    /// Returns the highest speeds on a leg.
    pub(super) fn speeds_on(&self, leg: LegSpeeds) -> LegSpeeds {
        self.speeds.least(LegSpeeds { tcp_speed: TCP_ASKED * leg.tcp_speed, ..leg })
    }
}

/// Default share of each joint's acceleration that bends leave for changes of the rate.
const RESERVE: f64 = 0.2;
/// Greatest such share.
const MOST_RESERVE: f64 = 0.9;
/// Planned share of a requested speed of the tool centre point.
const TCP_ASKED: f64 = 0.9995;
/// Planned share of the highest speed of the tool centre point, if limits have one.
const TCP_SHARE: f64 = 0.98;

impl Default for SpeedSettings {
    fn default() -> Self {
        Self { speeds: LegSpeeds::ANY, jerks: None, reserve: RESERVE }
    }
}

impl SpeedSettings {
    pub(super) fn check(&self) -> Result<(), TrajectoryError> {
        self.speeds.check()?;
        if let Some(given) = self.jerks.iter().flatten().find(|jerk| !RATES.contains(jerk)) {
            return Err(TrajectoryError::Setting { what: "jerks", given: *given, expected: "from 0.001 to 1e9" });
        }
        if (0.0..=MOST_RESERVE).contains(&self.reserve) {
            return Ok(());
        }
        Err(TrajectoryError::Setting { what: "reserve", given: self.reserve, expected: "from 0 to 0.9" })
    }

    /// Returns the budget for a plan within an arm's limits.
    pub(super) fn budget(&self, checker: &Checker) -> Budget {
        let limits = checker.limits();
        let jerks = self.jerks.unwrap_or(*limits.joint_jerks());
        let limited = limits.tcp_speed().map_or(f64::INFINITY, |most| TCP_SHARE * most);
        let of_limits = LegSpeeds { tcp_speed: limited, joint_speeds: *limits.joint_speeds() };
        let asked = LegSpeeds { tcp_speed: TCP_ASKED * self.speeds.tcp_speed, ..self.speeds };
        Budget {
            speeds: of_limits.least(asked),
            accelerations: *limits.joint_accelerations(),
            jerks,
            curving: 1.0 - self.reserve,
            tcp_asked: self.speeds.tcp_speed,
            tcp_acceleration: limits.tcp_acceleration().unwrap_or(f64::INFINITY),
        }
    }
}

/// Tolerances within which a corner may be rounded: in mm, in degrees of the tool's turn, in degrees of a joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Tolerances {
    pub(super) mm: f64,
    pub(super) turn_deg: f64,
    pub(super) joint_deg: f64,
}

/// Tolerances, in mm or degrees, that a corner or a curve can be computed with.
pub(super) const TOLERANCES: RangeInclusive<f64> = 1e-3..=f64::MAX;

impl Tolerances {
    pub(super) const NONE: Self = Self { mm: 0.0, turn_deg: 0.0, joint_deg: 0.0 };

    /// Checks that each tolerance is zero or large enough for a computation; `names` are those of the settings.
    pub(super) fn check(&self, names: [&'static str; 3]) -> Result<(), TrajectoryError> {
        let given = [self.mm, self.turn_deg, self.joint_deg];
        match names.into_iter().zip(given).find(|(_, given)| *given != 0.0 && !TOLERANCES.contains(given)) {
            Some((what, given)) => {
                Err(TrajectoryError::Setting { what, given, expected: "0, or finite and at least 0.001" })
            }
            None => Ok(()),
        }
    }
}

impl LegSpeeds {
    pub(super) const ANY: Self = Self { tcp_speed: f64::INFINITY, joint_speeds: [f64::INFINITY; 6] };

    pub(super) fn check(&self) -> Result<(), TrajectoryError> {
        let speeds = self.joint_speeds.iter().map(|speed| ("joint_speeds", *speed));
        let mut all = speeds.chain([("tcp_speed", self.tcp_speed)]);
        match all.find(|(_, given)| given.is_nan() || given < RATES.start()) {
            Some((what, given)) => Err(TrajectoryError::Setting { what, given, expected: "at least 0.001" }),
            None => Ok(()),
        }
    }

    /// Returns the lower of both.
    pub(super) fn least(self, other: Self) -> Self {
        Self {
            tcp_speed: self.tcp_speed.min(other.tcp_speed),
            joint_speeds: std::array::from_fn(|joint| self.joint_speeds[joint].min(other.joint_speeds[joint])),
        }
    }
}

impl Leg {
    /// Creates a leg with any speed, and a stop at its end.
    pub(super) fn new(after: usize, length: f64, start: [f64; 6], path: LegPath) -> Self {
        Self { after, length, start, path, speeds: LegSpeeds::ANY, corner: Tolerances::NONE }
    }

    pub(super) fn joints(after: usize, from: [f64; 6], to: [f64; 6]) -> Self {
        let moved: [f64; 6] = std::array::from_fn(|joint| to[joint] - from[joint]);
        let length = moved.iter().map(|moved| moved * moved).sum::<f64>().sqrt();
        Self::new(after, length, from, LegPath::Joints(moved.map(|moved| moved / length)))
    }

    /// Returns the joint positions at a distance along a leg in joint space, in degrees.
    pub(super) fn joints_at(&self, direction: &[f64; 6], way: f64) -> [f64; 6] {
        std::array::from_fn(|joint| self.start[joint] + way * direction[joint])
    }
}
