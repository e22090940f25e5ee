pub mod trajectory {
    //! Trajectory recording.
    //!
    //! Records the arm's path to a file on the controller, and makes a program of it.
    //!
    //! [`set_traj_config`](type@SetTrajConfig) says how finely to record and how fast to run the path later, [`set_traj_sample_mode`](type@SetTrajSampleMode) starts and stops
    //! recording, [`generate_traj_exe_file`](type@GenerateTrajExeFile) writes the program.
    //!
    //! What is advised of speed and acceleration is as for [`move_l`](crate::messages::motion::MoveL).
    /// Sets how finely a trajectory is recorded, and how fast it is run later.
    ///
    /// Sends `set_traj_config` (4.52).
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetTrajConfig {
        /// Acceleration at which the trajectory is run. In mm/s², at least 0. `acc` on the wire.
        ///
        /// Advised: more than 0, at most 8000. Anything else is refused unless that is left to the controller: see [`AdvisoryRanges`](check::AdvisoryRanges).
        pub acceleration: f64,
        /// Speed at which the trajectory is run. In mm/s, at least 0. `vel` on the wire.
        ///
        /// Advised: more than 0, at most 10000. Anything else is refused unless that is left to the controller: see [`AdvisoryRanges`](check::AdvisoryRanges).
        pub speed: f64,
        /// Interval at which Cartesian displacement is recorded. At least 0. Unit not stated; the sample sends 0.1. `xyz_interval` on the wire.
        pub position_interval: f64,
        /// Interval at which Cartesian rotation is recorded. At least 0. Unit not stated; the sample sends 0.1. `rpy_interval` on the wire.
        pub orientation_interval: f64,
    }
    impl SetTrajConfig {
        /// With the required fields alone.
        ///
        /// - `acceleration`: in mm/s², at least 0
        /// - `speed`: in mm/s, at least 0
        /// - `position_interval`: at least 0
        /// - `orientation_interval`: at least 0
        pub const fn new(
            acceleration: f64,
            speed: f64,
            position_interval: f64,
            orientation_interval: f64,
        ) -> Self {}
    }
    /// Reads how finely a trajectory is recorded, and how fast it is run later.
    ///
    /// Sends `get_traj_config` (4.53). Changes nothing on the robot. The reply is [`GetTrajConfigReply`].
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetTrajConfig {}
    impl GetTrajConfig {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetTrajConfig`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetTrajConfigReply {
        /// Acceleration at which the trajectory is run. In mm/s². `acc` on the wire.
        pub acceleration: f64,
        /// Interval at which Cartesian displacement is recorded. Unit not stated. `xyz_interval` on the wire.
        pub position_interval: f64,
        /// Interval at which Cartesian rotation is recorded. Unit not stated. `rpy_interval` on the wire.
        pub orientation_interval: f64,
        /// Speed at which the trajectory is run. In mm/s. `vel` on the wire.
        pub speed: f64,
    }
    /// Starts or stops the recording of a trajectory to a file.
    ///
    /// Sends `set_traj_sample_mode` (4.54).
    ///
    /// # Errata
    ///
    /// - The key is `filename` here and `fileName` in 4.58 and 4.59.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct SetTrajSampleMode {
        /// Whether to record.
        pub mode: super::types::Switch,
        /// Name of the trajectory file. `filename` on the wire.
        pub file_name: String,
    }
    impl SetTrajSampleMode {
        /// With the required fields alone.
        pub fn new(mode: super::types::Switch, file_name: impl Into<String>) -> Self {}
    }
    /// Reads whether a trajectory is being recorded.
    ///
    /// Sends `get_traj_sample_status` (4.55). Changes nothing on the robot. The reply is [`GetTrajSampleStatusReply`].
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetTrajSampleStatus {}
    impl GetTrajSampleStatus {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetTrajSampleStatus`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetTrajSampleStatusReply {
        /// Whether recording is on. `sampleStatus` on the wire.
        pub sampling: bool,
    }
    /// Reads the names of the trajectory files on the controller.
    ///
    /// Sends `get_exist_traj_file_name` (4.56). Changes nothing on the robot. The reply is [`GetExistTrajFileNameReply`].
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetExistTrajFileName {}
    impl GetExistTrajFileName {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetExistTrajFileName`].
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetExistTrajFileNameReply {
        /// Names of the trajectory files. `trajTrackFileName` on the wire.
        pub file_names: Vec<String>,
    }
    /// Renames a trajectory file.
    ///
    /// Sends `rename_traj_file_name` (4.57).
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct RenameTrajFileName {
        /// Present name of the trajectory file. `src` on the wire.
        pub source: String,
        /// New name of the trajectory file. `dest` on the wire.
        pub destination: String,
    }
    impl RenameTrajFileName {
        /// With the required fields alone.
        pub fn new(source: impl Into<String>, destination: impl Into<String>) -> Self {}
    }
    /// Deletes a trajectory file.
    ///
    /// Sends `remove_traj_file` (4.58).
    ///
    /// # Errata
    ///
    /// - The document's text calls the key `filename`; its sample sends `fileName`.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct RemoveTrajFile {
        /// Name of the trajectory file. `fileName` on the wire.
        pub file_name: String,
    }
    impl RemoveTrajFile {
        /// With the required fields alone.
        pub fn new(file_name: impl Into<String>) -> Self {}
    }
    /// Writes a program for the controller from a trajectory file.
    ///
    /// The document does not say what the program is called.
    ///
    /// Sends `generate_traj_exe_file` (4.59).
    ///
    /// # Errata
    ///
    /// - The document's text calls the key `filename`; its sample sends `fileName`.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GenerateTrajExeFile {
        /// Name of the trajectory file. `fileName` on the wire.
        pub file_name: String,
    }
    impl GenerateTrajExeFile {
        /// With the required fields alone.
        pub fn new(file_name: impl Into<String>) -> Self {}
    }
}
