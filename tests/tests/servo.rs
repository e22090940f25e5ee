//! Servo sessions against the simulator, at the real pace.

use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Duration;

use jaka_sim::{Controller, Delays, Fault};
use jaka_sync::servo::SetServoMoveFilter;
use jaka_sync::status::RobotStatus;
use jaka_sync::types::{JointPosition, Pose, Switch};
use jaka_sync::{Client, Config, ErrorCode, ErrorKind, Explanation, Monitor, Robot, ServoConfig};

fn ready() -> (Controller, Robot) {
    let mut delays = Delays::NONE;
    delays.servo_mode = Delays::REAL.servo_mode;
    let controller = Controller::builder().delays(delays).start().expect("loopback has free ports");
    controller.set_state(|state| {
        state.powered = true;
        state.enabled = true;
    });
    let monitor: Monitor = Config::new().connect_monitor(controller.status_addr()).expect("the controller listens");
    monitor
        .wait_until(|status| status.enabled == Some(true), Duration::from_secs(30))
        .expect("packets come by themselves");
    let client = Client::connect(controller.command_addr()).expect("the controller listens");
    (controller, Robot::new(client, monitor))
}

/// The last set-points are under way when they have been answered, and are given up when servo mode is left.
fn arrives(controller: &Controller, is_there: impl Fn(&RobotStatus) -> bool) {
    let monitor: Monitor = Config::new().connect_monitor(controller.status_addr()).expect("the controller listens");
    monitor.wait_until(is_there, Duration::from_secs(30)).expect("the arm follows the set-points");
}

const LEFT: &str = r#"{"cmdName":"servo_move","relFlag":0}"#;

/// The last request that is not a query.
fn last_change(requests: &[String]) -> &str {
    let queries = ["is_in_servomove", "get_joint_pos", "get_robot_state"];
    let is_query = |request: &&String| queries.iter().any(|query| request.contains(query));
    requests.iter().rev().find(|request| !is_query(request)).expect("something was changed")
}

/// On a busy machine answers may take their time. Set-points may jump.
fn patient() -> ServoConfig {
    ServoConfig::new().max_unanswered(Duration::from_secs(60)).unchecked()
}

const STEP: [f64; 6] = [0.1, 0.0, 0.0, 0.0, 0.0, -0.1];

/// Set-points of so long a time that what must be noticed is noticed, however busy the machine is: 40 s.
const CYCLES: usize = 5000;

/// Another program's set-points and ours together would make the arm jump.
#[test]
fn a_session_does_not_begin_where_servo_mode_is_on() {
    let (controller, mut robot) = ready();
    controller.set_state(|state| state.servo_mode = true);
    let error = robot.enter_servo_mode(&patient()).expect_err("it is on");
    assert!(matches!(error.kind(), ErrorKind::NotReady { explanation: Explanation::ServoModeOn }), "{error}");
    assert!(controller.state().servo_mode, "what another program needs is left as it is");
    assert!(
        !controller.requests().iter().any(|request| request.contains("servo_move")),
        "nothing was sent to change it"
    );
    robot.client().set_servo_mode(Switch::Off).expect("it is left");
    drop(robot.enter_servo_mode(&patient()).expect("it is off"));
}

#[test]
fn every_set_point_is_sent_in_order_and_answered() {
    let (controller, mut robot) = ready();
    let start = controller.state().joint_position.0;
    let filter = SetServoMoveFilter::joint_low_pass(0.5);
    let mut session = robot.enter_servo_mode(&patient().filter(filter)).expect("the arm is enabled");
    assert!(controller.state().servo_mode);
    for _ in 0..100 {
        session.send_joint_offset(STEP).expect("servo mode is on");
    }
    arrives(&controller, |status| {
        status.joint_actual_position.is_some_and(|at| (at.0[0] - start[0] - 10.0).abs() < 1e-6)
    });
    let report = session.land().expect("all were accepted");
    assert_eq!((report.cycles, report.refused, report.unanswered), (100, 0, 0));
    assert_eq!(report.accepted, 100 + report.landing_cycles);
    assert!(report.lateness(0.5) <= report.lateness(1.0));
    assert_eq!(controller.state().servo_filter, filter);
    let sent = controller.requests();
    assert_eq!(last_change(&sent), LEFT);
    let place = |part: &str| sent.iter().position(|request| request.contains(part)).expect("it was sent");
    let asked = sent.iter().rposition(|request| request.contains("get_joint_pos"));
    // From where the arm is in servo mode, not from where it was before.
    assert!(place("set_servo_move_filter") < place("\"servo_move\"") && Some(place("\"servo_move\"")) < asked);
    let set_points = u64::try_from(sent.iter().filter(|request| request.contains("servo_j")).count());
    assert_eq!(set_points, Ok(100 + report.landing_cycles));
}

