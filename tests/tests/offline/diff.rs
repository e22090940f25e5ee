//! Differences between two specs, and what each means for programs that use the generated Rust.

use expect_test::{Expect, expect};
use jaka_spec::tools::{Difference, Impact, diff, impact, summary};
use jaka_spec::{BUILTIN, Source, Spec, load, load_pack};
use jaka_tests::spec;

/// A place such as `motion/joint_move/speed`, a text after it, and its replacement.
pub(crate) type Edit<'t> = (&'t str, &'t str, &'t str);

/// The built-in spec with texts replaced.
fn edited(edits: &[Edit<'_>]) -> Spec {
    let files = edited_files(edits);
    let sources: Vec<_> = files.iter().map(|(path, text)| Source { path, text }).collect();
    load(&sources).unwrap_or_else(|errors| panic!("{errors}"))
}

/// The files of the built-in spec with texts replaced.
pub(crate) fn edited_files(edits: &[Edit<'_>]) -> Vec<(&'static str, String)> {
    let mut files: Vec<_> = BUILTIN.iter().map(|source| (source.path, source.text.to_owned())).collect();
    for (place, from, to) in edits {
        let mut steps = place.split('/');
        let path = format!("spec/{}.toml", steps.next().expect("a place begins with a file"));
        let (_, text) = files.iter_mut().find(|(known, _)| *known == path).expect("the file is built in");
        let start = steps.fold(0, |start, step| start + after(&text[start..], step));
        let at = start + text[start..].find(from).unwrap_or_else(|| panic!("{place} has no {from}"));
        text.replace_range(at..at + from.len(), to);
    }
    files
}

/// Position of the first line of the item `name`, which is a wire spelling, a number or a Rust name.
fn after(text: &str, name: &str) -> usize {
    let lines = [format!("wire = \"{name}\"\n"), format!("wire = {name}\n"), format!("name = \"{name}\"\n")];
    let found = lines.iter().filter_map(|line| text.find(line)).min();
    found.unwrap_or_else(|| panic!("there is no {name}"))
}

/// The text of a command, from its `[[command]]` to the next.
pub(crate) fn command_text(file: &str, wire: &str) -> &'static str {
    let path = format!("spec/{file}.toml");
    let text = BUILTIN.iter().find(|source| source.path == path).expect("the file is built in").text;
    let start = text.find(&format!("[[command]]\nwire = \"{wire}\"")).expect("the command is there");
    let end = text[start + 1..].find("\n[[command]]").map_or(text.len(), |end| start + 2 + end);
    &text[start..end]
}

fn lines(changes: &[Difference]) -> String {
    changes.iter().map(|change| change.to_string() + "\n").collect()
}

/// Checks the differences that the edits make, and those of their undoing that are major.
fn check(edits: &[Edit<'_>], done: &Expect, undone: &Expect) {
    let edited = edited(edits);
    done.assert_eq(&lines(&diff(&spec(), &edited)));
    let mut back = diff(&edited, &spec());
    back.retain(|change| change.impact == Impact::Major);
    undone.assert_eq(&lines(&back));
}

#[test]
fn a_spec_does_not_differ_from_itself() {
    assert_eq!(diff(&spec(), &spec()), []);
    assert_eq!(impact(&[]), None);
}

#[test]
fn the_gravest_impact_decides() {
    let reworded = ("motion/movc", "along an arc", "on an arc");
    let renamed = ("motion/movc", r#"name = "move_c""#, r#"name = "move_arc""#);
    assert_eq!(impact(&diff(&spec(), &edited(&[reworded]))), Some(Impact::Patch));
    assert_eq!(impact(&diff(&spec(), &edited(&[reworded, renamed]))), Some(Impact::Major));
    assert!(Impact::Patch < Impact::Minor && Impact::Minor < Impact::Major);
    assert_eq!(summary(&diff(&edited(&[reworded, renamed]), &spec())), "2 changes, major");
    assert_eq!(summary(&[]), "no differences");
}

#[test]
fn commands_come_go_and_move() {
    let (quit, move_c) = (command_text("session", "quit"), command_text("motion", "movc"));
    let added =
        "[[command]]\nwire = \"demo_motion_state\"\neffect = \"query\"\ndoc = \"Reads how the motion stands.\"\n";
    let with_move_c = format!("{move_c}\n[[type]]");
    check(
        &[("session", quit, added), ("motion", move_c, ""), ("network", "[[type]]", &with_move_c)],
        &expect![[r"
            major: command `movc`: topic changed from `motion` to `network`
            major: command `quit`: removed
            minor: command `demo_motion_state`: added
        "]],
        &expect![[r"
            major: command `demo_motion_state`: removed
            major: command `movc`: topic changed from `network` to `motion`
        "]],
    );
}

#[test]
fn what_is_said_about_a_command() {
    check(
        &[
            ("motion/movc", r#"name = "move_c""#, r#"name = "move_arc""#),
            ("motion/movc", "\"The `cmdName` is `movc`, while the section is titled MoveC.\",", ""),
            ("motion/joint_move", r#"section = "4.7""#, "section = \"4.107\"\nsince = \"1.6\"\nuntil = \"2\""),
            ("collision/clear_error", r#"effect = "power""#, r#"effect = "setting""#),
            ("motion/end_move", "deadline_ms = 60000\n", ""),
            ("motion/joint_move", "acceleration = \"acceleration\"\n", ""),
            (
                "motion/movc",
                "[command.motion]\npath = \"arc\"\ntarget = \"end_pose\"\nmode = { field = \"mode\", absolute = 0 }\nthrough = \"mid_pose\"\nspeed = \"speed\"\nacceleration = \"acceleration\"\ntolerance = \"tolerance\"\nunknown_with = [\"circle_count\", \"circle_mode\"]\n",
                "",
            ),
            ("motion/jog", "role = \"stop_axis\"\n", ""),
            ("program/play_program", "effect = \"motion\"\n", "effect = \"motion\"\nrole = \"resume\"\n"),
            ("frames/set_tool_id", "changes = [\"tool\"]\n", ""),
            ("motion/moveL", "deadline_ms = 60000\n", "deadline_ms = 1500\nends_session = true\n"),
            (
                "motion/wait_complete",
                "deprecated = \"watch the status of port 10000 until the robot is in position\"\n",
                "",
            ),
            ("motion/jog", "alias = [\"jog_stop\"]\n", ""),
            ("motion/wait_complete", "Waits until", "Waits as long as it takes until"),
            ("motion/wait_complete", r#"{"cmdName":"wait_complete"}"#, r#"{"cmdName": "wait_complete"}"#),
            ("servo/servo_j", "can only be excuted", "is executed only"),
            ("servo/set_servo_move_filter", r#"requires = ["not_servo_mode"]"#, r#"requires = ["powered", "enabled"]"#),
            ("servo/servo_move", r#"requires = ["powered", "enabled"]"#, ""),
            ("io/get_extio_status", "bare_reply = \"extio_status\"\n", ""),
            ("io/set_digital_output", "request and reply certain;", "all certain;"),
            ("power/shutdown", "reply_certain = false\n", ""),
            ("payload", r#"title = "Payload""#, r#"title = "The payload""#),
            ("types", "Angles are degrees", "Angles are in degrees"),
        ],
        &expect![[r"
            major: command `get_extio_status`: bare reply removed, was `extio_status`
            major: command `movc`: name changed from `move_c` to `move_arc`
            major: command `movc`: motion removed, was `tool centre point on an arc; target end_pose (absolute where mode is 0); through mid_pose; speed speed; acceleration acceleration; tolerance tolerance; on an unknown path with circle_count or circle_mode`
            major: command `moveL`: the session ends with it
            major: command `shutdown`: the reply is certain now, and an error if it is missing
            minor: command `clear_error`: effect changed from `power` to `setting`
            minor: command `end_move`: deadline removed, was `60000 ms`
            minor: command `jog`, variant `0`: role removed, was `stop_axis`
            minor: command `joint_move`: motion changed from `all joints; target joint_position (absolute where mode is 0, an offset where it is 1); speed speed; acceleration acceleration; on an unknown path with tolerance` to `all joints; target joint_position (absolute where mode is 0, an offset where it is 1); speed speed; on an unknown path with tolerance`
            minor: command `moveL`: deadline changed from `60000 ms` to `1500 ms`
            minor: command `play_program`: role added: `resume`
            minor: command `servo_move`: requirement removed, was `powered and enabled`
            minor: command `set_servo_move_filter`: requirement changed from `outside servo mode` to `powered and enabled`
            minor: command `set_tool_id`: change removed, was `the tool frame`
            patch: command `jog`: aliases changed
            patch: command `joint_move`: section changed from `4.7` to `4.107`
            patch: command `joint_move`: `since` added: `1.6`
            patch: command `joint_move`: `until` added: `2`
            patch: command `movc`: errata changed
            patch: command `servo_j`: refusal changed
            patch: command `set_digital_output`: evidence of the reconstruction changed
            patch: command `wait_complete`: no longer deprecated
            patch: command `wait_complete`: doc changed
            patch: command `wait_complete`: examples changed
            patch: topic `payload`: title changed
            patch: topic `types`: doc changed
        "]],
        &expect![[r"
            major: command `movc`: name changed from `move_arc` to `move_c`
        "]],
    );
}

#[test]
fn fields_of_requests() {
    let extra = "\n[[command.request]]\nwire = \"blend\"\ntype = \"float\"\noptional = true\ndoc = \"Blending.\"\n";
    let with_extra = format!("{extra}\n[[command.example]]");
    let last = "[[command.request]]\nwire = \"motType\"\nname = \"action\"\ntype = \"NetworkExceptionAction\"\ndoc = \"Reaction of the arm.\"\n";
    let last_first = format!("{last}\n[[command.request]]");
    check(
        &[
            ("payload/set_payload/mass", r#"type = "float""#, r#"type = "int""#),
            ("payload/set_payload/mass", r#"unit = "kg""#, r#"unit = "g""#),
            ("motion/joint_move/speed", "min = 0", "min = 1\nmax = 180"),
            ("motion/joint_move/accel", r#"name = "acceleration""#, r#"name = "joint_acceleration""#),
            ("motion/joint_move", "= \"acceleration\"\n", "= \"joint_acceleration\"\n"),
            ("motion/joint_move/accel", "= true }]\noptional = true", "= true }]\nsince = \"1.6\""),
            ("motion/joint_move/accel", "The document advises 720 at most. ", ""),
            ("motion/joint_move/accel", "[[command.example]]", &with_extra),
            ("motion/end_move/endPosition", r#"wire = "endPosition""#, r#"wire = "cartPosition""#),
            ("motion/end_move/speed", "max = 265", "max = 300"),
            ("motion/end_move/accel", "advised = [{ max = 720, nonzero = true }]", ""),
            ("program/rapid_rate/rate_value", "min = 0\n", "min = 0\nunit = \"share\"\n"),
            ("motion/moveL/speed", "min = 0", ""),
            ("motion/movc/tol", "min = 0", "min = 0\nmax = 10\nadvisory = true"),
            ("program/load_program", "ascii = true", ""),
            ("program/rapid_rate", "max = 1", "max = 2\nadvisory = true"),
            ("network/set_network_exception_handle", last, ""),
            ("network/set_network_exception_handle", "[[command.request]]", &last_first),
            ("io/set_tio_vout_param/tio_vout_ena", "2.0.4 alone", "2.0.4"),
            ("collision/clear_error", "[[command.example]]", &with_extra),
        ],
        &expect![[r"
            major: command `end_move`, request field `cartPosition`: added
            major: command `end_move`, request field `endPosition`: removed
            major: command `joint_move`, request field `accel`: name changed from `acceleration` to `joint_acceleration`
            major: command `joint_move`, request field `accel`: is no longer optional
            major: command `joint_move`, request field `speed`: range changed from `at least 0` to `1 to 180`
            major: command `movc`, request field `tol`: range changed from `at least 0` to `0 to 10, advisory`
            major: command `set_network_exception_handle`: order of the request fields changed
            major: command `set_payload`, request field `mass`: type changed from `float` to `int`
            major: command `set_payload`, request field `mass`: unit changed from `kg` to `g`
            minor: command `clear_error`, request field `blend`: added
            minor: command `end_move`, request field `accel`: advised range removed, was `-720 to 720, not 0`
            minor: command `end_move`, request field `speed`: advised range changed from `-265 to 265, not 0` to `-300 to 300, not 0`
            minor: command `joint_move`: motion changed from `all joints; target joint_position (absolute where mode is 0, an offset where it is 1); speed speed; acceleration acceleration; on an unknown path with tolerance` to `all joints; target joint_position (absolute where mode is 0, an offset where it is 1); speed speed; acceleration joint_acceleration; on an unknown path with tolerance`
            minor: command `joint_move`, request field `blend`: added
            minor: command `load_program`, request field `programName`: takes any text
            minor: command `moveL`, request field `speed`: range removed, was `at least 0`
            minor: command `rapid_rate`, request field `rate_value`: range changed from `0 to 1` to `0 to 2, advisory`
            patch: command `joint_move`, request field `accel`: doc changed
            patch: command `joint_move`, request field `accel`: `since` added: `1.6`
            patch: command `rapid_rate`, request field `rate_value`: unit added: `share`
            patch: command `set_tio_vout_param`, request field `tio_vout_ena`: disputed readings changed
        "]],
        &expect![[r"
            major: command `clear_error`, request field `blend`: removed
            major: command `end_move`, request field `accel`: advised range added: `-720 to 720, not 0`
            major: command `end_move`, request field `cartPosition`: removed
            major: command `end_move`, request field `endPosition`: added
            major: command `end_move`, request field `speed`: advised range changed from `-300 to 300, not 0` to `-265 to 265, not 0`
            major: command `joint_move`, request field `accel`: name changed from `joint_acceleration` to `acceleration`
            major: command `joint_move`, request field `accel`: becomes optional
            major: command `joint_move`, request field `blend`: removed
            major: command `load_program`, request field `programName`: takes printable ASCII only
            major: command `movc`, request field `tol`: range changed from `0 to 10, advisory` to `at least 0`
            major: command `moveL`, request field `speed`: range added: `at least 0`
            major: command `rapid_rate`, request field `rate_value`: range changed from `0 to 2, advisory` to `0 to 1`
            major: command `set_network_exception_handle`: order of the request fields changed
            major: command `set_payload`, request field `mass`: type changed from `int` to `float`
            major: command `set_payload`, request field `mass`: unit changed from `g` to `kg`
        "]],
    );
}

/// Changes that alter constructors, setters and methods: compared with the compiler by `spec_edits`.
#[test]
fn functions_that_take_fields() {
    let line = "[[command.request]]\nwire = \"line\"\nname = \"relative_to_tool\"\ntype = \"float\"\noptional = true\ndoc = \"A line.\"\n\n[[command.example]]";
    let (mass, centroid) =
        ("wire = \"mass\"\ntype = \"float\"\nunit = \"kg\"\nmin = 0\n", "wire = \"centroid\"\ntype = \"Centroid\"\n");
    check(
        &[
            // Its setter would have the name of a constructor, which then has an underscore.
            ("motion/moveL", "[[command.example]]", line),
            // Neither a text nor an array of numbers converts into it, and the method takes the request.
            ("program/load_program", "type = \"text\"\nascii = true", "type = \"python(text)\""),
            ("program/rapid_rate", "type = \"float\"\nmin = 0\nmax = 1", "type = \"python(float)\"\nmin = 0\nmax = 1"),
            ("kinematics/kine_forward", "type = \"JointPosition\"", "type = \"python(JointPosition)\""),
            // Constructors take the mass first; the optional fields have setters, whatever their order.
            ("payload/set_payload", mass, "wire = \"swap\"\n"),
            ("payload/set_payload", centroid, mass),
            ("payload/set_payload", "wire = \"swap\"\n", centroid),
        ],
        &expect![[r"
            major: command `kine_forward`: the method takes the request
            major: command `kine_forward`, request field `jointPosition`: functions take nothing that converts into it
            major: command `load_program`: the method takes the request
            major: command `load_program`, request field `programName`: functions take nothing that converts into it
            major: command `moveL`, request field `line`: its setter takes the name of the constructor `relative_to_tool`
            major: command `rapid_rate`: the method takes the request
            major: command `set_payload`: order of the request fields changed
            minor: command `kine_forward`, request field `jointPosition`: form on the wire changed from `JointPosition` to `python(JointPosition)`
            minor: command `load_program`, request field `programName`: form on the wire changed from `text` to `python(text)`
            minor: command `load_program`, request field `programName`: takes any text
            minor: command `moveL`, request field `line`: added
            minor: command `rapid_rate`, request field `rate_value`: form on the wire changed from `float` to `python(float)`
            patch: command `set_payload`, request field `centroid`: doc changed
            patch: command `set_payload`, request field `mass`: doc changed
        "]],
        &expect![[r"
            major: command `kine_forward`: the method takes the field
            major: command `kine_forward`, request field `jointPosition`: constructors are no longer `const`
            major: command `load_program`: the method takes the field
            major: command `load_program`, request field `programName`: takes printable ASCII only
            major: command `load_program`, request field `programName`: constructors are no longer `const`
            major: command `moveL`, request field `line`: removed
            major: command `rapid_rate`: the method takes the field
            major: command `set_payload`: order of the request fields changed
        "]],
    );
}

#[test]
fn fields_of_replies() {
    let extra = "\n[[command.reply]]\nwire = \"note\"\ntype = \"text\"\noptional = true\ndoc = \"A note.\"\n";
    let number = extra.replace("\"text\"", "\"int\"");
    let with = |field: &str| format!("{field}\n[[command.example]]");
    check(
        &[
            // Replies have no constructors.
            (
                "program/get_program_state/programState",
                "type = \"ProgramState\"",
                "type = \"ProgramState\"\nconstructors = true",
            ),
            // All keys of both are optional; but with a text the first is no longer `Copy`.
            ("power/power_on", "[[command.example]]", &with(extra)),
            ("power/enable_robot", "[[command.example]]", &with(&number)),
            ("power/disable_robot", "[[command.example]]", &with(&number)),
            ("power/get_version", "[[command.example]]", &with(&number)),
            ("power/get_robot_state/enable", r#"written = ["robot_disabled", "robot_enabled"]"#, "written = [0, 1]"),
            ("power/get_version/robot_id", "or_raw = true\n", ""),
            ("kinematics/get_joint_pos", r#"type = "JointPosition""#, "type = \"float[6]\"\nmin = -360\nmax = 360"),
        ],
        &expect![[r#"
            major: command `disable_robot`, reply field `note`: added
            major: command `get_joint_pos`, reply field `joint_pos`: type changed from `JointPosition` to `float[6]`
            major: command `get_version`, reply field `robot_id`: can no longer have another shape
            major: command `power_on`, reply: is no longer `Copy`
            minor: command `enable_robot`, reply field `note`: added
            minor: command `get_robot_state`, reply field `enable`: form on the wire changed from `bool written ["robot_disabled", "robot_enabled"]` to `bool written [0, 1]`
            minor: command `get_version`, reply field `note`: added
            minor: command `power_on`, reply field `note`: added
            patch: command `get_joint_pos`, reply field `joint_pos`: range added: `-360 to 360`
            patch: command `get_program_state`, reply field `programState`: gets a constructor for each value
        "#]],
        &expect![[r"
            major: command `disable_robot`, reply field `note`: removed
            major: command `enable_robot`, reply field `note`: removed
            major: command `get_joint_pos`, reply field `joint_pos`: type changed from `float[6]` to `JointPosition`
            major: command `get_version`, reply field `note`: removed
            major: command `get_version`, reply field `robot_id`: may have another shape, kept as raw JSON
            major: command `power_on`, reply field `note`: removed
        "]],
    );
}

#[test]
fn types_and_their_parts() {
    let field = "[[type.field]]\nwire = \"speed_limit\"\ntype = \"float\"\noptional = true\ndoc = \"A limit.\"\n\n";
    let with_field = format!("{field}[[type.field]]");
    let element = "[[type.field]]\nname = \"frame\"\ntype = \"int\"\noptional = true\ndoc = \"A frame.\"\n\n[[type]]\n";
    check(
        &[
            ("types/JointPosition", "type = \"float[6]\"\nunit = \"deg\"", "type = \"float[7]\"\nunit = \"rad\""),
            ("types/Pose", "exact = true\n", ""),
            ("types/Pose/rz", "[[type]]\n", element),
            ("types/Pose", r#"name = "x""#, r#"name = "swap""#),
            ("types/Pose", r#"name = "y""#, r#"name = "x""#),
            ("types/Pose", r#"name = "swap""#, r#"name = "y""#),
            ("network", r#"type = "NetworkExceptionAction""#, r#"type = "NetworkAction""#),
            ("network", r#"name = "NetworkExceptionAction""#, r#"name = "NetworkAction""#),
            ("status/RobotStatus", "[[type.field]]", &with_field),
            ("status/RobotStatus/inpos", "It stays true", "It remains true"),
            ("types/Switch/0", "wire = 0", r#"wire = "off""#),
            ("types/Switch/1", "wire = 1", r#"wire = "on""#),
        ],
        &expect![[r"
            major: command `enable_admittance_ctrl`, request: is no longer `Copy`
            major: command `servo_move`, request: is no longer `Copy`
            major: command `set_admit_ctrl_config`, request: is no longer `Copy`
            major: command `set_compliant_type`, request: is no longer `Copy`
            major: command `set_digital_output`, request: is no longer `Copy`
            major: command `set_network_exception_handle`, request field `motType`: type changed from `NetworkExceptionAction` to `NetworkAction`
            major: command `torque_control_enable`, request: is no longer `Copy`
            major: type `JointPosition`: type changed from `float[6]` to `float[7]`
            major: type `JointPosition`: unit changed from `deg` to `rad`
            major: type `NetworkExceptionAction`: removed
            major: type `Pose`: order of the fields changed
            major: type `Pose`, field `frame`: added
            major: type `Switch`: kind changed from `enum of integers` to `enum of strings`
            minor: type `NetworkAction`: added
            minor: type `Pose`: an array may have further elements
            minor: type `RobotStatus`, field `speed_limit`: added
            patch: type `Pose`, field `x`: doc changed
            patch: type `Pose`, field `y`: doc changed
            patch: type `RobotStatus`, field `inpos`: doc changed
        "]],
        &expect![[r"
            major: command `set_network_exception_handle`, request field `motType`: type changed from `NetworkAction` to `NetworkExceptionAction`
            major: type `JointPosition`: type changed from `float[7]` to `float[6]`
            major: type `JointPosition`: unit changed from `rad` to `deg`
            major: type `NetworkAction`: removed
            major: type `Pose`: an array with further elements becomes an error
            major: type `Pose`: order of the fields changed
            major: type `Pose`, field `frame`: removed
            major: type `RobotStatus`, field `speed_limit`: removed
            major: type `Switch`: kind changed from `enum of strings` to `enum of integers`
        "]],
    );
}

#[test]
fn values_variants_and_error_codes() {
    check(
        &[
            ("motion/jog", r#"tag = "jog_mode""#, r#"tag = "mode""#),
            ("motion/jog/3", "wire = 3", "wire = 4"),
            ("motion/jog/2", r#"name = "Increment""#, r#"name = "Offset""#),
            ("motion/jog/1/jnum", "max = 5", "max = 6"),
            ("motion/jog/0", "Stops the jog", "Ends the jog"),
            ("io/DigitalOutputKind/6", "wire = 6", "wire = 7"),
            ("io/DigitalOutputKind/5", r#"name = "Profinet""#, r#"name = "ProfinetDevice""#),
            ("io/DigitalOutputKind/5", "advisory = true\n", ""),
            ("io/DigitalOutputKind/2", "[[type.value]]", "advisory = true\n\n[[type.value]]"),
            ("io/DigitalOutputKind/0", "In the control cabinet.", "In the cabinet."),
            ("io/ExtioSetup/0", "wire = 0", "wire = 2"),
            (
                "io/ExtioSetup/Tcp/pins",
                "[[type]]",
                "[[type.variant.field]]\nname = \"note\"\ntype = \"text\"\noptional = true\ndoc = \"A note.\"\n\n[[type]]",
            ),
            ("program/ProgramState/idle", r#"wire = "idle""#, r#"wire = "waiting""#),
            ("errors/3", "wire = 3", "wire = 4"),
            ("errors/2", r#"name = "CallFailed""#, r#"name = "Failed""#),
            ("errors/2", "The command failed;", "The call failed;"),
            ("errors/1", "Exception:function call failed", "exception"),
        ],
        &expect![[r"
            major: command `jog`, variant `2`: name changed from `Increment` to `Offset`
            major: command `jog`, variant `3`: removed
            major: error code `2`: name changed from `CallFailed` to `Failed`
            major: error code `3`: removed
            major: type `DigitalOutputKind`, value `2`: only newer firmware takes it
            major: type `DigitalOutputKind`, value `5`: name changed from `Profinet` to `ProfinetDevice`
            major: type `DigitalOutputKind`, value `6`: removed
            major: type `ExtioSetup`, variant `0`: removed
            major: type `ProgramState`, value `idle`: removed
            minor: command `jog`: key of the tag changed from `jog_mode` to `mode`
            minor: command `jog`, variant `1`, field `jnum`: range changed from `0 to 5` to `0 to 6`
            minor: command `jog`, variant `4`: added
            minor: error code `4`: added
            minor: type `DigitalOutputKind`, value `5`: every firmware takes it
            minor: type `DigitalOutputKind`, value `7`: added
            minor: type `ExtioSetup`, variant `1`, field `note`: added
            minor: type `ExtioSetup`, variant `2`: added
            minor: type `ProgramState`, value `waiting`: added
            patch: command `jog`, variant `0`: doc changed
            patch: error code `1`: message changed
            patch: error code `2`: doc changed
            patch: type `DigitalOutputKind`, value `0`: doc changed
        "]],
        &expect![[r"
            major: command `jog`, variant `1`, field `jnum`: range changed from `0 to 6` to `0 to 5`
            major: command `jog`, variant `2`: name changed from `Offset` to `Increment`
            major: command `jog`, variant `4`: removed
            major: error code `2`: name changed from `Failed` to `CallFailed`
            major: error code `4`: removed
            major: type `DigitalOutputKind`, value `5`: name changed from `ProfinetDevice` to `Profinet`
            major: type `DigitalOutputKind`, value `5`: only newer firmware takes it
            major: type `DigitalOutputKind`, value `7`: removed
            major: type `ExtioSetup`, variant `1`, field `note`: removed
            major: type `ExtioSetup`, variant `2`: removed
            major: type `ProgramState`, value `waiting`: removed
        "]],
    );
}

#[test]
fn events_of_the_controller() {
    check(
        &[
            ("events", r#"["0x10F0050", "0x10F0057-0x10F0058"]"#, r#"["0x10F0050"]"#),
            ("events", "error\"\ncodes = [\"0x0F0034\"]", "warning\"\ncodes = [\"0x0F0034\"]"),
            ("events", "the robot is disabled", "the robot is off"),
            ("events", r#""0x0F2030-0x0F2032""#, r#""0x0F2032", "0xFE2044-0xFE2046""#),
            ("events", "look for obstacles around the arm", "look around the arm"),
            ("events", "检查机械臂周围有无", "检查周围有无"),
            ("events", "warning\"\ncodes = [\"0x303184\"]", "error\"\ncodes = [\"0x303184\"]"),
            ("events", "a safety signal prevents powering on", "no power"),
        ],
        &expect![[r"
            minor: event `0x0F0034`: severity changed from `error` to `warning`
            minor: event `0x0F2030-0x0F2031`: removed
            minor: event `0x10F0057-0x10F0058`: removed
            minor: event `0x303184`: severity changed from `warning` to `error`
            minor: event `0xFE2044-0xFE2046`: added
            patch: event `0x0F0034`: remedy changed
            patch: event `0x0F0034`: Chinese texts changed
            patch: event `0x10F0005`: meaning changed
            patch: event `0x303184`: meaning changed
        "]],
        &expect![""],
    );
}

#[test]
fn a_type_that_moves_takes_its_path_along() {
    let old = "[[type]]\nname = \"JogFrame\"\nkind = \"enum\"\ndoc = \"Frame of a jog, or its joints.\"\n";
    let values = "\n[[type.value]]\nwire = 0\nname = \"World\"\ndoc = \"The axes of the robot's base, or of the selected user frame (vendor's texts). The document calls it the world frame.\"\n\n[[type.value]]\nwire = 1\nname = \"Joint\"\ndoc = \"A joint.\"\n\n[[type.value]]\nwire = 2\nname = \"Tool\"\ndoc = \"The axes of the tool frame.\"\n";
    let whole = format!("{old}{values}");
    let moved = format!("{whole}\n[[type]]\nname = \"Switch\"");
    check(
        &[("motion", &whole, ""), ("types", "[[type]]\nname = \"Switch\"", &moved)],
        &expect![[r"
            major: type `JogFrame`: topic changed from `motion` to `types`
        "]],
        &expect![[r"
            major: type `JogFrame`: topic changed from `types` to `motion`
        "]],
    );
}

#[test]
fn requests_and_types_of_another_shape() {
    let fields = "[[command.request]]\nwire = \"rate_value\"\nname = \"rate\"\n";
    let choice = "[command.choice]\ntag = \"kind\"\n\n[[command.choice.variant]]\nwire = 0\nname = \"Rate\"\ndoc = \"A rate.\"\n\n[[command.choice.variant.field]]\nwire = \"rate_value\"\nname = \"rate\"\n";
    let text = "[[type.field]]\nname = \"label\"\ntype = \"text\"\ndoc = \"A label.\"\n\n[[type]]";
    check(
        &[
            ("program/rapid_rate", fields, choice),
            ("motion/wait_complete", "deprecated = \"watch the status", "deprecated = \"look at the status"),
            ("io/get_extio_status", "python(ExtioStatus)", "ExtioStatus"),
            ("io/FunctionInput/index", "[[type]]", text),
        ],
        &expect![[r"
            major: command `rapid_rate`: the request becomes a choice
            major: type `FunctionInput`: is no longer `Copy`
            minor: command `get_extio_status`, reply field `extio_status`: form on the wire changed from `python(ExtioStatus)` to `ExtioStatus`
            minor: type `FunctionInput`, field `label`: added
            patch: command `wait_complete`: note of the deprecation changed
        "]],
        &expect![[r"
            major: command `rapid_rate`: the request is no longer a choice
            major: type `FunctionInput`, field `label`: removed
        "]],
    );
}

#[test]
fn sources_of_what_a_robot_needs() {
    let text = "title = 'T'\n[robot_status]\nerror_code = 'absent'\npaused = 'program'\npowered_on = 'enabled'\n";
    let pack = load_pack(&spec(), Source { path: "newer.toml", text });
    let pack = pack.unwrap_or_else(|errors| panic!("{errors}"));
    expect![[r"
        major: type `RobotStatus`, field `paused`: source for a robot changed from `paused` to `program`
        minor: type `RobotStatus`, field `error_code`: source for a robot changed from `error_code` to `absent`
        minor: type `RobotStatus`, field `powered_on`: source for a robot changed from `powered_on` to `enabled`
    "]]
    .assert_eq(&lines(&diff(&spec(), &pack.spec)));
}
