//! Faults of the wire while motions are waited for and while set-points go out: each call ends in time, with an outcome
//! or an error that fits, and nothing hangs.

use std::time::Duration;

use jaka_robot::motion::JointMove;
use jaka_robot::{Cause, ErrorKind, Robot, RobotConfig, RobotStop, ServoConfig, SessionConfig};
use jaka_sim::{Fault, StatusFault};
use jaka_tests::Arm;
use jaka_tests::Configured as _;

/// No call may take longer than its deadline by more than this: another question, and what a session may take to land.
const SLACK: Duration = Duration::from_secs(3);
const DEADLINE: Duration = Duration::from_secs(2);

fn ready() -> (Arm, Robot) {
    let arm = Arm::simulated().status_period(Duration::from_millis(10));
    let (arm, robot) =
        arm.config(|config| config.reply_timeout(Duration::from_millis(300)).max_frame(64 << 10)).with_robot();
    let silence = Duration::from_millis(500);
    (
        arm,
        robot
            .configured(&RobotConfig::new().start_grace(Duration::from_millis(100), 3).status_silence(silence))
            .expect("it has no limits"),
    )
}

fn short_move() -> JointMove {
    let joint_position = [3.0, 90.0, 90.0, 90.0, -90.0, 0.0];
    JointMove::absolute(joint_position, 90.0).acceleration(700.0)
}

#[test]
fn motions_end_in_time_whatever_is_wrong_with_their_reply() {
    for fault in Fault::one_of_each() {
        let (arm, mut robot) = ready();
        arm.inject(fault.clone());
        let since = arm.clock().elapsed();
        let result = robot.run(&short_move(), DEADLINE);
        let took = arm.clock().elapsed().saturating_sub(since);
        assert!(took < DEADLINE + SLACK, "{fault}: {took:?}");
        match result {
            // Accepted: then the motion is what the status says.
            Ok(end) => {
                // What is left of the fault may break the connection by itself, or when the position is asked for.
                let is_lost = end.cause() == Cause::CommandsLost;
                assert!(is_lost || end.cause() == Cause::Reached, "{fault}: {end:?}");
                let is_there = (arm.state().joint_position.0[0] - 3.0).abs() < 1e-6;
                assert!(is_lost || is_there, "{fault}");
            }
            // Not known to be accepted: then it may have run, and the error says so.
            Err(error) => assert!(error.may_have_run(), "{fault}: {error:?}"),
        }
    }
}

#[test]
fn waits_end_in_time_whatever_is_wrong_with_the_status() {
    let faults = [
        (StatusFault::None, "reached"),
        (StatusFault::Silent, "lost"),
        (StatusFault::Slow(Duration::from_millis(80)), "reached"),
        (StatusFault::Pieces(3), "reached"),
        (StatusFault::CloseAfter(100), "lost"),
        (StatusFault::Garbage { bytes: 300, seed: 3 }, "any"),
        (StatusFault::Instead(b"{\"len\": 12}".to_vec()), "lost"),
    ];
    for (fault, expected) in faults {
        let (arm, mut robot) = ready();
        arm.status_fault(fault.clone());
        let since = arm.clock().elapsed();
        let end = robot.run(&short_move(), DEADLINE).expect("the command port is fine");
        let took = arm.clock().elapsed().saturating_sub(since);
        assert!(took < DEADLINE + SLACK, "{fault}: {took:?}");
        let fits = match end.cause() {
            Cause::Reached => (arm.state().joint_position.0[0] - 3.0).abs() < 1e-6 && expected != "lost",
            Cause::StatusLost => expected == "lost" || expected == "any",
            Cause::Deadline => expected == "any",
            _ => false,
        };
        assert!(fits, "{fault}: {:?} instead of {expected}", end.cause());
    }
}

#[test]
fn servo_sessions_end_in_time_whatever_is_wrong_with_an_answer() {
    for fault in Fault::one_of_each() {
        let (arm, mut robot) = ready();
        let mut session = robot
            .enter_servo_mode(SessionConfig::new().servo(ServoConfig::new().max_unanswered(SLACK)).unchecked())
            .expect("the arm is enabled");
        arm.inject_for("servo_j", fault.clone());
        let since = arm.clock().elapsed();
        let failed = (0..20).find_map(|_| session.send_joint_offset([0.05, 0.0, 0.0, 0.0, 0.0, 0.0]).err());
        let finished = session.land();
        let took = arm.clock().elapsed().saturating_sub(since);
        assert!(took < 2 * SLACK, "{fault}: {took:?}");
        let requests = arm.requests();
        let sent = requests.iter().filter(|request| request.contains("servo_j")).count();
        match (failed, finished) {
            (None, Ok(end)) => {
                let report = end.report;
                assert_eq!((report.cycles, sent as u64), (20, 20 + report.landing_cycles), "{fault}");
                assert!(report.accepted + 1 >= sent as u64, "{fault}: {report:?}");
            }
            // The connection is broken: no set-point has gone out after the one that showed it.
            (Some(error), _) | (None, Err(error)) => {
                let ends = error.is_disconnected()
                    || matches!(error.kind(), ErrorKind::NotAcknowledged { .. } | ErrorKind::ServoModeNotLeft { .. });
                assert!(ends || error.may_have_run(), "{fault}: {error:?}");
                let left = requests.iter().skip_while(|request| !request.contains("\"relFlag\":0}"));
                assert!(!left.into_iter().any(|request| request.contains("servo_j")), "{fault}");
            }
        }
    }
}

#[test]
fn robots_can_move_between_threads_and_their_stops_be_shared() {
    fn assert_send<T: Send>() {}
    fn assert_sync<T: Sync>() {}
    assert_send::<Robot>();
    assert_send::<RobotStop>();
    assert_sync::<RobotStop>();
}
