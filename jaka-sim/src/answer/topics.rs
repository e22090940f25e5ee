//! Effect and reply of each command, by topic.

use jaka_proto::Request;
use jaka_proto::messages::force::{AdmittanceAxis, ComplianceType, IdentifyStatus, SetAdmitCtrlConfig};
use jaka_proto::messages::program::ProgramState;
use jaka_proto::messages::types::{JointPosition, Pose};
use jaka_proto::wire::Typed;

use super::{Draft, Outcome, is_on, motion, reply, servo, trajectory};
use crate::motion::can_follow;
use crate::state::{FRAMES, Frame};
use crate::world::{Change, World};

/// Limit of output indices, so that clients cannot grow the state without bound.
const MAX_OUTPUTS: i64 = 1024;

/// Carries out a request. Writes the reply if the handler sets a field of it.
#[expect(clippy::too_many_lines, reason = "an arm for each command")]
pub(super) fn answer(request: &Request, world: &mut World, out: &mut Draft<'_>) -> Outcome {
    let state = &mut world.state;
    match request {
        // Power, enabling and the controller's state.
        Request::PowerOn(command) => {
            if !state.powered {
                world.later(world.delays.power_on, Change::PoweredOn);
            }
            reply(command, out, |reply| reply.powered_on = Some(true))
        }
        Request::EnableRobot(command) => {
            if !state.enabled {
                world.later(world.delays.enable, Change::Enabled);
            }
            reply(command, out, |reply| reply.enabled = Some(true))
        }
        Request::PowerOff(_) | Request::Shutdown(_) => {
            world.cancel_changes(|_| true);
            set(&mut world.state.powered, false)
        }
        Request::DisableRobot(_) => {
            // Events 0x0F003A and 0x0F0027.
            if world.is_moving() && !world.habits.disable_moving || world.runner.is_some() {
                return Outcome::Refused;
            }
            world.cancel_changes(|change| change != Change::PoweredOn);
            set(&mut world.state.enabled, false)
        }
        Request::GetRobotState(command) => reply(command, out, |reply| {
            let event = world.writing.event(state);
            (reply.powered_on, reply.enabled) = (state.powered, state.enabled);
            reply.error_message = event.is_some().then(|| state.error_message.clone());
            reply.error_code = event;
        }),
        Request::GetVersion(command) => reply(command, out, |reply| reply.version.clone_from(&state.version)),

        // Jog and planned motion.
        Request::Jog(command) => Outcome::accepted_if(motion::start_jog(command, world)),
        Request::JointMove(_) | Request::EndMove(_) | Request::MoveL(_) | Request::MoveC(_) => {
            Outcome::accepted_if(world.start_motion(request))
        }

        // Servo mode.
        Request::IsInServomove(command) => reply(command, out, |reply| reply.in_servo_mode = state.servo_mode),
        Request::SetServoMode(command) => {
            let on = is_on(command.servo_mode);
            // Acknowledges the command without entering servo mode.
            if world.habits.servo_at_rest && world.is_moving() && on {
                return Outcome::Accepted;
            }
            world.cancel_changes(|change| matches!(change, Change::ServoMode(_)));
            world.later(world.delays.servo_mode, Change::ServoMode(on));
            Outcome::Accepted
        }
        Request::ServoJ(command) => servo::joint_set_point(command, world),
        Request::ServoP(command) => servo::pose_set_point(command, world),
        Request::SetServoMoveFilter(command) if !can_follow(command) => Outcome::Refused,
        Request::SetServoMoveFilter(command) => set(&mut state.servo_filter, *command),

        // Programs and the speed rate. Pause, resume and stop without a program have no effect.
        Request::GetLoadedProgram(command) => {
            reply(command, out, |reply| reply.program_name.clone_from(&state.loaded_program))
        }
        Request::GetProgramState(command) => {
            reply(command, out, |reply| reply.program_state.clone_from(&state.program_state))
        }
        Request::GetMotionState(command) => reply(command, out, |reply| {
            reply.in_position = world.state.in_position;
            reply.paused = Some(world.state.program_state == ProgramState::Paused);
            reply.queue = i64::try_from(world.motions_waiting()).unwrap_or(i64::MAX);
            // Same values as in packets. The vendor's library reads these keys.
            (reply.motion_line, reply.error_add_line) = (Some(0.into()), Some(0.into()));
            reply.queue_full = Some(false);
        }),
        Request::GetRapidRate(command) => {
            reply(command, out, |reply| reply.rapid_rate = Typed::Known(state.rapid_rate))
        }
        Request::SetRapidRate(command) => set(&mut state.rapid_rate, command.rate),
        Request::LoadProgram(command) => {
            let is_there = world.programs.contains_key(&command.program_name);
            if is_there {
                state.loaded_program.clone_from(&command.program_name);
            }
            Outcome::accepted_if(is_there)
        }
        Request::PlayProgram(_) => match world.programs.get(&state.loaded_program) {
            Some(program) if world.runner.is_none() => {
                world.runner = Some(program.clone().into_iter());
                set(&mut state.program_state, ProgramState::Running)
            }
            _ => Outcome::Refused,
        },
        Request::PauseProgram(_) => replace(&mut state.program_state, &ProgramState::Running, ProgramState::Paused),
        Request::ResumeProgram(_) => replace(&mut state.program_state, &ProgramState::Paused, ProgramState::Running),
        Request::StopProgram(_) => {
            world.end_program();
            world.stop();
            Outcome::Accepted
        }

        // Inputs and outputs.
        Request::SetDigitalOutput(command) if command.index < MAX_OUTPUTS => {
            state.digital_outputs.insert((command.kind, command.index), is_on(command.value));
            Outcome::Accepted
        }
        Request::SetAnalogOutput(command) if command.index < MAX_OUTPUTS => {
            state.analog_outputs.insert((command.kind, command.index), command.value);
            Outcome::Accepted
        }
        Request::SetDigitalOutput(_) | Request::SetAnalogOutput(_) => Outcome::Refused,
        Request::GetDigitalInputStatus(command) => {
            reply(command, out, |reply| reply.digital_inputs.clone_from(&state.digital_inputs))
        }
        Request::GetFuncdiStatus(command) => {
            reply(command, out, |reply| reply.function_inputs.clone_from(&state.function_inputs))
        }
        Request::GetExtioStatus(command) => reply(command, out, |reply| reply.extio_status.clone_from(&state.extio)),
        Request::GetDigitalOutput(command) => reply(command, out, |reply| {
            reply.value = state.digital_outputs.get(&(command.kind, command.index)).copied().unwrap_or_default();
        }),
        Request::GetAnalogOutput(command) => reply(command, out, |reply| {
            reply.value = state.analog_outputs.get(&(command.kind, command.index)).copied().unwrap_or_default();
        }),

        // Tool frames and user frames.
        Request::GetToolOffsets(command) => reply(command, out, |reply| reply.offsets = offsets(&state.tool_frames)),
        Request::GetUserOffsets(command) => reply(command, out, |reply| reply.offsets = offsets(&state.user_frames)),
        Request::SetToolOffsets(command) => {
            set_frame(&mut state.tool_frames, command.id, command.offset, &command.name)
        }
        Request::SetUserOffsets(command) => {
            set_frame(&mut state.user_frames, command.id, command.offset, &command.name)
        }
        Request::SetToolId(command) => choose_frame(&mut state.tool_frame_id, command.tool_id),
        Request::SetUserId(command) => choose_frame(&mut state.user_frame_id, command.user_frame_id),
        Request::GetCurrToolId(command) => reply(command, out, |reply| reply.id = state.tool_frame_id),
        Request::GetCurrUserId(command) => reply(command, out, |reply| reply.id = state.user_frame_id),

        // User-defined system variables.
        Request::QueryUserDefinedVariable(command) => {
            reply(command, out, |reply| reply.variables.clone_from(&state.variables))
        }
        Request::ModifyUserDefinedVariable(command) => {
            let variable = state.variables.iter_mut().find(|variable| variable.id == command.id);
            let set = variable.map(|variable| {
                variable.alias.clone_from(&command.alias);
                variable.value = command.value;
            });
            Outcome::accepted_if(set.is_some())
        }

        // Payload of the arm.
        Request::SetPayload(command) => {
            (state.payload.mass, state.payload.centroid) = (command.mass, command.centroid);
            Outcome::Accepted
        }
        Request::GetPayload(command) => reply(command, out, |reply| *reply = state.payload),

        // Collision detection, protective stop and emergency stop.
        Request::ProtectiveStopStatus(command) => {
            reply(command, out, |reply| reply.protective_stop = state.protective_stop)
        }
        Request::EmergencyStopStatus(command) => {
            reply(command, out, |reply| reply.emergency_stop = state.emergency_stop)
        }
        // Levels of newer firmware.
        Request::SetClsnSensitivity(command) if !(0..=7).contains(&command.level) => Outcome::Refused,
        Request::SetClsnSensitivity(command) => set(&mut state.collision_level, command.level),
        Request::GetClsnSensitivity(command) => reply(command, out, |reply| reply.level = state.collision_level),
        Request::ClearError(_) => {
            state.clear_error();
            set(&mut state.protective_stop, false)
        }

        // Kinematics and present position. Poses are those of the selected tool frame in the selected user frame, so
        // that the computations and `get_tcp_pos` agree.
        Request::GetJointPos(command) => {
            let joints = world.noise.of(state.joint_commanded_position);
            reply(command, out, |reply| reply.joint_position = joints)
        }
        Request::GetTcpPos(command) => reply(command, out, |reply| reply.pose = state.tcp_commanded_pose),
        Request::GetActualJointPos(command) => {
            let joints = world.noise.of(state.joint_position);
            reply(command, out, |reply| reply.joint_position = joints)
        }
        Request::GetActualTcpPos(command) => reply(command, out, |reply| reply.pose = state.tcp_pose),
        Request::GetDhParam(command) => reply(command, out, |reply| *reply = state.dh_parameters),
        Request::KineForward(command) => reply(command, out, |reply| reply.pose = world.pose(command.joint_position.0)),
        Request::KineInverse(command) => {
            let flange = world.flange(command.pose);
            match world.model.inverse(flange, command.reference_joint_position) {
                Ok(joints) => reply(command, out, |reply| reply.joint_position = joints),
                Err(_) => Outcome::Refused,
            }
        }

        // Trajectory recording. Refuses files that do not exist.
        Request::SetTrajSampleMode(command) => Outcome::accepted_if(trajectory::sample(command, world)),
        Request::GetTrajSampleStatus(command) => {
            reply(command, out, |reply| reply.sampling = state.trajectory.sampling)
        }
        Request::GetExistTrajFileName(command) => {
            reply(command, out, |reply| reply.file_names.clone_from(&state.trajectory.file_names))
        }
        Request::RenameTrajFileName(command) => {
            Outcome::accepted_if(trajectory::rename(world, &command.source, &command.destination))
        }
        Request::RemoveTrajFile(command) => Outcome::accepted_if(trajectory::remove(world, &command.file_name)),
        Request::GenerateTrajExeFile(command) => Outcome::accepted_if(trajectory::generate(world, &command.file_name)),

        // Drag mode and force-compliant control.
        Request::GetDragStatus(command) => reply(command, out, |reply| reply.drag_mode = Typed::Known(state.drag_mode)),
        Request::IsOnLimit(command) => {
            reply(command, out, |reply| reply.on_limit = Typed::Known(state.on_soft_limit != 0))
        }
        Request::DragStatus(command) => reply(command, out, |reply| reply.drag_status = state.drag_mode),
        Request::SetTorqueControl(command) => set(&mut state.drag_mode, is_on(command.enable_flag)),
        Request::EnableAdmittanceCtrl(command) => set(&mut state.admittance.enabled, is_on(command.enable_flag)),
        // The document does not say whether drag mode also ends; here it does not.
        Request::DisableForceControl(_) => {
            (state.admittance.enabled, state.admittance.compliance_type) = (false, ComplianceType::Off);
            Outcome::Accepted
        }
        // One more level of nesting than in the document's text, as in its sample.
        Request::GetAdmitCtrlConfig(command) => {
            reply(command, out, |reply| reply.axes = Typed::Known(vec![state.admittance.axes.to_vec()]))
        }
        Request::SetAdmitCtrlConfig(command) => set_axis(&mut state.admittance.axes, command),
        Request::GetCompliantType(command) => reply(command, out, |reply| {
            reply.compliance_type = state.admittance.compliance_type;
            reply.sensor_compensation = state.admittance.sensor_compensation;
        }),
        Request::SetCompliantType(command) => {
            state.admittance.compliance_type = command.compliance_type;
            set(&mut state.admittance.sensor_compensation, is_on(command.sensor_compensation))
        }

        // Torque sensor and its payload.
        Request::StartTorqSensorPayloadIdentify(command) => identify(command.joint_position, world),
        Request::SetTorqueSensorComm(command) => {
            let sensor = &mut state.torque_sensor;
            sensor.address.clone_from(&command.address);
            (sensor.communication, sensor.port) = (command.communication, command.port);
            Outcome::Accepted
        }
        Request::GetTorqueSensorComm(command) => reply(command, out, |reply| {
            let sensor = &state.torque_sensor;
            reply.address.clone_from(&sensor.address);
            (reply.communication, reply.port) = (sensor.communication, sensor.port);
        }),
        Request::SetToolPayload(command) => {
            let payload = &mut state.torque_sensor.payload;
            (payload.mass, payload.centroid) = (command.mass, command.centroid);
            Outcome::Accepted
        }
        Request::GetToolPayload(command) => reply(command, out, |reply| *reply = state.torque_sensor.payload),
        Request::GetTorqSensorIdentifyStatus(command) => {
            reply(command, out, |reply| reply.status = state.torque_sensor.identify_status)
        }
        Request::GetTorqSensorPayloadIdentifyResult(command) => {
            reply(command, out, |reply| *reply = state.torque_sensor.identified)
        }
        _ => Outcome::Unhandled,
    }
}

