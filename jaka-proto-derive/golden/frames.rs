/// Tool frames and user frames.
///
/// The controller holds tool frames and user frames with the ids 0 to 10. Frame 0 is fixed: the centre of the flange as
/// tool frame, the robot's base frame as user frame. Frames 1 to 10 can be set.
///
/// Which frames are selected decides what Cartesian coordinates mean. Changing a frame changes where the next Cartesian
/// motion goes.
pub mod frames {
    #[allow(unused_imports)]
    use ::jaka_proto::{self as proto, check, wire};
    /// Sets the offset and the name of one tool frame.
    ///
    /// Which frame the robot moves in is selected by `set_tool_id`.
    ///
    /// Sends `set_tool_offsets` (4.28).
    ///
    /// # Errata
    ///
    /// - The key is `tooloffset` here, while the reply of `get_tool_offsets` has `tool_offsets`.
    #[derive(Debug, Clone, PartialEq)]
    pub struct SetToolOffsets {
        /// Offset of the tool frame.
        ///
        /// `tooloffset` on the wire.
        #[doc(alias = "tooloffset")]
        pub offset: super::types::Pose,
        /// Id of the tool frame to set. 1 to 10.
        pub id: i64,
        /// Name of the tool frame.
        pub name: String,
    }
    impl wire::Fields for SetToolOffsets {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"tooloffset\":");
            wire::Encode::encode(&self.offset, out);
            out.raw(",\"id\":");
            wire::Encode::encode(&self.id, out);
            out.raw(",\"name\":");
            wire::Encode::encode(&self.name, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut offset = None;
            let mut id = None;
            let mut name = None;
            let mut keys = reader
                .begin_fields(&["\"tooloffset\":", "\"id\":", "\"name\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("offset", &mut offset)?,
                    1 => reader.field("id", &mut id)?,
                    2 => reader.field("name", &mut name)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                offset: offset
                    .ok_or_else(|| wire::DecodeError::missing("offset", "tooloffset"))?,
                id: id.ok_or_else(|| wire::DecodeError::missing("id", "id"))?,
                name: name.ok_or_else(|| wire::DecodeError::missing("name", "name"))?,
            })
        }
    }
    proto::__object_impls!(SetToolOffsets);
    impl check::Validate for SetToolOffsets {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("offset", &self.offset, &check::Limits::NONE)?;
            place
                .check(
                    "id",
                    &self.id,
                    &check::Limits {
                        min: Some(1f64),
                        max: Some(10f64),
                        ..check::Limits::NONE
                    },
                )?;
            place.check("name", &self.name, &check::Limits::NONE)?;
            Ok(())
        }
    }
    impl proto::Command for SetToolOffsets {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "set_tool_offsets",
            "{\"cmdName\":\"set_tool_offsets\"",
            "4.28",
            proto::Effect::Setting,
        );
    }
    /// Selects the tool frame in which the robot moves.
    ///
    /// Id 0 selects the centre of the flange.
    ///
    /// Sends `set_tool_id` (4.29).
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct SetToolId {
        /// Id of the tool frame to use. 0 to 10.
        pub tool_id: i64,
    }
    impl wire::Fields for SetToolId {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"tool_id\":");
            wire::Encode::encode(&self.tool_id, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut tool_id = None;
            let mut keys = reader.begin_fields(&["\"tool_id\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("tool_id", &mut tool_id)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                tool_id: tool_id
                    .ok_or_else(|| wire::DecodeError::missing("tool_id", "tool_id"))?,
            })
        }
    }
    proto::__object_impls!(SetToolId);
    impl check::Validate for SetToolId {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place
                .check(
                    "tool_id",
                    &self.tool_id,
                    &check::Limits {
                        min: Some(0f64),
                        max: Some(10f64),
                        ..check::Limits::NONE
                    },
                )?;
            Ok(())
        }
    }
    impl proto::Command for SetToolId {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "set_tool_id",
            "{\"cmdName\":\"set_tool_id\"",
            "4.29",
            proto::Effect::Setting,
        );
    }
    /// Reads the offsets of all tool frames.
    ///
    /// Sends `get_tool_offsets` (4.30). Changes nothing on the robot.
    ///
    /// # Errata
    ///
    /// - The text writes the key `tool_offset`, the sample `tool_offsets`.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct GetToolOffsets;
    impl wire::Fields for GetToolOffsets {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(GetToolOffsets);
    impl check::Validate for GetToolOffsets {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for GetToolOffsets {
        type Reply = GetToolOffsetsReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "get_tool_offsets",
            "{\"cmdName\":\"get_tool_offsets\"",
            "4.30",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`GetToolOffsets`].
    #[derive(Debug, Clone, PartialEq)]
    pub struct GetToolOffsetsReply {
        /// Offset of each tool frame, by id from 0. The document counts 11.
        ///
        /// `tool_offsets` on the wire.
        #[doc(alias = "tool_offsets")]
        pub offsets: Vec<super::types::Pose>,
    }
    impl wire::Fields for GetToolOffsetsReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"tool_offsets\":");
            wire::Encode::encode(&self.offsets, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut offsets = None;
            let mut keys = reader.begin_fields(&["\"tool_offsets\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("offsets", &mut offsets)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                offsets: offsets
                    .ok_or_else(|| wire::DecodeError::missing(
                        "offsets",
                        "tool_offsets",
                    ))?,
            })
        }
    }
    proto::__object_impls!(GetToolOffsetsReply);
    /// Sets the offset and the name of one user frame.
    ///
    /// Which frame the robot moves in is selected by `set_user_id`.
    ///
    /// Sends `set_user_offsets` (4.31).
    ///
    /// # Errata
    ///
    /// - The key is spelled `userffset` in sample and text, without the o, and controllers expect it so.
    #[derive(Debug, Clone, PartialEq)]
    pub struct SetUserOffsets {
        /// Offset of the user frame.
        ///
        /// `userffset` on the wire.
        #[doc(alias = "userffset")]
        pub offset: super::types::Pose,
        /// Id of the user frame to set. 1 to 10.
        pub id: i64,
        /// Name of the user frame.
        pub name: String,
    }
    impl wire::Fields for SetUserOffsets {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"userffset\":");
            wire::Encode::encode(&self.offset, out);
            out.raw(",\"id\":");
            wire::Encode::encode(&self.id, out);
            out.raw(",\"name\":");
            wire::Encode::encode(&self.name, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut offset = None;
            let mut id = None;
            let mut name = None;
            let mut keys = reader
                .begin_fields(&["\"userffset\":", "\"id\":", "\"name\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("offset", &mut offset)?,
                    1 => reader.field("id", &mut id)?,
                    2 => reader.field("name", &mut name)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                offset: offset
                    .ok_or_else(|| wire::DecodeError::missing("offset", "userffset"))?,
                id: id.ok_or_else(|| wire::DecodeError::missing("id", "id"))?,
                name: name.ok_or_else(|| wire::DecodeError::missing("name", "name"))?,
            })
        }
    }
    proto::__object_impls!(SetUserOffsets);
    impl check::Validate for SetUserOffsets {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("offset", &self.offset, &check::Limits::NONE)?;
            place
                .check(
                    "id",
                    &self.id,
                    &check::Limits {
                        min: Some(1f64),
                        max: Some(10f64),
                        ..check::Limits::NONE
                    },
                )?;
            place.check("name", &self.name, &check::Limits::NONE)?;
            Ok(())
        }
    }
    impl proto::Command for SetUserOffsets {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "set_user_offsets",
            "{\"cmdName\":\"set_user_offsets\"",
            "4.31",
            proto::Effect::Setting,
        );
    }
    /// Selects the user frame in which the robot moves.
    ///
    /// Id 0 selects the robot's base frame.
    ///
    /// Sends `set_user_id` (4.32).
    ///
    /// # Errata
    ///
    /// - The text calls the key `set_user_id`. The sample has `user_frame_id`, and controllers expect it so.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct SetUserId {
        /// Id of the user frame to use. 0 to 10.
        pub user_frame_id: i64,
    }
    impl wire::Fields for SetUserId {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"user_frame_id\":");
            wire::Encode::encode(&self.user_frame_id, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut user_frame_id = None;
            let mut keys = reader.begin_fields(&["\"user_frame_id\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("user_frame_id", &mut user_frame_id)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                user_frame_id: user_frame_id
                    .ok_or_else(|| wire::DecodeError::missing(
                        "user_frame_id",
                        "user_frame_id",
                    ))?,
            })
        }
    }
    proto::__object_impls!(SetUserId);
    impl check::Validate for SetUserId {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place
                .check(
                    "user_frame_id",
                    &self.user_frame_id,
                    &check::Limits {
                        min: Some(0f64),
                        max: Some(10f64),
                        ..check::Limits::NONE
                    },
                )?;
            Ok(())
        }
    }
    impl proto::Command for SetUserId {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "set_user_id",
            "{\"cmdName\":\"set_user_id\"",
            "4.32",
            proto::Effect::Setting,
        );
    }
    /// Reads the offsets of all user frames.
    ///
    /// Sends `get_user_offsets` (4.33). Changes nothing on the robot.
    ///
    /// # Errata
    ///
    /// - The text is copied from 4.30: it writes the key `tool_offset` and speaks of tool frames.
    /// - In the sample, frame 1 repeats its positions as angles, down to -439 degrees. It is no measured frame.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct GetUserOffsets;
    impl wire::Fields for GetUserOffsets {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(GetUserOffsets);
    impl check::Validate for GetUserOffsets {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for GetUserOffsets {
        type Reply = GetUserOffsetsReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "get_user_offsets",
            "{\"cmdName\":\"get_user_offsets\"",
            "4.33",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`GetUserOffsets`].
    #[derive(Debug, Clone, PartialEq)]
    pub struct GetUserOffsetsReply {
        /// Offset of each user frame, by id from 0. The document counts 11.
        ///
        /// `user_offsets` on the wire.
        #[doc(alias = "user_offsets")]
        pub offsets: Vec<super::types::Pose>,
    }
    impl wire::Fields for GetUserOffsetsReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"user_offsets\":");
            wire::Encode::encode(&self.offsets, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut offsets = None;
            let mut keys = reader.begin_fields(&["\"user_offsets\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("offsets", &mut offsets)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                offsets: offsets
                    .ok_or_else(|| wire::DecodeError::missing(
                        "offsets",
                        "user_offsets",
                    ))?,
            })
        }
    }
    proto::__object_impls!(GetUserOffsetsReply);
}
