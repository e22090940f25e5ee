//! The monitor against the simulator: the newest packet, waiting, queues, losses and reconnection.

use std::ops::ControlFlow;
use std::sync::{Arc, Mutex};
use std::time::Duration;

use jaka_proto::wire::{Decode, DecodeError, Reader};
use jaka_sim::{Controller, StatusFault};
use jaka_sync::status::RobotStatus;
use jaka_sync::types::JointPosition;
use jaka_sync::{Monitor, Reconnect};
use jaka_tests::simulated::beside;
use jaka_tests::{Arm, LONG, ReservedPort};

/// A controller that sends packets when told to, and a monitor that has had the first.
fn quiet() -> (Arm, Monitor) {
    let controller = Arm::simulated().without_power().no_packets().config(|config| config.stale_after(LONG)).start();
    let monitor = controller.monitor();
    settle(&controller);
    (controller, monitor)
}

/// Lets the monitor's thread come to rest: all packets so far have been handed out.
fn settle(controller: &Arm) {
    controller.clock().sleep(Duration::from_millis(1));
}

fn put(controller: &Controller, angle: f64) {
    controller.set_state(|state| state.joint_position = [angle; 6].into());
    controller.publish();
}

#[test]
fn it_wakes_who_waits() {
    let (controller, monitor) = quiet();
    let wait = || {
        let found = monitor.wait_until(|status| status.powered_on == Some(true), LONG).expect("the packet comes");
        assert_eq!(found.status.powered_on, Some(true));
    };
    let began = controller.clock().elapsed();
    beside(controller.clock(), wait, || {
        settle(&controller);
        put(&controller, 1.0);
        settle(&controller);
        controller.set_state(|state| state.powered = true);
        controller.publish();
    });
    // Two times of settling, and not the timeout.
    assert_eq!(controller.clock().elapsed().saturating_sub(began), Duration::from_millis(2));
    // The newest packet counts, too.
    monitor.wait_until(|status| status.powered_on == Some(true), Duration::ZERO).expect("it is here already");
}

#[test]
fn it_keeps_the_newest_however_fast_packets_come() {
    let (controller, monitor) = quiet();
    let slow = monitor.subscribe(10);
    for n in 0..500 {
        put(&controller, f64::from(n) / 10.0);
    }
    let is_last = |status: &RobotStatus| status.joint_actual_position == Some(JointPosition([49.9; 6]));
    let last = monitor.wait_until(is_last, LONG).expect("the last packet comes");
    settle(&controller);
    assert_eq!(monitor.newest_packet().expect("it is connected").expect("there is one").number, last.number);
    // The queue holds the last ones, and counts those it dropped; those that were passed over came to it, too.
    let kept: Vec<_> = std::iter::from_fn(|| slow.try_next_packet()).collect();
    assert!(kept.len() <= 10 && is_last(&kept[kept.len() - 1].status));
    assert!(kept.is_sorted_by_key(|snapshot| snapshot.number));
    let statistics = monitor.statistics();
    assert_eq!(statistics.packets + statistics.skipped, 501);
    assert_eq!(500, slow.dropped() + kept.len() as u64);
}

#[test]
fn observers_are_called_until_they_break() {
    let (controller, monitor) = quiet();
    let (sender, receiver) = std::sync::mpsc::channel();
    monitor.observe(move |snapshot| {
        let wanted = snapshot.status.joint_actual_position.map_or(0.0, |joints| joints.0[0]);
        sender.send(wanted).expect("the test listens");
        if wanted < 3.0 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    });
    for n in 1..=5 {
        put(&controller, f64::from(n));
        let is_here = |status: &RobotStatus| status.joint_actual_position == Some([f64::from(n); 6].into());
        monitor.wait_until(is_here, LONG).expect("the packet comes");
    }
    // The sender went with the observer, so the channel ends.
    assert_eq!(receiver.iter().map(f64::to_bits).collect::<Vec<_>>(), [1.0, 2.0, 3.0].map(f64::to_bits));
}

