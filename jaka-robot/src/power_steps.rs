//! Power and enabling of the arm, and the reverse.

use std::fmt;
use std::sync::Arc;
use std::time::Duration;

use jaka_clock::Stopwatch;
use jaka_proto::Command;
use jaka_proto::messages::power::{DisableRobot, EnableRobot, GetRobotState, GetRobotStateReply, PowerOff, PowerOn};
use jaka_sync::layer::{ClientParts as _, Stops, describe};

use crate::arm::{Arm, unknown};
use crate::{Cause, Error, ErrorKind, Remedy, StatusProblem};

/// Period of the queries for the state.
const QUERY_PERIOD: Duration = Duration::from_millis(100);

/// Longest wait for rest before the arm loses its power: one that is about to rest need not be refused.
const REST: Duration = Duration::from_millis(500);

/// Wait until the next query: it may end with an error.
type Pause = fn(&Arm, Duration) -> Result<(), Error>;

/// Step of [`Robot::power_up_with`](crate::Robot::power_up_with) or
/// [`Robot::power_down_with`](crate::Robot::power_down_with), as the controller's own answers show it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct PowerStep {
    /// `cmdName` of the step's command.
    pub command: &'static str,
    /// Time from sending the command until the controller answered that the step is done (`get_robot_state`, 4.12);
    /// `None` just before the command is sent.
    pub took: Option<Duration>,
}

/// `power_on: sent`, then `power_on: done after 8.0 s`.
impl fmt::Display for PowerStep {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.took {
            None => write!(f, "{}: sent", self.command),
            Some(took) => write!(f, "{}: done after {:.1} s", self.command, took.as_secs_f64()),
        }
    }
}

/// Called for each step.
type Observer<'o> = &'o mut dyn FnMut(PowerStep);

/// The steps of a call, the time limit for all of them, and the last stop before it: a later one ends the steps.
struct Steps<'o> {
    observer: Observer<'o>,
    since: Stopwatch,
    timeout: Duration,
    /// The number of the latest stop that does not count; `None` if one before the call does.
    stop: Option<u64>,
    accepted: Vec<String>,
    /// Steps that are yet to be sent.
    rest: Vec<&'static str>,
    /// Connection, and the number of its commands that may have moved the arm before it was seen at rest; `None` for
    /// steps that a moving arm may take.
    moves: Option<u64>,
}

impl<'o> Steps<'o> {
    fn new(arm: &Arm, timeout: Duration, stop: Option<u64>, observer: Observer<'o>) -> Self {
        let (since, accepted, rest, moves) = (arm.clock().stopwatch(), Vec::new(), Vec::new(), None);
        Self { observer, since, timeout, stop, accepted, rest, moves }
    }

    fn left(&self) -> Duration {
        self.since.left_of(self.timeout)
    }

    /// Tells the program and its log of a step.
    fn tell(&mut self, step: PowerStep) {
        match step.took {
            None => log::info!(target: "jaka_robot", "{} is sent next", step.command),
            Some(took) => log::info!(target: "jaka_robot", "{} is done, after {took:.1?}", step.command),
        }
        (self.observer)(step);
    }

    /// Gate of a step: fails once a stop has begun that counts, or the arm may move again.
    fn check(&self, stops: &Stops, step: &str) -> Result<(), Error> {
        self.check_stops(stops)?;
        match self.moves {
            Some(before) if stops.moves() != before => {
                let moving = Error::from(ErrorKind::NotReady { occurrence: Cause::Moving.into() });
                Err(moving.before_with(step, Remedy::WaitForRest))
            }
            Some(_) | None => Ok(()),
        }
    }

    /// Fails once a stop has begun that counts.
    fn check_stops(&self, stops: &Stops) -> Result<(), Error> {
        if self.stop == Some(stops.begun()) {
            return Ok(());
        }
        let not_sent = self.rest.iter().map(|&name| name.to_owned()).collect();
        Err(ErrorKind::Stopped { accepted: self.accepted.clone(), not_sent }.into())
    }
}

/// Powers and enables the arm: see [`Robot::power_up_with`](crate::Robot::power_up_with).
pub(crate) fn up(arm: &mut Arm, timeout: Duration, observer: Observer<'_>) -> Result<(), Error> {
    let mut steps = Steps::new(arm, timeout, arm.stops().settled(), observer);
    arm.wait_for_status(|_| true, timeout)?;
    check_emergency_stop(arm, Duration::ZERO)?;
    let state = state_before(arm, PowerOn::INFO.name, steps.left())?;
    steps.rest.extend((!state.powered_on).then_some(PowerOn::INFO.name));
    steps.rest.extend((!state.enabled).then_some(EnableRobot::INFO.name));
    if !state.powered_on {
        switch(arm, &PowerOn::new(), |state| state.powered_on, &mut steps, check_emergency_stop)?;
    }
    if !state.enabled {
        switch(arm, &EnableRobot::new(), |state| state.enabled, &mut steps, check_emergency_stop)?;
    }
    arm.wait_for_status(|status| status.powered_on != Some(false) && status.enabled != Some(false), steps.left())?;
    steps.check_stops(arm.stops())
}

