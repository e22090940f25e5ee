/// Lost network.
///
/// What the arm does when the network fails while a program on another machine commands it.
pub mod network {
    #[allow(unused_imports)]
    use ::jaka_proto::{self as proto, check, wire};
    /// Sets what the arm does when the network fails, and how long after the failure.
    ///
    /// The document does not say what counts as a failure, or whether the setting outlives the connection.
    ///
    /// Sends `set_network_exception_handle` (4.75).
    ///
    /// # Errata
    ///
    /// - The document's text calls the key `millisecond`; its sample sends `timeLimit`.
    /// - The document's text calls the key `mnt`; its sample sends `motType`.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct SetNetworkExceptionHandle {
        /// How long after the failure the arm acts. In ms, at least 0.
        ///
        /// `timeLimit` on the wire.
        #[doc(alias = "timeLimit")]
        pub delay: i64,
        /// What the arm does.
        ///
        /// `motType` on the wire.
        #[doc(alias = "motType")]
        pub action: NetworkExceptionAction,
    }
    impl wire::Fields for SetNetworkExceptionHandle {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"timeLimit\":");
            wire::Encode::encode(&self.delay, out);
            out.raw(",\"motType\":");
            wire::Encode::encode(&self.action, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut delay = None;
            let mut action = None;
            let mut keys = reader.begin_fields(&["\"timeLimit\":", "\"motType\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("delay", &mut delay)?,
                    1 => reader.field("action", &mut action)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                delay: delay
                    .ok_or_else(|| wire::DecodeError::missing("delay", "timeLimit"))?,
                action: action
                    .ok_or_else(|| wire::DecodeError::missing("action", "motType"))?,
            })
        }
    }
    proto::__object_impls!(SetNetworkExceptionHandle);
    impl check::Validate for SetNetworkExceptionHandle {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place
                .check(
                    "delay",
                    &self.delay,
                    &check::Limits {
                        min: Some(0f64),
                        unit: "ms",
                        ..check::Limits::NONE
                    },
                )?;
            place.check("action", &self.action, &check::Limits::NONE)?;
            Ok(())
        }
    }
    impl proto::Command for SetNetworkExceptionHandle {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "set_network_exception_handle",
            "{\"cmdName\":\"set_network_exception_handle\"",
            "4.75",
            proto::Effect::Setting,
        );
    }
    /// What the arm does when the network fails.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum NetworkExceptionAction {
        /// Keeps, by the document's one word for it.
        ///
        /// It does not say what is kept: a motion may go on. Choose another action where the arm must not move on its own. `0` on the wire.
        Keep,
        /// Pauses. `1` on the wire.
        Pause,
        /// Terminates. `2` on the wire.
        Terminate,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for NetworkExceptionAction {
        fn from(value: i64) -> Self {
            match value {
                0 => Self::Keep,
                1 => Self::Pause,
                2 => Self::Terminate,
                other => Self::Other(other),
            }
        }
    }
    impl From<NetworkExceptionAction> for i64 {
        fn from(value: NetworkExceptionAction) -> Self {
            match value {
                NetworkExceptionAction::Keep => 0,
                NetworkExceptionAction::Pause => 1,
                NetworkExceptionAction::Terminate => 2,
                NetworkExceptionAction::Other(other) => other,
            }
        }
    }
    proto::__int_enum_impls!(NetworkExceptionAction);
    impl check::Validate for NetworkExceptionAction {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            let standing = match self {
                Self::Keep | Self::Pause | Self::Terminate => check::Standing::Listed,
                Self::Other(_) => check::Standing::Unknown,
            };
            place
                .listed(
                    &i64::from(*self),
                    standing,
                    "0 (Keep), 1 (Pause) or 2 (Terminate)",
                )
        }
    }
}
