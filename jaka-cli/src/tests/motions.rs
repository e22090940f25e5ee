//! Ends of motions with a wait, and of `jaka up`.

use std::time::Duration;

use jaka_sim::{Controller, Delays, Habit, Habits, Port};
use jaka_sync::motion::JointMove;
use jaka_tests::{Arm, LONG};
use serde_json::Value;

use super::{Run, interrupted, jaka, jaka_beside};

/// Motion of the first joint by 90 deg in 9 s.
const SLOW: &str = "call joint_move --mode absolute --joint-position 90,90,90,90,-90,0 --speed 10 --yes --wait";

/// Event on an arm that moves.
type Happening = fn(&Controller);

/// Runs a line, and `meanwhile` once the arm moves.
fn run(line: &str, meanwhile: Happening) -> Run {
    let arm = Arm::simulated().start();
    let other = || {
        assert!(arm.wait_for_requests(1, LONG), "the motion comes");
        meanwhile(&arm);
    };
    jaka_beside(&arm, other, line.split(' '))
}

/// Returns the requests other than queries.
fn changes(arm: &Arm) -> Vec<String> {
    arm.requests().into_iter().filter(|request| !request.contains("\"get_")).collect()
}

#[test]
fn each_end_has_its_exit_code() {
    let ends: [(&str, Happening, u8, &str); 6] = [
        ("", Controller::collide, 23, "protective stop"),
        ("", Controller::press_emergency_stop, 24, "emergency stop"),
        ("", Controller::cut_power, 25, "no power"),
        ("", |controller| controller.set_state(|state| "0x0f0030".clone_into(&mut state.error_code)), 26, "0x0f0030"),
        (" --timeout 3", |_| {}, 27, "has not ended in time"),
        ("", |controller| controller.link(Port::Status).cut(), 28, "the arm may still move"),
    ];
    for (options, meanwhile, code, text) in ends {
        let run = run(&format!("{SLOW}{options}"), meanwhile);
        assert_eq!((run.code, run.out.as_str()), (code, ""), "{text}: {run:?}");
        assert!(run.err.starts_with("error: ") && run.err.contains(text), "{run:?}");
    }
    let turn = "call moveL --mode relative --pose 0,0,1,0,0,1 --speed 100 --yes --wait";
    let run = run(turn, |_| {});
    assert_eq!((run.code, run.out.as_str()), (21, ""), "{run:?}");
}

#[test]
fn json_says_how_it_ended_whatever_the_end_is() {
    let cause = |line: &str, meanwhile: Happening| {
        let run = run(line, meanwhile);
        let json: Value = serde_json::from_str(&run.out).expect("it is one object");
        let end = &json["end"];
        assert_eq!(json["command"], "joint_move");
        assert!(end["report"]["waited_s"].as_f64().is_some() && end["text"].is_string(), "{json}");
        end["cause"].as_str().expect("it is a text").to_owned()
    };
    assert_eq!(cause(&format!("{SLOW} --json"), Controller::collide), "protective_stop");
    let fast = "call joint_move --mode absolute --joint-position 5,90,90,90,-90,0 --speed 90 --yes --wait --json";
    assert_eq!(cause(fast, |_| {}), "reached");
}

#[test]
fn a_seat_that_is_taken_during_a_move_is_told_at_once() {
    let arm = Arm::simulated().start();
    let mut taken_at = Duration::ZERO;
    let take_the_seat = || {
        assert!(arm.wait_for_requests(1, LONG), "the motion comes");
        // The answer has been read by then, and the motion takes minutes.
        arm.clock().sleep(Duration::from_secs(1));
        taken_at = arm.clock().elapsed();
        arm.take_over().expect("loopback has ports");
    };
    let run = jaka_beside(&arm, take_the_seat, "move --joints 170,90,90,90,-90,0 --speed 1 --yes --json".split(' '));
    assert!(
        arm.clock().elapsed().saturating_sub(taken_at) < Duration::from_millis(200),
        "with the next packets: {run:?}"
    );
    assert!(!arm.state().at_rest, "the arm goes on: {run:?}");
    let json: Value = serde_json::from_str(&run.out).expect("it is one object");
    assert_eq!((run.code, &json["end"]["cause"]), (4, &"commands_lost".into()), "{run:?}");
    for part in [
        "the arm may still move",
        "such as the vendor's app",
        "hint: use the emergency stop, or `jaka stop`, which takes the command port back",
    ] {
        assert!(run.err.contains(part), "{run:?}");
    }
}

#[test]
fn what_does_not_come_about_in_time_is_told() {
    for (habits, code) in [(Habits::from(Habit::LatePower), 4), (Habits::none(), 27)] {
        let slow = Arm::simulated().without_power();
        let slow = slow.controller(|controller| controller.delays(Delays::REAL).habits(habits)).start();
        let run = jaka(&slow, "up --yes --timeout 2".split(' '));
        assert_eq!((run.code, run.out.as_str()), (code, ""), "{run:?}");
    }
}

#[test]
fn a_motion_is_not_queued_behind_another_unless_that_is_asked_for() {
    let (arm, mut other) = Arm::simulated().with_client();
    other.joint_move(&JointMove::relative([60.0, 0.0, 0.0, 0.0, 0.0, 0.0], 2.0)).expect("the arm is ready");
    for line in ["jog 6 1 --speed 5 --yes", "move --joints 0,90,90,90,-90,0 --speed 10 --yes"] {
        let refused = jaka(&arm, line.split(' '));
        assert_eq!((refused.code, refused.out.as_str()), (20, ""), "{refused:?}");
        assert!(refused.err.contains("the arm is moving") && refused.err.contains("--queue"), "{refused:?}");
    }
    assert_eq!(changes(&arm).len(), 1, "only the first one was sent");
    let queued = jaka(&arm, "jog 6 1 --speed 5 --yes --queue --timeout 1".split(' '));
    assert_eq!(queued.code, 27, "{queued:?}");
    assert!(queued.err.contains("hint: `jaka stop` stops it"), "{queued:?}");
    assert_eq!(changes(&arm).len(), 2);
}

#[test]
fn an_interrupt_of_up_waits_for_the_step_that_went_out() {
    // The replies, and the reply to the stop, come only when the step is done.
    let powered = "note: the arm has power, after 8.0 s; enabling it\n";
    for (steps, told, said) in [
        (1, "", "accepted before: power_on; not sent: enable_robot"),
        (2, powered, "accepted before: power_on, enable_robot; not sent: nothing"),
    ] {
        let slow = Arm::simulated().without_power();
        let slow = slow.controller(|it| it.delays(Delays::REAL).habits(Habits::from(Habit::LatePower))).start();
        let run = interrupted(&slow, ["up", "--yes"], || {
            // Counts requests before checking them, so that one that comes meanwhile ends the wait.
            let mut seen = slow.requests().len();
            while changes(&slow).len() < steps {
                assert!(slow.wait_for_requests(seen + 1, LONG), "the step comes");
                seen = slow.requests().len();
            }
        });
        let text = format!(
            "note: interrupted: no further step is sent\nnote: switching the power on\n{told}note: the arm is at rest\n\
             error: interrupted; {said}\n\
             hint: look at the arm before it moves again\n"
        );
        assert_eq!((run.code, run.err), (4, text));
        let sent = [r#"{"cmdName":"power_on"}"#, r#"{"cmdName":"enable_robot"}"#];
        assert_eq!(changes(&slow), [&sent[..steps], &[r#"{"cmdName":"stop_program"}"#]].concat());
    }
}
