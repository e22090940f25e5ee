//! Motions that are sent one by one, and waited for.

mod batch;
mod destination;
mod guard_thread;
mod guarded;
mod rule;
mod wait;

use std::sync::Arc;
use std::time::Duration;

use jaka_proto::messages::power::GetRobotState;
use jaka_proto::recording::MotionStep;
use jaka_sync::layer::ClientParts as _;

use self::batch::{Batch, Begin, GoalFrames};
use self::destination::Destination;
use self::guarded::GuardedRun;
use self::rule::EndRule;
pub(crate) use self::rule::Grace;
use self::wait::EndWait;
use crate::arm::{Arm, REST, SETTLING, Sending, Sent};
use crate::cause::{Consequence, Occurrence};
use crate::guard::Armed;
use crate::limits::{Beginning, LimitChecks};
use crate::motions::PlannedMotion;
use crate::place::Quantity;
use crate::{Cause, End, Error, Report, Rest, Run};

/// Motions that have been started, and the options of the wait for their end.
#[derive(Debug)]
pub(crate) struct Planned {
    /// Motions that were accepted and have not been waited for.
    batch: Option<Batch>,
    /// True if motions were given up that the arm may not have begun yet, and it was not seen to rest since.
    has_given_up: bool,
    pub(crate) grace: Grace,
    /// Longest time without a status packet during a wait.
    pub(crate) silence: Duration,
}

impl Planned {
    pub(crate) fn new(grace: Grace, silence: Duration) -> Self {
        Self { batch: None, has_given_up: false, grace, silence }
    }

    /// True if motions were accepted that have not been waited for.
    pub(crate) fn has_motions(&self) -> bool {
        self.batch.is_some()
    }

    /// Gives the motions up, which the arm may not have begun yet: true if there were some.
    pub(crate) fn give_up(&mut self) -> bool {
        let had_motions = self.has_motions();
        if had_motions {
            (self.batch, self.has_given_up) = (None, true);
        }
        had_motions
    }

    /// Time for which an arm must be seen to rest: after motions that were given up, as long as one may take to begin.
    pub(crate) fn settling(&self) -> Duration {
        if self.has_given_up { self.grace.time } else { Duration::ZERO }
    }

    fn accepted(&mut self, arm: &Arm, goal: Destination, begin: Begin) {
        // Packets that came before the reply may be older than the motion.
        let (now, packet) = (arm.clock().now(), arm.state.now_on().states);
        self.batch = Some(match self.batch.take() {
            Some(batch) => batch.then(now, packet, goal, begin),
            None => Batch::new(now, packet, goal, begin),
        });
    }
}

/// The parts of a robot that a motion concerns.
#[derive(Debug)]
pub(crate) struct Moving<'a> {
    pub(crate) arm: &'a mut Arm,
    pub(crate) limits: &'a mut LimitChecks,
    pub(crate) planned: &'a mut Planned,
}

