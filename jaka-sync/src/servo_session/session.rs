//! A session in servo mode.

use std::fmt;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Duration;

use jaka_proto::Command;
use jaka_proto::check::InvalidArgument;
use jaka_proto::messages::servo::{ServoJ, ServoP};
use jaka_proto::messages::status::RobotStatus;
use jaka_proto::messages::types::{JointPosition, Pose};

use super::pace::Pace;
use super::{ServoConfig, ServoReport};
use crate::link::Answers;
use crate::robot::SetPoints;
use crate::{Error, ErrorKind, MotionStatus, Robot, Snapshot};

/// The greatest speed of a joint in servo mode, in deg/s (4.15).
const MAX_SPEED: f64 = 180.0;

/// The robot in servo mode, from [`Robot::enter_servo_mode`]: set-points go out once in each servo period, and their replies are
/// counted, not waited for.
///
/// Each call sends one set-point in the next cycle, and fails within a period if the controller has refused an earlier one.
/// Dropping the session leaves servo mode, also while a panic unwinds; [`finish`](Self::finish) does it with a report.
///
/// # Entering
/// [`Robot::enter_servo_mode`] fails with [`ErrorKind::NotReady`] while the arm moves or a motion of the robot has not been waited for, and
/// where the controller acknowledges servo mode and does not enter it; with [`ErrorKind::NotAcknowledged`] after a stop, with
/// [`ErrorKind::StatusUnknown`] where the status is stale, missing or unreadable, and as [`Client::call`](crate::Client::call). If
/// something fails after servo mode was asked for, it is left again; [`ErrorKind::ServoModeNotLeft`] where it is not known that it was.
///
/// # A link that stalls
/// If set-points are no longer answered ([`ServoConfig::max_unanswered`]), or the status is no longer known, no more are sent:
/// servo mode is left, and the call fails with [`ErrorKind::SetPointsUnanswered`] or [`ErrorKind::StatusUnknown`]. If the end of servo
/// mode is not answered within a second, the connection is reset, which discards the set-points that the system has not sent, and the
/// error is [`ErrorKind::ServoModeNotLeft`]. What the network or the controller has taken already may still move the arm: at most the
/// set-points that were unanswered.
///
/// ```no_run
/// # use jaka_sync::{Robot, ServoConfig};
/// let mut robot = Robot::connect("10.5.5.100")?;
/// let mut session = robot.enter_servo_mode(&ServoConfig::new())?;
/// for _ in 0..125 {
///     session.send_joint_offset([0.01, 0.0, 0.0, 0.0, 0.0, 0.0])?;
/// }
/// let report = session.finish()?;
/// println!("{} set-points, 99 % within {:?}", report.cycles, report.lateness(0.99));
/// # Ok::<(), jaka_sync::Error>(())
/// ```
#[must_use = "dropping a session leaves servo mode; `finish` does so, too, and reports"]
pub struct ServoSession<'r, S: MotionStatus = RobotStatus> {
    pub(super) robot: &'r mut Robot<S>,
    pub(super) config: ServoConfig,
    pub(super) pace: Pace,
    /// The joints of the last set-point, where they are known.
    pub(super) last: Option<JointPosition>,
    /// What the next set-point is checked against, where the robot has limits.
    pub(super) sent: SetPoints,
    pub(super) report: ServoReport,
    pub(super) refusal: Option<Error>,
    /// True while servo mode is to be left.
    pub(super) is_open: bool,
    /// Why no more set-points go out, if so.
    pub(super) ended: Option<String>,
}

