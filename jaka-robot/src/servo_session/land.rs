//! The landing: the arm is braked and held, so that it is at rest when servo mode is left.

use std::time::Duration;

use jaka_motion::{Checker, StraightStop};
use jaka_proto::Command;
use jaka_proto::messages::servo::ServoJ;

use super::ServoSession;
use super::braking::braking_after;
use super::course::Course;
use super::rates::Rates;
use super::set_point::{SetPoint, SetPointStep};
use crate::arm::{Sending, Stillness};
use crate::cause::{Braking, Occurrence};
use crate::{Cause, Error, ErrorKind, Rest};

/// Time for which the last set-point is held where no packets come that could show rest. Ours: an arm that follows its
/// set-points is at rest by then.
const BLIND: Duration = Duration::from_millis(200);

/// Generates the set-points that brake an arm, one after the other, from the motion of the last ones.
pub(crate) type BrakingPath<'b> = &'b mut dyn FnMut(&Course) -> Option<SetPoint>;

/// Brakes an arm straight on: in joint space by the stop of its limits if it has some and its joints are known, else by
/// a step that becomes smaller evenly.
#[derive(Debug)]
pub(crate) struct StraightOn {
    checker: Option<Checker>,
    rates: Rates,
    period: Duration,
    /// None before the first set-point.
    begun: Option<Begun>,
}

/// Braking under way.
#[derive(Debug, Clone, Copy)]
struct Begun {
    /// Step before it; `None` if the arm is at rest, or the step is not known.
    step: Option<SetPointStep>,
    braking: StepsToRest,
    /// Number of set-points that were given.
    given: u32,
}

/// Decrease of a step to rest.
#[derive(Debug, Clone, Copy)]
enum StepsToRest {
    /// Evenly, in so many periods.
    Even(u32),
    Stop(StraightStop),
}

impl StraightOn {
    /// Number of periods in which the arm is braked from the last set-point.
    pub(crate) fn periods(&self, course: &Course) -> u32 {
        match self.begin(course).braking {
            StepsToRest::Even(count) => count,
            StepsToRest::Stop(stop) => stop.periods(),
        }
    }

    /// The next set-point, unless the arm is to be held at the last one.
    pub(crate) fn next(&mut self, course: &Course) -> Option<SetPoint> {
        let mut begun = self.begun.unwrap_or_else(|| self.begin(course));
        begun.given = begun.given.saturating_add(1);
        self.begun = Some(begun);
        let share = match begun.braking {
            StepsToRest::Even(count) => (1.0 - f64::from(begun.given) / f64::from(count)).max(0.0),
            StepsToRest::Stop(stop) => stop.step(begun.given),
        };
        if share == 0.0 { None } else { course.after(&begun.step?.scaled(share)) }
    }

    fn begin(&self, course: &Course) -> Begun {
        // A set-point that no arm reaches in a period is not a speed.
        let step = course.step().filter(|step| self.rates.is_reachable(step, self.period));
        let braking = match (&self.checker, step, course.last_joints()) {
            (Some(checker), Some(SetPointStep::Joints(_)), Some(before)) => {
                StepsToRest::Stop(checker.straight_stop(before, self.period.as_secs_f64()))
            }
            _ => StepsToRest::Even(step.map_or(0, |step| self.rates.periods_to_brake(&step, self.period))),
        };
        Begun { step, braking, given: 0 }
    }
}

