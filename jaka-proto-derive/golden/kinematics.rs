pub mod kinematics {
    //! Kinematics and present position.
    //!
    //! Position of the arm, and conversions between joint positions and poses.
    //!
    //! None of these commands moves the arm.
    /// Computes the pose of the robot's end at a joint position (forward kinematics).
    ///
    /// The pose refers to the current tool frame, mounting and user frame (vendor's texts).
    ///
    /// Sends `kine_forward` (4.46). Changes nothing on the robot. The reply is [`KineForwardReply`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct KineForward {
        /// Joint position to compute the pose of. In deg. `jointPosition` on the wire.
        pub joint_position: super::types::JointPosition,
    }
    impl KineForward {
        /// With the required fields alone.
        ///
        /// - `joint_position`: in deg
        pub fn new(joint_position: impl Into<super::types::JointPosition>) -> Self {}
    }
    /// What the controller answers to [`type@KineForward`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct KineForwardReply {
        /// Pose of the robot's end at that joint position. `cartPosition` on the wire.
        pub pose: super::types::Pose,
    }
    /// Computes a joint position at which the robot's end has a pose (inverse kinematics).
    ///
    /// Where there is no solution, the controller answers with error code 2. The pose refers to the current tool frame, mounting and user frame
    /// (vendor's texts).
    ///
    /// Sends `kine_inverse` (4.47). Changes nothing on the robot. The reply is [`KineInverseReply`].
    ///
    /// # Refusals
    ///
    /// Known causes of a refusal:
    ///
    /// - No joint position reaches the pose (the document's own example).
    ///
    /// # Errata
    ///
    /// - The document's reply prints `[x,y,z,rx,ry,rz]` in `jointPosition`; its text says that these are joint angles.
    /// - The document's text calls the pose `[x, y, z, a, b, c]`, its sample `[x, y, z, rx, ry, rz]`.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct KineInverse {
        /// Reference for the solution. In deg. `jointPosition` on the wire.
        ///
        /// The document recommends the present joint position.
        pub reference_joint_position: super::types::JointPosition,
        /// Pose of the robot's end to find a joint position for. `cartPosition` on the wire.
        pub pose: super::types::Pose,
    }
    impl KineInverse {
        /// With the required fields alone.
        ///
        /// - `reference_joint_position`: in deg
        pub fn new(
            reference_joint_position: impl Into<super::types::JointPosition>,
            pose: impl Into<super::types::Pose>,
        ) -> Self {}
    }
    /// What the controller answers to [`type@KineInverse`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct KineInverseReply {
        /// Joint position that was found. In deg. `jointPosition` on the wire.
        pub joint_position: super::types::JointPosition,
    }
    /// Reads the positions of the six joints.
    ///
    /// They may be commanded ones: on firmware 1.5.14 they differ from the actual ones of port 10000 by up to 0.023 degrees.
    ///
    /// Sends `get_joint_pos` (4.49). Changes nothing on the robot. The reply is [`GetJointPosReply`].
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetJointPos {}
    impl GetJointPos {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetJointPos`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetJointPosReply {
        /// Positions of the six joints. In deg. `joint_pos` on the wire.
        pub joint_position: super::types::JointPosition,
    }
    /// Reads the pose of the robot's end, which the selected tool frame defines.
    ///
    /// By default that is the centre of the flange. The document does not say which user frame the pose refers to. It may be the commanded
    /// pose: see [`get_joint_pos`](type@GetJointPos).
    ///
    /// Sends `get_tcp_pos` (4.50). Changes nothing on the robot. The reply is [`GetTcpPosReply`].
    ///
    /// # Errata
    ///
    /// - The heading says present coordinate frame, the text present tool frame; neither mentions the user frame.
    /// - The document calls the pose `[x, y, z, a, b, c]` and gives no unit here; 4.47 gives millimetres and degrees.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetTcpPos {}
    impl GetTcpPos {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetTcpPos`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetTcpPosReply {
        /// Pose of the robot's end, which the selected tool frame defines. `tcp_pos` on the wire.
        pub pose: super::types::Pose,
    }
    /// Reads the Denavit-Hartenberg (DH) parameters of the robot.
    ///
    /// The document prints the four keys and zeros, and explains nothing: the units are those of the field notes, and no source says which of
    /// the conventions for DH parameters is meant.
    ///
    /// Sends `get_dh_param` (4.82). Changes nothing on the robot. The reply is [`GetDhParamReply`].
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetDhParam {}
    impl GetDhParam {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetDhParam`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetDhParamReply {
        /// DH parameter alpha, one for each joint. In deg.
        pub alpha: [f64; 6],
        /// DH parameter a, one for each joint. In mm.
        pub a: [f64; 6],
        /// DH parameter d, one for each joint. In mm.
        pub d: [f64; 6],
        /// Home offset, by the key's name, one for each joint. In deg. `joint_homeoff` on the wire.
        pub joint_home_offset: [f64; 6],
    }
}
