//! Replies that are complete and odd, from a port that is not a simulator's: what can be read of them counts, and the
//! connection lives, so that a stop can be sent.

use std::io::{Read, Write};
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::thread;

use jaka_proto::framing::{self, Framer};
use jaka_proto::{Envelope, ErrorCode};
use jaka_sync::servo::ServoJ;
use jaka_sync::{Client, Config, Disconnect, ErrorKind};
use jaka_tests::LONG;
use serde_json::json;

/// A controller that answers the first command with these bytes, and each further one with success.
fn controller(first: &[u8]) -> SocketAddr {
    let listener = TcpListener::bind("127.0.0.1:0").expect("loopback has free ports");
    let address = listener.local_addr().expect("it is bound");
    let first = first.to_vec();
    thread::spawn(move || serve(listener.accept().expect("it is connected").0, first));
    address
}

/// Answers until the client leaves.
fn serve(mut stream: TcpStream, first: Vec<u8>) {
    let (mut framer, mut next) = (Framer::default(), Some(first));
    loop {
        while let Some(request) = framer.next_frame().expect("requests only") {
            let command = Envelope::read(&framing::text(request)).expect("it is JSON").command.map(String::from);
            let joints = json!([1, 2, 3, 4, 5, 6]);
            let usual = json!({"errorCode": "0", "errorMsg": "", "cmdName": command, "joint_pos": joints});
            stream.write_all(&next.take().unwrap_or_else(|| usual.to_string().into_bytes())).expect("it is connected");
        }
        match stream.read(framer.spare()) {
            Ok(0) | Err(_) => return,
            Ok(len) => framer.filled(len),
        }
    }
}

fn client(first: impl AsRef<[u8]>) -> Client {
    Client::connect_with(&Config::new().reply_timeout(LONG), controller(first.as_ref())).expect("it listens")
}

/// The connection works, and a stop can be sent.
fn assert_usable(client: &mut Client) {
    client.stop_handle().stop().expect("the connection lives");
    assert_eq!(
        client.get_joint_pos().expect("the connection lives").joint_position,
        [1.0, 2.0, 3.0, 4.0, 5.0, 6.0].into()
    );
    assert!(client.disconnect_cause().is_none());
}

