pub mod motion {
    //! Jog and planned motion.
    //!
    //! The controller's own planner drives these motions. The reply says that a motion was accepted, not that it has ended:
    //! newer firmware replies at once, firmware 1.4, or any firmware that is still moving, may reply seconds later.
    //!
    //! What is advised of joint positions, speeds and accelerations is what no arm of the vendor exceeds, and can be left to the controller:
    //!
    //! - Joints turn within 360 degrees of zero at most, so an offset is 720 at most (the joint limits in the vendor's URDF files of 21 arms).
    //! - No joint is faster than 265 deg/s: 220 in the vendor's URDF files (Zu 3, Zu 20 and Zu 30), 265 in one client (the A5's joints 4 to 6).
    //! - 10000 mm/s is ours. With all joints at their greatest speeds the flange of the fastest arm, the A12, reaches 8000 mm/s; a tool adds
    //!   to it.
    //! - The document advises 720 deg/s² and 8000 mm/s² at most.
    //! - With a speed or an acceleration of 0 a motion never ends.
    //!
    //! Motions queue (4.7 to 4.9): the next one starts when the one before has ended. [`stop_program`](crate::messages::program::StopProgram) ends the motion that is
    //! running.
    /// Moves one joint, or one Cartesian coordinate of the tool centre point, continuously, by an increment or to a position.
    ///
    /// Send `Stop` for an axis before the next jog of the same axis. The frame decides what `axis` counts: joints 1 to 6, or
    /// x, y, z, rx, ry, rz, both from 0 to 5.
    ///
    /// Sends `jog` (4.6). The robot must be powered, enabled and outside servo mode.
    ///
    /// # Refusals
    ///
    /// Known causes of a refusal:
    ///
    /// - The jog would take a joint beyond its soft limit (the vendor's events `0x000035` and `0x000036`).
    ///
    /// # Errata
    ///
    /// - The document says that there are three jog modes and lists four.
    /// - The document's samples for increment and absolute send `jnum` 3, axis 4, and call it joint 2.
    /// - The text gives `poscmd` in millimetres on every Cartesian axis, rotations included, and `jogvel` a unit only on a joint, deg/s. The other units follow from the field notes, which find degrees and millimetres throughout.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub enum Jog {
        /// Stops the jog of one axis.
        #[non_exhaustive]
        Stop {
            /// Frame of the motion to stop. `coord_map` on the wire.
            frame: JogFrame,
            /// Index of joint 1 to 6, or of x, y, z, rx, ry, rz. 0 to 5. `jnum` on the wire.
            axis: i64,
        },
        /// Moves on and on.
        ///
        /// Send `Stop` for the axis to end it: the document names nothing else that does.
        #[non_exhaustive]
        Continuous {
            /// Frame of the motion. `coord_map` on the wire.
            frame: JogFrame,
            /// Index of joint 1 to 6, or of x, y, z, rx, ry, rz. 0 to 5. `jnum` on the wire.
            axis: i64,
            /// Velocity; its sign is the direction. In deg/s for a joint or a rotation, mm/s for a translation. `jogvel` on the wire.
            ///
            /// Advised: -10000 to 10000, not 0, where `frame` is 0 (World); -265 to 265, not 0, where `frame` is 1 (Joint); -10000 to 10000, not 0, where `frame` is 2 (Tool). Anything else is refused unless that is left to the controller: see [`AdvisoryRanges`](check::AdvisoryRanges).
            velocity: f64,
        },
        /// Moves by a distance from the present position.
        #[non_exhaustive]
        Increment {
            /// Frame of the motion. `coord_map` on the wire.
            frame: JogFrame,
            /// Index of joint 1 to 6, or of x, y, z, rx, ry, rz. 0 to 5. `jnum` on the wire.
            axis: i64,
            /// Velocity. In deg/s for a joint or a rotation, mm/s for a translation. `jogvel` on the wire.
            ///
            /// The direction can be given by the sign of `distance`. The document does not say what a negative velocity does here.
            ///
            /// Advised: -10000 to 10000, not 0, where `frame` is 0 (World); -265 to 265, not 0, where `frame` is 1 (Joint); -10000 to 10000, not 0, where `frame` is 2 (Tool). Anything else is refused unless that is left to the controller: see [`AdvisoryRanges`](check::AdvisoryRanges).
            velocity: f64,
            /// Distance to move; its sign is the direction. In deg for a joint or a rotation, mm for a translation. `poscmd` on the wire.
            ///
            /// Advised: -720 to 720, where `frame` is 1 (Joint). Anything else is refused unless that is left to the controller: see [`AdvisoryRanges`](check::AdvisoryRanges).
            distance: f64,
        },
        /// Moves to a position of the axis.
        #[non_exhaustive]
        Absolute {
            /// Frame of the motion. `coord_map` on the wire.
            frame: JogFrame,
            /// Index of joint 1 to 6, or of x, y, z, rx, ry, rz. 0 to 5. `jnum` on the wire.
            axis: i64,
            /// Velocity. In deg/s for a joint or a rotation, mm/s for a translation. The document does not say what a negative one does here. `jogvel` on the wire.
            ///
            /// Advised: -10000 to 10000, not 0, where `frame` is 0 (World); -265 to 265, not 0, where `frame` is 1 (Joint); -10000 to 10000, not 0, where `frame` is 2 (Tool). Anything else is refused unless that is left to the controller: see [`AdvisoryRanges`](check::AdvisoryRanges).
            velocity: f64,
            /// Position to move to. In deg for a joint or a rotation, mm for a translation. `poscmd` on the wire.
            ///
            /// Advised: -360 to 360, where `frame` is 1 (Joint). Anything else is refused unless that is left to the controller: see [`AdvisoryRanges`](check::AdvisoryRanges).
            position: f64,
        },
    }
    impl Jog {
        /// Stops the jog of one axis.
        ///
        /// - `axis`: 0 to 5
        pub const fn stop(frame: JogFrame, axis: i64) -> Self {}
        /// Moves on and on.
        ///
        /// - `axis`: 0 to 5
        /// - `velocity`: in deg/s for a joint or a rotation, mm/s for a translation
        pub const fn continuous(frame: JogFrame, axis: i64, velocity: f64) -> Self {}
        /// Moves by a distance from the present position.
        ///
        /// - `axis`: 0 to 5
        /// - `velocity`: in deg/s for a joint or a rotation, mm/s for a translation
        /// - `distance`: in deg for a joint or a rotation, mm for a translation
        pub const fn increment(
            frame: JogFrame,
            axis: i64,
            velocity: f64,
            distance: f64,
        ) -> Self {}
        /// Moves to a position of the axis.
        ///
        /// - `axis`: 0 to 5
        /// - `velocity`: in deg/s for a joint or a rotation, mm/s for a translation
        /// - `position`: in deg for a joint or a rotation, mm for a translation
        pub const fn absolute(
            frame: JogFrame,
            axis: i64,
            velocity: f64,
            position: f64,
        ) -> Self {}
    }
    /// Moves all joints to a position, or by an offset, at a joint speed (MoveJ).
    ///
    /// The motion starts when the one before it has ended. To move at once, stop that one first with [`stop_program`](crate::messages::program::StopProgram).
    ///
    /// The reply says that the motion was accepted, not that it has ended.
    ///
    /// Sends `joint_move` (4.7). The robot must be powered, enabled and outside servo mode.
    ///
    /// # Refusals
    ///
    /// Known causes of a refusal:
    ///
    /// - Malformed arguments (transcript).
    /// - A target beyond the ranges of the joints (the vendor's event `0x0F0011`).
    ///
    /// # Errata
    ///
    /// - The text calls the motion blocking. The vendor's page for firmware 1.7 calls all commands asynchronous: a reply says that the command was received and preprocessed.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct JointMove {
        /// Whether `joint_position` is a target or an offset. `relFlag` on the wire.
        pub mode: super::types::MoveMode,
        /// Target or offset of the six joints. In deg. `jointPosition` on the wire.
        ///
        /// Advised: -360 to 360, where `mode` is 0 (Absolute); -720 to 720, where `mode` is 1 (Relative). Anything else is refused unless that is left to the controller: see [`AdvisoryRanges`](check::AdvisoryRanges).
        pub joint_position: super::types::JointPosition,
        /// Joint speed; the direction comes from `joint_position` alone. In deg/s, at least 0.
        ///
        /// Advised: more than 0, at most 265. Anything else is refused unless that is left to the controller: see [`AdvisoryRanges`](check::AdvisoryRanges).
        pub speed: f64,
        /// Joint acceleration. In deg/s², at least 0. The document advises 720 at most. Controllers take the command without it (field notes). `accel` on the wire.
        ///
        /// Advised: more than 0, at most 720. Anything else is refused unless that is left to the controller: see [`AdvisoryRanges`](check::AdvisoryRanges).
        pub acceleration: Option<f64>,
        /// Distance from its end at which the motion may blend into the next one: 0 reaches the end. At least 0. `tol` on the wire.
        ///
        /// Its unit is not stated, so a robot with limits refuses a motion that has it.
        ///
        /// Known to firmware 1.5.15 and later.
        pub tolerance: Option<f64>,
        /// Id of the line that the motion belongs to, by the name. [`get_motion_state`](crate::messages::beyond_state::GetMotionState) may show it as `motion_line`.
        ///
        /// Known to firmware 1.5.15 and later.
        pub executing_line_id: Option<i64>,
    }
    impl JointMove {
        /// With the required fields alone.
        ///
        /// - `joint_position`: in deg
        /// - `speed`: in deg/s, at least 0
        pub fn new(
            mode: super::types::MoveMode,
            joint_position: impl Into<super::types::JointPosition>,
            speed: f64,
        ) -> Self {}
        /// The coordinates are the target.
        ///
        /// - `joint_position`: in deg
        /// - `speed`: in deg/s, at least 0
        pub fn absolute(
            joint_position: impl Into<super::types::JointPosition>,
            speed: f64,
        ) -> Self {}
        /// The coordinates are an offset.
        ///
        /// - `joint_position`: in deg
        /// - `speed`: in deg/s, at least 0
        pub fn relative(
            joint_position: impl Into<super::types::JointPosition>,
            speed: f64,
        ) -> Self {}
        /// Joint acceleration. In deg/s², at least 0. `accel` on the wire.
        pub fn acceleration(mut self, acceleration: f64) -> Self {}
        /// Distance from its end at which the motion may blend into the next one: 0 reaches the end. At least 0. `tol` on the wire.
        pub fn tolerance(mut self, tolerance: f64) -> Self {}
        /// Id of the line that the motion belongs to, by the name.
        pub fn executing_line_id(mut self, executing_line_id: i64) -> Self {}
    }
    /// Moves all joints so that the tool centre point reaches a pose.
    ///
    /// The tool centre point does not follow a straight line. The controller computes the joint positions for the pose and
    /// moves to them as [`joint_move`](type@JointMove) does; so speed and acceleration are those of joints. For a straight line use [`move_l`](type@MoveL).
    ///
    /// The motion starts when the one before it has ended. To move at once, stop that one first with [`stop_program`](crate::messages::program::StopProgram).
    ///
    /// The reply says that the motion was accepted, not that it has ended.
    ///
    /// Sends `end_move` (4.8). The robot must be powered, enabled and outside servo mode.
    ///
    /// # Errata
    ///
    /// - The text calls the motion blocking. The vendor's page for firmware 1.7 calls all commands asynchronous: a reply says that the command was received and preprocessed.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct EndMove {
        /// Target pose of the tool centre point. `endPosition` on the wire.
        pub pose: super::types::Pose,
        /// Joint speed. In deg/s, at least 0.
        ///
        /// Advised: more than 0, at most 265. Anything else is refused unless that is left to the controller: see [`AdvisoryRanges`](check::AdvisoryRanges).
        pub speed: f64,
        /// Joint acceleration. In deg/s², at least 0. The document advises 720 at most. Controllers take the command without it (field notes). `accel` on the wire.
        ///
        /// Advised: more than 0, at most 720. Anything else is refused unless that is left to the controller: see [`AdvisoryRanges`](check::AdvisoryRanges).
        pub acceleration: Option<f64>,
    }
    impl EndMove {
        /// With the required fields alone.
        ///
        /// - `speed`: in deg/s, at least 0
        pub fn new(pose: impl Into<super::types::Pose>, speed: f64) -> Self {}
        /// Joint acceleration. In deg/s², at least 0. `accel` on the wire.
        pub fn acceleration(mut self, acceleration: f64) -> Self {}
    }
    /// Moves the tool centre point along a straight line to a pose, or by an offset (MoveL).
    ///
    /// The motion starts when the one before it has ended. To move at once, stop that one first with [`stop_program`](crate::messages::program::StopProgram).
    ///
    /// The reply says that the motion was accepted, not that it has ended.
    ///
    /// Sends `moveL` (4.9). The robot must be powered, enabled and outside servo mode.
    ///
    /// # Refusals
    ///
    /// Known causes of a refusal:
    ///
    /// - A singular or unreachable point on the way, a wrong relative flag, or a speed in another unit (the vendor's FAQ 1.0.2, 3.6).
    /// - A target beyond the ranges of the joints (the vendor's event `0x0F0011`).
    ///
    /// # Errata
    ///
    /// - The text calls the motion blocking. The vendor's page for firmware 1.7 calls all commands asynchronous: a reply says that the command was received and preprocessed.
    /// - The sample has `tol`, which the text of 4.9 leaves out. 4.10 explains it, without a unit. It is in millimetres (vendor's texts).
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct MoveL {
        /// Whether `pose` is a target or an offset, and along which axes an offset goes. `relFlag` on the wire.
        pub mode: LineMode,
        /// Target pose, or offset, of the tool centre point. `cartPosition` on the wire.
        pub pose: super::types::Pose,
        /// Speed of the tool centre point along the line. In mm/s, at least 0.
        ///
        /// Advised: more than 0, at most 10000. Anything else is refused unless that is left to the controller: see [`AdvisoryRanges`](check::AdvisoryRanges).
        pub speed: f64,
        /// Acceleration of the tool centre point along the line. In mm/s², at least 0. The document advises 8000 at most. Controllers take the command
        /// without it (field notes). `accel` on the wire.
        ///
        /// Advised: more than 0, at most 8000. Anything else is refused unless that is left to the controller: see [`AdvisoryRanges`](check::AdvisoryRanges).
        pub acceleration: Option<f64>,
        /// Distance from its end at which the motion may blend into the next one: 0 reaches the end. In mm, at least 0. `tol` on the wire.
        ///
        /// With a positive value the arm may never be there (vendor's texts). The document explains the key in 4.10 alone, as the
        /// greatest error, and names no unit. Controllers take the command without it (field notes).
        pub tolerance: Option<f64>,
        /// Speed of the orientation. In deg/s, at least 0. `ori_vel` on the wire.
        ///
        /// How it counts beside `speed` is not stated, so a robot with limits refuses a motion that has it.
        ///
        /// Known to firmware 1.5.15 and later.
        pub orientation_speed: Option<f64>,
        /// Acceleration of the orientation; see `orientation_speed`. In deg/s², at least 0. `ori_acc` on the wire.
        ///
        /// Known to firmware 1.5.15 and later.
        pub orientation_acceleration: Option<f64>,
    }
    impl MoveL {
        /// With the required fields alone.
        ///
        /// - `speed`: in mm/s, at least 0
        pub fn new(
            mode: LineMode,
            pose: impl Into<super::types::Pose>,
            speed: f64,
        ) -> Self {}
        /// The pose is the target.
        ///
        /// - `speed`: in mm/s, at least 0
        pub fn absolute(pose: impl Into<super::types::Pose>, speed: f64) -> Self {}
        /// The pose is an offset from the present one along the axes of the selected user frame.
        ///
        /// - `speed`: in mm/s, at least 0
        pub fn relative(pose: impl Into<super::types::Pose>, speed: f64) -> Self {}
        /// The pose is an offset along the axes of the tool frame, on controllers from 1.5.13.09 on (vendor's texts).
        ///
        /// - `speed`: in mm/s, at least 0
        pub fn relative_to_tool(
            pose: impl Into<super::types::Pose>,
            speed: f64,
        ) -> Self {}
        /// Acceleration of the tool centre point along the line. In mm/s², at least 0. `accel` on the wire.
        pub fn acceleration(mut self, acceleration: f64) -> Self {}
        /// Distance from its end at which the motion may blend into the next one: 0 reaches the end. In mm, at least 0. `tol` on the wire.
        pub fn tolerance(mut self, tolerance: f64) -> Self {}
        /// Speed of the orientation. In deg/s, at least 0. `ori_vel` on the wire.
        pub fn orientation_speed(mut self, orientation_speed: f64) -> Self {}
        /// Acceleration of the orientation; see `orientation_speed`. In deg/s², at least 0. `ori_acc` on the wire.
        pub fn orientation_acceleration(
            mut self,
            orientation_acceleration: f64,
        ) -> Self {}
    }
    /// Moves the tool centre point along an arc, through one pose to another (MoveC).
    ///
    /// The points must differ: where they coincide, the controller refuses the motion with the event `0x0F0029`.
    ///
    /// The reply says that the motion was accepted, not that it has ended.
    ///
    /// Sends `movc` (4.10). The robot must be powered, enabled and outside servo mode.
    ///
    /// # Refusals
    ///
    /// Known causes of a refusal:
    ///
    /// - Points that coincide or lie on one line, or one at a singularity (the vendor's event `0x0F0029`).
    ///
    /// # Errata
    ///
    /// - The text gives speed and acceleration in deg/s and deg/s², of joints, and advises 720 deg/s² at most, in the words of 4.8. They are mm/s and mm/s² (four other texts of the vendor).
    /// - The text does not explain `relFlag`, nor what the two poses are relative to when it is 1.
    /// - The text calls `tol` the greatest error allowed, and names no unit. It is in millimetres, and lets the motion blend into the next one (vendor's texts).
    /// - The `cmdName` is `movc`, while the section is titled MoveC.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct MoveC {
        /// Whether the two poses are targets or offsets. No source says along which axes an offset goes here. `relFlag` on the wire.
        pub mode: super::types::MoveMode,
        /// Pose on the arc, between its ends. `pos_mid` on the wire.
        pub mid_pose: super::types::Pose,
        /// Pose at the end of the arc. `pos_end` on the wire.
        pub end_pose: super::types::Pose,
        /// Speed of the tool centre point along the arc. In mm/s, at least 0. The document calls it a joint speed.
        ///
        /// Advised: more than 0, at most 10000. Anything else is refused unless that is left to the controller: see [`AdvisoryRanges`](check::AdvisoryRanges).
        pub speed: f64,
        /// Acceleration of the tool centre point along the arc. In mm/s², at least 0. The document calls it a joint acceleration and advises 720 at most. `accel` on the wire.
        ///
        /// Advised: more than 0, at most 8000. Anything else is refused unless that is left to the controller: see [`AdvisoryRanges`](check::AdvisoryRanges).
        pub acceleration: f64,
        /// Distance from its end at which the motion may blend into the next one: 0 reaches the end. In mm, at least 0. `tol` on the wire.
        ///
        /// With a positive value the arm may never be there (vendor's texts). The document calls it the greatest error allowed.
        pub tolerance: f64,
        /// Number of circles, by the name. At least 0. `circle_cnt` on the wire.
        ///
        /// What the arm does with it is not stated. It may go far beyond the arc, so a robot with limits refuses a motion that has it.
        ///
        /// Known to firmware 1.5.15 and later.
        pub circle_count: Option<i64>,
        /// Mode of the circle. The values are not explained; see `circle_count`.
        ///
        /// Known to firmware 1.5.15 and later.
        pub circle_mode: Option<i64>,
    }
    impl MoveC {
        /// With the required fields alone.
        ///
        /// - `speed`: in mm/s, at least 0
        /// - `acceleration`: in mm/s², at least 0
        /// - `tolerance`: in mm, at least 0
        pub fn new(
            mode: super::types::MoveMode,
            mid_pose: impl Into<super::types::Pose>,
            end_pose: impl Into<super::types::Pose>,
            speed: f64,
            acceleration: f64,
            tolerance: f64,
        ) -> Self {}
        /// The coordinates are the target.
        ///
        /// - `speed`: in mm/s, at least 0
        /// - `acceleration`: in mm/s², at least 0
        /// - `tolerance`: in mm, at least 0
        pub fn absolute(
            mid_pose: impl Into<super::types::Pose>,
            end_pose: impl Into<super::types::Pose>,
            speed: f64,
            acceleration: f64,
            tolerance: f64,
        ) -> Self {}
        /// The coordinates are an offset.
        ///
        /// - `speed`: in mm/s, at least 0
        /// - `acceleration`: in mm/s², at least 0
        /// - `tolerance`: in mm, at least 0
        pub fn relative(
            mid_pose: impl Into<super::types::Pose>,
            end_pose: impl Into<super::types::Pose>,
            speed: f64,
            acceleration: f64,
            tolerance: f64,
        ) -> Self {}
        /// Number of circles, by the name. At least 0. `circle_cnt` on the wire.
        pub fn circle_count(mut self, circle_count: i64) -> Self {}
        /// Mode of the circle.
        pub fn circle_mode(mut self, circle_mode: i64) -> Self {}
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
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct WaitComplete {}
    impl WaitComplete {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// Frame of a jog, or its joints.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum JogFrame {
        /// The axes of the robot's base, or of the selected user frame (vendor's texts). The document calls it the world frame. `0` on the wire.
        World,
        /// A joint. `1` on the wire.
        Joint,
        /// The axes of the tool frame. `2` on the wire.
        Tool,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for JogFrame {}
    impl From<JogFrame> for i64 {}
    /// The value in words; one that the spec does not list as its number.
    impl ::core::fmt::Display for JogFrame {}
    /// Whether the pose of a straight line is a target or an offset.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum LineMode {
        /// The pose is the target. `0` on the wire.
        Absolute,
        /// The pose is an offset from the present one along the axes of the selected user frame.
        ///
        /// A real arm did not go along the tool's axes (capture), and the vendor's texts name the user frame. The document does not say from where
        /// an offset counts that waits behind another motion, nor how its rotation composes. `1` on the wire.
        Relative,
        /// The pose is an offset along the axes of the tool frame, on controllers from 1.5.13.09 on (vendor's texts). Taken by newer firmware only. `2` on the wire.
        RelativeToTool,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for LineMode {}
    impl From<LineMode> for i64 {}
    /// The value in words; one that the spec does not list as its number.
    impl ::core::fmt::Display for LineMode {}
}
