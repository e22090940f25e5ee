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
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct RapidRate {
        /// Rate. 0 to 1. The default is 1.
        ///
        /// `rate_value` on the wire.
        #[doc(alias = "rate_value")]
        pub rate: f64,
    }
    impl wire::Fields for RapidRate {
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
    proto::__object_impls!(RapidRate);
    impl check::Validate for RapidRate {
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
    impl proto::Command for RapidRate {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "rapid_rate",
            "{\"cmdName\":\"rapid_rate\"",
            "4.17",
            proto::Effect::Setting,
        );
    }
    /// Loads a program that is stored on the controller.
    ///
    /// The name ends in `.ngc` on controllers before version 1.5 and in `.jks` from 1.5 on. A trajectory's file has `track/`
    /// before its name.
    ///
    /// Sends `load_program` (4.18).
    ///
    /// # Errata
    ///
    /// - The text writes the key `program_name`, the sample `programName`.
    #[derive(Debug, Clone, PartialEq)]
    pub struct LoadProgram {
        /// File name of the program. Chinese characters are not supported.
        ///
        /// Printable ASCII only.
        ///
        /// `programName` on the wire.
        #[doc(alias = "programName")]
        pub program_name: String,
    }
    impl wire::Fields for LoadProgram {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"programName\":");
            wire::Encode::encode(&self.program_name, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut program_name = None;
            let mut keys = reader.begin_fields(&["\"programName\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("program_name", &mut program_name)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                program_name: program_name
                    .ok_or_else(|| wire::DecodeError::missing(
                        "program_name",
                        "programName",
                    ))?,
            })
        }
    }
    proto::__object_impls!(LoadProgram);
    impl check::Validate for LoadProgram {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place
                .check(
                    "program_name",
                    &self.program_name,
                    &check::Limits {
                        ascii: true,
                        ..check::Limits::NONE
                    },
                )?;
            Ok(())
        }
    }
    impl proto::Command for LoadProgram {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "load_program",
            "{\"cmdName\":\"load_program\"",
            "4.18",
            proto::Effect::Setting,
        );
    }
    /// Reads the name of the loaded program.
    ///
    /// Sends `get_loaded_program` (4.19). Changes nothing on the robot.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct GetLoadedProgram;
    impl wire::Fields for GetLoadedProgram {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(GetLoadedProgram);
    impl check::Validate for GetLoadedProgram {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for GetLoadedProgram {
        type Reply = GetLoadedProgramReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "get_loaded_program",
            "{\"cmdName\":\"get_loaded_program\"",
            "4.19",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`GetLoadedProgram`].
    #[derive(Debug, Clone, PartialEq)]
    pub struct GetLoadedProgramReply {
        /// File name of the program. The document does not say what it is when no program is loaded, nor whether a trajectory's
        /// name keeps its `track/`.
        ///
        /// `programName` on the wire.
        #[doc(alias = "programName")]
        pub program_name: String,
    }
    impl wire::Fields for GetLoadedProgramReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"programName\":");
            wire::Encode::encode(&self.program_name, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut program_name = None;
            let mut keys = reader.begin_fields(&["\"programName\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("program_name", &mut program_name)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                program_name: program_name
                    .ok_or_else(|| wire::DecodeError::missing(
                        "program_name",
                        "programName",
                    ))?,
            })
        }
    }
    proto::__object_impls!(GetLoadedProgramReply);
    /// Starts the loaded program.
    ///
    /// Sends `play_program` (4.20). The robot must be powered and enabled.
    ///
    /// Reconstructed, since the document's page is lost: reply only: the document has the request, the page with the reply is lost. Field notes: certain.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct PlayProgram;
    impl wire::Fields for PlayProgram {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(PlayProgram);
    impl check::Validate for PlayProgram {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for PlayProgram {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
                "play_program",
                "{\"cmdName\":\"play_program\"",
                "4.20",
                proto::Effect::Motion,
            )
            .requires(&[proto::Requirement::Powered, proto::Requirement::Enabled]);
    }
    /// Pauses the program that is running.
    ///
    /// Sends `pause_program` (4.21).
    ///
    /// Reconstructed, since the document's page is lost: The document's page is lost. Field notes: request and reply likely.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct PauseProgram;
    impl wire::Fields for PauseProgram {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(PauseProgram);
    impl check::Validate for PauseProgram {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for PauseProgram {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "pause_program",
            "{\"cmdName\":\"pause_program\"",
            "4.21",
            proto::Effect::Motion,
        );
    }
    /// Resumes the program that is paused.
    ///
    /// Sends `resume_program` (4.22). The robot must be powered and enabled.
    ///
    /// Reconstructed, since the document's page is lost: The document's page is lost. Field notes: request and reply likely.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct ResumeProgram;
    impl wire::Fields for ResumeProgram {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(ResumeProgram);
    impl check::Validate for ResumeProgram {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for ResumeProgram {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
                "resume_program",
                "{\"cmdName\":\"resume_program\"",
                "4.22",
                proto::Effect::Motion,
            )
            .requires(&[proto::Requirement::Powered, proto::Requirement::Enabled]);
    }
    /// Stops the program, or the motion, that is running.
    ///
    /// This is also the usual way to abort `joint_move`, `end_move` or `move_l` with no program loaded. No source says whether
    /// it ends `move_c`, a jog or servo motion too, nor what becomes of motions that wait their turn. It is no emergency stop:
    /// the command travels over the network.
    ///
    /// Sends `stop_program` (4.23).
    ///
    /// Reconstructed, since the document's page is lost: The document's page is lost. Field notes: request and reply certain. Sections 4.7 to 4.9 name it to end a motion.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct StopProgram;
    impl wire::Fields for StopProgram {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(StopProgram);
    impl check::Validate for StopProgram {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for StopProgram {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "stop_program",
            "{\"cmdName\":\"stop_program\"",
            "4.23",
            proto::Effect::Motion,
        );
    }
    /// Reads the state of the program.
    ///
    /// Sends `get_program_state` (4.24). Changes nothing on the robot.
    ///
    /// Reconstructed, since the document's page is lost: The document's page is lost. Field notes: request and key certain; value `idle` certain, `running` and `paused` likely.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct GetProgramState;
    impl wire::Fields for GetProgramState {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(GetProgramState);
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
}
