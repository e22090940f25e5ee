//! Status that comes late, steadily or all at once, and what a program does meanwhile: what packets say about a time
//! that is over ends no motion and lets none out. The arm itself is the witness.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::thread;
use std::time::Duration;

use jaka_robot::motion::{JointMove, LineMode, MoveC, MoveL};
use jaka_robot::types::Pose;
use jaka_robot::{Cause, End, ErrorKind, Monitor, Robot, RobotConfig};
use jaka_sim::{Fault, Habit, Port};
use jaka_tests::simulated::{beside, until};
use jaka_tests::{Arm, ArmBuilder, Configured as _, LONG};

const PERIOD: Duration = Duration::from_millis(20);

fn ms(ms: u64) -> Duration {
    Duration::from_millis(ms)
}

/// An arm whose clients take old packets as fresh.
fn lenient() -> ArmBuilder {
    Arm::simulated().status_period(PERIOD).config(|config| config.stale_after(LONG))
}

/// An arm and a robot that bears any silence.
fn patient(arm: ArmBuilder) -> (Arm, Robot) {
    let (arm, robot) = arm.with_robot();
    (arm, robot.configured(&RobotConfig::new().status_silence(LONG)).expect("it has no limits"))
}

fn ready() -> (Arm, Robot) {
    patient(lenient())
}

/// A constant delay of the status that has lasted for a while: packets come at their pace, and each is so old.
fn delayed(arm: &Arm, time: Duration) {
    arm.link(Port::Status).to_client().delay(time);
    arm.clock().sleep(time + ms(200));
}

fn to(angle: f64, speed: f64) -> JointMove {
    let joint_position = [angle, 90.0, 90.0, 90.0, -90.0, 0.0];
    JointMove::absolute(joint_position, speed).acceleration(400.0)
}

fn up(millimetres: f64, speed: f64) -> MoveL {
    let pose = Pose { x: 0.0, y: 0.0, z: millimetres, rx: 0.0, ry: 0.0, rz: 0.0 };
    MoveL::relative(pose, speed).acceleration(800.0)
}

fn sent(arm: &Arm, name: &str) -> usize {
    arm.requests().iter().filter(|request| request.contains(&format!("\"cmdName\":\"{name}\""))).count()
}

/// Asserts that the arm is at rest where a wait ends with rest.
fn assert_rests(arm: &Arm, end: &End) {
    let state = arm.state();
    assert!(state.at_rest, "{end} while it moves at joint 1 {}, z {}", state.joint_position.0[0], state.tcp_pose.z);
}

/// The packets are those of before the motion until after the deadline.
#[test]
fn old_packets_show_no_rest_of_an_arm_that_moves_whatever_becomes_of_its_queries() {
    let refusal = Fault::Instead(br#"{"errorCode":"2","errorMsg":"busy","cmdName":"get_tcp_pos"}"#.to_vec());
    for fault in [Fault::None, Fault::Close, refusal] {
        // Along a slow line, the arm moves for longer than the wait, and ends near its beginning.
        for height in [5.0, 0.4] {
            let (arm, mut robot) = ready();
            delayed(&arm, ms(3000));
            robot.start(&up(height, 0.1)).expect("accepted");
            let asked = sent(&arm, "get_tcp_pos");
            (0..20).for_each(|_| arm.inject_for("get_tcp_pos", fault.clone()));
            let end = robot.wait(ms(2500));
            assert!(!arm.state().at_rest && sent(&arm, "get_tcp_pos") > asked, "{fault}, {height} mm");
            assert!(!end.rest.was_seen() && end.cause() != Cause::Reached, "{fault}, {height} mm: {end:?}");
        }
    }
}

#[test]
fn packets_of_the_motion_before_do_not_end_this_one() {
    for (delay, height, speed) in [(ms(1500), 1.2, 0.5), (ms(800), 0.9, 1.0)] {
        let (arm, mut robot) = ready();
        delayed(&arm, delay);
        let end = robot.run(&to(5.0, 40.0), LONG).expect("accepted");
        assert!(end.cause() == Cause::Reached);
        let end = robot.run(&up(height, speed), LONG).expect("accepted");
        assert_rests(&arm, &end);
    }
}

#[test]
fn no_motion_is_sent_while_the_newest_packet_shows_a_stop() {
    let (arm, mut robot) = patient(lenient().status_period(ms(500)));
    arm.collide();
    robot.monitor().wait_until(|status| status.protective_stop == Some(true), LONG).expect("packets come");
    until(arm.clock(), || robot.unacknowledged().is_some());
    robot.acknowledge();
    let newest = robot.monitor().last_known_packet().expect("packets came");
    assert_eq!(newest.status.protective_stop, Some(true));
    let _ = robot.start(&to(5.0, 40.0));
    assert_eq!(sent(&arm, "joint_move"), 0, "a motion went out while the newest packet shows a stop");
}

/// A robot whose monitor has had an observer before it, which says that it has a packet with a protective stop, and
/// takes its time over it until the other channel is closed. By the system's clock, since that wait is none of a
/// simulated one.
fn robot_after_a_slow_observer() -> (Arm, Robot, Receiver<()>, Sender<()>) {
    let arm = Arm::real_time().status_period(PERIOD).start();
    let monitor: Monitor = arm.monitor();
    let ((seen, saw), (go_on, may_go_on)) = (mpsc::channel(), mpsc::channel());
    monitor.observe(move |snapshot| {
        if snapshot.status.protective_stop == Some(true) {
            let _ = seen.send(());
            let _ = may_go_on.recv();
        }
        ControlFlow::Continue(())
    });
    let robot = Robot::new(arm.client(), monitor).expect("it is the only robot");
    (arm, robot, saw, go_on)
}

/// Packets that come together, of which one in their midst shows a protective stop.
fn release_packets_with_a_stop_in_their_midst(arm: &Arm) {
    let publish = |count: usize| (0..count).for_each(|_| arm.publish());
    arm.link(Port::Status).to_client().hold();
    publish(5);
    arm.set_state(|state| state.protective_stop = true);
    publish(1);
    arm.set_state(|state| state.protective_stop = false);
    publish(5);
    arm.link(Port::Status).to_client().release();
}

#[test]
fn a_slow_observer_does_not_keep_a_stop_from_being_known_that_a_packet_passed_over_shows() {
    let (arm, mut robot, saw, _go_on) = robot_after_a_slow_observer();
    release_packets_with_a_stop_in_their_midst(&arm);
    saw.recv_timeout(LONG).expect("packets come");
    let error = robot.start(&to(5.0, 40.0)).expect_err("a packet showed a protective stop");
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. }), "{error:?}");
    assert_eq!(sent(&arm, "joint_move"), 0);
}

