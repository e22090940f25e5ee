/// Kinematics and present position.
///
/// Where the arm is, and the way between joint positions and poses.
///
/// None of these commands moves the arm.
pub mod kinematics {
    #[allow(unused_imports)]
    use ::jaka_proto::{self as proto, check, wire};
    /// Computes the pose of the robot's end at a joint position (forward kinematics).
    ///
    /// The document does not say which tool frame and which user frame the pose refers to.
    ///
    /// Sends `kine_forward` (4.46). Changes nothing on the robot.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct KineForward {
        /// Joint position to compute the pose of.
        ///
        /// `jointPosition` on the wire.
        #[doc(alias = "jointPosition")]
        pub joint_position: super::types::JointPosition,
    }
    impl wire::Fields for KineForward {
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
    proto::__object_impls!(KineForward);
    impl check::Validate for KineForward {
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
    impl proto::Command for KineForward {
        type Reply = KineForwardReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "kine_forward",
            "{\"cmdName\":\"kine_forward\"",
            "4.46",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`KineForward`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct KineForwardReply {
        /// Pose of the robot's end at that joint position.
        ///
        /// `cartPosition` on the wire.
        #[doc(alias = "cartPosition")]
        pub pose: super::types::Pose,
    }
    impl wire::Fields for KineForwardReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"cartPosition\":");
            wire::Encode::encode(&self.pose, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut pose = None;
            let mut keys = reader.begin_fields(&["\"cartPosition\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("pose", &mut pose)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                pose: pose
                    .ok_or_else(|| wire::DecodeError::missing("pose", "cartPosition"))?,
            })
        }
    }
    proto::__object_impls!(KineForwardReply);
    /// Computes a joint position at which the robot's end has a pose (inverse kinematics).
    ///
    /// Where there is no solution, the controller answers with error code 2. The document does not say which tool frame and
    /// which user frame the pose refers to.
    ///
    /// Sends `kine_inverse` (4.47). Changes nothing on the robot.
    ///
    /// # Errata
    ///
    /// - The document's reply prints `[x,y,z,rx,ry,rz]` in `jointPosition`; its text says that these are joint angles.
    /// - The document's text calls the pose `[x, y, z, a, b, c]`, its sample `[x, y, z, rx, ry, rz]`.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct KineInverse {
        /// Reference for the solution.
        ///
        /// The document recommends the present joint position.
        ///
        /// `jointPosition` on the wire.
        #[doc(alias = "jointPosition")]
        pub reference_joint_position: super::types::JointPosition,
        /// Pose of the robot's end to find a joint position for.
        ///
        /// `cartPosition` on the wire.
        #[doc(alias = "cartPosition")]
        pub pose: super::types::Pose,
    }
    impl wire::Fields for KineInverse {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"jointPosition\":");
            wire::Encode::encode(&self.reference_joint_position, out);
            out.raw(",\"cartPosition\":");
            wire::Encode::encode(&self.pose, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut reference_joint_position = None;
            let mut pose = None;
            let mut keys = reader
                .begin_fields(&["\"jointPosition\":", "\"cartPosition\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => {
                        reader
                            .field(
                                "reference_joint_position",
                                &mut reference_joint_position,
                            )?
                    }
                    1 => reader.field("pose", &mut pose)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                reference_joint_position: reference_joint_position
                    .ok_or_else(|| wire::DecodeError::missing(
                        "reference_joint_position",
                        "jointPosition",
                    ))?,
                pose: pose
                    .ok_or_else(|| wire::DecodeError::missing("pose", "cartPosition"))?,
            })
        }
    }
    proto::__object_impls!(KineInverse);
    impl check::Validate for KineInverse {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place
                .check(
                    "reference_joint_position",
                    &self.reference_joint_position,
                    &check::Limits::NONE,
                )?;
            place.check("pose", &self.pose, &check::Limits::NONE)?;
            Ok(())
        }
    }
    impl proto::Command for KineInverse {
        type Reply = KineInverseReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "kine_inverse",
            "{\"cmdName\":\"kine_inverse\"",
            "4.47",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`KineInverse`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct KineInverseReply {
        /// Joint position that was found.
        ///
        /// `jointPosition` on the wire.
        #[doc(alias = "jointPosition")]
        pub joint_position: super::types::JointPosition,
    }
    impl wire::Fields for KineInverseReply {
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
    proto::__object_impls!(KineInverseReply);
    /// Reads the positions of the six joints.
    ///
    /// Sends `get_joint_pos` (4.49). Changes nothing on the robot.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct GetJointPos;
    impl wire::Fields for GetJointPos {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(GetJointPos);
    impl check::Validate for GetJointPos {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for GetJointPos {
        type Reply = GetJointPosReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "get_joint_pos",
            "{\"cmdName\":\"get_joint_pos\"",
            "4.49",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`GetJointPos`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct GetJointPosReply {
        /// Positions of the six joints.
        ///
        /// `joint_pos` on the wire.
        #[doc(alias = "joint_pos")]
        pub joint_position: super::types::JointPosition,
    }
    impl wire::Fields for GetJointPosReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"joint_pos\":");
            wire::Encode::encode(&self.joint_position, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut joint_position = None;
            let mut keys = reader.begin_fields(&["\"joint_pos\":"])?;
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
                        "joint_pos",
                    ))?,
            })
        }
    }
    proto::__object_impls!(GetJointPosReply);
    /// Reads the pose of the robot's end, which the selected tool frame defines.
    ///
    /// By default that is the centre of the flange. The document does not say which user frame the pose refers to.
    ///
    /// Sends `get_tcp_pos` (4.50). Changes nothing on the robot.
    ///
    /// # Errata
    ///
    /// - The heading says present coordinate frame, the text present tool frame; neither mentions the user frame.
    /// - The document calls the pose `[x, y, z, a, b, c]` and gives no unit here; 4.47 gives millimetres and degrees.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct GetTcpPos;
    impl wire::Fields for GetTcpPos {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(GetTcpPos);
    impl check::Validate for GetTcpPos {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for GetTcpPos {
        type Reply = GetTcpPosReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "get_tcp_pos",
            "{\"cmdName\":\"get_tcp_pos\"",
            "4.50",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`GetTcpPos`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct GetTcpPosReply {
        /// Pose of the robot's end, which the selected tool frame defines.
        ///
        /// `tcp_pos` on the wire.
        #[doc(alias = "tcp_pos")]
        pub pose: super::types::Pose,
    }
    impl wire::Fields for GetTcpPosReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"tcp_pos\":");
            wire::Encode::encode(&self.pose, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut pose = None;
            let mut keys = reader.begin_fields(&["\"tcp_pos\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("pose", &mut pose)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                pose: pose.ok_or_else(|| wire::DecodeError::missing("pose", "tcp_pos"))?,
            })
        }
    }
    proto::__object_impls!(GetTcpPosReply);
    /// Reads the Denavit-Hartenberg (DH) parameters of the robot.
    ///
    /// The document prints the four keys and zeros, and explains nothing. It gives no unit, and does not say which of the
    /// conventions for DH parameters is meant.
    ///
    /// Sends `get_dh_param` (4.82). Changes nothing on the robot.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct GetDhParam;
    impl wire::Fields for GetDhParam {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(GetDhParam);
    impl check::Validate for GetDhParam {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for GetDhParam {
        type Reply = GetDhParamReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "get_dh_param",
            "{\"cmdName\":\"get_dh_param\"",
            "4.82",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`GetDhParam`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct GetDhParamReply {
        /// DH parameter alpha, one for each joint. Unit not stated.
        pub alpha: [f64; 6],
        /// DH parameter a, one for each joint. Unit not stated.
        pub a: [f64; 6],
        /// DH parameter d, one for each joint. Unit not stated.
        pub d: [f64; 6],
        /// Home offset, by the key's name, one for each joint. Unit not stated.
        ///
        /// `joint_homeoff` on the wire.
        #[doc(alias = "joint_homeoff")]
        pub joint_home_offset: [f64; 6],
    }
    impl wire::Fields for GetDhParamReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"alpha\":");
            wire::Encode::encode(&self.alpha, out);
            out.raw(",\"a\":");
            wire::Encode::encode(&self.a, out);
            out.raw(",\"d\":");
            wire::Encode::encode(&self.d, out);
            out.raw(",\"joint_homeoff\":");
            wire::Encode::encode(&self.joint_home_offset, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut alpha = None;
            let mut a = None;
            let mut d = None;
            let mut joint_home_offset = None;
            let mut keys = reader
                .begin_fields(
                    &["\"alpha\":", "\"a\":", "\"d\":", "\"joint_homeoff\":"],
                )?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("alpha", &mut alpha)?,
                    1 => reader.field("a", &mut a)?,
                    2 => reader.field("d", &mut d)?,
                    3 => reader.field("joint_home_offset", &mut joint_home_offset)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                alpha: alpha
                    .ok_or_else(|| wire::DecodeError::missing("alpha", "alpha"))?,
                a: a.ok_or_else(|| wire::DecodeError::missing("a", "a"))?,
                d: d.ok_or_else(|| wire::DecodeError::missing("d", "d"))?,
                joint_home_offset: joint_home_offset
                    .ok_or_else(|| wire::DecodeError::missing(
                        "joint_home_offset",
                        "joint_homeoff",
                    ))?,
            })
        }
    }
    proto::__object_impls!(GetDhParamReply);
}
