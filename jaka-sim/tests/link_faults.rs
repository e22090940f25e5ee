//! Links that stall, delay and cut, as plain sockets see them.

use std::io::{ErrorKind, Read};
use std::thread;
use std::time::{Duration, Instant};

use crate::common::{LIMIT, Peer, assert_accepted, document, fresh, json, request, simulated};
use jaka_sim::{Controller, Direction, Fault, Happening, LinkFault, Port, Scheduled, SimulatedClock, Takeover};

/// Time for which nothing comes where nothing must come. A test that waits too short passes, and never fails by chance.
const QUIET: Duration = Duration::from_millis(40);
const DELAY: Duration = Duration::from_millis(150);

/// A controller that sends no packets but those asked for, with a client at each port that has had a message.
fn connected() -> (Controller, Peer, Peer) {
    let controller = fresh();
    let (mut commands, mut status) = (Peer::commands(&controller), Peer::status(&controller));
    assert_accepted(&commands.call("get_version"), "get_version");
    status.receive();
    (controller, commands, status)
}

/// True if neither bytes nor an end come.
fn is_quiet(peer: &Peer) -> bool {
    peer.stream.set_read_timeout(Some(QUIET)).expect("a timeout can be set");
    let peeked = loop {
        match peer.stream.peek(&mut [0]) {
            // The process was stopped for a moment.
            Err(error) if error.kind() == ErrorKind::Interrupted => {}
            peeked => break peeked,
        }
    };
    peer.stream.set_read_timeout(Some(LIMIT)).expect("a timeout can be set");
    peeked.is_err_and(|error| matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut))
}

fn assert_passed(port: Port, peer: &mut Peer) {
    let message = json(&peer.receive());
    match port {
        Port::Command => assert_accepted(&message, "get_version"),
        Port::Status => assert!(message["len"].is_number(), "{message}"),
    }
}

#[test]
fn replies_are_held_and_requests_are_carried_out() {
    let (controller, mut commands, _status) = connected();
    controller.link(Port::Command).to_client().hold();
    commands.send(request("power_on"));
    assert!(controller.wait_for_requests(2, LIMIT));
    assert!(controller.state().powered);
    // Unsolicited bytes come after it, and a fault of a reply works on a link, too.
    controller.inject(Fault::Nameless);
    commands.send(request("get_version"));
    assert!(controller.wait_for_requests(3, LIMIT));
    controller.send(b"{}").expect("a client is connected");
    assert!(is_quiet(&commands));
    controller.link(Port::Command).release();
    assert_accepted(&json(&commands.receive()), "power_on");
    assert!(json(&commands.receive())["cmdName"].is_null());
    assert_eq!(commands.receive(), "{}");
}

#[test]
fn a_late_reply_comes_although_requests_are_held() {
    let (controller, mut commands, _status) = connected();
    controller.inject(Fault::Delay(DELAY));
    commands.send(request("get_payload"));
    assert!(controller.wait_for_requests(2, LIMIT));
    controller.link(Port::Command).to_controller().hold();
    commands.send(request("power_on"));
    assert_accepted(&json(&commands.receive()), "get_payload");
    assert!(is_quiet(&commands));
    assert!(!controller.state().powered);
}

#[test]
fn a_change_is_for_what_is_under_way() {
    for direction in Direction::ALL {
        let (controller, mut commands, _status) = connected();
        let link = controller.link(Port::Command).direction(direction);
        link.delay(Duration::from_secs(3600));
        commands.send(request("get_version"));
        assert!(is_quiet(&commands));
        link.delay(Duration::ZERO);
        assert_accepted(&json(&commands.receive()), "get_version");
        link.delay(Duration::MAX);
        commands.send(request("get_version"));
        assert!(is_quiet(&commands));
        link.release();
        assert_accepted(&json(&commands.receive()), "get_version");
        assert_accepted(&commands.call("get_version"), "get_version");
    }
}

#[test]
fn a_cut_connection_shows_no_end() {
    // Whatever the controller does with it, but close all by its owner.
    let ends: [fn(&Controller); 3] = [
        |controller| drop(Peer::commands(controller)),
        |controller| controller.take_over().expect("loopback has ports"),
        |controller| {
            controller.inject_always(Fault::Reset);
            assert!(controller.send(b"{}").is_ok());
        },
    ];
    for end in ends {
        let (controller, mut commands, status) = connected();
        controller.links().to_client().cut();
        end(&controller);
        commands.send(request("get_version"));
        assert!(is_quiet(&commands) && is_quiet(&status));
        controller.links().release();
        controller.clear_faults();
        assert!(is_quiet(&commands) && is_quiet(&status));
        // A connection that is made now is not cut.
        assert_accepted(&Peer::commands(&controller).call("get_version"), "get_version");
        controller.disconnect();
        commands.read_to_end();
    }
}

