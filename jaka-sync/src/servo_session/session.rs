//! A session in servo mode.

use std::fmt;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::{Duration, Instant};

use jaka_proto::Command;
use jaka_proto::check::InvalidArgument;
use jaka_proto::messages::servo::{IsInServomove, ServoJ, ServoMove, ServoP};
use jaka_proto::messages::types::{JointPosition, MoveMode, Pose, Switch};

use super::pace::{CYCLE, Pace};
use super::{ServoConfig, ServoReport};
use crate::link::Answers;
use crate::{Error, Exchanges, Robot, Snapshot};

/// The greatest speed of a joint in servo mode, in deg/s (4.15).
const MAX_SPEED: f64 = 180.0;

/// How long the last answers may take.
const LAST_ANSWERS: Duration = Duration::from_secs(1);

/// The robot in servo mode, from [`Robot::servo`]: set-points go out at the beat of the servo period, and their answers are
/// counted, not waited for.
///
/// Each call sends one set-point at the next beat, and fails within a period if the controller has refused an earlier one.
/// Dropping the session leaves servo mode, also while a panic unwinds; [`finish`](Self::finish) does it with a report.
///
/// ```no_run
/// # use jaka_sync::{Robot, ServoConfig};
/// let mut robot = Robot::connect("10.5.5.100")?;
/// let mut session = robot.servo(&ServoConfig::new())?;
/// for _ in 0..125 {
///     session.joints_by([0.01, 0.0, 0.0, 0.0, 0.0, 0.0])?;
/// }
/// let report = session.finish()?;
/// println!("{} set-points, 99 % within {:?}", report.cycles, report.lateness(0.99));
/// # Ok::<(), jaka_sync::Error>(())
/// ```
pub struct ServoSession<'r> {
    robot: &'r mut Robot,
    config: ServoConfig,
    pace: Pace,
    /// The joints of the last set-point, where they are known.
    last: Option<JointPosition>,
    report: ServoReport,
    refusal: Option<Error>,
    is_open: bool,
}

impl<'r> ServoSession<'r> {
    pub(crate) fn enter(robot: &'r mut Robot, config: &ServoConfig) -> Result<Self, Error> {
        if let Some(filter) = &config.filter {
            robot.client().call(filter)?;
        }
        let start = robot.client().get_joint_pos()?.joint_position;
        robot.client().servo_move(Switch::On)?;
        let pace = Pace::new(config.period(), config.busy_wait);
        let mut session = Self {
            robot,
            config: config.clone(),
            pace,
            last: Some(start),
            report: ServoReport::default(),
            refusal: None,
            is_open: true,
        };
        session.wait_until_entered()?;
        session.pace = Pace::new(config.period(), config.busy_wait);
        Ok(session)
    }

    /// The acknowledgement of `servo_move` comes before the mode has changed.
    fn wait_until_entered(&mut self) -> Result<(), Error> {
        let since = Instant::now();
        let mut pace = Pace::new(CYCLE, Duration::ZERO);
        while !self.robot.client().call(&IsInServomove)?.in_servo_mode {
            if since.elapsed() > self.config.enter_timeout {
                let after = self.config.enter_timeout;
                return Err(Error::StatusTimeout { after, exchanges: Exchanges::default() });
            }
            pace.wait();
        }
        Ok(())
    }

    /// The time of the next set-point, counted from the first.
    pub fn time(&self) -> Duration {
        self.pace.time()
    }

    /// Waits for the next beat and sends a set-point for all joints.
    ///
    /// # Errors
    /// - [`Error::InvalidArgument`]: a joint would have to move faster than 180 deg/s, which the controller ignores (4.15).
    ///   Nothing was sent. Behind a pose this is not checked: it does not tell where the joints are.
    /// - [`Error::Refused`]: the controller has refused an earlier set-point.
    /// - [`Error::NotAcknowledged`]: a protective or emergency stop. [`Error::Disconnected`]: the connection is lost.
    pub fn joints(&mut self, target: impl Into<JointPosition>) -> Result<(), Error> {
        let target = target.into();
        self.check_speed(target)?;
        let request = ServoJ {
            mode: MoveMode::Absolute,
            joint_position: target,
            step_count: Some(self.config.step_count.into()),
        };
        self.send(&request)?;
        self.last = Some(target);
        Ok(())
    }

    /// Waits for the next beat and sends a set-point by an offset of all joints from the one before.
    ///
    /// # Errors
    /// As [`joints`](Self::joints).
    pub fn joints_by(&mut self, offset: impl Into<JointPosition>) -> Result<(), Error> {
        let offset = offset.into();
        let (from, to) = (JointPosition([0.0; 6]), offset);
        self.check_step(from, to)?;
        let request = ServoJ {
            mode: MoveMode::Relative,
            joint_position: offset,
            step_count: Some(self.config.step_count.into()),
        };
        self.send(&request)?;
        self.last = self.last.map(|last| JointPosition(std::array::from_fn(|i| last.0[i] + offset.0[i])));
        Ok(())
    }

    /// Waits for the next beat and sends a set-point for the tool centre point.
    ///
    /// The speeds of the joints that follow from it are the controller's to check.
    ///
    /// # Errors
    /// As [`joints`](Self::joints), but for the speed.
    pub fn pose(&mut self, target: impl Into<Pose>) -> Result<(), Error> {
        let request =
            ServoP { pose: target.into(), mode: MoveMode::Absolute, step_count: Some(self.config.step_count.into()) };
        self.last = None;
        self.send(&request)
    }