impl<S: MotionStatus> ServoSession<'_, S> {
    /// The time of the next set-point, counted from the first.
    pub fn time(&self) -> Duration {
        self.pace.time()
    }

    /// Waits for the next cycle and sends a set-point for all joints.
    ///
    /// # Errors
    /// - [`ErrorKind::InvalidArgument`]: a joint would have to move faster than 180 deg/s, which the controller ignores (4.15).
    ///   Nothing was sent. After a pose this is not checked, because the joint positions are not known.
    /// - `ErrorKind::BeyondLimit`, `ErrorKind::NotChecked`: the robot has limits. Nothing was sent, and the session has ended: the
    ///   controller keeps the last set-point, and servo mode was left.
    /// - [`ErrorKind::Refused`]: the controller has refused an earlier set-point.
    /// - [`ErrorKind::NotAcknowledged`]: a protective or emergency stop. [`ErrorKind::Disconnected`]: the connection is lost.
    /// - [`ErrorKind::SetPointsUnanswered`], [`ErrorKind::StatusUnknown`]: one of the ports no longer responds; the session has ended.
    ///   [`ErrorKind::ServoModeNotLeft`]: it has ended so, and servo mode may be on. [`ErrorKind::SessionEnded`]: it had ended before.
    pub fn send_joints(&mut self, target: impl Into<JointPosition>) -> Result<(), Error> {
        let target = target.into();
        self.check_speed(target)?;
        self.send_checked_joints(ServoJ::absolute(target), Some(target))
    }

    /// Waits for the next cycle and sends a set-point by an offset of all joints from the one before.
    ///
    /// # Errors
    /// As [`send_joints`](Self::send_joints).
    pub fn send_joint_offset(&mut self, offset: impl Into<JointPosition>) -> Result<(), Error> {
        let offset = offset.into();
        let (from, to) = (JointPosition([0.0; 6]), offset);
        self.check_step(from, to)?;
        let target = self.last.map(|last| JointPosition(std::array::from_fn(|i| last.0[i] + offset.0[i])));
        self.send_checked_joints(ServoJ::relative(offset), target)
    }

    /// Waits for the next cycle and sends a set-point for the tool centre point.
    ///
    /// The speeds of the joints that follow from it are the controller's to check.
    ///
    /// # Errors
    /// As [`send_joints`](Self::send_joints), except for the speed.
    pub fn send_pose(&mut self, target: impl Into<Pose>) -> Result<(), Error> {
        let target = target.into();
        self.send_checked_pose(ServoP::absolute(target), Some(target))
    }

    /// Waits for the next cycle and sends a set-point by an offset of the tool centre point.
    ///
    /// No source says along which axes it goes, so a robot with limits refuses it.
    ///
    /// # Errors
    /// As [`send_pose`](Self::send_pose).
    pub fn send_pose_offset(&mut self, offset: impl Into<Pose>) -> Result<(), Error> {
        self.send_checked_pose(ServoP::relative(offset), None)
    }

    /// Calls `next` before each cycle, with the cycle's time and the last status, and sends the joints that it returns, until it
    /// returns `Break`.
    ///
    /// The time is that of the clock: missed cycles are skipped. A motion that is a function of this time then has a long way to the next
    /// set-point, which may be refused as too fast; a motion that counts its set-points is delayed instead.
    ///
    /// # Errors
    /// As [`send_joints`](Self::send_joints).
    pub fn run<B>(
        &mut self,
        mut next: impl FnMut(Duration, Option<&Snapshot<S>>) -> ControlFlow<B, JointPosition>,
    ) -> Result<B, Error> {
        loop {
            let status: Option<Arc<Snapshot<S>>> = self.robot.monitor().last_known_packet();
            match next(self.time(), status.as_deref()) {
                ControlFlow::Continue(target) => self.send_joints(target)?,
                ControlFlow::Break(end) => return Ok(end),
            }
        }
    }

    /// Waits for the next cycle, and returns how late it is.
    fn next_cycle(&mut self) -> Result<Duration, Error> {
        if let Some(because) = self.ended.clone() {
            return Err(ErrorKind::SessionEnded { because }.into());
        }
        let late = self.pace.wait();
        if late >= self.config.period() {
            self.sent.paused();
        }
        Ok(late)
    }

    fn send_checked_joints(&mut self, request: ServoJ, target: Option<JointPosition>) -> Result<(), Error> {
        let late = self.next_cycle()?;
        let checked = self.robot.check_joints(&self.sent, target, self.config.period());
        let target = checked.map_err(|error| self.end(error))?;
        self.send_to(&request.step_count(self.config.step_count.into()), target, late)
    }

    fn send_checked_pose(&mut self, request: ServoP, target: Option<Pose>) -> Result<(), Error> {
        let late = self.next_cycle()?;
        let checked = self.robot.check_pose(&self.sent, target, self.config.period());
        let joints = checked.map_err(|error| self.end(error))?;
        self.send_to(&request.step_count(self.config.step_count.into()), joints, late)
    }

    /// Sends a set-point at which the joints are here, where that is known.
    fn send_to<C: Command<Reply = ()>>(
        &mut self,
        request: &C,
        joints: Option<JointPosition>,
        late: Duration,
    ) -> Result<(), Error> {
        if let Err(error) = self.send(request, late) {
            self.last = self.last.filter(|_| !error.may_have_run());
            return Err(error);
        }
        self.last = joints;
        self.sent.sent(joints);
        Ok(())
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

    fn send<C: Command<Reply = ()>>(&mut self, request: &C, late: Duration) -> Result<(), Error> {
        // After the wait: a stop may have come meanwhile.
        if let Err(error) = self.take_answers(C::INFO.name) {
            return Err(self.end(error));
        }
        if let Some(refusal) = self.refusal.take() {
            return Err(self.end(refusal));
        }
        self.robot.check_latch()?;
        if let Err(error) = self.check_unanswered() {
            return Err(self.end(error));
        }
        let gate = self.robot.gate();
        let posted = self.robot.client().post(Some(&gate), std::slice::from_ref(request));
        let ends = |error: &Error| error.is_disconnected() || matches!(error.kind(), ErrorKind::StatusUnknown { .. });
        let outstanding = match posted {
            Err(error) if ends(&error) => return Err(self.end(error)),
            posted => posted?,
        };
        self.report.late(late, self.config.period());
        self.report.most_outstanding = self.report.most_outstanding.max(outstanding);
        Ok(())
    }

    /// On a link that stalls, set-points would accumulate, and move the arm when they are no longer wanted.
    fn check_unanswered(&mut self) -> Result<(), Error> {
        let link = self.robot.client().link();
        let count = link.outstanding();
        if count < self.config.most_unanswered() {
            return Ok(());
        }
        let oldest = link.oldest_posted().unwrap_or_default();
        Err(link.attach(ErrorKind::SetPointsUnanswered { count, oldest }.into()))
    }

    pub(super) fn take_answers(&mut self, command: &str) -> Result<(), Error> {
        let (answers, checked) = self.robot.client().link().drain(command);
        self.count(answers);
        checked
    }

    pub(super) fn count(&mut self, answers: Answers) {
        self.report.accepted += answers.accepted;
        for error in answers.failed {
            if matches!(error.kind(), ErrorKind::ReplyLost { .. }) {
                // Whether the controller took it is not known.
                (self.last, self.sent) = (None, SetPoints::default());
                self.report.unanswered += 1;
            } else {
                self.report.refused += 1;
                self.refusal.get_or_insert(error);
            }
        }
    }
}

impl<S: MotionStatus> fmt::Debug for ServoSession<'_, S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("ServoSession").field("config", &self.config).field("time", &self.time()).finish_non_exhaustive()
    }
}
