//! Compares the impact that `diff` states of forty edits of the spec with the compiler: a program that uses the
//! interface stops compiling where a change is major, and nowhere else. Many edits compile jaka-sync again, so that
//! `.ci/nightly` runs this alone.

use std::fs;

use jaka_spec::tools::{Impact, diff, impact};
use jaka_spec::{Source, load};
use jaka_tests::spec;

use crate::diff::{Edit, command_text, edited_files};
use crate::user_crate::UserCrate;
use crate::user_crate::grown::{copied, program};

/// Moment at which a program notices the change.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Noticed {
    /// It does not compile: the change is major.
    Compiling,
    /// It compiles and acts otherwise: the change is major.
    Running,
    /// It does not: the change is minor, or a patch.
    Never,
}
use Noticed::{Compiling, Never, Running};

/// Part of the program that uses replies, types and traits; the rest makes and sends each request.
const READS: &str = r"
use jaka_sync::{io, motion, network, power, program, proto};

fn copy<T: Copy>() {}
fn runs<T: proto::Motion>() {}

/// Uses replies, types and traits.
pub fn reads(client: &mut Client) -> Result<(), Error> {
    runs::<motion::MoveC>();
    copy::<power::PowerOnReply>();
    copy::<motion::JointMove>();
    let (): () = client.disable_robot()?;
    let id: Option<proto::wire::Typed<String>> = client.get_version()?.robot_id;
    let state: io::ExtioState = client.get_extio_status()?.extio_status.state;
    let action = network::NetworkExceptionAction::Keep;
    let wire: i64 = action.into();
    match client.get_program_state()?.program_state {
        program::ProgramState::Idle => drop((id, state, wire)),
        _ => {}
    }
    match io::DigitalOutputKind::from(6) {
        io::DigitalOutputKind::EthernetIp | io::DigitalOutputKind::Other(_) => {}
        _ => {}
    }
    Ok(())
}
";

const NOTE: &str = "\n[[command.reply]]\nwire = \"note\"\ntype = \"TYPE\"\noptional = true\ndoc = \"A note.\"\n";
const BLEND: &str = "\n[[command.request]]\nwire = \"blend\"\ntype = \"float\"\noptional = true\ndoc = \"Blending.\"\n\n[[command.example]]";
const QUIT: &str = "[[command]]\nwire = \"quit\"";
const ADDED: &str =
    "[[command]]\nwire = \"demo\"\neffect = \"query\"\ndoc = \"Is new.\"\n\n[[command]]\nwire = \"quit\"";
const VALUE: &str = "[[type.value]]\nwire = 0";
const MORE: &str = "[[type.value]]\nwire = 9\nname = \"Own\"\ndoc = \"New.\"\n\n[[type.value]]\nwire = 0";
const MOTION: &str = "[command.motion]\npath = \"arc\"\ntarget = \"end_pose\"\nmode = { field = \"mode\", absolute = 0 }\nthrough = \"mid_pose\"\nspeed = \"speed\"\nacceleration = \"acceleration\"\ntolerance = \"tolerance\"\nunknown_with = [\"circle_count\", \"circle_mode\"]\n";
const ACTION: &str = "[[command.request]]\nwire = \"motType\"\nname = \"action\"\ntype = \"NetworkExceptionAction\"\ndoc = \"Reaction of the arm.\"\n";
const FIELD: &str =
    "[[type.field]]\nwire = \"speed_limit\"\ntype = \"float\"\noptional = true\ndoc = \"A limit.\"\n\n[[type.field]]";

