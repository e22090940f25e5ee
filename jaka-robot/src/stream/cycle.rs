//! The cycle's own thread.

use std::sync::Arc;

use jaka_motion::{Dynamics, Generator, GeneratorError, Goal, Step};
use jaka_proto::messages::types::JointPosition;
use jaka_sync::layer::OnDrop;

use super::StreamConfig;
use super::target::{Order, Targets};
use crate::arm::Arm;
use crate::error::SessionEnd;
use crate::guard::{ForceLimit, SetPointGuard};
use crate::limits::LimitChecks;
use crate::servo_session::course::Course;
use crate::servo_session::{
    LagFit, LentArm, SetPoint, SetPoints, Supervision, beyond_limit, check_shows_joints, no_limits,
};
use crate::servo_thread::Begun;
use crate::{Cause, End, Error, ServoSession};

/// A stream, from entering servo mode to leaving it. Says when it is ready, or why it does not begin.
pub(super) fn run(
    lent: &mut LentArm,
    config: &StreamConfig,
    guard: Option<&SetPointGuard>,
    begun: &Begun<(Arc<Targets>, Generator)>,
) -> Option<Result<End, Error>> {
    // The caller has the error from here, and not from the thread.
    let refused = |error: Error| {
        begun.send(Err(error));
        None
    };
    let clock = lent.arm.clock().clone();
    let timeout = config.servo.enter_timeout;
    let check = |arm: &mut Arm, _: &mut LimitChecks| {
        check_shows_joints(arm, timeout)?;
        guard.map_or(Ok(()), SetPointGuard::check_before_start)
    };
    let mut session = match ServoSession::lead(lent.led(), &config.servo, check) {
        Ok(session) => session,
        Err(error) => return refused(error),
    };
    let mut generator = match generator_at_start(&session, config, guard) {
        Ok(generator) => generator,
        Err(error) => return refused(session.end_by(error, &mut |_| None)),
    };
    let targets = Arc::new(Targets::new(generator.joints(), &clock));
    // Ends the stream for its handles, also after a panic of this thread.
    let _ends = OnDrop(|| targets.end(SessionEnd::new(Cause::Failed, "its thread has ended")));
    begun.send(Ok((Arc::clone(&targets), generator.clone())));
    let (start, period) = (generator.joints(), config.servo.period());
    let has_force_limit = guard.is_some_and(|guard| guard.tool_stop(period.as_secs_f64()).is_some());
    let lag = has_force_limit.then(|| LagFit::new(clock.now(), start, period));
    let mut supervision = Supervision::new(config.max_departure_deg, config.max_gap, guard, lag);
    let mut set_points = StreamSetPoints { generator: &mut generator, targets: &targets, order: None, last: None };
    let ended = session.send_all(&mut set_points, &mut supervision);
    if let Err(error) = &ended {
        targets.land_because(SessionEnd::of(error));
    }
    let rest = &mut |course: &Course| {
        targets.landing(course.last_joints().map(|[_, last]| last));
        (!generator.is_at_rest()).then(|| SetPoint::Joints(generator.next(&Goal::Rest).joints))
    };
    let result = match ended {
        Ok(()) => session.land_by(rest, &supervision).map(|()| session.landed()),
        Err(error) => Err(session.end_by(error, rest)),
    };
    if let Some(joints) = session.last_joints() {
        targets.landed(joints);
    }
    targets.end(result.as_ref().map_or_else(SessionEnd::of, |_| SessionEnd::new(Cause::Landed, "it has landed")));
    Some(result)
}

fn generator_at_start(
    session: &ServoSession<'_>,
    config: &StreamConfig,
    guard: Option<&SetPointGuard>,
) -> Result<Generator, Error> {
    let (checker, start) = session.checker_and_start().ok_or_else(no_limits)?;
    let dynamics = config.dynamics.unwrap_or_else(|| Dynamics::of(checker.limits()));
    let period_s = config.servo.period().as_secs_f64();
    let generator = Generator::new(checker, dynamics, start, period_s).map_err(not_generated)?;
    match guard.and_then(|guard| guard.tool_stop(period_s)) {
        Some([speed_mm_s, within_mm]) => {
            let too_short = |error| ForceLimit::option("overtravel").refuse(within_mm, format!("more ({error})"));
            generator.with_tool_stop(speed_mm_s, within_mm).map_err(too_short)
        }
        None => Ok(generator),
    }
}

/// Error of a stream that its dynamics or the place of the arm do not allow.
fn not_generated(error: GeneratorError) -> Error {
    let option = StreamConfig::option("dynamics");
    match error {
        GeneratorError::Start(beyond) => beyond_limit(beyond),
        GeneratorError::OutOfRange { what, unit, joint, given, least, most } => {
            let expected = format!("{least} to {most:e} {unit}");
            option.refuse(format_args!("a {what} of joint {joint} of {given} {unit}"), expected)
        }
        GeneratorError::BeyondLimit { what, unit, joint, given, limit } => {
            let expected = format!("at most {limit} {unit}, the arm's limit");
            option.refuse(format_args!("a {what} of joint {joint} of {given} {unit}"), expected)
        }
        other => option.refuse(other, "a value within the robot's limits"),
    }
}

/// Set-points that the generator makes from the orders of the handles.
struct StreamSetPoints<'s> {
    generator: &'s mut Generator,
    targets: &'s Targets,
    /// None before the first one.
    order: Option<Order>,
    /// The last goal, and the set-point on the path to it.
    last: Option<(Goal, Step)>,
}

/// Tolerance of a joint that has reached its target, in degrees.
const THERE_DEG: f64 = 1e-4;

impl SetPoints for StreamSetPoints<'_> {
    fn is_done(&mut self) -> bool {
        self.targets.is_landing()
    }

    fn next(&mut self) -> JointPosition {
        self.order = self.targets.order().or(self.order);
        let goal = self.order.map_or(Goal::Rest, |order| self.targets.goal(&order));
        let step = self.generator.next(&goal);
        let joints = step.joints;
        self.last = Some((goal, step));
        joints
    }

    fn depend_on_frames(&self) -> bool {
        self.order.is_some_and(|order| order.depends_on_frames())
    }

    fn paused(&mut self) {
        self.generator.paused();
    }

    fn take_back(&mut self) {
        self.generator.take_back();
    }

    fn sent(&mut self) {
        let (Some(order), Some((goal, step))) = (&self.order, self.last.take()) else { return };
        let is_there = !matches!(goal, Goal::Joints(target) if target.max_distance(&step.joints) > THERE_DEG);
        self.targets.sent(step, order, is_there && self.generator.is_at_rest());
    }
}
