//! `jaka call --wait`: how motions end, and what Ctrl-C does.

use std::process::{Child, Stdio};

use expect_test::expect;
use jaka_sim::{Controller, Fault};
use jaka_tests::{Arm, LONG};

#[cfg(unix)]
use crate::common::interrupt;
use crate::program::{Run, command, jaka, result, started_at, without_late_answer};

/// 90 deg of the first joint in 90 s.
const SLOW: &str = "joint_move --mode absolute --joint-position 90,90,90,90,-90,0 --speed 1 --yes --wait";

fn started(controller: &Controller, line: &str) -> Child {
    started_at(controller, &format!("call {line}"))
}

/// Runs a line; `meanwhile` does what it does once the arm moves.
fn run(controller: &Controller, line: &str, meanwhile: impl FnOnce(&Controller)) -> Run {
    let child = started(controller, line);
    assert!(controller.wait_for_requests(1, LONG), "the motion comes");
    meanwhile(controller);
    result(child)
}

#[test]
fn a_motion_that_reaches_its_target_is_a_success() {
    let controller = Arm::real_time().start();
    let fast = "joint_move --mode absolute --joint-position 5,90,90,90,-90,0 --speed 90 --yes --wait";
    let run = run(&controller, fast, |_| {});
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    assert!(run.out.starts_with("the motion has reached its target, after "), "{run:?}");
    assert!((controller.state().joint_position.0[0] - 5.0).abs() < 0.1);
    let dry = jaka("call joint_move --mode absolute --joint-position 5,90,90,90,-90,0 --speed 90 --dry-run".split(' '));
    assert_eq!(controller.requests()[0], dry.out.trim_end(), "the bytes are those of --dry-run");
}

#[test]
fn a_motion_that_is_not_sent_is_told_apart() {
    let controller = Arm::real_time().start();
    controller.collide();
    let run = result(started(&controller, SLOW));
    assert_eq!((run.code, run.out.as_str()), (Some(20), ""), "{run:?}");
    assert!(controller.requests().is_empty());
    controller.set_state(|state| (state.protective_stop, state.enabled) = (false, false));
    let run = result(started(&controller, SLOW));
    assert_eq!(run.code, Some(1), "{run:?}");
    assert!(run.err.contains("The reason: the arm is not enabled"), "{run:?}");
}

#[test]
fn only_motions_are_waited_for() {
    for line in ["power_on --wait --sim", "jog --jog-mode stop --frame joint --axis 0 --wait --sim"] {
        let run = jaka(format!("call {line}").split(' '));
        assert_eq!(run.code, Some(2), "{run:?}");
        assert!(run.err.contains("was not sent: --wait is for the motions joint_move, end_move"), "{run:?}");
    }
}

#[test]
fn an_explicit_timeout_is_not_exceeded() {
    let controller = Arm::real_time().start();
    controller.inject(Fault::Drop);
    let run = result(started(&controller, "power_on --yes --timeout 0.5"));
    assert_eq!(run.code, Some(4), "{run:?}");
    assert!(run.err.contains("no reply to `power_on` within 500ms"), "{run:?}");
}

#[cfg(unix)]
#[test]
fn an_interrupt_stops_the_arm() {
    let controller = Arm::real_time().start();
    let child = started(&controller, SLOW);
    assert!(controller.wait_for_requests(1, LONG), "the motion comes");
    interrupt(&child);
    expect![[r"
        note: interrupted: the controller accepted the stop (`stop_program`)
        note: the arm is at rest
        error: the motion was stopped before its target
        hint: look at the arm before it moves again
        exit code 22
    "]]
    .assert_eq(&without_late_answer(&result(child)));
    assert!(controller.requests().iter().any(|request| request.contains("stop_program")));
    assert!(controller.state().at_rest && controller.state().joint_position.0[0] < 60.0);
}

#[cfg(unix)]
#[test]
fn a_stop_that_is_not_taken_is_told() {
    let controller = Arm::real_time().start();
    let refusal = r#"{"errorCode":"1","errorMsg":"busy","cmdName":"stop_program"}"#;
    controller.inject_for("stop_program", Fault::Instead(refusal.into()));
    let child = started(&controller, SLOW);
    assert!(controller.wait_for_requests(1, LONG), "the motion comes");
    interrupt(&child);
    let run = result(child);
    assert_eq!(run.code, Some(29), "{run:?}");
    assert!(run.err.contains("the controller did not accept the stop; the arm may still move"), "{run:?}");
}

#[cfg(unix)]
#[test]
fn an_interrupt_after_a_command_went_out_says_that_it_may_have_run() {
    let controller = Arm::real_time().start();
    controller.inject(Fault::Drop);
    let child = started(&controller, "set_digital_output --kind cabinet --index 0 --value on --yes");
    assert!(controller.wait_for_requests(1, LONG), "the command comes");
    interrupt(&child);
    expect![[r"
        error: interrupted: `set_digital_output` may have run; check the robot's state before you go on
        exit code 4
    "]]
    .assert_eq(&result(child).text());
}

#[cfg(unix)]
#[test]
fn an_interrupt_before_that_says_that_nothing_was_changed() {
    let silent = std::net::TcpListener::bind("127.0.0.1:0").expect("there are free ports");
    let port = silent.local_addr().expect("it has one").port().to_string();
    let words = ["call", "power_off", "--yes", "-r", "127.0.0.1", "--command-port", &port, "--check-firmware"];
    let child = command(words).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program starts");
    let _connection = silent.accept().expect("it connects");
    interrupt(&child);
    expect![[r"
        error: interrupted; no command that changes anything was sent
        exit code 130
    "]]
    .assert_eq(&result(child).text());
}
