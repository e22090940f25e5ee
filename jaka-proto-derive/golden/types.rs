pub mod types {
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct JointPosition(pub [f64; 6]);
    impl From<[f64; 6]> for JointPosition {}
    impl From<JointPosition> for [f64; 6] {}
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Pose {
        // unit "mm"
        pub x: f64,
        // unit "mm"
        pub y: f64,
        // unit "mm"
        pub z: f64,
        // unit "deg"
        pub rx: f64,
        // unit "deg"
        pub ry: f64,
        // unit "deg"
        pub rz: f64,
    }
    impl From<[f64; 6]> for Pose {}
    impl From<Pose> for [f64; 6] {}
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum MoveMode {
        Absolute,
        Relative,
        Other(i64),
    }
    impl From<i64> for MoveMode {}
    impl From<MoveMode> for i64 {}
    impl ::core::fmt::Display for MoveMode {}
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum Switch {
        Off,
        On,
        Other(i64),
    }
    impl From<i64> for Switch {}
    impl From<Switch> for i64 {}
    impl ::core::fmt::Display for Switch {}
}
