//! A client loses the seat of the command port while it waits, or its stop is refused. The controller is two plain
//! sockets.

use std::io::Write;
use std::time::Duration;

use jaka_robot::motion::JointMove;
use jaka_robot::{Cause, Disconnect, ErrorKind, Evidence, InputCondition, MotionExt as _, Numbering, Robot};
use jaka_sim::SimulatedClock;
use jaka_tests::simulated::beside;
use jaka_tests::{ClockedSocket, HandFed, LONG};

/// Time between two packets.
const PERIOD: Duration = Duration::from_millis(5);

/// An arm that moves, with an input that is low.
const MOVING: &str = r#"{"len": 100, "emergency_stop": 0, "protective_stop": 0, "powered_on": 1, "enabled": true, "inpos": false, "din": [0]}"#;

/// End of a connection by the controller.
#[derive(Debug, Clone, Copy)]
enum Loss {
    Closed,
    Reset,
}

const LOSSES: [Loss; 2] = [Loss::Closed, Loss::Reset];

/// A robot of two plain sockets, and its controller.
fn robot() -> (SimulatedClock, HandFed<ClockedSocket>, Robot) {
    let clock = SimulatedClock::new();
    let (mut controller, robot) = HandFed::by_clock(&clock, LONG);
    controller.packet_to(&robot, r#""din": [0]"#);
    (clock, controller, robot)
}

fn turn() -> JointMove {
    JointMove::absolute([30.0, 90.0, 90.0, 90.0, -90.0, 0.0], 20.0).acceleration(100.0)
}

fn input() -> InputCondition {
    Numbering::FromOne.cabinet(1).is_high()
}

/// Accepts the robot's motion.
fn accept_motion(controller: &mut HandFed<ClockedSocket>) {
    assert_eq!(controller.request()["cmdName"], "joint_move");
    controller.reply("joint_move", "");
}

/// Sends packets of an arm that moves, for a time.
fn show_moving(clock: &SimulatedClock, status: &mut ClockedSocket, time: Duration) {
    let until = clock.elapsed() + time;
    while clock.elapsed() < until {
        status.write_all(MOVING.as_bytes()).expect("the robot is connected");
        clock.sleep(PERIOD);
    }
}

/// Lets packets of an arm that moves come while the robot waits, and takes its seat in the midst of them, upon which
/// the wait ends.
fn lose_the_seat<T>(
    clock: &SimulatedClock,
    mut controller: HandFed<ClockedSocket>,
    loss: Loss,
    has_motion: bool,
    wait: impl FnOnce() -> T,
) -> T {
    let (begun, lost_after) = (clock.elapsed(), PERIOD * 10);
    let take_seat = move || {
        if has_motion {
            accept_motion(&mut controller);
        }
        let HandFed { commands, mut status } = controller;
        show_moving(clock, &mut status, lost_after);
        match loss {
            Loss::Closed => drop(commands),
            Loss::Reset => commands.reset(),
        }
        show_moving(clock, &mut status, lost_after);
    };
    beside(clock, take_seat, || {
        let ended = wait();
        assert_eq!(clock.elapsed(), begun + lost_after, "{loss:?}");
        ended
    })
}

fn is_by_peer(cause: &Disconnect) -> bool {
    matches!(cause, Disconnect::Closed { .. } | Disconnect::Read(_))
}

#[test]
fn a_motion_whose_seat_is_lost_says_so_at_once() {
    for loss in LOSSES {
        let (clock, controller, mut robot) = robot();
        let stop = robot.stop_handle();
        let end = lose_the_seat(&clock, controller, loss, true, || robot.run(&turn(), LONG)).expect("it was accepted");
        assert!(matches!(end.evidence(), Evidence::Commands { cause, .. } if is_by_peer(cause)), "{loss:?}: {end:?}");
        assert!(end.error.is_none() && end.packets.len() > 1, "{loss:?}: {end:?}");
        // It may go on, so that it can be waited for again, which is told the same. No other is sent, and no stop can
        // be.
        assert!(robot.wait(LONG).cause() == Cause::CommandsLost, "{loss:?}");
        for error in [robot.run(&turn(), LONG).expect_err("nothing can be sent"), stop.stop().expect_err("nor a stop")]
        {
            assert!(error.is_disconnected() && !error.may_have_run(), "{loss:?}: {error:?}");
        }
        let text = end.reached().expect_err("it is not known").to_string();
        for part in ["the arm may still move", "no stop can be sent on it", "emergency stop"] {
            assert!(text.contains(part), "{text}");
        }
    }
}

#[test]
fn a_motion_under_a_guard_whose_seat_is_lost_says_so_at_once() {
    for loss in LOSSES {
        let (clock, controller, mut robot) = robot();
        let wait = || robot.run(&turn().guard(input()), LONG);
        let end = lose_the_seat(&clock, controller, loss, true, wait).expect("it was accepted");
        assert!(end.cause() == Cause::CommandsLost, "{loss:?}: {end:?}");
        let stop = end.stop.expect("nobody judges the guard any longer").expect_err("it cannot be sent");
        assert!(stop.is_disconnected() && !stop.may_have_run(), "{loss:?}: {stop:?}");
    }
}

#[test]
fn a_wait_for_an_input_whose_seat_is_lost_says_so_at_once() {
    for loss in LOSSES {
        let (clock, controller, robot) = robot();
        let error = lose_the_seat(&clock, controller, loss, false, || robot.wait_for_input(input(), LONG))
            .expect_err("it is lost");
        assert!(matches!(error.kind(), ErrorKind::CommandsLost { .. }), "{loss:?}: {error:?}");
        assert!(error.is_disconnected() && !error.may_have_run() && !error.is_timeout(), "{loss:?}: {error:?}");
    }
}

#[test]
fn a_stop_that_fails_ends_no_wait() {
    let (clock, mut controller, mut robot) = robot();
    let (stop, mut stopped) = (robot.stop_handle(), Ok(()));
    let timeout = Duration::from_secs(1);
    let refuse = || {
        accept_motion(&mut controller);
        show_moving(&clock, &mut controller.status, PERIOD);
        beside(
            &clock,
            || stopped = stop.stop(),
            || {
                assert_eq!(controller.request()["cmdName"], "stop_program");
                let refusal =
                    br#"{"errorCode": "2", "errorMsg": "call stop_program failed", "cmdName": "stop_program"}"#;
                controller.commands.write_all(refusal).expect("the robot is connected");
                show_moving(&clock, &mut controller.status, timeout);
            },
        );
    };
    let end = beside(&clock, refuse, || robot.run(&turn(), timeout)).expect("it was accepted");
    assert!(stopped.is_err_and(|error| error.is_refused()));
    assert!(end.cause() == Cause::Deadline, "{end:?}");
    assert_eq!(end.report.waited, timeout);
}

#[test]
fn a_reply_that_comes_twice_does_not_keep_a_stop_back() {
    let (clock, mut controller, mut robot) = robot();
    let (stop, mut stopped) = (robot.stop_handle(), Ok(()));
    let while_it_moves = PERIOD * 20;
    let reply_twice = || {
        accept_motion(&mut controller);
        show_moving(&clock, &mut controller.status, while_it_moves);
        controller.reply("joint_move", "");
        // The wait does not read what nobody waits for: that would break the connection before the stop.
        show_moving(&clock, &mut controller.status, while_it_moves);
        beside(
            &clock,
            || stopped = stop.stop(),
            || {
                assert_eq!(controller.request()["cmdName"], "stop_program");
            },
        );
        show_moving(&clock, &mut controller.status, PERIOD);
    };
    let end = beside(&clock, reply_twice, || robot.run(&turn(), LONG)).expect("it was accepted");
    // Which of two replies is whose is not known any more.
    assert!(stopped.is_err_and(|error| error.may_have_run()));
    assert!(end.cause() == Cause::CommandsLost, "{end:?}");
    assert_eq!(end.report.waited, while_it_moves * 2);
}
