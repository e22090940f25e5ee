//! Ends of `jaka follow`.

use std::fs;

use expect_test::expect;
use jaka_motion::Model;
use jaka_motion::proto::messages::types::Pose;
use jaka_tests::{Arm, LONG};
use serde_json::Value;

use super::{Run, interrupted, jaka, scratch};

/// Writes a trajectory of 2 s, or this many times as long, to a file.
fn trajectory(factor: f64) -> String {
    let path = scratch("way.csv");
    let (middle, end) = (factor, 2.0 * factor);
    let text = format!(
        "time_s,joint_1_deg,joint_2_deg,joint_3_deg,joint_4_deg,joint_5_deg,joint_6_deg\n\
         0,0,90,90,90,-90,0\n{middle},4,90,90,90,-90,-6\n{end},0,90,90,90,-90,0\n"
    );
    fs::write(&path, text).expect("it can be written");
    path.display().to_string()
}

pub(super) fn words(factor: f64, options: &str) -> Vec<String> {
    let line = format!("follow {} --model zu5 --yes {options}", trajectory(factor));
    line.split_whitespace().map(str::to_owned).collect()
}

/// Returns an arm at the start of the trajectory.
fn arm() -> Arm {
    Arm::simulated().at([0.0, 90.0, 90.0, 90.0, -90.0, 0.0]).start()
}

/// Returns the JSON object printed by a run.
fn said(run: &Run) -> Value {
    serde_json::from_str(&run.out).unwrap_or_else(|_| panic!("{}", run.text()))
}

#[test]
fn a_trajectory_that_is_completed_is_reported() {
    let arm = arm();
    let run = jaka(&arm, words(1.0, "--json"));
    let mut said = said(&run);
    // The library's tests of JSON have the whole report.
    let report = said["end"]["report"].take();
    assert_eq!(report["trajectory"]["reached_s"], 2.0, "{report}");
    expect![[r#"
        {
          "end": {
            "cause": "reached",
            "error": null,
            "evidence": {
              "kind": "none"
            },
            "phase": "ended",
            "report": null,
            "rest": "packets",
            "stop": null,
            "text": "the motion has reached its target"
          }
        }"#]]
    .assert_eq(&format!("{said:#}"));
    assert_eq!(run.code, 0);
    assert!(arm.state().joint_position.0[0].abs() < 1e-6);
    assert!(!arm.state().servo_mode);
    expect![[r"
        the motion has reached its target, the arm lagged by 11 ms; of 502 set-points 99 % were at most 0.00 ms late
        exit code 0
    "]]
    .assert_eq(&jaka(&arm, words(1.0, "--scale 0.5")).text());
}

/// Tests a quarter of a circle of the tool around the axis of the first pose.
#[test]
fn points_without_times_are_followed() {
    let start = [0.0, 60.0, -80.0, 190.0, -90.0, 0.0];
    let tool = |joints: [f64; 6]| Pose::from(Model::named("Zu 5").expect("a published arm").forward(joints));
    let first = tool(start);
    let on_circle = |step: u32| {
        let (sin, cos) = (f64::from(step) * 0.0157).sin_cos();
        (first.x + 60.0 * (cos - 1.0), first.y + 60.0 * sin)
    };
    let lines = (0..=100).map(|step| {
        let (x, y) = on_circle(step);
        format!("{x},{y},{},{},{},{}\n", first.z, first.rx, first.ry, first.rz)
    });
    let path = scratch("seam.csv");
    fs::write(&path, format!("x_mm,y_mm,z_mm,rx_deg,ry_deg,rz_deg\n{}", lines.collect::<String>())).expect("written");
    let arm = Arm::simulated().at(start).start();
    let line = format!("follow {} --model zu5 --yes --within-mm 0.2 --tool-speed 100 --json", path.display());
    let run = jaka(&arm, line.split_whitespace());
    assert_eq!((run.code, &said(&run)["end"]["cause"]), (0, &"reached".into()), "{run:?}");
    let there = tool(arm.state().joint_position.0);
    let (x, y) = on_circle(100);
    assert!((there.x - x).hypot(there.y - y) < 0.3, "{there:?}");
}

#[test]
fn an_approach_leads_to_where_the_trajectory_starts() {
    let arm = arm();
    arm.set_state(|state| state.joint_position.0[3] = 91.0);
    expect![[r"
        error: the trajectory was not started: it starts with joint 4 at 90.000 deg, but the joint is at 91.000 deg, 1.000 deg away
        hint: `--approach` moves the arm to the start first
        exit code 20
    "]].assert_eq(&jaka(&arm, words(1.0, "")).text());
    assert!(!arm.requests().iter().any(|request| request.contains("servo_")));
    let run = jaka(&arm, words(1.0, "--approach 20 --json"));
    assert_eq!((run.code, &said(&run)["end"]["cause"]), (0, &"reached".into()), "{run:?}");
}

#[test]
fn an_interrupt_stops_the_arm_on_the_trajectory() {
    let arm = arm();
    let run = interrupted(&arm, words(30.0, ""), || {
        assert!(arm.wait_for_requests(1000, LONG), "set-points come");
    });
    expect![[r"
        note: interrupted: the arm stops on its trajectory; interrupt again to send `stop_program`, too
        error: the motion was stopped before its target (7.808 s of 60.000 s of the trajectory), and the arm is at rest
        hint: look at the arm before it moves again
        exit code 22
    "]]
    .assert_eq(&run.text());
    assert!(!arm.state().servo_mode && arm.state().at_rest);
    assert!(!arm.requests().iter().any(|request| request.contains("stop_program")));
}
