//! Recording sessions, and replaying them.

use std::fmt::Debug;
use std::io::{self, Write};
use std::net::SocketAddr;
use std::sync::{Arc, Condvar, Mutex};
use std::time::Duration;

use jaka_proto::recording::{Ending, Entry, Event, Message, Port, Recording};
use jaka_sim::{Controller, Delays, Deviation, Fault, FaultPlan, Replay, ReplayTiming};
use jaka_sync::kinematics::GetJointPos;
use jaka_sync::motion::JointMove;
use jaka_sync::power::GetVersion;
use jaka_sync::types::{MoveMode, Switch};
use jaka_sync::{Client, Config, Error, Monitor, Recorder, Robot, ServoConfig, StatusSampling};
use serde_json::json;

/// Short, but long enough for a busy machine: no test fails for taking longer, only for never ending.
const SHORT: Duration = Duration::from_millis(100);

/// How long anything may take.
const LIMIT: Duration = Duration::from_secs(30);

/// A file in memory.
#[derive(Debug, Clone, Default)]
struct Tape(Arc<Mutex<Vec<u8>>>);

impl Write for Tape {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.lock().expect("no test panics while it writes").extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Tape {
    fn recorder(&self) -> Recorder {
        Recorder::new(self.clone()).expect("a thread can be had")
    }

    fn read(&self) -> Recording {
        Recording::read(&self.0.lock().expect("no test panics while it writes")).expect("it has just been written")
    }
}

/// Runs a session with recording on, and gives what it returns and the recording.
fn recorded<T>(session: impl FnOnce(&Config) -> T) -> (T, Recording) {
    let tape = Tape::default();
    let recorder = tape.recorder();
    let result = session(&Config::new().recorder(recorder.clone()));
    let report = recorder.finish().expect("memory can be written");
    let recording = tape.read();
    assert_eq!(report.dropped, 0);
    assert_eq!(report.entries, u64::try_from(recording.entries.len()).expect("the number is small"));
    (result, recording)
}

fn replay(recording: &Recording, mode: Replay) -> Controller {
    let builder = Controller::builder().replay(recording.clone(), mode).replay_timing(ReplayTiming::Immediate);
    builder.start().expect("loopback has free ports")
}

/// What does not depend on the clock and the ports.
fn events(recording: &Recording) -> Vec<(Port, u32, Event)> {
    let without_address = |event: &Event| match event {
        Event::Connected { .. } => Event::Connected { address: String::new() },
        other => other.clone(),
    };
    recording.entries.iter().map(|entry| (entry.port, entry.connection, without_address(&entry.event))).collect()
}

/// A session in which all kinds of things happen: what its program saw.
fn eventful(config: &Config, commands: SocketAddr, status: SocketAddr) -> Vec<String> {
    let mut seen = Vec::new();
    let mut see = |result: &dyn Debug| seen.push(format!("{result:?}"));
    let mut client = config.connect(commands).expect("the controller listens");
    let mut packets = config.connect_status(status).expect("the controller listens");
    see(&client.get_version());
    see(&client.enable_robot()); // refused: no power
    see(&packets.next_packet());
    see(&client.call_within(&GetJointPos, SHORT)); // its reply is late
    see(&client.power_on()); // the late reply comes first
    see(&packets.next_packet());
    see(&packets.next_packet());
    see(&client.call_raw("get_robot_state", &json!({"unknown": [1, 2]})));
    see(&client.get_joint_pos()); // broken off in the middle
    see(&client.get_joint_pos()); // not sent
    drop(client);
    let mut client = config.connect(commands).expect("the controller listens");
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
        let monitor: Monitor = config.monitor(controller.status_addr()).expect("the controller listens");
        let client = config.connect(controller.command_addr()).expect("the controller listens");
        let mut robot = Robot::new(client, monitor);
        robot.power_up(LIMIT).expect("it powers up at once");
        let request = JointMove {
            mode: MoveMode::Relative,
            joint_position: [10.0, 0.0, 0.0, 0.0, 0.0, 0.0].into(),
            speed: 20.0,
            acceleration: None,
        };
        robot.run(&request, LIMIT).expect("it is sent").reached().expect("nothing is in the way");
        let mut session = robot.servo(&ServoConfig::new()).expect("the arm is enabled");
        (0..25).try_for_each(|_| session.joints_by([0.01; 6])).expect("set-points are sent");
        let report = session.finish().expect("servo mode is left");
        (report.cycles, report.accepted, report.refused, report.unanswered)
    };
    let robot = Controller::builder().delays(Delays::NONE).status_period(Duration::from_millis(20));
    let robot = robot.start().expect("loopback has free ports");
    let (seen, recording) = recorded(|config| program(config, &robot));
    assert_eq!(seen, (25, 25, 0, 0));
    let again = Controller::builder().replay(recording, Replay::Strict).start().expect("loopback has free ports");
    assert_eq!(program(&Config::new(), &again), seen);
    assert_eq!(again.deviations(), []);
}

