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
    /// Reads whether the robot is in servo mode.
    ///
    /// Sends `is_in_servomove` (4.13). Changes nothing on the robot.
    ///
    /// # Errata
    ///
    /// - The text explains `relFlag`, which neither request nor reply has; it belongs to `servo_move` (4.14).
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct IsInServomove;
    impl wire::Fields for IsInServomove {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(IsInServomove);
    impl check::Validate for IsInServomove {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for IsInServomove {
        type Reply = IsInServomoveReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "is_in_servomove",
            "{\"cmdName\":\"is_in_servomove\"",
            "4.13",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`IsInServomove`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct IsInServomoveReply {
        /// Whether the robot is in servo mode.
        ///
        /// `in_servomove` on the wire.
        #[doc(alias = "in_servomove")]
        pub in_servo_mode: bool,
    }
    impl wire::Fields for IsInServomoveReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"in_servomove\":");
            wire::Encode::encode(&self.in_servo_mode, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut in_servo_mode = None;
            let mut keys = reader.begin_fields(&["\"in_servomove\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("in_servo_mode", &mut in_servo_mode)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                in_servo_mode: in_servo_mode
                    .ok_or_else(|| wire::DecodeError::missing(
                        "in_servo_mode",
                        "in_servomove",
                    ))?,
            })
        }
    }
    proto::__object_impls!(IsInServomoveReply);
    /// Enters or leaves servo mode.
    ///
    /// The reply comes at once, before the mode has changed. `servo_j` is refused until `is_in_servomove` says that servo mode
    /// is on.
    ///
    /// Sends `servo_move` (4.14). The robot must be powered and enabled.
    ///
    /// # Errata
    ///
    /// - The key `relFlag` means enter or leave here. In other commands it chooses between target and offset.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct ServoMove {
        /// On to enter servo mode, off to leave it.
        ///
        /// `relFlag` on the wire.
        #[doc(alias = "relFlag")]
        pub servo_mode: super::types::Switch,
    }
    impl wire::Fields for ServoMove {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"relFlag\":");
            wire::Encode::encode(&self.servo_mode, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut servo_mode = None;
            let mut keys = reader.begin_fields(&["\"relFlag\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("servo_mode", &mut servo_mode)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                servo_mode: servo_mode
                    .ok_or_else(|| wire::DecodeError::missing("servo_mode", "relFlag"))?,
            })
        }
    }
    proto::__object_impls!(ServoMove);
    impl check::Validate for ServoMove {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("servo_mode", &self.servo_mode, &check::Limits::NONE)?;
            Ok(())
        }
    }
    impl proto::Command for ServoMove {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
                "servo_move",
                "{\"cmdName\":\"servo_move\"",
                "4.14",
                proto::Effect::Motion,
            )
            .requires(&[proto::Requirement::Powered, proto::Requirement::Enabled]);
    }
    /// Moves all joints to a set-point, or by an offset, within one servo period.
    ///
    /// The planner does not interpolate: set-points must follow one another every 8 ms times `step_count`, and a single one
    /// shows no effect. A set-point that asks more than 180 deg/s of a joint has no effect: the document's example is 1.5
    /// degrees in 8 ms, which is 187.5 deg/s.
    ///
    /// Every set-point is answered. The answers need not be waited for, but must be read. Enter servo mode with `servo_move`
    /// first.
    ///
    /// Sends `servo_j` (4.15). The robot must be powered, enabled and in servo mode.
    ///
    /// # Errata
    ///
    /// - The text writes the key `stepnum`, the sample `stepNum`.
    /// - The text asks for a set-point every 8 ms, and for one every 8 ms times `stepnum`. Field notes: the latter.
    /// - The text calls `joint_move` the fifth command. It is in 4.7.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct ServoJ {
        /// Whether `joint_position` is a target or an offset.
        ///
        /// `relFlag` on the wire.
        #[doc(alias = "relFlag")]
        pub mode: super::types::MoveMode,
        /// Set-point, or offset, of the six joints.
        ///
        /// `jointPosition` on the wire.
        #[doc(alias = "jointPosition")]
        pub joint_position: super::types::JointPosition,
        /// Length of the servo period as a multiple of the controller cycle of 8 ms. At least 1. Controllers take the command without it (field
        /// notes).
        ///
        /// `stepNum` on the wire.
        #[doc(alias = "stepNum")]
        pub step_count: Option<i64>,
    }
    impl wire::Fields for ServoJ {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"relFlag\":");
            wire::Encode::encode(&self.mode, out);
            out.raw(",\"jointPosition\":");
            wire::Encode::encode(&self.joint_position, out);
            if let Some(value) = &self.step_count {
                out.raw(",\"stepNum\":");
                wire::Encode::encode(value, out);
            }
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut mode = None;
            let mut joint_position = None;
            let mut step_count = None;
            let mut keys = reader
                .begin_fields(&["\"relFlag\":", "\"jointPosition\":", "\"stepNum\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("mode", &mut mode)?,
                    1 => reader.field("joint_position", &mut joint_position)?,
                    2 => reader.field("step_count", &mut step_count)?,
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
                step_count,
            })
        }
    }
    proto::__object_impls!(ServoJ);
    impl check::Validate for ServoJ {
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
                    "step_count",
                    &self.step_count,
                    &check::Limits {
                        min: Some(1f64),
                        ..check::Limits::NONE
                    },
                )?;
            Ok(())
        }
    }
    impl proto::Command for ServoJ {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
                "servo_j",
                "{\"cmdName\":\"servo_j\"",
                "4.15",
                proto::Effect::Motion,
            )
            .requires(
                &[
                    proto::Requirement::Powered,
                    proto::Requirement::Enabled,
                    proto::Requirement::ServoMode,
                ],
            );
    }
    /// Moves the tool centre point to a set-point, or by an offset, within one servo period.
    ///
    /// The planner does not interpolate: set-points must follow one another every 8 ms times `step_count`. Keep the steps
    /// between them small, so that the controller's speed limits are not exceeded; the document names no number.
    ///
    /// Every set-point is answered. The answers need not be waited for, but must be read. Enter servo mode with `servo_move`
    /// first.
    ///
    /// Sends `servo_p` (4.16). The robot must be powered, enabled and in servo mode.
    ///
    /// # Errata
    ///
    /// - The key is spelled `catPosition`, and controllers expect it so. Other commands have `cartPosition`.
    /// - The text writes the key `stepnum`, the sample `stepNum`.
    /// - The text asks for a set-point every 8 ms, and for one every 8 ms times `stepnum`. Field notes: the latter.
    /// - The text speaks of points of the six joints and of `servo_j`, as copied from 4.15. The set-point is a pose.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct ServoP {
        /// Set-point, or offset, of the tool centre point.
        ///
        /// `catPosition` on the wire.
        #[doc(alias = "catPosition")]
        pub pose: super::types::Pose,
        /// Whether `pose` is a target or an offset.
        ///
        /// `relFlag` on the wire.
        #[doc(alias = "relFlag")]
        pub mode: super::types::MoveMode,
        /// Length of the servo period as a multiple of the controller cycle of 8 ms. At least 1. Controllers take the command without it (field
        /// notes).
        ///
        /// `stepNum` on the wire.
        #[doc(alias = "stepNum")]
        pub step_count: Option<i64>,
    }
    impl wire::Fields for ServoP {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"catPosition\":");
            wire::Encode::encode(&self.pose, out);
            out.raw(",\"relFlag\":");
            wire::Encode::encode(&self.mode, out);
            if let Some(value) = &self.step_count {
                out.raw(",\"stepNum\":");
                wire::Encode::encode(value, out);
            }
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut pose = None;
            let mut mode = None;
            let mut step_count = None;
            let mut keys = reader
                .begin_fields(&["\"catPosition\":", "\"relFlag\":", "\"stepNum\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("pose", &mut pose)?,
                    1 => reader.field("mode", &mut mode)?,
                    2 => reader.field("step_count", &mut step_count)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                pose: pose
                    .ok_or_else(|| wire::DecodeError::missing("pose", "catPosition"))?,
                mode: mode.ok_or_else(|| wire::DecodeError::missing("mode", "relFlag"))?,
                step_count,
            })
        }
    }
    proto::__object_impls!(ServoP);
    impl check::Validate for ServoP {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("pose", &self.pose, &check::Limits::NONE)?;
            place.check("mode", &self.mode, &check::Limits::NONE)?;
            place
                .check(
                    "step_count",
                    &self.step_count,
                    &check::Limits {
                        min: Some(1f64),
                        ..check::Limits::NONE
                    },
                )?;
            Ok(())
        }
    }
    impl proto::Command for ServoP {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
                "servo_p",
                "{\"cmdName\":\"servo_p\"",
                "4.16",
                proto::Effect::Motion,
            )
            .requires(
                &[
                    proto::Requirement::Powered,
                    proto::Requirement::Enabled,
                    proto::Requirement::ServoMode,
                ],
            );
    }
    /// Sets the filter that smooths the set-points of servo mode.
    ///
    /// It can be set only outside servo mode.
    ///
    /// Sends `set_servo_move_filter` (4.60). The robot must be outside servo mode.
    ///
    /// # Errata
    ///
    /// - The text calls `filter_type` the motion mode, as copied from 4.6.
    /// - The text writes the keys `max_vr`, `max_ar`, `max_jr`, `max_vp`, `max_ap` and `max_jp`. The samples have `nlf_` before each of them.
    /// - The limits on rotation are printed in %/s, %/s^2 and %/s^3, without anything they could be a percentage of. The field notes find degrees throughout.
    /// - The limits of filter 2, which works on joints, are explained as limits on how fast the orientation changes, as those of filter 4, which works in Cartesian space.
    /// - Filter 5 is listed as speed look-ahead and explained as filter 3, the multi-stage mean filter of the joints.
    /// - `mmf_kp` is explained as coefficient of the position for filter 3, and of the acceleration for filter 5.
    /// - For filter 5 the text writes the key `max_buf`, the sample `mmf_max_buf`.
    /// - `mmf_ka` is explained as coefficient of acceleration and position. The key speaks of the acceleration alone.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub enum SetServoMoveFilter {
        /// No filter.
        Disabled,
        /// First-order low-pass filter on the joints.
        JointLowPass {
            /// Cut-off frequency. In Hz, at least 0.
            ///
            /// `lpf_cf` on the wire.
            #[doc(alias = "lpf_cf")]
            cutoff_frequency: f64,
        },
        /// Nonlinear filter on the joints.
        JointNonlinear {
            /// Greatest speed at which the orientation changes. In deg/s (printed as %/s), at least 0.
            ///
            /// `nlf_max_vr` on the wire.
            #[doc(alias = "nlf_max_vr")]
            max_rotation_speed: f64,
            /// Greatest acceleration with which the orientation changes. In deg/s² (printed as %/s²), at least 0.
            ///
            /// `nlf_max_ar` on the wire.
            #[doc(alias = "nlf_max_ar")]
            max_rotation_acceleration: f64,
            /// Greatest jerk with which the orientation changes. In deg/s³ (printed as %/s³), at least 0.
            ///
            /// `nlf_max_jr` on the wire.
            #[doc(alias = "nlf_max_jr")]
            max_rotation_jerk: f64,
        },
        /// Multi-stage mean filter on the joints.
        JointMean {
            /// Width of the filter's window. At least 0. A wider one smooths more and is less accurate.
            ///
            /// `mmf_max_buf` on the wire.
            #[doc(alias = "mmf_max_buf")]
            window_width: i64,
            /// How closely the position is followed. A smaller one smooths more; a greater one is more accurate, but may cause jitter.
            ///
            /// `mmf_kp` on the wire.
            #[doc(alias = "mmf_kp")]
            position_coefficient: f64,
            /// How closely the speed is followed. A smaller one smooths more; a greater one is more accurate, but may cause jitter.
            ///
            /// `mmf_kv` on the wire.
            #[doc(alias = "mmf_kv")]
            speed_coefficient: f64,
            /// How closely the acceleration is followed. A smaller one smooths more; a greater one is more accurate, but may cause
            /// jitter.
            ///
            /// `mmf_ka` on the wire.
            #[doc(alias = "mmf_ka")]
            acceleration_coefficient: f64,
        },
        /// Nonlinear filter in Cartesian space.
        CartesianNonlinear {
            /// Greatest speed at which the orientation changes. In deg/s (printed as %/s), at least 0.
            ///
            /// `nlf_max_vr` on the wire.
            #[doc(alias = "nlf_max_vr")]
            max_rotation_speed: f64,
            /// Greatest acceleration with which the orientation changes. In deg/s² (printed as %/s²), at least 0.
            ///
            /// `nlf_max_ar` on the wire.
            #[doc(alias = "nlf_max_ar")]
            max_rotation_acceleration: f64,
            /// Greatest jerk with which the orientation changes. In deg/s³ (printed as %/s³), at least 0.
            ///
            /// `nlf_max_jr` on the wire.
            #[doc(alias = "nlf_max_jr")]
            max_rotation_jerk: f64,
            /// Greatest speed of the commanded translation in Cartesian space. In mm/s, at least 0.
            ///
            /// `nlf_max_vp` on the wire.
            #[doc(alias = "nlf_max_vp")]
            max_translation_speed: f64,
            /// Greatest acceleration of the commanded translation in Cartesian space. In mm/s², at least 0.
            ///
            /// `nlf_max_ap` on the wire.
            #[doc(alias = "nlf_max_ap")]
            max_translation_acceleration: f64,
            /// Greatest jerk of the commanded translation in Cartesian space. In mm/s³, at least 0.
            ///
            /// `nlf_max_jp` on the wire.
            #[doc(alias = "nlf_max_jp")]
            max_translation_jerk: f64,
        },
        /// Speed look-ahead.
        SpeedLookahead {
            /// Size of the mean filter's buffer. At least 0.
            ///
            /// `mmf_max_buf` on the wire.
            #[doc(alias = "mmf_max_buf")]
            buffer_size: i64,
            /// Filter coefficient. The document calls it that of the acceleration here, and that of the position for filter 3.
            ///
            /// `mmf_kp` on the wire.
            #[doc(alias = "mmf_kp")]
            coefficient: f64,
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
                Self::JointNonlinear {
                    max_rotation_speed,
                    max_rotation_acceleration,
                    max_rotation_jerk,
                } => {
                    out.key("\"filter_type\":2");
                    out.raw(",\"nlf_max_vr\":");
                    wire::Encode::encode(max_rotation_speed, out);
                    out.raw(",\"nlf_max_ar\":");
                    wire::Encode::encode(max_rotation_acceleration, out);
                    out.raw(",\"nlf_max_jr\":");
                    wire::Encode::encode(max_rotation_jerk, out);
                }
                Self::JointMean {
                    window_width,
                    position_coefficient,
                    speed_coefficient,
                    acceleration_coefficient,
                } => {
                    out.key("\"filter_type\":3");
                    out.raw(",\"mmf_max_buf\":");
                    wire::Encode::encode(window_width, out);
                    out.raw(",\"mmf_kp\":");
                    wire::Encode::encode(position_coefficient, out);
                    out.raw(",\"mmf_kv\":");
                    wire::Encode::encode(speed_coefficient, out);
                    out.raw(",\"mmf_ka\":");
                    wire::Encode::encode(acceleration_coefficient, out);
                }
                Self::CartesianNonlinear {
                    max_rotation_speed,
                    max_rotation_acceleration,
                    max_rotation_jerk,
                    max_translation_speed,
                    max_translation_acceleration,
                    max_translation_jerk,
                } => {
                    out.key("\"filter_type\":4");
                    out.raw(",\"nlf_max_vr\":");
                    wire::Encode::encode(max_rotation_speed, out);
                    out.raw(",\"nlf_max_ar\":");
                    wire::Encode::encode(max_rotation_acceleration, out);
                    out.raw(",\"nlf_max_jr\":");
                    wire::Encode::encode(max_rotation_jerk, out);
                    out.raw(",\"nlf_max_vp\":");
                    wire::Encode::encode(max_translation_speed, out);
                    out.raw(",\"nlf_max_ap\":");
                    wire::Encode::encode(max_translation_acceleration, out);
                    out.raw(",\"nlf_max_jp\":");
                    wire::Encode::encode(max_translation_jerk, out);
                }
                Self::SpeedLookahead { buffer_size, coefficient } => {
                    out.key("\"filter_type\":5");
                    out.raw(",\"mmf_max_buf\":");
                    wire::Encode::encode(buffer_size, out);
                    out.raw(",\"mmf_kp\":");
                    wire::Encode::encode(coefficient, out);
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
                2 => {
                    let mut max_rotation_speed = None;
                    let mut max_rotation_acceleration = None;
                    let mut max_rotation_jerk = None;
                    let mut keys = reader
                        .begin_fields(
                            &["\"nlf_max_vr\":", "\"nlf_max_ar\":", "\"nlf_max_jr\":"],
                        )?;
                    while let Some(key) = reader.next_field(&mut keys)? {
                        match key {
                            0 => {
                                reader.field("max_rotation_speed", &mut max_rotation_speed)?
                            }
                            1 => {
                                reader
                                    .field(
                                        "max_rotation_acceleration",
                                        &mut max_rotation_acceleration,
                                    )?
                            }
                            2 => {
                                reader.field("max_rotation_jerk", &mut max_rotation_jerk)?
                            }
                            _ => reader.skip()?,
                        }
                    }
                    Ok(Self::JointNonlinear {
                        max_rotation_speed: max_rotation_speed
                            .ok_or_else(|| wire::DecodeError::missing(
                                "max_rotation_speed",
                                "nlf_max_vr",
                            ))?,
                        max_rotation_acceleration: max_rotation_acceleration
                            .ok_or_else(|| wire::DecodeError::missing(
                                "max_rotation_acceleration",
                                "nlf_max_ar",
                            ))?,
                        max_rotation_jerk: max_rotation_jerk
                            .ok_or_else(|| wire::DecodeError::missing(
                                "max_rotation_jerk",
                                "nlf_max_jr",
                            ))?,
                    })
                }
                3 => {
                    let mut window_width = None;
                    let mut position_coefficient = None;
                    let mut speed_coefficient = None;
                    let mut acceleration_coefficient = None;
                    let mut keys = reader
                        .begin_fields(
                            &[
                                "\"mmf_max_buf\":",
                                "\"mmf_kp\":",
                                "\"mmf_kv\":",
                                "\"mmf_ka\":",
                            ],
                        )?;
                    while let Some(key) = reader.next_field(&mut keys)? {
                        match key {
                            0 => reader.field("window_width", &mut window_width)?,
                            1 => {
                                reader
                                    .field("position_coefficient", &mut position_coefficient)?
                            }
                            2 => {
                                reader.field("speed_coefficient", &mut speed_coefficient)?
                            }
                            3 => {
                                reader
                                    .field(
                                        "acceleration_coefficient",
                                        &mut acceleration_coefficient,
                                    )?
                            }
                            _ => reader.skip()?,
                        }
                    }
                    Ok(Self::JointMean {
                        window_width: window_width
                            .ok_or_else(|| wire::DecodeError::missing(
                                "window_width",
                                "mmf_max_buf",
                            ))?,
                        position_coefficient: position_coefficient
                            .ok_or_else(|| wire::DecodeError::missing(
                                "position_coefficient",
                                "mmf_kp",
                            ))?,
                        speed_coefficient: speed_coefficient
                            .ok_or_else(|| wire::DecodeError::missing(
                                "speed_coefficient",
                                "mmf_kv",
                            ))?,
                        acceleration_coefficient: acceleration_coefficient
                            .ok_or_else(|| wire::DecodeError::missing(
                                "acceleration_coefficient",
                                "mmf_ka",
                            ))?,
                    })
                }
                4 => {
                    let mut max_rotation_speed = None;
                    let mut max_rotation_acceleration = None;
                    let mut max_rotation_jerk = None;
                    let mut max_translation_speed = None;
                    let mut max_translation_acceleration = None;
                    let mut max_translation_jerk = None;
                    let mut keys = reader
                        .begin_fields(
                            &[
                                "\"nlf_max_vr\":",
                                "\"nlf_max_ar\":",
                                "\"nlf_max_jr\":",
                                "\"nlf_max_vp\":",
                                "\"nlf_max_ap\":",
                                "\"nlf_max_jp\":",
                            ],
                        )?;
                    while let Some(key) = reader.next_field(&mut keys)? {
                        match key {
                            0 => {
                                reader.field("max_rotation_speed", &mut max_rotation_speed)?
                            }
                            1 => {
                                reader
                                    .field(
                                        "max_rotation_acceleration",
                                        &mut max_rotation_acceleration,
                                    )?
                            }
                            2 => {
                                reader.field("max_rotation_jerk", &mut max_rotation_jerk)?
                            }
                            3 => {
                                reader
                                    .field("max_translation_speed", &mut max_translation_speed)?
                            }
                            4 => {
                                reader
                                    .field(
                                        "max_translation_acceleration",
                                        &mut max_translation_acceleration,
                                    )?
                            }
                            5 => {
                                reader
                                    .field("max_translation_jerk", &mut max_translation_jerk)?
                            }
                            _ => reader.skip()?,
                        }
                    }
                    Ok(Self::CartesianNonlinear {
                        max_rotation_speed: max_rotation_speed
                            .ok_or_else(|| wire::DecodeError::missing(
                                "max_rotation_speed",
                                "nlf_max_vr",
                            ))?,
                        max_rotation_acceleration: max_rotation_acceleration
                            .ok_or_else(|| wire::DecodeError::missing(
                                "max_rotation_acceleration",
                                "nlf_max_ar",
                            ))?,
                        max_rotation_jerk: max_rotation_jerk
                            .ok_or_else(|| wire::DecodeError::missing(
                                "max_rotation_jerk",
                                "nlf_max_jr",
                            ))?,
                        max_translation_speed: max_translation_speed
                            .ok_or_else(|| wire::DecodeError::missing(
                                "max_translation_speed",
                                "nlf_max_vp",
                            ))?,
                        max_translation_acceleration: max_translation_acceleration
                            .ok_or_else(|| wire::DecodeError::missing(
                                "max_translation_acceleration",
                                "nlf_max_ap",
                            ))?,
                        max_translation_jerk: max_translation_jerk
                            .ok_or_else(|| wire::DecodeError::missing(
                                "max_translation_jerk",
                                "nlf_max_jp",
                            ))?,
                    })
                }
                5 => {
                    let mut buffer_size = None;
                    let mut coefficient = None;
                    let mut keys = reader
                        .begin_fields(&["\"mmf_max_buf\":", "\"mmf_kp\":"])?;
                    while let Some(key) = reader.next_field(&mut keys)? {
                        match key {
                            0 => reader.field("buffer_size", &mut buffer_size)?,
                            1 => reader.field("coefficient", &mut coefficient)?,
                            _ => reader.skip()?,
                        }
                    }
                    Ok(Self::SpeedLookahead {
                        buffer_size: buffer_size
                            .ok_or_else(|| wire::DecodeError::missing(
                                "buffer_size",
                                "mmf_max_buf",
                            ))?,
                        coefficient: coefficient
                            .ok_or_else(|| wire::DecodeError::missing(
                                "coefficient",
                                "mmf_kp",
                            ))?,
                    })
                }
                other => {
                    Err(
                        wire::DecodeError::unfit(
                                "one of 0, 1, 2, 3, 4, 5",
                                &other.to_string(),
                            )
                            .in_field("filter_type"),
                    )
                }
            }
        }
    }
    proto::__object_impls!(SetServoMoveFilter);
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
                Self::JointNonlinear {
                    max_rotation_speed,
                    max_rotation_acceleration,
                    max_rotation_jerk,
                } => {
                    place
                        .check(
                            "max_rotation_speed",
                            max_rotation_speed,
                            &check::Limits {
                                min: Some(0f64),
                                unit: "deg/s (printed as %/s)",
                                ..check::Limits::NONE
                            },
                        )?;
                    place
                        .check(
                            "max_rotation_acceleration",
                            max_rotation_acceleration,
                            &check::Limits {
                                min: Some(0f64),
                                unit: "deg/s² (printed as %/s²)",
                                ..check::Limits::NONE
                            },
                        )?;
                    place
                        .check(
                            "max_rotation_jerk",
                            max_rotation_jerk,
                            &check::Limits {
                                min: Some(0f64),
                                unit: "deg/s³ (printed as %/s³)",
                                ..check::Limits::NONE
                            },
                        )?;
                }
                Self::JointMean {
                    window_width,
                    position_coefficient,
                    speed_coefficient,
                    acceleration_coefficient,
                } => {
                    place
                        .check(
                            "window_width",
                            window_width,
                            &check::Limits {
                                min: Some(0f64),
                                ..check::Limits::NONE
                            },
                        )?;
                    place
                        .check(
                            "position_coefficient",
                            position_coefficient,
                            &check::Limits::NONE,
                        )?;
                    place
                        .check(
                            "speed_coefficient",
                            speed_coefficient,
                            &check::Limits::NONE,
                        )?;
                    place
                        .check(
                            "acceleration_coefficient",
                            acceleration_coefficient,
                            &check::Limits::NONE,
                        )?;
                }
                Self::CartesianNonlinear {
                    max_rotation_speed,
                    max_rotation_acceleration,
                    max_rotation_jerk,
                    max_translation_speed,
                    max_translation_acceleration,
                    max_translation_jerk,
                } => {
                    place
                        .check(
                            "max_rotation_speed",
                            max_rotation_speed,
                            &check::Limits {
                                min: Some(0f64),
                                unit: "deg/s (printed as %/s)",
                                ..check::Limits::NONE
                            },
                        )?;
                    place
                        .check(
                            "max_rotation_acceleration",
                            max_rotation_acceleration,
                            &check::Limits {
                                min: Some(0f64),
                                unit: "deg/s² (printed as %/s²)",
                                ..check::Limits::NONE
                            },
                        )?;
                    place
                        .check(
                            "max_rotation_jerk",
                            max_rotation_jerk,
                            &check::Limits {
                                min: Some(0f64),
                                unit: "deg/s³ (printed as %/s³)",
                                ..check::Limits::NONE
                            },
                        )?;
                    place
                        .check(
                            "max_translation_speed",
                            max_translation_speed,
                            &check::Limits {
                                min: Some(0f64),
                                unit: "mm/s",
                                ..check::Limits::NONE
                            },
                        )?;
                    place
                        .check(
                            "max_translation_acceleration",
                            max_translation_acceleration,
                            &check::Limits {
                                min: Some(0f64),
                                unit: "mm/s²",
                                ..check::Limits::NONE
                            },
                        )?;
                    place
                        .check(
                            "max_translation_jerk",
                            max_translation_jerk,
                            &check::Limits {
                                min: Some(0f64),
                                unit: "mm/s³",
                                ..check::Limits::NONE
                            },
                        )?;
                }
                Self::SpeedLookahead { buffer_size, coefficient } => {
                    place
                        .check(
                            "buffer_size",
                            buffer_size,
                            &check::Limits {
                                min: Some(0f64),
                                ..check::Limits::NONE
                            },
                        )?;
                    place.check("coefficient", coefficient, &check::Limits::NONE)?;
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