    /// Waits for the next beat and sends a set-point by an offset of the tool centre point.
    ///
    /// # Errors
    /// As [`pose`](Self::pose).
    pub fn pose_by(&mut self, offset: impl Into<Pose>) -> Result<(), Error> {
        let request =
            ServoP { pose: offset.into(), mode: MoveMode::Relative, step_count: Some(self.config.step_count.into()) };
        self.last = None;
        self.send(&request)
    }

    /// Calls `next` before each beat, with its time and the newest status, and sends the joints that it gives, until it
    /// breaks.
    ///
    /// The time is the clock's: beats that were missed are passed over. A motion that follows it then has a long way to the next set-point,
    /// which may be refused as too fast; one that counts its set-points is delayed instead.
    ///
    /// # Errors
    /// As [`joints`](Self::joints).
    pub fn run<B>(
        &mut self,
        mut next: impl FnMut(Duration, Option<&Snapshot>) -> ControlFlow<B, JointPosition>,
    ) -> Result<B, Error> {
        loop {
            let status: Option<Arc<Snapshot>> = self.robot.monitor().last();
            match next(self.time(), status.as_deref()) {
                ControlFlow::Continue(target) => self.joints(target)?,
                ControlFlow::Break(end) => return Ok(end),
            }
        }
    }

    fn check_speed(&self, target: JointPosition) -> Result<(), Error> {
        self.last.map_or(Ok(()), |last| self.check_step(last, target))
    }

    fn check_step(&self, from: JointPosition, to: JointPosition) -> Result<(), Error> {
        let most = MAX_SPEED * self.config.period().as_secs_f64();
        let steps = from.0.iter().zip(to.0).map(|(from, to)| to - from);
        let Some((joint, step)) = steps.enumerate().find(|(_, step)| step.abs() > most + 1e-9) else {
            return Ok(());
        };
        let allowed = format!("a step of at most {most:.3} deg each {:?} (180 deg/s)", self.config.period());
        let value = format!("a step of {step:.3} deg");
        let field = format!("joint_position[{joint}]");
        Err(InvalidArgument::new(ServoJ::INFO.name, field, value, allowed, false).into())
    }

    fn send<C: Command<Reply = ()>>(&mut self, request: &C) -> Result<(), Error> {
        self.take_answers(C::INFO.name)?;
        if let Some(refusal) = self.refusal.take() {
            return Err(refusal);
        }
        let late = self.pace.wait();
        // Behind the wait: a stop may have come meanwhile.
        self.robot.check_latch()?;
        let gate = self.robot.gate();
        let outstanding = self.robot.client().post(Some(&gate), std::slice::from_ref(request))?;
        self.report.late(late, self.config.period());
        self.report.most_outstanding = self.report.most_outstanding.max(outstanding);
        Ok(())
    }

    fn take_answers(&mut self, command: &str) -> Result<(), Error> {
        let (answers, checked) = self.robot.client().link().drain(command);
        self.count(answers);
        checked
    }

    fn count(&mut self, answers: Answers) {
        self.report.accepted += answers.accepted;
        for error in answers.failed {
            if matches!(error, Error::ReplyLost { .. }) {
                self.report.unanswered += 1;
            } else {
                self.report.refused += 1;
                self.refusal.get_or_insert(error);
            }
        }
    }

    /// Waits for the last answers and leaves servo mode.
    ///
    /// # Errors
    /// As [`Client::call`](crate::Client::call), and [`Error::Refused`] if the controller refused a set-point. Servo mode is
    /// left in any case, if it can be; [`Error::ServoModeNotLeft`] keeps both errors where it cannot.
    pub fn finish(mut self) -> Result<ServoReport, Error> {
        let answers = self.last_answers();
        let left = self.leave();
        let refused = self.refusal.take().map_or(Ok(()), Err);
        match (answers.and(refused), left) {
            (Ok(()), Ok(())) => {
                self.report.sort();
                Ok(std::mem::take(&mut self.report))
            }
            (Err(first), Err(leaving)) => {
                Err(Error::ServoModeNotLeft { first: Box::new(first), leaving: Box::new(leaving) })
            }
            (Err(error), Ok(())) | (Ok(()), Err(error)) => Err(error),
        }
    }

    fn last_answers(&mut self) -> Result<(), Error> {
        let since = Instant::now();
        let mut pace = Pace::new(CYCLE, Duration::ZERO);
        while self.robot.client().link().outstanding() > 0 && since.elapsed() < LAST_ANSWERS {
            self.take_answers(ServoJ::INFO.name)?;
            pace.wait();
        }
        // The last set-point has its period, too.
        self.pace.wait();
        Ok(())
    }

    fn leave(&mut self) -> Result<(), Error> {
        self.is_open = false;
        // Another thread that reads may have taken answers in meanwhile.
        let (answers, unanswered) = self.robot.client().link().forget_posted();
        self.count(answers);
        self.report.unanswered += unanswered;
        self.robot.client().call(&ServoMove { servo_mode: Switch::Off })
    }
}

impl Drop for ServoSession<'_> {
    fn drop(&mut self) {
        if self.is_open {
            if let Err(error) = self.leave() {
                log::warn!(target: "jaka_sync", "servo mode was not left: {error}");
            }
        }
    }
}

impl fmt::Debug for ServoSession<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("ServoSession").field("config", &self.config).field("time", &self.time()).finish_non_exhaustive()
    }
}
