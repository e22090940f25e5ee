//! Commands beyond the document: newer firmware answers them, and firmware 1.5.14 refuses them but for one.

use jaka_sync::beyond_io::{GetAnalogOutput, GetDigitalOutput};
use jaka_sync::io::{AnalogOutputKind, DigitalOutputKind, SetAnalogOutput, SetDigitalOutput};
use jaka_sync::proto::{Command, ErrorCode, Request, Visit};
use jaka_sync::types::Switch;
use jaka_sync::{Client, Error};
use jaka_tests::{LONG, spec};

use super::arm::{Arm, assert_close, refused, turn};

pub(crate) const COVERED: &[&str] = &[
    "get_data",
    "get_motion_state",
    "emergency_stop_status",
    "get_drag_status",
    "get_rapid_rate",
    "get_curr_tool_id",
    "get_curr_user_id",
    "get_actual_joint_pos",
    "get_actual_tcp_pos",
    "get_digital_output",
    "get_digital_input",
    "get_analog_output",
    "send_tio_rs_command",
    "get_tio_pin_mode",
    "set_tio_pin_mode",
    "get_rs485_chn_mode",
    "set_rs485_chn_mode",
    "get_rs485_chn_comm",
    "set_rs485_chn_comm",
    "get_rs485_signal_list",
    "get_tio_signals",
    "add_tio_rs_signal",
    "del_tio_rs_signal",
    "torque_feedforward",
    "set_motion_planner",
    "set_motion_limit_warning_range",
    "get_motion_limit_warning_range",
    "set_installation_angle",
    "set_port10000_delay_ms",
    "get_port10000_delay_ms",
    "setOptionalInfoConfig",
    "getOptionalInfoConfig",
];

/// An arm whose controller has this firmware.
fn arm_of(version: &str) -> Arm {
    let arm = Arm::ready();
    arm.controller.set_state(|state| version.clone_into(&mut state.version));
    arm
}

/// Sends the request of each example, and gives what became of it.
fn send_examples(version: &str, mut check: impl FnMut(&str, Result<(), Error>)) {
    struct Call<'c>(&'c mut Client);
    impl Visit for Call<'_> {
        type Output = Result<(), Error>;

        fn visit<C: Command>(self, command: &C) -> Self::Output {
            self.0.call(command).map(drop)
        }
    }
    let mut arm = arm_of(version);
    for name in COVERED {
        for example in &spec().command(name).expect("the spec has it").examples {
            let request = example.request.as_ref().map(|text| Request::read(text).expect("it fits"));
            check(name, request.expect("each is of a request").visit(Call(&mut arm.client)));
        }
    }
}

#[test]
fn newer_firmware_answers_them() {
    send_examples("1.7.2", |name, outcome| outcome.unwrap_or_else(|error| panic!("{name}: {error}")));
}

#[test]
fn firmware_1_5_14_does_not_know_them() {
    send_examples("1.5.14_13_X64", |name, outcome| match outcome {
        Ok(()) => assert!(["get_data", "torque_feedforward"].contains(&name), "{name}"),
        Err(error) => {
            let refusal = error.refusal().unwrap_or_else(|| panic!("{name}: {error}"));
            assert_eq!((refusal.code, &*refusal.message), (ErrorCode::EXCEPTION, "Exception:function call failed"));
        }
    });
}

#[test]
fn the_whole_status_comes_on_the_command_port() {
    let mut arm = arm_of("1.5.14_13_X64");
    let (whole, mut packet) = (arm.client.get_data().expect("it answers"), arm.status());
    // The length is that of a packet.
    packet.length = whole.length;
    assert_eq!(whole, packet);
}

#[test]
fn positions_and_frames_are_those_of_the_arm() {
    let mut arm = arm_of("1.7.2");
    arm.client.joint_move(&turn(30.0)).expect("the arm is enabled");
    arm.wait(1);
    assert_close(arm.client.get_actual_joint_pos().expect("it answers").joint_position.0, arm.joints(), 1e-4);
    assert_close(arm.client.get_actual_tcp_pos().expect("it answers").pose, arm.pose(), 1e-4);
    arm.client.set_tool_id(2).expect("there is such a frame");
    arm.client.set_user_id(1).expect("there is such a frame");
    assert_eq!(arm.client.get_curr_tool_id().expect("it answers").id, 2);
    assert_eq!(arm.client.get_curr_user_id().expect("it answers").id, 1);
}

#[test]
fn stops_and_motions_are_those_of_the_arm() {
    let mut arm = arm_of("1.7.2");
    let state = arm.client.get_motion_state().expect("it answers");
    assert_eq!((state.in_position, state.paused, state.queue), (true, false, 0));
    arm.client.joint_move(&turn(30.0)).expect("the arm is enabled");
    arm.client.joint_move(&turn(-30.0)).expect("the arm is enabled");
    arm.wait(1);
    assert!(!arm.client.get_motion_state().expect("it answers").in_position);
    arm.controller.set_state(|state| state.emergency_stop = true);
    assert!(arm.client.emergency_stop_status().expect("it answers").emergency_stop);
}

#[test]
fn outputs_are_those_that_were_set() {
    let mut arm = arm_of("1.7.2");
    arm.client.set_digital_output(&SetDigitalOutput::tool(1, Switch::On)).expect("it answers");
    arm.client.set_analog_output(&SetAnalogOutput::cabinet(3, 4.32)).expect("it answers");
    let mut digital = |kind| arm.client.get_digital_output(&GetDigitalOutput::new(kind, 1)).expect("it answers").value;
    assert_eq!([DigitalOutputKind::Tool, DigitalOutputKind::Cabinet].map(&mut digital), [true, false]);
    let analog = GetAnalogOutput::new(AnalogOutputKind::Cabinet, 3);
    assert_eq!(arm.client.get_analog_output(&analog).expect("it answers").value.to_bits(), 4.32_f64.to_bits());
}

#[test]
fn what_the_spec_forbids_is_not_sent() {
    let mut arm = arm_of("1.7.2");
    assert!(arm.client.set_motion_limit_warning_range(6).is_err());
    let beyond = r#"{"cmdName":"set_motion_limit_warning_range","range_level":6}"#;
    refused(arm.client.call_text(beyond, LONG));
}
