//! A client and a monitor together: motions that are waited for.

mod batch;
mod explain;
mod guard;
mod inputs;
mod io_wait;
mod latch;
mod limits;
mod motion;
mod position;
mod power;
mod preflight;
mod readiness;
mod rest;
mod run_until;
mod sentry;
mod stops;
mod target;
mod trouble;
mod vigil;
mod wait;
mod watch;

use std::fmt::Display;
use std::sync::Arc;
use std::time::Duration;

use jaka_proto::messages::power::GetRobotState;
use jaka_proto::messages::status::RobotStatus;
use jaka_proto::recording::MotionStep;
use jaka_sync::layer::{ClientParts as _, Clock, MonitorParts as _, names_a_port};

use self::batch::{Batch, Begin, Frames};
pub(crate) use self::guard::Armed;
pub use self::guard::{ForceComponent, ForceLimit, Guard, TcpBox};
#[cfg(feature = "stream")]
pub(crate) use self::guard::{MeasuredLag, SetPointGuard};
pub use self::inputs::{AnalogCondition, AnalogInput, Input, InputCondition, Numbering};
use self::latch::Latch;
use self::limits::Checks;
pub use self::limits::LimitPolicy;
pub use self::motion::{Motion, Path};
use self::position::Query;
pub use self::power::PowerStep;
pub use self::preflight::{CheckItem, Finding, Preflight, Verdict};
pub(crate) use self::rest::Stillness;
pub use self::stops::RobotStop;
use self::target::Goal;
pub use self::target::Target;
use self::wait::{Grace, Wait};
use crate::cause::{Consequence, Occurrence};
use crate::{Call, Cause, Client, Command, Config, End, Error, ErrorKind, Monitor, MotionStatus, Report, Rest};

/// How long the news may take that settles the cause of an end: the next packet, or the end of the other connection.
const SETTLING: Duration = Duration::from_millis(250);

/// A robot whose motions are waited for: a [`Client`] for commands and a [`Monitor`] for their effects.
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
/// A status packet alone does not end a motion, because it cannot show its age: when packets say that the arm is in position,
/// the controller is asked where it is (`get_joint_pos`, 4.49, or `get_tcp_pos`, 4.50), usually once for each motion.
///
/// After a protective stop, an emergency stop or a silent status port, motions are refused until
/// [`acknowledge`](Self::acknowledge) is called: somebody should have checked the robot first. They are also refused while the status is
/// stale, missing or unreadable ([`ErrorKind::StatusUnknown`]). Nothing is ever sent again, or enabled
/// again, automatically.
///
/// `S` is what its monitor keeps of status packets: [`MotionStatus`].
#[derive(Debug)]
#[must_use = "dropping a robot closes its connections, and its stop handles can no longer stop the arm"]
pub struct Robot<S: MotionStatus = RobotStatus> {
    client: Client,
    monitor: Arc<Monitor<S>>,
    grace: Grace,
    silence: Duration,
    /// True if the program has allowed motion without status.
    pub(crate) moves_without_status: bool,
    /// What must be acknowledged before the arm moves again.
    pub(crate) latch: Latch,
    batch: Option<Batch>,
    /// What motions are checked against, and where the last one will end.
    checks: Checks,
    /// How often frames had been changed when the last motion was sent.
    frame_changes: u64,
    /// The query that has not been answered.
    query: Option<Query>,
    /// True if the last wait saw the arm at rest by the controller's answers, and nothing was sent since.
    rests: bool,
}

impl Robot<RobotStatus> {
    /// Connects to a controller at the protocol's ports, 10001 and 10000: `10.5.5.100` or `robot.local`, without a port.
    ///
    /// # Errors
    /// As [`Client::connect`] and [`Monitor::connect`]; [`ErrorKind::PortInAddress`] if the address has a port, which can be only one of
    /// the two. [`connect_at`](Self::connect_at) takes two addresses.
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

