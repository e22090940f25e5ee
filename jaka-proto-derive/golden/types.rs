pub mod types {
    //! Types that several topics share.
    //!
    //! Angles are degrees and lengths millimetres, as on the wire.
    /// Positions, or offsets, of joints 1 to 6. In deg.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct JointPosition(pub [f64; 6]);
    impl From<[f64; 6]> for JointPosition {}
    impl From<JointPosition> for [f64; 6] {}
    /// Position and orientation of a frame, or an offset from one.
    ///
    /// The orientation is turned about the fixed axes x, then y, then z, so that its matrix is Rz(rz) Ry(ry) Rx(rx): the same as moving
    /// axes z, y, x. Four pairs of joint positions and pose of a real arm agree with this to 0.0000 degrees. The document speaks of Euler angles
    /// in the order x, y, z (4.16), which misleads. Some sections call the angles a, b, c.
    ///
    /// Sections 4.16 and 4.47 state the units. Elsewhere the document leaves them out; the field notes find the same
    /// throughout.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Pose {
        /// Position along x. In mm.
        pub x: f64,
        /// Position along y. In mm.
        pub y: f64,
        /// Position along z. In mm.
        pub z: f64,
        /// Rotation about the fixed axis x, the first of the three. In deg.
        pub rx: f64,
        /// Rotation about the fixed axis y, the second. In deg.
        pub ry: f64,
        /// Rotation about the fixed axis z, the third. In deg.
        pub rz: f64,
    }
    impl From<[f64; 6]> for Pose {}
    impl From<Pose> for [f64; 6] {}
    /// Whether a motion's coordinates are a target or an offset.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum MoveMode {
        /// The coordinates are the target. `0` on the wire.
        Absolute,
        /// The coordinates are an offset.
        ///
        /// The document does not say from which position it counts, and no source says, for a pose of [`move_c`](crate::messages::motion::MoveC) or [`servo_p`](crate::messages::servo::ServoP), along the axes of
        /// which frame. Try a small one first. `1` on the wire.
        Relative,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for MoveMode {}
    impl From<MoveMode> for i64 {}
    /// The value in words; one that the spec does not list as its number.
    impl ::core::fmt::Display for MoveMode {}
    /// Off or on.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum Switch {
        /// Off. `0` on the wire.
        Off,
        /// On. `1` on the wire.
        On,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for Switch {}
    impl From<Switch> for i64 {}
    /// The value in words; one that the spec does not list as its number.
    impl ::core::fmt::Display for Switch {}
}
