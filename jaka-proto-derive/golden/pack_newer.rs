#[allow(unreachable_pub, dead_code, clippy::self_named_constructors)]
pub mod newer {
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query
    pub struct DemoMotionState {}
    impl DemoMotionState {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct DemoMotionStateReply {
        pub in_position: bool,
        pub paused: bool,
        pub queue: i64,
        pub active_queue: i64,
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query
    pub struct DemoStopState {}
    impl DemoStopState {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct DemoStopStateReply {
        pub emergency_stop: bool,
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting
    pub struct SetDemoPeriod {
        // min 1, unit "ms"
        pub period: i64,
    }
    impl SetDemoPeriod {
        pub const fn new(period: i64) -> Self {}
    }
    pub trait NewerCommands: ::jaka_sync::Call {
        fn demo_motion_state(
            &mut self,
        ) -> Result<DemoMotionStateReply, ::jaka_sync::Error>;
        fn demo_stop_state(&mut self) -> Result<DemoStopStateReply, ::jaka_sync::Error>;
        fn set_demo_period(&mut self, period: i64) -> Result<(), ::jaka_sync::Error>;
    }
    impl<T: ::jaka_sync::Call + ?Sized> NewerCommands for T {}
}
