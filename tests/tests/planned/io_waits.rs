//! Waits for inputs, by packets that the test writes by hand on plain sockets.

use std::sync::Arc;
use std::time::Duration;

use jaka_robot::jaka_sync::ErrorKind as Failure;
use jaka_robot::{Error, ErrorKind, InputCondition, NotShown, Numbering, Robot, Snapshot, StatusProblem};
use jaka_sim::SimulatedClock;
use jaka_tests::simulated::beside;
use jaka_tests::{ClockedSocket, HandFed, LONG};

const IO: Numbering = Numbering::FromOne;

/// Time between two packets.
const PERIOD: Duration = Duration::from_millis(5);

fn waits() -> (SimulatedClock, HandFed<ClockedSocket>, Robot) {
    let clock = SimulatedClock::new();
    let (controller, robot) = HandFed::by_clock(&clock, LONG);
    (clock, controller, robot)
}

/// Waits while these packets come again and again, 20 in all.
fn while_packets_come(
    clock: &SimulatedClock,
    (controller, robot): (&mut HandFed<ClockedSocket>, &Robot),
    packets: &[&str],
    wait: impl FnOnce() -> Result<Arc<Snapshot>, Error>,
) -> Result<Arc<Snapshot>, Error> {
    let feed = || {
        for packet in packets.iter().cycle().take(20) {
            controller.packet_to(robot, packet);
            clock.sleep(PERIOD);
        }
    };
    beside(clock, feed, wait)
}

