//! Sessions that are recorded and replayed: identical replays, and deviations of a program.

use std::fmt::Debug;
use std::net::SocketAddr;
use std::time::Duration;

use jaka_proto::recording::{Port, Recording};
use jaka_robot::ServoConfig;
use jaka_robot::kinematics::GetJointPos;
use jaka_robot::motion::JointMove;
use jaka_sim::{Deviation, Fault, FaultPlan, Replay, ReplayTiming};
use jaka_tests::{Arm, ArmBuilder, LONG, events, recorded};
use serde_json::json;

/// Timeout where nothing comes, and time between packets.
const SHORT: Duration = Duration::from_millis(100);

/// The arm of most sessions.
fn arm() -> ArmBuilder {
    Arm::simulated().without_power()
}

/// A controller that answers from a recording.
fn replayed(recording: &Recording, mode: Replay, timing: ReplayTiming) -> ArmBuilder {
    Arm::simulated().controller(|controller| controller.replay(recording.clone(), mode).replay_timing(timing))
}

fn replay(recording: &Recording, mode: Replay) -> ArmBuilder {
    replayed(recording, mode, ReplayTiming::Immediate)
}

/// Text of a result without the address, which differs in a replay.
fn without(address: SocketAddr, said: &str) -> String {
    said.replace(&address.to_string(), "ADDRESS")
}

/// A session in which all kinds of things happen: what its program saw.
fn eventful(arm: &Arm) -> Vec<String> {
    let mut seen = Vec::new();
    let mut see = |result: &dyn Debug| seen.push(without(arm.command_addr(), &format!("{result:?}")));
    let mut client = arm.client();
    let mut packets = arm.stream();
    see(&client.get_version());
    see(&client.enable_robot()); // refused: no power
    see(&packets.next_packet());
    see(&client.call_within(&GetJointPos::new(), SHORT / 2)); // its reply is late
    see(&client.power_on()); // the late reply comes first
    see(&packets.next_packet());
    see(&packets.next_packet());
    see(&client.call_raw("get_robot_state", &json!({"unknown": [1, 2]})));
    see(&client.get_joint_pos()); // broken off in the middle
    see(&client.get_joint_pos()); // not sent
    drop(client);
    let mut client = arm.client();
    see(&client.get_version());
    see(&client.quit());
    see(&client.get_version()); // the session has ended
    seen
}

#[test]
fn a_strict_replay_of_a_session_is_the_same_session() {
    let faults = "none, none, hold, none, none, close-after 10".parse::<FaultPlan>().expect("it is a script");
    let arm = arm().controller(|controller| controller.faults(faults)).status_period(SHORT);
    let (seen, recording) = recorded(arm, eventful);
    assert!(seen[1].contains("Refused") && seen[3].contains("Timeout"), "{seen:?}");
    assert!(seen[8].contains("Closed { partial: 10 }"), "{seen:?}");
    for timing in [ReplayTiming::Recorded, ReplayTiming::Immediate] {
        let again = replayed(&recording, Replay::Strict, timing);
        let ((seen_again, deviations), recording_again) = recorded(again, |arm| (eventful(arm), arm.deviations()));
        assert_eq!(deviations, []);
        assert_eq!(seen_again, seen);
        assert_eq!(events(&recording_again), events(&recording));
    }
}

#[test]
fn motions_and_servo_sessions_of_a_robot_are_replayed() {
    let program = |arm: &Arm| {
        let mut robot = arm.robot();
        robot.power_up(LONG).expect("it powers up at once");
        let request = JointMove::relative([10.0, 0.0, 0.0, 0.0, 0.0, 0.0], 20.0);
        robot.run(&request, LONG).expect("it is sent").reached().expect("nothing is in the way");
        let mut session = robot.enter_servo_mode(ServoConfig::new()).expect("the arm is enabled");
        (0..25).try_for_each(|_| session.send_joint_offset([0.01; 6])).expect("set-points are sent");
        let report = session.land().expect("servo mode is left").report;
        // How often the arm is held at the end depends on when packets come.
        (report.cycles, report.accepted - report.landing_cycles, report.refused, report.unanswered)
    };
    let (seen, recording) = recorded(arm().status_period(Duration::from_millis(20)), program);
    assert_eq!(seen, (25, 25, 0, 0));
    let again = replayed(&recording, Replay::Strict, ReplayTiming::Recorded).start();
    let replayed = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| program(&again)));
    assert_eq!(again.deviations(), []);
    assert_eq!(replayed.unwrap(), seen);
}

