//! The exchange where nothing is wrong with the wire: sessions, stop handles, deadlines, raw calls.

use std::io::{Read, Write};
use std::thread;
use std::time::Duration;

use jaka_sim::{Fault, SimulatedClock};
use jaka_sync::kinematics::GetJointPos;
use jaka_sync::motion::JointMove;
use jaka_sync::program::StopProgram;
use jaka_sync::{Client, Config, Error, ErrorCode, StatusStream, StopHandle};
use jaka_tests::simulated::beside;
use jaka_tests::{Arm, ClockedSocket, LONG, accepted};
use serde_json::{Value, json};

fn connected() -> (Arm, Client) {
    Arm::simulated().without_power().with_client()
}

fn patient() -> Config {
    Config::new().reply_timeout(LONG)
}

fn one_degree() -> JointMove {
    let joint_position = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    JointMove::relative(joint_position, 10.0)
}

#[test]
fn a_refused_motion_is_an_error_with_the_controllers_own_words() {
    let (_controller, mut client) = connected();
    let error = client.joint_move(&one_degree()).expect_err("the arm has no power");
    let refusal = error.refusal().expect("the controller refuses");
    assert_eq!((refusal.code, refusal.message.as_str()), (ErrorCode(2), "call joint_move failed"));
    assert!(!error.may_have_run() && !error.is_disconnected());
}

#[test]
fn a_request_is_sent_as_it_stands() {
    let (controller, mut client) = connected();
    let request = "{ \"rate_value\":0.5,\t\"cmdName\": \"rapid_rate\" }";
    let reply = client.call_text(request, LONG).expect("it answers");
    assert!(reply.contains("\"rapid_rate\""), "{reply}");
    assert_eq!(controller.requests(), [request]);
    for wrong in ["", "[]", "{}", "{\"cmdName\": \"\"}"] {
        let error = client.call_text(wrong, LONG).expect_err("it is not a request");
        assert!(error.is_invalid_argument(), "{wrong}: {error:?}");
    }
    assert_eq!(controller.requests(), [request]);
}

