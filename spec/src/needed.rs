//! Fields of status packets that a robot needs, by their names in Rust as built in, and their sources.

use crate::model::Field;

/// Field of status packets that shows a robot whether the arm may move, or the progress of a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NeededField {
    /// Name in Rust of the field of the built-in status packet.
    pub name: &'static str,
    /// True if a pack cannot declare it absent.
    pub is_required: bool,
    /// Consequence of a packet that does not show it, as a phrase.
    pub without: &'static str,
}

/// Source of a field of the built-in status packet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FieldSource<'s> {
    /// Field of the status packet with the same meaning.
    Field(&'s Field),
    /// None: the packets of this controller never have it.
    Absent,
    /// The program, which reads it of what packets have otherwise.
    Program,
}

/// Source of a field that a robot needs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NeededSource<'s> {
    /// The field, as built in.
    pub needed: &'static NeededField,
    /// Its source.
    pub source: FieldSource<'s>,
    /// True if a pack names the source, or gives the field another key or form: a packet without it does not fit the
    /// pack.
    pub is_changed: bool,
}

/// Fields of status packets that a robot needs.
///
/// A pack that gives one of them another type, unit or name says in its table `[robot_status]` where packets have it.
pub const NEEDED_FIELDS: &[NeededField] = &[
    required("emergency_stop", "the emergency stop is not seen"),
    required("protective_stop", "the protective stop is not seen"),
    required("powered_on", "a loss of power is not seen"),
    required("enabled", "an arm that is disabled is not seen"),
    required("in_position", "packets do not show that the arm moves"),
    required("joint_actual_position", "servo sessions and guards do not see where the joints are"),
    optional("drag_status", "drag mode is not seen, in which a hand leads the arm"),
    optional("on_soft_limit", "a soft limit that is hit is not seen"),
    optional("paused", "a motion that is paused ends as stopped"),
    optional("error_code", "an error of the controller is not seen"),
    optional("error_message", "an error of the controller comes without its text"),
    optional("actual_position", "guards do not see where the tool is"),
    optional("current_tool_id", "a tool frame that another program selects during a motion is not seen"),
    optional("current_user_frame_id", "a user frame that another program selects during a motion is not seen"),
];

/// Words of a pack for a needed field, in place of a field.
pub(crate) const ABSENT: &str = "absent";
pub(crate) const PROGRAM: &str = "program";

/// Line of a pack's table `[robot_status]`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum StatusLine {
    /// Name in Rust of a field of the status packet.
    Field(String),
    Absent,
    Program,
}

impl StatusLine {
    pub(crate) fn of(text: &str) -> Self {
        match text {
            ABSENT => Self::Absent,
            PROGRAM => Self::Program,
            name => Self::Field(name.to_owned()),
        }
    }
}

const fn required(name: &'static str, without: &'static str) -> NeededField {
    NeededField { name, is_required: true, without }
}

const fn optional(name: &'static str, without: &'static str) -> NeededField {
    NeededField { name, is_required: false, without }
}
