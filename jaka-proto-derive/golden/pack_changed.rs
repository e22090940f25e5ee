/// What newer firmware changes.
///
/// A field more for `joint_move`, a wider range, a settled dispute, a status key and an error code.
#[allow(unreachable_pub)]
pub mod changed {
    #[allow(unused_imports)]
    use ::jaka_sync::proto::{self as proto, check, wire};
    /// Moves all joints to a position, or by an offset, at a joint speed (MoveJ).
    ///
    /// The motion starts when the one before it has ended. To move at once, stop that one first with `stop_program`.
    ///
    /// The reply says that the motion was accepted, not that it has ended.
    ///
    /// Sends `joint_move` (4.7). The robot must be powered, enabled and outside servo mode.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct JointMove {
        /// Whether `joint_position` is a target or an offset.
        ///
        /// `relFlag` on the wire.
        #[doc(alias = "relFlag")]
        pub mode: ::jaka_sync::types::MoveMode,
        /// Target or offset of the six joints.
        ///
        /// `jointPosition` on the wire.
        #[doc(alias = "jointPosition")]
        pub joint_position: ::jaka_sync::types::JointPosition,
        /// Joint speed; the direction comes from `joint_position` alone. In deg/s, at least 0.
        pub speed: f64,
        /// Joint acceleration. In deg/s², at least 0. The document advises 720 at most. Controllers take the command without it (field notes).
        ///
        /// `accel` on the wire.
        #[doc(alias = "accel")]
        pub acceleration: Option<f64>,
        /// Distance from the target at which the next motion may begin. In mm, at least 0.
        ///
        /// Known to firmware 1.7.1 and later.
        pub zone: Option<f64>,
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
            if let Some(value) = &self.zone {
                out.raw(",\"zone\":");
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
            let mut zone = None;
            let mut keys = reader
                .begin_fields(
                    &[
                        "\"relFlag\":",
                        "\"jointPosition\":",
                        "\"speed\":",
                        "\"accel\":",
                        "\"zone\":",
                    ],
                )?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("mode", &mut mode)?,
                    1 => reader.field("joint_position", &mut joint_position)?,
                    2 => reader.field("speed", &mut speed)?,
                    3 => reader.field("acceleration", &mut acceleration)?,
                    4 => reader.field("zone", &mut zone)?,
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
                zone,
            })
        }
    }
    proto::__object_impls!(JointMove);
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
            place
                .check(
                    "zone",
                    &self.zone,
                    &check::Limits {
                        min: Some(0f64),
                        unit: "mm",
                        ..check::Limits::NONE
                    }
                        .since([1, 7, 1]),
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
    /// Sets the rate by which the controller scales the speed of motion.
    ///
    /// The document speaks of the rate at which programs run; whether a motion that is running follows the new rate at once
    /// is not stated.
    ///
    /// Sends `rapid_rate` (4.17).
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct RapidRate {
        /// Rate. 0 to 1.5. The default is 1.
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
                        max: Some(1.5f64),
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
    /// Sets the voltage output of a version 3 tool I/O board.
    ///
    /// The sources contradict each other on both values, and a tool meant for 12 V can be destroyed by 24 V. So both values
    /// stay raw. With no tool connected, measure first which value gives which voltage.
    ///
    /// Sends `set_tio_vout_param` (4.80).
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct SetTioVoutParam {
        /// Raw switch of the voltage output. 0 to 1. The sources contradict each other on which of them is on.
        ///
        /// Sources contradict each other on the meaning, so the value is passed on as it is:
        ///
        /// - document 2.0.4: 0 = enabled, 1 = not enabled
        /// - vendor header, SDK 2.2.2: 0 = off, 1 = on
        ///
        /// `tio_vout_ena` on the wire.
        #[doc(alias = "tio_vout_ena")]
        pub output_enable: i64,
        /// Voltage of the tool's output.
        ///
        /// Settled: Measured at the tool's connector.
        ///
        /// `tio_vout_vol` on the wire.
        #[doc(alias = "tio_vout_vol")]
        pub output_voltage: ToolVoltage,
    }
    impl wire::Fields for SetTioVoutParam {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"tio_vout_ena\":");
            wire::Encode::encode(&self.output_enable, out);
            out.raw(",\"tio_vout_vol\":");
            wire::Encode::encode(&self.output_voltage, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut output_enable = None;
            let mut output_voltage = None;
            let mut keys = reader
                .begin_fields(&["\"tio_vout_ena\":", "\"tio_vout_vol\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("output_enable", &mut output_enable)?,
                    1 => reader.field("output_voltage", &mut output_voltage)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                output_enable: output_enable
                    .ok_or_else(|| wire::DecodeError::missing(
                        "output_enable",
                        "tio_vout_ena",
                    ))?,
                output_voltage: output_voltage
                    .ok_or_else(|| wire::DecodeError::missing(
                        "output_voltage",
                        "tio_vout_vol",
                    ))?,
            })
        }
    }
    proto::__object_impls!(SetTioVoutParam);
    impl check::Validate for SetTioVoutParam {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place
                .check(
                    "output_enable",
                    &self.output_enable,
                    &check::Limits {
                        min: Some(0f64),
                        max: Some(1f64),
                        ..check::Limits::NONE
                    },
                )?;
            place.check("output_voltage", &self.output_voltage, &check::Limits::NONE)?;
            Ok(())
        }
    }
    impl proto::Command for SetTioVoutParam {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "set_tio_vout_param",
            "{\"cmdName\":\"set_tio_vout_param\"",
            "4.80",
            proto::Effect::Setting,
        );
    }
    /// Voltage of the tool's output.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum ToolVoltage {
        /// 24 V. `0` on the wire.
        V24,
        /// 12 V. `1` on the wire.
        V12,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for ToolVoltage {
        fn from(value: i64) -> Self {
            match value {
                0 => Self::V24,
                1 => Self::V12,
                other => Self::Other(other),
            }
        }
    }
    impl From<ToolVoltage> for i64 {
        fn from(value: ToolVoltage) -> Self {
            match value {
                ToolVoltage::V24 => 0,
                ToolVoltage::V12 => 1,
                ToolVoltage::Other(other) => other,
            }
        }
    }
    proto::__int_enum_impls!(ToolVoltage);
    impl check::Validate for ToolVoltage {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            let standing = match self {
                Self::V24 | Self::V12 => check::Standing::Listed,
                Self::Other(_) => check::Standing::Unknown,
            };
            place.listed(&i64::from(*self), standing, "0 (V24) or 1 (V12)")
        }
    }
    /// State of the robot, as one packet of port 10000 gives it.
    ///
    /// Any key may be absent. A refused command on port 10001 does not show here.
    #[derive(Debug, Clone, PartialEq, Default)]
    #[non_exhaustive]
    pub struct RobotStatus {
        /// Length of the packet, itself included. In bytes.
        ///
        /// The document says that packets are at most 5000 bytes as a rule; 9 KB have been seen, and newer firmware is said to send
        /// up to 15 KB (field notes).
        ///
        /// `len` on the wire.
        #[doc(alias = "len")]
        pub length: Option<i64>,
        /// Whether the robot is in drag mode.
        pub drag_status: Option<bool>,
        /// Configuration and state of the extension I/O modules. Absent on firmware 1.5.14.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub extio: Option<wire::Typed<::jaka_sync::status::ExtioReport>>,
        /// Code of the controller's event, which is not always an error: a hexadecimal number such as `0x0`, which says that there is none.
        ///
        /// `0x10f0005`, say, is the information that the robot is disabled, and may be of an event that is over. `ControllerEvent` of the
        /// Rust crates reads the code and knows the severity.
        ///
        /// `errcode` on the wire.
        #[doc(alias = "errcode")]
        pub error_code: Option<String>,
        /// Message of the controller for `error_code`.
        ///
        /// `errmsg` on the wire.
        #[doc(alias = "errmsg")]
        pub error_message: Option<String>,
        /// Measurements in the cabinet and the joints, for diagnosis.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub monitor_data: Option<wire::Typed<::jaka_sync::status::MonitorData>>,
        /// Settings and state of the torque sensor.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `torqsensor` on the wire.
        #[doc(alias = "torqsensor")]
        pub torque_sensor: Option<wire::Typed<::jaka_sync::status::TorqueSensorReport>>,
        /// Actual positions of the six joints.
        pub joint_actual_position: Option<::jaka_sync::types::JointPosition>,
        /// Actual pose of the tool centre point in Cartesian space.
        pub actual_position: Option<::jaka_sync::types::Pose>,
        /// All digital inputs. 135, 136, 144 or 200, depending on the firmware.
        ///
        /// `din` on the wire.
        #[doc(alias = "din")]
        pub digital_inputs: Option<Vec<bool>>,
        /// All digital outputs of the cabinet. The document prints 144.
        ///
        /// `dout` on the wire.
        #[doc(alias = "dout")]
        pub digital_outputs: Option<Vec<bool>>,
        /// All analog inputs of the cabinet. 64, 66 or 128, depending on the firmware. Unit not stated.
        ///
        /// `ain` on the wire.
        #[doc(alias = "ain")]
        pub analog_inputs: Option<Vec<f64>>,
        /// All analog outputs of the cabinet. The document prints 66. Unit not stated.
        ///
        /// `aout` on the wire.
        #[doc(alias = "aout")]
        pub analog_outputs: Option<Vec<f64>>,
        /// All digital inputs of the tool. The document prints 8.
        ///
        /// `tio_din` on the wire.
        #[doc(alias = "tio_din")]
        pub tool_digital_inputs: Option<Vec<bool>>,
        /// All digital outputs of the tool. The document prints 8.
        ///
        /// `tio_dout` on the wire.
        #[doc(alias = "tio_dout")]
        pub tool_digital_outputs: Option<Vec<bool>>,
        /// All analog inputs of the tool. 1 or 2, depending on the firmware. Unit not stated.
        ///
        /// `tio_ain` on the wire.
        #[doc(alias = "tio_ain")]
        pub tool_analog_inputs: Option<Vec<f64>>,
        /// Whether the robot has power and is enabled.
        pub task_state: Option<::jaka_sync::status::TaskState>,
        /// Whether each joint is homed. Withdrawn.
        ///
        /// The document prints the length 9 and no element.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub homed: Option<wire::Typed<Vec<bool>>>,
        /// Task mode of the robot.
        pub task_mode: Option<::jaka_sync::status::TaskMode>,
        /// State of the program.
        ///
        /// `interp_state` on the wire.
        #[doc(alias = "interp_state")]
        pub interpreter_state: Option<::jaka_sync::status::InterpreterState>,
        /// Whether the robot is enabled.
        pub enabled: Option<bool>,
        /// Whether the program is paused.
        pub paused: Option<bool>,
        /// Rate by which motions are scaled; 1 in the document's sample.
        ///
        /// `rapidrate` on the wire.
        #[doc(alias = "rapidrate")]
        pub rapid_rate: Option<f64>,
        /// Index of the present tool frame.
        pub current_tool_id: Option<i64>,
        /// Index of the present user frame.
        ///
        /// `current_user_id` on the wire.
        #[doc(alias = "current_user_id")]
        pub current_user_frame_id: Option<i64>,
        /// Whether a soft limit is reached, by the key's name; passed on as it is.
        ///
        /// The document does not explain it, and prints 1 in its sample, for a robot that is enabled and in position.
        pub on_soft_limit: Option<i64>,
        /// Whether the robot is in an emergency stop, by the key's name. The document does not explain it.
        pub emergency_stop: Option<bool>,
        /// Not explained. The document prints the length 6 and no element.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub drag_near_limit: Option<wire::Typed<Vec<i64>>>,
        /// The input of each function.
        ///
        /// The document prints only the length, 15; 12 and 13 have been seen too. `get_funcdi_status` names the
        /// functions, and the shape of an entry is taken from there.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `funcdi` on the wire.
        #[doc(alias = "funcdi")]
        pub function_inputs: Option<wire::Typed<Vec<::jaka_sync::io::FunctionInput>>>,
        /// Whether the robot has power, by the key's name. The document does not explain it.
        pub powered_on: Option<bool>,
        /// Whether the robot is in position, by the key's name. The document does not explain it.
        ///
        /// It stays true for some 100 ms after a motion is accepted, and a motion of length zero may never drop it (field notes).
        ///
        /// `inpos` on the wire.
        #[doc(alias = "inpos")]
        pub in_position: Option<bool>,
        /// Not explained. The document prints 1.
        pub motion_mode: Option<i64>,
        /// Speed of the tool centre point's translation, by the key's name. In mm/s. The document does not explain it.
        ///
        /// `curr_tcp_trans_vel` on the wire.
        #[doc(alias = "curr_tcp_trans_vel")]
        pub tcp_speed: Option<f64>,
        /// Whether the robot is in a protective stop, by the key's name. The document does not explain it here.
        ///
        /// `protective_stop_status` reads the key of the same name.
        pub protective_stop: Option<bool>,
        /// Not explained. The document prints 0.
        pub point_key: Option<i64>,
        /// Not explained. The document prints 1.
        ///
        /// `netState` on the wire.
        #[doc(alias = "netState")]
        pub network_state: Option<i64>,
        /// Commanded positions of the six joints. Sent by newer firmware.
        ///
        /// `joint_position` on the wire.
        #[doc(alias = "joint_position")]
        pub joint_commanded_position: Option<::jaka_sync::types::JointPosition>,
        /// Commanded pose of the tool centre point. Sent by newer firmware.
        ///
        /// `position` on the wire.
        #[doc(alias = "position")]
        pub commanded_position: Option<::jaka_sync::types::Pose>,
        /// Keys at the tool, by the name; 3 of them. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `tio_key` on the wire.
        #[doc(alias = "tio_key")]
        pub tool_keys: Option<wire::Typed<Vec<i64>>>,
        /// Instantaneous velocities, by the name; 6 of them. Sent by newer firmware, not explained. Unit not stated.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `instVel` on the wire.
        #[doc(alias = "instVel")]
        pub instantaneous_velocities: Option<wire::Typed<Vec<f64>>>,
        /// Relays, by the name; 2 of them. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `relay_io` on the wire.
        #[doc(alias = "relay_io")]
        pub relay_outputs: Option<wire::Typed<Vec<bool>>>,
        /// Digital inputs of the Modbus slave, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `mb_slave_din` on the wire.
        #[doc(alias = "mb_slave_din")]
        pub modbus_slave_digital_inputs: Option<wire::Typed<Vec<bool>>>,
        /// Digital outputs of the Modbus slave, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `mb_slave_dout` on the wire.
        #[doc(alias = "mb_slave_dout")]
        pub modbus_slave_digital_outputs: Option<wire::Typed<Vec<bool>>>,
        /// Analog inputs of the Modbus slave, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `mb_slave_ain` on the wire.
        #[doc(alias = "mb_slave_ain")]
        pub modbus_slave_analog_inputs: Option<wire::Typed<Vec<f64>>>,
        /// Analog outputs of the Modbus slave, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `mb_slave_aout` on the wire.
        #[doc(alias = "mb_slave_aout")]
        pub modbus_slave_analog_outputs: Option<wire::Typed<Vec<f64>>>,
        /// Digital inputs of the Profinet device, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `pn_dev_din` on the wire.
        #[doc(alias = "pn_dev_din")]
        pub profinet_device_digital_inputs: Option<wire::Typed<Vec<bool>>>,
        /// Digital outputs of the Profinet device, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `pn_dev_dout` on the wire.
        #[doc(alias = "pn_dev_dout")]
        pub profinet_device_digital_outputs: Option<wire::Typed<Vec<bool>>>,
        /// Analog inputs of the Profinet device, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `pn_dev_ain` on the wire.
        #[doc(alias = "pn_dev_ain")]
        pub profinet_device_analog_inputs: Option<wire::Typed<Vec<f64>>>,
        /// Analog outputs of the Profinet device, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `pn_dev_aout` on the wire.
        #[doc(alias = "pn_dev_aout")]
        pub profinet_device_analog_outputs: Option<wire::Typed<Vec<f64>>>,
        /// Digital inputs of the EtherNet/IP adapter, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `eip_adpt_din` on the wire.
        #[doc(alias = "eip_adpt_din")]
        pub ethernet_ip_adapter_digital_inputs: Option<wire::Typed<Vec<bool>>>,
        /// Digital outputs of the EtherNet/IP adapter, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `eip_adpt_dout` on the wire.
        #[doc(alias = "eip_adpt_dout")]
        pub ethernet_ip_adapter_digital_outputs: Option<wire::Typed<Vec<bool>>>,
        /// Analog inputs of the EtherNet/IP adapter, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `eip_adpt_ain` on the wire.
        #[doc(alias = "eip_adpt_ain")]
        pub ethernet_ip_adapter_analog_inputs: Option<wire::Typed<Vec<f64>>>,
        /// Analog outputs of the EtherNet/IP adapter, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `eip_adpt_aout` on the wire.
        #[doc(alias = "eip_adpt_aout")]
        pub ethernet_ip_adapter_analog_outputs: Option<wire::Typed<Vec<f64>>>,
        /// Serial signals at the tool, by the name; 8 of them. Sent by newer firmware; shape not known.
        ///
        /// `tio_rs_signals` on the wire.
        #[doc(alias = "tio_rs_signals")]
        pub tool_rs_signals: Option<wire::Value>,
        /// A line that belongs to a motion, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub motion_line: Option<wire::Typed<i64>>,
        /// A line that belongs to an error, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `err_add_line` on the wire.
        #[doc(alias = "err_add_line")]
        pub error_add_line: Option<wire::Typed<i64>>,
        /// State of the brakes.
        pub brake_state: Option<i64>,
    }
    impl wire::Fields for RobotStatus {
        fn write_fields(&self, out: &mut wire::Writer) {
            if let Some(value) = &self.length {
                out.key("\"len\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.drag_status {
                out.key("\"drag_status\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.extio {
                out.key("\"extio\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.error_code {
                out.key("\"errcode\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.error_message {
                out.key("\"errmsg\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.monitor_data {
                out.key("\"monitor_data\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.torque_sensor {
                out.key("\"torqsensor\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.joint_actual_position {
                out.key("\"joint_actual_position\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.actual_position {
                out.key("\"actual_position\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.digital_inputs {
                out.key("\"din\":");
                out.array(
                    value,
                    |out, item| {
                        out.choose(*item, "0", "1");
                    },
                );
            }
            if let Some(value) = &self.digital_outputs {
                out.key("\"dout\":");
                out.array(
                    value,
                    |out, item| {
                        out.choose(*item, "0", "1");
                    },
                );
            }
            if let Some(value) = &self.analog_inputs {
                out.key("\"ain\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.analog_outputs {
                out.key("\"aout\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.tool_digital_inputs {
                out.key("\"tio_din\":");
                out.array(
                    value,
                    |out, item| {
                        out.choose(*item, "0", "1");
                    },
                );
            }
            if let Some(value) = &self.tool_digital_outputs {
                out.key("\"tio_dout\":");
                out.array(
                    value,
                    |out, item| {
                        out.choose(*item, "0", "1");
                    },
                );
            }
            if let Some(value) = &self.tool_analog_inputs {
                out.key("\"tio_ain\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.task_state {
                out.key("\"task_state\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.homed {
                out.key("\"homed\":");
                match value {
                    wire::Typed::Known(value) => {
                        out.array(
                            value,
                            |out, item| {
                                out.choose(*item, "0", "1");
                            },
                        );
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.task_mode {
                out.key("\"task_mode\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.interpreter_state {
                out.key("\"interp_state\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.enabled {
                out.key("\"enabled\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.paused {
                out.key("\"paused\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.rapid_rate {
                out.key("\"rapidrate\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.current_tool_id {
                out.key("\"current_tool_id\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.current_user_frame_id {
                out.key("\"current_user_id\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.on_soft_limit {
                out.key("\"on_soft_limit\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.emergency_stop {
                out.key("\"emergency_stop\":");
                out.choose(*value, "0", "1");
            }
            if let Some(value) = &self.drag_near_limit {
                out.key("\"drag_near_limit\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.function_inputs {
                out.key("\"funcdi\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.powered_on {
                out.key("\"powered_on\":");
                out.choose(*value, "0", "1");
            }
            if let Some(value) = &self.in_position {
                out.key("\"inpos\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.motion_mode {
                out.key("\"motion_mode\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.tcp_speed {
                out.key("\"curr_tcp_trans_vel\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.protective_stop {
                out.key("\"protective_stop\":");
                out.choose(*value, "0", "1");
            }
            if let Some(value) = &self.point_key {
                out.key("\"point_key\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.network_state {
                out.key("\"netState\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.joint_commanded_position {
                out.key("\"joint_position\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.commanded_position {
                out.key("\"position\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.tool_keys {
                out.key("\"tio_key\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.instantaneous_velocities {
                out.key("\"instVel\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.relay_outputs {
                out.key("\"relay_io\":");
                match value {
                    wire::Typed::Known(value) => {
                        out.array(
                            value,
                            |out, item| {
                                out.choose(*item, "0", "1");
                            },
                        );
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.modbus_slave_digital_inputs {
                out.key("\"mb_slave_din\":");
                match value {
                    wire::Typed::Known(value) => {
                        out.array(
                            value,
                            |out, item| {
                                out.choose(*item, "0", "1");
                            },
                        );
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.modbus_slave_digital_outputs {
                out.key("\"mb_slave_dout\":");
                match value {
                    wire::Typed::Known(value) => {
                        out.array(
                            value,
                            |out, item| {
                                out.choose(*item, "0", "1");
                            },
                        );
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.modbus_slave_analog_inputs {
                out.key("\"mb_slave_ain\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.modbus_slave_analog_outputs {
                out.key("\"mb_slave_aout\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.profinet_device_digital_inputs {
                out.key("\"pn_dev_din\":");
                match value {
                    wire::Typed::Known(value) => {
                        out.array(
                            value,
                            |out, item| {
                                out.choose(*item, "0", "1");
                            },
                        );
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.profinet_device_digital_outputs {
                out.key("\"pn_dev_dout\":");
                match value {
                    wire::Typed::Known(value) => {
                        out.array(
                            value,
                            |out, item| {
                                out.choose(*item, "0", "1");
                            },
                        );
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.profinet_device_analog_inputs {
                out.key("\"pn_dev_ain\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.profinet_device_analog_outputs {
                out.key("\"pn_dev_aout\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.ethernet_ip_adapter_digital_inputs {
                out.key("\"eip_adpt_din\":");
                match value {
                    wire::Typed::Known(value) => {
                        out.array(
                            value,
                            |out, item| {
                                out.choose(*item, "0", "1");
                            },
                        );
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.ethernet_ip_adapter_digital_outputs {
                out.key("\"eip_adpt_dout\":");
                match value {
                    wire::Typed::Known(value) => {
                        out.array(
                            value,
                            |out, item| {
                                out.choose(*item, "0", "1");
                            },
                        );
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.ethernet_ip_adapter_analog_inputs {
                out.key("\"eip_adpt_ain\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.ethernet_ip_adapter_analog_outputs {
                out.key("\"eip_adpt_aout\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.tool_rs_signals {
                out.key("\"tio_rs_signals\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.motion_line {
                out.key("\"motion_line\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.error_add_line {
                out.key("\"err_add_line\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.brake_state {
                out.key("\"brake_state\":");
                wire::Encode::encode(value, out);
            }
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut this = Self::default();
            this.read_fields_into(reader)?;
            Ok(this)
        }
        fn read_fields_into(
            &mut self,
            reader: &mut wire::Reader<'_>,
        ) -> Result<(), wire::DecodeError> {
            let mut keys = reader
                .begin_status(
                    &[
                        "\"len\":",
                        "\"drag_status\":",
                        "\"extio\":",
                        "\"errcode\":",
                        "\"errmsg\":",
                        "\"monitor_data\":",
                        "\"torqsensor\":",
                        "\"joint_actual_position\":",
                        "\"actual_position\":",
                        "\"din\":",
                        "\"dout\":",
                        "\"ain\":",
                        "\"aout\":",
                        "\"tio_din\":",
                        "\"tio_dout\":",
                        "\"tio_ain\":",
                        "\"task_state\":",
                        "\"homed\":",
                        "\"task_mode\":",
                        "\"interp_state\":",
                        "\"enabled\":",
                        "\"paused\":",
                        "\"rapidrate\":",
                        "\"current_tool_id\":",
                        "\"current_user_id\":",
                        "\"on_soft_limit\":",
                        "\"emergency_stop\":",
                        "\"drag_near_limit\":",
                        "\"funcdi\":",
                        "\"powered_on\":",
                        "\"inpos\":",
                        "\"motion_mode\":",
                        "\"curr_tcp_trans_vel\":",
                        "\"protective_stop\":",
                        "\"point_key\":",
                        "\"netState\":",
                        "\"joint_position\":",
                        "\"position\":",
                        "\"tio_key\":",
                        "\"instVel\":",
                        "\"relay_io\":",
                        "\"mb_slave_din\":",
                        "\"mb_slave_dout\":",
                        "\"mb_slave_ain\":",
                        "\"mb_slave_aout\":",
                        "\"pn_dev_din\":",
                        "\"pn_dev_dout\":",
                        "\"pn_dev_ain\":",
                        "\"pn_dev_aout\":",
                        "\"eip_adpt_din\":",
                        "\"eip_adpt_dout\":",
                        "\"eip_adpt_ain\":",
                        "\"eip_adpt_aout\":",
                        "\"tio_rs_signals\":",
                        "\"motion_line\":",
                        "\"err_add_line\":",
                        "\"brake_state\":",
                    ],
                )?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.status_field_into("length", &mut self.length, &mut keys)?,
                    1 => {
                        reader
                            .status_field_into(
                                "drag_status",
                                &mut self.drag_status,
                                &mut keys,
                            )?
                    }
                    2 => reader.status_field_into("extio", &mut self.extio, &mut keys)?,
                    3 => {
                        reader
                            .status_field_into(
                                "error_code",
                                &mut self.error_code,
                                &mut keys,
                            )?
                    }
                    4 => {
                        reader
                            .status_field_into(
                                "error_message",
                                &mut self.error_message,
                                &mut keys,
                            )?
                    }
                    5 => {
                        reader
                            .status_field_into(
                                "monitor_data",
                                &mut self.monitor_data,
                                &mut keys,
                            )?
                    }
                    6 => {
                        reader
                            .status_field_into(
                                "torque_sensor",
                                &mut self.torque_sensor,
                                &mut keys,
                            )?
                    }
                    7 => {
                        reader
                            .status_field_into(
                                "joint_actual_position",
                                &mut self.joint_actual_position,
                                &mut keys,
                            )?
                    }
                    8 => {
                        reader
                            .status_field_into(
                                "actual_position",
                                &mut self.actual_position,
                                &mut keys,
                            )?
                    }
                    9 => {
                        reader
                            .status_field_into(
                                "digital_inputs",
                                &mut self.digital_inputs,
                                &mut keys,
                            )?
                    }
                    10 => {
                        reader
                            .status_field_into(
                                "digital_outputs",
                                &mut self.digital_outputs,
                                &mut keys,
                            )?
                    }
                    11 => {
                        reader
                            .status_field_into(
                                "analog_inputs",
                                &mut self.analog_inputs,
                                &mut keys,
                            )?
                    }
                    12 => {
                        reader
                            .status_field_into(
                                "analog_outputs",
                                &mut self.analog_outputs,
                                &mut keys,
                            )?
                    }
                    13 => {
                        reader
                            .status_field_into(
                                "tool_digital_inputs",
                                &mut self.tool_digital_inputs,
                                &mut keys,
                            )?
                    }
                    14 => {
                        reader
                            .status_field_into(
                                "tool_digital_outputs",
                                &mut self.tool_digital_outputs,
                                &mut keys,
                            )?
                    }
                    15 => {
                        reader
                            .status_field_into(
                                "tool_analog_inputs",
                                &mut self.tool_analog_inputs,
                                &mut keys,
                            )?
                    }
                    16 => {
                        reader
                            .status_field_into(
                                "task_state",
                                &mut self.task_state,
                                &mut keys,
                            )?
                    }
                    17 => reader.status_field_into("homed", &mut self.homed, &mut keys)?,
                    18 => {
                        reader
                            .status_field_into(
                                "task_mode",
                                &mut self.task_mode,
                                &mut keys,
                            )?
                    }
                    19 => {
                        reader
                            .status_field_into(
                                "interpreter_state",
                                &mut self.interpreter_state,
                                &mut keys,
                            )?
                    }
                    20 => {
                        reader
                            .status_field_into("enabled", &mut self.enabled, &mut keys)?
                    }
                    21 => {
                        reader.status_field_into("paused", &mut self.paused, &mut keys)?
                    }
                    22 => {
                        reader
                            .status_field_into(
                                "rapid_rate",
                                &mut self.rapid_rate,
                                &mut keys,
                            )?
                    }
                    23 => {
                        reader
                            .status_field_into(
                                "current_tool_id",
                                &mut self.current_tool_id,
                                &mut keys,
                            )?
                    }
                    24 => {
                        reader
                            .status_field_into(
                                "current_user_frame_id",
                                &mut self.current_user_frame_id,
                                &mut keys,
                            )?
                    }
                    25 => {
                        reader
                            .status_field_into(
                                "on_soft_limit",
                                &mut self.on_soft_limit,
                                &mut keys,
                            )?
                    }
                    26 => {
                        reader
                            .status_field_into(
                                "emergency_stop",
                                &mut self.emergency_stop,
                                &mut keys,
                            )?
                    }
                    27 => {
                        reader
                            .status_field_into(
                                "drag_near_limit",
                                &mut self.drag_near_limit,
                                &mut keys,
                            )?
                    }
                    28 => {
                        reader
                            .status_field_into(
                                "function_inputs",
                                &mut self.function_inputs,
                                &mut keys,
                            )?
                    }
                    29 => {
                        reader
                            .status_field_into(
                                "powered_on",
                                &mut self.powered_on,
                                &mut keys,
                            )?
                    }
                    30 => {
                        reader
                            .status_field_into(
                                "in_position",
                                &mut self.in_position,
                                &mut keys,
                            )?
                    }
                    31 => {
                        reader
                            .status_field_into(
                                "motion_mode",
                                &mut self.motion_mode,
                                &mut keys,
                            )?
                    }
                    32 => {
                        reader
                            .status_field_into(
                                "tcp_speed",
                                &mut self.tcp_speed,
                                &mut keys,
                            )?
                    }
                    33 => {
                        reader
                            .status_field_into(
                                "protective_stop",
                                &mut self.protective_stop,
                                &mut keys,
                            )?
                    }
                    34 => {
                        reader
                            .status_field_into(
                                "point_key",
                                &mut self.point_key,
                                &mut keys,
                            )?
                    }
                    35 => {
                        reader
                            .status_field_into(
                                "network_state",
                                &mut self.network_state,
                                &mut keys,
                            )?
                    }
                    36 => {
                        reader
                            .status_field_into(
                                "joint_commanded_position",
                                &mut self.joint_commanded_position,
                                &mut keys,
                            )?
                    }
                    37 => {
                        reader
                            .status_field_into(
                                "commanded_position",
                                &mut self.commanded_position,
                                &mut keys,
                            )?
                    }
                    38 => {
                        reader
                            .status_field_into(
                                "tool_keys",
                                &mut self.tool_keys,
                                &mut keys,
                            )?
                    }
                    39 => {
                        reader
                            .status_field_into(
                                "instantaneous_velocities",
                                &mut self.instantaneous_velocities,
                                &mut keys,
                            )?
                    }
                    40 => {
                        reader
                            .status_field_into(
                                "relay_outputs",
                                &mut self.relay_outputs,
                                &mut keys,
                            )?
                    }
                    41 => {
                        reader
                            .status_field_into(
                                "modbus_slave_digital_inputs",
                                &mut self.modbus_slave_digital_inputs,
                                &mut keys,
                            )?
                    }
                    42 => {
                        reader
                            .status_field_into(
                                "modbus_slave_digital_outputs",
                                &mut self.modbus_slave_digital_outputs,
                                &mut keys,
                            )?
                    }
                    43 => {
                        reader
                            .status_field_into(
                                "modbus_slave_analog_inputs",
                                &mut self.modbus_slave_analog_inputs,
                                &mut keys,
                            )?
                    }
                    44 => {
                        reader
                            .status_field_into(
                                "modbus_slave_analog_outputs",
                                &mut self.modbus_slave_analog_outputs,
                                &mut keys,
                            )?
                    }
                    45 => {
                        reader
                            .status_field_into(
                                "profinet_device_digital_inputs",
                                &mut self.profinet_device_digital_inputs,
                                &mut keys,
                            )?
                    }
                    46 => {
                        reader
                            .status_field_into(
                                "profinet_device_digital_outputs",
                                &mut self.profinet_device_digital_outputs,
                                &mut keys,
                            )?
                    }
                    47 => {
                        reader
                            .status_field_into(
                                "profinet_device_analog_inputs",
                                &mut self.profinet_device_analog_inputs,
                                &mut keys,
                            )?
                    }
                    48 => {
                        reader
                            .status_field_into(
                                "profinet_device_analog_outputs",
                                &mut self.profinet_device_analog_outputs,
                                &mut keys,
                            )?
                    }
                    49 => {
                        reader
                            .status_field_into(
                                "ethernet_ip_adapter_digital_inputs",
                                &mut self.ethernet_ip_adapter_digital_inputs,
                                &mut keys,
                            )?
                    }
                    50 => {
                        reader
                            .status_field_into(
                                "ethernet_ip_adapter_digital_outputs",
                                &mut self.ethernet_ip_adapter_digital_outputs,
                                &mut keys,
                            )?
                    }
                    51 => {
                        reader
                            .status_field_into(
                                "ethernet_ip_adapter_analog_inputs",
                                &mut self.ethernet_ip_adapter_analog_inputs,
                                &mut keys,
                            )?
                    }
                    52 => {
                        reader
                            .status_field_into(
                                "ethernet_ip_adapter_analog_outputs",
                                &mut self.ethernet_ip_adapter_analog_outputs,
                                &mut keys,
                            )?
                    }
                    53 => {
                        reader
                            .status_field_into(
                                "tool_rs_signals",
                                &mut self.tool_rs_signals,
                                &mut keys,
                            )?
                    }
                    54 => {
                        reader
                            .status_field_into(
                                "motion_line",
                                &mut self.motion_line,
                                &mut keys,
                            )?
                    }
                    55 => {
                        reader
                            .status_field_into(
                                "error_add_line",
                                &mut self.error_add_line,
                                &mut keys,
                            )?
                    }
                    56 => {
                        reader
                            .status_field_into(
                                "brake_state",
                                &mut self.brake_state,
                                &mut keys,
                            )?
                    }
                    _ => reader.skip_unknown(&keys)?,
                }
            }
            keys.absent(0, &mut self.length);
            keys.absent(1, &mut self.drag_status);
            keys.absent(2, &mut self.extio);
            keys.absent(3, &mut self.error_code);
            keys.absent(4, &mut self.error_message);
            keys.absent(5, &mut self.monitor_data);
            keys.absent(6, &mut self.torque_sensor);
            keys.absent(7, &mut self.joint_actual_position);
            keys.absent(8, &mut self.actual_position);
            keys.absent(9, &mut self.digital_inputs);
            keys.absent(10, &mut self.digital_outputs);
            keys.absent(11, &mut self.analog_inputs);
            keys.absent(12, &mut self.analog_outputs);
            keys.absent(13, &mut self.tool_digital_inputs);
            keys.absent(14, &mut self.tool_digital_outputs);
            keys.absent(15, &mut self.tool_analog_inputs);
            keys.absent(16, &mut self.task_state);
            keys.absent(17, &mut self.homed);
            keys.absent(18, &mut self.task_mode);
            keys.absent(19, &mut self.interpreter_state);
            keys.absent(20, &mut self.enabled);
            keys.absent(21, &mut self.paused);
            keys.absent(22, &mut self.rapid_rate);
            keys.absent(23, &mut self.current_tool_id);
            keys.absent(24, &mut self.current_user_frame_id);
            keys.absent(25, &mut self.on_soft_limit);
            keys.absent(26, &mut self.emergency_stop);
            keys.absent(27, &mut self.drag_near_limit);
            keys.absent(28, &mut self.function_inputs);
            keys.absent(29, &mut self.powered_on);
            keys.absent(30, &mut self.in_position);
            keys.absent(31, &mut self.motion_mode);
            keys.absent(32, &mut self.tcp_speed);
            keys.absent(33, &mut self.protective_stop);
            keys.absent(34, &mut self.point_key);
            keys.absent(35, &mut self.network_state);
            keys.absent(36, &mut self.joint_commanded_position);
            keys.absent(37, &mut self.commanded_position);
            keys.absent(38, &mut self.tool_keys);
            keys.absent(39, &mut self.instantaneous_velocities);
            keys.absent(40, &mut self.relay_outputs);
            keys.absent(41, &mut self.modbus_slave_digital_inputs);
            keys.absent(42, &mut self.modbus_slave_digital_outputs);
            keys.absent(43, &mut self.modbus_slave_analog_inputs);
            keys.absent(44, &mut self.modbus_slave_analog_outputs);
            keys.absent(45, &mut self.profinet_device_digital_inputs);
            keys.absent(46, &mut self.profinet_device_digital_outputs);
            keys.absent(47, &mut self.profinet_device_analog_inputs);
            keys.absent(48, &mut self.profinet_device_analog_outputs);
            keys.absent(49, &mut self.ethernet_ip_adapter_digital_inputs);
            keys.absent(50, &mut self.ethernet_ip_adapter_digital_outputs);
            keys.absent(51, &mut self.ethernet_ip_adapter_analog_inputs);
            keys.absent(52, &mut self.ethernet_ip_adapter_analog_outputs);
            keys.absent(53, &mut self.tool_rs_signals);
            keys.absent(54, &mut self.motion_line);
            keys.absent(55, &mut self.error_add_line);
            keys.absent(56, &mut self.brake_state);
            Ok(())
        }
    }
    proto::__object_impls!(RobotStatus, in_place);
    impl check::Validate for RobotStatus {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place
                .check(
                    "length",
                    &self.length,
                    &check::Limits {
                        unit: "bytes",
                        ..check::Limits::NONE
                    },
                )?;
            place.check("drag_status", &self.drag_status, &check::Limits::NONE)?;
            place.check("extio", &self.extio, &check::Limits::NONE)?;
            place.check("error_code", &self.error_code, &check::Limits::NONE)?;
            place.check("error_message", &self.error_message, &check::Limits::NONE)?;
            place.check("monitor_data", &self.monitor_data, &check::Limits::NONE)?;
            place.check("torque_sensor", &self.torque_sensor, &check::Limits::NONE)?;
            place
                .check(
                    "joint_actual_position",
                    &self.joint_actual_position,
                    &check::Limits::NONE,
                )?;
            place.check("actual_position", &self.actual_position, &check::Limits::NONE)?;
            place.check("digital_inputs", &self.digital_inputs, &check::Limits::NONE)?;
            place.check("digital_outputs", &self.digital_outputs, &check::Limits::NONE)?;
            place.check("analog_inputs", &self.analog_inputs, &check::Limits::NONE)?;
            place.check("analog_outputs", &self.analog_outputs, &check::Limits::NONE)?;
            place
                .check(
                    "tool_digital_inputs",
                    &self.tool_digital_inputs,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "tool_digital_outputs",
                    &self.tool_digital_outputs,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "tool_analog_inputs",
                    &self.tool_analog_inputs,
                    &check::Limits::NONE,
                )?;
            place.check("task_state", &self.task_state, &check::Limits::NONE)?;
            place.check("homed", &self.homed, &check::Limits::NONE)?;
            place.check("task_mode", &self.task_mode, &check::Limits::NONE)?;
            place
                .check(
                    "interpreter_state",
                    &self.interpreter_state,
                    &check::Limits::NONE,
                )?;
            place.check("enabled", &self.enabled, &check::Limits::NONE)?;
            place.check("paused", &self.paused, &check::Limits::NONE)?;
            place.check("rapid_rate", &self.rapid_rate, &check::Limits::NONE)?;
            place.check("current_tool_id", &self.current_tool_id, &check::Limits::NONE)?;
            place
                .check(
                    "current_user_frame_id",
                    &self.current_user_frame_id,
                    &check::Limits::NONE,
                )?;
            place.check("on_soft_limit", &self.on_soft_limit, &check::Limits::NONE)?;
            place.check("emergency_stop", &self.emergency_stop, &check::Limits::NONE)?;
            place.check("drag_near_limit", &self.drag_near_limit, &check::Limits::NONE)?;
            place.check("function_inputs", &self.function_inputs, &check::Limits::NONE)?;
            place.check("powered_on", &self.powered_on, &check::Limits::NONE)?;
            place.check("in_position", &self.in_position, &check::Limits::NONE)?;
            place.check("motion_mode", &self.motion_mode, &check::Limits::NONE)?;
            place
                .check(
                    "tcp_speed",
                    &self.tcp_speed,
                    &check::Limits {
                        unit: "mm/s",
                        ..check::Limits::NONE
                    },
                )?;
            place.check("protective_stop", &self.protective_stop, &check::Limits::NONE)?;
            place.check("point_key", &self.point_key, &check::Limits::NONE)?;
            place.check("network_state", &self.network_state, &check::Limits::NONE)?;
            place
                .check(
                    "joint_commanded_position",
                    &self.joint_commanded_position,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "commanded_position",
                    &self.commanded_position,
                    &check::Limits::NONE,
                )?;
            place.check("tool_keys", &self.tool_keys, &check::Limits::NONE)?;
            place
                .check(
                    "instantaneous_velocities",
                    &self.instantaneous_velocities,
                    &check::Limits::NONE,
                )?;
            place.check("relay_outputs", &self.relay_outputs, &check::Limits::NONE)?;
            place
                .check(
                    "modbus_slave_digital_inputs",
                    &self.modbus_slave_digital_inputs,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "modbus_slave_digital_outputs",
                    &self.modbus_slave_digital_outputs,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "modbus_slave_analog_inputs",
                    &self.modbus_slave_analog_inputs,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "modbus_slave_analog_outputs",
                    &self.modbus_slave_analog_outputs,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "profinet_device_digital_inputs",
                    &self.profinet_device_digital_inputs,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "profinet_device_digital_outputs",
                    &self.profinet_device_digital_outputs,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "profinet_device_analog_inputs",
                    &self.profinet_device_analog_inputs,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "profinet_device_analog_outputs",
                    &self.profinet_device_analog_outputs,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "ethernet_ip_adapter_digital_inputs",
                    &self.ethernet_ip_adapter_digital_inputs,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "ethernet_ip_adapter_digital_outputs",
                    &self.ethernet_ip_adapter_digital_outputs,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "ethernet_ip_adapter_analog_inputs",
                    &self.ethernet_ip_adapter_analog_inputs,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "ethernet_ip_adapter_analog_outputs",
                    &self.ethernet_ip_adapter_analog_outputs,
                    &check::Limits::NONE,
                )?;
            place.check("tool_rs_signals", &self.tool_rs_signals, &check::Limits::NONE)?;
            place.check("motion_line", &self.motion_line, &check::Limits::NONE)?;
            place.check("error_add_line", &self.error_add_line, &check::Limits::NONE)?;
            place.check("brake_state", &self.brake_state, &check::Limits::NONE)?;
            Ok(())
        }
    }
    /// The commands of [`changed`](self) as methods: of a client, of a robot, and of all else that takes commands.
    pub trait ChangedCommands: ::jaka_sync::Call {
        /// Moves all joints to a position, or by an offset, at a joint speed (MoveJ).
        ///
        /// The motion starts when the one before it has ended. To move at once, stop that one first with `stop_program`.
        ///
        /// The reply says that the motion was accepted, not that it has ended.
        ///
        /// Sends `joint_move` (4.7). The robot must be powered, enabled and outside servo mode.
        ///
        /// # Errors
        /// As `Call::call`. In another state than the one it needs, expect a refusal.
        fn joint_move_changed(
            &mut self,
            request: &JointMove,
        ) -> Result<(), ::jaka_sync::Error> {
            ::jaka_sync::Call::call(self, request)
        }
        /// Sets the rate by which the controller scales the speed of motion.
        ///
        /// The document speaks of the rate at which programs run; whether a motion that is running follows the new rate at once
        /// is not stated.
        ///
        /// Sends `rapid_rate` (4.17).
        ///
        /// # Errors
        /// As `Call::call`.
        fn rapid_rate_changed(&mut self, rate: f64) -> Result<(), ::jaka_sync::Error> {
            ::jaka_sync::Call::call(self, &RapidRate { rate })
        }
        /// Sets the voltage output of a version 3 tool I/O board.
        ///
        /// The sources contradict each other on both values, and a tool meant for 12 V can be destroyed by 24 V. So both values
        /// stay raw. With no tool connected, measure first which value gives which voltage.
        ///
        /// Sends `set_tio_vout_param` (4.80).
        ///
        /// # Errors
        /// As `Call::call`.
        fn set_tio_vout_param_changed(
            &mut self,
            request: &SetTioVoutParam,
        ) -> Result<(), ::jaka_sync::Error> {
            ::jaka_sync::Call::call(self, request)
        }
    }
    impl<T: ::jaka_sync::Call + ?Sized> ChangedCommands for T {}
    /// The payload is too heavy for the motion.
    pub const OVERLOAD: proto::ErrorCode = proto::ErrorCode(5i64);
    /// What sources say about a code, in a sentence; `None` for a code that neither they nor this module name.
    pub fn meaning(code: proto::ErrorCode) -> Option<&'static str> {
        match code.0 {
            5i64 => Some("The payload is too heavy for the motion."),
            _ => code.meaning(),
        }
    }
}