#[test]
fn an_observer_that_panics_is_not_called_again_and_the_monitor_goes_on() {
    let (controller, monitor) = quiet();
    let (sender, receiver) = std::sync::mpsc::channel();
    monitor.observe(move |_| {
        sender.send(()).expect("the test listens");
        panic!("by the test");
    });
    let packets = monitor.subscribe(8);
    for n in 1..=3 {
        put(&controller, f64::from(n));
        packets.next_packet_within(LONG).expect("the packet comes");
    }
    assert_eq!(receiver.iter().count(), 1);
    assert!(monitor.newest_packet().is_ok_and(|latest| latest.is_some()) && !packets.is_closed());
}

#[test]
fn an_observer_may_drop_the_monitor() {
    let (controller, monitor) = quiet();
    let packets = monitor.subscribe(8);
    let monitor = Arc::new(Mutex::new(Some(monitor)));
    let held = Arc::clone(&monitor);
    let observe = |monitor: &Monitor| {
        monitor.observe(move |_| {
            held.lock().expect("nobody panics").take();
            ControlFlow::Continue(())
        });
    };
    observe(monitor.lock().expect("nobody panics").as_ref().expect("it is there"));
    put(&controller, 1.0);
    packets.next_packet_within(LONG).expect("the packet comes");
    // Its thread comes to its end, and ends the subscription.
    assert!(packets.next_packet_within(LONG).is_none());
    assert!(monitor.lock().expect("nobody panics").is_none());
}

#[test]
fn a_silent_controller_is_stale_and_a_timeout() {
    let (controller, monitor) = quiet();
    let error = monitor.wait_until(|status| status.enabled == Some(true), Duration::from_millis(20)).expect_err("no");
    let expected = format!("no status packet from {} within 20ms; ", controller.status_addr());
    assert!(error.to_string().starts_with(&expected), "{error}");
    assert!(!monitor.is_stale());

    let (controller, monitor) = quiet();
    let newest = monitor.newest_packet().expect("the connection is there").expect("one has come");
    controller.clock().sleep(LONG.saturating_sub(newest.age()));
    assert!(!monitor.is_stale(), "it is as old as it may be");
    monitor.wait_until(|_| true, Duration::ZERO).expect("it is not too old");
    controller.clock().sleep(Duration::from_nanos(1));
    // What is stale does not count, whatever it says.
    assert!(monitor.is_stale());
    assert!(monitor.wait_until(|_| true, Duration::from_millis(50)).is_err_and(|error| error.is_timeout()));
}

#[test]
fn garbage_is_skipped_and_counted() {
    let (controller, monitor) = quiet();
    controller.send_status(b"garbage without a brace ");
    put(&controller, 7.0);
    monitor.wait_until(|status| status.joint_actual_position == Some([7.0; 6].into()), LONG).expect("it goes on");
    let statistics = monitor.statistics();
    assert_eq!((statistics.resyncs, statistics.dropped_bytes), (1, 24));
    controller.status_fault(StatusFault::Pieces(7));
    put(&controller, 8.0);
    monitor.wait_until(|status| status.joint_actual_position == Some([8.0; 6].into()), LONG).expect("it goes on");
}

#[test]
fn a_packet_that_cannot_be_read_is_reported_to_a_wait_that_times_out() {
    let (controller, monitor) = quiet();
    controller.send_status(b"{\"len\": 40 \"enabled\": true}");
    let error = monitor.wait_until(|status| status.enabled == Some(true), Duration::from_millis(50));
    let error = error.expect_err("it is not enabled");
    let source = std::error::Error::source(&error).expect("the place is named");
    assert!(source.to_string().starts_with("not JSON: expected `,` or a bracket at byte 11"), "{source}");
    assert_eq!(monitor.statistics().unfit, 1);
}

#[test]
fn an_ended_connection_is_reported_and_nothing_hangs() {
    let (controller, monitor) = quiet();
    let queue = monitor.subscribe(4);
    controller.disconnect();
    let error = monitor.wait_until(|_| false, LONG).expect_err("the connection has ended");
    assert!(error.is_disconnected());
    assert!(monitor.newest_packet().is_err_and(|error| error.is_disconnected()));
    assert!(monitor.last_known_packet().is_some() && monitor.disconnect_cause().is_some());
    assert!(queue.next_packet_within(LONG).is_none() && queue.is_closed());
}

