//! Into servo mode.

use std::time::Duration;

use jaka_proto::Command;
use jaka_proto::messages::servo::{IsInServomove, SetServoMode, SetServoMoveFilter};
use jaka_proto::messages::types::Switch;
use jaka_sync::layer::ClientParts as _;

use super::course::Course;
use super::pace::{CYCLE, Pace};
use super::{MOST_STEPS, ServoConfig, ServoSession};
use crate::error::Attach as _;
use crate::{Error, ErrorKind, Explanation, MotionStatus, Report, Rest, Robot};

impl<'r, S: MotionStatus> ServoSession<'r, S> {
    /// Enters servo mode, unless what is asked of the arm at rest says otherwise. Nothing that changes something was sent by then.
    pub(crate) fn enter(
        robot: &'r mut Robot<S>,
        config: &ServoConfig,
        check: impl FnOnce(&mut Robot<S>) -> Result<(), Error>,
    ) -> Result<Self, Error> {
        check_step_count(config)?;
        config.rates.check_themselves()?;
        #[cfg(feature = "realtime")]
        let priority = config.take_priority()?;
        robot.rest_for_servo(config.enter_timeout)?;
        if robot.client().call(&IsInServomove::new())?.in_servo_mode {
            return Err(robot.not_ready(Explanation::ServoModeOn));
        }
        check(robot)?;
        if let Some(filter) = &config.filter {
            let gate = robot.gate();
            let client = robot.client();
            client.call_through(Some(&gate), filter, client.timeout_of(SetServoMoveFilter::INFO))?;
        }
        let mut session = Self {
            pace: Pace::new(robot.clock(), config.period(), config.busy_wait),
            since: robot.clock().stopwatch(),
            robot,
            config: config.clone(),
            course: Course::unknown(),
            report: Report::of_set_points(),
            rest: Rest::NotSeen,
            refusal: None,
            begun: None,
            is_open: true,
            ended: None,
            #[cfg(feature = "realtime")]
            priority,
        };
        match session.switch_on() {
            Ok(course) => {
                session.course = course;
                session.pace = Pace::new(session.robot.clock(), config.period(), config.busy_wait);
                Ok(session)
            }
            Err(error) => Err(session.end(error)),
        }
    }

    /// Servo mode on, and where the arm is in it.
    fn switch_on(&mut self) -> Result<Course, Error> {
        let gate = self.robot.gate();
        let (client, timeout) = (self.robot.client(), self.config.enter_timeout);
        let on =
            client.call_through(Some(&gate), &SetServoMode::new(Switch::On), client.timeout_of(SetServoMode::INFO));
        if let Err(error) = on.map_err(Error::from) {
            // What was not sent or was refused need not be left.
            self.is_open = error.may_have_run();
            return Err(error);
        }
        self.wait_until_entered(timeout)?;
        let start = self.robot.client().get_joint_pos()?.joint_position;
        let pose = self.robot.tcp_pose(timeout)?;
        self.robot.prepare_set_points(start, pose, timeout)?;
        if let Some(accelerations) = self.robot.joint_accelerations() {
            self.config.rates.joint_acceleration = accelerations;
        }
        Ok(Course::at(start, pose))
    }

    /// The acknowledgement of `servo_move` comes before the mode has changed, and also where it does not change.
    fn wait_until_entered(&mut self, timeout: Duration) -> Result<(), Error> {
        let since = self.robot.clock().stopwatch();
        let mut pace = Pace::new(self.robot.clock(), CYCLE, Duration::ZERO);
        while !self.robot.client().call(&IsInServomove::new())?.in_servo_mode {
            if since.passed() > timeout {
                return Err(self.robot.not_ready(Explanation::ServoModeNotEntered));
            }
            pace.wait();
        }
        Ok(())
    }
}

/// A longer period would let one set-point move the arm far.
pub(super) fn check_step_count(config: &ServoConfig) -> Result<(), Error> {
    let count = config.step_count;
    if count <= MOST_STEPS {
        return Ok(());
    }
    let expected = format!("1 to {MOST_STEPS}: a period of at most {:?}", CYCLE * MOST_STEPS);
    Err(ServoConfig::option("step_count").refuse(count, expected))
}

impl<S: MotionStatus> Robot<S> {
    /// Enters servo mode, in which set-points come one by one: waits until the controller is in it.
    ///
    /// # Errors
    /// As [`ServoSession`] says at "Entering".
    pub fn enter_servo_mode(&mut self, config: &ServoConfig) -> Result<ServoSession<'_, S>, Error> {
        ServoSession::enter(self, config, |_| Ok(()))
    }

    /// Waits until the arm is at rest, by the controller's answers. While it moves, controllers acknowledge servo mode and do not
    /// enter it.
    fn rest_for_servo(&mut self, timeout: Duration) -> Result<(), Error> {
        self.client().link().check_open(SetServoMode::INFO.name)?;
        self.latch.check()?;
        if self.has_motions() {
            return Err(self.not_ready(Explanation::Moving));
        }
        self.known_status(timeout)?;
        // Packets may be old: the controller says whether it moves.
        if self.comes_to_rest(timeout)? { Ok(()) } else { Err(self.not_ready(Explanation::Moving)) }
    }

    /// The error for what the robot's state keeps it from doing.
    pub(crate) fn not_ready(&mut self, explanation: Explanation) -> Error {
        self.client().link().attach(ErrorKind::NotReady { explanation }.into())
    }
}