/// Odd values that a key of a reply may have.
fn oddities() -> Vec<Vec<u8>> {
    let deep = format!("{}{}", "[".repeat(70), "]".repeat(70));
    let values = [r#""\ud83d""#, "NaN", "-Infinity", r#"{"a": [NaN, "\q"]}"#, &deep, "0x10", r#""\x""#];
    let bytes: [&[u8]; 2] = [b"\"\xc4\xe3\"", b"{\"\xff\": 0}"];
    values.iter().map(|value| value.as_bytes()).chain(bytes).map(<[u8]>::to_vec).collect()
}

fn reply(before: &str, odd: &[u8], after: &str) -> Vec<u8> {
    [before.as_bytes(), odd, after.as_bytes()].concat()
}

#[test]
fn an_odd_refusal_is_a_refusal() {
    for (code, name) in [("2", r#", "cmdName": "get_joint_pos""#), ("-1", "")] {
        for odd in oddities() {
            let after = format!(r#", "errorCode": "{code}", "errorMsg": "not now"{name}}}"#);
            let mut client = client(reply(r#"{"new": "#, &odd, &after));
            let error = client.get_joint_pos().expect_err("it is refused");
            let refusal = error.refusal().unwrap_or_else(|| panic!("{error:?}"));
            assert_eq!((refusal.command.as_str(), refusal.code.0.to_string().as_str()), ("get_joint_pos", code));
            assert_eq!(refusal.message, "not now");
            assert!(!error.may_have_run());
            assert_usable(&mut client);
        }
    }
}

#[test]
fn what_stands_for_no_text_in_a_message_is_replaced() {
    for message in [r"no \ud83d!".as_bytes(), b"no \xe4!", b"no \\\xe4!"] {
        let after = r#"", "errorCode": "2", "cmdName": "get_joint_pos"}"#;
        let mut client = client(reply(r#"{"errorMsg": ""#, message, after));
        let error = client.get_joint_pos().expect_err("it is refused");
        assert_eq!(error.refusal().map(|refusal| &*refusal.message), Some("no \u{fffd}!"));
        assert_usable(&mut client);
    }
}

#[test]
fn an_odd_payload_is_an_unexpected_reply() {
    for odd in oddities() {
        let before = r#"{"errorCode": "0", "errorMsg": "", "cmdName": "get_joint_pos", "joint_pos": "#;
        let mut client = client(reply(before, &odd, "}"));
        let error = client.get_joint_pos().expect_err("that is not a position");
        assert!(matches!(error.kind(), ErrorKind::UnexpectedReply { .. }) && error.may_have_run(), "{error:?}");
        let kept = client.last_reply().expect("it is kept").to_owned();
        assert_eq!(kept, framing::text(&reply(before, &odd, "}")));
        assert_usable(&mut client);
    }
}

#[test]
fn a_payload_next_to_what_is_odd_is_read() {
    for odd in oddities().into_iter().filter(|odd| odd[0] != b'{' || odd.is_ascii()) {
        let after = r#", "errorCode": "0", "cmdName": "get_joint_pos", "joint_pos": [6, 5, 4, 3, 2, 1]}"#;
        let mut client = client(reply(r#"{"new": "#, &odd, after));
        let found = client.get_joint_pos().expect("it is accepted").joint_position;
        assert_eq!(found, [6.0, 5.0, 4.0, 3.0, 2.0, 1.0].into());
        assert_usable(&mut client);
    }
}

#[test]
fn a_code_that_is_odd_is_never_a_success() {
    let codes: Vec<Vec<u8>> =
        [r#""2", "errorCode": "0""#, r#"0, "errorCode": 2"#, "1e-400", r#""0x-0""#, "0x0", r#""0\ud83d""#]
            .map(|code| code.as_bytes().to_vec())
            .into_iter()
            .chain(oddities())
            .collect();
    for code in codes {
        let mut client = client(reply(r#"{"errorCode": "#, &code, r#", "errorMsg": "", "cmdName": "enable_robot"}"#));
        let error = client.enable_robot().expect_err("that is not a success");
        let shown = String::from_utf8_lossy(&code);
        assert!(matches!(error.kind(), ErrorKind::UnexpectedReply { .. }), "{shown}: {error:?}");
        assert!(error.may_have_run(), "{shown}");
        assert_usable(&mut client);
    }
}

#[test]
fn a_name_that_is_odd_is_none() {
    let names = oddities().into_iter().chain([br#""get_joint_pos", "cmdName": "get_version""#.to_vec()]);
    for name in names {
        let before = r#"{"errorCode": "2", "errorMsg": "no", "cmdName": "#;
        let mut refused = client(reply(before, &name, "}"));
        // It can only be the reply to the one outstanding command.
        assert!(refused.get_joint_pos().expect_err("it is refused").is_refused());
        assert_usable(&mut refused);
        let before = r#"{"errorCode": "0", "joint_pos": [6, 5, 4, 3, 2, 1], "cmdName": "#;
        let error = client(reply(before, &name, "}")).get_joint_pos().expect_err("it may be anybody's");
        let ErrorKind::Disconnected { cause, .. } = error.kind() else { panic!("{error:?}") };
        assert!(matches!(**cause, Disconnect::OutOfSync(_)), "{error:?}");
    }
}

#[test]
fn raw_calls_get_json_or_an_error_and_text_calls_the_text() {
    let after = r#", "errorCode": "0", "errorMsg": "", "cmdName": "look"}"#;
    for odd in oddities().into_iter().chain([br#"1, "new": 2"#.to_vec()]) {
        let bytes = reply(r#"{"new": "#, &odd, after);
        let mut raw = client(&bytes);
        let error = raw.call_raw("look", &json!({})).expect_err("that is not JSON throughout");
        assert!(matches!(error.kind(), ErrorKind::UnexpectedReply { .. }), "{error:?}");
        assert_eq!(raw.last_reply(), Some(&*framing::text(&bytes)));
        assert_usable(&mut raw);
        let mut text = client(&bytes);
        assert_eq!(text.call_text(r#"{"cmdName": "look"}"#, LONG).expect("it is accepted"), framing::text(&bytes));
        assert_usable(&mut text);
    }
    let refused = reply(r#"{"new": NaN"#, b"", &after.replace("\"0\"", "\"7\""));
    let error = client(refused).call_raw("look", &json!({})).expect_err("it is refused");
    assert_eq!(error.refusal().map(|refusal| refusal.code), Some(ErrorCode(7)));
}

#[test]
fn a_pipeline_counts_odd_replies() {
    let reply = br#"{"errorCode": "0", "errorMsg": "\ud83d", "new": NaN, "cmdName": "servo_j"}"#;
    let mut client = client(reply);
    let mut pipeline = client.pipeline(2);
    for _ in 0..3 {
        let set_point = ServoJ::relative([0.0; 6]);
        pipeline.send(&set_point).expect("it is sent");
    }
    pipeline.finish().expect("all are accepted");
    assert_usable(&mut client);
}

#[test]
fn what_is_not_an_object_breaks_the_connection() {
    for bytes in
        [r#"{"errorCode": [0}"#, r#"{"errorCode": "0" "cmdName": "get_joint_pos"}"#, "{errorCode: 0}", r#"{"x": {]}}"#]
    {
        let error = client(bytes).get_joint_pos().expect_err("that is not an object");
        let ErrorKind::Disconnected { cause, .. } = error.kind() else { panic!("{error:?}") };
        assert!(matches!(**cause, Disconnect::NotJson(_)), "{error:?}");
    }
}
