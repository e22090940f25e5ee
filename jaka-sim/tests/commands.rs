//! Answers of the controller.

use std::time::Duration;

use crate::common::{Peer, assert_accepted, assert_refused, assert_unknown, fresh, json, request, stepped};
use jaka_proto::{Command, Envelope, Request, Visit, read_payload};
use jaka_spec::Requirement;

#[test]
fn power_comes_before_enabling_and_enabling_before_motion() {
    let controller = fresh();
    let mut peer = Peer::commands(&controller);
    let state = |enable: &str, power: &str| {
        json(&format!(
            r#"{{"errorCode":"0","errorMsg":"","cmdName":"get_robot_state","enable":"{enable}","power":"{power}"}}"#
        ))
    };
    let jog = r#"{"cmdName":"jog","jog_mode":2,"coord_map":1,"jnum":5,"jogvel":30,"poscmd":20}"#;
    assert_eq!(peer.call("get_robot_state"), state("robot_disabled", "powered_off"));
    assert_refused(&peer.call("enable_robot"), "enable_robot");
    assert_eq!(peer.call("power_on")["power status"], "True");
    assert_refused(&peer.ask(jog), "jog");
    assert_eq!(peer.call("enable_robot")["enabled status"], "True");
    assert_accepted(&peer.ask(jog), "jog");
    assert_eq!(peer.call("get_robot_state"), state("robot_enabled", "powered_on"));
    assert_accepted(&peer.call("power_off"), "power_off");
    assert_eq!(peer.call("get_robot_state"), state("robot_disabled", "powered_off"));
    assert_accepted(&peer.call("power_on"), "power_on");
    assert_refused(&peer.ask(jog), "jog");
    assert_accepted(&peer.call("shutdown"), "shutdown");
    assert!(!controller.state().powered);
}

#[test]
fn servo_mode_ends_with_what_it_needs() {
    let controller = stepped();
    let mut peer = Peer::commands(&controller);
    let enter = r#"{"cmdName":"servo_move","relFlag":1}"#;
    for end in ["power_off", "disable_robot"] {
        assert_accepted(&peer.ask(enter), "servo_move");
        assert_eq!(peer.call("is_in_servomove")["in_servomove"], true);
        assert_accepted(&peer.call(end), end);
        assert_eq!(peer.call("is_in_servomove")["in_servomove"], false);
        assert_refused(&peer.ask(enter), "servo_move");
        peer.call("power_on");
        peer.call("enable_robot");
    }
    peer.ask(enter);
    controller.set_state(|state| state.protective_stop = true);
    assert_eq!(peer.call("is_in_servomove")["in_servomove"], false);
    assert_eq!(peer.call("protective_stop_status")["protective_stop"], "1");
    assert_accepted(&peer.call("clear_error"), "clear_error");
    assert_eq!(peer.call("protective_stop_status")["protective_stop"], "0");
}