#[test]
fn raw_calls_give_the_whole_reply() {
    let (controller, mut client) = connected();
    let reply = client.call_raw("get_robot_state", &Value::Null).expect("it answers");
    assert_eq!(reply["cmdName"], "get_robot_state");
    let rate = json!({"rate_value": 0.25});
    client.call_raw("rapid_rate", &rate).expect("it answers");
    assert_eq!(controller.requests()[1], r#"{"cmdName":"rapid_rate","rate_value":0.25}"#);
    assert_eq!(client.last_reply(), Some(r#"{"errorCode": "0", "errorMsg": "", "cmdName": "rapid_rate"}"#));
}

#[test]
fn quit_ends_the_session() {
    let (controller, mut client) = connected();
    client.quit().expect("it answers");
    let error = client.get_version().expect_err("the session has ended");
    assert!(error.is_disconnected() && !error.may_have_run());
    let source = std::error::Error::source(&error).expect("the cause is told");
    assert_eq!(source.to_string(), "`quit` ended the session");
    assert_eq!(controller.requests().len(), 1);
}

#[test]
fn shutdown_succeeds_with_a_reply_and_with_a_controller_that_just_goes_away() {
    let (_controller, mut client) = connected();
    client.shutdown().expect("it answers");
    for fault in [Fault::Close, Fault::Reset] {
        let (controller, mut client) = connected();
        controller.inject(fault);
        client.shutdown().expect("a controller that shuts down closes the connection");
        assert!(client.get_version().is_err_and(|error| error.is_disconnected()));
    }
    // Other commands get no such benefit of the doubt.
    let (controller, mut client) = connected();
    controller.inject(Fault::Close);
    assert!(client.power_off().is_err_and(|error| error.is_disconnected()));
}

#[test]
fn a_stop_handle_stops_while_a_call_waits() {
    let (controller, mut client) = Arm::real_time().with_client();
    let stop = client.stop_handle();
    // The reply to the motion is held back until the next reply goes out: that to the stop.
    controller.inject(Fault::Hold);
    let sent = controller.requests().len();
    let moving = thread::spawn(move || client.joint_move(&one_degree()).map(|()| client));
    assert!(controller.wait_for_requests(sent + 1, LONG));
    stop.stop().expect("the controller takes the stop");
    let mut client = moving.join().expect("the thread does not panic").expect("the motion was accepted");
    assert_eq!(controller.requests().last().map(String::as_str), Some(r#"{"cmdName":"stop_program"}"#));
    client.get_version().expect("the connection works");
}

#[test]
fn a_stop_that_is_refused_or_unanswered_is_an_error() {
    let (controller, client) = Arm::real_time().with_client();
    let stop = client.stop_handle();
    let refusal = br#"{"errorCode": "2", "errorMsg": "call stop_program failed", "cmdName": "stop_program"}"#;
    controller.inject(Fault::Instead(refusal.to_vec()));
    let error = stop.stop().expect_err("the controller refuses");
    assert_eq!(error.to_string(), "the controller refused `stop_program` with code 2: call stop_program failed");
    controller.disconnect();
    assert!(stop.stop().is_err_and(|error| error.is_disconnected()));
}

#[test]
fn addresses_with_and_without_a_port() {
    let (controller, mut client) = connected();
    let address = controller.command_addr();
    assert_eq!(client.peer_addr().expect("it is connected"), address);
    drop(client);
    let by_name = format!("localhost:{}", address.port());
    client = Client::connect_with(&controller.config(), by_name).expect("the name is known everywhere");
    client.get_version().expect("it answers");
    // Without a port, it is the protocol's.
    let error = Client::connect_with(&Config::new().connect_timeout(Duration::from_millis(100)), "127.0.0.1");
    if let Err(error) = error {
        assert!(error.to_string().starts_with("cannot connect to 127.0.0.1:10001"), "{error}");
    }
}

#[test]
fn handles_can_move_and_be_shared_between_threads() {
    fn assert_send<T: Send>() {}
    fn assert_sync<T: Sync>() {}
    assert_send::<Client>();
    assert_send::<StopHandle>();
    assert_sync::<StopHandle>();
    assert_send::<StatusStream>();
    assert_send::<Error>();
    assert_sync::<Error>();
    assert_send::<jaka_robot::Robot>();
    assert_send::<jaka_robot::RobotStop>();
    assert_sync::<jaka_robot::RobotStop>();
}

#[test]
fn a_client_that_is_dropped_closes_its_connection_and_its_stop_handle_says_so() {
    let (mut server, mut client) = accepted(|address| Client::connect_with(&patient(), address));
    let stop = client.stop_handle();
    client.pipeline(1).send(&StopProgram::new()).expect("it is not known yet");
    drop(client);
    let mut bytes = String::new();
    server.read_to_string(&mut bytes).expect("the end is orderly, and comes");
    assert_eq!(bytes, r#"{"cmdName":"stop_program"}"#);
    let error = stop.stop().expect_err("the connection is closed");
    assert!(error.is_disconnected() && !error.may_have_run(), "{error:?}");
    let source = std::error::Error::source(&error).expect("the cause is told");
    assert_eq!(source.to_string(), "the client was dropped, which closed its connection");
}

#[test]
fn a_new_client_connects_although_a_stop_handle_of_the_last_one_lives() {
    let (controller, client) = connected();
    let stop = client.stop_handle();
    drop(client);
    let mut next = controller.client();
    assert!(stop.stop().is_err_and(|error| error.is_disconnected()));
    next.get_version().expect("it is served");
}

#[test]
fn a_call_ends_at_its_deadline_although_the_peer_reads_slowly() {
    let clock = SimulatedClock::new();
    let config = Config::new().clock(&clock);
    let (mut server, mut client) = ClockedSocket::accepted(&clock, |address| Client::connect_with(&config, address));
    let pad = "x".repeat(16 << 20);
    let request = format!("{{\"cmdName\":\"load_program\",\"programName\":\"{pad}\"}}");
    // A little all the time: no single write waits long for room. All of it would take more than a minute.
    let read_slowly = || {
        while server.read(&mut [0; 4096]).is_ok_and(|count| count > 0) {
            clock.sleep(Duration::from_millis(20));
        }
    };
    beside(&clock, read_slowly, || {
        let began = clock.elapsed();
        let error = client.call_text(&request, Duration::from_secs(3)).expect_err("it takes far longer");
        assert_eq!(clock.elapsed().saturating_sub(began), Duration::from_secs(3));
        assert!(error.is_disconnected() && error.may_have_run(), "{error:?}");
        drop(client);
    });
}

#[test]
fn replies_on_the_status_connection_are_distinguished_from_packets() {
    let (mut server, mut status) = accepted(|address| StatusStream::connect_with(&patient(), address));
    let reply = br#"{"errorCode":"0","errorMsg":"","cmdName":"get_joint_pos"}"#;
    server.write_all(reply).expect("the stream reads");
    let error = status.newest_packet().expect_err("it is not a status port");
    let source = std::error::Error::source(&error).expect("the cause is told");
    assert_eq!(
        source.to_string(),
        "received a reply to a command instead of a status packet: this is the command port; status packets come from port 10000"
    );
}

#[test]
fn a_robots_address_with_a_port_is_refused() {
    for address in ["10.5.5.100:10001", "localhost:10000", "[::1]:10001"] {
        let error = jaka_robot::Robot::connect(address).expect_err("a robot has two ports");
        assert!(
            matches!(error.kind(), jaka_robot::ErrorKind::PortInAddress { address: named } if named == address),
            "{error:?}"
        );
        assert!(error.is_connect() && !error.may_have_run());
        assert_eq!(
            error.to_string(),
            format!(
                "cannot connect to {address}: the address has a port, but a robot has two; give its address without a \
                 port, or both addresses to `Robot::connect_at`"
            )
        );
    }
    let controller = Arm::simulated().start();
    let config = controller.config();
    let mut robot = jaka_robot::Robot::connect_at(&config, controller.command_addr(), controller.status_addr())
        .expect("the controller listens");
    robot.client().get_version().expect("it answers");
    robot.monitor().wait_until(|_| true, LONG).expect("packets come");
}

#[test]
fn no_timeout_is_too_long() {
    let (controller, mut client) = Arm::real_time()
        .config(|config| {
            config.connect_timeout(Duration::MAX).reply_timeout(Duration::MAX).keepalive(Some(Duration::MAX))
        })
        .with_client();
    client.get_version().expect("it answers");
    client.call_within(&GetJointPos::new(), Duration::MAX).expect("it answers");
    let mut pipeline = client.pipeline(usize::MAX);
    pipeline.send(&StopProgram::new()).expect("it is not known yet");
    assert_eq!(pipeline.finish().expect("it answers"), 1);
    client.stop_handle().stop().expect("it answers");
    let mut status = controller.stream();
    status.next_packet().expect("packets come");
    status.newest_packet().expect("packets come");
}
