//! Faults on the command port: for each the exact error, whether the connection can be used on, and no wrong data.

use std::net::TcpListener;
use std::time::Duration;

use jaka_proto::exchange::OutOfSync;
use jaka_proto::framing::FrameError;
use jaka_sim::{Controller, Fault, SimulatedClock};
use jaka_sync::{Client, Config, Disconnect, Error, ErrorCode, ErrorKind, Monitor};
use jaka_tests::{Arm, LONG, ReservedPort};
use serde_json::json;

/// Reply timeout where no reply comes.
const SHORT: Duration = Duration::from_millis(300);

/// A controller in simulated time whose next reply has this fault, and a client with a short reply timeout.
fn faulty(fault: Fault) -> (Arm, Client) {
    let arm = Arm::simulated().without_power().config(|config| config.reply_timeout(SHORT));
    let (controller, client) = arm.with_client();
    controller.inject(fault);
    (controller, client)
}

/// A controller in real time whose next reply has this fault, and a client that waits for any reply that comes at all.
fn patient(fault: Fault) -> (Arm, Client) {
    let (controller, client) = Arm::real_time().without_power().with_client();
    controller.inject(fault);
    (controller, client)
}

/// The connection works, and answers belong to their questions.
fn assert_usable(controller: &Controller, client: &mut Client) {
    let joints = [1.0, 2.0, 3.0, 4.0, 5.0, 6.5];
    controller.set_state(|state| state.joint_position = joints.into());
    assert_eq!(client.get_joint_pos().expect("the connection works").joint_position, joints.into());
    assert!(!client.get_robot_state().expect("the connection works").enabled);
    assert!(client.disconnect_cause().is_none());
}

/// The connection is broken for good: nothing is sent any more, and the first cause is told again.
fn assert_broken(controller: &Controller, client: &mut Client, cause: &str) {
    // Once the controller has seen the end, it has all that was sent.
    assert!(controller.wait_for_disconnect(LONG), "the connection is closed");
    let before = controller.requests().len();
    for _ in 0..2 {
        let error = client.get_robot_state().expect_err("the connection is broken");
        assert!(error.is_disconnected() && !error.may_have_run(), "{error:?}");
        let text = format!("`get_robot_state` was not sent: the connection to {} is broken", controller.command_addr());
        assert!(error.to_string().starts_with(&text), "{error}");
        let source = std::error::Error::source(&error).expect("the cause is told");
        assert!(source.to_string().contains(cause), "`{source}` does not say `{cause}`");
    }
    assert_eq!(controller.requests().len(), before);
    let told = client.disconnect_cause().expect("it can be asked too").to_string();
    assert!(told.contains(cause), "`{told}` does not say `{cause}`");
}

/// The cause of a broken connection, of a call that had been sent.
fn cause_of(error: Error) -> String {
    match error.into_kind() {
        ErrorKind::Disconnected { command: Some(_), sent: true, cause, .. } => format!("{cause:?}"),
        other => panic!("the connection should be broken: {other:?}"),
    }
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
    let (controller, mut client) = faulty(Fault::Drop);
    let error = client.get_version().expect_err("no reply comes");
    assert!(error.is_timeout() && error.may_have_run() && !error.is_disconnected());
    assert_eq!(error.to_string(), "no reply to `get_version` within 300ms; it may have run");
    assert_usable(&controller, &mut client);
}

#[test]
fn late_reply_is_discarded() {
    let (controller, mut client) = faulty(Fault::Hold);
    assert!(client.get_joint_pos().expect_err("the reply is held back").is_timeout());
    // The late reply holds the old position; the new call must not get it.
    controller.release();
    assert_usable(&controller, &mut client);
}

#[test]
fn late_reply_after_a_call_of_another_name() {
    let (controller, mut client) = faulty(Fault::Hold);
    assert!(client.get_joint_pos().expect_err("the reply is held back").is_timeout());
    // It goes out before the next reply.
    assert!(!client.get_version().expect("the next reply comes").version.is_empty());
    assert_usable(&controller, &mut client);
}

