/// Power, enabling and the controller's state.
///
/// The arm is ready to move when it has power and is enabled, in this order.
///
/// A reply to `power_on` or `enable_robot`, even with errorCode 0, is no proof of the new state: firmware 1.5.14 replies when the state is
/// there, newer firmware at once. Poll `get_robot_state` or the status of port 10000 until the state is there.
///
/// Leave the states in the reverse order, from an arm at rest: powering off wants a disabled arm, a shutdown one without power (events in the
/// vendor's table).
pub mod power {
    #[allow(unused_imports)]
    use ::jaka_proto::{self as proto, check, wire};
    /// Switches the arm's power off.
    ///
    /// It wants a disabled arm (event `0x0F0026`).
    ///
    /// Sends `power_off` (4.2).
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct PowerOff {}
    impl wire::Fields for PowerOff {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self {})
        }
    }
    proto::__object_impls!(PowerOff);
    impl PowerOff {
        /// Without any optional field.
        #[must_use]
        pub const fn new() -> Self {
            Self {}
        }
    }
    impl check::Validate for PowerOff {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for PowerOff {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
                "power_off",
                "{\"cmdName\":\"power_off\"",
                "4.2",
                proto::Effect::Power,
            )
            .deadline_ms(15000u64);
    }
    /// Reads whether the arm has power and is enabled.
    ///
    /// Old firmware answers with the document's words, newer firmware with true and false or with numbers, and adds the
    /// controller's error.
    ///
    /// Sends `get_robot_state` (4.12). Changes nothing on the robot.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetRobotState {}
    impl wire::Fields for GetRobotState {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self {})
        }
    }
    proto::__object_impls!(GetRobotState);
    impl GetRobotState {
        /// Without any optional field.
        #[must_use]
        pub const fn new() -> Self {
            Self {}
        }
    }
    impl check::Validate for GetRobotState {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for GetRobotState {
        type Reply = GetRobotStateReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "get_robot_state",
            "{\"cmdName\":\"get_robot_state\"",
            "4.12",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`GetRobotState`].
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetRobotStateReply {
        /// Whether the arm is enabled.
        ///
        /// `enable` on the wire.
        #[doc(alias = "enable")]
        pub enabled: bool,
        /// Whether the arm has power.
        ///
        /// `power` on the wire.
        #[doc(alias = "power")]
        pub powered_on: bool,
        /// Code of the controller's event, which is not always an error; newer firmware adds the key.
        ///
        /// Firmware 1.5.14 writes a number, 17760261 for `0x10f0005`, which is kept as raw JSON; the vendor's own SDK reads nothing else. Clients
        /// of newer firmware have met a hexadecimal string such as `0x0`, as on port 10000. The Rust method `event` reads both.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `errcode` on the wire.
        #[doc(alias = "errcode")]
        pub error_code: Option<wire::Typed<String>>,
        /// The message that goes with `error_code`, which newer firmware adds.
        ///
        /// `msg` on the wire.
        #[doc(alias = "msg")]
        pub error_message: Option<String>,
    }
    impl wire::Fields for GetRobotStateReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"enable\":");
            out.choose(*&self.enabled, "\"robot_disabled\"", "\"robot_enabled\"");
            out.raw(",\"power\":");
            out.choose(*&self.powered_on, "\"powered_off\"", "\"powered_on\"");
            if let Some(value) = &self.error_code {
                out.raw(",\"errcode\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.error_message {
                out.raw(",\"msg\":");
                wire::Encode::encode(value, out);
            }
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut enabled = None;
            let mut powered_on = None;
            let mut error_code = None;
            let mut error_message = None;
            let mut keys = reader
                .begin_fields(
                    &["\"enable\":", "\"power\":", "\"errcode\":", "\"msg\":"],
                )?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => {
                        reader
                            .field_word(
                                "enabled",
                                &mut enabled,
                                "robot_disabled",
                                "robot_enabled",
                            )?
                    }
                    1 => {
                        reader
                            .field_word(
                                "powered_on",
                                &mut powered_on,
                                "powered_off",
                                "powered_on",
                            )?
                    }
                    2 => reader.field("error_code", &mut error_code)?,
                    3 => reader.field("error_message", &mut error_message)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                enabled: enabled
                    .ok_or_else(|| wire::DecodeError::missing("enabled", "enable"))?,
                powered_on: powered_on
                    .ok_or_else(|| wire::DecodeError::missing("powered_on", "power"))?,
                error_code,
                error_message,
            })
        }
    }
    proto::__object_impls!(GetRobotStateReply);
    /// What replies hold, as structs that can be written as literals. They grow with the spec, so that the compiler leads
    /// to each place where a field is forgotten, and are no part of the interface.
    #[doc(hidden)]
    #[allow(missing_docs, missing_debug_implementations, clippy::too_many_lines)]
    pub mod literal {
        pub struct GetRobotStateReply {
            pub enabled: bool,
            pub powered_on: bool,
            pub error_code: Option<super::wire::Typed<String>>,
            pub error_message: Option<String>,
        }
        impl From<GetRobotStateReply> for super::GetRobotStateReply {
            #[inline]
            fn from(
                GetRobotStateReply {
                    enabled,
                    powered_on,
                    error_code,
                    error_message,
                }: GetRobotStateReply,
            ) -> Self {
                Self {
                    enabled,
                    powered_on,
                    error_code,
                    error_message,
                }
            }
        }
    }
}
/// Jog and planned motion.
///
/// The controller's own planner drives these motions. The reply says that a motion was accepted, not that it has ended:
/// newer firmware replies at once, firmware 1.4, or any firmware that is still moving, may reply seconds later.
///
/// Motions queue (4.7 to 4.9): the next one starts when the one before has ended. `stop_program` ends the motion that is
/// running.
pub mod motion {
    #[allow(unused_imports)]
    use ::jaka_proto::{self as proto, check, wire};
    /// Moves all joints to a position, or by an offset, at a joint speed (MoveJ).
    ///
    /// The motion starts when the one before it has ended. To move at once, stop that one first with `stop_program`.
    ///
    /// The reply says that the motion was accepted, not that it has ended.
    ///
    /// Sends `joint_move` (4.7). The robot must be powered, enabled and outside servo mode.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct JointMove {
        /// Whether `joint_position` is a target or an offset.
        ///
        /// `relFlag` on the wire.
        #[doc(alias = "relFlag")]
        pub mode: super::types::MoveMode,
        /// Target or offset of the six joints.
        ///
        /// `jointPosition` on the wire.
        #[doc(alias = "jointPosition")]
        pub joint_position: super::types::JointPosition,
        /// Joint speed; the direction comes from `joint_position` alone. In deg/s, at least 0.
        pub speed: f64,
        /// Joint acceleration. In deg/s², at least 0. The document advises 720 at most. Controllers take the command without it (field notes).
        ///
        /// `accel` on the wire.
        #[doc(alias = "accel")]
        pub acceleration: Option<f64>,
    }
    impl wire::Fields for JointMove {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"relFlag\":");
            wire::Encode::encode(&self.mode, out);
            out.raw(",\"jointPosition\":");
            wire::Encode::encode(&self.joint_position, out);
            out.raw(",\"speed\":");
            wire::Encode::encode(&self.speed, out);
            if let Some(value) = &self.acceleration {
                out.raw(",\"accel\":");
                wire::Encode::encode(value, out);
            }
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut mode = None;
            let mut joint_position = None;
            let mut speed = None;
            let mut acceleration = None;
            let mut keys = reader
                .begin_fields(
                    &["\"relFlag\":", "\"jointPosition\":", "\"speed\":", "\"accel\":"],
                )?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("mode", &mut mode)?,
                    1 => reader.field("joint_position", &mut joint_position)?,
                    2 => reader.field("speed", &mut speed)?,
                    3 => reader.field("acceleration", &mut acceleration)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                mode: mode.ok_or_else(|| wire::DecodeError::missing("mode", "relFlag"))?,
                joint_position: joint_position
                    .ok_or_else(|| wire::DecodeError::missing(
                        "joint_position",
                        "jointPosition",
                    ))?,
                speed: speed
                    .ok_or_else(|| wire::DecodeError::missing("speed", "speed"))?,
                acceleration,
            })
        }
    }
    proto::__object_impls!(JointMove);
    impl JointMove {
        /// With the required fields alone.
        ///
        /// - `speed`: in deg/s, at least 0
        #[must_use]
        pub fn new(
            mode: super::types::MoveMode,
            joint_position: impl Into<super::types::JointPosition>,
            speed: f64,
        ) -> Self {
            Self {
                mode,
                joint_position: joint_position.into(),
                speed,
                acceleration: None,
            }
        }
        /// The coordinates are the target.
        ///
        /// - `speed`: in deg/s, at least 0
        #[must_use]
        pub fn absolute(
            joint_position: impl Into<super::types::JointPosition>,
            speed: f64,
        ) -> Self {
            Self::new(super::types::MoveMode::Absolute, joint_position, speed)
        }
        /// The coordinates are an offset.
        ///
        /// - `speed`: in deg/s, at least 0
        #[must_use]
        pub fn relative(
            joint_position: impl Into<super::types::JointPosition>,
            speed: f64,
        ) -> Self {
            Self::new(super::types::MoveMode::Relative, joint_position, speed)
        }
        /// Joint acceleration. In deg/s², at least 0. The document advises 720 at most. Controllers take the command without it (field notes).
        ///
        /// `accel` on the wire.
        #[doc(alias = "accel")]
        #[must_use]
        pub fn acceleration(mut self, acceleration: f64) -> Self {
            self.acceleration = Some(acceleration);
            self
        }
    }
    impl check::Validate for JointMove {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("mode", &self.mode, &check::Limits::NONE)?;
            place.check("joint_position", &self.joint_position, &check::Limits::NONE)?;
            place
                .check(
                    "speed",
                    &self.speed,
                    &check::Limits {
                        min: Some(0f64),
                        unit: "deg/s",
                        ..check::Limits::NONE
                    },
                )?;
            place
                .check(
                    "acceleration",
                    &self.acceleration,
                    &check::Limits {
                        min: Some(0f64),
                        unit: "deg/s²",
                        ..check::Limits::NONE
                    },
                )?;
            Ok(())
        }
    }
    impl proto::Command for JointMove {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
                "joint_move",
                "{\"cmdName\":\"joint_move\"",
                "4.7",
                proto::Effect::Motion,
            )
            .requires(
                &[
                    proto::Requirement::Powered,
                    proto::Requirement::Enabled,
                    proto::Requirement::NotServoMode,
                ],
            )
            .deadline_ms(60000u64);
    }
}
/// Servo mode.
///
/// In servo mode the arm follows set-points that come one by one, without the controller's planner between them.
///
/// A set-point is due every 8 ms, or every multiple of it that `step_count` gives, and each is answered. Plan the
/// trajectory beforehand: what the set-points ask goes straight to the drives. For other purposes the document advises
/// `joint_move` and `move_l`.
pub mod servo {
    #[allow(unused_imports)]
    use ::jaka_proto::{self as proto, check, wire};
    /// Sets the filter that smooths the set-points of servo mode.
    ///
    /// It can be set only outside servo mode. Filters 1, 2, 3 and 5 act on `servo_j` and `servo_p`, filter 4 on `servo_p` alone (vendor's
    /// manual).
    ///
    /// Sends `set_servo_move_filter` (4.60). The robot must be outside servo mode.
    ///
    /// # Errata
    ///
    /// - The text calls `filter_type` the motion mode, as copied from 4.6.
    /// - The text writes the keys `max_vr`, `max_ar`, `max_jr`, `max_vp`, `max_ap` and `max_jp`. The samples have `nlf_` before each of them.
    /// - The limits on rotation are printed in %/s, %/s^2 and %/s^3, without anything they could be a percentage of. Those of filter 2 are degrees (vendor's manual), and the field notes find degrees throughout.
    /// - The limits of filter 2 are explained as limits on how fast the orientation changes, as those of filter 4, which works in Cartesian space. They are limits of the joints (vendor's manual).
    /// - Filter 5 is listed as speed look-ahead and explained as filter 3, the multi-stage mean filter of the joints.
    /// - `mmf_kp` is explained as coefficient of the position for filter 3, and of the acceleration for filter 5. It is that of the position for both (vendor's manual).
    /// - For filter 5 the text writes the key `max_buf`, the sample `mmf_max_buf`.
    /// - `mmf_ka` is explained as coefficient of acceleration and position. The key speaks of the acceleration alone.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub enum SetServoMoveFilter {
        /// No filter.
        #[non_exhaustive]
        Disabled,
        /// First-order low-pass filter on the joints.
        #[non_exhaustive]
        JointLowPass {
            /// Cut-off frequency. In Hz, at least 0.
            ///
            /// `lpf_cf` on the wire.
            #[doc(alias = "lpf_cf")]
            cutoff_frequency: f64,
        },
    }
    impl wire::Fields for SetServoMoveFilter {
        fn write_fields(&self, out: &mut wire::Writer) {
            match self {
                Self::Disabled {} => {
                    out.key("\"filter_type\":0");
                }
                Self::JointLowPass { cutoff_frequency } => {
                    out.key("\"filter_type\":1");
                    out.raw(",\"lpf_cf\":");
                    wire::Encode::encode(cutoff_frequency, out);
                }
            }
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            match reader.tag("filter_type", "filter_type")? {
                0 => {
                    let mut keys = reader.begin_fields(&[])?;
                    while let Some(key) = reader.next_field(&mut keys)? {
                        match key {
                            _ => reader.skip()?,
                        }
                    }
                    Ok(Self::Disabled {})
                }
                1 => {
                    let mut cutoff_frequency = None;
                    let mut keys = reader.begin_fields(&["\"lpf_cf\":"])?;
                    while let Some(key) = reader.next_field(&mut keys)? {
                        match key {
                            0 => reader.field("cutoff_frequency", &mut cutoff_frequency)?,
                            _ => reader.skip()?,
                        }
                    }
                    Ok(Self::JointLowPass {
                        cutoff_frequency: cutoff_frequency
                            .ok_or_else(|| wire::DecodeError::missing(
                                "cutoff_frequency",
                                "lpf_cf",
                            ))?,
                    })
                }
                other => {
                    Err(
                        wire::DecodeError::unfit("one of 0, 1", &other.to_string())
                            .in_field("filter_type"),
                    )
                }
            }
        }
    }
    proto::__object_impls!(SetServoMoveFilter);
    impl SetServoMoveFilter {
        /// No filter.
        #[must_use]
        pub const fn disabled() -> Self {
            Self::Disabled {}
        }
        /// First-order low-pass filter on the joints.
        ///
        /// - `cutoff_frequency`: in Hz, at least 0
        #[must_use]
        pub const fn joint_low_pass(cutoff_frequency: f64) -> Self {
            Self::JointLowPass {
                cutoff_frequency,
            }
        }
    }
    impl check::Validate for SetServoMoveFilter {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            match self {
                Self::Disabled {} => {}
                Self::JointLowPass { cutoff_frequency } => {
                    place
                        .check(
                            "cutoff_frequency",
                            cutoff_frequency,
                            &check::Limits {
                                min: Some(0f64),
                                unit: "Hz",
                                ..check::Limits::NONE
                            },
                        )?;
                }
            }
            Ok(())
        }
    }
    impl proto::Command for SetServoMoveFilter {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
                "set_servo_move_filter",
                "{\"cmdName\":\"set_servo_move_filter\"",
                "4.60",
                proto::Effect::Setting,
            )
            .requires(&[proto::Requirement::NotServoMode]);
    }
}
/// Programs and the speed rate.
///
/// Loads a program that is stored on the controller, starts, pauses, resumes and stops it.
///
/// `stop_program` also ends a motion when no program is loaded.
pub mod program {
    #[allow(unused_imports)]
    use ::jaka_proto::{self as proto, check, wire};
    /// Sets the rate by which the controller scales the speed of motion.
    ///
    /// The document speaks of the rate at which programs run; whether a motion that is running follows the new rate at once
    /// is not stated.
    ///
    /// Sends `rapid_rate` (4.17).
    #[doc(alias = "rapid_rate")]
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetRapidRate {
        /// Rate. 0 to 1. The default is 1.
        ///
        /// `rate_value` on the wire.
        #[doc(alias = "rate_value")]
        pub rate: f64,
    }
    impl wire::Fields for SetRapidRate {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"rate_value\":");
            wire::Encode::encode(&self.rate, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut rate = None;
            let mut keys = reader.begin_fields(&["\"rate_value\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("rate", &mut rate)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                rate: rate
                    .ok_or_else(|| wire::DecodeError::missing("rate", "rate_value"))?,
            })
        }
    }
    proto::__object_impls!(SetRapidRate);
    impl SetRapidRate {
        /// With the required fields alone.
        ///
        /// - `rate`: 0 to 1
        #[must_use]
        pub const fn new(rate: f64) -> Self {
            Self { rate }
        }
    }
    impl check::Validate for SetRapidRate {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place
                .check(
                    "rate",
                    &self.rate,
                    &check::Limits {
                        min: Some(0f64),
                        max: Some(1f64),
                        ..check::Limits::NONE
                    },
                )?;
            Ok(())
        }
    }
    impl proto::Command for SetRapidRate {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "rapid_rate",
            "{\"cmdName\":\"rapid_rate\"",
            "4.17",
            proto::Effect::Setting,
        );
    }
    /// Reads the state of the program.
    ///
    /// Sends `get_program_state` (4.24). Changes nothing on the robot.
    ///
    /// Reconstructed, since the document's page is lost: The document's page is lost. Field notes: request and key certain; value `idle` certain, `running` and `paused` likely.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetProgramState {}
    impl wire::Fields for GetProgramState {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self {})
        }
    }
    proto::__object_impls!(GetProgramState);
    impl GetProgramState {
        /// Without any optional field.
        #[must_use]
        pub const fn new() -> Self {
            Self {}
        }
    }
    impl check::Validate for GetProgramState {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for GetProgramState {
        type Reply = GetProgramStateReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "get_program_state",
            "{\"cmdName\":\"get_program_state\"",
            "4.24",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`GetProgramState`].
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetProgramStateReply {
        /// State of the program.
        ///
        /// `programState` on the wire.
        #[doc(alias = "programState")]
        pub program_state: ProgramState,
    }
    impl wire::Fields for GetProgramStateReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"programState\":");
            wire::Encode::encode(&self.program_state, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut program_state = None;
            let mut keys = reader.begin_fields(&["\"programState\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("program_state", &mut program_state)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                program_state: program_state
                    .ok_or_else(|| wire::DecodeError::missing(
                        "program_state",
                        "programState",
                    ))?,
            })
        }
    }
    proto::__object_impls!(GetProgramStateReply);
    /// State of a program, as `get_program_state` answers. There may be others than these.
    #[derive(Debug, Clone, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum ProgramState {
        /// No program runs. `"idle"` on the wire.
        Idle,
        /// A program runs. Likely, not certain (field notes). `"running"` on the wire.
        Running,
        /// A program is paused. Likely, not certain (field notes). `"paused"` on the wire.
        Paused,
        /// A value that the spec does not list.
        Other(String),
    }
    impl From<&str> for ProgramState {
        fn from(value: &str) -> Self {
            match value {
                "idle" => Self::Idle,
                "running" => Self::Running,
                "paused" => Self::Paused,
                other => Self::Other(other.to_owned()),
            }
        }
    }
    impl AsRef<str> for ProgramState {
        fn as_ref(&self) -> &str {
            match self {
                Self::Idle => "idle",
                Self::Running => "running",
                Self::Paused => "paused",
                Self::Other(other) => other,
            }
        }
    }
    /// The value as on the wire.
    impl ::core::fmt::Display for ProgramState {
        fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
            f.pad(self.as_ref())
        }
    }
    proto::__text_enum_impls!(ProgramState);
    impl check::Validate for ProgramState {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            let standing = match self {
                Self::Idle | Self::Running | Self::Paused => check::Standing::Listed,
                Self::Other(_) => check::Standing::Unknown,
            };
            place.listed(&self.as_ref(), standing, "`idle`, `running` or `paused`")
        }
    }
    /// What replies hold, as structs that can be written as literals. They grow with the spec, so that the compiler leads
    /// to each place where a field is forgotten, and are no part of the interface.
    #[doc(hidden)]
    #[allow(missing_docs, missing_debug_implementations, clippy::too_many_lines)]
    pub mod literal {
        pub struct GetProgramStateReply {
            pub program_state: super::ProgramState,
        }
        impl From<GetProgramStateReply> for super::GetProgramStateReply {
            #[inline]
            fn from(
                GetProgramStateReply { program_state }: GetProgramStateReply,
            ) -> Self {
                Self { program_state }
            }
        }
    }
}
/// Inputs and outputs.
///
/// Digital and analog inputs and outputs of the cabinet, the tool and extension modules.
pub mod io {
    #[allow(unused_imports)]
    use ::jaka_proto::{self as proto, check, wire};
    /// Reads the configuration and state of the extension I/O modules.
    ///
    /// Sends `get_extio_status` (4.34). Changes nothing on the robot.
    ///
    /// # Errata
    ///
    /// - The document prints the reply of a controller without modules as a bare tuple, `(0, [], {'state': 0})`, without JSON around it. Both that and the same text inside the JSON string are read.
    /// - The sample configures eight digital inputs and reports the states of nine.
    /// - Here `state` 0 means that the modules do not run and 1 that they do. Chapter 2 describes `mode` of `extio` on port 10000, also called the modules' state, as 0 for on and 1 for off.
    /// - Chapter 2 describes the same settings with the pins as an array in the order di, do, ai, ao. Here they are a dictionary.
    /// - No RTU module is shown here. Its settings follow chapter 2, which lists the data bits twice: as data bit length before the slave number, and as data bits behind it.
    /// - Chapter 2 lists a slave number behind a TCP module's port. The sample here has none.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetExtioStatus {}
    impl wire::Fields for GetExtioStatus {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self {})
        }
    }
    proto::__object_impls!(GetExtioStatus);
    impl GetExtioStatus {
        /// Without any optional field.
        #[must_use]
        pub const fn new() -> Self {
            Self {}
        }
    }
    impl check::Validate for GetExtioStatus {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for GetExtioStatus {
        type Reply = GetExtioStatusReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
                "get_extio_status",
                "{\"cmdName\":\"get_extio_status\"",
                "4.34",
                proto::Effect::Query,
            )
            .bare_reply("extio_status");
    }
    /// What the controller answers to [`GetExtioStatus`].
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetExtioStatusReply {
        /// All modules. On the wire a Python literal inside a string.
        pub extio_status: ExtioStatus,
    }
    impl wire::Fields for GetExtioStatusReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"extio_status\":");
            out.python(|out| {
                wire::Encode::encode(&self.extio_status, out);
            });
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut extio_status = None;
            let mut keys = reader.begin_fields(&["\"extio_status\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field_python("extio_status", &mut extio_status)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                extio_status: extio_status
                    .ok_or_else(|| wire::DecodeError::missing(
                        "extio_status",
                        "extio_status",
                    ))?,
            })
        }
    }
    proto::__object_impls!(GetExtioStatusReply);
    /// The extension I/O modules and their state, as `get_extio_status` answers.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioStatus {
        /// Number of modules.
        pub count: i64,
        /// One entry for each module.
        pub modules: Vec<ExtioModule>,
        /// Whether the modules run, and the state of their pins.
        pub state: ExtioState,
    }
    impl wire::Encode for ExtioStatus {
        fn encode(&self, out: &mut wire::Writer) {
            out.raw("[");
            wire::Encode::encode(&self.count, out);
            out.raw(",");
            wire::Encode::encode(&self.modules, out);
            out.raw(",");
            wire::Encode::encode(&self.state, out);
            out.raw("]");
        }
    }
    impl wire::Decode for ExtioStatus {
        fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
            reader.begin_array()?;
            let this = Self {
                count: reader.element("count")?,
                modules: reader.element("modules")?,
                state: reader.element("state")?,
            };
            reader.end_array()?;
            Ok(this)
        }
        fn decode_into(
            &mut self,
            reader: &mut wire::Reader<'_>,
        ) -> Result<(), wire::DecodeError> {
            reader.begin_array()?;
            reader.element_into("count", &mut self.count)?;
            reader.element_into("modules", &mut self.modules)?;
            reader.element_into("state", &mut self.state)?;
            reader.end_array()
        }
    }
    proto::__serde_impls!(ExtioStatus);
    impl check::Validate for ExtioStatus {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("count", &self.count, &check::Limits::NONE)?;
            place.check("modules", &self.modules, &check::Limits::NONE)?;
            place.check("state", &self.state, &check::Limits::NONE)?;
            Ok(())
        }
    }
    /// One extension I/O module.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioModule {
        /// How the module is connected, and its pins.
        pub setup: ExtioSetup,
        /// Where the module's pins start; of interest with several modules.
        ///
        /// `pinmap` on the wire.
        #[doc(alias = "pinmap")]
        pub pin_map: ExtioPinMap,
    }
    impl wire::Fields for ExtioModule {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"setup\":");
            wire::Encode::encode(&self.setup, out);
            out.raw(",\"pinmap\":");
            wire::Encode::encode(&self.pin_map, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut setup = None;
            let mut pin_map = None;
            let mut keys = reader.begin_fields(&["\"setup\":", "\"pinmap\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("setup", &mut setup)?,
                    1 => reader.field("pin_map", &mut pin_map)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                setup: setup
                    .ok_or_else(|| wire::DecodeError::missing("setup", "setup"))?,
                pin_map: pin_map
                    .ok_or_else(|| wire::DecodeError::missing("pin_map", "pinmap"))?,
            })
        }
        fn read_fields_into(
            &mut self,
            reader: &mut wire::Reader<'_>,
        ) -> Result<(), wire::DecodeError> {
            let mut keys = reader.begin_fields(&["\"setup\":", "\"pinmap\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.required_into("setup", &mut self.setup, &mut keys)?,
                    1 => reader.required_into("pin_map", &mut self.pin_map, &mut keys)?,
                    _ => reader.skip()?,
                }
            }
            keys.required(0, "setup", "setup")?;
            keys.required(1, "pin_map", "pinmap")?;
            Ok(())
        }
    }
    proto::__object_impls!(ExtioModule, in_place);
    impl check::Validate for ExtioModule {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("setup", &self.setup, &check::Limits::NONE)?;
            place.check("pin_map", &self.pin_map, &check::Limits::NONE)?;
            Ok(())
        }
    }
    /// How an extension I/O module is connected, and its pins.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub enum ExtioSetup {
        /// Connected by Modbus RTU.
        #[non_exhaustive]
        Rtu {
            /// Name of the module.
            name: String,
            /// Serial settings of the connection. The document prints no sample of them.
            ///
            /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
            connection: wire::Typed<ExtioRtu>,
            /// The module's pins.
            pins: ExtioPins,
        },
        /// Connected by Modbus TCP.
        #[non_exhaustive]
        Tcp {
            /// Name of the module.
            name: String,
            /// Network address of the module.
            connection: ExtioTcp,
            /// The module's pins.
            pins: ExtioPins,
        },
        /// A kind that the spec does not list, as raw JSON.
        Other(wire::Value),
    }
    impl wire::Encode for ExtioSetup {
        fn encode(&self, out: &mut wire::Writer) {
            match self {
                Self::Rtu { name, connection, pins } => {
                    out.raw("[0");
                    out.raw(",");
                    wire::Encode::encode(name, out);
                    out.raw(",");
                    match connection {
                        wire::Typed::Known(value) => {
                            wire::Encode::encode(value, out);
                        }
                        wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                    }
                    out.raw(",");
                    wire::Encode::encode(pins, out);
                    out.raw("]");
                }
                Self::Tcp { name, connection, pins } => {
                    out.raw("[1");
                    out.raw(",");
                    wire::Encode::encode(name, out);
                    out.raw(",");
                    wire::Encode::encode(connection, out);
                    out.raw(",");
                    wire::Encode::encode(pins, out);
                    out.raw("]");
                }
                Self::Other(value) => wire::Encode::encode(value, out),
            }
        }
    }
    impl wire::Decode for ExtioSetup {
        fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
            let start = reader.mark();
            reader.begin_array()?;
            match reader.element::<i64>("kind")? {
                0 => {
                    let this = Self::Rtu {
                        name: reader.element("name")?,
                        connection: reader.element("connection")?,
                        pins: reader.element("pins")?,
                    };
                    reader.end_array()?;
                    Ok(this)
                }
                1 => {
                    let this = Self::Tcp {
                        name: reader.element("name")?,
                        connection: reader.element("connection")?,
                        pins: reader.element("pins")?,
                    };
                    reader.end_array()?;
                    Ok(this)
                }
                _ => {
                    reader.go_back(start);
                    wire::Decode::decode(reader).map(Self::Other)
                }
            }
        }
        fn decode_into(
            &mut self,
            reader: &mut wire::Reader<'_>,
        ) -> Result<(), wire::DecodeError> {
            let start = reader.mark();
            reader.begin_array()?;
            match (reader.element::<i64>("kind")?, &mut *self) {
                (0, Self::Rtu { name, connection, pins }) => {
                    reader.element_into("name", name)?;
                    reader.element_into("connection", connection)?;
                    reader.element_into("pins", pins)?;
                    reader.end_array()
                }
                (1, Self::Tcp { name, connection, pins }) => {
                    reader.element_into("name", name)?;
                    reader.element_into("connection", connection)?;
                    reader.element_into("pins", pins)?;
                    reader.end_array()
                }
                _ => {
                    reader.go_back(start);
                    *self = wire::Decode::decode(reader)?;
                    Ok(())
                }
            }
        }
    }
    proto::__serde_impls!(ExtioSetup);
    impl check::Validate for ExtioSetup {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            match self {
                Self::Rtu { name, connection, pins } => {
                    place.check("name", name, &check::Limits::NONE)?;
                    place.check("connection", connection, &check::Limits::NONE)?;
                    place.check("pins", pins, &check::Limits::NONE)?;
                }
                Self::Tcp { name, connection, pins } => {
                    place.check("name", name, &check::Limits::NONE)?;
                    place.check("connection", connection, &check::Limits::NONE)?;
                    place.check("pins", pins, &check::Limits::NONE)?;
                }
                Self::Other(_) => {}
            }
            Ok(())
        }
    }
    /// Serial settings of an extension I/O module.
    ///
    /// The elements and their order are those of chapter 2. The document prints no sample.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioRtu {
        /// Baud rate.
        pub baud_rate: i64,
        /// Length of the data bits.
        pub data_bit_length: i64,
        /// Number of the Modbus slave.
        pub slave_id: i64,
        /// Data bits. The document lists them a second time and does not say how they differ from `data_bit_length`.
        pub data_bits: i64,
        /// Parity. The document does not say how it is written, and whether as number or text.
        pub parity: wire::Value,
        /// Length of the stop bits.
        pub stop_bit_length: i64,
    }
    impl wire::Encode for ExtioRtu {
        fn encode(&self, out: &mut wire::Writer) {
            out.raw("[");
            wire::Encode::encode(&self.baud_rate, out);
            out.raw(",");
            wire::Encode::encode(&self.data_bit_length, out);
            out.raw(",");
            wire::Encode::encode(&self.slave_id, out);
            out.raw(",");
            wire::Encode::encode(&self.data_bits, out);
            out.raw(",");
            wire::Encode::encode(&self.parity, out);
            out.raw(",");
            wire::Encode::encode(&self.stop_bit_length, out);
            out.raw("]");
        }
    }
    impl wire::Decode for ExtioRtu {
        fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
            reader.begin_array()?;
            let this = Self {
                baud_rate: reader.element("baud_rate")?,
                data_bit_length: reader.element("data_bit_length")?,
                slave_id: reader.element("slave_id")?,
                data_bits: reader.element("data_bits")?,
                parity: reader.element("parity")?,
                stop_bit_length: reader.element("stop_bit_length")?,
            };
            reader.end_array()?;
            Ok(this)
        }
        fn decode_into(
            &mut self,
            reader: &mut wire::Reader<'_>,
        ) -> Result<(), wire::DecodeError> {
            reader.begin_array()?;
            reader.element_into("baud_rate", &mut self.baud_rate)?;
            reader.element_into("data_bit_length", &mut self.data_bit_length)?;
            reader.element_into("slave_id", &mut self.slave_id)?;
            reader.element_into("data_bits", &mut self.data_bits)?;
            reader.element_into("parity", &mut self.parity)?;
            reader.element_into("stop_bit_length", &mut self.stop_bit_length)?;
            reader.end_array()
        }
    }
    proto::__serde_impls!(ExtioRtu);
    impl check::Validate for ExtioRtu {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("baud_rate", &self.baud_rate, &check::Limits::NONE)?;
            place.check("data_bit_length", &self.data_bit_length, &check::Limits::NONE)?;
            place.check("slave_id", &self.slave_id, &check::Limits::NONE)?;
            place.check("data_bits", &self.data_bits, &check::Limits::NONE)?;
            place.check("parity", &self.parity, &check::Limits::NONE)?;
            place.check("stop_bit_length", &self.stop_bit_length, &check::Limits::NONE)?;
            Ok(())
        }
    }
    /// Network address of an extension I/O module.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioTcp {
        /// IP address.
        pub address: String,
        /// TCP port.
        pub port: i64,
        /// Number of the Modbus slave. Chapter 2 lists it; the sample of 4.34 has none.
        pub slave_id: Option<i64>,
    }
    impl wire::Encode for ExtioTcp {
        fn encode(&self, out: &mut wire::Writer) {
            out.raw("[");
            wire::Encode::encode(&self.address, out);
            out.raw(",");
            wire::Encode::encode(&self.port, out);
            if let Some(value) = &self.slave_id {
                out.raw(",");
                wire::Encode::encode(value, out);
            }
            out.raw("]");
        }
    }
    impl wire::Decode for ExtioTcp {
        fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
            reader.begin_array()?;
            let this = Self {
                address: reader.element("address")?,
                port: reader.element("port")?,
                slave_id: reader.optional_element("slave_id")?,
            };
            reader.end_array()?;
            Ok(this)
        }
        fn decode_into(
            &mut self,
            reader: &mut wire::Reader<'_>,
        ) -> Result<(), wire::DecodeError> {
            reader.begin_array()?;
            reader.element_into("address", &mut self.address)?;
            reader.element_into("port", &mut self.port)?;
            reader.optional_element_into("slave_id", &mut self.slave_id)?;
            reader.end_array()
        }
    }
    proto::__serde_impls!(ExtioTcp);
    impl check::Validate for ExtioTcp {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("address", &self.address, &check::Limits::NONE)?;
            place.check("port", &self.port, &check::Limits::NONE)?;
            place.check("slave_id", &self.slave_id, &check::Limits::NONE)?;
            Ok(())
        }
    }
    /// The pins of an extension I/O module, by kind.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioPins {
        /// Analog inputs.
        ///
        /// `ai` on the wire.
        #[doc(alias = "ai")]
        pub analog_inputs: ExtioPinRange,
        /// Digital outputs.
        ///
        /// `do` on the wire.
        #[doc(alias = "do")]
        pub digital_outputs: ExtioPinRange,
        /// Analog outputs.
        ///
        /// `ao` on the wire.
        #[doc(alias = "ao")]
        pub analog_outputs: ExtioPinRange,
        /// Digital inputs.
        ///
        /// `di` on the wire.
        #[doc(alias = "di")]
        pub digital_inputs: ExtioPinRange,
    }
    impl wire::Fields for ExtioPins {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"ai\":");
            wire::Encode::encode(&self.analog_inputs, out);
            out.raw(",\"do\":");
            wire::Encode::encode(&self.digital_outputs, out);
            out.raw(",\"ao\":");
            wire::Encode::encode(&self.analog_outputs, out);
            out.raw(",\"di\":");
            wire::Encode::encode(&self.digital_inputs, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut analog_inputs = None;
            let mut digital_outputs = None;
            let mut analog_outputs = None;
            let mut digital_inputs = None;
            let mut keys = reader
                .begin_fields(&["\"ai\":", "\"do\":", "\"ao\":", "\"di\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("analog_inputs", &mut analog_inputs)?,
                    1 => reader.field("digital_outputs", &mut digital_outputs)?,
                    2 => reader.field("analog_outputs", &mut analog_outputs)?,
                    3 => reader.field("digital_inputs", &mut digital_inputs)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                analog_inputs: analog_inputs
                    .ok_or_else(|| wire::DecodeError::missing("analog_inputs", "ai"))?,
                digital_outputs: digital_outputs
                    .ok_or_else(|| wire::DecodeError::missing("digital_outputs", "do"))?,
                analog_outputs: analog_outputs
                    .ok_or_else(|| wire::DecodeError::missing("analog_outputs", "ao"))?,
                digital_inputs: digital_inputs
                    .ok_or_else(|| wire::DecodeError::missing("digital_inputs", "di"))?,
            })
        }
    }
    proto::__object_impls!(ExtioPins);
    impl check::Validate for ExtioPins {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("analog_inputs", &self.analog_inputs, &check::Limits::NONE)?;
            place.check("digital_outputs", &self.digital_outputs, &check::Limits::NONE)?;
            place.check("analog_outputs", &self.analog_outputs, &check::Limits::NONE)?;
            place.check("digital_inputs", &self.digital_inputs, &check::Limits::NONE)?;
            Ok(())
        }
    }
    /// Where the registers of some pins start, and how many pins there are.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioPinRange {
        /// Address of the first register.
        pub start: i64,
        /// Number of pins.
        pub count: i64,
    }
    impl wire::Encode for ExtioPinRange {
        fn encode(&self, out: &mut wire::Writer) {
            out.raw("[");
            wire::Encode::encode(&self.start, out);
            out.raw(",");
            wire::Encode::encode(&self.count, out);
            out.raw("]");
        }
    }
    impl wire::Decode for ExtioPinRange {
        fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
            reader.begin_array()?;
            let this = Self {
                start: reader.element("start")?,
                count: reader.element("count")?,
            };
            reader.end_array()?;
            Ok(this)
        }
    }
    proto::__serde_impls!(ExtioPinRange);
    impl check::Validate for ExtioPinRange {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("start", &self.start, &check::Limits::NONE)?;
            place.check("count", &self.count, &check::Limits::NONE)?;
            Ok(())
        }
    }
    /// Index at which the pins of an extension I/O module start, by kind.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioPinMap {
        /// Index of the first analog input.
        ///
        /// `ai` on the wire.
        #[doc(alias = "ai")]
        pub analog_inputs: i64,
        /// Index of the first digital output.
        ///
        /// `do` on the wire.
        #[doc(alias = "do")]
        pub digital_outputs: i64,
        /// Index of the first analog output.
        ///
        /// `ao` on the wire.
        #[doc(alias = "ao")]
        pub analog_outputs: i64,
        /// Index of the first digital input.
        ///
        /// `di` on the wire.
        #[doc(alias = "di")]
        pub digital_inputs: i64,
    }
    impl wire::Fields for ExtioPinMap {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"ai\":");
            wire::Encode::encode(&self.analog_inputs, out);
            out.raw(",\"do\":");
            wire::Encode::encode(&self.digital_outputs, out);
            out.raw(",\"ao\":");
            wire::Encode::encode(&self.analog_outputs, out);
            out.raw(",\"di\":");
            wire::Encode::encode(&self.digital_inputs, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut analog_inputs = None;
            let mut digital_outputs = None;
            let mut analog_outputs = None;
            let mut digital_inputs = None;
            let mut keys = reader
                .begin_fields(&["\"ai\":", "\"do\":", "\"ao\":", "\"di\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("analog_inputs", &mut analog_inputs)?,
                    1 => reader.field("digital_outputs", &mut digital_outputs)?,
                    2 => reader.field("analog_outputs", &mut analog_outputs)?,
                    3 => reader.field("digital_inputs", &mut digital_inputs)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                analog_inputs: analog_inputs
                    .ok_or_else(|| wire::DecodeError::missing("analog_inputs", "ai"))?,
                digital_outputs: digital_outputs
                    .ok_or_else(|| wire::DecodeError::missing("digital_outputs", "do"))?,
                analog_outputs: analog_outputs
                    .ok_or_else(|| wire::DecodeError::missing("analog_outputs", "ao"))?,
                digital_inputs: digital_inputs
                    .ok_or_else(|| wire::DecodeError::missing("digital_inputs", "di"))?,
            })
        }
    }
    proto::__object_impls!(ExtioPinMap);
    impl check::Validate for ExtioPinMap {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("analog_inputs", &self.analog_inputs, &check::Limits::NONE)?;
            place.check("digital_outputs", &self.digital_outputs, &check::Limits::NONE)?;
            place.check("analog_outputs", &self.analog_outputs, &check::Limits::NONE)?;
            place.check("digital_inputs", &self.digital_inputs, &check::Limits::NONE)?;
            Ok(())
        }
    }
    /// Whether the extension I/O modules run, and the state of their pins.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioState {
        /// Whether the modules run.
        ///
        /// `state` on the wire.
        #[doc(alias = "state")]
        pub running: bool,
        /// State of the digital inputs, where there are modules.
        ///
        /// `di` on the wire.
        #[doc(alias = "di")]
        pub digital_inputs: Option<Vec<bool>>,
        /// State of the digital outputs, where the controller sends them.
        ///
        /// `do` on the wire.
        #[doc(alias = "do")]
        pub digital_outputs: Option<Vec<bool>>,
        /// Values of the analog inputs, where the controller sends them.
        ///
        /// `ai` on the wire.
        #[doc(alias = "ai")]
        pub analog_inputs: Option<Vec<f64>>,
        /// Values of the analog outputs, where the controller sends them.
        ///
        /// `ao` on the wire.
        #[doc(alias = "ao")]
        pub analog_outputs: Option<Vec<f64>>,
    }
    impl wire::Fields for ExtioState {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"state\":");
            out.choose(*&self.running, "0", "1");
            if let Some(value) = &self.digital_inputs {
                out.raw(",\"di\":");
                out.array(
                    value,
                    |out, item| {
                        out.choose(*item, "0", "1");
                    },
                );
            }
            if let Some(value) = &self.digital_outputs {
                out.raw(",\"do\":");
                out.array(
                    value,
                    |out, item| {
                        out.choose(*item, "0", "1");
                    },
                );
            }
            if let Some(value) = &self.analog_inputs {
                out.raw(",\"ai\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.analog_outputs {
                out.raw(",\"ao\":");
                wire::Encode::encode(value, out);
            }
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut running = None;
            let mut digital_inputs = None;
            let mut digital_outputs = None;
            let mut analog_inputs = None;
            let mut analog_outputs = None;
            let mut keys = reader
                .begin_fields(
                    &["\"state\":", "\"di\":", "\"do\":", "\"ai\":", "\"ao\":"],
                )?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("running", &mut running)?,
                    1 => reader.field("digital_inputs", &mut digital_inputs)?,
                    2 => reader.field("digital_outputs", &mut digital_outputs)?,
                    3 => reader.field("analog_inputs", &mut analog_inputs)?,
                    4 => reader.field("analog_outputs", &mut analog_outputs)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                running: running
                    .ok_or_else(|| wire::DecodeError::missing("running", "state"))?,
                digital_inputs,
                digital_outputs,
                analog_inputs,
                analog_outputs,
            })
        }
        fn read_fields_into(
            &mut self,
            reader: &mut wire::Reader<'_>,
        ) -> Result<(), wire::DecodeError> {
            let mut keys = reader
                .begin_fields(
                    &["\"state\":", "\"di\":", "\"do\":", "\"ai\":", "\"ao\":"],
                )?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.required_into("running", &mut self.running, &mut keys)?,
                    1 => {
                        reader
                            .field_into(
                                "digital_inputs",
                                &mut self.digital_inputs,
                                &mut keys,
                            )?
                    }
                    2 => {
                        reader
                            .field_into(
                                "digital_outputs",
                                &mut self.digital_outputs,
                                &mut keys,
                            )?
                    }
                    3 => {
                        reader
                            .field_into(
                                "analog_inputs",
                                &mut self.analog_inputs,
                                &mut keys,
                            )?
                    }
                    4 => {
                        reader
                            .field_into(
                                "analog_outputs",
                                &mut self.analog_outputs,
                                &mut keys,
                            )?
                    }
                    _ => reader.skip()?,
                }
            }
            keys.required(0, "running", "state")?;
            keys.absent(1, &mut self.digital_inputs);
            keys.absent(2, &mut self.digital_outputs);
            keys.absent(3, &mut self.analog_inputs);
            keys.absent(4, &mut self.analog_outputs);
            Ok(())
        }
    }
    proto::__object_impls!(ExtioState, in_place);
    impl check::Validate for ExtioState {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("running", &self.running, &check::Limits::NONE)?;
            place.check("digital_inputs", &self.digital_inputs, &check::Limits::NONE)?;
            place.check("digital_outputs", &self.digital_outputs, &check::Limits::NONE)?;
            place.check("analog_inputs", &self.analog_inputs, &check::Limits::NONE)?;
            place.check("analog_outputs", &self.analog_outputs, &check::Limits::NONE)?;
            Ok(())
        }
    }
    /// What replies hold, as structs that can be written as literals. They grow with the spec, so that the compiler leads
    /// to each place where a field is forgotten, and are no part of the interface.
    #[doc(hidden)]
    #[allow(missing_docs, missing_debug_implementations, clippy::too_many_lines)]
    pub mod literal {
        pub struct GetExtioStatusReply {
            pub extio_status: super::ExtioStatus,
        }
        impl From<GetExtioStatusReply> for super::GetExtioStatusReply {
            #[inline]
            fn from(GetExtioStatusReply { extio_status }: GetExtioStatusReply) -> Self {
                Self { extio_status }
            }
        }
        pub struct ExtioStatus {
            pub count: i64,
            pub modules: Vec<super::ExtioModule>,
            pub state: super::ExtioState,
        }
        impl From<ExtioStatus> for super::ExtioStatus {
            #[inline]
            fn from(ExtioStatus { count, modules, state }: ExtioStatus) -> Self {
                Self { count, modules, state }
            }
        }
        pub struct ExtioModule {
            pub setup: super::ExtioSetup,
            pub pin_map: super::ExtioPinMap,
        }
        impl From<ExtioModule> for super::ExtioModule {
            #[inline]
            fn from(ExtioModule { setup, pin_map }: ExtioModule) -> Self {
                Self { setup, pin_map }
            }
        }
        pub enum ExtioSetup {
            Rtu {
                name: String,
                connection: super::wire::Typed<super::ExtioRtu>,
                pins: super::ExtioPins,
            },
            Tcp { name: String, connection: super::ExtioTcp, pins: super::ExtioPins },
        }
        impl From<ExtioSetup> for super::ExtioSetup {
            #[inline]
            fn from(value: ExtioSetup) -> Self {
                match value {
                    ExtioSetup::Rtu { name, connection, pins } => {
                        Self::Rtu {
                            name,
                            connection,
                            pins,
                        }
                    }
                    ExtioSetup::Tcp { name, connection, pins } => {
                        Self::Tcp {
                            name,
                            connection,
                            pins,
                        }
                    }
                }
            }
        }
        pub struct ExtioRtu {
            pub baud_rate: i64,
            pub data_bit_length: i64,
            pub slave_id: i64,
            pub data_bits: i64,
            pub parity: super::wire::Value,
            pub stop_bit_length: i64,
        }
        impl From<ExtioRtu> for super::ExtioRtu {
            #[inline]
            fn from(
                ExtioRtu {
                    baud_rate,
                    data_bit_length,
                    slave_id,
                    data_bits,
                    parity,
                    stop_bit_length,
                }: ExtioRtu,
            ) -> Self {
                Self {
                    baud_rate,
                    data_bit_length,
                    slave_id,
                    data_bits,
                    parity,
                    stop_bit_length,
                }
            }
        }
        pub struct ExtioTcp {
            pub address: String,
            pub port: i64,
            pub slave_id: Option<i64>,
        }
        impl From<ExtioTcp> for super::ExtioTcp {
            #[inline]
            fn from(ExtioTcp { address, port, slave_id }: ExtioTcp) -> Self {
                Self { address, port, slave_id }
            }
        }
        pub struct ExtioPins {
            pub analog_inputs: super::ExtioPinRange,
            pub digital_outputs: super::ExtioPinRange,
            pub analog_outputs: super::ExtioPinRange,
            pub digital_inputs: super::ExtioPinRange,
        }
        impl From<ExtioPins> for super::ExtioPins {
            #[inline]
            fn from(
                ExtioPins {
                    analog_inputs,
                    digital_outputs,
                    analog_outputs,
                    digital_inputs,
                }: ExtioPins,
            ) -> Self {
                Self {
                    analog_inputs,
                    digital_outputs,
                    analog_outputs,
                    digital_inputs,
                }
            }
        }
        pub struct ExtioPinRange {
            pub start: i64,
            pub count: i64,
        }
        impl From<ExtioPinRange> for super::ExtioPinRange {
            #[inline]
            fn from(ExtioPinRange { start, count }: ExtioPinRange) -> Self {
                Self { start, count }
            }
        }
        pub struct ExtioPinMap {
            pub analog_inputs: i64,
            pub digital_outputs: i64,
            pub analog_outputs: i64,
            pub digital_inputs: i64,
        }
        impl From<ExtioPinMap> for super::ExtioPinMap {
            #[inline]
            fn from(
                ExtioPinMap {
                    analog_inputs,
                    digital_outputs,
                    analog_outputs,
                    digital_inputs,
                }: ExtioPinMap,
            ) -> Self {
                Self {
                    analog_inputs,
                    digital_outputs,
                    analog_outputs,
                    digital_inputs,
                }
            }
        }
        pub struct ExtioState {
            pub running: bool,
            pub digital_inputs: Option<Vec<bool>>,
            pub digital_outputs: Option<Vec<bool>>,
            pub analog_inputs: Option<Vec<f64>>,
            pub analog_outputs: Option<Vec<f64>>,
        }
        impl From<ExtioState> for super::ExtioState {
            #[inline]
            fn from(
                ExtioState {
                    running,
                    digital_inputs,
                    digital_outputs,
                    analog_inputs,
                    analog_outputs,
                }: ExtioState,
            ) -> Self {
                Self {
                    running,
                    digital_inputs,
                    digital_outputs,
                    analog_inputs,
                    analog_outputs,
                }
            }
        }
    }
}
/// Force control and drag mode.
///
/// Leading the arm by hand, the torque sensor at its end, and control that yields to forces.
///
/// While such control is on, the arm may move with the forces that act on it. The document gives no units for forces and
/// torques here.
pub mod force {
    #[allow(unused_imports)]
    use ::jaka_proto::{self as proto, check, wire};
    /// Sets the parameters of compliance in velocity.
    ///
    /// Sends `set_vel_compliant_ctrl` (4.79).
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetVelCompliantCtrl {
        /// Level and ratios.
        ///
        /// `compliant_ctrl` on the wire.
        #[doc(alias = "compliant_ctrl")]
        pub compliance: VelocityCompliance,
    }
    impl wire::Fields for SetVelCompliantCtrl {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"compliant_ctrl\":");
            wire::Encode::encode(&self.compliance, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut compliance = None;
            let mut keys = reader.begin_fields(&["\"compliant_ctrl\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("compliance", &mut compliance)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                compliance: compliance
                    .ok_or_else(|| wire::DecodeError::missing(
                        "compliance",
                        "compliant_ctrl",
                    ))?,
            })
        }
    }
    proto::__object_impls!(SetVelCompliantCtrl);
    impl SetVelCompliantCtrl {
        /// With the required fields alone.
        #[must_use]
        pub const fn new(compliance: VelocityCompliance) -> Self {
            Self { compliance }
        }
    }
    impl check::Validate for SetVelCompliantCtrl {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("compliance", &self.compliance, &check::Limits::NONE)?;
            Ok(())
        }
    }
    impl proto::Command for SetVelCompliantCtrl {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "set_vel_compliant_ctrl",
            "{\"cmdName\":\"set_vel_compliant_ctrl\"",
            "4.79",
            proto::Effect::Setting,
        );
    }
    /// Parameters of compliance in velocity.
    ///
    /// The level says how often the arm slows down, and each ratio by how much: level 1 uses two ratios, level 2 three, level 3 four, and the
    /// rest are 0. Those in use become smaller: 1 > rate1 > rate2 > rate3 > rate4 > 0 (vendor's manual). The document gives neither ranges nor
    /// rules.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct VelocityCompliance {
        /// Level of the compliance, `vc_level` in the document. 1 to 3.
        pub level: i64,
        /// First ratio. 0 to 1.
        pub rate1: f64,
        /// Second ratio. 0 to 1.
        pub rate2: f64,
        /// Third ratio, or 0 with level 1. 0 to 1.
        pub rate3: f64,
        /// Fourth ratio, or 0 with levels 1 and 2. 0 to 1.
        pub rate4: f64,
    }
    impl wire::Encode for VelocityCompliance {
        fn encode(&self, out: &mut wire::Writer) {
            out.raw("[");
            wire::Encode::encode(&self.level, out);
            out.raw(",");
            wire::Encode::encode(&self.rate1, out);
            out.raw(",");
            wire::Encode::encode(&self.rate2, out);
            out.raw(",");
            wire::Encode::encode(&self.rate3, out);
            out.raw(",");
            wire::Encode::encode(&self.rate4, out);
            out.raw("]");
        }
    }
    impl wire::Decode for VelocityCompliance {
        fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
            reader.begin_array()?;
            let this = Self {
                level: reader.element("level")?,
                rate1: reader.element("rate1")?,
                rate2: reader.element("rate2")?,
                rate3: reader.element("rate3")?,
                rate4: reader.element("rate4")?,
            };
            reader.end_array()?;
            Ok(this)
        }
    }
    proto::__serde_impls!(VelocityCompliance);
    impl VelocityCompliance {
        /// With the required fields alone.
        ///
        /// - `level`: 1 to 3
        /// - `rate1`: 0 to 1
        /// - `rate2`: 0 to 1
        /// - `rate3`: 0 to 1
        /// - `rate4`: 0 to 1
        #[must_use]
        pub const fn new(
            level: i64,
            rate1: f64,
            rate2: f64,
            rate3: f64,
            rate4: f64,
        ) -> Self {
            Self {
                level,
                rate1,
                rate2,
                rate3,
                rate4,
            }
        }
    }
    impl check::Validate for VelocityCompliance {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place
                .check(
                    "level",
                    &self.level,
                    &check::Limits {
                        min: Some(1f64),
                        max: Some(3f64),
                        ..check::Limits::NONE
                    },
                )?;
            place
                .check(
                    "rate1",
                    &self.rate1,
                    &check::Limits {
                        min: Some(0f64),
                        max: Some(1f64),
                        ..check::Limits::NONE
                    },
                )?;
            place
                .check(
                    "rate2",
                    &self.rate2,
                    &check::Limits {
                        min: Some(0f64),
                        max: Some(1f64),
                        ..check::Limits::NONE
                    },
                )?;
            place
                .check(
                    "rate3",
                    &self.rate3,
                    &check::Limits {
                        min: Some(0f64),
                        max: Some(1f64),
                        ..check::Limits::NONE
                    },
                )?;
            place
                .check(
                    "rate4",
                    &self.rate4,
                    &check::Limits {
                        min: Some(0f64),
                        max: Some(1f64),
                        ..check::Limits::NONE
                    },
                )?;
            Ok(())
        }
    }
    /// What replies hold, as structs that can be written as literals. They grow with the spec, so that the compiler leads
    /// to each place where a field is forgotten, and are no part of the interface.
    #[doc(hidden)]
    #[allow(missing_docs, missing_debug_implementations, clippy::too_many_lines)]
    pub mod literal {
        pub struct VelocityCompliance {
            pub level: i64,
            pub rate1: f64,
            pub rate2: f64,
            pub rate3: f64,
            pub rate4: f64,
        }
        impl From<VelocityCompliance> for super::VelocityCompliance {
            #[inline]
            fn from(
                VelocityCompliance {
                    level,
                    rate1,
                    rate2,
                    rate3,
                    rate4,
                }: VelocityCompliance,
            ) -> Self {
                Self {
                    level,
                    rate1,
                    rate2,
                    rate3,
                    rate4,
                }
            }
        }
    }
}
/// Types that several topics share.
///
/// Angles are degrees and lengths millimetres, as on the wire.
pub mod types {
    #[allow(unused_imports)]
    use ::jaka_proto::{self as proto, check, wire};
    /// Positions, or offsets, of joints 1 to 6. In deg.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct JointPosition(pub [f64; 6]);
    impl From<[f64; 6]> for JointPosition {
        fn from(value: [f64; 6]) -> Self {
            Self(value)
        }
    }
    impl From<JointPosition> for [f64; 6] {
        fn from(value: JointPosition) -> Self {
            value.0
        }
    }
    impl wire::Encode for JointPosition {
        fn encode(&self, out: &mut wire::Writer) {
            wire::Encode::encode(&self.0, out);
        }
    }
    impl wire::Decode for JointPosition {
        fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
            wire::Decode::decode(reader).map(Self)
        }
    }
    proto::__serde_impls!(JointPosition);
    impl check::Validate for JointPosition {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            let limits = check::Limits {
                unit: "deg",
                ..*limits
            };
            check::Validate::validate(&self.0, place, &limits)
        }
    }
    /// Whether a motion's coordinates are a target or an offset.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum MoveMode {
        /// The coordinates are the target. `0` on the wire.
        Absolute,
        /// The coordinates are an offset.
        ///
        /// The document does not say from which position it counts, and no source says, for a pose of `move_c` or `servo_p`, along the axes of
        /// which frame. Try a small one first. `1` on the wire.
        Relative,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for MoveMode {
        fn from(value: i64) -> Self {
            match value {
                0 => Self::Absolute,
                1 => Self::Relative,
                other => Self::Other(other),
            }
        }
    }
    impl From<MoveMode> for i64 {
        fn from(value: MoveMode) -> Self {
            match value {
                MoveMode::Absolute => 0,
                MoveMode::Relative => 1,
                MoveMode::Other(other) => other,
            }
        }
    }
    /// The value in words; one that the spec does not list as its number.
    impl ::core::fmt::Display for MoveMode {
        fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
            match self {
                Self::Absolute => f.pad("absolute"),
                Self::Relative => f.pad("relative"),
                Self::Other(other) => ::core::fmt::Display::fmt(other, f),
            }
        }
    }
    proto::__int_enum_impls!(MoveMode);
    impl check::Validate for MoveMode {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            let standing = match self {
                Self::Absolute | Self::Relative => check::Standing::Listed,
                Self::Other(_) => check::Standing::Unknown,
            };
            place.listed(&i64::from(*self), standing, "0 (Absolute) or 1 (Relative)")
        }
    }
}
/// Any request of the spec, told apart by its `cmdName`.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Request {
    /// `power_off`
    PowerOff(power::PowerOff),
    /// `get_robot_state`
    GetRobotState(power::GetRobotState),
    /// `joint_move`
    JointMove(motion::JointMove),
    /// `set_servo_move_filter`
    SetServoMoveFilter(servo::SetServoMoveFilter),
    /// `rapid_rate`
    SetRapidRate(program::SetRapidRate),
    /// `get_program_state`
    GetProgramState(program::GetProgramState),
    /// `get_extio_status`
    GetExtioStatus(io::GetExtioStatus),
    /// `set_vel_compliant_ctrl`
    SetVelCompliantCtrl(force::SetVelCompliantCtrl),
}
impl Request {
    /// What the spec says about each command, topic by topic.
    pub const COMMANDS: &'static [&'static ::jaka_proto::CommandInfo] = &[
        <power::PowerOff as ::jaka_proto::Command>::INFO,
        <power::GetRobotState as ::jaka_proto::Command>::INFO,
        <motion::JointMove as ::jaka_proto::Command>::INFO,
        <servo::SetServoMoveFilter as ::jaka_proto::Command>::INFO,
        <program::SetRapidRate as ::jaka_proto::Command>::INFO,
        <program::GetProgramState as ::jaka_proto::Command>::INFO,
        <io::GetExtioStatus as ::jaka_proto::Command>::INFO,
        <force::SetVelCompliantCtrl as ::jaka_proto::Command>::INFO,
    ];
    /// Does something with the request, whatever its type.
    pub fn visit<V: ::jaka_proto::Visit>(&self, visitor: V) -> V::Output {
        match self {
            Self::PowerOff(request) => visitor.visit(request),
            Self::GetRobotState(request) => visitor.visit(request),
            Self::JointMove(request) => visitor.visit(request),
            Self::SetServoMoveFilter(request) => visitor.visit(request),
            Self::SetRapidRate(request) => visitor.visit(request),
            Self::GetProgramState(request) => visitor.visit(request),
            Self::GetExtioStatus(request) => visitor.visit(request),
            Self::SetVelCompliantCtrl(request) => visitor.visit(request),
        }
    }
    /// Reads the request `name` from its JSON; `None` if the spec has no such command.
    pub(crate) fn read_named(
        name: &str,
        reader: &mut ::jaka_proto::wire::Reader<'_>,
    ) -> Option<Result<Self, ::jaka_proto::wire::DecodeError>> {
        Some(
            match name {
                "power_off" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::PowerOff)
                }
                "get_robot_state" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::GetRobotState)
                }
                "joint_move" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::JointMove)
                }
                "set_servo_move_filter" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::SetServoMoveFilter)
                }
                "rapid_rate" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::SetRapidRate)
                }
                "get_program_state" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::GetProgramState)
                }
                "get_extio_status" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::GetExtioStatus)
                }
                "set_vel_compliant_ctrl" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::SetVelCompliantCtrl)
                }
                _ => return None,
            },
        )
    }
}
impl From<power::PowerOff> for Request {
    fn from(request: power::PowerOff) -> Self {
        Self::PowerOff(request)
    }
}
impl From<power::GetRobotState> for Request {
    fn from(request: power::GetRobotState) -> Self {
        Self::GetRobotState(request)
    }
}
impl From<motion::JointMove> for Request {
    fn from(request: motion::JointMove) -> Self {
        Self::JointMove(request)
    }
}
impl From<servo::SetServoMoveFilter> for Request {
    fn from(request: servo::SetServoMoveFilter) -> Self {
        Self::SetServoMoveFilter(request)
    }
}
impl From<program::SetRapidRate> for Request {
    fn from(request: program::SetRapidRate) -> Self {
        Self::SetRapidRate(request)
    }
}
impl From<program::GetProgramState> for Request {
    fn from(request: program::GetProgramState) -> Self {
        Self::GetProgramState(request)
    }
}
impl From<io::GetExtioStatus> for Request {
    fn from(request: io::GetExtioStatus) -> Self {
        Self::GetExtioStatus(request)
    }
}
impl From<force::SetVelCompliantCtrl> for Request {
    fn from(request: force::SetVelCompliantCtrl) -> Self {
        Self::SetVelCompliantCtrl(request)
    }
}
impl ::jaka_proto::ErrorCode {
    /// The controller rejects the command.
    ///
    /// Not in the document. Seen when `servo_j` was sent outside servo mode; what else it covers is not known.
    pub const REJECTED: Self = Self(-1i64);
    /// The command was accepted.
    ///
    /// The document says executed, but it may not have ended yet: a motion is only accepted, and `power_on` and `enable_robot`
    /// need seconds.
    ///
    /// The message is empty by chapter 5, while chapter 3 prints `unknown`. It may be absent too (field notes).
    pub const SUCCESS: Self = Self(0i64);
    /// What sources say about the code, in a sentence; `None` for a code they do not name.
    pub fn meaning(self) -> Option<&'static str> {
        match self.0 {
            -1i64 => Some("The controller rejects the command."),
            0i64 => Some("The command was accepted."),
            _ => None,
        }
    }
}
impl ::jaka_proto::ControllerEvent {
    /// Ranges of codes, first and last, in their order.
    pub(crate) const SEVERITIES: &'static [(u32, u32, ::jaka_proto::Severity)] = &[
        (0x10F0000, 0x10F0002, ::jaka_proto::Severity::Information),
    ];
    /// Ranges of codes, first and last, in their order.
    pub(crate) const MEANINGS: &'static [(u32, u32, &'static str)] = &[
        (0x10F0000, 0x10F0000, "the emergency stop was triggered"),
        (0x10F0001, 0x10F0001, "the emergency stop was reset"),
        (0x10F0002, 0x10F0002, "the arm was powered on"),
    ];
}
impl Client {
    /// Switches the arm's power off.
    ///
    /// It wants a disabled arm (event `0x0F0026`).
    ///
    /// Sends `power_off` (4.2).
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn power_off(&mut self) -> Result<(), Error> {
        self.call(&::jaka_proto::messages::power::PowerOff::new())
    }
    /// Reads whether the arm has power and is enabled.
    ///
    /// Old firmware answers with the document's words, newer firmware with true and false or with numbers, and adds the
    /// controller's error.
    ///
    /// Sends `get_robot_state` (4.12). Changes nothing on the robot.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn get_robot_state(
        &mut self,
    ) -> Result<::jaka_proto::messages::power::GetRobotStateReply, Error> {
        self.call(&::jaka_proto::messages::power::GetRobotState::new())
    }
    /// Moves all joints to a position, or by an offset, at a joint speed (MoveJ).
    ///
    /// The motion starts when the one before it has ended. To move at once, stop that one first with `stop_program`.
    ///
    /// The reply says that the motion was accepted, not that it has ended.
    ///
    /// Sends `joint_move` (4.7). The robot must be powered, enabled and outside servo mode.
    ///
    /// # Errors
    /// As [`call`](Self::call). In another state than the one it needs, expect a refusal.
    pub fn joint_move(
        &mut self,
        request: &::jaka_proto::messages::motion::JointMove,
    ) -> Result<(), Error> {
        self.call(request)
    }
    /// Sets the filter that smooths the set-points of servo mode.
    ///
    /// It can be set only outside servo mode. Filters 1, 2, 3 and 5 act on `servo_j` and `servo_p`, filter 4 on `servo_p` alone (vendor's
    /// manual).
    ///
    /// Sends `set_servo_move_filter` (4.60). The robot must be outside servo mode.
    ///
    /// # Errata
    ///
    /// - The text calls `filter_type` the motion mode, as copied from 4.6.
    /// - The text writes the keys `max_vr`, `max_ar`, `max_jr`, `max_vp`, `max_ap` and `max_jp`. The samples have `nlf_` before each of them.
    /// - The limits on rotation are printed in %/s, %/s^2 and %/s^3, without anything they could be a percentage of. Those of filter 2 are degrees (vendor's manual), and the field notes find degrees throughout.
    /// - The limits of filter 2 are explained as limits on how fast the orientation changes, as those of filter 4, which works in Cartesian space. They are limits of the joints (vendor's manual).
    /// - Filter 5 is listed as speed look-ahead and explained as filter 3, the multi-stage mean filter of the joints.
    /// - `mmf_kp` is explained as coefficient of the position for filter 3, and of the acceleration for filter 5. It is that of the position for both (vendor's manual).
    /// - For filter 5 the text writes the key `max_buf`, the sample `mmf_max_buf`.
    /// - `mmf_ka` is explained as coefficient of acceleration and position. The key speaks of the acceleration alone.
    ///
    /// # Errors
    /// As [`call`](Self::call). In another state than the one it needs, expect a refusal.
    pub fn set_servo_move_filter(
        &mut self,
        request: &::jaka_proto::messages::servo::SetServoMoveFilter,
    ) -> Result<(), Error> {
        self.call(request)
    }
    /// Sets the rate by which the controller scales the speed of motion.
    ///
    /// The document speaks of the rate at which programs run; whether a motion that is running follows the new rate at once
    /// is not stated.
    ///
    /// Sends `rapid_rate` (4.17).
    ///
    /// # Errors
    /// As [`call`](Self::call).
    #[doc(alias = "rapid_rate")]
    pub fn set_rapid_rate(&mut self, rate: f64) -> Result<(), Error> {
        self.call(&::jaka_proto::messages::program::SetRapidRate::new(rate))
    }
    /// Reads the state of the program.
    ///
    /// Sends `get_program_state` (4.24). Changes nothing on the robot.
    ///
    /// Reconstructed, since the document's page is lost: The document's page is lost. Field notes: request and key certain; value `idle` certain, `running` and `paused` likely.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn get_program_state(
        &mut self,
    ) -> Result<::jaka_proto::messages::program::GetProgramStateReply, Error> {
        self.call(&::jaka_proto::messages::program::GetProgramState::new())
    }
    /// Reads the configuration and state of the extension I/O modules.
    ///
    /// Sends `get_extio_status` (4.34). Changes nothing on the robot.
    ///
    /// # Errata
    ///
    /// - The document prints the reply of a controller without modules as a bare tuple, `(0, [], {'state': 0})`, without JSON around it. Both that and the same text inside the JSON string are read.
    /// - The sample configures eight digital inputs and reports the states of nine.
    /// - Here `state` 0 means that the modules do not run and 1 that they do. Chapter 2 describes `mode` of `extio` on port 10000, also called the modules' state, as 0 for on and 1 for off.
    /// - Chapter 2 describes the same settings with the pins as an array in the order di, do, ai, ao. Here they are a dictionary.
    /// - No RTU module is shown here. Its settings follow chapter 2, which lists the data bits twice: as data bit length before the slave number, and as data bits behind it.
    /// - Chapter 2 lists a slave number behind a TCP module's port. The sample here has none.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn get_extio_status(
        &mut self,
    ) -> Result<::jaka_proto::messages::io::GetExtioStatusReply, Error> {
        self.call(&::jaka_proto::messages::io::GetExtioStatus::new())
    }
    /// Sets the parameters of compliance in velocity.
    ///
    /// Sends `set_vel_compliant_ctrl` (4.79).
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn set_vel_compliant_ctrl(
        &mut self,
        compliance: ::jaka_proto::messages::force::VelocityCompliance,
    ) -> Result<(), Error> {
        self.call(&::jaka_proto::messages::force::SetVelCompliantCtrl::new(compliance))
    }
}
