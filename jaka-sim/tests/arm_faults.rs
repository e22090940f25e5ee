//! What happens to the arm and to inputs at given times.

use std::io::ErrorKind;
use std::time::Duration;

use crate::common::{Peer, assert_accepted, document, enabled, stepped};
use jaka_sim::{ArmFault, Controller, State};

fn ms(time: u64) -> Duration {
    Duration::from_millis(time)
}

/// What the faults of a table change.
fn seen(state: &State) -> (bool, bool, bool, bool, bool, bool) {
    let State { powered, enabled, protective_stop, emergency_stop, .. } = *state;
    (powered, enabled, protective_stop, emergency_stop, state.digital_inputs[1], state.tool_digital_inputs[1])
}

#[test]
fn each_fault_changes_what_its_name_says() {
    for fault in ArmFault::one_of_each(1) {
        let controller = stepped();
        // So that what goes low and what is released can be seen.
        let before = matches!(fault, ArmFault::InputLow(_) | ArmFault::ToolInputLow(_));
        controller.set_state(|state| {
            (state.digital_inputs[1], state.tool_digital_inputs[1]) = (before, before);
            state.emergency_stop = fault == ArmFault::ReleaseEmergencyStop;
        });
        controller.at(ms(100), fault).expect("there are two inputs");
        controller.advance(ms(96));
        let was = seen(&controller.state());
        controller.advance(ms(8));
        let (powered, enabled, ..) = was;
        let expected = match fault {
            ArmFault::Collide => (powered, enabled, true, false, before, before),
            ArmFault::PressEmergencyStop => (powered, false, false, true, before, before),
            ArmFault::ReleaseEmergencyStop => (powered, false, false, false, before, before),
            ArmFault::CutPower => (false, false, false, false, before, before),
            ArmFault::InputHigh(_) | ArmFault::ToolInputLow(_) => (powered, enabled, false, false, true, false),
            ArmFault::InputLow(_) | ArmFault::ToolInputHigh(_) => (powered, enabled, false, false, false, true),
            _ => panic!("{fault} is not in this table"),
        };
        assert_eq!(seen(&controller.state()), expected, "{fault}");
        assert_ne!(was, expected, "{fault}");
    }
}

#[test]
fn a_collision_comes_in_its_cycle_however_far_time_goes_on_at_once() {
    let controller = enabled(document().stepped_clock().at(ms(2000), ArmFault::Collide));
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
    controller.at(ms(500), ArmFault::PressEmergencyStop).expect("it has no input");
    assert!(controller.state().emergency_stop);
    for fault in [ArmFault::InputHigh(2), ArmFault::InputLow(2), ArmFault::InputHigh(2)] {
        controller.at(ms(2000), fault).expect("there is such an input");
    }
    controller.advance(ms(1000));
    assert!(controller.state().digital_inputs[2]);
}

#[test]
fn an_input_that_the_controller_does_not_have_is_an_error() {
    let error = document().at(ms(1), ArmFault::InputHigh(144)).start().expect_err("there are 144");
    assert_eq!(error.kind(), ErrorKind::InvalidInput);
    assert_eq!(error.to_string(), "the cabinet has 144 digital inputs, from 0, and not one with number 144");
    let controller: Controller = stepped();
    let before = controller.state();
    for fault in
        [ArmFault::InputHigh(144), ArmFault::InputLow(144), ArmFault::ToolInputHigh(144), ArmFault::ToolInputLow(144)]
    {
        assert_eq!(controller.at(ms(8), fault).expect_err("there is none").kind(), ErrorKind::InvalidInput, "{fault}");
    }
    controller.advance(ms(100));
    assert_eq!(controller.state(), before);
}
