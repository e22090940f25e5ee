//! What was found at one item.

use std::fmt;

use jaka_proto::text::visible;

/// What a [`Preflight`](super::Preflight) looks at, in this order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum CheckItem {
    /// The port for commands (10001), and whether the controller answers this client there.
    CommandPort,
    /// The port for status packets (10000), and whether packets come from there.
    StatusPort,
    /// The controller's version (`get_version`, 4.51), compared with those of which this project knows.
    Firmware,
    /// The arm's power (`get_robot_state`, 4.12, or else packets).
    Power,
    /// Whether the arm is enabled (`get_robot_state`, 4.12, or else packets).
    Enabled,
    /// The emergency stop (packets).
    EmergencyStop,
    /// The protective stop (`protective_stop_status`, 4.40, and packets).
    ProtectiveStop,
    /// The controller's event, with its severity (packets).
    Event,
    /// Servo mode (`is_in_servomove`, 4.13).
    ServoMode,
    /// Drag mode (`drag_status`, 4.37).
    DragMode,
    /// The program (`get_program_state`, 4.24).
    Program,
    /// The selected tool frame (packets), and its offset (`get_tool_offsets`, 4.30).
    ToolFrame,
    /// The selected user frame (packets), and its offset (`get_user_offsets`, 4.33).
    UserFrame,
    /// The payload (`get_payload`, 4.43).
    Payload,
    /// The rate by which motions are scaled (packets).
    RapidRate,
    /// The collision level (`get_clsn_sensitivity`, 4.45).
    CollisionLevel,
    /// Whether a soft limit was hit (packets).
    SoftLimit,
    /// What of status packets is missing or cannot be read.
    StatusPackets,
    /// How many status packets come in a second.
    StatusRate,
    /// How long queries take (`get_joint_pos`, 4.49).
    RoundTrip,
    /// The arm's model, compared with what the controller computes (`kine_forward`, 4.46).
    #[cfg(feature = "motion")]
    Model,
    /// The controller's own Denavit-Hartenberg parameters (`get_dh_param`, 4.82), compared with the model's.
    #[cfg(feature = "motion")]
    DhParameters,
    /// Where the arm is against its limits.
    #[cfg(feature = "motion")]
    Limits,
}

/// In words, such as `tool frame`.
impl fmt::Display for CheckItem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::CommandPort => "command port",
            Self::StatusPort => "status port",
            Self::Firmware => "firmware",
            Self::Power => "power",
            Self::Enabled => "enabled",
            Self::EmergencyStop => "emergency stop",
            Self::ProtectiveStop => "protective stop",
            Self::Event => "event",
            Self::ServoMode => "servo mode",
            Self::DragMode => "drag mode",
            Self::Program => "program",
            Self::ToolFrame => "tool frame",
            Self::UserFrame => "user frame",
            Self::Payload => "payload",
            Self::RapidRate => "rapid rate",
            Self::CollisionLevel => "collision level",
            Self::SoftLimit => "soft limit",
            Self::StatusPackets => "status packets",
            Self::StatusRate => "status rate",
            Self::RoundTrip => "round trip",
            #[cfg(feature = "motion")]
            Self::Model => "model",
            #[cfg(feature = "motion")]
            Self::DhParameters => "DH parameters",
            #[cfg(feature = "motion")]
            Self::Limits => "limits",
        })
    }
}

/// How a check came out. A later one counts more.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Verdict {
    /// Nothing was found. This does not mean that the arm is safe to move.
    NothingFound,
    /// It was not checked, or depends on what another finding tells.
    NotChecked,
    /// It may be meant so, and somebody should look at it.
    Look,
    /// The robot cannot be used as it is.
    Wrong,
}

/// In words: `nothing found`, `not checked`, `look` or `wrong`.
impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::NothingFound => "nothing found",
            Self::NotChecked => "not checked",
            Self::Look => "look",
            Self::Wrong => "wrong",
        })
    }
}

/// What was found at one item. Its texts are lines without invisible characters, whatever the controller says.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    item: CheckItem,
    verdict: Verdict,
    seen: String,
    advice: Option<String>,
}

impl Finding {
    pub(super) fn nothing(item: CheckItem, seen: impl AsRef<str>) -> Self {
        Self::new(item, Verdict::NothingFound, seen.as_ref(), None)
    }

    pub(super) fn not_checked(item: CheckItem, why: impl AsRef<str>) -> Self {
        Self::new(item, Verdict::NotChecked, why.as_ref(), None)
    }

    pub(super) fn look(item: CheckItem, seen: impl AsRef<str>, advice: &str) -> Self {
        Self::new(item, Verdict::Look, seen.as_ref(), Some(advice))
    }

    pub(super) fn wrong(item: CheckItem, seen: impl AsRef<str>, advice: &str) -> Self {
        Self::new(item, Verdict::Wrong, seen.as_ref(), Some(advice))
    }

    fn new(item: CheckItem, verdict: Verdict, seen: &str, advice: Option<&str>) -> Self {
        Self { item, verdict, seen: visible(seen).into_owned(), advice: advice.map(str::to_owned) }
    }

    /// What was looked at.
    pub fn item(&self) -> CheckItem {
        self.item
    }

    /// How it came out.
    pub fn verdict(&self) -> Verdict {
        self.verdict
    }

    /// What was seen; for what was not checked, why not.
    pub fn seen(&self) -> &str {
        &self.seen
    }

    /// What to do: there is something if the verdict is [`Look`](Verdict::Look) or [`Wrong`](Verdict::Wrong).
    pub fn advice(&self) -> Option<&str> {
        self.advice.as_deref()
    }
}

/// A row of a table, with the advice in a line of its own below it.
impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:15}  {:13}  {}", self.item, self.verdict, self.seen)?;
        self.advice.as_ref().map_or(Ok(()), |advice| write!(f, "\n{:32}{advice}", ""))
    }
}
