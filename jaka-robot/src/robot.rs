//! A robot: a client and a monitor together.

mod config;

use std::fmt::{self, Display};
use std::sync::Arc;
use std::time::Duration;

use jaka_motion::{Checker, Trajectory};
use jaka_proto::messages::status::RobotStatus;
use jaka_sync::layer::{ClientParts as _, names_a_port};

pub use self::config::RobotConfig;
#[cfg(doc)]
use crate::Cause;
use crate::arm::Arm;
use crate::input_wait::wait_for;
use crate::limits::LimitChecks;
use crate::motions::PlannedMotion;
use crate::planned::{Moving, Planned};
use crate::power_steps::NeedsRest;
use crate::preflight::Preflight;
use crate::servo_session::{LedArm, ServoSession};
use crate::{
    AnalogCondition, Call, Client, Command, Config, End, Error, ErrorKind, FollowConfig, FollowRun, InputCondition,
    Monitor, Motion, MotionStatus, Occurrence, PowerStep, RobotStop, Run, SessionConfig, Snapshot, power_steps,
};
#[cfg(feature = "stream")]
use crate::{Stream, StreamConfig};

/// Error of a second robot on one connection, which has one robot at a time. Gives the client back.
#[derive(Debug)]
#[non_exhaustive]
pub struct HasRobot {
    /// The client, whose connection stays open.
    pub client: Box<Client>,
}

impl Display for HasRobot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        ErrorKind::HasRobot.fmt(f)
    }
}

impl std::error::Error for HasRobot {}

/// Drops the client. That closes the connection if it is its first client.
impl From<HasRobot> for Error {
    fn from(_: HasRobot) -> Self {
        ErrorKind::HasRobot.into()
    }
}

/// A robot with motions that end: a [`Client`] for commands and a [`Monitor`] for their effects.
///
/// ```no_run
/// use std::time::Duration;
/// use jaka_robot::Robot;
/// use jaka_robot::motion::JointMove;
///
/// let mut robot = Robot::connect("10.5.5.100")?;
/// let stop = robot.stop_handle();
/// ctrlc::set_handler(move || {
///     if let Err(error) = stop.stop() {
///         eprintln!("the arm may still move, use the emergency stop: {error}");
///     }
/// })?;
/// robot.power_up(Duration::from_secs(60))?;
/// // The last joint, by 5 deg from where it is, at 5 deg/s and 20 deg/s².
/// let turn = JointMove::relative([0.0, 0.0, 0.0, 0.0, 0.0, 5.0], 5.0).acceleration(20.0);
/// robot.run(&turn, Duration::from_secs(30))?.reached()?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// A status packet alone does not end a motion, because it cannot show its age: if packets show the arm in position,
/// the robot queries the position (`get_joint_pos`, 4.49, or `get_tcp_pos`, 4.50), usually once for each motion.
///
/// After a protective stop, an emergency stop, drag mode or a silent status port, motions are refused until
/// [`acknowledge`](Self::acknowledge) is called: somebody should have checked the robot first. They are also refused
/// while the status is stale, missing or unreadable ([`ErrorKind::StatusUnknown`]). Nothing is ever sent again, or
/// enabled again, automatically.
///
/// `S` is the type of its monitor's status packets: [`MotionStatus`].
#[derive(Debug)]
#[must_use = "dropping a robot closes its connections, and its stop handles can no longer stop the arm"]
pub struct Robot<S: MotionStatus = RobotStatus> {
    monitor: Arc<Monitor<S>>,
    pub(crate) arm: Arm,
    limits: LimitChecks,
    planned: Planned,
    needs_rest: NeedsRest,
}

impl<S: MotionStatus> Robot<S> {
    /// The parts that a motion concerns.
    fn moving(&mut self) -> Moving<'_> {
        let Self { arm, limits, planned, .. } = self;
        Moving { arm, limits, planned }
    }

    /// The parts that a session uses.
    fn led(&mut self) -> LedArm<'_> {
        let (has_motions, settling) = (self.planned.has_motions(), self.planned.settling());
        LedArm { arm: &mut self.arm, limits: &mut self.limits, has_motions, settling }
    }
}

/// As through [`Robot::client`]: motions are not waited for. For those, see [`Robot::run`].
impl<S: MotionStatus> Call for Robot<S> {
    fn call<C: Command>(&mut self, command: &C) -> Result<C::Reply, jaka_sync::Error> {
        self.client().call(command)
    }
}

