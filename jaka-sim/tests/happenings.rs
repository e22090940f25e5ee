//! Happenings to the arm, to inputs and to links at given times.

use std::io::ErrorKind;
use std::time::Duration;

use crate::common::{Peer, assert_accepted, document, enabled, json, stepped};
use jaka_sim::{Controller, Happening, Level, LinkFault};

fn ms(time: u64) -> Duration {
    Duration::from_millis(time)
}

#[test]
fn each_happening_changes_what_its_name_says() {
    for happening in Happening::one_of_each() {
        let controller = stepped();
        // So that what goes low and what is released can be seen.
        controller.set_state(|state| {
            state.tool_digital_inputs[0] = true;
            state.emergency_stop = happening == Happening::ReleaseEmergencyStop;
        });
        let mut status = Peer::status(&controller);
        status.receive();
        let mut expected = controller.state();
        controller.at(ms(100), happening).expect("there are such inputs");
        controller.advance(ms(96));
        assert_eq!(controller.state(), expected, "{happening}");
        controller.advance(ms(8));
        match happening {
            Happening::Collide => {
                expected.protective_stop = true;
                (expected.error_code, expected.error_message) =
                    ("0xf0034".to_owned(), "a collision was detected".to_owned());
            }
            Happening::PressEmergencyStop => (expected.emergency_stop, expected.enabled) = (true, false),
            Happening::ReleaseEmergencyStop => expected.emergency_stop = false,
            Happening::CutPower => (expected.powered, expected.enabled) = (false, false),
            Happening::Input(index, level) => expected.digital_inputs[index] = level == Level::High,
            Happening::ToolInput(index, level) => expected.tool_digital_inputs[index] = level == Level::High,
            Happening::AnalogInput(index, value) => expected.analog_inputs[index] = value,
            Happening::ToolAnalogInput(index, value) => expected.tool_analog_inputs[index] = value,
            Happening::Link { .. } => {
                controller.send_status(b"{}");
                assert!(!status.has_something());
                controller.at(ms(0), LinkFault::None).expect("it has no input");
                assert_eq!(status.receive(), "{}");
            }
            _ => panic!("{happening} is not in this table"),
        }
        assert_eq!(controller.state(), expected, "{happening}");
    }
}

#[test]
fn a_collision_comes_in_its_cycle_however_far_time_goes_on_at_once() {
    let controller = enabled(document().stepped_clock().at(ms(2000), Happening::Collide));
    let mut peer = Peer::commands(&controller);
    let turn = r#"{"cmdName":"joint_move","relFlag":1,"jointPosition":[90,0,0,0,0,0],"speed":10,"accel":100}"#;
    assert_accepted(&peer.ask(turn), "joint_move");
    let start = controller.state().joint_position.0[0];
    controller.advance(ms(60_000));
    let state = controller.state();
    // 0.1 s at 100 deg/s² and 1.9 s at 10 deg/s, less the cycle in which it collides.
    let turned = state.joint_position.0[0] - start;
    assert!(state.protective_stop && (turned - 19.5).abs() < 0.1, "{turned} deg");
    assert_accepted(&peer.call("clear_error"), "clear_error");
    assert!(!controller.state().protective_stop, "it comes once");
}

#[test]
fn what_is_for_a_time_that_has_passed_happens_at_once_and_in_order() {
    let controller = stepped();
    controller.advance(ms(1000));
    controller.at(ms(500), Happening::PressEmergencyStop).expect("it has no input");
    assert!(controller.state().emergency_stop);
    for level in [Level::High, Level::Low, Level::High] {
        controller.at(ms(2000), Happening::Input(2, level)).expect("there is such an input");
    }
    controller.advance(ms(1000));
    assert!(controller.state().digital_inputs[2]);
}

#[test]
fn inputs_change_at_their_times_and_packets_show_them() {
    let controller = document()
        .stepped_clock()
        .status_period(Duration::MAX)
        .at(ms(1000), Happening::Input(3, Level::High))
        .at(ms(2000), Happening::Input(3, Level::Low))
        .at(ms(500), Happening::ToolAnalogInput(0, 2.5))
        .at(ms(500), Happening::ToolAnalogInput(0, 3.5))
        .start()
        .expect("loopback has ports");
    let mut status = Peer::status(&controller);
    status.receive();
    let mut shown = |time| {
        controller.advance(time);
        controller.publish();
        let packet = json(&status.receive());
        (packet["din"][3].clone(), packet["tio_ain"][0].clone())
    };
    assert_eq!(shown(ms(496)), (0.into(), 0.into()));
    // Two changes at the same time are made in their order.
    assert_eq!(shown(ms(8)), (0.into(), 3.5.into()));
    assert_eq!(shown(ms(496)), (1.into(), 3.5.into()));
    assert_eq!(shown(ms(992)), (1.into(), 3.5.into()));
    assert_eq!(shown(ms(8)), (0.into(), 3.5.into()));
    // An idle arm passes over many cycles at once, and over no change.
    let start = controller.elapsed();
    for (time, level) in [(60_000, Level::High), (60_008, Level::Low), (120_000, Level::High)] {
        controller.at(start + ms(time), Happening::ToolInput(1, level)).expect("there is such an input");
    }
    controller.advance(ms(60_000));
    assert!(controller.state().tool_digital_inputs[1]);
    controller.advance(ms(8));
    assert!(!controller.state().tool_digital_inputs[1]);
    controller.advance(ms(60_000));
    assert!(controller.state().tool_digital_inputs[1]);
}

#[test]
fn an_input_that_the_controller_does_not_have_is_an_error() {
    let error = document().at(ms(1), Happening::Input(144, Level::High)).start().expect_err("there are 144");
    assert_eq!(error.kind(), ErrorKind::InvalidInput);
    assert_eq!(error.to_string(), "the cabinet has 144 digital inputs, from 0, and not one with number 144");
    let controller: Controller = stepped();
    let before = controller.state();
    for happening in [
        Happening::Input(144, Level::Low),
        Happening::ToolInput(8, Level::High),
        Happening::AnalogInput(66, 1.0),
        Happening::ToolAnalogInput(1, 1.0),
    ] {
        let error = controller.at(ms(8), happening).expect_err("there is none");
        assert_eq!(error.kind(), ErrorKind::InvalidInput, "{happening}");
    }
    controller.advance(ms(100));
    assert_eq!(controller.state(), before);
}