#[test]
fn lost_reply_and_a_call_of_the_same_name() {
    let (controller, mut client) = faulty(Fault::Drop);
    assert!(client.get_joint_pos().expect_err("no reply comes").is_timeout());
    // Its own reply completes the older request, and none comes for itself: which was lost cannot be told.
    let error = client.get_joint_pos().expect_err("the reply is taken for the late one");
    assert!(error.may_have_run());
    assert!(cause_of(error).contains("Ambiguous"));
    assert_broken(&controller, &mut client, "one of two replies to `get_joint_pos` is lost");
}

#[test]
fn reply_split_at_every_byte() {
    let (controller, mut client) = patient(Fault::None);
    client.get_version().expect("nothing is wrong");
    let length = client.last_reply().expect("there was a reply").len();
    for cut in 1..length {
        controller.inject(Fault::Pieces(vec![cut]));
        assert!(!client.get_version().expect("the pieces are put together").version.is_empty());
    }
    controller.inject(Fault::Pieces(vec![1; length]));
    assert!(!client.get_version().expect("the pieces are put together").version.is_empty());
    assert_usable(&controller, &mut client);
}

#[test]
fn two_replies_in_one_segment() {
    let (controller, mut client) = faulty(Fault::WithNext);
    assert!(client.get_joint_pos().expect_err("the reply waits for the next one").is_timeout());
    assert!(!client.get_version().expect("both replies come at once").version.is_empty());
    assert_usable(&controller, &mut client);
}

#[test]
fn refusal_without_a_name() {
    let (controller, mut client) = patient(Fault::None);
    let error = client.call_raw("no_such_command", &json!({})).expect_err("the controller does not know it");
    let refusal = error.refusal().expect("it is refused");
    assert_eq!((refusal.command.as_str(), refusal.code), ("no_such_command", ErrorCode(1)));
    assert_eq!(refusal.message, "Exception:function call failed");
    assert!(!error.may_have_run());
    assert_usable(&controller, &mut client);
}

/// The controller may lack both.
#[test]
fn refusal_without_a_name_while_two_requests_are_outstanding() {
    let (_controller, mut client) = faulty(Fault::Drop);
    assert!(client.get_version().expect_err("no reply comes").is_timeout());
    let error = client.call_raw("no_such_command", &json!({})).expect_err("whose is the refusal?");
    assert!(error.is_timeout() && error.may_have_run(), "{error:?}");
    client.get_joint_pos().expect("the connection works");
}

