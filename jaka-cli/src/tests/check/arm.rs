//! Model of the arm, and its position relative to limits.

use std::fs;

use expect_test::{Expect, expect};
use jaka_sim::{Controller, Fault, Model};
use jaka_sync::proto::messages::kinematics::GetDhParamReply;
use jaka_tests::Arm;

use super::super::scratch;
use super::{assert_found, assert_report, check, healthy};

fn zu5() -> &'static Model {
    Model::named("Zu 5").expect("a published arm")
}

/// Returns an arm of this model.
fn arm(model: Model) -> Arm {
    Arm::simulated().controller(|controller| controller.model(model)).start()
}

/// Returns the reply of a Zu 5 to `get_dh_param`, with the forearm longer by this many mm.
fn longer_by(mm: f64) -> GetDhParamReply {
    let mut reply = healthy().state().dh_parameters;
    reply.a[3] += mm;
    reply
}

fn assert_model(arm: &Arm, name: &str, expected: &Expect) {
    assert_report(&check(arm, &["--yes", "--json", "--model", name]), expected);
}

#[test]
fn a_model_that_is_named() {
    assert_model(&healthy(), "zu5", &expect![[r#""#]]);
    assert_model(
        &healthy(),
        "zu7",
        &expect![[r#"
            model: wrong: this is not a Zu 7: poses differ by up to 159.6 mm and 0.000 deg, more than 0.5 mm or 0.01 deg
              look at the arm's name plate: limits of another model do not fit this arm
        "#]],
    );
}

#[test]
fn a_calibrated_arm() {
    let calibrated = arm(zu5().with_dh(&longer_by(3.0)).expect("it is near"));
    assert_report(
        &check(&calibrated, &["--yes", "--json"]),
        &expect![[r#"
            model: look: a Zu 5, with its own parameters: the published ones differ too much
              build its model from `get_dh_param` with `Model::with_dh`
        "#]],
    );
    assert_model(
        &calibrated,
        "zu5",
        &expect![[r#"
            model: look: a Zu 5, with its own parameters: the published ones differ too much
              build its model from `get_dh_param` with `Model::with_dh`
        "#]],
    );
}

#[test]
fn every_published_arm_is_known_again() {
    for name in ["Zu 12", "MiniCobo"] {
        let arm = arm(Model::named(name).expect("a published arm").clone());
        let report = check(&arm, &["--yes"]);
        let model = report.out.lines().find(|line| line.starts_with("model")).unwrap_or_default();
        assert!(model.contains("nothing found") && model.contains(name), "{}", report.text());
    }
}

#[test]
fn other_parameters_than_those_of_the_poses() {
    assert_found(
        |controller| controller.set_state(|state| state.dh_parameters = longer_by(40.0)),
        &expect![[r#"
            dh_parameters: look: DH parameter a of joint 4 is 408.5 mm; that of the Zu 5 is 368.5 mm
              no source states their definition: the agreement of the model with the controller's poses decides
        "#]],
    );
}

#[test]
fn an_arm_beyond_its_limits() {
    let beyond = [0.0, 90.0, 176.5, 90.0, -90.0, 0.0];
    assert_found(
        |controller| controller.set_state(|state| state.joint_position = beyond.into()),
        &expect![[r#"
            limits: look: joint 3 is at 176.5 deg; limit 175 (Zu 5)
              move it back, by a motion that goes no further out, or at the pendant
        "#]],
    );
}

#[test]
fn limits_of_a_file() {
    let path = scratch("limits.toml");
    let file = path.display().to_string();
    fs::write(&path, "model = \"Zu 5\"\n[joints]\nmax_deg = [360, 80, 175, 265, 360, 360]\n")
        .expect("the folder is there");
    let report = check(&healthy(), &["--yes", "--json", "--limits", &file]);
    assert_report(
        &report,
        &expect![[r#"
        limits: look: joint 2 is at 90 deg; limit 80 (Zu 5)
          move it back, by a motion that goes no further out, or at the pendant
    "#]],
    );
    fs::write(&path, "model = \"Zu 5\"\n[tcp]\nspeed_mms = 250\n").expect("the folder is there");
    let controller = healthy();
    let report = check(&controller, &["--yes", "--limits", &file]);
    expect![[r#"
        error: limits.toml:3:1: unknown field `speed_mms`, expected `speed_mm_s` or `acceleration_mm_s2` in `tcp`
        exit code 2
    "#]]
    .assert_eq(&report.text().replace(&file, "limits.toml"));
    assert!(controller.requests().is_empty());
}

#[test]
fn poses_that_the_controller_does_not_compute() {
    let refusal = br#"{"errorCode": "2", "errorMsg": "call kine_forward failed", "cmdName": "kine_forward"}"#;
    let refuse = |times: usize| {
        move |controller: &Controller| {
            for _ in 0..times {
                controller.inject_for("kine_forward", Fault::Instead(refusal.to_vec()));
            }
        }
    };
    // The arm may refuse positions beyond its ranges: the check then queries those of another model.
    assert_found(refuse(1), &expect![[r#""#]]);
    assert_found(
        refuse(8),
        &expect![[r#"
        model: look: the controller refused `kine_forward` with code 2: call kine_forward failed
          read it at the pendant: this controller does not answer the query
    "#]],
    );
}