    /// Connects to a controller whose two ports have addresses of their own: a simulated one, or one that is reached through a proxy.
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
        Ok(Self::new(Client::connect_with(config, commands_address)?, monitor))
    }

    /// A robot of two connections to the same controller.
    ///
    /// The monitor can be shared: given as an [`Arc`], or taken from [`monitor`](Self::monitor).
    pub fn new(client: Client, monitor: impl Into<Arc<Monitor>>) -> Self {
        Self::with_monitor(client, monitor)
    }
}

impl<S: MotionStatus> Robot<S> {
    /// The same with a monitor of another type of status packets, such as the one of a [pack](crate::pack!):
    /// `Robot::<newer::RobotStatus>::with_monitor(…)`.
    pub fn with_monitor(client: Client, monitor: impl Into<Arc<Monitor<S>>>) -> Self {
        let monitor = monitor.into();
        let grace = Grace { time: Duration::from_millis(400), packets: 3 };
        Self {
            latch: Latch::new(&monitor, &client.link().clock),
            client,
            monitor,
            grace,
            silence: Duration::from_secs(2),
            moves_without_status: false,
            batch: None,
            checks: Checks::default(),
            frame_changes: 0,
            query: None,
            rests: false,
        }
    }

    /// Sets how long the arm must be seen at rest, and how many packets must show it, if one answer of the controller is not enough to
    /// say that the motion has ended: for several motions in a queue, a motion that ends where it began, an arm that stops before its
    /// target. 0.4 s and three packets by default.
    ///
    /// It is also how long the arm may take to begin: if it has not left its position by then, the motion counts as one without length,
    /// or, if its target is known and the arm is not there, as stopped.
    pub fn with_start_grace(mut self, time: Duration, packets: u32) -> Self {
        self.grace = Grace { time, packets: packets.max(1) };
        self
    }

    /// Sets how long no status packet may come while a motion is waited for. 2 s by default.
    pub fn with_status_silence(mut self, time: Duration) -> Self {
        self.silence = time;
        self
    }

    /// Allows motions and set-points while the status is stale, missing or unreadable.
    ///
    /// A stop that the status would show is not noticed then. For programs that observe the robot's state by other means.
    pub fn allow_motion_without_status(mut self) -> Self {
        self.moves_without_status = true;
        self
    }

    /// The client, for all other commands.
    ///
    /// Motions that are sent through it are neither refused after a stop nor waited for, nor checked against limits. With limits, where a
    /// queue of motions ends is not known after a call of this: wait for its end before the next motion.
    #[doc(alias = "get_joint_pos")]
    #[doc(alias = "get_tcp_pos")]
    #[doc(alias = "set_digital_output")]
    pub fn client(&mut self) -> &mut Client {
        self.rests = false;
        self.checks.forget_plan();
        &mut self.client
    }

    /// The monitor, which can be cloned for other threads.
    pub fn monitor(&self) -> &Arc<Monitor<S>> {
        &self.monitor
    }

    /// Sends a motion and waits for its end.
    ///
    /// # Errors
    /// As [`start`](Self::start), but the reply is waited for no longer than `timeout`. All that happens after the motion
    /// was accepted is reported by the [`End`].
    #[doc(alias = "joint_move")]
    #[doc(alias = "linear_move")]
    #[doc(alias = "move_c")]
    #[doc(alias = "move_j")]
    #[doc(alias = "move_l")]
    #[doc(alias = "movej")]
    #[doc(alias = "movel")]
    pub fn run(&mut self, motion: &impl Motion, timeout: Duration) -> Result<End, Error> {
        let since = self.clock().stopwatch();
        self.send(motion, timeout, None)?;
        Ok(self.wait(since.left_of(timeout)))
    }

