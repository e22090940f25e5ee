//! A robot: a client and a monitor together.

// In the order of the documentation.
mod config;
mod connecting;
mod leading;

use std::sync::Arc;

use jaka_proto::messages::status::RobotStatus;

pub use self::config::RobotConfig;
#[cfg(doc)]
use crate::Client;
#[cfg(doc)]
use crate::ErrorKind;
use crate::arm::Arm;
use crate::limits::LimitChecks;
use crate::planned::{Moving, Planned};
use crate::servo_session::Led;
use crate::{Call, Command, Monitor, MotionStatus};

/// A robot whose motions are waited for: a [`Client`] for commands and a [`Monitor`] for their effects.
///
/// ```no_run
/// use std::time::Duration;
/// use jaka_robot::Robot;
/// use jaka_robot::motion::JointMove;
///
/// let mut robot = Robot::connect("10.5.5.100")?;
/// let stop = robot.stop_handle();
/// ctrlc::set_handler(move || {
///     if let Err(error) = stop.stop() {
///         eprintln!("the arm may still move, use the emergency stop: {error}");
///     }
/// })?;
/// robot.power_up(Duration::from_secs(60))?;
/// // The last joint, by 5 deg from where it is, at 5 deg/s and 20 deg/s².
/// let turn = JointMove::relative([0.0, 0.0, 0.0, 0.0, 0.0, 5.0], 5.0).acceleration(20.0);
/// robot.run(&turn, Duration::from_secs(30))?.reached()?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// A status packet alone does not end a motion, because it cannot show its age: when packets say that the arm is in
/// position, the controller is asked where it is (`get_joint_pos`, 4.49, or `get_tcp_pos`, 4.50), usually once for each
/// motion.
///
/// After a protective stop, an emergency stop or a silent status port, motions are refused until
/// [`acknowledge`](Self::acknowledge) is called: somebody should have checked the robot first. They are also refused
/// while the status is stale, missing or unreadable ([`ErrorKind::StatusUnknown`]). Nothing is ever sent again, or
/// enabled again, automatically.
///
/// `S` is what its monitor keeps of status packets: [`MotionStatus`].
#[derive(Debug)]
#[must_use = "dropping a robot closes its connections, and its stop handles can no longer stop the arm"]
pub struct Robot<S: MotionStatus = RobotStatus> {
    monitor: Arc<Monitor<S>>,
    pub(crate) arm: Arm,
    limits: LimitChecks,
    planned: Planned,
}

impl<S: MotionStatus> Robot<S> {
    /// The parts that a motion concerns.
    fn moving(&mut self) -> Moving<'_> {
        let Self { arm, limits, planned, .. } = self;
        Moving { arm, limits, planned }
    }

    /// The parts that a session leads.
    fn led(&mut self) -> Led<'_> {
        let has_motions = self.planned.has_motions();
        Led { arm: &mut self.arm, limits: &mut self.limits, has_motions }
    }
}

/// As through [`Robot::client`]: motions are neither refused after a stop nor waited for. For those, see
/// [`Robot::run`].
impl<S: MotionStatus> Call for Robot<S> {
    fn call<C: Command>(&mut self, command: &C) -> Result<C::Reply, jaka_sync::Error> {
        self.client().call(command)
    }
}