impl Robot<RobotStatus> {
    /// Connects to a controller at the protocol's ports, 10001 and 10000: `10.5.5.100` or `robot.local`, without a
    /// port.
    ///
    /// # Errors
    /// As [`Client::connect`] and [`Monitor::connect`]; [`ErrorKind::PortInAddress`] if the address has a port, which
    /// can be only one of the two. [`connect_at`](Self::connect_at) takes two addresses.
    pub fn connect(address: impl Display) -> Result<Self, Error> {
        Self::connect_with(&Config::new(), address)
    }

    /// Connects to a controller at the protocol's ports, 10001 and 10000, by a configuration.
    ///
    /// # Errors
    /// As [`connect`](Self::connect).
    pub fn connect_with(config: &Config, address: impl Display) -> Result<Self, Error> {
        let address = address.to_string();
        if names_a_port(&address) {
            return Err(ErrorKind::PortInAddress { address }.into());
        }
        Self::connect_at(config, &address, &address)
    }

    /// Connects to a controller with a separate address for each port: a simulated one, or one behind a proxy.
    ///
    /// ```
    /// use jaka_sim::Controller;
    /// use jaka_robot::{Config, Robot};
    ///
    /// let controller = Controller::start()?;
    /// let robot = Robot::connect_at(&Config::new(), controller.command_addr(), controller.status_addr())?;
    /// # drop(robot);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`Client::connect`] and [`Monitor::connect`].
    pub fn connect_at(
        config: &Config,
        commands_address: impl Display,
        status_address: impl Display,
    ) -> Result<Self, Error> {
        let monitor = Monitor::connect_with(config, status_address)?;
        Ok(Self::new(Client::connect_with(config, commands_address)?, monitor)?)
    }

    /// A robot of two connections to the same controller.
    ///
    /// The monitor can be shared: given as an [`Arc`], or taken from [`monitor`](Self::monitor). A connection has one
    /// robot at a time. Stops that nobody has acknowledged bind the next robot of the connection, too.
    ///
    /// # Errors
    /// [`HasRobot`], with the client, if the connection has a robot already, by another handle
    /// ([`Client::try_clone`]). Nothing is closed.
    pub fn new(client: Client, monitor: impl Into<Arc<Monitor>>) -> Result<Self, HasRobot> {
        Self::with_monitor(client, monitor)
    }
}

impl<S: MotionStatus> Robot<S> {
    /// A robot of two connections, with a monitor of another type of status packets, such as a [pack](crate::pack!)'s:
    /// `Robot::<newer::RobotStatus>::with_monitor(…)`.
    ///
    /// # Errors
    /// As [`new`](Robot::new).
    pub fn with_monitor(client: Client, monitor: impl Into<Arc<Monitor<S>>>) -> Result<Self, HasRobot> {
        let monitor = monitor.into();
        let RobotConfig { grace, silence, needs_status, needs_rest, .. } = RobotConfig::new();
        let arm = Arm::new(client, &monitor, needs_status).map_err(|client| HasRobot { client })?;
        Ok(Self { monitor, arm, limits: LimitChecks::default(), planned: Planned::new(grace, silence), needs_rest })
    }

    /// Applies options. Those that are not set in `config` are the defaults.
    ///
    /// # Errors
    /// [`ErrorKind::ModelMismatch`] if the controller computes other poses than the limits' model,
    /// [`ErrorKind::InvalidOption`] for an invalid value, and if a preset of the limits requires collision detection
    /// and it is off, and as [`Client::call`]; nothing has changed then.
    pub fn configure(&mut self, config: &RobotConfig) -> Result<(), Error> {
        config.check()?;
        if let Some(limits) = &config.limits {
            config.waived.check(&mut self.arm, limits.preset())?;
        }
        self.limits = match &config.limits {
            Some(limits) => LimitChecks::new(&mut self.arm, limits.clone())?,
            None => LimitChecks::default(),
        };
        (self.planned.grace, self.planned.silence) = (config.grace, config.silence);
        self.arm.position.set_rest_speed(config.rest_speed);
        self.needs_rest = config.needs_rest;
        self.arm.state.set_needs_status(config.needs_status);
        Ok(())
    }

