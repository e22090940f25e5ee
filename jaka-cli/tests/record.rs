//! `jaka record` and `--record`, with simulated and scripted controllers.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]
#![cfg(unix)]

use std::fs;
use std::io::{BufReader, ErrorKind, Read, Write};
use std::net::{Shutdown, SocketAddr, TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdout};
use std::thread;
use std::time::Duration;

use expect_test::expect;
use jaka_sim::{Controller, Replay};
use jaka_sync::recording::{Ending, Event, Message, Port, Recording};
use jaka_sync::{Client, Config, Error, Recorder, StatusStream};
use jaka_tests::{Arm, LONG, ReservedPort};
use socket2::SockRef;

use crate::common::{self, end, interrupt, started};
use crate::program::{address_of, command, jaka, scratch};

/// The path of a recording that does not exist yet.
fn recording_path(name: &str) -> PathBuf {
    let path = scratch(name);
    fs::remove_file(&path).ok();
    path
}

fn read(path: &Path) -> Recording {
    let recording = Recording::read(&fs::read(path).unwrap()).unwrap();
    assert_eq!(recording.truncated, None);
    recording
}

/// Events of a connection, without its beginning.
fn events(recording: &Recording, connection: u32) -> Vec<&Event> {
    let entries = recording.entries.iter().filter(|entry| entry.connection == connection);
    entries.map(|entry| &entry.event).filter(|event| !matches!(event, Event::Connected { .. })).collect()
}

/// The texts of a connection's messages, each with its direction.
fn messages(recording: &Recording, connection: u32) -> Vec<String> {
    let line = |event: &&Event| event.message().map(|message| format!("{} {message}", event.word()));
    events(recording, connection).iter().filter_map(line).collect()
}

/// A proxy at work.
struct Proxy {
    path: PathBuf,
    child: Child,
    _out: BufReader<ChildStdout>,
    commands: SocketAddr,
    status: SocketAddr,
}

impl Proxy {
    /// One that records to this file, before the robot that the options name.
    fn start(name: &str, options: &[String]) -> Self {
        let path = recording_path(name);
        let mut line = command(["record", &path.display().to_string(), "--listen", "127.0.0.1"]);
        line.args(["--listen-commands", "0", "--listen-status", "0"]).args(options);
        let (child, out, line) = started(&mut line);
        let addresses = line.trim_end().strip_prefix("commands at ").unwrap().split_once(", status at ").unwrap();
        let (commands, status) = (addresses.0.parse().unwrap(), addresses.1.parse().unwrap());
        Self { path, child, _out: out, commands, status }
    }

    /// One before a command port that the test plays.
    fn before(name: &str, robot: &TcpListener) -> Self {
        let port = robot.local_addr().unwrap().port().to_string();
        Self::start(name, &["-r", "127.0.0.1", "--command-port", &port].map(str::to_owned))
    }

    /// Interrupts the proxy, and returns its recording.
    fn finish(self) -> Recording {
        interrupt(&self.child);
        assert_eq!(end(self.child).code(), Some(0));
        read(&self.path)
    }
}

/// Both ends of a connection through a proxy.
fn connect(proxy: &Proxy, robot: &TcpListener) -> (TcpStream, TcpStream) {
    let client = TcpStream::connect(proxy.commands).unwrap();
    let (robot, _) = robot.accept().unwrap();
    for stream in [&client, &robot] {
        stream.set_read_timeout(Some(LONG)).unwrap();
    }
    (client, robot)
}

fn rest(mut stream: &TcpStream) -> Vec<u8> {
    let mut rest = Vec::new();
    stream.read_to_end(&mut rest).unwrap();
    rest
}

fn is_reset(stream: &TcpStream) -> bool {
    common::read(stream, &mut [0]).is_err_and(|error| error.kind() == ErrorKind::ConnectionReset)
}

