//! Transcripts: what clients send, and what they make of the replies. Each begins with a line that names its client and
//! what it shows; the lines after it are the steps.
//!
//! | `reads` | what the client does with the reply |
//! |---|---|
//! | `code` | prints the code of the parsed reply, and the reply if that is not 0 |
//! | `fast code` | the same with the code behind `"errorCode": "` in the text |
//! | `state` | prints whether power and enabling are the words that it knows |
//! | `key …` | prints a key of the parsed reply, as Python does |
//! | `numbers …` | remembers the numbers behind a key and a bracket; `JOINTS` and `POSE` of later requests |
//! | `blind` | nothing |
//! | `reply` | takes the text as it is; `reply at rest` comes only when the arm rests |
//! | `six …` | takes six numbers, here to a hundredth |
//! | `accepted` | wants the code `"0"`, its command's name, and these keys: numbers or truth values, or with these values |

use std::time::Duration;

use jaka_sim::{Firmware, Model};
use jaka_tests::{Arm, CYCLE, LONG};
use serde_json::{Map, Value};

use super::{Wire, are_close, object, six};

/// `nkawa/JAKA_Zu5s_MQTT_Control` builds requests by concatenation, most of them with a blank behind the colon, and
/// reads a reply by one `recv`. `RobotControlAndMachineVisionLaboratory/jaka_controller_tcp_ros` writes numbers by
/// `std::to_string`, so with six decimals of a `float`; it was written for firmware 1.4.11, which is older than any
/// that the simulator has. The vendor's library is known by the commands and keys that it sent to a recording server:
/// blanks, the order of members and the values are ours.
const TRANSCRIPTS: &str = include_str!("transcripts.jsonl");

/// A client, and what it remembers.
struct Client<'a> {
    wire: Wire<'a>,
    /// Size of its one read of a reply.
    size: usize,
    /// The positions that were read last, as Python joins them with commas.
    joints: String,
    pose: String,
    /// The parameters of a run whose author passed the whole tuple in place of its list.
    with_tuples: bool,
}

fn arm(header: &Value) -> Arm {
    let mut arm = Arm::stepped().without_power().no_packets();
    if let Some(at) = header.as_object().and_then(|header| six(header, "at")) {
        arm = arm.at(at);
    }
    let firmware = Firmware::ALL.iter().find(|firmware| header["firmware"] == firmware.name()).expect("there is one");
    let model = header["model"].as_str().map(|name| Model::named(name).expect("it is published").clone());
    let arm = arm.controller(|controller| {
        let controller = controller.firmware(*firmware);
        if let Some(model) = model { controller.model(model) } else { controller }
    });
    let arm = arm.start();
    arm.set_state(|state| {
        (state.powered, state.enabled) = (header["powered"] == true, header["powered"] == true);
        state.tool_frame_id = header["tool_frame_id"].as_i64().unwrap_or(state.tool_frame_id);
    });
    arm
}

/// Lets the arm come to rest. Before it does, `check` is called.
fn rest(arm: &Arm, check: impl Fn()) {
    let end = arm.elapsed() + LONG;
    while !arm.state().at_rest {
        assert!(arm.elapsed() < end, "it rests");
        check();
        arm.advance(Duration::from_millis(200));
    }
}

fn of_state(arm: &Arm, key: &str) -> Value {
    let state = arm.state();
    match key {
        "powered" => state.powered.into(),
        "enabled" => state.enabled.into(),
        "at_rest" => state.at_rest.into(),
        "rapid_rate" => state.rapid_rate.into(),
        "tool_frame_id" => state.tool_frame_id.into(),
        _ => panic!("say here what `{key}` is"),
    }
}

