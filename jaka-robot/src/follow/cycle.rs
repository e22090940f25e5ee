//! The run's own thread.

use std::sync::Arc;
use std::time::Duration;

use jaka_clock::Clock;
use jaka_motion::{Checker, Follower, Stopping, Trajectory};
use jaka_proto::messages::types::JointPosition;
use jaka_proto::recording::MotionStep;
use jaka_sync::layer::OnDrop;

use super::approach::Approach;
use super::orders::Orders;
use super::{FollowConfig, start};
use crate::arm::Arm;
use crate::error::SessionEnd;
use crate::guard::SetPointGuard;
use crate::limits::LimitChecks;
use crate::place::Quantity;
use crate::servo_session::{LagFit, LentArm, SetPoint, SetPoints, Supervision, no_limits};
use crate::servo_thread::Begun;
use crate::{Cause, End, Error, ServoSession, TrajectoryReport};

/// A run, from entering servo mode to leaving it. Says when it is ready, or why it does not begin; then there is no end
/// of it.
pub(super) fn run(
    lent: &mut LentArm,
    (trajectory, config): (&Trajectory, &FollowConfig),
    guard: Option<&SetPointGuard>,
    orders: &Arc<Orders>,
    begun: &Begun<()>,
) -> Option<End> {
    // Ends the run for its handles, also after a panic of this thread.
    let _ends = OnDrop(|| orders.end(SessionEnd::new(Cause::Failed, "its thread has ended")));
    let refused = |error: Error| {
        // The caller has the error from here.
        begun.send(Err(error));
        None
    };
    let mut checked = None;
    let check = |arm: &mut Arm, limits: &mut LimitChecks| {
        start::check((arm, limits), trajectory, config, guard).map(|with| checked = Some(with))
    };
    let mut session = match ServoSession::lead(lent.led(), &config.servo, check) {
        Ok(session) => session,
        Err(error) => return refused(error),
    };
    let mut way = match Way::new(&session, (trajectory, checked.as_ref()), (config, guard), orders) {
        Ok(way) => way,
        Err(error) => return refused(session.end_by(error, &mut |_| None)),
    };
    begun.send(Ok(()));
    let (period, most_deg) = (config.servo.period(), config.max_departure_deg);
    let lag = LagFit::new(session.arm.clock().now(), way.last, period);
    let mut supervision = Supervision::new(most_deg, config.max_gap, guard, Some(lag));
    session.begin_pace();
    let ended = session.send_all(&mut way, &mut supervision);
    let end = way.ended(session, ended, &supervision);
    if end.error.is_none() && end.cause() != Cause::Reached {
        lent.arm.link().record_motion(MotionStep::Failed, || end.to_string());
    }
    orders.end(SessionEnd::of_trajectory(&end));
    Some(end)
}

/// The path to the start of the trajectory, and then the trajectory.
struct Way<'o> {
    /// None once the arm has been at the start.
    approach: Option<Approach>,
    follower: Follower,
    /// Quantity in which the trajectory was given.
    given_in: Quantity,
    orders: &'o Orders,
    is_overdue: bool,
    /// The last set-point, or the position of the arm before the first one.
    last: JointPosition,
    clock: Clock,
}

