//! Options of a robot.

use std::time::Duration;

use jaka_motion::Limits;

use crate::Error;
use crate::arm::REST_SPEED;
use crate::error::OptionName;
use crate::limits::Waived;
use crate::planned::Grace;
use crate::power_steps::NeedsRest;

/// Options of a [`Robot`](crate::Robot), without the options of its connections ([`Config`](crate::Config)).
///
/// ```no_run
/// use jaka_robot::jaka_motion::{Limits, Model};
/// use jaka_robot::motion::JointMove;
/// use jaka_robot::{Robot, RobotConfig};
///
/// let arm = Model::named("Zu 5").expect("a published arm");
/// let mut robot = Robot::connect("10.5.5.100")?;
/// robot.configure(&RobotConfig::new().limits(Limits::of(arm).with_tcp_speed(250.0)?))?;
/// let beyond = JointMove::absolute([0.0, 0.0, 181.0, 0.0, 0.0, 0.0], 20.0).acceleration(50.0);
/// let error = robot.start(&beyond).unwrap_err();
/// assert_eq!(error.to_string(), "`joint_move` was not sent: joint 3 would be at 181 deg; limit 175 (Zu 5)");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Limits
/// A motion beyond a limit anywhere on its path is refused with
/// [`ErrorKind::BeyondLimit`](crate::ErrorKind::BeyondLimit), and a motion with an unknown path with
/// [`ErrorKind::NotChecked`](crate::ErrorKind::NotChecked); nothing is sent then. [`Checker`](jaka_motion::Checker)
/// describes the checks and their resolution. They apply to [`run`](crate::Robot::run), [`start`](crate::Robot::start)
/// and servo sessions, and not to commands through [`client`](crate::Robot::client), such as a jog.
///
/// The check assumes that an offset of a motion in a queue counts from the end of the motion before it, which the
/// document does not state. If somebody else stops the queue, and this program does not know it yet, the arm moves to
/// the target of the next motion from another place: [`wait`](crate::Robot::wait) for the end of a motion to know.
///
/// Limits are not a safety function and no fence: they keep a program from wrong requests. They know nothing of
/// collisions, not even of the arm with itself, and do not see motions of other clients.
///
/// The robot queries the poses of twelve joint positions (`kine_forward`, 4.46, which moves nothing), which determine
/// tool, user frame and mounting. Before a motion it queries the position of the arm (4.49 and 4.50); if both answers
/// do not fit together, a frame has changed, and it queries the poses again.
///
/// # Presets
/// With [`Preset::Usual`](jaka_motion::Preset::Usual) and [`Preset::Quick`](jaka_motion::Preset::Quick) the robot also
/// queries the payload (4.43), which it logs, and the collision level (4.45), which must not be 0: see
/// [`without_payload`](Self::without_payload) and [`without_collision_detection`](Self::without_collision_detection).
#[derive(Debug, Clone)]
#[must_use = "a configuration does nothing until a robot is configured by it"]
pub struct RobotConfig {
    pub(super) grace: Grace,
    pub(super) silence: Duration,
    pub(super) rest_speed: f64,
    pub(super) needs_rest: NeedsRest,
    pub(super) needs_status: bool,
    pub(super) limits: Option<Limits>,
    pub(super) waived: Waived,
}

impl Default for RobotConfig {
    fn default() -> Self {
        Self {
            grace: Grace { time: Duration::from_millis(400), packets: 3 },
            silence: Duration::from_secs(2),
            rest_speed: REST_SPEED,
            needs_rest: NeedsRest::Seen,
            needs_status: true,
            limits: None,
            waived: Waived::default(),
        }
    }
}

impl RobotConfig {
    /// The defaults, with which a robot is made.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the time of rest, and the number of packets that must show it, for the end of a motion that one answer of
    /// the controller does not confirm: several motions in a queue, a motion that ends at its start, an arm that stops
    /// before its target. 0.4 s and three packets by default.
    ///
    /// It is also the time within which the arm must begin: if it has not left its position by then, the motion counts
    /// as one without length, or, if its target is known and the arm is not there, as stopped.
    pub fn start_grace(mut self, time: Duration, packets: u32) -> Self {
        self.grace = Grace { time, packets: packets.max(1) };
        self
    }

    /// Sets the longest time without a status packet during a wait for a motion. 2 s by default.
    pub fn status_silence(mut self, time: Duration) -> Self {
        self.silence = time;
        self
    }

    /// Sets the greatest speed of a joint of an arm at rest, in deg/s. 0.5 deg/s by default.
    ///
    /// The arm is at rest if no joint turned faster over three answers of the controller (`get_joint_pos`, 4.49) that
    /// are 100 ms apart. Noise of the encoders looks like a turn: of ±0.03 deg, like up to 0.3 deg/s. A robot waits for
    /// rest after it has stopped the arm, and asks for it before servo mode and before it powers the arm down:
    /// [`Robot::wait_for_rest`](crate::Robot::wait_for_rest).
    pub fn rest_speed(mut self, deg_s: f64) -> Self {
        self.rest_speed = deg_s;
        self
    }

    /// Allows [`Robot::power_down`](crate::Robot::power_down) although the controller does not report the joints
    /// (`get_joint_pos`, 4.49), so that it is not known whether the arm is at rest. An arm that is seen to move keeps
    /// its power all the same.
    pub fn allow_power_down_without_joints(mut self) -> Self {
        self.needs_rest = NeedsRest::UnlessUnknown;
        self
    }

    /// Fails if an option does not take its value.
    pub(super) fn check(&self) -> Result<(), Error> {
        let is_speed = self.rest_speed > 0.0 && self.rest_speed.is_finite();
        let name = OptionName::new("RobotConfig", "rest_speed");
        if is_speed { Ok(()) } else { Err(name.refuse(self.rest_speed, "a number above 0 deg/s")) }
    }

    /// Allows motions and set-points while the status is stale, missing or unreadable.
    ///
    /// A stop that the status would show is not noticed then. For programs that observe the robot's state by other
    /// means.
    pub fn allow_motion_without_status(mut self) -> Self {
        self.needs_status = false;
        self
    }

    /// Sets the limits by which each motion and each set-point is checked before it is sent. By default there are none.
    pub fn limits(mut self, limits: Limits) -> Self {
        self.limits = Some(limits);
        self
    }

    /// Takes presets other than the gentle one although the payload was not read.
    pub fn without_payload(mut self) -> Self {
        self.waived.payload = true;
        self
    }

    /// Takes presets other than the gentle one although the collision level is 0 or was not read.
    pub fn without_collision_detection(mut self) -> Self {
        self.waived.collision_detection = true;
        self
    }
}
