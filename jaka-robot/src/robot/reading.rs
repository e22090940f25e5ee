//! What is asked of a robot.

use std::sync::Arc;
use std::time::Duration;

use jaka_motion::Checker;

use super::Robot;
#[cfg(doc)]
use crate::ErrorKind;
use crate::input_wait::wait_for;
use crate::preflight::Preflight;
use crate::{AnalogCondition, Error, Explanation, InputCondition, MotionStatus, Snapshot};

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
        wait_for(&self.arm, &condition.into(), timeout)
    }

    /// The same for an analog input: `IO.tool_analog(1).is_above(2.5)`.
    ///
    /// # Errors
    /// As [`wait_for_input`](Self::wait_for_input); also [`ErrorKind::InvalidOption`] for a threshold that is not a
    /// finite number.
    pub fn wait_for_analog(&self, condition: AnalogCondition, timeout: Duration) -> Result<Arc<Snapshot>, Error> {
        wait_for(&self.arm, &condition.into(), timeout)
    }

    /// Reads what could keep the robot from being used, or should be looked at before: ports, firmware, power, stops, events, frames,
    /// payload, rates, and how fast packets and replies come. Takes some two seconds; nothing is changed on the controller.
    ///
    /// Also compares the arm's model, which is that of its limits or else any published one, with what
    /// the controller computes (`kine_forward`, which moves nothing), and where the arm is with the limits.
    ///
    /// What cannot be read is a finding, too. If the command port is lost on the way, or does not answer two queries one after the other,
    /// the rest of what it tells is [not checked](crate::preflight::Verdict::NotChecked).
    ///
    /// ```
    /// use jaka_sim::Controller;
    /// use jaka_robot::preflight::{CheckItem, Verdict};
    /// use jaka_robot::{Config, Robot};
    ///
    /// let controller = Controller::start()?;
    /// let mut robot = Robot::connect_at(&Config::new(), controller.command_addr(), controller.status_addr())?;
    /// let preflight = robot.preflight();
    /// let power = preflight.findings().iter().find(|finding| finding.item() == CheckItem::Power).expect("each item has one");
    /// assert_eq!((power.verdict(), power.seen()), (Verdict::Look, "the arm has no power"));
    /// assert_eq!(power.advice(), Some("switch it on: `power_on`"));
    /// println!("{preflight}");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn preflight(&mut self) -> Preflight {
        let limits = self.limits.checker().map(Checker::limits);
        let (client, status) = self.arm.ports();
        Preflight::of(client, status, limits)
    }

    /// Why the controller refused a command of the [`client`](Self::client), as far as its state shows it, and what helps.
    ///
    /// Asks the controller whether the arm is powered and enabled (`get_robot_state`, 4.12): packets may be older than the
    /// refusal. Only packets show whether the robot is stopped; stale ones count for nothing. Refused motions of the robot itself are explained in their error:
    /// [`ErrorKind::Refused`].
    pub fn explain(&mut self, error: &jaka_sync::Error) -> Option<Explanation> {
        self.arm.explain(error)
    }
}
