//! A user's crate as cargo builds it: an edit of its pack is noticed, and a program that makes every request by its
//! constructor compiles against a spec in which ten commands have an optional field more. They compile jaka-sync again,
//! so that `.ci/nightly` runs them alone.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process;

use expect_test::{Expect, expect};
use jaka_spec::tools::{Impact, diff, impact};
use jaka_spec::{Command, Field, Request, Scalar, Source, Spec, Type, TypeId, TypeKind, to_snake};

use super::{PACK, UserCrate};
use crate::architecture::{root, with_dependencies};

/// Commands of each shape: bare, with one required field, with several, with optional ones, and with variants.
const TEN: [&str; 10] = [
    "get_version",
    "power_on",
    "rapid_rate",
    "load_program",
    "set_clsn_sensitivity",
    "joint_move",
    "moveL",
    "set_digital_output",
    "set_vel_compliant_ctrl",
    "jog",
];

/// One more field of the last variant, or of the request. A text, so that it is not a matter of `Copy` alone.
fn field(command: &Command) -> String {
    let table = match command.request {
        Request::Fields(_) => "command.request",
        Request::Choice(_) => "command.choice.variant.field",
    };
    let ty =
        if command.request.fields().any(|field| field.ty == Type::Scalar(Scalar::Text)) { "text" } else { "float" };
    format!("\n[[{table}]]\nwire = \"extra\"\ntype = \"{ty}\"\noptional = true\ndoc = \"More.\"\n")
}

/// The text of a topic in which each of the ten commands has the field.
fn grown(spec: &Spec, text: &str) -> String {
    let mut out = String::new();
    for (at, block) in text.split("\n[[command]]\n").enumerate() {
        if at > 0 {
            out.push_str("\n[[command]]\n");
        }
        out.push_str(block);
        let wire = block.strip_prefix("wire = \"").and_then(|rest| rest.split('"').next());
        let command = wire.filter(|wire| at > 0 && TEN.contains(wire)).and_then(|wire| spec.command(wire));
        out.extend(command.map(field));
    }
    out
}

/// A function for each command that makes its request and sends it, by its method and by `call`.
pub(crate) fn program(spec: &Spec) -> String {
    let mut code = "//! A program.\n\n#![allow(deprecated)]\n\nuse jaka_sync::{Client, Error};\n".to_owned();
    for topic in &spec.topics {
        for command in &topic.commands {
            let request = format!("jaka_sync::{}::{}", topic.name, command.request_type());
            let requests = made(spec, command, &request);
            let _ =
                write!(code, "\n/// Sends it.\npub fn {}(client: &mut Client) -> Result<(), Error> {{\n", command.name);
            for made in &requests {
                let _ = writeln!(code, "    let request: {request} = {made};\n    let _ = client.call(&request)?;");
            }
            let _ =
                writeln!(code, "    let _ = client.{}({})?;\n    Ok(())\n}}", command.name, argument(spec, command));
        }
    }
    code
}

/// The request by each of its constructors, and with all of its optional fields.
fn made(spec: &Spec, command: &Command, path: &str) -> Vec<String> {
    let fields = match &command.request {
        Request::Fields(fields) => fields,
        Request::Choice(choice) => {
            let variants = choice.variants.iter();
            let made = variants.map(|v| format!("{path}::{}({})", to_snake(&v.name), arguments(spec, &v.fields, "")));
            return made.collect();
        }
    };
    let mut made = vec![format!("{path}::new({})", arguments(spec, fields, ""))];
    for field in fields.iter().filter(|field| field.constructors) {
        let values = field.ty.named().map(|id| values(spec, id)).unwrap_or_default();
        let others = arguments(spec, fields, &field.name);
        made.extend(values.iter().map(|value| format!("{path}::{}({others})", to_snake(value))));
    }
    let setters = fields.iter().filter(|field| field.optional);
    let setters: Vec<_> = setters.map(|field| format!(".{}({})", field.name, value(spec, &field.ty))).collect();
    made.push(format!("{}{}", made[0], setters.concat()));
    made
}

/// Argument of the method of a command.
fn argument(spec: &Spec, command: &Command) -> String {
    let required: Vec<_> = command.request.fields().filter(|field| !field.optional).collect();
    match (&command.request, required.as_slice()) {
        (Request::Fields(_), []) => String::new(),
        (Request::Fields(_), [field]) if !matches!(field.ty, Type::Array(..)) => value(spec, &field.ty),
        _ => "&request".to_owned(),
    }
}

/// Values for the required fields, except for the field `without`.
fn arguments(spec: &Spec, fields: &[Field], without: &str) -> String {
    let required = fields.iter().filter(|field| !field.optional && field.name != without);
    let values: Vec<_> = required.map(|field| value(spec, &field.ty)).collect();
    values.join(", ")
}

/// A value of the type.
fn value(spec: &Spec, ty: &Type) -> String {
    match ty {
        Type::Scalar(Scalar::Int) => "1".to_owned(),
        Type::Scalar(Scalar::Float) => "1.0".to_owned(),
        Type::Scalar(Scalar::Text) => "\"text\"".to_owned(),
        Type::Scalar(Scalar::Json) => "jaka_sync::proto::wire::Value::from(1)".to_owned(),
        Type::Array(element, len) => format!("[{}; {len}]", value(spec, element)),
        Type::List(element) => format!("vec![{}]", value(spec, element)),
        Type::Named(id) => named(spec, *id),
        other => panic!("no request has a {other:?}"),
    }
}

