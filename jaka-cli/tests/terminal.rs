//! Questions and warnings to a person on a terminal, which `script` of util-linux gives the program.

#![cfg(target_os = "linux")]

use jaka_sim::Controller;
use jaka_tests::Arm;

use crate::program::address_of;
use crate::pseudo::on_terminal;
use crate::transcripts;

/// Output of a line on a controller, with this answer; none if there is no terminal.
fn shown(controller: &Controller, line: &str, answer: &str) -> Option<String> {
    let (shown, code) = on_terminal(&format!("{line} {}", address_of(controller).join(" ")), answer)?;
    Some(format!("{shown}exit code {}\n", code.unwrap_or(-1)))
}

#[test]
fn a_question_says_what_will_happen_and_no_is_an_answer() {
    let controller = Arm::real_time().start();
    transcripts::check("questions.txt", |line| shown(&controller, line, "n\n"));
    assert!(controller.requests().is_empty());
}

#[test]
fn what_is_beyond_a_limit_is_refused_before_a_question() {
    let controller = Arm::real_time().start();
    transcripts::check("beyond_limits.txt", |line| shown(&controller, line, ""));
    assert!(controller.requests().is_empty());
}

#[test]
fn whoever_takes_the_seat_for_a_query_is_warned() {
    let controller = Arm::real_time().start();
    let warning =
        "warning: the command port serves one client: another program that is connected there may be disconnected\n";
    for (line, is_warned) in [
        ("call get_joint_pos", true),
        ("call get_joint_pos -q", false),
        ("call get_joint_pos --yes", false),
        ("call stop_program", false),
        ("stop", false),
    ] {
        let Some(shown) = shown(&controller, line, "") else { return };
        assert!(shown.ends_with("exit code 0\n") && shown.starts_with(warning) == is_warned, "{line}: {shown}");
        assert_eq!(shown.contains("serves one client"), is_warned, "{line}: {shown}");
    }
}
