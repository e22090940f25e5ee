//! Motions under a guard.

use std::sync::Arc;
use std::thread;
use std::time::Duration;

use jaka_proto::CommandInfo;
use jaka_sync::layer::{OnDrop, Watched};

use super::Moving;
use super::guard_thread::{GuardThread, Stopped, Why, lost};
use crate::arm::unknown;
use crate::cause::Occurrence;
use crate::guard::{Armed, Guard, longest_silence, packet_period};
use crate::motions::PlannedMotion;
use crate::{End, Error, ErrorKind, GuardTrip, NotGuarded, Path, Report, Rest, TripReason};

/// Run of one motion under a guard.
#[derive(Debug)]
pub(crate) struct GuardedRun<'a> {
    pub(crate) moving: Moving<'a>,
    pub(crate) guard: &'a Guard,
    /// True if the motion, its guard or the limits depend on the selected frames.
    pub(crate) depends_on_frames: bool,
}

impl GuardedRun<'_> {
    /// Sends a motion, and waits until it has ended or the guard has tripped, upon which the arm is stopped.
    pub(crate) fn run(mut self, motion: PlannedMotion<'_>, timeout: Duration) -> Result<End, Error> {
        let arm = &self.moving.arm;
        let since = arm.clock().stopwatch();
        self.guard.check()?;
        arm.link().check_open(motion.info.name)?;
        arm.check_acknowledged()?;
        let left = || since.left_of(timeout);
        let fresh_for = self.check_speed(motion.info, motion.path, left())?;
        let armed = Armed::new(self.guard, &arm.state, left()).map_err(|problem| arm.attach(unknown(problem)))?;
        if let Some(trip) = armed.trip() {
            return self.not_begun(trip, since.passed());
        }
        let guarding = GuardThread::new(arm, armed, fresh_for);
        let is_over = Watched::new(arm.clock(), false);
        let (result, stopped) = thread::scope(|scope| {
            let relieved = OnDrop(|| guarding.relieve());
            let thread = thread::Builder::new().name("jaka guard".to_owned());
            let keep = || {
                let _end = OnDrop(|| {
                    *is_over.lock() = true;
                    is_over.wake();
                });
                guarding.run()
            };
            let spawned = thread.spawn_scoped(scope, self.moving.arm.clock().participating(keep));
            let watching = spawned.map_err(|source| Error::from(ErrorKind::Thread { source }))?;
            let sent = self.moving.send(motion, left(), Some(&guarding.armed));
            let result = sent.map(|()| self.moving.wait_unless(left(), &|| guarding.has_failed()));
            drop(relieved);
            // A panic there has been reported, and has stopped the arm or kept the motion back; if the stop was not
            // accepted, the wait has ended. A join knows nothing of a simulated clock.
            is_over.wait_for(Duration::MAX, |is_over| is_over.then_some(()));
            let stopped = watching.join().unwrap_or_default();
            Ok::<_, Error>((result, stopped.or_else(|| guarding.written())))
        })?;
        match (result, guarding.armed.trip()) {
            (Ok(end), _) => {
                let end = self.end_of_guarded(&guarding, end, stopped);
                self.moving.record(&end);
                Ok(end)
            }
            (Err(error), Some(trip)) if matches!(error.kind(), ErrorKind::GuardTripped { .. }) => {
                self.not_begun(trip, since.passed())
            }
            (Err(error), _) => Err(self.error_of_guarded(&guarding, error, stopped)),
        }
    }

    /// Fails if the guard has a limit of force by which the motion could not be stopped in time; and says how old the
    /// newest packet may become.
    fn check_speed(&self, info: &'static CommandInfo, path: Path, timeout: Duration) -> Result<Duration, Error> {
        let (arm, guard) = (&self.moving.arm, self.guard);
        if guard.force_limits().next().is_none() {
            return Ok(Duration::MAX);
        }
        let refused = |reason: NotGuarded| arm.attach(ErrorKind::NotGuarded { command: info.name.to_owned(), reason });
        let (Path::Line { speed, acceleration } | Path::Arc { speed, acceleration, .. }) = path else {
            return Err(refused(NotGuarded::SpeedUnknown));
        };
        // The guard reports an unknown status.
        let is_in_position =
            arm.state.status_within(timeout).map_or(true, |newest| newest.status.in_position == Some(true));
        if self.moving.planned.has_motions() || !is_in_position {
            return Err(refused(NotGuarded::Moving));
        }
        let period = packet_period(arm, timeout).ok_or_else(|| refused(NotGuarded::PeriodUnknown))?;
        guard.force_limits().try_for_each(|limit| limit.check_speed(speed, acceleration, period)).map_err(refused)?;
        Ok(longest_silence(period))
    }

    /// The end for a guard that has tripped before the motion was sent.
    fn not_begun(&self, trip: GuardTrip, waited: Duration) -> Result<End, Error> {
        if let TripReason::NotShown(reason) = trip.reason {
            return Err(self.moving.arm.attach(ErrorKind::NotShown { what: self.guard.to_string(), reason }));
        }
        let packets = vec![Arc::clone(&trip.packet)];
        let occurrence = Occurrence::trip(trip.before_start());
        Ok(End { packets, ..End::new(occurrence, Rest::NotSeen, Report::of_wait(waited)) })
    }

    /// End of the motion, by the wait for it and by the actions of the guard's thread. Stops the arm if it may still
    /// move.
    fn end_of_guarded(&mut self, guarding: &GuardThread, mut end: End, stopped: Option<Stopped>) -> End {
        let may_move = end.occurrence.consequence().may_move();
        let Some(stopped) = stopped.or_else(|| may_move.then(|| Stopped::new(&guarding.stop, None))) else {
            return end;
        };
        self.moving.take(&stopped.stop);
        // In other frames the tool is elsewhere, so that a guard may trip by the same packet.
        let change = match &stopped.why {
            Some(Why::Trip(trip)) if self.depends_on_frames => end.report.frames.change_to(&trip.packet.status),
            Some(Why::Trip(_) | Why::Blind(_)) | None => None,
        };
        if let Some(change) = change.filter(|_| !end.occurrence.cause.is_of_status()) {
            end.occurrence = Occurrence::frames_changed(change);
        }
        // News of packets against the arm itself counts before that.
        match stopped.why.filter(|_| !end.occurrence.cause.is_of_status()) {
            Some(Why::Trip(trip)) => {
                let reaction = stopped.stop.written.map(|at| at.saturating_duration_since(trip.packet.received));
                let is_at_rest = self.moving.come_to_rest(&mut end, &stopped.stop);
                end.occurrence = Occurrence::trip(GuardTrip { reaction, is_at_rest, ..trip });
            }
            Some(Why::Blind(problem)) => {
                end.occurrence = lost(&problem);
                self.moving.arm.state.latch(&end.occurrence);
            }
            None if end.occurrence.consequence().stops() => {
                self.moving.come_to_rest(&mut end, &stopped.stop);
            }
            None => {}
        }
        end.stop = Some(stopped.stop.accepted);
        end
    }

    /// The error of a motion without a reply: it may run, and nothing evaluates the guard any more.
    fn error_of_guarded(&mut self, guarding: &GuardThread, first: Error, stopped: Option<Stopped>) -> Error {
        let may_run = guarding.armed.has_begun() && first.may_have_run();
        let Some(stopped) = stopped.or_else(|| may_run.then(|| Stopped::new(&guarding.stop, None))) else {
            return first;
        };
        self.moving.take(&stopped.stop);
        match stopped.stop.accepted {
            Err(stopping) if may_run => self.moving.arm.attach(ErrorKind::NotStopped { first, stopping }),
            _ => first,
        }
    }
}