#[test]
fn a_predicate_that_stops_the_arm_does_not_hang() {
    let (arm, robot) = ready();
    let (stop, monitor) = (robot.stop_handle(), Arc::clone(robot.monitor()));
    let (done, ended) = mpsc::channel();
    let place = arm.clock().participant();
    thread::spawn(move || {
        let result = place.run(|| monitor.wait_until(|_| stop.stop().is_ok(), ms(1000)));
        let _ = done.send(result.is_ok());
    });
    let ended = arm.clock().outside(|| ended.recv_timeout(LONG));
    if ended.is_err() {
        // They would wait for it, too.
        std::mem::forget((arm, robot));
    }
    assert_eq!(ended, Ok(true), "it hangs");
}

#[test]
fn no_motion_is_sent_after_its_deadline() {
    let (arm, mut robot) = patient(lenient().config(|config| config.stale_after(ms(1000))));
    let clock = arm.clock();
    arm.link(Port::Status).to_client().hold();
    clock.sleep(ms(1300));
    let release = || {
        clock.sleep(ms(600));
        arm.link(Port::Status).to_client().release();
    };
    let result = beside(clock, release, || robot.run(&to(30.0, 40.0), ms(100)));
    clock.sleep(ms(200));
    assert_eq!(sent(&arm, "joint_move"), 0, "a motion went out after its deadline: {result:?}");
}

#[test]
fn a_relative_motion_after_a_stop_is_not_measured_from_a_moving_arm() {
    let (arm, mut robot) = ready();
    delayed(&arm, ms(2000));
    let stop = robot.stop_handle();
    let slow = to(60.0, 20.0).acceleration(20.0);
    let clock = arm.clock();
    let stop = || {
        clock.sleep(ms(1200));
        stop.stop().expect("taken");
    };
    let stopped = beside(clock, stop, || robot.run(&slow, LONG).expect("accepted"));
    assert!(stopped.cause() == Cause::Stopped, "{:?}", stopped.cause());
    robot.acknowledge();
    let by = JointMove::relative([10.0, 0.0, 0.0, 0.0, 0.0, 0.0], 20.0).acceleration(100.0);
    let end = robot.run(&by, LONG).expect("accepted");
    assert!(end.cause() != Cause::Stopped, "nobody stopped it");
}

#[test]
fn no_motion_is_sent_on_the_first_packet_of_a_backlog() {
    let arm =
        lenient().status_period(ms(10)).config(|config| config.stale_after(ms(1000)).reply_timeout(ms(3000))).start();
    let mut gone_out = 0;
    for _ in 0..2 {
        let mut robot = arm.robot().configured(&RobotConfig::new().status_silence(LONG)).expect("it has no limits");
        let before = sent(&arm, "joint_move");
        let clock = arm.clock();
        arm.link(Port::Status).to_client().hold();
        clock.sleep(ms(1100));
        arm.collide();
        clock.sleep(ms(300));
        let release = || {
            clock.sleep(ms(100));
            arm.link(Port::Status).to_client().release();
        };
        let _ = beside(clock, release, || robot.start(&to(30.0, 40.0)));
        let now = sent(&arm, "joint_move") - before;
        gone_out += now;
        robot.client().clear_error().expect("fine");
        drop(robot);
        arm.set_state(|state| state.protective_stop = false);
    }
    assert_eq!(gone_out, 0, "motions went out after a stop that had been received for 300 ms");
}

