//! `jaka call --stdin`: lines of JSON over one connection.

use std::process::{Child, Stdio};

use expect_test::{Expect, expect};
use jaka_sim::{Controller, Fault};
use jaka_tests::{Arm, LONG};

#[cfg(unix)]
use crate::common::interrupt;
use crate::program::{Run, address_of, command, result, run};

fn lines(controller: &Controller, options: &str, input: &str) -> Run {
    let words = ["call", "--stdin"].into_iter().chain(options.split_whitespace()).map(str::to_owned);
    run(command(words.chain(address_of(controller))), input)
}

fn check(run: &Run, expected: &Expect) {
    expected.assert_eq(&run.text());
}

#[test]
fn each_line_gets_a_line() {
    let controller = Arm::real_time().start();
    let input = r#"
        {"cmdName": "get_joint_pos"}
        {"cmdName": "get_tcp_pos"}

        {"cmdName": "set_digital_output", "type": 0, "index": 2, "value": 1}
        {"cmdName": "get_payload"}
        {"cmdName": "get_extio_status"}"#;
    check(
        &lines(&controller, "--yes", input),
        &expect![[r#"
            {"command":"get_joint_pos","reply":{"joint_position":[0.0,90.0,90.0,90.0,-90.0,0.0]}}
            {"command":"get_tcp_pos","reply":{"pose":{"rx":180.0,"ry":0.0,"rz":90.0,"x":-482.0,"y":114.0,"z":443.15}}}
            {"command":"set_digital_output","reply":{}}
            {"command":"get_payload","reply":{"centroid":{"x":0.0,"y":0.0,"z":1.0},"mass":1.0}}
            {"command":"get_extio_status","reply":{"extio_status":{"count":1,"modules":[{"pin_map":{"analog_inputs":0,"analog_outputs":0,"digital_inputs":0,"digital_outputs":0},"setup":[1,"modbusIoName",["192.168.2.47",8888],{"ai":[0,0],"ao":[0,0],"di":[0,8],"do":[0,0]}]}],"state":{"digital_inputs":[false,false,false,false,false,false,false,false,false],"running":false}}}}
            exit code 0
        "#]],
    );
    assert_eq!(controller.requests().len(), 5);
}

#[test]
fn the_first_failure_ends_it_unless_it_is_to_go_on() {
    let input = [
        r#"{"cmdName":"get_version"}"#,
        r#"{"cmdName":"rapid_rate","rate_value":7}"#,
        "nonsense",
        r#"{"cmdName":"get_versio"}"#,
        r#"{"cmdName":"rapid_rate","rate_value":0.5}"#,
        r#"{"cmdName":"get_rapid_rate"}"#,
    ];
    let input = input.join("\n");
    check(
        &lines(&Arm::real_time().start(), "--yes", &input),
        &expect![[r#"
            {"command":"get_version","reply":{"version":"1.5.14_13_X64"}}
            {"command":"rapid_rate","error":"`rapid_rate` was not sent:\n  field `rate` is 7; allowed is a number, 0 to 1","exit_code":2}
            error: `rapid_rate` was not sent:
              field `rate` is 7; allowed is a number, 0 to 1
            exit code 2
        "#]],
    );
    check(
        &lines(&Arm::real_time().start(), "--yes --keep-going", &input),
        &expect![[r#"
            {"command":"get_version","reply":{"version":"1.5.14_13_X64"}}
            {"command":"rapid_rate","error":"`rapid_rate` was not sent:\n  field `rate` is 7; allowed is a number, 0 to 1","exit_code":2}
            {"error":"the request is not a JSON object: expected ident at line 1 column 2","exit_code":2}
            {"command":"get_versio","error":"there is no command `get_versio`; did you mean `get_version`?\nhint: `jaka call --list` lists the commands; --pack adds commands, and --raw sends a command that is not in the spec","exit_code":2}
            {"command":"rapid_rate","reply":{}}
            {"command":"get_rapid_rate","error":"the controller refused `get_rapid_rate` with code 1: Exception:function call failed\nThe code's meaning: An exception arose in the controller's program.","exit_code":1}
            error: `rapid_rate` was not sent:
              field `rate` is 7; allowed is a number, 0 to 1
            exit code 2
        "#]],
    );
    let controller = Arm::real_time().start();
    let refused = lines(&controller, "", r#"{"cmdName":"power_off"}"#);
    check(
        &refused,
        &expect![[r#"
        {"command":"power_off","error":"`power_off` was not sent: it switches power, brakes or the controller itself; use --yes to send such commands from standard input","exit_code":2}
        error: `power_off` was not sent: it switches power, brakes or the controller itself; use --yes to send such commands from standard input
        exit code 2
    "#]],
    );
    assert!(controller.requests().is_empty());
}

#[test]
fn a_refusal_and_a_lost_reply_are_told_apart() {
    let controller = Arm::real_time().start();
    controller.set_state(|state| state.enabled = false);
    let motion = r#"{"cmdName":"joint_move","relFlag":0,"jointPosition":[5,90,90,90,-90,0],"speed":90}"#;
    check(
        &lines(&controller, "--yes", motion),
        &expect![[r#"
        {"command":"joint_move","error":"the controller refused `joint_move` with code 2: call joint_move failed\nThe reason: the arm is not enabled","exit_code":1}
        error: the controller refused `joint_move` with code 2: call joint_move failed
        The reason: the arm is not enabled
        hint: when somebody has looked at the arm, `jaka up` powers and enables it
        exit code 1
    "#]],
    );
    controller.inject(Fault::Drop);
    let lost = lines(&controller, "--yes --timeout 1", r#"{"cmdName":"get_version"}"#);
    check(
        &lost,
        &expect![[r#"
        {"command":"get_version","error":"no reply to `get_version` within 1s; it may have run","exit_code":4}
        error: no reply to `get_version` within 1s; it may have run
        exit code 4
    "#]],
    );
}

#[test]
fn motions_are_waited_for() {
    let controller = Arm::real_time().start();
    let to = |angle: i32| {
        format!(
            "{{\"cmdName\":\"joint_move\",\"relFlag\":0,\"jointPosition\":[{angle},90,90,90,-90,0],\"speed\":90}}\n"
        )
    };
    let run =
        lines(&controller, "--yes --wait", &[to(5), "{\"cmdName\":\"get_joint_pos\"}\n".to_owned(), to(0)].concat());
    assert_eq!(run.code, Some(0), "{run:?}");
    let answers: Vec<serde_json::Value> =
        run.out.lines().map(|line| serde_json::from_str(line).expect("it is JSON")).collect();
    assert_eq!((&answers[0]["command"], &answers[0]["end"]["cause"]), (&"joint_move".into(), &"reached".into()));
    assert_eq!(answers[1]["reply"]["joint_position"][0].as_f64().map(f64::round), Some(5.0));
    assert_eq!(answers[2]["end"]["cause"], "reached");
    controller.collide();
    let run = lines(&controller, "--yes --wait", &to(5));
    assert_eq!(run.code, Some(20), "{run:?}");
    assert!(run.out.contains("\"exit_code\":20"), "{run:?}");
}

#[cfg(unix)]
#[test]
fn an_interrupt_between_lines_ends_it() {
    use std::io::{BufRead, BufReader, Write};
    let controller = Arm::real_time().start();
    let words = ["call", "--stdin"].map(str::to_owned).into_iter().chain(address_of(&controller));
    let mut command = command(words);
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child: Child = command.spawn().expect("the program starts");
    let mut input = child.stdin.take().expect("it is piped");
    writeln!(input, "{{\"cmdName\":\"get_version\"}}").expect("it reads");
    let mut line = String::new();
    BufReader::new(child.stdout.take().expect("it is piped")).read_line(&mut line).expect("it answers");
    assert!(line.contains("\"version\""), "{line}");
    assert!(controller.wait_for_requests(1, LONG));
    interrupt(&child);
    expect![[r"
        error: interrupted; no command is outstanding
        exit code 130
    "]]
    .assert_eq(&result(child).text());
}
