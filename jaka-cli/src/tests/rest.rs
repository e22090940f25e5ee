//! Rest of the arm after `jaka stop` and Ctrl-C, compared with the joints of the simulated controller.

use std::fs;
use std::time::Duration;

use expect_test::expect;
use jaka_sim::{Controller, Fault, Port};
use jaka_sync::motion::JointMove;
use jaka_tests::simulated::until;
use jaka_tests::{Arm, LONG};

use super::follow::words;
use super::{Run, interrupted, interrupted_and, jaka, jaka_beside, scratch};

/// Greatest speed of a joint of an arm at rest, in deg/s.
const REST_SPEED: f64 = 0.5;

const MOVES: [&str; 3] = [
    "move --joints 90,90,90,90,-90,0 --speed 60 --yes",
    "jog 1 90 --speed 60 --yes",
    "call joint_move --mode absolute --joint-position 90,90,90,90,-90,0 --speed 60 --yes --wait",
];

fn arm() -> Arm {
    Arm::simulated().at([0.0, 90.0, 90.0, 90.0, -90.0, 0.0]).start()
}

/// Returns the speed of the fastest joint, in deg/s.
fn speed(arm: &Arm) -> f64 {
    let before = arm.state().joint_position.0;
    arm.clock().sleep(Duration::from_millis(8));
    let after = arm.state().joint_position.0;
    (0..6).map(|joint| (after[joint] - before[joint]).abs() / 0.008).fold(0.0, f64::max)
}

/// Waits until a request of this name has come.
fn wait_for(arm: &Arm, name: &str) {
    until(arm.clock(), || arm.requests().iter().any(|request| request.contains(name)));
}

/// Turns the first joint on at 10 deg/s, whatever the controller was told.
fn turn_on(arm: &Arm, time: Duration) {
    for _ in 0..time.as_millis() / 4 {
        arm.clock().sleep(Duration::from_millis(4));
        arm.set_state(|state| state.joint_position.0[0] += 0.04);
    }
}

fn has_said_rest(run: &Run) -> bool {
    run.text().lines().any(|line| line.ends_with("the arm is at rest") && !line.contains("whether"))
}

#[test]
fn after_ctrl_c_the_arm_is_at_rest_when_that_is_said() {
    let moments = (0..12).map(|step| Duration::from_millis(30 + 110 * step));
    for (line, after) in MOVES.iter().flat_map(|line| moments.clone().map(move |after| (line, after))) {
        let arm = arm();
        let run = interrupted(&arm, line.split(' '), || {
            wait_for(&arm, "joint_move");
            arm.clock().sleep(after);
        });
        let text = "note: interrupted: the controller accepted the stop (`stop_program`)\n\
                    note: the arm is at rest\n\
                    error: the motion was stopped before its target\n\
                    hint: look at the arm before it moves again\n";
        assert_eq!((run.code, run.err.as_str()), (22, text), "{line} after {after:?}");
        assert!(speed(&arm) < REST_SPEED && arm.state().joint_position.0[0] < 89.0, "{line} after {after:?}");
    }
}

