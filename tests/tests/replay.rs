//! Sessions that are recorded and replayed: the same again, and how a program deviates.

use std::fmt::Debug;
use std::net::SocketAddr;
use std::time::Duration;

use jaka_proto::recording::{Port, Recording};
use jaka_sim::{Controller, Delays, Deviation, Fault, FaultPlan, Replay, ReplayTiming};
use jaka_sync::kinematics::GetJointPos;
use jaka_sync::motion::JointMove;
use jaka_sync::{Client, Config, Monitor, Robot, ServoConfig};
use jaka_tests::{events, recorded};
use serde_json::json;

/// Short, but long enough for a busy machine: no test fails for taking longer, only for never ending.
const SHORT: Duration = Duration::from_millis(100);

/// How long anything may take.
const LIMIT: Duration = Duration::from_secs(30);

fn replay(recording: &Recording, mode: Replay) -> Controller {
    let builder = Controller::builder().replay(recording.clone(), mode).replay_timing(ReplayTiming::Immediate);
    builder.start().expect("loopback has free ports")
}

/// What is said, without the address, which is another one in a replay.
fn without(address: SocketAddr, said: &str) -> String {
    said.replace(&address.to_string(), "ADDRESS")
}

/// A session in which all kinds of things happen: what its program saw.
fn eventful(config: &Config, commands: SocketAddr, status: SocketAddr) -> Vec<String> {
    let mut seen = Vec::new();
    let mut see = |result: &dyn Debug| seen.push(without(commands, &format!("{result:?}")));
    let mut client = config.connect_client(commands).expect("the controller listens");
    let mut packets = config.connect_status(status).expect("the controller listens");
    see(&client.get_version());
    see(&client.enable_robot()); // refused: no power
    see(&packets.next_packet());
    see(&client.call_within(&GetJointPos::new(), SHORT)); // its reply is late
    see(&client.power_on()); // the late reply comes first
    see(&packets.next_packet());
    see(&packets.next_packet());
    see(&client.call_raw("get_robot_state", &json!({"unknown": [1, 2]})));
    see(&client.get_joint_pos()); // broken off in the middle
    see(&client.get_joint_pos()); // not sent
    drop(client);
    let mut client = config.connect_client(commands).expect("the controller listens");
    see(&client.get_version());
    see(&client.quit());
    see(&client.get_version()); // the session has ended
    seen
}

#[test]
fn a_strict_replay_of_a_session_is_the_same_session() {
    let faults = "none, none, hold, none, none, close-after 10".parse::<FaultPlan>().expect("it is a script");
    let builder = Controller::builder().delays(Delays::NONE).faults(faults).status_period(SHORT);
    let robot = builder.start().expect("loopback has free ports");
    let (seen, recording) = recorded(|config| eventful(config, robot.command_addr(), robot.status_addr()));
    assert!(seen[1].contains("Refused") && seen[3].contains("Timeout"), "{seen:?}");
    assert!(seen[8].contains("Closed { partial: 10 }"), "{seen:?}");
    for timing in [ReplayTiming::Recorded, ReplayTiming::Immediate] {
        let builder = Controller::builder().replay(recording.clone(), Replay::Strict).replay_timing(timing);
        let again = builder.start().expect("loopback has free ports");
        let (seen_again, recording_again) =
            recorded(|config| eventful(config, again.command_addr(), again.status_addr()));
        assert_eq!(again.deviations(), []);
        assert_eq!(seen_again, seen);
        assert_eq!(events(&recording_again), events(&recording));
    }
}

