//! Status packets that are odd, from a port that is not a simulator's: what fits is believed, what does not is
//! reported.

use std::io::Write;
use std::net::TcpStream;
use std::time::Duration;

use jaka_proto::wire::{Decode as _, DecodeError, Reader};
use jaka_sim::SimulatedClock;
use jaka_sync::status::RobotStatus;
use jaka_sync::{Config, ErrorKind, Monitor, StatusStream};
use jaka_tests::simulated::beside;
use jaka_tests::{ClockedSocket, LONG, accepted};

/// A stream, and the controller's end of it.
fn stream() -> (TcpStream, StatusStream) {
    accepted(|address| StatusStream::connect_with(&Config::new().reply_timeout(LONG), address))
}

fn monitor() -> (TcpStream, Monitor) {
    accepted(|address| Monitor::connect_with(&Config::new().reply_timeout(LONG).stale_after(LONG), address))
}

fn send(mut to: &TcpStream, bytes: impl AsRef<[u8]>) {
    to.write_all(bytes.as_ref()).expect("it is connected");
}

jaka_sync::status_subset! {
    /// Fields on which a stop depends.
    pub struct Stops { protective_stop, rapid_rate }
}

/// Packets with a protective stop and a field that does not fit, and that field.
const UNFIT: [(&[u8], &str); 7] = [
    (br#"{"len": 60, "rapidrate": "100%", "protective_stop": 1}"#, "rapid_rate"),
    (br#"{"len": 60, "drag_status": 2, "protective_stop": 1}"#, "drag_status"),
    (br#"{"len": 60, "protective_stop": 1, "rapidrate": NaN}"#, "rapid_rate"),
    (br#"{"len": 60, "protective_stop": 1, "errmsg": "\ud83d"}"#, "error_message"),
    (b"{\"len\": 60, \"errmsg\": \"\xc4\xe3\", \"protective_stop\": 1}", "error_message"),
    (br#"{"len": 60, "din": [0, 1, {"new": 1}], "protective_stop": 1}"#, "digital_inputs"),
    (br#"{"len": 60, "rapidrate": 1, "rapidrate": 0.5, "protective_stop": 1}"#, "rapid_rate"),
];

#[test]
fn a_protective_stop_next_to_a_field_that_does_not_fit_is_seen() {
    let (controller, mut status) = stream();
    for (packet, field) in UNFIT {
        send(&controller, packet);
        let found = status.next_packet().expect("the packet stays");
        assert_eq!((found.protective_stop, found.rapid_rate), (Some(true), None), "{field}");
        assert_eq!(fields(status.unfit()), [field]);
    }
    send(&controller, br#"{"len": 26, "rapidrate": 1}"#);
    assert_eq!(status.next_packet().expect("it fits").rapid_rate, Some(1.0));
    assert_eq!(status.unfit(), []);
}

fn fields(unfit: &[DecodeError]) -> Vec<&str> {
    unfit.iter().map(|error| error.field().split(['.', '[']).next().unwrap_or_default()).collect()
}

#[test]
fn a_choice_of_fields_has_those_that_fit() {
    let (controller, mut status) = stream();
    for (packet, field) in UNFIT {
        send(&controller, packet);
        let stops: Stops = status.next_packet_as().expect("the packet stays");
        assert_eq!(stops, Stops { protective_stop: Some(true), rapid_rate: None }, "{field}");
        // A monitor reads into the memory of an earlier packet.
        let mut earlier = Stops { protective_stop: Some(false), rapid_rate: Some(1.0) };
        let text = status.packet_text().expect("it was read");
        earlier.decode_into(&mut Reader::new(text)).expect("the packet stays");
        assert_eq!(earlier, stops, "{field}");
        let told = fields(status.unfit());
        assert_eq!(told, if field == "rapid_rate" { vec![field] } else { vec![] });
    }
}

#[test]
fn a_monitor_says_which_fields_do_not_fit() {
    let (controller, monitor) = monitor();
    let packets = monitor.subscribe(1);
    for (number, (packet, field)) in (1..).zip(UNFIT) {
        send(&controller, packet);
        let found = packets.next_packet_within(LONG).expect("the packet stays");
        assert_eq!((found.number, found.status.protective_stop), (number, Some(true)), "{field}");
        assert_eq!(fields(&found.unfit), [field]);
        assert!(found.is_unfit(field) && !found.is_unfit("protective_stop"), "{field}");
        let statistics = monitor.statistics();
        assert_eq!((statistics.packets, statistics.unfit), (number, number));
    }
    send(&controller, br#"{"len": 26, "rapidrate": 1}"#);
    let found = monitor.wait_until(|status| status.rapid_rate == Some(1.0), LONG).expect("it fits");
    assert_eq!(found.unfit, []);
    let statistics = monitor.statistics();
    assert_eq!((statistics.packets, statistics.unfit), (UNFIT.len() as u64 + 1, UNFIT.len() as u64));
}

#[test]
fn a_stop_that_does_not_fit_is_neither_on_nor_off() {
    let (controller, monitor) = monitor();
    send(&controller, br#"{"len": 40, "protective_stop": 0}"#);
    monitor.wait_until(|status| status.protective_stop == Some(false), LONG).expect("it fits");
    for odd in ["\"yes\"", "2", "[1]", "True", "0, \"protective_stop\": 1", "1e-400"] {
        send(&controller, format!(r#"{{"len": 50, "protective_stop": {odd}}}"#));
        let found = monitor.wait_until(|status| status.protective_stop != Some(false), LONG).expect("the packet stays");
        assert_eq!((found.status.protective_stop, found.is_unfit("protective_stop")), (None, true), "{odd}");
        send(&controller, br#"{"len": 40, "protective_stop": 0}"#);
        monitor.wait_until(|status| status.protective_stop == Some(false), LONG).expect("it fits");
    }
}

#[test]
fn what_is_not_an_object_is_an_error_and_the_stream_goes_on() {
    let (controller, mut status) = stream();
    for odd in [r#"{"len": [0}"#, r#"{"len": 5 "enabled": true}"#, "{len: 5}", r#"{"x": {]}}"#] {
        send(&controller, odd);
        let error = status.next_packet().expect_err(odd);
        assert!(matches!(error.kind(), ErrorKind::UnexpectedStatus { .. }), "{odd}: {error:?}");
        assert_eq!(status.packet_text(), Some(odd));
    }
    send(&controller, br#"{"len": 28, "enabled": true}"#);
    assert_eq!(status.next_packet().expect("it goes on").enabled, Some(true));
}

/// A packet with all that a cut can fall into.
const CUT: &str =
    r#"{"len": 99, "din": [0, 1], "errmsg": "a {\"len\": \\ b", "extio": {"num": 1}, "position": [1, 2]}"#;

#[test]
fn a_stream_finds_the_next_packet_after_one_that_is_cut_anywhere() {
    let (controller, mut status) = stream();
    for (number, end) in (0..).zip(1..CUT.len()) {
        let whole = |number: i64| format!(r#"{{"len": 40, "drag_status": 0, "motion_line": {number}}}"#);
        send(&controller, &CUT[..end]);
        send(&controller, whole(2 * number) + &whole(2 * number + 1));
        let line = |status: RobotStatus| *status.motion_line.expect("the key came").known().expect("it is a number");
        let first = line(status.next_packet().expect("it goes on"));
        assert!(first == 2 * number || first == 2 * number + 1, "after {}", &CUT[..end]);
        if first == 2 * number {
            assert_eq!(line(status.next_packet().expect("it goes on")), 2 * number + 1);
        }
    }
}

#[test]
fn a_monitor_finds_the_next_packet_after_one_that_is_cut_anywhere() {
    let (controller, monitor) = monitor();
    for (number, end) in (0..).zip(1..CUT.len()) {
        let whole = |number: i64| format!(r#"{{"len": 40, "drag_status": 0, "motion_line": {number}}}"#);
        send(&controller, &CUT[..end]);
        send(&controller, whole(2 * number) + &whole(2 * number + 1));
        let wanted = |status: &RobotStatus| {
            let line = status.motion_line.as_ref().and_then(|line| line.known());
            line.is_some_and(|line| *line == 2 * number + 1)
        };
        let found = monitor.wait_until(wanted, LONG).expect("it goes on");
        assert_eq!(found.unfit, []);
    }
    let statistics = monitor.statistics();
    assert_eq!((statistics.resyncs, statistics.unfit), (CUT.len() as u64 - 1, 0));
    assert!(statistics.dropped_bytes >= (1..CUT.len() as u64).sum());
}

#[test]
fn a_stream_on_which_every_packet_is_cut_ends_in_time_and_goes_on() {
    let clock = SimulatedClock::new();
    let config = Config::new().clock(&clock).reply_timeout(Duration::from_millis(50));
    let (mut controller, mut status) =
        ClockedSocket::accepted(&clock, |address| StatusStream::connect_with(&config, address));
    let send_cut_ones = || {
        for _ in 0..1000 {
            controller.write_all(&CUT.as_bytes()[..40]).expect("it is connected");
            clock.sleep(Duration::from_millis(1));
        }
    };
    beside(&clock, send_cut_ones, || {
        let began = clock.elapsed();
        assert!(status.next_packet().expect_err("none is whole").is_timeout());
        assert_eq!(clock.elapsed().saturating_sub(began), Duration::from_millis(50));
    });
    controller.write_all(br#"{"len": 28, "enabled": true}"#).expect("it is connected");
    assert_eq!(status.next_packet().expect("it goes on").enabled, Some(true));
}

#[test]
fn garbage_between_packets_is_passed_over() {
    let (controller, mut status) = stream();
    send(&controller, b"\0\xff} ] {\"no\": {\"packet\": 1}} x{\"len\": 28, \"enabled\": true}");
    assert_eq!(status.next_packet().expect("it is found").enabled, Some(true));
}
