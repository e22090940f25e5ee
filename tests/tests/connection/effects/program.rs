//! Programs and the speed rate.

use jaka_sync::Client;
use jaka_sync::program::ProgramState;
use jaka_sync::status::InterpreterState;

use super::arm::{Arm, assert_close, disabled, refused, turn, turned};

effects! {
    rapid_rate => the_rate_scales_speed,
    load_program => a_program_is_loaded,
    get_loaded_program => the_loaded_program_is_told,
    play_program => a_program_moves_the_arm,
    pause_program => a_pause_keeps_the_arm_where_it_is,
    resume_program => a_program_goes_on_after_a_pause,
    stop_program => a_stop_ends_motion,
    get_program_state => the_programs_state_is_told,
}

/// The program that turns joint 1 there and back, half a second after its start.
fn playing(arm: &mut Arm) {
    arm.client.load_program("test.jks").expect("every controller has it");
    arm.client.play_program().expect("the arm is enabled");
    arm.controller.advance(std::time::Duration::from_millis(500));
}

fn the_rate_scales_speed(arm: &mut Arm) {
    let start = arm.joints();
    arm.client.set_rapid_rate(0.5).expect("it answers");
    assert_eq!(arm.status().rapid_rate, Some(0.5));
    // At the full rate this takes 1.75 s.
    arm.client.joint_move(&turn(30.0)).expect("the arm is enabled");
    arm.wait(3);
    assert_eq!(arm.status().in_position, Some(false));
    arm.wait(1);
    assert_eq!(arm.status().in_position, Some(true));
    assert_close(arm.joints(), turned(start, 30.0), 1e-9);
}

fn a_program_is_loaded(arm: &mut Arm) {
    arm.client.load_program("track/test.jks").expect("every controller has it");
    refused(arm.client.load_program("no_such_program.jks"));
    assert_eq!(arm.client.get_loaded_program().expect("it answers").program_name, "track/test.jks");
}

fn the_loaded_program_is_told(arm: &mut Arm) {
    arm.controller.set_state(|state| "weld.jks".clone_into(&mut state.loaded_program));
    assert_eq!(arm.client.get_loaded_program().expect("it answers").program_name, "weld.jks");
}

fn a_program_moves_the_arm(arm: &mut Arm) {
    let start = arm.joints();
    playing(arm);
    let status = arm.status();
    assert_eq!((status.interpreter_state, status.paused), (Some(InterpreterState::Running), Some(false)));
    assert!(arm.joints()[0] - start[0] > 5.0);
    refused(arm.client.play_program());
    arm.wait(5);
    assert_eq!(arm.status().interpreter_state, Some(InterpreterState::Idle));
    assert_close(arm.joints(), start, 1e-9);
    arm.refuses(disabled, Client::play_program);
}

fn a_pause_keeps_the_arm_where_it_is(arm: &mut Arm) {
    let start = arm.joints();
    playing(arm);
    arm.client.pause_program().expect("it answers");
    let paused = arm.joints();
    arm.wait(5);
    assert_close(arm.joints(), paused, 0.0);
    assert!(paused[0] - start[0] > 5.0);
    let status = arm.status();
    assert_eq!((status.interpreter_state, status.paused), (Some(InterpreterState::Paused), Some(true)));
}

fn a_program_goes_on_after_a_pause(arm: &mut Arm) {
    let start = arm.joints();
    playing(arm);
    arm.client.pause_program().expect("it answers");
    arm.client.resume_program().expect("the arm is enabled");
    assert_eq!(arm.status().paused, Some(false));
    arm.wait(5);
    assert_close(arm.joints(), start, 1e-9);
    assert_eq!(arm.status().interpreter_state, Some(InterpreterState::Idle));
    arm.refuses(disabled, Client::resume_program);
}

fn a_stop_ends_motion(arm: &mut Arm) {
    let start = arm.joints();
    for _ in 0..2 {
        arm.client.joint_move(&turn(40.0)).expect("the arm is enabled");
    }
    arm.wait(1);
    arm.client.stop_program().expect("it answers");
    arm.wait(10);
    assert!((5.0..30.0).contains(&(arm.joints()[0] - start[0])));
    assert_eq!(arm.status().in_position, Some(true));
}

fn the_programs_state_is_told(arm: &mut Arm) {
    let state = |arm: &mut Arm| arm.client.get_program_state().expect("it answers").program_state;
    assert_eq!(state(arm), ProgramState::Idle);
    playing(arm);
    assert_eq!(state(arm), ProgramState::Running);
    arm.client.pause_program().expect("it answers");
    assert_eq!(state(arm), ProgramState::Paused);
    arm.client.stop_program().expect("it answers");
    assert_eq!(state(arm), ProgramState::Idle);
}
