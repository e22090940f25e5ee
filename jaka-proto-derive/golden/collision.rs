pub mod collision {
    //! Collision detection and protective stop.
    //!
    //! Force of a contact at which the arm stops, state of that stop, and recovery from it.
    //!
    //! A protective stop usually follows a collision (4.40). [`clear_error`](type@ClearError) leaves the collision protection (4.48); the document
    //! does not say whether that is the same state.
    /// Reads whether the robot is in a protective stop.
    ///
    /// A protective stop usually follows a collision.
    ///
    /// Sends `protective_stop_status` (4.40). Changes nothing on the robot. The reply is [`ProtectiveStopStatusReply`].
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct ProtectiveStopStatus {}
    impl ProtectiveStopStatus {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@ProtectiveStopStatus`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct ProtectiveStopStatusReply {
        /// Whether the robot is in a protective stop.
        pub protective_stop: bool,
    }
    /// Sets the collision level, which says how hard a contact must be for the arm to stop.
    ///
    /// Level 0 switches collision detection off.
    ///
    /// Sends `set_clsn_sensitivity` (4.44).
    ///
    /// # Errata
    ///
    /// - The key is `sensitivityVal` here and `sensitivityLevel` in the reply of [`get_clsn_sensitivity`](type@GetClsnSensitivity).
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetClsnSensitivity {
        /// Collision level. 0 to 5. `sensitivityVal` on the wire.
        ///
        /// 0 switches detection off. 1 is the most sensitive and stops at 25 N; each level adds 25 N; 5 is the least sensitive and
        /// stops at 125 N.
        ///
        /// Newer firmware takes more than this range, which can be switched off: see [`AdvisoryRanges`](check::AdvisoryRanges).
        pub level: i64,
    }
    impl SetClsnSensitivity {
        /// With the required fields alone.
        ///
        /// - `level`: 0 to 5
        pub const fn new(level: i64) -> Self {}
    }
    /// Reads the collision level.
    ///
    /// Sends `get_clsn_sensitivity` (4.45). Changes nothing on the robot. The reply is [`GetClsnSensitivityReply`].
    ///
    /// # Errata
    ///
    /// - The key is `sensitivityLevel` here and `sensitivityVal` in the request of [`set_clsn_sensitivity`](type@SetClsnSensitivity).
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetClsnSensitivity {}
    impl GetClsnSensitivity {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetClsnSensitivity`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetClsnSensitivityReply {
        /// Collision level: 0 to 5 in the document, up to 7 on newer firmware (one client). `sensitivityLevel` on the wire.
        ///
        /// 0 says that detection is off. Of 1 to 5, 1 is the most sensitive and 5 the least. See [`set_clsn_sensitivity`](type@SetClsnSensitivity) for the forces.
        pub level: i64,
    }
    /// Leaves the collision protection that the robot enters after a collision.
    ///
    /// Make sure first that nobody and nothing is in contact with the arm.
    ///
    /// Sends `clear_error` (4.48).
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct ClearError {}
    impl ClearError {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
}