#[test]
fn a_level_that_is_there_counts_at_once_and_nothing_is_sent() {
    let (_, mut controller, robot) = waits();
    controller.packet_to(&robot, r#""din": [0, 0, 1], "tio_din": [1, 0], "ain": [0.5, -2.0], "tio_ain": [474.0]"#);
    for condition in [IO.cabinet(3).is_high(), IO.cabinet(1).is_low(), IO.tool(1).is_high(), IO.tool(2).is_low()] {
        let packet = robot.wait_for_input(condition, LONG).unwrap_or_else(|error| panic!("{condition}: {error}"));
        assert_eq!(packet.number, 1, "{condition}");
    }
    for condition in [
        IO.cabinet_analog(1).is_above(0.4),
        IO.cabinet_analog(2).is_below(-1.0),
        IO.tool_analog(1).is_above(473.0),
        Numbering::FromZero.tool_analog(0).is_below(475.0),
    ] {
        let packet = robot.wait_for_analog(condition, LONG).unwrap_or_else(|error| panic!("{condition}: {error}"));
        assert_eq!(packet.number, 1, "{condition}");
    }
    drop(robot);
    assert_eq!(controller.received(), "");
}

#[test]
fn numbers_count_from_where_the_program_says() {
    let (_, mut controller, robot) = waits();
    controller.packet_to(&robot, r#""din": [0, 0, 1, 0]"#);
    let is_high = |condition: InputCondition| match robot.wait_for_input(condition, Duration::ZERO) {
        Ok(_) => true,
        Err(error) if error.is_timeout() => false,
        Err(error) => panic!("{condition}: {error}"),
    };
    let high = |numbering: Numbering, numbers: [usize; 4]| numbers.map(|n| is_high(numbering.cabinet(n).is_high()));
    assert_eq!(high(Numbering::FromZero, [0, 1, 2, 3]), [false, false, true, false]);
    assert_eq!(high(Numbering::FromOne, [1, 2, 3, 4]), [false, false, true, false]);
    let error = robot.wait_for_input(IO.cabinet(0).is_high(), LONG).expect_err("there is none");
    assert!(error.is_invalid_argument(), "{error:?}");
    assert!(error.to_string().contains("at least 1, since inputs are counted from 1"), "{error}");
    let error = robot.wait_for_analog(IO.tool_analog(1).is_above(f64::NAN), LONG).expect_err("it is not a number");
    assert!(error.is_invalid_argument(), "{error:?}");
}

#[test]
fn an_edge_is_one_between_two_packets_after_the_call() {
    let (clock, mut controller, robot) = waits();
    let (low, high) = (r#""din": [0], "tio_ain": [1.0]"#, r#""din": [1], "tio_ain": [3.0]"#);
    controller.packet_to(&robot, high);
    // The level is there all the time, and so there is no edge.
    let stays = PERIOD * 10;
    for wait in [
        &(|| robot.wait_for_input(IO.cabinet(1).rises(), stays)) as &(dyn Fn() -> _ + Sync),
        &(|| robot.wait_for_analog(IO.tool_analog(1).rises_above(2.0), stays)),
    ] {
        let error =
            while_packets_come(&clock, (&mut controller, &robot), &[high], wait).expect_err("it does not change");
        assert!(error.is_timeout(), "{error:?}");
    }
    for (wait, is_high) in [
        (&(|| robot.wait_for_input(IO.cabinet(1).rises(), LONG)) as &(dyn Fn() -> _ + Sync), true),
        (&(|| robot.wait_for_input(IO.cabinet(1).falls(), LONG)), false),
        (&(|| robot.wait_for_analog(IO.tool_analog(1).rises_above(2.0), LONG)), true),
        (&(|| robot.wait_for_analog(IO.tool_analog(1).falls_below(2.0), LONG)), false),
    ] {
        let before = robot.monitor().last_known_packet().map_or(0, |newest| newest.number);
        let packet = while_packets_come(&clock, (&mut controller, &robot), &[high, low], wait).expect("it changes");
        assert_eq!(packet.status.digital_inputs, Some(vec![is_high]));
        assert!(packet.number > before);
    }
}

#[test]
fn a_timeout_tells_what_the_last_packet_says_of_the_input() {
    let (_, mut controller, robot) = waits();
    controller.packet_to(&robot, r#""din": [0, 1], "ain": [0.5]"#);
    let error = robot.wait_for_input(IO.cabinet(1).is_high(), Duration::from_millis(20)).expect_err("it is low");
    assert!(matches!(jaka_tests::failure(&error), Some(Failure::StateTimeout { .. })), "{error:?}");
    assert!(error.to_string().ends_with("the last packet: digital input 1 of the cabinet (counted from 1) is low"));
    let wait = robot.wait_for_analog(IO.cabinet_analog(1).rises_above(2.5), Duration::from_millis(20));
    let text = wait.expect_err("it is not above").to_string();
    assert!(text.ends_with("analog input 1 of the cabinet (counted from 1) is at 0.5"), "{text}");
}

#[test]
fn an_input_that_packets_do_not_show_ends_the_wait_at_once() {
    for (keys, expected) in [
        (r#""tio_din": [1]"#, NotShown::Absent { field: "digital_inputs".to_owned() }),
        (r#""din": [1, 1]"#, NotShown::TooShort { field: "digital_inputs".to_owned(), count: 2 }),
    ] {
        let (_, mut controller, robot) = waits();
        controller.packet_to(&robot, keys);
        let error = robot.wait_for_input(IO.cabinet(3).is_high(), LONG).expect_err("it is not shown");
        let ErrorKind::NotShown { reason, .. } = error.kind() else { panic!("{error:?}") };
        assert_eq!(*reason, expected);
    }
    // In the middle of a wait, too.
    let (clock, mut controller, robot) = waits();
    controller.packet_to(&robot, r#""din": [0]"#);
    let wait = || robot.wait_for_input(IO.cabinet(1).rises(), LONG);
    let packets = [r#""din": [0]"#, r#""din": ["on"]"#];
    let error = while_packets_come(&clock, (&mut controller, &robot), &packets, wait).expect_err("it is not shown");
    assert!(matches!(error.kind(), ErrorKind::NotShown { reason: NotShown::Unfit { .. }, .. }), "{error:?}");
    assert!(!error.may_have_run() && !error.is_timeout());
}

#[test]
fn a_wait_ends_when_the_status_is_no_longer_known() {
    let (clock, stale_after) = (SimulatedClock::new(), Duration::from_millis(100));
    let (mut controller, robot) = HandFed::by_clock(&clock, stale_after);
    controller.packet_to(&robot, r#""din": [0]"#);
    let error = robot.wait_for_input(IO.cabinet(1).is_high(), LONG).expect_err("packets stay away");
    assert!(clock.elapsed() <= stale_after + PERIOD, "{:?}", clock.elapsed());
    assert!(matches!(error.kind(), ErrorKind::WaitEnded { problem: StatusProblem::Stale { .. }, .. }), "{error:?}");
    assert!(
        error.to_string().starts_with(
            "the wait has ended before digital input 1 of the cabinet (counted from 1) is high, because the state of the robot is unknown: the last status"
        ),
        "{error}"
    );

    let (clock, mut controller, robot) = waits();
    controller.packet_to(&robot, r#""din": [0]"#);
    let HandFed { commands, status } = controller;
    let close = || {
        clock.sleep(PERIOD);
        drop(status);
    };
    let error = beside(&clock, close, || robot.wait_for_input(IO.cabinet(1).is_high(), LONG));
    let error = error.expect_err("the connection is lost");
    // The command connection may end, too, which would say more.
    assert_eq!(clock.elapsed(), PERIOD + Duration::from_millis(250));
    assert!(matches!(error.kind(), ErrorKind::WaitEnded { problem: StatusProblem::Ended { .. }, .. }), "{error:?}");
    drop(commands);
}

#[test]
fn a_packet_that_ends_a_silence_is_not_news() {
    let (clock, stale_after) = (SimulatedClock::new(), Duration::from_millis(100));
    let (mut controller, robot) = HandFed::by_clock(&clock, stale_after);
    controller.packet_to(&robot, r#""din": [0]"#);
    let resume = || {
        // Before the wait looks at the age of the newest packet again.
        clock.sleep(stale_after + Duration::from_micros(500));
        controller.packet(r#""din": [1]"#);
    };
    let waited = beside(&clock, resume, || robot.wait_for_input(IO.cabinet(1).is_high(), LONG));
    let error = waited.expect_err("the network may have held the packet back");
    assert!(matches!(error.kind(), ErrorKind::WaitEnded { problem: StatusProblem::Resuming, .. }), "{error:?}");
}