    /// Powers and enables the arm, each step after the controller has confirmed the previous one (`get_robot_state`,
    /// 4.12), and waits until status packets confirm it, too. It usually takes about 12 s, and logs each step
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
    /// - [`ErrorKind::StatusUnknown`], at once: a packet shows the emergency stop in a form that cannot be read. A
    ///   packet without this field passes: then only the controller refuses.
    /// - [`ErrorKind::Stopped`]: a [`RobotStop`](crate::RobotStop) has begun, also before the call if nothing has
    ///   reported it. No further step is sent then, until [`acknowledge`](Self::acknowledge). Also where all had been
    ///   accepted, and the arm is enabled all the same.
    /// - [`StateTimeout`](jaka_sync::ErrorKind::StateTimeout): the state did not come in time; with what the last
    ///   packet says.
    /// - [`StatusTimeout`](jaka_sync::ErrorKind::StatusTimeout): no status packet came.
    /// - Otherwise as [`Client::call`](crate::Client::call). No reply is waited for beyond `timeout`.
    pub fn power_up_with(&mut self, timeout: Duration, mut observer: impl FnMut(PowerStep)) -> Result<(), Error> {
        power_steps::up(&mut self.arm, timeout, &mut observer)
    }

    /// Disables the arm and switches its power off, each step when the controller says that the one before is done
    /// (`get_robot_state`, 4.12), and waits until the status packets say so, too. A step that is done already is left
    /// out.
    ///
    /// An arm that moves keeps its power: without it, it would fall into its brakes. Stop it, wait for its
    /// [rest](Self::wait_for_rest), and power it down then. Not every controller refuses to disable an arm that moves.
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
    /// - [`ErrorKind::NotSent`]: the arm [is not at rest](ErrorKind::NotAtRest), something that may move it was sent
    ///   through any handle of the connection since it was seen at rest, or the controller does not report the joints:
    ///   for that, see [`RobotConfig::allow_power_down_without_joints`].
    /// - [`ErrorKind::Refused`]: the controller does not disable an arm that runs a program (4.4).
    /// - [`ErrorKind::Stopped`]: a [`RobotStop`](crate::RobotStop) has begun during the call. No further step is sent
    ///   then.
    /// - [`StateTimeout`](jaka_sync::ErrorKind::StateTimeout): the state did not come in time; with what the last
    ///   packet says.
    /// - [`StatusTimeout`](jaka_sync::ErrorKind::StatusTimeout): no status packet came.
    /// - Otherwise as [`Client::call`](crate::Client::call). No reply is waited for beyond `timeout`.
    pub fn power_down_with(&mut self, timeout: Duration, mut observer: impl FnMut(PowerStep)) -> Result<(), Error> {
        power_steps::down(&mut self.arm, self.needs_rest, timeout, &mut observer)
    }

    /// Sends a motion and waits for its end; [under a guard](crate::MotionExt::guard) also for its trip.
    ///
    /// # Errors
    /// As [`start`](Self::start), with a wait for the reply of at most `timeout`. The [`End`] reports everything after
    /// the acceptance of the motion. Under a guard also the errors of [`MotionExt::guard`](crate::MotionExt::guard).
    #[doc(alias = "joint_move")]
    #[doc(alias = "linear_move")]
    #[doc(alias = "move_c")]
    #[doc(alias = "move_j")]
    #[doc(alias = "move_l")]
    #[doc(alias = "movej")]
    #[doc(alias = "movel")]
    pub fn run(&mut self, motion: &impl Run, timeout: Duration) -> Result<End, Error> {
        self.moving().run(motion, timeout)
    }

    /// Sends a motion, which starts after the end of the earlier ones. [`wait`](Self::wait) then waits for all of them.
    ///
    /// If the first motion is by an offset, the robot queries the position of the arm first.
    ///
    /// # Errors
    /// As [`Client::call`]. Nothing that moves the arm was sent after [`ErrorKind::NotAcknowledged`] (a stop or a
    /// silent status has not been acknowledged), [`ErrorKind::StatusUnknown`] (the status is stale, missing or
    /// unreadable), [`ErrorKind::NotReady`] (the newest packet shows a stop) and
    /// [`NotSentInTime`](jaka_sync::ErrorKind::NotSentInTime); and, with limits, after `ErrorKind::BeyondLimit` and
    /// `ErrorKind::NotChecked`.
    pub fn start<M: Motion>(&mut self, motion: &M) -> Result<(), Error> {
        let timeout = self.arm.queries().timeout_of(M::INFO);
        self.moving().send(PlannedMotion::of(motion), timeout, None)
    }

    /// Waits for the end of all started motions; returns at once with [`Cause::NoMotion`] if there are none. After the
    /// loss of the command connection it waits at most until the next status packet: [`Cause::CommandsLost`].
    #[doc(alias = "wait_complete")]
    pub fn wait(&mut self, timeout: Duration) -> End {
        self.moving().wait(timeout)
    }