#[test]
fn refusal_without_a_name_of_one_of_two_commands_that_the_controller_has() {
    let (controller, mut client) = faulty(Fault::None);
    client.get_version().expect("it answers");
    client.get_joint_pos().expect("it answers");
    controller.inject(Fault::Drop);
    assert!(client.get_version().expect_err("no reply comes").is_timeout());
    controller.inject(Fault::Instead(br#"{"errorCode": "2", "errorMsg": "no"}"#.to_vec()));
    let error = client.get_joint_pos().expect_err("whose is the refusal?");
    assert!(cause_of(error).contains("Nameless"));
    assert_broken(&controller, &mut client, "names no command");
}

#[test]
fn success_without_a_name() {
    let (controller, mut client) = patient(Fault::Nameless);
    let error = client.get_joint_pos().expect_err("the data may be anybody's");
    assert!(error.may_have_run());
    assert!(cause_of(error).contains("Nameless"));
    assert_broken(&controller, &mut client, "names no command");
}

#[test]
fn reply_to_another_command() {
    let (controller, mut client) = patient(Fault::Renamed("get_payload".to_owned()));
    let error = client.get_joint_pos().expect_err("the reply is to another command");
    assert!(cause_of(error).contains("Unsolicited"));
    assert_broken(&controller, &mut client, "a reply to `get_payload` came, but no such request is outstanding");
}

#[test]
fn unasked_reply_before_the_own() {
    let unasked = br#"{"errorCode": "0", "errorMsg": "", "cmdName": "jog"}"#;
    let (controller, mut client) = patient(Fault::Before(unasked.to_vec()));
    let error = client.get_joint_pos().expect_err("nobody jogged");
    assert!(cause_of(error).contains("Unsolicited"));
    assert_broken(&controller, &mut client, "a reply to `jog` came, but no such request is outstanding");
}

#[test]
fn reply_that_comes_twice() {
    let (controller, mut client) = patient(Fault::Twice);
    client.get_version().expect("the first copy is the reply");
    // Usually the copy has been read already, and nothing is sent; it may also come only now.
    assert!(client.get_joint_pos().expect_err("the second copy is unasked").is_disconnected());
    assert_broken(&controller, &mut client, "a reply to `get_version` came, but no such request is outstanding");
}

#[test]
fn garbage_instead_of_a_reply() {
    let (controller, mut client) = patient(Fault::Instead(b"HTTP/1.1 400 Bad Request\r\n".to_vec()));
    let error = client.get_joint_pos().expect_err("that is not a reply");
    let ErrorKind::Disconnected { cause, .. } = error.kind() else { panic!("it breaks the connection: {error:?}") };
    assert!(matches!(&**cause, Disconnect::Frame(FrameError::Garbage { .. })));
    assert!(cause.to_string().contains("HTTP/1.1 400 Bad Request"), "{cause}");
    assert_broken(&controller, &mut client, "HTTP/1.1 400 Bad Request");
}

#[test]
fn nul_bytes() {
    let (controller, mut client) = patient(Fault::Before(vec![0, 0, 0]));
    assert!(cause_of(client.get_joint_pos().expect_err("NUL begins no reply")).contains("Garbage"));
    assert_broken(&controller, &mut client, r"\x00\x00\x00");
}

#[test]
fn braces_that_hold_no_json() {
    let (controller, mut client) = patient(Fault::Instead(b"{errorCode: 0}".to_vec()));
    assert!(cause_of(client.get_joint_pos().expect_err("that is not JSON")).contains("NotJson"));
    assert_broken(&controller, &mut client, "not JSON");
}

#[test]
fn invalid_utf8() {
    let reply = b"{\"errorCode\": \"2\", \"errorMsg\": \"\xff\xfe\", \"cmdName\": \"get_joint_pos\"}";
    let (controller, mut client) = patient(Fault::Instead(reply.to_vec()));
    let error = client.get_joint_pos().expect_err("it is refused");
    assert_eq!(error.refusal().map(|refusal| &*refusal.message), Some("\u{fffd}\u{fffd}"));
    assert_usable(&controller, &mut client);
}

#[test]
fn oversized_reply() {
    let (controller, mut client) = Arm::real_time().config(|config| config.max_frame(4096)).with_client();
    let huge = format!("{{\"errorMsg\": \"{}\"}}", "x".repeat(5000));
    controller.inject(Fault::Instead(huge.into_bytes()));
    assert!(cause_of(client.get_joint_pos().expect_err("the limit is exceeded")).contains("TooLong"));
    assert_broken(&controller, &mut client, "longer than 4096 bytes");
}

#[test]
fn reply_that_does_not_fit_the_spec() {
    let reply = br#"{"errorCode": "0", "errorMsg": "", "cmdName": "get_joint_pos", "joint_pos": [1, 2, 3]}"#;
    let (controller, mut client) = patient(Fault::Instead(reply.to_vec()));
    let error = client.get_joint_pos().expect_err("three joints are not six");
    assert!(!error.is_disconnected());
    assert_eq!(error.to_string(), "`get_joint_pos` was not refused, but its reply does not fit the spec");
    let source = std::error::Error::source(&error).expect("the field is named");
    assert_eq!(source.to_string(), "field `joint_position`: expected an array of 6, found `[1, 2, 3]`");
    assert_eq!(client.last_reply().map(str::as_bytes), Some(reply.as_slice()));
    assert_usable(&controller, &mut client);
}

#[test]
fn refusal_with_a_payload_that_does_not_fit() {
    let reply =
        br#"{"joint_pos": "?", "errorMsg": "call get_joint_pos failed", "errorCode": "2", "cmdName": "get_joint_pos"}"#;
    let (controller, mut client) = patient(Fault::Instead(reply.to_vec()));
    let error = client.get_joint_pos().expect_err("the controller refuses");
    assert_eq!(error.to_string(), "the controller refused `get_joint_pos` with code 2: call get_joint_pos failed");
    assert_usable(&controller, &mut client);
}

#[test]
fn bare_tuple_of_a_controller_without_modules() {
    let (controller, mut client) = patient(Fault::Instead(b"(0, [], {'state': 0})".to_vec()));
    let status = client.get_extio_status().expect("the document prints this reply").extio_status;
    assert_eq!((status.count, status.state.running), (0, false));
    assert_usable(&controller, &mut client);
    controller.inject(Fault::Instead(b"(0, [], {'state': 0})".to_vec()));
    assert!(cause_of(client.get_joint_pos().expect_err("nobody asked for it")).contains("Unsolicited"));
}

#[test]
fn eof_before_the_reply() {
    let (controller, mut client) = patient(Fault::Close);
    let error = client.get_joint_pos().expect_err("the connection is closed");
    assert!(error.may_have_run());
    assert!(cause_of(error).contains("Closed { partial: 0 }"));
    assert_broken(&controller, &mut client, "the controller closed the connection");
}

#[test]
fn eof_inside_the_reply() {
    let (controller, mut client) = patient(Fault::CloseAfter(17));
    let error = client.get_joint_pos().expect_err("the connection is closed");
    assert!(error.may_have_run());
    assert!(cause_of(error).contains("Closed { partial: 17 }"));
    assert_broken(&controller, &mut client, "in the middle of a message, after 17 bytes of it");
}

#[test]
fn reset() {
    let (controller, mut client) = patient(Fault::Reset);
    let error = client.get_joint_pos().expect_err("the connection is reset");
    assert!(error.may_have_run());
    assert!(cause_of(error).contains("ConnectionReset"));
    assert_broken(&controller, &mut client, "receiving failed");
}

#[test]
fn another_client_takes_the_port() {
    let (controller, mut first) = patient(Fault::None);
    first.get_version().expect("the connection works");
    let mut second = controller.client();
    second.get_version().expect("the newcomer is served");
    let error = first.get_version().expect_err("the newcomer has replaced it");
    assert!(error.is_disconnected());
    second.get_version().expect("the newcomer is still served");
}

#[test]
fn nothing_is_sent_of_a_request_that_the_spec_forbids() {
    let (controller, mut client) = patient(Fault::None);
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

#[test]
fn a_controller_that_never_reads() {
    // The connection is not accepted: the kernel takes some bytes, and then no more.
    let listener = TcpListener::bind("127.0.0.1:0").expect("loopback has free ports");
    let address = listener.local_addr().expect("it is bound");
    let config = Config::new().clock(&SimulatedClock::new()).reply_timeout(SHORT);
    let mut client = Client::connect_with(&config, address).expect("it listens");
    let program = "x".repeat(1 << 20);
    let errors = (0..64).map(|_| client.load_program(&*program).expect_err("nobody answers"));
    let broken = errors.into_iter().find(Error::is_disconnected).expect("the kernel's buffers are finite");
    assert!(broken.may_have_run());
    assert!(cause_of(broken).contains("Write"));
}

#[test]
fn kinds_of_being_out_of_sync_are_distinguished() {
    assert_eq!(OutOfSync::Nameless.to_string(), "a reply came that names no command");
}
