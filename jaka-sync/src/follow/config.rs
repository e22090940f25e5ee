//! How a trajectory is followed.

use std::time::Duration;

use jaka_proto::Command;
use jaka_proto::check::InvalidArgument;
use jaka_proto::messages::servo::ServoJ;

use crate::ServoConfig;
use crate::servo_session::check_at_least;

/// How a trajectory is followed: see [`Robot::start_follow`](crate::Robot::start_follow).
#[derive(Debug, Clone, PartialEq)]
#[must_use = "a configuration does nothing until a trajectory is followed with it"]
pub struct FollowConfig {
    pub(super) servo: ServoConfig,
    pub(super) approach_deg_s: Option<f64>,
    pub(super) scale: f64,
    pub(super) deadline: Option<Duration>,
    pub(super) max_departure_deg: f64,
    pub(super) max_gap: Duration,
}

impl Default for FollowConfig {
    fn default() -> Self {
        Self {
            servo: ServoConfig::new(),
            approach_deg_s: None,
            scale: 1.0,
            deadline: None,
            max_departure_deg: 5.0,
            max_gap: Duration::from_millis(100),
        }
    }
}

impl FollowConfig {
    /// The defaults: a set-point each 8 ms, the trajectory's own speed, no approach, no deadline.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets how the servo session runs in which set-points go out: their period, the filter, how long entering may take, and more. What it says
    /// of speeds and accelerations does not matter, since set-points are within the robot's limits.
    pub fn servo(mut self, servo: ServoConfig) -> Self {
        self.servo = servo;
        self
    }

    /// Moves the arm to where the trajectory starts first, with at most this speed of each joint in deg/s.
    ///
    /// The way is straight in joint space, and checked before anything is sent. Without this, a trajectory that starts more than 0.01 deg elsewhere than
    /// where the joints are to be is refused.
    pub fn approach(mut self, speed_deg_s: f64) -> Self {
        self.approach_deg_s = Some(speed_deg_s);
        self
    }

    /// Sets how fast the trajectory is followed at first: 1 for its own speed, which is the default and the most, down to 0 for a pause.
    pub fn speed_scale(mut self, scale: f64) -> Self {
        self.scale = scale;
        self
    }

    /// Sets how long it may take, from the call on, with the approach and pauses. Then it stops along the trajectory. By default there is no deadline.
    pub fn deadline(mut self, time: Duration) -> Self {
        self.deadline = Some(time);
        self
    }

    /// Sets how far a joint may be from all its set-points of the last half second, in degrees, by status packets: 5 by default. Beyond that the run
    /// ends with [`Cause::Departed`](crate::Cause::Departed).
    pub fn max_departure(mut self, degrees: f64) -> Self {
        self.max_departure_deg = degrees;
        self
    }

    /// Sets how late a cycle may begin: 100 ms by default. Beyond that the run ends with
    /// [`Cause::SetPointLate`](crate::Cause::SetPointLate). At speed it also ends so after three periods, and
    /// then nothing brakes ([`ServoSession`](crate::ServoSession), at "Late set-points"); a slow arm goes on from
    /// standstill.
    pub fn max_gap(mut self, time: Duration) -> Self {
        self.max_gap = time;
        self
    }

    pub(super) fn check(&self) -> Result<(), InvalidArgument> {
        check_scale(self.scale)?;
        check_at_least("max_departure", self.max_departure_deg, "deg")?;
        self.approach_deg_s.map_or(Ok(()), |speed| check_at_least("approach", speed, "deg/s"))
    }
}

pub(super) fn check_scale(scale: f64) -> Result<(), InvalidArgument> {
    if (0.0..=1.0).contains(&scale) {
        return Ok(());
    }
    Err(InvalidArgument::new(ServoJ::INFO.name, "speed_scale", scale.to_string(), "from 0 to 1".to_owned()))
}