fn set<T>(place: &mut T, value: T) -> Outcome {
    *place = value;
    Outcome::Accepted
}

fn replace(state: &mut ProgramState, from: &ProgramState, to: ProgramState) -> Outcome {
    if state == from {
        *state = to;
    }
    Outcome::Accepted
}

/// Selects the frame in use, if there is one with this id.
fn choose_frame(used: &mut i64, id: i64) -> Outcome {
    let exists = usize::try_from(id).is_ok_and(|id| id < FRAMES);
    *used = if exists { id } else { *used };
    Outcome::accepted_if(exists)
}

/// Sets a frame, if there is one with this id: the first frame is fixed.
fn set_frame(frames: &mut [Frame], id: i64, offset: Pose, name: &str) -> Outcome {
    let frame = usize::try_from(id).ok().filter(|id| *id > 0).and_then(|id| frames.get_mut(id));
    let set = frame.map(|frame| *frame = Frame { offset, name: name.to_owned() });
    Outcome::accepted_if(set.is_some())
}

fn offsets(frames: &[Frame]) -> Vec<Pose> {
    frames.iter().map(|frame| frame.offset).collect()
}

/// Sets the parameters of an axis. Unknown axes have been refused before.
fn set_axis(axes: &mut [AdmittanceAxis], command: &SetAdmitCtrlConfig) -> Outcome {
    let index = usize::try_from(i64::from(command.axis)).ok();
    if let Some(axis) = index.and_then(|index| axes.get_mut(index)) {
        axis.enabled = is_on(command.enabled);
        axis.user_force = command.user_force;
        axis.rebound = command.rebound;
        axis.constant_force = command.constant_force;
        axis.normal_track = command.normal_track;
    }
    Outcome::Accepted
}

/// Starts the motion that identifies the payload, which is that of `set_payload`.
fn identify(to: JointPosition, world: &mut World) -> Outcome {
    const SPEED: f64 = 30.0;
    const ACCELERATION: f64 = 60.0;
    let is_planned = world.enqueue(world.plan_joints(to.0, SPEED, ACCELERATION));
    if is_planned {
        world.identifying = true;
        world.state.torque_sensor.identify_status = IdentifyStatus::NotDone;
    }
    Outcome::accepted_if(is_planned)
}
