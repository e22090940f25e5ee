/// Trajectory recording.
///
/// Records the arm's path to a file on the controller, and makes a program of it.
///
/// `set_traj_config` says how finely to record and how fast to run the path later, `set_traj_sample_mode` starts and stops
/// recording, `generate_traj_exe_file` writes the program.
pub mod trajectory {
    #[allow(unused_imports)]
    use ::jaka_proto::{self as proto, check, wire};
    /// Sets how finely a trajectory is recorded, and how fast it is run later.
    ///
    /// Sends `set_traj_config` (4.52).
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct SetTrajConfig {
        /// Acceleration at which the trajectory is run. In mm/s², at least 0.
        ///
        /// `acc` on the wire.
        #[doc(alias = "acc")]
        pub acceleration: f64,
        /// Speed at which the trajectory is run. In mm/s, at least 0.
        ///
        /// `vel` on the wire.
        #[doc(alias = "vel")]
        pub speed: f64,
        /// Interval at which Cartesian displacement is recorded. At least 0. Unit not stated; the sample sends 0.1.
        ///
        /// `xyz_interval` on the wire.
        #[doc(alias = "xyz_interval")]
        pub position_interval: f64,
        /// Interval at which Cartesian rotation is recorded. At least 0. Unit not stated; the sample sends 0.1.
        ///
        /// `rpy_interval` on the wire.
        #[doc(alias = "rpy_interval")]
        pub orientation_interval: f64,
    }
    impl wire::Fields for SetTrajConfig {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"acc\":");
            wire::Encode::encode(&self.acceleration, out);
            out.raw(",\"vel\":");
            wire::Encode::encode(&self.speed, out);
            out.raw(",\"xyz_interval\":");
            wire::Encode::encode(&self.position_interval, out);
            out.raw(",\"rpy_interval\":");
            wire::Encode::encode(&self.orientation_interval, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut acceleration = None;
            let mut speed = None;
            let mut position_interval = None;
            let mut orientation_interval = None;
            let mut keys = reader
                .begin_fields(
                    &["\"acc\":", "\"vel\":", "\"xyz_interval\":", "\"rpy_interval\":"],
                )?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("acceleration", &mut acceleration)?,
                    1 => reader.field("speed", &mut speed)?,
                    2 => reader.field("position_interval", &mut position_interval)?,
                    3 => reader.field("orientation_interval", &mut orientation_interval)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                acceleration: acceleration
                    .ok_or_else(|| wire::DecodeError::missing("acceleration", "acc"))?,
                speed: speed.ok_or_else(|| wire::DecodeError::missing("speed", "vel"))?,
                position_interval: position_interval
                    .ok_or_else(|| wire::DecodeError::missing(
                        "position_interval",
                        "xyz_interval",
                    ))?,
                orientation_interval: orientation_interval
                    .ok_or_else(|| wire::DecodeError::missing(
                        "orientation_interval",
                        "rpy_interval",
                    ))?,
            })
        }
    }
    proto::__object_impls!(SetTrajConfig);
    impl check::Validate for SetTrajConfig {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place
                .check(
                    "acceleration",
                    &self.acceleration,
                    &check::Limits {
                        min: Some(0f64),
                        unit: "mm/s²",
                        ..check::Limits::NONE
                    },
                )?;
            place
                .check(
                    "speed",
                    &self.speed,
                    &check::Limits {
                        min: Some(0f64),
                        unit: "mm/s",
                        ..check::Limits::NONE
                    },
                )?;
            place
                .check(
                    "position_interval",
                    &self.position_interval,
                    &check::Limits {
                        min: Some(0f64),
                        ..check::Limits::NONE
                    },
                )?;
            place
                .check(
                    "orientation_interval",
                    &self.orientation_interval,
                    &check::Limits {
                        min: Some(0f64),
                        ..check::Limits::NONE
                    },
                )?;
            Ok(())
        }
    }
    impl proto::Command for SetTrajConfig {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "set_traj_config",
            "{\"cmdName\":\"set_traj_config\"",
            "4.52",
            proto::Effect::Setting,
        );
    }
    /// Reads how finely a trajectory is recorded, and how fast it is run later.
    ///
    /// Sends `get_traj_config` (4.53). Changes nothing on the robot.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct GetTrajConfig;
    impl wire::Fields for GetTrajConfig {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(GetTrajConfig);
    impl check::Validate for GetTrajConfig {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for GetTrajConfig {
        type Reply = GetTrajConfigReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "get_traj_config",
            "{\"cmdName\":\"get_traj_config\"",
            "4.53",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`GetTrajConfig`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct GetTrajConfigReply {
        /// Acceleration at which the trajectory is run. In mm/s².
        ///
        /// `acc` on the wire.
        #[doc(alias = "acc")]
        pub acceleration: f64,
        /// Interval at which Cartesian displacement is recorded. Unit not stated.
        ///
        /// `xyz_interval` on the wire.
        #[doc(alias = "xyz_interval")]
        pub position_interval: f64,
        /// Interval at which Cartesian rotation is recorded. Unit not stated.
        ///
        /// `rpy_interval` on the wire.
        #[doc(alias = "rpy_interval")]
        pub orientation_interval: f64,
        /// Speed at which the trajectory is run. In mm/s.
        ///
        /// `vel` on the wire.
        #[doc(alias = "vel")]
        pub speed: f64,
    }
    impl wire::Fields for GetTrajConfigReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"acc\":");
            wire::Encode::encode(&self.acceleration, out);
            out.raw(",\"xyz_interval\":");
            wire::Encode::encode(&self.position_interval, out);
            out.raw(",\"rpy_interval\":");
            wire::Encode::encode(&self.orientation_interval, out);
            out.raw(",\"vel\":");
            wire::Encode::encode(&self.speed, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut acceleration = None;
            let mut position_interval = None;
            let mut orientation_interval = None;
            let mut speed = None;
            let mut keys = reader
                .begin_fields(
                    &["\"acc\":", "\"xyz_interval\":", "\"rpy_interval\":", "\"vel\":"],
                )?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("acceleration", &mut acceleration)?,
                    1 => reader.field("position_interval", &mut position_interval)?,
                    2 => reader.field("orientation_interval", &mut orientation_interval)?,
                    3 => reader.field("speed", &mut speed)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                acceleration: acceleration
                    .ok_or_else(|| wire::DecodeError::missing("acceleration", "acc"))?,
                position_interval: position_interval
                    .ok_or_else(|| wire::DecodeError::missing(
                        "position_interval",
                        "xyz_interval",
                    ))?,
                orientation_interval: orientation_interval
                    .ok_or_else(|| wire::DecodeError::missing(
                        "orientation_interval",
                        "rpy_interval",
                    ))?,
                speed: speed.ok_or_else(|| wire::DecodeError::missing("speed", "vel"))?,
            })
        }
    }
    proto::__object_impls!(GetTrajConfigReply);
    /// Starts or stops the recording of a trajectory to a file.
    ///
    /// Sends `set_traj_sample_mode` (4.54).
    ///
    /// # Errata
    ///
    /// - The key is `filename` here and `fileName` in 4.58 and 4.59.
    #[derive(Debug, Clone, PartialEq)]
    pub struct SetTrajSampleMode {
        /// Whether to record.
        pub mode: super::types::Switch,
        /// Name of the trajectory file.
        ///
        /// `filename` on the wire.
        #[doc(alias = "filename")]
        pub file_name: String,
    }
    impl wire::Fields for SetTrajSampleMode {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"mode\":");
            wire::Encode::encode(&self.mode, out);
            out.raw(",\"filename\":");
            wire::Encode::encode(&self.file_name, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut mode = None;
            let mut file_name = None;
            let mut keys = reader.begin_fields(&["\"mode\":", "\"filename\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("mode", &mut mode)?,
                    1 => reader.field("file_name", &mut file_name)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                mode: mode.ok_or_else(|| wire::DecodeError::missing("mode", "mode"))?,
                file_name: file_name
                    .ok_or_else(|| wire::DecodeError::missing("file_name", "filename"))?,
            })
        }
    }
    proto::__object_impls!(SetTrajSampleMode);
    impl check::Validate for SetTrajSampleMode {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("mode", &self.mode, &check::Limits::NONE)?;
            place.check("file_name", &self.file_name, &check::Limits::NONE)?;
            Ok(())
        }
    }
    impl proto::Command for SetTrajSampleMode {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "set_traj_sample_mode",
            "{\"cmdName\":\"set_traj_sample_mode\"",
            "4.54",
            proto::Effect::Setting,
        );
    }
    /// Reads whether a trajectory is being recorded.
    ///
    /// Sends `get_traj_sample_status` (4.55). Changes nothing on the robot.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct GetTrajSampleStatus;
    impl wire::Fields for GetTrajSampleStatus {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(GetTrajSampleStatus);
    impl check::Validate for GetTrajSampleStatus {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for GetTrajSampleStatus {
        type Reply = GetTrajSampleStatusReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "get_traj_sample_status",
            "{\"cmdName\":\"get_traj_sample_status\"",
            "4.55",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`GetTrajSampleStatus`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct GetTrajSampleStatusReply {
        /// Whether recording is on.
        ///
        /// `sampleStatus` on the wire.
        #[doc(alias = "sampleStatus")]
        pub sampling: bool,
    }
    impl wire::Fields for GetTrajSampleStatusReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"sampleStatus\":");
            out.choose(*&self.sampling, "0", "1");
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut sampling = None;
            let mut keys = reader.begin_fields(&["\"sampleStatus\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("sampling", &mut sampling)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                sampling: sampling
                    .ok_or_else(|| wire::DecodeError::missing(
                        "sampling",
                        "sampleStatus",
                    ))?,
            })
        }
    }
    proto::__object_impls!(GetTrajSampleStatusReply);
    /// Reads the names of the trajectory files on the controller.
    ///
    /// Sends `get_exist_traj_file_name` (4.56). Changes nothing on the robot.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct GetExistTrajFileName;
    impl wire::Fields for GetExistTrajFileName {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(GetExistTrajFileName);
    impl check::Validate for GetExistTrajFileName {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for GetExistTrajFileName {
        type Reply = GetExistTrajFileNameReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "get_exist_traj_file_name",
            "{\"cmdName\":\"get_exist_traj_file_name\"",
            "4.56",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`GetExistTrajFileName`].
    #[derive(Debug, Clone, PartialEq)]
    pub struct GetExistTrajFileNameReply {
        /// Names of the trajectory files.
        ///
        /// `trajTrackFileName` on the wire.
        #[doc(alias = "trajTrackFileName")]
        pub file_names: Vec<String>,
    }
    impl wire::Fields for GetExistTrajFileNameReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"trajTrackFileName\":");
            wire::Encode::encode(&self.file_names, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut file_names = None;
            let mut keys = reader.begin_fields(&["\"trajTrackFileName\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("file_names", &mut file_names)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                file_names: file_names
                    .ok_or_else(|| wire::DecodeError::missing(
                        "file_names",
                        "trajTrackFileName",
                    ))?,
            })
        }
    }
    proto::__object_impls!(GetExistTrajFileNameReply);
    /// Renames a trajectory file.
    ///
    /// Sends `rename_traj_file_name` (4.57).
    #[derive(Debug, Clone, PartialEq)]
    pub struct RenameTrajFileName {
        /// Present name of the trajectory file.
        ///
        /// `src` on the wire.
        #[doc(alias = "src")]
        pub source: String,
        /// New name of the trajectory file.
        ///
        /// `dest` on the wire.
        #[doc(alias = "dest")]
        pub destination: String,
    }
    impl wire::Fields for RenameTrajFileName {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"src\":");
            wire::Encode::encode(&self.source, out);
            out.raw(",\"dest\":");
            wire::Encode::encode(&self.destination, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut source = None;
            let mut destination = None;
            let mut keys = reader.begin_fields(&["\"src\":", "\"dest\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("source", &mut source)?,
                    1 => reader.field("destination", &mut destination)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                source: source
                    .ok_or_else(|| wire::DecodeError::missing("source", "src"))?,
                destination: destination
                    .ok_or_else(|| wire::DecodeError::missing("destination", "dest"))?,
            })
        }
    }
    proto::__object_impls!(RenameTrajFileName);
    impl check::Validate for RenameTrajFileName {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("source", &self.source, &check::Limits::NONE)?;
            place.check("destination", &self.destination, &check::Limits::NONE)?;
            Ok(())
        }
    }
    impl proto::Command for RenameTrajFileName {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "rename_traj_file_name",
            "{\"cmdName\":\"rename_traj_file_name\"",
            "4.57",
            proto::Effect::Setting,
        );
    }
    /// Deletes a trajectory file.
    ///
    /// Sends `remove_traj_file` (4.58).
    ///
    /// # Errata
    ///
    /// - The document's text calls the key `filename`; its sample sends `fileName`.
    #[derive(Debug, Clone, PartialEq)]
    pub struct RemoveTrajFile {
        /// Name of the trajectory file.
        ///
        /// `fileName` on the wire.
        #[doc(alias = "fileName")]
        pub file_name: String,
    }
    impl wire::Fields for RemoveTrajFile {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"fileName\":");
            wire::Encode::encode(&self.file_name, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut file_name = None;
            let mut keys = reader.begin_fields(&["\"fileName\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("file_name", &mut file_name)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                file_name: file_name
                    .ok_or_else(|| wire::DecodeError::missing("file_name", "fileName"))?,
            })
        }
    }
    proto::__object_impls!(RemoveTrajFile);
    impl check::Validate for RemoveTrajFile {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("file_name", &self.file_name, &check::Limits::NONE)?;
            Ok(())
        }
    }
    impl proto::Command for RemoveTrajFile {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "remove_traj_file",
            "{\"cmdName\":\"remove_traj_file\"",
            "4.58",
            proto::Effect::Setting,
        );
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
    pub struct GenerateTrajExeFile {
        /// Name of the trajectory file.
        ///
        /// `fileName` on the wire.
        #[doc(alias = "fileName")]
        pub file_name: String,
    }
    impl wire::Fields for GenerateTrajExeFile {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"fileName\":");
            wire::Encode::encode(&self.file_name, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut file_name = None;
            let mut keys = reader.begin_fields(&["\"fileName\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("file_name", &mut file_name)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                file_name: file_name
                    .ok_or_else(|| wire::DecodeError::missing("file_name", "fileName"))?,
            })
        }
    }
    proto::__object_impls!(GenerateTrajExeFile);
    impl check::Validate for GenerateTrajExeFile {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("file_name", &self.file_name, &check::Limits::NONE)?;
            Ok(())
        }
    }
    impl proto::Command for GenerateTrajExeFile {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "generate_traj_exe_file",
            "{\"cmdName\":\"generate_traj_exe_file\"",
            "4.59",
            proto::Effect::Setting,
        );
    }
}
