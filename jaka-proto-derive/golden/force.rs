/// Force control and drag mode.
///
/// Leading the arm by hand, the torque sensor at its end, and control that yields to forces.
///
/// While such control is on, the arm may move with the forces that act on it. The document gives no units for forces and
/// torques here.
pub mod force {
    #[allow(unused_imports)]
    use ::jaka_proto::{self as proto, check, wire};
    /// Switches drag mode on or off.
    ///
    /// In drag mode the arm gives way to the hand and can be led. `drag_status` reads the mode back.
    ///
    /// Sends `torque_control_enable` (4.36). The robot must be powered and enabled.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct TorqueControlEnable {
        /// Whether drag mode is on.
        pub enable_flag: super::types::Switch,
    }
    impl wire::Fields for TorqueControlEnable {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"enable_flag\":");
            wire::Encode::encode(&self.enable_flag, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut enable_flag = None;
            let mut keys = reader.begin_fields(&["\"enable_flag\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("enable_flag", &mut enable_flag)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                enable_flag: enable_flag
                    .ok_or_else(|| wire::DecodeError::missing(
                        "enable_flag",
                        "enable_flag",
                    ))?,
            })
        }
    }
    proto::__object_impls!(TorqueControlEnable);
    impl check::Validate for TorqueControlEnable {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("enable_flag", &self.enable_flag, &check::Limits::NONE)?;
            Ok(())
        }
    }
    impl proto::Command for TorqueControlEnable {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
                "torque_control_enable",
                "{\"cmdName\":\"torque_control_enable\"",
                "4.36",
                proto::Effect::Setting,
            )
            .requires(&[proto::Requirement::Powered, proto::Requirement::Enabled]);
    }
    /// Reads whether the robot is in drag mode.
    ///
    /// Sends `drag_status` (4.37). Changes nothing on the robot.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct DragStatus;
    impl wire::Fields for DragStatus {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(DragStatus);
    impl check::Validate for DragStatus {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for DragStatus {
        type Reply = DragStatusReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "drag_status",
            "{\"cmdName\":\"drag_status\"",
            "4.37",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`DragStatus`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct DragStatusReply {
        /// Whether the robot is in drag mode.
        pub drag_status: bool,
    }
    impl wire::Fields for DragStatusReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"drag_status\":");
            out.choose(*&self.drag_status, "\"False\"", "\"True\"");
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut drag_status = None;
            let mut keys = reader.begin_fields(&["\"drag_status\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("drag_status", &mut drag_status)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                drag_status: drag_status
                    .ok_or_else(|| wire::DecodeError::missing(
                        "drag_status",
                        "drag_status",
                    ))?,
            })
        }
    }
    proto::__object_impls!(DragStatusReply);
    /// Sets the brand of the torque sensor.
    ///
    /// Sends `set_torsenosr_brand` (4.61).
    ///
    /// # Errata
    ///
    /// - The wire spells the name `torsenosr`.
    /// - The document's text calls the key `sensor_band`; its sample sends `sensor_brand`.
    #[doc(alias = "set_torsenosr_brand")]
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct SetTorqueSensorBrand {
        /// Brand of the sensor.
        ///
        /// `sensor_brand` on the wire.
        #[doc(alias = "sensor_brand")]
        pub brand: TorqueSensorBrand,
    }
    impl wire::Fields for SetTorqueSensorBrand {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"sensor_brand\":");
            wire::Encode::encode(&self.brand, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut brand = None;
            let mut keys = reader.begin_fields(&["\"sensor_brand\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("brand", &mut brand)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                brand: brand
                    .ok_or_else(|| wire::DecodeError::missing("brand", "sensor_brand"))?,
            })
        }
    }
    proto::__object_impls!(SetTorqueSensorBrand);
    impl check::Validate for SetTorqueSensorBrand {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("brand", &self.brand, &check::Limits::NONE)?;
            Ok(())
        }
    }
    impl proto::Command for SetTorqueSensorBrand {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "set_torsenosr_brand",
            "{\"cmdName\":\"set_torsenosr_brand\"",
            "4.61",
            proto::Effect::Setting,
        );
    }
    /// Reads the brand of the torque sensor.
    ///
    /// Sends `get_torsenosr_brand` (4.62). Changes nothing on the robot.
    ///
    /// # Errata
    ///
    /// - The wire spells the name `torsenosr`.
    /// - The document's text calls the key `sensor_band`; its sample answers `sensor_brand`.
    #[doc(alias = "get_torsenosr_brand")]
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct GetTorqueSensorBrand;
    impl wire::Fields for GetTorqueSensorBrand {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(GetTorqueSensorBrand);
    impl check::Validate for GetTorqueSensorBrand {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for GetTorqueSensorBrand {
        type Reply = GetTorqueSensorBrandReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "get_torsenosr_brand",
            "{\"cmdName\":\"get_torsenosr_brand\"",
            "4.62",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`GetTorqueSensorBrand`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct GetTorqueSensorBrandReply {
        /// Brand of the sensor.
        ///
        /// `sensor_brand` on the wire.
        #[doc(alias = "sensor_brand")]
        pub brand: TorqueSensorBrand,
    }
    impl wire::Fields for GetTorqueSensorBrandReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"sensor_brand\":");
            wire::Encode::encode(&self.brand, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut brand = None;
            let mut keys = reader.begin_fields(&["\"sensor_brand\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("brand", &mut brand)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                brand: brand
                    .ok_or_else(|| wire::DecodeError::missing("brand", "sensor_brand"))?,
            })
        }
    }
    proto::__object_impls!(GetTorqueSensorBrandReply);
    /// Sets the parameters of admittance control for one axis.
    ///
    /// For moving the arm by hand, the document wants the constant force and the normal tracking of all axes to be zero.
    ///
    /// Sends `set_admit_ctrl_config` (4.63).
    ///
    /// # Errata
    ///
    /// - The wire spells `ftNnormalTrack` with a double N.
    /// - The sample sends `ftReboundFK` last; the text, and the rows of 4.64, have it right behind `ftUser`.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct SetAdmitCtrlConfig {
        /// Axis to set.
        pub axis: CartesianAxis,
        /// Whether the axis is on.
        ///
        /// `opt` on the wire.
        #[doc(alias = "opt")]
        pub enabled: super::types::Switch,
        /// Damping: the force with which a user moves the arm along the axis at its greatest speed.
        ///
        /// Unit not stated.
        ///
        /// `ftUser` on the wire.
        #[doc(alias = "ftUser")]
        pub user_force: f64,
        /// Constant force. Unit not stated. Zero for moving the arm by hand.
        ///
        /// `ftConstant` on the wire.
        #[doc(alias = "ftConstant")]
        pub constant_force: f64,
        /// Normal tracking. Zero for moving the arm by hand.
        ///
        /// The document does not say which other values there are.
        ///
        /// `ftNnormalTrack` on the wire.
        #[doc(alias = "ftNnormalTrack")]
        pub normal_track: i64,
        /// Rebound: how strongly the arm returns to its initial state. Unit not stated.
        ///
        /// `ftReboundFK` on the wire.
        #[doc(alias = "ftReboundFK")]
        pub rebound: f64,
    }
    impl wire::Fields for SetAdmitCtrlConfig {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"axis\":");
            wire::Encode::encode(&self.axis, out);
            out.raw(",\"opt\":");
            wire::Encode::encode(&self.enabled, out);
            out.raw(",\"ftUser\":");
            wire::Encode::encode(&self.user_force, out);
            out.raw(",\"ftConstant\":");
            wire::Encode::encode(&self.constant_force, out);
            out.raw(",\"ftNnormalTrack\":");
            wire::Encode::encode(&self.normal_track, out);
            out.raw(",\"ftReboundFK\":");
            wire::Encode::encode(&self.rebound, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut axis = None;
            let mut enabled = None;
            let mut user_force = None;
            let mut constant_force = None;
            let mut normal_track = None;
            let mut rebound = None;
            let mut keys = reader
                .begin_fields(
                    &[
                        "\"axis\":",
                        "\"opt\":",
                        "\"ftUser\":",
                        "\"ftConstant\":",
                        "\"ftNnormalTrack\":",
                        "\"ftReboundFK\":",
                    ],
                )?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("axis", &mut axis)?,
                    1 => reader.field("enabled", &mut enabled)?,
                    2 => reader.field("user_force", &mut user_force)?,
                    3 => reader.field("constant_force", &mut constant_force)?,
                    4 => reader.field("normal_track", &mut normal_track)?,
                    5 => reader.field("rebound", &mut rebound)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                axis: axis.ok_or_else(|| wire::DecodeError::missing("axis", "axis"))?,
                enabled: enabled
                    .ok_or_else(|| wire::DecodeError::missing("enabled", "opt"))?,
                user_force: user_force
                    .ok_or_else(|| wire::DecodeError::missing("user_force", "ftUser"))?,
                constant_force: constant_force
                    .ok_or_else(|| wire::DecodeError::missing(
                        "constant_force",
                        "ftConstant",
                    ))?,
                normal_track: normal_track
                    .ok_or_else(|| wire::DecodeError::missing(
                        "normal_track",
                        "ftNnormalTrack",
                    ))?,
                rebound: rebound
                    .ok_or_else(|| wire::DecodeError::missing("rebound", "ftReboundFK"))?,
            })
        }
    }
    proto::__object_impls!(SetAdmitCtrlConfig);
    impl check::Validate for SetAdmitCtrlConfig {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("axis", &self.axis, &check::Limits::NONE)?;
            place.check("enabled", &self.enabled, &check::Limits::NONE)?;
            place.check("user_force", &self.user_force, &check::Limits::NONE)?;
            place.check("constant_force", &self.constant_force, &check::Limits::NONE)?;
            place.check("normal_track", &self.normal_track, &check::Limits::NONE)?;
            place.check("rebound", &self.rebound, &check::Limits::NONE)?;
            Ok(())
        }
    }
    impl proto::Command for SetAdmitCtrlConfig {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "set_admit_ctrl_config",
            "{\"cmdName\":\"set_admit_ctrl_config\"",
            "4.63",
            proto::Effect::Setting,
        );
    }
    /// Reads the parameters of admittance control for all axes.
    ///
    /// Sends `get_admit_ctrl_config` (4.64). Changes nothing on the robot.
    ///
    /// # Errata
    ///
    /// - The document's text describes six rows of five values; its sample has one more array around the six rows.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct GetAdmitCtrlConfig;
    impl wire::Fields for GetAdmitCtrlConfig {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(GetAdmitCtrlConfig);
    impl check::Validate for GetAdmitCtrlConfig {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for GetAdmitCtrlConfig {
        type Reply = GetAdmitCtrlConfigReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "get_admit_ctrl_config",
            "{\"cmdName\":\"get_admit_ctrl_config\"",
            "4.64",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`GetAdmitCtrlConfig`].
    #[derive(Debug, Clone, PartialEq)]
    pub struct GetAdmitCtrlConfigReply {
        /// Parameters of the axes x, y, z, rx, ry, rz.
        ///
        /// In the document's sample the outer array holds one array, and that one holds the six rows. The document's text describes
        /// one level less.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `admitConfig` on the wire.
        #[doc(alias = "admitConfig")]
        pub axes: wire::Typed<Vec<Vec<AdmittanceAxis>>>,
    }
    impl wire::Fields for GetAdmitCtrlConfigReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"admitConfig\":");
            match &self.axes {
                wire::Typed::Known(value) => {
                    wire::Encode::encode(value, out);
                }
                wire::Typed::Raw(value) => wire::Encode::encode(value, out),
            }
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut axes = None;
            let mut keys = reader.begin_fields(&["\"admitConfig\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("axes", &mut axes)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                axes: axes
                    .ok_or_else(|| wire::DecodeError::missing("axes", "admitConfig"))?,
            })
        }
    }
    proto::__object_impls!(GetAdmitCtrlConfigReply);
    /// Switches the torque sensor on or off.
    ///
    /// Sources contradict each other on which value is on, so the value is sent as given. Try it with the arm clear of people.
    ///
    /// Sends `set_torque_sensor_mode` (4.65).
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct SetTorqueSensorMode {
        /// Mode, 0 or 1, sent raw because the sources do not agree on the meaning. 0 to 1.
        ///
        /// Sources contradict each other on the meaning, so the value is passed on as it is:
        ///
        /// - document 2.0.4: 0 = on, 1 = off
        /// - vendor header, SDK 2.2.2: 1 = on, 0 = off
        ///
        /// `sensor_mode` on the wire.
        #[doc(alias = "sensor_mode")]
        pub mode: i64,
    }
    impl wire::Fields for SetTorqueSensorMode {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"sensor_mode\":");
            wire::Encode::encode(&self.mode, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut mode = None;
            let mut keys = reader.begin_fields(&["\"sensor_mode\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("mode", &mut mode)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                mode: mode
                    .ok_or_else(|| wire::DecodeError::missing("mode", "sensor_mode"))?,
            })
        }
    }
    proto::__object_impls!(SetTorqueSensorMode);
    impl check::Validate for SetTorqueSensorMode {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place
                .check(
                    "mode",
                    &self.mode,
                    &check::Limits {
                        min: Some(0f64),
                        max: Some(1f64),
                        ..check::Limits::NONE
                    },
                )?;
            Ok(())
        }
    }
    impl proto::Command for SetTorqueSensorMode {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "set_torque_sensor_mode",
            "{\"cmdName\":\"set_torque_sensor_mode\"",
            "4.65",
            proto::Effect::Setting,
        );
    }
    /// Moves the arm to a joint position to identify the payload at the end of the tool.
    ///
    /// This is a motion, and the document does not say how fast it is. `get_torq_sensor_identify_status` says when the
    /// identification is done, and `get_torq_sensor_payload_identify_result` reads what was found.
    ///
    /// Sends `start_torq_sensor_payload_identify` (4.66). The robot must be powered, enabled and outside servo mode.
    ///
    /// # Errata
    ///
    /// - The document's text also spells the key `jointposition`; its sample sends `jointPosition`.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct StartTorqSensorPayloadIdentify {
        /// Joint position at which the identification ends.
        ///
        /// The document recommends turning joints 4, 5 and 6 by 90 degrees each, for an accurate result.
        ///
        /// `jointPosition` on the wire.
        #[doc(alias = "jointPosition")]
        pub joint_position: super::types::JointPosition,
    }
    impl wire::Fields for StartTorqSensorPayloadIdentify {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"jointPosition\":");
            wire::Encode::encode(&self.joint_position, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut joint_position = None;
            let mut keys = reader.begin_fields(&["\"jointPosition\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("joint_position", &mut joint_position)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                joint_position: joint_position
                    .ok_or_else(|| wire::DecodeError::missing(
                        "joint_position",
                        "jointPosition",
                    ))?,
            })
        }
    }
    proto::__object_impls!(StartTorqSensorPayloadIdentify);
    impl check::Validate for StartTorqSensorPayloadIdentify {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("joint_position", &self.joint_position, &check::Limits::NONE)?;
            Ok(())
        }
    }
    impl proto::Command for StartTorqSensorPayloadIdentify {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
                "start_torq_sensor_payload_identify",
                "{\"cmdName\":\"start_torq_sensor_payload_identify\"",
                "4.66",
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
    /// Reads how far the identification of the payload is.
    ///
    /// Sends `get_torq_sensor_identify_staus` (4.67). Changes nothing on the robot.
    ///
    /// # Errata
    ///
    /// - The wire spells the name `staus`.
    #[doc(alias = "get_torq_sensor_identify_staus")]
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct GetTorqSensorIdentifyStatus;
    impl wire::Fields for GetTorqSensorIdentifyStatus {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(GetTorqSensorIdentifyStatus);
    impl check::Validate for GetTorqSensorIdentifyStatus {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for GetTorqSensorIdentifyStatus {
        type Reply = GetTorqSensorIdentifyStatusReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "get_torq_sensor_identify_staus",
            "{\"cmdName\":\"get_torq_sensor_identify_staus\"",
            "4.67",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`GetTorqSensorIdentifyStatus`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct GetTorqSensorIdentifyStatusReply {
        /// How far the identification is.
        ///
        /// `identify_status` on the wire.
        #[doc(alias = "identify_status")]
        pub status: IdentifyStatus,
    }
    impl wire::Fields for GetTorqSensorIdentifyStatusReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"identify_status\":");
            wire::Encode::encode(&self.status, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut status = None;
            let mut keys = reader.begin_fields(&["\"identify_status\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("status", &mut status)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                status: status
                    .ok_or_else(|| wire::DecodeError::missing(
                        "status",
                        "identify_status",
                    ))?,
            })
        }
    }
    proto::__object_impls!(GetTorqSensorIdentifyStatusReply);
    /// Reads the payload that the identification found.
    ///
    /// Of use only once `get_torq_sensor_identify_status` says that the identification is done.
    ///
    /// Sends `get_torq_sensor_payload_identify_result` (4.68). Changes nothing on the robot.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct GetTorqSensorPayloadIdentifyResult;
    impl wire::Fields for GetTorqSensorPayloadIdentifyResult {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(GetTorqSensorPayloadIdentifyResult);
    impl check::Validate for GetTorqSensorPayloadIdentifyResult {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for GetTorqSensorPayloadIdentifyResult {
        type Reply = GetTorqSensorPayloadIdentifyResultReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "get_torq_sensor_payload_identify_result",
            "{\"cmdName\":\"get_torq_sensor_payload_identify_result\"",
            "4.68",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`GetTorqSensorPayloadIdentifyResult`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct GetTorqSensorPayloadIdentifyResultReply {
        /// Centroid of the payload.
        pub centroid: super::payload::Centroid,
        /// Mass of the payload. In kg.
        pub mass: f64,
    }
    impl wire::Fields for GetTorqSensorPayloadIdentifyResultReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"centroid\":");
            wire::Encode::encode(&self.centroid, out);
            out.raw(",\"mass\":");
            wire::Encode::encode(&self.mass, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut centroid = None;
            let mut mass = None;
            let mut keys = reader.begin_fields(&["\"centroid\":", "\"mass\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("centroid", &mut centroid)?,
                    1 => reader.field("mass", &mut mass)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                centroid: centroid
                    .ok_or_else(|| wire::DecodeError::missing("centroid", "centroid"))?,
                mass: mass.ok_or_else(|| wire::DecodeError::missing("mass", "mass"))?,
            })
        }
    }
    proto::__object_impls!(GetTorqSensorPayloadIdentifyResultReply);
    /// Sets the mass and the centroid of the payload at the torque sensor.
    ///
    /// This is not the payload of the arm: that is `set_payload`.
    ///
    /// Sends `set_tool_payload` (4.69).
    ///
    /// # Errata
    ///
    /// - The document's worked example prints the `cmdName` `set_payload`, which is another command (4.42).
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct SetToolPayload {
        /// Mass of the payload. In kg, at least 0.
        pub mass: f64,
        /// Centroid of the payload.
        pub centroid: super::payload::Centroid,
    }
    impl wire::Fields for SetToolPayload {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"mass\":");
            wire::Encode::encode(&self.mass, out);
            out.raw(",\"centroid\":");
            wire::Encode::encode(&self.centroid, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut mass = None;
            let mut centroid = None;
            let mut keys = reader.begin_fields(&["\"mass\":", "\"centroid\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("mass", &mut mass)?,
                    1 => reader.field("centroid", &mut centroid)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                mass: mass.ok_or_else(|| wire::DecodeError::missing("mass", "mass"))?,
                centroid: centroid
                    .ok_or_else(|| wire::DecodeError::missing("centroid", "centroid"))?,
            })
        }
    }
    proto::__object_impls!(SetToolPayload);
    impl check::Validate for SetToolPayload {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place
                .check(
                    "mass",
                    &self.mass,
                    &check::Limits {
                        min: Some(0f64),
                        unit: "kg",
                        ..check::Limits::NONE
                    },
                )?;
            place.check("centroid", &self.centroid, &check::Limits::NONE)?;
            Ok(())
        }
    }
    impl proto::Command for SetToolPayload {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "set_tool_payload",
            "{\"cmdName\":\"set_tool_payload\"",
            "4.69",
            proto::Effect::Setting,
        );
    }
    /// Reads the mass and the centroid of the payload at the torque sensor.
    ///
    /// This is not the payload of the arm: that is `get_payload`.
    ///
    /// Sends `get_tool_payload` (4.70). Changes nothing on the robot.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct GetToolPayload;
    impl wire::Fields for GetToolPayload {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(GetToolPayload);
    impl check::Validate for GetToolPayload {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for GetToolPayload {
        type Reply = GetToolPayloadReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "get_tool_payload",
            "{\"cmdName\":\"get_tool_payload\"",
            "4.70",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`GetToolPayload`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct GetToolPayloadReply {
        /// Centroid of the payload.
        pub centroid: super::payload::Centroid,
        /// Mass of the payload. In kg.
        pub mass: f64,
    }
    impl wire::Fields for GetToolPayloadReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"centroid\":");
            wire::Encode::encode(&self.centroid, out);
            out.raw(",\"mass\":");
            wire::Encode::encode(&self.mass, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut centroid = None;
            let mut mass = None;
            let mut keys = reader.begin_fields(&["\"centroid\":", "\"mass\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("centroid", &mut centroid)?,
                    1 => reader.field("mass", &mut mass)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                centroid: centroid
                    .ok_or_else(|| wire::DecodeError::missing("centroid", "centroid"))?,
                mass: mass.ok_or_else(|| wire::DecodeError::missing("mass", "mass"))?,
            })
        }
    }
    proto::__object_impls!(GetToolPayloadReply);
    /// Sets the forces and torques that are the condition for compliant control.
    ///
    /// The document does not say what happens when they are reached.
    ///
    /// Sends `set_compliance_condition` (4.71).
    ///
    /// # Errata
    ///
    /// - The heading speaks of a torque condition, the text of force components and torque components.
    /// - The text names only `fx` and `tx` of the six values, and prints no order.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct SetComplianceCondition {
        /// Force along, and torque about, each of the axes x, y and z, at the force sensor. Units not stated.
        ///
        /// The document names `fx`, the force along x, and `tx`, the torque about x, and prints no order. Forces before torques,
        /// so fx, fy, fz, tx, ty, tz, is the usual one: confirm it on the robot.
        ///
        /// `compliant_condition` on the wire.
        #[doc(alias = "compliant_condition")]
        pub condition: [f64; 6],
    }
    impl wire::Fields for SetComplianceCondition {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"compliant_condition\":");
            wire::Encode::encode(&self.condition, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut condition = None;
            let mut keys = reader.begin_fields(&["\"compliant_condition\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("condition", &mut condition)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                condition: condition
                    .ok_or_else(|| wire::DecodeError::missing(
                        "condition",
                        "compliant_condition",
                    ))?,
            })
        }
    }
    proto::__object_impls!(SetComplianceCondition);
    impl check::Validate for SetComplianceCondition {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("condition", &self.condition, &check::Limits::NONE)?;
            Ok(())
        }
    }
    impl proto::Command for SetComplianceCondition {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "set_compliance_condition",
            "{\"cmdName\":\"set_compliance_condition\"",
            "4.71",
            proto::Effect::Setting,
        );
    }
    /// Switches admittance control on or off.
    ///
    /// While it is on, the arm may move with the forces that its sensor reads. `set_admit_ctrl_config` sets the axes.
    ///
    /// Sends `enable_admittance_ctrl` (4.72).
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct EnableAdmittanceCtrl {
        /// Whether admittance control is on.
        pub enable_flag: super::types::Switch,
    }
    impl wire::Fields for EnableAdmittanceCtrl {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"enable_flag\":");
            wire::Encode::encode(&self.enable_flag, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut enable_flag = None;
            let mut keys = reader.begin_fields(&["\"enable_flag\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("enable_flag", &mut enable_flag)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                enable_flag: enable_flag
                    .ok_or_else(|| wire::DecodeError::missing(
                        "enable_flag",
                        "enable_flag",
                    ))?,
            })
        }
    }
    proto::__object_impls!(EnableAdmittanceCtrl);
    impl check::Validate for EnableAdmittanceCtrl {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("enable_flag", &self.enable_flag, &check::Limits::NONE)?;
            Ok(())
        }
    }
    impl proto::Command for EnableAdmittanceCtrl {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "enable_admittance_ctrl",
            "{\"cmdName\":\"enable_admittance_ctrl\"",
            "4.72",
            proto::Effect::Setting,
        );
    }
    /// Reads the type of force control, and whether the sensor is compensated.
    ///
    /// Sends `get_compliant_type` (4.73). Changes nothing on the robot.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct GetCompliantType;
    impl wire::Fields for GetCompliantType {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(GetCompliantType);
    impl check::Validate for GetCompliantType {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for GetCompliantType {
        type Reply = GetCompliantTypeReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "get_compliant_type",
            "{\"cmdName\":\"get_compliant_type\"",
            "4.73",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`GetCompliantType`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct GetCompliantTypeReply {
        /// Type of force control.
        pub compliance_type: ComplianceType,
        /// Whether sensor compensation is on, which initialises the sensor.
        pub sensor_compensation: bool,
    }
    impl wire::Fields for GetCompliantTypeReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"compliance_type\":");
            wire::Encode::encode(&self.compliance_type, out);
            out.raw(",\"sensor_compensation\":");
            out.choose(*&self.sensor_compensation, "0", "1");
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut compliance_type = None;
            let mut sensor_compensation = None;
            let mut keys = reader
                .begin_fields(&["\"compliance_type\":", "\"sensor_compensation\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("compliance_type", &mut compliance_type)?,
                    1 => reader.field("sensor_compensation", &mut sensor_compensation)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                compliance_type: compliance_type
                    .ok_or_else(|| wire::DecodeError::missing(
                        "compliance_type",
                        "compliance_type",
                    ))?,
                sensor_compensation: sensor_compensation
                    .ok_or_else(|| wire::DecodeError::missing(
                        "sensor_compensation",
                        "sensor_compensation",
                    ))?,
            })
        }
    }
    proto::__object_impls!(GetCompliantTypeReply);
    /// Sets the type of force control, and whether the sensor is compensated.
    ///
    /// Sends `set_compliant_type` (4.74).
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct SetCompliantType {
        /// Whether sensor compensation is on, which initialises the sensor.
        pub sensor_compensation: super::types::Switch,
        /// Type of force control.
        pub compliance_type: ComplianceType,
    }
    impl wire::Fields for SetCompliantType {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"sensor_compensation\":");
            wire::Encode::encode(&self.sensor_compensation, out);
            out.raw(",\"compliance_type\":");
            wire::Encode::encode(&self.compliance_type, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut sensor_compensation = None;
            let mut compliance_type = None;
            let mut keys = reader
                .begin_fields(&["\"sensor_compensation\":", "\"compliance_type\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("sensor_compensation", &mut sensor_compensation)?,
                    1 => reader.field("compliance_type", &mut compliance_type)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                sensor_compensation: sensor_compensation
                    .ok_or_else(|| wire::DecodeError::missing(
                        "sensor_compensation",
                        "sensor_compensation",
                    ))?,
                compliance_type: compliance_type
                    .ok_or_else(|| wire::DecodeError::missing(
                        "compliance_type",
                        "compliance_type",
                    ))?,
            })
        }
    }
    proto::__object_impls!(SetCompliantType);
    impl check::Validate for SetCompliantType {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place
                .check(
                    "sensor_compensation",
                    &self.sensor_compensation,
                    &check::Limits::NONE,
                )?;
            place.check("compliance_type", &self.compliance_type, &check::Limits::NONE)?;
            Ok(())
        }
    }
    impl proto::Command for SetCompliantType {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "set_compliant_type",
            "{\"cmdName\":\"set_compliant_type\"",
            "4.74",
            proto::Effect::Setting,
        );
    }
    /// Sets how the controller reaches the torque sensor.
    ///
    /// The document does not say what to send as address and port for RS485.
    ///
    /// Sends `set_torque_sensor_comm` (4.76).
    ///
    /// # Errata
    ///
    /// - The document's heading speaks of the IP address alone; the command sets the type and the port too.
    #[derive(Debug, Clone, PartialEq)]
    pub struct SetTorqueSensorComm {
        /// Protocol to reach the sensor by.
        ///
        /// `type` on the wire.
        #[doc(alias = "type")]
        pub communication: TorqueSensorCommunication,
        /// IP address of the sensor.
        ///
        /// `ip_addr` on the wire.
        #[doc(alias = "ip_addr")]
        pub address: String,
        /// Port of the sensor, for TCP/IP. 0 to 65535.
        pub port: i64,
    }
    impl wire::Fields for SetTorqueSensorComm {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"type\":");
            wire::Encode::encode(&self.communication, out);
            out.raw(",\"ip_addr\":");
            wire::Encode::encode(&self.address, out);
            out.raw(",\"port\":");
            wire::Encode::encode(&self.port, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut communication = None;
            let mut address = None;
            let mut port = None;
            let mut keys = reader
                .begin_fields(&["\"type\":", "\"ip_addr\":", "\"port\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("communication", &mut communication)?,
                    1 => reader.field("address", &mut address)?,
                    2 => reader.field("port", &mut port)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                communication: communication
                    .ok_or_else(|| wire::DecodeError::missing("communication", "type"))?,
                address: address
                    .ok_or_else(|| wire::DecodeError::missing("address", "ip_addr"))?,
                port: port.ok_or_else(|| wire::DecodeError::missing("port", "port"))?,
            })
        }
    }
    proto::__object_impls!(SetTorqueSensorComm);
    impl check::Validate for SetTorqueSensorComm {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("communication", &self.communication, &check::Limits::NONE)?;
            place.check("address", &self.address, &check::Limits::NONE)?;
            place
                .check(
                    "port",
                    &self.port,
                    &check::Limits {
                        min: Some(0f64),
                        max: Some(65535f64),
                        ..check::Limits::NONE
                    },
                )?;
            Ok(())
        }
    }
    impl proto::Command for SetTorqueSensorComm {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "set_torque_sensor_comm",
            "{\"cmdName\":\"set_torque_sensor_comm\"",
            "4.76",
            proto::Effect::Setting,
        );
    }
    /// Reads how the controller reaches the torque sensor.
    ///
    /// Sends `get_torque_sensor_comm` (4.77). Changes nothing on the robot.
    ///
    /// # Errata
    ///
    /// - The document's heading speaks of the IP address alone; the reply holds the type and the port too.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct GetTorqueSensorComm;
    impl wire::Fields for GetTorqueSensorComm {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(GetTorqueSensorComm);
    impl check::Validate for GetTorqueSensorComm {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for GetTorqueSensorComm {
        type Reply = GetTorqueSensorCommReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "get_torque_sensor_comm",
            "{\"cmdName\":\"get_torque_sensor_comm\"",
            "4.77",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`GetTorqueSensorComm`].
    #[derive(Debug, Clone, PartialEq)]
    pub struct GetTorqueSensorCommReply {
        /// IP address of the sensor.
        ///
        /// `ip_addr` on the wire.
        #[doc(alias = "ip_addr")]
        pub address: String,
        /// Protocol by which the sensor is reached.
        ///
        /// `type` on the wire.
        #[doc(alias = "type")]
        pub communication: TorqueSensorCommunication,
        /// Port of the sensor, for TCP/IP.
        pub port: i64,
    }
    impl wire::Fields for GetTorqueSensorCommReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"ip_addr\":");
            wire::Encode::encode(&self.address, out);
            out.raw(",\"type\":");
            wire::Encode::encode(&self.communication, out);
            out.raw(",\"port\":");
            wire::Encode::encode(&self.port, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut address = None;
            let mut communication = None;
            let mut port = None;
            let mut keys = reader
                .begin_fields(&["\"ip_addr\":", "\"type\":", "\"port\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("address", &mut address)?,
                    1 => reader.field("communication", &mut communication)?,
                    2 => reader.field("port", &mut port)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                address: address
                    .ok_or_else(|| wire::DecodeError::missing("address", "ip_addr"))?,
                communication: communication
                    .ok_or_else(|| wire::DecodeError::missing("communication", "type"))?,
                port: port.ok_or_else(|| wire::DecodeError::missing("port", "port"))?,
            })
        }
    }
    proto::__object_impls!(GetTorqueSensorCommReply);
    /// Switches force control off.
    ///
    /// The document's heading calls it torque control. It does not say whether drag mode ends too.
    ///
    /// Sends `disable_force_control` (4.78).
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct DisableForceControl;
    impl wire::Fields for DisableForceControl {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(DisableForceControl);
    impl check::Validate for DisableForceControl {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for DisableForceControl {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "disable_force_control",
            "{\"cmdName\":\"disable_force_control\"",
            "4.78",
            proto::Effect::Setting,
        );
    }
    /// Sets the parameters of compliance in velocity.
    ///
    /// Sends `set_vel_compliant_ctrl` (4.79).
    #[derive(Debug, Clone, Copy, PartialEq)]
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
    /// Brand of a torque sensor.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum TorqueSensorBrand {
        /// Sony. `1` on the wire.
        Sony,
        /// Bosch Sensortec. `2` on the wire.
        BoschSensortec,
        /// STMicroelectronics. `3` on the wire.
        StMicroelectronics,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for TorqueSensorBrand {
        fn from(value: i64) -> Self {
            match value {
                1 => Self::Sony,
                2 => Self::BoschSensortec,
                3 => Self::StMicroelectronics,
                other => Self::Other(other),
            }
        }
    }
    impl From<TorqueSensorBrand> for i64 {
        fn from(value: TorqueSensorBrand) -> Self {
            match value {
                TorqueSensorBrand::Sony => 1,
                TorqueSensorBrand::BoschSensortec => 2,
                TorqueSensorBrand::StMicroelectronics => 3,
                TorqueSensorBrand::Other(other) => other,
            }
        }
    }
    proto::__int_enum_impls!(TorqueSensorBrand);
    impl check::Validate for TorqueSensorBrand {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            let standing = match self {
                Self::Sony | Self::BoschSensortec | Self::StMicroelectronics => {
                    check::Standing::Listed
                }
                Self::Other(_) => check::Standing::Unknown,
            };
            place
                .listed(
                    &i64::from(*self),
                    standing,
                    "1 (Sony), 2 (BoschSensortec) or 3 (StMicroelectronics)",
                )
        }
    }
    /// An axis to move along or about.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum CartesianAxis {
        /// Along x. `0` on the wire.
        X,
        /// Along y. `1` on the wire.
        Y,
        /// Along z. `2` on the wire.
        Z,
        /// About x. `3` on the wire.
        Rx,
        /// About y. `4` on the wire.
        Ry,
        /// About z. `5` on the wire.
        Rz,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for CartesianAxis {
        fn from(value: i64) -> Self {
            match value {
                0 => Self::X,
                1 => Self::Y,
                2 => Self::Z,
                3 => Self::Rx,
                4 => Self::Ry,
                5 => Self::Rz,
                other => Self::Other(other),
            }
        }
    }
    impl From<CartesianAxis> for i64 {
        fn from(value: CartesianAxis) -> Self {
            match value {
                CartesianAxis::X => 0,
                CartesianAxis::Y => 1,
                CartesianAxis::Z => 2,
                CartesianAxis::Rx => 3,
                CartesianAxis::Ry => 4,
                CartesianAxis::Rz => 5,
                CartesianAxis::Other(other) => other,
            }
        }
    }
    proto::__int_enum_impls!(CartesianAxis);
    impl check::Validate for CartesianAxis {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            let standing = match self {
                Self::X | Self::Y | Self::Z | Self::Rx | Self::Ry | Self::Rz => {
                    check::Standing::Listed
                }
                Self::Other(_) => check::Standing::Unknown,
            };
            place
                .listed(
                    &i64::from(*self),
                    standing,
                    "0 (X), 1 (Y), 2 (Z), 3 (Rx), 4 (Ry) or 5 (Rz)",
                )
        }
    }
    /// Parameters of admittance control for one axis.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct AdmittanceAxis {
        /// Whether the axis is on.
        pub enabled: bool,
        /// Damping: the force with which a user moves the arm along the axis at its greatest speed. Unit not stated.
        pub user_force: f64,
        /// Rebound: how strongly the arm returns to its initial state. Unit not stated.
        pub rebound: f64,
        /// Constant force. Unit not stated.
        pub constant_force: f64,
        /// Normal tracking. The document does not say which values there are.
        pub normal_track: i64,
    }
    impl wire::Encode for AdmittanceAxis {
        fn encode(&self, out: &mut wire::Writer) {
            out.raw("[");
            out.choose(*&self.enabled, "0", "1");
            out.raw(",");
            wire::Encode::encode(&self.user_force, out);
            out.raw(",");
            wire::Encode::encode(&self.rebound, out);
            out.raw(",");
            wire::Encode::encode(&self.constant_force, out);
            out.raw(",");
            wire::Encode::encode(&self.normal_track, out);
            out.raw("]");
        }
    }
    impl wire::Decode for AdmittanceAxis {
        fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
            reader.begin_array()?;
            let this = Self {
                enabled: reader.element("enabled")?,
                user_force: reader.element("user_force")?,
                rebound: reader.element("rebound")?,
                constant_force: reader.element("constant_force")?,
                normal_track: reader.element("normal_track")?,
            };
            reader.end_array()?;
            Ok(this)
        }
    }
    proto::__serde_impls!(AdmittanceAxis);
    impl check::Validate for AdmittanceAxis {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("enabled", &self.enabled, &check::Limits::NONE)?;
            place.check("user_force", &self.user_force, &check::Limits::NONE)?;
            place.check("rebound", &self.rebound, &check::Limits::NONE)?;
            place.check("constant_force", &self.constant_force, &check::Limits::NONE)?;
            place.check("normal_track", &self.normal_track, &check::Limits::NONE)?;
            Ok(())
        }
    }
    /// How far the identification of a payload is.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum IdentifyStatus {
        /// The identification is done. `0` on the wire.
        Done,
        /// The identification is not done. `1` on the wire.
        NotDone,
        /// The identification failed. `2` on the wire.
        Failed,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for IdentifyStatus {
        fn from(value: i64) -> Self {
            match value {
                0 => Self::Done,
                1 => Self::NotDone,
                2 => Self::Failed,
                other => Self::Other(other),
            }
        }
    }
    impl From<IdentifyStatus> for i64 {
        fn from(value: IdentifyStatus) -> Self {
            match value {
                IdentifyStatus::Done => 0,
                IdentifyStatus::NotDone => 1,
                IdentifyStatus::Failed => 2,
                IdentifyStatus::Other(other) => other,
            }
        }
    }
    proto::__int_enum_impls!(IdentifyStatus);
    impl check::Validate for IdentifyStatus {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            let standing = match self {
                Self::Done | Self::NotDone | Self::Failed => check::Standing::Listed,
                Self::Other(_) => check::Standing::Unknown,
            };
            place
                .listed(
                    &i64::from(*self),
                    standing,
                    "0 (Done), 1 (NotDone) or 2 (Failed)",
                )
        }
    }
    /// Type of force control.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum ComplianceType {
        /// No compliant control. `0` on the wire.
        Off,
        /// Compliance at constant force. `1` on the wire.
        ConstantForce,
        /// Compliance in velocity. `2` on the wire.
        Velocity,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for ComplianceType {
        fn from(value: i64) -> Self {
            match value {
                0 => Self::Off,
                1 => Self::ConstantForce,
                2 => Self::Velocity,
                other => Self::Other(other),
            }
        }
    }
    impl From<ComplianceType> for i64 {
        fn from(value: ComplianceType) -> Self {
            match value {
                ComplianceType::Off => 0,
                ComplianceType::ConstantForce => 1,
                ComplianceType::Velocity => 2,
                ComplianceType::Other(other) => other,
            }
        }
    }
    proto::__int_enum_impls!(ComplianceType);
    impl check::Validate for ComplianceType {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            let standing = match self {
                Self::Off | Self::ConstantForce | Self::Velocity => {
                    check::Standing::Listed
                }
                Self::Other(_) => check::Standing::Unknown,
            };
            place
                .listed(
                    &i64::from(*self),
                    standing,
                    "0 (Off), 1 (ConstantForce) or 2 (Velocity)",
                )
        }
    }
    /// How the controller reaches the torque sensor.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum TorqueSensorCommunication {
        /// By TCP/IP. `0` on the wire.
        TcpIp,
        /// By RS485. `1` on the wire.
        Rs485,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for TorqueSensorCommunication {
        fn from(value: i64) -> Self {
            match value {
                0 => Self::TcpIp,
                1 => Self::Rs485,
                other => Self::Other(other),
            }
        }
    }
    impl From<TorqueSensorCommunication> for i64 {
        fn from(value: TorqueSensorCommunication) -> Self {
            match value {
                TorqueSensorCommunication::TcpIp => 0,
                TorqueSensorCommunication::Rs485 => 1,
                TorqueSensorCommunication::Other(other) => other,
            }
        }
    }
    proto::__int_enum_impls!(TorqueSensorCommunication);
    impl check::Validate for TorqueSensorCommunication {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            let standing = match self {
                Self::TcpIp | Self::Rs485 => check::Standing::Listed,
                Self::Other(_) => check::Standing::Unknown,
            };
            place.listed(&i64::from(*self), standing, "0 (TcpIp) or 1 (Rs485)")
        }
    }
    /// Parameters of compliance in velocity.
    ///
    /// The document gives neither ranges nor units, and does not say how a level and the four ratios work together.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct VelocityCompliance {
        /// Level of the compliance, `vc_level` in the document.
        pub level: i64,
        /// Ratio of level 1.
        pub rate1: f64,
        /// Ratio of level 2.
        pub rate2: f64,
        /// Ratio of level 3.
        pub rate3: f64,
        /// Ratio of level 4.
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
    impl check::Validate for VelocityCompliance {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("level", &self.level, &check::Limits::NONE)?;
            place.check("rate1", &self.rate1, &check::Limits::NONE)?;
            place.check("rate2", &self.rate2, &check::Limits::NONE)?;
            place.check("rate3", &self.rate3, &check::Limits::NONE)?;
            place.check("rate4", &self.rate4, &check::Limits::NONE)?;
            Ok(())
        }
    }
}