/// Disables the arm and switches its power off: see [`Robot::power_down_with`](crate::Robot::power_down_with).
pub(crate) fn down(
    arm: &mut Arm,
    needs_rest: NeedsRest,
    timeout: Duration,
    observer: Observer<'_>,
) -> Result<(), Error> {
    let mut steps = Steps::new(arm, timeout, Some(arm.stops().begun()), observer);
    let state = state_before(arm, DisableRobot::INFO.name, steps.left())?;
    steps.rest.extend(state.enabled.then_some(DisableRobot::INFO.name));
    steps.rest.extend(state.powered_on.then_some(PowerOff::INFO.name));
    if let Some(first) = steps.rest.first() {
        let before = arm.stops().moves();
        needs_rest.check(arm, first, steps.left())?;
        steps.moves = Some(before);
    }
    if state.enabled {
        switch(arm, &DisableRobot::new(), |state| !state.enabled, &mut steps, pause)?;
    }
    if state.powered_on {
        switch(arm, &PowerOff::new(), |state| !state.powered_on, &mut steps, pause)?;
    }
    arm.wait_for_status(|status| status.powered_on != Some(true) && status.enabled != Some(true), steps.left())?;
    steps.check_stops(arm.stops())
}

/// State of the arm by the controller, before the first step.
fn state_before(arm: &mut Arm, first: &str, timeout: Duration) -> Result<GetRobotStateReply, Error> {
    let state = arm.queries().call_within(&GetRobotState::new(), timeout);
    state.map_err(|error| Error::from(error).before(first))
}

/// Rule for an arm that is to lose its power.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum NeedsRest {
    /// It must be seen at rest.
    Seen,
    /// It must not be seen to move: its controller may not report the joints.
    UnlessUnknown,
}

impl NeedsRest {
    /// Fails, for the first step, if the arm is not at rest.
    fn check(self, arm: &mut Arm, first: &str, timeout: Duration) -> Result<(), Error> {
        let Err(error) = arm.position.wait_for_rest(REST.min(timeout)) else { return Ok(()) };
        let is_unknown = !matches!(error.kind(), ErrorKind::NotAtRest { .. }) && !error.is_disconnected();
        match self {
            Self::UnlessUnknown if is_unknown => Ok(()),
            Self::Seen if is_unknown => Err(error.before_with(first, Remedy::PowerDownUnseen)),
            Self::Seen | Self::UnlessUnknown => Err(error.before(first)),
        }
    }
}

/// Sends the next step, and waits until the controller says that it has done it.
fn switch<C: Command>(
    arm: &mut Arm,
    command: &C,
    is_done: impl Fn(&GetRobotStateReply) -> bool,
    steps: &mut Steps<'_>,
    pause: Pause,
) -> Result<(), Error> {
    let since = arm.statistics().packets;
    let held_by = Arc::clone(arm.stops());
    if steps.left().is_zero() {
        return Err(not_in_time(arm, steps.timeout, since));
    }
    steps.check(&held_by, C::INFO.name)?;
    let sent = arm.clock().stopwatch();
    steps.tell(PowerStep { command: C::INFO.name, took: None });
    let gate = || steps.check(&held_by, C::INFO.name);
    let accepted = arm.client().call_through(Some(&gate), command, steps.left());
    accepted.map_err(|error| arm.explained(error.into(), steps.left()))?;
    steps.accepted.push(steps.rest.remove(0).to_owned());
    while !is_done(&arm.queries().call_within(&GetRobotState::new(), steps.left())?) {
        pause(arm, QUERY_PERIOD.min(steps.left()))?;
        steps.check_stops(&held_by)?;
        if steps.left().is_zero() {
            return Err(not_in_time(arm, steps.timeout, since));
        }
    }
    steps.tell(PowerStep { command: C::INFO.name, took: Some(sent.passed()) });
    Ok(())
}

/// Fails as soon as a packet says that the emergency stop is pressed, or shows it in a form that cannot be read; looks
/// for such a packet for at most `time`.
fn check_emergency_stop(arm: &Arm, time: Duration) -> Result<(), Error> {
    let found = arm.state.watch(time, |newest| {
        let packet = newest?;
        let unreadable = packet.unfit.iter().find(|error| error.is_in("emergency_stop"));
        match (packet.status.emergency_stop, unreadable) {
            (Some(true), _) => Some(Err(Cause::EmergencyStop)),
            (_, Some(source)) => Some(Ok(StatusProblem::Unreadable { source: source.clone() })),
            (_, None) => None,
        }
    });
    match found {
        Ok(Some(Err(cause))) => Err(arm.not_ready(cause)),
        Ok(Some(Ok(problem))) => Err(arm.attach(unknown(problem))),
        Ok(None) => Ok(()),
        Err(cause) => Err(arm.status_ended(cause)),
    }
}

/// Lets time pass, unless the monitor has ended.
fn pause(arm: &Arm, time: Duration) -> Result<(), Error> {
    arm.state.watch(time, |_| None::<()>).map(drop).map_err(|cause| arm.status_ended(cause))
}

fn not_in_time(arm: &Arm, after: Duration, packets_before: u64) -> Error {
    let packets = arm.statistics().packets.saturating_sub(packets_before);
    let says = arm.state.newest_packet().and_then(|last| describe(&last));
    arm.attach(jaka_sync::ErrorKind::StateTimeout { after, packets, says })
}
