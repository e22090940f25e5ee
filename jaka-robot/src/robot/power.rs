//! Powering and enabling the arm, and the way back.

use std::sync::Arc;
use std::time::Duration;

use jaka_proto::Command;
use jaka_proto::messages::power::{DisableRobot, EnableRobot, GetRobotState, GetRobotStateReply, PowerOff, PowerOn};
use jaka_sync::layer::{ClientParts as _, Clock, MonitorParts as _, Stopwatch, describe, told};

use super::readiness::unknown;
use super::stops::Stops;
use super::{MotionStatus, Robot};
use crate::error::Attach as _;
use crate::{Error, ErrorKind, Explanation, StatusProblem};

/// How often the state is asked for.
const QUERY_PERIOD: Duration = Duration::from_millis(100);

/// How the time until the next query passes: it may end with an error.
type Pause<R> = fn(&mut R, Duration) -> Result<(), Error>;

/// Step of [`Robot::power_up_with`] or [`Robot::power_down_with`], as the controller's own answers show it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct PowerStep {
    /// `cmdName` of the step's command.
    pub command: &'static str,
    /// Time from sending the command until the controller answered that the step is done (`get_robot_state`, 4.12);
    /// `None` just before the command is sent.
    pub took: Option<Duration>,
}

/// Called for each step.
type Observer<'o> = &'o mut dyn FnMut(PowerStep);

/// The steps of a call, how long all of them may take, and the stop after which no other is sent.
struct Steps<'o> {
    observer: Observer<'o>,
    since: Stopwatch,
    timeout: Duration,
    /// The number of the latest stop of the program's own that does not count.
    stop: u64,
    accepted: Vec<String>,
    /// Those that are yet to be sent.
    rest: Vec<&'static str>,
}

impl<'o> Steps<'o> {
    fn new(clock: &Clock, timeout: Duration, stop: u64, observer: Observer<'o>) -> Self {
        Self { observer, since: clock.stopwatch(), timeout, stop, accepted: Vec::new(), rest: Vec::new() }
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

    /// Fails once a stop has begun that counts. As a gate it lets no step out after that.
    fn check_stops(&self, stops: &Stops) -> Result<(), Error> {
        if stops.begun() == self.stop {
            return Ok(());
        }
        let not_sent = self.rest.iter().map(|&name| name.to_owned()).collect();
        Err(ErrorKind::Stopped { accepted: self.accepted.clone(), not_sent }.into())
    }
}

impl<S: MotionStatus> Robot<S> {
    /// Powers and enables the arm, each step when the controller says that the one before is done (`get_robot_state`,
    /// 4.12), and waits until the status packets say so, too. It usually takes about 12 s, in which each step is logged
    /// (`log::info!`).
    ///
    /// # Errors
    /// As [`power_up_with`](Self::power_up_with).
    #[doc(alias = "enable_robot")]
    #[doc(alias = "power_on")]
    pub fn power_up(&mut self, timeout: Duration) -> Result<(), Error> {
        self.power_up_with(timeout, |_| {})
    }

    /// Powers and enables the arm as [`power_up`](Self::power_up) does, and calls `observer` before each step and when
    /// it is done.
    ///
    /// A step that is done already is left out. The observer runs in this thread, between the steps.
    ///
    /// ```no_run
    /// # let mut robot = jaka_robot::Robot::connect("10.5.5.100")?;
    /// robot.power_up_with(std::time::Duration::from_secs(60), |step| match step.took {
    ///     None => println!("{} …", step.command),
    ///     Some(took) => println!("{} done after {took:.1?}", step.command),
    /// })?;
    /// # Ok::<(), jaka_robot::Error>(())
    /// ```
    ///
    /// # Errors
    /// - [`ErrorKind::NotReady`], at once: the emergency stop is pressed.
    /// - [`ErrorKind::StatusUnknown`], at once: a packet shows the emergency stop in a form that cannot be read. A packet
    ///   without this field passes: then only the controller refuses.
    /// - [`ErrorKind::Stopped`]: a [`RobotStop`](crate::RobotStop) has begun, also before the call if nothing has reported it. No further
    ///   step is sent then, until [`acknowledge`](Self::acknowledge). Also where all had been accepted, and the arm is enabled all the same.
    /// - [`StateTimeout`](jaka_sync::ErrorKind::StateTimeout): the state did not come in time; with what the last
    ///   packet says.
    /// - [`StatusTimeout`](jaka_sync::ErrorKind::StatusTimeout): no status packet came.
    /// - Otherwise as [`Client::call`](crate::Client::call). No reply is waited for beyond `timeout`.
    pub fn power_up_with(&mut self, timeout: Duration, mut observer: impl FnMut(PowerStep)) -> Result<(), Error> {
        let mut steps = Steps::new(self.clock(), timeout, self.latch.reported(), &mut observer);
        self.monitor.wait_until(|_| true, timeout)?;
        self.check_emergency_stop(Duration::ZERO)?;
        let state = self.client.call_within(&GetRobotState::new(), steps.left())?;
        steps.rest.extend((!state.powered_on).then_some(PowerOn::INFO.name));
        steps.rest.extend((!state.enabled).then_some(EnableRobot::INFO.name));
        if !state.powered_on {
            self.switch(&PowerOn::new(), |state| state.powered_on, &mut steps, Self::check_emergency_stop)?;
        }
        if !state.enabled {
            self.switch(&EnableRobot::new(), |state| state.enabled, &mut steps, Self::check_emergency_stop)?;
        }
        let is_up = |status: &S| {
            told(status).is_ok_and(|status| status.powered_on != Some(false) && status.enabled != Some(false))
        };
        self.monitor.wait_until(is_up, steps.left())?;
        steps.check_stops(&self.latch.stops)
    }