#[test]
fn garbage_is_recorded_byte_for_byte_and_replayed() {
    let garbage = b"\x00\xff not a message {\xfe} \n\"";
    let program = |arm: &Arm| {
        let mut client = arm.client();
        client.get_version().expect("it answers");
        without(arm.command_addr(), &format!("{:?}", client.get_joint_pos()))
    };
    let (seen, recording) = recorded(arm(), |arm| {
        arm.inject(Fault::None);
        arm.inject(Fault::Instead(garbage.to_vec()));
        program(arm)
    });
    assert!(seen.contains("Garbage"), "{seen}");
    let last = recording.entries.iter().rev().find_map(|entry| entry.event.message()).expect("there are messages");
    assert_eq!(last.bytes(), garbage);
    let (seen_again, recording_again) =
        recorded(replay(&recording, Replay::Strict), |arm| (program(arm), arm.deviations()));
    assert_eq!(seen_again, (seen, vec![]));
    assert_eq!(events(&recording_again), events(&recording));
}

#[test]
fn resets_are_replayed_as_resets() {
    let program = |arm: &Arm| {
        let version = arm.client().get_version();
        format!("{:?}", version.map_err(|error| std::error::Error::source(&error).map(ToString::to_string)))
    };
    let (seen, recording) = recorded(arm(), |arm| {
        arm.inject(Fault::Reset);
        program(arm)
    });
    assert!(seen.contains("receiving failed"), "{seen}");
    for mode in [Replay::Strict, Replay::Matching] {
        let again = replay(&recording, mode).start();
        assert_eq!((program(&again), again.deviations()), (seen.clone(), vec![]));
    }
}

#[test]
fn unsolicited_replies_are_replayed() {
    let reply = br#"{"errorCode": "0", "errorMsg": "", "cmdName": "get_version", "version": "1"}"#;
    let program = |arm: &Arm| {
        let mut client = arm.client();
        without(arm.command_addr(), &format!("{:?} {:?}", client.get_version(), client.get_robot_state()))
    };
    let (seen, recording) = recorded(arm(), |arm| {
        arm.inject(Fault::Instead(reply.repeat(2)));
        program(arm)
    });
    assert!(seen.contains("Unsolicited"), "{seen}");
    let again = replay(&recording, Replay::Strict).start();
    assert_eq!(program(&again).replace("exchanges: 0", "exchanges: 3"), seen);
    assert_eq!(again.deviations(), []);
}

/// A short session, recorded: two queries and two settings.
fn short_session() -> Recording {
    let ((), recording) = recorded(arm(), |arm| {
        let mut client = arm.client();
        client.set_rapid_rate(0.5).expect("it answers");
        arm.set_state(|state| state.joint_position = [1.0; 6].into());
        client.get_joint_pos().expect("it answers");
        client.set_rapid_rate(0.25).expect("it answers");
        arm.set_state(|state| state.joint_position = [2.0; 6].into());
        client.get_joint_pos().expect("it answers");
    });
    recording
}

