//! Powering and enabling the arm, and the way back.

use std::time::Duration;

use jaka_proto::Command;
use jaka_proto::messages::power::{DisableRobot, EnableRobot, GetRobotState, GetRobotStateReply, PowerOff, PowerOn};

use super::status::told;
use super::{Explanation, MotionStatus, Robot};
use crate::clock::Stopwatch;
use crate::{Error, ErrorKind, monitor};

/// How often the state is asked for.
const QUERY_PERIOD: Duration = Duration::from_millis(100);

/// How the time until the next query passes: it may end with an error.
type Pause<R> = fn(&mut R, Duration) -> Result<(), Error>;

/// When a call has begun, and how long all of it may take.
#[derive(Debug)]
struct Limit {
    since: Stopwatch,
    timeout: Duration,
}

impl Limit {
    fn left(&self) -> Duration {
        self.since.left_of(self.timeout)
    }
}

impl<S: MotionStatus> Robot<S> {
    /// Powers and enables the arm, each step when the controller says that the one before is done (`get_robot_state`, 4.12), and
    /// waits until the status packets say so, too. It usually takes about 12 s.
    ///
    /// # Errors
    /// - [`ErrorKind::NotReady`], at once: the emergency stop is pressed.
    /// - [`ErrorKind::StateTimeout`]: the state did not come in time; with what the last packet says.
    /// - [`ErrorKind::StatusTimeout`]: no status packet came.
    /// - Otherwise as [`Client::call`](crate::Client::call). No reply is waited for beyond `timeout`.
    pub fn power_up(&mut self, timeout: Duration) -> Result<(), Error> {
        let limit = Limit { since: self.clock().stopwatch(), timeout };
        self.monitor.wait_until(|_| true, timeout)?;
        self.check_emergency_stop(Duration::ZERO)?;
        let state = self.client.call_within(&GetRobotState::new(), limit.left())?;
        if !state.powered_on {
            self.switch(&PowerOn::new(), |state| state.powered_on, &limit, Self::check_emergency_stop)?;
        }
        if !state.enabled {
            self.switch(&EnableRobot::new(), |state| state.enabled, &limit, Self::check_emergency_stop)?;
        }
        let is_up = |status: &S| {
            told(status).is_ok_and(|status| status.powered_on != Some(false) && status.enabled != Some(false))
        };
        self.monitor.wait_until(is_up, limit.left()).map(drop)
    }

    /// Disables the arm and switches its power off, each step when the controller says that the one before is done (`get_robot_state`,
    /// 4.12), and waits until the status packets say so, too. A step that is done already is left out.
    ///
    /// # Errors
    /// - [`ErrorKind::Refused`]: the controller does not disable an arm that moves or runs a program (4.4).
    /// - [`ErrorKind::StateTimeout`]: the state did not come in time; with what the last packet says.
    /// - [`ErrorKind::StatusTimeout`]: no status packet came.
    /// - Otherwise as [`Client::call`](crate::Client::call). No reply is waited for beyond `timeout`.
    pub fn power_down(&mut self, timeout: Duration) -> Result<(), Error> {
        let limit = Limit { since: self.clock().stopwatch(), timeout };
        let state = self.client.call_within(&GetRobotState::new(), limit.left())?;
        if state.enabled {
            self.switch(&DisableRobot::new(), |state| !state.enabled, &limit, Self::pause)?;
        }
        if state.powered_on {
            self.switch(&PowerOff::new(), |state| !state.powered_on, &limit, Self::pause)?;
        }
        let is_down = |status: &S| {
            told(status).is_ok_and(|status| status.powered_on != Some(true) && status.enabled != Some(true))
        };
        self.monitor.wait_until(is_down, limit.left()).map(drop)
    }

    /// Sends a command, and waits until the controller says that it has done it.
    fn switch<C: Command>(
        &mut self,
        command: &C,
        is_done: impl Fn(&GetRobotStateReply) -> bool,
        limit: &Limit,
        pause: Pause<Self>,
    ) -> Result<(), Error> {
        let since = self.monitor.statistics().packets;
        if limit.left().is_zero() {
            return Err(self.not_in_time(limit.timeout, since));
        }
        let accepted = self.client.call_within(command, limit.left());
        accepted.map_err(|error| self.explained(error, limit.left()))?;
        while !is_done(&self.client.call_within(&GetRobotState::new(), limit.left())?) {
            pause(self, QUERY_PERIOD.min(limit.left()))?;
            if limit.left().is_zero() {
                return Err(self.not_in_time(limit.timeout, since));
            }
        }
        Ok(())
    }

    /// Fails as soon as a packet says that the emergency stop is pressed; looks for such a packet for at most `time`.
    fn check_emergency_stop(&mut self, time: Duration) -> Result<(), Error> {
        let is_pressed = self.monitor.watch(time, |newest| {
            let is_pressed = S::snapshot(newest?).status.emergency_stop == Some(true);
            is_pressed.then_some(())
        });
        match is_pressed? {
            Some(()) => Err(self.not_ready(Explanation::EmergencyStop)),
            None => Ok(()),
        }
    }

    /// Lets time pass, unless the monitor has ended.
    fn pause(&mut self, time: Duration) -> Result<(), Error> {
        self.monitor.watch(time, |_| None::<()>).map(drop)
    }

    fn not_in_time(&self, after: Duration, packets_before: u64) -> Error {
        let packets = self.monitor.statistics().packets.saturating_sub(packets_before);
        let says = self.monitor.last_known_packet().and_then(|last| monitor::describe(&S::snapshot(&last)));
        self.client.link().attach(ErrorKind::StateTimeout { after, packets, says }.into())
    }
}