impl ServoSession<'_> {
    /// Brakes the arm straight on, and holds it until the status shows it at rest.
    ///
    /// Fails if a stop, a refusal or the connection ends that, or rest was not seen.
    pub(super) fn come_to_rest(&mut self) -> Result<(), Error> {
        let mut straight_on = self.straight_on();
        self.come_to_rest_by(&mut |course| straight_on.next(course))
    }

    pub(crate) fn straight_on(&mut self) -> StraightOn {
        let checker = self.limits.checker().cloned();
        if checker.is_some() {
            // The way on in joints was checked, not that along the line of the poses.
            self.course.go_on_in_joints();
        }
        StraightOn { checker, rates: self.rates, period: self.config.period(), begun: None }
    }

    /// Brakes the arm, and holds it until the status shows it at rest.
    pub(super) fn come_to_rest_by(&mut self, braking: BrakingPath<'_>) -> Result<(), Error> {
        let came = if self.course.has_begun() {
            // Set-points that were sent before may be refused yet.
            let outstanding = u64::try_from(self.arm.link().outstanding(self.owner)).unwrap_or(u64::MAX);
            let refused = self.report.refused.saturating_add(outstanding);
            match self.brake(braking, refused) {
                // No set-point follows a stop, but packets may show rest.
                Err(error) if error.cause() == Cause::Stopped => self.hold(refused).and(Err(error)),
                braked => braked.and_then(|()| self.hold(refused)),
            }
        } else {
            // It was entered at rest.
            self.rest = Rest::Packets;
            Ok(())
        };
        self.expect_set_point(false);
        came
    }

    /// Brakes the arm. If the last set-point is so long ago that the arm has none, the arm is stationary.
    fn brake(&mut self, braking: BrakingPath<'_>, refused: u64) -> Result<(), Error> {
        let late = self.begun.map_or_else(|| self.pace.late(), |cycle| self.arm.clock().elapsed(cycle.due));
        if late >= self.config.gap() {
            self.stand(late);
            return Ok(());
        }
        while self.may_brake() {
            let Some(next) = braking(&self.course) else { break };
            let gate = self.arm.gate(Sending::Braking);
            if !self.send_landing(next, &gate, refused)? {
                return Ok(());
            }
            self.expect_set_point(true);
        }
        // The last step takes its period, too: a stop that waits goes out at rest.
        if let (Some(hold), Some(_)) = (self.course.hold(), self.course.step())
            && self.may_brake()
        {
            let gate = self.arm.gate(Sending::Braking);
            self.send_landing(hold, &gate, refused)?;
        }
        Ok(())
    }

    /// False if set-points may work against a hand: in drag mode they brake the arm only while its joints are known to
    /// follow.
    fn may_brake(&mut self) -> bool {
        self.look_for_news();
        let newest = self.arm.state.newest_packet().filter(|_| self.is_led_by_hand);
        newest.is_none_or(|newest| {
            newest.status.joint_actual_position.is_some_and(|joints| self.departure.is_followed(joints))
        })
    }

    /// Lets an arm that is not to be held follow its last set-points: until packets show rest, for a while at most.
    fn let_go(&mut self) {
        let since = self.arm.clock().stopwatch();
        let mut stillness = Stillness::new(since.began, None);
        while since.passed() < BLIND && self.may_brake() {
            if self.arm.state.newest_packet().is_some_and(|packet| stillness.is_seen(&packet)) {
                self.rest = Rest::Packets;
                return;
            }
            self.pace.wait();
        }
    }

    /// The arm has had no set-point for so long that the SDK assumes it at rest; this is reported for one that moved.
    fn stand(&mut self, late: Duration) {
        if self.course.is_moving() {
            self.count_gap(late);
        }
        self.course.paused();
    }

    /// Holds the arm until packets show it at rest at the last set-point, or, where packets do not come, for a while.
    /// Does not hold an arm that a hand or an obstacle keeps from its set-points.
    fn hold(&mut self, refused: u64) -> Result<(), Error> {
        // A stop of the program's own can go out now.
        self.expect_set_point(false);
        let since = self.arm.clock().stopwatch();
        let (mut stillness, mut is_held) = (Stillness::new(since.began, self.course.held_joints()), true);
        loop {
            self.look_for_news();
            if self.is_led_by_hand || self.has_departed {
                self.let_go();
                return Ok(());
            }
            if is_held && self.arm.unacknowledged_stop().is_some() {
                // A stop discards set-points: the arm may rest before the last one.
                (stillness, is_held) = (Stillness::new(self.arm.clock().now(), None), false);
            }
            let packet = self.arm.state.newest_packet();
            if packet.is_some_and(|packet| stillness.is_seen(&packet)) {
                self.rest = Rest::Packets;
                return Ok(());
            }
            let is_blind = self.arm.state.fresh_packet().is_err();
            let patience = if is_blind { BLIND.min(self.config.rest_timeout) } else { self.config.rest_timeout };
            if since.passed() >= patience {
                let may_be_blind = is_blind && self.arm.state.moves_without_status();
                return if may_be_blind {
                    Ok(())
                } else {
                    Err(ErrorKind::RestNotSeen { first: None, after: patience }.into())
                };
            }
            self.hold_once(refused)?;
        }
    }

    fn hold_once(&mut self, refused: u64) -> Result<(), Error> {
        match (self.arm.unacknowledged_stop(), self.course.hold()) {
            (None, Some(set_point)) => {
                let gate = self.arm.gate(Sending::Holding);
                match self.send_landing(set_point, &gate, refused) {
                    // A stop has come between, or an odd reply, which the next ones make up for.
                    Err(error) if braking_after(&error) == Braking::Land && !error.is_refused() => Ok(()),
                    sent => sent.map(drop),
                }
            }
            // After a stop of the program's own nothing goes out; packets may still show rest. Drag mode ends it all.
            (None | Some(Occurrence { cause: Cause::Stopped | Cause::DragMode, .. }), _) => {
                self.pace.wait();
                Ok(())
            }
            (Some(occurrence), _) => Err(ErrorKind::NotAcknowledged { occurrence }.into()),
        }
    }

    /// Sends a set-point in the cycle that has begun, or the next one: not where that comes after a gap, since the arm
    /// stands then. Fails if more are refused than this.
    fn send_landing(
        &mut self,
        set_point: SetPoint,
        gate: &dyn Fn() -> Result<(), Error>,
        refused: u64,
    ) -> Result<bool, Error> {
        if set_point.is_pose() {
            self.look_at_frames();
            self.check_frames()?;
        }
        // Computing since then takes its time, too.
        let cycle = self.begun.take().unwrap_or_else(|| self.pace.wait());
        let late = self.arm.clock().elapsed(cycle.due);
        if late >= self.config.gap() {
            self.stand(late);
            return Ok(false);
        }
        self.take_answers(ServoJ::INFO.name)?;
        // A refusal of one that was sent before is told when the session ends.
        if let Some(refusal) = self.refusal.take_if(|_| self.report.refused > refused) {
            return Err(refusal);
        }
        self.check_unanswered()?;
        self.begun = Some(cycle);
        if let Err(error) = self.post(&set_point, gate, Duration::MAX) {
            self.begun = None;
            let ErrorKind::SetPointLate { late } = *error.kind() else { return Err(error) };
            self.stand(late);
            return Ok(false);
        }
        let joints = self.course.joints_at(&set_point);
        self.course.sent(set_point, joints);
        self.departure.sent(joints);
        self.report.landing_cycles += 1;
        Ok(true)
    }
}

/// Error of a session that has ended, and after which the arm was not seen at rest.
pub(super) fn not_seen(first: Error, landing: Error) -> Error {
    match landing.into_kind() {
        // An error of an unknown status says so itself.
        ErrorKind::RestNotSeen { after, .. } if !matches!(first.kind(), ErrorKind::StatusUnknown { .. }) => {
            ErrorKind::RestNotSeen { first: Some(first), after }.into()
        }
        ErrorKind::RestNotSeen { .. } => first,
        // A controller that has refused one follows none, and its state may say why.
        ErrorKind::Refused { .. } if first.is_refused() || is_of_state(&first) => first,
        landing => ErrorKind::NotLanded { first, landing: landing.into() }.into(),
    }
}

/// True for a session that the state of the robot has ended.
fn is_of_state(error: &Error) -> bool {
    matches!(error.kind(), ErrorKind::RobotState { .. } | ErrorKind::NotAcknowledged { .. })
}