#[test]
fn a_connection_that_is_made_while_the_link_is_cut_stays_cut() {
    let controller = fresh();
    controller.links().cut();
    let (mut commands, status) = (Peer::commands(&controller), Peer::status(&controller));
    commands.send(request("power_on"));
    assert!(is_quiet(&commands) && is_quiet(&status));
    controller.links().release();
    commands.send(request("power_on"));
    assert!(is_quiet(&commands) && is_quiet(&status));
    assert!(!controller.state().powered);
}

#[test]
fn new_connections_are_held_as_well() {
    let controller = fresh();
    controller.links().hold();
    let (mut commands, mut status) = (Peer::commands(&controller), Peer::status(&controller));
    commands.send(request("get_version"));
    assert!(is_quiet(&commands) && is_quiet(&status));
    controller.links().release();
    assert_passed(Port::Command, &mut commands);
    assert_passed(Port::Status, &mut status);
}

#[test]
fn the_end_of_a_connection_is_held_after_its_last_bytes() {
    let (controller, mut commands, _status) = connected();
    controller.link(Port::Command).to_client().hold();
    commands.send(request("quit"));
    // The controller is done with it, and the client does not know.
    assert!(controller.wait_for_disconnect(LIMIT));
    assert!(is_quiet(&commands));
    controller.links().release();
    assert_accepted(&json(&commands.receive()), "quit");
    assert_eq!(commands.read_to_end(), b"");

    let (controller, mut commands, _status) = connected();
    controller.link(Port::Command).to_client().hold();
    let mut newcomer = Peer::commands(&controller);
    newcomer.send(request("get_version"));
    assert!(controller.wait_for_requests(2, LIMIT));
    assert!(is_quiet(&commands));
    controller.links().release();
    assert_eq!(commands.read_to_end(), b"");
    assert_passed(Port::Command, &mut newcomer);
}

#[test]
fn a_reset_is_held_too() {
    let (controller, mut commands, _status) = connected();
    controller.link(Port::Command).to_client().hold();
    controller.inject(Fault::Reset);
    commands.send(request("get_version"));
    assert!(controller.wait_for_disconnect(LIMIT));
    assert!(is_quiet(&commands));
    controller.links().release();
    let error = commands.stream.read_exact(&mut [0]).expect_err("the reset is an error");
    assert_eq!(error.kind(), ErrorKind::ConnectionReset);
}

#[test]
fn a_refused_newcomer_does_not_know_while_the_link_is_held() {
    let controller = Controller::builder().takeover(Takeover::Refuse).start().expect("loopback has ports");
    let mut commands = Peer::commands(&controller);
    assert_accepted(&commands.call("get_version"), "get_version");
    controller.link(Port::Command).hold();
    let mut newcomer = Peer::commands(&controller);
    assert!(is_quiet(&newcomer));
    controller.links().release();
    assert_eq!(newcomer.read_to_end(), b"");
    assert_accepted(&commands.call("get_version"), "get_version");
}

#[test]
fn the_end_of_a_client_is_held_and_delayed_too() {
    let (controller, commands, _status) = connected();
    controller.link(Port::Command).to_controller().hold();
    drop(commands);
    assert!(!controller.wait_for_disconnect(QUIET));
    controller.links().release();
    assert!(controller.wait_for_disconnect(LIMIT));

    let (controller, mut commands, _status) = connected();
    controller.link(Port::Command).to_controller().delay(DELAY);
    let began = Instant::now();
    commands.send(request("power_on"));
    drop(commands);
    assert!(controller.wait_for_disconnect(LIMIT));
    assert!(began.elapsed() >= DELAY);
    assert!(controller.state().powered);
}

#[test]
fn a_half_open_connection_obeys_its_link() {
    let (controller, mut commands, _status) = connected();
    controller.inject(Fault::HalfOpen);
    commands.send(request("get_version"));
    assert!(controller.wait_for_requests(2, LIMIT));
    controller.link(Port::Command).hold();
    drop(commands);
    assert!(!controller.wait_for_disconnect(QUIET));
    controller.links().release();
    assert!(controller.wait_for_disconnect(LIMIT));
}

