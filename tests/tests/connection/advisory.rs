//! Checks that need no model of the arm, before a byte goes out: positions, speeds, accelerations and steps that no arm
//! has.

use jaka_proto::check::InvalidArgument;
use jaka_robot::{AdvisoryRanges, Client, ErrorKind, Robot, SessionConfig};
use jaka_sync::Error;
use jaka_tests::{Arm, spec};
use serde_json::{Map, Value};

use crate::effects::call;

/// A request of each command that goes out.
const BASES: [&str; 9] = [
    r#"{"cmdName":"joint_move","relFlag":0,"jointPosition":[0,0,0,0,0,0],"speed":20}"#,
    r#"{"cmdName":"end_move","endPosition":[0,0,0,0,0,0],"speed":20}"#,
    r#"{"cmdName":"moveL","relFlag":0,"cartPosition":[0,0,0,0,0,0],"speed":20}"#,
    r#"{"cmdName":"movc","relFlag":0,"pos_mid":[0,0,0,0,0,0],"pos_end":[0,0,0,0,0,0],"speed":9,"accel":5,"tol":0}"#,
    r#"{"cmdName":"jog","jog_mode":1,"coord_map":1,"jnum":0,"jogvel":30}"#,
    r#"{"cmdName":"servo_j","relFlag":0,"jointPosition":[0,0,0,0,0,0]}"#,
    r#"{"cmdName":"servo_p","catPosition":[0,0,0,0,0,0],"relFlag":1}"#,
    r#"{"cmdName":"start_torq_sensor_payload_identify","jointPosition":[0,0,0,0,0,0]}"#,
    r#"{"cmdName":"set_traj_config","acc":100,"vel":20,"xyz_interval":0.1,"rpy_interval":0.1}"#,
];

