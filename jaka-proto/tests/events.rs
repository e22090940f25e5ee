//! The controller's events: their codes as controllers write them, their severities and their meanings.

use jaka_proto::messages::power::{GetRobotState, GetRobotStateReply};
use jaka_proto::messages::status::RobotStatus;
use jaka_proto::{Command as _, ControllerEvent, EventNote, Severity, read_payload};
use serde_json::json;

fn event(code: u32) -> ControllerEvent {
    ControllerEvent::new(code).expect("the code is not zero")
}

/// Counts the codes with this upper half by severity: errors, warnings, information.
fn counts(upper: u32) -> [usize; 3] {
    let mut counts = [0; 3];
    for lower in 0..=0xFFFF {
        match ControllerEvent::new(upper << 16 | lower).map(ControllerEvent::severity) {
            Some(Severity::Error) => counts[0] += 1,
            Some(Severity::Warning) => counts[1] += 1,
            Some(Severity::Information) => counts[2] += 1,
            _ => {}
        }
    }
    counts
}

/// The figures were counted in the vendor's table itself: JakaCobot.github.io, `docs/en/guide/errinfo.md`, February
/// 2024.
#[test]
fn all_events_of_the_vendors_table_have_their_severity() {
    assert_eq!(counts(0x0F), [195, 39, 1], "controller");
    assert_eq!(counts(0x10F), [10, 42, 105], "controller");
    for joint in 0x00..=0x05 {
        assert_eq!(counts(joint), [11, 2, 0], "joint {joint:#x}");
    }
    for servo in 0x10..=0x15 {
        assert_eq!(counts(servo), [46, 4, 0], "servo {servo:#x}");
    }
    assert_eq!(counts(0x20), [7, 2, 0], "extension I/O");
    assert_eq!(counts(0x30), [3, 40, 0], "control cabinet");
    assert_eq!(counts(0x3F), [3, 0, 0], "torque sensor");
    assert_eq!(counts(0x0E), [0, 69, 0], "remote interface");
}

#[test]
fn events_that_captures_and_manuals_show_have_the_severity_known_of_them() {
    let known = [
        (0x010F_0005, Severity::Information, "the robot is disabled"),
        (0x010F_0004, Severity::Information, "the robot is enabled"),
        (0x010F_0015, Severity::Information, "servo mode is on"),
        (0x010F_0016, Severity::Information, "servo mode is off"),
        (0x010F_001B, Severity::Information, "a program starts"),
        (0x010F_000B, Severity::Information, "a protective stop began after a collision"),
        (0x000F_0034, Severity::Error, "a collision was detected"),
        (0x010F_0020, Severity::Warning, "reduced mode is on"),
        (0x0005_0031, Severity::Error, "the joint is at its positive soft limit"),
        (0x000F_0029, Severity::Error, "the circular motion was not taken: its points may coincide"),
    ];
    for (code, severity, meaning) in known {
        assert_eq!((event(code).severity(), event(code).meaning()), (severity, Some(meaning)), "{code:#x}");
    }
}

#[test]
fn the_neighbours_of_known_codes_are_not_taken_for_known() {
    // The first and the last code of the table, and both sides of a gap in it.
    for (unknown, known) in
        [(0x2F, 0x30), (0x010F_0302, 0x010F_0301), (0x010F_003E, 0x010F_003D), (0x010F_003E, 0x010F_003F)]
    {
        assert_eq!((event(unknown).severity(), event(unknown).meaning()), (Severity::Unknown, None), "{unknown:#x}");
        assert_ne!(event(known).severity(), Severity::Unknown, "{known:#x}");
    }
    for code in [1, 0x1776_0261, u32::MAX] {
        assert_eq!((event(code).severity(), event(code).meaning()), (Severity::Unknown, None), "{code:#x}");
    }
}

#[test]
fn each_event_of_the_table_has_a_meaning_and_a_remedy_and_no_other_code_has() {
    let codes = (0..0x200).flat_map(|upper| (0..=0xFFFF).map(move |lower| upper << 16 | lower));
    let mut count = 0;
    for event in codes.filter_map(ControllerEvent::new) {
        let texts = [event.meaning(), event.cause().map(EventNote::text), event.remedy().map(EventNote::text)];
        if event.severity() == Severity::Unknown {
            assert_eq!(texts, [None; 3], "{event}");
        } else {
            assert!(texts[0].is_some() && texts[2].is_some(), "{event}");
            count += 1;
        }
    }
    assert_eq!(count, 894);
}

