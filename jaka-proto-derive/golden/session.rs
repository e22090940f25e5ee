pub mod session {
    //! The connection.
    //!
    //! Port 10001 serves one client. A second client is refused or takes the first one's place, depending on the firmware. The
    //! replies come in the order of the requests.
    //!
    //! Closing the connection leaves power and enabling as they are.
    /// Ends the connection.
    ///
    /// The controller answers as usual, and the client closes the connection then. Closing it without this command leaves power
    /// and enabling as they are.
    ///
    /// Sends `quit` (4.11).
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct Quit {}
    impl Quit {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
}
