//! Address of the robot, by the precedence of arguments, environment and config file.

use std::env::split_paths;
use std::net::IpAddr;
use std::path::{Path, PathBuf};
use std::time::Duration;

use jaka_sync::{COMMAND_PORT, Config, STATUS_PORT};

use super::config_file::{ConfigFile, Entry};
use super::environment::Environment;
use super::{AddressArgs, Lookup};
use crate::failure::Failure;

/// Message without an address of the robot.
const NO_ROBOT: &str = "no robot is given; name its address with `--robot ADDRESS`, with the environment variable JAKA_ROBOT, or with \
                        `robot = \"NAME\"` in the config file; or try a simulated one with `--sim`";

/// Addresses of a robot, and the timeouts of its connections.
#[derive(Debug, PartialEq)]
pub(super) struct RobotAddress {
    /// Title of the robot for people: its name and address.
    pub(super) title: String,
    /// Addresses of its ports.
    pub(super) commands: String,
    pub(super) status: String,
    pub(super) timeout: Option<Duration>,
    pub(super) connect_timeout: Option<Duration>,
    pub(super) stale_after: Option<Duration>,
}

impl RobotAddress {
    /// Finds the robot: the command line takes precedence over the environment, and that over the config file.
    pub(super) fn find(args: &AddressArgs, environment: &Environment) -> Result<Self, Failure> {
        let file = config_file(args.config.as_deref(), environment)?;
        let named = named(args.robot.as_deref(), environment, &file)?;
        let named = named.ok_or_else(|| Failure::Usage(NO_ROBOT.to_owned()))?;
        let known = file.robots.get(&named).cloned();
        let is_known = known.is_some();
        let entry = known.unwrap_or_else(|| Entry { address: named.clone(), ..Entry::default() });
        let host = host(&entry.address)?;
        let address =
            |port: u16| if host.contains(':') { format!("[{host}]:{port}") } else { format!("{host}:{port}") };
        Ok(Self {
            commands: address(args.command_port.or(entry.command_port).unwrap_or(COMMAND_PORT)),
            status: address(args.status_port.or(entry.status_port).unwrap_or(STATUS_PORT)),
            timeout: args.timeout.or(entry.timeout),
            connect_timeout: args.timeout.or(entry.connect_timeout),
            stale_after: entry.stale_after,
            title: if is_known && named != host { format!("{named} ({host})") } else { host },
        })
    }

    /// Adds the robot's times to those of a config.
    pub(super) fn configure(&self, mut config: Config) -> Config {
        if let Some(timeout) = self.timeout {
            config = config.reply_timeout(timeout);
        }
        if let Some(timeout) = self.connect_timeout {
            config = config.connect_timeout(timeout);
        }
        if let Some(age) = self.stale_after {
            config = config.stale_after(age);
        }
        config
    }
}

/// Returns the named robot: the command line takes precedence over the environment, and that over the config file.
fn named(robot: Option<&str>, environment: &Environment, file: &ConfigFile) -> Result<Option<String>, Failure> {
    Ok(match (robot, &environment.robot) {
        (Some(robot), _) => Some(robot.to_owned()),
        (None, Some(robot)) => {
            let robot = robot.to_str().ok_or_else(|| Failure::Usage("JAKA_ROBOT is not valid UTF-8".to_owned()))?;
            Some(robot.to_owned())
        }
        (None, None) => file.robot.clone(),
    })
}

/// Returns the packs of the environment, or else of the config file, for this robot or for all; and true if they are
/// from the config file.
pub(super) fn packs(lookup: Lookup<'_>, environment: &Environment) -> Result<(Vec<PathBuf>, bool), Failure> {
    if let Some(paths) = &environment.packs {
        return Ok((split_paths(paths).filter(|path| !path.as_os_str().is_empty()).collect(), false));
    }
    let file = config_file(lookup.config, environment)?;
    let named = named(lookup.robot, environment, &file)?;
    let own = named.and_then(|named| file.robots.get(&named)?.pack.clone());
    Ok((own.map_or(file.packs, |pack| vec![pack]), true))
}

/// Returns the config file to read; an empty one if it is the usual one and does not exist.
pub(super) fn config_file(path: Option<&Path>, environment: &Environment) -> Result<ConfigFile, Failure> {
    if let Some(path) = path.or(environment.config.as_deref()) {
        return ConfigFile::read(path);
    }
    let usual = environment.usual_config();
    let found = usual.map_or(Ok(None), |path| ConfigFile::read_if_there(&path))?;
    Ok(found.unwrap_or_default())
}

/// Returns the host of an address, which must have no port, since a controller has two.
fn host(address: &str) -> Result<String, Failure> {
    let bare = address.trim_start_matches('[').trim_end_matches(']');
    if bare.parse::<IpAddr>().is_ok() {
        return Ok(bare.to_owned());
    }
    if address.is_empty() || address.contains(|c: char| c.is_whitespace() || c == '/') {
        return Err(Failure::Usage(format!(
            "`{address}` is not an address, and the config file has no robot of that name"
        )));
    }
    if address.contains(':') {
        return Err(Failure::Usage(format!(
            "the address `{address}` has a port, but a controller has two: use --command-port and --status-port"
        )));
    }
    Ok(address.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn args(robot: Option<&str>) -> AddressArgs {
        AddressArgs { robot: robot.map(str::to_owned), ..AddressArgs::default() }
    }

    fn environment(robot: &str) -> Environment {
        Environment { robot: Some(robot.into()), ..Environment::default() }
    }

    #[test]
    fn the_command_line_counts_more_than_the_environment() {
        let found = RobotAddress::find(&args(Some("10.0.0.1")), &environment("10.0.0.2")).unwrap();
        assert_eq!(found.commands, "10.0.0.1:10001");
        let found = RobotAddress::find(&args(None), &environment("10.0.0.2")).unwrap();
        assert_eq!(found.status, "10.0.0.2:10000");
    }

    #[test]
    fn without_an_address_the_ways_to_give_one_are_named() {
        let failure = RobotAddress::find(&args(None), &Environment::default()).unwrap_err().to_string();
        for way in ["--robot", "JAKA_ROBOT", "config file", "--sim"] {
            assert!(failure.contains(way), "{failure}");
        }
    }

    #[test]
    fn the_times_of_a_robot_go_into_its_config() {
        let robot = RobotAddress::find(&args(Some("10.0.0.1")), &Environment::default()).unwrap();
        assert_eq!(robot.configure(Config::new()).get_stale_after(), Config::new().get_stale_after());
        let [timeout, age] = [2, 3].map(|seconds| Some(Duration::from_secs(seconds)));
        let config = RobotAddress { timeout, stale_after: age, ..robot }.configure(Config::new());
        assert_eq!((Some(config.get_reply_timeout()), Some(config.get_stale_after())), (timeout, age));
    }

    #[test]
    fn addresses_have_no_port() {
        let address =
            |text| RobotAddress::find(&args(Some(text)), &Environment::default()).map(|address| address.status);
        assert_eq!(address("arm.local").unwrap(), "arm.local:10000");
        assert_eq!(address("fe80::1").unwrap(), "[fe80::1]:10000");
        assert_eq!(address("[::1]").unwrap(), "[::1]:10000");
        for bad in ["10.5.5.100:10001", "[::1]:10001", "", "cell 1", "http://arm"] {
            assert!(matches!(address(bad), Err(Failure::Usage(_))), "{bad}");
        }
    }
}
