//! `jaka explain`: each way to give a code or a refusal. `transcripts/explain.txt` has what is said of them.

use crate::program::{jaka, pack};

fn text(arguments: &[&str]) -> String {
    jaka(["explain"].iter().chain(arguments).copied().map(str::to_owned)).text()
}

#[test]
fn a_code_is_read_in_each_form() {
    let collision = text(&["0x0F0034"]);
    for same in ["0x0f0034", "0X000f0034", "0F0034", "983092"] {
        assert_eq!(text(&[same]), collision, "{same}");
    }
}

/// 131120 is 0x020030 in decimal digits.
#[test]
fn digits_alone_are_read_both_ways() {
    assert!(text(&["131120"]).starts_with("0x020030 (warning)"));
    assert!(text(&["020030"]).starts_with("0x020030 (warning)"));
    assert!(text(&["0E0001"]).starts_with("0x0E0001 (warning)"));
}

#[test]
fn a_refusal_leads_to_its_known_causes() {
    let refused = text(&["call", "joint_move", "failed"]);
    let reply = r#"{"errorCode": "2", "errorMsg": "call joint_move failed", "cmdName": "joint_move"}"#;
    assert_eq!(text(&[reply]), refused);
    let message = "servoj command can only be excuted in servo move mode";
    assert!(text(&[message]).starts_with("errorCode -1, Rejected\n"));
    assert!(text(&[message]).contains("in servo mode; `jaka status`"));
    assert!(text(&["--", "-1"]).starts_with("errorCode -1, Rejected\n"));
    assert!(text(&["-1"]).starts_with("errorCode -1, Rejected\n"));
}

#[test]
fn what_is_no_refusal_is_said() {
    let lexium = "permission deny, please check remote control source";
    assert!(text(&[lexium]).starts_with("errorCode 3, PermissionDenied\n"));
    // Words of the explanations are no refusals.
    for word in ["joint_move", "servo_j", "power_on", "kine_inverse", "failed", "cmdName"] {
        let unknown = text(&[word]);
        assert!(
            unknown.starts_with(&format!("error: `{word}` is not a code, nor a refusal of the spec; ")),
            "{unknown}"
        );
    }
    assert!(text(&["--pack", &pack("newer.toml"), "0x0F0034"]).contains("a collision was detected"));
}
