//! A link that stalls, delays or is cut, and controllers that are odd: no false end of a motion, no set-point that runs
//! after its session, no stop that is lost. The arm itself is the witness: the simulator says where it is, and whether
//! it is at rest.

use std::time::Duration;

use jaka_robot::motion::{JointMove, MoveL};
use jaka_robot::types::{MoveMode, Pose};
use jaka_robot::{
    Cause, Config, End, Error, ErrorKind, Evidence, Phase, Remedy, Rest, Robot, RobotConfig, RobotStop, ServoConfig,
    jaka_sync,
};
use jaka_sim::{Delays, Fault, Port, StatusFault};
use jaka_tests::simulated::beside;
use jaka_tests::{Arm, ArmBuilder, CYCLE, Configured as _, LONG, text};

fn arm() -> ArmBuilder {
    Arm::simulated().status_period(Duration::from_millis(30))
}

/// A robot for which packets of a minute ago are fresh, so that the test alone decides what is stale.
fn ready() -> (Arm, Robot) {
    let (arm, robot) = arm().config(|config| config.stale_after(LONG)).with_robot();
    (arm, robot.configured(&RobotConfig::new().status_silence(LONG)).expect("it has no limits"))
}

fn joint_1(arm: &Arm) -> f64 {
    arm.state().joint_position.0[0]
}

fn to(angle: f64, speed: f64) -> JointMove {
    let joint_position = [angle, 90.0, 90.0, 90.0, -90.0, 0.0];
    JointMove::absolute(joint_position, speed).acceleration(300.0)
}

fn up(millimetres: f64, speed: f64) -> MoveL {
    let pose = Pose { x: 0.0, y: 0.0, z: millimetres, rx: 0.0, ry: 0.0, rz: 0.0 };
    MoveL::relative(pose, speed).acceleration(800.0)
}

/// The arm is where it was sent and moves no more, now.
fn assert_there(arm: &Arm, end: &End, angle: f64) {
    assert!(end.cause() == Cause::Reached, "{:?} at {}", end.cause(), joint_1(arm));
    let state = arm.state();
    assert!((joint_1(arm) - angle).abs() < 0.1 && state.tcp_speed == 0.0, "at {}", joint_1(arm));
}

#[test]
fn old_status_after_a_stall_ends_no_motion() {
    let (arm, mut robot) = ready();
    // What the link holds is from before the motion: in position.
    let clock = arm.clock();
    arm.link(Port::Status).to_client().hold();
    clock.sleep(Duration::from_millis(300));
    robot.start(&to(50.0, 40.0)).expect("the command port is fine");
    let release = || {
        clock.sleep(Duration::from_millis(400));
        arm.link(Port::Status).to_client().release();
    };
    let end = beside(clock, release, || robot.wait(LONG));
    assert_there(&arm, &end, 50.0);
}

#[test]
fn a_constant_delay_of_the_status_ends_no_motion() {
    let (arm, mut robot) = ready();
    arm.link(Port::Status).to_client().delay(Duration::from_millis(800));
    let height = arm.state().tcp_pose.z;
    let end = robot.run(&up(60.0, 50.0), LONG).expect("it is reachable");
    let state = arm.state();
    assert!(end.cause() == Cause::Reached && state.tcp_speed == 0.0, "{:?} at {:?}", end.cause(), state.tcp_pose);
    assert!((state.tcp_pose.z - height - 60.0).abs() < 0.5);
    let end = robot.run(&to(40.0, 40.0), LONG).expect("it is reachable");
    assert_there(&arm, &end, 40.0);
}

