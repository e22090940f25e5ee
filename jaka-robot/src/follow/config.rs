//! Options of a run that follows a trajectory.

use std::time::Duration;

use crate::error::OptionName;
use crate::place::Quantity;
use crate::servo_session::MOST_DEG;
use crate::{Error, Guard, ServoConfig};

/// Options of a run that follows a trajectory: see [`Robot::start_follow`](crate::Robot::start_follow).
#[derive(Debug, Clone)]
#[must_use = "a configuration does nothing until a trajectory is followed with it"]
pub struct FollowConfig {
    pub(super) servo: ServoConfig,
    pub(super) approach_deg_s: Option<f64>,
    pub(super) scale: f64,
    pub(super) deadline: Option<Duration>,
    pub(super) max_departure_deg: f64,
    pub(super) max_gap: Duration,
    pub(super) guard: Option<Guard>,
    /// Quantity in which the trajectory was given.
    pub(super) given_in: Quantity,
}

impl Default for FollowConfig {
    fn default() -> Self {
        Self {
            servo: ServoConfig::new(),
            approach_deg_s: None,
            scale: 1.0,
            deadline: None,
            max_departure_deg: MOST_DEG,
            max_gap: Duration::from_millis(100),
            guard: None,
            given_in: Quantity::Pose,
        }
    }
}

impl FollowConfig {
    /// The defaults: a set-point each 8 ms, the trajectory's own speed, no approach, no deadline.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the options of set-points: period, filter, timeout of servo mode and more.
    pub fn servo(mut self, servo: ServoConfig) -> Self {
        self.servo = servo;
        self
    }

    /// Moves the arm to the start of the trajectory first, with at most this speed of each joint in deg/s.
    ///
    /// The path is straight in joint space, and checked before anything is sent. Without this option, a trajectory is
    /// refused if its start is more than 0.01 deg away from the commanded joints. A speed below 0.001 deg/s is an
    /// [`ErrorKind::InvalidOption`](crate::ErrorKind::InvalidOption).
    pub fn approach(mut self, speed_deg_s: f64) -> Self {
        self.approach_deg_s = Some(speed_deg_s);
        self
    }

    /// Puts the run under a guard: when it trips, the arm is braked along the trajectory, and the run ends with
    /// [`Cause::Guard`](crate::Cause::Guard). The first set-point that brakes goes out in the next servo period after
    /// the packet. [`Guard`] describes its reach and its limits: it is **not a safety function**.
    ///
    /// Nothing that moves the arm was sent after [`ErrorKind::GuardTripped`](crate::ErrorKind::GuardTripped) (the guard
    /// trips by the newest packet already), [`ErrorKind::NotShown`](crate::ErrorKind::NotShown) (packets lack its
    /// values), [`ErrorKind::StatusUnknown`](crate::ErrorKind::StatusUnknown), and
    /// [`ErrorKind::NotGuarded`](crate::ErrorKind::NotGuarded) (a [`ForceLimit`](crate::ForceLimit) permits less speed;
    /// the error has the place and the speed).
    ///
    /// # A limit of force
    /// Under a [`ForceLimit`](crate::ForceLimit) the arm is braked also
    /// where packets stay away for three of their periods, 100 ms at least. All of the trajectory is looked at, at its
    /// own speed, which is the most that a handle can ask for: wherever something were touched, the tool must rest
    /// within the overtravel, [computed](jaka_motion::Follower::worst_overtravel) with the set-points that brake it. An
    /// approach is so slow that the same holds.
    pub fn guard(mut self, guard: impl Into<Guard>) -> Self {
        self.guard = Some(guard.into());
        self
    }

    /// States that the trajectory was made of joint positions alone, so that it depends on no frame: it continues if
    /// another tool frame or user frame is selected meanwhile.
    ///
    /// By default, or under a guard or limits for the tool centre point or the user frame, the run then ends with
    /// [`Cause::FramesChanged`](crate::Cause::FramesChanged), because a trajectory may contain lines.
    pub fn in_joints(mut self) -> Self {
        self.given_in = Quantity::Joints;
        self
    }

    /// Sets the rate of the trajectory at first: 1 for its own speed, which is the default and the most, down to 0 for
    /// a pause. Another number is an [`ErrorKind::InvalidOption`](crate::ErrorKind::InvalidOption).
    pub fn speed_scale(mut self, scale: f64) -> Self {
        self.scale = scale;
        self
    }

    /// Sets the longest duration from the call on, with the approach and pauses. Then the run stops along the
    /// trajectory. By default there is no deadline.
    pub fn deadline(mut self, time: Duration) -> Self {
        self.deadline = Some(time);
        self
    }

    /// Sets the greatest distance of a joint from all its set-points of the last half second, in degrees, by status
    /// packets: 5 by default. Beyond it the run ends with [`Cause::Departed`](crate::Cause::Departed). Less than 0.001,
    /// or no number, is an [`ErrorKind::InvalidOption`](crate::ErrorKind::InvalidOption).
    pub fn max_departure(mut self, degrees: f64) -> Self {
        self.max_departure_deg = degrees;
        self
    }

    /// Sets the greatest lateness of a cycle: 100 ms by default. Beyond it the run ends with
    /// [`Cause::SetPointLate`](crate::Cause::SetPointLate). At speed it also ends so after three periods, and then
    /// nothing brakes ([`ServoSession`](crate::ServoSession), at "Late set-points"); a slow arm continues from
    /// standstill.
    pub fn max_gap(mut self, time: Duration) -> Self {
        self.max_gap = time;
        self
    }

    /// Name of one of its options.
    pub(super) const fn option(name: &'static str) -> OptionName {
        OptionName::new("FollowConfig", name)
    }

    pub(super) fn check(&self) -> Result<(), Error> {
        check_scale(Self::option("speed_scale"), self.scale)?;
        Self::option("max_departure").check_at_least(self.max_departure_deg, "deg")?;
        self.approach_deg_s.map_or(Ok(()), |speed| Self::option("approach").check_at_least(speed, "deg/s"))
    }
}

pub(super) fn check_scale(option: OptionName, scale: f64) -> Result<(), Error> {
    if (0.0..=1.0).contains(&scale) { Ok(()) } else { Err(option.refuse(scale, "0 to 1")) }
}
