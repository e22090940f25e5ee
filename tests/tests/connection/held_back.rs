//! A network holds status packets back, and delivers them at once: packets of the silence are not given as news. The
//! controller is a plain socket, and each packet has the time at which it was written.

use std::io::Write;
use std::time::Duration;

use jaka_sim::SimulatedClock;
use jaka_sync::status::RobotStatus;
use jaka_sync::{Config, ErrorKind, Monitor, Snapshot, StatusProblem, StatusStream};
use jaka_tests::simulated::beside;
use jaka_tests::{ClockedSocket, LONG};

const PERIOD: Duration = Duration::from_millis(50);
const STALE_AFTER: Duration = Duration::from_millis(500);
/// Length of a stall.
const HELD: Duration = Duration::from_millis(1500);

/// A controller that stamps its packets, behind a network that can hold them back.
struct Stamping<'c> {
    clock: &'c SimulatedClock,
    socket: ClockedSocket,
    held: Option<Vec<String>>,
}

impl Stamping<'_> {
    /// Writes packets for a time. A part is present at some times.
    fn write_for(&mut self, time: Duration, part_is_present: bool) {
        let until = self.clock.elapsed() + time;
        while self.clock.elapsed() < until {
            let packet = format!(
                r#"{{"len": 100, "rapidrate": {}, "din": [{}], "pad": "{}"}}"#,
                self.clock.elapsed().as_secs_f64(),
                u8::from(part_is_present),
                "x".repeat(8000)
            );
            match &mut self.held {
                Some(held) => held.push(packet),
                None => self.socket.write_all(packet.as_bytes()).expect("the monitor reads"),
            }
            self.clock.sleep(PERIOD);
        }
    }

    /// Delivers the packets one by one, so that the monitor takes each for the newest.
    fn release(&mut self) {
        for packet in self.held.take().expect("packets were held") {
            self.socket.write_all(packet.as_bytes()).expect("the monitor reads");
            self.clock.sleep(Duration::from_millis(2));
        }
    }
}

fn connected(clock: &SimulatedClock) -> (Stamping<'_>, Monitor) {
    let config = Config::new().clock(clock).stale_after(STALE_AFTER).reply_timeout(LONG).connect_timeout(LONG);
    let (socket, monitor) = ClockedSocket::accepted(clock, |address| Monitor::connect_with(&config, address));
    (Stamping { clock, socket, held: None }, monitor)
}

/// Time since a packet was written.
fn true_age(clock: &SimulatedClock, packet: &Snapshot) -> Duration {
    let written = packet.status.rapid_rate.expect("each packet has its time");
    clock.elapsed().saturating_sub(Duration::from_secs_f64(written))
}

fn is_present(status: &RobotStatus) -> bool {
    status.digital_inputs.as_ref().is_some_and(|inputs| inputs[0])
}

#[test]
fn a_wait_takes_no_packet_of_a_silence_for_news() {
    let clock = SimulatedClock::new();
    let (mut controller, monitor) = connected(&clock);
    let act = || {
        controller.write_for(PERIOD * 4, false);
        controller.held = Some(Vec::new());
        // A part passed in the silence; it has gone by the end of it.
        controller.write_for(HELD / 2, true);
        controller.write_for(HELD / 2, false);
        controller.release();
        controller.write_for(PERIOD * 20, false);
        controller.write_for(PERIOD * 20, true);
    };
    beside(&clock, act, || {
        let found = monitor.wait_until(is_present, Duration::from_secs(30)).expect("a part comes");
        assert!(true_age(&clock, &found) < Duration::from_millis(20), "{found:?}");
        assert!(!found.follows_silence);
    });
}

#[test]
fn the_next_packet_is_none_that_was_held_back() {
    let clock = SimulatedClock::new();
    let (mut controller, monitor) = connected(&clock);
    let count = || monitor.statistics().packets + monitor.statistics().skipped;
    let (all, before) = (monitor.subscribe(1000), count());
    let act = || {
        controller.write_for(PERIOD * 4, false);
        controller.held = Some(Vec::new());
        controller.write_for(HELD, false);
        controller.release();
        controller.write_for(PERIOD * 10, false);
    };
    beside(&clock, act, || {
        clock.sleep(PERIOD * 4 + HELD.saturating_sub(Duration::from_millis(10)));
        let next = monitor.next_packet().expect("packets come again");
        assert!(true_age(&clock, &next) < Duration::from_millis(20), "{next:?}");
    });
    // A queue gets all of them, and each says whether it may be old.
    clock.sleep(PERIOD);
    let taken: Vec<_> = std::iter::from_fn(|| all.try_next_packet()).collect();
    assert!(taken.len() >= 4 + 30 + 10 - 1, "{}", taken.len());
    assert_eq!(count() - before, taken.len() as u64, "{:?}", monitor.statistics());
    for packet in &taken {
        let written = Duration::from_secs_f64(packet.status.rapid_rate.expect("each packet has its time"));
        let was_held = written >= PERIOD * 4 && written < PERIOD * 4 + HELD;
        assert!(packet.follows_silence || !was_held, "{packet:?}");
    }
    assert!(!taken[2].follows_silence && !taken[taken.len() - 1].follows_silence);
}

#[test]
fn packets_that_may_all_be_old_are_told() {
    let clock = SimulatedClock::new();
    let (mut controller, monitor) = connected(&clock);
    let act = || {
        controller.write_for(PERIOD, true);
        // Each follows a silence.
        for _ in 0..5 {
            clock.sleep(STALE_AFTER * 2);
            controller.write_for(PERIOD, true);
        }
    };
    beside(&clock, act, || {
        clock.sleep(STALE_AFTER + PERIOD * 2);
        let error = monitor.wait_until(is_present, STALE_AFTER * 4).expect_err("none is known to be new");
        let ErrorKind::StatusUnknown { problem: StatusProblem::Resuming } = error.kind() else { panic!("{error:?}") };
        let text = "the state of the robot is unknown: status packets have just resumed after a silence, and may be old; try again in a \
                    moment";
        assert_eq!(error.to_string(), text);
    });
}

/// Of a reader of packets, too.
#[test]
fn a_stream_tells_packets_that_may_have_been_held_back() {
    let clock = SimulatedClock::new();
    let config = Config::new().clock(&clock).stale_after(STALE_AFTER).reply_timeout(LONG).connect_timeout(LONG);
    let (socket, mut stream) = ClockedSocket::accepted(&clock, |address| StatusStream::connect_with(&config, address));
    let mut controller = Stamping { clock: &clock, socket, held: None };
    let act = || {
        controller.write_for(PERIOD * 4, false);
        controller.held = Some(Vec::new());
        controller.write_for(HELD, false);
        controller.release();
        controller.write_for(PERIOD * 10, false);
    };
    beside(&clock, act, || {
        let mut last = (Duration::ZERO, false);
        for _ in 0..4 + 30 + 10 {
            let packet = stream.next_packet().expect("packets come again");
            let written = Duration::from_secs_f64(packet.rapid_rate.expect("each packet has its time"));
            let was_held = written >= PERIOD * 4 && written < PERIOD * 4 + HELD;
            assert!(stream.follows_silence() || !was_held, "{written:?}");
            assert!(!stream.follows_silence() || written >= PERIOD * 4, "{written:?}");
            last = (written, stream.follows_silence());
        }
        assert!(last.0 >= PERIOD * 4 + HELD && !last.1, "{last:?}");
    });
}