#[test]
fn a_cartesian_or_relative_motion_that_is_stopped_by_others_is_not_reached() {
    let (arm, mut robot) = ready();
    let stop = robot.client().stop_handle();
    let start = arm.state().tcp_pose.z;
    let clock = arm.clock();
    let stop_where = |is_there: &(dyn Fn() -> bool + Sync)| {
        while !is_there() {
            clock.sleep(Duration::from_millis(8));
        }
        stop.stop().expect("the controller takes the stop");
    };
    let is_up = || arm.state().tcp_pose.z >= start + 15.0;
    let end = beside(clock, || stop_where(&is_up), || robot.run(&up(100.0, 50.0), LONG));
    let end = end.expect("it is reachable");
    assert!(end.cause() == Cause::Stopped, "{:?}", end.cause());
    assert!(arm.state().tcp_pose.z < start + 90.0);
    robot.acknowledge();
    let offset = {
        let mut changed = to(0.0, 40.0);
        changed.mode = MoveMode::Relative;
        changed.joint_position = [40.0, 0.0, 0.0, 0.0, 0.0, 0.0].into();
        changed
    };
    let is_turned = || joint_1(&arm) >= 8.0;
    let end = beside(clock, || stop_where(&is_turned), || robot.run(&offset, LONG));
    assert!(end.expect("it is reachable").cause() == Cause::Stopped);
}

#[test]
fn relative_motions_in_a_queue_end_at_rest_and_claim_no_target() {
    let (arm, mut robot) = ready();
    let height = arm.state().tcp_pose.z;
    robot.start(&up(10.0, 60.0)).expect("it is reachable");
    robot.start(&up(10.0, 60.0)).expect("it is reachable");
    let end = robot.wait(LONG);
    assert!(end.cause() == Cause::AtRest, "{:?}", end.cause());
    assert!((arm.state().tcp_pose.z - height - 20.0).abs() < 0.01);
    assert!(end.at_rest().is_ok());
}

#[test]
fn a_motion_that_was_not_sent_by_the_robot_is_not_waited_for() {
    let (arm, mut robot) = ready();
    robot.client().joint_move(&to(40.0, 40.0)).expect("it is reachable");
    let end = robot.wait(LONG);
    assert!(end.cause() == Cause::NoMotion, "{:?}", end.cause());
    assert!(joint_1(&arm) < 40.0);
    assert!(end.reached().is_err_and(|error| error.to_string().contains("nothing to wait for")));
}

#[test]
fn a_frame_that_changes_meanwhile_leaves_a_pose_unknown() {
    let (_arm, mut robot) = ready();
    robot.start(&up(10.0, 60.0)).expect("it is reachable");
    robot.client().set_tool_id(1).expect("there is such a frame");
    let end = robot.wait(LONG);
    assert!(end.cause() == Cause::AtRest, "{:?}", end.cause());
    // Joints have no frame.
    robot.start(&to(5.0, 60.0)).expect("it is reachable");
    robot.client().set_tool_id(0).expect("there is such a frame");
    assert!(robot.wait(LONG).cause() == Cause::Reached);
}

#[test]
fn one_query_confirms_a_motion() {
    let (arm, mut robot) = ready();
    for angle in [5.0, -5.0, 5.0] {
        let before = arm.requests().len();
        assert_there(&arm, &robot.run(&to(angle, 90.0), LONG).expect("it is reachable"), angle);
        let queries = arm.requests()[before..].iter().filter(|request| request.contains("get_")).count();
        assert_eq!(queries, 1);
    }
}

#[test]
fn a_late_answer_delays_an_end_and_nothing_else() {
    let (arm, mut robot) = ready();
    arm.inject_for("get_joint_pos", Fault::Delay(Duration::from_millis(700)));
    assert_there(&arm, &robot.run(&to(5.0, 60.0), LONG).expect("it is reachable"), 5.0);
    // The deadline is kept, and the next wait takes the answer over.
    arm.inject_for("get_joint_pos", Fault::Hold);
    let since = arm.clock().now();
    let end = robot.run(&to(15.0, 60.0), Duration::from_secs(2)).expect("it is reachable");
    assert_eq!((end.cause(), end.phase()), (Cause::Unanswered, Phase::MayStillMove), "{end}");
    assert_eq!(arm.clock().now() - since, Duration::from_secs(2));
    let queries = |requests: Vec<String>| requests.iter().filter(|request| request.contains("get_joint_pos")).count();
    let asked = queries(arm.requests());
    arm.release();
    assert_there(&arm, &robot.wait(LONG), 15.0);
    assert!(queries(arm.requests()) <= asked + 1, "one is outstanding at most");
}

