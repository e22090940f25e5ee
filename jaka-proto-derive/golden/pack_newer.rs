/// What newer firmware adds.
///
/// Three commands that the built-in spec does not have.
#[allow(unreachable_pub, dead_code, clippy::self_named_constructors)]
pub mod newer {
    #[allow(unused_imports)]
    use ::jaka_sync::proto::{self as proto, check, wire};
    /// Reads how the motion stands.
    ///
    /// Sends `get_motion_state`. Changes nothing on the robot.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetMotionState {}
    impl wire::Fields for GetMotionState {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self {})
        }
    }
    proto::__object_impls!(GetMotionState);
    impl GetMotionState {
        /// Without any optional field.
        #[must_use]
        pub const fn new() -> Self {
            Self {}
        }
    }
    impl check::Validate for GetMotionState {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for GetMotionState {
        type Reply = GetMotionStateReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "get_motion_state",
            "{\"cmdName\":\"get_motion_state\"",
            "",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`GetMotionState`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetMotionStateReply {
        /// Whether the arm is in position.
        ///
        /// `inpos` on the wire.
        #[doc(alias = "inpos")]
        pub in_position: bool,
        /// Whether the motion is paused.
        pub paused: bool,
        /// How many motions are queued.
        pub queue: i64,
        /// How many of the queued motions are being carried out.
        pub active_queue: i64,
    }
    impl wire::Fields for GetMotionStateReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"inpos\":");
            wire::Encode::encode(&self.in_position, out);
            out.raw(",\"paused\":");
            wire::Encode::encode(&self.paused, out);
            out.raw(",\"queue\":");
            wire::Encode::encode(&self.queue, out);
            out.raw(",\"active_queue\":");
            wire::Encode::encode(&self.active_queue, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut in_position = None;
            let mut paused = None;
            let mut queue = None;
            let mut active_queue = None;
            let mut keys = reader
                .begin_fields(
                    &["\"inpos\":", "\"paused\":", "\"queue\":", "\"active_queue\":"],
                )?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("in_position", &mut in_position)?,
                    1 => reader.field("paused", &mut paused)?,
                    2 => reader.field("queue", &mut queue)?,
                    3 => reader.field("active_queue", &mut active_queue)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                in_position: in_position
                    .ok_or_else(|| wire::DecodeError::missing("in_position", "inpos"))?,
                paused: paused
                    .ok_or_else(|| wire::DecodeError::missing("paused", "paused"))?,
                queue: queue
                    .ok_or_else(|| wire::DecodeError::missing("queue", "queue"))?,
                active_queue: active_queue
                    .ok_or_else(|| wire::DecodeError::missing(
                        "active_queue",
                        "active_queue",
                    ))?,
            })
        }
    }
    proto::__object_impls!(GetMotionStateReply);
    /// Reads whether the emergency stop is pressed.
    ///
    /// Sends `emergency_stop_status`. Changes nothing on the robot.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct EmergencyStopStatus {}
    impl wire::Fields for EmergencyStopStatus {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self {})
        }
    }
    proto::__object_impls!(EmergencyStopStatus);
    impl EmergencyStopStatus {
        /// Without any optional field.
        #[must_use]
        pub const fn new() -> Self {
            Self {}
        }
    }
    impl check::Validate for EmergencyStopStatus {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for EmergencyStopStatus {
        type Reply = EmergencyStopStatusReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "emergency_stop_status",
            "{\"cmdName\":\"emergency_stop_status\"",
            "",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`EmergencyStopStatus`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct EmergencyStopStatusReply {
        /// Whether the emergency stop is pressed.
        pub emergency_stop: bool,
    }
    impl wire::Fields for EmergencyStopStatusReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"emergency_stop\":");
            out.choose(*&self.emergency_stop, "0", "1");
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut emergency_stop = None;
            let mut keys = reader.begin_fields(&["\"emergency_stop\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("emergency_stop", &mut emergency_stop)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                emergency_stop: emergency_stop
                    .ok_or_else(|| wire::DecodeError::missing(
                        "emergency_stop",
                        "emergency_stop",
                    ))?,
            })
        }
    }
    proto::__object_impls!(EmergencyStopStatusReply);
    /// Sets the time between two status packets.
    ///
    /// Sends `set_port10000_delay_ms`.
    #[doc(alias = "set_port10000_delay_ms")]
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetStatusPeriod {
        /// Time between two packets. In ms, at least 1.
        ///
        /// `port10000_delay_ms` on the wire.
        #[doc(alias = "port10000_delay_ms")]
        pub period: i64,
    }
    impl wire::Fields for SetStatusPeriod {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"port10000_delay_ms\":");
            wire::Encode::encode(&self.period, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut period = None;
            let mut keys = reader.begin_fields(&["\"port10000_delay_ms\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("period", &mut period)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                period: period
                    .ok_or_else(|| wire::DecodeError::missing(
                        "period",
                        "port10000_delay_ms",
                    ))?,
            })
        }
    }
    proto::__object_impls!(SetStatusPeriod);
    impl SetStatusPeriod {
        /// With the required fields alone.
        ///
        /// - `period`: in ms, at least 1
        #[must_use]
        pub const fn new(period: i64) -> Self {
            Self { period }
        }
    }
    impl check::Validate for SetStatusPeriod {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place
                .check(
                    "period",
                    &self.period,
                    &check::Limits {
                        min: Some(1f64),
                        unit: "ms",
                        ..check::Limits::NONE
                    },
                )?;
            Ok(())
        }
    }
    impl proto::Command for SetStatusPeriod {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "set_port10000_delay_ms",
            "{\"cmdName\":\"set_port10000_delay_ms\"",
            "",
            proto::Effect::Setting,
        );
    }
    /// What replies hold, as structs that can be written as literals. They grow with the spec, so that the compiler leads
    /// to each place where a field is forgotten, and are no part of the interface.
    #[doc(hidden)]
    #[allow(missing_docs, missing_debug_implementations, clippy::too_many_lines)]
    pub mod literal {
        pub struct GetMotionStateReply {
            pub in_position: bool,
            pub paused: bool,
            pub queue: i64,
            pub active_queue: i64,
        }
        impl From<GetMotionStateReply> for super::GetMotionStateReply {
            #[inline]
            fn from(
                GetMotionStateReply {
                    in_position,
                    paused,
                    queue,
                    active_queue,
                }: GetMotionStateReply,
            ) -> Self {
                Self {
                    in_position,
                    paused,
                    queue,
                    active_queue,
                }
            }
        }
        pub struct EmergencyStopStatusReply {
            pub emergency_stop: bool,
        }
        impl From<EmergencyStopStatusReply> for super::EmergencyStopStatusReply {
            #[inline]
            fn from(
                EmergencyStopStatusReply { emergency_stop }: EmergencyStopStatusReply,
            ) -> Self {
                Self { emergency_stop }
            }
        }
    }
    /// The commands of [`newer`](self) as methods: of a client, of a robot, and of all else that takes commands.
    pub trait NewerCommands: ::jaka_sync::Call {
        /// Reads how the motion stands.
        ///
        /// Sends `get_motion_state`. Changes nothing on the robot.
        ///
        /// # Errors
        /// As `Call::call`.
        fn get_motion_state(
            &mut self,
        ) -> Result<GetMotionStateReply, ::jaka_sync::Error> {
            ::jaka_sync::Call::call(self, &GetMotionState::new())
        }
        /// Reads whether the emergency stop is pressed.
        ///
        /// Sends `emergency_stop_status`. Changes nothing on the robot.
        ///
        /// # Errors
        /// As `Call::call`.
        fn emergency_stop_status(
            &mut self,
        ) -> Result<EmergencyStopStatusReply, ::jaka_sync::Error> {
            ::jaka_sync::Call::call(self, &EmergencyStopStatus::new())
        }
        /// Sets the time between two status packets.
        ///
        /// Sends `set_port10000_delay_ms`.
        ///
        /// # Errors
        /// As `Call::call`.
        #[doc(alias = "set_port10000_delay_ms")]
        fn set_status_period(&mut self, period: i64) -> Result<(), ::jaka_sync::Error> {
            ::jaka_sync::Call::call(self, &SetStatusPeriod::new(period))
        }
    }
    impl<T: ::jaka_sync::Call + ?Sized> NewerCommands for T {}
}