#[test]
fn motions_and_servo_sessions_of_a_robot_are_replayed() {
    let program = |config: &Config, controller: &Controller| {
        let monitor: Monitor = config.connect_monitor(controller.status_addr()).expect("the controller listens");
        let client = config.connect_client(controller.command_addr()).expect("the controller listens");
        let mut robot = Robot::new(client, monitor);
        robot.power_up(LIMIT).expect("it powers up at once");
        let request = JointMove::relative([10.0, 0.0, 0.0, 0.0, 0.0, 0.0], 20.0);
        robot.run(&request, LIMIT).expect("it is sent").reached().expect("nothing is in the way");
        let mut session = robot
            .enter_servo_mode(&ServoConfig::new().max_unanswered(Duration::from_secs(30)))
            .expect("the arm is enabled");
        (0..25).try_for_each(|_| session.send_joint_offset([0.01; 6])).expect("set-points are sent");
        let report = session.land().expect("servo mode is left");
        // How often the arm is held at the end depends on when packets come.
        (report.cycles, report.accepted - report.landing_cycles, report.refused, report.unanswered)
    };
    let robot = Controller::builder().delays(Delays::NONE).status_period(Duration::from_millis(20));
    let robot = robot.start().expect("loopback has free ports");
    let (seen, recording) = recorded(|config| program(config, &robot));
    assert_eq!(seen, (25, 25, 0, 0));
    let again = Controller::builder().replay(recording, Replay::Strict).start().expect("loopback has free ports");
    let replayed = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| program(&Config::new(), &again)));
    assert_eq!(again.deviations(), []);
    assert_eq!(replayed.unwrap(), seen);
}

#[test]
fn garbage_is_recorded_byte_for_byte_and_replayed() {
    let garbage = b"\x00\xff not a message {\xfe} \n\"";
    let robot = jaka_tests::controller();
    let program = |config: &Config, address| {
        let mut client = config.connect_client(address).expect("the controller listens");
        client.get_version().expect("it answers");
        without(address, &format!("{:?}", client.get_joint_pos()))
    };
    robot.inject(Fault::None);
    robot.inject(Fault::Instead(garbage.to_vec()));
    let (seen, recording) = recorded(|config| program(config, robot.command_addr()));
    assert!(seen.contains("Garbage"), "{seen}");
    let last = recording.entries.iter().rev().find_map(|entry| entry.event.message()).expect("there are messages");
    assert_eq!(last.bytes(), garbage);
    let again = replay(&recording, Replay::Strict);
    let (seen_again, recording_again) = recorded(|config| program(config, again.command_addr()));
    assert_eq!((seen_again, again.deviations()), (seen, vec![]));
    assert_eq!(events(&recording_again), events(&recording));
}

#[test]
fn resets_are_replayed_as_resets() {
    let robot = jaka_tests::controller();
    robot.inject(Fault::Reset);
    let program = |config: &Config, address| {
        let mut client = config.connect_client(address).expect("the controller listens");
        format!(
            "{:?}",
            client.get_version().map_err(|error| std::error::Error::source(&error).map(ToString::to_string))
        )
    };
    let (seen, recording) = recorded(|config| program(config, robot.command_addr()));
    assert!(seen.contains("receiving failed"), "{seen}");
    for mode in [Replay::Strict, Replay::Matching] {
        let again = replay(&recording, mode);
        assert_eq!((program(&Config::new(), again.command_addr()), again.deviations()), (seen.clone(), vec![]));
    }
}

#[test]
fn unsolicited_replies_are_replayed() {
    let reply = br#"{"errorCode": "0", "errorMsg": "", "cmdName": "get_version", "version": "1"}"#;
    let robot = jaka_tests::controller();
    robot.inject(Fault::Instead(reply.repeat(2)));
    let program = |config: &Config, address| {
        let mut client = config.connect_client(address).expect("the controller listens");
        without(address, &format!("{:?} {:?}", client.get_version(), client.get_robot_state()))
    };
    let (seen, recording) = recorded(|config| program(config, robot.command_addr()));
    assert!(seen.contains("Unsolicited"), "{seen}");
    let again = replay(&recording, Replay::Strict);
    assert_eq!(program(&Config::new(), again.command_addr()).replace("exchanges: 0", "exchanges: 3"), seen);
    assert_eq!(again.deviations(), []);
}

/// A short session, recorded: two queries and two settings.
fn short_session() -> Recording {
    let robot = jaka_tests::controller();
    let ((), recording) = recorded(|config| {
        let mut client = config.connect_client(robot.command_addr()).expect("the controller listens");
        client.set_rapid_rate(0.5).expect("it answers");
        robot.set_state(|state| state.joint_position = [1.0; 6].into());
        client.get_joint_pos().expect("it answers");
        client.set_rapid_rate(0.25).expect("it answers");
        robot.set_state(|state| state.joint_position = [2.0; 6].into());
        client.get_joint_pos().expect("it answers");
    });
    recording
}

