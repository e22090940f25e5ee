//! A client loses the seat of the command port while it waits, or its stop is refused. The controller is two plain sockets.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::thread;
use std::time::{Duration, Instant};

use jaka_sync::motion::JointMove;
use jaka_sync::{Disconnect, ErrorKind, InputCondition, Numbering, Outcome, Robot};
use jaka_tests::HandFed;

/// Longer than anything takes.
const LONG: Duration = Duration::from_secs(60);

/// An arm that moves, with an input that is low.
const MOVING: &str = r#"{"len": 100, "emergency_stop": 0, "protective_stop": 0, "powered_on": 1, "enabled": true, "inpos": false, "din": [0]}"#;

/// The reply to a motion.
const ACCEPTED: &[u8] = br#"{"errorCode": "0", "errorMsg": "", "cmdName": "joint_move"}"#;

/// How the controller ends the connection.
#[derive(Debug, Clone, Copy)]
enum Loss {
    Closed,
    Reset,
}

const LOSSES: [Loss; 2] = [Loss::Closed, Loss::Reset];

/// A robot of two plain sockets, and its controller.
fn robot() -> (HandFed, Robot) {
    let (mut controller, robot) = HandFed::new(LONG);
    controller.packet_to(&robot, r#""din": [0]"#);
    (controller, robot)
}

fn turn() -> JointMove {
    JointMove::absolute([30.0, 90.0, 90.0, 90.0, -90.0, 0.0], 20.0).acceleration(100.0)
}

fn input() -> InputCondition {
    Numbering::FromOne.cabinet(1).is_high()
}

/// Reads a request and accepts it.
fn accept_motion(commands: &mut TcpStream) {
    let length = commands.read(&mut [0; 1024]).expect("the robot sends its motion");
    assert!(length > 0, "the robot sends its motion");
    commands.write_all(ACCEPTED).expect("the robot is connected");
}

/// Answers the query that has come if this machine is so slow that no packet has shown the motion yet.
fn answer_query(commands: &mut TcpStream) {
    commands.set_nonblocking(true).expect("it is a socket");
    let has_come = commands.read(&mut [0; 1024]).is_ok();
    commands.set_nonblocking(false).expect("it is a socket");
    if has_come {
        let reply =
            br#"{"errorCode": "0", "errorMsg": "", "cmdName": "get_joint_pos", "joint_pos": [1, 90, 90, 90, -90, 0]}"#;
        commands.write_all(reply).expect("the robot is connected");
    }
}

/// Lets packets of an arm that moves come while the robot waits, and takes its seat after a while.
fn lose_the_seat<T: Send>(controller: HandFed, loss: Loss, has_motion: bool, wait: impl FnOnce() -> T + Send) -> T {
    let HandFed { mut commands, mut status } = controller;
    thread::scope(|scope| {
        let waiting = scope.spawn(wait);
        if has_motion {
            accept_motion(&mut commands);
        }
        let (since, mut commands) = (Instant::now(), Some(commands));
        for packet in 0.. {
            if waiting.is_finished() {
                break;
            }
            assert!(since.elapsed() < LONG / 2, "{loss:?}: the wait goes on");
            status.write_all(MOVING.as_bytes()).expect("the robot is connected");
            thread::sleep(Duration::from_millis(5));
            if let Some(commands) = commands.take_if(|_| packet == 10) {
                let linger = matches!(loss, Loss::Reset).then_some(Duration::ZERO);
                socket2::SockRef::from(&commands).set_linger(linger).expect("it is a socket");
            }
        }
        waiting.join().expect("the wait does not panic")
    })
}

fn is_by_peer(cause: &Disconnect) -> bool {
    matches!(cause, Disconnect::Closed { .. } | Disconnect::Read(_))
}

#[test]
fn a_motion_whose_seat_is_lost_says_so_at_once() {
    for loss in LOSSES {
        let (controller, mut robot) = robot();
        let stop = robot.stop_handle();
        let end = lose_the_seat(controller, loss, true, || robot.run(&turn(), LONG)).expect("it was accepted");
        assert!(
            matches!(&end.outcome, Outcome::ConnectionLost { cause, .. } if is_by_peer(cause)),
            "{loss:?}: {end:?}"
        );
        assert!(end.not_answered.is_none() && end.packets.len() > 1, "{loss:?}: {end:?}");
        // It may go on, so that it can be waited for again, which is told the same. No other is sent, and no stop can be.
        assert!(matches!(robot.wait(LONG).outcome, Outcome::ConnectionLost { .. }), "{loss:?}");
        for error in [robot.run(&turn(), LONG).expect_err("nothing can be sent"), stop.stop().expect_err("nor a stop")]
        {
            assert!(error.is_disconnected() && !error.may_have_run(), "{loss:?}: {error:?}");
        }
        let text = end.reached().expect_err("it is not known").to_string();
        for part in ["it may go on", "cannot be stopped over this connection", "emergency stop"] {
            assert!(text.contains(part), "{text}");
        }
    }
}

#[test]
fn a_motion_under_a_guard_whose_seat_is_lost_says_so_at_once() {
    for loss in LOSSES {
        let (controller, mut robot) = robot();
        let wait = || robot.run_until(&turn(), input(), LONG);
        let end = lose_the_seat(controller, loss, true, wait).expect("it was accepted");
        assert!(matches!(end.outcome, Outcome::ConnectionLost { .. }), "{loss:?}: {end:?}");
        let stop = end.stop.expect("nobody judges the guard any longer").expect_err("it cannot be sent");
        assert!(stop.is_disconnected() && !stop.may_have_run(), "{loss:?}: {stop:?}");
    }
}

#[test]
fn a_wait_for_an_input_whose_seat_is_lost_says_so_at_once() {
    for loss in LOSSES {
        let (controller, robot) = robot();
        let error =
            lose_the_seat(controller, loss, false, || robot.wait_for_input(input(), LONG)).expect_err("it is lost");
        assert!(matches!(error.kind(), ErrorKind::CommandsLost { .. }), "{loss:?}: {error:?}");
        assert!(error.is_disconnected() && !error.may_have_run() && !error.is_timeout(), "{loss:?}: {error:?}");
    }
}

#[test]
fn a_stop_that_fails_ends_no_wait() {
    let (HandFed { mut commands, mut status }, mut robot) = robot();
    let stop = robot.stop_handle();
    let (end, stopped) = thread::scope(|scope| {
        let waiting = scope.spawn(|| robot.run(&turn(), Duration::from_secs(1)));
        accept_motion(&mut commands);
        let stopping = scope.spawn(|| stop.stop());
        let _ = commands.read(&mut [0; 1024]).expect("the stop comes");
        let refusal = br#"{"errorCode": "2", "errorMsg": "call stop_program failed", "cmdName": "stop_program"}"#;
        commands.write_all(refusal).expect("the robot is connected");
        while !waiting.is_finished() {
            status.write_all(MOVING.as_bytes()).expect("the robot is connected");
            thread::sleep(Duration::from_millis(5));
        }
        (waiting.join().expect("it does not panic"), stopping.join().expect("it does not panic"))
    });
    assert!(stopped.is_err_and(|error| error.is_refused()));
    assert!(end.is_ok_and(|end| matches!(end.outcome, Outcome::Deadline)));
}

#[test]
fn a_reply_that_comes_twice_does_not_keep_a_stop_back() {
    let (HandFed { mut commands, mut status }, mut robot) = robot();
    let stop = robot.stop_handle();
    thread::scope(|scope| {
        let waiting = scope.spawn(|| robot.run(&turn(), LONG));
        accept_motion(&mut commands);
        let mut show_moving = || {
            for _ in 0..20 {
                status.write_all(MOVING.as_bytes()).expect("the robot is connected");
                thread::sleep(Duration::from_millis(5));
            }
        };
        show_moving();
        answer_query(&mut commands);
        commands.write_all(ACCEPTED).expect("the robot is connected");
        // The wait does not read what nobody waits for: that would break the connection before the stop.
        show_moving();
        assert!(!waiting.is_finished(), "the wait goes on");
        let stopping = scope.spawn(|| stop.stop());
        let mut request = [0; 1024];
        let length = commands.read(&mut request).expect("the stop comes");
        assert!(String::from_utf8_lossy(&request[..length]).contains("stop_program"));
        // Which of two replies is whose is not known any more.
        assert!(stopping.join().expect("it does not panic").is_err_and(|error| error.may_have_run()));
        status.write_all(MOVING.as_bytes()).expect("the robot is connected");
        let end = waiting.join().expect("it does not panic").expect("it was accepted");
        assert!(matches!(end.outcome, Outcome::ConnectionLost { .. }), "{end:?}");
    });
}
