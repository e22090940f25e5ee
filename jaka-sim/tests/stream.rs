//! Requests in pieces of any size, and clients of any kind.

use crate::common::{Peer, assert_accepted, assert_unknown, fresh, json, request};
use jaka_sim::{Controller, Takeover};

const MOVE: &str = r#"{"cmdName": "set_user_offsets", "userffset": [1,2,3,4,5,6], "id": 2, "name": "}\"{\\"}"#;

#[test]
fn requests_in_one_write_are_answered_in_order() {
    let controller = fresh();
    let mut peer = Peer::commands(&controller);
    let commands = ["power_on", "enable_robot", "get_robot_state", "fly", "disable_robot", "get_robot_state"];
    let requests: Vec<_> = commands.iter().map(|command| request(command)).collect();
    peer.send(requests.concat() + "\n" + MOVE + " \r\n");
    for command in commands {
        let reply = json(&peer.receive());
        if command == "fly" { assert_unknown(&reply) } else { assert_accepted(&reply, command) }
    }
    assert_accepted(&json(&peer.receive()), "set_user_offsets");
    assert_eq!(controller.requests(), [requests, vec![MOVE.to_owned()]].concat());
}

#[test]
fn requests_may_be_cut_at_every_byte() {
    let controller = fresh();
    let mut peer = Peer::commands(&controller);
    for at in 0..=MOVE.len() {
        let (head, tail) = MOVE.split_at(at);
        peer.send(head);
        peer.send(tail);
        assert_accepted(&json(&peer.receive()), "set_user_offsets");
    }
    for byte in MOVE.bytes() {
        peer.send([byte]);
    }
    assert_accepted(&json(&peer.receive()), "set_user_offsets");
    assert_eq!(controller.state().user_frames[2].name, "}\"{\\");
    assert!(controller.requests().iter().all(|request| request == MOVE));
}

#[test]
fn the_port_is_free_when_the_client_sees_the_end() {
    let controller = Controller::builder().takeover(Takeover::Refuse).start().expect("loopback has ports");
    for fault in [jaka_sim::Fault::Close, jaka_sim::Fault::CloseAfter(9), jaka_sim::Fault::Reset] {
        for _ in 0..20 {
            controller.inject(fault.clone());
            let mut peer = Peer::commands(&controller);
            peer.send(request("get_version"));
            peer.read_to_end();
        }
    }
    assert_eq!(controller.requests().len(), 60);
}

#[test]
fn garbage_is_answered_like_an_unknown_command() {
    let controller = fresh();
    for garbage in [&b"hello\n"[..], b"\0\0\0", b"]", b"\xff\xfe", b"\"{\"", b"GET / HTTP/1.1\r\n\r\n"] {
        let mut peer = Peer::commands(&controller);
        peer.send(garbage);
        assert_unknown(&json(&peer.receive()));
        // The next request is found after it; whether something in it looks like a request is up to the framer.
        if !garbage.contains(&b'{') {
            peer.send(request("get_version"));
            assert_accepted(&json(&peer.receive()), "get_version");
        }
    }
}

#[test]
fn objects_that_are_no_requests_do_no_harm() {
    let controller = fresh();
    let mut peer = Peer::commands(&controller);
    let deep = format!("{{\"cmdName\":\"jog\",\"a\":{}1{}}}", "[".repeat(20_000), "]".repeat(20_000));
    let texts: [&[u8]; 6] = [
        b"{\"cmdName\":\"\xff\xff\"}",
        b"{\"cmdName\":\"get_version\",\"\xff\":1}",
        b"{\"cmdName\":null}",
        b"{\"a\":\"\\ud800\"}",
        b"({}, ')', \"(\")",
        deep.as_bytes(),
    ];
    for text in texts {
        peer.send(text);
        assert_unknown(&json(&peer.receive()));
    }
    let number = format!("{{\"cmdName\":\"rapid_rate\",\"rate_value\":1e{}}}", "9".repeat(1000));
    assert_eq!(peer.ask(&number)["errorCode"], "2");
    assert_eq!(controller.requests().len(), 7);
}

#[test]
fn clients_may_leave_at_any_time() {
    let controller = fresh();
    for at in 0..MOVE.len() {
        let mut peer = Peer::commands(&controller);
        peer.send(&MOVE[..at]);
    }
    for _ in 0..50 {
        let mut peer = Peer::commands(&controller);
        peer.send(request("get_joint_pos").repeat(20));
    }
    assert_accepted(&Peer::commands(&controller).call("get_version"), "get_version");
}
