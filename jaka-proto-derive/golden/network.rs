pub mod network {
    //! Lost network.
    //!
    //! Reaction of the arm to a failure of the network while a program on another machine commands it.
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
    #[non_exhaustive]
    pub struct SetNetworkExceptionHandle {
        /// Time from the failure to the reaction of the arm. In ms, at least 0. `timeLimit` on the wire.
        pub delay: i64,
        /// Reaction of the arm. `motType` on the wire.
        pub action: NetworkExceptionAction,
    }
    impl SetNetworkExceptionHandle {
        /// With the required fields alone.
        ///
        /// - `delay`: in ms, at least 0
        pub const fn new(delay: i64, action: NetworkExceptionAction) -> Self {}
    }
    /// Reaction of the arm to a failure of the network.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum NetworkExceptionAction {
        /// The arm goes on with its motion (vendor's texts).
        ///
        /// Choose another action where the arm must not move on its own. The document has one word, keep. `0` on the wire.
        Keep,
        /// The motion pauses, by the document's word. `1` on the wire.
        Pause,
        /// The motion stops (vendor's texts). `2` on the wire.
        Terminate,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for NetworkExceptionAction {}
    impl From<NetworkExceptionAction> for i64 {}
    /// The value in words; one that the spec does not list as its number.
    impl ::core::fmt::Display for NetworkExceptionAction {}
}
