pub mod trajectory {
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting
    pub struct SetTrajConfig {
        // min 0, advised Advised::to([Advice{max: 8000, nonzero: true, unit: ""}]), unit "mm/s²"
        pub acceleration: f64,
        // min 0, advised Advised::to([Advice{max: 10000, nonzero: true, unit: ""}]), unit "mm/s"
        pub speed: f64,
        // min 0
        pub position_interval: f64,
        // min 0
        pub orientation_interval: f64,
    }
    impl SetTrajConfig {
        pub const fn new(
            acceleration: f64,
            speed: f64,
            position_interval: f64,
            orientation_interval: f64,
        ) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query
    pub struct GetTrajConfig {}
    impl GetTrajConfig {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetTrajConfigReply {
        pub acceleration: f64,
        pub position_interval: f64,
        pub orientation_interval: f64,
        pub speed: f64,
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    // Setting
    pub struct SetTrajSampleMode {
        pub mode: super::types::Switch,
        pub file_name: String,
    }
    impl SetTrajSampleMode {
        pub fn new(mode: super::types::Switch, file_name: impl Into<String>) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query
    pub struct GetTrajSampleStatus {}
    impl GetTrajSampleStatus {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetTrajSampleStatusReply {
        pub sampling: bool,
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query
    pub struct GetExistTrajFileName {}
    impl GetExistTrajFileName {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetExistTrajFileNameReply {
        pub file_names: Vec<String>,
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    // Setting
    pub struct RenameTrajFileName {
        pub source: String,
        pub destination: String,
    }
    impl RenameTrajFileName {
        pub fn new(source: impl Into<String>, destination: impl Into<String>) -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    // Setting
    pub struct RemoveTrajFile {
        pub file_name: String,
    }
    impl RemoveTrajFile {
        pub fn new(file_name: impl Into<String>) -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    // Setting
    pub struct GenerateTrajExeFile {
        pub file_name: String,
    }
    impl GenerateTrajExeFile {
        pub fn new(file_name: impl Into<String>) -> Self {}
    }
}
