//! Commands beyond the document: newer firmware answers them, and firmware 1.5.14 refuses them but for one.

use jaka_spec::{Version, Versions};
use jaka_sync::beyond_io::{GetAnalogOutput, GetDigitalOutput};
use jaka_sync::io::{AnalogOutputKind, DigitalOutputKind, SetAnalogOutput, SetDigitalOutput};
use jaka_sync::proto::wire::Typed;
use jaka_sync::proto::{Command, ErrorCode, Request, Visit};
use jaka_sync::types::Switch;
use jaka_sync::{Client, Error};
use jaka_tests::{LONG, spec};

use super::arm::{Arm, assert_close, refused, turn};

/// The commands that the document does not have, in the order of the spec: one that is added is tested here.
fn commands() -> Vec<jaka_spec::Command> {
    spec().commands().filter(|command| !command.evidence.is_empty()).cloned().collect()
}

/// An arm whose controller has this firmware.
fn arm_of(version: &str) -> Arm {
    let arm = Arm::ready();
    arm.controller.set_state(|state| version.clone_into(&mut state.version));
    arm
}

/// Sends the requests of the command's examples to firmware of this version, and returns their outcomes.
fn send_examples(version: &str, command: &jaka_spec::Command) -> Vec<Result<(), Error>> {
    struct Call<'c>(&'c mut Client);
    impl Visit for Call<'_> {
        type Output = Result<(), Error>;

        fn visit<C: Command>(self, command: &C) -> Self::Output {
            self.0.call(command).map(drop)
        }
    }
    let mut arm = arm_of(version);
    let requests = command.examples.iter().filter_map(|example| example.request.as_ref());
    let requests: Vec<_> = requests.map(|text| Request::read(text).expect("the example fits")).collect();
    assert!(!requests.is_empty(), "{}: no example has a request", command.wire);
    requests.iter().map(|request| request.visit(Call(&mut arm.client))).collect()
}

#[test]
fn the_first_and_the_last_firmware_that_has_them_answers_them() {
    let commands = commands();
    assert!(commands.len() > 30, "{}", commands.len());
    for command in &commands {
        let Versions { since, until } = &command.versions;
        let bounds = [since, until].map(|version| version.as_ref().map(ToString::to_string));
        for version in bounds.into_iter().flatten().chain(["1.7.2".to_owned()].into_iter().filter(|_| until.is_none()))
        {
            for outcome in send_examples(&version, command) {
                outcome.unwrap_or_else(|error| panic!("{}, firmware {version}: {error}", command.wire));
            }
        }
    }
}

/// The spec says by `since` of which commands firmware 1.5.14 is taken to lack.
#[test]
fn firmware_1_5_14_does_not_know_those_since_a_later_one() {
    let is_later = |version: &Version| version.numbers() > &[1, 5, 14][..];
    for command in commands() {
        let is_known = !command.versions.since.as_ref().is_some_and(is_later);
        for outcome in send_examples("1.5.14_13_X64", &command) {
            let Err(error) = outcome else {
                assert!(is_known, "{} is answered", command.wire);
                continue;
            };
            let refusal = error.refusal().unwrap_or_else(|| panic!("{}: {error}", command.wire));
            let unknown = (ErrorCode::EXCEPTION, "Exception:function call failed");
            assert_eq!((is_known, refusal.code, &*refusal.message), (false, unknown.0, unknown.1), "{}", command.wire);
        }
    }
}

/// A client's program for such old firmware sends the one, and 1.5.14 answers the other.
#[test]
fn two_of_them_are_older() {
    for name in ["get_data", "torque_feedforward"] {
        let command = spec().command(name).cloned().expect("the spec has it");
        assert!(send_examples("1.5.14_13_X64", &command).iter().all(Result::is_ok), "{name}");
    }
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
fn limits_drag_mode_and_the_rate_are_those_of_the_arm() {
    let mut arm = arm_of("1.7.2");
    let known = |arm: &mut Arm| {
        let limit = arm.client.is_on_limit().expect("it answers").on_limit;
        let drag = arm.client.get_drag_status().expect("it answers").drag_mode;
        (limit, drag, arm.client.get_rapid_rate().expect("it answers").rapid_rate)
    };
    assert_eq!(known(&mut arm), (Typed::Known(false), Typed::Known(false), Typed::Known(1.0)));
    arm.controller.set_state(|state| {
        (state.on_soft_limit, state.drag_mode, state.rapid_rate) = (1, true, 0.5);
    });
    assert_eq!(known(&mut arm), (Typed::Known(true), Typed::Known(true), Typed::Known(0.5)));
}

#[test]
fn stops_and_motions_are_those_of_the_arm() {
    let mut arm = arm_of("1.7.2");
    let state = arm.client.get_motion_state().expect("it answers");
    assert_eq!((state.in_position, state.paused, state.queue), (true, Some(false), 0));
    arm.client.joint_move(&turn(30.0)).expect("the arm is enabled");
    arm.client.joint_move(&turn(-30.0)).expect("the arm is enabled");
    arm.wait(1);
    let state = arm.client.get_motion_state().expect("it answers");
    assert_eq!((state.in_position, state.queue), (false, 1));
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
