//! Problems of a newcomer: wrong addresses, swapped ports, other programs, and controllers that do not answer this
//! client.

use std::io::Write;
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::thread;

use expect_test::{Expect, expect};
use jaka_sim::{Fault, StatusFault, Takeover};
use jaka_tests::{Arm, ReservedPort};

use super::super::jaka_at;
use super::{assert_found, assert_report, found, healthy};

/// Checks the ports at these addresses, in the time of an arm.
fn assert_at(arm: &Arm, commands: SocketAddr, status: SocketAddr, expected: &Expect) {
    assert_report(&jaka_at(arm.config(), [commands, status], ["check", "--yes", "--json"]), expected);
}

#[test]
fn nobody_listens() {
    let (nobody, controller) = (ReservedPort::any(), healthy());
    assert_at(
        &controller,
        nobody.address(),
        controller.status_addr(),
        &expect![[r#"
        command_port: wrong: 127.0.0.1:PORT refuses the connection (Connection refused (os error 111))
          check the address and the port, wait until the controller has started, and end other programs that are connected to this port, such as the vendor's app: it serves one client
    "#]],
    );
    assert_at(
        &controller,
        controller.command_addr(),
        nobody.address(),
        &expect![[r#"
        status_port: wrong: 127.0.0.1:PORT refuses the connection (Connection refused (os error 111))
          check the address and the port, and wait until the controller has started
    "#]],
    );
}

#[test]
fn ports_that_are_mixed_up() {
    let controller = healthy();
    assert_at(
        &controller,
        controller.status_addr(),
        controller.status_addr(),
        &expect![[r#"
        command_port: wrong: this port sends status packets
          this is the status port: commands go to port 10001
    "#]],
    );
    assert_at(
        &controller,
        controller.command_addr(),
        controller.command_addr(),
        &expect![[r#"
        status_port: wrong: the controller closed the connection
          check that this is port 10000 of a controller that is not shutting down
    "#]],
    );
}

#[test]
fn another_client_has_the_seat() {
    let controller = Arm::simulated().controller(|controller| controller.takeover(Takeover::Refuse)).start();
    let _other = TcpStream::connect(controller.command_addr()).expect("it listens");
    controller.wait_until_accepted();
    assert_at(
        &controller,
        controller.command_addr(),
        controller.status_addr(),
        &expect![[r#"
        command_port: wrong: the controller closed the connection
          the command port serves one client: look for another program that is connected to it, and end that one
    "#]],
    );
}

#[test]
fn the_pendant_keeps_control() {
    let denied = br#"{"errorCode":"3","errorMsg":"permission deny, please check remote control source","cmdName":"get_version"}"#;
    assert_found(
        |controller| controller.inject_for("get_version", Fault::Instead(denied.to_vec())),
        &expect![[r#"
        command_port: wrong: the controller refused `get_version` with code 3: permission deny, please check remote control source
          grant remote control at the pendant: the controller may be in local mode
    "#]],
    );
}

#[test]
fn a_controller_that_says_nothing() {
    assert_found(
        |controller| controller.inject_for("get_version", Fault::Drop),
        &expect![[r#"
            command_port: wrong: no reply to `get_version` within 5s
              check that this is port 10001 of a controller that has started, and the network
        "#]],
    );
    assert_found(
        |controller| controller.status_fault(StatusFault::Silent),
        &expect![[r#"
        status_port: wrong: no status packet from 127.0.0.1:PORT within 5s
          check the network, and that this is port 10000; port 10001 sends only replies
    "#]],
    );
}

#[test]
fn packets_that_are_none() {
    let lines = StatusFault::Instead(b"joint_actual_position:(0, 0)\n".to_vec());
    assert_found(
        |controller| controller.status_fault(lines),
        &expect![[r#"
        status_port: wrong: this firmware sends its status as text lines, a form of very old versions: bytes that do not begin a frame: `joint_actual_position:(0, 0)\x0a`
          this firmware is older than the protocol: ask the vendor for newer firmware
    "#]],
    );
    assert_found(
        |controller| controller.status_fault(StatusFault::CloseAfter(0)),
        &expect![[r#"
        status_port: wrong: the controller closed the connection
          check that this is port 10000 of a controller that is not shutting down
    "#]],
    );
    assert_found(
        |controller| controller.status_fault(StatusFault::Instead(b"(nothing of this protocol)".to_vec())),
        &expect![[r#"
            status_port: wrong: no status packet from 127.0.0.1:PORT within 5s; other data came
              check the address and the port: something else may listen there, or a controller that expects TLS
        "#]],
    );
}

#[test]
fn another_service() {
    // This arm does not use a simulated clock.
    let controller = Arm::real_time().start();
    let listener = TcpListener::bind("127.0.0.1:0").expect("loopback has free ports");
    let address = listener.local_addr().expect("it is bound");
    thread::scope(|scope| {
        let service = scope.spawn(|| {
            let (mut client, _) = listener.accept().expect("the program connects");
            client.write_all(b"SSH-2.0-OpenSSH_9.7\r\n").expect("it is connected");
            client
        });
        let report = jaka_at(controller.config(), [address, controller.status_addr()], ["check", "--yes", "--json"]);
        // The finding on the rate of packets, which the machine may slow down, comes last.
        let first: Vec<_> = found(&report).lines().take(2).map(str::to_owned).collect();
        expect![[r#"
            command_port: wrong: bytes that do not begin a frame: `SSH-2.0-OpenSSH_9.7\x0d\x0a`
              check the address and the port: something else may listen there, or a controller that expects TLS"#]]
        .assert_eq(&first.join("\n"));
        assert_eq!(report.code, 9);
        drop(service.join());
    });
}