    /// Sends a motion, which starts when those before it have ended. [`wait`](Self::wait) then waits for all of them.
    ///
    /// If the first motion is one by an offset, the controller is asked first where the arm is.
    ///
    /// # Errors
    /// As [`Client::call`]. Nothing that moves the arm was sent after [`ErrorKind::NotAcknowledged`] (a stop or a silent status has not
    /// been acknowledged), [`ErrorKind::StatusUnknown`] (the status is stale, missing or unreadable), [`ErrorKind::NotReady`] (the newest
    /// packet shows a stop) and [`NotSentInTime`](jaka_sync::ErrorKind::NotSentInTime); and, with limits, after
    /// `ErrorKind::BeyondLimit` and `ErrorKind::NotChecked`.
    pub fn start<M: Motion>(&mut self, motion: &M) -> Result<(), Error> {
        self.send(motion, self.client.timeout_of(M::INFO), None)
    }

    /// Sends a motion, under a guard if there is one, which lets it out or not.
    fn send<M: Motion>(&mut self, motion: &M, timeout: Duration, guard: Option<&Armed>) -> Result<(), Error> {
        let since = self.clock().stopwatch();
        self.client.link().check_open(M::INFO.name)?;
        self.latch.check()?;
        let begin = self.begin(motion, timeout)?;
        let left = || since.left_of(timeout);
        let end = self.check_limits(motion, &begin, left())?;
        self.rests = false;
        let gate = self.gate();
        let guarded = || gate().and_then(|()| guard.map_or(Ok(()), Armed::let_out));
        let sent = self.client.call_through(Some(&guarded), motion, left());
        self.frame_changes = begin.frames.changes;
        match sent {
            Ok(()) => {
                self.accepted(Goal::new(motion.target(), motion.tolerance(), begin.start), begin);
                self.plan(end);
            }
            Err(error) => {
                let error = Error::from(error);
                // It can still be waited for.
                if error.may_have_run() {
                    self.accepted(Goal::Unknown, begin);
                    self.checks.forget_plan();
                }
                return Err(self.explained(error, left()));
            }
        }
        Ok(())
    }

    /// What is known of the arm before a motion.
    fn begin<M: Motion>(&mut self, motion: &M, timeout: Duration) -> Result<Begin, Error> {
        let since = self.clock().stopwatch();
        let Some(newest) = self.known_status(timeout)? else {
            return Ok(Begin::default());
        };
        let mut begin = Begin::new(
            &newest.status,
            Frames::new(&newest.status, self.client.link().frame_changes(), self.frame_changes),
        );
        if let Some(quantity) = motion.target().start_quantity().filter(|_| self.batch.is_none() && begin.at_rest) {
            begin.start = self.place_at_rest(quantity, since.left_of(timeout))?;
        }
        Ok(begin)
    }

    fn accepted(&mut self, goal: Goal, begin: Begin) {
        // Packets that came before the reply may be older than the motion.
        let now = self.clock().now();
        self.batch = Some(match self.batch.take() {
            Some(batch) => batch.then(now, goal, begin.frames),
            None => Batch::new(now, goal, begin),
        });
    }

    /// Waits for the end of all motions that were started; at once, with [`Cause::NoMotion`], if there are none. Once the command connection is lost, no
    /// longer than until the next status packet: [`Cause::CommandsLost`].
    #[doc(alias = "wait_complete")]
    pub fn wait(&mut self, timeout: Duration) -> End {
        let mut end = self.wait_unless(timeout, &|| false);
        self.settle_cause(&mut end);
        self.report(&end);
        self.record(&end);
        end
    }

    /// The same, and gives up waiting once it is to, with [`Cause::Deadline`]. Its end is yet to be reported.
    fn wait_unless(&mut self, timeout: Duration, gives_up: &dyn Fn() -> bool) -> End {
        let since = self.clock().stopwatch();
        let Some(batch) = self.batch.take() else {
            return End::new(Cause::NoMotion, Rest::NotSeen, Report::of_wait(Duration::ZERO));
        };
        let mut wait = Wait::new(batch, self.client.link().frame_changes(), self.grace);
        let (occurrence, rest) = self.watch(&mut wait, timeout, gives_up);
        let (cause, consequence) = (occurrence.cause, occurrence.consequence());
        self.rests = rest == Rest::Answers && matches!(cause, Cause::Reached | Cause::AtRest);
        if consequence.latches() {
            self.latch.set(&occurrence);
        }
        if consequence == Consequence::GoesOn {
            // The motions may go on: they can be waited for again.
            self.batch = Some(wait.batch);
        }
        let mut end = End::new(occurrence, rest, Report::of_wait(since.passed()));
        end.packets = wait.packets.into();
        // A connection that is lost is the cause.
        end.error = wait.failure.filter(|failure| !failure.is_disconnected());
        end.error = end.error.or_else(|| self.unanswered().filter(|_| cause == Cause::Deadline));
        end
    }

