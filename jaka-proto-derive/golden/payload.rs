pub mod payload {
    //! Payload.
    //!
    //! Mass and centroid of what the arm carries.
    //!
    //! The payload at the torque sensor is a setting of its own: see [`set_tool_payload`](crate::messages::force::SetToolPayload).
    /// Sets the mass and the centroid of the payload.
    ///
    /// Sends `set_payload` (4.42).
    ///
    /// # Errata
    ///
    /// - The document's reply prints the `cmdName` with blanks around it, ` set_payload `.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetPayload {
        /// Mass of the payload. In kg, at least 0.
        pub mass: f64,
        /// Centroid of the payload.
        pub centroid: Centroid,
    }
    impl SetPayload {
        /// With the required fields alone.
        ///
        /// - `mass`: in kg, at least 0
        pub fn new(mass: f64, centroid: impl Into<Centroid>) -> Self {}
    }
    /// Reads the mass and the centroid of the payload.
    ///
    /// Sends `get_payload` (4.43). Changes nothing on the robot. The reply is [`GetPayloadReply`].
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetPayload {}
    impl GetPayload {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetPayload`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetPayloadReply {
        /// Centroid of the payload.
        pub centroid: Centroid,
        /// Mass of the payload. In kg.
        pub mass: f64,
    }
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
    impl From<[f64; 3]> for Centroid {}
    impl From<Centroid> for [f64; 3] {}
}
