//! A session in servo mode.

use std::cell::Cell;
use std::fmt;
use std::ops::ControlFlow;
use std::time::Duration;

use jaka_clock::Stopwatch;
use jaka_proto::Command;
use jaka_proto::messages::servo::{ServoJ, ServoP};
use jaka_proto::messages::types::{JointPosition, Pose};
use jaka_proto::recording::MotionStep;
use jaka_sync::layer::{Answers, ClientParts as _, Gate, Kept, Leading, Owner};

use super::ServoConfig;
use super::course::Course;
use super::departure::Departure;
use super::pace::{Cycle, Pace};
use super::rates::Rates;
use super::realtime::RealtimePriority;
use super::set_point::{SetPoint, SetPointStep};
use crate::arm::{Arm, Sending, Since, kept_back};
use crate::error::SessionEnd;
use crate::limits::LimitChecks;
use crate::under_way::UnderWay;
use crate::{Cause, Error, ErrorKind, Occurrence, Report, Rest, Snapshot};

/// The robot in servo mode, from [`Robot::enter_servo_mode`](crate::Robot::enter_servo_mode): set-points go out once in
/// each servo period, and their replies are counted, not waited for.
///
/// Each call sends one set-point in the next cycle. [`land`](Self::land) brakes the arm, leaves servo mode and reports;
/// dropping the session does the same without a report, also while a panic unwinds.
///
/// # Entering
/// [`Robot::enter_servo_mode`](crate::Robot::enter_servo_mode) waits until the arm is
/// [at rest](crate::Robot::wait_for_rest). It fails with [`ErrorKind::NotSent`] if the arm still moves after
/// [`ServoConfig::enter_timeout`], or a query fails; with [`ErrorKind::NotReady`] if the program has not waited for the
/// end of a motion, if servo mode is on already, and if the controller acknowledges servo mode and does not enter it;
/// with [`ErrorKind::NotAcknowledged`] after a stop, with [`ErrorKind::StatusUnknown`] if the status is stale, missing
/// or unreadable, with [`ErrorKind::InvalidOption`] for an invalid value of the configuration, and as
/// [`Client::call`](crate::Client::call). After a failure, the session leaves servo mode again;
/// [`ErrorKind::ServoModeNotLeft`] if that is not confirmed.
///
/// # Set-points
/// Each set-point is compared with the previous ones, by its nominal period, as the controller does (4.15): a joint may
/// not be faster than 180 deg/s, and [`SessionConfig`](crate::SessionConfig) limits the change of speeds. Set-points of
/// poses are compared with each other. The first step is from standstill. A set-point that is late by a period or more
/// delays all later ones, and none is skipped. Without limits, a change from poses to absolute joint positions is
/// refused, since its distance is not known. [`SessionConfig::unchecked`](crate::SessionConfig::unchecked) turns these
/// checks off.
///
/// # Late set-points
/// A set-point that is late by three periods or more follows a gap: the controller had no set-point at a due time. No
/// source states the reaction of an arm; three periods are ours. If each joint was slower than its acceleration limit
/// times one period, the session assumes that the arm rests: it continues, and compares the step with standstill.
/// Otherwise the session ends with [`ErrorKind::SetPointLate`]. It then sends no set-points that brake, since the
/// motion to brake is over, and holds the last one. [`report`](Self::report) has the lateness. On a machine with other
/// work, give the thread `ServoConfig::realtime_priority`.
///
/// # Landing
/// If a set-point is refused, here or by the controller, in the middle of a motion, the arm must not stop at once: a
/// missing set-point after the last one at 175 deg/s is a braking of 21,900 deg/s². So every session ends by a landing,
/// for any cause: the call that fails, [`land`](Self::land), a drop, a panic, a [`RobotStop`](crate::RobotStop), an
/// unknown status, or packets that show no power, an arm that is not enabled, an error, a soft limit or drag mode. The
/// session brakes the arm straight on, all joints in proportion, with the acceleration of
/// [`ServoConfig`] or, if the robot has limits, of these. Then it holds the last set-point until status packets show
/// the arm at rest there ([`ServoConfig::rest_timeout`]), and leaves servo mode. A stop by the program itself brakes
/// first, and then sends `stop_program`.
///
/// In drag mode set-points brake the arm only while its joints are known to follow them, and nothing holds the arm
/// against the hand that leads it.
///
/// A protective stop, an emergency stop and a lost or stalled connection end the session at once, without a landing. No
/// source states the behaviour of an arm at speed then, or after the program is killed.
///
/// # A link that stalls
/// If set-points stay unanswered ([`ServoConfig::max_unanswered`]), the session sends no more: it leaves servo mode,
/// and the call fails with [`ErrorKind::SetPointsUnanswered`]. If the end of servo mode is not answered within a
/// second, the session resets the connection, which discards the set-points that the system has not sent, and the error
/// is [`ErrorKind::ServoModeNotLeft`]. Set-points that the network or the controller already has may still move the
/// arm: at most the unanswered ones.
///
/// A session that [`std::mem::forget`] takes never ends: the robot stays in servo mode, motions of the connection are
/// refused, and each stop waits its 3 s for a braking that nobody does, then goes out. Drop the connection.
///
/// ```no_run
/// # use jaka_robot::{Robot, ServoConfig};
/// let mut robot = Robot::connect("10.5.5.100")?;
/// let mut session = robot.enter_servo_mode(ServoConfig::new())?;
/// for _ in 0..125 {
///     session.send_joint_offset([0.01, 0.0, 0.0, 0.0, 0.0, 0.0])?;
/// }
/// let report = session.land()?.report;
/// println!("{} set-points, 99 % within {:?}", report.cycles, report.lateness(0.99));
/// # Ok::<(), jaka_robot::Error>(())
/// ```
#[must_use = "dropping a session ends it; `land` does so, too, and reports"]
pub struct ServoSession<'r> {
    pub(crate) arm: &'r mut Arm,
    pub(crate) limits: &'r mut LimitChecks,
    /// Owner of the set-points.
    pub(super) owner: Owner,
    /// Keeps back commands of other handles, until the session ends.
    pub(super) lead: Option<Leading>,
    pub(super) config: ServoConfig,
    pub(super) rates: Rates,
    pub(super) pace: Pace,
    /// The last set-points, by which the next one is checked, and from which the arm is braked.
    pub(super) course: Course,
    pub(super) departure: Departure,
    pub(crate) report: Report,
    pub(super) under_way: UnderWay,
    /// Packets after which news ends the session.
    pub(super) since_packet: Since,
    /// News of packets that ends the session: the first, unless a stop or drag mode follows.
    pub(super) news: Option<Occurrence>,
    /// True once packets have shown drag mode: set-points may work against a hand.
    pub(super) is_led_by_hand: bool,
    /// True if the session ends because the joints have departed from their set-points.
    pub(super) has_departed: bool,
    /// Rest of the arm at its last set-point, before servo mode is left.
    pub(crate) rest: Rest,
    /// Time since servo mode was entered.
    pub(super) since: Stopwatch,
    pub(super) refusal: Option<Error>,
    /// Cycle that has begun, while its set-point has not gone out.
    pub(super) begun: Option<Cycle>,
    /// True while servo mode is to be left.
    pub(super) is_open: bool,
    /// Reason why no more set-points go out, if so.
    pub(super) ended: Option<SessionEnd>,
    /// Real-time priority of this thread, until the session ends.
    pub(super) priority: Option<RealtimePriority>,
}

