//! Options of a session with set-points from the program.

use super::ServoConfig;
use super::rates::Rates;

/// Options of a [`ServoSession`](crate::ServoSession): its set-points, and the greatest distances between them.
///
/// A [`ServoConfig`] is one, with the defaults for the rest: [`enter_servo_mode`](crate::Robot::enter_servo_mode) takes
/// both.
#[derive(Debug, Clone, PartialEq, Default)]
#[must_use = "a configuration does nothing until servo mode is entered with it"]
pub struct SessionConfig {
    pub(super) servo: ServoConfig,
    pub(super) rates: Rates,
}

impl From<ServoConfig> for SessionConfig {
    fn from(servo: ServoConfig) -> Self {
        Self { servo, rates: Rates::default() }
    }
}

impl From<&ServoConfig> for SessionConfig {
    fn from(servo: &ServoConfig) -> Self {
        servo.clone().into()
    }
}

impl From<&Self> for SessionConfig {
    fn from(config: &Self) -> Self {
        config.clone()
    }
}

impl SessionConfig {
    /// The defaults.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets how set-points go out.
    pub fn servo(mut self, servo: ServoConfig) -> Self {
        self.servo = servo;
        self
    }

    /// Sets the greatest change of a joint's speed from one set-point to the next, and the deceleration of the arm at
    /// the end of the session, in deg/s²: 720 by default, which the document advises at most (4.7). Other values than a
    /// number of at least 0.001 are an [`ErrorKind::InvalidOption`](crate::ErrorKind::InvalidOption). A robot with
    /// limits brakes by their stop ([`Limits::stop_accelerations`](jaka_motion::Limits::stop_accelerations)). From 100
    /// deg/s a landing takes 0.14 s with 720 deg/s², and 10 s with 10.
    pub fn max_joint_acceleration(mut self, acceleration_deg_s2: f64) -> Self {
        self.rates.joint_acceleration = [acceleration_deg_s2; 6];
        self.rates.joint_deceleration = [acceleration_deg_s2; 6];
        self
    }

    /// Sets the greatest speed of the tool centre point by set-points that are poses, in mm/s: 3000 by default, which
    /// is ours. Other values than a number of at least 0.001 are an
    /// [`ErrorKind::InvalidOption`](crate::ErrorKind::InvalidOption).
    pub fn max_tcp_speed(mut self, speed_mm_s: f64) -> Self {
        self.rates.tcp_speed = speed_mm_s;
        self
    }

    /// Sets the greatest change of the tool centre point's speed from one set-point that is a pose to the next, and the
    /// deceleration of the arm after such set-points, in mm/s²: 8000 by default, which the document advises at most
    /// (4.9). Other values than a number of at least 0.001 are an
    /// [`ErrorKind::InvalidOption`](crate::ErrorKind::InvalidOption).
    pub fn max_tcp_acceleration(mut self, acceleration_mm_s2: f64) -> Self {
        self.rates.tcp_acceleration = acceleration_mm_s2;
        self
    }

    /// Sends set-points without a comparison with the previous ones: also jumps. For programs with other checks, and
    /// for controllers with a filter that smooths them. The arm is still braked at the end of the session, and limits
    /// of the robot still hold.
    pub fn unchecked(mut self) -> Self {
        self.rates.are_checked = false;
        self
    }
}
