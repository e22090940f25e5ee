pub mod session {
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Session, ends_session: true
    pub struct Quit {}
    impl Quit {
        pub const fn new() -> Self {}
    }
}
