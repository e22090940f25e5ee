//! Faults on the command port, in the words of their errors. The fault matrix has what each does to each kind of call.

use std::time::Duration;

use jaka_sim::Fault;
use jaka_sync::{Client, Config, ErrorKind, Monitor};
use jaka_tests::{Arm, LONG, ReservedPort};
use serde_json::json;

/// Reply timeout where no reply comes.
const SHORT: Duration = Duration::from_millis(300);

/// The longest message that the client takes.
const MAX_FRAME: usize = 4096;

/// A controller whose next reply has this fault, and a client with a short reply timeout.
fn faulty(fault: Fault) -> (Arm, Client) {
    let arm = Arm::simulated().without_power().config(|config| config.reply_timeout(SHORT).max_frame(MAX_FRAME));
    let (controller, client) = arm.with_client();
    controller.inject(fault);
    (controller, client)
}

#[test]
fn refused_connect() {
    let nobody = ReservedPort::any();
    let address = nobody.address();
    let error = Client::connect(address).expect_err("nobody listens");
    assert!(error.is_connect() && !error.may_have_run());
    let seat = "check the address, that the controller is on, and that no other client, such as the vendor's app, is connected to the command port";
    assert_eq!(error.to_string(), format!("cannot connect to {address}; {seat}"));
    let ErrorKind::Connect { source, .. } = error.kind() else { panic!("it is a connect error") };
    assert_eq!(source.kind(), std::io::ErrorKind::ConnectionRefused);
    // The status port serves any number of clients.
    let error = <Monitor>::connect(address).expect_err("nobody listens");
    let remedy = "check the address, the network, and that the controller is on";
    assert_eq!(error.to_string(), format!("cannot connect to {address}; {remedy}"));
}

#[test]
fn connect_to_a_name_that_does_not_exist() {
    let error = Client::connect("no such host").expect_err("blanks are in no host name");
    assert!(error.is_connect());
    assert_eq!(
        error.to_string(),
        "cannot connect to no such host:10001; check the address, the network, and that the controller is on"
    );
}

#[test]
fn connect_timeout() {
    // A backlog that is full lets further attempts wait without an answer.
    let socket =
        socket2::Socket::new(socket2::Domain::IPV4, socket2::Type::STREAM, None).expect("sockets are to be had");
    let any = std::net::SocketAddr::from(([127, 0, 0, 1], 0));
    socket.bind(&any.into()).expect("loopback has free ports");
    socket.listen(1).expect("it is bound");
    let address = socket.local_addr().ok().and_then(|address| address.as_socket()).expect("it is bound");
    let config = Config::new().connect_timeout(SHORT);
    let mut waiting = Vec::new();
    let error = (0..16)
        .find_map(|_| match Client::connect_with(&config, address) {
            Ok(client) => {
                waiting.push(client);
                None
            }
            Err(error) => Some(error),
        })
        .expect("a backlog of one is full after a few connections");
    let ErrorKind::Connect { source, .. } = error.kind() else { panic!("it is a connect error") };
    assert_eq!(source.kind(), std::io::ErrorKind::TimedOut);
}

#[test]
fn no_reply() {
    let (_controller, mut client) = faulty(Fault::Drop);
    let error = client.get_version().expect_err("no reply comes");
    assert!(error.is_timeout() && error.may_have_run() && !error.is_disconnected());
    assert_eq!(error.to_string(), "no reply to `get_version` within 300ms; it may have run");
    client.get_joint_pos().expect("the connection works");
    assert!(client.disconnect_cause().is_none());
}

#[test]
fn a_broken_connection_tells_its_first_cause_and_sends_nothing_more() {
    for (fault, cause) in [
        (Fault::Nameless, "names no command"),
        (Fault::Renamed("jog".to_owned()), "a reply to `jog` came, but no such request is outstanding"),
        (Fault::Instead(b"HTTP/1.1 400 Bad Request\r\n".to_vec()), "HTTP/1.1 400 Bad Request"),
        (Fault::Before(vec![0, 0, 0]), r"\x00\x00\x00"),
        (Fault::Instead(b"{errorCode: 0}".to_vec()), "not JSON"),
        (Fault::Oversized(MAX_FRAME + 1), "longer than 4096 bytes"),
        (Fault::Close, "the controller closed the connection"),
        (Fault::CloseAfter(17), "in the middle of a message, after 17 bytes of it"),
        (Fault::Reset, "receiving failed"),
    ] {
        let (controller, mut client) = faulty(fault.clone());
        let error = client.get_joint_pos().expect_err("the connection breaks");
        assert!(error.is_disconnected() && error.may_have_run(), "{fault}: {error:?}");
        // Once the controller has seen the end, it has all that was sent.
        assert!(controller.wait_for_disconnect(LONG), "{fault}");
        let text = format!("`get_robot_state` was not sent: the connection to {} is broken", controller.command_addr());
        for _ in 0..2 {
            let error = client.get_robot_state().expect_err("the connection is broken");
            assert!(error.is_disconnected() && !error.may_have_run(), "{fault}: {error:?}");
            assert!(error.to_string().starts_with(&text), "{error}");
            let source = std::error::Error::source(&error).expect("the cause is told");
            assert!(source.to_string().contains(cause), "`{source}` does not say `{cause}`");
        }
        assert_eq!(controller.requests().len(), 1, "{fault}");
        let told = client.disconnect_cause().expect("it can be asked too").to_string();
        assert!(told.contains(cause), "`{told}` does not say `{cause}`");
    }
}

#[test]
fn nothing_is_sent_of_a_request_that_the_spec_forbids() {
    let (controller, mut client) = faulty(Fault::None);
    let error = client.set_rapid_rate(1.5).expect_err("the range is 0 to 1");
    assert!(error.is_invalid_argument() && !error.may_have_run());
    assert_eq!(error.to_string(), "`rapid_rate` was not sent: field `rate` is 1.5, allowed is 0 to 1");
    assert!(client.load_program("程序.jks").is_err_and(|error| error.is_invalid_argument()));
    assert!(client.kine_forward([f64::NAN; 6]).is_err_and(|error| error.is_invalid_argument()));
    assert!(client.set_clsn_sensitivity(9).is_err_and(|error| error.is_invalid_argument()));
    assert!(client.call_raw("jog", &json!([1])).is_err_and(|error| error.is_invalid_argument()));
    assert!(client.call_raw("jog", &json!({"cmdName": "x"})).is_err_and(|error| error.is_invalid_argument()));
    client.get_version().expect("the connection works");
    assert_eq!(controller.requests(), [r#"{"cmdName":"get_version"}"#]);
}