impl ServoSession<'_> {
    /// The time of the next set-point: the sum of the periods before it.
    pub fn time(&self) -> Duration {
        self.pace.time()
    }

    /// Report of the session so far; the whole one once the session has ended.
    pub fn report(&self) -> &Report {
        &self.report
    }

    /// Waits for the next cycle and sends a set-point for all joints.
    ///
    /// # Errors
    /// After each of these errors the session has ended, and the arm was braked, unless the text says otherwise or the
    /// controller refused: then it follows no more set-points, not even for braking; [`ErrorKind::ServoModeNotLeft`] if
    /// servo mode may be on, [`ErrorKind::RestNotSeen`] if the arm was not seen at rest.
    /// - [`InvalidArgument`](jaka_sync::ErrorKind::InvalidArgument): a joint would have to be too fast, or to become so
    ///   too soon. The set-point was not sent.
    /// - `ErrorKind::BeyondLimit`, `ErrorKind::NotChecked`: the robot has limits. The set-point was not sent.
    /// - [`ErrorKind::SetPointLate`]: the set-point is late by three periods or more, in the middle of a motion. It was
    ///   not sent, and nothing braked the arm.
    /// - [`ErrorKind::RobotState`] with [`Cause::FramesChanged`]: the robot has limits that depend on the selected
    ///   frames. The set-point was not sent.
    /// - [`ErrorKind::Refused`]: the controller has refused an earlier set-point.
    /// - [`ErrorKind::NotAcknowledged`], [`ErrorKind::NotReady`]: a stop, or drag mode.
    /// - [`ErrorKind::RobotState`]: packets, or the controller's answer after a refusal, show no power, an arm that is
    ///   not enabled, an error of the controller or a soft limit.
    ///   [`Disconnected`](jaka_sync::ErrorKind::Disconnected): the connection is lost.
    /// - [`ErrorKind::SetPointsUnanswered`], [`ErrorKind::StatusUnknown`]: one of the ports no longer responds.
    /// - [`ErrorKind::SessionEnded`]: the session had ended before.
    pub fn send_joints(&mut self, target: impl Into<JointPosition>) -> Result<(), Error> {
        self.send(SetPoint::Joints(target.into()))
    }

    /// Waits for the next cycle and sends a set-point by an offset of all joints from the one before.
    ///
    /// # Errors
    /// As [`send_joints`](Self::send_joints).
    pub fn send_joint_offset(&mut self, offset: impl Into<JointPosition>) -> Result<(), Error> {
        self.send(SetPoint::JointOffset(offset.into()))
    }

    /// Waits for the next cycle and sends a set-point for the tool centre point.
    ///
    /// The speeds of the joints that follow from it are the controller's to check, unless the robot has limits. It is
    /// compared with the set-point before if that is a pose, too, or the first, and the robot has no limits.
    ///
    /// Once status packets show another tool frame or user frame than at the start, no pose is sent any more: the call
    /// fails with [`Cause::FramesChanged`]. With limits the arm is braked in joints. Without, the joint positions
    /// are not known, nothing brakes the arm, and the error is [`ErrorKind::NotLanded`].
    ///
    /// # Errors
    /// As [`send_joints`](Self::send_joints).
    pub fn send_pose(&mut self, target: impl Into<Pose>) -> Result<(), Error> {
        self.send(SetPoint::Pose(target.into()))
    }

    /// Waits for the next cycle and sends a set-point by an offset of the tool centre point.
    ///
    /// No source says along which axes it goes, so a robot with limits refuses it.
    ///
    /// # Errors
    /// As [`send_joints`](Self::send_joints).
    pub fn send_pose_offset(&mut self, offset: impl Into<Pose>) -> Result<(), Error> {
        self.send(SetPoint::PoseOffset(offset.into()))
    }

    /// Calls `next` before each cycle, with the cycle's time and the last status, and sends the joints that it returns,
    /// until it returns `Break`.
    ///
    /// The time counts set-points, [`time`](Self::time), and is not the clock's: a late cycle delays a motion that is a
    /// function of it.
    ///
    /// # Errors
    /// As [`send_joints`](Self::send_joints).
    pub fn run<B>(
        &mut self,
        mut next: impl FnMut(Duration, Option<&Snapshot>) -> ControlFlow<B, JointPosition>,
    ) -> Result<B, Error> {
        loop {
            let status = self.arm.state.newest_packet();
            match next(self.time(), status.as_deref()) {
                ControlFlow::Continue(target) => self.send_joints(target)?,
                ControlFlow::Break(end) => return Ok(end),
            }
        }
    }

    /// Sends a set-point in the next cycle, or ends the session.
    fn send(&mut self, set_point: SetPoint) -> Result<(), Error> {
        if let Some(end) = self.ended.clone() {
            return Err(end.into_error());
        }
        let cycle = self.wait_for_cycle();
        let sent = self.check_news().and(cycle).and_then(|_| {
            // After a lost reply it is not known where an offset has led.
            self.take_answers(ServoJ::INFO.name)?;
            self.look_at_frames();
            if set_point.is_pose() || self.limits.depend_on_frames() {
                self.check_frames()?;
            }
            let joints = self.check(&set_point)?;
            self.send_checked(set_point, joints, Duration::MAX)
        });
        sent.map_err(|error| self.end(error))
    }

    /// Takes the news of the packets that have come.
    pub(super) fn look_for_news(&mut self) {
        let Some(news) = self.arm.state.news(self.since_packet, |_| true) else { return };
        self.is_led_by_hand |= news.cause == Cause::DragMode;
        if self.news.as_ref().is_none_or(|first| news.consequence().latches() && news.cause < first.cause) {
            self.news = Some(news);
        }
    }

    /// Fails once packets have shown a state of the robot that ends the session.
    pub(super) fn check_news(&mut self) -> Result<(), Error> {
        self.look_for_news();
        let Some(news) = self.news.clone() else { return Ok(()) };
        // After a stop of the program, an error of the controller is its consequence.
        let is_stopped = self.lead.is_some() && self.arm.stops().check_set_point().is_err();
        if is_stopped && !news.consequence().latches() {
            return Err(self.arm.attach(kept_back(Kept::Stopped)));
        }
        Err(self.ended_by(news))
    }

    /// Error of a session that the state of the robot has ended.
    pub(super) fn ended_by(&self, occurrence: Occurrence) -> Error {
        let latches = occurrence.consequence().latches();
        let kind =
            if latches { ErrorKind::NotAcknowledged { occurrence } } else { ErrorKind::RobotState { occurrence } };
        self.arm.attach(kind)
    }

    /// Reads changes under way from the newest packet.
    pub(super) fn look_at_frames(&mut self) {
        if let Some(newest) = self.arm.state.newest_packet() {
            self.under_way.see(&newest);
            self.report.saw(&self.under_way);
        }
    }

    /// Fails if other frames are selected than at the start.
    pub(super) fn check_frames(&mut self) -> Result<(), Error> {
        self.under_way.change().map_or(Ok(()), |change| {
            Err(ErrorKind::RobotState { occurrence: Occurrence::frames_changed(change) }.into())
        })
    }

    /// Counts a set-point that went out so late, and the gap before it unless its cycle has begun after one.
    fn went_out(&mut self, late: Duration, begun: Option<Cycle>) {
        let period = self.config.period();
        if late >= self.config.gap() && begun.is_none_or(|cycle| cycle.late < self.config.gap()) {
            self.count_gap(late);
        }
        self.report.late(late, period);
        if late >= period && late < self.config.gap() {
            let text = || format!("a set-point is {late:.1?} late");
            self.arm.link().record_motion(MotionStep::Late, text);
        }
    }

    /// Counts a gap before a set-point that is so late.
    pub(super) fn count_gap(&mut self, late: Duration) {
        self.report.gap(late);
        let text = || format!("a set-point is {late:.1?} late: the controller had none when several were due");
        self.arm.link().record_motion(MotionStep::Gap, text);
    }

    /// Waits for the next cycle, and returns its lateness. Fails after a gap in the middle of a motion.
    pub(super) fn wait_for_cycle(&mut self) -> Result<Duration, Error> {
        let cycle = self.pace.wait();
        let late = cycle.late;
        self.begun = Some(cycle);
        if late < self.config.gap() {
            return Ok(late);
        }
        let may_go_on = self.stands_within_a_period();
        self.course.paused();
        self.count_gap(late);
        if may_go_on {
            return Ok(late);
        }
        // A stop may have come meanwhile, and says more.
        self.arm.gate(Sending::SetPoint)().and(Err(ErrorKind::SetPointLate { late }.into()))
    }

    /// True if each joint was slower than its acceleration limit times a period at the last set-point, so that an arm
    /// without a set-point is taken to stand.
    fn stands_within_a_period(&self) -> bool {
        let rates = &self.rates;
        let brakes_at_once = |step: SetPointStep| rates.periods_to_brake(&step, self.config.period()) <= 1;
        !self.course.has_begun() || self.course.step_of_joints().is_some_and(brakes_at_once)
    }

    /// Checks a set-point, and returns the joint positions at it, if they are known.
    fn check(&mut self, set_point: &SetPoint) -> Result<Option<JointPosition>, Error> {
        let period = self.config.period();
        // Limits know the joints for a pose, too.
        if !(set_point.is_pose() && self.limits.checker().is_some()) {
            let step = self.course.step_to(set_point);
            let before = step.as_ref().and_then(|step| self.course.last_step(step));
            match (step, before) {
                (Some(step), Some(before)) => self.rates.check(&step, &before, period)?,
                // Only if the pose at the start is not known.
                _ if !self.course.has_begun() => {}
                _ => self.rates.check_unknown(set_point)?,
            }
        }
        let (before, joints) = (self.course.last_joints(), self.course.joints_at(set_point));
        match *set_point {
            SetPoint::Joints(_) | SetPoint::JointOffset(_) => {
                self.limits.check_joints(self.arm, before, joints, period)
            }
            SetPoint::Pose(target) => self.limits.check_pose(self.arm, before, Some(target), period),
            SetPoint::PoseOffset(_) => self.limits.check_pose(self.arm, before, None, period),
        }
    }

    /// Sends a set-point that has been checked, after the answers were taken. Refused where it is later than `most`,
    /// or follows a gap and the arm moves or cannot begin with it.
    pub(super) fn send_checked(
        &mut self,
        set_point: SetPoint,
        joints: Option<JointPosition>,
        most: Duration,
    ) -> Result<(), Error> {
        // After the wait: a stop may have come meanwhile.
        if let Some(refusal) = self.refusal.take() {
            return Err(refusal);
        }
        self.arm.check_acknowledged()?;
        self.check_unanswered()?;
        let (gate, begun) = (self.arm.gate(Sending::SetPoint), self.begun);
        let most = if self.can_begin_with(&set_point, joints) { most } else { most.min(self.most_without_gap()) };
        let late = self.post(&set_point, &gate, most)?;
        self.course.sent(set_point, joints);
        self.departure.sent(joints);
        self.went_out(late, begun);
        self.expect_set_point(self.course.is_moving());
        Ok(())
    }

    /// Tells stops whether another set-point is to come that moves or brakes the arm: they wait for it.
    pub(super) fn expect_set_point(&self, is_moving: bool) {
        if let Some(lead) = &self.lead {
            lead.expect_set_point(is_moving.then(|| self.arm.clock().now() + self.config.gap() * 2));
        }
    }

    /// Ends the lead. Where the arm was not seen at rest, other commands are kept back until it is.
    pub(super) fn end_lead(&mut self) {
        if let Some(lead) = self.lead.take()
            && self.rest.was_seen()
        {
            lead.end_at_rest();
        }
    }

    /// True if an arm at rest at the last set-point can continue with this one.
    fn can_begin_with(&self, next: &SetPoint, joints: Option<JointPosition>) -> bool {
        let in_joints = self.course.last_joints().zip(joints);
        let step = in_joints.map(|([_, last], joints)| SetPointStep::between_joints(last, joints));
        let step = step.or_else(|| self.course.step_to(next));
        step.is_none_or(|step| self.rates.check(&step, &step.scaled(0.0), self.config.period()).is_ok())
    }

    /// Greatest lateness that is not a gap.
    fn most_without_gap(&self) -> Duration {
        self.config.gap().saturating_sub(Duration::from_nanos(1))
    }

    /// Sends the set-point of the cycle that has begun, and returns its lateness: that at the gate, since the thread
    /// may be held up until the moment of the write. Fails for one later than `most`, and for one that follows a gap in
    /// the middle of a motion.
    pub(super) fn post(
        &mut self,
        set_point: &SetPoint,
        gate: &dyn Fn() -> Result<(), Error>,
        most: Duration,
    ) -> Result<Duration, Error> {
        let (steps, clock) = (self.config.step_count.into(), self.arm.clock().clone());
        let gap = if self.stands_within_a_period() { Duration::MAX } else { self.config.gap() };
        let (owner, client, begun, lateness) = (self.owner, self.arm.client(), self.begun, Cell::new(Duration::ZERO));
        let gate = || {
            gate()?;
            let late = begun.map_or(Duration::ZERO, |cycle| clock.elapsed(cycle.due));
            lateness.set(late);
            if late > most || late >= gap { Err(ErrorKind::SetPointLate { late }.into()) } else { Ok(()) }
        };
        let gate: Gate<'_, Error> = Some(&gate);
        let outstanding = match *set_point {
            SetPoint::Joints(target) => client.post(owner, gate, &[ServoJ::absolute(target).step_count(steps)]),
            SetPoint::JointOffset(offset) => client.post(owner, gate, &[ServoJ::relative(offset).step_count(steps)]),
            SetPoint::Pose(target) => client.post(owner, gate, &[ServoP::absolute(target).step_count(steps)]),
            SetPoint::PoseOffset(offset) => client.post(owner, gate, &[ServoP::relative(offset).step_count(steps)]),
        }?;
        let late = lateness.get();
        if let Some(cycle) = self.begun.take() {
            self.pace.went_out(cycle, late);
        }
        self.report.most_outstanding = self.report.most_outstanding.max(outstanding);
        Ok(late)
    }

    /// On a stalled link, set-points would accumulate, and move the arm later than wanted.
    pub(super) fn check_unanswered(&mut self) -> Result<(), Error> {
        let link = self.arm.link();
        let count = link.outstanding(self.owner);
        if count < self.config.most_unanswered() {
            return Ok(());
        }
        let oldest = link.oldest_posted(self.owner).unwrap_or_default();
        Err(self.arm.attach(ErrorKind::SetPointsUnanswered { count, oldest }))
    }

    pub(super) fn take_answers(&mut self, command: &str) -> Result<(), Error> {
        let (answers, checked) = self.arm.link().drain(self.owner, command);
        self.count(answers);
        Ok(checked?)
    }

    pub(super) fn count(&mut self, answers: Answers) {
        self.report.accepted += answers.accepted;
        for error in answers.failed {
            if matches!(error.kind(), jaka_sync::ErrorKind::ReplyLost { .. }) {
                // The controller may have taken it.
                self.course.lost();
                self.report.unanswered += 1;
            } else {
                self.report.refused += 1;
                self.refusal.get_or_insert(error.into());
            }
        }
    }
}

impl fmt::Debug for ServoSession<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("ServoSession").field("config", &self.config).field("time", &self.time()).finish_non_exhaustive()
    }
}
