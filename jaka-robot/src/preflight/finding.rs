//! What was found at one item.

use std::fmt;

use jaka_proto::text::visible;

jaka_proto::worded! {
    /// What a [`Preflight`](super::Preflight) looks at, in this order.
    ///
    /// Displayed in words, such as `tool frame`.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
    #[non_exhaustive]
    pub enum CheckItem {
        /// The port for commands (10001), and whether the controller answers this client there.
        CommandPort => "command port",
        /// The port for status packets (10000), and whether packets come from there.
        StatusPort => "status port",
        /// The controller's version (`get_version`, 4.51), compared with those of which this project knows.
        Firmware => "firmware",
        /// The arm's power (`get_robot_state`, 4.12, or else packets).
        Power => "power",
        /// Whether the arm is enabled (`get_robot_state`, 4.12, or else packets).
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
        /// Whether a soft limit was hit (packets).
        SoftLimit => "soft limit",
        /// What of status packets is missing or cannot be read.
        StatusPackets => "status packets",
        /// How many status packets come in a second.
        StatusRate => "status rate",
        /// How long queries take (`get_joint_pos`, 4.49).
        RoundTrip => "round trip",
        /// The arm's model, compared with what the controller computes (`kine_forward`, 4.46).
        Model => "model",
        /// The controller's own Denavit-Hartenberg parameters (`get_dh_param`, 4.82), compared with the model's.
        DhParameters => "DH parameters",
        /// Where the arm is against its limits.
        Limits => "limits",
    }
}

jaka_proto::worded! {
    /// How a check came out. A later one counts more.
    ///
    /// Displayed in words: `nothing found`, `not checked`, `look` or `wrong`.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
    #[non_exhaustive]
    pub enum Verdict {
        /// Nothing was found. This does not mean that the arm is safe to move.
        NothingFound => "nothing found",
        /// It was not checked, or depends on what another finding tells.
        NotChecked => "not checked",
        /// It may be meant so, and somebody should look at it.
        Look => "look",
        /// The robot cannot be used as it is.
        Wrong => "wrong",
    }
}

/// What was found at one item. Its texts are lines without invisible characters, whatever the controller says.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    item: CheckItem,
    judgement: Judgement,
}

/// What was seen somewhere, and what to do about it.
#[derive(Debug, Clone, PartialEq, Eq)]
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
    /// What was looked at.
    pub fn item(&self) -> CheckItem {
        self.item
    }

    /// How it came out.
    pub fn verdict(&self) -> Verdict {
        self.judgement.verdict
    }

    /// What was seen; for what was not checked, why not.
    pub fn seen(&self) -> &str {
        &self.judgement.seen
    }

    /// What to do: there is something if the verdict is [`Look`](Verdict::Look) or [`Wrong`](Verdict::Wrong).
    pub fn advice(&self) -> Option<&str> {
        self.judgement.advice.as_deref()
    }
}

/// A row of a table, with the advice in a line of its own below it.
impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Judgement { verdict, seen, advice } = &self.judgement;
        write!(f, "{:15}  {verdict:13}  {seen}", self.item)?;
        advice.as_ref().map_or(Ok(()), |advice| write!(f, "\n{:32}{advice}", ""))
    }
}

/// What was judged, or why it could not be.
pub(super) fn either(judged: Result<Judgement, Judgement>) -> Judgement {
    judged.unwrap_or_else(|unanswered| unanswered)
}
