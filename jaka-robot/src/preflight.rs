//! Check of a robot before its use: finds obstacles, and settings for somebody to look at. It reads, and never changes
//! anything.

mod arm;
mod commands;
mod finding;
mod packets;
mod ports;
mod round_trip;
mod settings;

use std::fmt::{self, Display};

use jaka_motion::Limits;
use jaka_proto::messages::status::RobotStatus;
use jaka_sync::layer::{MonitorParts as _, Stops};
use jaka_sync::{Client, Config, Error, Monitor, MotionStatus};

use self::commands::Commands;
pub use self::finding::{CheckItem, Finding, Verdict};
use self::packets::Count;
use crate::arm::{ArmState, StatusPort};

/// Findings on a robot before its use: see [`Robot::preflight`](crate::Robot::preflight) and
/// [`read_at`](Self::read_at).
///
/// Displayed as a table, with the points to look at [at the pendant](Self::AT_THE_PENDANT) and the limits of the
/// verdicts.
///
/// With the feature `serde`, its form is `verdict`, `findings` (`item`, `verdict`, `seen` and `advice`),
/// `at_the_pendant` (`item` and `what`), and `note`.
#[derive(Debug, Clone, PartialEq, Eq)]
#[must_use = "a check changes nothing: what it found is all that it does"]
pub struct Preflight {
    findings: Vec<Finding>,
}

impl Preflight {
    /// Settings without a query, each with its effect. Look at them at the pendant.
    pub const AT_THE_PENDANT: &[(&str, &str)] = &[
        ("remote control", "acceptance of motions from this program"),
        ("mounting", "direction of the mounting; poses and kinematics depend on it"),
        ("network exception", "reaction of the arm to a lost connection (4.75)"),
        ("soft limits", "joint ranges, speeds and zones in the controller itself"),
    ];

    /// Note on the limits of the verdicts.
    pub const NOTE: &str = "\"Nothing found\" is not \"safe\": states and settings were read, and nothing is known of the \
                            cell, the people in it, the tool, and where the arm will move.";

    /// Connects to a controller's two ports, and does the same as [`Robot::preflight`](crate::Robot::preflight): for a
    /// new robot, since a port without a connection is a finding.
    ///
    /// The command port serves one client: another program that is connected there may be disconnected.
    pub fn read_at(config: &Config, commands_address: impl Display, status_address: impl Display) -> Self {
        Self::read_as::<RobotStatus>(config, commands_address, status_address, None)
    }

    /// Reads an arm by another type of status packets, such as a [pack](crate::pack!)'s:
    /// `Preflight::read_as::<newer::RobotStatus>(…)`.
    pub fn read_as<S: MotionStatus>(
        config: &Config,
        commands_address: impl Display,
        status_address: impl Display,
        limits: Option<&Limits>,
    ) -> Self {
        let monitor = Monitor::<S>::connect_with(config, status_address);
        let mut client = Client::connect_with(config, commands_address);
        let state = monitor.as_ref().map(|monitor| ArmState::new(monitor, &Stops::new(monitor.clock()), true));
        let status = monitor
            .as_ref()
            .and_then(|source| Ok(StatusPort { source, state: state.as_ref().map_err(|&error| error)? }));
        Self::read(client.as_mut().map_err(|error| &*error), status, limits)
    }

    /// One finding for each [`CheckItem`], in its order.
    pub fn findings(&self) -> &[Finding] {
        &self.findings
    }

    /// The worst of all verdicts.
    pub fn verdict(&self) -> Verdict {
        self.findings.iter().map(Finding::verdict).max().unwrap_or(Verdict::NotChecked)
    }

    /// Reads an arm by the ports that are connected, and compares it with these limits.
    pub(crate) fn read(
        client: Result<&mut Client, &Error>,
        status: Result<StatusPort<'_>, &Error>,
        limits: Option<&Limits>,
    ) -> Self {
        let mut findings = Vec::new();
        let count = Count::begin(status);
        let mut commands = Commands::open(client, &mut findings);
        findings.push(round_trip::measure(&mut commands).at(CheckItem::RoundTrip));
        arm::read(limits, &mut commands, &mut findings);
        let packet = count.and_then(|count| count.end(&mut findings)).unwrap_or_else(|port| {
            findings.push(port.at(CheckItem::StatusPort));
            findings
                .extend([CheckItem::StatusPackets, CheckItem::StatusRate].map(|item| packets::no_packet().at(item)));
            None
        });
        let packet: Option<&RobotStatus> = packet.as_ref().map(|packet| &packet.status);
        settings::read(&mut commands, packet, &mut findings);
        packets::read(packet, &mut findings);
        findings.sort_by_key(Finding::item);
        Self { findings }
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for Preflight {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(serde::Serialize)]
        struct Form<'p> {
            verdict: Verdict,
            findings: &'p [Finding],
            at_the_pendant: Vec<Setting>,
            note: &'static str,
        }
        #[derive(serde::Serialize)]
        struct Setting {
            item: String,
            what: &'static str,
        }
        let settings = Self::AT_THE_PENDANT.iter().map(|(item, what)| Setting { item: item.replace(' ', "_"), what });
        let (verdict, findings, at_the_pendant) = (self.verdict(), self.findings(), settings.collect());
        Form { verdict, findings, at_the_pendant, note: Self::NOTE }.serialize(serializer)
    }
}

/// A table of the findings, then the settings without a query, the number of findings, and the note on the verdicts.
impl Display for Preflight {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for finding in &self.findings {
            writeln!(f, "{finding}")?;
        }
        writeln!(f, "\nLook at the pendant for these, which no query reads:")?;
        for (what, decides) in Self::AT_THE_PENDANT {
            writeln!(f, "{what:17}  {decides}")?;
        }
        let count = |verdict| self.findings.iter().filter(|finding| finding.verdict() == verdict).count();
        let (wrong, look) = (count(Verdict::Wrong), count(Verdict::Look));
        writeln!(f, "\n{wrong} wrong, {look} to look at, {} not checked.", count(Verdict::NotChecked))?;
        f.write_str(Self::NOTE)
    }
}