#[test]
fn a_recording_tells_the_whole_session() {
    let robot = jaka_tests::controller();
    let ((), recording) = recorded(|config| {
        let mut client = config.connect(robot.command_addr()).expect("the controller listens");
        client.rapid_rate(0.5).expect("it answers");
        robot.inject(Fault::Drop);
        assert!(client.call_within(&GetJointPos, SHORT).is_err_and(|error| error.is_timeout()));
    });
    let command = |event| (Port::Command, 1, event);
    assert!(recording.header.software.starts_with("jaka-sync "));
    let Event::Connected { address } = &recording.entries[0].event else { panic!("it begins so") };
    assert_eq!(*address, robot.command_addr().to_string());
    assert_eq!(
        events(&recording)[1..],
        [
            command(Event::Sent(Message::new(r#"{"cmdName":"rapid_rate","rate_value":0.5}"#))),
            command(Event::Received(Message::new(r#"{"errorCode":"0","errorMsg":"","cmdName":"rapid_rate"}"#))),
            command(Event::Sent(Message::new(r#"{"cmdName":"get_joint_pos"}"#))),
            command(Event::Error { text: "no reply to `get_joint_pos` within 100ms; it may have run".to_owned() }),
            command(Event::Closed { by: Ending::Client, why: "the program has closed it".to_owned() }),
        ]
    );
    assert!(recording.entries.is_sorted_by_key(|entry| entry.time));
}

#[test]
fn connections_that_cannot_be_made_are_recorded() {
    let listener = std::net::TcpListener::bind("127.0.0.1:0").expect("loopback has free ports");
    let address = listener.local_addr().expect("it is bound");
    drop(listener);
    let ((), recording) = recorded(|config| {
        let error = config.connect(address).expect_err("nobody listens");
        assert!(error.exchanges().is_empty());
    });
    let [Entry { event: Event::Error { text }, .. }] = &recording.entries[..] else { panic!("{recording:?}") };
    assert!(text.starts_with(&format!("cannot connect to {address}: ")), "{text}");
}

#[test]
fn garbage_is_recorded_byte_for_byte_and_replayed() {
    let garbage = b"\x00\xff not a message {\xfe} \n\"";
    let robot = jaka_tests::controller();
    let program = |config: &Config, address| {
        let mut client = config.connect(address).expect("the controller listens");
        client.get_version().expect("it answers");
        format!("{:?}", client.get_joint_pos())
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
fn garbage_between_status_packets_is_recorded_by_monitors() {
    let robot = Controller::builder().status_period(Duration::MAX).start().expect("loopback has free ports");
    let (skipped, recording) = recorded(|config| {
        let monitor: Monitor = config.monitor(robot.status_addr()).expect("the controller listens");
        monitor.wait_until(|_| true, LIMIT).expect("the first packet comes at once");
        let seen = monitor.subscribe(10);
        for piece in [b"\x01\x02".as_slice(), b"\x03", b"\x04{\"len\": 7}"] {
            robot.send_status(piece);
        }
        assert_eq!(seen.next_within(LIMIT).expect("the packet is found").status.length, Some(7));
        monitor.statistics().dropped_bytes
    });
    assert!(skipped >= 2);
    let received = recording.entries.iter().filter_map(|entry| entry.event.message());
    let all = received.skip(1).flat_map(Message::bytes).copied().collect::<Vec<_>>();
    assert_eq!(all, b"\x01\x02\x03\x04{\"len\": 7}");
    let last = &recording.entries.last().expect("it has entries").event;
    assert!(matches!(last, Event::Closed { by: Ending::Client, .. }), "{last:?}");
}

#[test]
fn resets_are_replayed_as_resets() {
    let robot = jaka_tests::controller();
    robot.inject(Fault::Reset);
    let program = |config: &Config, address| {
        let mut client = config.connect(address).expect("the controller listens");
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
fn replies_that_nobody_asked_for_are_replayed() {
    let reply = br#"{"errorCode": "0", "errorMsg": "", "cmdName": "get_version", "version": "1"}"#;
    let robot = jaka_tests::controller();
    robot.inject(Fault::Instead(reply.repeat(2)));
    let program = |config: &Config, address| {
        let mut client = config.connect(address).expect("the controller listens");
        format!("{:?} {:?}", client.get_version(), client.get_robot_state())
    };
    let (seen, recording) = recorded(|config| program(config, robot.command_addr()));
    assert!(seen.contains("Unasked"), "{seen}");
    let again = replay(&recording, Replay::Strict);
    assert_eq!(program(&Config::new(), again.command_addr()).replace("Exchanges(0)", "Exchanges(3)"), seen);
    assert_eq!(again.deviations(), []);
}

/// A short session, recorded: two queries and two settings.
fn short_session() -> Recording {
    let robot = jaka_tests::controller();
    let ((), recording) = recorded(|config| {
        let mut client = config.connect(robot.command_addr()).expect("the controller listens");
        client.rapid_rate(0.5).expect("it answers");
        robot.set_state(|state| state.joint_position = [1.0; 6].into());
        client.get_joint_pos().expect("it answers");
        client.rapid_rate(0.25).expect("it answers");
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
    let error = client.rapid_rate(0.25).expect_err("another one was recorded");
    assert!(error.is_disconnected());
    let [Deviation::OtherRequest { expected, received }] = &controller.deviations()[..] else { panic!("there is one") };
    assert_eq!(expected, r#"{"cmdName":"get_joint_pos"}"#);
    assert_eq!(received, r#"{"cmdName":"rapid_rate","rate_value":0.25}"#);
    // A further connection is one too many.
    let mut client = Client::connect(controller.command_addr()).expect("the controller listens");
    assert!(client.get_version().is_err_and(|error| error.is_disconnected()));
    let deviations = controller.deviations();
    assert_eq!(deviations[1], Deviation::Connection { port: Port::Command, recorded: 1 });
    assert_eq!(deviations[1].to_string(), "a connection to the command port beyond the 1 of the recording");
}

#[test]
fn requests_too_few_and_too_many_are_deviations() {
    let recording = short_session();
    let controller = replay(&recording, Replay::Strict);
    let mut client = Client::connect(controller.command_addr()).expect("the controller listens");
    client.rapid_rate(0.5).expect("it was recorded");
    assert!(!controller.wait_for_deviations(1, Duration::ZERO));
    drop(client);
    assert!(controller.wait_for_deviations(1, LIMIT));
    let expected = r#"{"cmdName":"get_joint_pos"}"#.to_owned();
    assert_eq!(controller.deviations(), [Deviation::MissingRequest { expected }]);

    let controller = replay(&recording, Replay::Strict);
    let mut client = Client::connect(controller.command_addr()).expect("the controller listens");
    client.rapid_rate(0.5).expect("it was recorded");
    client.get_joint_pos().expect("it was recorded");
    client.rapid_rate(0.25).expect("it was recorded");
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
    client.rapid_rate(0.25).expect("it was recorded");
    // From another connection, too.
    let mut client = Client::connect(controller.command_addr()).expect("the controller listens");
    assert_eq!(client.get_joint_pos().expect("it was recorded").joint_position, [2.0; 6].into());
    assert_eq!(controller.deviations(), []);
    for refused in [client.rapid_rate(0.3), client.rapid_rate(0.25), client.get_joint_pos().map(drop)] {
        let error = refused.expect_err("the recording has none, or none any more");
        assert!(error.to_string().contains("the recording has no reply left to this request"), "{error}");
    }
    client.rapid_rate(0.5).expect("it was recorded");
    let deviations: Vec<_> = controller.deviations().iter().map(ToString::to_string).collect();
    assert_eq!(deviations[0], r#"the recording has no reply left to `{"cmdName":"rapid_rate","rate_value":0.3}`"#);
    assert_eq!(deviations.len(), 3);
}

#[test]
fn matching_keeps_silent_and_closes_where_the_controller_did() {
    let robot = jaka_tests::controller();
    let program = |config: &Config, address| {
        let mut client = config.connect(address).expect("the controller listens");
        let silent = client.call_within(&GetJointPos, SHORT).expect_err("no reply comes");
        client.rapid_rate(0.5).expect("it answers");
        (silent.to_string(), client.get_version().expect_err("the controller closes").to_string())
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

/// A writer that waits until it is released.
#[derive(Debug, Clone, Default)]
struct Gate {
    is_open: Arc<(Mutex<bool>, Condvar)>,
    tape: Tape,
}

impl Write for Gate {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let (is_open, opened) = &*self.is_open;
        let guard = is_open.lock().expect("no test panics while it writes");
        drop(opened.wait_while(guard, |is_open| !*is_open).expect("no test panics while it writes"));
        self.tape.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_writer_that_hangs_delays_no_call_and_what_is_dropped_is_counted() {
    let gate = Gate::default();
    let recorder = Recorder::new(gate.clone()).expect("a thread can be had");
    let robot = jaka_tests::controller();
    let mut client =
        Config::new().recorder(recorder.clone()).connect(robot.command_addr()).expect("the controller listens");
    // Some 10 MB: more than waits.
    let long = json!({"text": "x".repeat(60_000)});
    for _ in 0..170 {
        client.call_raw("get_version", &long).expect("it answers, whether or not the writer hangs");
    }
    *gate.is_open.0.lock().expect("no test panics while it writes") = true;
    gate.is_open.1.notify_all();
    let report = recorder.finish().expect("memory can be written");
    let recording = gate.tape.read();
    let dropped = recording.entries.iter().map(|entry| match entry.event {
        Event::Dropped { count } => count,
        _ => 0,
    });
    assert!(report.dropped > 20, "{report:?}");
    assert_eq!(dropped.sum::<u64>(), report.dropped);
    assert_eq!(report.entries + report.dropped, 1 + 2 * 170);
    // A replay says where it ends.
    let again = replay(&recording, Replay::Strict);
    let mut client = Client::connect(again.command_addr()).expect("the controller listens");
    let answered = (0..170).take_while(|_| client.call_raw("get_version", &long).is_ok()).count();
    assert!(answered > 100 && answered < 170, "{answered}");
    assert!(matches!(again.deviations()[..], [Deviation::Gap { .. }]), "{:?}", again.deviations().len());
}

#[test]
fn errors_have_the_last_messages_only_where_they_are_recorded() {
    let robot = jaka_tests::controller();
    let fails = |config: &Config| {
        let mut client = config.connect(robot.command_addr()).expect("the controller listens");
        for _ in 0..6 {
            client.get_version().expect("it answers");
        }
        client.servo_move(Switch::On).expect_err("the arm has no power")
    };
    let bare = fails(&Config::new());
    assert!(bare.exchanges().is_empty());
    assert_eq!(format!("{bare:#}"), bare.to_string());

    let (error, recording) = recorded(fails);
    assert_eq!(error.to_string(), bare.to_string());
    let messages: Vec<_> = recording.entries.iter().filter(|entry| entry.event.message().is_some()).collect();
    assert_eq!(error.exchanges().iter().collect::<Vec<_>>(), messages[messages.len() - 8..]);
    let long = format!("{error:#}");
    let lines: Vec<_> = long.lines().collect();
    assert_eq!(lines[0], error.to_string());
    assert_eq!(lines[1], "the last messages of the connection, by seconds since the recording began:");
    assert!(lines[8].ends_with(r#" -> {"cmdName":"servo_move","relFlag":1}"#), "{long}");
    assert!(lines[9].contains(r#" <- {"errorCode":"#), "{long}");
    assert_eq!(lines.len(), 10);
}

#[test]
fn errors_of_each_kind_have_the_last_messages() {
    let robot = Controller::builder().delays(Delays::NONE).status_period(Duration::MAX);
    let robot = robot.start().expect("loopback has free ports");
    let ((), _) = recorded(|config| {
        let mut client = config.connect(robot.command_addr()).expect("it listens");
        let with = |error: &Error, count| assert_eq!(error.exchanges().len(), count, "{error:?}");
        robot.inject(Fault::Drop);
        with(&client.call_within(&GetVersion, SHORT).expect_err("no reply comes"), 1);
        robot.inject(Fault::Instead(br#"{"errorCode": "0", "cmdName": "get_joint_pos"}"#.to_vec()));
        let unexpected = client.get_joint_pos().expect_err("the position is missing");
        assert!(matches!(unexpected, Error::UnexpectedReply { .. }));
        with(&unexpected, 3);
        robot.disconnect();
        let lost = client.get_version().expect_err("the connection is lost");
        assert!(lost.is_disconnected());
        with(&lost, 4);
        with(&client.get_version().expect_err("nothing is sent any more"), 4);

        let config = config.clone().reply_timeout(SHORT);
        let mut status = config.connect_status(robot.status_addr()).expect("it listens");
        // The first packet comes at once, which on a busy machine can be later than the timeout.
        while status.next_packet().is_err() {}
        with(&status.next_packet().expect_err("no packet comes"), 1);
        robot.send_status(br#"{"enabled": "perhaps"}"#);
        let mut errors = std::iter::repeat_with(|| status.next_packet().expect_err("it does not fit"));
        with(&errors.find(|error| !error.is_timeout()).expect("the iterator has no end"), 2);
        let monitor: Monitor = config.monitor(robot.status_addr()).expect("it listens");
        monitor.wait_until(|_| true, LIMIT).expect("the first packet comes at once");
        with(&monitor.wait_until(|_| false, SHORT).expect_err("it never does"), 1);
    });
}

#[test]
fn fewer_status_packets_can_be_recorded() {
    let robot = Controller::builder().status_period(Duration::from_millis(5)).start().expect("loopback has free ports");
    let ((), recording) = recorded(|config| {
        let config = config.clone().status_sampling(StatusSampling::EveryNth(4));
        let mut status = config.connect_status(robot.status_addr()).expect("the controller listens");
        for _ in 0..9 {
            status.next_packet().expect("packets come");
        }
    });
    assert_eq!(recording.entries.iter().filter(|entry| entry.event.message().is_some()).count(), 3);
}

#[test]
fn stops_of_another_thread_are_recorded() {
    let robot = jaka_tests::controller();
    let ((), recording) = recorded(|config| {
        let client = config.connect(robot.command_addr()).expect("the controller listens");
        let stop = client.stop_handle();
        std::thread::spawn(move || stop.stop()).join().expect("it does not panic").expect("it answers");
    });
    let answers = recording.answers();
    assert_eq!(answers.len(), 1);
    assert_eq!(answers[0].request.text(), Some(r#"{"cmdName":"stop_program"}"#));
}

#[test]
fn a_file_is_complete_when_the_last_connection_is_dropped() {
    let path = std::env::temp_dir().join(format!("jaka-recording-{}.jsonl", std::process::id()));
    let robot = jaka_tests::controller();
    let recorder = Recorder::create(&path).expect("the folder can be written");
    let mut client = Config::new().recorder(recorder).connect(robot.command_addr()).expect("the controller listens");
    client.get_version().expect("it answers");
    drop(client);
    let file = std::fs::read(&path).expect("it is there");
    std::fs::remove_file(&path).expect("it is there");
    let recording = Recording::read(&file).expect("it is complete");
    assert_eq!((recording.entries.len(), recording.truncated), (4, None));
    assert!(Recorder::create(path.join("no folder")).is_err());
}