#[test]
fn after_ctrl_c_the_arm_is_at_rest_when_that_is_said_of_a_trajectory() {
    for after in [0, 100, 1000, 7000].map(Duration::from_millis) {
        let arm = arm();
        let run = interrupted(&arm, words(10.0, "--json"), || {
            wait_for(&arm, "servo_j");
            arm.clock().sleep(after);
        });
        assert!(run.code == 22 && run.err.contains("and the arm is at rest\n"), "{run:?}");
        assert!(run.out.contains(r#""rest":"answers""#), "by the controller's answers: {run:?}");
        assert!(speed(&arm) < REST_SPEED);
    }
}

#[test]
fn an_arm_that_goes_on_after_ctrl_c_is_not_said_to_rest() {
    for line in MOVES {
        let arm = arm();
        let run = interrupted_and(
            &arm,
            line.split(' '),
            || {
                wait_for(&arm, "joint_move");
                arm.clock().sleep(Duration::from_millis(300));
            },
            || turn_on(&arm, LONG),
        );
        assert!(!has_said_rest(&run), "{run:?}");
        let line = "error: the motion was stopped before its target; the arm still moves: joint 1 turns at ";
        assert!(run.code == 29 && run.err.contains(line), "{run:?}");
        assert!(run.err.ends_with("hint: use the emergency stop, unless you see the arm at rest\n"), "{run:?}");
    }
    let arm = arm();
    let run = interrupted_and(
        &arm,
        words(10.0, "--json"),
        || assert!(arm.wait_for_requests(500, LONG), "set-points come"),
        || {
            until(arm.clock(), || !arm.state().servo_mode);
            turn_on(&arm, LONG);
        },
    );
    assert!(!has_said_rest(&run) && run.out.contains(r#""rest":"not_seen""#), "{run:?}");
    assert!(run.code == 29 && run.err.contains("the arm still moves: joint 1 turns at 10.0"), "{run:?}");
}

#[test]
fn a_trajectory_that_its_time_has_ended_is_not_said_to_rest_by_packets_alone() {
    let arm = arm();
    let other = || {
        until(arm.clock(), || arm.state().servo_mode);
        until(arm.clock(), || !arm.state().servo_mode);
        turn_on(&arm, LONG);
    };
    let run = jaka_beside(&arm, other, words(10.0, "--timeout 3"));
    assert!(run.code == 27 && run.err.contains("and the arm was not seen at rest\n"), "{run:?}");
    let run = jaka(&self::arm(), words(10.0, "--timeout 3"));
    assert!(run.code == 27 && run.err.contains("and the arm is at rest\n"), "{run:?}");
}

#[test]
fn a_stop_waits_for_rest_and_says_so() {
    for after in (0..12).map(|step| Duration::from_millis(30 + 110 * step)) {
        let (arm, mut other) = Arm::simulated().with_client();
        other.joint_move(&JointMove::relative([90.0, 0.0, 0.0, 0.0, 0.0, 0.0], 60.0)).expect("the arm is ready");
        arm.clock().sleep(after);
        let run = jaka(&arm, ["stop"]);
        let out = "the controller accepted the stop (`stop_program`)\nthe arm is at rest\n";
        assert_eq!((run.code, run.out.as_str(), run.err.as_str()), (0, out, ""), "after {after:?}");
        assert!(speed(&arm) < REST_SPEED && arm.state().joint_position.0[0] < 89.0, "after {after:?}");
        let requests = arm.requests();
        let first = requests.iter().position(|request| !request.contains("joint_move"));
        assert!(first.is_some_and(|first| requests[first].contains("stop_program")), "{requests:?}");
    }
}

#[test]
fn a_stop_of_an_arm_that_goes_on_says_how_fast() {
    let arm = arm();
    let run = jaka_beside(&arm, || turn_on(&arm, LONG), ["stop"]);
    expect![[r"
        the controller accepted the stop (`stop_program`)
        warning: the arm still moves: joint 1 turns at 10.00 deg/s; use the emergency stop if it does not come to rest
        error: the arm still moves: joint 1 turns at 10.00 deg/s
        hint: use the emergency stop, unless you see the arm at rest
        exit code 29
    "]]
    .assert_eq(&run.text());
}

#[test]
fn a_stop_of_an_arm_that_rests_late_says_both() {
    let arm = arm();
    let run = jaka_beside(&arm, || turn_on(&arm, Duration::from_secs(3)), ["stop"]);
    expect![[r"
        the controller accepted the stop (`stop_program`)
        the arm is at rest
        warning: the arm still moves: joint 1 turns at 10.00 deg/s; use the emergency stop if it does not come to rest
        exit code 0
    "]]
    .assert_eq(&run.text());
    assert!(arm.clock().elapsed() >= Duration::from_secs(3) && speed(&arm) < REST_SPEED);
}

#[test]
fn a_stop_after_which_the_arm_cannot_be_observed_says_why() {
    let refused = arm();
    let refusal = r#"{"errorCode":"2","errorMsg":"busy","cmdName":"get_joint_pos"}"#;
    (0..200).for_each(|_| refused.inject_for("get_joint_pos", Fault::Instead(refusal.into())));
    let run = jaka(&refused, ["stop"]);
    assert!(run.code == 29 && !has_said_rest(&run), "{run:?}");
    assert!(run.err.contains("error: it is not known whether the arm is at rest: the controller refused"), "{run:?}");

    let silent: fn(&Controller) = |controller| controller.link(Port::Command).cut();
    for (end, why) in [(silent, "no reply to `get_joint_pos`"), (Controller::disconnect, "the connection to ")] {
        let arm = arm();
        let other = || {
            wait_for(&arm, "stop_program");
            arm.clock().sleep(Duration::from_millis(150));
            end(&arm);
        };
        let run = jaka_beside(&arm, other, ["stop"]);
        assert!(run.code == 29 && !has_said_rest(&run), "{run:?}");
        assert!(run.err.contains(&format!("error: it is not known whether the arm is at rest: {why}")), "{run:?}");
    }
}

#[test]
fn a_pack_by_which_the_joints_are_others_keeps_rest_from_being_said() {
    let pack = scratch("radians.toml");
    let text = "title = 'T'\n[[type]]\nname = 'Radians'\nkind = 'wrapper'\ntype = 'float[6]'\nunit = 'rad'\ndoc = 'D.'\n\
                [[override]]\ntarget = 'get_joint_pos'\nreply = 'joint_pos'\ntype = 'Radians'\n";
    fs::write(&pack, text).expect("it can be written");
    let arm = arm();
    let run = jaka(&arm, ["stop", "--pack", &pack.display().to_string()]);
    assert!(arm.requests()[0].contains("stop_program"));
    assert!(run.code == 29 && !has_said_rest(&run) && run.err.contains("a pack changes `get_joint_pos`"), "{run:?}");
    let run = jaka(&arm, ["stop", "--pack", "nowhere.toml"]);
    assert!(run.code == 0 && has_said_rest(&run), "{run:?}");
}

#[test]
fn without_power_the_rest_is_seen_too() {
    let arm = Arm::simulated().without_power().start();
    let run = jaka(&arm, ["stop"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""), "{run:?}");
}