    /// Disables the arm and switches its power off, each step when the controller says that the one before is done (`get_robot_state`,
    /// 4.12), and waits until the status packets say so, too. A step that is done already is left out.
    ///
    /// # Errors
    /// As [`power_down_with`](Self::power_down_with).
    #[doc(alias = "disable_robot")]
    #[doc(alias = "power_off")]
    pub fn power_down(&mut self, timeout: Duration) -> Result<(), Error> {
        self.power_down_with(timeout, |_| {})
    }

    /// Disables the arm and switches its power off as [`power_down`](Self::power_down) does, and calls `observer`
    /// before each step and when it is done.
    ///
    /// # Errors
    /// - [`ErrorKind::Refused`]: the controller does not disable an arm that moves or runs a program (4.4).
    /// - [`ErrorKind::Stopped`]: a [`RobotStop`](crate::RobotStop) has begun during the call. No further step is sent then.
    /// - [`StateTimeout`](jaka_sync::ErrorKind::StateTimeout): the state did not come in time; with what the last
    ///   packet says.
    /// - [`StatusTimeout`](jaka_sync::ErrorKind::StatusTimeout): no status packet came.
    /// - Otherwise as [`Client::call`](crate::Client::call). No reply is waited for beyond `timeout`.
    pub fn power_down_with(&mut self, timeout: Duration, mut observer: impl FnMut(PowerStep)) -> Result<(), Error> {
        let mut steps = Steps::new(self.clock(), timeout, self.latch.stops.begun(), &mut observer);
        let state = self.client.call_within(&GetRobotState::new(), steps.left())?;
        steps.rest.extend(state.enabled.then_some(DisableRobot::INFO.name));
        steps.rest.extend(state.powered_on.then_some(PowerOff::INFO.name));
        if state.enabled {
            self.switch(&DisableRobot::new(), |state| !state.enabled, &mut steps, Self::pause)?;
        }
        if state.powered_on {
            self.switch(&PowerOff::new(), |state| !state.powered_on, &mut steps, Self::pause)?;
        }
        let is_down = |status: &S| {
            told(status).is_ok_and(|status| status.powered_on != Some(true) && status.enabled != Some(true))
        };
        self.monitor.wait_until(is_down, steps.left())?;
        steps.check_stops(&self.latch.stops)
    }

    /// Sends the next step, and waits until the controller says that it has done it.
    fn switch<C: Command>(
        &mut self,
        command: &C,
        is_done: impl Fn(&GetRobotStateReply) -> bool,
        steps: &mut Steps<'_>,
        pause: Pause<Self>,
    ) -> Result<(), Error> {
        let (since, own_stops) = (self.monitor.statistics().packets, Arc::clone(&self.latch.stops));
        if steps.left().is_zero() {
            return Err(self.not_in_time(steps.timeout, since));
        }
        steps.check_stops(&own_stops)?;
        let sent = self.clock().stopwatch();
        steps.tell(PowerStep { command: C::INFO.name, took: None });
        let gate = || steps.check_stops(&own_stops);
        let accepted = self.client.call_through(Some(&gate), command, steps.left());
        accepted.map_err(|error| self.explained(error.into(), steps.left()))?;
        steps.accepted.push(steps.rest.remove(0).to_owned());
        while !is_done(&self.client.call_within(&GetRobotState::new(), steps.left())?) {
            pause(self, QUERY_PERIOD.min(steps.left()))?;
            steps.check_stops(&own_stops)?;
            if steps.left().is_zero() {
                return Err(self.not_in_time(steps.timeout, since));
            }
        }
        steps.tell(PowerStep { command: C::INFO.name, took: Some(sent.passed()) });
        Ok(())
    }

    /// Fails as soon as a packet says that the emergency stop is pressed, or shows it in a form that cannot be read;
    /// looks for such a packet for at most `time`.
    fn check_emergency_stop(&mut self, time: Duration) -> Result<(), Error> {
        let found = self.monitor.watch(time, |newest| {
            let packet = S::snapshot(newest?);
            let unreadable = packet.unfit.iter().find(|error| error.is_in("emergency_stop"));
            match (packet.status.emergency_stop, unreadable) {
                (Some(true), _) => Some(Err(Explanation::EmergencyStop)),
                (_, Some(source)) => Some(Ok(StatusProblem::Unreadable { source: source.clone() })),
                (_, None) => None,
            }
        });
        match found? {
            Some(Err(explanation)) => Err(self.not_ready(explanation)),
            Some(Ok(problem)) => Err(self.client.link().attach(unknown(problem))),
            None => Ok(()),
        }
    }

    /// Lets time pass, unless the monitor has ended.
    fn pause(&mut self, time: Duration) -> Result<(), Error> {
        Ok(self.monitor.watch(time, |_| None::<()>).map(drop)?)
    }

    fn not_in_time(&self, after: Duration, packets_before: u64) -> Error {
        let packets = self.monitor.statistics().packets.saturating_sub(packets_before);
        let says = self.monitor.last_known_packet().and_then(|last| describe(&S::snapshot(&last)));
        self.client.link().attach(jaka_sync::ErrorKind::StateTimeout { after, packets, says }.into())
    }
}