#[test]
fn a_position_that_cannot_be_asked_for_is_never_reached() {
    let (arm, mut robot) = ready();
    let refusal = br#"{"errorCode": "2", "errorMsg": "call get_joint_pos failed", "cmdName": "get_joint_pos"}"#;
    for _ in 0..20 {
        arm.inject_for("get_joint_pos", Fault::Instead(refusal.to_vec()));
    }
    let end = robot.run(&to(5.0, 60.0), LONG).expect("it is reachable");
    assert_eq!((end.cause(), end.rest, end.phase()), (Cause::Refused, Rest::Packets, Phase::Ended), "{end}");
    assert!(end.error.as_ref().is_some_and(Error::is_refused));
    let text = end.reached().expect_err("it is not known").to_string();
    assert!(text.contains("get_joint_pos"), "{text}");
}

#[test]
fn no_motion_is_sent_while_the_status_is_stale_or_gone() {
    let (arm, mut robot) = arm().config(|config| config.stale_after(Duration::from_millis(200))).with_robot();
    arm.link(Port::Status).to_client().hold();
    arm.clock().sleep(Duration::from_millis(300));
    let before = arm.requests().len();
    let error = robot.run(&to(5.0, 60.0), LONG).expect_err("nobody knows how the arm is");
    assert!(matches!(error.kind(), ErrorKind::StatusUnknown { .. }) && !error.may_have_run(), "{error:?}");
    assert!(
        robot
            .enter_servo_mode(ServoConfig::new())
            .is_err_and(|error| matches!(error.kind(), ErrorKind::StatusUnknown { .. }))
    );
    // Nor is a question sent, such as that of where a motion by an offset begins.
    let offset = JointMove::relative([5.0, 0.0, 0.0, 0.0, 0.0, 0.0], 60.0);
    let error = robot.run(&offset, LONG).expect_err("nobody knows how the arm is");
    assert!(matches!(error.kind(), ErrorKind::StatusUnknown { .. }) && !error.may_have_run(), "{error:?}");
    assert_eq!(arm.requests().len(), before);
    // A program that says that it does without is not kept back.
    let mut robot = robot.configured(&RobotConfig::new().allow_motion_without_status()).expect("it has no limits");
    robot.start(&to(5.0, 60.0)).expect("it is reachable");
    arm.link(Port::Status).to_client().release();

    let (arm, mut robot) = self::arm().with_robot();
    arm.status_fault(StatusFault::CloseAfter(0));
    arm.clock().sleep(Duration::from_millis(60));
    assert!(robot.monitor().disconnect_cause().is_some());
    let error = robot.start(&to(5.0, 60.0)).expect_err("nobody knows how the arm is");
    assert_eq!(error.remedy(), Remedy::Connection(jaka_sync::Remedy::ConnectStatusAgain), "{error}");
}

