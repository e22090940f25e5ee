//! Writes the JSON Schema and messages for a validator: `schema_messages FOLDER` makes `protocol.schema.json`,
//! `passes/` with what the client sends and reads, and `fails/` with what it does not send. See `tests/json-schema`.

use std::error::Error;
use std::fs;
use std::path::Path;

use jaka_proto::Request;
use jaka_proto::check::AdvisoryRanges;
use jaka_spec::Spec;
use jaka_spec::tools::schema;
use jaka_tests::{any_object, any_request};
use proptest::strategy::{Strategy as _, ValueTree as _};
use proptest::test_runner::TestRunner;
use serde_json::{Value, json};

/// Number of random requests, and of replies to each command.
const REQUESTS: usize = 1000;
const REPLIES: usize = 2;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args_os().nth(1).ok_or("schema_messages FOLDER")?;
    let spec: &'static Spec = Box::leak(Box::new(jaka_spec::builtin()?));
    let (mut passes, mut fails) = (Vec::new(), wrong());
    for example in spec.commands().flat_map(|command| &command.examples) {
        for text in [&example.request, &example.reply].into_iter().flatten() {
            passes.push(serde_json::from_str(text)?);
        }
    }
    let mut runner = TestRunner::deterministic();
    for _ in 0..REQUESTS {
        let message = any_request(spec).new_tree(&mut runner).map_err(|reason| reason.to_string())?.current();
        let is_sent = Request::read(&message.to_string())?.check(AdvisoryRanges::Enforced).is_ok();
        if is_sent { &mut passes } else { &mut fails }.push(message);
    }
    for command in spec.commands() {
        for _ in 0..REPLIES {
            let mut reply = any_object(spec, spec.reply_fields(command))
                .new_tree(&mut runner)
                .map_err(|reason| reason.to_string())?
                .current();
            reply.insert("errorCode".to_owned(), "0".into());
            reply.insert("cmdName".to_owned(), command.wire.clone().into());
            passes.push(reply.into());
        }
    }
    let path = Path::new(&folder);
    for (name, messages) in [("passes", &passes), ("fails", &fails)] {
        let folder = path.join(name);
        fs::create_dir_all(&folder)?;
        for (number, message) in messages.iter().enumerate() {
            fs::write(folder.join(format!("{number}.json")), message.to_string())?;
        }
        println!("{} messages in {name}", messages.len());
    }
    fs::write(path.join("protocol.schema.json"), schema(spec).to_string())?;
    Ok(())
}

/// Messages of which each has one mistake.
fn wrong() -> Vec<Value> {
    let joint_move = |key: &str, value: Value| {
        let mut message = json!({ "cmdName": "joint_move", "relFlag": 0, "jointPosition": [0, 0, 0, 0, 0, 0], "speed": 20, "accel": 20 });
        message[key] = value;
        message
    };
    vec![
        joint_move("cmdName", json!("joint_moves")),
        joint_move("cmdName", json!(null)),
        joint_move("speed", json!(null)),
        joint_move("speed", json!(-1)),
        joint_move("speed", json!("20")),
        joint_move("acceleration", json!(20)),
        joint_move("relFlag", json!(2)),
        joint_move("jointPosition", json!([0, 0, 0, 0, 0])),
        joint_move("jointPosition", json!([0, 0, 0, 0, 0, "0"])),
        json!({ "cmdName": "jog", "jog_mode": 4, "coord_map": 1, "jnum": 1 }),
        json!({ "cmdName": "jog", "jog_mode": 0, "coord_map": 1, "jnum": 6 }),
        json!({ "cmdName": "jog", "jog_mode": 1, "coord_map": 1, "jnum": 1 }),
        json!({ "cmdName": "end_move", "endPosition": [0, 0, 0, 0, 0, 0, 0], "speed": 1 }),
        json!({ "cmdName": "load_program", "programName": "程序" }),
        json!({ "cmdName": "set_digital_output", "type": 3, "index": 1, "value": 1 }),
        json!(["power_on"]),
        json!({ "errorCode": "0", "cmdName": "get_robot_state", "enable": "on", "power": 1 }),
        json!({ "errorCode": "0", "cmdName": "get_robot_state", "enable": true, "power": null }),
        json!({ "errorCode": "none" }),
    ]
}
