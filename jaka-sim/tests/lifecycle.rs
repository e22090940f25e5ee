//! Starting and ending.

use std::io::{ErrorKind, Read, Write};
use std::net::{IpAddr, Ipv4Addr, TcpListener, TcpStream};
use std::sync::mpsc;
use std::thread;
use std::time::{Duration, Instant};

use crate::common::{LIMIT, Peer, assert_accepted, fresh, json, request, simulated};
use jaka_sim::{Controller, Fault};

/// Address of loopback whose ports nobody else takes, where the system has more than one.
fn own_address() -> IpAddr {
    if !cfg!(target_os = "linux") {
        return Ipv4Addr::LOCALHOST.into();
    }
    let [_, a, b, c] = std::process::id().to_be_bytes();
    Ipv4Addr::new(127, a | 1 << 7, b, c).into()
}

#[test]
fn dropping_ends_all_and_frees_the_ports() {
    // A period and a client for which a test could not wait.
    let builder = Controller::builder().address(own_address()).status_period(Duration::from_secs(3600));
    let controller = builder.start().expect("there are ports");
    let addresses = [controller.command_addr(), controller.status_addr()];
    let mut commands = Peer::commands(&controller);
    let mut status = [Peer::status(&controller), Peer::status(&controller)];
    controller.inject(Fault::Hold);
    commands.send(request("power_on"));
    assert!(controller.wait_for_requests(1, LIMIT));
    for reader in &mut status {
        reader.receive();
    }
    let start = Instant::now();
    drop(controller);
    assert!(start.elapsed() < LIMIT);
    assert_eq!(commands.read_to_end(), b"");
    assert!(status.iter_mut().all(|reader| reader.read_to_end().is_empty()));
    for address in addresses {
        assert_eq!(TcpStream::connect(address).map_err(|error| error.kind()).err(), Some(ErrorKind::ConnectionRefused));
        TcpListener::bind(address).expect("the port is free");
    }
}

#[test]
fn dropping_does_not_wait_for_clients_who_do_not_read() {
    let controller = fresh();
    let mut peer = Peer::commands(&controller);
    controller.inject(Fault::Instead(vec![b' '; 64 << 20]));
    peer.send(request("power_on"));
    assert!(controller.wait_for_requests(1, LIMIT));
    let start = Instant::now();
    drop(controller);
    assert!(start.elapsed() < LIMIT);
}

#[test]
fn a_newcomer_does_not_wait_for_clients_who_do_not_read() {
    let controller = fresh();
    let mut peer = Peer::commands(&controller);
    controller.inject(Fault::Instead(vec![b' '; 64 << 20]));
    peer.send(request("power_on"));
    assert!(controller.wait_for_requests(1, LIMIT));
    assert_accepted(&Peer::commands(&controller).call("get_version"), "get_version");
}

/// Has a write of the controller wait for a client that has read the first byte of it, and then holds the link.
fn hold_while_it_writes<S: Read + Write>(controller: &Controller, peer: &mut Peer<S>) {
    controller.inject(Fault::Instead(vec![b' '; 64 << 20]));
    peer.send(request("power_on"));
    peer.receive_bytes(1);
    controller.links().hold();
}

/// Fails if this does not end.
fn assert_ends(act: impl FnOnce() + Send + 'static) {
    let (ends, ended) = mpsc::channel();
    thread::spawn(move || {
        act();
        ends.send(()).ok();
    });
    assert_eq!(ended.recv_timeout(LIMIT), Ok(()));
}

#[test]
fn dropping_does_not_wait_for_a_write_on_a_link_that_is_held_since() {
    let controller = fresh();
    let mut peer = Peer::commands(&controller);
    hold_while_it_writes(&controller, &mut peer);
    assert_ends(|| drop(controller));

    let (_, controller) = simulated();
    let mut peer = Peer::simulated_commands(&controller);
    hold_while_it_writes(&controller, &mut peer);
    assert_ends(|| drop(controller));
}

#[test]
fn a_newcomer_does_not_wait_for_a_write_on_a_link_that_is_held_since() {
    let controller = fresh();
    let mut peer = Peer::commands(&controller);
    hold_while_it_writes(&controller, &mut peer);
    let _newcomer = Peer::commands(&controller);
    assert_ends(move || controller.wait_until_accepted());

    let (_, controller) = simulated();
    let mut peer = Peer::simulated_commands(&controller);
    hold_while_it_writes(&controller, &mut peer);
    let _newcomer = Peer::simulated_commands(&controller);
    assert_ends(move || controller.wait_until_accepted());
}

#[test]
fn disconnecting_closes_connections_and_lets_new_ones_in() {
    let controller = fresh();
    for _ in 0..20 {
        let mut commands = Peer::commands(&controller);
        let mut status = Peer::status(&controller);
        controller.disconnect();
        assert_eq!(commands.read_to_end(), b"");
        status.read_to_end();
    }
    assert_accepted(&Peer::commands(&controller).call("get_version"), "get_version");
}

#[test]
fn bytes_are_sent_unasked() {
    let controller = fresh();
    assert_eq!(controller.send(b"{}").map_err(|error| error.kind()), Err(ErrorKind::NotConnected));
    for _ in 0..20 {
        let mut peer = Peer::commands(&controller);
        controller.send(b"{\"errorCode\": \"0\"}").expect("a client is connected");
        assert_eq!(peer.receive(), "{\"errorCode\": \"0\"}");
    }
}

#[test]
fn waiting_for_requests_ends() {
    let controller = fresh();
    assert!(controller.wait_for_requests(0, Duration::ZERO));
    assert!(!controller.wait_for_requests(1, Duration::from_millis(1)));
    let mut peer = Peer::commands(&controller);
    thread::scope(|scope| {
        scope.spawn(|| assert!(controller.wait_for_requests(3, LIMIT)));
        peer.send(request("get_version").repeat(3));
    });
    // The state is that after the requests that were waited for.
    peer.send(request("power_on"));
    assert!(controller.wait_for_requests(4, Duration::MAX));
    assert!(controller.state().powered);
    assert_eq!(controller.requests().last(), Some(&request("power_on")));
    assert!(controller.wait_for_requests(4, Duration::ZERO));
    for _ in 0..4 {
        assert_eq!(json(&peer.receive())["errorCode"], "0");
    }
}

#[test]
fn a_panic_in_a_change_does_not_end_the_controller() {
    let controller = fresh();
    let change = || controller.set_state(|_| panic!("a test fails here"));
    assert!(std::panic::catch_unwind(std::panic::AssertUnwindSafe(change)).is_err());
    assert_accepted(&Peer::commands(&controller).call("power_on"), "power_on");
}