impl<'o> Way<'o> {
    fn new(
        session: &ServoSession<'_>,
        (trajectory, known_by): (&Trajectory, Option<&Checker>),
        (config, guard): (&FollowConfig, Option<&'o SetPointGuard>),
        orders: &'o Orders,
    ) -> Result<Self, Error> {
        let (checker, at) = session.checker_and_start().ok_or_else(no_limits)?;
        // A frame may have changed since, or the arm have moved.
        if known_by != Some(checker) {
            start::check_limits(checker, trajectory, config, guard)?;
        }
        Ok(Self {
            approach: Some(start::check_start(checker, at, trajectory, (config, guard))?),
            follower: start::follower(trajectory, checker, config)?,
            given_in: config.given_in,
            orders,
            is_overdue: false,
            last: at,
            clock: session.arm.clock().clone(),
        })
    }

    /// Brings the arm to rest after the last set-point, and returns the end of the run.
    fn ended(mut self, mut session: ServoSession<'_>, ended: Result<(), Error>, supervision: &Supervision<'_>) -> End {
        let (error, has_left_curve) = match ended {
            Ok(()) => (session.land_by(&mut |_| None, supervision).err(), false),
            Err(error) => {
                let (error, has_left_curve) = self.braked(&mut session, error);
                (Some(error), has_left_curve)
            }
        };
        // Trajectory time stands still, for any last set-points.
        self.orders.followed(self.follower.time_s(), 0.0);
        let occurrence = match &error {
            Some(error) => error.occurrence(),
            None if self.follower.is_at_end() && session.rest.was_seen() => Cause::Reached.into(),
            None if self.follower.is_at_end() => Cause::RestNotSeen.into(),
            None if self.is_overdue => Cause::Deadline.into(),
            None => Cause::Stopped.into(),
        };
        let trajectory = TrajectoryReport {
            reached: Duration::from_secs_f64(self.follower.time_s()),
            duration: self.follower.trajectory().duration(),
            has_left_curve,
            lag: supervision.lag(),
        };
        let report = session.take_report().of_trajectory(trajectory);
        End { error, ..End::new(occurrence, session.rest, report) }
    }

    /// Ends the session after an error: the arm is braked along the curve, or straight on where that takes too long,
    /// also because a stop of the program's own goes out before. Says whether it has left the curve.
    fn braked(&mut self, session: &mut ServoSession<'_>, error: Error) -> (Error, bool) {
        let (mut straight_on, stops) = (session.straight_on(), Arc::clone(session.arm.stops()));
        let (mut is_straight_on, mut is_stopping, mut ahead) = (false, None, LookAhead::default());
        self.leading().brake();
        let error = session.end_by(error, &mut |course| {
            let left = stops.time_to_brake();
            if is_stopping.replace(left.is_some()) != Some(left.is_some()) {
                ahead = self.look_ahead(straight_on.periods(course), left);
            }
            is_straight_on = is_straight_on || ahead.takes_longer();
            if is_straight_on {
                self.orders.followed(self.follower.time_s(), 0.0);
                straight_on.next(course)
            } else {
                self.brake()
            }
        });
        let is_off = self.approach.is_none() && session.last_joints() != Some(self.follower.joints());
        if is_off && !is_straight_on {
            // The last one of the landing was not sent.
            self.follower.take_back();
        }
        (error, is_off && is_straight_on)
    }

    /// True if braking along the curve takes not much longer than straight braking in so many periods, and no longer
    /// than a stop waits, if one does.
    fn look_ahead(&self, straight_on: u32, left: Option<Duration>) -> LookAhead {
        let most = straight_on.saturating_mul(2).saturating_add(self.periods_in(MORE_S));
        let most = left.map_or(most, |left| most.min(self.periods_in(left.saturating_sub(SPARE).as_secs_f64())));
        let stopping = self.approach.as_ref().map_or_else(|| Some(self.follower.stopping()), Approach::stopping);
        LookAhead { stopping, most }
    }

    fn periods_in(&self, time_s: f64) -> u32 {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "some seconds, of periods of 8 ms to 96 ms"
        )]
        let periods = (time_s / self.follower.period_s()).floor() as u32;
        periods
    }

    /// The next set-point that brakes the arm; `None` at rest.
    fn brake(&mut self) -> Option<SetPoint> {
        // The one before was sent.
        self.tell();
        let is_at_rest = self.approach.as_ref().map_or_else(|| self.follower.is_at_rest(), Approach::is_at_rest);
        if is_at_rest {
            return None;
        }
        self.leading().brake();
        Some(SetPoint::Joints(self.advance()))
    }

    /// Follower of the approach during it, and then the trajectory's.
    fn leading(&mut self) -> &mut Follower {
        self.approach.as_mut().and_then(Approach::follower).unwrap_or(&mut self.follower)
    }

    fn advance(&mut self) -> JointPosition {
        self.approach.as_mut().map_or_else(|| self.follower.advance(), Approach::advance)
    }

    fn tell(&self) {
        let rate = if self.follower.is_at_rest() || self.approach.is_some() { 0.0 } else { self.follower.rate() };
        self.orders.followed(self.follower.time_s(), rate);
    }
}

/// Look-ahead that finds, some periods at a time, whether a stop along the curve takes longer than `most` periods.
/// These can be all that are left of the trajectory.
#[derive(Default)]
struct LookAhead {
    /// None once it is known that it does not.
    stopping: Option<Stopping>,
    most: u32,
}

impl LookAhead {
    /// Looks further ahead. True once the stop is known to take longer.
    fn takes_longer(&mut self) -> bool {
        let Some(stopping) = &mut self.stopping else { return false };
        let left = self.most.saturating_sub(stopping.periods());
        if stopping.look_ahead(left.min(AT_ONCE)).is_some() {
            self.stopping = None;
            return false;
        }
        stopping.periods() >= self.most
    }
}

/// Number of periods that it looks ahead before each set-point that brakes. One takes some microseconds at most.
const AT_ONCE: u32 = 500;
/// Time by which braking along the curve may exceed twice the time of braking straight on, in seconds.
const MORE_S: f64 = 0.5;
/// Least time between the end of braking and a stop that goes out: set-points may be late.
const SPARE: Duration = Duration::from_millis(300);

impl SetPoints for Way<'_> {
    fn is_done(&mut self) -> bool {
        if !self.orders.is_stopped() && self.orders.is_overdue(self.clock.now()) {
            self.is_overdue = true;
            self.orders.stop();
        }
        if self.approach.as_ref().is_some_and(Approach::is_done) {
            self.approach = None;
        }
        match &self.approach {
            Some(approach) => self.orders.is_stopped() && approach.is_at_rest(),
            None => self.follower.is_at_end() || self.orders.is_stopped() && self.follower.is_at_rest(),
        }
    }

    fn next(&mut self) -> JointPosition {
        if self.orders.is_to_brake() {
            self.leading().brake();
        } else {
            let scale = self.orders.scale();
            // An approach has its own speed, independent of the trajectory's.
            let scale = if self.approach.is_some() && scale > 0.0 { 1.0 } else { scale };
            self.leading().set_scale(scale);
        }
        self.last = self.advance();
        self.last
    }

    fn depend_on_frames(&self) -> bool {
        self.given_in == Quantity::Pose
    }

    fn paused(&mut self) {
        self.leading().paused();
        self.tell();
    }

    fn take_back(&mut self) {
        match &mut self.approach {
            Some(approach) => approach.take_back(),
            None => self.follower.take_back(),
        }
    }

    fn sent(&mut self) {
        self.tell();
    }
}