impl Moving<'_> {
    /// Sends a motion, and waits for its end.
    pub(crate) fn run(mut self, run: &impl Run, timeout: Duration) -> Result<End, Error> {
        let motion = run.motion();
        if let Some(guard) = motion.guard {
            let depends_on_frames = self.depends_on_frames(motion);
            return GuardedRun { moving: self, guard, depends_on_frames }.run(motion, timeout);
        }
        let since = self.arm.clock().stopwatch();
        self.send(motion, timeout, None)?;
        Ok(self.wait(since.left_of(timeout)))
    }

    /// Sends a motion, under a guard if there is one, which lets it out or not.
    pub(crate) fn send(
        &mut self,
        motion: PlannedMotion<'_>,
        timeout: Duration,
        guard: Option<&Armed>,
    ) -> Result<(), Error> {
        let since = self.arm.clock().stopwatch();
        self.arm.link().check_open(motion.info.name)?;
        self.arm.check_acknowledged()?;
        let left = || since.left_of(timeout);
        let not_sent = |error: Error| error.before(motion.info.name);
        self.arm.rest_after_stop(left()).map_err(not_sent)?;
        let begin = self.begin(motion, left()).map_err(not_sent)?;
        let beginning = if self.planned.has_motions() { Beginning::InQueue } else { Beginning::AtRest(begin.start) };
        let times = (self.planned.grace.time, left());
        let end = self.limits.check_motion(self.arm, motion, beginning, times).map_err(not_sent)?;
        let gate = self.arm.gate(Sending::Motion);
        let guarded = || gate().and_then(|()| guard.map_or(Ok(()), Armed::let_out));
        let sent = self.arm.client().call_written(Some(&guarded), (motion.info, motion.request), left());
        self.arm.moved_after(begin.frames.changes);
        match sent {
            Ok(()) => {
                let goal = Destination::new(motion.target, motion.tolerance_mm, begin.start);
                self.planned.accepted(self.arm, goal, begin);
                self.limits.plan(self.arm, end);
            }
            Err(error) => {
                let error = Error::from(error);
                // It can still be waited for.
                if error.may_have_run() {
                    self.planned.accepted(self.arm, Destination::Unknown, begin);
                    self.limits.forget_plan();
                }
                return Err(self.arm.explained(error, left()));
            }
        }
        Ok(())
    }

    /// True if the motion, its guard or the limits depend on the selected frames.
    fn depends_on_frames(&self, motion: PlannedMotion<'_>) -> bool {
        motion.depends_on_frames() || self.limits.depend_on_frames()
    }

    /// State of the arm before a motion, as far as it is known.
    fn begin(&mut self, motion: PlannedMotion<'_>, timeout: Duration) -> Result<Begin, Error> {
        let since = self.arm.clock().stopwatch();
        let stops = self.arm.stops().begun();
        let Some(newest) = self.arm.known_status(timeout)? else {
            return Ok(Begin { stops, ..Begin::default() });
        };
        let (changes, by_others) = (self.arm.link().frame_changes(), self.arm.changes_by_others());
        let under_way = self.arm.under_way();
        let frames = GoalFrames { shown: under_way.frames(), changes, by_others };
        let mut begin = Begin::new(&newest, frames, under_way);
        (begin.stops, begin.depends_on_frames) = (stops, self.depends_on_frames(motion));
        let is_first_at_rest = !self.planned.has_motions() && begin.at_rest;
        if let Some(quantity) = Quantity::of_start(motion.target).filter(|_| is_first_at_rest) {
            let (settling, left) = (self.planned.settling(), since.left_of(timeout));
            let position = &mut self.arm.position;
            begin.start = if settling.is_zero() {
                position.place_at_rest(quantity, left)?
            } else {
                position.place_settled(quantity, settling, left)?
            };
            self.planned.has_given_up &= begin.start.is_none();
        }
        begin.at_rest &= !self.planned.has_given_up;
        Ok(begin)
    }

    /// Waits for the end of all motions that were started.
    pub(crate) fn wait(&mut self, timeout: Duration) -> End {
        let mut end = self.wait_unless(timeout, &|| false);
        self.settle_cause(&mut end);
        if end.occurrence.consequence().stops() {
            let stop = self.arm.stop_handle().end_motion();
            self.take(&stop);
            self.come_to_rest(&mut end, &stop);
            end.stop = Some(stop.accepted);
        }
        self.record(&end);
        end
    }

    /// Waits as [`wait`](Self::wait), and gives up, with [`Cause::Deadline`], once `gives_up` says so. The end is yet
    /// to be reported.
    fn wait_unless(&mut self, timeout: Duration, gives_up: &dyn Fn() -> bool) -> End {
        let since = self.arm.clock().stopwatch();
        let Some(mut batch) = self.planned.batch.take() else {
            return End::new(Cause::NoMotion, Rest::NotSeen, Report::of_wait(Duration::ZERO));
        };
        let frame_changes = self.arm.link().frame_changes();
        batch.wait_after(frame_changes, self.arm.changes_by_others());
        let mut rule = EndRule::new(batch, frame_changes, self.planned.grace);
        let mut wait = EndWait { arm: self.arm, rule: &mut rule, silence: self.planned.silence };
        let (occurrence, rest) = wait.end(timeout, gives_up);
        let (cause, consequence) = (occurrence.cause, occurrence.consequence());
        let is_at_rest = rest == Rest::Answers && matches!(cause, Cause::Reached | Cause::AtRest);
        self.arm.position.note_rest(is_at_rest);
        self.planned.has_given_up &= !is_at_rest;
        if consequence.latches() {
            self.arm.state.latch(&occurrence);
        }
        let mut report = Report::of_wait(since.passed()).without(self.arm.absent());
        report.saw(&rule.batch.under_way);
        if consequence == Consequence::GoesOn {
            // The motions may continue: the program can wait for them again.
            self.planned.batch = Some(rule.batch);
        }
        let mut end = End::new(occurrence, rest, report);
        end.packets = rule.packets.into();
        // A connection that is lost is the cause.
        end.error = rule.failure.filter(|failure| !failure.is_disconnected());
        end.error = end.error.or_else(|| self.arm.position.unanswered().filter(|_| cause == Cause::Deadline));
        end
    }

    /// Takes note of a stop, which the end or the error reports, and no other: true if it was accepted. Its motion is
    /// not waited for any more then.
    fn take(&mut self, stop: &Sent) -> bool {
        if stop.accepted.is_ok() {
            // The controller begins none of them.
            self.planned.batch = None;
            self.limits.unsettle();
        }
        stop.accepted.is_ok()
    }

    /// Waits until an arm that was stopped rests, and notes that in the end: true if it does.
    fn come_to_rest(&mut self, end: &mut End, stop: &Sent) -> bool {
        let rest = stop.accepted.is_ok().then(|| self.arm.position.wait_for_rest(REST));
        let is_at_rest = matches!(rest, Some(Ok(_)));
        end.rest = if is_at_rest { Rest::Answers } else { Rest::NotSeen };
        // An arm that still brakes is in order.
        let failure = rest.and_then(Result::err).filter(|error| error.is_disconnected() || error.is_timeout());
        end.error = failure;
        is_at_rest
    }

    /// Settles the cause where packets stay away: a controller that has gone answers nothing either. Under a guard the
    /// stop settles it.
    fn settle_cause(&mut self, end: &mut End) {
        if end.occurrence.cause != Cause::StatusLost {
            return;
        }
        let Err(error) = self.arm.queries().call_within(&GetRobotState::new(), SETTLING) else { return };
        match error.kind() {
            jaka_sync::ErrorKind::Disconnected { address, cause, .. } => {
                end.occurrence = Occurrence::commands_lost(address.clone(), Arc::clone(cause));
            }
            _ => end.error = end.error.take().or(Some(error.into())),
        }
    }

    /// Records how motions ended, if there were some.
    fn record(&self, end: &End) {
        let step = match end.occurrence.cause {
            Cause::NoMotion => return,
            Cause::Reached | Cause::AtRest => MotionStep::Done,
            _ => MotionStep::Failed,
        };
        self.arm.link().record_motion(step, || end.occurrence.to_string());
    }
}
