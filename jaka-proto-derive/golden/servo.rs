pub mod servo {
    //! Servo mode.
    //!
    //! In servo mode the arm follows set-points that come one by one, without the controller's planner between them.
    //!
    //! A set-point is due every 8 ms, or every multiple of it that `step_count` gives, and each is answered. Plan the
    //! trajectory beforehand: what the set-points ask goes straight to the drives. Send each at once, with TCP_NODELAY (field notes). For other purposes the document advises
    //! [`joint_move`](crate::messages::motion::JointMove) and [`move_l`](crate::messages::motion::MoveL).
    //!
    //! What is advised of an offset is what no arm of the vendor does in one controller cycle of 8 ms: 2.12 deg of a joint (265 deg/s, the
    //! greatest speed that any source gives for a joint), and, both ours, 80 mm (10000 mm/s) and 9 deg of the tool centre point; with all
    //! joints at their greatest speeds the flange of the fastest arms reaches 8000 mm/s (A12) and 1060 deg/s (A5). How far a set-point is
    //! from the one before it is not looked at. That `step_count` is 12 at most is ours: the arm follows no set-point for 96 ms.
    /// Reads whether the robot is in servo mode.
    ///
    /// Sends `is_in_servomove` (4.13). Changes nothing on the robot. The reply is [`IsInServomoveReply`].
    ///
    /// # Errata
    ///
    /// - The text explains `relFlag`, which neither request nor reply has; it belongs to [`servo_move`](type@SetServoMode) (4.14).
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct IsInServomove {}
    impl IsInServomove {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@IsInServomove`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct IsInServomoveReply {
        /// Whether the robot is in servo mode. `in_servomove` on the wire.
        pub in_servo_mode: bool,
    }
    /// Enters or leaves servo mode.
    ///
    /// An arm at rest enters at once: within 9 ms on firmware 1.5.14. While the arm moves, the command is acknowledged and servo mode is not
    /// entered: [`is_in_servomove`](type@IsInServomove) stays false, and [`servo_j`](type@ServoJ) is refused with code -1 (two transcripts of firmware 1.5.14). So send it to an arm
    /// at rest, and ask [`is_in_servomove`](type@IsInServomove) before the first set-point.
    ///
    /// Sends `servo_move` (4.14). The robot must be powered and enabled.
    ///
    /// # Errata
    ///
    /// - The key `relFlag` means enter or leave here. In other commands it chooses between target and offset.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetServoMode {
        /// On to enter servo mode, off to leave it. `relFlag` on the wire.
        pub servo_mode: super::types::Switch,
    }
    impl SetServoMode {
        /// With the required fields alone.
        pub const fn new(servo_mode: super::types::Switch) -> Self {}
    }
    /// Moves all joints to a set-point, or by an offset, within one servo period.
    ///
    /// The planner does not interpolate: set-points must follow one another every 8 ms times `step_count`, and a single one
    /// shows no effect. A set-point that asks more than 180 deg/s of a joint has no effect: the document's example is 1.5
    /// degrees in 8 ms, which is 187.5 deg/s.
    ///
    /// Every set-point is answered. The answers need not be waited for, but must be read. Enter servo mode with [`servo_move`](type@SetServoMode)
    /// first.
    ///
    /// Sends `servo_j` (4.15). The robot must be powered, enabled and in servo mode.
    ///
    /// # Errata
    ///
    /// - The text writes the key `stepnum`, the sample `stepNum`.
    /// - The text asks for a set-point every 8 ms, and for one every 8 ms times `stepnum`. Field notes: the latter.
    /// - The text calls [`joint_move`](crate::messages::motion::JointMove) the fifth command. It is in 4.7.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct ServoJ {
        /// Whether `joint_position` is a target or an offset. `relFlag` on the wire.
        pub mode: super::types::MoveMode,
        /// Set-point, or offset, of the six joints. In deg. `jointPosition` on the wire.
        ///
        /// Advised: -360 to 360, where `mode` is 0 (Absolute); -2.12 to 2.12, times `step_count`, where `mode` is 1 (Relative). Anything else is refused unless that is left to the controller: see [`AdvisoryRanges`](check::AdvisoryRanges).
        pub joint_position: super::types::JointPosition,
        /// Length of the servo period as a multiple of the controller cycle of 8 ms. At least 1. Controllers take the command without it (field
        /// notes). `stepNum` on the wire.
        ///
        /// Advised: 1 to 12. Anything else is refused unless that is left to the controller: see [`AdvisoryRanges`](check::AdvisoryRanges).
        pub step_count: Option<i64>,
    }
    impl ServoJ {
        /// With the required fields alone.
        ///
        /// - `joint_position`: in deg
        pub fn new(
            mode: super::types::MoveMode,
            joint_position: impl Into<super::types::JointPosition>,
        ) -> Self {}
        /// The coordinates are the target.
        ///
        /// - `joint_position`: in deg
        pub fn absolute(joint_position: impl Into<super::types::JointPosition>) -> Self {}
        /// The coordinates are an offset.
        ///
        /// - `joint_position`: in deg
        pub fn relative(joint_position: impl Into<super::types::JointPosition>) -> Self {}
        /// Length of the servo period as a multiple of the controller cycle of 8 ms. At least 1. `stepNum` on the wire.
        pub fn step_count(mut self, step_count: i64) -> Self {}
    }
    /// Moves the tool centre point to a set-point, or by an offset, within one servo period.
    ///
    /// The planner does not interpolate: set-points must follow one another every 8 ms times `step_count`. Keep the steps
    /// between them small, so that the controller's speed limits are not exceeded; the document names no number.
    ///
    /// Every set-point is answered. The answers need not be waited for, but must be read. Enter servo mode with [`servo_move`](type@SetServoMode)
    /// first.
    ///
    /// Sends `servo_p` (4.16). The robot must be powered, enabled and in servo mode.
    ///
    /// # Errata
    ///
    /// - The text calls the orientation Euler angles in the order x, y, z. The turns are about fixed axes: R = Rz(rz) Ry(ry) Rx(rx) (capture).
    /// - The key is spelled `catPosition`, and controllers expect it so. Other commands have `cartPosition`.
    /// - The text writes the key `stepnum`, the sample `stepNum`.
    /// - The text asks for a set-point every 8 ms, and for one every 8 ms times `stepnum`. Field notes: the latter.
    /// - The text speaks of points of the six joints and of [`servo_j`](type@ServoJ), as copied from 4.15. The set-point is a pose.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct ServoP {
        /// Set-point, or offset, of the tool centre point. `catPosition` on the wire.
        ///
        /// Advised: -80 to 80 mm, times `step_count`, where `mode` is 1 (Relative); -9 to 9 deg, times `step_count`, where `mode` is 1 (Relative). Anything else is refused unless that is left to the controller: see [`AdvisoryRanges`](check::AdvisoryRanges).
        pub pose: super::types::Pose,
        /// Whether `pose` is a target or an offset. `relFlag` on the wire.
        pub mode: super::types::MoveMode,
        /// Length of the servo period as a multiple of the controller cycle of 8 ms. At least 1. Controllers take the command without it (field
        /// notes). `stepNum` on the wire.
        ///
        /// Advised: 1 to 12. Anything else is refused unless that is left to the controller: see [`AdvisoryRanges`](check::AdvisoryRanges).
        pub step_count: Option<i64>,
    }
    impl ServoP {
        /// With the required fields alone.
        pub fn new(
            pose: impl Into<super::types::Pose>,
            mode: super::types::MoveMode,
        ) -> Self {}
        /// The coordinates are the target.
        pub fn absolute(pose: impl Into<super::types::Pose>) -> Self {}
        /// The coordinates are an offset.
        pub fn relative(pose: impl Into<super::types::Pose>) -> Self {}
        /// Length of the servo period as a multiple of the controller cycle of 8 ms. At least 1. `stepNum` on the wire.
        pub fn step_count(mut self, step_count: i64) -> Self {}
    }
    /// Sets the filter that smooths the set-points of servo mode.
    ///
    /// It can be set only outside servo mode. Filters 1, 2, 3 and 5 act on [`servo_j`](type@ServoJ) and [`servo_p`](type@ServoP), filter 4 on [`servo_p`](type@ServoP) alone (vendor's
    /// texts).
    ///
    /// Sends `set_servo_move_filter` (4.60). The robot must be outside servo mode.
    ///
    /// # Errata
    ///
    /// - The text calls `filter_type` the motion mode, as copied from 4.6.
    /// - The text writes the keys `max_vr`, `max_ar`, `max_jr`, `max_vp`, `max_ap` and `max_jp`. The samples have `nlf_` before each of them.
    /// - The limits on rotation are printed in %/s, %/s^2 and %/s^3, without anything they could be a percentage of. Those of filter 2 are degrees (vendor's texts), and the field notes find degrees throughout.
    /// - The limits of filter 2 are explained as limits on how fast the orientation changes, as those of filter 4, which works in Cartesian space. They are limits of the joints (vendor's texts).
    /// - Filter 5 is listed as speed look-ahead and explained as filter 3, the multi-stage mean filter of the joints.
    /// - `mmf_kp` is explained as coefficient of the position for filter 3, and of the acceleration for filter 5. It is that of the position for both (vendor's texts).
    /// - For filter 5 the text writes the key `max_buf`, the sample `mmf_max_buf`.
    /// - `mmf_ka` is explained as coefficient of acceleration and position. The key speaks of the acceleration alone.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub enum SetServoMoveFilter {
        /// No filter.
        #[non_exhaustive]
        Disabled,
        /// First-order low-pass filter on the joints.
        #[non_exhaustive]
        JointLowPass {
            /// Cut-off frequency. In Hz, at least 0. `lpf_cf` on the wire.
            cutoff_frequency: f64,
        },
        /// Nonlinear filter on the joints.
        #[non_exhaustive]
        JointNonlinear {
            /// Greatest speed of a joint. In deg/s, at least 0. `nlf_max_vr` on the wire.
            max_joint_speed: f64,
            /// Greatest acceleration of a joint. In deg/s², at least 0. `nlf_max_ar` on the wire.
            max_joint_acceleration: f64,
            /// Greatest jerk of a joint. In deg/s³, at least 0. `nlf_max_jr` on the wire.
            max_joint_jerk: f64,
        },
        /// Multi-stage mean filter on the joints.
        #[non_exhaustive]
        JointMean {
            /// Width of the filter's window. At least 0. A wider one smooths more and is less accurate. `mmf_max_buf` on the wire.
            ///
            /// Fewer than 3 buffered points fail, and more than about 100 delay the motion (vendor's texts).
            window_width: i64,
            /// Coefficient for the following of the position. A smaller one smooths more; a greater one is more accurate, but may cause jitter. `mmf_kp` on the wire.
            position_coefficient: f64,
            /// Coefficient for the following of the speed. A smaller one smooths more; a greater one is more accurate, but may cause jitter. `mmf_kv` on the wire.
            speed_coefficient: f64,
            /// Coefficient for the following of the acceleration. A smaller one smooths more; a greater one is more accurate, but may cause
            /// jitter. `mmf_ka` on the wire.
            acceleration_coefficient: f64,
        },
        /// Nonlinear filter in Cartesian space.
        #[non_exhaustive]
        CartesianNonlinear {
            /// Greatest speed at which the orientation changes. In deg/s (printed as %/s), at least 0. `nlf_max_vr` on the wire.
            max_rotation_speed: f64,
            /// Greatest acceleration with which the orientation changes. In deg/s² (printed as %/s²), at least 0. `nlf_max_ar` on the wire.
            max_rotation_acceleration: f64,
            /// Greatest jerk with which the orientation changes. In deg/s³ (printed as %/s³), at least 0. `nlf_max_jr` on the wire.
            max_rotation_jerk: f64,
            /// Greatest speed of the commanded translation in Cartesian space. In mm/s, at least 0. `nlf_max_vp` on the wire.
            max_translation_speed: f64,
            /// Greatest acceleration of the commanded translation in Cartesian space. In mm/s², at least 0. `nlf_max_ap` on the wire.
            max_translation_acceleration: f64,
            /// Greatest jerk of the commanded translation in Cartesian space. In mm/s³, at least 0. `nlf_max_jp` on the wire.
            max_translation_jerk: f64,
        },
        /// Speed look-ahead.
        #[non_exhaustive]
        SpeedLookahead {
            /// Size of the mean filter's buffer. At least 0. `mmf_max_buf` on the wire.
            ///
            /// Fewer than 3 buffered points fail, and more than about 100 delay the motion (vendor's texts).
            buffer_size: i64,
            /// Coefficient for the following of the position. The document calls it a coefficient of the acceleration here. `mmf_kp` on the wire.
            position_coefficient: f64,
        },
    }
    impl SetServoMoveFilter {
        /// No filter.
        pub const fn disabled() -> Self {}
        /// First-order low-pass filter on the joints.
        ///
        /// - `cutoff_frequency`: in Hz, at least 0
        pub const fn joint_low_pass(cutoff_frequency: f64) -> Self {}
        /// Nonlinear filter on the joints.
        ///
        /// - `max_joint_speed`: in deg/s, at least 0
        /// - `max_joint_acceleration`: in deg/s², at least 0
        /// - `max_joint_jerk`: in deg/s³, at least 0
        pub const fn joint_nonlinear(
            max_joint_speed: f64,
            max_joint_acceleration: f64,
            max_joint_jerk: f64,
        ) -> Self {}
        /// Multi-stage mean filter on the joints.
        ///
        /// - `window_width`: at least 0
        pub const fn joint_mean(
            window_width: i64,
            position_coefficient: f64,
            speed_coefficient: f64,
            acceleration_coefficient: f64,
        ) -> Self {}
        /// Nonlinear filter in Cartesian space.
        ///
        /// - `max_rotation_speed`: in deg/s (printed as %/s), at least 0
        /// - `max_rotation_acceleration`: in deg/s² (printed as %/s²), at least 0
        /// - `max_rotation_jerk`: in deg/s³ (printed as %/s³), at least 0
        /// - `max_translation_speed`: in mm/s, at least 0
        /// - `max_translation_acceleration`: in mm/s², at least 0
        /// - `max_translation_jerk`: in mm/s³, at least 0
        pub const fn cartesian_nonlinear(
            max_rotation_speed: f64,
            max_rotation_acceleration: f64,
            max_rotation_jerk: f64,
            max_translation_speed: f64,
            max_translation_acceleration: f64,
            max_translation_jerk: f64,
        ) -> Self {}
        /// Speed look-ahead.
        ///
        /// - `buffer_size`: at least 0
        pub const fn speed_lookahead(
            buffer_size: i64,
            position_coefficient: f64,
        ) -> Self {}
    }
}
