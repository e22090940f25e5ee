//! Waits for inputs.

use std::cell::RefCell;
use std::sync::Arc;
use std::time::Duration;

use jaka_sync::layer::{ClientParts as _, MonitorParts as _};

use super::guard::Guard;
use super::inputs::{AnalogCondition, InputCondition};
use super::vigil::{self, Vigil};
use super::{MotionStatus, Robot};
use super::{SETTLING, trouble};
use crate::error::Attach as _;
use crate::{Cause, Error, ErrorKind, Occurrence, Snapshot, StatusProblem, TripReason};

/// What happens to the robot during a wait. What was so before does not end it: a program may wait for the button that
/// powers the arm.
struct News {
    /// Cause that the packets have shown since the wait began.
    shown: Option<Cause>,
    code: Option<String>,
    stops: u64,
    /// What has happened, once something has.
    found: Option<Occurrence>,
}

impl News {
    fn since<S: MotionStatus>(robot: &Robot<S>) -> Self {
        let newest = robot.monitor.last_known_packet().map(|newest| S::snapshot(&newest));
        let code = newest.as_ref().and_then(|newest| trouble::code(&newest.status)).map(str::to_owned);
        let mut news = Self { shown: None, code, stops: robot.latch.stops.taken(), found: None };
        news.shown = newest.and_then(|newest| news.of(&newest)).map(|occurrence| occurrence.cause);
        news
    }

    fn of(&self, packet: &Snapshot) -> Option<Occurrence> {
        match trouble::news(&packet.status, self.code.as_deref())? {
            trouble::News::Ends(occurrence) => Some(occurrence),
            trouble::News::AtRest(_) => None,
        }
    }

    /// True once something has happened.
    fn have_come<S: MotionStatus>(&mut self, robot: &Robot<S>) -> bool {
        if self.found.is_none() && robot.latch.stops.taken() > self.stops {
            self.found = Some(Cause::Stopped.into());
        }
        if let (None, Ok(newest)) = (&self.found, robot.monitor.fresh_packet()) {
            let shown = self.of(&S::snapshot(&newest));
            let cause = shown.as_ref().map(|occurrence| occurrence.cause);
            self.found = shown.filter(|_| cause != self.shown);
            self.shown = cause;
        }
        self.found.is_some()
    }
}

impl<S: MotionStatus> Robot<S> {
    /// Waits for a level or an edge of a digital input, and returns the packet that shows it.
    ///
    /// Nothing is sent: status packets tell it. A level counts at once if the newest packet has it. An edge is one between two packets
    /// after the call; one that is gone again within a period of the packets, 30 to 100 ms, is missed.
    ///
    /// ```no_run
    /// use std::time::Duration;
    /// use jaka_robot::{Numbering, Robot};
    ///
    /// const IO: Numbering = Numbering::FromOne;
    /// let robot = Robot::connect("10.5.5.100")?;
    /// robot.wait_for_input(IO.cabinet(3).rises(), Duration::from_secs(10))?;
    /// # Ok::<(), jaka_robot::Error>(())
    /// ```
    ///
    /// # Errors
    /// After `timeout` [`StateTimeout`](jaka_sync::ErrorKind::StateTimeout), which tells what the last packet says of
    /// the input. At once [`ErrorKind::NotShown`] if a packet does not show the input, [`ErrorKind::WaitEnded`] if
    /// packets stay away, come again after a silence, cannot be read, or their connection is lost,
    /// [`ErrorKind::CommandsLost`] if the command connection is lost, and [`ErrorKind::InvalidOption`] for a number 0
    /// that is counted from 1.
    pub fn wait_for_input(&self, condition: InputCondition, timeout: Duration) -> Result<Arc<Snapshot>, Error> {
        self.wait_for(&condition.into(), timeout)
    }

    /// The same for an analog input: `IO.tool_analog(1).is_above(2.5)`.
    ///
    /// # Errors
    /// As [`wait_for_input`](Self::wait_for_input); also [`ErrorKind::InvalidOption`] for a threshold that is not a
    /// finite number.
    pub fn wait_for_analog(&self, condition: AnalogCondition, timeout: Duration) -> Result<Arc<Snapshot>, Error> {
        self.wait_for(&condition.into(), timeout)
    }

    fn wait_for(&self, guard: &Guard, timeout: Duration) -> Result<Arc<Snapshot>, Error> {
        guard.check()?;
        let since = self.clock().stopwatch();
        let what = guard.to_string();
        let attach = |kind: ErrorKind| self.client.link().attach(kind.into());
        let blind = |problem: StatusProblem| attach(ErrorKind::WaitEnded { what: what.clone(), problem });
        let before = self.monitor.statistics().packets;
        let armed = self.arm(guard, timeout).map_err(blind)?;
        let (left, link) = (since.left_of(timeout), self.client.link());
        let commands_lost =
            |cause| attach(ErrorKind::CommandsLost { address: link.address(), what: what.clone(), cause });
        let news = RefCell::new(News::since(self));
        let is_over = || link.lost().is_some() || news.borrow_mut().have_come(self);
        let trip = match vigil::keep(&self.monitor, &armed, (left, Duration::MAX), is_over) {
            Vigil::Tripped(trip) => trip,
            // A controller that has gone takes both connections with it.
            Vigil::Blind(problem @ StatusProblem::Ended { .. }) => {
                return Err(link.lost_within(SETTLING).map_or_else(|| blind(problem), commands_lost));
            }
            Vigil::Blind(problem) => return Err(blind(problem)),
            Vigil::Over(newest) => {
                if let Some(cause) = link.broken() {
                    return Err(commands_lost(cause));
                }
                if let Some(occurrence) = news.into_inner().found {
                    return Err(attach(ErrorKind::WaitBroken { what, occurrence }));
                }
                let packets = self.monitor.statistics().packets.saturating_sub(before);
                let says = guard.conditions.iter().find_map(|condition| condition.says(&newest));
                let kind = jaka_sync::ErrorKind::StateTimeout { after: timeout, packets, says };
                return Err(link.attach(kind.into()));
            }
        };
        match trip.reason {
            TripReason::NotShown(reason) => Err(match trip.packet.unreadable() {
                Some(source) => blind(StatusProblem::Unreadable { source }),
                None => attach(ErrorKind::NotShown { what, reason }),
            }),
            TripReason::Holds if trip.packet.follows_silence => Err(blind(StatusProblem::Resuming)),
            TripReason::Holds | TripReason::Panicked => Ok(trip.packet),
        }
    }
}
