pub mod payload {
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting, changes:[Change::Payload]
    pub struct SetPayload {
        // min 0, unit "kg"
        pub mass: f64,
        pub centroid: Centroid,
    }
    impl SetPayload {
        pub fn new(mass: f64, centroid: impl Into<Centroid>) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query
    pub struct GetPayload {}
    impl GetPayload {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetPayloadReply {
        pub centroid: Centroid,
        pub mass: f64,
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Centroid {
        // unit "mm"
        pub x: f64,
        // unit "mm"
        pub y: f64,
        // unit "mm"
        pub z: f64,
    }
    impl From<[f64; 3]> for Centroid {}
    impl From<Centroid> for [f64; 3] {}
}
