//! Questions and warnings to a person on a terminal, which `script` of util-linux gives the program.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]
#![cfg(target_os = "linux")]

use expect_test::{Expect, expect};
use jaka_sim::Controller;
use jaka_tests::Arm;

use crate::program::address_of;
use crate::pseudo::on_terminal;

/// Runs a line on a controller, with this answer, and compares what is shown.
fn check(controller: &Controller, line: &str, answer: &str, expected: &Expect) {
    let line = format!("{line} {}", address_of(controller).join(" "));
    let Some((shown, code)) = on_terminal(&line, answer) else { return };
    expected.assert_eq(&format!("{shown}exit code {}", code.unwrap_or(-1)));
}

#[test]
fn a_question_says_what_the_arm_will_do() {
    let controller = Arm::real_time().start();
    let asked = |line: &str, expected: &Expect| check(&controller, line, "n\n", expected);
    asked(
        "up",
        &expect![[r#"
            The arm of 127.0.0.1 will get power and be enabled: its brakes release.
              {"cmdName":"power_on"}
              {"cmdName":"enable_robot"}
            The command port serves one client: another program that is connected there may be disconnected.
            Go on? [y/N] error: `power_on` and `enable_robot` were not sent
            exit code 2"#]],
    );
    asked(
        "down",
        &expect![[r#"
            The arm of 127.0.0.1 will be disabled and lose its power.
              {"cmdName":"disable_robot"}
              {"cmdName":"power_off"}
            The command port serves one client: another program that is connected there may be disconnected.
            Go on? [y/N] error: `disable_robot` and `power_off` were not sent
            exit code 2"#]],
    );
    asked(
        "clear",
        &expect![[r#"
            The arm of 127.0.0.1 will leave its protective stop, after which it can be moved again.
              {"cmdName":"clear_error"}
            The command port serves one client: another program that is connected there may be disconnected.
            Go on? [y/N] error: `clear_error` was not sent
            exit code 2"#]],
    );
    asked(
        "move --joints 0,90,80,90,-90,0 --speed 10 --model zu5",
        &expect![[r#"
            The arm of 127.0.0.1 will go to the joint positions 0, 90, 80, 90, -90, 0 deg: joint 3, which turns furthest (-10 deg), at 10 deg/s scaled by the rapid rate, with an acceleration of 72 deg/s².
              {"cmdName":"joint_move","relFlag":0,"jointPosition":[0,90,80,90,-90,0],"speed":10,"accel":72}
            The command port serves one client: another program that is connected there may be disconnected.
            Go on? [y/N] error: `joint_move` was not sent
            exit code 2"#]],
    );
    asked(
        "move --pose -400,100,450,180,0,90 --speed 50 --acceleration 200",
        &expect![[r#"
            The arm of 127.0.0.1 will move its tool centre point in a straight line to -400, 100, 450 mm (x, y, z) and 180, 0, 90 deg (rx, ry, rz), at 50 mm/s scaled by the rapid rate, with an acceleration of 200 mm/s².
              {"cmdName":"moveL","relFlag":0,"cartPosition":[-400,100,450,180,0,90],"speed":50,"accel":200}
            The command port serves one client: another program that is connected there may be disconnected.
            Go on? [y/N] error: `moveL` was not sent
            exit code 2"#]],
    );
    asked(
        "jog 6 5 --speed 5",
        &expect![[r#"
            The arm of 127.0.0.1 will turn joint 6 by 5 deg, from 0 to 5 deg, at 5 deg/s scaled by the rapid rate, with the controller's own acceleration.
              {"cmdName":"joint_move","relFlag":1,"jointPosition":[0,0,0,0,0,5],"speed":5}
            The command port serves one client: another program that is connected there may be disconnected.
            Go on? [y/N] error: `joint_move` was not sent
            exit code 2"#]],
    );
    asked(
        "jog z -10 --speed 20",
        &expect![[r#"
            The arm of 127.0.0.1 will move its tool centre point by -10 mm along z of the selected user frame, at 20 mm/s scaled by the rapid rate, with the controller's own acceleration.
              {"cmdName":"moveL","relFlag":1,"cartPosition":[0,0,-10,0,0,0],"speed":20}
            The command port serves one client: another program that is connected there may be disconnected.
            Go on? [y/N] error: `moveL` was not sent
            exit code 2"#]],
    );
    assert!(controller.requests().is_empty());
}

#[test]
fn a_question_about_a_command_has_its_fields_with_units() {
    let controller = Arm::real_time().start();
    let asked = |line: &str, expected: &Expect| check(&controller, line, "n\n", expected);
    asked(
        "call joint_move --mode relative --joint-position 1,0,0,0,0,0 --speed 10",
        &expect![[r#"
            To 127.0.0.1:
              {"cmdName":"joint_move","relFlag":1,"jointPosition":[1,0,0,0,0,0],"speed":10}
            `joint_move` starts, stops or continues a motion or a program. Moves all joints to a position, or by an offset, at a joint speed (MoveJ).
              mode            Relative (1)
              joint_position  1, 0, 0, 0, 0, 0 deg
              speed           10 deg/s
            The command port serves one client: another program that is connected there may be disconnected.
            Send it? [y/N] error: `joint_move` was not sent
            exit code 2"#]],
    );
    asked(
        "call jog --jog-mode continuous --frame joint --axis 0 --velocity 1",
        &expect![[r#"
            To 127.0.0.1:
              {"cmdName":"jog","jog_mode":1,"coord_map":1,"jnum":0,"jogvel":1}
            `jog` starts, stops or continues a motion or a program. Moves one joint, or one Cartesian coordinate of the tool centre point, continuously, by an increment or to a position.
              jog_mode  Continuous (1)
              frame     Joint (1)
              axis      0
              velocity  1 deg/s for a joint or a rotation, mm/s for a translation
            The command port serves one client: another program that is connected there may be disconnected.
            Send it? [y/N] error: `jog` was not sent
            exit code 2"#]],
    );
    asked(
        "call set_payload --mass 1.2 --centroid 0,0,40",
        &expect![[r#"
        To 127.0.0.1:
          {"cmdName":"set_payload","mass":1.2,"centroid":[0,0,40]}
        `set_payload` changes a setting or an output. Sets the mass and the centroid of the payload.
          mass        1.2 kg
          centroid.x  0 mm
          centroid.y  0 mm
          centroid.z  40 mm
        The command port serves one client: another program that is connected there may be disconnected.
        Send it? [y/N] error: `set_payload` was not sent
        exit code 2"#]],
    );
    assert!(controller.requests().is_empty());
}

#[test]
fn what_is_beyond_a_limit_is_refused_before_a_question() {
    let controller = Arm::real_time().start();
    let refused = |line: &str, expected: &Expect| check(&controller, line, "", expected);
    refused(
        "move --joints 0,90,176,90,-90,0 --speed 10 --model zu5",
        &expect![[r#"
            error: `joint_move` was not sent: joint 3 would be at 176 deg; limit 175 (Zu 5)
            exit code 20"#]],
    );
    refused(
        "jog 3 86 --speed 10 --model zu5",
        &expect![[r#"
            error: `joint_move` was not sent: joint 3 would be at 176 deg; limit 175 (Zu 5)
            exit code 20"#]],
    );
    refused(
        "jog 3 8 --speed 190 --model zu5",
        &expect![[r#"
            error: `joint_move` was not sent: joint 3 would turn at 190 deg/s; limit 180 (Zu 5)
            hint: joint motions take deg/s, tool lines mm/s; 190 may be meant in mm/s
            exit code 20"#]],
    );
    refused(
        "jog 3 8 --speed 500",
        &expect![[r#"
            error: `joint_move` was not sent: field `speed` is 500, allowed is more than 0, at most 265 deg/s
            hint: joint motions take deg/s, tool lines mm/s; 500 may be meant in mm/s
            exit code 2"#]],
    );
    refused(
        "call joint_move --mode relative --joint-position 1,0,0,0,0,0 --speed 500",
        &expect![[r#"
            error: `joint_move` was not sent:
              field `speed` is 500.0; allowed is a number, more than 0, at most 265 deg/s; this is advisory
            hint: joint motions take deg/s, tool lines mm/s; 500 may be meant in mm/s
            hint: `--advisory-ranges ignore` leaves the check to the controller
            exit code 2"#]],
    );
    assert!(controller.requests().is_empty());
}

#[test]
fn whoever_takes_the_seat_is_asked_or_warned() {
    let controller = Arm::real_time().start();
    check(
        &controller,
        "check",
        "n\n",
        &expect![[r#"
            The command port of 127.0.0.1 serves one client. Another program that is connected there may be disconnected, and the arm may stop or keep moving, depending on the setting of the controller (4.75).
            Connect? [y/N] error: nothing was checked: the answer was not yes
            exit code 2"#]],
    );
    check(
        &controller,
        "probe",
        "n\n",
        &expect![[r#"
            The command port of 127.0.0.1 serves one client. Another program that is connected there may be disconnected, and the arm may stop or keep moving, depending on the setting of the controller (4.75).
            Connect? [y/N] error: nothing was probed: the answer was not yes
            exit code 2"#]],
    );
    check(
        &controller,
        "jitter --seconds 0.1",
        "n\n",
        &expect![[r#"
            The command port of 127.0.0.1 serves one client. Another program that is connected there may be disconnected, and the arm may stop or keep moving, depending on the setting of the controller (4.75).
            Connect? [y/N] error: nothing was measured: the answer was not yes
            exit code 2"#]],
    );
    assert!(controller.requests().is_empty());
    check(
        &controller,
        "call get_joint_pos",
        "",
        &expect![[r#"
            warning: the command port serves one client: another program that is connected there may be disconnected
            joint_position  0, 90, 90, 90, -90, 0 deg
            exit code 0"#]],
    );
    for line in ["call get_joint_pos -q", "call get_joint_pos --yes", "call stop_program", "stop"] {
        let line = format!("{line} {}", address_of(&controller).join(" "));
        let Some((shown, code)) = on_terminal(&line, "") else { return };
        assert!(code == Some(0) && !shown.contains("serves one client"), "{line}: {shown}");
    }
}