/// A session with replies, a refusal and status packets; the packets that were read.
fn session(config: &Config, commands: SocketAddr, status: SocketAddr) -> Result<Vec<String>, Error> {
    let mut packets = StatusStream::connect_with(config, status)?;
    let mut client = Client::connect_with(config, commands)?;
    client.get_version()?;
    assert!(client.enable_robot().is_err_and(|error| error.is_refused()));
    client.power_on()?;
    let text = |stream: &mut StatusStream| {
        stream.next_packet()?;
        Ok(stream.packet_text().unwrap_or_default().to_owned())
    };
    (0..3).map(|_| text(&mut packets)).collect()
}

#[test]
fn a_proxy_records_what_the_client_itself_records() {
    let controller = Arm::real_time().without_power().start();
    let proxy = Proxy::start("proxy.jsonl", &address_of(&controller));
    let path = recording_path("client.jsonl");
    let recorder = Recorder::create(&path).unwrap();
    let packets = session(&controller.config().recorder(recorder.clone()), proxy.commands, proxy.status).unwrap();
    recorder.finish().unwrap();
    assert!(controller.wait_for_disconnect(LONG));
    let (by_client, by_proxy) = (read(&path), proxy.finish());
    let connection = |recording: &Recording, port| {
        let of_port = |entry: &&jaka_sync::recording::Entry| entry.port == port;
        recording.entries.iter().find(of_port).expect("there is one").connection
    };
    let on = |recording, port| messages(recording, connection(recording, port));
    assert_eq!(on(&by_proxy, Port::Command), on(&by_client, Port::Command));
    let passed = on(&by_proxy, Port::Status);
    let read: Vec<_> = packets.iter().map(|packet| format!("received {packet}")).collect();
    assert_eq!(passed[..3], read);

    // And so it can be replayed.
    let again = Controller::builder().replay(by_proxy, Replay::Strict).start().unwrap();
    assert_eq!(session(&controller.config(), again.command_addr(), again.status_addr()).unwrap(), packets);
    assert_eq!(again.deviations(), []);
}

#[test]
fn bytes_pass_unchanged_and_nothing_is_lost_from_the_recording() {
    let robot = TcpListener::bind("127.0.0.1:0").unwrap();
    let proxy = Proxy::before("bytes.jsonl", &robot);
    let (mut client, mut controller) = connect(&proxy, &robot);
    let requests = b"{\"cmdName\":\"a\"}\n{\"cmdName\"  :\"b}\"}xx{\"half".to_vec();
    let replies = [&b"garbage\xff\x00{\"errorCode\":\"0\"}(1,[2])"[..], &vec![b'z'; 30_000]].concat();
    thread::scope(|scope| {
        for (stream, bytes) in [(&mut client, &requests), (&mut controller, &replies)] {
            scope.spawn(move || {
                // In pieces of many sizes.
                let mut bytes = &bytes[..];
                for size in (1..).map(|size| size * size) {
                    let (piece, left) = bytes.split_at(size.min(bytes.len()));
                    stream.write_all(piece).unwrap();
                    bytes = left;
                    if bytes.is_empty() {
                        break;
                    }
                }
                stream.shutdown(Shutdown::Write).unwrap();
            });
        }
    });
    assert!(rest(&controller) == requests && rest(&client) == replies, "the bytes are the same");
    let recording = proxy.finish();
    let recorded = |sent: bool| -> Vec<u8> {
        let is_it = |event: &&&Event| matches!(event, Event::Sent(_)) == sent;
        let of_it = events(&recording, 1).into_iter().filter(|event| is_it(&event)).filter_map(Event::message);
        of_it.flat_map(Message::bytes).copied().collect()
    };
    let without_line_feed: Vec<_> = requests.iter().copied().filter(|byte| *byte != b'\n').collect();
    assert!(recorded(true) == without_line_feed && recorded(false) == replies, "all of them are recorded");
    let messages = messages(&recording, 1);
    for message in ["sent {\"cmdName\"  :\"b}\"}", "sent xx", "received {\"errorCode\":\"0\"}", "received (1,[2])"] {
        assert!(messages.iter().any(|found| found == message), "{message}: {:?}", &messages[..8]);
    }
}