fn named(spec: &Spec, id: TypeId) -> String {
    let (topic, name) = (&spec.topic_of(id).expect("the spec has it").name, &spec[id].name);
    match &spec[id].kind {
        TypeKind::Wrapper(ty, _) => value(spec, ty),
        TypeKind::Array { fields, .. } if jaka_spec::is_floats(fields) => format!("[1.0; {}]", fields.len()),
        TypeKind::Array { fields, .. } | TypeKind::Object(fields) => {
            format!("jaka_sync::{topic}::{name}::new({})", arguments(spec, fields, ""))
        }
        _ => format!("jaka_sync::{topic}::{name}::{}", values(spec, id)[0]),
    }
}

fn values(spec: &Spec, id: TypeId) -> Vec<&str> {
    match &spec[id].kind {
        TypeKind::IntEnum(values) => values.iter().map(|value| &*value.name).collect(),
        TypeKind::TextEnum(values) => values.iter().map(|value| &*value.name).collect(),
        _ => panic!("{} is not an enum that requests have", spec[id].name),
    }
}

impl UserCrate {
    /// Depends on the jaka-sync of a workspace.
    pub(crate) fn with_workspace(self, workspace: &Path) -> Self {
        // The same versions as here, so that nothing has to be fetched.
        self.write("Cargo.lock", &fs::read_to_string(workspace.join("Cargo.lock")).expect("the workspace has one"));
        let name = self.folder.file_name().expect("it is the crate's name").display();
        let (edition, sync) = (self.edition, workspace.join("jaka-sync").display().to_string());
        self.write(
            "Cargo.toml",
            &format!(
                "[package]\nname = \"{name}\"\nedition = {edition:?}\n\n[workspace]\n\n[dependencies]\njaka-sync = {{ path = {sync:?} }}\n"
            ),
        );
        self
    }

    fn expect_of_cargo(&self, expected: &Expect) {
        self.compare(self.check(), expected);
    }

    /// Compiles the crate by cargo; what cargo says.
    pub(crate) fn check(&self) -> Vec<u8> {
        let output = process::Command::new(env!("CARGO"))
            .args(["check", "--offline", "--quiet", "--color=never", "--target-dir"])
            // An edit changes little of what is compiled.
            .env("CARGO_INCREMENTAL", "1")
            .arg(self.folder.with_file_name("target"))
            .current_dir(&self.folder)
            .output()
            .expect("cargo runs");
        output.stderr
    }
}

/// Copies jaka-sync and the crates that it needs, as a workspace in a folder of this name.
pub(crate) fn copied(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    if folder.exists() {
        fs::remove_dir_all(&folder).expect("the folder of an earlier run can be removed");
    }
    for member in with_dependencies("jaka-sync") {
        copy(&root().join(member), &folder.join(member));
    }
    for file in ["Cargo.toml", "Cargo.lock"] {
        fs::copy(root().join(file), folder.join(file)).expect("it can be copied");
    }
    folder
}

/// Copies the sources of a crate.
fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("the folder can be made");
    for entry in fs::read_dir(from).expect("the folder can be read") {
        let path = entry.expect("it can be read").path();
        let target = to.join(path.file_name().expect("it has a name"));
        if path.is_dir() {
            copy(&path, &target);
        } else {
            fs::copy(&path, &target).expect("it can be copied");
        }
    }
}

#[test]
#[ignore = "a step of .ci/nightly"]
fn an_edit_of_a_pack_is_noticed() {
    let user = UserCrate::new("edited", "2024", "jaka_sync::pack!(\"newer.toml\");\n").with_workspace(root());
    user.write("newer.toml", PACK);
    user.expect_of_cargo(&expect![[""]]);
    user.write("newer.toml", &PACK.replace("query", "fly"));
    user.expect_of_cargo(&expect![[r#"
        error: newer.toml:6:10: command `demo_motion_state`: `effect` is one of query, setting, motion, power, session, not `fly`
         --> src/lib.rs:1:18
          |
        1 | jaka_sync::pack!("newer.toml");
          |                  ^^^^^^^^^^^^

        error: could not compile `edited` (lib) due to 1 previous error
    "#]]);
    user.write("newer.toml", PACK);
    user.expect_of_cargo(&expect![[""]]);
}

#[test]
#[ignore = "a step of .ci/nightly"]
fn a_program_compiles_after_ten_commands_have_got_an_optional_field() {
    let spec = jaka_spec::builtin().expect("the spec is correct");
    let folder = copied("grown");
    let texts: Vec<_> = jaka_spec::BUILTIN.iter().map(|source| (source.path, grown(&spec, source.text))).collect();
    for (path, text) in &texts {
        fs::write(folder.join(path), text).expect("the file can be written");
    }
    let sources: Vec<_> = texts.iter().map(|(path, text)| Source { path, text }).collect();
    let newer = jaka_spec::load(&sources).expect("the grown spec is correct");
    let changes = diff(&spec, &newer);
    assert_eq!((changes.len(), impact(&changes)), (TEN.len(), Some(Impact::Minor)), "{changes:?}");

    let mut code = program(&spec);
    UserCrate::new("before", "2024", &code).with_workspace(root()).expect_of_cargo(&expect![""]);
    code += "
/// With the field that is new.
pub fn extra() -> (jaka_sync::motion::JointMove, jaka_sync::program::LoadProgram, jaka_sync::power::GetVersion) {
    let motion = jaka_sync::motion::JointMove::absolute([0.0; 6], 1.0).extra(1.0);
    let program = jaka_sync::program::LoadProgram::new(\"text\").extra(\"more\");
    (motion, program, jaka_sync::power::GetVersion::new().extra(1.0))
}
";
    UserCrate::new("after", "2024", &code).with_workspace(&folder).expect_of_cargo(&expect![""]);
}
