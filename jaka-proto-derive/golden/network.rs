pub mod network {
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting
    pub struct SetNetworkExceptionHandle {
        // min 0, unit "ms"
        pub delay: i64,
        pub action: NetworkExceptionAction,
    }
    impl SetNetworkExceptionHandle {
        pub const fn new(delay: i64, action: NetworkExceptionAction) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum NetworkExceptionAction {
        Keep,
        Pause,
        Terminate,
        Other(i64),
    }
    impl From<i64> for NetworkExceptionAction {}
    impl From<NetworkExceptionAction> for i64 {}
    impl ::core::fmt::Display for NetworkExceptionAction {}
}
