/// Collision detection and protective stop.
///
/// How hard a contact must be for the arm to stop, whether it has stopped, and the way back.
///
/// A protective stop usually follows a collision (4.40). `clear_error` leaves the collision protection (4.48); the document
/// does not say whether that is the same state.
pub mod collision {
    #[allow(unused_imports)]
    use ::jaka_proto::{self as proto, check, wire};
    /// Reads whether the robot is in a protective stop.
    ///
    /// A protective stop usually follows a collision.
    ///
    /// Sends `protective_stop_status` (4.40). Changes nothing on the robot.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct ProtectiveStopStatus;
    impl wire::Fields for ProtectiveStopStatus {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(ProtectiveStopStatus);
    impl check::Validate for ProtectiveStopStatus {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for ProtectiveStopStatus {
        type Reply = ProtectiveStopStatusReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "protective_stop_status",
            "{\"cmdName\":\"protective_stop_status\"",
            "4.40",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`ProtectiveStopStatus`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct ProtectiveStopStatusReply {
        /// Whether the robot is in a protective stop.
        pub protective_stop: bool,
    }
    impl wire::Fields for ProtectiveStopStatusReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"protective_stop\":");
            out.choose(*&self.protective_stop, "\"0\"", "\"1\"");
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut protective_stop = None;
            let mut keys = reader.begin_fields(&["\"protective_stop\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("protective_stop", &mut protective_stop)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                protective_stop: protective_stop
                    .ok_or_else(|| wire::DecodeError::missing(
                        "protective_stop",
                        "protective_stop",
                    ))?,
            })
        }
    }
    proto::__object_impls!(ProtectiveStopStatusReply);
    /// Sets the collision level, which says how hard a contact must be for the arm to stop.
    ///
    /// Level 0 switches collision detection off.
    ///
    /// Sends `set_clsn_sensitivity` (4.44).
    ///
    /// # Errata
    ///
    /// - The key is `sensitivityVal` here and `sensitivityLevel` in the reply of `get_clsn_sensitivity`.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct SetClsnSensitivity {
        /// Collision level. 0 to 5.
        ///
        /// 0 switches detection off. 1 is the most sensitive and stops at 25 N; each level adds 25 N; 5 is the least sensitive and
        /// stops at 125 N.
        ///
        /// `sensitivityVal` on the wire.
        #[doc(alias = "sensitivityVal")]
        pub level: i64,
    }
    impl wire::Fields for SetClsnSensitivity {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"sensitivityVal\":");
            wire::Encode::encode(&self.level, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut level = None;
            let mut keys = reader.begin_fields(&["\"sensitivityVal\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("level", &mut level)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                level: level
                    .ok_or_else(|| wire::DecodeError::missing(
                        "level",
                        "sensitivityVal",
                    ))?,
            })
        }
    }
    proto::__object_impls!(SetClsnSensitivity);
    impl check::Validate for SetClsnSensitivity {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place
                .check(
                    "level",
                    &self.level,
                    &check::Limits {
                        min: Some(0f64),
                        max: Some(5f64),
                        ..check::Limits::NONE
                    },
                )?;
            Ok(())
        }
    }
    impl proto::Command for SetClsnSensitivity {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "set_clsn_sensitivity",
            "{\"cmdName\":\"set_clsn_sensitivity\"",
            "4.44",
            proto::Effect::Setting,
        );
    }
    /// Reads the collision level.
    ///
    /// Sends `get_clsn_sensitivity` (4.45). Changes nothing on the robot.
    ///
    /// # Errata
    ///
    /// - The key is `sensitivityLevel` here and `sensitivityVal` in the request of `set_clsn_sensitivity`.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct GetClsnSensitivity;
    impl wire::Fields for GetClsnSensitivity {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(GetClsnSensitivity);
    impl check::Validate for GetClsnSensitivity {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for GetClsnSensitivity {
        type Reply = GetClsnSensitivityReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "get_clsn_sensitivity",
            "{\"cmdName\":\"get_clsn_sensitivity\"",
            "4.45",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`GetClsnSensitivity`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct GetClsnSensitivityReply {
        /// Collision level, from 0 to 5.
        ///
        /// 0 says that detection is off, 1 is the most sensitive, 5 the least. See `set_clsn_sensitivity` for the forces.
        ///
        /// `sensitivityLevel` on the wire.
        #[doc(alias = "sensitivityLevel")]
        pub level: i64,
    }
    impl wire::Fields for GetClsnSensitivityReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"sensitivityLevel\":");
            wire::Encode::encode(&self.level, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut level = None;
            let mut keys = reader.begin_fields(&["\"sensitivityLevel\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("level", &mut level)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                level: level
                    .ok_or_else(|| wire::DecodeError::missing(
                        "level",
                        "sensitivityLevel",
                    ))?,
            })
        }
    }
    proto::__object_impls!(GetClsnSensitivityReply);
    /// Leaves the collision protection that the robot enters after a collision.
    ///
    /// Make sure first that nobody and nothing is in contact with the arm.
    ///
    /// Sends `clear_error` (4.48).
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct ClearError;
    impl wire::Fields for ClearError {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(ClearError);
    impl check::Validate for ClearError {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for ClearError {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
                "clear_error",
                "{\"cmdName\":\"clear_error\"",
                "4.48",
                proto::Effect::Power,
            )
            .deadline_ms(15000u64);
    }
}
