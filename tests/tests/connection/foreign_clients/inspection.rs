//! `cyysky/FMCV_INSPECTION`, an inspection system in Python, over its own client of port 10001 (`tcp_type` `jaka_tcp`).
//!
//! It builds requests by f-strings, with lists as Python prints them and blanks between some members. It reads a reply
//! by one `recv` of 5120 bytes, and by a second one where `json.loads` fails. A reply is a success where `errorCode`
//! equals the string `"0"` and `cmdName` the command's name. It waits for an end by `get_data`: 10 ms after the request
//! at first, then each 80 ms, for 10 s at most.

use std::time::Duration;

use jaka_sim::{Delays, Firmware};
use jaka_tests::{Arm, ArmBuilder};
use serde_json::{Map, Value};

use super::{Wire, object, six};

/// Size of each of the client's reads.
const READ: usize = 5120;
const FIRST_QUESTION: Duration = Duration::from_millis(10);
const BETWEEN_QUESTIONS: Duration = Duration::from_millis(80);
const PATIENCE: Duration = Duration::from_secs(10);

const LINE_UP: &str =
    r#"{"cmdName":"moveL", "cartPosition":[0, 0, 10, 0, 0, 0], "relFlag":1, "speed":20, "accel":100}"#;
const SLOW_LINE: &str =
    r#"{"cmdName":"moveL", "cartPosition":[0, 0, 100, 0, 0, 0], "relFlag":1, "speed":5, "accel":100}"#;

/// The client's connection, of the thread that owns its socket.
struct Backend<'a>(Wire<'a>);

impl<'a> Backend<'a> {
    fn connect(arm: &'a Arm) -> Self {
        Self(Wire::connect(arm))
    }

    /// The parsed reply, which is an empty object where two reads do not have it.
    fn exchange(&mut self, request: &str) -> Map<String, Value> {
        let mut reply = self.0.ask(request, READ);
        if let Some(reply) = object(&reply) {
            return reply;
        }
        reply.push_str(&self.0.recv(READ));
        object(&reply).unwrap_or_default()
    }

    /// Success and message of a command, as the client returns them.
    fn call(&mut self, command: &str, request: &str) -> (bool, Option<String>) {
        let reply = self.exchange(request);
        let is_success = reply.get("errorCode").is_some_and(|code| code == "0");
        let is_own = reply.get("cmdName").is_some_and(|name| name == command);
        (is_success && is_own, reply.get("errorMsg").and_then(Value::as_str).map(str::to_owned))
    }