    /// Waits until the arm is at rest, by the controller's answers: until no joint has turned faster than
    /// [`RobotConfig::rest_speed`] over three of them (`get_joint_pos`, 4.49), 100 ms apart.
    ///
    /// An arm that rests stays at rest only if nothing moves it: a motion through another handle, a program of the
    /// controller, a person. The wait takes as long as three answers at least.
    ///
    /// # Errors
    /// [`ErrorKind::NotAtRest`] if the arm still moves after `timeout`, with the speed of its fastest joint; otherwise
    /// as [`Client::call`], if the controller does not report the joints.
    pub fn wait_for_rest(&mut self, timeout: Duration) -> Result<(), Error> {
        self.arm.position.wait_for_rest(timeout).map(drop)
    }

    /// Occurrence that must be acknowledged before the arm moves again, if there is one.
    ///
    /// This is any stop that a packet has shown, also between motions, and any stop by a handle of the connection:
    /// [`RobotStop`] says which.
    pub fn unacknowledged(&self) -> Option<Occurrence> {
        self.arm.unacknowledged()
    }

    /// Confirms that somebody has checked the robot. Motions are sent again, unless something else prevents them, such
    /// as a stop on its way.
    ///
    /// Gives up motions that nobody has waited for. The arm may begin them yet: until it was seen at rest, the end of
    /// the next motion takes the whole [grace](RobotConfig::start_grace), and servo mode is entered only after it.
    pub fn acknowledge(&mut self) {
        self.arm.state.acknowledge();
        if self.planned.give_up() {
            self.limits.unsettle();
        }
    }

    /// A handle that stops the arm from another thread and so ends a [`wait`](Self::wait).
    #[doc(alias = "abort")]
    #[doc(alias = "motion_abort")]
    #[doc(alias = "stop")]
    pub fn stop_handle(&self) -> RobotStop {
        self.arm.stop_handle()
    }

    /// The client, for all other commands.
    ///
    /// Motions through it are neither awaited nor checked against limits. After a stop, typed ones are refused as the
    /// robot's own are ([`KeptBack`](jaka_sync::ErrorKind::KeptBack)), raw ones are not. With limits, the end of a
    /// queue of motions is unknown after a call of this: wait for its end before the next motion.
    #[doc(alias = "get_joint_pos")]
    #[doc(alias = "get_tcp_pos")]
    #[doc(alias = "set_digital_output")]
    pub fn client(&mut self) -> &mut Client {
        self.limits.forget_plan();
        self.arm.client()
    }

    /// The monitor, which can be cloned for other threads.
    pub fn monitor(&self) -> &Arc<Monitor<S>> {
        &self.monitor
    }

    /// The limits, with the frames that the controller was found to have.
    pub fn limits(&self) -> Option<&Checker> {
        self.limits.checker()
    }

    /// Waits for a level or an edge of a digital input, and returns the packet that shows it.
    ///
    /// Sends nothing: status packets show the input. A level counts at once if the newest packet has it. An edge lies
    /// between two packets after the call; an edge that reverts within a period of the packets, 30 to 100 ms, is
    /// missed.
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
    /// After `timeout` [`StateTimeout`](jaka_sync::ErrorKind::StateTimeout), with the input in the last packet. At once
    /// [`ErrorKind::NotShown`] if a packet does not show the input, [`ErrorKind::WaitEnded`] if packets stay away, come
    /// again after a silence, cannot be read, or their connection is lost, [`ErrorKind::CommandsLost`] if the command
    /// connection is lost, and [`ErrorKind::InvalidOption`] for a number 0 that is counted from 1.
    pub fn wait_for_input(&self, condition: InputCondition, timeout: Duration) -> Result<Arc<Snapshot>, Error> {
        wait_for(&self.arm, &condition.into(), timeout)
    }

    /// Waits for a level or an edge of an analog input, as [`wait_for_input`](Self::wait_for_input):
    /// `IO.tool_analog(1).is_above(2.5)`.
    ///
    /// # Errors
    /// As [`wait_for_input`](Self::wait_for_input); also [`ErrorKind::InvalidOption`] for a threshold that is not a
    /// finite number.
    pub fn wait_for_analog(&self, condition: AnalogCondition, timeout: Duration) -> Result<Arc<Snapshot>, Error> {
        wait_for(&self.arm, &condition.into(), timeout)
    }