#[test]
fn an_answer_from_before_the_arm_had_left_ends_no_motion() {
    let (arm, mut robot) = ready();
    let foreign = robot.client().stop_handle();
    let at = arm.state().tcp_pose;
    let mid_pose = Pose { x: at.x + 30.0, z: at.z + 1.0, ..at };
    let end_pose = Pose { z: at.z + 0.3, ..at };
    let circle = MoveC::absolute(mid_pose, end_pose, 30.0, 5.0, 0.0);
    delayed(&arm, ms(400));
    robot.start(&circle).expect("accepted");
    arm.link(Port::Command).to_client().hold();
    let clock = arm.clock();
    let stop = || {
        clock.sleep(ms(1000));
        // Its reply is held, but the stop is carried out.
        drop(foreign.stop());
    };
    let release = || {
        clock.sleep(ms(3500));
        arm.link(Port::Command).to_client().release();
    };
    let end = beside(clock, stop, || beside(clock, release, || robot.wait(ms(9000))));
    let state = arm.state();
    if end.cause() == Cause::Reached {
        assert!(state.tcp_pose.distance_mm(&end_pose) < 0.5 && state.at_rest);
    }
}

#[test]
fn a_refused_motion_is_reported_within_its_deadline() {
    let habits = [Habit::LateQueries(Some(ms(3000)))];
    let (arm, mut robot) = patient(lenient().controller(|controller| controller.habits(habits)));
    robot.start(&to(90.0, 10.0)).expect("accepted");
    let mut far = up(0.0, 20.0);
    far.pose = Pose { x: 9000.0, y: 0.0, z: 0.0, rx: 0.0, ry: 0.0, rz: 0.0 };
    far.mode = LineMode::Absolute;
    let since = arm.clock().elapsed();
    let error = robot.run(&far, ms(200)).expect_err("it is not reachable");
    let took = arm.clock().elapsed().saturating_sub(since);
    assert!(took <= ms(200), "{error} after {took:?}");
}

#[test]
fn a_stop_that_fails_keeps_the_next_motion_back_also_where_another_was_reported() {
    let (arm, mut robot) = patient(lenient().config(|config| config.reply_timeout(ms(1500))));
    robot.start(&to(40.0, 10.0)).expect("accepted");
    let (one, two) = (robot.stop_handle(), robot.stop_handle());
    arm.inject_for("stop_program", Fault::Drop);
    let mut stopped = [Ok(()), Ok(())];
    let [first, second] = &mut stopped;
    let stop_again = || {
        until(arm.clock(), || sent(&arm, "stop_program") > 0);
        *second = two.stop();
    };
    beside(arm.clock(), || *first = one.stop(), stop_again);
    let end = robot.wait(LONG);
    assert!(end.cause() == Cause::Stopped, "{:?}", end.cause());
    let result = robot.start(&to(5.0, 40.0));
    // Of which of the two the reply was lost cannot be told.
    assert!(stopped.iter().any(Result::is_err), "{stopped:?}");
    assert!(
        result.as_ref().is_err_and(|error| matches!(error.kind(), ErrorKind::NotAcknowledged { .. })),
        "{stopped:?}, {result:?}"
    );
}

/// Neither does it hold up a motion.
#[test]
fn a_slow_predicate_holds_up_no_stop() {
    let (arm, mut robot) = ready();
    let (clock, stop, monitor) = (arm.clock(), robot.stop_handle(), Arc::clone(robot.monitor()));
    let ((looking, looks), (go_on, may_go_on)) = (mpsc::channel(), mpsc::channel::<()>());
    let observe = move || {
        let slow = |_: &jaka_robot::status::RobotStatus| {
            let _ = looking.send(());
            let ended = clock.outside(|| may_go_on.recv_timeout(LONG));
            assert_eq!(ended, Err(RecvTimeoutError::Disconnected), "the stop or the motion waits for the predicate");
            true
        };
        let _ = monitor.wait_until(slow, ms(100));
    };
    beside(clock, observe, || {
        clock.outside(|| looks.recv_timeout(LONG)).expect("the predicate is asked");
        // It goes out, or is refused because of the stop, and does not wait for observers.
        let moving = || drop(robot.start(&to(5.0, 40.0)));
        beside(clock, moving, || stop.stop().expect("the controller takes the stop"));
        drop(go_on);
    });
}
