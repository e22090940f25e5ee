//! Messages on standard error, and their colours: `-v`, `-q` and `--color`.

use std::process::Stdio;

use expect_test::expect;
use jaka_sim::Fault;
use jaka_tests::{Arm, LONG};

use crate::program::{address_of, command, jaka, result, run, scratch};

/// The lines of a log, without their times.
fn log(err: &str) -> String {
    let without_time = |line: &str| {
        let (time, text) = line.strip_prefix('[').and_then(|line| line.split_once(" s] ")).expect("a line has a time");
        assert!(time.trim().parse::<f64>().is_ok_and(|time| time >= 0.0), "{line}");
        format!("{text}\n")
    };
    err.lines().map(without_time).collect()
}

#[test]
fn verbose_tells_connections_requests_and_replies() {
    let controller = Arm::real_time().without_power().start();
    let expected = format!(
        "connected to {} (port for commands)\n-> {}\n<- {}",
        controller.command_addr(),
        r#"{"cmdName":"get_version"}"#,
        r#"{"errorCode": "0", "errorMsg": "", "cmdName": "get_version", "#
    );
    for line in [["-v", "call", "get_version"], ["call", "-v", "get_version"], ["call", "get_version", "-v"]] {
        let run = jaka(line.map(str::to_owned).into_iter().chain(address_of(&controller)));
        assert_eq!(run.code, Some(0), "{run:?}");
        let log = log(&run.err);
        assert!(log.starts_with(&expected) && log.lines().count() == 3, "{log}");
    }
    let silent = jaka(["call", "get_version", "--sim"]);
    assert_eq!((silent.code, silent.err.as_str()), (Some(0), ""));
    let both = jaka(["call", "get_version", "--sim", "-vv"]);
    let of_simulator =
        ["command client connected", r#"received {"cmdName":"get_version"}"#, r#"sends {"errorCode": "0""#];
    assert!(of_simulator.iter().all(|line| both.err.contains(line)), "{both:?}");
    let of_status = jaka(["status", "-v", "--sim"]);
    assert!(of_status.err.contains("(port for status packets)"), "{of_status:?}");
}

#[test]
fn a_log_is_whole_when_the_command_fails() {
    let controller = Arm::real_time().without_power().start();
    controller.inject(Fault::Drop);
    let words = ["-v", "call", "get_version", "--timeout", "0.3"].map(str::to_owned);
    let run = jaka(words.into_iter().chain(address_of(&controller)));
    let lines: Vec<_> = run.err.lines().collect();
    assert_eq!((run.code, lines.len()), (Some(4), 3), "{run:?}");
    assert!(lines[1].ends_with(r#"-> {"cmdName":"get_version"}"#), "{lines:?}");
    assert!(lines[2].starts_with("error: no reply to `get_version`"), "{lines:?}");
}

#[test]
fn quiet_hides_warnings_and_no_errors() {
    let recording = scratch("cut.jsonl");
    let text = "{\"jaka_recording\":1,\"started\":1,\"software\":\"a test\"}\n{\"time\":1,";
    std::fs::write(&recording, text).expect("it can be written");
    let file = recording.to_str().expect("it is UTF-8");
    let warned = jaka(["replay", file, "--show"]);
    assert!(warned.err.starts_with("warning: ") && warned.code == Some(0), "{warned:?}");
    let quiet = jaka(["replay", file, "--show", "-q"]);
    assert_eq!((quiet.code, quiet.err.as_str(), quiet.out), (Some(0), "", warned.out));
    let failed = jaka(["-q", "call", "power_on", "-r", "127.0.0.1"]);
    assert!(failed.err.starts_with("error: `power_on` was not sent"), "{failed:?}");
    assert_eq!(jaka(["call", "-q", "-v", "power_on", "--sim"]).code, Some(2));
}

#[cfg(unix)]
#[test]
fn quiet_does_not_hide_that_a_command_may_have_run() {
    let controller = Arm::real_time().without_power().start();
    for words in [["-q", "call", "power_on", "--yes"], ["call", "power_on", "--yes", "-q"]] {
        controller.inject(Fault::Drop);
        let before = controller.requests().len();
        let mut command = command(words.map(str::to_owned).into_iter().chain(address_of(&controller)));
        let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program starts");
        assert!(controller.wait_for_requests(before + 1, LONG), "the command comes");
        crate::common::interrupt(&child);
        expect![[r"
            error: interrupted: `power_on` may have run; check the robot's state before you go on
            exit code 4
        "]]
        .assert_eq(&result(child).text());
    }
}

#[test]
fn colours_are_used_where_they_are_asked_for() {
    let failed = |words: &[&str], no_color: &str| {
        let mut command = command(words);
        run(
            {
                command.env("NO_COLOR", no_color);
                command
            },
            "",
        )
        .err
    };
    let line = ["status", "--sim", "--fields", "nothing"];
    for (option, no_color) in [("auto", ""), ("never", ""), ("auto", "1")] {
        let err = failed(&[&line[..], &["--color", option]].concat(), no_color);
        assert!(err.starts_with("error: there is no status field `nothing`"), "{err}");
    }
    for words in [&["--color=always"][..], &["--color", "always"]] {
        let err = failed(&[words, &line].concat(), "1");
        assert!(err.starts_with("\u{1b}[1m\u{1b}[31merror:\u{1b}[0m there is no status field"), "{err:?}");
    }
    // Also where the line cannot be parsed, and in help.
    let err = failed(&["status", "--color", "always", "--filds", "x"], "");
    assert!(err.starts_with("\u{1b}[1m\u{1b}[31merror:\u{1b}[0m there is no option `--filds`"), "{err:?}");
    let help = jaka(["call", "joint_move", "--help", "--color=always"]).out;
    assert!(help.contains("\u{1b}["), "{help}");
    assert!(!jaka(["status", "--help", "--color=never"]).out.contains('\u{1b}'));
}
