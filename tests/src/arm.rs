//! The simulated arm of a test: its controller, and clients that share its time.

use std::ops::Deref;
use std::time::Duration;

use jaka_proto::wire::Decode;
use jaka_robot::types::JointPosition;
use jaka_robot::{Client, Config, End, Monitor, Robot, StatusStream, TrajectoryReport};
use jaka_sim::{Controller, Delays, SimulatedClock, State};

use crate::standstill::Standstill;

/// Timeout for what must happen, however busy the machine is.
pub const LONG: Duration = Duration::from_secs(60);

/// Period of the controller.
pub const CYCLE: Duration = Duration::from_millis(8);

/// Report of the trajectory that has ended.
///
/// # Panics
/// It is the end of another motion.
pub fn followed(end: &End) -> &TrajectoryReport {
    end.report.trajectory.as_ref().expect("it is the end of a trajectory")
}

/// A simulated arm. It is powered, enabled and at rest unless its [`ArmBuilder`] says otherwise, and switches without
/// delay.
///
/// It dereferences to its [`Controller`].
#[derive(Debug)]
pub struct Arm {
    controller: Controller,
    config: Config,
    _standstill: Option<Standstill>,
}

/// Options of an [`Arm`].
#[derive(Debug, Clone)]
#[must_use = "start it"]
pub struct ArmBuilder {
    controller: jaka_sim::Builder,
    config: Config,
    is_powered: bool,
    joints: Option<[f64; 6]>,
}

impl Arm {
    /// An arm in simulated time, which its clients share: each time is exact, and passes as soon as all threads wait.
    /// A deadlock ends the test.
    pub fn simulated() -> ArmBuilder {
        Self::by_clock(&SimulatedClock::new())
    }

    /// An arm in the simulated time of a clock.
    pub fn by_clock(clock: &SimulatedClock) -> ArmBuilder {
        ArmBuilder::new(Controller::builder().clock(clock), Config::new().clock(clock))
    }

    /// An arm whose time passes by [`Controller::advance`] alone. A packet comes on connecting and with each period
    /// that is stepped over.
    ///
    /// Its clients wait in real time, and take packets of a minute ago as fresh.
    pub fn stepped() -> ArmBuilder {
        ArmBuilder::new(Controller::builder().stepped_clock(), patient())
    }

    /// An arm in real time, whose clients take packets of a minute ago as fresh and wait for replies as long.
    ///
    /// For tests about the system itself: no assertion may depend on the speed of the machine.
    pub fn real_time() -> ArmBuilder {
        ArmBuilder::new(Controller::builder(), patient())
    }

    /// Options of the arm's clients, with its clock.
    pub fn config(&self) -> Config {
        self.config.clone()
    }

    /// Clock of a simulated arm.
    ///
    /// # Panics
    /// The arm has another time.
    pub fn clock(&self) -> &SimulatedClock {
        self.controller.clock().expect("the arm is in simulated time")
    }

    /// A client that the controller has accepted.
    ///
    /// # Panics
    /// The controller does not listen.
    pub fn client(&self) -> Client {
        let client = Client::connect_with(&self.config, self.command_addr()).expect("the controller listens");
        self.wait_until_accepted();
        client
    }

    /// A monitor that has its first packet.
    ///
    /// # Panics
    /// The controller does not listen, or sends no packet.
    pub fn monitor<S: Decode + Send + Sync + 'static>(&self) -> Monitor<S> {
        let monitor: Monitor<S> =
            Monitor::connect_with(&self.config, self.status_addr()).expect("the controller listens");
        monitor.wait_until(|_| true, LONG).expect("a packet comes on connecting");
        monitor
    }

    /// A reader of packets that the controller has accepted.
    ///
    /// # Panics
    /// The controller does not listen.
    pub fn stream(&self) -> StatusStream {
        let stream = StatusStream::connect_with(&self.config, self.status_addr()).expect("the controller listens");
        self.wait_until_accepted();
        stream
    }

    /// A robot that the controller has accepted, and that has its first packet.
    ///
    /// # Panics
    /// As [`client`](Self::client) and [`monitor`](Self::monitor).
    pub fn robot(&self) -> Robot {
        let monitor = self.monitor();
        Robot::new(self.client(), monitor).expect("it is the only robot")
    }
}

impl Deref for Arm {
    type Target = Controller;

    fn deref(&self) -> &Controller {
        &self.controller
    }
}

impl ArmBuilder {
    fn new(controller: jaka_sim::Builder, config: Config) -> Self {
        // Systems connect by their own time, also by a simulated clock.
        let config = config.connect_timeout(LONG);
        Self { controller: controller.delays(Delays::NONE), config, is_powered: true, joints: None }
    }

    /// Without power, as a controller that has just been switched on.
    pub fn without_power(mut self) -> Self {
        self.is_powered = false;
        self
    }

    /// At rest at these joint positions, in degrees.
    pub fn at(mut self, joints: [f64; 6]) -> Self {
        self.joints = Some(joints);
        self
    }

    /// Period of status packets.
    pub fn status_period(self, period: Duration) -> Self {
        self.controller(|controller| controller.status_period(period))
    }

    /// Without status packets but the one that each reader gets on connecting.
    pub fn no_packets(self) -> Self {
        self.status_period(Duration::MAX)
    }

    /// Any other options of the controller: faults, habits, delays, firmware, packs.
    pub fn controller(mut self, change: impl FnOnce(jaka_sim::Builder) -> jaka_sim::Builder) -> Self {
        self.controller = change(self.controller);
        self
    }

    /// Options of the arm's clients.
    pub fn config(mut self, change: impl FnOnce(Config) -> Config) -> Self {
        self.config = change(self.config);
        self
    }

    /// Starts the controller.
    ///
    /// # Panics
    /// It cannot be started.
    pub fn start(self) -> Arm {
        let controller = self.controller.start().expect("the controller starts");
        controller.set_state(|state: &mut State| {
            (state.powered, state.enabled) = (self.is_powered, self.is_powered);
            if let Some(joints) = self.joints {
                state.joint_position = JointPosition(joints);
            }
        });
        let standstill = controller.clock().map(Standstill::end_test);
        Arm { controller, config: self.config, _standstill: standstill }
    }

    /// Starts the controller and connects a robot to it.
    ///
    /// # Panics
    /// As [`start`](Self::start) and [`Arm::robot`].
    pub fn with_robot(self) -> (Arm, Robot) {
        let arm = self.start();
        let robot = arm.robot();
        (arm, robot)
    }

    /// Starts the controller and connects a client to it.
    ///
    /// # Panics
    /// As [`start`](Self::start) and [`Arm::client`].
    pub fn with_client(self) -> (Arm, Client) {
        let arm = self.start();
        let client = arm.client();
        (arm, client)
    }
}

fn patient() -> Config {
    Config::new().stale_after(LONG).reply_timeout(LONG)
}
