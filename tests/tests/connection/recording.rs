//! Recording sessions.

use std::io::{self, Write};
use std::sync::{Arc, Condvar, Mutex};
use std::time::Duration;

use jaka_proto::recording::{Ending, Entry, Event, Message, Port, Recording};
use jaka_sim::{Builder, Deviation, Fault, Replay, ReplayTiming};
use jaka_sync::kinematics::GetJointPos;
use jaka_sync::power::GetVersion;
use jaka_sync::types::Switch;
use jaka_sync::{Client, Error, ErrorKind, Monitor, Recorder, StatusStream};
use jaka_tests::{Arm, LONG, RecordingBuffer, ReservedPort, events, recorded};
use serde_json::json;

/// Timeout where nothing comes.
const SHORT: Duration = Duration::from_millis(100);

#[test]
fn a_recording_tells_the_whole_session() {
    let (address, recording) = recorded(Arm::simulated(), |arm| {
        let mut client = arm.client();
        client.set_rapid_rate(0.5).expect("it answers");
        arm.inject(Fault::Drop);
        assert!(client.call_within(&GetJointPos::new(), SHORT).is_err_and(|error| error.is_timeout()));
        arm.command_addr()
    });
    let command = |event| (Port::Command, 1, event);
    assert!(recording.header.software.starts_with("jaka-sync "));
    let Event::Connected { address: recorded } = &recording.entries[0].event else { panic!("it begins so") };
    assert_eq!(*recorded, address.to_string());
    assert_eq!(
        events(&recording)[1..],
        [
            command(Event::Sent(Message::new(r#"{"cmdName":"rapid_rate","rate_value":0.5}"#))),
            command(Event::Received(Message::new(r#"{"errorCode": "0", "errorMsg": "", "cmdName": "rapid_rate"}"#))),
            command(Event::Sent(Message::new(r#"{"cmdName":"get_joint_pos"}"#))),
            command(Event::Error { text: "no reply to `get_joint_pos` within 100ms; it may have run".to_owned() }),
            command(Event::Closed { by: Ending::Client, why: "the program has closed it".to_owned() }),
        ]
    );
    let times: Vec<_> = recording.entries.iter().map(|entry| entry.time).collect();
    assert_eq!(times, [Duration::ZERO, Duration::ZERO, Duration::ZERO, Duration::ZERO, SHORT, SHORT]);
}

#[test]
fn connections_that_cannot_be_made_are_recorded() {
    let nobody = ReservedPort::any();
    let address = nobody.address();
    let ((), recording) = recorded(Arm::simulated(), |arm| {
        let error = Client::connect_with(&arm.config(), address).expect_err("nobody listens");
        assert!(error.exchanges().is_empty());
    });
    let [Entry { event: Event::Error { text }, .. }] = &recording.entries[..] else { panic!("{recording:?}") };
    assert!(text.starts_with(&format!("cannot connect to {address}; ")), "{text}");
}

#[test]
fn garbage_between_status_packets_is_recorded_by_monitors() {
    let (skipped, recording) = recorded(Arm::simulated().no_packets(), |arm| {
        let monitor: Monitor = arm.monitor();
        // The first packet has been handed out.
        arm.clock().sleep(SHORT);
        let seen = monitor.subscribe(10);
        for piece in [b"\x01\x02".as_slice(), b"\x03", b"\x04{\"len\": 7}"] {
            arm.send_status(piece);
        }
        assert_eq!(seen.next_packet_within(LONG).expect("the packet is found").status.length, Some(7));
        monitor.statistics().dropped_bytes
    });
    assert!(skipped >= 2);
    let received = recording.entries.iter().filter_map(|entry| entry.event.message());
    let all = received.skip(1).flat_map(Message::bytes).copied().collect::<Vec<_>>();
    assert_eq!(all, b"\x01\x02\x03\x04{\"len\": 7}");
    let last = &recording.entries.last().expect("it has entries").event;
    assert!(matches!(last, Event::Closed { by: Ending::Client, .. }), "{last:?}");
}

/// A writer that waits until it is released.
#[derive(Debug, Clone, Default)]
struct Gate {
    passage: Arc<(Mutex<Passage>, Condvar)>,
    buffer: RecordingBuffer,
}

#[derive(Debug, Default)]
struct Passage {
    somebody_waits: bool,
    is_open: bool,
}

impl Gate {
    fn open(&self) {
        let (passage, changed) = &*self.passage;
        passage.lock().expect("no test panics while it writes").is_open = true;
        changed.notify_all();
    }

    fn wait_until_it_hangs(&self) {
        let (passage, changed) = &*self.passage;
        let guard = passage.lock().expect("no test panics while it writes");
        let waited = changed.wait_timeout_while(guard, LONG, |passage| !passage.somebody_waits);
        assert!(!waited.expect("no test panics while it writes").1.timed_out(), "nothing is written");
    }
}

impl Write for Gate {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let (passage, changed) = &*self.passage;
        let mut guard = passage.lock().expect("no test panics while it writes");
        guard.somebody_waits = true;
        changed.notify_all();
        drop(changed.wait_while(guard, |passage| !passage.is_open).expect("no test panics while it writes"));
        self.buffer.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_writer_that_hangs_delays_no_call_and_what_is_dropped_is_counted() {
    let gate = Gate::default();
    let recorder = Recorder::new(gate.clone()).expect("a thread can be had");
    let (_arm, mut client) = Arm::real_time().config(|config| config.recorder(recorder.clone())).with_client();
    // From here on all waits, however late the writer begins.
    client.get_version().expect("it answers");
    gate.wait_until_it_hangs();
    // Some 10 MB: more than waits.
    let long = json!({"text": "x".repeat(60_000)});
    for _ in 0..170 {
        client.call_raw("get_version", &long).expect("it answers, whether or not the writer hangs");
    }
    gate.open();
    let report = recorder.finish().expect("memory can be written");
    let recording = gate.buffer.read().expect("it has just been written");
    let dropped = recording.entries.iter().map(|entry| match entry.event {
        Event::Dropped { count } => count,
        _ => 0,
    });
    assert!(report.dropped > 20, "{report:?}");
    assert_eq!(dropped.sum::<u64>(), report.dropped);
    assert_eq!(report.entries + report.dropped, 1 + 2 * 171);
    // A replay says where it ends.
    let again = |sim: Builder| sim.replay(recording, Replay::Strict).replay_timing(ReplayTiming::Immediate);
    let (again, mut client) = Arm::real_time().controller(again).with_client();
    client.get_version().expect("its reply is recorded");
    let answered = (0..170).take_while(|_| client.call_raw("get_version", &long).is_ok()).count();
    assert!(answered > 100 && answered < 170, "{answered}");
    assert!(matches!(again.deviations()[..], [Deviation::Gap { .. }]), "{:?}", again.deviations().len());
}

#[test]
fn errors_have_the_last_messages_only_where_they_are_recorded() {
    let fails = |arm: &Arm| {
        let mut client = arm.client();
        for _ in 0..6 {
            client.get_version().expect("it answers");
        }
        client.set_servo_mode(Switch::On).expect_err("the arm has no power")
    };
    let arm = || Arm::simulated().without_power();
    let bare = fails(&arm().start());
    assert!(bare.exchanges().is_empty());
    assert_eq!(format!("{bare:#}"), bare.to_string());

    let (error, recording) = recorded(arm(), fails);
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
    let ((), _) = recorded(Arm::simulated().no_packets(), |arm| {
        let mut client = arm.client();
        let with = |error: &Error, count| assert_eq!(error.exchanges().len(), count, "{error:?}");
        arm.inject(Fault::Drop);
        with(&client.call_within(&GetVersion::new(), SHORT).expect_err("no reply comes"), 1);
        arm.inject(Fault::Instead(br#"{"errorCode": "0", "cmdName": "get_joint_pos"}"#.to_vec()));
        let unexpected = client.get_joint_pos().expect_err("the position is missing");
        assert!(matches!(unexpected.kind(), ErrorKind::UnexpectedReply { .. }));
        with(&unexpected, 3);
        arm.disconnect();
        let lost = client.get_version().expect_err("the connection is lost");
        assert!(lost.is_disconnected());
        with(&lost, 4);
        with(&client.get_version().expect_err("nothing is sent any more"), 4);

        let config = arm.config().reply_timeout(SHORT);
        let mut status = StatusStream::connect_with(&config, arm.status_addr()).expect("it listens");
        status.next_packet().expect("the first packet comes at once");
        with(&status.next_packet().expect_err("no packet comes"), 1);
        arm.send_status(br#"{"enabled" true}"#);
        with(&status.next_packet().expect_err("it does not fit"), 2);
        let monitor: Monitor = arm.monitor();
        with(&monitor.wait_until(|_| false, SHORT).expect_err("it never does"), 1);
    });
}

#[test]
fn fewer_status_packets_can_be_recorded() {
    let arm = Arm::simulated().config(|config| config.recorded_status_interval(Duration::from_millis(120)));
    let ((), recording) = recorded(arm, |arm| {
        let mut status = arm.stream();
        for _ in 0..9 {
            status.next_packet().expect("packets come");
        }
    });
    assert_eq!(recording.entries.iter().filter(|entry| entry.event.message().is_some()).count(), 3);
}

#[test]
fn stops_of_another_thread_are_recorded() {
    let ((), recording) = recorded(Arm::real_time(), |arm| {
        let client = arm.client();
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
    let recorder = Recorder::create(&path).expect("the folder can be written");
    let arm = Arm::simulated().start();
    let config = arm.config().recorder(recorder);
    let mut client = Client::connect_with(&config, arm.command_addr()).expect("the controller listens");
    drop(config);
    client.get_version().expect("it answers");
    drop(client);
    let file = std::fs::read(&path).expect("it is there");
    std::fs::remove_file(&path).expect("it is there");
    let recording = Recording::read(&file).expect("it is complete");
    assert_eq!((recording.entries.len(), recording.truncated), (4, None));
    assert!(Recorder::create(path.join("no folder")).is_err());
}