impl Client<'_> {
    /// Sends a request, and returns the reply when the way there and back has taken a cycle.
    fn ask(&mut self, bytes: &str) -> String {
        let reply = self.wire.ask(bytes, self.size);
        self.wire.arm.advance(CYCLE);
        reply
    }

    fn step(&mut self, step: &Value) {
        if let Some(state) = step["state"].as_object() {
            for (key, expected) in state {
                assert_eq!(of_state(self.wire.arm, key), *expected, "{key}");
            }
        } else if step["rests"] == true {
            rest(self.wire.arm, || {});
        } else {
            let bytes = step["send"].as_str().expect("a step is a request, a state or a rest");
            let bytes = bytes.replace("JOINTS", &self.joints).replace("POSE", &self.pose);
            let (reads, gives) = (step["reads"].as_str().expect("it says how it reads"), &step["gives"]);
            self.call(&bytes, reads, gives);
        }
    }

    fn call(&mut self, bytes: &str, reads: &str, gives: &Value) {
        if reads == "reply at rest" {
            self.wire.send(bytes);
            rest(self.wire.arm, || assert_eq!(self.wire.peek(), None, "the arm still moves"));
            return assert_eq!(self.wire.recv(self.size), *gives);
        }
        let reply = self.ask(bytes);
        let parsed = object(&reply);
        let read = || parsed.as_ref().expect("a parser takes the reply");
        match reads.split_once(' ').unwrap_or((reads, "")) {
            ("blind", _) => {}
            ("reply", _) => assert_eq!(reply, *gives),
            ("six", key) => {
                let expected: Vec<_> = gives.as_array().into_iter().flatten().filter_map(Value::as_f64).collect();
                let found = six(read(), key).expect("it has the key");
                assert!(are_close(found, expected.try_into().expect("there are six"), 0.01), "{found:?}");
            }
            ("accepted", _) => accepted(bytes, read(), gives),
            (kind, key) => assert_eq!(self.printed(&reply, parsed.as_ref(), (kind, key)), *gives),
        }
    }

    /// The tuple that the program in Python prints.
    fn printed(&mut self, reply: &str, parsed: Option<&Map<String, Value>>, (kind, key): (&str, &str)) -> String {
        let code = match kind {
            "fast" | "numbers" => fast_code(reply),
            _ => code(parsed.expect("`json.loads` takes the reply")),
        };
        if code != 0 {
            return format!("({code}, '{reply}')");
        }
        let member = |key: &str| parsed.and_then(|parsed| parsed.get(key)).expect("it has the key");
        match kind {
            "code" | "fast" => "(0,)".to_owned(),
            "state" => {
                let is = |key: &str, word: &str| u8::from(member(key) == word);
                format!("(0, {}, {})", is("power", "powered_on"), is("enable", "robot_enabled"))
            }
            "key" => format!("(0, {})", python(member(key))),
            "numbers" => {
                let numbers: Option<Vec<String>> = numbers(reply, key);
                let Some(numbers) = numbers else { return format!("(0, '{reply}')") };
                assert_eq!(numbers.len(), 6, "{reply}");
                let joined = if self.with_tuples { format!("0,[{}]", numbers.join(", ")) } else { numbers.join(",") };
                *(if key == "joint_pos" { &mut self.joints } else { &mut self.pose }) = joined;
                "(0, six numbers)".to_owned()
            }
            _ => panic!("say here how a client reads `{kind}`"),
        }
    }
}

fn accepted(bytes: &str, reply: &Map<String, Value>, keys: &Value) {
    let name = object(bytes).expect("it is JSON")["cmdName"].clone();
    assert_eq!((&reply["errorCode"], &reply["cmdName"]), (&"0".into(), &name), "{reply:?}");
    for key in keys.as_array().into_iter().flatten().filter_map(Value::as_str) {
        assert!(reply.get(key).is_some_and(|value| value.is_number() || value.is_boolean()), "{key} of {reply:?}");
    }
    for (key, value) in keys.as_object().into_iter().flatten() {
        assert_eq!(reply.get(key), Some(value), "{key}");
    }
}

/// The code of a parsed reply, by Python's `int`.
fn code(reply: &Map<String, Value>) -> i64 {
    let code = reply.get("errorCode").expect("it has a code");
    code.as_str().map_or_else(|| code.as_i64(), |code| code.trim().parse().ok()).expect("`int` takes it")
}

/// The code after `"errorCode": "` in a reply; -1 in another form.
fn fast_code(reply: &str) -> i64 {
    let found = reply.split_once(r#""errorCode": ""#).and_then(|(_, rest)| rest.split_once('"'));
    found.map_or(-1, |(code, _)| code.parse().expect("`int` takes it"))
}

/// The numbers that stand in a reply behind a key, a blank and a bracket, as Python prints them.
fn numbers(reply: &str, key: &str) -> Option<Vec<String>> {
    let (_, rest) = reply.split_once(&format!("\"{key}\": ["))?;
    let (list, _) = rest.split_once(']')?;
    let numbers = list.split(',').map(|number| number.trim().parse().ok());
    numbers.map(|number| number.map(|number: f64| format!("{number:?}"))).collect()
}

/// A value as Python prints it.
fn python(value: &Value) -> String {
    match value {
        Value::Bool(true) => "True".to_owned(),
        Value::Bool(false) => "False".to_owned(),
        Value::String(text) => format!("'{text}'"),
        other => other.to_string(),
    }
}

#[test]
fn clients_make_of_each_reply_what_their_transcripts_have() {
    let lines: Vec<Value> = TRANSCRIPTS.lines().map(|line| serde_json::from_str(line).expect("it is JSON")).collect();
    for run in lines.chunk_by(|_, next| next.get("client").is_none()) {
        let (header, steps) = run.split_first().expect("a chunk is not empty");
        let arm = arm(header);
        let size = header["size"].as_u64().and_then(|size| usize::try_from(size).ok()).expect("it has a size");
        let (joints, pose, with_tuples) = (String::new(), String::new(), header["tuples"] == true);
        let mut client = Client { wire: Wire::connect(&arm), size, joints, pose, with_tuples };
        for step in steps {
            println!("{} {}: {step}", header["client"], header["shows"]);
            client.step(step);
        }
    }
}