#[test]
fn a_closure_gives_set_points_until_it_breaks() {
    let (controller, mut robot) = ready();
    let start = controller.state().joint_position.0;
    let mut session = robot.enter_servo_mode(&patient().step_count(2)).expect("the arm is enabled");
    let mut times = Vec::new();
    let end = session.run(|time, status| {
        assert!(status.is_some(), "the monitor has packets");
        times.push(time);
        let mut target = start;
        target[2] += 0.05 * f64::from(u32::try_from(times.len()).expect("it is small"));
        if times.len() > 20 { ControlFlow::Break("done") } else { ControlFlow::Continue(JointPosition(target)) }
    });
    assert_eq!(end.expect("servo mode is on"), "done");
    // A set-point is due every two cycles; none is skipped, however late one is.
    assert!(times.iter().zip(0..).all(|(time, number)| *time == Duration::from_millis(16) * number), "{times:?}");
    arrives(&controller, |status| {
        status.joint_actual_position.is_some_and(|at| (at.0[2] - start[2] - 1.0).abs() < 1e-6)
    });
    let report = session.land().expect("all were accepted");
    assert_eq!(report.accepted, 20 + report.landing_cycles);
}

#[test]
fn the_tool_centre_point_follows_set_points_too() {
    let (controller, mut robot) = ready();
    let start = controller.state().tcp_pose;
    let mut session = robot.enter_servo_mode(&patient()).expect("the arm is enabled");
    for n in 1..=20 {
        session.send_pose(Pose { z: start.z + 0.1 * f64::from(n), ..start }).expect("servo mode is on");
    }
    for _ in 0..10 {
        session.send_pose_offset([0.0, 0.2, 0.0, 0.0, 0.0, 0.0]).expect("servo mode is on");
    }
    let is_there = |at: Pose| (at.z - start.z - 2.0).abs() < 0.01 && (at.y - start.y - 2.0).abs() < 0.01;
    arrives(&controller, |status| status.actual_position.is_some_and(is_there));
    let report = session.land().expect("all were accepted");
    assert_eq!((report.cycles, report.accepted), (30, 30 + report.landing_cycles));
}

#[test]
fn a_step_that_is_too_fast_is_not_sent() {
    let (controller, mut robot) = ready();
    let config = ServoConfig::new().max_unanswered(Duration::from_secs(60));
    let mut session = robot.enter_servo_mode(&config).expect("the arm is enabled");
    let error = session.send_joint_offset([1.5, 0.0, 0.0, 0.0, 0.0, 0.0]).expect_err("that is 187.5 deg/s");
    assert_eq!(
        error.to_string(),
        "`servo_j` was not sent: field `joint_position[0]` is a step of 1.500 deg, \
         allowed is a step of at most 1.440 deg each 8ms (180 deg/s)"
    );
    drop(session);
    let mut session = robot.enter_servo_mode(&config).expect("the arm is enabled");
    assert!(session.send_joints([0.0; 6]).is_err_and(|error| error.is_invalid_argument()));
    drop(session);
    assert_eq!(controller.requests().iter().filter(|request| request.contains("servo_j")).count(), 0);
}

#[test]
fn a_refusal_is_reported_soon_and_servo_mode_is_left() {
    let (controller, mut robot) = ready();
    let mut session = robot.enter_servo_mode(&patient()).expect("the arm is enabled");
    session.send_joint_offset(STEP).expect("servo mode is on");
    controller.set_state(|state| state.servo_mode = false);
    let error =
        (0..CYCLES).find_map(|_| session.send_joint_offset(STEP).err()).expect("a refusal comes within some cycles");
    let refusal = error.refusal().expect("the controller refuses");
    assert_eq!(refusal.code, ErrorCode(-1));
    // The next one would start from where the arm is not.
    let ended = session.send_joint_offset(STEP).expect_err("the session has ended");
    assert!(matches!(ended.kind(), ErrorKind::SessionEnded { .. }), "{ended:?}");
    drop(session);
    assert_eq!(last_change(&controller.requests()), LEFT);
    robot.client().get_joint_pos().expect("the connection works");
}