#[test]
#[ignore = "a step of .ci/nightly"]
fn what_is_major_is_noticed_by_programs() {
    let (move_c, quit) = (command_text("motion", "movc"), command_text("session", "quit"));
    let (with_move_c, action_first) = (format!("{move_c}\n[[type]]"), format!("{ACTION}\n[[command.request]]"));
    let note = |ty: &str| format!("{}\n[[command.example]]", NOTE.replace("TYPE", ty));
    let (text, int) = (note("text"), note("int"));
    let edits: [(Noticed, &[Edit<'_>]); 40] = [
        (Compiling, &[("session", quit, "")]),
        (Never, &[("session", QUIT, ADDED)]),
        (Compiling, &[("motion", move_c, ""), ("network", "[[type]]", &with_move_c)]),
        (Compiling, &[("motion/movc", r#"name = "move_c""#, r#"name = "move_arc""#)]),
        (Compiling, &[("motion/movc", MOTION, "")]),
        (Running, &[("motion/moveL", "deadline_ms = 60000\n", "ends_session = true\n")]),
        (Running, &[("power/shutdown", "reply_certain = false\n", "")]),
        (Running, &[("io/get_extio_status", "bare_reply = \"extio_status\"\n", "")]),
        (Never, &[("collision/clear_error", r#"effect = "power""#, r#"effect = "setting""#)]),
        (Never, &[("motion/end_move", "deadline_ms = 60000\n", "")]),
        (Never, &[("motion/joint_move", "acceleration = \"acceleration\"\n", "")]),
        (Never, &[("motion/jog", "role = \"stop_axis\"\n", "")]),
        (Never, &[("frames/set_tool_id", "changes = [\"tool\"]\n", "")]),
        (Never, &[("motion/wait_complete", "Waits until", "Waits as long as it takes until")]),
        (Never, &[("motion/joint_move", r#"section = "4.7""#, "section = \"4.7\"\nsince = \"1.6\"")]),
        (Compiling, &[("payload/set_payload/mass", r#"type = "float""#, r#"type = "int""#)]),
        (Compiling, &[("payload/set_payload/mass", r#"type = "float""#, "type = \"float\"\noptional = true")]),
        (Running, &[("payload/set_payload/mass", r#"unit = "kg""#, r#"unit = "g""#)]),
        (Running, &[("motion/joint_move/speed", "min = 0", "min = 1\nmax = 180")]),
        (Compiling, &[("motion/joint_move/accel", "= true }]\noptional = true", "= true }]")]),
        (Never, &[("motion/joint_move/accel", "[[command.example]]", BLEND)]),
        (Running, &[("motion/end_move/endPosition", r#"wire = "endPosition""#, r#"wire = "cartPosition""#)]),
        (Never, &[("motion/end_move/speed", "max = 265", "max = 300")]),
        (Never, &[("program/rapid_rate/rate_value", "min = 0\n", "min = 0\nunit = \"share\"\n")]),
        (Never, &[("program/load_program", "ascii = true", "")]),
        (Compiling, &[("program/load_program", "type = \"text\"\nascii = true", "type = \"python(text)\"")]),
        (
            Compiling,
            &[
                ("network/set_network_exception_handle", ACTION, ""),
                ("network/set_network_exception_handle", "[[command.request]]", &action_first),
            ],
        ),
        (Compiling, &[("power/power_on", "[[command.example]]", &text)]),
        (Never, &[("power/enable_robot", "[[command.example]]", &int)]),
        (Compiling, &[("power/disable_robot", "[[command.example]]", &int)]),
        (
            Never,
            &[("power/get_robot_state/enable", r#"written = ["robot_disabled", "robot_enabled"]"#, "written = [0, 1]")],
        ),
        (Compiling, &[("power/get_version/robot_id", "or_raw = true\n", "")]),
        (
            Compiling,
            &[
                ("network", r#"type = "NetworkExceptionAction""#, r#"type = "NetworkAction""#),
                ("network", r#"name = "NetworkExceptionAction""#, r#"name = "NetworkAction""#),
            ],
        ),
        (Compiling, &[("io/DigitalOutputKind", r#"name = "EthernetIp""#, r#"name = "EtherCat""#)]),
        (Running, &[("io/DigitalOutputKind", "wire = 6", "wire = 7")]),
        (Never, &[("io/DigitalOutputKind", VALUE, MORE)]),
        (Compiling, &[("io/ExtioStatus/state", r#"name = "state""#, r#"name = "running""#)]),
        (Compiling, &[("motion/jog", r#"name = "Increment""#, r#"name = "Step""#)]),
        (Never, &[("types/Pose", "exact = true\n", "")]),
        (Never, &[("status/RobotStatus", "[[type.field]]", FIELD)]),
    ];
    let load = |files: &[(&str, String)]| {
        let sources: Vec<_> = files.iter().map(|(path, text)| Source { path, text }).collect();
        load(&sources).unwrap_or_else(|errors| panic!("{errors}"))
    };
    for (noticed, edit) in edits {
        let changes = diff(&spec(), &load(&edited_files(edit)));
        assert_eq!(impact(&changes) == Some(Impact::Major), noticed != Never, "{noticed:?}: {changes:#?}");
    }
    let folder = copied("spec_edits");
    let user = UserCrate::new("of_edited_spec", "2024", &(program(&spec()) + READS)).with_workspace(&folder);
    let check = |edits: &[Edit<'_>]| {
        for (path, text) in edited_files(edits) {
            // Cargo goes by the times of files.
            if fs::read_to_string(folder.join(path)).expect("the file is there") != text {
                fs::write(folder.join(path), text).expect("the file can be written");
            }
        }
        String::from_utf8(user.check()).expect("the compiler speaks UTF-8")
    };
    // What lets the program compile does so together.
    let others: Vec<_> =
        edits.iter().filter(|(noticed, _)| *noticed != Compiling).flat_map(|(_, edit)| *edit).collect();
    assert_eq!(check(&[]), "", "the program of the spec as it is");
    assert_eq!(check(&others.into_iter().copied().collect::<Vec<_>>()), "");
    for (_, edit) in edits.iter().filter(|(noticed, _)| *noticed == Compiling) {
        let said = check(edit);
        println!("{edit:?}: {}", said.lines().next().unwrap_or_default());
        assert!(!said.is_empty(), "every program compiles, in spite of {edit:?}");
        assert!(said.contains("`of_edited_spec`"), "code by hand has to follow {edit:?}: {said}");
    }
}
