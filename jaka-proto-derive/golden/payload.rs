/// Payload.
///
/// Mass and centroid of what the arm carries.
///
/// The payload at the torque sensor is a setting of its own: see `set_tool_payload`.
pub mod payload {
    #[allow(unused_imports)]
    use ::jaka_proto::{self as proto, check, wire};
    /// Sets the mass and the centroid of the payload.
    ///
    /// Sends `set_payload` (4.42).
    ///
    /// # Errata
    ///
    /// - The document's reply prints the `cmdName` with blanks around it, ` set_payload `.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct SetPayload {
        /// Mass of the payload. In kg, at least 0.
        pub mass: f64,
        /// Centroid of the payload.
        pub centroid: Centroid,
    }
    impl wire::Fields for SetPayload {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"mass\":");
            wire::Encode::encode(&self.mass, out);
            out.raw(",\"centroid\":");
            wire::Encode::encode(&self.centroid, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut mass = None;
            let mut centroid = None;
            let mut keys = reader.begin_fields(&["\"mass\":", "\"centroid\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("mass", &mut mass)?,
                    1 => reader.field("centroid", &mut centroid)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                mass: mass.ok_or_else(|| wire::DecodeError::missing("mass", "mass"))?,
                centroid: centroid
                    .ok_or_else(|| wire::DecodeError::missing("centroid", "centroid"))?,
            })
        }
    }
    proto::__object_impls!(SetPayload);
    impl check::Validate for SetPayload {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place
                .check(
                    "mass",
                    &self.mass,
                    &check::Limits {
                        min: Some(0f64),
                        unit: "kg",
                        ..check::Limits::NONE
                    },
                )?;
            place.check("centroid", &self.centroid, &check::Limits::NONE)?;
            Ok(())
        }
    }
    impl proto::Command for SetPayload {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "set_payload",
            "{\"cmdName\":\"set_payload\"",
            "4.42",
            proto::Effect::Setting,
        );
    }
    /// Reads the mass and the centroid of the payload.
    ///
    /// Sends `get_payload` (4.43). Changes nothing on the robot.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct GetPayload;
    impl wire::Fields for GetPayload {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(GetPayload);
    impl check::Validate for GetPayload {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for GetPayload {
        type Reply = GetPayloadReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "get_payload",
            "{\"cmdName\":\"get_payload\"",
            "4.43",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`GetPayload`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct GetPayloadReply {
        /// Centroid of the payload.
        pub centroid: Centroid,
        /// Mass of the payload. In kg.
        pub mass: f64,
    }
    impl wire::Fields for GetPayloadReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"centroid\":");
            wire::Encode::encode(&self.centroid, out);
            out.raw(",\"mass\":");
            wire::Encode::encode(&self.mass, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut centroid = None;
            let mut mass = None;
            let mut keys = reader.begin_fields(&["\"centroid\":", "\"mass\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("centroid", &mut centroid)?,
                    1 => reader.field("mass", &mut mass)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                centroid: centroid
                    .ok_or_else(|| wire::DecodeError::missing("centroid", "centroid"))?,
                mass: mass.ok_or_else(|| wire::DecodeError::missing("mass", "mass"))?,
            })
        }
    }
    proto::__object_impls!(GetPayloadReply);
    /// Centroid of a payload.
    ///
    /// The document does not say in which frame it is given.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Centroid {
        /// Position along x. In mm.
        pub x: f64,
        /// Position along y. In mm.
        pub y: f64,
        /// Position along z. In mm.
        pub z: f64,
    }
    impl wire::Encode for Centroid {
        fn encode(&self, out: &mut wire::Writer) {
            out.raw("[");
            wire::Encode::encode(&self.x, out);
            out.raw(",");
            wire::Encode::encode(&self.y, out);
            out.raw(",");
            wire::Encode::encode(&self.z, out);
            out.raw("]");
        }
    }
    impl wire::Decode for Centroid {
        fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
            reader.begin_array()?;
            let this = Self {
                x: reader.element("x")?,
                y: reader.element("y")?,
                z: reader.element("z")?,
            };
            reader.end_array()?;
            Ok(this)
        }
    }
    proto::__serde_impls!(Centroid);
    impl From<[f64; 3]> for Centroid {
        fn from([x, y, z]: [f64; 3]) -> Self {
            Self { x, y, z }
        }
    }
    impl From<Centroid> for [f64; 3] {
        fn from(value: Centroid) -> Self {
            [value.x, value.y, value.z]
        }
    }
    impl check::Validate for Centroid {
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
            Ok(())
        }
    }
}
