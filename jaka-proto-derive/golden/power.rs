/// Power, enabling and the controller's state.
///
/// The arm is ready to move when it has power and is enabled, in this order.
///
/// A reply to `power_on` or `enable_robot`, even with errorCode 0, is no proof of the new state. Poll `get_robot_state` or
/// the status of port 10000 until the state is there.
pub mod power {
    #[allow(unused_imports)]
    use ::jaka_proto::{self as proto, check, wire};
    /// Switches the arm's power on.
    ///
    /// This takes about 8 s. An errorCode of 0 is no proof that the arm has power: poll the state.
    ///
    /// Sends `power_on` (4.1).
    ///
    /// # Errata
    ///
    /// - The reply's key `power status` has a blank in it.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct PowerOn;
    impl wire::Fields for PowerOn {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(PowerOn);
    impl check::Validate for PowerOn {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for PowerOn {
        type Reply = PowerOnReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
                "power_on",
                "{\"cmdName\":\"power_on\"",
                "4.1",
                proto::Effect::Power,
            )
            .deadline_ms(30000u64);
    }
    /// What the controller answers to [`PowerOn`].
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct PowerOnReply {
        /// Whether the arm has power, where the controller says so.
        ///
        /// `power status` on the wire.
        #[doc(alias = "power status")]
        pub powered_on: Option<bool>,
    }
    impl wire::Fields for PowerOnReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            if let Some(value) = &self.powered_on {
                out.key("\"power status\":");
                out.choose(*value, "\"False\"", "\"True\"");
            }
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut powered_on = None;
            let mut keys = reader.begin_fields(&["\"power status\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("powered_on", &mut powered_on)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self { powered_on })
        }
    }
    proto::__object_impls!(PowerOnReply);
    /// Switches the arm's power off.
    ///
    /// Sends `power_off` (4.2).
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct PowerOff;
    impl wire::Fields for PowerOff {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(PowerOff);
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
    /// Enables the arm, so that it can move.
    ///
    /// This takes 3 to 4 s as a rule; 20 s is seen. An errorCode of 0 is no proof that the arm is enabled: poll the state.
    ///
    /// Sends `enable_robot` (4.3). The robot must be powered.
    ///
    /// # Errata
    ///
    /// - The reply's key `enabled status` has a blank in it.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct EnableRobot;
    impl wire::Fields for EnableRobot {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(EnableRobot);
    impl check::Validate for EnableRobot {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for EnableRobot {
        type Reply = EnableRobotReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
                "enable_robot",
                "{\"cmdName\":\"enable_robot\"",
                "4.3",
                proto::Effect::Power,
            )
            .requires(&[proto::Requirement::Powered])
            .deadline_ms(30000u64);
    }
    /// What the controller answers to [`EnableRobot`].
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct EnableRobotReply {
        /// Whether the arm is enabled, where the controller says so.
        ///
        /// `enabled status` on the wire.
        #[doc(alias = "enabled status")]
        pub enabled: Option<bool>,
    }
    impl wire::Fields for EnableRobotReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            if let Some(value) = &self.enabled {
                out.key("\"enabled status\":");
                out.choose(*value, "\"False\"", "\"True\"");
            }
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut enabled = None;
            let mut keys = reader.begin_fields(&["\"enabled status\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("enabled", &mut enabled)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self { enabled })
        }
    }
    proto::__object_impls!(EnableRobotReply);
    /// Disables the arm.
    ///
    /// Sends `disable_robot` (4.4).
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct DisableRobot;
    impl wire::Fields for DisableRobot {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(DisableRobot);
    impl check::Validate for DisableRobot {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for DisableRobot {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
                "disable_robot",
                "{\"cmdName\":\"disable_robot\"",
                "4.4",
                proto::Effect::Power,
            )
            .deadline_ms(15000u64);
    }
    /// Shuts down the arm and the controller.
    ///
    /// The document shows a reply, users see none. The connection is of no use afterwards.
    ///
    /// Sends `shutdown` (4.5).
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct Shutdown;
    impl wire::Fields for Shutdown {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(Shutdown);
    impl check::Validate for Shutdown {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for Shutdown {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
                "shutdown",
                "{\"cmdName\":\"shutdown\"",
                "4.5",
                proto::Effect::Power,
            )
            .deadline_ms(5000u64)
            .reply_uncertain()
            .ends_session();
    }
    /// Reads whether the arm has power and is enabled.
    ///
    /// Old firmware answers with the document's words, newer firmware with true and false or with numbers, and adds the
    /// controller's error.
    ///
    /// Sends `get_robot_state` (4.12). Changes nothing on the robot.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct GetRobotState;
    impl wire::Fields for GetRobotState {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(GetRobotState);
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
        /// Firmware 1.5.14 writes a number, 17760261 for `0x10f0005`, which is kept as raw JSON. How other firmware writes it is not known;
        /// on port 10000 it is a hexadecimal string such as `0x0`. The Rust method `event` reads both.
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
    /// Reads the version of the controller's software.
    ///
    /// Sends `get_version` (4.51). Changes nothing on the robot.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct GetVersion;
    impl wire::Fields for GetVersion {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(GetVersion);
    impl check::Validate for GetVersion {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for GetVersion {
        type Reply = GetVersionReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "get_version",
            "{\"cmdName\":\"get_version\"",
            "4.51",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`GetVersion`].
    #[derive(Debug, Clone, PartialEq)]
    pub struct GetVersionReply {
        /// Version, such as `1.6.5_01_X86`.
        pub version: String,
    }
    impl wire::Fields for GetVersionReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"version\":");
            wire::Encode::encode(&self.version, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut version = None;
            let mut keys = reader.begin_fields(&["\"version\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("version", &mut version)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                version: version
                    .ok_or_else(|| wire::DecodeError::missing("version", "version"))?,
            })
        }
    }
    proto::__object_impls!(GetVersionReply);
}
