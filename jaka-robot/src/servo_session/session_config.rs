//! Options of a session whose set-points a program gives.

use super::ServoConfig;
use super::rates::Rates;

/// Options of a [`ServoSession`](crate::ServoSession): those of its set-points, and the greatest distances between
/// them.
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

    /// Sets how fast the speed of a joint may change from one set-point to the next, and with which acceleration the
    /// arm is braked when the session ends, in deg/s²: 720 by default, which the document advises at most (4.7). Any
    /// other than a number above 0 is an [`ErrorKind::InvalidOption`](crate::ErrorKind::InvalidOption). If the robot
    /// has limits, it is braked by their stop
    /// ([`Limits::stop_accelerations`](jaka_motion::Limits::stop_accelerations)). From 100 deg/s a landing takes 0.14 s
    /// with 720 deg/s², and 10 s with 10.
    pub fn max_joint_acceleration(mut self, acceleration_deg_s2: f64) -> Self {
        self.rates.joint_acceleration = [acceleration_deg_s2; 6];
        self.rates.joint_deceleration = [acceleration_deg_s2; 6];
        self
    }

    /// Sets how fast set-points that are poses may move the tool centre point, in mm/s: 3000 by default, which is ours.
    /// Any other than a number above 0 is an [`ErrorKind::InvalidOption`](crate::ErrorKind::InvalidOption).
    pub fn max_tcp_speed(mut self, speed_mm_s: f64) -> Self {
        self.rates.tcp_speed = speed_mm_s;
        self
    }

    /// Sets how fast the speed of the tool centre point may change from one set-point that is a pose to the next, and
    /// with which acceleration the arm is braked after such, in mm/s²: 8000 by default, which the document advises at
    /// most (4.9). Any other than a number above 0 is an [`ErrorKind::InvalidOption`](crate::ErrorKind::InvalidOption).
    pub fn max_tcp_acceleration(mut self, acceleration_mm_s2: f64) -> Self {
        self.rates.tcp_acceleration = acceleration_mm_s2;
        self
    }

    /// Sends set-points without comparing them with the ones before: also those that jump. For programs that check them
    /// by other means, and for controllers whose filter smooths them. The arm is still braked when the session ends,
    /// and limits of the robot still hold.
    pub fn unchecked(mut self) -> Self {
        self.rates.are_checked = false;
        self
    }
}
