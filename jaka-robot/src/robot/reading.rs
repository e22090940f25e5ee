//! What is asked of a robot, and how it is switched on and off.

use std::sync::Arc;
use std::time::Duration;

use jaka_motion::Checker;

use super::Robot;
#[cfg(doc)]
use crate::ErrorKind;
use crate::input_wait::wait_for;
use crate::{
    AnalogCondition, Error, Explanation, InputCondition, MotionStatus, PowerStep, Preflight, Snapshot, power_steps,
};

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
        power_steps::up(&mut self.arm, timeout, &mut observer)
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
        power_steps::down(&mut self.arm, timeout, &mut observer)
    }

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
    /// the rest of what it tells is [not checked](crate::Verdict::NotChecked).
    ///
    /// ```
    /// use jaka_sim::Controller;
    /// use jaka_robot::{CheckItem, Config, Robot, Verdict};
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
