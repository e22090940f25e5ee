//! A user's crate with a pack: what the compiler says about it.

pub(crate) mod grown;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;

use expect_test::{Expect, expect};

/// The library of jaka-robot in the folder of this program: the newest that is not newer than the program. Others may
/// lie there, with other
/// features or of older code, but that one has the code with which the program was built.
static JAKA_ROBOT: LazyLock<PathBuf> = LazyLock::new(|| {
    let built = |path: &Path| fs::metadata(path).and_then(|file| file.modified()).expect("the time of a file is known");
    let program = std::env::current_exe().expect("the program has a path");
    let entries = fs::read_dir(program.parent().expect("it is in a folder")).expect("the folder can be read");
    let paths = entries.filter_map(|entry| Some(entry.ok()?.path()));
    let is_library = |path: &PathBuf| {
        let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        name.starts_with("libjaka_robot-") && path.extension().is_some_and(|extension| extension == "rlib")
    };
    let older = paths.filter(is_library).filter(|path| built(path) <= built(&program));
    older.max_by_key(|path| built(path)).expect("cargo has built jaka-robot beside its tests")
});

/// A crate in a folder of its own that depends on jaka-robot alone.
pub(crate) struct UserCrate {
    folder: PathBuf,
    edition: &'static str,
}

impl UserCrate {
    /// Each crate has a name of its own, by which its folder is known.
    pub(crate) fn new(name: &str, edition: &'static str, code: &str) -> Self {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("user").join(name);
        if folder.exists() {
            fs::remove_dir_all(&folder).expect("the crate of an earlier run can be removed");
        }
        let this = Self { folder, edition };
        this.write("src/lib.rs", code);
        this
    }

    fn write(&self, path: &str, text: &str) {
        let path = self.folder.join(path);
        fs::create_dir_all(path.parent().expect("a file is in a folder")).expect("the folder can be made");
        fs::write(path, text).expect("the file can be written");
    }

    fn expect(&self, expected: &Expect) {
        self.compare(self.compile(), expected);
    }

    /// Compiles the crate against the library that this program was built with; what the compiler says. `cargo check`
    /// would compile the library once more.
    fn compile(&self) -> Vec<u8> {
        let dependencies = JAKA_ROBOT.parent().expect("a file is in a folder");
        let output = Command::new(Path::new(env!("CARGO")).with_file_name("rustc"))
            .args(["src/lib.rs", "--crate-type=lib", "--emit=metadata", "--color=never", "--edition", self.edition])
            .args(["--extern".to_owned(), format!("jaka_robot={}", JAKA_ROBOT.display())])
            .args(["-L".to_owned(), format!("dependency={}", dependencies.display())])
            .env("CARGO_MANIFEST_DIR", &self.folder)
            .current_dir(&self.folder)
            .output()
            .expect("the compiler runs");
        output.stderr
    }

    /// Compares what the compiler or cargo says, without the paths of this machine.
    fn compare(&self, said: Vec<u8>, expected: &Expect) {
        let text = String::from_utf8(said).expect("the compiler speaks UTF-8");
        expected.assert_eq(&text.replace(&self.folder.display().to_string(), "FOLDER"));
    }
}

/// A crate that takes no warning, with a pack of all that is legal and strange.
#[test]
fn a_strange_pack_compiles_without_a_warning() {
    let code = r#"
#![forbid(unsafe_code)]
#![deny(warnings, missing_docs, missing_debug_implementations, unreachable_pub, unused, rust_2018_idioms)]
//! A user's crate.

jaka_robot::pack!("strange.toml");

use strange::StrangeCommands as _;

/// Methods of the pack together with those of the client and of the robot.
pub fn calls(client: &mut jaka_robot::Client, robot: &mut jaka_robot::Robot) -> Result<(), jaka_robot::Error> {
    client.item()?;
    client.choose(&strange::Choose::Other)?;
    client.power_on()?;
    client.power_on_strange()?;
    robot.load_program_strange(1)?;
    Ok(robot.set_rapid_rate_strange(strange::Level::Ok)?)
}

/// A function that names nothing but what the prelude has.
pub fn prelude(texts: Vec<Option<bool>>) -> Result<String, Box<dyn std::error::Error>> {
    Ok(format!("{texts:?} {:?}", strange::Floats::from([1.0, 2.0])))
}
"#;
    for edition in ["2021", "2024"] {
        let user = UserCrate::new(&format!("strange_{edition}"), edition, code);
        user.write("strange.toml", include_str!("../../pack-user/strange.toml"));
        user.expect(&expect![""]);
    }
}

