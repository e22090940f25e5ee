pub mod session {
    //! The connection.
    //!
    //! Port 10001 serves one client. A second client is refused or takes the first one's place, depending on the firmware. The
    //! replies come in the order of the requests. The vendor's app can be connected at the same time (chapter 1). Queries are answered while the arm
    //! moves. The end of the connection at any time is a normal event: another client may have taken the place. Some Schneider Lexium units
    //! speak the protocol inside TLS, which this spec leaves out (field notes).
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