#[test]
fn a_general_cause_says_so() {
    let collision = event(0x000F_0034);
    let cause = collision.cause().expect("the family has one");
    assert!(matches!(cause, EventNote::OfFamily(_)));
    assert_eq!(
        cause.to_string(),
        format!("{} (general: the vendor's table states nothing for this code)", cause.text())
    );
    let remedy = collision.remedy().expect("the table has one");
    assert!(matches!(remedy, EventNote::OfCode(_)) && remedy.to_string() == remedy.text(), "{remedy}");
}

#[test]
fn a_code_is_read_in_every_form_of_a_status_packet() {
    let disabled = Ok(Some(event(0x010F_0005)));
    for text in ["0x10f0005", "0x10F0005", "0X10F0005", "10f0005", "0x010F0005", " 0x10f0005 ", "0x000000010f0005"] {
        assert_eq!(ControllerEvent::from_text(text), disabled, "{text}");
    }
    for text in ["0x0", "0", "", " ", "0x000000", "0X00"] {
        assert_eq!(ControllerEvent::from_text(text), Ok(None), "{text}");
    }
    assert_eq!(ControllerEvent::from_text("0xffffffff"), Ok(Some(event(u32::MAX))));
}

#[test]
fn what_is_not_a_code_is_not_taken_for_no_event() {
    for text in ["0x", "x0", "-1", "+1", "0x-1", "0x+10f0005", "none", "0x100000000", "0x10f0005;", "1 2", "0x0x1", "٣"]
    {
        let error = ControllerEvent::from_text(text).expect_err(text);
        assert_eq!(error.text, text);
    }
}

#[test]
fn an_event_says_its_code_severity_and_meaning() {
    let texts =
        [0x010F_0005, 0x000F_0034, 0x000F_0030, 0x000E_0001, 0x2F, 0x1776_0261].map(|code| event(code).to_string());
    assert_eq!(
        texts,
        [
            "0x10f0005 (information: the robot is disabled)",
            "0x0f0034 (error: a collision was detected)",
            "0x0f0030 (error: the joint speed limit is set to 0)",
            "0x0e0001 (warning: a gRPC call failed)",
            "0x00002f (severity unknown)",
            "0x17760261 (severity unknown)",
        ]
    );
    assert_eq!(format!("{:?}", event(0x010F_0005)), "ControllerEvent(0x10f0005)");
    assert_eq!(format!("[{:<11}]", Severity::Error), "[error      ]");
}

#[test]
fn hostile_text_in_place_of_a_code_does_not_reach_a_terminal() {
    let text = format!("\u{1b}[2J\u{202e}\u{9b}\n{}", "x".repeat(1000));
    let message = ControllerEvent::from_text(&text).expect_err("it is not a code").to_string();
    assert!(message.chars().all(|c| c.is_ascii() && !c.is_control()), "{message:?}");
    assert!(message.len() < 200, "{message}");
}

#[test]
fn a_status_packet_has_an_event() {
    let status = |code: Option<&str>| {
        let mut status = RobotStatus::default();
        status.error_code = code.map(str::to_owned);
        status
    };
    assert_eq!(status(Some("0x10f0005")).event(), Ok(Some(event(0x010F_0005))));
    assert_eq!(status(Some("0x0")).event(), Ok(None));
    assert_eq!(status(None).event(), Ok(None));
    assert!(status(Some("none")).event().is_err());
}

/// A reply of `get_robot_state` with this value of `errcode`.
fn robot_state(code: serde_json::Value) -> GetRobotStateReply {
    let mut reply = json!({
        "errorCode": "0", "errorMsg": "", "cmdName": "get_robot_state", "enable": "robot_enabled", "power": "powered_on",
    });
    reply["errcode"] = code;
    read_payload(GetRobotState::INFO, &reply.to_string()).expect("the reply fits")
}

#[test]
fn get_robot_state_has_the_event_as_a_number_and_as_a_text() {
    let disabled = Ok(Some(event(0x010F_0005)));
    // The number is that of a controller with firmware 1.5.14.
    for code in [json!(17_760_261), json!(17_760_261.0), json!("0x10f0005"), json!("10F0005")] {
        assert_eq!(robot_state(code.clone()).event(), disabled, "{code}");
    }
    for code in [json!(0), json!("0"), json!("0x0"), json!(""), json!("00"), json!(null)] {
        assert_eq!(robot_state(code.clone()).event(), Ok(None), "{code}");
    }
    assert_eq!(robot_state(json!("7")).event(), Ok(Some(event(7))));
}

/// `"17760261"` could be the number of the event 0x10f0005, or the digits of 0x17760261.
#[test]
fn get_robot_state_does_not_guess_what_digits_mean() {
    for code in
        [json!("17760261"), json!("10"), json!(-1), json!(4_294_967_296_u64), json!(1.5), json!([]), json!(true)]
    {
        assert!(robot_state(code.clone()).event().is_err(), "{code}");
    }
}
