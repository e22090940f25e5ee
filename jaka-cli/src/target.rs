//! Robot of a command, or a simulated one.

mod address;
mod config_file;
mod environment;
pub(crate) mod packs;
pub(crate) mod seat;

use std::path::{Path, PathBuf};
use std::time::Duration;

use clap::Args;
use itertools::Itertools as _;
use jaka_motion::Limits;
use jaka_robot::preflight::Preflight;
use jaka_robot::proto::wire::Decode;
use jaka_robot::recording::Port;
use jaka_robot::status::RobotStatus;
use jaka_robot::{Client, Config, Monitor, MotionStatus, Reconnect, Recorder, Robot, StatusStream};
use jaka_sim::{Builder, Controller, Delays, Model};

use self::address::RobotAddress;
use self::environment::Environment;
use crate::failure::Failure;
use crate::recordings::record;
use crate::text::seconds::some_seconds;

/// Default timeout for connecting.
const CONNECT_TIMEOUT: Duration = Duration::from_secs(5);

/// Timeout for a simulated controller. It shares this process, so that a slow machine delays both it and the command.
const SIMULATED: Duration = Duration::from_secs(60);

/// Options of a command that talks to a robot.
#[derive(Debug, Args)]
#[command(next_help_heading = "Robot")]
pub(crate) struct RobotArgs {
    #[command(flatten)]
    address: AddressArgs,
    /// Record everything sent and received to a new file
    #[arg(long, value_name = "FILE")]
    record: Option<PathBuf>,
}

/// Options for the robot of a command.
#[derive(Debug, Default, Args)]
#[command(next_help_heading = "Robot")]
pub(crate) struct AddressArgs {
    /// Address, or name in the config file.
    #[arg(
        long,
        short,
        help = "Address of the robot, or its name in the config file [env: JAKA_ROBOT]",
        value_name = "ADDRESS",
        conflicts_with = "sim"
    )]
    robot: Option<String>,
    /// Port for commands [default: 10001]
    #[arg(long, value_name = "PORT", conflicts_with = "sim")]
    command_port: Option<u16>,
    /// Port for status packets [default: 10000]
    #[arg(long, value_name = "PORT", conflicts_with = "sim")]
    status_port: Option<u16>,
    /// Timeout for connecting, each reply and each status packet [default: 5], and for waits
    ///
    /// Without it, commands with a longer time in the protocol, such as motions, get that longer time.
    #[arg(long, value_name = "SECONDS", value_parser = some_seconds)]
    timeout: Option<Duration>,
    /// Config file.
    #[arg(
        long,
        help = "The config file [env: JAKA_CONFIG] [default: ~/.config/jaka/config.toml]",
        value_name = "FILE"
    )]
    config: Option<PathBuf>,
    /// Start a simulated controller for this one command, a Zu 5 or another model
    ///
    /// It has no power unless --sim-powered is given, and switches power and enabling at once.
    #[arg(long, value_name = "MODEL", num_args = 0..=1, require_equals = true, default_missing_value = "Zu 5", value_parser = model)]
    sim: Option<&'static Model>,
    /// Give the simulated arm power and enable it from the start
    #[arg(long, requires = "sim")]
    sim_powered: bool,
}

/// Returns the model of this name.
pub(crate) fn model(name: &str) -> Result<&'static Model, String> {
    Model::named(name)
        .ok_or_else(|| format!("the models are {}", Model::published().iter().map(Model::name).join(", ")))
}

/// Robot and config file of a command line, before the search for the robot.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Lookup<'l> {
    /// Config file of the command line.
    pub(crate) config: Option<&'l Path>,
    /// Robot of the command line, by its address or its name in the config file.
    pub(crate) robot: Option<&'l str>,
}

/// Returns the packs of the environment, or else of the config file, for this robot or for all; and true if they are
/// from the config file.
pub(crate) fn usual_packs(lookup: Lookup<'_>) -> Result<(Vec<PathBuf>, bool), Failure> {
    address::packs(lookup, &Environment::read())
}