#[test]
fn another_request_than_the_recorded_one_is_a_deviation() {
    let controller = replay(&short_session(), Replay::Strict);
    let mut client = Client::connect(controller.command_addr()).expect("the controller listens");
    client.call_raw("rapid_rate", &json!({"rate_value": 0.5})).expect("the same JSON");
    let error = client.set_rapid_rate(0.25).expect_err("another one was recorded");
    assert!(error.is_disconnected());
    let [Deviation::OtherRequest { expected, received }] = &controller.deviations()[..] else { panic!("there is one") };
    assert_eq!(expected, r#"{"cmdName":"get_joint_pos"}"#);
    assert_eq!(received, r#"{"cmdName":"rapid_rate","rate_value":0.25}"#);
    // A further connection is one too many.
    let mut client = Client::connect(controller.command_addr()).expect("the controller listens");
    assert!(client.get_version().is_err_and(|error| error.is_disconnected()));
    let deviations = controller.deviations();
    assert_eq!(deviations[1], Deviation::Connection { port: Port::Command, recorded: 1 });
    assert_eq!(deviations[1].to_string(), "a connection to the command port, of which the recording has 1");
}

#[test]
fn requests_too_few_and_too_many_are_deviations() {
    let recording = short_session();
    let controller = replay(&recording, Replay::Strict);
    let mut client = Client::connect(controller.command_addr()).expect("the controller listens");
    client.set_rapid_rate(0.5).expect("it was recorded");
    assert!(!controller.wait_for_deviations(1, Duration::ZERO));
    drop(client);
    assert!(controller.wait_for_deviations(1, LIMIT));
    let expected = r#"{"cmdName":"get_joint_pos"}"#.to_owned();
    assert_eq!(controller.deviations(), [Deviation::MissingRequest { expected }]);

    let controller = replay(&recording, Replay::Strict);
    let mut client = Client::connect(controller.command_addr()).expect("the controller listens");
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
    let controller = replay(&short_session(), Replay::Matching);
    let mut client = Client::connect(controller.command_addr()).expect("the controller listens");
    assert_eq!(client.get_joint_pos().expect("it was recorded").joint_position, [1.0; 6].into());
    client.set_rapid_rate(0.25).expect("it was recorded");
    // From another connection, too.
    let mut client = Client::connect(controller.command_addr()).expect("the controller listens");
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
    let robot = jaka_tests::controller();
    let program = |config: &Config, address| {
        let mut client = config.connect_client(address).expect("the controller listens");
        let silent = client.call_within(&GetJointPos::new(), SHORT).expect_err("no reply comes");
        client.set_rapid_rate(0.5).expect("it answers");
        let closed = client.get_version().expect_err("the controller closes");
        (silent.to_string(), without(address, &closed.to_string()))
    };
    robot.inject(Fault::Drop);
    robot.inject(Fault::None);
    robot.inject(Fault::Close);
    let (seen, recording) = recorded(|config| program(config, robot.command_addr()));
    let again = replay(&recording, Replay::Matching);
    assert_eq!(program(&Config::new(), again.command_addr()), seen);
    assert_eq!(again.deviations(), []);
}

#[test]
fn the_last_status_packet_stays_and_serves_further_readers_of_a_matching_replay() {
    let robot = Controller::builder().status_period(SHORT).start().expect("loopback has free ports");
    let (packets, recording) = recorded(|config| {
        let mut status = config.connect_status(robot.status_addr()).expect("the controller listens");
        let mut next = |position: f64| {
            robot.set_state(|state| state.joint_position = [position; 6].into());
            let wanted = Some([position; 6].into());
            std::iter::repeat_with(|| status.next_packet().expect("packets come"))
                .find(|packet| packet.joint_actual_position == wanted)
                .expect("the iterator has no end")
        };
        (next(1.0), next(2.0))
    });
    let again = Controller::builder()
        .replay(recording, Replay::Matching)
        .replay_timing(ReplayTiming::Immediate)
        .status_period(Duration::from_millis(5));
    let again = again.start().expect("loopback has free ports");
    for _ in 0..2 {
        let mut status = Config::new().connect_status(again.status_addr()).expect("the controller listens");
        let mut packets_again = std::iter::repeat_with(|| status.next_packet().expect("packets come"));
        assert!(packets_again.any(|packet| packet == packets.0));
        assert!(packets_again.any(|packet| packet == packets.1));
        assert!(packets_again.take(5).all(|packet| packet == packets.1));
    }
    assert_eq!(again.deviations(), []);
}
