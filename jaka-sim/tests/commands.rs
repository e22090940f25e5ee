//! Answers of the controller. What commands change is a test of the whole project: `connection/effects`.

use crate::common::{Peer, assert_refused, fresh, json, stepped};
use jaka_spec::Requirement;

#[test]
fn what_the_controller_cannot_carry_out_is_refused() {
    let controller = stepped();
    let mut peer = Peer::commands(&controller);
    let requests = [
        ("joint_move", r#""relFlag":0"#),
        ("joint_move", r#""relFlag":0,"jointPosition":[1,2,3],"speed":1"#),
        ("joint_move", r#""relFlag":0,"jointPosition":"far","speed":1"#),
        ("joint_move", r#""relFlag":7,"jointPosition":[1,2,3,4,5,6],"speed":1"#),
        ("jog", r#""jog_mode":9"#),
        ("set_tool_id", r#""tool_id":11"#),
        ("set_tool_offsets", r#""tooloffset":[0,0,0,0,0,0],"id":-1,"name":"""#),
        ("rapid_rate", r#""rate_value":1.5"#),
        ("set_digital_output", r#""type":0,"index":99999999,"value":1"#),
        ("set_analog_output", r#""type":0,"index":99999999,"value":1"#),
        ("modify_user_defined_variable", r#""id_new":1,"alias_new":"n","value_new":1"#),
        ("rename_traj_file_name", r#""src":"none","dest":"n""#),
        ("remove_traj_file", r#""fileName":"none""#),
        ("generate_traj_exe_file", r#""fileName":"none""#),
        ("set_admit_ctrl_config", r#""axis":6,"opt":1,"ftUser":1,"ftConstant":1,"ftNnormalTrack":0,"ftReboundFK":0"#),
    ];
    let before = controller.state();
    for (command, fields) in requests {
        assert_refused(&peer.ask(&format!("{{\"cmdName\":\"{command}\",{fields}}}")), command);
    }
    assert_eq!(controller.state(), before);
}

#[test]
fn requirements_are_those_of_the_spec() {
    let controller = stepped();
    let mut peer = Peer::commands(&controller);
    let spec = jaka_spec::builtin().expect("the spec is correct");
    for command in spec.commands() {
        let text = command.examples.iter().find_map(|example| example.request.as_deref());
        let text = text.expect("the spec has a request of each command");
        for requirement in &command.requires {
            controller.set_state(|state| {
                state.powered = *requirement != Requirement::Powered;
                state.enabled = *requirement != Requirement::Enabled;
                state.servo_mode = *requirement == Requirement::NotServoMode;
            });
            let reply = peer.ask(text);
            let (code, message) = match &command.refusal {
                Some(refusal) => (refusal.code, refusal.message.clone()),
                None => (2, format!("call {} failed", command.wire)),
            };
            assert_eq!(reply["errorCode"], code.to_string(), "{text}");
            assert_eq!(reply["errorMsg"], message, "{text}");
        }
    }
}

#[test]
fn the_state_begins_as_the_document_prints_it() {
    let controller = fresh();
    let mut peer = Peer::commands(&controller);
    let spec = jaka_spec::builtin().expect("the spec is correct");
    // Which inputs there are is taken from the status packet, servo mode cannot be on without power, and the arm is a
    // real one.
    let others = ["get_digital_input_status", "is_in_servomove", "get_extio_status"];
    let others = [&others[..], &["get_joint_pos", "get_tcp_pos", "get_dh_param"]].concat();
    let of_document = spec.commands().filter(|command| command.section.is_some());
    let queries = of_document.filter(|command| command.effect == jaka_spec::Effect::Query && command.is_bare());
    for command in queries.filter(|command| !others.contains(&&*command.wire)) {
        let printed = command.examples.iter().find_map(|example| example.reply.as_deref());
        let printed = json(printed.expect("the spec has a reply of each query"));
        let reply = peer.call(&command.wire);
        assert_eq!(normal(&reply.to_string()), normal(&printed.to_string()));
    }
}

/// JSON in which whole numbers have no fraction.
fn normal(text: &str) -> String {
    text.replace(".0,", ",").replace(".0]", "]").replace(".0}", "}")
}