    /// The value of a key of the packet; `None` if the reply is no success to it.
    fn packet_value(&mut self, key: &str) -> Option<Value> {
        let mut reply = self.exchange(r#"{"cmdName":"get_data"}"#);
        let is_success = reply.get("errorCode").is_some_and(|code| code == "0");
        let is_own = reply.get("cmdName").is_some_and(|name| name == "get_data");
        (is_success && is_own).then(|| reply.remove(key)).flatten()
    }

    /// Asks until a key of the packet has a value; false if its patience ends before.
    fn wait(&mut self, key: &str, value: &Value) -> bool {
        let end = self.0.arm.elapsed() + PATIENCE;
        self.0.arm.advance(FIRST_QUESTION);
        while self.0.arm.elapsed() < end {
            if self.packet_value(key).is_some_and(|found| found == *value) {
                return true;
            }
            self.0.arm.advance(BETWEEN_QUESTIONS);
        }
        false
    }
}

fn arm() -> ArmBuilder {
    Arm::stepped().without_power().no_packets()
}

/// True for success without a message.
fn is_accepted((is_success, message): (bool, Option<String>)) -> bool {
    is_success && message.as_deref() == Some("")
}

/// `cyysky/FMCV_INSPECTION`, `FMCV/Comm/TCP_JAKA.py` and `FMCV/Com.py`: power and enabling, the frames that its
/// calibration sets and selects, and a line by an offset.
///
/// The key of the user frame is the document's `userffset`. `FMCV/Platform/Jaka/JakaControl.py` selects frame 10.
#[test]
fn frames_are_selected_and_a_line_has_ended_when_it_says_so() {
    for firmware in [Firmware::default(), Firmware::Newer] {
        let arm = arm().controller(|controller| controller.firmware(firmware)).start();
        let mut client = Backend::connect(&arm);
        assert!(is_accepted(client.call("power_on", r#"{"cmdName":"power_on"}"#)));
        assert!(is_accepted(client.call("enable_robot", r#"{"cmdName":"enable_robot"}"#)));
        let before = six(&client.exchange(r#"{"cmdName":"get_tcp_pos"}"#), "tcp_pos").expect("it has the key");

        let board = r#"{"cmdName":"set_user_offsets","userffset":[10.5, -20.0, 5.0, 0.0, 0.0, 0.0],"id":10,"name":"FMCV Board"}"#;
        assert!(is_accepted(client.call("set_user_offsets", board)));
        assert!(is_accepted(client.call("set_user_id", r#"{"cmdName":"set_user_id","user_frame_id":10}"#)));
        assert!(client.wait("current_user_id", &10.into()));
        let camera = r#"{"cmdName":"set_tool_offsets","tooloffset":[0.0, 0.0, 50.0, 0.0, 0.0, 0.0],"id":10,"name":"FMCV Camera"}"#;
        assert!(is_accepted(client.call("set_tool_offsets", camera)));
        assert!(is_accepted(client.call("set_tool_id", r#"{"cmdName":"set_tool_id","tool_id":10}"#)));
        assert!(client.wait("current_tool_id", &10.into()));
        assert_eq!((arm.state().user_frame_id, arm.state().tool_frame_id), (10, 10));

        let from = six(&client.exchange(r#"{"cmdName":"get_tcp_pos"}"#), "tcp_pos").expect("it has the key");
        assert!((from[0] - before[0]).abs() > 1.0, "the frames count: {before:?} {from:?}");
        assert!(is_accepted(client.call("moveL", LINE_UP)));
        assert!(!arm.state().at_rest);
        assert!(client.wait("inpos", &true.into()));
        assert!(arm.state().at_rest);
        let to = six(&client.exchange(r#"{"cmdName":"get_tcp_pos"}"#), "tcp_pos").expect("it has the key");
        assert!((to[2] - from[2] - 10.0).abs() < 0.01, "{firmware}: {from:?} {to:?}");
    }
}

/// `cyysky/FMCV_INSPECTION`, `FMCV/Comm/TCP_JAKA.py`: the reply to `get_data` of newer firmware takes both reads, and
/// fits into them.
#[test]
fn the_packet_of_newer_firmware_takes_both_of_its_reads() {
    let arm = arm().controller(|controller| controller.firmware(Firmware::Newer)).start();
    let mut wire = Wire::connect(&arm);
    let first = wire.ask(r#"{"cmdName":"get_data"}"#, READ);
    assert!(object(&first).is_none() && first.len() == READ, "{}", first.len());
    let second = wire.recv(READ);
    assert!(object(&(first + &second)).is_some_and(|reply| reply["inpos"] == true));
    assert!(wire.arrived.is_empty());
}

/// `cyysky/FMCV_INSPECTION`, `FMCV/Com.py`: a controller that says 100 ms after the start of a motion that the arm is
/// not in position, as field notes have it, has the line ended for the client before it began.
#[test]
fn a_line_has_ended_for_it_before_it_shows() {
    let mut delays = Delays::NONE;
    delays.in_position = Delays::REAL.in_position;
    let arm = arm().controller(|controller| controller.delays(delays)).start();
    arm.set_state(|state| (state.powered, state.enabled) = (true, true));
    let mut client = Backend::connect(&arm);
    assert!(is_accepted(client.call("moveL", LINE_UP)));
    assert!(client.wait("inpos", &true.into()));
    assert!(!arm.state().at_rest && arm.elapsed() <= FIRST_QUESTION, "it asked once");
}

/// `cyysky/FMCV_INSPECTION`, `FMCV/Com.py`: a line that takes more than 10 s is a success for the client while the arm
/// still moves, since it returns whether the line was accepted, not whether the arm is there.
#[test]
fn a_long_line_is_a_success_for_it_while_the_arm_moves() {
    let arm = arm().start();
    arm.set_state(|state| (state.powered, state.enabled) = (true, true));
    let mut client = Backend::connect(&arm);
    assert!(is_accepted(client.call("moveL", SLOW_LINE)));
    assert!(!client.wait("inpos", &true.into()));
    assert!(!arm.state().at_rest);
}

/// `cyysky/FMCV_INSPECTION`, `FMCV/Comm/TCP_JAKA.py`: replies that come with the state, as those of 1.5.14 to
/// `power_on` and `enable_robot`, come within the 10 s for which the client's socket waits.
#[test]
fn late_replies_to_power_and_enabling_come_within_its_patience() {
    let arm = arm().controller(|controller| controller.delays(Delays::REAL)).start();
    let mut wire = Wire::connect(&arm);
    for (request, reply) in [
        (r#"{"cmdName":"power_on"}"#, r#"{"errorCode": "0", "errorMsg": "", "cmdName": "power_on"}"#),
        (r#"{"cmdName":"enable_robot"}"#, r#"{"errorCode": "0", "errorMsg": "", "cmdName": "enable_robot"}"#),
    ] {
        wire.send(request);
        assert_eq!(wire.peek(), None, "the reply comes with the state");
        arm.advance(PATIENCE.saturating_sub(Duration::from_secs(1)));
        let (found, expected) = (object(&wire.recv(READ)), object(reply).expect("it is JSON"));
        let found = found.expect("it is JSON");
        assert!(expected.iter().all(|(key, value)| found.get(key) == Some(value)), "{found:?}");
    }
    assert!(arm.state().powered && arm.state().enabled);
}

/// `cyysky/FMCV_INSPECTION`, `FMCV/Comm/TCP_JAKA.py`: a refusal is none of its successes, and its message is handed on.
/// Its mode `end_mode`, which none of its calls uses, sends that as the command's name.
#[test]
fn refusals_are_no_successes() {
    let arm = arm().start();
    let mut client = Backend::connect(&arm);
    let refused = |message: &str| (false, Some(message.to_owned()));
    assert_eq!(client.call("moveL", LINE_UP), refused("call moveL failed"));
    let unknown = r#"{"cmdName":"end_mode", "endPosition":[0, 0, 10, 0, 0, 0], "speed":20, "accel":100}"#;
    assert_eq!(client.call("end_mode", unknown), refused("Exception:function call failed"));
    assert!(is_accepted(client.call("power_on", r#"{"cmdName":"power_on"}"#)));
}

/// `cyysky/FMCV_INSPECTION`, `FMCV/Comm/TCP_JAKA.py`: a code that is a number and a name with blanks, as some firmware
/// writes them, are no success for the client, either of them. It waits in vain for a frame that is selected.
#[test]
fn a_code_that_is_a_number_is_no_success_for_it() {
    let arm = arm().start();
    for name in ["set_user_id", "get_data"] {
        arm.set_reply(name, [("errorCode".to_owned(), 0.into()), ("cmdName".to_owned(), format!(" {name} ").into())]);
    }
    let mut client = Backend::connect(&arm);
    let select = r#"{"cmdName":"set_user_id","user_frame_id":10}"#;
    let reply = client.exchange(select);
    assert!(reply["errorCode"].as_f64() == Some(0.0) && reply["cmdName"] == " set_user_id ", "{reply:?}");
    let (is_success, _) = client.call("set_user_id", select);
    assert!(!is_success && arm.state().user_frame_id == 10);
    assert!(!client.wait("current_user_id", &10.into()));
}
