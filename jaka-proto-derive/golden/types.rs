/// Types that several topics share.
///
/// Angles are degrees and lengths millimetres, as on the wire.
pub mod types {
    /// Positions, or offsets, of joints 1 to 6. In deg.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct JointPosition(pub [f64; 6]);
    impl From<[f64; 6]> for JointPosition {}
    impl From<JointPosition> for [f64; 6] {}
    /// Position and orientation of a frame, or an offset from one.
    ///
    /// The orientation is given by Euler angles in the order x, y, z (4.16). Some sections call them a, b, c.
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
        /// Rotation about x. In deg.
        pub rx: f64,
        /// Rotation about y. In deg.
        pub ry: f64,
        /// Rotation about z. In deg.
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
        /// The document does not say from which position it counts, nor, for a pose, along the axes of which frame. Try a small
        /// one first. `1` on the wire.
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
