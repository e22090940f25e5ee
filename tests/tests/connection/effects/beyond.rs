//! Commands beyond the document: newer firmware answers them, and firmware 1.5.14 refuses them but for one.

use std::time::Duration;

use jaka_spec::{Version, Versions};
use jaka_sync::beyond_io::{GetAnalogOutput, GetDigitalOutput};
use jaka_sync::io::{AnalogOutputKind, DigitalOutputKind, SetAnalogOutput, SetDigitalOutput};
use jaka_sync::motion::JointMove;
use jaka_sync::proto::ErrorCode;
use jaka_sync::types::Switch;
use jaka_sync::{Client, Error};
use jaka_tests::{Arm, LONG, spec};

use super::call;

/// The commands that the document does not have, in the order of the spec: one that is added is tested here.
fn commands() -> Vec<jaka_spec::Command> {
    spec().commands().filter(|command| !command.evidence.is_empty()).cloned().collect()
}

/// An arm whose controller has this firmware, and its client.
fn arm_of(version: &str) -> (Arm, Client) {
    let (arm, client) = Arm::stepped().no_packets().with_client();
    arm.set_state(|state| version.clone_into(&mut state.version));
    (arm, client)
}

/// Sends the requests of the command's examples to firmware of this version, and returns their outcomes.
fn send_examples(version: &str, command: &jaka_spec::Command) -> Vec<Result<(), Error>> {
    let (_arm, mut client) = arm_of(version);
    let requests: Vec<_> = command.examples.iter().filter_map(|example| example.request.as_deref()).collect();
    assert!(!requests.is_empty(), "{}: no example has a request", command.wire);
    requests.into_iter().map(|request| call(&mut client, request).map(drop)).collect()
}

/// A turn of joint 1 from where it is, in degrees, at 20 deg/s.
fn turn(angle: f64) -> JointMove {
    JointMove::relative([angle, 0.0, 0.0, 0.0, 0.0, 0.0], 20.0).acceleration(80.0)
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
    let (arm, mut client) = arm_of("1.5.14_13_X64");
    let whole = client.get_data().expect("it answers");
    let mut packet = arm.stream().next_packet().expect("the first packet comes at once");
    // The length is that of a packet.
    packet.length = whole.length;
    assert_eq!(whole, packet);
}

#[test]
fn positions_and_limits_are_those_of_the_arm() {
    let (arm, mut client) = arm_of("1.7.2");
    client.joint_move(&turn(30.0)).expect("the arm is enabled");
    arm.advance(Duration::from_secs(1));
    arm.set_state(|state| state.on_soft_limit = 1);
    let (joints, pose) = (client.get_actual_joint_pos(), client.get_actual_tcp_pos());
    assert!(joints.expect("it answers").joint_position.max_distance(&arm.state().joint_position) < 1e-4);
    assert!(pose.expect("it answers").pose.distance_mm(&arm.state().tcp_pose) < 1e-4);
    assert_eq!(client.is_on_limit().expect("it answers").on_limit.known(), Some(&true));
}

#[test]
fn stops_and_motions_are_those_of_the_arm() {
    let (arm, mut client) = arm_of("1.7.2");
    let state = client.get_motion_state().expect("it answers");
    assert_eq!((state.in_position, state.paused, state.queue), (true, Some(false), 0));
    client.joint_move(&turn(30.0)).expect("the arm is enabled");
    client.joint_move(&turn(-30.0)).expect("the arm is enabled");
    arm.advance(Duration::from_secs(1));
    let state = client.get_motion_state().expect("it answers");
    assert_eq!((state.in_position, state.queue), (false, 1));
    arm.press_emergency_stop();
    assert!(client.emergency_stop_status().expect("it answers").emergency_stop);
}

#[test]
fn outputs_are_those_that_were_set() {
    let (_arm, mut client) = arm_of("1.7.2");
    client.set_digital_output(&SetDigitalOutput::tool(1, Switch::On)).expect("it answers");
    client.set_analog_output(&SetAnalogOutput::cabinet(3, 4.32)).expect("it answers");
    let mut digital = |kind| client.get_digital_output(&GetDigitalOutput::new(kind, 1)).expect("it answers").value;
    assert_eq!([DigitalOutputKind::Tool, DigitalOutputKind::Cabinet].map(&mut digital), [true, false]);
    let analog = GetAnalogOutput::new(AnalogOutputKind::Cabinet, 3);
    assert_eq!(client.get_analog_output(&analog).expect("it answers").value.to_bits(), 4.32_f64.to_bits());
}

#[test]
fn what_the_spec_forbids_is_not_sent() {
    let (_arm, mut client) = arm_of("1.7.2");
    assert!(client.set_motion_limit_warning_range(6).is_err());
    let beyond = r#"{"cmdName":"set_motion_limit_warning_range","range_level":6}"#;
    assert!(client.call_text(beyond, LONG).is_err_and(|error| error.is_refused()));
}
