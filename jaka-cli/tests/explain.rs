//! `jaka explain`: events by code, and refusals by their words.

use expect_test::expect;

use crate::program::{jaka, pack};

fn text(arguments: &[&str]) -> String {
    jaka(["explain"].iter().chain(arguments).copied().map(str::to_owned)).text()
}

#[test]
fn a_code_is_read_in_each_form() {
    let collision = text(&["0x0F0034"]);
    expect![[r"
        0x0F0034 (error), event of the controller
          meaning: a collision was detected
          cause: a safety function was triggered, or a safety signal or a safety setting changed (general: no source states it for this code)
          remedy: look for obstacles around the arm and for signs of a collision; check whether the robot's serial number and model are recognised correctly; check the settings of payload and mounting angle
          family: safety
        exit code 0
    "]]
    .assert_eq(&collision);
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
fn a_drive_names_its_joint_and_chinese_is_a_language() {
    expect![[r"
        0x020030 (warning), event of the controller
          含义: 该关节的速度超过其限值
          关节: 3
          原因: 通常是控制器下发的指令速度高于该关节的实际限速
          措施: 检查机械臂的速度限制是否被人为调高；如被调高，联系厂商技术支持；如未改动，降低速度或加速度限制；仍出现时导出诊断信息并联系厂商技术支持
          类别: joint
        exit code 0
    "]]
    .assert_eq(&text(&["0x020030", "--lang", "zh"]));
}

#[test]
fn a_refusal_leads_to_its_known_causes() {
    let refused = text(&["call", "joint_move", "failed"]);
    expect![[r"
        errorCode 2, CallFailed
          The command failed; the message says more, or only that: of a motion, the target may be beyond the arm's ranges or out of reach.
          Often `call … failed` with the command's name: in a transcript, for malformed arguments, and of `kine_inverse` where it finds no
          solution. It is likely, not certain, that a wrong state has the same answer, such as `joint_move` while the robot is not enabled.
        `joint_move`
          needs: the robot must be powered, enabled and outside servo mode; `jaka status` shows whether it is
          known cause: Malformed arguments (transcript).
          known cause: A target beyond the ranges of the joints (the vendor's event `0x0F0011`).
        exit code 0
    "]]
    .assert_eq(&refused);
    let reply = r#"{"errorCode": "2", "errorMsg": "call joint_move failed", "cmdName": "joint_move"}"#;
    assert_eq!(text(&[reply]), refused);
    let message = "servoj command can only be excuted in servo move mode";
    assert!(text(&[message]).starts_with("errorCode -1, Rejected\n"));
    assert!(text(&[message]).contains("in servo mode; `jaka status`"));
    assert!(text(&["--", "-1"]).starts_with("errorCode -1, Rejected\n"));
    assert!(text(&["-1"]).starts_with("errorCode -1, Rejected\n"));
}

#[test]
fn what_no_source_has_is_said() {
    expect![[r"
        error: the code 0x12345 is not in the spec; newer firmware has codes that no table lists, and it may be an error
        exit code 2
    "]]
    .assert_eq(&text(&["0x12345"]));
    expect![[r"
        error: `hello` is not a code, nor a refusal of the spec; examples: the code 0x0F0034, the refusal `call joint_move failed`
        exit code 2
    "]]
    .assert_eq(&text(&["hello"]));
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