#[test]
fn a_stop_key_that_does_not_fit_keeps_the_arm_from_moving() {
    for unfit in [r#""emergency_stop": "pressed?""#, r#""protective_stop": 7"#, r#""enabled": "perhaps""#] {
        let (arm, mut robot) = ready();
        arm.status_fault(StatusFault::Silent);
        let packet = format!(r#"{{"len": 100, "powered_on": 1, "inpos": true, "rapidrate": "100%", {unfit}}}"#);
        arm.send_status(packet.as_bytes());
        let is_it = |status: &jaka_robot::status::RobotStatus| status.joint_actual_position.is_none();
        robot.monitor().wait_until(is_it, LONG).expect("the packet comes");
        let before = arm.requests().len();
        let error = robot.start(&to(5.0, 60.0)).expect_err("whether the arm is stopped is not known");
        assert!(matches!(error.kind(), ErrorKind::StatusUnknown { .. }), "{unfit}: {error:?}");
        assert_eq!(arm.requests().len(), before, "{unfit}");
        // One that matters to no stop keeps nothing back.
        arm.send_status(br#"{"len": 100, "powered_on": 1, "enabled": true, "inpos": true, "drag_status": 2}"#);
        robot.monitor().wait_until(|status| status.enabled == Some(true), LONG).expect("the packet comes");
        robot.start(&to(5.0, 60.0)).expect("the state is known");
    }
}

#[test]
fn a_wait_whose_packets_cannot_be_read_says_so() {
    let (arm, robot) = ready();
    let mut robot =
        robot.configured(&RobotConfig::new().status_silence(Duration::from_millis(300))).expect("it has no limits");
    robot.start(&to(40.0, 20.0)).expect("it is reachable");
    arm.status_fault(StatusFault::Instead(br#"{"len": 40, "inpos": true, "protective_stop": 7}"#.to_vec()));
    let end = robot.wait(LONG);
    assert!(matches!(end.evidence(), Evidence::Status { unreadable: Some(_), .. }), "{:?}", end.cause());
    assert!(end.to_string().contains("protective_stop"), "{end}");
}

#[test]
fn a_status_without_in_position_still_shows_an_end() {
    let (arm, mut robot) = ready();
    arm.status_fault(StatusFault::Instead(br#"{"len": 40, "powered_on": 1, "enabled": true}"#.to_vec()));
    let end = robot.run(&to(8.0, 60.0), LONG).expect("it is reachable");
    assert_there(&arm, &end, 8.0);
}

#[test]
fn servo_mode_that_is_acknowledged_and_not_entered_is_an_error() {
    let (arm, mut robot) = ready();
    let not_in = br#"{"errorCode": "0", "errorMsg": "", "in_servomove": false, "cmdName": "is_in_servomove"}"#;
    for _ in 0..1000 {
        arm.inject_for("is_in_servomove", Fault::Instead(not_in.to_vec()));
    }
    let entered = robot.enter_servo_mode(ServoConfig::new().enter_timeout(Duration::from_millis(300)));
    let error = entered.expect_err("the controller says that it is not in servo mode");
    assert!(
        matches!(error.kind(), ErrorKind::NotReady { .. }) && error.to_string().contains("did not enter"),
        "{error}"
    );
    assert!(!arm.state().servo_mode);
    assert!(arm.requests().iter().any(|request| request == r#"{"cmdName":"servo_move","relFlag":0}"#));
}

#[test]
fn servo_mode_that_the_controller_says_is_still_on_has_not_been_left() {
    let (arm, mut robot) = ready();
    let session = robot.enter_servo_mode(ServoConfig::new()).expect("the arm is at rest");
    let still_in = br#"{"errorCode": "0", "errorMsg": "", "in_servomove": true, "cmdName": "is_in_servomove"}"#;
    for _ in 0..1000 {
        arm.inject_for("is_in_servomove", Fault::Instead(still_in.to_vec()));
    }
    let since = arm.clock().now();
    let error = session.land().expect_err("the controller says that it is in servo mode");
    let ErrorKind::ServoModeNotLeft { first: None, leaving } = error.kind() else { panic!("{error:?}") };
    assert!(matches!(leaving.kind(), ErrorKind::NotReady { .. }), "{leaving:?}");
    // It is asked each 8 ms for a second.
    assert_eq!(arm.clock().now() - since, Duration::from_secs(1) + CYCLE);
}

#[test]
fn two_concurrent_stops_keep_the_next_motion_back_until_both_are_reported() {
    let (arm, mut robot) = ready();
    let stops = [robot.stop_handle(), robot.stop_handle()];
    for round in 0..30 {
        let target = if round % 2 == 0 { 30.0 } else { -30.0 };
        robot.start(&to(target, 60.0)).expect("it is reachable");
        let stop = |stop: &RobotStop| stop.stop().expect("the controller takes the stop");
        let both = || beside(arm.clock(), || stop(&stops[0]), || stop(&stops[1]));
        let started = beside(arm.clock(), both, || {
            let end = robot.wait(LONG);
            assert!(end.cause() == Cause::Stopped, "{:?}", end.cause());
            robot.start(&to(-target, 60.0)).is_ok()
        });
        let requests = arm.requests();
        let last = |name: &str| requests.iter().rposition(|request| request.contains(name));
        // It was refused; or sent after both stops; or one was called after it, and then the wait says so.
        if started && last("stop_program") > last("joint_move") {
            let end = robot.wait(LONG);
            assert!(end.cause() == Cause::Stopped, "round {round}: {:?}, {requests:?}", end.cause());
        }
        stops[0].stop().expect("the controller takes the stop");
        robot.acknowledge();
    }
}

/// Largest travel of joint 1 during a time, in degrees.
fn moves_on(arm: &Arm, for_time: Duration) -> f64 {
    let (from, clock) = (joint_1(arm), arm.clock());
    let since = clock.now();
    let mut furthest: f64 = 0.0;
    while clock.now() - since < for_time {
        furthest = furthest.max((joint_1(arm) - from).abs());
        clock.sleep(Duration::from_millis(5));
    }
    furthest
}

#[test]
fn set_points_do_not_accumulate_on_a_link_that_is_held() {
    const STEP: f64 = 0.04;
    let (arm, mut robot) = ready();
    let mut session = robot.enter_servo_mode(ServoConfig::new()).expect("the arm is at rest");
    let slow = |session: &mut jaka_robot::ServoSession<'_>| session.send_joint_offset([STEP, 0.0, 0.0, 0.0, 0.0, 0.0]);
    for _ in 0..20 {
        slow(&mut session).expect("answers come");
    }
    arm.links().hold();
    let error = (0..2000).find_map(|_| slow(&mut session).err()).expect("nothing is answered");
    assert!(matches!(error.kind(), ErrorKind::ServoModeNotLeft { .. }) && error.is_disconnected(), "{error:?}");
    let text = error.to_string();
    assert!(text.contains("servo mode may be on") && text.contains("no stop can be sent"), "{text}");
    assert!(slow(&mut session).is_err_and(|error| matches!(error.kind(), ErrorKind::SessionEnded { .. })));
    let report = session.land();
    assert!(report.as_ref().is_err_and(|error| matches!(error.kind(), ErrorKind::SessionEnded { .. })), "{report:?}");
    arm.links().release();
    // 100 ms are twelve set-points; those of before the stall are done when the first of these begins.
    assert!(moves_on(&arm, Duration::from_secs(1)) <= 12.0 * STEP + 0.01);
}

/// The stall lasts 2.5 s. The witness is the arm: it has only the set-points of the first 100 ms of it to follow.
#[test]
fn pipelines_of_another_handle_hide_no_stall() {
    const STEP: f64 = 0.04;
    let (arm, mut robot) = ready();
    let mut other = robot.client().try_clone().expect("the connection is there");
    let mut session = robot.enter_servo_mode(ServoConfig::new()).expect("the arm is at rest");
    let step = |session: &mut jaka_robot::ServoSession<'_>| session.send_joint_offset([STEP, 0.0, 0.0, 0.0, 0.0, 0.0]);
    for _ in 0..20 {
        step(&mut session).expect("answers come");
    }
    arm.link(Port::Command).hold();
    let clock = arm.clock();
    let pipelines = || {
        for _ in 0..125 {
            drop(other.pipeline(1));
            clock.sleep(Duration::from_millis(20));
        }
        arm.link(Port::Command).release();
    };
    let mut go = || (0..2000).find_map(|_| step(&mut session).err());
    let error = beside(clock, pipelines, &mut go).expect("nothing is answered for a while");
    assert!(matches!(error.kind(), ErrorKind::ServoModeNotLeft { .. }) && error.is_disconnected(), "{error:?}");
    assert!(moves_on(&arm, Duration::from_secs(1)) <= 12.0 * STEP + 0.01);
}

#[test]
fn a_link_that_stalls_for_a_moment_ends_the_session_and_leaves_servo_mode() {
    let (arm, mut robot) = ready();
    let mut session = robot.enter_servo_mode(ServoConfig::new()).expect("the arm is at rest");
    arm.link(Port::Command).hold();
    let clock = arm.clock();
    let release = || {
        clock.sleep(Duration::from_millis(400));
        arm.link(Port::Command).release();
    };
    let mut go = || (0..2000).find_map(|_| session.send_joint_offset([0.02; 6]).err()).expect("nothing is answered");
    let error = beside(clock, release, &mut go);
    assert!(matches!(error.kind(), ErrorKind::SetPointsUnanswered { .. }) && error.may_have_run(), "{error:?}");
    drop(session);
    assert!(!arm.state().servo_mode);
    robot.client().get_version().expect("the connection lives");
}

#[test]
fn set_points_end_with_the_status() {
    let (arm, mut robot) = arm().config(|config| config.stale_after(Duration::from_millis(300))).with_robot();
    let mut session = robot.enter_servo_mode(ServoConfig::new().max_unanswered(LONG)).expect("the arm is at rest");
    arm.link(Port::Status).to_client().hold();
    let error = (0..2000).find_map(|_| session.send_joint_offset([0.001; 6]).err()).expect("the status is stale");
    assert!(matches!(error.kind(), ErrorKind::StatusUnknown { .. }), "{error:?}");
    assert!(!arm.state().servo_mode);
}

#[test]
fn servo_mode_is_left_where_entering_it_was_not_answered() {
    for fault in [Fault::Drop, Fault::Delay(Duration::from_millis(600))] {
        let impatient = |config: Config| config.reply_timeout(Duration::from_millis(300)).stale_after(LONG);
        let (arm, mut robot) = arm().config(impatient).with_robot();
        arm.inject_for("servo_move", fault.clone());
        let error = robot.enter_servo_mode(ServoConfig::new()).expect_err("its reply does not come in time");
        assert!(error.may_have_run(), "{fault}: {error:?}");
        let is_left = !arm.state().servo_mode;
        assert!(is_left || matches!(error.kind(), ErrorKind::ServoModeNotLeft { .. }), "{fault}: {error:?}");
        // The late reply of the first is not taken for that of the second.
        let requests = arm.requests();
        assert!(requests.iter().any(|request| request == r#"{"cmdName":"servo_move","relFlag":0}"#), "{requests:?}");
    }
}

#[test]
fn the_first_set_point_is_checked_against_where_the_arm_is_in_servo_mode() {
    let (arm, mut robot) = ready();
    let session = robot.enter_servo_mode(ServoConfig::new()).expect("the arm is at rest");
    drop(session);
    let requests = arm.requests();
    let first = |part: &str| requests.iter().position(|request| request.contains(part)).expect("it was sent");
    let last = |part: &str| requests.iter().rposition(|request| request.contains(part)).expect("it was sent");
    // Before it, whether the arm is at rest; in it, where it is.
    assert!(first("get_joint_pos") < first("servo_move"), "{requests:?}");
    assert!(first("is_in_servomove") < last("get_joint_pos"), "{requests:?}");
    let error = robot.enter_servo_mode(ServoConfig::new().step_count(1000)).expect_err("a period of 8 s");
    assert!(error.is_invalid_argument(), "{error:?}");
}

#[test]
fn servo_mode_is_not_asked_for_while_the_arm_moves() {
    let (arm, mut robot) = ready();
    robot.start(&to(20.0, 40.0)).expect("it is reachable");
    let error = robot.enter_servo_mode(ServoConfig::new()).expect_err("a motion has not been waited for");
    assert!(matches!(error.kind(), ErrorKind::NotReady { .. }), "{error:?}");
    assert!(!arm.requests().iter().any(|request| request.contains("servo_move")));
    assert_there(&arm, &robot.wait(LONG), 20.0);
    // A motion that somebody else has sent is waited for.
    let mut other = arm.client();
    let monitor = robot.monitor().clone();
    let packets = monitor.subscribe(1000);
    other.joint_move(&to(30.0, 5.0)).expect("it is reachable");
    let packet_of_motion =
        |_| packets.next_packet_within(LONG).expect("packets come").status.in_position == Some(false);
    assert!((0..1000).any(packet_of_motion), "the arm moves");
    drop(robot);
    let mut robot = Robot::new(arm.client(), monitor).expect("it is the only robot");
    drop(robot.enter_servo_mode(ServoConfig::new()).expect("the arm has come to rest"));
    assert!((joint_1(&arm) - 30.0).abs() < 0.01);
}

#[test]
fn power_up_keeps_its_time_and_says_what_is_in_its_way() {
    let slow = arm().controller(|arm| arm.delays(Delays::REAL)).config(|config| config.stale_after(LONG));
    let (arm, mut robot) = slow.without_power().with_robot();
    let error = robot.power_up(Duration::from_millis(500)).expect_err("it takes seconds");
    assert!(error.is_timeout(), "{error:?}");
    let text = error.to_string();
    assert!(!text.contains("no status packet"), "{text}");

    arm.press_emergency_stop();
    robot.monitor().wait_until(|status| status.emergency_stop == Some(true), LONG).expect("the status says it");
    let before = arm.requests().len();
    let error = robot.power_up(LONG).expect_err("the emergency stop is pressed");
    assert!(error.to_string().contains("emergency stop is pressed"), "{error}");
    assert_eq!(arm.requests().len(), before, "nothing was sent");
    // Packets that say something else are told apart from none.
    let error = robot.monitor().wait_until(|status| status.enabled == Some(true), Duration::from_secs(1));
    let error = error.expect_err("it is not enabled");
    assert!(
        matches!(error.kind(), jaka_sync::ErrorKind::StateTimeout { .. })
            && error.to_string().contains("emergency stop"),
        "{error}"
    );
}

#[test]
fn refusals_are_explained_by_the_state_of_now() {
    let (arm, mut robot) = ready();
    arm.link(Port::Status).to_client().hold();
    // The status still says enabled.
    arm.set_state(|state| state.enabled = false);
    let error = robot.client().joint_move(&to(5.0, 60.0)).expect_err("the arm is not enabled");
    assert_eq!(robot.explain(&error).map(|reason| reason.cause), Some(Cause::NotEnabled));
    arm.set_state(|state| state.powered = false);
    let error = robot.client().joint_move(&to(5.0, 60.0)).expect_err("the arm has no power");
    assert_eq!(robot.explain(&error).map(|reason| reason.cause), Some(Cause::NotPowered));
    // And where it is powered by now, old packets do not say that it is not.
    arm.link(Port::Status).to_client().release();
    robot.monitor().wait_until(|status| status.powered_on == Some(false), LONG).expect("packets come again");
    arm.link(Port::Status).to_client().hold();
    arm.set_state(|state| {
        state.powered = true;
        state.enabled = true;
    });
    let refusal = br#"{"errorCode": "2", "errorMsg": "call joint_move failed", "cmdName": "joint_move"}"#;
    arm.inject_for("joint_move", Fault::Instead(refusal.to_vec()));
    let error = robot.client().joint_move(&to(5.0, 60.0)).expect_err("refused for another reason");
    assert!(robot.explain(&error).is_none());
}

#[test]
fn packets_that_are_stale_explain_no_refusal() {
    let (arm, mut robot) = arm().with_robot();
    arm.set_state(|state| state.protective_stop = true);
    robot.monitor().wait_until(|status| status.protective_stop == Some(true), LONG).expect("packets come");
    arm.link(Port::Status).to_client().hold();
    arm.clock().sleep(Duration::from_secs(1));
    arm.set_state(|state| (state.protective_stop, state.enabled) = (false, false));
    // Typed motions are kept back: the stop was not acknowledged.
    let error = robot.client().call_text(&text(&to(5.0, 60.0)), LONG).map(drop).expect_err("the arm is not enabled");
    assert_eq!(robot.explain(&error).map(|reason| reason.cause), Some(Cause::NotEnabled));
}