/// Returns the robots of the config file, with their addresses; none if it is unreadable.
pub(crate) fn robots(config: Option<&Path>) -> Vec<(String, String)> {
    let file = address::config_file(config, &Environment::read()).unwrap_or_default();
    file.robots.into_iter().map(|(name, entry)| (name, entry.address)).collect()
}

impl RobotArgs {
    /// Returns the robot and the config file of the command line.
    pub(crate) fn lookup(&self) -> Lookup<'_> {
        Lookup { config: self.address.config.as_deref(), robot: self.address.robot.as_deref() }
    }

    /// Whether the command line names a robot or a simulated one.
    pub(crate) fn is_given(&self) -> bool {
        self.address.is_given()
    }

    /// Whether the robot is a simulated one.
    pub(crate) fn is_simulated(&self) -> bool {
        self.address.is_simulated()
    }

    /// Finds the robot, or starts the simulated controller with these packs, and starts the recording. Does not connect
    /// yet.
    pub(crate) fn target(&self, packs: &[PathBuf]) -> Result<Target, Failure> {
        let (target, unrecorded) = self.target_or_unrecorded(packs)?;
        unrecorded.map_or(Ok(target), Err)
    }

    /// Finds the robot like [`Self::target`], also if the recording cannot begin; the failure of that comes with it.
    pub(crate) fn target_or_unrecorded(&self, packs: &[PathBuf]) -> Result<(Target, Option<Failure>), Failure> {
        let target = self.address.target(packs)?;
        Ok(match self.record.as_deref().map(record::begin) {
            None => (target, None),
            Some(Ok(recorder)) => (target.recorded(recorder, Duration::ZERO), None),
            Some(Err(failure)) => (target, Some(failure)),
        })
    }
}

impl AddressArgs {
    /// Whether the command line names a robot or a simulated one.
    pub(crate) fn is_given(&self) -> bool {
        self.robot.is_some() || self.is_simulated()
    }

    /// Whether the robot is a simulated one.
    pub(crate) fn is_simulated(&self) -> bool {
        self.sim.is_some()
    }

    /// Finds the robot, or starts the simulated controller with these packs. Does not connect yet.
    pub(crate) fn target(&self, packs: &[PathBuf]) -> Result<Target, Failure> {
        #[cfg(test)]
        if let Some(target) = crate::tests::target(self.timeout) {
            return Ok(target);
        }
        let (address, controller) = match self.sim {
            Some(model) => {
                let controller = self.simulated(model, packs)?;
                let address = RobotAddress {
                    title: format!("simulated {}", model.name()),
                    commands: controller.command_addr().to_string(),
                    status: controller.status_addr().to_string(),
                    timeout: self.timeout.or(Some(SIMULATED)),
                    connect_timeout: self.timeout.or(Some(SIMULATED)),
                    stale_after: Some(SIMULATED),
                };
                (address, Some(controller))
            }
            None => (RobotAddress::find(self, &Environment::read())?, None),
        };
        Ok(Target { config: address.configure(Config::new()), address, timeout: self.timeout, controller })
    }

    /// Starts a controller without delays for one command.
    fn simulated(&self, model: &Model, packs: &[PathBuf]) -> Result<Controller, Failure> {
        let builder = Controller::builder().model(model.clone()).delays(Delays::NONE);
        let started = packs.iter().fold(builder, Builder::pack).start();
        let controller = started.map_err(|error| Failure::local("cannot start the simulated controller", error))?;
        if self.sim_powered {
            controller.set_state(|state| (state.powered, state.enabled) = (true, true));
        }
        Ok(controller)
    }
}

/// Addresses of a robot, and the config of its connections.
#[derive(Debug)]
pub(crate) struct Target {
    address: RobotAddress,
    config: Config,
    /// `--timeout` of the command line.
    timeout: Option<Duration>,
    /// Simulated controller, which lives as long as the target.
    #[expect(dead_code, reason = "it is dropped with the target")]
    controller: Option<Controller>,
}

