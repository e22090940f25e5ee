impl Client {
    /// Switches the arm's power on.
    ///
    /// This takes about 8 s. Firmware 1.5.14 replies when the arm has power (three transcripts), newer firmware at once (vendor's SDK). So an
    /// errorCode of 0 is no proof that the arm has power: poll the state.
    ///
    /// Sends `power_on` (4.1).
    ///
    /// # Errata
    ///
    /// - The reply's key `power status` has a blank in it.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn power_on(
        &mut self,
    ) -> Result<::jaka_proto::messages::power::PowerOnReply, Error> {}
    /// Switches the arm's power off.
    ///
    /// It wants a disabled arm (event `0x0F0026`).
    ///
    /// Sends `power_off` (4.2).
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn power_off(&mut self) -> Result<(), Error> {}
    /// Enables the arm, so that it can move.
    ///
    /// This takes 3 to 4 s as a rule; 20 s is seen. Firmware 1.5.14 replies when the arm is enabled (transcripts), newer firmware at once
    /// (vendor's SDK). So an errorCode of 0 is no proof that the arm is enabled: poll the state.
    ///
    /// Sends `enable_robot` (4.3). The robot must be powered.
    ///
    /// # Errata
    ///
    /// - The reply's key `enabled status` has a blank in it.
    ///
    /// # Errors
    /// As [`call`](Self::call). In another state than the one it needs, expect a refusal.
    pub fn enable_robot(
        &mut self,
    ) -> Result<::jaka_proto::messages::power::EnableRobotReply, Error> {}
    /// Disables the arm.
    ///
    /// It is refused while the arm moves or a program runs (events `0x0F003A` and `0x0F0027`).
    ///
    /// Sends `disable_robot` (4.4).
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn disable_robot(&mut self) -> Result<(), Error> {}
    /// Shuts down the arm and the controller.
    ///
    /// It wants an arm without power (vendor's table of events). The document shows a reply, users see none. The connection is of no use
    /// afterwards.
    ///
    /// Sends `shutdown` (4.5).
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn shutdown(&mut self) -> Result<(), Error> {}
    /// Reads whether the arm has power and is enabled.
    ///
    /// Old firmware answers with the document's words, newer firmware with true and false or with numbers, and adds the
    /// controller's error.
    ///
    /// Sends `get_robot_state` (4.12). Changes nothing on the robot.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn get_robot_state(
        &mut self,
    ) -> Result<::jaka_proto::messages::power::GetRobotStateReply, Error> {}
    /// Reads the version of the controller's software.
    ///
    /// Sends `get_version` (4.51). Changes nothing on the robot.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn get_version(
        &mut self,
    ) -> Result<::jaka_proto::messages::power::GetVersionReply, Error> {}
    /// Moves one joint, or one Cartesian coordinate of the tool centre point, continuously, by an increment or to a position.
    ///
    /// Send `Stop` for an axis before the next jog of the same axis. The frame decides what `axis` counts: joints 1 to 6, or
    /// x, y, z, rx, ry, rz, both from 0 to 5.
    ///
    /// Sends `jog` (4.6). The robot must be powered, enabled and outside servo mode.
    ///
    /// # Errata
    ///
    /// - The document says that there are three jog modes and lists four.
    /// - The document's samples for increment and absolute send `jnum` 3, axis 4, and call it joint 2.
    /// - The text gives `poscmd` in millimetres on every Cartesian axis, rotations included, and `jogvel` a unit only on a joint, deg/s. The other units follow from the field notes, which find degrees and millimetres throughout.
    ///
    /// # Errors
    /// As [`call`](Self::call). In another state than the one it needs, expect a refusal.
    pub fn jog(
        &mut self,
        request: &::jaka_proto::messages::motion::Jog,
    ) -> Result<(), Error> {}
    /// Moves all joints to a position, or by an offset, at a joint speed (MoveJ).
    ///
    /// The motion starts when the one before it has ended. To move at once, stop that one first with `stop_program`.
    ///
    /// The reply says that the motion was accepted, not that it has ended.
    ///
    /// Sends `joint_move` (4.7). The robot must be powered, enabled and outside servo mode.
    ///
    /// # Errors
    /// As [`call`](Self::call). In another state than the one it needs, expect a refusal.
    pub fn joint_move(
        &mut self,
        request: &::jaka_proto::messages::motion::JointMove,
    ) -> Result<(), Error> {}
    /// Moves all joints so that the tool centre point reaches a pose.
    ///
    /// The tool centre point does not follow a straight line. The controller computes the joint positions for the pose and
    /// moves to them as `joint_move` does; so speed and acceleration are those of joints. For a straight line use `move_l`.
    ///
    /// The motion starts when the one before it has ended. To move at once, stop that one first with `stop_program`.
    ///
    /// The reply says that the motion was accepted, not that it has ended.
    ///
    /// Sends `end_move` (4.8). The robot must be powered, enabled and outside servo mode.
    ///
    /// # Errors
    /// As [`call`](Self::call). In another state than the one it needs, expect a refusal.
    pub fn end_move(
        &mut self,
        request: &::jaka_proto::messages::motion::EndMove,
    ) -> Result<(), Error> {}
    /// Moves the tool centre point along a straight line to a pose, or by an offset (MoveL).
    ///
    /// The motion starts when the one before it has ended. To move at once, stop that one first with `stop_program`.
    ///
    /// The reply says that the motion was accepted, not that it has ended.
    ///
    /// Sends `moveL` (4.9). The robot must be powered, enabled and outside servo mode.
    ///
    /// # Errata
    ///
    /// - The sample has `tol`, which the text of 4.9 leaves out. 4.10 explains it, without a unit; millimetres follow from the field notes, which find them throughout.
    ///
    /// # Errors
    /// As [`call`](Self::call). In another state than the one it needs, expect a refusal.
    #[doc(alias = "moveL")]
    pub fn move_l(
        &mut self,
        request: &::jaka_proto::messages::motion::MoveL,
    ) -> Result<(), Error> {}
    /// Moves the tool centre point along an arc, through one pose to another (MoveC).
    ///
    /// The three points, the present one among them, must differ: otherwise the controller refuses the motion with the event
    /// `0x0F0029`.
    ///
    /// The reply says that the motion was accepted, not that it has ended.
    ///
    /// Sends `movc` (4.10). The robot must be powered, enabled and outside servo mode.
    ///
    /// # Errata
    ///
    /// - The text gives speed and acceleration in deg/s and deg/s², of joints, and advises 720 deg/s² at most, in the words of 4.8. They are mm/s and mm/s² (four other texts of the vendor).
    /// - The text does not explain `relFlag`, nor what the two poses are relative to when it is 1.
    /// - The text calls `tol` the greatest error allowed, and names no unit. It is in millimetres, and lets the motion blend into the next one (vendor's manual).
    /// - The `cmdName` is `movc`, while the section is titled MoveC.
    ///
    /// # Errors
    /// As [`call`](Self::call). In another state than the one it needs, expect a refusal.
    #[doc(alias = "movc")]
    pub fn move_c(
        &mut self,
        request: &::jaka_proto::messages::motion::MoveC,
    ) -> Result<(), Error> {}
    /// Waits until the motion that is running has ended.
    ///
    /// The document calls it withdrawn and advises against it, without saying what it does. On old firmware the reply comes
    /// when the motion ends.
    ///
    /// Sends `wait_complete` (4.41).
    ///
    /// Withdrawn by the vendor: watch the status of port 10000 until the robot is in position.
    ///
    /// # Errata
    ///
    /// - In the sample, the reply's `cmdName` begins with a blank.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    #[deprecated(note = "watch the status of port 10000 until the robot is in position")]
    pub fn wait_complete(&mut self) -> Result<(), Error> {}
    /// Reads whether the robot is in servo mode.
    ///
    /// Sends `is_in_servomove` (4.13). Changes nothing on the robot.
    ///
    /// # Errata
    ///
    /// - The text explains `relFlag`, which neither request nor reply has; it belongs to `servo_move` (4.14).
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn is_in_servomove(
        &mut self,
    ) -> Result<::jaka_proto::messages::servo::IsInServomoveReply, Error> {}
    /// Enters or leaves servo mode.
    ///
    /// An arm at rest enters at once: within 9 ms on firmware 1.5.14. While the arm moves, the command is acknowledged and servo mode is not
    /// entered: `is_in_servomove` stays false, and `servo_j` is refused with code -1 (two transcripts of firmware 1.5.14). So send it to an arm
    /// at rest, and ask `is_in_servomove` before the first set-point.
    ///
    /// Sends `servo_move` (4.14). The robot must be powered and enabled.
    ///
    /// # Errata
    ///
    /// - The key `relFlag` means enter or leave here. In other commands it chooses between target and offset.
    ///
    /// # Errors
    /// As [`call`](Self::call). In another state than the one it needs, expect a refusal.
    #[doc(alias = "servo_move")]
    pub fn set_servo_mode(
        &mut self,
        servo_mode: ::jaka_proto::messages::types::Switch,
    ) -> Result<(), Error> {}
    /// Moves all joints to a set-point, or by an offset, within one servo period.
    ///
    /// The planner does not interpolate: set-points must follow one another every 8 ms times `step_count`, and a single one
    /// shows no effect. A set-point that asks more than 180 deg/s of a joint has no effect: the document's example is 1.5
    /// degrees in 8 ms, which is 187.5 deg/s.
    ///
    /// Every set-point is answered. The answers need not be waited for, but must be read. Enter servo mode with `servo_move`
    /// first.
    ///
    /// Sends `servo_j` (4.15). The robot must be powered, enabled and in servo mode.
    ///
    /// # Errata
    ///
    /// - The text writes the key `stepnum`, the sample `stepNum`.
    /// - The text asks for a set-point every 8 ms, and for one every 8 ms times `stepnum`. Field notes: the latter.
    /// - The text calls `joint_move` the fifth command. It is in 4.7.
    ///
    /// # Errors
    /// As [`call`](Self::call). In another state than the one it needs, the controller refuses with code -1, `servoj command can only be excuted in servo move mode`.
    pub fn servo_j(
        &mut self,
        request: &::jaka_proto::messages::servo::ServoJ,
    ) -> Result<(), Error> {}
    /// Moves the tool centre point to a set-point, or by an offset, within one servo period.
    ///
    /// The planner does not interpolate: set-points must follow one another every 8 ms times `step_count`. Keep the steps
    /// between them small, so that the controller's speed limits are not exceeded; the document names no number.
    ///
    /// Every set-point is answered. The answers need not be waited for, but must be read. Enter servo mode with `servo_move`
    /// first.
    ///
    /// Sends `servo_p` (4.16). The robot must be powered, enabled and in servo mode.
    ///
    /// # Errata
    ///
    /// - The key is spelled `catPosition`, and controllers expect it so. Other commands have `cartPosition`.
    /// - The text writes the key `stepnum`, the sample `stepNum`.
    /// - The text asks for a set-point every 8 ms, and for one every 8 ms times `stepnum`. Field notes: the latter.
    /// - The text speaks of points of the six joints and of `servo_j`, as copied from 4.15. The set-point is a pose.
    ///
    /// # Errors
    /// As [`call`](Self::call). In another state than the one it needs, expect a refusal.
    pub fn servo_p(
        &mut self,
        request: &::jaka_proto::messages::servo::ServoP,
    ) -> Result<(), Error> {}
    /// Sets the filter that smooths the set-points of servo mode.
    ///
    /// It can be set only outside servo mode. Filters 1, 2, 3 and 5 act on `servo_j` and `servo_p`, filter 4 on `servo_p` alone (vendor's
    /// manual).
    ///
    /// Sends `set_servo_move_filter` (4.60). The robot must be outside servo mode.
    ///
    /// # Errata
    ///
    /// - The text calls `filter_type` the motion mode, as copied from 4.6.
    /// - The text writes the keys `max_vr`, `max_ar`, `max_jr`, `max_vp`, `max_ap` and `max_jp`. The samples have `nlf_` before each of them.
    /// - The limits on rotation are printed in %/s, %/s^2 and %/s^3, without anything they could be a percentage of. Those of filter 2 are degrees (vendor's manual), and the field notes find degrees throughout.
    /// - The limits of filter 2 are explained as limits on how fast the orientation changes, as those of filter 4, which works in Cartesian space. They are limits of the joints (vendor's manual).
    /// - Filter 5 is listed as speed look-ahead and explained as filter 3, the multi-stage mean filter of the joints.
    /// - `mmf_kp` is explained as coefficient of the position for filter 3, and of the acceleration for filter 5. It is that of the position for both (vendor's manual).
    /// - For filter 5 the text writes the key `max_buf`, the sample `mmf_max_buf`.
    /// - `mmf_ka` is explained as coefficient of acceleration and position. The key speaks of the acceleration alone.
    ///
    /// # Errors
    /// As [`call`](Self::call). In another state than the one it needs, expect a refusal.
    pub fn set_servo_move_filter(
        &mut self,
        request: &::jaka_proto::messages::servo::SetServoMoveFilter,
    ) -> Result<(), Error> {}
    /// Sets the rate by which the controller scales the speed of motion.
    ///
    /// The document speaks of the rate at which programs run; whether a motion that is running follows the new rate at once
    /// is not stated.
    ///
    /// Sends `rapid_rate` (4.17).
    ///
    /// # Errors
    /// As [`call`](Self::call).
    #[doc(alias = "rapid_rate")]
    pub fn set_rapid_rate(&mut self, rate: f64) -> Result<(), Error> {}
    /// Loads a program that is stored on the controller.
    ///
    /// The name ends in `.ngc` on controllers before version 1.5 and in `.jks` from 1.5 on. A trajectory's file has `track/`
    /// before its name.
    ///
    /// Sends `load_program` (4.18).
    ///
    /// # Errata
    ///
    /// - The text writes the key `program_name`, the sample `programName`.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn load_program(
        &mut self,
        program_name: impl Into<String>,
    ) -> Result<(), Error> {}
    /// Reads the name of the loaded program.
    ///
    /// Sends `get_loaded_program` (4.19). Changes nothing on the robot.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn get_loaded_program(
        &mut self,
    ) -> Result<::jaka_proto::messages::program::GetLoadedProgramReply, Error> {}
    /// Starts the loaded program.
    ///
    /// Sends `play_program` (4.20). The robot must be powered and enabled.
    ///
    /// Reconstructed, since the document's page is lost: reply only: the document has the request, the page with the reply is lost. Field notes: certain.
    ///
    /// # Errors
    /// As [`call`](Self::call). In another state than the one it needs, expect a refusal.
    pub fn play_program(&mut self) -> Result<(), Error> {}
    /// Pauses the program that is running.
    ///
    /// Sends `pause_program` (4.21).
    ///
    /// Reconstructed, since the document's page is lost: The document's page is lost. Field notes: request and reply likely.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn pause_program(&mut self) -> Result<(), Error> {}
    /// Resumes the program that is paused.
    ///
    /// Sends `resume_program` (4.22). The robot must be powered and enabled.
    ///
    /// Reconstructed, since the document's page is lost: The document's page is lost. Field notes: request and reply likely.
    ///
    /// # Errors
    /// As [`call`](Self::call). In another state than the one it needs, expect a refusal.
    pub fn resume_program(&mut self) -> Result<(), Error> {}
    /// Stops the program, or the motion, that is running.
    ///
    /// This is also the usual way to abort `joint_move`, `end_move` or `move_l` with no program loaded. No source says whether
    /// it ends `move_c`, a jog or servo motion too, nor what becomes of motions that wait their turn. It is no emergency stop:
    /// the command travels over the network.
    ///
    /// Sends `stop_program` (4.23).
    ///
    /// Reconstructed, since the document's page is lost: The document's page is lost. Field notes: request and reply certain. Sections 4.7 to 4.9 name it to end a motion.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn stop_program(&mut self) -> Result<(), Error> {}
    /// Reads the state of the program.
    ///
    /// Sends `get_program_state` (4.24). Changes nothing on the robot.
    ///
    /// Reconstructed, since the document's page is lost: The document's page is lost. Field notes: request and key certain; value `idle` certain, `running` and `paused` likely.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn get_program_state(
        &mut self,
    ) -> Result<::jaka_proto::messages::program::GetProgramStateReply, Error> {}
    /// Sets one digital output.
    ///
    /// Controllers do not agree on the first output's number: some firmware counts `index` from 0, other firmware from 1. Check
    /// on the controller at hand which output switches before anything is wired to it.
    ///
    /// Sends `set_digital_output` (4.25).
    ///
    /// Reconstructed, since the document's page is lost: The document's page is lost. Field notes: request and reply certain; output types 0 to 6 certain, 3 to 6 on newer firmware only.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn set_digital_output(
        &mut self,
        request: &::jaka_proto::messages::io::SetDigitalOutput,
    ) -> Result<(), Error> {}
    /// Reads the states of all digital inputs.
    ///
    /// The first eight are the cabinet's own inputs. The controller occupies the first of them, so it is not for use. The
    /// document calls the others Modbus inputs.
    ///
    /// Sends `get_digital_input_status` (4.26). Changes nothing on the robot.
    ///
    /// Reconstructed, since the document's page is lost: The document's page is lost but for one sentence about `din_status`. Field notes: request, key and type certain; 64 and 136 entries seen.
    ///
    /// # Errata
    ///
    /// - The sentence that is left of the document counts 136 inputs. Controllers send other numbers too; 64 is seen.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn get_digital_input_status(
        &mut self,
    ) -> Result<::jaka_proto::messages::io::GetDigitalInputStatusReply, Error> {}
    /// Sets one analog output.
    ///
    /// The document names no unit for the value and no range.
    ///
    /// Sends `set_analog_output` (4.27).
    ///
    /// # Errata
    ///
    /// - The document numbers the cabinet's outputs from 0 to 7 and says to send 7 for the seventh, which would be the eighth when counted from 0.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn set_analog_output(
        &mut self,
        request: &::jaka_proto::messages::io::SetAnalogOutput,
    ) -> Result<(), Error> {}
    /// Reads the configuration and state of the extension I/O modules.
    ///
    /// Sends `get_extio_status` (4.34). Changes nothing on the robot.
    ///
    /// # Errata
    ///
    /// - The document prints the reply of a controller without modules as a bare tuple, `(0, [], {'state': 0})`, without JSON around it. Both that and the same text inside the JSON string are read.
    /// - The sample configures eight digital inputs and reports the states of nine.
    /// - Here `state` 0 means that the modules do not run and 1 that they do. Chapter 2 describes `mode` of `extio` on port 10000, also called the modules' state, as 0 for on and 1 for off.
    /// - Chapter 2 describes the same settings with the pins as an array in the order di, do, ai, ao. Here they are a dictionary.
    /// - No RTU module is shown here. Its settings follow chapter 2, which lists the data bits twice: as data bit length before the slave number, and as data bits behind it.
    /// - Chapter 2 lists a slave number behind a TCP module's port. The sample here has none.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn get_extio_status(
        &mut self,
    ) -> Result<::jaka_proto::messages::io::GetExtioStatusReply, Error> {}
    /// Reads which inputs serve as function inputs.
    ///
    /// The entries stand for these functions, in this order:
    ///
    /// 1. start the program
    /// 2. pause the program
    /// 3. resume the program
    /// 4. stop the program
    /// 5. switch power on
    /// 6. switch power off
    /// 7. enable the robot
    /// 8. disable the robot
    /// 9. reduced mode, level 1
    /// 10. protective stop
    /// 11. return to the initial position
    /// 12. reduced mode, level 2
    /// 13. clear the error (likely)
    /// 14. enter drag mode (likely)
    /// 15. leave drag mode (likely)
    ///
    /// The document has the first twelve.
    ///
    /// Sends `get_funcdi_status` (4.35). Changes nothing on the robot.
    ///
    /// # Errata
    ///
    /// - The document counts 12 functions, its sample has 13 entries, and port 10000 sends 12, 13 or 15 of them.
    /// - The text calls the sample's `[0, 2]` the entry of reduced mode, level 1, the ninth function. In the sample it is the tenth entry, which the list gives to the protective stop.
    /// - The text writes the key `funci_status`, the sample `funcdi_status`.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn get_funcdi_status(
        &mut self,
    ) -> Result<::jaka_proto::messages::io::GetFuncdiStatusReply, Error> {}
    /// Sets the voltage output of a version 3 tool I/O board.
    ///
    /// The sources contradict each other on both values, and a tool meant for 12 V can be destroyed by 24 V. So both values stay raw. The TCP
    /// document stands alone against two SDK headers, the vendor's manual, six users, and one program on port 10001 itself; no measurement is
    /// known. With no tool connected, measure first which value gives which voltage.
    ///
    /// The setting wants a disabled arm (one client).
    ///
    /// Sends `set_tio_vout_param` (4.80).
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn set_tio_vout_param(
        &mut self,
        request: &::jaka_proto::messages::io::SetTioVoutParam,
    ) -> Result<(), Error> {}
    /// Reads the settings of the voltage output of a version 3 tool I/O board.
    ///
    /// The sources contradict each other on the meaning of both values, so both stay raw. `set_tio_vout_param` has the readings.
    ///
    /// Sends `get_tio_vout_param` (4.81). Changes nothing on the robot.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn get_tio_vout_param(
        &mut self,
    ) -> Result<::jaka_proto::messages::io::GetTioVoutParamReply, Error> {}
    /// Sets the offset and the name of one tool frame.
    ///
    /// Which frame the robot moves in is selected by `set_tool_id`.
    ///
    /// Sends `set_tool_offsets` (4.28).
    ///
    /// # Errata
    ///
    /// - The key is `tooloffset` here, while the reply of `get_tool_offsets` has `tool_offsets`.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn set_tool_offsets(
        &mut self,
        request: &::jaka_proto::messages::frames::SetToolOffsets,
    ) -> Result<(), Error> {}
    /// Selects the tool frame in which the robot moves.
    ///
    /// Id 0 selects the centre of the flange.
    ///
    /// Sends `set_tool_id` (4.29).
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn set_tool_id(&mut self, tool_id: i64) -> Result<(), Error> {}
    /// Reads the offsets of all tool frames.
    ///
    /// Sends `get_tool_offsets` (4.30). Changes nothing on the robot.
    ///
    /// # Errata
    ///
    /// - The text writes the key `tool_offset`, the sample `tool_offsets`.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn get_tool_offsets(
        &mut self,
    ) -> Result<::jaka_proto::messages::frames::GetToolOffsetsReply, Error> {}
    /// Sets the offset and the name of one user frame.
    ///
    /// Which frame the robot moves in is selected by `set_user_id`.
    ///
    /// Sends `set_user_offsets` (4.31).
    ///
    /// # Errata
    ///
    /// - The key is spelled `userffset` in sample and text, without the o, and controllers expect it so.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn set_user_offsets(
        &mut self,
        request: &::jaka_proto::messages::frames::SetUserOffsets,
    ) -> Result<(), Error> {}
    /// Selects the user frame in which the robot moves.
    ///
    /// Id 0 selects the robot's base frame.
    ///
    /// Sends `set_user_id` (4.32).
    ///
    /// # Errata
    ///
    /// - The text calls the key `set_user_id`. The sample has `user_frame_id`, and controllers expect it so.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn set_user_id(&mut self, user_frame_id: i64) -> Result<(), Error> {}
    /// Reads the offsets of all user frames.
    ///
    /// Sends `get_user_offsets` (4.33). Changes nothing on the robot.
    ///
    /// # Errata
    ///
    /// - The text is copied from 4.30: it writes the key `tool_offset` and speaks of tool frames.
    /// - In the sample, frame 1 repeats its positions as angles, down to -439 degrees. It is no measured frame.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn get_user_offsets(
        &mut self,
    ) -> Result<::jaka_proto::messages::frames::GetUserOffsetsReply, Error> {}
    /// Reads all user-defined system variables.
    ///
    /// Sends `query_user_defined_variable` (4.38). Changes nothing on the robot.
    ///
    /// # Errata
    ///
    /// - The text explains a variable named `system_var1` with the value 12.0. The sample has `test` with the value 1.0.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn query_user_defined_variable(
        &mut self,
    ) -> Result<
        ::jaka_proto::messages::variables::QueryUserDefinedVariableReply,
        Error,
    > {}
    /// Sets the name and the value of a user-defined system variable.
    ///
    /// The request carries both: to change the value alone, send the present name along.
    ///
    /// Sends `modify_user_defined_variable` (4.39).
    ///
    /// # Errata
    ///
    /// - The key `id_new` is no new id. It names the variable to change.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn modify_user_defined_variable(
        &mut self,
        request: &::jaka_proto::messages::variables::ModifyUserDefinedVariable,
    ) -> Result<(), Error> {}
    /// Sets the mass and the centroid of the payload.
    ///
    /// Sends `set_payload` (4.42).
    ///
    /// # Errata
    ///
    /// - The document's reply prints the `cmdName` with blanks around it, ` set_payload `.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn set_payload(
        &mut self,
        request: &::jaka_proto::messages::payload::SetPayload,
    ) -> Result<(), Error> {}
    /// Reads the mass and the centroid of the payload.
    ///
    /// Sends `get_payload` (4.43). Changes nothing on the robot.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn get_payload(
        &mut self,
    ) -> Result<::jaka_proto::messages::payload::GetPayloadReply, Error> {}
    /// Reads whether the robot is in a protective stop.
    ///
    /// A protective stop usually follows a collision.
    ///
    /// Sends `protective_stop_status` (4.40). Changes nothing on the robot.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn protective_stop_status(
        &mut self,
    ) -> Result<::jaka_proto::messages::collision::ProtectiveStopStatusReply, Error> {}
    /// Sets the collision level, which says how hard a contact must be for the arm to stop.
    ///
    /// Level 0 switches collision detection off.
    ///
    /// Sends `set_clsn_sensitivity` (4.44).
    ///
    /// # Errata
    ///
    /// - The key is `sensitivityVal` here and `sensitivityLevel` in the reply of `get_clsn_sensitivity`.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn set_clsn_sensitivity(&mut self, level: i64) -> Result<(), Error> {}
    /// Reads the collision level.
    ///
    /// Sends `get_clsn_sensitivity` (4.45). Changes nothing on the robot.
    ///
    /// # Errata
    ///
    /// - The key is `sensitivityLevel` here and `sensitivityVal` in the request of `set_clsn_sensitivity`.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn get_clsn_sensitivity(
        &mut self,
    ) -> Result<::jaka_proto::messages::collision::GetClsnSensitivityReply, Error> {}
    /// Leaves the collision protection that the robot enters after a collision.
    ///
    /// Make sure first that nobody and nothing is in contact with the arm.
    ///
    /// Sends `clear_error` (4.48).
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn clear_error(&mut self) -> Result<(), Error> {}
    /// Computes the pose of the robot's end at a joint position (forward kinematics).
    ///
    /// The pose refers to the current tool frame, mounting and user frame (vendor's manual).
    ///
    /// Sends `kine_forward` (4.46). Changes nothing on the robot.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn kine_forward(
        &mut self,
        joint_position: impl Into<::jaka_proto::messages::types::JointPosition>,
    ) -> Result<::jaka_proto::messages::kinematics::KineForwardReply, Error> {}
    /// Computes a joint position at which the robot's end has a pose (inverse kinematics).
    ///
    /// Where there is no solution, the controller answers with error code 2. The pose refers to the current tool frame, mounting and user frame
    /// (vendor's manual).
    ///
    /// Sends `kine_inverse` (4.47). Changes nothing on the robot.
    ///
    /// # Errata
    ///
    /// - The document's reply prints `[x,y,z,rx,ry,rz]` in `jointPosition`; its text says that these are joint angles.
    /// - The document's text calls the pose `[x, y, z, a, b, c]`, its sample `[x, y, z, rx, ry, rz]`.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn kine_inverse(
        &mut self,
        request: &::jaka_proto::messages::kinematics::KineInverse,
    ) -> Result<::jaka_proto::messages::kinematics::KineInverseReply, Error> {}
    /// Reads the positions of the six joints.
    ///
    /// They may be commanded ones: on firmware 1.5.14 they differ from the actual ones of port 10000 by up to 0.023 degrees.
    ///
    /// Sends `get_joint_pos` (4.49). Changes nothing on the robot.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn get_joint_pos(
        &mut self,
    ) -> Result<::jaka_proto::messages::kinematics::GetJointPosReply, Error> {}
    /// Reads the pose of the robot's end, which the selected tool frame defines.
    ///
    /// By default that is the centre of the flange. The document does not say which user frame the pose refers to. It may be the commanded
    /// pose: see `get_joint_pos`.
    ///
    /// Sends `get_tcp_pos` (4.50). Changes nothing on the robot.
    ///
    /// # Errata
    ///
    /// - The heading says present coordinate frame, the text present tool frame; neither mentions the user frame.
    /// - The document calls the pose `[x, y, z, a, b, c]` and gives no unit here; 4.47 gives millimetres and degrees.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn get_tcp_pos(
        &mut self,
    ) -> Result<::jaka_proto::messages::kinematics::GetTcpPosReply, Error> {}
    /// Reads the Denavit-Hartenberg (DH) parameters of the robot.
    ///
    /// The document prints the four keys and zeros, and explains nothing: the units are those of the field notes, and no source says which of
    /// the conventions for DH parameters is meant.
    ///
    /// Sends `get_dh_param` (4.82). Changes nothing on the robot.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn get_dh_param(
        &mut self,
    ) -> Result<::jaka_proto::messages::kinematics::GetDhParamReply, Error> {}
    /// Sets how finely a trajectory is recorded, and how fast it is run later.
    ///
    /// Sends `set_traj_config` (4.52).
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn set_traj_config(
        &mut self,
        request: &::jaka_proto::messages::trajectory::SetTrajConfig,
    ) -> Result<(), Error> {}
    /// Reads how finely a trajectory is recorded, and how fast it is run later.
    ///
    /// Sends `get_traj_config` (4.53). Changes nothing on the robot.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn get_traj_config(
        &mut self,
    ) -> Result<::jaka_proto::messages::trajectory::GetTrajConfigReply, Error> {}
    /// Starts or stops the recording of a trajectory to a file.
    ///
    /// Sends `set_traj_sample_mode` (4.54).
    ///
    /// # Errata
    ///
    /// - The key is `filename` here and `fileName` in 4.58 and 4.59.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn set_traj_sample_mode(
        &mut self,
        request: &::jaka_proto::messages::trajectory::SetTrajSampleMode,
    ) -> Result<(), Error> {}
    /// Reads whether a trajectory is being recorded.
    ///
    /// Sends `get_traj_sample_status` (4.55). Changes nothing on the robot.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn get_traj_sample_status(
        &mut self,
    ) -> Result<::jaka_proto::messages::trajectory::GetTrajSampleStatusReply, Error> {}
    /// Reads the names of the trajectory files on the controller.
    ///
    /// Sends `get_exist_traj_file_name` (4.56). Changes nothing on the robot.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn get_exist_traj_file_name(
        &mut self,
    ) -> Result<::jaka_proto::messages::trajectory::GetExistTrajFileNameReply, Error> {}
    /// Renames a trajectory file.
    ///
    /// Sends `rename_traj_file_name` (4.57).
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn rename_traj_file_name(
        &mut self,
        request: &::jaka_proto::messages::trajectory::RenameTrajFileName,
    ) -> Result<(), Error> {}
    /// Deletes a trajectory file.
    ///
    /// Sends `remove_traj_file` (4.58).
    ///
    /// # Errata
    ///
    /// - The document's text calls the key `filename`; its sample sends `fileName`.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn remove_traj_file(
        &mut self,
        file_name: impl Into<String>,
    ) -> Result<(), Error> {}
    /// Writes a program for the controller from a trajectory file.
    ///
    /// The document does not say what the program is called.
    ///
    /// Sends `generate_traj_exe_file` (4.59).
    ///
    /// # Errata
    ///
    /// - The document's text calls the key `filename`; its sample sends `fileName`.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn generate_traj_exe_file(
        &mut self,
        file_name: impl Into<String>,
    ) -> Result<(), Error> {}
    /// Switches drag mode on or off.
    ///
    /// In drag mode the arm gives way to the hand and can be led. `drag_status` reads the mode back.
    ///
    /// Sends `torque_control_enable` (4.36). The robot must be powered and enabled.
    ///
    /// # Errors
    /// As [`call`](Self::call). In another state than the one it needs, expect a refusal.
    #[doc(alias = "torque_control_enable")]
    pub fn set_torque_control(
        &mut self,
        enable_flag: ::jaka_proto::messages::types::Switch,
    ) -> Result<(), Error> {}
    /// Reads whether the robot is in drag mode.
    ///
    /// Sends `drag_status` (4.37). Changes nothing on the robot.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn drag_status(
        &mut self,
    ) -> Result<::jaka_proto::messages::force::DragStatusReply, Error> {}
    /// Sets the brand of the torque sensor.
    ///
    /// Sends `set_torsenosr_brand` (4.61).
    ///
    /// # Errata
    ///
    /// - The wire spells the name `torsenosr`.
    /// - The document's text calls the key `sensor_band`; its sample sends `sensor_brand`.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    #[doc(alias = "set_torsenosr_brand")]
    pub fn set_torque_sensor_brand(
        &mut self,
        brand: ::jaka_proto::messages::force::TorqueSensorBrand,
    ) -> Result<(), Error> {}
    /// Reads the brand of the torque sensor.
    ///
    /// Sends `get_torsenosr_brand` (4.62). Changes nothing on the robot.
    ///
    /// # Errata
    ///
    /// - The wire spells the name `torsenosr`.
    /// - The document's text calls the key `sensor_band`; its sample answers `sensor_brand`.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    #[doc(alias = "get_torsenosr_brand")]
    pub fn get_torque_sensor_brand(
        &mut self,
    ) -> Result<::jaka_proto::messages::force::GetTorqueSensorBrandReply, Error> {}
    /// Sets the parameters of admittance control for one axis.
    ///
    /// For moving the arm by hand, the document wants the constant force and the normal tracking of all axes to be zero.
    ///
    /// Sends `set_admit_ctrl_config` (4.63).
    ///
    /// # Errata
    ///
    /// - The wire spells `ftNnormalTrack` with a double N.
    /// - The sample sends `ftReboundFK` last; the text, and the rows of 4.64, have it right behind `ftUser`.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn set_admit_ctrl_config(
        &mut self,
        request: &::jaka_proto::messages::force::SetAdmitCtrlConfig,
    ) -> Result<(), Error> {}
    /// Reads the parameters of admittance control for all axes.
    ///
    /// Sends `get_admit_ctrl_config` (4.64). Changes nothing on the robot.
    ///
    /// # Errata
    ///
    /// - The document's text describes six rows of five values; its sample has one more array around the six rows.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn get_admit_ctrl_config(
        &mut self,
    ) -> Result<::jaka_proto::messages::force::GetAdmitCtrlConfigReply, Error> {}
    /// Switches the torque sensor on or off.
    ///
    /// Sources contradict each other on which value is on, so the value is sent as given: the TCP documents say 0, all other texts 1, and no
    /// capture shows it. Try it with the arm clear of people.
    ///
    /// Sends `set_torque_sensor_mode` (4.65).
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn set_torque_sensor_mode(&mut self, mode: i64) -> Result<(), Error> {}
    /// Moves the arm to a joint position to identify the payload at the end of the tool.
    ///
    /// This is a motion, and the document does not say how fast it is. `get_torq_sensor_identify_status` says when the
    /// identification is done, and `get_torq_sensor_payload_identify_result` reads what was found.
    ///
    /// Sends `start_torq_sensor_payload_identify` (4.66). The robot must be powered, enabled and outside servo mode.
    ///
    /// # Errata
    ///
    /// - The document's text also spells the key `jointposition`; its sample sends `jointPosition`.
    ///
    /// # Errors
    /// As [`call`](Self::call). In another state than the one it needs, expect a refusal.
    pub fn start_torq_sensor_payload_identify(
        &mut self,
        joint_position: impl Into<::jaka_proto::messages::types::JointPosition>,
    ) -> Result<(), Error> {}
    /// Reads how far the identification of the payload is.
    ///
    /// Sends `get_torq_sensor_identify_staus` (4.67). Changes nothing on the robot.
    ///
    /// # Errata
    ///
    /// - The wire spells the name `staus`.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    #[doc(alias = "get_torq_sensor_identify_staus")]
    pub fn get_torq_sensor_identify_status(
        &mut self,
    ) -> Result<::jaka_proto::messages::force::GetTorqSensorIdentifyStatusReply, Error> {}
    /// Reads the payload that the identification found.
    ///
    /// Of use only once `get_torq_sensor_identify_status` says that the identification is done.
    ///
    /// Sends `get_torq_sensor_payload_identify_result` (4.68). Changes nothing on the robot.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn get_torq_sensor_payload_identify_result(
        &mut self,
    ) -> Result<
        ::jaka_proto::messages::force::GetTorqSensorPayloadIdentifyResultReply,
        Error,
    > {}
    /// Sets the mass and the centroid of the payload at the torque sensor.
    ///
    /// This is not the payload of the arm: that is `set_payload`.
    ///
    /// Sends `set_tool_payload` (4.69).
    ///
    /// # Errata
    ///
    /// - The document's worked example prints the `cmdName` `set_payload`, which is another command (4.42).
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn set_tool_payload(
        &mut self,
        request: &::jaka_proto::messages::force::SetToolPayload,
    ) -> Result<(), Error> {}
    /// Reads the mass and the centroid of the payload at the torque sensor.
    ///
    /// This is not the payload of the arm: that is `get_payload`.
    ///
    /// Sends `get_tool_payload` (4.70). Changes nothing on the robot.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn get_tool_payload(
        &mut self,
    ) -> Result<::jaka_proto::messages::force::GetToolPayloadReply, Error> {}
    /// Sets the forces and torques that are the condition for compliant control.
    ///
    /// The document does not say what happens when they are reached.
    ///
    /// Sends `set_compliance_condition` (4.71).
    ///
    /// # Errata
    ///
    /// - The heading speaks of a torque condition, the text of force components and torque components.
    /// - The text names only `fx` and `tx` of the six values, and prints no order and no unit.
    /// - The sample sends zeros, while the values are to be greater than 0 (vendor's manual).
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn set_compliance_condition(
        &mut self,
        request: &::jaka_proto::messages::force::SetComplianceCondition,
    ) -> Result<(), Error> {}
    /// Switches admittance control on or off.
    ///
    /// While it is on, the arm may move with the forces that its sensor reads. `set_admit_ctrl_config` sets the axes.
    ///
    /// Sends `enable_admittance_ctrl` (4.72).
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn enable_admittance_ctrl(
        &mut self,
        enable_flag: ::jaka_proto::messages::types::Switch,
    ) -> Result<(), Error> {}
    /// Reads the type of force control, and whether the sensor is compensated.
    ///
    /// Sends `get_compliant_type` (4.73). Changes nothing on the robot.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn get_compliant_type(
        &mut self,
    ) -> Result<::jaka_proto::messages::force::GetCompliantTypeReply, Error> {}
    /// Sets the type of force control, and whether the sensor is compensated.
    ///
    /// Sends `set_compliant_type` (4.74).
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn set_compliant_type(
        &mut self,
        request: &::jaka_proto::messages::force::SetCompliantType,
    ) -> Result<(), Error> {}
    /// Sets how the controller reaches the torque sensor.
    ///
    /// The document does not say what to send as address and port for RS485.
    ///
    /// Sends `set_torque_sensor_comm` (4.76).
    ///
    /// # Errata
    ///
    /// - The document's heading speaks of the IP address alone; the command sets the type and the port too.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn set_torque_sensor_comm(
        &mut self,
        request: &::jaka_proto::messages::force::SetTorqueSensorComm,
    ) -> Result<(), Error> {}
    /// Reads how the controller reaches the torque sensor.
    ///
    /// Sends `get_torque_sensor_comm` (4.77). Changes nothing on the robot.
    ///
    /// # Errata
    ///
    /// - The document's heading speaks of the IP address alone; the reply holds the type and the port too.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn get_torque_sensor_comm(
        &mut self,
    ) -> Result<::jaka_proto::messages::force::GetTorqueSensorCommReply, Error> {}
    /// Switches force control off.
    ///
    /// The document's heading calls it torque control. It does not say whether drag mode ends too.
    ///
    /// Sends `disable_force_control` (4.78).
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn disable_force_control(&mut self) -> Result<(), Error> {}
    /// Sets the parameters of compliance in velocity.
    ///
    /// Sends `set_vel_compliant_ctrl` (4.79).
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn set_vel_compliant_ctrl(
        &mut self,
        compliance: ::jaka_proto::messages::force::VelocityCompliance,
    ) -> Result<(), Error> {}
    /// Sets what the arm does when the network fails, and how long after the failure.
    ///
    /// The document does not say what counts as a failure, or whether the setting outlives the connection.
    ///
    /// Sends `set_network_exception_handle` (4.75).
    ///
    /// # Errata
    ///
    /// - The document's text calls the key `millisecond`; its sample sends `timeLimit`.
    /// - The document's text calls the key `mnt`; its sample sends `motType`.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn set_network_exception_handle(
        &mut self,
        request: &::jaka_proto::messages::network::SetNetworkExceptionHandle,
    ) -> Result<(), Error> {}
    /// Ends the connection.
    ///
    /// The controller answers as usual, and the client closes the connection then. Closing it without this command leaves power
    /// and enabling as they are.
    ///
    /// Sends `quit` (4.11).
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn quit(&mut self) -> Result<(), Error> {}
}
