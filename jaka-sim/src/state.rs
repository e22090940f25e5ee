//! State of the simulated controller.

mod initial;
mod parts;

use std::collections::{BTreeMap, HashMap};

use jaka_proto::ControllerEvent;
use jaka_proto::messages::io::{AnalogOutputKind, DigitalOutputKind, ExtioStatus, FunctionInput};
use jaka_proto::messages::kinematics::GetDhParamReply;
use jaka_proto::messages::payload::GetPayloadReply;
use jaka_proto::messages::program::ProgramState;
use jaka_proto::messages::servo::SetServoMoveFilter;
use jaka_proto::messages::types::{JointPosition, Pose};
use jaka_proto::messages::variables::UserVariable;
use jaka_spec::Requirement;
use serde_json::{Map, Value};

pub use parts::{AdmittanceControl, Frame, TorqueSensor, Trajectory};

/// Number of frames of a kind in a controller: the fixed one and ten that can be set.
pub(crate) const FRAMES: usize = 11;

/// Error code for no error.
pub(crate) const NO_ERROR: &str = "0x0";

/// Event of a collision, in the vendor's table of controller events.
const COLLISION: u32 = 0x0f_0034;

/// State of the robot and its controller.
///
/// Commands change it; replies and status packets show it. [`Controller::state`](crate::Controller::state) returns a
/// copy, and [`Controller::set_state`](crate::Controller::set_state) changes it beyond the effect of any command. The
/// initial state is that of the document's example replies, which define the meaning of the values.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
#[expect(clippy::struct_excessive_bools, reason = "each is a fact of its own")]
pub struct State {
    /// Whether the arm has power.
    pub powered: bool,
    /// Whether the arm is enabled. Never without power.
    pub enabled: bool,
    /// Whether the robot is in a protective stop.
    pub protective_stop: bool,
    /// Whether the robot is in an emergency stop, in which the arm is not enabled.
    pub emergency_stop: bool,
    /// State of the soft limits: 1 if one is reached. Only status packets show it, and the simulator never sets it.
    pub on_soft_limit: i64,
    /// Error code of the controller, a hexadecimal number such as `0x0`.
    pub error_code: String,
    /// Error message of the controller; empty without an error.
    pub error_message: String,
    /// Version of the controller's software.
    pub version: String,

    /// Actual positions of the six joints, in degrees.
    pub joint_position: JointPosition,
    /// Pose of the tool frame in use, relative to the user frame in use. Follows from the joints and the frames.
    pub tcp_pose: Pose,
    /// Speed of the tool centre point, in mm/s. Follows from the motion.
    pub tcp_speed: f64,
    /// Whether the robot is in position. Follows from the motion.
    pub in_position: bool,
    /// Whether the arm is at rest: it does not move, and no program runs. Follows from the motion at once, unlike
    /// `in_position`.
    pub at_rest: bool,
    /// Commanded positions of the six joints, in degrees: ahead of `joint_position` by
    /// [`Builder::lag`](crate::Builder::lag) and [`Habit::Lead`](crate::Habit::Lead), and equal without them. Follows
    /// from the motion.
    pub joint_commanded_position: JointPosition,
    /// Commanded pose, which belongs to `joint_commanded_position`.
    pub tcp_commanded_pose: Pose,
    /// Whether the robot is in servo mode, which requires that it is enabled and not in a protective stop.
    pub servo_mode: bool,
    /// Filter of servo mode, as last set. It applies from the next entry into servo mode.
    pub servo_filter: SetServoMoveFilter,
    /// Whether the arm is in drag mode, which requires that it is enabled.
    pub drag_mode: bool,
    /// Denavit-Hartenberg parameters in the replies of the robot.
    pub dh_parameters: GetDhParamReply,

    /// Scale of motion speeds, from 0 to 1.
    pub rapid_rate: f64,
    /// File name of the loaded program.
    pub loaded_program: String,
    /// State of the program.
    pub program_state: ProgramState,

    /// All digital inputs.
    pub digital_inputs: Vec<bool>,
    /// Digital outputs set so far, by place and index as sent; all others are off.
    pub digital_outputs: HashMap<(DigitalOutputKind, i64), bool>,
    /// All analog inputs of the cabinet.
    pub analog_inputs: Vec<f64>,
    /// Analog outputs set so far, by place and index as sent; all others are 0.
    pub analog_outputs: HashMap<(AnalogOutputKind, i64), f64>,
    /// All digital inputs of the tool.
    pub tool_digital_inputs: Vec<bool>,
    /// All analog inputs of the tool.
    pub tool_analog_inputs: Vec<f64>,
    /// Input of each function.
    pub function_inputs: Vec<FunctionInput>,
    /// Extension I/O modules and their state.
    pub extio: ExtioStatus,

    /// Tool frames, by id.
    pub tool_frames: [Frame; FRAMES],
    /// Id of the tool frame in use.
    pub tool_frame_id: i64,
    /// User frames, by id.
    pub user_frames: [Frame; FRAMES],
    /// Id of the user frame in use.
    pub user_frame_id: i64,

    /// User-defined system variables.
    pub variables: Vec<UserVariable>,
    /// Payload of the arm.
    pub payload: GetPayloadReply,
    /// Collision level, from 0 to 7; 0 is off. The document has levels up to 5; one client has levels up to 7 on newer
    /// firmware.
    pub collision_level: i64,
    /// Trajectory recording.
    pub trajectory: Trajectory,
    /// Torque sensor at the end of the arm.
    pub torque_sensor: TorqueSensor,
    /// Force-compliant control.
    pub admittance: AdmittanceControl,
    /// Fields of each setting as last set, by its `cmdName` and then by name in Rust: of the spec and of packs. Queries
    /// for which these say `remembers` return them, and some settings show nowhere else, such as the reaction to a
    /// failure of the network.
    pub remembered: BTreeMap<String, Map<String, Value>>,
}

impl State {
    /// Whether the state meets the requirement of a command.
    pub fn meets(&self, requirement: Requirement) -> bool {
        match requirement {
            Requirement::Powered => self.powered,
            Requirement::Enabled => self.enabled,
            Requirement::ServoMode => self.servo_mode,
            Requirement::NotServoMode => !self.servo_mode,
        }
    }

    /// Whether the arm can move.
    pub(crate) fn can_move(&self) -> bool {
        self.enabled && !self.protective_stop && !self.emergency_stop
    }

    /// Applies a collision: a protective stop, shown in the error code.
    pub(crate) fn collide(&mut self) {
        self.protective_stop = true;
        self.report(COLLISION);
    }

    /// Writes an event into the error code.
    pub(crate) fn report(&mut self, code: u32) {
        self.error_code = format!("{code:#x}");
        let meaning = ControllerEvent::new(code).and_then(ControllerEvent::meaning);
        meaning.unwrap_or_default().clone_into(&mut self.error_message);
    }

    /// Clears the error, if there is one.
    pub(crate) fn clear_error(&mut self) {
        NO_ERROR.clone_into(&mut self.error_code);
        self.error_message.clear();
    }

    /// Switches off modes that the state excludes. Called after each change.
    pub(crate) fn make_consistent(&mut self) {
        self.enabled &= self.powered && !self.emergency_stop;
        self.servo_mode &= self.enabled && !self.protective_stop;
        self.drag_mode &= self.enabled;
    }
}
