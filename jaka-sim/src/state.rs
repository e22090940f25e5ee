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

pub use parts::{AdmittanceControl, Frame, NetworkException, TorqueSensor, Trajectory};

/// Number of frames of a kind in a controller: the fixed one and ten that can be set.
pub(crate) const FRAMES: usize = 11;

/// The error code that says that there is none.
pub(crate) const NO_ERROR: &str = "0x0";

/// The event of a collision, in the vendor's table of controller events.
const COLLISION: u32 = 0x0f_0034;

/// State of the robot and its controller.
///
/// Commands change it, replies and status packets show it. [`Controller::state`](crate::Controller::state) takes a
/// copy, [`Controller::set_state`](crate::Controller::set_state) changes it as no command could. It begins as the
/// document's example replies have it; see there for what the values mean.
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
    /// Whether the robot is in an emergency stop. The arm is not enabled in one.
    pub emergency_stop: bool,
    /// State of the soft limits: 1 if one is reached. Status packets alone show it, and nothing here sets it.
    pub on_soft_limit: i64,
    /// Error code of the controller, a hexadecimal number such as `0x0`.
    pub error_code: String,
    /// Error message of the controller; empty where there is no error.
    pub error_message: String,
    /// Version of the controller's software.
    pub version: String,

    /// Positions of the six joints, in degrees: where the arm is.
    pub joint_position: JointPosition,
    /// Pose of the tool frame in use, seen from the user frame in use. Follows from the joints and the frames.
    pub tcp_pose: Pose,
    /// Speed of the tool centre point, in mm/s. Follows from the motion.
    pub tcp_speed: f64,
    /// Whether the robot is in position. Follows from the motion.
    pub in_position: bool,
    /// Whether the arm is at rest: it does not move, and nothing waits to move it. Follows from the motion, at once
    /// where `in_position` takes its time.
    pub at_rest: bool,
    /// Positions of the six joints as commanded, in degrees: ahead of `joint_position` by
    /// [`Builder::lag`](crate::Builder::lag) and [`Habit::Lead`](crate::Habit::Lead), and equal without. Follows from
    /// the motion.
    pub joint_commanded_position: JointPosition,
    /// Pose as commanded, which belongs to `joint_commanded_position`.
    pub tcp_commanded_pose: Pose,
    /// Whether the robot is in servo mode. Only where it is enabled and in no protective stop.
    pub servo_mode: bool,
    /// The filter of servo mode, as last set. It acts from when servo mode is entered.
    pub servo_filter: SetServoMoveFilter,
    /// Whether the arm is in drag mode. Only where it is enabled.
    pub drag_mode: bool,
    /// Denavit-Hartenberg parameters, as the robot answers them.
    pub dh_parameters: GetDhParamReply,

    /// Rate by which motions are scaled, from 0 to 1.
    pub rapid_rate: f64,
    /// File name of the program that is loaded.
    pub loaded_program: String,
    /// State of the program.
    pub program_state: ProgramState,

    /// All digital inputs.
    pub digital_inputs: Vec<bool>,
    /// Digital outputs that have been set, by place and index as sent; all others are off.
    pub digital_outputs: HashMap<(DigitalOutputKind, i64), bool>,
    /// All analog inputs of the cabinet.
    pub analog_inputs: Vec<f64>,
    /// Analog outputs that have been set, by place and index as sent; all others are 0.
    pub analog_outputs: HashMap<(AnalogOutputKind, i64), f64>,
    /// All digital inputs of the tool.
    pub tool_digital_inputs: Vec<bool>,
    /// All analog inputs of the tool.
    pub tool_analog_inputs: Vec<f64>,
    /// The input of each function.
    pub function_inputs: Vec<FunctionInput>,
    /// The extension I/O modules and their state.
    pub extio: ExtioStatus,

    /// The tool frames, by id.
    pub tool_frames: [Frame; FRAMES],
    /// Id of the tool frame in use.
    pub tool_frame_id: i64,
    /// The user frames, by id.
    pub user_frames: [Frame; FRAMES],
    /// Id of the user frame in use.
    pub user_frame_id: i64,

    /// User-defined system variables.
    pub variables: Vec<UserVariable>,
    /// Payload of the arm.
    pub payload: GetPayloadReply,
    /// Collision level, from 0 to 7; 0 is off. The document has levels up to 5, and one client has levels up to 7 on newer
    /// firmware.
    pub collision_level: i64,
    /// Reaction of the arm to a failure of the network, as last set.
    pub network_exception: NetworkException,
    /// Trajectory recording.
    pub trajectory: Trajectory,
    /// The torque sensor at the end of the arm.
    pub torque_sensor: TorqueSensor,
    /// Control that yields to forces.
    pub admittance: AdmittanceControl,
    /// Fields of replies that settings have set, by `cmdName` of the query and then by name in Rust: of the queries for
    /// which the spec, or a pack, says `remembers`.
    pub remembered: BTreeMap<String, Map<String, Value>>,
}

impl State {
    /// True where the state is as a command requires.
    pub fn meets(&self, requirement: Requirement) -> bool {
        match requirement {
            Requirement::Powered => self.powered,
            Requirement::Enabled => self.enabled,
            Requirement::ServoMode => self.servo_mode,
            Requirement::NotServoMode => !self.servo_mode,
        }
    }

    /// True where nothing keeps the arm from moving.
    pub(crate) fn can_move(&self) -> bool {
        self.enabled && !self.protective_stop && !self.emergency_stop
    }

    /// Collides: a protective stop, which the error code shows.
    pub(crate) fn collide(&mut self) {
        self.protective_stop = true;
        self.report(COLLISION);
    }

    /// Puts an event into the error code.
    pub(crate) fn report(&mut self, code: u32) {
        self.error_code = format!("{code:#x}");
        let meaning = ControllerEvent::new(code).and_then(ControllerEvent::meaning);
        meaning.unwrap_or_default().clone_into(&mut self.error_message);
    }

    /// Leaves the error, if there is one.
    pub(crate) fn clear_error(&mut self) {
        NO_ERROR.clone_into(&mut self.error_code);
        self.error_message.clear();
    }

    /// Switches off what cannot be on in this state. Follows each change.
    pub(crate) fn make_consistent(&mut self) {
        self.enabled &= self.powered && !self.emergency_stop;
        self.servo_mode &= self.enabled && !self.protective_stop;
        self.drag_mode &= self.enabled;
    }
}
