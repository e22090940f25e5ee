//! The cycle's own thread.

use std::sync::Arc;
use std::sync::mpsc::SyncSender;

use jaka_motion::{Generator, GeneratorError, Goal};
use jaka_proto::Command;
use jaka_proto::check::InvalidArgument;
use jaka_proto::messages::servo::ServoJ;

use super::StreamConfig;
use super::departure::Departure;
use super::target::{Order, Targets};
use crate::robot::Armed;
use crate::servo_session::SetPoint;
use crate::{Error, ErrorKind, MotionStatus, Robot, ServoReport, ServoSession, Unchecked};

type Ready = SyncSender<Result<(Arc<Targets>, Generator), Error>>;

/// Ends the stream for its handles, also where this thread panics.
struct Ends(Arc<Targets>);

impl Drop for Ends {
    fn drop(&mut self) {
        self.0.end("its thread has ended".to_owned());
    }
}

/// A stream, from entering servo mode to leaving it. Says when it is ready, or why it does not begin.
pub(super) fn run<S: MotionStatus>(
    robot: &mut Robot<S>,
    config: &StreamConfig,
    guard: Option<&Armed>,
    ready: &Ready,
) -> Result<ServoReport, Error> {
    let mut session = match robot.enter_servo_mode(&config.servo) {
        Ok(session) => session,
        Err(error) => return Ok(refuse(ready, error)),
    };
    let mut generator = match generator(&session, config) {
        Ok(generator) => generator,
        Err(error) => return Ok(refuse(ready, session.end_by(error, &mut |_| None))),
    };
    let targets = Arc::new(Targets::new(generator.joints(), session.clock()));
    let _ends = Ends(Arc::clone(&targets));
    // Nobody waits where the caller's thread has ended; then it lands.
    if ready.send(Ok((Arc::clone(&targets), generator.clone()))).is_err() {
        targets.land();
    }
    let ended = go(&mut session, &mut generator, &targets, (config, guard));
    let rest = &mut |_: &_| (!generator.is_at_rest()).then(|| SetPoint::Joints(generator.next(&Goal::Rest).joints));
    let result = match ended {
        Ok(()) => session.land_by(rest),
        Err(error) => Err(session.end_by(error, rest)),
    };
    targets.end(result.as_ref().err().map_or_else(|| "it has landed".to_owned(), ToString::to_string));
    result
}

/// The caller has the error from here, and not from the thread.
fn refuse(ready: &Ready, error: Error) -> ServoReport {
    let _ = ready.send(Err(error));
    ServoReport::default()
}

fn generator<S: MotionStatus>(session: &ServoSession<'_, S>, config: &StreamConfig) -> Result<Generator, Error> {
    let Some((checker, start)) = session.checker_and_start() else {
        let command = ServoJ::INFO.name.to_owned();
        return Err(ErrorKind::NotChecked { command, reason: Unchecked::NoLimits }.into());
    };
    let dynamics = config.dynamics.unwrap_or_else(|| jaka_motion::Dynamics::of(checker.limits()));
    let period = config.servo.period().as_secs_f64();
    Generator::new(checker, dynamics, start, period).map_err(|error| match error {
        GeneratorError::Start(beyond) => {
            ErrorKind::BeyondLimit { command: ServoJ::INFO.name.to_owned(), beyond }.into()
        }
        other => {
            let allowed = "what the robot's limits allow".to_owned();
            InvalidArgument::new(ServoJ::INFO.name, "dynamics", other.to_string(), allowed, false).into()
        }
    })
}

/// Cycle by cycle, until it is to land.
fn go<S: MotionStatus>(
    session: &mut ServoSession<'_, S>,
    generator: &mut Generator,
    targets: &Targets,
    (config, guard): (&StreamConfig, Option<&Armed>),
) -> Result<(), Error> {
    let mut departure = Departure::new(generator.joints(), generator.period_s(), config.max_departure_deg);
    let mut order: Option<Order> = None;
    loop {
        let cycle = session.begin_cycle();
        if cycle.follows_gap {
            generator.paused();
        }
        guard.map_or(Ok(()), Armed::check)?;
        if targets.is_landing() {
            return Ok(());
        }
        order = targets.order().or(order);
        let Some(order) = order else { continue };
        if cycle.late > config.max_gap {
            return Err(ErrorKind::SetPointLate { late: cycle.late }.into());
        }
        if let Some((number, joints)) = session.actual_joints_after(departure.packet()) {
            departure.check(number, joints)?;
        }
        let goal = targets.goal(&order);
        let step = generator.next(&goal);
        let joints = step.joints;
        session.send_generated(joints, &cycle).inspect_err(|_| generator.take_back())?;
        departure.sent(joints);
        let is_there = !matches!(goal, Goal::Joints(target) if target.max_distance(&joints) > THERE_DEG);
        targets.sent(step, &order, is_there && generator.is_at_rest());
    }
}

/// How far from its target a joint may be that has reached it, in degrees.
const THERE_DEG: f64 = 1e-4;