#[test]
fn no_thread_waits_for_a_link() {
    let faults = [LinkFault::Hold, LinkFault::Cut, LinkFault::Delay(Duration::MAX), LinkFault::Slow(0)];
    let ends: [fn(Controller); 2] = [drop, |controller| controller.disconnect()];
    for fault in faults {
        for end in ends {
            let (controller, mut commands, mut status) = connected();
            controller.links().set(fault);
            commands.send(request("get_version").repeat(10));
            controller.publish();
            controller.send_status(&vec![b' '; 100_000]);
            controller.send(&vec![b' '; 100_000]).expect("a client is connected");
            let began = Instant::now();
            end(controller);
            commands.read_to_end();
            status.read_to_end();
            assert!(began.elapsed() < LIMIT);
        }
    }
}

#[test]
fn too_much_that_waits_ends_the_connection() {
    const MIB: usize = 1 << 20;
    let (clock, controller) = simulated();
    let mut commands = Peer::simulated_commands(&controller);
    let mut status = Peer::simulated_status(&controller);
    assert_accepted(&commands.call("get_version"), "get_version");
    status.receive();
    controller.links().to_client().hold();
    for _ in 0..20 {
        controller.send_status(&vec![b' '; MIB]);
    }
    let sent = (0..20).filter(|_| controller.send(&vec![b' '; MIB]).is_ok()).count();
    assert_eq!(sent, 16);
    assert!(commands.is_quiet_for(DELAY) && status.is_quiet_for(DELAY));
    let place = clock.participant();
    controller.links().release();
    let status = thread::spawn(move || place.run(|| status.read_to_end().len()));
    // What could not be sent is not missing where it was not taken.
    assert_eq!(commands.receive_bytes(16 * MIB), vec![b' '; 16 * MIB]);
    assert_eq!(clock.outside(|| status.join()).expect("no panic"), 16 * MIB);
    assert_accepted(&commands.call("get_version"), "get_version");
}

#[test]
fn a_link_may_begin_with_a_fault() {
    let mut builder = Controller::builder();
    for text in ["link status to-client hold", "link command both delay 150ms", "link command both none at 3600s"] {
        let Scheduled { happening, at } = text.parse().expect("it can happen");
        builder = builder.at(at, happening);
    }
    let controller = builder.start().expect("there are ports");
    let (mut commands, mut status) = (Peer::commands(&controller), Peer::status(&controller));
    let began = Instant::now();
    assert_accepted(&commands.call("get_version"), "get_version");
    // There and back.
    assert!(began.elapsed() >= DELAY * 2);
    assert!(is_quiet(&status));
    controller.links().release();
    assert_passed(Port::Status, &mut status);
    assert_accepted(&commands.call("get_version"), "get_version");
}

#[test]
fn a_link_changes_in_its_cycle_though_nobody_asks_the_controller() {
    let on_status = |direction, fault| Happening::Link { port: Some(Port::Status), direction, fault };
    let clock = SimulatedClock::new();
    let builder = document().status_period(Duration::from_millis(10)).clock(&clock);
    let builder = builder.at(Duration::ZERO, on_status(None, LinkFault::Hold));
    let controller = builder.at(DELAY, on_status(None, LinkFault::None)).start().expect("loopback has ports");
    let cut = on_status(Some(Direction::ToClient), LinkFault::Cut);
    controller.at(DELAY * 2, cut).expect("a thread starts");
    let mut status = Peer::simulated_status(&controller);
    // Those of 0 ms to 150 ms have waited for the first cycle after that.
    for _ in 0..=15 {
        status.receive();
        assert_eq!(clock.elapsed(), Duration::from_millis(152));
    }
    for count in 16..=30 {
        status.receive();
        assert_eq!(clock.elapsed(), Duration::from_millis(10) * count);
    }
    assert!(status.is_quiet_for(LIMIT));
}

#[test]
fn with_a_time_scale_a_link_changes_as_early() {
    let clock = SimulatedClock::new();
    let builder = document().clock(&clock).time_scale(10.0).status_period(Duration::MAX);
    let builder = builder.at(Duration::ZERO, LinkFault::Hold);
    let controller = builder.at(Duration::from_secs(8), LinkFault::None).start().expect("loopback has ports");
    let mut status = Peer::simulated_status(&controller);
    status.receive();
    assert_eq!(clock.elapsed(), Duration::from_millis(800));
}