    /// Reads states and settings that could keep the robot from being used, or should be looked at before: ports,
    /// firmware, power, stops, events, frames, payload, rates, and the speed of packets and replies. Takes some two
    /// seconds; nothing is changed on the controller.
    ///
    /// Also compares the arm's model, by its limits or else any published one, with the controller's computations
    /// (`kine_forward`, which moves nothing), and the place of the arm with the limits.
    ///
    /// An unreadable item is a finding, too. If the command port is lost, or does not answer two queries in a row, its
    /// other items are [not checked](crate::preflight::Verdict::NotChecked).
    ///
    /// ```
    /// use jaka_sim::Controller;
    /// use jaka_robot::preflight::{CheckItem, Verdict};
    /// use jaka_robot::{Config, Robot};
    ///
    /// let controller = Controller::start()?;
    /// let mut robot = Robot::connect_at(&Config::new(), controller.command_addr(), controller.status_addr())?;
    /// let preflight = robot.preflight();
    /// let power = preflight.findings().iter().find(|finding| finding.item() == CheckItem::Power);
    /// let power = power.expect("each item has one");
    /// assert_eq!((power.verdict(), power.seen()), (Verdict::Look, "the arm has no power"));
    /// assert_eq!(power.advice(), Some("switch it on: `power_on`"));
    /// println!("{preflight}");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn preflight(&mut self) -> Preflight {
        let limits = self.limits.checker().map(Checker::limits);
        let (client, status) = self.arm.ports();
        Preflight::read(Ok(client), Ok(status), limits)
    }

    /// Explains why the controller refused a command of the [`client`](Self::client), as far as its state shows it,
    /// with a remedy.
    ///
    /// Asks the controller whether the arm is powered and enabled (`get_robot_state`, 4.12): packets may be older than
    /// the refusal. Only packets show whether the robot is stopped; stale ones count for nothing. Refused motions of
    /// the robot itself are explained in their error: [`ErrorKind::Refused`].
    pub fn explain(&mut self, error: &jaka_sync::Error) -> Option<Occurrence> {
        self.arm.explain(error)
    }
}

impl<S: MotionStatus> Robot<S> {
    /// Enters servo mode, in which set-points come one by one: waits until the controller is in it.
    ///
    /// # Errors
    /// As [`ServoSession`] says at "Entering".
    pub fn enter_servo_mode(&mut self, config: impl Into<SessionConfig>) -> Result<ServoSession<'_>, Error> {
        ServoSession::enter(self.led(), &config.into())
    }

    /// Follows a trajectory, and returns when the arm is at rest at its end, or with the cause of another end. At the
    /// deadline it stops along the trajectory.
    ///
    /// The arm must be at the start of the trajectory: see [`FollowConfig::approach`].
    ///
    /// # Errors
    /// As [`start_follow`](Self::start_follow). The [`End`] reports everything after the first set-point.
    pub fn follow(&mut self, trajectory: &Trajectory, deadline: Duration) -> Result<End, Error> {
        Ok(self.start_follow(trajectory, &FollowConfig::new().deadline(deadline))?.wait())
    }

    /// Begins to follow a trajectory.
    ///
    /// The robot compares all of it with its limits before the first set-point, with the present tool and frames of the
    /// controller, independent of earlier comparisons.
    ///
    /// # Errors
    /// Nothing moves the arm after an error. The errors of [`ServoSession`](crate::ServoSession), at "Entering";
    /// [`ErrorKind::NotChecked`] if the robot has no limits, [`ErrorKind::NotShown`] if packets do not show the joints,
    /// [`ErrorKind::Trajectory`] if the trajectory is beyond a limit, [`ErrorKind::NotAtStart`] if its start is not at
    /// the commanded joints by the controller's own answer, [`ErrorKind::BeyondLimit`] if the straight path in joint
    /// space to its start is beyond a limit, [`ErrorKind::InvalidOption`] for an invalid value of the configuration.
    pub fn start_follow(&mut self, trajectory: &Trajectory, config: &FollowConfig) -> Result<FollowRun<'_>, Error> {
        FollowRun::begin(self.led(), trajectory, config)
    }
}

#[cfg(feature = "stream")]
impl<S: MotionStatus> Robot<S> {
    /// Enters servo mode, in which the arm goes to targets and velocities that any thread may give at any time.
    ///
    /// It begins at rest, at the commanded joints by the controller's own answer.
    ///
    /// # Errors
    /// The errors of [`ServoSession`](crate::ServoSession), at "Entering"; [`ErrorKind::NotChecked`] if the robot has
    /// no limits, which describe the arm to a stream, [`ErrorKind::NotShown`] if packets do not show the joints, which
    /// the stream compares with its set-points, [`ErrorKind::BeyondLimit`] if the arm is beyond a limit, and
    /// [`ErrorKind::InvalidOption`] for an invalid value of the configuration, such as dynamics beyond the limits.
    pub fn stream(&mut self, config: &StreamConfig) -> Result<Stream<'_>, Error> {
        Stream::begin(self.led(), config)
    }
}