#[test]
fn another_request_than_the_recorded_one_is_a_deviation() {
    let (controller, mut client) = replay(&short_session(), Replay::Strict).with_client();
    client.call_raw("rapid_rate", &json!({"rate_value": 0.5})).expect("the same JSON");
    let error = client.set_rapid_rate(0.25).expect_err("another one was recorded");
    assert!(error.is_disconnected());
    let [Deviation::OtherRequest { expected, received }] = &controller.deviations()[..] else { panic!("there is one") };
    assert_eq!(expected, r#"{"cmdName":"get_joint_pos"}"#);
    assert_eq!(received, r#"{"cmdName":"rapid_rate","rate_value":0.25}"#);
    // A further connection is one too many.
    let mut client = controller.client();
    assert!(client.get_version().is_err_and(|error| error.is_disconnected()));
    let deviations = controller.deviations();
    assert_eq!(deviations[1], Deviation::Connection { port: Port::Command, recorded: 1 });
    assert_eq!(deviations[1].to_string(), "a connection to the command port, of which the recording has 1");
}

#[test]
fn requests_too_few_and_too_many_are_deviations() {
    let recording = short_session();
    let (controller, mut client) = replay(&recording, Replay::Strict).with_client();
    client.set_rapid_rate(0.5).expect("it was recorded");
    assert!(!controller.wait_for_deviations(1, Duration::ZERO));
    drop(client);
    assert!(controller.wait_for_deviations(1, LONG));
    let expected = r#"{"cmdName":"get_joint_pos"}"#.to_owned();
    assert_eq!(controller.deviations(), [Deviation::MissingRequest { expected }]);

    let (controller, mut client) = replay(&recording, Replay::Strict).with_client();
    client.set_rapid_rate(0.5).expect("it was recorded");
    client.get_joint_pos().expect("it was recorded");
    client.set_rapid_rate(0.25).expect("it was recorded");
    client.get_joint_pos().expect("it was recorded");
    assert!(client.get_version().is_err_and(|error| error.is_disconnected()));
    let received = r#"{"cmdName":"get_version"}"#.to_owned();
    assert_eq!(controller.deviations(), [Deviation::FurtherRequest { received }]);
    assert_eq!(controller.requests().len(), 5);
}

#[test]
fn matching_answers_equal_requests_in_any_order_and_no_others() {
    let (controller, mut client) = replay(&short_session(), Replay::Matching).with_client();
    assert_eq!(client.get_joint_pos().expect("it was recorded").joint_position, [1.0; 6].into());
    client.set_rapid_rate(0.25).expect("it was recorded");
    // From another connection, too.
    let mut client = controller.client();
    assert_eq!(client.get_joint_pos().expect("it was recorded").joint_position, [2.0; 6].into());
    assert_eq!(controller.deviations(), []);
    for refused in [client.set_rapid_rate(0.3), client.set_rapid_rate(0.25), client.get_joint_pos().map(drop)] {
        let error = refused.expect_err("the recording has none, or none any more");
        assert!(error.to_string().contains("the recording has no unused reply to this request"), "{error}");
    }
    client.set_rapid_rate(0.5).expect("it was recorded");
    let deviations: Vec<_> = controller.deviations().iter().map(ToString::to_string).collect();
    assert_eq!(deviations[0], r#"the recording has no unused reply to `{"cmdName":"rapid_rate","rate_value":0.3}`"#);
    assert_eq!(deviations.len(), 3);
}

#[test]
fn matching_keeps_silent_and_closes_where_the_controller_did() {
    let program = |arm: &Arm| {
        let mut client = arm.client();
        let silent = client.call_within(&GetJointPos::new(), SHORT).expect_err("no reply comes");
        client.set_rapid_rate(0.5).expect("it answers");
        let closed = client.get_version().expect_err("the controller closes");
        (silent.to_string(), without(arm.command_addr(), &closed.to_string()))
    };
    let (seen, recording) = recorded(arm(), |arm| {
        for fault in [Fault::Drop, Fault::None, Fault::Close] {
            arm.inject(fault);
        }
        program(arm)
    });
    let again = replay(&recording, Replay::Matching).start();
    assert_eq!(program(&again), seen);
    assert_eq!(again.deviations(), []);
}

#[test]
fn the_last_status_packet_stays_and_serves_further_readers_of_a_matching_replay() {
    let (packets, recording) = recorded(arm().status_period(SHORT), |arm| {
        let mut status = arm.stream();
        let mut next = |position: f64| {
            arm.set_state(|state| state.joint_position = [position; 6].into());
            let wanted = Some([position; 6].into());
            std::iter::repeat_with(|| status.next_packet().expect("packets come"))
                .find(|packet| packet.joint_actual_position == wanted)
                .expect("the iterator has no end")
        };
        (next(1.0), next(2.0))
    });
    let again = replay(&recording, Replay::Matching).status_period(Duration::from_millis(5)).start();
    for _ in 0..2 {
        let mut status = again.stream();
        let mut packets_again = std::iter::repeat_with(|| status.next_packet().expect("packets come"));
        assert!(packets_again.any(|packet| packet == packets.0));
        assert!(packets_again.any(|packet| packet == packets.1));
        assert!(packets_again.take(5).all(|packet| packet == packets.1));
    }
    assert_eq!(again.deviations(), []);
}
