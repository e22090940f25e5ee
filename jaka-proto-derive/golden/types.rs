/// Types that several topics share.
///
/// Angles are degrees and lengths millimetres, as on the wire.
pub mod types {
    #[allow(unused_imports)]
    use ::jaka_proto::{self as proto, check, wire};
    /// Positions, or offsets, of joints 1 to 6. In deg.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct JointPosition(pub [f64; 6]);
    impl From<[f64; 6]> for JointPosition {
        fn from(value: [f64; 6]) -> Self {
            Self(value)
        }
    }
    impl From<JointPosition> for [f64; 6] {
        fn from(value: JointPosition) -> Self {
            value.0
        }
    }
    impl wire::Encode for JointPosition {
        fn encode(&self, out: &mut wire::Writer) {
            wire::Encode::encode(&self.0, out);
        }
    }
    impl wire::Decode for JointPosition {
        fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
            wire::Decode::decode(reader).map(Self)
        }
    }
    proto::__serde_impls!(JointPosition);
    impl check::Validate for JointPosition {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            let limits = check::Limits {
                unit: "deg",
                ..*limits
            };
            check::Validate::validate(&self.0, place, &limits)
        }
    }
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
    impl wire::Encode for Pose {
        fn encode(&self, out: &mut wire::Writer) {
            out.raw("[");
            wire::Encode::encode(&self.x, out);
            out.raw(",");
            wire::Encode::encode(&self.y, out);
            out.raw(",");
            wire::Encode::encode(&self.z, out);
            out.raw(",");
            wire::Encode::encode(&self.rx, out);
            out.raw(",");
            wire::Encode::encode(&self.ry, out);
            out.raw(",");
            wire::Encode::encode(&self.rz, out);
            out.raw("]");
        }
    }
    impl wire::Decode for Pose {
        fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
            reader.begin_array()?;
            let this = Self {
                x: reader.element("x")?,
                y: reader.element("y")?,
                z: reader.element("z")?,
                rx: reader.element("rx")?,
                ry: reader.element("ry")?,
                rz: reader.element("rz")?,
            };
            reader.end_exact_array()?;
            Ok(this)
        }
    }
    proto::__serde_impls!(Pose);
    impl From<[f64; 6]> for Pose {
        fn from([x, y, z, rx, ry, rz]: [f64; 6]) -> Self {
            Self { x, y, z, rx, ry, rz }
        }
    }
    impl From<Pose> for [f64; 6] {
        fn from(value: Pose) -> Self {
            [value.x, value.y, value.z, value.rx, value.ry, value.rz]
        }
    }
    impl check::Validate for Pose {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place
                .check(
                    "x",
                    &self.x,
                    &check::Limits {
                        unit: "mm",
                        ..check::Limits::NONE
                    },
                )?;
            place
                .check(
                    "y",
                    &self.y,
                    &check::Limits {
                        unit: "mm",
                        ..check::Limits::NONE
                    },
                )?;
            place
                .check(
                    "z",
                    &self.z,
                    &check::Limits {
                        unit: "mm",
                        ..check::Limits::NONE
                    },
                )?;
            place
                .check(
                    "rx",
                    &self.rx,
                    &check::Limits {
                        unit: "deg",
                        ..check::Limits::NONE
                    },
                )?;
            place
                .check(
                    "ry",
                    &self.ry,
                    &check::Limits {
                        unit: "deg",
                        ..check::Limits::NONE
                    },
                )?;
            place
                .check(
                    "rz",
                    &self.rz,
                    &check::Limits {
                        unit: "deg",
                        ..check::Limits::NONE
                    },
                )?;
            Ok(())
        }
    }
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
    impl From<i64> for MoveMode {
        fn from(value: i64) -> Self {
            match value {
                0 => Self::Absolute,
                1 => Self::Relative,
                other => Self::Other(other),
            }
        }
    }
    impl From<MoveMode> for i64 {
        fn from(value: MoveMode) -> Self {
            match value {
                MoveMode::Absolute => 0,
                MoveMode::Relative => 1,
                MoveMode::Other(other) => other,
            }
        }
    }
    proto::__int_enum_impls!(MoveMode);
    impl check::Validate for MoveMode {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            let standing = match self {
                Self::Absolute | Self::Relative => check::Standing::Listed,
                Self::Other(_) => check::Standing::Unknown,
            };
            place.listed(&i64::from(*self), standing, "0 (Absolute) or 1 (Relative)")
        }
    }
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
    impl From<i64> for Switch {
        fn from(value: i64) -> Self {
            match value {
                0 => Self::Off,
                1 => Self::On,
                other => Self::Other(other),
            }
        }
    }
    impl From<Switch> for i64 {
        fn from(value: Switch) -> Self {
            match value {
                Switch::Off => 0,
                Switch::On => 1,
                Switch::Other(other) => other,
            }
        }
    }
    proto::__int_enum_impls!(Switch);
    impl check::Validate for Switch {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            let standing = match self {
                Self::Off | Self::On => check::Standing::Listed,
                Self::Other(_) => check::Standing::Unknown,
            };
            place.listed(&i64::from(*self), standing, "0 (Off) or 1 (On)")
        }
    }
}
