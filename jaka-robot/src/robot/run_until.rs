//! Motions under a guard.

use std::sync::Arc;
use std::thread;
use std::time::Duration;

use jaka_proto::CommandInfo;
use jaka_sync::layer::{ClientParts as _, Watched};

use super::guard::{Guard, longest_silence};
use super::readiness::unknown;
use super::sentry::{Relieved, Sentry, Stopped, Why, lost};
use super::stops::Sent;
use super::{Motion, MotionStatus, Path, Robot};
use crate::cause::Occurrence;
use crate::error::Attach as _;
use crate::{End, Error, ErrorKind, GuardTrip, NotGuarded, Report, Rest, TripReason};

/// How long an arm that was stopped is waited for until it rests.
const REST: Duration = Duration::from_secs(2);

impl<S: MotionStatus> Robot<S> {
    /// Runs a motion under a guard: sends it, and waits until it has ended or the guard has tripped, upon which the arm is stopped.
    /// [`Guard`] tells what can be expected of that, and what not: it is **not a safety function**.
    ///
    /// A guard that has tripped before the motion goes out, such as by an input that has the level already, sends nothing
    /// ([`GuardTrip::is_before_start`]). The stop is written by the thread that reads the packet, or, where it would have to wait, by one of its own, also while this one waits
    /// for the reply to the motion. If the guard tripped, the arm is then waited for until it rests, for 2 s at most.
    ///
    /// Motions that were started before are ended by the stop, too, but not by a guard that trips before this motion has gone out: wait for them
    /// first.
    ///
    /// Since nobody judges the guard after this call, the arm is stopped in each way out in which it may still move: at the deadline, when
    /// the command connection is lost, which no stop passes any more, when the status is lost or stale ([`Config::stale_after`](crate::Config::stale_after)), after an error of the controller.
    /// [`End::stop`] tells whether the stop was accepted.
    ///
    /// ```no_run
    /// use std::time::Duration;
    /// use jaka_robot::motion::MoveL;
    /// use jaka_robot::{Numbering, Robot};
    ///
    /// const IO: Numbering = Numbering::FromOne;
    /// let mut robot = Robot::connect("10.5.5.100")?;
    /// let down = MoveL::relative([0.0, 0.0, -50.0, 0.0, 0.0, 0.0], 20.0).acceleration(200.0);
    /// let trip = robot.run_until(&down, IO.tool(1).rises(), Duration::from_secs(10))?.guarded()?;
    /// println!("{trip}; the stop was written after {:?}", trip.reaction);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`run`](Self::run); where the motion may have run, the arm was stopped, and [`ErrorKind::NotStopped`] says if
    /// the controller has not accepted that. Nothing was sent after [`ErrorKind::NotShown`] (packets do not show what
    /// the guard needs), [`ErrorKind::NotGuarded`] (a [`ForceLimit`](crate::ForceLimit) permits less speed),
    /// [`ErrorKind::StatusUnknown`], also with [`allow_motion_without_status`](Self::allow_motion_without_status),
    /// [`ErrorKind::InvalidOption`] (a condition has a value that it does not take), and [`ErrorKind::Thread`].
    pub fn run_until<M: Motion>(
        &mut self,
        motion: &M,
        guard: impl Into<Guard>,
        timeout: Duration,
    ) -> Result<End, Error> {
        let (since, guard) = (self.clock().stopwatch(), guard.into());
        guard.check()?;
        self.client.link().check_open(M::INFO.name)?;
        self.latch.check()?;
        let left = || since.left_of(timeout);
        let fresh_for = self.check_speed(M::INFO, motion.path(), &guard, left())?;
        let armed = self.arm(&guard, left()).map_err(|problem| self.client.link().attach(unknown(problem)))?;
        if let Some(trip) = armed.trip() {
            return self.not_begun(&guard, trip, since.passed());
        }
        let sentry = Sentry::new(self, armed, fresh_for);
        let is_over = Watched::new(self.clock(), false);
        let (result, stopped) = thread::scope(|scope| {
            let relieved = Relieved(&sentry);
            let (thread, place) = (thread::Builder::new().name("jaka guard".to_owned()), self.clock().participant());
            let keep = || {
                let _end = Ends(&is_over);
                sentry.keep()
            };
            let spawned = thread.spawn_scoped(scope, move || place.run(keep));
            let watching = spawned.map_err(|source| Error::from(ErrorKind::Thread { source }))?;
            let sent = self.send(motion, left(), Some(&sentry.armed));
            let result = sent.map(|()| self.wait_unless(left(), &|| sentry.has_failed()));
            drop(relieved);
            // A panic there has been reported, and has stopped the arm or kept the motion back; if the stop was not accepted, the wait has ended.
            // A join knows nothing of a simulated clock.
            is_over.wait_for(Duration::MAX, |is_over| is_over.then_some(()));
            let stopped = watching.join().unwrap_or_default();
            Ok::<_, Error>((result, stopped.or_else(|| sentry.written(None))))
        })?;
        match (result, sentry.armed.trip()) {
            (Ok(end), _) => {
                let end = self.end_of_guarded(&sentry, end, stopped);
                self.record(&end);
                Ok(end)
            }
            (Err(error), Some(trip)) if matches!(error.kind(), ErrorKind::GuardTripped { .. }) => {
                self.not_begun(&guard, trip, since.passed())
            }
            (Err(error), _) => Err(self.error_of_guarded(&sentry, error, stopped)),
        }
    }