impl Target {
    /// Creates a robot at these addresses, with this config and this `--timeout`.
    #[cfg(test)]
    pub(crate) fn at(config: Config, [commands, status]: [String; 2], timeout: Option<Duration>) -> Self {
        let title = "127.0.0.1".to_owned();
        let address = RobotAddress { title, commands, status, timeout, connect_timeout: timeout, stale_after: None };
        Self { config: address.configure(config), address, timeout, controller: None }
    }

    /// Returns the title of the robot for people: its name and address.
    pub(crate) fn title(&self) -> &str {
        &self.address.title
    }

    /// Returns the robot with a recorder for all traffic on its connections.
    pub(crate) fn recorded(mut self, recorder: Recorder, status_interval: Duration) -> Self {
        self.config = self.config.recorder(recorder).recorded_status_interval(status_interval);
        self
    }

    /// Returns the address of a port, and the timeout for connecting.
    pub(crate) fn address(&self, port: Port) -> (&str, Duration) {
        let address = match port {
            Port::Command => &self.address.commands,
            Port::Status => &self.address.status,
        };
        (address, self.address.connect_timeout.unwrap_or(CONNECT_TIMEOUT))
    }

    /// Returns the config of its connections.
    pub(crate) fn config(&self) -> &Config {
        &self.config
    }

    /// Connects to the command port, which serves one client.
    pub(crate) fn client(&self) -> Result<Client, Failure> {
        Ok(Client::connect_with(&self.config, &self.address.commands)?)
    }

    /// Connects to both ports, and waits for the first status packet.
    pub(crate) fn robot<S: MotionStatus>(&self) -> Result<Robot<S>, Failure> {
        let monitor = Monitor::connect_with(&self.config, &self.address.status)?;
        let robot = Robot::with_monitor(self.client()?, monitor).map_err(jaka_robot::Error::from)?;
        robot.monitor().wait_until(|_| true, self.config.get_reply_timeout())?;
        Ok(robot)
    }

    /// Returns `--timeout` of the command line, if given.
    pub(crate) fn timeout(&self) -> Option<Duration> {
        self.timeout
    }

    /// Returns the timeout for an action: `--timeout` of the command line, or else this one.
    pub(crate) fn patience(&self, usual: Duration) -> Duration {
        self.timeout.unwrap_or(usual)
    }

    /// Connects to both ports, and runs the checks before the use of the robot.
    pub(crate) fn preflight<S: MotionStatus>(&self, limits: Option<&Limits>) -> Preflight {
        Preflight::read_as::<S>(&self.config, &self.address.commands, &self.address.status, limits)
    }

    /// Connects to the status port, which serves any number of readers.
    pub(crate) fn status_stream(&self) -> Result<StatusStream, Failure> {
        Ok(StatusStream::connect_with(&self.config, &self.address.status)?)
    }

    /// Returns the newest status packet in terms of the built-in type, read as another type from the status port alone.
    pub(crate) fn status<S: MotionStatus>(&self) -> Result<RobotStatus, Failure> {
        Ok(self.status_stream()?.newest_packet_as::<S>()?.robot_status())
    }

    /// Connects to the status port, with this timeout for a packet.
    pub(crate) fn status_stream_within(&self, timeout: Duration) -> Result<StatusStream, Failure> {
        Ok(StatusStream::connect_with(&self.config.clone().reply_timeout(timeout), &self.address.status)?)
    }

    /// Connects to the status port, with a thread that reads and reconnects.
    pub(crate) fn monitor<S: Decode + Send + Sync + 'static>(
        &self,
        reconnect: Reconnect,
    ) -> Result<Monitor<S>, Failure> {
        Ok(Monitor::connect_with(&self.config.clone().reconnect(reconnect), &self.address.status)?)
    }
}
