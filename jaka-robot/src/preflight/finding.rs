//! Findings, one for each item.

use std::fmt;

use jaka_proto::text::visible;

jaka_proto::worded! {
    /// Item of a [`Preflight`](super::Preflight), in the order of the check.
    ///
    /// Displayed in words, such as `tool frame`.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
    #[non_exhaustive]
    pub enum CheckItem {
        /// The port for commands (10001), and whether the controller answers this client there.
        CommandPort => "command port",
        /// The port for status packets (10000), and whether packets come from there.
        StatusPort => "status port",
        /// The controller's version (`get_version`, 4.51), compared with the versions that this project knows.
        Firmware => "firmware",
        /// The arm's power (`get_robot_state`, 4.12, or else packets).
        Power => "power",
        /// The enabled state of the arm (`get_robot_state`, 4.12, or else packets).
        Enabled => "enabled",
        /// The emergency stop (packets).
        EmergencyStop => "emergency stop",
        /// The protective stop (`protective_stop_status`, 4.40, and packets).
        ProtectiveStop => "protective stop",
        /// The controller's event, with its severity (packets).
        Event => "event",
        /// Servo mode (`is_in_servomove`, 4.13).
        ServoMode => "servo mode",
        /// Drag mode (`drag_status`, 4.37).
        DragMode => "drag mode",
        /// The program (`get_program_state`, 4.24).
        Program => "program",
        /// The selected tool frame (packets), and its offset (`get_tool_offsets`, 4.30).
        ToolFrame => "tool frame",
        /// The selected user frame (packets), and its offset (`get_user_offsets`, 4.33).
        UserFrame => "user frame",
        /// The payload (`get_payload`, 4.43).
        Payload => "payload",
        /// The rate by which motions are scaled (packets).
        RapidRate => "rapid rate",
        /// The collision level (`get_clsn_sensitivity`, 4.45).
        CollisionLevel => "collision level",
        /// A soft limit that was hit (packets).
        SoftLimit => "soft limit",
        /// Keys of status packets that are missing or cannot be read.
        StatusPackets => "status packets",
        /// Number of status packets in a second.
        StatusRate => "status rate",
        /// Round-trip time of queries (`get_joint_pos`, 4.49).
        RoundTrip => "round trip",
        /// The arm's model, compared with the controller's computations (`kine_forward`, 4.46).
        Model => "model",
        /// The controller's own Denavit-Hartenberg parameters (`get_dh_param`, 4.82), compared with the model's.
        DhParameters => "DH parameters",
        /// Place of the arm against its limits.
        Limits => "limits",
    }
}

jaka_proto::worded! {
    /// Result of a check. A later one counts more.
    ///
    /// Displayed in words: `nothing found`, `not checked`, `look` or `wrong`.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
    #[non_exhaustive]
    pub enum Verdict {
        /// Nothing was found. This does not mean that the arm is safe to move.
        NothingFound => "nothing found",
        /// It was not checked, or depends on another finding.
        NotChecked => "not checked",
        /// It may be meant so, and somebody should look at it.
        Look => "look",
        /// The robot cannot be used as it is.
        Wrong => "wrong",
    }
}

/// Finding at one item. Its texts are single lines without invisible characters, for any text of the controller.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Finding {
    item: CheckItem,
    #[cfg_attr(feature = "serde", serde(flatten))]
    judgement: Judgement,
}

/// Observation, its verdict, and advice.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub(super) struct Judgement {
    pub(super) verdict: Verdict,
    seen: String,
    advice: Option<String>,
}

impl Judgement {
    pub(super) fn nothing(seen: impl AsRef<str>) -> Self {
        Self::new(Verdict::NothingFound, seen.as_ref(), None)
    }

    pub(super) fn not_checked(why: impl AsRef<str>) -> Self {
        Self::new(Verdict::NotChecked, why.as_ref(), None)
    }

    pub(super) fn look(seen: impl AsRef<str>, advice: &str) -> Self {
        Self::new(Verdict::Look, seen.as_ref(), Some(advice))
    }

    pub(super) fn wrong(seen: impl AsRef<str>, advice: &str) -> Self {
        Self::new(Verdict::Wrong, seen.as_ref(), Some(advice))
    }

    fn new(verdict: Verdict, seen: &str, advice: Option<&str>) -> Self {
        Self { verdict, seen: visible(seen).into_owned(), advice: advice.map(str::to_owned) }
    }

    /// The finding at this item.
    pub(super) fn at(self, item: CheckItem) -> Finding {
        Finding { item, judgement: self }
    }
}

impl Finding {
    /// Item that was checked.
    pub fn item(&self) -> CheckItem {
        self.item
    }

    /// Result of the check.
    pub fn verdict(&self) -> Verdict {
        self.judgement.verdict
    }

    /// Observation; for an item that was not checked, the reason.
    pub fn seen(&self) -> &str {
        &self.judgement.seen
    }

    /// Advice: there is some if the verdict is [`Look`](Verdict::Look) or [`Wrong`](Verdict::Wrong).
    pub fn advice(&self) -> Option<&str> {
        self.judgement.advice.as_deref()
    }
}

/// A row of a table, with the advice in a separate line below it.
impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Judgement { verdict, seen, advice } = &self.judgement;
        write!(f, "{:15}  {verdict:13}  {seen}", self.item)?;
        advice.as_ref().map_or(Ok(()), |advice| write!(f, "\n{:32}{advice}", ""))
    }
}

/// Judgement on an answer, or on its absence.
pub(super) fn either(judged: Result<Judgement, Judgement>) -> Judgement {
    judged.unwrap_or_else(|unanswered| unanswered)
}
