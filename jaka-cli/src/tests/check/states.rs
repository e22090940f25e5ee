//! States and settings of the arm, firmware, and single queries that fail.

use std::time::Duration;

use expect_test::{Expect, expect};
use jaka_sim::proto::messages::program::ProgramState;
use jaka_sim::{Controller, Fault, State, StatusFault};
use serde_json::{Value, json};

use super::super::Run;
use super::{assert_each_found, check, healthy};

/// Plants each state in an arm of its own, and compares all findings.
fn assert_states(changes: &[&dyn Fn(&mut State)], expected: &Expect) {
    let faults: Vec<_> = changes
        .iter()
        .map(|change| move |controller: &Controller| controller.set_state(|state| change(state)))
        .collect();
    let faults: Vec<&dyn Fn(&Controller)> = faults.iter().map(|fault| fault as _).collect();
    assert_each_found(&faults, expected);
}

#[test]
fn power_and_enabling() {
    assert_states(
        &[
            &|state| state.powered = false,
            &|state| state.enabled = false,
            // An emergency stop ends enabling, and is the only finding.
            &|state| state.emergency_stop = true,
            &|state| state.protective_stop = true,
        ],
        &expect![[r#"
            power: look: the arm has no power
              switch it on: `power_on`
            enabled: look: the arm is not enabled
              enable it: `enable_robot`
            emergency_stop: wrong: the emergency stop is pressed
              release it when nobody is at the arm, and enable the arm
            protective_stop: wrong: the robot is in a protective stop
              find the obstacle, free the arm, and call `clear_error`
        "#]],
    );
}

#[test]
fn events() {
    let event = |code: &'static str, message: &'static str| {
        move |state: &mut State| (state.error_code, state.error_message) = (code.to_owned(), message.to_owned())
    };
    assert_states(
        &[
            &event("0xf0034", "collision"),
            &event("0x10f0020", ""),
            &event("0xabcdef", "a\u{1b}[2J"),
            &event("over", ""),
            &event("0x10f0004", "information is nothing to look at"),
        ],
        &expect![[r#"
            event: wrong: 0x0f0034 (error: a collision was detected), "collision"
              remove its cause: the pendant and the vendor's table of events explain it
            event: look: 0x10f0020 (warning: reduced mode is on)
              look it up in the vendor's table of events, or at the pendant
            event: look: 0xabcdef (severity unknown), "a\u{1b}[2J"
              look it up in the vendor's table of events, or at the pendant
            event: look: the event code "over" is not a number such as 0x10f0005
              look at the pendant
        "#]],
    );
}

#[test]
fn modes_and_programs() {
    assert_states(
        &[
            &|state| state.servo_mode = true,
            &|state| state.drag_mode = true,
            &|state| state.program_state = ProgramState::Running,
            &|state| state.program_state = ProgramState::Paused,
            &|state| state.program_state = ProgramState::Other("reverse".to_owned()),
        ],
        &expect![[r#"
            servo_mode: look: on
              other motions are refused: leave it with `set_servo_mode`, if no other program needs it
            drag_mode: look: on
              a hand can move the arm: switch it off at the pendant or at the arm
            program: look: a program runs
              it may move the arm: stop it first, or wait for its end
            program: look: a program is paused
              it may move the arm when somebody resumes it: `stop_program` ends it
            program: look: unknown state "reverse"
              look at the pendant
        "#]],
    );
}

#[test]
fn settings() {
    assert_states(
        &[
            &|state| state.tool_frame_id = 3,
            &|state| state.user_frame_id = 5,
            &|state| state.payload.mass = 0.0,
            &|state| state.rapid_rate = 0.5,
            &|state| state.rapid_rate = 0.0,
            &|state| state.collision_level = 0,
            &|state| state.on_soft_limit = 1,
        ],
        &expect![[r#"
            tool_frame: look: 3, with an offset of zero
              it is the same as frame 0: set its offset, or select frame 0
            user_frame: look: 5, with an offset of zero
              it is the same as frame 0: set its offset, or select frame 0
            payload: look: 0 kg
              set the load of the arm with the gripper: `set_payload`
            rapid_rate: look: 0.5 of 1
              motions run at another speed than requested: set it with `set_rapid_rate`
            rapid_rate: wrong: 0 of 1
              no motion moves the arm: set it with `set_rapid_rate`
            collision_level: look: 0: collision detection is off
              switch it on: `set_clsn_sensitivity`
            soft_limit: look: hit (`on_soft_limit` is 1)
              find the joint, and jog it back
        "#]],
    );
}

#[test]
fn firmware() {
    let version = |text: &'static str| {
        move |controller: &Controller| controller.set_reply("get_version", [("version".to_owned(), json!(text))])
    };
    assert_each_found(
        &[&version("1.4.12_X86"), &version("4.0.1"), &version("\u{1b}[2J")],
        &expect![[r#"
            firmware: look: 1.4.12_X86, older than 1.5.14, the oldest that was captured
              compare its answers with the spec before you rely on them: `jaka probe` does it
            firmware: look: 4.0.1, newer than 3.2.10, the newest that is known
              compare its answers with the spec before you rely on them: `jaka probe` does it
            firmware: look: `\u{1b}[2J` is not a firmware version such as 1.6.5_01_X86
              compare its answers with the spec before you rely on them: `jaka probe` does it
        "#]],
    );
}

#[test]
fn a_query_without_an_answer() {
    let refusal = br#"{"errorCode": "2", "errorMsg": "call get_payload failed", "cmdName": "get_payload"}"#;
    let fault = |fault: Fault| move |controller: &Controller| controller.inject_for("get_payload", fault.clone());
    assert_each_found(
        &[
            &fault(Fault::Instead(refusal.to_vec())),
            &|controller| controller.set_reply("get_payload", [("mass".to_owned(), json!("heavy"))]),
            &fault(Fault::Drop),
            // Later items are not checked.
            &fault(Fault::Close),
        ],
        &expect![[r#"
            payload: look: the controller refused `get_payload` with code 2: call get_payload failed
              read it at the pendant: this controller does not answer the query
            payload: look: `get_payload` was not refused, but its reply does not fit the spec: field `mass`: expected a number, found `"heavy"`
              read it at the pendant; `jaka probe` shows the reply
            payload: look: no reply to `get_payload` within 5s
              check the network and the load of the controller, then run the check again
            payload: wrong: the connection broke at `get_payload`: the controller closed the connection
              the command port serves one client: look for another program that is connected to it, and end that one
        "#]],
    );
}

#[test]
fn packets() {
    let shown = |key: &'static str, value: Value| {
        move |controller: &Controller| controller.set_status([(key.to_owned(), value.clone())])
    };
    assert_each_found(
        &[
            &shown("current_tool_id", json!(15)),
            &shown("emergency_stop", json!("perhaps")),
            &shown("rapidrate", json!("fast")),
            &shown("rapidrate", json!(null)),
        ],
        &expect![[r#"
            tool_frame: look: 15, without an offset from the controller
              look at its offset at the pendant: poses refer to this frame
            status_packets: wrong: cannot be read: field `emergency_stop`: expected a truth value, found `"perhaps"`
              a `Robot` refuses motions while it cannot tell whether the arm is stopped: `jaka probe` compares the packet with the spec
            status_packets: look: cannot be read: field `rapid_rate`: expected a number, found `"fast"`
              `jaka probe` compares the packet with the spec
            status_packets: look: missing: rapid_rate
              `jaka probe` compares the packet with the spec
        "#]],
    );
}

#[test]
fn slow_packets() {
    let controller = healthy();
    controller.status_fault(StatusFault::Slow(Duration::from_millis(400)));
    let report = check(&controller, &["--yes"]);
    expect![[r#"
        status rate      look           2 packets in a second; 10 to 33 are usual
                                        check the network, and how often the controller sends (`get_port10000_delay_ms` on newer firmware)"#]].assert_eq(&lines_of(&report, "status rate"));
    assert_eq!(report.code, 8);
}

#[test]
fn slow_replies() {
    let controller = healthy();
    controller.inject_always(Fault::Delay(Duration::from_millis(30)));
    let report = check(&controller, &["--yes"]);
    expect![[r#"
        round trip       look           67 queries: 50 % within 30.0ms, 99 % within 30.0ms
                                        connect by cable, without Wi-Fi and busy switches: set-points of servo mode are due each 8 ms, and a session ends when 100 ms of them are not answered"#]].assert_eq(&lines_of(&report, "round trip"));
    assert_eq!(report.code, 8);
}

/// Returns the lines of a report about an item.
fn lines_of(report: &Run, item: &str) -> String {
    report.out.lines().skip_while(|line| !line.starts_with(item)).take(2).collect::<Vec<_>>().join("\n")
}