#[test]
fn servo_mode_decides_what_moves() {
    let controller = stepped();
    let mut peer = Peer::commands(&controller);
    let servo_j = r#"{"cmdName":"servo_j","relFlag":1,"jointPosition":[0.5,0,0,0,0,-0.5],"stepNum":1}"#;
    let joint_move = r#"{"cmdName":"joint_move","relFlag":0,"jointPosition":[0,10,20,30,40,50],"speed":20}"#;
    let filter = r#"{"cmdName":"set_servo_move_filter","filter_type":0}"#;
    let reason = "servoj command can only be excuted in servo move mode";
    let refused = json(&format!(r#"{{"errorCode":"-1","errorMsg":"{reason}","cmdName":"servo_j"}}"#));
    assert_eq!(peer.ask(servo_j), refused);
    assert_accepted(&peer.ask(joint_move), "joint_move");
    controller.advance(Duration::from_secs(30));
    assert_accepted(&peer.ask(filter), "set_servo_move_filter");
    peer.ask(r#"{"cmdName":"servo_move","relFlag":1}"#);
    assert_refused(&peer.ask(joint_move), "joint_move");
    assert_refused(&peer.ask(filter), "set_servo_move_filter");
    assert_accepted(&peer.ask(servo_j), "servo_j");
    controller.advance(Duration::from_millis(8));
    assert_eq!(peer.call("get_joint_pos")["joint_pos"], json("[0.5,10,20,30,40,49.5]"));
    peer.ask(r#"{"cmdName":"servo_move","relFlag":0}"#);
    assert_eq!(peer.ask(servo_j), refused);
}

/// A setting, the query that reads it, and what the query has to answer then.
const PAIRS: [(&str, &str, &str); 22] = [
    (r#""load_program","programName":"track/test.jks""#, "get_loaded_program", r#""programName":"track/test.jks""#),
    (r#""play_program""#, "get_program_state", r#""programState":"running""#),
    (r#""pause_program""#, "get_program_state", r#""programState":"paused""#),
    (r#""resume_program""#, "get_program_state", r#""programState":"running""#),
    (r#""stop_program""#, "get_program_state", r#""programState":"idle""#),
    (r#""set_payload","mass":2.5,"centroid":[1,2,3]"#, "get_payload", r#""mass":2.5,"centroid":[1,2,3]"#),
    (r#""set_tool_payload","mass":1.5,"centroid":[4,5,6]"#, "get_tool_payload", r#""mass":1.5,"centroid":[4,5,6]"#),
    (r#""set_clsn_sensitivity","sensitivityVal":5"#, "get_clsn_sensitivity", r#""sensitivityLevel":5"#),
    (
        r#""set_traj_config","acc":1,"vel":2,"xyz_interval":3,"rpy_interval":4"#,
        "get_traj_config",
        r#""acc":1,"vel":2,"xyz_interval":3,"rpy_interval":4"#,
    ),
    (r#""set_traj_sample_mode","mode":0,"filename":"x""#, "get_traj_sample_status", r#""sampleStatus":0"#),
    (r#""set_traj_sample_mode","mode":1,"filename":"x""#, "get_traj_sample_status", r#""sampleStatus":1"#),
    (
        r#""rename_traj_file_name","src":"test","dest":"y""#,
        "get_exist_traj_file_name",
        r#""trajTrackFileName":["pythonTrack1","y","x"]"#,
    ),
    (r#""remove_traj_file","fileName":"y""#, "get_exist_traj_file_name", r#""trajTrackFileName":["pythonTrack1","x"]"#),
    (r#""torque_control_enable","enable_flag":1"#, "drag_status", r#""drag_status":"True""#),
    (r#""torque_control_enable","enable_flag":0"#, "drag_status", r#""drag_status":"False""#),
    (r#""set_torsenosr_brand","sensor_brand":3"#, "get_torsenosr_brand", r#""sensor_brand":3"#),
    (
        r#""set_compliant_type","sensor_compensation":0,"compliance_type":2"#,
        "get_compliant_type",
        r#""sensor_compensation":0,"compliance_type":2"#,
    ),
    (r#""disable_force_control""#, "get_compliant_type", r#""sensor_compensation":0,"compliance_type":0"#),
    (
        r#""set_torque_sensor_comm","type":1,"ip_addr":"10.0.0.1","port":99"#,
        "get_torque_sensor_comm",
        r#""type":1,"ip_addr":"10.0.0.1","port":99"#,
    ),
    (
        r#""set_tio_vout_param","tio_vout_ena":1,"tio_vout_vol":1"#,
        "get_tio_vout_param",
        r#""tio_vout_ena":1,"tio_vout_vol":1"#,
    ),
    (
        r#""modify_user_defined_variable","id_new":5500,"alias_new":"n","value_new":14"#,
        "query_user_defined_variable",
        r#""var_list":[{"alias":"n","id":5500,"value":14}]"#,
    ),
    (r#""servo_move","relFlag":1"#, "is_in_servomove", r#""in_servomove":true"#),
];

#[test]
fn a_get_after_a_set_gives_it_back() {
    let controller = stepped();
    let mut peer = Peer::commands(&controller);
    for (set, get, expected) in PAIRS {
        assert_eq!(peer.ask(&format!("{{\"cmdName\":{set}}}"))["errorCode"], "0", "{set}");
        let envelope = format!(r#"{{"errorCode":"0","errorMsg":"","cmdName":"{get}",{expected}}}"#);
        assert_eq!(peer.call(get), json(&envelope), "{set}");
    }
}

#[test]
fn a_command_changes_what_it_ends_and_nothing_beside_it() {
    let controller = stepped();
    let mut peer = Peer::commands(&controller);
    peer.ask(r#"{"cmdName":"enable_admittance_ctrl","enable_flag":1}"#);
    peer.call("disable_force_control");
    assert!(!controller.state().admittance.enabled);
    peer.ask(r#"{"cmdName":"set_payload","mass":2.5,"centroid":[1,2,3]}"#);
    peer.ask(r#"{"cmdName":"set_tool_payload","mass":1.5,"centroid":[4,5,6]}"#);
    assert_eq!(
        (&peer.call("get_payload")["mass"], &peer.call("get_tool_payload")["mass"]),
        (&json("2.5"), &json("1.5"))
    );
    peer.ask(r#"{"cmdName":"torque_control_enable","enable_flag":1}"#);
    peer.call("disable_robot");
    assert_eq!(peer.call("drag_status")["drag_status"], "False");
}

#[test]
fn frames_and_axes_are_set_one_by_one() {
    let controller = fresh();
    let mut peer = Peer::commands(&controller);
    peer.ask(r#"{"cmdName":"set_tool_offsets","tooloffset":[1,2,3,4,5,6],"id":10,"name":"tcp_new"}"#);
    peer.ask(r#"{"cmdName":"set_tool_id","tool_id":10}"#);
    peer.ask(r#"{"cmdName":"set_user_offsets","userffset":[6,5,4,3,2,1],"id":1,"name":"user_new"}"#);
    peer.ask(r#"{"cmdName":"set_user_id","user_frame_id":1}"#);
    let tools = peer.call("get_tool_offsets")["tool_offsets"].clone();
    let users = peer.call("get_user_offsets")["user_offsets"].clone();
    assert_eq!((&tools[10], &tools[2]), (&json("[1,2,3,4,5,6]"), &json("[0,0,10,0,0,0]")));
    assert_eq!((&users[1], &users[2]), (&json("[6,5,4,3,2,1]"), &json("[9,9,9,9,9,9]")));
    assert_eq!((tools.as_array().map(Vec::len), users.as_array().map(Vec::len)), (Some(11), Some(11)));
    let state = controller.state();
    assert_eq!((&*state.tool_frames[10].name, state.tool_frame_id), ("tcp_new", 10));
    assert_eq!((&*state.user_frames[1].name, state.user_frame_id), ("user_new", 1));

    let fields = r#""axis":5,"opt":1,"ftUser":25,"ftConstant":5,"ftNnormalTrack":2,"ftReboundFK":3"#;
    peer.ask(&format!(r#"{{"cmdName":"set_admit_ctrl_config",{fields}}}"#));
    let axes = peer.call("get_admit_ctrl_config")["admitConfig"][0].clone();
    assert_eq!((&axes[5], &axes[2]), (&json("[1,25,3,5,2]"), &json("[1,25,0,5,0]")));
}

#[test]
fn what_has_no_query_is_in_the_state() {
    let controller = fresh();
    let mut peer = Peer::commands(&controller);
    let settings = [
        r#"{"cmdName":"rapid_rate","rate_value":0.25}"#,
        r#"{"cmdName":"set_digital_output","type":1,"index":2,"value":1}"#,
        r#"{"cmdName":"set_analog_output","type":0,"index":7,"value":4.32}"#,
        r#"{"cmdName":"set_torque_sensor_mode","sensor_mode":1}"#,
        r#"{"cmdName":"enable_admittance_ctrl","enable_flag":1}"#,
        r#"{"cmdName":"set_compliance_condition","compliant_condition":[1,2,3,4,5,6]}"#,
        r#"{"cmdName":"set_vel_compliant_ctrl","compliant_ctrl":[1,0.1,0.2,0.3,0.4]}"#,
        r#"{"cmdName":"set_network_exception_handle","timeLimit":100,"motType":2}"#,
    ];
    for setting in settings {
        assert_eq!(peer.ask(setting)["errorCode"], "0", "{setting}");
    }
    let state = controller.state();
    assert!((state.rapid_rate - 0.25).abs() < f64::EPSILON);
    assert_eq!(state.digital_outputs.into_iter().map(|(output, on)| (output.1, on)).collect::<Vec<_>>(), [(2, true)]);
    assert_eq!(state.analog_outputs.into_values().collect::<Vec<_>>(), [4.32]);
    assert!(state.admittance.enabled);
    assert_eq!(state.remembered["set_torque_sensor_mode"]["mode"], 1);
    assert_eq!(state.remembered["set_vel_compliant_ctrl"]["compliance"][0], 1);
    assert_eq!(state.remembered["set_network_exception_handle"]["delay"], 100);
}

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
fn what_is_not_a_command_is_unknown() {
    let controller = fresh();
    let mut peer = Peer::commands(&controller);
    for text in ["{\"cmdName\":\"fly\"}", "{}", "{\"a\":1}", "{\"cmdName\":3}", "{'a'}", "{{}}", "(1,2)"] {
        assert_unknown(&peer.ask(text));
    }
    assert_eq!(controller.requests().len(), 7);
    assert_eq!(controller.requests()[0], request("fly"));
}

/// Decodes a reply as that of a command.
struct Decode<'r>(&'r str);

impl Visit for Decode<'_> {
    type Output = Result<(), String>;

    fn visit<C: Command>(self, _command: &C) -> Self::Output {
        read_payload::<C::Reply>(C::INFO, self.0).map(drop).map_err(|error| error.to_string())
    }
}

#[test]
fn every_example_of_the_spec_is_answered() {
    let controller = stepped();
    let spec = jaka_spec::builtin().expect("the spec is correct");
    let mut refused = Vec::new();
    for command in spec.commands() {
        for text in command.examples.iter().filter_map(|example| example.request.as_deref()) {
            controller.set_state(|state| {
                state.powered = true;
                state.enabled = true;
                state.servo_mode = command.requires.contains(&Requirement::ServoMode);
                // That of a firmware that knows all of them.
                "1.7.2".clone_into(&mut state.version);
            });
            controller.advance(Duration::from_secs(60));
            // Some commands end the connection.
            let mut peer = Peer::commands(&controller);
            peer.send(text);
            let reply = peer.receive();
            let envelope = Envelope::read(&reply).expect("the reply is an object");
            assert_eq!(envelope.command.as_deref(), Some(&*command.wire), "{reply}");
            if envelope.code.expect("the reply has a code").is_success() {
                let request = Request::read(text).expect("the example is a request");
                assert_eq!(request.visit(Decode(&reply)), Ok(()), "{reply}");
            } else {
                refused.push(&*command.wire);
            }
        }
    }
    // A file that has been renamed before.
    assert_eq!(refused, ["remove_traj_file"]);
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
