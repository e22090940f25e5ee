//! Waits for inputs.

use std::sync::Arc;
use std::time::Duration;

use super::guard::Guard;
use super::inputs::{AnalogCondition, InputCondition};
use super::vigil::{self, Vigil};
use super::{MotionStatus, Robot};
use crate::{Error, ErrorKind, Snapshot, StatusProblem, TripReason};

impl<S: MotionStatus> Robot<S> {
    /// Waits for a level or an edge of a digital input, and returns the packet that shows it.
    ///
    /// Nothing is sent: status packets tell it. A level counts at once if the newest packet has it. An edge is one between two packets
    /// after the call; one that is gone again within a period of the packets, 30 to 100 ms, is missed.
    ///
    /// ```no_run
    /// use std::time::Duration;
    /// use jaka_sync::{Numbering, Robot};
    ///
    /// const IO: Numbering = Numbering::FromOne;
    /// let robot = Robot::connect("10.5.5.100")?;
    /// robot.wait_for_input(IO.cabinet(3).rises(), Duration::from_secs(10))?;
    /// # Ok::<(), jaka_sync::Error>(())
    /// ```
    ///
    /// # Errors
    /// After `timeout` [`ErrorKind::StateTimeout`], which tells what the last packet says of the input. At once [`ErrorKind::NotShown`] if
    /// a packet does not show the input, [`ErrorKind::WaitEnded`] if packets stay away, come again after a silence, cannot be read, or their connection is lost,
    /// [`ErrorKind::CommandsLost`] if the command connection is lost, and [`ErrorKind::InvalidArgument`] for a number 0 that is counted from 1.
    pub fn wait_for_input(&self, condition: InputCondition, timeout: Duration) -> Result<Arc<Snapshot>, Error> {
        self.wait_for(&condition.into(), "wait_for_input", timeout)
    }

    /// The same for an analog input: `IO.tool_analog(1).is_above(2.5)`.
    ///
    /// # Errors
    /// As [`wait_for_input`](Self::wait_for_input); also [`ErrorKind::InvalidArgument`] for a threshold that is not a finite number.
    pub fn wait_for_analog(&self, condition: AnalogCondition, timeout: Duration) -> Result<Arc<Snapshot>, Error> {
        self.wait_for(&condition.into(), "wait_for_analog", timeout)
    }

    fn wait_for(&self, guard: &Guard, call: &str, timeout: Duration) -> Result<Arc<Snapshot>, Error> {
        guard.check(call)?;
        let since = self.clock().stopwatch();
        let what = guard.to_string();
        let attach = |kind: ErrorKind| self.client.link.attach(kind.into());
        let blind = |problem: StatusProblem| attach(ErrorKind::WaitEnded { what: what.clone(), problem });
        let before = self.monitor.statistics().packets;
        let armed = self.arm(guard, timeout).map_err(blind)?;
        let (left, link) = (since.left_of(timeout), &self.client.link);
        let trip = match vigil::keep(&self.monitor, &armed, (left, Duration::MAX), || link.lost().is_some()) {
            Vigil::Tripped(trip) => trip,
            Vigil::Blind(problem) => return Err(blind(problem)),
            Vigil::Over(newest) => {
                if let Some(cause) = link.broken() {
                    return Err(attach(ErrorKind::CommandsLost { address: link.address(), what, cause }));
                }
                let packets = self.monitor.statistics().packets.saturating_sub(before);
                let says = guard.conditions.iter().find_map(|condition| condition.says(&newest));
                return Err(attach(ErrorKind::StateTimeout { after: timeout, packets, says }));
            }
        };
        match trip.reason {
            TripReason::NotShown(reason) => Err(attach(ErrorKind::NotShown { what, reason })),
            TripReason::Holds if trip.packet.follows_silence => Err(blind(StatusProblem::Resuming)),
            TripReason::Holds | TripReason::Panicked => Ok(trip.packet),
        }
    }
}
