//! Meaning of a command to the arm: roles, changes and motions.

toml_words! {
    /// Role of a request for the arm, which decides the times at which it may be sent.
    pub enum Role {
        /// Stops the arm. Stop handles, guards and sessions send the built-in `stop_program` alone.
        Stop: "stop",
        /// Stops the jog of one axis.
        StopAxis: "stop_axis",
        /// Pauses a motion or a program.
        Pause: "pause",
        /// Resumes a paused motion.
        Resume: "resume",
        /// Set-point of servo mode.
        SetPoint: "set_point",
        /// Enters or leaves servo mode. A request that leaves it has a role of its own.
        ServoMode: "servo_mode",
        /// Sets an output. Passes while a session, a stream or a trajectory moves the arm.
        Output: "output",
        /// Short query for a state of the robot. Passes while a session, a stream or a trajectory moves the arm.
        State: "state",
    }
}

toml_words! {
    /// Property of the arm that a command changes, and on which other commands depend.
    pub enum Change {
        /// Frames to which poses refer: the user frame, or the mounting of the arm.
        Frames: "frames",
        /// Tool frame, whose origin is the tool centre point.
        Tool: "tool",
        /// Payload.
        Payload: "payload",
    }
}

/// Motion that a command starts, by the Rust names of the fields of its request.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Motion {
    /// Path to the target; `None` if the controller chooses it.
    pub path: Option<PathKind>,
    /// Field with the target, a `JointPosition` or a `Pose`.
    pub target: String,
    /// Field that says whether the target is absolute or an offset; `None` for an absolute target.
    pub mode: Option<MotionMode>,
    /// Field with the pose between the ends of an arc.
    pub through: Option<String>,
    /// Field with the speed.
    pub speed: Option<String>,
    /// Field with the acceleration.
    pub acceleration: Option<String>,
    /// Field with the tolerance: the distance from the target at which the controller may blend into the next motion.
    pub tolerance: Option<String>,
    /// Optional fields with which the path is unknown, since no source says how they change it.
    pub unknown_with: Vec<String>,
}

/// Enum that says whether the target of a motion is absolute or an offset. With any other value it is unknown.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MotionMode {
    /// Field with the enum.
    pub field: String,
    /// Value for an absolute target.
    pub absolute: i64,
    /// Value for an offset: of the joints, or along the axes of the selected user frame.
    pub offset: Option<i64>,
}

/// Kind of path of a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PathKind {
    /// All joints at once.
    Joints,
    /// Tool centre point on a straight line.
    Line,
    /// Tool centre point on an arc.
    Arc,
}

/// Type of the target of a motion in joint positions.
pub const JOINT_POSITION: &str = "JointPosition";

/// Type of a pose.
pub const POSE: &str = "Pose";

impl PathKind {
    /// Words of the TOML files, each with its value.
    pub(crate) const WORDS: &'static [(&'static str, Self)] =
        &[("joints", Self::Joints), ("line", Self::Line), ("arc", Self::Arc)];

    /// Unit of the speed on it.
    pub(crate) fn speed_unit(self) -> &'static str {
        match self {
            Self::Joints => "deg/s",
            Self::Line | Self::Arc => "mm/s",
        }
    }

    /// Unit of the acceleration on it.
    pub(crate) fn acceleration_unit(self) -> &'static str {
        match self {
            Self::Joints => "deg/s²",
            Self::Line | Self::Arc => "mm/s²",
        }
    }
}

impl Motion {
    /// True if it names this field.
    pub(crate) fn names(&self, field: &str) -> bool {
        let Self { path: _, target, mode, through, speed, acceleration, tolerance, unknown_with } = self;
        let mode = mode.as_ref().map(|mode| &mode.field);
        let names = [Some(target), mode, through.as_ref(), speed.as_ref(), acceleration.as_ref(), tolerance.as_ref()];
        names.into_iter().flatten().chain(unknown_with).any(|name| name == field)
    }

    /// Follows a field that gets another name in Rust.
    pub(crate) fn rename(&mut self, old: &str, new: &str) {
        let Self { path: _, target, mode, through, speed, acceleration, tolerance, unknown_with } = self;
        let mode = mode.as_mut().map(|mode| &mut mode.field);
        let names = [mode, through.as_mut(), speed.as_mut(), acceleration.as_mut(), tolerance.as_mut()];
        names
            .into_iter()
            .flatten()
            .chain([target])
            .chain(unknown_with)
            .filter(|name| *name == old)
            .for_each(|name| new.clone_into(name));
    }
}