    /// Settles the cause where packets stay away: a controller that has gone answers nothing either. Under a guard the
    /// stop settles it.
    fn settle_cause(&mut self, end: &mut End) {
        if end.occurrence.cause != Cause::StatusLost {
            return;
        }
        let Err(error) = self.client.call_within(&GetRobotState::new(), SETTLING) else { return };
        match error.kind() {
            jaka_sync::ErrorKind::Disconnected { address, cause, .. } => {
                end.occurrence = Occurrence::commands_lost(address.clone(), Arc::clone(cause));
            }
            _ => end.error = end.error.take().or(Some(error.into())),
        }
    }

    /// Records how motions ended, if there were some.
    fn record(&self, end: &End) {
        let step = match end.occurrence.cause {
            Cause::NoMotion => return,
            Cause::Reached | Cause::AtRest => MotionStep::Done,
            _ => MotionStep::Failed,
        };
        self.client.link().record_motion(step, || end.occurrence.to_string());
    }

    /// The program is told of the stops that have ended a motion, if they have.
    fn report(&mut self, end: &End) {
        if end.occurrence.cause == Cause::Stopped {
            self.latch.report_stops();
        }
    }

    /// The same robot for another thread, which this one outlives: on the same connections, with what keeps motions back.
    #[cfg(feature = "stream")]
    pub(crate) fn lent(&mut self) -> Self {
        Self {
            client: self.client.lent(),
            latch: self.latch.clone(),
            monitor: Arc::clone(&self.monitor),
            grace: self.grace,
            silence: self.silence,
            moves_without_status: self.moves_without_status,
            batch: self.batch.clone(),
            checks: self.checks.lent(),
            frame_changes: self.frame_changes,
            query: self.query.take(),
            rests: std::mem::take(&mut self.rests),
        }
    }

    /// The clock of its connections.
    pub(crate) fn clock(&self) -> &Clock {
        &self.client.link().clock
    }

    /// True if motions were accepted that have not been waited for.
    pub(crate) fn has_motions(&self) -> bool {
        self.batch.is_some()
    }

    /// What must be acknowledged before the arm moves again, if something must.
    ///
    /// This is any stop that a packet has shown, also between motions, and one by a [`RobotStop`] that no [`End`] has reported.
    pub fn unacknowledged(&self) -> Option<Occurrence> {
        self.latch.unacknowledged()
    }

    /// Confirms that somebody has checked the robot: motions are sent again, unless something else prevents them, such as a stop that is
    /// on its way.
    pub fn acknowledge(&mut self) {
        self.latch.acknowledge();
        if self.batch.take().is_some() {
            self.checks.unsettle();
        }
    }

    /// A handle that stops the arm from another thread and so ends a [`wait`](Self::wait).
    #[doc(alias = "abort")]
    #[doc(alias = "motion_abort")]
    #[doc(alias = "stop")]
    pub fn stop_handle(&self) -> RobotStop {
        RobotStop {
            handle: self.client.stop_handle(),
            stops: Arc::clone(&self.latch.stops),
            waker: self.monitor.waker(),
        }
    }
}

/// As through [`Robot::client`]: motions are neither refused after a stop nor waited for. For those, see [`Robot::run`].
impl<S: MotionStatus> Call for Robot<S> {
    fn call<C: Command>(&mut self, command: &C) -> Result<C::Reply, jaka_sync::Error> {
        self.client().call(command)
    }
}
