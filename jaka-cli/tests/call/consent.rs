//! Requests that are sent without a question, and requests that are not.

use expect_test::expect;
use jaka_sim::Controller;
use jaka_tests::Arm;

use crate::program::{address_of, command, jaka, run};

/// Sends a line to a controller, with `answer` on a standard input that is not a terminal.
fn call(controller: &Controller, line: &str, answer: &str) -> (Option<i32>, String, usize) {
    let before = controller.requests().len();
    let words = ["call"].into_iter().chain(line.split(' ')).map(str::to_owned).chain(address_of(controller));
    let run = run(command(words), answer);
    (run.code, run.err, controller.requests().len() - before)
}

#[test]
fn what_changes_something_needs_yes_without_a_terminal() {
    let controller = Arm::real_time().start();
    for line in [
        "joint_move --mode relative --joint-position 1,0,0,0,0,0 --speed 10",
        "power_off",
        "clear_error",
        "set_digital_output --kind cabinet --index 0 --value on",
        "jog --jog-mode continuous --frame joint --axis 0 --velocity 1",
        "resume_program",
    ] {
        let (code, error, sent) = call(&controller, line, "y\n");
        assert_eq!((code, sent), (Some(2), 0), "{line}: {error}");
        assert!(error.contains("was not sent") && error.contains("--yes"), "{line}: {error}");
    }
    let (code, error, sent) = call(&controller, "power_off --yes", "");
    assert_eq!((code, sent), (Some(0), 1), "{error}");
    assert!(!controller.state().powered);
    expect![[r"
        error: `power_on` was not sent: it switches power, brakes or the controller itself, and there is no terminal to ask on; use --yes to send it anyway
    "]].assert_eq(&call(&controller, "power_on", "").1);
}

#[test]
fn queries_and_stops_are_never_held_up() {
    let controller = Arm::real_time().start();
    for line in
        ["get_version", "wait_complete", "stop_program", "pause_program", "jog --jog-mode stop --frame joint --axis 0"]
    {
        let (code, error, sent) = call(&controller, line, "");
        assert_eq!(sent, 1, "{line}: {error}");
        assert!(matches!(code, Some(0 | 1)), "{line}: {error}");
    }
}

#[test]
fn what_is_unchecked_wants_a_yes_whatever_it_is() {
    let controller = Arm::real_time().start();
    let (code, error, sent) = call(&controller, "get_version --raw", "");
    assert_eq!((code, sent), (Some(2), 0), "{error}");
    let (code, error, sent) = call(&controller, "get_version --raw --yes", "");
    assert_eq!((code, sent), (Some(0), 1), "{error}");
}

#[test]
fn a_dry_run_needs_no_yes_and_no_robot() {
    let run = jaka(["call", "power_off", "--dry-run"]);
    assert_eq!((run.code, run.out.as_str(), run.err.as_str()), (Some(0), "{\"cmdName\":\"power_off\"}\n", ""));
}

#[test]
fn a_simulated_arm_needs_no_consent() {
    assert_eq!(jaka(["call", "power_on", "--sim"]).text(), "powered_on  true\nexit code 0\n");
}

#[test]
fn without_an_address_nothing_is_sent() {
    let run = jaka(["call", "get_version"]);
    assert_eq!(run.code, Some(2));
    assert!(run.err.contains("no robot is given"), "{}", run.err);
}