/// Requests of what no arm does: a command, fields that differ from those above, and the field that is refused with its
/// permitted range in words.
const REFUSED: [(&str, &str, &str, &str); 32] = [
    ("joint_move", r#"{"jointPosition":[1000,0,0,0,0,0]}"#, "joint_position[0]", "-360 to 360 deg"),
    ("joint_move", r#"{"jointPosition":[0,0,0,0,0,-360.1]}"#, "joint_position[5]", "-360 to 360 deg"),
    ("joint_move", r#"{"relFlag":1,"jointPosition":[0,720.5,0,0,0,0]}"#, "joint_position[1]", "-720 to 720 deg"),
    ("joint_move", r#"{"speed":9000}"#, "speed", "more than 0, at most 265 deg/s"),
    ("joint_move", r#"{"speed":0}"#, "speed", "more than 0, at most 265 deg/s"),
    ("joint_move", r#"{"accel":0}"#, "acceleration", "more than 0, at most 720 deg/s²"),
    ("joint_move", r#"{"accel":721}"#, "acceleration", "more than 0, at most 720 deg/s²"),
    ("end_move", r#"{"speed":0}"#, "speed", "more than 0, at most 265 deg/s"),
    ("end_move", r#"{"speed":300}"#, "speed", "more than 0, at most 265 deg/s"),
    ("end_move", r#"{"accel":8000}"#, "acceleration", "more than 0, at most 720 deg/s²"),
    ("moveL", r#"{"speed":0}"#, "speed", "more than 0, at most 10000 mm/s"),
    ("moveL", r#"{"speed":10001}"#, "speed", "more than 0, at most 10000 mm/s"),
    ("moveL", r#"{"relFlag":1,"accel":8001}"#, "acceleration", "more than 0, at most 8000 mm/s²"),
    ("movc", r#"{"speed":0}"#, "speed", "more than 0, at most 10000 mm/s"),
    ("movc", r#"{"accel":0}"#, "acceleration", "more than 0, at most 8000 mm/s²"),
    ("jog", r#"{"jogvel":-266}"#, "velocity", JOINT_JOG),
    ("jog", r#"{"coord_map":0,"jogvel":0}"#, "velocity", TCP_JOG),
    ("jog", r#"{"jog_mode":2,"jogvel":-0.0,"poscmd":1}"#, "velocity", JOINT_JOG),
    ("jog", r#"{"jog_mode":2,"poscmd":-721}"#, "distance", JOG_BY),
    ("jog", r#"{"jog_mode":3,"poscmd":361}"#, "position", JOG_TO),
    ("servo_j", r#"{"jointPosition":[0,0,0,361,0,0],"stepNum":1}"#, "joint_position[3]", "-360 to 360 deg"),
    ("servo_j", r#"{"relFlag":1,"jointPosition":[2.13,0,0,0,0,0]}"#, "joint_position[0]", "-2.12 to 2.12 deg"),
    (
        "servo_j",
        r#"{"relFlag":1,"jointPosition":[0,4.25,0,0,0,0],"stepNum":2}"#,
        "joint_position[1]",
        "-4.24 to 4.24 deg",
    ),
    ("servo_j", r#"{"stepNum":13}"#, "step_count", "1 to 12"),
    ("servo_p", r#"{"catPosition":[300,0,0,0,0,0],"stepNum":1}"#, "pose.x", "-80 to 80 mm"),
    ("servo_p", r#"{"catPosition":[0,0,-80.5,0,0,0]}"#, "pose.z", "-80 to 80 mm"),
    ("servo_p", r#"{"catPosition":[0,0,0,0,0,9.5]}"#, "pose.rz", "-9 to 9 deg"),
    ("servo_p", r#"{"catPosition":[0,0,0,-28,0,0],"stepNum":3}"#, "pose.rx", "-27 to 27 deg"),
    ("servo_p", r#"{"relFlag":0,"stepNum":13}"#, "step_count", "1 to 12"),
    (
        "start_torq_sensor_payload_identify",
        r#"{"jointPosition":[0,0,-400,0,0,0]}"#,
        "joint_position[2]",
        "-360 to 360 deg",
    ),
    ("set_traj_config", r#"{"acc":0}"#, "acceleration", "more than 0, at most 8000 mm/s²"),
    ("set_traj_config", r#"{"vel":20000}"#, "speed", "more than 0, at most 10000 mm/s"),
];
const JOINT_JOG: &str = "-265 to 265 deg/s for a joint or a rotation, mm/s for a translation, not 0";
const JOG_BY: &str = "-720 to 720 deg for a joint or a rotation, mm for a translation";
const JOG_TO: &str = "-360 to 360 deg for a joint or a rotation, mm for a translation";
const TCP_JOG: &str = "-10000 to 10000 deg/s for a joint or a rotation, mm/s for a translation, not 0";

/// The requests that are refused.
fn refused() -> impl Iterator<Item = (String, &'static str, &'static str)> {
    let object = |text: &str| serde_json::from_str::<Map<String, Value>>(text).expect("it is JSON");
    REFUSED.iter().map(move |(command, fields, field, allowed)| {
        let base = BASES.iter().find(|base| base.contains(&format!("\"{command}\""))).expect("it has one");
        let mut request = object(base);
        request.extend(object(fields));
        (Value::from(request).to_string(), *field, *allowed)
    })
}

/// Requests at the ends of what is advised, or of which nothing is.
const SENT: [&str; 14] = [
    r#"{"cmdName":"joint_move","relFlag":0,"jointPosition":[360,-360,0,0,0,0],"speed":265,"accel":720}"#,
    r#"{"cmdName":"joint_move","relFlag":1,"jointPosition":[720,-720,361,0,0,0],"speed":0.001,"accel":0.001}"#,
    r#"{"cmdName":"end_move","endPosition":[5000,0,0,500,0,0],"speed":265}"#,
    r#"{"cmdName":"moveL","relFlag":0,"cartPosition":[0,0,0,0,0,0],"speed":10000,"accel":8000}"#,
    r#"{"cmdName":"movc","relFlag":1,"pos_mid":[0,0,0,0,0,0],"pos_end":[0,0,0,0,0,0],"speed":9,"accel":5,"tol":0}"#,
    r#"{"cmdName":"jog","jog_mode":0,"coord_map":1,"jnum":0}"#,
    r#"{"cmdName":"jog","jog_mode":1,"coord_map":1,"jnum":0,"jogvel":-265}"#,
    r#"{"cmdName":"jog","jog_mode":3,"coord_map":2,"jnum":0,"jogvel":266,"poscmd":1000}"#,
    r#"{"cmdName":"servo_j","relFlag":0,"jointPosition":[360,0,0,0,0,0]}"#,
    r#"{"cmdName":"servo_j","relFlag":1,"jointPosition":[2.12,0,0,0,0,-2.12]}"#,
    r#"{"cmdName":"servo_j","relFlag":1,"jointPosition":[25.44,0,0,0,0,0],"stepNum":12}"#,
    r#"{"cmdName":"servo_p","catPosition":[80,0,-80,9,0,-9],"relFlag":1,"stepNum":1}"#,
    r#"{"cmdName":"servo_p","catPosition":[960,0,0,108,0,0],"relFlag":1,"stepNum":12}"#,
    r#"{"cmdName":"servo_p","catPosition":[960,0,0,180,0,0],"relFlag":0}"#,
];

/// A controller whose arm is enabled, and its client.
fn ready(ranges: AdvisoryRanges) -> (Arm, Client) {
    Arm::simulated().config(|config| config.advisory_ranges(ranges)).with_client()
}

#[track_caller]
fn invalid(error: &Error) -> &InvalidArgument {
    let jaka_sync::ErrorKind::InvalidArgument(invalid) = error.kind() else { panic!("{error}") };
    invalid
}

#[test]
fn what_no_arm_does_is_refused_before_a_byte_goes_out() {
    let (controller, mut client) = ready(AdvisoryRanges::Enforced);
    for (text, field, allowed) in refused() {
        let error = call(&mut client, &text).expect_err(&text);
        let invalid = invalid(&error);
        assert_eq!((&*invalid.field, &*invalid.allowed, invalid.advisory), (field, allowed, true), "{text}");
        assert!(!error.may_have_run(), "{text}");
    }
    assert_eq!(controller.requests(), Vec::<String>::new());
}

#[test]
fn it_says_so_and_how_to_send_it_nevertheless() {
    let (_controller, mut client) = ready(AdvisoryRanges::Enforced);
    let (text, ..) = refused().nth(3).expect("there are more");
    let error = call(&mut client, &text).expect_err("no joint is as fast");
    assert_eq!(
        invalid(&error).to_string(),
        "`joint_move` was not sent: field `speed` is 9000, allowed is more than 0, at most 265 deg/s; \
         this is advisory: `AdvisoryRanges::Ignored` leaves it to the controller"
    );
}

#[test]
fn it_goes_out_where_that_is_left_to_the_controller() {
    let (controller, mut client) = ready(AdvisoryRanges::Ignored);
    for ((text, ..), (name, ..)) in refused().zip(REFUSED) {
        if let Err(error) = call(&mut client, &text) {
            assert!(error.is_refused(), "{text}: {error}");
        }
        assert!(controller.requests().last().is_some_and(|last| last.contains(name)), "{text}");
    }
    assert_eq!(controller.requests().len(), REFUSED.len());
}

#[test]
fn what_is_forbidden_stays_forbidden() {
    let (controller, mut client) = ready(AdvisoryRanges::Ignored);
    for text in [
        r#"{"cmdName":"joint_move","relFlag":0,"jointPosition":[0,0,0,0,0,0],"speed":-1}"#,
        r#"{"cmdName":"servo_j","relFlag":0,"jointPosition":[0,0,0,0,0,0],"stepNum":0}"#,
        r#"{"cmdName":"jog","jog_mode":1,"coord_map":1,"jnum":6,"jogvel":1}"#,
    ] {
        let error = call(&mut client, text).expect_err(text);
        assert!(!invalid(&error).advisory, "{text}");
    }
    assert_eq!(controller.requests(), Vec::<String>::new());
}

#[test]
fn what_an_arm_may_do_goes_out() {
    let (controller, mut client) = ready(AdvisoryRanges::Enforced);
    for text in SENT {
        if let Err(error) = call(&mut client, text) {
            assert!(error.is_refused(), "{text}: {error}");
        }
    }
    assert_eq!(controller.requests(), SENT);
}

/// By the model, with values under their names and a whole object in place of an array, the same is refused and the
/// same sent.
#[test]
fn the_model_refuses_the_same_in_the_same_words() {
    let spec = spec();
    let by_model = |text: &str, ranges| {
        let mut fields: Map<String, Value> = serde_json::from_str(text).expect("it is JSON");
        let name = fields.remove("cmdName").expect("it has a name");
        let command = spec.command(name.as_str().expect("it is a name")).expect("the spec has it");
        if let Some(Value::Array(pose)) = fields.get("catPosition") {
            let names = ["x", "y", "z", "rx", "ry", "rz"].map(str::to_owned).into_iter();
            let pose: Map<_, _> = names.zip(pose.clone()).collect();
            fields.insert("catPosition".to_owned(), pose.into());
        }
        if command.name.starts_with("servo") {
            let name = if fields["relFlag"] == 0 { "absolute" } else { "Relative" };
            fields.insert("relFlag".to_owned(), name.into());
        }
        jaka_dynamic::request(&spec, command, &fields, ranges)
    };
    for (text, field, allowed) in refused() {
        let problems = by_model(&text, AdvisoryRanges::Enforced).expect_err(&text);
        let [problem] = &*problems else { panic!("{text}: {problems:?}") };
        assert_eq!((&*problem.field, problem.advisory), (field, true), "{text}");
        assert!(problem.allowed.ends_with(allowed), "{text}: {problem}");
        by_model(&text, AdvisoryRanges::Ignored).expect("it is left to the controller");
    }
    for text in SENT {
        let sent = by_model(text, AdvisoryRanges::Enforced);
        assert_eq!(sent.as_deref(), Ok(text));
    }
}

#[test]
fn a_servo_session_refuses_it_and_ends() {
    let (controller, client) = ready(AdvisoryRanges::Enforced);
    let mut robot = Robot::new(client, controller.monitor()).expect("it is the only robot");
    let config = SessionConfig::new().unchecked();
    let refused = |sent: Result<(), jaka_robot::Error>, field: &str| {
        let error = sent.expect_err(field);
        assert_eq!(invalid(error.connection().expect(field)).field, field);
    };
    let entered = "the arm is enabled";
    let mut session = robot.enter_servo_mode(&config).expect(entered);
    refused(session.send_pose_offset([300.0, 0.0, 0.0, 0.0, 0.0, 0.0]), "pose.x");
    assert!(matches!(session.send_joints([0.0; 6]).unwrap_err().kind(), ErrorKind::SessionEnded { .. }));
    drop(session);
    let mut session = robot.enter_servo_mode(&config).expect(entered);
    refused(session.send_pose_offset([0.0, 0.0, 0.0, 0.0, 10.0, 0.0]), "pose.ry");
    drop(session);
    let mut session = robot.enter_servo_mode(&config).expect(entered);
    refused(session.send_joints([400.0, 0.0, 0.0, 0.0, 0.0, 0.0]), "joint_position[0]");
    drop(session);
    let sent = controller.requests();
    let set_points: Vec<_> =
        sent.iter().filter(|request| request.contains("servo_j") || request.contains("servo_p")).collect();
    assert_eq!(set_points, Vec::<&String>::new());
}
