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
    /// Moves one joint, or one Cartesian coordinate of the tool centre point, continuously, by an increment or to a position.
    ///
    /// Send `Stop` for an axis before the next jog of the same axis. The frame decides what `axis` counts: joints 1 to 6, or
    /// x, y, z, rx, ry, rz, both from 0 to 5.
    ///
    /// Sends `jog` (4.6). The robot must be powered, enabled and outside servo mode.
    ///
    /// # Errata
    ///
    /// - The document says that there are three jog modes and lists four.
    /// - The document's samples for increment and absolute send `jnum` 3, axis 4, and call it joint 2.
    /// - The text gives `poscmd` in millimetres on every Cartesian axis, rotations included, and `jogvel` a unit only on a joint, deg/s. The other units follow from the field notes, which find degrees and millimetres throughout.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub enum Jog {
        /// Stops the jog of one axis.
        Stop {
            /// Frame of the motion to stop.
            ///
            /// `coord_map` on the wire.
            #[doc(alias = "coord_map")]
            frame: JogFrame,
            /// Index of joint 1 to 6, or of x, y, z, rx, ry, rz. 0 to 5.
            ///
            /// `jnum` on the wire.
            #[doc(alias = "jnum")]
            axis: i64,
        },
        /// Moves on and on.
        ///
        /// Send `Stop` for the axis to end it: the document names nothing else that does.
        Continuous {
            /// Frame of the motion.
            ///
            /// `coord_map` on the wire.
            #[doc(alias = "coord_map")]
            frame: JogFrame,
            /// Index of joint 1 to 6, or of x, y, z, rx, ry, rz. 0 to 5.
            ///
            /// `jnum` on the wire.
            #[doc(alias = "jnum")]
            axis: i64,
            /// Velocity; its sign is the direction. In deg/s for a joint or a rotation, mm/s for a translation.
            ///
            /// `jogvel` on the wire.
            #[doc(alias = "jogvel")]
            velocity: f64,
        },
        /// Moves by a distance from the present position.
        Increment {
            /// Frame of the motion.
            ///
            /// `coord_map` on the wire.
            #[doc(alias = "coord_map")]
            frame: JogFrame,
            /// Index of joint 1 to 6, or of x, y, z, rx, ry, rz. 0 to 5.
            ///
            /// `jnum` on the wire.
            #[doc(alias = "jnum")]
            axis: i64,
            /// Velocity. In deg/s for a joint or a rotation, mm/s for a translation.
            ///
            /// The direction can be given by the sign of `distance`. The document does not say what a negative velocity does here.
            ///
            /// `jogvel` on the wire.
            #[doc(alias = "jogvel")]
            velocity: f64,
            /// Distance to move; its sign is the direction. In deg for a joint or a rotation, mm for a translation.
            ///
            /// `poscmd` on the wire.
            #[doc(alias = "poscmd")]
            distance: f64,
        },
        /// Moves to a position of the axis.
        Absolute {
            /// Frame of the motion.
            ///
            /// `coord_map` on the wire.
            #[doc(alias = "coord_map")]
            frame: JogFrame,
            /// Index of joint 1 to 6, or of x, y, z, rx, ry, rz. 0 to 5.
            ///
            /// `jnum` on the wire.
            #[doc(alias = "jnum")]
            axis: i64,
            /// Velocity. In deg/s for a joint or a rotation, mm/s for a translation. The document does not say what a negative one does here.
            ///
            /// `jogvel` on the wire.
            #[doc(alias = "jogvel")]
            velocity: f64,
            /// Position to move to. In deg for a joint or a rotation, mm for a translation.
            ///
            /// `poscmd` on the wire.
            #[doc(alias = "poscmd")]
            position: f64,
        },
    }
    impl wire::Fields for Jog {
        fn write_fields(&self, out: &mut wire::Writer) {
            match self {
                Self::Stop { frame, axis } => {
                    out.key("\"jog_mode\":0");
                    out.raw(",\"coord_map\":");
                    wire::Encode::encode(frame, out);
                    out.raw(",\"jnum\":");
                    wire::Encode::encode(axis, out);
                }
                Self::Continuous { frame, axis, velocity } => {
                    out.key("\"jog_mode\":1");
                    out.raw(",\"coord_map\":");
                    wire::Encode::encode(frame, out);
                    out.raw(",\"jnum\":");
                    wire::Encode::encode(axis, out);
                    out.raw(",\"jogvel\":");
                    wire::Encode::encode(velocity, out);
                }
                Self::Increment { frame, axis, velocity, distance } => {
                    out.key("\"jog_mode\":2");
                    out.raw(",\"coord_map\":");
                    wire::Encode::encode(frame, out);
                    out.raw(",\"jnum\":");
                    wire::Encode::encode(axis, out);
                    out.raw(",\"jogvel\":");
                    wire::Encode::encode(velocity, out);
                    out.raw(",\"poscmd\":");
                    wire::Encode::encode(distance, out);
                }
                Self::Absolute { frame, axis, velocity, position } => {
                    out.key("\"jog_mode\":3");
                    out.raw(",\"coord_map\":");
                    wire::Encode::encode(frame, out);
                    out.raw(",\"jnum\":");
                    wire::Encode::encode(axis, out);
                    out.raw(",\"jogvel\":");
                    wire::Encode::encode(velocity, out);
                    out.raw(",\"poscmd\":");
                    wire::Encode::encode(position, out);
                }
            }
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            match reader.tag("jog_mode", "jog_mode")? {
                0 => {
                    let mut frame = None;
                    let mut axis = None;
                    let mut keys = reader
                        .begin_fields(&["\"coord_map\":", "\"jnum\":"])?;
                    while let Some(key) = reader.next_field(&mut keys)? {
                        match key {
                            0 => reader.field("frame", &mut frame)?,
                            1 => reader.field("axis", &mut axis)?,
                            _ => reader.skip()?,
                        }
                    }
                    Ok(Self::Stop {
                        frame: frame
                            .ok_or_else(|| wire::DecodeError::missing(
                                "frame",
                                "coord_map",
                            ))?,
                        axis: axis
                            .ok_or_else(|| wire::DecodeError::missing("axis", "jnum"))?,
                    })
                }
                1 => {
                    let mut frame = None;
                    let mut axis = None;
                    let mut velocity = None;
                    let mut keys = reader
                        .begin_fields(&["\"coord_map\":", "\"jnum\":", "\"jogvel\":"])?;
                    while let Some(key) = reader.next_field(&mut keys)? {
                        match key {
                            0 => reader.field("frame", &mut frame)?,
                            1 => reader.field("axis", &mut axis)?,
                            2 => reader.field("velocity", &mut velocity)?,
                            _ => reader.skip()?,
                        }
                    }
                    Ok(Self::Continuous {
                        frame: frame
                            .ok_or_else(|| wire::DecodeError::missing(
                                "frame",
                                "coord_map",
                            ))?,
                        axis: axis
                            .ok_or_else(|| wire::DecodeError::missing("axis", "jnum"))?,
                        velocity: velocity
                            .ok_or_else(|| wire::DecodeError::missing(
                                "velocity",
                                "jogvel",
                            ))?,
                    })
                }
                2 => {
                    let mut frame = None;
                    let mut axis = None;
                    let mut velocity = None;
                    let mut distance = None;
                    let mut keys = reader
                        .begin_fields(
                            &[
                                "\"coord_map\":",
                                "\"jnum\":",
                                "\"jogvel\":",
                                "\"poscmd\":",
                            ],
                        )?;
                    while let Some(key) = reader.next_field(&mut keys)? {
                        match key {
                            0 => reader.field("frame", &mut frame)?,
                            1 => reader.field("axis", &mut axis)?,
                            2 => reader.field("velocity", &mut velocity)?,
                            3 => reader.field("distance", &mut distance)?,
                            _ => reader.skip()?,
                        }
                    }
                    Ok(Self::Increment {
                        frame: frame
                            .ok_or_else(|| wire::DecodeError::missing(
                                "frame",
                                "coord_map",
                            ))?,
                        axis: axis
                            .ok_or_else(|| wire::DecodeError::missing("axis", "jnum"))?,
                        velocity: velocity
                            .ok_or_else(|| wire::DecodeError::missing(
                                "velocity",
                                "jogvel",
                            ))?,
                        distance: distance
                            .ok_or_else(|| wire::DecodeError::missing(
                                "distance",
                                "poscmd",
                            ))?,
                    })
                }
                3 => {
                    let mut frame = None;
                    let mut axis = None;
                    let mut velocity = None;
                    let mut position = None;
                    let mut keys = reader
                        .begin_fields(
                            &[
                                "\"coord_map\":",
                                "\"jnum\":",
                                "\"jogvel\":",
                                "\"poscmd\":",
                            ],
                        )?;
                    while let Some(key) = reader.next_field(&mut keys)? {
                        match key {
                            0 => reader.field("frame", &mut frame)?,
                            1 => reader.field("axis", &mut axis)?,
                            2 => reader.field("velocity", &mut velocity)?,
                            3 => reader.field("position", &mut position)?,
                            _ => reader.skip()?,
                        }
                    }
                    Ok(Self::Absolute {
                        frame: frame
                            .ok_or_else(|| wire::DecodeError::missing(
                                "frame",
                                "coord_map",
                            ))?,
                        axis: axis
                            .ok_or_else(|| wire::DecodeError::missing("axis", "jnum"))?,
                        velocity: velocity
                            .ok_or_else(|| wire::DecodeError::missing(
                                "velocity",
                                "jogvel",
                            ))?,
                        position: position
                            .ok_or_else(|| wire::DecodeError::missing(
                                "position",
                                "poscmd",
                            ))?,
                    })
                }
                other => {
                    Err(
                        wire::DecodeError::unfit("one of 0, 1, 2, 3", &other.to_string())
                            .in_field("jog_mode"),
                    )
                }
            }
        }
    }
    proto::__object_impls!(Jog);
    impl check::Validate for Jog {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            match self {
                Self::Stop { frame, axis } => {
                    place.check("frame", frame, &check::Limits::NONE)?;
                    place
                        .check(
                            "axis",
                            axis,
                            &check::Limits {
                                min: Some(0f64),
                                max: Some(5f64),
                                ..check::Limits::NONE
                            },
                        )?;
                }
                Self::Continuous { frame, axis, velocity } => {
                    place.check("frame", frame, &check::Limits::NONE)?;
                    place
                        .check(
                            "axis",
                            axis,
                            &check::Limits {
                                min: Some(0f64),
                                max: Some(5f64),
                                ..check::Limits::NONE
                            },
                        )?;
                    place
                        .check(
                            "velocity",
                            velocity,
                            &check::Limits {
                                unit: "deg/s for a joint or a rotation, mm/s for a translation",
                                ..check::Limits::NONE
                            },
                        )?;
                }
                Self::Increment { frame, axis, velocity, distance } => {
                    place.check("frame", frame, &check::Limits::NONE)?;
                    place
                        .check(
                            "axis",
                            axis,
                            &check::Limits {
                                min: Some(0f64),
                                max: Some(5f64),
                                ..check::Limits::NONE
                            },
                        )?;
                    place
                        .check(
                            "velocity",
                            velocity,
                            &check::Limits {
                                unit: "deg/s for a joint or a rotation, mm/s for a translation",
                                ..check::Limits::NONE
                            },
                        )?;
                    place
                        .check(
                            "distance",
                            distance,
                            &check::Limits {
                                unit: "deg for a joint or a rotation, mm for a translation",
                                ..check::Limits::NONE
                            },
                        )?;
                }
                Self::Absolute { frame, axis, velocity, position } => {
                    place.check("frame", frame, &check::Limits::NONE)?;
                    place
                        .check(
                            "axis",
                            axis,
                            &check::Limits {
                                min: Some(0f64),
                                max: Some(5f64),
                                ..check::Limits::NONE
                            },
                        )?;
                    place
                        .check(
                            "velocity",
                            velocity,
                            &check::Limits {
                                unit: "deg/s for a joint or a rotation, mm/s for a translation",
                                ..check::Limits::NONE
                            },
                        )?;
                    place
                        .check(
                            "position",
                            position,
                            &check::Limits {
                                unit: "deg for a joint or a rotation, mm for a translation",
                                ..check::Limits::NONE
                            },
                        )?;
                }
            }
            Ok(())
        }
    }
    impl proto::Command for Jog {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
                "jog",
                "{\"cmdName\":\"jog\"",
                "4.6",
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
    /// Moves all joints so that the tool centre point reaches a pose.
    ///
    /// The tool centre point does not follow a straight line. The controller computes the joint positions for the pose and
    /// moves to them as `joint_move` does; so speed and acceleration are those of joints. For a straight line use `move_l`.
    ///
    /// The motion starts when the one before it has ended. To move at once, stop that one first with `stop_program`.
    ///
    /// The reply says that the motion was accepted, not that it has ended.
    ///
    /// Sends `end_move` (4.8). The robot must be powered, enabled and outside servo mode.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct EndMove {
        /// Target pose of the tool centre point.
        ///
        /// `endPosition` on the wire.
        #[doc(alias = "endPosition")]
        pub pose: super::types::Pose,
        /// Joint speed. In deg/s, at least 0.
        pub speed: f64,
        /// Joint acceleration. In deg/s², at least 0. The document advises 720 at most. Controllers take the command without it (field notes).
        ///
        /// `accel` on the wire.
        #[doc(alias = "accel")]
        pub acceleration: Option<f64>,
    }
    impl wire::Fields for EndMove {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"endPosition\":");
            wire::Encode::encode(&self.pose, out);
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
            let mut pose = None;
            let mut speed = None;
            let mut acceleration = None;
            let mut keys = reader
                .begin_fields(&["\"endPosition\":", "\"speed\":", "\"accel\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("pose", &mut pose)?,
                    1 => reader.field("speed", &mut speed)?,
                    2 => reader.field("acceleration", &mut acceleration)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                pose: pose
                    .ok_or_else(|| wire::DecodeError::missing("pose", "endPosition"))?,
                speed: speed
                    .ok_or_else(|| wire::DecodeError::missing("speed", "speed"))?,
                acceleration,
            })
        }
    }
    proto::__object_impls!(EndMove);
    impl check::Validate for EndMove {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("pose", &self.pose, &check::Limits::NONE)?;
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
    impl proto::Command for EndMove {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
                "end_move",
                "{\"cmdName\":\"end_move\"",
                "4.8",
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
    /// Moves the tool centre point along a straight line to a pose, or by an offset (MoveL).
    ///
    /// The motion starts when the one before it has ended. To move at once, stop that one first with `stop_program`.
    ///
    /// The reply says that the motion was accepted, not that it has ended.
    ///
    /// Sends `moveL` (4.9). The robot must be powered, enabled and outside servo mode.
    ///
    /// # Errata
    ///
    /// - The sample has `tol`, which the text of 4.9 leaves out. 4.10 explains it, without a unit; millimetres follow from the field notes, which find them throughout.
    #[doc(alias = "moveL")]
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct MoveL {
        /// Whether `pose` is a target or an offset.
        ///
        /// `relFlag` on the wire.
        #[doc(alias = "relFlag")]
        pub mode: super::types::MoveMode,
        /// Target pose, or offset, of the tool centre point.
        ///
        /// `cartPosition` on the wire.
        #[doc(alias = "cartPosition")]
        pub pose: super::types::Pose,
        /// Speed of the tool centre point along the line. In mm/s, at least 0.
        pub speed: f64,
        /// Acceleration of the tool centre point along the line. In mm/s², at least 0. The document advises 8000 at most. Controllers take the command
        /// without it (field notes).
        ///
        /// `accel` on the wire.
        #[doc(alias = "accel")]
        pub acceleration: Option<f64>,
        /// Greatest error allowed, or 0 where none is needed. In mm, at least 0. The document names no unit. Controllers take the command without it
        /// (field notes).
        ///
        /// `tol` on the wire.
        #[doc(alias = "tol")]
        pub tolerance: Option<f64>,
    }
    impl wire::Fields for MoveL {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"relFlag\":");
            wire::Encode::encode(&self.mode, out);
            out.raw(",\"cartPosition\":");
            wire::Encode::encode(&self.pose, out);
            out.raw(",\"speed\":");
            wire::Encode::encode(&self.speed, out);
            if let Some(value) = &self.acceleration {
                out.raw(",\"accel\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.tolerance {
                out.raw(",\"tol\":");
                wire::Encode::encode(value, out);
            }
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut mode = None;
            let mut pose = None;
            let mut speed = None;
            let mut acceleration = None;
            let mut tolerance = None;
            let mut keys = reader
                .begin_fields(
                    &[
                        "\"relFlag\":",
                        "\"cartPosition\":",
                        "\"speed\":",
                        "\"accel\":",
                        "\"tol\":",
                    ],
                )?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("mode", &mut mode)?,
                    1 => reader.field("pose", &mut pose)?,
                    2 => reader.field("speed", &mut speed)?,
                    3 => reader.field("acceleration", &mut acceleration)?,
                    4 => reader.field("tolerance", &mut tolerance)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                mode: mode.ok_or_else(|| wire::DecodeError::missing("mode", "relFlag"))?,
                pose: pose
                    .ok_or_else(|| wire::DecodeError::missing("pose", "cartPosition"))?,
                speed: speed
                    .ok_or_else(|| wire::DecodeError::missing("speed", "speed"))?,
                acceleration,
                tolerance,
            })
        }
    }
    proto::__object_impls!(MoveL);
    impl check::Validate for MoveL {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("mode", &self.mode, &check::Limits::NONE)?;
            place.check("pose", &self.pose, &check::Limits::NONE)?;
            place
                .check(
                    "speed",
                    &self.speed,
                    &check::Limits {
                        min: Some(0f64),
                        unit: "mm/s",
                        ..check::Limits::NONE
                    },
                )?;
            place
                .check(
                    "acceleration",
                    &self.acceleration,
                    &check::Limits {
                        min: Some(0f64),
                        unit: "mm/s²",
                        ..check::Limits::NONE
                    },
                )?;
            place
                .check(
                    "tolerance",
                    &self.tolerance,
                    &check::Limits {
                        min: Some(0f64),
                        unit: "mm",
                        ..check::Limits::NONE
                    },
                )?;
            Ok(())
        }
    }
    impl proto::Command for MoveL {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
                "moveL",
                "{\"cmdName\":\"moveL\"",
                "4.9",
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
    /// Moves the tool centre point along an arc, through one pose to another (MoveC).
    ///
    /// The units of speed and acceleration are uncertain: the document gives those of joints, although the motion follows a
    /// path. Begin with small values, and with nobody near the arm.
    ///
    /// The reply says that the motion was accepted, not that it has ended.
    ///
    /// Sends `movc` (4.10). The robot must be powered, enabled and outside servo mode.
    ///
    /// # Errata
    ///
    /// - The text gives speed and acceleration in deg/s and deg/s², of joints, and advises 720 deg/s² at most, in the words of 4.8. The motion follows a path, for which 4.9 has mm/s and mm/s².
    /// - The text does not explain `relFlag`, nor what the two poses are relative to when it is 1.
    /// - The text names no unit for `tol`. Millimetres follow from the field notes, which find them throughout.
    /// - The `cmdName` is `movc`, while the section is titled MoveC.
    #[doc(alias = "movc")]
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct MoveC {
        /// Whether the two poses are targets or offsets, as for `move_l`. The document does not explain it here.
        ///
        /// `relFlag` on the wire.
        #[doc(alias = "relFlag")]
        pub mode: super::types::MoveMode,
        /// Pose on the arc, between its ends.
        ///
        /// `pos_mid` on the wire.
        #[doc(alias = "pos_mid")]
        pub mid_pose: super::types::Pose,
        /// Pose at the end of the arc.
        ///
        /// `pos_end` on the wire.
        #[doc(alias = "pos_end")]
        pub end_pose: super::types::Pose,
        /// Speed. In deg/s as printed or mm/s by the kind of motion (uncertain), at least 0. The document calls it a joint speed, although the motion follows a path.
        pub speed: f64,
        /// Acceleration. In deg/s² as printed or mm/s² by the kind of motion (uncertain), at least 0. The document calls it a joint acceleration and advises 720 at most.
        ///
        /// `accel` on the wire.
        #[doc(alias = "accel")]
        pub acceleration: f64,
        /// Greatest error allowed, or 0 where none is needed. In mm, at least 0. The document names no unit.
        ///
        /// `tol` on the wire.
        #[doc(alias = "tol")]
        pub tolerance: f64,
    }
    impl wire::Fields for MoveC {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"relFlag\":");
            wire::Encode::encode(&self.mode, out);
            out.raw(",\"pos_mid\":");
            wire::Encode::encode(&self.mid_pose, out);
            out.raw(",\"pos_end\":");
            wire::Encode::encode(&self.end_pose, out);
            out.raw(",\"speed\":");
            wire::Encode::encode(&self.speed, out);
            out.raw(",\"accel\":");
            wire::Encode::encode(&self.acceleration, out);
            out.raw(",\"tol\":");
            wire::Encode::encode(&self.tolerance, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut mode = None;
            let mut mid_pose = None;
            let mut end_pose = None;
            let mut speed = None;
            let mut acceleration = None;
            let mut tolerance = None;
            let mut keys = reader
                .begin_fields(
                    &[
                        "\"relFlag\":",
                        "\"pos_mid\":",
                        "\"pos_end\":",
                        "\"speed\":",
                        "\"accel\":",
                        "\"tol\":",
                    ],
                )?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("mode", &mut mode)?,
                    1 => reader.field("mid_pose", &mut mid_pose)?,
                    2 => reader.field("end_pose", &mut end_pose)?,
                    3 => reader.field("speed", &mut speed)?,
                    4 => reader.field("acceleration", &mut acceleration)?,
                    5 => reader.field("tolerance", &mut tolerance)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                mode: mode.ok_or_else(|| wire::DecodeError::missing("mode", "relFlag"))?,
                mid_pose: mid_pose
                    .ok_or_else(|| wire::DecodeError::missing("mid_pose", "pos_mid"))?,
                end_pose: end_pose
                    .ok_or_else(|| wire::DecodeError::missing("end_pose", "pos_end"))?,
                speed: speed
                    .ok_or_else(|| wire::DecodeError::missing("speed", "speed"))?,
                acceleration: acceleration
                    .ok_or_else(|| wire::DecodeError::missing("acceleration", "accel"))?,
                tolerance: tolerance
                    .ok_or_else(|| wire::DecodeError::missing("tolerance", "tol"))?,
            })
        }
    }
    proto::__object_impls!(MoveC);
    impl check::Validate for MoveC {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("mode", &self.mode, &check::Limits::NONE)?;
            place.check("mid_pose", &self.mid_pose, &check::Limits::NONE)?;
            place.check("end_pose", &self.end_pose, &check::Limits::NONE)?;
            place
                .check(
                    "speed",
                    &self.speed,
                    &check::Limits {
                        min: Some(0f64),
                        unit: "deg/s as printed or mm/s by the kind of motion (uncertain)",
                        ..check::Limits::NONE
                    },
                )?;
            place
                .check(
                    "acceleration",
                    &self.acceleration,
                    &check::Limits {
                        min: Some(0f64),
                        unit: "deg/s² as printed or mm/s² by the kind of motion (uncertain)",
                        ..check::Limits::NONE
                    },
                )?;
            place
                .check(
                    "tolerance",
                    &self.tolerance,
                    &check::Limits {
                        min: Some(0f64),
                        unit: "mm",
                        ..check::Limits::NONE
                    },
                )?;
            Ok(())
        }
    }
    impl proto::Command for MoveC {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
                "movc",
                "{\"cmdName\":\"movc\"",
                "4.10",
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
    /// Waits until the motion that is running has ended.
    ///
    /// The document calls it withdrawn and advises against it, without saying what it does. On old firmware the reply comes
    /// when the motion ends.
    ///
    /// Sends `wait_complete` (4.41).
    ///
    /// Withdrawn by the vendor: watch the status of port 10000 until the robot is in position.
    ///
    /// # Errata
    ///
    /// - In the sample, the reply's `cmdName` begins with a blank.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct WaitComplete;
    impl wire::Fields for WaitComplete {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(WaitComplete);
    impl check::Validate for WaitComplete {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for WaitComplete {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
                "wait_complete",
                "{\"cmdName\":\"wait_complete\"",
                "4.41",
                proto::Effect::Session,
            )
            .deadline_ms(60000u64);
    }
    /// What a jog moves along or about.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum JogFrame {
        /// The axes of the world frame. `0` on the wire.
        World,
        /// A joint. `1` on the wire.
        Joint,
        /// The axes of the tool frame. `2` on the wire.
        Tool,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for JogFrame {
        fn from(value: i64) -> Self {
            match value {
                0 => Self::World,
                1 => Self::Joint,
                2 => Self::Tool,
                other => Self::Other(other),
            }
        }
    }
    impl From<JogFrame> for i64 {
        fn from(value: JogFrame) -> Self {
            match value {
                JogFrame::World => 0,
                JogFrame::Joint => 1,
                JogFrame::Tool => 2,
                JogFrame::Other(other) => other,
            }
        }
    }
    proto::__int_enum_impls!(JogFrame);
    impl check::Validate for JogFrame {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            let standing = match self {
                Self::World | Self::Joint | Self::Tool => check::Standing::Listed,
                Self::Other(_) => check::Standing::Unknown,
            };
            place.listed(&i64::from(*self), standing, "0 (World), 1 (Joint) or 2 (Tool)")
        }
    }
}