#[test]
fn a_client_that_has_sent_all_still_gets_its_replies() {
    let robot = TcpListener::bind("127.0.0.1:0").unwrap();
    let proxy = Proxy::before("half.jsonl", &robot);
    let (mut client, mut controller) = connect(&proxy, &robot);
    client.write_all(b"{\"cmdName\":\"a\"}").unwrap();
    client.shutdown(Shutdown::Write).unwrap();
    assert_eq!(rest(&controller), b"{\"cmdName\":\"a\"}");
    controller.write_all(b"{\"errorCode\":\"0\"}").unwrap();
    drop(controller);
    assert_eq!(rest(&client), b"{\"errorCode\":\"0\"}");
    let recording = proxy.finish();
    let closed = Event::Closed { by: Ending::Client, why: "the client has closed it".to_owned() };
    let [Event::Sent(_), Event::Received(_), last] = events(&recording, 1)[..] else { panic!("there are three") };
    assert_eq!(last, &closed);
}

#[test]
fn a_client_sees_how_the_controller_ends_the_connection() {
    let robot = TcpListener::bind("127.0.0.1:0").unwrap();
    let proxy = Proxy::before("ends.jsonl", &robot);
    let (client, controller) = connect(&proxy, &robot);
    drop(controller);
    assert_eq!(rest(&client), b"");
    let (mut client, mut controller) = connect(&proxy, &robot);
    controller.write_all(b"{}").unwrap();
    client.read_exact(&mut [0; 2]).unwrap();
    SockRef::from(&controller).set_linger(Some(Duration::ZERO)).unwrap();
    drop(controller);
    assert!(is_reset(&client));
    let recording = proxy.finish();
    let by = |connection| match events(&recording, connection).pop() {
        Some(Event::Closed { by, .. }) => *by,
        _ => panic!("it has ended"),
    };
    assert_eq!([by(1), by(2)], [Ending::Controller, Ending::Failure]);
}

#[test]
fn the_controller_sees_how_a_client_ends_the_connection() {
    let robot = TcpListener::bind("127.0.0.1:0").unwrap();
    let proxy = Proxy::before("leaves.jsonl", &robot);
    let (client, controller) = connect(&proxy, &robot);
    client.shutdown(Shutdown::Write).unwrap();
    assert_eq!(rest(&controller), b"");
    drop(controller);
    assert_eq!(rest(&client), b"");
    let (client, controller) = connect(&proxy, &robot);
    SockRef::from(&client).set_linger(Some(Duration::ZERO)).unwrap();
    drop(client);
    assert!(is_reset(&controller));
    let recording = proxy.finish();
    for connection in [1, 2] {
        assert!(matches!(events(&recording, connection)[..], [Event::Closed { by: Ending::Client, .. }]));
    }
}

#[test]
fn status_readers_are_served_side_by_side_and_packets_thinned_in_the_recording_alone() {
    let controller = Arm::real_time().without_power().start();
    let options = [&address_of(&controller)[..], &["--status-every", "1000"].map(str::to_owned)].concat();
    let proxy = Proxy::start("readers.jsonl", &options);
    let mut readers: Vec<_> =
        (0..3).map(|_| StatusStream::connect_with(&controller.config(), proxy.status).unwrap()).collect();
    for reader in &mut readers {
        reader.next_packet().unwrap();
    }
    readers.pop();
    for _ in 0..5 {
        for reader in &mut readers {
            reader.next_packet().unwrap();
        }
    }
    drop(readers);
    let recording = proxy.finish();
    for connection in 1..=3 {
        assert_eq!(messages(&recording, connection).len(), 1, "{connection}");
    }
}