    /// Fails if the guard has a limit of force by which the motion could not be stopped in time; and says how old the newest packet may become.
    fn check_speed(
        &self,
        info: &'static CommandInfo,
        path: Path,
        guard: &Guard,
        timeout: Duration,
    ) -> Result<Duration, Error> {
        if guard.force_limits().next().is_none() {
            return Ok(Duration::MAX);
        }
        let refused = |reason: NotGuarded| {
            self.client.link().attach(ErrorKind::NotGuarded { command: info.name.to_owned(), reason }.into())
        };
        let (Path::Line { speed, acceleration } | Path::Arc { speed, acceleration, .. }) = path else {
            return Err(refused(NotGuarded::SpeedUnknown));
        };
        // A status that is not known is told by the guard.
        let is_in_position = self.status_now(timeout).map_or(true, |newest| newest.status.in_position == Some(true));
        if self.has_motions() || !is_in_position {
            return Err(refused(NotGuarded::Moving));
        }
        let period = self.packet_period(timeout).ok_or_else(|| refused(NotGuarded::PeriodUnknown))?;
        guard.force_limits().try_for_each(|limit| limit.check_speed(speed, acceleration, period)).map_err(refused)?;
        Ok(longest_silence(period))
    }

    /// The end where the guard has tripped before the motion went out.
    fn not_begun(&self, guard: &Guard, trip: GuardTrip, waited: Duration) -> Result<End, Error> {
        if let TripReason::NotShown(reason) = trip.reason {
            return Err(self.client.link().attach(ErrorKind::NotShown { what: guard.to_string(), reason }.into()));
        }
        let packets = vec![Arc::clone(&trip.packet)];
        let occurrence = Occurrence::trip(trip.before_start());
        Ok(End { packets, ..End::new(occurrence, Rest::NotSeen, Report::of_wait(waited)) })
    }

    /// How the motion ended, by the wait for it and by what the sentry did; and a stop where the arm may still move.
    fn end_of_guarded(&mut self, sentry: &Sentry<S>, mut end: End, stopped: Option<Stopped>) -> End {
        let may_move = end.occurrence.consequence().may_move();
        let Some(stopped) = stopped.or_else(|| may_move.then(|| Stopped::new(&sentry.stop, None))) else {
            self.report(&end);
            return end;
        };
        let is_accepted = self.take(&stopped.stop);
        // What packets show against the arm itself counts before that.
        match stopped.why.filter(|_| !end.occurrence.cause.is_of_status()) {
            Some(Why::Trip(trip)) => {
                let reaction = stopped.stop.written.map(|at| at.saturating_duration_since(trip.packet.received));
                let rest = if is_accepted { self.comes_to_rest(REST) } else { Ok(false) };
                self.rests = matches!(rest, Ok(true));
                end.occurrence = Occurrence::trip(GuardTrip { reaction, is_at_rest: self.rests, ..trip });
                end.rest = if self.rests { Rest::Answers } else { Rest::NotSeen };
                end.error = rest.err();
            }
            Some(Why::Blind(problem)) => {
                end.occurrence = lost(&problem);
                self.latch.set(&end.occurrence);
            }
            None => {}
        }
        end.stop = Some(stopped.stop.accepted);
        end
    }

    /// The error of a motion whose reply did not come: it may run, and nobody judges the guard any longer.
    fn error_of_guarded(&mut self, sentry: &Sentry<S>, first: Error, stopped: Option<Stopped>) -> Error {
        let may_run = sentry.armed.has_begun() && first.may_have_run();
        let Some(stopped) = stopped.or_else(|| may_run.then(|| Stopped::new(&sentry.stop, None))) else { return first };
        self.take(&stopped.stop);
        match stopped.stop.accepted {
            Err(stopping) if may_run => self.client.link().attach(ErrorKind::NotStopped { first, stopping }.into()),
            _ => first,
        }
    }

    /// Takes note of a stop, which the end or the error reports, and no other: true if it was accepted. Its motion is not waited for any more then.
    fn take(&mut self, stop: &Sent) -> bool {
        if stop.accepted.is_ok() {
            self.latch.report_stop(stop.number);
            self.batch = None;
            self.checks.unsettle();
        }
        stop.accepted.is_ok()
    }
}

/// Says, when it is dropped, that a thread is at its end.
struct Ends<'w>(&'w Watched<bool>);

impl Drop for Ends<'_> {
    fn drop(&mut self) {
        *self.0.lock() = true;
        self.0.wake();
    }
}