#[test]
fn answers_that_another_call_reads_count_too() {
    let (controller, mut robot) = ready();
    let stop = robot.client().stop_handle();
    let mut session = robot.enter_servo_mode(&patient()).expect("the arm is enabled");
    session.send_joint_offset(STEP).expect("servo mode is on");
    stop.stop().expect("its reply comes after that of the set-point");
    let report = session.land().expect("the set-point was accepted");
    assert_eq!((report.cycles, report.accepted, report.unanswered), (1, 1 + report.landing_cycles, 0));

    let mut session = robot.enter_servo_mode(&patient()).expect("the arm is enabled");
    controller.set_state(|state| state.servo_mode = false);
    session.send_joint_offset(STEP).expect("its answer has not come");
    stop.stop().expect("its reply comes after that of the set-point");
    let error = session.land().expect_err("the set-point was refused");
    assert_eq!(error.refusal().map(|refusal| refusal.code), Some(ErrorCode(-1)));
}

#[test]
fn servo_mode_is_left_on_drop_and_on_panic() {
    let (controller, mut robot) = ready();
    drop(robot.enter_servo_mode(&patient()).expect("the arm is enabled"));
    assert_eq!(last_change(&controller.requests()), LEFT);
    robot.client().is_in_servomove().expect("it answers");
    let panicked = catch_unwind(AssertUnwindSafe(|| {
        let mut session = robot.enter_servo_mode(&patient()).expect("the arm is enabled");
        session.send_joint_offset(STEP).expect("servo mode is on");
        panic!("a bug in the user's program");
    }));
    assert!(panicked.is_err());
    assert_eq!(last_change(&controller.requests()), LEFT);
}

#[test]
fn answers_that_never_come_are_counted_and_hold_nothing_up() {
    let (controller, mut robot) = ready();
    let mut session = robot.enter_servo_mode(&patient()).expect("the arm is enabled");
    for _ in 0..3 {
        controller.inject_for("servo_j", Fault::Drop);
    }
    for _ in 0..20 {
        session.send_joint_offset(STEP).expect("nothing is refused");
    }
    let report = session.land().expect("nothing was refused");
    assert_eq!((report.cycles, report.accepted, report.unanswered), (20, 17 + report.landing_cycles, 3));
    robot.client().get_joint_pos().expect("the connection works");
}

#[test]
fn a_stop_or_a_lost_connection_ends_the_session() {
    let (controller, mut robot) = ready();
    let mut session = robot.enter_servo_mode(&patient()).expect("the arm is enabled");
    controller.collide();
    let error = (0..CYCLES).find_map(|_| session.send_joint_offset(STEP).err()).expect("the stop is noticed");
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. } | ErrorKind::Refused { .. }), "{error:?}");
    drop(session);
    assert!(robot.enter_servo_mode(&patient()).is_err(), "nobody has looked");

    let (controller, mut robot) = ready();
    let mut session = robot.enter_servo_mode(&patient()).expect("the arm is enabled");
    controller.disconnect();
    let error = (0..CYCLES).find_map(|_| session.send_joint_offset(STEP).err()).expect("the loss is noticed");
    let is_told = matches!(error.kind(), ErrorKind::ServoModeNotLeft { .. }) && error.is_disconnected();
    assert!(is_told || matches!(error.kind(), ErrorKind::StatusUnknown { .. }), "{error:?}");
    let error = session.land().expect_err("servo mode cannot be left").to_string();
    assert!(error.contains("servo mode may be on"), "{error}");
}

#[test]
fn no_set_point_goes_out_after_a_stop() {
    let (controller, mut robot) = ready();
    let stop = robot.stop_handle();
    // The longest period, so that the session waits for its end while the stop comes.
    let config = patient().step_count(12);
    std::thread::scope(|scope| {
        let sending = scope.spawn(|| {
            let mut session = robot.enter_servo_mode(&config).expect("the arm is enabled");
            (0..100).find_map(|_| session.send_joint_offset(STEP).err())
        });
        let is_set_point = |request: &String| request.contains("servo_j");
        let mut received = 1;
        while !controller.requests().iter().any(is_set_point) {
            assert!(controller.wait_for_requests(received, Duration::from_secs(30)), "a set-point comes");
            received = controller.requests().len() + 1;
        }
        // Most likely the session waits by now; where it does not, the test still passes.
        controller.wait_for_requests(received, Duration::from_millis(100));
        stop.stop().expect("the controller takes the stop");
        let error = sending.join().expect("it does not panic").expect("the session has ended");
        assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. }), "{error:?}");
        let after = controller.requests().into_iter().skip_while(|request| !request.contains("stop_program"));
        assert_eq!(after.filter(is_set_point).collect::<Vec<_>>(), Vec::<String>::new());
    });
}