#[test]
fn a_robot_that_cannot_be_reached_is_reported_and_recorded() {
    let robot = TcpListener::bind("127.0.0.1:0").unwrap();
    let mut proxy = Proxy::before("nobody.jsonl", &robot);
    let (client, controller) = connect(&proxy, &robot);
    let address = robot.local_addr().unwrap();
    // A program that another test is about to start has a copy of the socket, so that dropping it is not enough.
    SockRef::from(&robot).shutdown(Shutdown::Both).unwrap();
    drop((controller, robot));
    let _nobody = ReservedPort::at(address);
    assert_eq!(rest(&client), b"");
    let client = TcpStream::connect(proxy.commands).unwrap();
    assert!(is_reset(&client));
    let mut errors = proxy.child.stderr.take().unwrap();
    let recording = proxy.finish();
    let [Event::Error { text }] = events(&recording, 2)[..] else { panic!("{recording:?}") };
    assert!(text.starts_with("cannot connect to 127.0.0.1:"), "{text}");
    let mut told = String::new();
    errors.read_to_string(&mut told).unwrap();
    assert_eq!(told, format!("warning: {text}\n"));
}

#[test]
fn status_packets_alone_are_recorded_until_there_are_enough() {
    let controller = Arm::real_time().without_power().start();
    let path = recording_path("packets.jsonl");
    let record = |options: &[&str]| {
        let address = address_of(&controller);
        let start = ["record", path.to_str().unwrap(), "--status-only"];
        jaka(start.iter().chain(options).copied().chain(address.iter().map(String::as_str)))
    };
    let run = record(&["--count", "4"]);
    let path_text = path.display();
    let expected = format!("recording the status packets of 127.0.0.1\n{path_text}: 6 entries\nexit code 0\n");
    assert_eq!(run.text(), expected);
    let recording = read(&path);
    assert_eq!(messages(&recording, 1).len(), 4);
    assert!(matches!(recording.entries[5].event, Event::Closed { by: Ending::Client, .. }));

    let text = record(&["--count", "4"]).text().replace(&path.display().to_string(), "packets.jsonl");
    expect![[r#"
        error: packets.jsonl exists already, and recordings are not overwritten
        exit code 2
    "#]]
    .assert_eq(&text);
    // Of those that pass, some are recorded.
    fs::remove_file(&path).unwrap();
    assert_eq!(record(&["--count", "4", "--status-every", "1000"]).code, Some(0));
    assert_eq!(messages(&read(&path), 1).len(), 1);
    // How many come within a time is not known.
    fs::remove_file(&path).unwrap();
    assert_eq!(record(&["--seconds", "0.1"]).code, Some(0));
}

#[test]
fn a_connection_that_is_lost_ends_the_recording() {
    let controller = Arm::real_time().without_power().start();
    let path = recording_path("lost.jsonl");
    let mut line = command(["record", path.to_str().unwrap(), "--status-only"]);
    let (child, _out, _) = started(line.args(address_of(&controller)));
    controller.wait_until_accepted();
    controller.disconnect();
    assert_eq!(end(child).code(), Some(5));
    let recording = read(&path);
    let last = &recording.entries.last().unwrap().event;
    assert!(matches!(last, Event::Closed { by: Ending::Controller, .. }), "{last:?}");
}

#[test]
fn commands_record_their_session() {
    let path = recording_path("call.jsonl");
    let record = ["--record", path.to_str().unwrap()];
    assert_eq!(jaka(["call", "get_version", "--sim"].iter().chain(&record)).code, Some(0));
    let recording = read(&path);
    assert_eq!(messages(&recording, 1)[0], r#"sent {"cmdName":"get_version"}"#);
    assert_eq!(recording.entries.len(), 4);
    // The first recording stays.
    assert_eq!(jaka(["call", "get_version", "--sim"].iter().chain(&record)).code, Some(2));
    assert_eq!(read(&path), recording);
    assert_eq!(jaka(["status", "--sim", "--record", "nowhere/x.jsonl"]).code, Some(6));
}

#[test]
fn a_recording_has_what_open_connections_have_sent_so_far() {
    let robot = TcpListener::bind("127.0.0.1:0").unwrap();
    let cut = Proxy::before("cut.jsonl", &robot);
    let (mut client, mut controller) = connect(&cut, &robot);
    client.write_all(b"{\"cmdName\"").unwrap();
    controller.read_exact(&mut [0; 10]).unwrap();
    assert_eq!(messages(&cut.finish(), 1), ["sent {\"cmdName\""]);
}

#[test]
fn a_recording_of_nothing_is_not_kept() {
    let taken = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = taken.local_addr().unwrap().port().to_string();
    let path = recording_path("nothing.jsonl");
    let file = path.to_str().unwrap();
    let proxy = jaka(["record", file, "--sim", "--listen", "127.0.0.1", "--listen-commands", &port]);
    assert_eq!((proxy.code, path.exists()), (Some(6), false), "{}", proxy.err);
    assert!(proxy.err.starts_with(&format!("error: cannot listen at 127.0.0.1, port {port}: ")), "{}", proxy.err);
    assert!(proxy.err.contains("; or `--listen-commands` and `--listen-status` set other ports"), "{}", proxy.err);
    let nobody = ReservedPort::any();
    let port = nobody.address().port().to_string();
    let refused = jaka(["call", "get_version", "-r", "127.0.0.1", "--command-port", &port, "--record", file]);
    assert_eq!((refused.code, path.exists()), (Some(3), false), "{}", refused.err);
    let idle = ["--listen", "127.0.0.1", "--listen-commands", "0", "--listen-status", "0", "--seconds", "0.05"];
    let idle = jaka(["record", file, "--sim"].iter().chain(&idle));
    assert!(idle.out.ends_with("nothing was recorded\n") && !path.exists(), "{}", idle.text());
}

#[test]
fn an_interrupted_command_leaves_a_whole_recording() {
    let path = recording_path("status.jsonl");
    let args = ["status", "--sim", "--watch", "0", "--raw", "--record", path.to_str().unwrap()];
    let (child, out, packet) = started(&mut command(args));
    interrupt(&child);
    // So that it is not kept from ending by what it prints.
    drop(out);
    assert_eq!(end(child).code(), Some(0));
    assert_eq!(messages(&read(&path), 1)[0], format!("received {}", packet.trim_end()));
}

#[test]
fn status_readers_are_bounded_and_commands_go_through() {
    let controller = Arm::real_time().without_power().start();
    let proxy = Proxy::start("readers.jsonl", &address_of(&controller));
    let readers: Vec<_> = (0..80).map(|_| TcpStream::connect(proxy.status).unwrap()).collect();
    let is_served = |reader: &TcpStream| {
        reader.set_read_timeout(Some(LONG)).unwrap();
        common::read(reader, &mut [0]).is_ok_and(|count| count == 1)
    };
    // In the order in which they came.
    let served: Vec<_> = readers.iter().map(is_served).collect();
    assert_eq!(served.iter().filter(|served| **served).count(), 64, "{served:?}");
    assert!(served[..64].iter().all(|served| *served), "{served:?}");
    let mut client = TcpStream::connect(proxy.commands).unwrap();
    client.write_all(br#"{"cmdName":"power_on"}"#).unwrap();
    client.set_read_timeout(Some(LONG)).unwrap();
    assert!(common::read(&client, &mut [0]).is_ok_and(|count| count == 1), "it is answered");
    drop(readers);
    // As soon as one has left, another is served.
    common::wait_until("a reader is served", || is_served(&TcpStream::connect(proxy.status).unwrap()));
    drop(client);
    let recording = proxy.finish();
    assert!(
        recording.entries.iter().any(|entry| entry.event == Event::Sent(Message::new(r#"{"cmdName":"power_on"}"#)))
    );
}

/// The robot decides which of them it serves.
#[test]
fn command_clients_are_not_bounded() {
    let robot = TcpListener::bind("127.0.0.1:0").unwrap();
    // Of a wait for a connection.
    SockRef::from(&robot).set_read_timeout(Some(LONG)).unwrap();
    let proxy = Proxy::before("commands.jsonl", &robot);
    let idle: Vec<_> = (0..80).map(|_| connect(&proxy, &robot)).collect();
    let (mut client, mut controller) = connect(&proxy, &robot);
    client.write_all(b"{}").unwrap();
    let mut request = [0; 2];
    controller.read_exact(&mut request).unwrap();
    assert_eq!(&request, b"{}");
    drop((idle, client, controller));
    proxy.finish();
}