#[test]
fn it_reconnects_if_configured() {
    let controller =
        Arm::simulated().config(|config| config.reconnect(Reconnect::attempts(100)).stale_after(LONG)).start();
    let monitor: Monitor = controller.monitor();
    for n in 1..=3 {
        controller.disconnect();
        let began = controller.clock().elapsed();
        while monitor.statistics().reconnects < n {
            assert!(controller.clock().elapsed().saturating_sub(began) < LONG, "it does not reconnect");
            monitor.next_packet().expect("packets go on");
        }
    }
    let nobody = ReservedPort::any();
    let never: Result<Monitor, _> = Monitor::connect_with(&controller.config(), nobody.address());
    assert!(never.is_err_and(|error| error.is_connect()));
}

#[test]
fn attempts_to_reconnect_come_to_an_end() {
    // Nobody else gets the ports once the controller has gone.
    let ports = [ReservedPort::any(), ReservedPort::any()];
    let [commands, status] = [&ports[0], &ports[1]].map(|port| port.address().port());
    let controller = Arm::simulated()
        .controller(|controller| controller.ports(commands, status))
        .config(|config| config.reconnect(Reconnect::attempts(2)))
        .start();
    let (monitor, clock): (Monitor, _) = (controller.monitor(), controller.clock().clone());
    let began = clock.elapsed();
    drop(controller);
    let error = monitor.wait_until(|_| false, LONG).expect_err("nobody is there any more");
    assert!(error.is_disconnected());
    // It waits before each attempt.
    assert_eq!(clock.elapsed().saturating_sub(began), Duration::from_millis(100 + 200));
}

/// The one field of the packet that the program needs.
#[derive(Debug, PartialEq)]
struct Joints(Option<JointPosition>);

impl Decode for Joints {
    fn decode(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let mut joints = None;
        reader.begin_object()?;
        while let Some(key) = reader.next_key()? {
            match &*key {
                "joint_actual_position" => reader.field("joints", &mut joints)?,
                _ => reader.skip()?,
            }
        }
        Ok(Self(joints))
    }
}

#[test]
fn a_type_of_ones_own_is_decoded_in_place_of_the_whole_packet() {
    let controller = Arm::simulated().start();
    let monitor: Monitor<Joints> = controller.monitor();
    let found = monitor.next_packet().expect("a packet comes");
    assert_eq!(found.status, Joints(Some(controller.state().joint_position)));
}

#[test]
fn monitors_are_shared_between_threads() {
    fn assert_send_and_sync<T: Send + Sync>() {}
    assert_send_and_sync::<Monitor>();
    assert_send_and_sync::<Monitor<Joints>>();
    assert_send_and_sync::<jaka_sync::Subscription<RobotStatus>>();
}

/// A user's type of a packet, with a bug in its decoder.
#[derive(Debug)]
struct Buggy(bool);

impl Decode for Buggy {
    fn decode(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let status = RobotStatus::decode(reader)?;
        assert!(status.powered_on != Some(true), "a bug in the user's program");
        Ok(Self(status.protective_stop == Some(true)))
    }
}

#[test]
fn a_panic_of_a_users_decoder_is_a_packet_that_cannot_be_read_and_the_monitor_goes_on() {
    let (controller, _) = quiet();
    let monitor: Monitor<Buggy> = controller.monitor();
    controller.set_state(|state| state.powered = true);
    controller.publish();
    let error = monitor.wait_until(|_| false, Duration::from_millis(1)).expect_err("it panics");
    assert!(error.to_string().contains("does not fit"), "{error}");
    controller.set_state(|state| {
        state.powered = false;
        state.protective_stop = true;
    });
    controller.publish();
    monitor.wait_until(|packet| packet.0, LONG).expect("the monitor goes on");
}
