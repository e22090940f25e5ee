//! Ends of motions as JSON, with their reports and the evidence for their causes.

use std::sync::Arc;
use std::time::Duration;

use expect_test::{Expect, expect};
use jaka_proto::ControllerEvent;
use jaka_proto::wire::DecodeError;
use jaka_robot::jaka_motion::{Limits, Model, TimedPoint, Trajectory};
use jaka_robot::motion::JointMove;
use jaka_robot::{
    Cause, CauseGroup, Disconnect, Error, ErrorKind, Evidence, FollowConfig, MotionExt as _, NotShown, Numbering,
    Phase, RobotConfig, ServoModeState, TripReason,
};
use jaka_tests::simulated::{beside, until};
use jaka_tests::{Arm, Configured as _, LONG};
use serde_json::{to_string, to_string_pretty, to_value};

const HERE: [f64; 6] = [0.0, 90.0, 90.0, 90.0, -90.0, 0.0];

fn check(written: serde_json::Result<String>, expected: &Expect) {
    expected.assert_eq(&written.expect("it is written"));
}

#[test]
fn an_end_of_a_motion_has_the_names_of_its_parts() {
    let (_arm, mut robot) = Arm::simulated().with_robot();
    let turn = JointMove::absolute([5.0, 90.0, 90.0, 90.0, -90.0, 0.0], 10.0).acceleration(60.0);
    let end = robot.run(&turn, LONG).expect("the arm is ready");
    check(
        to_string_pretty(&end),
        &expect![[r#"
        {
          "cause": "reached",
          "text": "the motion has reached its target",
          "phase": "ended",
          "rest": "answers",
          "evidence": {
            "kind": "none"
          },
          "error": null,
          "stop": null,
          "report": {
            "waited_s": 0.69,
            "cycles": 0,
            "late_cycles": 0,
            "gaps": 0,
            "longest_gap_s": 0.0,
            "landing_cycles": 0,
            "accepted": 0,
            "refused": 0,
            "unanswered": 0,
            "most_outstanding": 0,
            "absent": [],
            "frames": {
              "tool": 0,
              "user": 0
            },
            "rapid_rate": 1.0,
            "trajectory": null,
            "lateness": null
          }
        }"#]],
    );
}

#[test]
fn an_end_by_a_guard_has_its_trip() {
    let (arm, mut robot) = Arm::simulated().status_period(Duration::from_millis(10)).with_robot();
    let far = JointMove::absolute([100.0, 90.0, 90.0, 90.0, -90.0, 0.0], 25.0).acceleration(500.0);
    let high = || {
        until(arm.clock(), || arm.state().joint_position.0[0] >= 1.0);
        arm.set_state(|state| state.digital_inputs[0] = true);
    };
    let guarded = far.guard(Numbering::FromOne.cabinet(1).rises());
    let end = beside(arm.clock(), high, || robot.run(&guarded, LONG).expect("the motion is accepted"));
    let end = to_value(&end).expect("it is written");
    assert_eq!((&end["cause"], &end["phase"]), (&"guard".into(), &"ended".into()));
    check(
        to_string(&[&end["evidence"], &end["stop"]]),
        &expect![[
            r#"[{"condition":0,"is_at_rest":true,"is_before_start":false,"kind":"trip","lag":null,"reaction_s":0.0,"reason":{"kind":"holds"},"text":"digital input 1 of the cabinet (counted from 1) goes high"},{"error":null,"is_accepted":true}]"#
        ]],
    );
}

#[test]
fn an_end_of_a_trajectory_has_its_progress_and_its_lag() {
    let (_arm, robot) = Arm::simulated().at(HERE).with_robot();
    let limits = Limits::of(Model::named("Zu 5").expect("a published arm"));
    let mut robot = robot.configured(&RobotConfig::new().limits(limits)).expect("it is this arm");
    let aside = [5.0, 90.0, 90.0, 90.0, -90.0, 0.0];
    let points = [TimedPoint::new(0.0, HERE), TimedPoint::new(1.0, aside), TimedPoint::new(2.0, HERE)];
    let trajectory = Trajectory::timed(&points, robot.limits().expect("it has some")).expect("within limits");
    let run = robot.start_follow(&trajectory, &FollowConfig::new()).expect("the arm is there");
    let handle = run.handle();
    let end = run.wait();
    let mut end = to_value(&end).expect("it is written");
    let waited = end["report"]["waited_s"].take();
    assert!(waited.as_f64() >= Some(2.0), "{waited}");
    let lag = &mut end["report"]["trajectory"]["lag"];
    for joints in ["residual_deg", "worst_deg"] {
        let joints = lag[joints].take();
        assert!(joints.as_array().is_some_and(|joints| joints.len() == 6), "{joints}");
    }
    check(
        to_string_pretty(&end["report"]),
        &expect![[r#"
        {
          "absent": [],
          "accepted": 258,
          "cycles": 252,
          "frames": {
            "tool": 0,
            "user": 0
          },
          "gaps": 0,
          "landing_cycles": 6,
          "late_cycles": 0,
          "lateness": {
            "max_s": 0.0,
            "p50_s": 0.0,
            "p90_s": 0.0,
            "p99_s": 0.0
          },
          "longest_gap_s": 0.0,
          "most_outstanding": 1,
          "rapid_rate": 1.0,
          "refused": 0,
          "trajectory": {
            "duration_s": 2.0,
            "has_left_curve": false,
            "lag": {
              "delay_s": 0.011,
              "packets": 68,
              "residual_deg": null,
              "worst_deg": null
            },
            "reached_s": 2.0
          },
          "unanswered": 0,
          "waited_s": null
        }"#]],
    );
    check(to_string(&handle.progress()), &expect![[r#"{"time_s":2.0,"duration_s":2.0,"rate":0.0}"#]]);
}

#[test]
fn evidence_is_an_object_of_its_kind() {
    let cause = || Arc::new(Disconnect::Closed { partial: 0 });
    let event = ControllerEvent::from_text("0x0f0030").expect("a number");
    let unfit = DecodeError::unfit("a number", "a").in_field("din");
    let all = [
        Evidence::None,
        Evidence::Event { code: "0x0F0030".to_owned(), event, message: "joint 1".to_owned() },
        Evidence::Event { code: "odd".to_owned(), event: None, message: String::new() },
        Evidence::ServoMode { state: ServoModeState::OnAlready },
        Evidence::Commands { address: "arm:10001".to_owned(), cause: cause() },
        Evidence::Status { cause: Some(cause()), unreadable: None },
        Evidence::Status { cause: None, unreadable: Some(unfit.clone()) },
    ];
    let lines = all.iter().map(|evidence| to_string(evidence).expect("it is written") + "\n");
    expect![[r#"
        {"kind":"none"}
        {"kind":"event","code":"0x0F0030","event":{"severity":"error","meaning":"the joint speed limit is set to 0"},"message":"joint 1"}
        {"kind":"event","code":"odd","event":null,"message":""}
        {"kind":"servo_mode","state":"on_already"}
        {"kind":"commands","address":"arm:10001","cause":"the controller closed the connection"}
        {"kind":"status","cause":"the controller closed the connection","unreadable":null}
        {"kind":"status","cause":null,"unreadable":"field `din`: expected a number, found `a`"}
    "#]].assert_eq(&lines.collect::<String>());
    let reasons = [
        TripReason::Holds,
        TripReason::NotShown(NotShown::Unfit { source: unfit }),
        TripReason::NotShown(NotShown::TooShort { field: "din".to_owned(), count: 2 }),
        TripReason::NotShown(NotShown::SensorOff),
        TripReason::Panicked,
    ];
    check(
        to_string(&reasons),
        &expect![[
            r#"[{"kind":"holds"},{"kind":"not_shown","reason":{"kind":"unfit","source":"field `din`: expected a number, found `a`"}},{"kind":"not_shown","reason":{"kind":"too_short","field":"din","count":2}},{"kind":"not_shown","reason":{"kind":"sensor_off"}},{"kind":"panicked"}]"#
        ]],
    );
}

#[test]
fn causes_have_their_names_and_errors_their_causes() {
    for cause in Cause::ALL {
        assert_eq!(to_value(cause).expect("it is written"), cause.name());
    }
    check(to_string(&(CauseGroup::Done, Phase::MayHaveRun)), &expect![[r#"["done","may_have_run"]"#]]);
    let error = Error::from(ErrorKind::NotShown { what: "the force".to_owned(), reason: NotShown::SensorOff });
    check(
        to_string(&error),
        &expect![[
            r#"{"cause":"not_shown","text":"it is not known whether the force: the sensor does not report that it works","may_have_run":false,"evidence":{"kind":"none"}}"#
        ]],
    );
}
