pub mod shapes {
    //! Shapes.
    //!
    //! A command of each shape, and what such commands are made of. [`stop`](type@Stop) is the simplest.
    #[allow(unused_imports)]
    use ::jaka_proto::{self as proto, check, wire};
    /// Stops the motion.
    ///
    /// Sends `stop`.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct Stop {}
    impl wire::Fields for Stop {
        #[inline]
        fn write_fields(&self, out: &mut wire::Writer) {
            let _ = out;
        }
        #[inline]
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut keys = reader.begin_fields(&[])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    _ => reader.skip()?,
                }
            }
            Ok(Self {})
        }
    }
    proto::__object_impls!(Stop);
    impl Stop {
        /// Without any optional field.
        #[must_use]
        pub const fn new() -> Self {
            Self {}
        }
    }
    impl check::Validate for Stop {
        #[allow(unused_variables)]
        #[inline]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::FieldLimits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for Stop {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::__command_info!(
            "stop", "{\"cmdName\":\"stop\"", "", Motion, role : Some(proto::Role::Start),
        );
    }
    /// Moves all joints to a position. [`stop`](type@Stop) ends the motion.
    ///
    /// Sends `moveTo` (4.7). The robot must be enabled and outside servo mode.
    ///
    /// Known to firmware 1.5 and later.
    ///
    /// # Errata
    ///
    /// - The sample has `toll`.
    #[doc(alias = "moveTo")]
    #[doc(alias = "joint_move")]
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct MoveTo {
        /// How the position counts. `relFlag` on the wire.
        #[doc(alias = "relFlag")]
        pub mode: Mode,
        /// Where to. In deg.
        ///
        /// Advised: -360 to 360, where `mode` is 0 (Absolute); -2.5 to 2.5, not 0, times `count`, where `mode` is 1 (Relative). Anything else is refused unless that is left to the controller: see [`AdvisoryRanges`](check::AdvisoryRanges).
        pub position: Joints,
        /// A point on the way.
        ///
        /// Advised: -2000 to 2000 mm. Anything else is refused unless that is left to the controller: see [`AdvisoryRanges`](check::AdvisoryRanges).
        pub via: Option<Point>,
        /// How many cycles it takes.
        pub count: Option<i64>,
        /// Joint speed. In deg/s, 0 to 180.
        ///
        /// Newer firmware takes more than this range, which can be switched off: see [`AdvisoryRanges`](check::AdvisoryRanges).
        pub speed: f64,
        /// How near. Not more. `tol` on the wire.
        ///
        /// Known to firmware up to 1.6.
        #[doc(alias = "tol")]
        pub tolerance: Option<f64>,
    }
    impl wire::Fields for MoveTo {
        #[inline]
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"relFlag\":");
            wire::Encode::encode(&self.mode, out);
            out.raw(",\"position\":");
            wire::Encode::encode(&self.position, out);
            if let Some(value) = &self.via {
                out.raw(",\"via\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.count {
                out.raw(",\"count\":");
                wire::Encode::encode(value, out);
            }
            out.raw(",\"speed\":");
            wire::Encode::encode(&self.speed, out);
            if let Some(value) = &self.tolerance {
                out.raw(",\"tol\":");
                wire::Encode::encode(value, out);
            }
        }
        #[inline]
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut mode = None;
            let mut position = None;
            let mut via = None;
            let mut count = None;
            let mut speed = None;
            let mut tolerance = None;
            let mut keys = reader
                .begin_fields(
                    &[
                        "\"relFlag\":",
                        "\"position\":",
                        "\"via\":",
                        "\"count\":",
                        "\"speed\":",
                        "\"tol\":",
                    ],
                )?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("mode", &mut mode)?,
                    1 => reader.field("position", &mut position)?,
                    2 => reader.field("via", &mut via)?,
                    3 => reader.field("count", &mut count)?,
                    4 => reader.field("speed", &mut speed)?,
                    5 => reader.field("tolerance", &mut tolerance)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                mode: mode.ok_or_else(|| wire::DecodeError::missing("mode", "relFlag"))?,
                position: position
                    .ok_or_else(|| wire::DecodeError::missing("position", "position"))?,
                via,
                count,
                speed: speed
                    .ok_or_else(|| wire::DecodeError::missing("speed", "speed"))?,
                tolerance,
            })
        }
    }
    proto::__object_impls!(MoveTo);
    impl MoveTo {
        /// With the required fields alone.
        ///
        /// - `position`: in deg
        /// - `speed`: in deg/s, 0 to 180
        #[must_use]
        pub fn new(mode: Mode, position: impl Into<Joints>, speed: f64) -> Self {
            Self {
                mode,
                position: position.into(),
                via: None,
                count: None,
                speed,
                tolerance: None,
            }
        }
        /// As it is.
        ///
        /// - `position`: in deg
        /// - `speed`: in deg/s, 0 to 180
        #[must_use]
        pub fn absolute(position: impl Into<Joints>, speed: f64) -> Self {
            Self::new(Mode::Absolute, position, speed)
        }
        /// From where the arm is.
        ///
        /// - `position`: in deg
        /// - `speed`: in deg/s, 0 to 180
        #[must_use]
        pub fn relative(position: impl Into<Joints>, speed: f64) -> Self {
            Self::new(Mode::Relative, position, speed)
        }
        /// A point on the way.
        #[must_use]
        pub fn via(mut self, via: impl Into<Point>) -> Self {
            self.via = Some(via.into());
            self
        }
        /// How many cycles it takes.
        #[must_use]
        pub fn count(mut self, count: i64) -> Self {
            self.count = Some(count);
            self
        }
        /// How near. `tol` on the wire.
        #[doc(alias = "tol")]
        #[must_use]
        pub fn tolerance(mut self, tolerance: f64) -> Self {
            self.tolerance = Some(tolerance);
            self
        }
    }
    impl check::Validate for MoveTo {
        #[allow(unused_variables)]
        #[inline]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::FieldLimits,
        ) -> Result<(), check::NotSent> {
            place.check("mode", &self.mode, &check::FieldLimits::NONE)?;
            place
                .check(
                    "position",
                    &self.position,
                    &check::FieldLimits {
                        advised: match &self.mode {
                            Mode::Absolute => {
                                check::Advised::to(
                                    &[
                                        check::Advice {
                                            max: 360f64,
                                            nonzero: false,
                                            unit: "",
                                        },
                                    ],
                                )
                            }
                            Mode::Relative => {
                                check::Advised::to(
                                        &[
                                            check::Advice {
                                                max: 2.5f64,
                                                nonzero: true,
                                                unit: "",
                                            },
                                        ],
                                    )
                                    .times(Clone::clone(&self.count))
                            }
                            _ => check::Advised::NONE,
                        },
                        ..check::FieldLimits::NONE
                    },
                )?;
            place
                .check(
                    "via",
                    &self.via,
                    &check::FieldLimits {
                        advised: check::Advised::to(
                            &[
                                check::Advice {
                                    max: 2000f64,
                                    nonzero: false,
                                    unit: "mm",
                                },
                            ],
                        ),
                        ..check::FieldLimits::NONE
                    },
                )?;
            place.check("count", &self.count, &check::FieldLimits::NONE)?;
            place
                .check(
                    "speed",
                    &self.speed,
                    &check::FieldLimits {
                        min: Some(0f64),
                        max: Some(180f64),
                        advisory: true,
                        unit: "deg/s",
                        ..check::FieldLimits::NONE
                    },
                )?;
            place
                .check(
                    "tolerance",
                    &self.tolerance,
                    &check::FieldLimits {
                        firmware: proto::FirmwareRange::ALL.until([1, 6]),
                        ..check::FieldLimits::NONE
                    },
                )?;
            Ok(())
        }
    }
    impl proto::Command for MoveTo {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::__command_info!(
            "moveTo", "{\"cmdName\":\"moveTo\"", "4.7", Motion, role :
            Some(proto::Role::Start), requires : & [proto::Requirement::Enabled,
            proto::Requirement::NotServoMode], deadline :
            Some(::core::time::Duration::from_millis(60000u64)), firmware :
            proto::FirmwareRange::ALL.since([1, 5]),
        );
    }
    /// Names the robot.
    ///
    /// Sends `set_name`.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct SetName {
        /// Its name.
        ///
        /// Printable ASCII only.
        pub name: String,
    }
    impl wire::Fields for SetName {
        #[inline]
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"name\":");
            wire::Encode::encode(&self.name, out);
        }
        #[inline]
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut name = None;
            let mut keys = reader.begin_fields(&["\"name\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("name", &mut name)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                name: name.ok_or_else(|| wire::DecodeError::missing("name", "name"))?,
            })
        }
    }
    proto::__object_impls!(SetName);
    impl SetName {
        /// With the required fields alone.
        #[must_use]
        pub fn new(name: impl Into<String>) -> Self {
            Self { name: name.into() }
        }
    }
    impl check::Validate for SetName {
        #[allow(unused_variables)]
        #[inline]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::FieldLimits,
        ) -> Result<(), check::NotSent> {
            place
                .check(
                    "name",
                    &self.name,
                    &check::FieldLimits {
                        ascii: true,
                        ..check::FieldLimits::NONE
                    },
                )?;
            Ok(())
        }
    }
    impl proto::Command for SetName {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::__command_info!(
            "set_name", "{\"cmdName\":\"set_name\"", "", Setting,
        );
    }
    /// Sets a filter.
    ///
    /// Sends `set_filter`.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub enum SetFilter {
        /// No filter.
        #[non_exhaustive]
        Off,
        /// A low-pass filter.
        #[non_exhaustive]
        LowPass {
            /// Its cut-off frequency. In Hz.
            cutoff: f64,
        },
    }
    impl wire::Fields for SetFilter {
        #[inline]
        fn write_fields(&self, out: &mut wire::Writer) {
            match self {
                Self::Off {} => {
                    out.key("\"filter_type\":0");
                }
                Self::LowPass { cutoff } => {
                    out.key("\"filter_type\":1");
                    out.raw(",\"cutoff\":");
                    wire::Encode::encode(cutoff, out);
                }
            }
        }
        #[inline]
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
                    Ok(Self::Off {})
                }
                1 => {
                    let mut cutoff = None;
                    let mut keys = reader.begin_fields(&["\"cutoff\":"])?;
                    while let Some(key) = reader.next_field(&mut keys)? {
                        match key {
                            0 => reader.field("cutoff", &mut cutoff)?,
                            _ => reader.skip()?,
                        }
                    }
                    Ok(Self::LowPass {
                        cutoff: cutoff
                            .ok_or_else(|| wire::DecodeError::missing(
                                "cutoff",
                                "cutoff",
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
    proto::__object_impls!(SetFilter);
    impl SetFilter {
        /// No filter.
        #[must_use]
        pub const fn off() -> Self {
            Self::Off {}
        }
        /// A low-pass filter.
        ///
        /// - `cutoff`: in Hz
        #[must_use]
        pub const fn low_pass(cutoff: f64) -> Self {
            Self::LowPass { cutoff }
        }
    }
    impl check::Validate for SetFilter {
        #[allow(unused_variables)]
        #[inline]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::FieldLimits,
        ) -> Result<(), check::NotSent> {
            match self {
                Self::Off {} => {}
                Self::LowPass { cutoff } => {
                    place
                        .check(
                            "cutoff",
                            cutoff,
                            &check::FieldLimits {
                                unit: "Hz",
                                ..check::FieldLimits::NONE
                            },
                        )?;
                }
            }
            Ok(())
        }
    }
    impl proto::Command for SetFilter {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::__command_info!(
            "set_filter", "{\"cmdName\":\"set_filter\"", "", Setting,
        );
    }
    /// Reads the state.
    ///
    /// Sends `get_state`. Changes nothing on the robot. The reply is [`GetStateReply`].
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetState {}
    impl wire::Fields for GetState {
        #[inline]
        fn write_fields(&self, out: &mut wire::Writer) {
            let _ = out;
        }
        #[inline]
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut keys = reader.begin_fields(&[])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    _ => reader.skip()?,
                }
            }
            Ok(Self {})
        }
    }
    proto::__object_impls!(GetState);
    impl GetState {
        /// Without any optional field.
        #[must_use]
        pub const fn new() -> Self {
            Self {}
        }
    }
    impl check::Validate for GetState {
        #[allow(unused_variables)]
        #[inline]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::FieldLimits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for GetState {
        type Reply = GetStateReply;
        const INFO: &'static proto::CommandInfo = &proto::__command_info!(
            "get_state", "{\"cmdName\":\"get_state\"", "", Query,
        );
    }
    /// What the controller answers to [`type@GetState`].
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetStateReply {
        /// Whether it is enabled. `enabled status` on the wire.
        #[doc(alias = "enabled status")]
        pub enabled: bool,
        /// What the program does.
        pub state: Option<State>,
        /// An alarm.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub alarm: wire::Typed<i64>,
        /// Digital inputs.
        pub inputs: Vec<bool>,
    }
    impl wire::Fields for GetStateReply {
        #[inline]
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"enabled status\":");
            out.choose(*&self.enabled, "\"off\"", "\"on\"");
            if let Some(value) = &self.state {
                out.raw(",\"state\":");
                wire::Encode::encode(value, out);
            }
            out.raw(",\"alarm\":");
            match &self.alarm {
                wire::Typed::Known(value) => {
                    wire::Encode::encode(value, out);
                }
                wire::Typed::Raw(value) => wire::Encode::encode(value, out),
            }
            out.raw(",\"inputs\":");
            out.array(
                &self.inputs,
                |out, item| {
                    out.choose(*item, "0", "1");
                },
            );
        }
        #[inline]
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut enabled = None;
            let mut state = None;
            let mut alarm = None;
            let mut inputs = None;
            let mut keys = reader
                .begin_fields(
                    &["\"enabled status\":", "\"state\":", "\"alarm\":", "\"inputs\":"],
                )?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field_word("enabled", &mut enabled, "off", "on")?,
                    1 => reader.field("state", &mut state)?,
                    2 => reader.field("alarm", &mut alarm)?,
                    3 => reader.field("inputs", &mut inputs)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                enabled: enabled
                    .ok_or_else(|| wire::DecodeError::missing(
                        "enabled",
                        "enabled status",
                    ))?,
                state,
                alarm: alarm
                    .ok_or_else(|| wire::DecodeError::missing("alarm", "alarm"))?,
                inputs: inputs
                    .ok_or_else(|| wire::DecodeError::missing("inputs", "inputs"))?,
            })
        }
    }
    proto::__object_impls!(GetStateReply);
    /// Reads the status.
    ///
    /// Sends `get_data`. Changes nothing on the robot. The reply is [`type@RobotStatus`].
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetData {}
    impl wire::Fields for GetData {
        #[inline]
        fn write_fields(&self, out: &mut wire::Writer) {
            let _ = out;
        }
        #[inline]
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut keys = reader.begin_fields(&[])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    _ => reader.skip()?,
                }
            }
            Ok(Self {})
        }
    }
    proto::__object_impls!(GetData);
    impl GetData {
        /// Without any optional field.
        #[must_use]
        pub const fn new() -> Self {
            Self {}
        }
    }
    impl check::Validate for GetData {
        #[allow(unused_variables)]
        #[inline]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::FieldLimits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for GetData {
        type Reply = RobotStatus;
        const INFO: &'static proto::CommandInfo = &proto::__command_info!(
            "get_data", "{\"cmdName\":\"get_data\"", "", Query,
        );
    }
    /// Reads the modules.
    ///
    /// Sends `get_modules`. Changes nothing on the robot. The reply is [`GetModulesReply`].
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetModules {}
    impl wire::Fields for GetModules {
        #[inline]
        fn write_fields(&self, out: &mut wire::Writer) {
            let _ = out;
        }
        #[inline]
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut keys = reader.begin_fields(&[])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    _ => reader.skip()?,
                }
            }
            Ok(Self {})
        }
    }
    proto::__object_impls!(GetModules);
    impl GetModules {
        /// Without any optional field.
        #[must_use]
        pub const fn new() -> Self {
            Self {}
        }
    }
    impl check::Validate for GetModules {
        #[allow(unused_variables)]
        #[inline]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::FieldLimits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for GetModules {
        type Reply = GetModulesReply;
        const INFO: &'static proto::CommandInfo = &proto::__command_info!(
            "get_modules", "{\"cmdName\":\"get_modules\"", "", Query, bare_reply :
            Some("modules"),
        );
    }
    /// What the controller answers to [`type@GetModules`].
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetModulesReply {
        /// All modules.
        pub modules: Vec<Module>,
    }
    impl wire::Fields for GetModulesReply {
        #[inline]
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"modules\":");
            out.python(|out| {
                wire::Encode::encode(&self.modules, out);
            });
        }
        #[inline]
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut modules = None;
            let mut keys = reader.begin_fields(&["\"modules\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field_python("modules", &mut modules)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                modules: modules
                    .ok_or_else(|| wire::DecodeError::missing("modules", "modules"))?,
            })
        }
    }
    proto::__object_impls!(GetModulesReply);
    /// How a position counts.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum Mode {
        /// As it is. `0` on the wire.
        Absolute,
        /// From where the arm is. Taken by newer firmware only. `1` on the wire.
        Relative,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for Mode {
        fn from(value: i64) -> Self {
            match value {
                0 => Self::Absolute,
                1 => Self::Relative,
                other => Self::Other(other),
            }
        }
    }
    impl From<Mode> for i64 {
        fn from(value: Mode) -> Self {
            match value {
                Mode::Absolute => 0,
                Mode::Relative => 1,
                Mode::Other(other) => other,
            }
        }
    }
    /// The value in words; one that the spec does not list as its number.
    impl ::core::fmt::Display for Mode {
        #[inline]
        fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
            match self {
                Self::Absolute => f.pad("absolute"),
                Self::Relative => f.pad("relative"),
                Self::Other(other) => ::core::fmt::Display::fmt(other, f),
            }
        }
    }
    proto::__int_enum_impls!(Mode);
    impl check::Validate for Mode {
        #[allow(unused_variables)]
        #[inline]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::FieldLimits,
        ) -> Result<(), check::NotSent> {
            let standing = match self {
                Self::Absolute => check::Standing::Listed,
                Self::Relative => check::Standing::Advisory,
                Self::Other(_) => check::Standing::Unknown,
            };
            place.listed(&i64::from(*self), standing, "0 (Absolute)")
        }
    }
    /// What a program does.
    #[derive(Debug, Clone, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum State {
        /// Nothing. `"idle"` on the wire.
        Idle,
        /// It runs. `"running"` on the wire.
        Running,
        /// A value that the spec does not list.
        Other(String),
    }
    impl From<&str> for State {
        fn from(value: &str) -> Self {
            match value {
                "idle" => Self::Idle,
                "running" => Self::Running,
                other => Self::Other(other.to_owned()),
            }
        }
    }
    impl AsRef<str> for State {
        fn as_ref(&self) -> &str {
            match self {
                Self::Idle => "idle",
                Self::Running => "running",
                Self::Other(other) => other,
            }
        }
    }
    /// The value as on the wire.
    impl ::core::fmt::Display for State {
        #[inline]
        fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
            f.pad(self.as_ref())
        }
    }
    proto::__text_enum_impls!(State);
    impl check::Validate for State {
        #[allow(unused_variables)]
        #[inline]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::FieldLimits,
        ) -> Result<(), check::NotSent> {
            let standing = match self {
                Self::Idle | Self::Running => check::Standing::Listed,
                Self::Other(_) => check::Standing::Unknown,
            };
            place.listed(&self.as_ref(), standing, "`idle` or `running`")
        }
    }
    /// Joint positions. In deg.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Joints(pub [f64; 6]);
    impl From<[f64; 6]> for Joints {
        fn from(value: [f64; 6]) -> Self {
            Self(value)
        }
    }
    impl From<Joints> for [f64; 6] {
        fn from(value: Joints) -> Self {
            value.0
        }
    }
    impl wire::Encode for Joints {
        #[inline]
        fn encode(&self, out: &mut wire::Writer) {
            wire::Encode::encode(&self.0, out);
        }
    }
    impl wire::Decode for Joints {
        fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
            wire::Decode::decode(reader).map(Self)
        }
    }
    proto::__serde_impls!(Joints);
    impl check::Validate for Joints {
        #[allow(unused_variables)]
        #[inline]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::FieldLimits,
        ) -> Result<(), check::NotSent> {
            let limits = check::FieldLimits {
                unit: "deg",
                ..*limits
            };
            check::Validate::validate(&self.0, place, &limits)
        }
    }
    /// A point.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Point {
        /// Along x. In mm.
        pub x: f64,
        /// Along y.
        pub y: f64,
    }
    impl wire::Encode for Point {
        #[inline]
        fn encode(&self, out: &mut wire::Writer) {
            out.raw("[");
            wire::Encode::encode(&self.x, out);
            out.raw(",");
            wire::Encode::encode(&self.y, out);
            out.raw("]");
        }
    }
    impl wire::Decode for Point {
        fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
            reader.begin_array()?;
            let this = Self {
                x: reader.element("x")?,
                y: reader.element("y")?,
            };
            reader.end_exact_array()?;
            Ok(this)
        }
    }
    proto::__serde_impls!(Point);
    impl From<[f64; 2]> for Point {
        fn from([x, y]: [f64; 2]) -> Self {
            Self { x, y }
        }
    }
    impl From<Point> for [f64; 2] {
        fn from(value: Point) -> Self {
            [value.x, value.y]
        }
    }
    impl check::Validate for Point {
        #[allow(unused_variables)]
        #[inline]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::FieldLimits,
        ) -> Result<(), check::NotSent> {
            place
                .check(
                    "x",
                    &self.x,
                    &check::FieldLimits {
                        unit: "mm",
                        ..check::FieldLimits::NONE
                    },
                )?;
            place.check("y", &self.y, &check::FieldLimits::NONE)?;
            Ok(())
        }
    }
    /// A module.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct Module {
        /// How it is reached.
        pub setup: Setup,
        /// Its label.
        pub label: Option<String>,
    }
    impl wire::Encode for Module {
        #[inline]
        fn encode(&self, out: &mut wire::Writer) {
            out.raw("[");
            wire::Encode::encode(&self.setup, out);
            if let Some(value) = &self.label {
                out.raw(",");
                wire::Encode::encode(value, out);
            }
            out.raw("]");
        }
    }
    impl wire::Decode for Module {
        fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
            reader.begin_array()?;
            let this = Self {
                setup: reader.element("setup")?,
                label: reader.optional_element("label")?,
            };
            reader.end_array()?;
            Ok(this)
        }
        fn decode_into(
            &mut self,
            reader: &mut wire::Reader<'_>,
        ) -> Result<(), wire::DecodeError> {
            reader.begin_array()?;
            reader.element_into("setup", &mut self.setup)?;
            reader.optional_element_into("label", &mut self.label)?;
            reader.end_array()
        }
    }
    proto::__serde_impls!(Module);
    impl check::Validate for Module {
        #[allow(unused_variables)]
        #[inline]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::FieldLimits,
        ) -> Result<(), check::NotSent> {
            place.check("setup", &self.setup, &check::FieldLimits::NONE)?;
            place.check("label", &self.label, &check::FieldLimits::NONE)?;
            Ok(())
        }
    }
    /// How a module is reached.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub enum Setup {
        /// By a serial line.
        #[non_exhaustive]
        Serial {
            /// Bauds.
            baud_rate: i64,
        },
        /// By TCP.
        #[non_exhaustive]
        Tcp {
            /// Its address.
            address: String,
        },
        /// A kind that the spec does not list, as raw JSON.
        Other(wire::Value),
    }
    impl wire::Encode for Setup {
        #[inline]
        fn encode(&self, out: &mut wire::Writer) {
            match self {
                Self::Serial { baud_rate } => {
                    out.raw("[0");
                    out.raw(",");
                    wire::Encode::encode(baud_rate, out);
                    out.raw("]");
                }
                Self::Tcp { address } => {
                    out.raw("[1");
                    out.raw(",");
                    wire::Encode::encode(address, out);
                    out.raw("]");
                }
                Self::Other(value) => wire::Encode::encode(value, out),
            }
        }
    }
    impl wire::Decode for Setup {
        fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
            let start = reader.mark();
            reader.begin_array()?;
            match reader.element::<i64>("kind")? {
                0 => {
                    let this = Self::Serial {
                        baud_rate: reader.element("baud_rate")?,
                    };
                    reader.end_array()?;
                    Ok(this)
                }
                1 => {
                    let this = Self::Tcp {
                        address: reader.element("address")?,
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
                (1, Self::Tcp { address }) => {
                    reader.element_into("address", address)?;
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
    proto::__serde_impls!(Setup);
    impl check::Validate for Setup {
        #[allow(unused_variables)]
        #[inline]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::FieldLimits,
        ) -> Result<(), check::NotSent> {
            match self {
                Self::Serial { baud_rate } => {
                    place.check("baud_rate", baud_rate, &check::FieldLimits::NONE)?;
                }
                Self::Tcp { address } => {
                    place.check("address", address, &check::FieldLimits::NONE)?;
                }
                Self::Other(_) => {}
            }
            Ok(())
        }
    }
    /// A status packet. [`moveTo`](type@MoveTo) changes the point.
    #[derive(Debug, Clone, PartialEq, Default)]
    #[non_exhaustive]
    pub struct RobotStatus {
        /// Where the tool is.
        pub point: Option<Point>,
        /// The event. `errcode` on the wire.
        #[doc(alias = "errcode")]
        pub event: Option<String>,
    }
    impl wire::Fields for RobotStatus {
        #[inline]
        fn write_fields(&self, out: &mut wire::Writer) {
            if let Some(value) = &self.point {
                out.key("\"point\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.event {
                out.key("\"errcode\":");
                wire::Encode::encode(value, out);
            }
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut this = Self::default();
            wire::Fields::read_fields_into(&mut this, reader)?;
            Ok(this)
        }
        fn read_fields_into(
            &mut self,
            reader: &mut wire::Reader<'_>,
        ) -> Result<(), wire::DecodeError> {
            let mut keys = reader.begin_status(&["\"point\":", "\"errcode\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.status_field_into("point", &mut self.point, &mut keys)?,
                    1 => reader.status_field_into("event", &mut self.event, &mut keys)?,
                    _ => reader.skip_unknown(&keys)?,
                }
            }
            keys.absent(0, &mut self.point);
            keys.absent(1, &mut self.event);
            Ok(())
        }
    }
    proto::__object_impls!(RobotStatus, in_place);
    impl check::Validate for RobotStatus {
        #[allow(unused_variables)]
        #[inline]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::FieldLimits,
        ) -> Result<(), check::NotSent> {
            place.check("point", &self.point, &check::FieldLimits::NONE)?;
            place.check("event", &self.event, &check::FieldLimits::NONE)?;
            Ok(())
        }
    }
}
/// Any request of the spec, by its `cmdName`.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Request {
    /// `stop`
    Stop(shapes::Stop),
    /// `moveTo`
    MoveTo(shapes::MoveTo),
    /// `set_name`
    SetName(shapes::SetName),
    /// `set_filter`
    SetFilter(shapes::SetFilter),
    /// `get_state`
    GetState(shapes::GetState),
    /// `get_data`
    GetData(shapes::GetData),
    /// `get_modules`
    GetModules(shapes::GetModules),
}
impl Request {
    /// Facts of the spec about each command, topic by topic.
    pub const COMMANDS: &'static [&'static ::jaka_proto::CommandInfo] = &[
        <shapes::Stop as ::jaka_proto::Command>::INFO,
        <shapes::MoveTo as ::jaka_proto::Command>::INFO,
        <shapes::SetName as ::jaka_proto::Command>::INFO,
        <shapes::SetFilter as ::jaka_proto::Command>::INFO,
        <shapes::GetState as ::jaka_proto::Command>::INFO,
        <shapes::GetData as ::jaka_proto::Command>::INFO,
        <shapes::GetModules as ::jaka_proto::Command>::INFO,
    ];
    /// Does something with the request, whatever its type.
    pub fn visit<V: ::jaka_proto::Visit>(&self, visitor: V) -> V::Output {
        match self {
            Self::Stop(request) => visitor.visit(request),
            Self::MoveTo(request) => visitor.visit(request),
            Self::SetName(request) => visitor.visit(request),
            Self::SetFilter(request) => visitor.visit(request),
            Self::GetState(request) => visitor.visit(request),
            Self::GetData(request) => visitor.visit(request),
            Self::GetModules(request) => visitor.visit(request),
        }
    }
    /// Reads the request `name` from its JSON; `None` if the spec has no such command.
    #[inline]
    pub(crate) fn read_named(
        name: &str,
        reader: &mut ::jaka_proto::wire::Reader<'_>,
    ) -> Option<Result<Self, ::jaka_proto::wire::DecodeError>> {
        Some(
            match name {
                "stop" => ::jaka_proto::wire::Fields::read_fields(reader).map(Self::Stop),
                "moveTo" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::MoveTo)
                }
                "set_name" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::SetName)
                }
                "set_filter" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::SetFilter)
                }
                "get_state" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::GetState)
                }
                "get_data" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::GetData)
                }
                "get_modules" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::GetModules)
                }
                _ => return None,
            },
        )
    }
}
impl From<shapes::Stop> for Request {
    fn from(request: shapes::Stop) -> Self {
        Self::Stop(request)
    }
}
impl From<shapes::MoveTo> for Request {
    fn from(request: shapes::MoveTo) -> Self {
        Self::MoveTo(request)
    }
}
impl From<shapes::SetName> for Request {
    fn from(request: shapes::SetName) -> Self {
        Self::SetName(request)
    }
}
impl From<shapes::SetFilter> for Request {
    fn from(request: shapes::SetFilter) -> Self {
        Self::SetFilter(request)
    }
}
impl From<shapes::GetState> for Request {
    fn from(request: shapes::GetState) -> Self {
        Self::GetState(request)
    }
}
impl From<shapes::GetData> for Request {
    fn from(request: shapes::GetData) -> Self {
        Self::GetData(request)
    }
}
impl From<shapes::GetModules> for Request {
    fn from(request: shapes::GetModules) -> Self {
        Self::GetModules(request)
    }
}
impl ::jaka_proto::ErrorCode {
    /// The command failed; the message says more. Also where [`moveTo`](crate::messages::shapes::MoveTo) is refused.
    pub const CALL_FAILED: Self = Self(2i64);
    /// Meaning of the code in a sentence, from sources; `None` for a code that they do not name.
    pub fn meaning(self) -> Option<&'static str> {
        match self.0 {
            2i64 => Some("The command failed; the message says more."),
            _ => None,
        }
    }
}
/// Ranges of codes of events, first and last, in their order, each with its place in `EVENT_EXPLANATIONS`.
pub(crate) static EVENT_RANGES: &[(u32, u32, usize)] = &[(0x0F0006, 0x0F0007, 0)];
/// Severity, meaning, cause and remedy.
pub(crate) static EVENT_EXPLANATIONS: &[::jaka_proto::controller_event::Explanation] = &[
    (::jaka_proto::Severity::Error, Some("a joint is at its hard limit"), None, None),
];
pub mod shapes {
    //! Shapes.
    //!
    //! A command of each shape, and what such commands are made of. [`stop`](crate::Client::stop) is the simplest.
    /// Sent by [`Client::stop`](crate::Client::stop).
    #[doc(inline)]
    pub use ::jaka_proto::messages::shapes::Stop;
    /// Sent by [`Client::move_to`](crate::Client::move_to).
    #[doc(inline)]
    pub use ::jaka_proto::messages::shapes::MoveTo;
    /// Sent by [`Client::set_name`](crate::Client::set_name).
    #[doc(inline)]
    pub use ::jaka_proto::messages::shapes::SetName;
    /// Sent by [`Client::set_filter`](crate::Client::set_filter).
    #[doc(inline)]
    pub use ::jaka_proto::messages::shapes::SetFilter;
    /// Sent by [`Client::get_state`](crate::Client::get_state).
    #[doc(inline)]
    pub use ::jaka_proto::messages::shapes::GetState;
    /// Sent by [`Client::get_data`](crate::Client::get_data).
    #[doc(inline)]
    pub use ::jaka_proto::messages::shapes::GetData;
    /// Sent by [`Client::get_modules`](crate::Client::get_modules).
    #[doc(inline)]
    pub use ::jaka_proto::messages::shapes::GetModules;
    #[doc(inline)]
    pub use ::jaka_proto::messages::shapes::{
        GetStateReply, GetModulesReply, Mode, State, Joints, Point, Module, Setup,
        RobotStatus,
    };
}
/// # Shapes
///
/// With the messages of [`shapes`](crate::shapes).
impl Client {
    /// Stops the motion.
    ///
    /// Sends [`stop`](crate::shapes::Stop).
    ///
    /// # Errors
    /// As [`call`](Self::call).
    #[inline]
    pub fn stop(&mut self) -> Result<(), Error> {
        self.call(&self::shapes::Stop::new())
    }
    /// Moves all joints to a position. [`stop`](crate::Client::stop) ends the motion.
    ///
    /// Sends [`moveTo`](crate::shapes::MoveTo) (4.7). The robot must be enabled and outside servo mode.
    ///
    /// Known to firmware 1.5 and later.
    ///
    /// # Errata
    ///
    /// - The sample has `toll`.
    ///
    /// # Examples
    ///
    /// ```rust,no_run
    /// # let mut robot = jaka_sync::Client::connect("10.5.5.100")?;
    /// use jaka_sync::shapes::MoveTo;
    ///
    /// robot.move_to(&MoveTo::absolute([0.0, 0.0, 0.0, 0.0, 0.0, 0.0], 20.5))?;
    /// # Ok::<(), jaka_sync::Error>(())
    /// ```
    ///
    /// Request:
    ///
    /// ```json
    /// {"cmdName":"moveTo","relFlag":0,"position":[0,0,0,0,0,0],"speed":20.5}
    /// ```
    ///
    /// Reply:
    ///
    /// ```json
    /// {"errorCode":"0","errorMsg":"","cmdName":"moveTo"}
    /// ```
    ///
    /// # Errors
    /// As [`call`](Self::call). In another state than the one it needs, expect a refusal.
    #[doc(alias = "moveTo")]
    #[doc(alias = "joint_move")]
    #[inline]
    pub fn move_to(&mut self, request: &self::shapes::MoveTo) -> Result<(), Error> {
        self.call(request)
    }
    /// Names the robot.
    ///
    /// Sends [`set_name`](crate::shapes::SetName).
    ///
    /// # Errors
    /// As [`call`](Self::call).
    #[inline]
    pub fn set_name(&mut self, name: impl Into<String>) -> Result<(), Error> {
        self.call(&self::shapes::SetName::new(name))
    }
    /// Sets a filter.
    ///
    /// Sends [`set_filter`](crate::shapes::SetFilter).
    ///
    /// # Errors
    /// As [`call`](Self::call).
    #[inline]
    pub fn set_filter(
        &mut self,
        request: &self::shapes::SetFilter,
    ) -> Result<(), Error> {
        self.call(request)
    }
    /// Reads the state.
    ///
    /// Sends [`get_state`](crate::shapes::GetState). Changes nothing on the robot.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    #[inline]
    pub fn get_state(&mut self) -> Result<self::shapes::GetStateReply, Error> {
        self.call(&self::shapes::GetState::new())
    }
    /// Reads the status.
    ///
    /// Sends [`get_data`](crate::shapes::GetData). Changes nothing on the robot.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    #[inline]
    pub fn get_data(&mut self) -> Result<self::shapes::RobotStatus, Error> {
        self.call(&self::shapes::GetData::new())
    }
    /// Reads the modules.
    ///
    /// Sends [`get_modules`](crate::shapes::GetModules). Changes nothing on the robot.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    #[inline]
    pub fn get_modules(&mut self) -> Result<self::shapes::GetModulesReply, Error> {
        self.call(&self::shapes::GetModules::new())
    }
}