const PACK: &str = r#"
title = "Test"

[[command]]
wire = "demo_motion_state"
effect = "query"
doc = "Reads how the motion stands."
"#;

/// Entries that the built-in spec has.
const COVERED: &str = r#"
title = "Test"

[[command]]
wire = "get_loaded_program"
name = "loaded_program"
effect = "query"
doc = "Reads the program."

[[command.reply]]
wire = "programName"
name = "program_name"
type = "text"
doc = "Its name."

[[override]]
target = "rapid_rate"
request = "rate_value"
max = 1

[[error]]
wire = 2
name = "Overload"
doc = "Too heavy."
"#;

/// A program that was written when it had not.
const USE: &str = r#"#![deny(warnings)]
jaka_robot::pack!("newer.toml");

use newer::NewerCommands as _;

pub fn run(robot: &mut jaka_robot::Robot) -> Result<newer::LoadedProgramReply, jaka_robot::Error> {
    robot.set_rapid_rate_newer(0.5)?;
    robot.client().call(&newer::SetRapidRate::new(0.5))?;
    assert_eq!(newer::meaning(newer::OVERLOAD), Some("Too heavy."));
    Ok(robot.loaded_program()?)
}
"#;

#[test]
fn errors_stand_at_the_macro() {
    let code = "jaka_robot::pack!(\"newer.toml\");\n";
    let user = UserCrate::new("pack", "2024", code);
    user.expect(&expect![[r#"
        error: cannot read the pack `FOLDER/newer.toml`: No such file or directory (os error 2); the path is relative to the folder of the crate's Cargo.toml
         --> src/lib.rs:1:19
          |
        1 | jaka_robot::pack!("newer.toml");
          |                   ^^^^^^^^^^^^

        error: aborting due to 1 previous error

    "#]]);

    user.write("newer.toml", PACK);
    user.expect(&expect![[""]]);

    user.write("newer.toml", &PACK.replace("query", "fly").replace("doc", "docs"));
    user.expect(&expect![[r#"
        error: newer.toml:4:1: command `demo_motion_state`: `doc` is missing
         --> src/lib.rs:1:19
          |
        1 | jaka_robot::pack!("newer.toml");
          |                   ^^^^^^^^^^^^

        error: newer.toml:6:10: command `demo_motion_state`: `effect` is one of query, setting, motion, power, session, not `fly`
         --> src/lib.rs:1:19
          |
        1 | jaka_robot::pack!("newer.toml");
          |                   ^^^^^^^^^^^^

        error: newer.toml:7:1: command `demo_motion_state`: unknown key `docs`; is it `doc`?
         --> src/lib.rs:1:19
          |
        1 | jaka_robot::pack!("newer.toml");
          |                   ^^^^^^^^^^^^

        error: aborting due to 3 previous errors

    "#]]);

    // What the spec has by now is silent, and keeps its names.
    user.write("newer.toml", COVERED);
    user.write("src/lib.rs", USE);
    user.expect(&expect![[""]]);

    user.write("src/lib.rs", "jaka_robot::pack!(\"newer.toml\" over \"newer.toml\");\n");
    user.expect(&expect![[r#"
        error: expected `on` and the packs on which this one stands
         --> src/lib.rs:1:32
          |
        1 | jaka_robot::pack!("newer.toml" over "newer.toml");
          |                                ^^^^

        error: aborting due to 1 previous error

    "#]]);
    user.write("src/lib.rs", "jaka_robot::pack!(\"newer.toml\" on \"older.toml\");\n");
    user.expect(&expect![[r#"
        error: cannot read the pack `FOLDER/older.toml`: No such file or directory (os error 2); the path is relative to the folder of the crate's Cargo.toml
         --> src/lib.rs:1:35
          |
        1 | jaka_robot::pack!("newer.toml" on "older.toml");
          |                                   ^^^^^^^^^^^^

        error: aborting due to 1 previous error

    "#]]);

    user.write("src/lib.rs", "jaka_robot::pack!(newer);\n");
    user.expect(&expect![[r"
        error: expected string literal
         --> src/lib.rs:1:19
          |
        1 | jaka_robot::pack!(newer);
          |                   ^^^^^

        error: aborting due to 1 previous error

    "]]);
}

#[test]
fn a_choice_of_status_fields_compiles_without_a_warning() {
    let code = r"
#![forbid(unsafe_code)]
#![deny(warnings, missing_docs, missing_debug_implementations, unreachable_pub, unused, rust_2018_idioms)]
//! A user's crate.

jaka_robot::status_subset! {
    /// Where the arm is.
    #[non_exhaustive]
    pub struct Joints { joint_actual_position, in_position }
}

/// Reads them.
pub fn joints(status: &mut jaka_robot::StatusStream) -> Result<Option<jaka_robot::types::JointPosition>, jaka_robot::Error> {
    jaka_robot::status_subset! {
        struct Own { extio, digital_inputs, tool_rs_signals, task_state, }
    }
    let own: Own = status.newest_packet_as()?;
    drop((own.extio, own.digital_inputs, own.tool_rs_signals, own.task_state));
    let joints: Joints = status.newest_packet_as()?;
    Ok(joints.joint_actual_position.filter(|_| joints.in_position == Some(true)))
}
";
    UserCrate::new("subset", "2021", code).expect(&expect![""]);
}

#[test]
fn a_field_that_the_status_packet_does_not_have_is_an_error_at_its_name() {
    let code = |field| format!("jaka_robot::status_subset! {{ pub struct Joints {{ in_position, {field} }} }}\n");
    let user = UserCrate::new("no_subset", "2024", &code("joint_actual_positions"));
    user.expect(&expect![[r"
        error: the status packet has no field `joint_actual_positions`; is it `joint_actual_position`?
         --> src/lib.rs:1:63
          |
        1 | jaka_robot::status_subset! { pub struct Joints { in_position, joint_actual_positions } }
          |                                                               ^^^^^^^^^^^^^^^^^^^^^^

        error: aborting due to 1 previous error

    "]]);
    user.write("src/lib.rs", &code("inpos"));
    user.expect(&expect![[r"
        error: `inpos` on the wire is `in_position` here
         --> src/lib.rs:1:63
          |
        1 | jaka_robot::status_subset! { pub struct Joints { in_position, inpos } }
          |                                                               ^^^^^

        error: aborting due to 1 previous error

    "]]);
    user.write("src/lib.rs", &code("in_position"));
    user.expect(&expect![[r"
        error: `in_position` stands here twice
         --> src/lib.rs:1:63
          |
        1 | jaka_robot::status_subset! { pub struct Joints { in_position, in_position } }
          |                                                               ^^^^^^^^^^^

        error: aborting due to 1 previous error

    "]]);
}

/// A command in place of a motion.
#[test]
fn what_is_no_motion_is_told_with_a_way_to_send_it() {
    let code = r"
pub fn guess(robot: &mut jaka_robot::Robot) {
    let _ = robot.run(&jaka_robot::power::PowerOn::new(), std::time::Duration::ZERO);
}
";
    let said = String::from_utf8(UserCrate::new("guess", "2024", code).compile()).expect("the compiler speaks UTF-8");
    for part in [
        "error[E0277]: `jaka_robot::power::PowerOn` is not a motion whose end a robot waits for",
        "note: any other command goes out by `Robot::client`: `robot.client().call(&request)`",
        "note: a command of a pack is a motion by a table `[command.motion]` in the pack",
    ] {
        assert!(said.contains(part), "{said}");
    }
}
